//! The walk that all annealing here takes: one cell after the other gets a random other color.
//!
//! A move that costs nothing is kept; one that costs `rise` is kept with the probability
//! `exp(-rise / temperature)`, else taken back. The temperature stays what it is: with few
//! colors the walk goes into and out of the small valleys by itself.
//!
//! Source: Metropolis and others 1953.

use crate::search::Stop;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Moves between two looks at the limits.
const MOVES: u32 = 1 << 14;

/// What is walked on.
pub(super) trait Landscape {
    /// Unknown cells.
    fn cells(&self) -> usize;
    /// Colors, at least 2.
    fn colors(&self) -> usize;
    /// The color of a cell.
    fn color(&self, cell: usize) -> usize;
    /// Gives it another.
    fn recolor(&mut self, cell: usize, color: usize);
    /// What is wrong; nothing when it is 0.
    fn cost(&self) -> i64;
}

/// Walks until nothing is wrong, and says whether that is so, or until `moves` reaches `most` or
/// something asks to stop.
pub(super) fn walk(
    land: &mut impl Landscape,
    temperature: f64,
    rng: &mut Pcg64,
    moves: &mut u64,
    most: u64,
    stop: &dyn Stop,
) -> bool {
    let accept: Vec<f64> = (0..64).map(|rise| (-f64::from(rise) / temperature).exp()).collect();
    while land.cost() > 0 {
        if *moves >= most || stop.should_stop() {
            return false;
        }
        for _ in 0..MOVES {
            change(land, rng, &accept);
            *moves += 1;
            if land.cost() == 0 || *moves >= most {
                break;
            }
        }
    }
    true
}

/// Gives a random cell a random other color, or not.
#[inline]
fn change(land: &mut impl Landscape, rng: &mut Pcg64, accept: &[f64]) {
    let (cell, before) = (rng.random_range(0..land.cells()), land.cost());
    let (old, by) = (land.color(cell), rng.random_range(1..land.colors()));
    land.recolor(cell, (old + by) % land.colors());
    let rise = land.cost() - before;
    let kept = rise <= 0 || {
        let chance = usize::try_from(rise).ok().and_then(|rise| accept.get(rise));
        chance.is_some_and(|&chance| rng.random::<f64>() < chance)
    };
    if !kept {
        land.recolor(cell, old);
    }
}
