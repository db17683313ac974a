//! Memory in words: reading `4GiB`, `512MiB`, and writing how much something takes.

/// The units that are read, with their bytes.
const UNITS: [(&str, f64); 8] = [
    ("B", 1.0),
    ("KiB", 1024.0),
    ("MiB", 1_048_576.0),
    ("GiB", 1_073_741_824.0),
    ("kB", 1e3),
    ("MB", 1e6),
    ("GB", 1e9),
    ("", 1.0),
];

/// Reads a number and a unit; a number alone is in bytes.
///
/// # Errors
/// What was expected, for any other text.
pub fn parse(text: &str) -> Result<usize, String> {
    let wrong = || {
        "expected a number and a unit (B, kB, KiB, MB, MiB, GB or GiB), as in 4GiB or 500MB"
            .to_owned()
    };
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let plain = digits.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    let unit = UNITS.iter().find(|(name, _)| *name == &text[digits.len()..]);
    match (plain, digits.parse::<f64>(), unit) {
        (true, Ok(number), Some((_, bytes))) if number * bytes < 1e18 => {
            Ok((number * bytes) as usize)
        }
        _ => Err(wrong()),
    }
}

/// Memory for people, rounded: `12 KiB`, `340 MiB`, `4.2 GiB`.
pub fn words(bytes: f64) -> String {
    let mebibytes = bytes / 1_048_576.0;
    match mebibytes {
        ..1.0 => format!("{:.0} KiB", (bytes / 1024.0).ceil()),
        ..1000.0 => format!("{mebibytes:.0} MiB"),
        _ => format!("{:.1} GiB", mebibytes / 1024.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_numbers_with_units() {
        let read = [("4GiB", 4 << 30), ("1.5KiB", 1536), ("2MB", 2_000_000), ("7", 7)];
        for (text, bytes) in read {
            assert_eq!(parse(text), Ok(bytes));
        }
        for text in ["", "GiB", "4 GiB", "4X", "-1GiB", "1e9", "99999999999GiB"] {
            assert!(parse(text).is_err(), "{text}");
        }
        assert_eq!([words(3e5), words(4.2e9)], ["293 KiB", "3.9 GiB"]);
    }
}
