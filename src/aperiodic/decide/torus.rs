//! The smallest torus on which tiles fit, by strips.
//!
//! A strip of height h with a period downward is a walk in a graph: its steps are the columns of
//! h tiles whose lowest fits above the highest, from their W labels to their E labels. A shortest
//! cycle is a narrowest torus of that height. A torus that has neither a height nor a width of h
//! or less has at least (h + 1)^2 cells, so strips in both directions up to the root of the
//! smallest area found are enough to know that it is the smallest.

use super::cycles::on_cycles;
use super::form::{Tile, labels, transposed};
use crate::search::Stop;
use std::collections::{HashMap, HashSet, VecDeque};

/// A filled torus.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Torus {
    /// Tiles in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The numbers of the tiles, row after row from the north.
    pub cells: Vec<usize>,
    /// Whether none has fewer cells.
    pub smallest: bool,
}

impl Torus {
    /// The number of cells.
    pub fn area(&self) -> usize {
        self.cells.len()
    }

    /// Rows become columns.
    fn transposed(self) -> Self {
        let (width, height) = (self.height, self.width);
        let cells = (0..self.area()).map(|i| self.cells[i % width * height + i / width]).collect();
        Self { width, height, cells, smallest: self.smallest }
    }
}

/// How far to go.
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    /// Columns of a strip.
    pub columns: u64,
    /// Steps looked at for the cycles of a strip.
    pub steps: u64,
}

/// The smallest torus; among those, one of the smallest height or width. `None` when there is
/// none of height or width at most `most`, or the bounds are too tight to find one.
pub fn smallest(tiles: &[Tile], most: usize, bounds: Bounds, stop: &dyn Stop) -> Option<Torus> {
    let turned = transposed(tiles);
    let mut best: Option<Torus> = None;
    let mut sure = true;
    for height in 1usize.. {
        let area = best.as_ref().map_or(usize::MAX, Torus::area);
        let enough = height.saturating_mul(height) >= area;
        if enough || best.is_none() && height > most || stop.should_stop() {
            sure &= enough;
            break;
        }
        for rows in [true, false] {
            let area = best.as_ref().map_or(usize::MAX, Torus::area);
            let strip = Strip::new(if rows { tiles } else { &turned }, height, bounds.columns);
            let Some(strip) = strip else {
                sure = false;
                continue;
            };
            let (cycle, all) = strip.shortest_cycle((area - 1) / height, bounds.steps);
            sure &= all;
            if let Some(columns) = cycle {
                let torus = strip.torus(&columns);
                best = Some(if rows { torus } else { torus.transposed() });
            }
        }
    }
    best.map(|torus| Torus { smallest: sure, ..torus })
}

/// The columns of a height that fit below themselves, as steps of a graph.
struct Strip {
    height: usize,
    /// The tiles of the columns, from the top, one column after the other.
    tiles: Vec<u32>,
    /// For each column the states W and E.
    steps: Vec<(u32, u32)>,
    states: usize,
}

impl Strip {
    /// `None` when there are too many columns.
    fn new(tiles: &[Tile], height: usize, most: u64) -> Option<Self> {
        let mut below: Vec<Vec<u32>> = vec![Vec::new(); labels(tiles).0];
        (0..).zip(tiles).for_each(|(number, tile)| below[tile[0] as usize].push(number));
        if closed_walks(tiles, &below, height) > most {
            return None;
        }
        let mut strip = Self { height, tiles: Vec::new(), steps: Vec::new(), states: 0 };
        let mut seen = HashSet::new();
        let mut names = HashMap::new();
        let mut column: Vec<u32> = Vec::with_capacity(height);
        // For each tile of the column which of those that fit there comes next.
        let mut next = vec![0; height + 1];
        loop {
            let depth = column.len();
            let choice = match column.last() {
                None => (next[0] < tiles.len()).then_some(next[0] as u32),
                Some(&above) if depth < height => {
                    below[tiles[above as usize][2] as usize].get(next[depth]).copied()
                }
                Some(&last) => {
                    if tiles[last as usize][2] == tiles[column[0] as usize][0] {
                        strip.add(tiles, &column, &mut names, &mut seen);
                    }
                    None
                }
            };
            match choice {
                Some(tile) => {
                    next[depth] += 1;
                    next[depth + 1] = 0;
                    column.push(tile);
                }
                None if depth == 0 => break,
                None => {
                    column.pop();
                }
            }
        }
        strip.states = names.len();
        strip.cut();
        Some(strip)
    }

    /// Keeps one column for each pair of states.
    fn add(
        &mut self,
        tiles: &[Tile],
        column: &[u32],
        names: &mut HashMap<Vec<u32>, u32>,
        seen: &mut HashSet<(u32, u32)>,
    ) {
        let mut state = |side: usize| {
            let labels: Vec<u32> = column.iter().map(|&t| tiles[t as usize][side]).collect();
            let new = names.len() as u32;
            *names.entry(labels).or_insert(new)
        };
        let step = (state(3), state(1));
        if seen.insert(step) {
            self.steps.push(step);
            self.tiles.extend(column);
        }
    }

    /// Keeps only columns on a cycle.
    fn cut(&mut self) {
        let kept = on_cycles(self.states, &self.steps);
        let columns = self.tiles.chunks(self.height).zip(&kept);
        self.tiles = columns.filter(|(_, kept)| **kept).flat_map(|(c, _)| c.to_vec()).collect();
        let mut kept = kept.into_iter();
        self.steps.retain(|_| kept.next().unwrap_or(false));
    }

    /// The columns of a shortest cycle, if that has at most `most`; and whether the search for a
    /// shorter one was complete.
    fn shortest_cycle(&self, most: usize, mut budget: u64) -> (Option<Vec<usize>>, bool) {
        let mut leaving: Vec<Vec<u32>> = vec![Vec::new(); self.states];
        (0..).zip(&self.steps).for_each(|(step, &(from, _))| leaving[from as usize].push(step));
        let (mut best, mut most) = (None, most);
        // The step by which a state was reached, and from which root.
        let mut reached = vec![(u32::MAX, u32::MAX); self.states];
        for root in 0..self.states as u32 {
            if most == 0 {
                break;
            }
            let mut queue = VecDeque::from([(root, 0)]);
            'root: while let Some((state, depth)) = queue.pop_front() {
                if depth == most {
                    break;
                }
                for &step in &leaving[state as usize] {
                    if budget == 0 {
                        return (best, false);
                    }
                    budget -= 1;
                    let to = self.steps[step as usize].1;
                    if to == root {
                        let mut cycle = vec![step as usize];
                        let mut at = state;
                        while at != root {
                            let back = reached[at as usize].1;
                            cycle.push(back as usize);
                            at = self.steps[back as usize].0;
                        }
                        cycle.reverse();
                        most = cycle.len() - 1;
                        best = Some(cycle);
                        break 'root;
                    }
                    if reached[to as usize].0 != root {
                        reached[to as usize] = (root, step);
                        queue.push_back((to, depth + 1));
                    }
                }
            }
        }
        (best, true)
    }

    fn torus(&self, columns: &[usize]) -> Torus {
        let tile = |row: usize, column: usize| self.tiles[column * self.height + row] as usize;
        let rows = (0..self.height).flat_map(|row| columns.iter().map(move |&c| tile(row, c)));
        let cells = rows.collect();
        Torus { width: columns.len(), height: self.height, cells, smallest: false }
    }
}

/// How many columns of a height are looked at: walks downward.
fn closed_walks(tiles: &[Tile], below: &[Vec<u32>], height: usize) -> u64 {
    let mut ways = vec![1u64; tiles.len()];
    for _ in 1..height {
        let from = |tile: &Tile| {
            let next = below[tile[2] as usize].iter().map(|&lower| ways[lower as usize]);
            next.fold(0, u64::saturating_add)
        };
        ways = tiles.iter().map(from).collect();
    }
    ways.into_iter().fold(0, u64::saturating_add)
}
