//! One round: colors of the classes, annealed to few corner tiles.
//!
//! A move gives a class another color. Corner tiles are counted by the cells that make them, and
//! labels by the sides that have them, so a move costs as many steps as the class has cells and
//! sides. What is made small is
//!
//! > corner tiles + penalty x conflicts beyond those allowed,
//!
//! where a pair of colors with `l` labels has `l - 1` conflicts. The temperature falls from a
//! first to a last value. Under the pair condition no conflict is allowed; else a few are, and
//! states with few tiles are examined whether the condition holds all the same.
//!
//! Source: Kirkpatrick, Gelatt and Vecchi 1983.

use super::condition::{Colored, Condition};
use super::vertices::Vertices;
use crate::search::Stop;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use std::collections::HashSet;

/// The most colors.
pub const MOST_COLORS: usize = 8;
const BITS: usize = 3;
/// Moves between two temperatures, and two looks at the limits.
const STRETCH: u64 = 1 << 10;

/// How a round is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schedule {
    /// Colors.
    pub colors: usize,
    /// Moves.
    pub moves: u64,
    /// The first and the last temperature.
    pub temperature: [f64; 2],
    /// What a conflict costs, in corner tiles.
    pub penalty: i32,
    /// Conflicts that cost nothing.
    pub allowed: i32,
}

/// The best that a round found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// Corner tiles.
    pub tiles: usize,
    /// The colors of the classes.
    pub colors: Vec<u8>,
}

/// What became of a round.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Round {
    /// The best coloring that meets the condition.
    pub found: Option<Found>,
    /// Moves made.
    pub moves: u64,
    /// States examined.
    pub examined: u64,
    /// Whether it was told to stop.
    pub cut: bool,
}

/// Where a class occurs.
#[derive(Debug, Clone, Default)]
struct Places {
    /// Cells, and what one color more adds to their key.
    cells: Vec<(u32, i32)>,
    /// Sides, likewise.
    sides: Vec<(u32, i32)>,
}

/// The tables that all rounds share.
#[derive(Debug, Clone)]
pub struct Tables {
    places: Vec<Places>,
    cells: usize,
    /// For each side its key when all colors are 0: direction and label.
    sides: Vec<i32>,
    labels: usize,
}

impl Tables {
    /// The tables of a problem.
    pub fn new(vertices: &Vertices) -> Self {
        let mut places = vec![Places::default(); vertices.patterns.len()];
        let mut add = |class: usize, is_cell: bool, place: usize, step: i32| {
            let list = &mut places[class];
            let list = if is_cell { &mut list.cells } else { &mut list.sides };
            match list.last_mut().filter(|last| last.0 as usize == place) {
                Some(last) => last.1 += step,
                None => list.push((place as u32, step)),
            }
        };
        let cells: std::collections::BTreeSet<[usize; 4]> =
            vertices.cells.iter().map(|&(classes, _)| classes).collect();
        for (cell, classes) in cells.iter().enumerate() {
            for (corner, &class) in classes.iter().enumerate() {
                add(class, true, cell, 1 << (BITS * corner));
            }
        }
        let all = vertices.sides();
        let mut names: Vec<u32> = all.iter().map(|&(_, _, label)| label).collect();
        names.sort_unstable();
        names.dedup();
        let labels = names.len();
        let mut sides = Vec::with_capacity(all.len());
        for (side, &(flat, [a, b], label)) in all.iter().enumerate() {
            // label + labels x (second + 8 x first + 64 x direction)
            let label = names.partition_point(|&name| name < label);
            sides.push((usize::from(flat) << (2 * BITS)) as i32 * labels as i32 + label as i32);
            add(a, false, side, (labels << BITS) as i32);
            add(b, false, side, labels as i32);
        }
        Self { places, cells: cells.len(), sides, labels }
    }
}

/// A coloring, and what is counted of it.
struct State<'a> {
    tables: &'a Tables,
    colors: Vec<u8>,
    cell_keys: Vec<i32>,
    side_keys: Vec<i32>,
    /// Cells by key.
    by_tile: Vec<u16>,
    /// Sides by key.
    by_label: Vec<u16>,
    /// Different labels by pair of colors.
    by_pair: Vec<u8>,
    tiles: i32,
    conflicts: i32,
}

impl<'a> State<'a> {
    fn new(tables: &'a Tables, colors: Vec<u8>) -> Self {
        let mut state = Self {
            tables,
            colors: vec![0; colors.len()],
            cell_keys: vec![0; tables.cells],
            side_keys: tables.sides.clone(),
            by_tile: vec![0; 1 << (4 * BITS)],
            by_label: vec![0; tables.labels << (2 * BITS + 1)],
            by_pair: vec![0; 1 << (2 * BITS + 1)],
            tiles: 0,
            conflicts: 0,
        };
        for cell in 0..tables.cells {
            state.put_cell(cell, 0);
        }
        for side in 0..tables.sides.len() {
            state.put_side(side, tables.sides[side]);
        }
        for (class, &color) in colors.iter().enumerate() {
            state.recolor(class, color);
        }
        state
    }

    fn put_cell(&mut self, cell: usize, key: i32) {
        self.cell_keys[cell] = key;
        let count = &mut self.by_tile[key as usize];
        self.tiles += i32::from(*count == 0);
        *count += 1;
    }

    fn take_cell(&mut self, cell: usize) -> i32 {
        let key = self.cell_keys[cell];
        let count = &mut self.by_tile[key as usize];
        *count -= 1;
        self.tiles -= i32::from(*count == 0);
        key
    }

    fn put_side(&mut self, side: usize, key: i32) {
        self.side_keys[side] = key;
        let count = &mut self.by_label[key as usize];
        *count += 1;
        if *count == 1 {
            let labels = &mut self.by_pair[key as usize / self.tables.labels];
            *labels += 1;
            self.conflicts += i32::from(*labels > 1);
        }
    }

    fn take_side(&mut self, side: usize) -> i32 {
        let key = self.side_keys[side];
        let count = &mut self.by_label[key as usize];
        *count -= 1;
        if *count == 0 {
            let labels = &mut self.by_pair[key as usize / self.tables.labels];
            *labels -= 1;
            self.conflicts -= i32::from(*labels >= 1);
        }
        key
    }

    fn recolor(&mut self, class: usize, color: u8) {
        let by = i32::from(color) - i32::from(self.colors[class]);
        self.colors[class] = color;
        let places = &self.tables.places[class];
        for &(cell, step) in &places.cells {
            let key = self.take_cell(cell as usize);
            self.put_cell(cell as usize, key + by * step);
        }
        for &(side, step) in &places.sides {
            let key = self.take_side(side as usize);
            self.put_side(side as usize, key + by * step);
        }
    }

    fn cost(&self, schedule: &Schedule) -> i32 {
        self.tiles + schedule.penalty * (self.conflicts - schedule.allowed).max(0)
    }
}

/// Runs a round, whose random numbers are those of its seed and number alone.
pub fn round(
    vertices: &Vertices,
    tables: &Tables,
    condition: Condition,
    schedule: &Schedule,
    [seed, number]: [u64; 2],
    stop: &dyn Stop,
) -> Round {
    let mut rng = Pcg64::new(u128::from(seed), u128::from(number));
    let (classes, colors) = (vertices.patterns.len(), schedule.colors.clamp(2, MOST_COLORS));
    let first = (0..classes).map(|_| below(rng.next_u64(), colors) as u8).collect();
    let mut state = State::new(tables, first);
    let mut round = Round::default();
    let mut seen = HashSet::new();
    let [hot, cold] = schedule.temperature;
    while round.moves < schedule.moves {
        if stop.should_stop() {
            round.cut = true;
            return round;
        }
        let done = round.moves as f64 / schedule.moves as f64;
        let temperature = hot * (cold / hot).powf(done);
        let accept: [u32; 64] = std::array::from_fn(|rise| {
            ((-(rise as f64) / temperature).exp() * f64::from(u32::MAX)) as u32
        });
        for _ in 0..STRETCH {
            let random = rng.next_u64();
            let class = below(random, classes);
            let other = (random >> 8) as u8 as usize % (colors - 1) + 1;
            let (old, before) = (state.colors[class], state.cost(schedule));
            state.recolor(class, ((usize::from(old) + other) % colors) as u8);
            let rise = state.cost(schedule) - before;
            if rise > 0 && accept[(rise as usize).min(63)] <= (random >> 16) as u32 {
                state.recolor(class, old);
            } else if state.conflicts <= schedule.allowed {
                examine(vertices, condition, &state, &mut seen, &mut round);
            }
        }
        round.moves += STRETCH;
    }
    round
}

/// Keeps a state that is better than the best so far and meets the condition.
fn examine(
    vertices: &Vertices,
    condition: Condition,
    state: &State<'_>,
    seen: &mut HashSet<Vec<u8>>,
    round: &mut Round,
) {
    let tiles = state.tiles as usize;
    if round.found.as_ref().is_some_and(|found| found.tiles <= tiles) {
        return;
    }
    let met = match condition {
        // Nothing more to see: there is no conflict.
        Condition::Pair => state.conflicts == 0,
        // The first states are not worth a look.
        Condition::Radius(_) if tiles > WORTH_A_LOOK => false,
        Condition::Radius(_) => {
            state.conflicts == 0
                || seen.insert(state.colors.clone()) && {
                    round.examined += 1;
                    Colored::new(vertices, &state.colors).meets(condition, &vertices.wang)
                }
        }
    };
    if met {
        round.found = Some(Found { tiles, colors: state.colors.clone() });
    }
}

/// Larger sets are not examined.
const WORTH_A_LOOK: usize = 40;

/// A number below `end` from the upper half of a random word.
fn below(random: u64, end: usize) -> usize {
    (((random >> 32) * end as u64) >> 32) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aperiodic::coloring::language::{patterns, windows};
    use crate::aperiodic::coloring::partition::{JEANDEL_RAO, Partition};

    fn problem() -> Vertices {
        let windows = windows(&Partition::jeandel_rao(), [5, 3]).unwrap();
        Vertices::new(JEANDEL_RAO.to_vec(), [4, 2], &patterns(&windows)).unwrap()
    }

    #[test]
    fn what_is_counted_move_by_move_is_what_there_is() {
        let vertices = problem();
        assert_eq!(vertices.patterns.len(), 107);
        let tables = Tables::new(&vertices);
        let mut state = State::new(&tables, vec![0; 107]);
        let mut rng = Pcg64::new(1, 2);
        for _ in 0..2000 {
            let random = rng.next_u64();
            state.recolor(below(random, 107), (random % 4) as u8);
            let colored = Colored::new(&vertices, &state.colors);
            assert_eq!(state.tiles as usize, colored.tiles.len());
            let labels: std::collections::BTreeSet<_> = vertices
                .sides()
                .into_iter()
                .map(|(flat, ends, label)| (flat, ends.map(|class| state.colors[class]), label))
                .collect();
            let pairs: HashSet<_> = labels.iter().map(|&(flat, ends, _)| (flat, ends)).collect();
            assert_eq!(state.conflicts as usize, labels.len() - pairs.len());
        }
    }
}
