//! What a partial packing is worth: an estimate of the logarithm of its number of completions.
//!
//! Think of the tiles not yet used as a heap of parts that are joined at random wherever their
//! dominoes fit (the configuration model of random graphs). The number of ways is about
//! `prod T! B! L! R! / prod h! v! c!`, where `T[d]` (`B`, `L`, `R`) unused tiles have the domino
//! `d` on the north (south, west, east) side, `h[d]` and `v[d]` dominoes `d` are still to be
//! placed across and down, and `c[x]` cells are still to get the color `x`. Placing a cell
//! changes the logarithm by a few terms. Weights below 1 for the denominator let the beam live
//! several levels longer (measured, unexplained); it then tends to use up one color early.
//!
//! Scores are fixed-point numbers, so that no rounding differs from machine to machine.
//! Source: this project.

/// Binary places of a score.
const PLACES: i32 = 14;

/// A score as a fixed-point number.
pub(super) fn fixed(value: f64) -> i64 {
    (value * f64::from(1 << PLACES)).round() as i64
}

/// How much the logarithms count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    /// Of the tiles left, `T`, `B`, `L` and `R`.
    pub tiles: f64,
    /// Of the dominoes left, `h` and `v`.
    pub dominoes: f64,
    /// Of the cells of a color left, `c`.
    pub colors: f64,
    /// Of the tiles left with the same (NW, SW, SE), in a compact set.
    pub triples: f64,
}

/// Logarithms of small numbers, times their weights; that of 0 is 0.
#[derive(Debug)]
pub(super) struct Logarithms {
    /// What a window costs for each of its four dominoes.
    pub(super) tiles: Vec<i64>,
    /// What a domino gains.
    pub(super) dominoes: Vec<i64>,
    /// What a color gains.
    pub(super) colors: Vec<i64>,
    /// What a window of a compact set gains when it is the first of its two.
    pub(super) fresh: i64,
}

impl Logarithms {
    /// Tables for counts up to `most`.
    pub(super) fn new(weights: Weights, most: usize) -> Self {
        let table = |weight: f64| {
            let log = |n: usize| if n == 0 { 0.0 } else { (n as f64).ln() };
            (0..=most).map(|n| fixed(weight * log(n))).collect()
        };
        Self {
            tiles: table(-weights.tiles),
            dominoes: table(weights.dominoes),
            colors: table(weights.colors),
            fresh: fixed(-weights.triples * 2f64.ln()),
        }
    }
}
