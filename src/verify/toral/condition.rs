//! The way back: every tiling by the corner tiles gives one by the Wang tiles.
//!
//! The labels of a pair of colors are those that occur at a side between two vertices of these
//! colors; the options of a corner tile are **all** Wang tiles whose labels occur at its four
//! pairs.
//!
//! * *Pair.* Every pair of a corner tile has one label. Then each has one option, and neighbors
//!   fit: the side they share has one label.
//! * *Radius 1.* A corner tile stands for its only option, or for the only one that fits some
//!   option of each of the four neighbors. There is exactly one in every surrounding that can
//!   occur in a tiling, and those of neighbors fit.
//! * *Radius 2.* The same, with options of the neighbors that fit some option of each of theirs.
//!
//! A surrounding can occur only if it can be continued by a margin of one cell, all of it legal.
//! All of them are tried, so what holds for them holds in every tiling.

use super::WayBack;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};

/// Cells filled at most, so that no file keeps us busy for hours.
const PATIENCE: u64 = 100_000_000;

/// Labels by the two colors of a side, separately for sides that run west to east (N and S) and
/// north to south.
type Labels = BTreeMap<(bool, u32, u32), BTreeSet<u32>>;

/// The sides N, E, S, W of a corner tile [NW, NE, SE, SW]: whether it runs west to east, and its
/// colors from the west or the north on.
fn side([nw, ne, se, sw]: [u32; 4], side: usize) -> (bool, u32, u32) {
    [(true, nw, ne), (false, ne, se), (true, sw, se), (false, nw, sw)][side]
}

/// For each corner tile the numbers of the Wang tiles that it may stand for.
pub(super) type Options = Vec<Vec<usize>>;

/// The options of corner tiles that occur with these Wang tiles, and which way back there is.
pub(super) fn check(
    wang: &[[u32; 4]],
    tiles: &[[u32; 4]],
    occurring: &[BTreeSet<usize>],
) -> (Options, Result<WayBack, String>) {
    let mut labels = Labels::new();
    for (&tile, numbers) in tiles.iter().zip(occurring) {
        for (&number, s) in numbers.iter().flat_map(|number| (0..4).map(move |s| (number, s))) {
            labels.entry(side(tile, s)).or_default().insert(wang[number][s]);
        }
    }
    let has = |tile: [u32; 4], s: usize, label: u32| {
        labels.get(&side(tile, s)).is_some_and(|all| all.contains(&label))
    };
    let mut options: Options = Vec::with_capacity(tiles.len());
    for &tile in tiles {
        let fits = |&number: &usize| (0..4).all(|s| has(tile, s, wang[number][s]));
        options.push((0..wang.len()).filter(fits).collect());
    }
    if labels.values().all(|labels| labels.len() == 1) {
        return (options, Ok(WayBack::Pair));
    }
    let decode = |radius| {
        let left = Cell::new(PATIENCE);
        Decoding { wang, tiles, options: &options, radius, left }.check(&labels)
    };
    let way_back = match decode(1) {
        Ok(()) => Ok(WayBack::Radius1),
        Err(reason) => decode(2).map(|()| WayBack::Radius2).map_err(|_| reason),
    };
    (options, way_back)
}

/// The map from surroundings to Wang tiles.
struct Decoding<'a> {
    wang: &'a [[u32; 4]],
    tiles: &'a [[u32; 4]],
    options: &'a [Vec<usize>],
    /// Steps from a cell to those it is read from.
    radius: usize,
    /// Steps that may still be taken.
    left: Cell<u64>,
}

/// Steps to the north, east, south and west, as rows and columns.
const STEPS: [(isize, isize); 4] = [(-1, 0), (0, 1), (1, 0), (0, -1)];

/// Corner tiles in a box; those not yet chosen are `None`.
struct Patch {
    width: usize,
    cells: Vec<Option<usize>>,
}

impl Patch {
    /// The cell a step away, if it is in the box.
    fn next(&self, cell: usize, direction: usize) -> Option<usize> {
        let (row, column) = ((cell / self.width) as isize, (cell % self.width) as isize);
        let (down, right) = STEPS[direction];
        let (row, column) = (row + down, column + right);
        let height = self.cells.len() / self.width;
        let inside =
            (0..height as isize).contains(&row) && (0..self.width as isize).contains(&column);
        inside.then(|| row as usize * self.width + column as usize)
    }
}

impl Decoding<'_> {
    /// Tries all surroundings of cells with several options and of neighbors whose common side
    /// has several labels.
    fn check(&self, labels: &Labels) -> Result<(), String> {
        for (tile, options) in self.options.iter().enumerate() {
            if options.len() > 1 {
                self.try_all(&[(tile, 0, 0)])?;
            }
        }
        for (one, &tile) in self.tiles.iter().enumerate() {
            for (s, down, right) in [(1, 0, 1), (2, 1, 0)] {
                if labels.get(&side(tile, s)).is_some_and(|all| all.len() == 1) {
                    continue;
                }
                for (two, &other) in self.tiles.iter().enumerate() {
                    if side(tile, s) == side(other, (s + 2) % 4) {
                        self.try_all(&[(one, 0, 0), (two, down, right)])?;
                    }
                }
            }
        }
        Ok(())
    }

    /// All surroundings of one or two tiles, given with their rows and columns.
    fn try_all(&self, middle: &[(usize, usize, usize)]) -> Result<(), String> {
        let reach = self.radius + 1;
        let (down, right) = middle.last().map_or((0, 0), |&(_, down, right)| (down, right));
        let (height, width) = (2 * reach + 1 + down, 2 * reach + 1 + right);
        let mut patch = Patch { width, cells: vec![None; height * width] };
        let mut middles = Vec::new();
        for &(tile, down, right) in middle {
            let cell = (reach + down) * width + reach + right;
            patch.cells[cell] = Some(tile);
            middles.push(cell);
        }
        // From the middle outwards, first the cells that are read.
        let distance = |cell: &usize| {
            let apart = |&middle: &usize| {
                (cell / width).abs_diff(middle / width) + (cell % width).abs_diff(middle % width)
            };
            middles.iter().map(apart).min().unwrap_or(0)
        };
        let mut order: Vec<usize> =
            (0..patch.cells.len()).filter(|&cell| patch.cells[cell].is_none()).collect();
        order.sort_by_key(distance);
        let read = order.iter().filter(|&cell| distance(cell) <= self.radius).count();
        match self.extend(&mut patch, &middles, &order, read) {
            None => Ok(()),
            Some(reason) => Err(reason),
        }
    }

    /// Fills the cells in order; a reason as soon as a surrounding that can be continued to the
    /// whole box is not read as it should be.
    fn extend(
        &self,
        patch: &mut Patch,
        middles: &[usize],
        order: &[usize],
        read: usize,
    ) -> Option<String> {
        let filled = patch.cells.iter().flatten().count() - middles.len();
        if filled == read {
            let fault = self.fault(patch, middles)?;
            return self.continues(patch, order, filled).then_some(fault);
        }
        let cell = order[filled];
        for tile in 0..self.tiles.len() {
            if self.is_legal(patch, cell, tile) {
                if self.is_out_of_patience() {
                    return Some(format!("more than {PATIENCE} cells of surroundings to fill"));
                }
                patch.cells[cell] = Some(tile);
                let found = self.extend(patch, middles, order, read);
                patch.cells[cell] = None;
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }

    /// Whether the rest of the box can be filled.
    fn continues(&self, patch: &mut Patch, order: &[usize], filled: usize) -> bool {
        let Some(&cell) = order.get(filled) else { return true };
        for tile in 0..self.tiles.len() {
            if self.is_legal(patch, cell, tile) {
                // What is not known to end is taken to go on: that refuses more.
                if self.is_out_of_patience() {
                    return true;
                }
                patch.cells[cell] = Some(tile);
                let can = self.continues(patch, order, filled + 1);
                patch.cells[cell] = None;
                if can {
                    return true;
                }
            }
        }
        false
    }

    /// Counts a cell that is filled.
    fn is_out_of_patience(&self) -> bool {
        self.left.set(self.left.get().saturating_sub(1));
        self.left.get() == 0
    }

    /// Whether a tile agrees with the neighbors that are there.
    fn is_legal(&self, patch: &Patch, cell: usize, tile: usize) -> bool {
        (0..4).all(|d| {
            let other = patch.next(cell, d).and_then(|next| patch.cells[next]);
            other.is_none_or(|other| {
                side(self.tiles[tile], d) == side(self.tiles[other], (d + 2) % 4)
            })
        })
    }

    /// The options of a cell that fit those of its neighbors, which fit those of theirs, so many
    /// steps away.
    fn left(&self, patch: &Patch, cell: usize, radius: usize) -> Vec<usize> {
        let Some(tile) = patch.cells[cell] else { return Vec::new() };
        let mut left = self.options[tile].clone();
        if radius == 0 || left.len() == 1 {
            return left;
        }
        for d in 0..4 {
            if let Some(next) = patch.next(cell, d) {
                let theirs = self.left(patch, next, radius - 1);
                let meets =
                    |wang: usize, other: usize| self.wang[wang][d] == self.wang[other][(d + 2) % 4];
                left.retain(|&wang| theirs.iter().any(|&other| meets(wang, other)));
            }
        }
        left
    }

    /// What is wrong with the middle of a patch.
    fn fault(&self, patch: &Patch, middles: &[usize]) -> Option<String> {
        let name = |cell: usize| {
            patch.cells[cell].map_or(String::new(), |tile| format!("{:?}", self.tiles[tile]))
        };
        let mut wang = Vec::new();
        for &cell in middles {
            match self.left(patch, cell, self.radius)[..] {
                [only] => wang.push(only),
                ref left => {
                    return Some(format!(
                        "corner tile {} stands for the Wang tiles {left:?} in some surrounding, \
                         expected one",
                        name(cell)
                    ));
                }
            }
        }
        let [one, two] = middles[..] else { return None };
        let d = if two == one + 1 { 1 } else { 2 };
        (self.wang[wang[0]][d] != self.wang[wang[1]][(d + 2) % 4]).then(|| {
            format!(
                "corner tiles {} and {} are neighbors, but stand for Wang tiles {} and {}, \
                 which do not fit",
                name(one),
                name(two),
                wang[0],
                wang[1]
            )
        })
    }
}
