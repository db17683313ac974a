//! Coverings of corner sets: every tile at least once, and no other window.
//!
//! The cost is the number of tiles that are missing and of windows that show no tile of the
//! set, so a covering is what costs nothing. Under a symmetry ([`Fold`]) only a part of the
//! torus is unknown, and of the tiles that the symmetry makes of each other one is counted. The
//! walk begins anew, with another of three temperatures, when it has come to nothing for long.
//! The more cells there are to spare the sooner it ends: a tenth more than tiles is easy.
//!
//! Source: this project.

use super::metropolis::{Landscape, walk};
use crate::search::Limits;
use crate::tiles::{Kind, TileSet};
use crate::torus::Fold;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// The largest number of colors: there is a word for every tile over them.
pub const MAX_COVER_COLORS: usize = 64;

/// Temperatures of the first, second, third walk, and again.
const TEMPERATURES: [f64; 3] = [0.25, 0.2, 0.3];

/// Moves of the first three walks for each unknown cell; the next three have twice as many.
const PATIENCE: u64 = 20_000;

/// A window that shows no tile of the set.
const ILLEGAL: u32 = u32::MAX;

/// What a walk came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Walk {
    /// The colors of all lattice points, row by row; `None` when a limit was met.
    pub labels: Option<Vec<u8>>,
    /// Moves tried.
    pub moves: u64,
}

/// A covering of the torus, under its symmetry if it has one; nodes are moves.
///
/// Nothing is found when the set is no fixed set of corner tiles, the symmetry does not keep
/// it, or there are fewer cells than tiles; then nothing is tried either.
pub fn cover(set: &TileSet, fold: &Fold, seed: u64, limits: &Limits<'_>) -> Walk {
    let mut moves = 0;
    let Some(mut torus) = Torus::new(set, fold) else { return Walk { labels: None, moves } };
    let mut rng = Pcg64::seed_from_u64(seed);
    for round in 0u32.. {
        torus.begin(&mut rng);
        let patience = PATIENCE.saturating_mul(torus.cells() as u64) << (round / 3).min(32);
        let most = limits.nodes.min(moves.saturating_add(patience));
        let temperature = TEMPERATURES[round as usize % TEMPERATURES.len()];
        if walk(&mut torus, temperature, &mut rng, &mut moves, most, limits.stop) {
            let cells: Vec<u8> = torus.cells.iter().map(|&color| color as u8).collect();
            return Walk { labels: Some(fold.unfold(&cells)), moves };
        }
        if moves >= limits.nodes || limits.stop.should_stop() {
            break;
        }
    }
    Walk { labels: None, moves }
}

/// The orbits into which the symmetry puts the tiles: a covering under it has as many cells left to
/// choose at least. `None` when it does not keep the set.
pub fn orbits(set: &TileSet, fold: &Fold) -> Option<usize> {
    classes(set, &powers(fold)).map(|(_, number)| number)
}

fn powers(fold: &Fold) -> Vec<Vec<usize>> {
    fold.powers().iter().map(|power| power.iter().map(|&c| c.into()).collect()).collect()
}

/// The unknown cells, and what their windows show.
struct Torus {
    colors: usize,
    cells: Vec<usize>,
    /// For every window the cells of its corners and their steps.
    corners: Vec<[(u32, u32); 4]>,
    /// For every cell the windows that show it, each once, and how many they are.
    around: Vec<([u32; 4], usize)>,
    /// Images of the colors after so many steps.
    powers: Vec<Vec<usize>>,
    /// The number of a tile, by its colors; images have the same.
    classes: Vec<u32>,
    /// By that number, the windows that show it.
    shown: Vec<u32>,
    cost: i64,
}

impl Torus {
    fn new(set: &TileSet, fold: &Fold) -> Option<Self> {
        let colors = set.colors().largest();
        let suits = set.kind() == Kind::Corner
            && !set.is_compact()
            && (1..=MAX_COVER_COLORS).contains(&colors)
            && fold.powers()[0].len() == colors;
        if !suits {
            return None;
        }
        let powers = powers(fold);
        let (classes, number) = classes(set, &powers)?;
        if number > fold.cells() {
            return None;
        }
        let (w, h) = (fold.width(), fold.height());
        let corner = |row, column| {
            let (cell, steps) = fold.locate(row, column);
            (cell as u32, steps as u32)
        };
        let window = |r, c| [(r, c), (r, c + 1), (r + 1, c), (r + 1, c + 1)];
        let corners: Vec<[(u32, u32); 4]> =
            (0..w * h).map(|i| window(i / w, i % w).map(|(r, c)| corner(r, c))).collect();
        let mut around = vec![([0; 4], 0); w * h];
        for (window, corners) in corners.iter().enumerate() {
            for &(cell, _) in corners {
                let (windows, count) = &mut around[cell as usize];
                if !windows[..*count].contains(&(window as u32)) {
                    windows[*count] = window as u32;
                    *count += 1;
                }
            }
        }
        let (cells, shown) = (vec![0; w * h], vec![0; number]);
        Some(Self { colors, cells, corners, around, powers, classes, shown, cost: 0 })
    }

    /// Random colors.
    fn begin(&mut self, rng: &mut Pcg64) {
        self.cells.iter_mut().for_each(|cell| *cell = rng.random_range(0..self.colors));
        self.shown.fill(0);
        self.cost = self.shown.len() as i64;
        (0..self.corners.len()).for_each(|window| self.count(window, true));
    }

    /// Counts a window in, or out again.
    #[inline]
    fn count(&mut self, window: usize, more: bool) {
        let color =
            |(cell, steps): (u32, u32)| self.powers[steps as usize][self.cells[cell as usize]];
        let tile =
            self.corners[window].iter().fold(0, |i, &corner| i * self.colors + color(corner));
        let class = self.classes[tile];
        if class == ILLEGAL {
            self.cost += if more { 1 } else { -1 };
        } else if more {
            self.shown[class as usize] += 1;
            self.cost -= i64::from(self.shown[class as usize] == 1);
        } else {
            self.shown[class as usize] -= 1;
            self.cost += i64::from(self.shown[class as usize] == 0);
        }
    }
}

impl Landscape for Torus {
    fn cells(&self) -> usize {
        self.cells.len()
    }

    fn colors(&self) -> usize {
        self.colors
    }

    fn color(&self, cell: usize) -> usize {
        self.cells[cell]
    }

    fn recolor(&mut self, cell: usize, color: usize) {
        let (windows, number) = self.around[cell];
        windows[..number].iter().for_each(|&window| self.count(window as usize, false));
        self.cells[cell] = color;
        windows[..number].iter().for_each(|&window| self.count(window as usize, true));
    }

    fn cost(&self) -> i64 {
        self.cost
    }
}

/// Numbers of the tiles by their colors (NW, NE, SW, SE), the same for all images, and how many
/// numbers there are; `None` when the set is not kept.
fn classes(set: &TileSet, powers: &[Vec<usize>]) -> Option<(Vec<u32>, usize)> {
    let colors = set.colors().largest();
    let code = |tile: [usize; 4]| tile.iter().fold(0, |i, color| i * colors + color);
    let tiles: Vec<[usize; 4]> = set
        .allowed()
        .map(|tile| {
            let [ne, se, sw, nw] = set.kind().unpack(tile, set.colors()).map(usize::from);
            [nw, ne, sw, se]
        })
        .collect();
    let mut classes = vec![ILLEGAL; colors.pow(4)];
    let mut number = 0;
    for &tile in &tiles {
        if classes[code(tile)] == ILLEGAL {
            powers.iter().for_each(|power| classes[code(tile.map(|c| power[c]))] = number);
            number += 1;
        }
    }
    let kept = classes.iter().filter(|&&class| class != ILLEGAL).count() == tiles.len();
    kept.then_some((classes, number as usize))
}
