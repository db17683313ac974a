//! Lower bounds: the board cut into strips that overlap, each filled at least cost on its own.
//!
//! The cost of a cell is divided among the strips that hold it, so the sum of their least costs is
//! at most the cost of any tiling (Lagrange). The strips are read side by side, place by place;
//! where two overlap, what each would at least have to pay for every content of the overlap (its
//! *min-marginals*) is evened out between them by moving cost from one to the other. This never
//! lowers the bound: it is sequential tree-reweighted message passing (Kolmogorov, 2006) with
//! strips for trees. All numbers are integers, so the bound is exact.
//!
//! A strip whose ends meet is cut at two places. At a cut, states have a *toll*: one half begins
//! with it, the other takes it back at its end; tolls are evened out as costs are. This cannot be
//! done at the cut where reading begins, so every other round begins at the other cut.
//!
//! Invariant: a part's message at a place is the least cost after each state if the last reading
//! went backward, and up to it, the place included, if it went forward.

use super::board::{Board, Cost, NEVER, may_be};
use super::machine::Machine;
use super::overlap::{Overlap, firsts};
use super::strip::Strip;
use crate::search::Stop;
use std::collections::HashMap;
use std::sync::Arc;

/// Strips of the same height along one direction.
#[derive(Debug, Clone)]
pub(super) struct System {
    machine: Arc<Machine>,
    parts: Vec<Part>,
    /// The overlaps of strips, in order.
    seams: Vec<Seam>,
    /// For each line a strip that has it.
    keeper: Vec<usize>,
    length: usize,
    /// Where rings are cut.
    cuts: Option<[usize; 2]>,
    /// The cut where reading begins.
    phase: usize,
}

/// A strip with its share of the costs.
#[derive(Debug, Clone)]
pub(super) struct Part {
    strip: Strip,
    /// What slices cost, by place, then by slice.
    costs: Vec<Cost>,
    barred: Vec<bool>,
    /// By place, then by state.
    messages: Vec<Cost>,
    /// What states cost after a cut, taken back before it.
    tolls: [Vec<Cost>; 2],
    /// The message of the place being read; forward, before the place is paid.
    now: Vec<Cost>,
    /// Of the place being read: the least cost of the whole strip for each slice.
    least: Vec<Cost>,
}

/// Two strips that overlap.
#[derive(Debug, Clone)]
struct Seam {
    first: usize,
    second: usize,
    overlap: Arc<Overlap>,
}

/// What comes before a place.
#[derive(Debug, Clone, Copy)]
enum Past {
    Nothing,
    Toll(usize),
    Place(usize),
}

/// Costs by cell, then by tile, on their way from one system to another; none is negative.
pub(super) type Pool = Vec<Cost>;

impl System {
    /// Strips of the machine's height, of which the next begins `stride` lines later; `cost` says
    /// what is divided among them, by cell and tile.
    pub(super) fn new(
        board: &Board,
        along: usize,
        machine: Arc<Machine>,
        stride: usize,
        cost: impl Fn(usize, usize) -> Cost,
    ) -> Self {
        let (all, lines, length) = (board.lines(along), machine.lines, board.length(along));
        let firsts = firsts(board, along, lines, stride);
        let mut holders = vec![0; all];
        let mut keeper = vec![usize::MAX; all];
        for (part, &first) in firsts.iter().enumerate() {
            for line in 0..lines {
                holders[(first + line) % all] += 1;
                keeper[(first + line) % all] = part;
            }
        }
        let mut overlaps: HashMap<usize, Arc<Overlap>> = HashMap::new();
        let mut seams = Vec::new();
        for first in 0..firsts.len() {
            let second = (first + 1) % firsts.len();
            let apart = (firsts[second] + all - firsts[first]) % all;
            let round = second == 0 && !(board.meet[1 - along] && lines < all);
            if first == second || round || apart >= lines {
                continue;
            }
            let both = lines - apart;
            let overlap = overlaps.entry(both);
            let overlap = overlap.or_insert_with(|| Arc::new(Overlap::new(&machine, both)));
            seams.push(Seam { first, second, overlap: Arc::clone(overlap) });
        }
        let cuts = board.meet[along].then_some([0, length / 2]);
        let mut ranks = vec![0; all];
        let parts = firsts.iter().map(|&first| {
            let strip = Strip::new(board, along, first, lines);
            let costs = strip.table(board, &machine, |cell, tile| {
                let line = board.line(along, cell);
                // All shares make the whole.
                let part = |rank: Cost| (cost(cell, tile) * rank).div_euclid(holders[line]);
                match may_be(board.cost(cell, tile)) {
                    true => part(ranks[line] + 1) - part(ranks[line]),
                    false => NEVER,
                }
            });
            strip.lines.iter().for_each(|&line| ranks[line] += 1);
            let tolls = if cuts.is_some() { machine.states() } else { 0 };
            Part {
                barred: strip.barred(board, &machine),
                strip,
                costs,
                messages: vec![0; length * machine.states()],
                tolls: [vec![0; tolls], vec![0; tolls]],
                now: vec![0; machine.states()],
                least: vec![NEVER; machine.slices.len()],
            }
        });
        let parts = parts.collect();
        let mut system = Self { machine, parts, seams, keeper, length, cuts, phase: 0 };
        system.backward(false);
        system
    }

    /// The machine of all strips.
    pub(super) fn machine(&self) -> &Arc<Machine> {
        &self.machine
    }

    /// The strips, in order.
    pub(super) fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// Keeps tiles that are told out of a cell.
    pub(super) fn bar(&mut self, board: &Board, cell: usize, out: impl Fn(usize) -> bool) {
        let slices = self.machine.slices.len();
        for part in &mut self.parts {
            let line = board.line(part.strip.along, cell);
            let Some(line) = part.strip.lines.iter().position(|&of_all| of_all == line) else {
                continue;
            };
            let at = board.line(1 - part.strip.along, cell);
            let costs = &mut part.costs[at * slices..];
            for (cost, slice) in costs.iter_mut().zip(&self.machine.slices) {
                if out(usize::from(slice[line])) {
                    *cost = NEVER;
                }
            }
        }
        self.backward(false);
    }

    /// The place that is read so manieth.
    fn place(&self, step: usize) -> usize {
        let begin = self.cuts.map_or(0, |cuts| cuts[self.phase]);
        (begin + step) % self.length
    }

    /// The number of the cut before a step that is not the first.
    fn cut(&self, step: usize) -> Option<usize> {
        let other = 1 - self.phase;
        self.cuts.filter(|cuts| step > 0 && cuts[other] == self.place(step)).map(|_| other)
    }

    /// Reads all strips forward, evening out; gives the bound, or nothing if it was
    /// stopped: then what is known is no longer sound. Takes what is in the pool, and puts
    /// half of what tiles cost more than others in.
    pub(super) fn forward(
        &mut self,
        board: &Board,
        mut pool: Option<&mut Pool>,
        stop: &dyn Stop,
    ) -> Option<Cost> {
        let mut bound = 0;
        for step in 0..self.length {
            if stop.should_stop() {
                return None;
            }
            let at = self.place(step);
            let last = (at + self.length - 1) % self.length;
            let past = match (self.cut(step), step, self.cuts) {
                (Some(cut), ..) => Past::Toll(cut),
                (None, 0, None) => Past::Nothing,
                (None, 0, Some(_)) => Past::Toll(self.phase),
                _ => Past::Place(last),
            };
            for part in &mut self.parts {
                if let (Past::Toll(cut), true) = (past, step > 0) {
                    part.cross(&self.machine, last, at, cut);
                    bound = (bound + part.least_before(&self.machine, last, cut)).min(NEVER);
                }
                part.reach(&self.machine, at, past);
            }
            if let Some(pool) = pool.as_deref_mut() {
                self.take(board, at, pool);
            }
            for part in &mut self.parts {
                part.weigh(&self.machine, at);
            }
            self.even(at);
            if let Some(pool) = pool.as_deref_mut() {
                self.give(board, at, pool);
            }
            for part in &mut self.parts {
                part.pay(&self.machine, at);
            }
        }
        let last = self.place(self.length - 1);
        let ends = self.parts.iter().map(|part| match self.cuts {
            Some(_) => part.least_before(&self.machine, last, self.phase),
            None => part.message(&self.machine, last).iter().copied().min().unwrap_or(NEVER),
        });
        Some(ends.fold(bound, |a, b| (a + b).min(NEVER)))
    }

    /// Reads all strips backward, evening out if asked to. The next round begins at the other cut.
    pub(super) fn backward(&mut self, even: bool) {
        for step in (0..self.length).rev() {
            let (at, next) = (self.place(step), self.place(step + 1));
            let cut = self.cut(step + 1);
            let end = if step + 1 == self.length { self.cuts.map(|_| self.phase) } else { cut };
            for part in &mut self.parts {
                if let (Some(cut), true) = (cut, even) {
                    part.cross(&self.machine, at, next, cut);
                }
                match end.is_some() || step + 1 == self.length {
                    true => part.end(end),
                    false => part.follow(&self.machine, next),
                }
                if even {
                    part.weigh_paid(&self.machine, at);
                }
            }
            if even {
                self.even(at);
            }
            for part in &mut self.parts {
                part.keep(&self.machine, at);
            }
        }
        if even {
            self.phase = 1 - self.phase;
        }
    }

    /// Evens out the min-marginals of overlaps, there and back again.
    fn even(&mut self, at: usize) {
        for seam in 0..self.seams.len() {
            self.even_seam(seam, at);
        }
        for seam in (0..self.seams.len()).rev() {
            self.even_seam(seam, at);
        }
    }

    fn even_seam(&mut self, seam: usize, at: usize) {
        let Seam { first, second, overlap } = &self.seams[seam];
        let of = |part: usize, keys: &[u32]| {
            let mut least = vec![NEVER; overlap.contents];
            for (&key, &cost) in keys.iter().zip(&self.parts[part].least) {
                least[key as usize] = least[key as usize].min(cost);
            }
            let lowest = least.iter().copied().min().unwrap_or(0);
            (least, lowest)
        };
        let (a, low_a) = of(*first, &overlap.tail);
        let (b, low_b) = of(*second, &overlap.head);
        // What the first strip takes over.
        let change = a.iter().zip(&b).map(|(&a, &b)| match may_be(a) && may_be(b) {
            true => ((b - low_b) - (a - low_a)).div_euclid(2),
            false => NEVER,
        });
        let change: Vec<Cost> = change.collect();
        for (part, keys, sign) in [(*first, &overlap.tail, 1), (*second, &overlap.head, -1)] {
            let part = &mut self.parts[part];
            let costs = &mut part.costs[at * keys.len()..];
            for ((&key, cost), least) in keys.iter().zip(costs).zip(&mut part.least) {
                match change[key as usize] {
                    change if !may_be(change) => (*cost, *least) = (NEVER, NEVER),
                    change if may_be(*cost) => {
                        *cost += sign * change;
                        *least = if may_be(*least) { *least + sign * change } else { NEVER };
                    }
                    _ => {}
                }
            }
        }
    }

    /// Takes the costs of cells of a place from the pool.
    fn take(&mut self, board: &Board, at: usize, pool: &mut Pool) {
        let tiles = board.tiles;
        for (number, part) in self.parts.iter_mut().enumerate() {
            for (line, &of_all) in part.strip.lines.iter().enumerate() {
                if self.keeper[of_all] != number {
                    continue;
                }
                let cell = board.cell(part.strip.along, of_all, at);
                let extra = &mut pool[cell * tiles..][..tiles];
                if extra.iter().all(|&cost| cost == 0) {
                    continue;
                }
                let costs = &mut part.costs[at * self.machine.slices.len()..];
                for (cost, slice) in costs.iter_mut().zip(&self.machine.slices) {
                    *cost = (*cost + extra[usize::from(slice[line])]).min(NEVER);
                }
                extra.fill(0);
            }
        }
    }

    /// Puts half of what tiles cost more than the cheapest of a cell in the pool.
    fn give(&mut self, board: &Board, at: usize, pool: &mut Pool) {
        let tiles = board.tiles;
        let mut of_tile = vec![NEVER; tiles];
        for part in &mut self.parts {
            for (line, &of_all) in part.strip.lines.iter().enumerate() {
                of_tile.fill(NEVER);
                for (slice, &least) in self.machine.slices.iter().zip(&part.least) {
                    let of_tile = &mut of_tile[usize::from(slice[line])];
                    *of_tile = (*of_tile).min(least);
                }
                let lowest = of_tile.iter().copied().min().unwrap_or(0);
                let cell = board.cell(part.strip.along, of_all, at);
                for (of_tile, pool) in of_tile.iter_mut().zip(&mut pool[cell * tiles..]) {
                    *of_tile = if may_be(*of_tile) { (*of_tile - lowest) / 2 } else { 0 };
                    *pool += *of_tile;
                }
                let costs = &mut part.costs[at * self.machine.slices.len()..];
                let slices = self.machine.slices.iter().zip(costs).zip(&mut part.least);
                for ((slice, cost), least) in slices {
                    let given = of_tile[usize::from(slice[line])];
                    if may_be(*cost) {
                        *cost -= given;
                    }
                    if may_be(*least) {
                        *least -= given;
                    }
                }
            }
        }
    }
}

impl Part {
    /// The strip, what its slices cost now, and the states that are barred.
    pub(super) fn view(&self) -> (&Strip, &[Cost], &[bool]) {
        (&self.strip, &self.costs, &self.barred)
    }

    /// The message of a place.
    fn message(&self, machine: &Machine, at: usize) -> &[Cost] {
        &self.messages[at * machine.states()..][..machine.states()]
    }

    /// Evens out the toll of a cut: before it the message is that of a reading forward, after it
    /// that of one backward.
    fn cross(&mut self, machine: &Machine, last: usize, at: usize, cut: usize) {
        let mut rest = std::mem::take(&mut self.now);
        self.from(machine, at, &mut rest);
        let before = &self.messages[last * machine.states()..];
        for ((toll, &a), &b) in self.tolls[cut].iter_mut().zip(before).zip(&rest) {
            *toll = if may_be(a) && may_be(b) { (a - b).div_euclid(2) } else { NEVER };
        }
        self.now = rest;
    }

    /// The least cost of the half that ends at a cut.
    fn least_before(&self, machine: &Machine, last: usize, cut: usize) -> Cost {
        let costs = self.message(machine, last).iter().zip(&self.tolls[cut]);
        let left = costs.filter(|&(&a, &t)| may_be(a) && may_be(t)).map(|(a, t)| a - t);
        left.min().unwrap_or(NEVER)
    }

    /// The least cost up to each state, without that of its place.
    fn reach(&mut self, machine: &Machine, at: usize, past: Past) {
        let mut now = std::mem::take(&mut self.now);
        match past {
            Past::Nothing => {
                now.fill(NEVER);
                machine.first.iter().for_each(|&state| now[state as usize] = 0);
            }
            Past::Toll(cut) => machine.least_before(&self.tolls[cut], &mut now),
            Past::Place(last) => machine.least_before(self.message(machine, last), &mut now),
        }
        if !self.barred.is_empty() {
            for (now, &barred) in now.iter_mut().zip(&self.barred[at * machine.states()..]) {
                *now = if barred { NEVER } else { *now };
            }
        }
        self.now = now;
    }

    /// The least cost after each state.
    fn follow(&mut self, machine: &Machine, next: usize) {
        let mut now = std::mem::take(&mut self.now);
        self.from(machine, next, &mut now);
        self.now = now;
    }

    /// The least cost after each state before a cut, or before the end.
    fn end(&mut self, cut: Option<usize>) {
        let Some(cut) = cut else { return self.now.fill(0) };
        for (now, &toll) in self.now.iter_mut().zip(&self.tolls[cut]) {
            *now = if may_be(toll) { -toll } else { NEVER };
        }
    }

    /// The least cost from a place on, by the state before it.
    fn from(&self, machine: &Machine, at: usize, least: &mut [Cost]) {
        let costs = &self.costs[at * machine.slices.len()..];
        let barred = self.barred.get(at * machine.states()..).unwrap_or(&[]);
        let paid = self.message(machine, at).iter().zip(&machine.slice).enumerate();
        let paid = paid.map(|(state, (&after, &slice))| match barred.get(state) {
            Some(true) => NEVER,
            _ => (after + costs[slice as usize]).min(NEVER),
        });
        machine.least_after(&paid.collect::<Vec<_>>(), least);
    }

    /// The least cost of each slice, the place not being paid yet.
    fn weigh(&mut self, machine: &Machine, at: usize) {
        self.weigh_paid(machine, at);
        let costs = &self.costs[at * machine.slices.len()..];
        for (least, cost) in self.least.iter_mut().zip(costs) {
            *least = (*least + cost).min(NEVER);
        }
    }

    /// The least cost of each slice, the place being paid.
    fn weigh_paid(&mut self, machine: &Machine, at: usize) {
        self.least.fill(NEVER);
        let other = &self.messages[at * machine.states()..];
        for ((now, other), &slice) in self.now.iter().zip(other).zip(&machine.slice) {
            let least = &mut self.least[slice as usize];
            *least = (*least).min(now + other);
        }
    }

    /// Pays a place, and keeps the message.
    fn pay(&mut self, machine: &Machine, at: usize) {
        let costs = &self.costs[at * machine.slices.len()..];
        for (now, &slice) in self.now.iter_mut().zip(&machine.slice) {
            *now = (*now + costs[slice as usize]).min(NEVER);
        }
        self.keep(machine, at);
    }

    /// Keeps the message.
    fn keep(&mut self, machine: &Machine, at: usize) {
        self.messages[at * machine.states()..][..machine.states()].copy_from_slice(&self.now);
    }
}
