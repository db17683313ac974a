//! Time in words: reading `90s`, `10m`, `2h`, and writing how long something took.

use std::time::Duration;

/// The units that are read, with their seconds.
const UNITS: [(&str, f64); 5] =
    [("ms", 1e-3), ("s", 1.0), ("m", 60.0), ("h", 3600.0), ("d", 86400.0)];

/// Reads a time: a decimal number and one of the units `ms`, `s`, `m`, `h`, `d`; without a unit
/// it is in seconds.
///
/// # Errors
/// What was expected, for any other text.
pub fn parse(text: &str) -> Result<Duration, String> {
    let wrong = || {
        "expected a number and a unit (ms, s, m, h or d), as in 90s or 1.5h; \
         a number alone is in seconds"
            .to_owned()
    };
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let unit = &text[digits.len()..];
    let plain = digits.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    let (true, Ok(number)) = (plain, digits.parse::<f64>()) else { return Err(wrong()) };
    let seconds = match unit {
        "" => 1.0,
        _ => UNITS.iter().find(|(name, _)| *name == unit).ok_or_else(wrong)?.1,
    };
    Duration::try_from_secs_f64(number * seconds).map_err(|_| format!("{text} is too long"))
}

/// A time for people, rounded: `under 0.01 s`, `0.02 s`, `75 s`, `12 min 5 s`, `3 h 20 min`.
pub fn words(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    let whole = seconds.round() as u64;
    match whole {
        0 if seconds < 0.01 => "under 0.01 s".to_owned(),
        0..10 => format!("{seconds:.2} s"),
        10..100 => format!("{seconds:.1} s"),
        100..6000 => format!("{} min {} s", whole / 60, whole % 60),
        6000..172_800 => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
        _ => format!("{} d {} h", whole / 86400, whole % 86400 / 3600),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_numbers_with_units() {
        for (text, milliseconds) in [
            ("90s", 90_000),
            ("90", 90_000),
            ("10m", 600_000),
            ("2h", 7_200_000),
            ("1.5h", 5_400_000),
            ("250ms", 250),
            ("0.5", 500),
            ("1d", 86_400_000),
            ("0", 0),
        ] {
            assert_eq!(parse(text), Ok(Duration::from_millis(milliseconds)), "{text}");
        }
    }

    #[test]
    fn refuses_everything_else() {
        for text in [
            "", "s", "-1", "-1s", "+1s", "1x", "1 s", "1e3", "1h30m", "1..2s", ".", "inf", "NaN",
            "1S", "é", "9s9",
        ] {
            assert!(parse(text).unwrap_err().starts_with("expected"), "{text}");
        }
        assert!(parse(&format!("{}h", "9".repeat(400))).unwrap_err().ends_with("too long"));
    }

    #[test]
    fn writes_what_people_can_take_in() {
        for (seconds, expected) in [
            (0.0, "under 0.01 s"),
            (0.0234, "0.02 s"),
            (9.2, "9.20 s"),
            (42.0, "42.0 s"),
            (725.4, "12 min 5 s"),
            (12_000.0, "3 h 20 min"),
            (200_000.0, "2 d 7 h"),
        ] {
            assert_eq!(words(Duration::from_secs_f64(seconds)), expected);
        }
    }
}
