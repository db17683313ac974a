//! Which tiles a semi-stochastic tiling can show.
//!
//! A point shows only the colors that have a probability above 0 in its cell. Going along a row of
//! points, its neighbors are in the same cell or in the next, so of all tiles just those can occur
//! whose corners lie in four cells of the map that come together somewhere (a cell of one point meets
//! two neighbors at once). The exact set is the union, over all places, of the products of the four
//! supports. What is easier to pack is a pruned set ([`crate::tiles::Members::Pruned`]): pairs of
//! colors that no tile shows on two of its corners are excluded, all six pairs of corners looked at;
//! it contains the exact set.

use super::Probabilities;
use crate::tiles::{Color, TileId};
use std::collections::{BTreeSet, HashSet};

impl Probabilities {
    /// The different quadruples of supports around a tile, in the order of a tile's sides.
    fn around_tiles(&self) -> Vec<[Vec<u8>; 4]> {
        let (width, height) = (self.shape().width(), self.shape().height());
        let supports = self.supports();
        let mut different = supports.clone();
        different.sort_unstable();
        different.dedup();
        let numbers: Vec<usize> = supports
            .iter()
            .map(|support| different.partition_point(|other| other < support))
            .collect();
        let at = |row: usize, column: usize| numbers[row * width + column];
        // The columns of cells in which the west and the east corners of a tile can lie; and the rows
        // of its north and south ones.
        let steps = |cells: usize, scale: u32| {
            let within = (0..cells).filter(move |_| scale > 1).map(|cell| (cell, cell));
            within.chain((0..cells).map(move |cell| (cell, (cell + 1) % cells)))
        };
        let mut found = HashSet::new();
        for (north, south) in steps(height, self.scale()[1]) {
            for (west, east) in steps(width, self.scale()[0]) {
                found.insert([at(north, east), at(south, east), at(south, west), at(north, west)]);
            }
        }
        found.into_iter().map(|corners| corners.map(|corner| different[corner].clone())).collect()
    }

    /// All tiles that can occur, in order.
    pub fn tiles(&self) -> Vec<TileId> {
        let c = self.colors() as u32;
        let mut tiles = BTreeSet::new();
        for [ne, se, sw, nw] in self.around_tiles() {
            for &a in &ne {
                for &b in &se {
                    for &d in &sw {
                        let first = (u32::from(a) * c + u32::from(b)) * c + u32::from(d);
                        tiles.extend(nw.iter().map(|&e| TileId(first * c + u32::from(e))));
                    }
                }
            }
        }
        tiles.into_iter().collect()
    }

    /// The pairs of colors that no tile shows: what a pruned set excludes.
    pub fn never_together(&self) -> Vec<(Color, Color)> {
        let c = self.colors();
        let mut together = vec![false; c * c];
        for corners in self.around_tiles() {
            for (at, first) in corners.iter().enumerate() {
                for (other, second) in corners.iter().enumerate() {
                    if at != other {
                        for &a in first {
                            for &b in second {
                                together[usize::from(a) * c + usize::from(b)] = true;
                            }
                        }
                    }
                }
            }
        }
        (0..c)
            .flat_map(|a| (a + 1..c).map(move |b| (a, b)))
            .filter(|&(a, b)| !together[a * c + b])
            .map(|(a, b)| (Color(a as u8), Color(b as u8)))
            .collect()
    }
}
