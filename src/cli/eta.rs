//! The time that a search has left, told as a range.
//!
//! Knuth's fraction of the tree grows by the hour about as fast as it has of late, but only
//! about: thick and thin parts of the tree follow each other. So a straight line is fitted (least
//! squares) to the last half, the last quarter and the last eighth of the time spent, and each
//! slope says when the fraction would reach 1 from where it stands. The answer is the span of
//! the three, widened either way, the more the less evenly the run has gone so far; by how much,
//! traces of real counts have told (`WIDER`).
//!
//! There is no clock in here: times come in, and may begin anywhere, as after a checkpoint.

use super::duration;
use std::time::Duration;

/// Samples kept at most; at this number every second one is dropped.
const MOST: usize = 256;
/// Samples before anything is told; fewer are no basis for a line through the last eighth.
const FEWEST: usize = 16;
/// The last parts of the run to which lines are fitted, as what the run is divided by.
const WINDOWS: [f64; 3] = [2.0, 4.0, 8.0];
/// A smaller movement of the fraction is rounding.
const ROUNDING: f64 = 1e-14;
/// Into so many parts of equal time a run is cut to see how evenly it goes.
const PARTS: u32 = 8;
/// The range is widened by this factor either way, plus the relative standard deviation of the
/// speeds in the parts of the run. Chosen so that some nine in ten of the ranges told during 31
/// real counts of 2 to 60 s held the truth.
const WIDER: f64 = 1.4;

/// The time left by the samples of a run so far.
#[derive(Debug, Clone, Default)]
pub struct Eta {
    /// What has been kept, in the order of time, at most one a slot.
    samples: Vec<Sample>,
    /// The latest, kept or not.
    last: Option<Sample>,
    /// The length of a slot; 0 while all samples are kept.
    slot: f64,
}

/// The fraction of the tree visited at a time, in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sample {
    time: f64,
    fraction: f64,
}

impl Eta {
    /// Without samples.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes a sample: what part of the tree was visited at a time spent. One that goes back in
    /// time or is no fraction is passed over.
    pub fn add(&mut self, time: Duration, fraction: f64) {
        let sample = Sample { time: time.as_secs_f64(), fraction };
        let later = self.last.is_none_or(|last| sample.time > last.time);
        if !later || !(0.0..=1.0).contains(&fraction) {
            return;
        }
        let kept =
            self.samples.last().is_none_or(|kept| self.slot_of(kept) < self.slot_of(&sample));
        self.last = Some(sample);
        if kept {
            self.samples.push(sample);
        }
        if self.samples.len() == MOST {
            self.thin();
        }
    }

    /// The time left, from the shortest to the longest that is likely, or `None` when that is not
    /// to be told: too early in the run, or the fraction has not moved of late.
    ///
    /// [`Duration::MAX`] as the longest means that there is no telling how long.
    pub fn left(&self) -> Option<(Duration, Duration)> {
        let (first, last) = (self.samples.first()?, self.last?);
        if last.fraction >= 1.0 {
            return Some((Duration::ZERO, Duration::ZERO));
        }
        if self.samples.len() < FEWEST {
            return None;
        }
        let span = last.time - first.time;
        let (mut slow, mut fast) = (f64::INFINITY, 0.0f64);
        for part in WINDOWS {
            if let Some(slope) = self.slope(last.time - span / part) {
                (slow, fast) = (slow.min(slope), fast.max(slope));
            }
        }
        // Not even the half has moved, or none could be fitted.
        if fast <= 0.0 {
            return None;
        }
        let time = |rate: f64| (1.0 - last.fraction) / rate;
        let wider = WIDER + self.unevenness(first.time, span);
        Some((seconds(time(fast) / wider), seconds(time(slow) * wider)))
    }

    /// The relative standard deviation of the speed from part to part of the run; 0 when it is
    /// the same in all of them.
    fn unevenness(&self, begin: f64, span: f64) -> f64 {
        let part = |i: u32| self.fraction_at(begin + span * f64::from(i) / f64::from(PARTS));
        let mean = (part(PARTS) - part(0)) / f64::from(PARTS);
        let off = |i: u32| ((part(i + 1) - part(i)) / mean - 1.0).powi(2);
        let variance = (0..PARTS).map(off).sum::<f64>() / f64::from(PARTS);
        if variance.is_finite() { variance.sqrt() } else { 0.0 }
    }

    /// The fraction at a time, between two samples on the line that joins them.
    fn fraction_at(&self, time: f64) -> f64 {
        let next = self.samples.partition_point(|sample| sample.time < time);
        let Some(after) = self.samples.get(next).or(self.last.as_ref()) else { return 0.0 };
        let before = next.checked_sub(1).and_then(|i| self.samples.get(i)).unwrap_or(after);
        let part = ((time - before.time) / (after.time - before.time)).min(1.0);
        before.fraction + (after.fraction - before.fraction) * part
    }

    /// The slope of the line through the samples from a time on; `None` when they are too few,
    /// 0 when the fraction has not moved.
    fn slope(&self, begin: f64) -> Option<f64> {
        let start = self.samples.partition_point(|sample| sample.time < begin);
        let kept = &self.samples[start..];
        let last = self.last.filter(|last| kept.last() != Some(last));
        let window = || kept.iter().copied().chain(last);
        let count = window().count();
        let (first, last) = (window().next()?, window().last()?);
        if count < 3 {
            return None;
        }
        if last.fraction - first.fraction < ROUNDING {
            return Some(0.0);
        }
        let mean = |of: fn(&Sample) -> f64| window().map(|s| of(&s)).sum::<f64>() / count as f64;
        let (time, fraction) = (mean(|s| s.time), mean(|s| s.fraction));
        let (mut square, mut product) = (0.0, 0.0);
        for sample in window() {
            let ahead = sample.time - time;
            square += ahead * ahead;
            product += ahead * (sample.fraction - fraction);
        }
        Some((product / square).max(0.0))
    }

    /// Makes the slots twice as long, or as long as it takes, and keeps the first sample of each.
    fn thin(&mut self) {
        let (Some(first), Some(last)) = (self.samples.first(), self.last) else { return };
        self.slot = (last.time - first.time) / (MOST / 2) as f64;
        let samples = std::mem::take(&mut self.samples);
        for sample in samples {
            if self.samples.last().is_none_or(|kept| self.slot_of(kept) < self.slot_of(&sample)) {
                self.samples.push(sample);
            }
        }
    }

    /// The slot of a sample, counted from the first.
    fn slot_of(&self, sample: &Sample) -> f64 {
        let since = self.samples.first().map_or(0.0, |first| sample.time - first.time);
        if self.slot > 0.0 { (since / self.slot).floor() } else { since }
    }
}

/// A time of so many seconds; [`Duration::MAX`] when it is longer than that.
fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX)
}

/// For people: `2.5 to 4 h left`, `more than 3 years left`.
pub fn words((shortest, longest): (Duration, Duration)) -> String {
    format!("{} left", duration::range(shortest, longest))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of `count --kind corner --colors 3 --automorphism 3,0:+1 --plain` (14.5 s): the
    /// fraction in ten thousandths, after every two hundredth of the time. An even tree.
    const EVEN: [u16; 199] = [
        0, 36, 92, 119, 164, 206, 280, 312, 350, 420, 452, 518, 548, 629, 661, 737, 773, 838, 879,
        918, 966, 987, 1028, 1053, 1098, 1117, 1153, 1177, 1221, 1244, 1266, 1302, 1331, 1375,
        1404, 1445, 1462, 1495, 1537, 1575, 1635, 1675, 1754, 1787, 1869, 1902, 1977, 2014, 2087,
        2136, 2170, 2234, 2270, 2352, 2394, 2467, 2511, 2581, 2614, 2682, 2729, 2775, 2837, 2869,
        2945, 2980, 3050, 3101, 3179, 3211, 3237, 3326, 3357, 3427, 3473, 3550, 3582, 3660, 3696,
        3765, 3807, 3847, 3915, 3957, 4038, 4071, 4134, 4168, 4267, 4295, 4309, 4345, 4393, 4436,
        4471, 4541, 4582, 4661, 4692, 4724, 4802, 4848, 4919, 4947, 5028, 5055, 5120, 5142, 5227,
        5261, 5273, 5304, 5326, 5398, 5436, 5503, 5538, 5619, 5664, 5690, 5759, 5810, 5887, 5914,
        5981, 6026, 6095, 6124, 6174, 6237, 6275, 6347, 6389, 6447, 6484, 6563, 6597, 6676, 6715,
        6753, 6815, 6848, 6929, 6963, 7042, 7066, 7140, 7169, 7237, 7282, 7328, 7391, 7425, 7504,
        7538, 7599, 7650, 7729, 7764, 7795, 7859, 7914, 7985, 8018, 8088, 8122, 8201, 8227, 8273,
        8355, 8386, 8457, 8498, 8559, 8603, 8682, 8715, 8794, 8834, 8868, 8951, 8980, 9043, 9081,
        9157, 9189, 9270, 9308, 9382, 9425, 9464, 9527, 9562, 9652, 9685, 9753, 9780, 9861, 9900,
    ];
    /// Of `count --kind domino --colors 5` (6.5 s). The tree is thin at first: half of the
    /// fraction is done in a quarter of the time.
    const UNEVEN: [u16; 199] = [
        0, 0, 0, 260, 431, 431, 628, 812, 812, 1015, 1161, 1161, 1396, 1525, 1525, 1636, 1636,
        1914, 2169, 2169, 2285, 2386, 2386, 2487, 2601, 2601, 2698, 2786, 2786, 2882, 2971, 2971,
        3065, 3150, 3150, 3240, 3240, 3321, 3732, 3732, 4105, 4487, 4487, 4687, 4857, 4857, 4993,
        5178, 5178, 5278, 5353, 5353, 5456, 5456, 5619, 5700, 5700, 5767, 5831, 5831, 5969, 6099,
        6099, 6163, 6219, 6219, 6273, 6325, 6325, 6376, 6418, 6418, 6468, 6468, 6512, 6555, 6555,
        6598, 6642, 6642, 6754, 6876, 6876, 6953, 7018, 7018, 7072, 7137, 7137, 7192, 7235, 7235,
        7277, 7277, 7317, 7363, 7363, 7401, 7444, 7444, 7487, 7609, 7609, 7687, 7749, 7749, 7867,
        7938, 7938, 7987, 8030, 8030, 8072, 8072, 8110, 8149, 8149, 8183, 8215, 8215, 8247, 8276,
        8276, 8310, 8392, 8392, 8477, 8539, 8539, 8571, 8571, 8627, 8737, 8737, 8800, 8844, 8844,
        8882, 8919, 8919, 8955, 8984, 8984, 9016, 9047, 9047, 9077, 9105, 9105, 9136, 9136, 9161,
        9193, 9193, 9221, 9252, 9252, 9281, 9312, 9312, 9341, 9370, 9370, 9395, 9418, 9418, 9444,
        9444, 9468, 9490, 9490, 9517, 9546, 9546, 9573, 9599, 9599, 9622, 9647, 9647, 9672, 9699,
        9699, 9723, 9745, 9745, 9768, 9768, 9790, 9813, 9813, 9835, 9863, 9863, 9888, 9912, 9912,
        9936, 9961,
    ];

    fn run(samples: impl IntoIterator<Item = (f64, f64)>) -> Eta {
        let mut eta = Eta::new();
        for (time, fraction) in samples {
            eta.add(seconds(time), fraction);
        }
        eta
    }

    /// The range in seconds.
    fn range(eta: &Eta) -> (f64, f64) {
        let (shortest, longest) = eta.left().unwrap();
        (shortest.as_secs_f64(), longest.as_secs_f64())
    }

    /// How many of the ranges told from a tenth of a run to nine tenths hold the truth, and how
    /// far apart their ends are in the (geometric) mean.
    fn coverage(trace: &[u16], begin: f64) -> (f64, f64) {
        let mut eta = Eta::new();
        let (mut told, mut true_ones, mut widths) = (0.0, 0.0, 0.0);
        for (time, &fraction) in (1..).zip(trace) {
            eta.add(seconds(begin + f64::from(time)), f64::from(fraction) / 1e4);
            if (20..=180).contains(&time) {
                let (shortest, longest) = range(&eta);
                let truth = f64::from(200 - time);
                told += 1.0;
                true_ones += f64::from(u8::from(shortest <= truth && truth <= longest));
                widths += (longest / shortest).ln();
            }
        }
        (true_ones / told, (widths / told).exp())
    }

    #[test]
    fn real_runs() {
        let (even, uneven) = (coverage(&EVEN, 0.0), coverage(&UNEVEN, 0.0));
        assert!(even.0 >= 0.95 && even.1 < 3.0, "{even:?}");
        assert!(uneven.0 >= 0.8 && uneven.1 < 6.5, "{uneven:?}");
        // When the clock began is all the same.
        let later = coverage(&UNEVEN, 4096.0);
        assert!((later.0, later.1 as f32) == (uneven.0, uneven.1 as f32), "{later:?}");
    }

    #[test]
    fn an_even_run_is_told_closely() {
        for most in [16, 255, 256, 257, 511, 512, 513, 5000, 100_000] {
            let eta = run((0..most).map(|i| (f64::from(i), f64::from(i) / 200_000.0)));
            let (truth, (shortest, longest)) = (f64::from(200_001 - most), range(&eta));
            assert!((truth / shortest - WIDER).abs() < 1e-3, "{most}: {shortest} {truth}");
            assert!((longest / truth - WIDER).abs() < 1e-3, "{most}: {longest} {truth}");
        }
    }

    #[test]
    fn a_run_taken_up_in_the_middle() {
        // Ten hours spent before, at one speed; now one hour at another.
        let eta = run((0..3600).map(|i| (36_000.0 + f64::from(i), 0.5 + f64::from(i) / 36_000.0)));
        let (shortest, longest) = range(&eta);
        assert!((8_000.0..14_401.0).contains(&shortest), "{shortest}");
        assert!((14_401.0..24_000.0).contains(&longest), "{longest}");
    }

    #[test]
    fn a_run_that_speeds_up_or_slows_down_has_a_wider_range() {
        let width = |power: f64| {
            let fraction = |i: i32| (f64::from(i) / 1000.0).powf(power);
            let (shortest, longest) = range(&run((0..500).map(|i| (f64::from(i), fraction(i)))));
            assert!(shortest < 501.0 && 501.0 < longest || power != 1.0);
            longest / shortest
        };
        assert!(width(1.0) < width(1.5) && width(1.5) < width(2.0));
        assert!(width(1.0) < width(0.7) && width(0.7) < width(0.5));
    }

    #[test]
    fn a_run_that_stands_still_cannot_be_told() {
        let mut eta = run((0..100).map(|i| (f64::from(i), f64::from(i) / 1000.0)));
        // The last eighth has not moved: nobody knows how long.
        for i in 100..120 {
            eta.add(seconds(f64::from(i)), 0.099);
        }
        let (shortest, longest) = eta.left().unwrap();
        assert!(shortest.as_secs_f64() > 300.0 && longest == Duration::MAX, "{shortest:?}");
        assert!(words((shortest, longest)).starts_with("more than "));
        // Nor has the last half.
        for i in 120..300 {
            eta.add(seconds(f64::from(i)), 0.099);
        }
        assert_eq!(eta.left(), None);
        // Nothing at all, or nothing but rounding.
        for step in [0.0, 1e-19] {
            assert_eq!(run((0..1000).map(|i| (f64::from(i), f64::from(i) * step))).left(), None);
        }
    }

    #[test]
    fn too_little_to_tell() {
        assert_eq!(Eta::new().left(), None);
        assert_eq!(run((0..15).map(|i| (f64::from(i), f64::from(i) / 100.0))).left(), None);
        // All at one time, or at no time.
        for time in [0.0, 7.0] {
            assert_eq!(run((0..100).map(|i| (time, f64::from(i) / 100.0))).left(), None);
        }
        // No fractions.
        let eta = run((0..100).map(|i| (f64::from(i), [f64::NAN, -0.5, 1.5][i as usize % 3])));
        assert_eq!(eta.left(), None);
    }

    #[test]
    fn the_end() {
        for begin in [0.0, 1e6] {
            let eta = run((0..=100).map(|i| (begin + f64::from(i), f64::from(i) / 100.0)));
            assert_eq!(eta.left(), Some((Duration::ZERO, Duration::ZERO)));
        }
    }

    #[test]
    fn time_that_goes_back_is_passed_over() {
        let steady = || (0..1000).map(|i| (f64::from(i), f64::from(i) / 4000.0));
        let torn = steady().flat_map(|(time, fraction)| [(time, fraction), (time / 2.0, 0.9)]);
        assert_eq!(run(torn).left(), run(steady()).left());
    }

    #[test]
    fn samples_stay_few_and_even() {
        // A burst of samples, and then a long run of one a second.
        let burst = (0..250).map(|i| (f64::from(i) * 1e-3, 1e-6));
        let eta = run(burst.chain((1..20_000).map(|i| (f64::from(i), f64::from(i) / 1e5))));
        let Eta { samples, slot, .. } = &eta;
        assert!(samples.len() < MOST && samples.len() >= MOST / 2, "{}", samples.len());
        assert!(samples.windows(2).all(|two| two[1].time - two[0].time <= 2.0 * slot));
        assert!(samples.windows(3).all(|three| three[2].time - three[0].time >= *slot));
    }

    #[test]
    fn ages() {
        // A trillionth of the tree in an hour.
        let eta = run((0..3600).map(|i| (f64::from(i), f64::from(i) * 3e-16)));
        assert_eq!(words(eta.left().unwrap()), "more than 1000 years left");
        let hours = |hours: u64| Duration::from_secs(3600 * hours);
        assert_eq!(words((hours(3), hours(4))), "3 to 4 h left");
        assert_eq!(words((hours(27_000), Duration::MAX)), "more than 3 years left");
    }
}
