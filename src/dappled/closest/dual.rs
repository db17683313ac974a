//! Lower bounds: the board cut into strips that overlap, each filled at least cost on its own.
//!
//! The cost of a cell is divided among the strips that hold it, so the sum of their least costs is
//! at most the cost of any tiling (Lagrange). The strips are read side by side, place by place;
//! where two overlap, what each would at least have to pay for every content of the overlap (its
//! *min-marginals*) is evened out between them by moving cost from one to the other. This never
//! lowers the bound (it is sequential tree-reweighted message passing, Kolmogorov 2006, with
//! strips for trees). All numbers are integers, so the bound is exact.
//!
//! A strip whose ends meet begins with what states cost that is taken back at the end. After every
//! round these costs become those found at the end, which does not lower the bound either.

use super::board::{Board, Cost, NEVER, may_be};
use super::machine::Machine;
use super::strip::Strip;
use std::collections::HashMap;
use std::sync::Arc;

/// Strips of the same height along one direction.
#[derive(Debug, Clone)]
pub struct System {
    pub machine: Arc<Machine>,
    pub strips: Vec<Part>,
    /// The overlaps of strips, in order.
    seams: Vec<Seam>,
    length: usize,
    ring: bool,
}

/// A strip with its share of the costs.
#[derive(Debug, Clone)]
pub struct Part {
    pub strip: Strip,
    /// What slices cost, by place, then by slice.
    pub costs: Vec<Cost>,
    barred: Vec<bool>,
    /// The least cost up to a state, with its place; by place, then by state.
    pub ahead: Vec<Cost>,
    /// The least cost after a state.
    pub behind: Vec<Cost>,
    /// What states cost at the beginning of a ring, taken back at the end.
    toll: Vec<Cost>,
    /// Of the place being read: the least cost of each slice.
    least: Vec<Cost>,
}

/// Two strips that overlap, and the content of the overlap for each slice of both.
#[derive(Debug, Clone)]
struct Seam {
    north: usize,
    south: usize,
    shape: Arc<Overlap>,
}

#[derive(Debug)]
struct Overlap {
    contents: usize,
    /// By slice of the northern strip.
    tail: Vec<u32>,
    /// By slice of the southern strip.
    head: Vec<u32>,
}

fn overlap(machine: &Machine, lines: usize) -> Overlap {
    let mut numbers = HashMap::new();
    let mut number = |tiles: &[u8]| {
        let next = numbers.len() as u32;
        *numbers.entry(tiles.to_vec()).or_insert(next)
    };
    let tail = machine.slices.iter().map(|slice| number(&slice[slice.len() - lines..])).collect();
    let head = machine.slices.iter().map(|slice| number(&slice[..lines])).collect();
    Overlap { contents: numbers.len(), tail, head }
}

impl System {
    /// Strips of the machine's height, of which the next begins `stride` lines later.
    pub fn new(board: &Board, along: usize, machine: Arc<Machine>, stride: usize) -> Self {
        let (all, lines) = (board.lines(along), machine.lines);
        let ring = board.meet[1 - along] && lines < all;
        let mut firsts: Vec<usize> = match ring {
            true => (0..all).step_by(stride).collect(),
            false => (0..all - lines).step_by(stride).collect(),
        };
        if !ring {
            firsts.push(all - lines);
        }
        let mut holders = vec![0; all];
        for &first in &firsts {
            (0..lines).for_each(|line| holders[(first + line) % all] += 1);
        }
        let mut seams = Vec::new();
        let mut shapes: HashMap<usize, Arc<Overlap>> = HashMap::new();
        for north in 0..firsts.len() {
            let south = (north + 1) % firsts.len();
            if south == north || (south == 0 && !ring) {
                continue;
            }
            let apart = (firsts[south] + all - firsts[north]) % all;
            if apart < lines {
                let both = lines - apart;
                let shape = shapes.entry(both).or_insert_with(|| Arc::new(overlap(&machine, both)));
                seams.push(Seam { north, south, shape: Arc::clone(shape) });
            }
        }
        let length = board.length(along);
        let meets = board.meet[along];
        let states = machine.states();
        // The share of strips that come first is rounded up.
        let mut given = vec![0; all];
        let strips = firsts.iter().map(|&first| {
            let strip = Strip::new(board, along, first, lines);
            let share: Vec<(i64, i64)> = strip.lines.iter().map(|&line| {
                let rank = given[line];
                given[line] += 1;
                (rank, holders[line])
            }).collect();
            let place: HashMap<usize, usize> =
                strip.lines.iter().enumerate().map(|(at, &line)| (line, at)).collect();
            let costs = strip.table(board, &machine, |cell, tile| {
                let line = if along == 0 { cell / board.width } else { cell % board.width };
                let cost = board.cost(cell, tile);
                if !may_be(cost) { return NEVER; }
                let (rank, holders) = share[place[&line]];
                (cost * (rank + 1)).div_euclid(holders) - (cost * rank).div_euclid(holders)
            });
            let barred = strip.barred(board, &machine);
            Part {
                strip, costs, barred,
                ahead: vec![NEVER; length * states],
                behind: vec![0; length * states],
                toll: if meets { vec![0; states] } else { Vec::new() },
                least: vec![NEVER; machine.slices.len()],
            }
        });
        let strips = strips.collect();
        let mut system = Self { machine, strips, seams, length, ring: meets };
        system.backward(false);
        system
    }

    /// Reads all strips from their first place to their last; gives the bound.
    pub fn forward(&mut self, even: bool) -> Cost {
        let states = self.machine.states();
        for at in 0..self.length {
            for part in &mut self.strips {
                part.reach(&self.machine, at, self.ring);
                if even { part.weigh(&self.machine, at); }
            }
            if even { self.even(at); }
            for part in &mut self.strips {
                part.pay(&self.machine, at);
            }
        }
        let last = (self.length - 1) * states;
        self.strips.iter().map(|part| {
            let ends = part.ahead[last..last + states].iter();
            match self.ring {
                true => ends.zip(&part.toll).map(|(a, t)| a - t).min().unwrap_or(NEVER),
                false => ends.copied().min().unwrap_or(NEVER),
            }
        }).fold(0, |a, b| (a + b).min(NEVER))
    }

    /// The other way; it does not give the bound.
    pub fn backward(&mut self, even: bool) {
        for at in (0..self.length).rev() {
            for part in &mut self.strips {
                part.follow(&self.machine, at, self.length, self.ring);
                if even { part.weigh_back(&self.machine, at); }
            }
            if even { self.even(at); }
        }
    }

    /// New tolls for rings.
    pub fn turn(&mut self) {
        if !self.ring { return; }
        let states = self.machine.states();
        let last = (self.length - 1) * states;
        for part in &mut self.strips {
            let ends = &part.ahead[last..last + states];
            let least = ends.iter().copied().min().unwrap_or(0);
            for (toll, &end) in part.toll.iter_mut().zip(ends) {
                *toll = if may_be(end) { end - least } else { NEVER };
            }
        }
    }

    /// Evens out the min-marginals of overlaps.
    fn even(&mut self, at: usize) {
        for seam in 0..self.seams.len() { self.even_seam(seam, at); }
        for seam in (0..self.seams.len()).rev() { self.even_seam(seam, at); }
    }

    fn even_seam(&mut self, seam: usize, at: usize) {
        let Seam { north, south, shape } = &self.seams[seam];
        let slices = self.machine.slices.len();
        let mut a = vec![NEVER; shape.contents];
        let mut b = vec![NEVER; shape.contents];
        for (slice, &least) in self.strips[*north].least.iter().enumerate() {
            let u = shape.tail[slice] as usize;
            a[u] = a[u].min(least);
        }
        for (slice, &least) in self.strips[*south].least.iter().enumerate() {
            let u = shape.head[slice] as usize;
            b[u] = b[u].min(least);
        }
        let low_a = a.iter().copied().min().unwrap_or(0);
        let low_b = b.iter().copied().min().unwrap_or(0);
        // What the northern strip takes over.
        for u in 0..shape.contents {
            a[u] = match (may_be(a[u]), may_be(b[u])) {
                (true, true) => ((b[u] - low_b) - (a[u] - low_a)).div_euclid(2),
                _ => NEVER,
            };
        }
        for (part, keys, sign) in [(*north, &shape.tail, 1), (*south, &shape.head, -1)] {
            let Part { costs, least, .. } = &mut self.strips[part];
            let costs = &mut costs[at * slices..][..slices];
            for slice in 0..slices {
                let change = a[keys[slice] as usize];
                if !may_be(change) {
                    costs[slice] = NEVER;
                    least[slice] = NEVER;
                } else if may_be(costs[slice]) {
                    costs[slice] += sign * change;
                    if may_be(least[slice]) { least[slice] += sign * change; }
                }
            }
        }
    }
}

impl Part {
    /// The least cost up to each state, without that of its place.
    fn reach(&mut self, machine: &Machine, at: usize, ring: bool) {
        let states = machine.states();
        let (past, now) = self.ahead.split_at_mut(at * states);
        let now = &mut now[..states];
        if at == 0 && !ring {
            now.fill(NEVER);
            machine.first.iter().for_each(|&state| now[state as usize] = 0);
        } else {
            let past = if at == 0 { &self.toll[..] } else { &past[(at - 1) * states..] };
            for (state, now) in now.iter_mut().enumerate() {
                let before = machine.before(state).iter();
                *now = before.map(|&b| past[b as usize]).min().unwrap_or(NEVER);
            }
        }
        if !self.barred.is_empty() {
            for (now, &barred) in now.iter_mut().zip(&self.barred[at * states..]) {
                if barred { *now = NEVER; }
            }
        }
    }

    /// Adds what the place costs.
    fn pay(&mut self, machine: &Machine, at: usize) {
        let states = machine.states();
        let costs = &self.costs[at * machine.slices.len()..];
        for (now, &slice) in self.ahead[at * states..][..states].iter_mut().zip(&machine.slice) {
            *now = (*now + costs[slice as usize]).min(NEVER);
        }
    }

    /// The least cost of each slice, before the place is paid.
    fn weigh(&mut self, machine: &Machine, at: usize) {
        let (states, slices) = (machine.states(), machine.slices.len());
        self.least.fill(NEVER);
        let ahead = &self.ahead[at * states..][..states];
        let behind = &self.behind[at * states..][..states];
        for ((a, b), &slice) in ahead.iter().zip(behind).zip(&machine.slice) {
            let least = &mut self.least[slice as usize];
            *least = (*least).min(a + b);
        }
        for (least, cost) in self.least.iter_mut().zip(&self.costs[at * slices..]) {
            *least = (*least + cost).min(NEVER);
        }
    }

    /// The least cost of each slice, when its place is paid.
    fn weigh_back(&mut self, machine: &Machine, at: usize) {
        let states = machine.states();
        self.least.fill(NEVER);
        let ahead = &self.ahead[at * states..][..states];
        let behind = &self.behind[at * states..][..states];
        for ((a, b), &slice) in ahead.iter().zip(behind).zip(&machine.slice) {
            let least = &mut self.least[slice as usize];
            *least = (*least).min(a + b);
        }
    }

    /// The least cost after each state.
    fn follow(&mut self, machine: &Machine, at: usize, length: usize, ring: bool) {
        let states = machine.states();
        let (now, next) = self.behind[at * states..].split_at_mut(states);
        if at + 1 == length {
            match ring {
                true => {
                    for (now, &toll) in now.iter_mut().zip(&self.toll) {
                        *now = if may_be(toll) { -toll } else { NEVER };
                    }
                }
                false => now.fill(0),
            }
        } else {
            let costs = &self.costs[(at + 1) * machine.slices.len()..];
            let barred = self.barred.get((at + 1) * states..).unwrap_or(&[]);
            let next = &mut next[..states];
            // Their place is paid from here on; it is not read again as it was.
            let paid: Vec<Cost> = next.iter().enumerate().map(|(state, &after)| {
                if barred.get(state) == Some(&true) { return NEVER; }
                (after + costs[machine.slice[state] as usize]).min(NEVER)
            }).collect();
            for (state, now) in now.iter_mut().enumerate() {
                let after = machine.after(state).iter();
                *now = after.map(|&a| paid[a as usize]).min().unwrap_or(NEVER);
            }
        }
    }
}
