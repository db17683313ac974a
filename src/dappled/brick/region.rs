//! Regions of any form, with holes, with any boundary: decided and filled in linear time.
//!
//! Three known edges of a tile always have a fourth. So a part that hangs together is filled from
//! its far ends towards an *exit*, each tile by its edge on the way there:
//!
//! * if some edge of its boundary is free, that is the exit, and there is a wall;
//! * else, if the part holds a cycle of tiles, that comes last. Every tile of it makes, of the
//!   position where the cycle enters, those where it may leave: the same one, or all others. From
//!   some position the cycle closes; with three positions or more there always is one;
//! * else the part is a tree. Every tile tells the next one towards the root which positions of the
//!   edge between them can be had; there is a wall if the root can be filled.
//!
//! Source: Derouet-Jourdan, Kaji, Mizoguchi, *A linear algorithm for brick Wang tiling*, 2019; here
//! with sets of positions as words, and free edges.

use super::{FREE, Side, Wall};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::VecDeque;

/// A part that cannot be filled, by one of its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the part with row {row}, column {column} ({cells} cells) has no wall with this boundary")]
pub struct Unfillable {
    /// The row of its first cell.
    pub row: usize,
    /// The column of its first cell.
    pub column: usize,
    /// How many cells it has.
    pub cells: usize,
}

type Cell = (usize, usize);

/// Whether a tile can have its edges in these sets: exactly one pair of opposite ones alike.
fn possible([north, east, south, west]: [u64; 4]) -> bool {
    let equal = |a: u64, b: u64| a & b != 0;
    let differ = |a: u64, b: u64| a != 0 && b != 0 && (a != b || a & (a - 1) != 0);
    equal(north, south) && differ(east, west) || differ(north, south) && equal(east, west)
}

/// The positions that an edge may have, given sets for the others.
fn choices(mut sets: [u64; 4], side: usize, all: u64) -> u64 {
    let mut choices = 0;
    let mut left = sets[side] & all;
    while left != 0 {
        let one = left & left.wrapping_neg();
        left ^= one;
        sets[side] = one;
        if possible(sets) {
            choices |= one;
        }
    }
    choices
}

/// A wall at work.
struct Filling {
    wall: Wall,
    all: u64,
    random: Pcg64Mcg,
}

impl Filling {
    /// The positions that edges of a cell may have: the known one, or all.
    fn sets(&self, (column, row): Cell) -> [u64; 4] {
        self.wall
            .tile(column, row)
            .map(|position| if position == FREE { self.all } else { 1 << position })
    }

    fn set(&mut self, (column, row): Cell, side: Side, position: u8) {
        self.wall.set(column, row, side, position);
    }

    fn pick(&mut self, mut set: u64) -> Option<u8> {
        if set == 0 {
            return None;
        }
        for _ in 0..self.random.random_range(0..set.count_ones()) {
            set &= set - 1;
        }
        Some(set.trailing_zeros() as u8)
    }

    /// Gives all free edges of a cell but some a position, as it comes.
    fn scatter(&mut self, cell: Cell, but: &[Side]) {
        for side in Side::ALL {
            if !but.contains(&side) && self.wall.at(cell.0, cell.1, side) == FREE {
                let position = self.random.random_range(0..self.wall.positions());
                self.set(cell, side, position);
            }
        }
    }

    /// Fills cells from the last to the first, each by its edge towards the exit.
    fn fill(&mut self, towards: &[(Cell, Side)]) -> Option<()> {
        for &(cell, side) in towards.iter().rev() {
            self.scatter(cell, &[side]);
            let set = choices(self.sets(cell), side as usize, self.all);
            let position = self.pick(set)?;
            self.set(cell, side, position);
        }
        Some(())
    }

    /// The cells of a part by their distance from some of them, with the way back; those themselves
    /// are left out.
    fn ways(&self, from: &[Cell]) -> Vec<(Cell, Side)> {
        let mut seen = vec![false; self.wall.width() * self.wall.height()];
        let index = |(column, row): Cell| row * self.wall.width() + column;
        let mut queue: VecDeque<Cell> = from.iter().copied().collect();
        from.iter().for_each(|&cell| seen[index(cell)] = true);
        let mut ways = Vec::new();
        while let Some(cell) = queue.pop_front() {
            for side in Side::ALL {
                if let Some(next) = self.wall.neighbor(cell.0, cell.1, side)
                    && !seen[index(next)]
                {
                    seen[index(next)] = true;
                    ways.push((next, opposite(side)));
                    queue.push_back(next);
                }
            }
        }
        ways
    }

    /// A cycle of the part of this cell, if there is one: its cells, each with the side where the
    /// cycle leaves it.
    fn cycle(&self, start: Cell) -> Option<Vec<(Cell, Side)>> {
        let ways = self.ways(&[start]);
        let index = |(column, row): Cell| row * self.wall.width() + column;
        let mut back = vec![None; self.wall.width() * self.wall.height()];
        ways.iter().for_each(|&(cell, side)| back[index(cell)] = Some(side));
        // The way from a cell to the start: the cells with the sides where it leaves them.
        let path = |mut cell: Cell| {
            let mut path = Vec::new();
            while let Some(side) = back[index(cell)] {
                path.push((cell, side));
                cell = beyond(cell, side);
            }
            path
        };
        for &(cell, _) in [(start, Side::North)].iter().chain(&ways) {
            for side in Side::ALL {
                let Some(other) = self.wall.neighbor(cell.0, cell.1, side) else { continue };
                let outward = back[index(other)] == Some(opposite(side));
                if outward || back[index(cell)] == Some(side) {
                    continue;
                }
                // An edge that closes a cycle: up from the other cell, down to this one.
                let (mut up, mut down) = (path(other), path(cell));
                while let (Some(a), Some(b)) = (up.last(), down.last())
                    && a == b
                {
                    up.pop();
                    down.pop();
                }
                let down = down.iter().rev().map(|&(at, side)| (beyond(at, side), opposite(side)));
                let mut cycle: Vec<(Cell, Side)> = up.into_iter().chain(down).collect();
                cycle.push((cell, side));
                return Some(cycle);
            }
        }
        None
    }

    /// Fills the cells of a cycle, whose other edges are known.
    fn close(&mut self, cycle: &[(Cell, Side)]) -> Option<()> {
        let entry = |at: usize| opposite(cycle[(at + cycle.len() - 1) % cycle.len()].1);
        for (at, &(cell, leaving)) in cycle.iter().enumerate() {
            self.scatter(cell, &[entry(at), leaving]);
        }
        // What leaves a cell, by what enters it.
        let step = |filling: &Self, at: usize, mut set: u64| {
            let (mut sets, mut leaving) = (filling.sets(cycle[at].0), 0);
            while set != 0 && leaving != filling.all {
                sets[entry(at) as usize] = set & set.wrapping_neg();
                set &= set - 1;
                leaving |= choices(sets, cycle[at].1 as usize, filling.all);
            }
            leaving
        };
        let first = self.random.random_range(0..self.wall.positions());
        for start in (first..self.wall.positions()).chain(0..first) {
            let mut sets = vec![1_u64 << start];
            for at in 0..cycle.len() {
                sets.push(step(self, at, sets[at]));
            }
            if sets[cycle.len()] >> start & 1 == 0 {
                continue;
            }
            // Backwards, from where it closes.
            let mut leaving = start;
            for at in (0..cycle.len()).rev() {
                self.set(cycle[at].0, cycle[at].1, leaving);
                let mut known = self.sets(cycle[at].0);
                known[entry(at) as usize] = sets[at];
                known[cycle[at].1 as usize] = 1 << leaving;
                let set = choices(known, entry(at) as usize, self.all);
                leaving = self.pick(set)?;
            }
            return Some(());
        }
        None
    }

    /// Fills a tree, the boundary of which is known.
    fn tree(&mut self, root: Cell) -> Option<()> {
        let ways = self.ways(&[root]);
        let width = self.wall.width();
        let index = move |(column, row): Cell| row * width + column;
        // What the cell of each number can have on its side towards the root.
        let mut told = vec![0; self.wall.width() * self.wall.height()];
        let mut towards = vec![None; told.len()];
        ways.iter().for_each(|&(cell, side)| towards[index(cell)] = Some(side));
        let sets = |filling: &Self, told: &[u64], cell: Cell| {
            let mut sets = filling.sets(cell);
            for side in Side::ALL {
                if let Some(next) = filling.wall.neighbor(cell.0, cell.1, side)
                    && towards[index(next)] == Some(opposite(side))
                    && filling.wall.at(cell.0, cell.1, side) == FREE
                {
                    sets[side as usize] = told[index(next)];
                }
            }
            sets
        };
        for &(cell, side) in ways.iter().rev() {
            told[index(cell)] = choices(sets(self, &told, cell), side as usize, self.all);
        }
        // From the root on, every edge one after the other.
        let cells: Vec<Cell> = [root].into_iter().chain(ways.iter().map(|way| way.0)).collect();
        for cell in cells {
            for side in Side::ALL {
                let set = choices(sets(self, &told, cell), side as usize, self.all);
                let position = self.pick(set)?;
                self.set(cell, side, position);
            }
        }
        Some(())
    }
}

fn opposite(side: Side) -> Side {
    Side::ALL[(side as usize + 2) % 4]
}

/// The neighbor of a cell that is known to have one.
fn beyond((column, row): Cell, side: Side) -> Cell {
    match side {
        Side::North => (column, row - 1),
        Side::South => (column, row + 1),
        Side::West => (column - 1, row),
        Side::East => (column + 1, row),
    }
}

/// Fills all cells of a wall of which boundary edges may be known, inner ones not.
///
/// # Errors
/// A part that has no wall.
pub fn fill(partial: &Wall, seed: u64) -> Result<Wall, Unfillable> {
    let all = u64::MAX >> (64 - partial.positions());
    let mut filling = Filling { wall: partial.clone(), all, random: Pcg64Mcg::seed_from_u64(seed) };
    let mut seen = vec![false; partial.width() * partial.height()];
    for start in partial.cells() {
        if seen[start.1 * partial.width() + start.0] {
            continue;
        }
        let ways = filling.ways(&[start]);
        let cells: Vec<Cell> = [start].into_iter().chain(ways.iter().map(|way| way.0)).collect();
        cells.iter().for_each(|cell| seen[cell.1 * partial.width() + cell.0] = true);
        let exit = cells.iter().find_map(|&cell| {
            let is_exit = |side: &Side| {
                partial.at(cell.0, cell.1, *side) == FREE
                    && partial.neighbor(cell.0, cell.1, *side).is_none()
            };
            Some((cell, Side::ALL.into_iter().find(is_exit)?))
        });
        let filled = if let Some(exit) = exit {
            let ways = filling.ways(&[exit.0]);
            filling.fill(&[&[exit], &ways[..]].concat())
        } else if let Some(cycle) = filling.cycle(start) {
            let of_cycle: Vec<Cell> = cycle.iter().map(|way| way.0).collect();
            let ways = filling.ways(&of_cycle);
            filling.fill(&ways).and_then(|()| filling.close(&cycle))
        } else {
            filling.tree(start)
        };
        if filled.is_none() {
            let (column, row) = start;
            return Err(Unfillable { row, column, cells: cells.len() });
        }
    }
    Ok(filling.wall)
}
