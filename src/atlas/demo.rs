//! A piece of the endless tiling, for maps and pictures that show a set at work.
//!
//! A **complete** set has a tile for any colors, so that colors drawn by a hash of place and seed
//! make a tiling. Other sets are laid tile by tile, each time one of those that fit what lies
//! there, with a bounded number of steps back. Corner tiles are laid from the south-west: only
//! the NE corner is then free, the one that differs between the two tiles which a compact set
//! (Lagae 2007, 3.2.2) has for the other three. Wang tiles are laid from the north-west, for the
//! two tiles for each N and W. So neither ever steps back. Where stepping back does not help, the
//! packing itself is repeated: it always fits.
//!
//! The piece does not wrap around. The same arguments always give the same piece.

use crate::tiles::{Kind, Members, TileId};
use crate::torus::{Packing, Shape};
use std::collections::HashMap;

/// How a piece was laid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// Random colors: any are allowed.
    Colors,
    /// One random tile after the other.
    TileByTile,
    /// Copies of the packing side by side.
    Repeated,
}

/// A piece of a tiling: a rectangle whose neighbors match.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Demo {
    /// Its width and height.
    pub shape: Shape,
    /// Its tiles, row by row.
    pub tiles: Vec<TileId>,
    /// How it was laid.
    pub how: How,
}

/// Steps, with those back, that a tile may cost.
const STEPS: usize = 100;

/// A side that may have any color.
const FREE: u8 = u8::MAX;

/// A piece of a tiling with the tiles of a packing of corner or Wang tiles on a torus.
pub fn tiling(packing: &Packing, shape: Shape, seed: u64) -> Demo {
    if *packing.set.members() == Members::Complete
        && let Some(tiles) = random(packing, shape, seed)
    {
        return Demo { shape, tiles, how: How::Colors };
    }
    match Layer::new(packing, shape).lay(seed) {
        Some(tiles) => Demo { shape, tiles, how: How::TileByTile },
        None => Demo { shape, tiles: repeated(packing, shape), how: How::Repeated },
    }
}

/// A random word for a place: the finalizer of SplitMix64 (Steele, Lea and Flood 2014).
fn hash(seed: u64, place: u64) -> u64 {
    let mut x = seed
        .wrapping_mul(0xd129_0ddb_53c4_3e49)
        .wrapping_add(place.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// A random number below `count`.
fn below(count: usize, seed: u64, place: u64) -> usize {
    (((hash(seed, place) >> 32) * count as u64) >> 32) as usize
}

/// Tiles that show random colors.
fn random(packing: &Packing, shape: Shape, seed: u64) -> Option<Vec<TileId>> {
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let lines = shape.width() as u64 + 1;
    // Two colors a place: of a corner or north edge, and of a west edge.
    let color = |row: usize, column: usize, of: usize| {
        let place = 2 * (row as u64 * lines + column as u64) + of as u64;
        below(if of == 0 { colors.horizontal() } else { colors.vertical() }, seed, place) as u8
    };
    let cells = (0..shape.height()).flat_map(|r| (0..shape.width()).map(move |c| (r, c)));
    cells
        .map(|(r, c)| {
            let sides = match kind {
                Kind::Corner => {
                    [color(r, c + 1, 0), color(r + 1, c + 1, 0), color(r + 1, c, 0), color(r, c, 0)]
                }
                _ => [color(r, c, 0), color(r, c + 1, 1), color(r + 1, c, 0), color(r, c, 1)],
            };
            kind.pack(&sides, colors).ok()
        })
        .collect()
}

fn repeated(packing: &Packing, shape: Shape) -> Vec<TileId> {
    let (w, h) = (packing.shape.width(), packing.shape.height());
    let cells = (0..shape.height()).flat_map(|r| (0..shape.width()).map(move |c| (r, c)));
    cells.map(|(r, c)| packing.tiles[r % h * w + c % w]).collect()
}

/// Lays tile by tile.
struct Layer<'a> {
    packing: &'a Packing,
    shape: Shape,
    /// The tiles that show some colors, [`FREE`] standing for any.
    fitting: HashMap<[u8; 4], Vec<TileId>>,
}

impl<'a> Layer<'a> {
    fn new(packing: &'a Packing, shape: Shape) -> Self {
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let mut tiles = packing.tiles.clone();
        tiles.sort_unstable();
        tiles.dedup();
        let mut fitting: HashMap<_, Vec<TileId>> = HashMap::new();
        for &tile in &tiles {
            let sides = kind.unpack(tile, colors);
            for (line, before) in [(false, false), (true, false), (false, true), (true, true)] {
                let known = known(kind, line, before);
                let key = std::array::from_fn(|i| if known[i] { sides[i] } else { FREE });
                fitting.entry(key).or_default().push(tile);
            }
        }
        Self { packing, shape, fitting }
    }

    /// The cell that is laid in this step: corner tiles from the south up.
    fn cell(&self, step: usize) -> usize {
        let (w, h) = (self.shape.width(), self.shape.height());
        match self.packing.set.kind() {
            Kind::Corner => (h - 1 - step / w) * w + step % w,
            _ => step,
        }
    }

    /// What the tile of this step has to show.
    fn key(&self, tiles: &[TileId], step: usize) -> [u8; 4] {
        let (kind, colors) = (self.packing.set.kind(), self.packing.set.colors());
        let width = self.shape.width();
        let sides = |step: usize| kind.unpack(tiles[self.cell(step)], colors);
        let mut key = [FREE; 4];
        let line = step.checked_sub(width).map(sides);
        let before = (!step.is_multiple_of(width)).then(|| sides(step - 1));
        if kind == Kind::Corner {
            // NE, SE, SW, NW.
            if let Some(south) = line {
                [key[1], key[2]] = [south[0], south[3]];
            }
            if let Some(west) = before {
                [key[3], key[2]] = [west[0], west[1]];
            }
        } else {
            // N, E, S, W.
            key[0] = line.map_or(FREE, |north| north[2]);
            key[3] = before.map_or(FREE, |west| west[1]);
        }
        key
    }

    fn lay(&self, seed: u64) -> Option<Vec<TileId>> {
        let cells = self.shape.cells();
        let mut tiles = vec![TileId(0); cells];
        // How many tiles were tried in each step.
        let mut tried = vec![0; cells];
        let mut step = 0;
        for _ in 0..cells.saturating_mul(STEPS) {
            if step == cells {
                return Some(tiles);
            }
            let fitting = self.fitting.get(&self.key(&tiles, step));
            let fitting = fitting.map_or(&[][..], Vec::as_slice);
            if tried[step] < fitting.len() {
                let first = below(fitting.len(), seed, step as u64);
                tiles[self.cell(step)] = fitting[(first + tried[step]) % fitting.len()];
                tried[step] += 1;
                step += 1;
            } else {
                tried[step] = 0;
                step = step.checked_sub(1)?;
            }
        }
        (step == cells).then_some(tiles)
    }
}

/// Which sides are known where the line before and the cell before are.
fn known(kind: Kind, line: bool, before: bool) -> [bool; 4] {
    match kind {
        Kind::Corner => [false, line, line || before, before],
        _ => [line, false, false, before],
    }
}
