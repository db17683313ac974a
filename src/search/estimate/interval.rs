//! Intervals: where a number lies, with 95 % confidence, judged by independent estimates.
//!
//! The mean of the estimates is unbiased. Estimates of tree sizes are skewed: many a little too
//! small, few much too large. So the interval is symmetric about the mean on a logarithmic
//! scale, Student's t times the standard error wide.

/// A number and bounds for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The estimate.
    pub mean: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Interval {
    /// A number known exactly.
    pub fn exact(number: f64) -> Self {
        Self { mean: number, low: number, high: number }
    }

    /// From independent estimates of equal standing; `None` for fewer than `fewest`.
    ///
    /// When all agree the interval has no width; for estimates that are all 0 that is no
    /// statement at all.
    pub fn of(estimates: &[f64], fewest: usize) -> Option<Self> {
        if estimates.len() < fewest.max(2) {
            return None;
        }
        let count = estimates.len() as f64;
        let mean = estimates.iter().sum::<f64>() / count;
        if mean <= 0.0 {
            return Some(Self::exact(0.0));
        }
        let squares = estimates.iter().map(|x| (x / mean - 1.0).powi(2)).sum::<f64>();
        let relative = squares / (count - 1.0) / count;
        let width = (student(count - 1.0) * relative.ln_1p().sqrt()).exp();
        Some(Self { mean, low: mean / width, high: mean * width })
    }

    /// The same of a number `factor` times as large.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self { mean: self.mean * factor, low: self.low * factor, high: self.high * factor }
    }

    /// Half its width, relative to the estimate.
    pub fn relative(self) -> f64 {
        if self.mean > 0.0 { (self.high - self.low) / 2.0 / self.mean } else { 0.0 }
    }
}

/// The 97.5 % quantile of Student's t distribution (the expansion of Cornish and Fisher).
fn student(freedom: f64) -> f64 {
    let z: f64 = 1.959_964;
    let first = (z.powi(3) + z) / 4.0;
    let second = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
    z + first / freedom + second / freedom.powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (freedom, quantile) in [(7.0, 2.365), (19.0, 2.093), (63.0, 1.998)] {
            assert!((student(freedom) - quantile).abs() < 0.01, "{freedom}");
        }
    }

    #[test]
    fn intervals_hold_the_mean_and_stay_positive() {
        let interval = Interval::of(&[0.0, 0.0, 0.0, 12.0], 4);
        assert!(
            interval.is_some_and(|i| i.mean == 3.0 && 0.0 < i.low && i.low < 3.0 && i.high > 9.0)
        );
        assert_eq!(Interval::of(&[5.0, 5.0], 2), Some(Interval::exact(5.0)));
        assert_eq!(Interval::of(&[1.0, 2.0], 3), None);
    }
}
