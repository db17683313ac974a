//! Recursive packings: one color after the other, each packing around the one before.
//!
//! The packing over `c - 1` colors is laid into the south-west of the torus for `c` and closes on
//! its own, so it says the colors of `(c-1)^2 + 1` rows and columns of points; the beam fills the
//! rest. A first row over two colors helps a beam much, and here the first row is given, as is
//! the last: the seam of the block before. So the seam of every packing that another is to be
//! built around is given, too, with the first two colors only. What is chosen badly early cannot
//! be helped later, so after a number of nodes all is begun again.
//!
//! Source: this project; recursive packings: Lagae 2007, figures 5.11 and 5.12.

use super::random::Random;
use super::{Options, Outcome, Refusal, find_around};
use crate::search::Limits;
use crate::tiles::{Colors, Kind, Members, TileSet};
use crate::torus::{Lattice, Pins, Shape};

/// The packing over two colors, its tile of one color in the south-west.
const TWO: [u8; 16] = [0, 0, 1, 0, 1, 0, 1, 1, 0, 1, 1, 1, 0, 0, 0, 1];

/// Nodes spent on one color before all is begun again, for each cell and state of the beam.
const PATIENCE: u64 = 26;

/// Looks for a recursive packing of all corner tiles on the square torus until it is found or
/// the limits say stop; it runs on one thread. `restart` in the outcome counts beginnings.
///
/// # Errors
/// When the number of colors or the width of the beam do not suit.
pub fn find_recursive(
    colors: usize,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Outcome, Refusal> {
    let mut outcome = Outcome { labels: None, restart: 0, nodes: 0, depth: 0 };
    loop {
        let mut random = Random::new(options.seed, outcome.restart);
        if let Some(labels) = build(colors, &mut random, options, limits, &mut outcome)? {
            return Ok(Outcome { labels: Some(labels), ..outcome });
        }
        if outcome.nodes >= limits.nodes || limits.stop.should_stop() {
            return Ok(outcome);
        }
        outcome.restart += 1;
    }
}

/// One beginning: the labels, unless patience or the limits are at their end.
fn build(
    colors: usize,
    random: &mut Random,
    options: &Options,
    limits: &Limits<'_>,
    outcome: &mut Outcome,
) -> Result<Option<Vec<u8>>, Refusal> {
    if colors < 2 {
        return Ok(Some(vec![0]));
    }
    let mut labels = TWO.to_vec();
    for c in 3..=colors {
        let too_large = Refusal::TooLarge { colors, cells: colors.saturating_pow(4) };
        let Some((set, lattice)) = all(c) else { return Err(too_large) };
        let cells = lattice.shape.cells();
        let pins = around(&labels, c, lattice, (c < colors).then_some(&mut *random));
        let options = Options { seed: random.next(), threads: 1, ..*options };
        let patience = PATIENCE * (cells * options.width) as u64;
        let nodes = patience.min(limits.nodes.saturating_sub(outcome.nodes));
        let limits = Limits { nodes, stop: limits.stop };
        let found = match find_around(&set, lattice.shape, Some(&pins), &options, &limits) {
            // The seam may break a rule together with the block: another one, then.
            Err(Refusal::Pins) => return Ok(None),
            found => found?,
        };
        outcome.nodes += found.nodes;
        outcome.depth = outcome.depth.max(found.depth);
        match found.labels {
            Some(found) => labels = found,
            None => return Ok(None),
        }
    }
    Ok(Some(labels))
}

/// All corner tiles over `colors` colors, and their square torus.
fn all(colors: usize) -> Option<(TileSet, Lattice)> {
    let side = (colors * colors) as u64;
    let set = TileSet::new(Kind::Corner, Colors::one(colors as u64).ok()?, Members::Complete);
    let shape = Shape::new(side, side).ok()?;
    Some((set.ok()?, Lattice { kind: Kind::Corner, shape }))
}

/// Pins that lay a packing over `colors - 1` colors into the south-west; with random numbers
/// also the rest of the row of the seam, of the first two colors.
fn around(block: &[u8], colors: usize, lattice: Lattice, seam: Option<&mut Random>) -> Pins {
    let (side, inner) = (colors * colors, (colors - 1) * (colors - 1));
    let mut pins = Pins::free(lattice);
    // No point is pinned twice, so no pin can be refused.
    for row in 0..=inner {
        for column in 0..=inner {
            let point = (side - inner + row) % side * side + column;
            let _ = pins.pin(point, block[row % inner * inner + column % inner]);
        }
    }
    if let Some(random) = seam {
        for column in inner + 1..side {
            let _ = pins.pin(column, random.below(2) as u8);
        }
    }
    pins
}
