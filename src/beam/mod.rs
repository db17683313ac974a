//! First packings of corner tiles by beam search, without any symmetry.
//!
//! Exhaustive search goes deep and comes back; a beam goes down once, with thousands of partial
//! packings side by side, and keeps at every cell those that can most likely be completed. That
//! likelihood is an estimate of the number of completions ([`score`]). It finds an unrestricted
//! packing of the 256 tiles over four colors in about a second (280 days of backtracking in
//! Lagae and Dutré 2006) and packings of pruned sets that were said to have none. It proves
//! nothing: where there is no packing it goes on for ever.
//!
//! Source: this project; the idea of the score from the configuration model of random graphs
//! (Bollobás 1980).

mod descent;
mod excess;
mod given;
mod model;
mod random;
mod recursive;
mod restarts;
mod rule;
pub mod score;
mod seams;

pub use recursive::find_recursive;

use crate::search::Limits;
use crate::tiles::{Kind, Members, TileSet};
use crate::torus::{Fold, Pins, Shape};
use descent::Beam;
use excess::Excess;
use given::Frame;
use model::{Counts, Model, each_image};
use random::Gumbel;
use rule::{Compact, Once, Rule, Times, Window};
use score::{Logarithms, Weights};

/// The widest beam.
pub const MAX_WIDTH: usize = 200_000;

/// The largest number of colors.
pub const MAX_BEAM_COLORS: usize = 64;

/// The largest number of cells.
pub const MAX_BEAM_CELLS: usize = 65_535;

/// How to search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// States kept at every cell, 1 to [`MAX_WIDTH`].
    pub width: usize,
    /// The scale of the noise.
    pub tau: f64,
    /// Colors of the random first row, the fewer the better; at least 1.
    pub palette: usize,
    /// Weights of the score.
    pub weights: Weights,
    /// Descents at most.
    pub restarts: u64,
    /// Everything random follows from it.
    pub seed: u64,
    /// Threads, at least 1; the answer does not depend on them.
    pub threads: usize,
}

impl Options {
    /// What measured best for a recursive packing: its first row is given.
    pub fn for_recursion(set: &TileSet) -> Self {
        let options = Self::for_set(set);
        Self { width: 3000, weights: Weights { colors: 0.2, ..options.weights }, ..options }
    }

    /// The same with all colors in the first row instead of two: twenty times the work on all 256
    /// tiles over four colors, for packings that nothing but the score has shaped. Wide beams
    /// measured best.
    #[must_use]
    pub fn over_all_colors(self, set: &TileSet) -> Self {
        let wide = *set.members() == Members::Complete;
        let width = if wide { self.width.max(8000) } else { self.width };
        Self { palette: set.colors().largest(), width, ..self }
    }

    /// What measured best for a set.
    pub fn for_set(set: &TileSet) -> Self {
        let triples = if set.is_compact() && set.colors().largest() > 4 { -1.5 } else { 0.0 };
        // Of all 256 tiles over four colors 24 million nodes a packing, instead of 13, when the
        // abundant colors are preferred a little, as other sets like it.
        let (width, colors) = match set.members() {
            Members::Complete => (1000, 0.0),
            _ => (3000, 0.2),
        };
        Self {
            width,
            tau: 0.25,
            palette: 2,
            weights: Weights { tiles: 1.0, dominoes: 0.65, colors, triples },
            restarts: u64::MAX,
            seed: 0,
            threads: 1,
        }
    }
}

/// What the search came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outcome {
    /// The labels of a packing, as in [`crate::torus::Lattice`]; `None` when it was stopped or
    /// there were no restarts left.
    pub labels: Option<Vec<u8>>,
    /// The restart that found it, from 0, or the number of restarts that ended without.
    pub restart: u64,
    /// Partial packings looked at that broke no rule, up to that restart.
    pub nodes: u64,
    /// The most cells that were filled.
    pub depth: usize,
}

/// Why the beam cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// The beam knows corner tiles only.
    #[error("beam search is for corner tiles, not for {0} tiles")]
    Kind(Kind),
    /// A packing has as many cells as the set has tiles.
    #[error("size {shape} has {cells} cells, but the set has {tiles} tiles")]
    Size {
        /// The torus asked for.
        shape: Shape,
        /// Its cells.
        cells: u64,
        /// The tiles of the set.
        tiles: u64,
    },
    /// More than the counts of a state hold.
    #[error(
        "{colors} colors and {cells} cells: beam search handles up to {MAX_BEAM_COLORS} colors \
         and {MAX_BEAM_CELLS} cells"
    )]
    TooLarge {
        /// Colors of the set.
        colors: usize,
        /// Cells of the torus.
        cells: usize,
    },
    /// An option out of range.
    #[error("a beam of {0} states: expected 1 to {MAX_WIDTH}")]
    Width(usize),
    /// Other numbers of dominoes on opposite sides: there is no packing.
    #[error("the tiles do not have the same dominoes on opposite sides: there is no packing")]
    Unbalanced,
    /// The cells given beforehand are not those of the torus, or use a tile twice.
    #[error("the cells given beforehand use a tile twice, or more of a color than there is")]
    Pins,
    /// Rows are scanned, so there must be some.
    #[error("beam search fills row after row, and only one row is left to choose")]
    OneRow,
    /// A covering of a set whose tiles are not given.
    #[error("beam search does not look for coverings of compact sets")]
    Compact,
    /// There is no such packing.
    #[error("the seams that the symmetry makes do not fit the tiles")]
    Seams,
    /// The symmetry leads out of the set.
    #[error("the symmetry does not keep the set")]
    NotKept,
}

/// Looks for a packing of a corner set until it is found or the limits say stop.
///
/// # Errors
/// When the set, the torus or the width of the beam do not suit.
pub fn find(
    set: &TileSet,
    shape: Shape,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Outcome, Refusal> {
    find_around(set, shape, None, options, limits)
}

/// As [`find`], among the packings that have certain cells as given beforehand.
///
/// # Errors
/// As [`find`], and when these cells cannot be part of a packing.
pub fn find_around(
    set: &TileSet,
    shape: Shape,
    pins: Option<&Pins>,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Outcome, Refusal> {
    check(set, shape, options)?;
    if shape.cells() as u64 != set.size() {
        return Err(Refusal::Size { shape, cells: shape.cells() as u64, tiles: set.size() });
    }
    let colors = set.colors().largest();
    // Rows are scanned, so they should be short.
    let fold = oriented(&Fold::none(shape, colors));
    let turned = fold.shape() != shape;
    let frame = Frame::new(shape, turned, pins).ok_or(Refusal::Pins)?;
    let tiles = windows(set, turned);
    let torus = Torus { fold, frame };
    if set.is_compact() {
        let counts = Counts::compact(colors);
        let (rule, none) = (Compact::new(colors), Excess::none());
        return search(rule, &counts, &torus, none, options, limits);
    }
    let counts = counts(colors, &tiles, torus.fold.powers())?;
    if torus.fold.height() < 2 {
        return Err(Refusal::OneRow);
    }
    search(Once::new(colors, &tiles), &counts, &torus, Excess::none(), options, limits)
}

/// Looks for a covering of a corner set under a symmetry, or [`Fold::none`], until it is found or
/// the limits say stop. Every restart has another balanced choice of tiles to be used again.
///
/// # Errors
/// When the set, the torus, the symmetry or the width of the beam do not suit.
pub fn cover(
    set: &TileSet,
    fold: &Fold,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Outcome, Refusal> {
    let (colors, shape) = (set.colors().largest(), fold.shape());
    check(set, shape, options)?;
    if set.is_compact() {
        return Err(Refusal::Compact);
    }
    let fold = oriented(fold);
    if fold.height() < 2 {
        return Err(Refusal::OneRow);
    }
    let turned = fold.shape() != shape;
    let tiles = windows(set, turned);
    let code = |tile: Window| tile.iter().fold(0, |i, color| i * colors + color);
    let mut allowed = vec![false; colors.pow(4)];
    tiles.iter().for_each(|&tile| allowed[code(tile)] = true);
    // One tile of every orbit.
    let (mut least, mut kept) = (Vec::new(), true);
    for &tile in &tiles {
        let mut first = true;
        each_image(fold.powers(), tile, |image| {
            kept &= allowed[code(image)];
            first &= code(image) >= code(tile);
        });
        if first {
            least.push(tile);
        }
    }
    if !kept || fold.powers()[0].len() != colors {
        return Err(Refusal::NotKept);
    }
    let Some(number) = fold.cells().checked_sub(least.len()) else {
        let needed = (least.len() * fold.powers().len()) as u64;
        return Err(Refusal::Size { shape, cells: shape.cells() as u64, tiles: needed });
    };
    let counts = counts(colors, &least, fold.powers())?;
    if !seams::fit(&fold, &least) {
        return Err(Refusal::Seams);
    }
    let frame = Frame::new(shape, turned, None).ok_or(Refusal::Pins)?;
    let torus = Torus { fold, frame };
    if number == 0 {
        let rule = Once::new(colors, &tiles);
        return search(rule, &counts, &torus, Excess::none(), options, limits);
    }
    let sizes = vec![(1, 1), (2, 1), (1, 2)];
    let excess = Excess { number, allowed, colors, sizes };
    search(Times::new(colors, &tiles), &counts, &torus, excess, options, limits)
}

fn check(set: &TileSet, shape: Shape, options: &Options) -> Result<(), Refusal> {
    let (colors, cells) = (set.colors().largest(), shape.cells());
    if set.kind() != Kind::Corner {
        return Err(Refusal::Kind(set.kind()));
    }
    if colors > MAX_BEAM_COLORS || cells > MAX_BEAM_CELLS {
        return Err(Refusal::TooLarge { colors, cells });
    }
    if !(1..=MAX_WIDTH).contains(&options.width) {
        return Err(Refusal::Width(options.width));
    }
    Ok(())
}

/// The fold or its mirror image, whichever has the shorter rows.
fn oriented(fold: &Fold) -> Fold {
    let turned = fold.turned().filter(|turned| turned.width() < fold.width());
    turned.unwrap_or_else(|| fold.clone())
}

/// What is scanned: the cells to choose, and where they and their images lie. Cells are given
/// beforehand only where there is no symmetry.
struct Torus {
    fold: Fold,
    frame: Frame,
}

fn search<R: Rule>(
    rule: R,
    counts: &Counts,
    torus: &Torus,
    excess: Excess,
    options: &Options,
    limits: &Limits<'_>,
) -> Result<Outcome, Refusal> {
    let Torus { fold, frame } = torus;
    let logs = Logarithms::new(options.weights, fold.cells());
    let model = Model::new(fold.clone(), counts, rule, logs, frame.given()).ok_or(Refusal::Pins)?;
    let gumbel = Gumbel::new(options.tau);
    let Options { width, palette, seed, .. } = *options;
    let palette = palette.max(1);
    let beam = Beam { model: &model, gumbel: &gumbel, excess: &excess, width, palette, seed };
    let run = restarts::run(&beam, options.restarts, options.threads.max(1), limits);
    let (restart, labels) = match run.found {
        Some((number, cells)) => (number, Some(frame.restore(&fold.unfold(&cells)))),
        None => (run.ended, None),
    };
    Ok(Outcome { labels, restart, nodes: run.nodes, depth: run.depth })
}

/// The tiles that may occur, reflected through their SW-NE diagonal when rows and columns are
/// exchanged: it keeps NE and SW, so that a compact set remains one.
fn windows(set: &TileSet, turned: bool) -> Vec<Window> {
    let window = |tile| {
        let [ne, se, sw, nw] = set.kind().unpack(tile, set.colors()).map(usize::from);
        if turned { [se, ne, sw, nw] } else { [nw, ne, sw, se] }
    };
    set.allowed().map(window).collect()
}

/// How many dominoes and colors there are to place; under a symmetry how many orbits of them.
fn counts(colors: usize, tiles: &[Window], powers: &[Vec<u8>]) -> Result<Counts, Refusal> {
    let mut sides = [(); 4].map(|()| vec![0; colors * colors]);
    let mut cells = vec![0; colors];
    for &[nw, ne, sw, se] in tiles {
        for (side, domino) in sides.iter_mut().zip([[nw, ne], [sw, se], [nw, sw], [ne, se]]) {
            each_image(powers, domino, |[a, b]| side[a * colors + b] += 1);
        }
        each_image(powers, [nw], |[color]| cells[color] += 1);
    }
    let [north, south, west, east] = sides;
    if north != south || west != east {
        return Err(Refusal::Unbalanced);
    }
    Ok(Counts { across: north, down: west, cells })
}
