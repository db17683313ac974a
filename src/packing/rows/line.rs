//! Lines of the torus as states: which there are, which may follow which, which are alike.
//!
//! Lines run along the short side of the torus, or as the visiting order says. With an
//! automorphism that moves lines along themselves only the lines it keeps are states.
//!
//! Two states are of one class when a rotation of the lines and a permutation of the colors that
//! keeps the set turn one into the other: the same done to all lines turns packings into
//! packings.
//!
//! The *kind* of a state is how often each domino occurs along it. Every packing of a set has
//! the same number of each domino along its lines, so kinds must add up.

use super::law::{Law, Mask};
use crate::packing::Task;
use crate::symmetry::ColorMap;
use crate::tiles::{Kind, TileSet};
use crate::torus::Order;
use std::collections::HashMap;

/// The number of a state.
pub type State = u16;

/// How often each domino occurs, as bytes of one number, so that it adds up: no set of at most
/// 128 tiles has one side more often. Colors beyond the fourth are not counted.
pub type Dominoes = u128;

/// What is between two lines.
#[derive(Debug, Clone, Copy, Default)]
pub struct Between {
    /// The tiles.
    pub mask: Mask,
    /// Their key.
    pub key: u64,
}

/// How lines lie on the torus.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// Lines are columns.
    pub transposed: bool,
    /// Cells of a line.
    pub length: usize,
    /// How many lines there are.
    pub lines: usize,
}

impl Frame {
    /// Of a task: as its order says, else along the short side; rows of a square.
    pub fn of(task: &Task) -> Self {
        let (w, h) = (task.shape.width(), task.shape.height());
        let along_columns = task
            .automorphism
            .as_ref()
            .map_or(h < w, |automorphism| automorphism.dx == 0 && automorphism.dy != 0);
        let transposed = match task.order {
            Some(Order::Column) => true,
            Some(Order::Row) => false,
            _ => along_columns,
        };
        let (length, lines) = if transposed { (h, w) } else { (w, h) };
        Self { transposed, length, lines }
    }
}

/// A class of states.
#[derive(Debug, Clone, Copy)]
pub struct Class {
    /// One of them.
    pub first: State,
    /// How many there are.
    pub size: u64,
}

/// The states of a task that has been checked.
#[derive(Debug, Clone)]
pub struct Lines {
    /// How lines lie.
    pub frame: Frame,
    /// What the set demands.
    pub law: Law,
    /// By state: the states that may follow, with the tiles between.
    pub after: Vec<Vec<(State, Between)>>,
    /// What is between two states, no tiles if they cannot follow each other.
    between: Vec<Between>,
    /// The classes, in the order in which they are done.
    pub classes: Vec<Class>,
    /// By state: the place of its class in that order.
    pub class: Vec<u8>,
    /// By state: its kind.
    pub kind: Vec<u16>,
    /// By kind: how often each domino occurs.
    pub kinds: Vec<Dominoes>,
    /// How often each domino occurs along the lines of a packing.
    pub target: Dominoes,
}

impl Lines {
    /// The lines of a task.
    pub fn new(task: &Task) -> Self {
        let frame = Frame::of(task);
        let law = Law::new(&task.set);
        let states = states(task, frame);
        let n = states.len();
        let mut lines = Self {
            frame,
            after: vec![Vec::new(); n],
            between: vec![Between::default(); n * n],
            classes: Vec::new(),
            class: vec![0; n],
            kind: Vec::new(),
            kinds: Vec::new(),
            target: target(&task.set, frame),
            law,
        };
        for (a, first) in states.iter().enumerate() {
            for (b, second) in states.iter().enumerate() {
                if let Some(mask) = lines.tiles(&task.set, first, second) {
                    let between = Between { mask, key: lines.law.key(mask) };
                    lines.after[a].push((b as State, between));
                    lines.between[a * n + b] = between;
                }
            }
        }
        for state in &states {
            let count = dominoes(state);
            let known = lines.kinds.iter().position(|&other| other == count);
            let kind = known.unwrap_or_else(|| {
                lines.kinds.push(count);
                lines.kinds.len() - 1
            });
            lines.kind.push(kind as u16);
        }
        lines.sort_into_classes(task, &states);
        lines
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        self.class.len()
    }

    /// What is between two states, if the second may follow the first.
    #[inline(always)]
    pub fn between(&self, first: State, second: State) -> Option<Between> {
        let between = self.between[usize::from(first) * self.states() + usize::from(second)];
        (between.mask != 0).then_some(between)
    }

    /// The dominoes along a state.
    #[inline(always)]
    pub fn dominoes(&self, state: State) -> Dominoes {
        self.kinds[usize::from(self.kind[usize::from(state)])]
    }

    fn tiles(&self, set: &TileSet, first: &[u8], second: &[u8]) -> Option<Mask> {
        let length = first.len();
        (0..length).try_fold(0, |mask, at| {
            let next = (at + 1) % length;
            let (ne, se, sw, nw) = match self.frame.transposed {
                false => (first[next], second[next], second[at], first[at]),
                true => (second[at], second[next], first[next], first[at]),
            };
            let tile = Kind::Corner.pack(&[ne, se, sw, nw], set.colors()).ok()?;
            self.law.join(mask, self.law.tile(tile)?)
        })
    }

    /// Large classes first: what is done is left out of all that follows.
    fn sort_into_classes(&mut self, task: &Task, states: &[Vec<u8>]) {
        let number: HashMap<&[u8], usize> =
            states.iter().enumerate().map(|(number, state)| (&state[..], number)).collect();
        let maps = color_maps(task);
        let mut orbit_of = vec![usize::MAX; states.len()];
        let mut orbits: Vec<Vec<usize>> = Vec::new();
        for (start, state) in states.iter().enumerate() {
            if orbit_of[start] != usize::MAX {
                continue;
            }
            let mut orbit = Vec::new();
            for map in &maps {
                for shift in 0..state.len() {
                    let cell = |at: usize| map[usize::from(state[(at + shift) % state.len()])];
                    let image: Vec<u8> = (0..state.len()).map(cell).collect();
                    if let Some(&image) = number.get(&image[..])
                        && orbit_of[image] == usize::MAX
                    {
                        orbit_of[image] = orbits.len();
                        orbit.push(image);
                    }
                }
            }
            orbits.push(orbit);
        }
        let followers = |orbit: &[usize]| self.after[orbit[0]].len();
        orbits.sort_by_key(|orbit| std::cmp::Reverse((orbit.len(), followers(orbit))));
        for (place, orbit) in orbits.iter().enumerate() {
            self.classes.push(Class { first: orbit[0] as State, size: orbit.len() as u64 });
            for &state in orbit {
                self.class[state] = place as u8;
            }
        }
    }
}

/// All lines that an automorphism keeps, all lines without one, smallest first.
fn states(task: &Task, frame: Frame) -> Vec<Vec<u8>> {
    let colors = task.set.colors().horizontal();
    let mut states = Vec::new();
    let (step, map): (usize, Option<&ColorMap>) = match &task.automorphism {
        None => (0, None),
        Some(automorphism) => {
            let along = if frame.transposed { automorphism.dy } else { automorphism.dx };
            (along as usize, Some(&automorphism.map))
        }
    };
    let mut state = vec![0u8; frame.length];
    fill(&mut state, 0, colors as u8, step, map, &mut states);
    states
}

/// Fills the cells of a line from `at` on; a cell that the automorphism decides is not chosen.
fn fill(
    state: &mut Vec<u8>,
    at: usize,
    colors: u8,
    step: usize,
    map: Option<&ColorMap>,
    states: &mut Vec<Vec<u8>>,
) {
    let length = state.len();
    if at == length {
        let kept = map.is_none_or(|map| {
            let map = map.horizontal();
            (0..length).all(|at| state[(at + step) % length] == map[usize::from(state[at])])
        });
        if kept {
            states.push(state.clone());
        }
        return;
    }
    let decided = map.filter(|_| step > 0 && at >= step);
    for color in 0..colors {
        if decided.is_some_and(|map| color != map.horizontal()[usize::from(state[at - step])]) {
            continue;
        }
        state[at] = color;
        fill(state, at + 1, colors, step, map, states);
    }
}

/// The permutations of the colors that keep the set, and commute with the automorphism.
fn color_maps(task: &Task) -> Vec<Vec<u8>> {
    let colors = task.set.colors();
    let count = colors.horizontal();
    let mut maps = vec![Vec::new()];
    for _ in 0..count {
        let longer = |map: Vec<u8>| {
            let missing = (0..count as u8).filter(|color| !map.contains(color));
            missing.map(|color| [&map[..], &[color]].concat()).collect::<Vec<_>>()
        };
        maps = maps.into_iter().flat_map(longer).collect();
    }
    let keeps = |map: &Vec<u8>| {
        let set = task.set.allowed().all(|tile| {
            let sides = Kind::Corner.unpack(tile, colors).map(|color| map[usize::from(color)]);
            Kind::Corner.pack(&sides, colors).is_ok_and(|image| task.set.allows(image))
        });
        let commutes = task.automorphism.as_ref().is_none_or(|automorphism| {
            let other = automorphism.map.horizontal();
            (0..count).all(|c| map[usize::from(other[c])] == other[usize::from(map[c])])
        });
        set && commutes
    };
    maps.retain(keeps);
    maps
}

fn domino(first: u8, second: u8) -> Dominoes {
    if first < 4 && second < 4 { 1 << (8 * (4 * first + second)) } else { 0 }
}

fn dominoes(state: &[u8]) -> Dominoes {
    let next = |at: usize| state[(at + 1) % state.len()];
    state.iter().enumerate().map(|(at, &color)| domino(color, next(at))).sum()
}

/// Every domino along the lines is a side of one tile: the south of a row, the east of a column.
fn target(set: &TileSet, frame: Frame) -> Dominoes {
    let colors = set.colors();
    let side = |tile| {
        let [ne, se, sw, _] = Kind::Corner.unpack(tile, colors);
        if frame.transposed { domino(ne, se) } else { domino(sw, se) }
    };
    if !set.is_compact() {
        return set.allowed().map(side).sum();
    }
    // Two tiles of each class, which shares (NW, SW, SE); and as many of the other dominoes.
    let count = colors.horizontal() as u8;
    let pairs = (0..count).flat_map(|a| (0..count).map(move |b| domino(a, b)));
    2 * Dominoes::from(count) * pairs.sum::<Dominoes>()
}
