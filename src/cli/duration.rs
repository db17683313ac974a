//! Time in words: reading `90s`, `10m`, `2h`, and writing how long something took or may take.
//!
//! A time that is only known to lie in a range is written in few digits and in the units people
//! would use, up to years; its ends are rounded outward, so that the range stays true.

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

/// A unit of a range.
struct Unit {
    name: &'static str,
    seconds: f64,
    /// Beyond so many the next unit is used.
    most: f64,
}

/// The units of ranges.
const SPOKEN: [Unit; 6] = [
    Unit { name: "s", seconds: 1.0, most: 90.0 },
    Unit { name: "min", seconds: 60.0, most: 90.0 },
    Unit { name: "h", seconds: 3600.0, most: 48.0 },
    Unit { name: "days", seconds: 86_400.0, most: 90.0 },
    Unit { name: "months", seconds: YEAR / 12.0, most: 24.0 },
    Unit { name: "years", seconds: YEAR, most: 1000.0 },
];
/// Seconds of a year.
const YEAR: f64 = 365.25 * 86_400.0;
/// A range is open when its ends are this many times apart.
const OPEN: f64 = 50.0;

/// A range of times for people: `2.5 to 4 h`, `50 min to 2 h`, `up to 3 s`. One that reaches too
/// far to be of use is told by its beginning: `more than 3 years`, at most 1000 of them.
pub fn range(shortest: Duration, longest: Duration) -> String {
    let (low, high) = (shortest.as_secs_f64(), longest.as_secs_f64());
    let own = unit(low);
    let from = rounded(low, own, f64::floor);
    if high > 1000.0 * YEAR || (from > 0.0 && high > OPEN * low) {
        return match from {
            0.0 => "an unknown time".to_owned(),
            _ => format!("more than {} {}", from.min(1000.0), own.name),
        };
    }
    let unit = unit(high);
    let to = rounded(high, unit, f64::ceil).max(1.0);
    if from == 0.0 {
        return format!("up to {to} {}", unit.name);
    }
    if low < unit.seconds {
        return format!("{from} {} to {to} {}", own.name, unit.name);
    }
    match rounded(low, unit, f64::floor) {
        from if from == to => format!("about {to} {}", unit.name),
        from => format!("{from} to {to} {}", unit.name),
    }
}

/// The unit for a time.
fn unit(seconds: f64) -> &'static Unit {
    let fits = |unit: &&Unit| seconds <= unit.seconds * unit.most;
    SPOKEN.iter().find(fits).unwrap_or(&SPOKEN[SPOKEN.len() - 1])
}

/// A number of units near a time, in steps: of 5 from 20 on, of a half below 5, but whole seconds.
fn rounded(seconds: f64, unit: &Unit, round: fn(f64) -> f64) -> f64 {
    let number = seconds / unit.seconds;
    let step = match () {
        () if number > 20.0 => 5.0,
        () if number > 5.0 || unit.seconds == 1.0 => 1.0,
        () => 0.5,
    };
    round(number / step) * step
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

    #[test]
    fn writes_ranges_in_units_for_people() {
        const MIN: f64 = 60.0;
        const H: f64 = 3600.0;
        const D: f64 = 24.0 * H;
        const Y: f64 = 365.25 * D;
        for (low, high, expected) in [
            (0.0, 0.0, "up to 1 s"),
            (0.3, 2.2, "up to 3 s"),
            (0.5, 70.0 * MIN, "up to 70 min"),
            (3.9, 7.1, "3 to 8 s"),
            (23.0, 41.0, "20 to 45 s"),
            (180.0, 300.0, "3 to 5 min"),
            (70.0, 250.0, "1 to 4.5 min"),
            (40.0, 100.0, "40 s to 2 min"),
            (120.0, 120.0, "about 2 min"),
            (2.6 * H, 3.9 * H, "2.5 to 4 h"),
            (52.0 * MIN, 2.0 * H, "50 min to 2 h"),
            (30.0 * H, 70.0 * H, "1 to 3 days"),
            (20.0 * D, 100.0 * D, "20 days to 3.5 months"),
            (0.9 * Y, 3.2 * Y, "10 months to 3.5 years"),
            (400.0 * Y, 990.0 * Y, "400 to 990 years"),
            (3.3 * Y, 1001.0 * Y, "more than 3 years"),
            (2.0 * H, 200.0 * H, "more than 2 h"),
            (1.2, 1e9, "more than 1 s"),
            (0.9, 1e99, "an unknown time"),
            (1e12, 1e14, "more than 1000 years"),
            (1e99, 1e99, "more than 1000 years"),
        ] {
            let time = |s: f64| Duration::try_from_secs_f64(s).unwrap_or(Duration::MAX);
            assert_eq!(range(time(low), time(high)), expected, "{low} {high}");
        }
    }
}
