//! How much memory a count will need, told before it begins.
//!
//! Where the rule is the same everywhere, states multiply by nearly the same factor with every
//! column, and the digits of the numbers grow evenly with rows and columns. So narrow rectangles are
//! counted, a few rows of them, and what they show is continued. Other counts are stopped when they
//! meet the limit.

use super::line::Ends;
use super::plane::Plane;
use super::sweep::Sweep;
use crate::dappled::{Field, Rule};

/// Narrow rectangles have fewer states.
const FEW: f64 = 3000.0;
/// Steps between the two widths that are compared: rows that meet their end favor even lengths.
const APART: usize = 2;
/// Where halves are joined there are so many times as many states: measured, 1.46 to 1.49 for limits
/// of 2.
const JOINING: f64 = 1.5;

/// An estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Need {
    /// The most states at a time.
    pub states: f64,
    /// Bytes.
    pub bytes: f64,
}

/// What a narrow rectangle shows.
#[derive(Debug, Clone, Copy)]
struct Seen {
    /// The most states.
    peak: f64,
    /// States between rows.
    between: f64,
    /// Bits that the number of fillings gains with a row.
    bits: f64,
}

impl Need {
    /// What a count will need, about; `None` when it is little, or not to be told.
    pub fn of(rule: &Rule, given: Option<&Field>, by: Option<u8>) -> Option<Self> {
        let plane = Plane::new(rule, given);
        let (width, height) = (plane.width(), plane.height());
        let Seen { peak, between, bits } = expected(&plane)?;
        if by.is_some() {
            let number = limbs(bits * height as f64) * (width * height + 1) as f64;
            return Some(Self { states: peak, bytes: 2.0 * peak * 8.0 * (1.0 + number) });
        }
        let states = peak * if height > 3 { JOINING } else { 1.0 };
        let half = bits * height.div_ceil(2) as f64;
        // Between rows sums are shared out among the states; joined, each has nearly all of them.
        let kept = between * 8.0 * (1.0 + limbs(half - between.log2()));
        Some(Self { states, bytes: 2.0 * states * 8.0 * (1.0 + limbs(half)) + kept })
    }

    /// What [`super::Sampler`] will need at least, about.
    pub fn of_tilings(rule: &Rule, given: Option<&Field>) -> Option<Self> {
        let plane = Plane::new(rule, given);
        let (width, height) = (plane.width() as f64, plane.height() as f64);
        let Seen { peak, between, bits } = expected(&plane)?;
        let number = 8.0 * (1.0 + limbs(bits * height - between.log2()));
        // All cells of one row, and rows here and there.
        let bytes = number * (peak * width + between * height.sqrt());
        Some(Self { states: peak, bytes })
    }
}

/// Limbs of a number, with room for sums.
fn limbs(bits: f64) -> f64 {
    ((bits.max(0.0) + 24.0) / 64.0).floor() + 1.0
}

/// What is to be expected, from what narrow rectangles show.
fn expected(plane: &Plane) -> Option<Seen> {
    if !plane.is_even() || plane.columns_meet() {
        return None;
    }
    let longest = plane.column(0, Ends::Free).demands.iter().map(|d| d.longest).max();
    let rows = plane.height().min(2 * longest.unwrap_or(0) as usize + 4);
    let mut seen: Vec<Seen> = Vec::new();
    while seen.last().is_none_or(|last| last.peak < FEW) {
        if seen.len() + 1 == plane.width() {
            return None;
        }
        seen.push(look(&plane.resized(seen.len() + 1, rows)?)?);
    }
    let (&last, &before) = (seen.last()?, seen.iter().rev().nth(APART)?);
    let steps = (plane.width() - seen.len()) as f64 / APART as f64;
    let more = |last: f64, before: f64| last * (last / before).powf(steps);
    Some(Seen {
        peak: more(last.peak, before.peak),
        between: more(last.between, before.between),
        bits: last.bits + steps * (last.bits - before.bits),
    })
}

/// Counts a narrow rectangle.
fn look(plane: &Plane) -> Option<Seen> {
    let mut sweep = Sweep::of(plane, None, false).ok()?;
    let (mut peak, mut between, mut bits) = (0.0f64, 0.0f64, [0.0f64; 2]);
    // The last rows have fewer states, for they know that nothing comes.
    while !sweep.is_done() {
        sweep.step();
        let states = sweep.table().len() as f64;
        peak = peak.max(states);
        if sweep.is_at_row() {
            between = between.max(states);
            let sum = &sweep.table().sums()[0];
            bits = [bits[1], sum.bits() as f64];
        }
    }
    (between > 0.0).then_some(Seen { peak, between, bits: bits[1] - bits[0] })
}
