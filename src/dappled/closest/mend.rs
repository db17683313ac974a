//! Upper bounds: a strip at a time is filled anew at least cost while the rest stays (large
//! neighborhood search).
//!
//! What breaks a limit inside the strip is excluded, what breaks one across its edge costs a
//! penalty, so the search also mends fields that break the rule. Ties are broken by chance: a
//! little noise on the costs, less than one in all. Once nothing is broken the cost never rises.
//!
//! A strip whose ends meet is cut where chance says; the slices after the cut, as many as a run may
//! be long, stay, and are read again at the end.

use super::board::{Board, Cost, ENDLESS, NEVER, may_be};
use super::dual::System;
use super::machine::Machine;
use super::strip::Strip;
use crate::dappled::FREE;
use crate::search::Stop;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::sync::Arc;

/// Noise of all cells of a strip together is below one in `1 << NOISE` units of cost.
const NOISE: u32 = 18;

/// Costs of a strip stay below this power of two.
const ROOM: u32 = 57;

/// A strip to be filled: what slices cost, and which states may not be where.
#[derive(Debug)]
struct Job {
    machine: Arc<Machine>,
    strip: Strip,
    table: Vec<Cost>,
    barred: Vec<bool>,
}

/// Fills strips of a board, with room for its work.
#[derive(Debug)]
pub(super) struct Mender {
    /// Of strips along rows, and along columns.
    machines: [Arc<Machine>; 2],
    /// What a broken window costs.
    penalty: Cost,
    /// As high as penalties go.
    highest: Cost,
    messages: Vec<Cost>,
}

impl Mender {
    /// With machines along rows and along columns.
    pub(super) fn new(board: &Board, machines: [Arc<Machine>; 2]) -> Self {
        let costs = board.costs.iter().copied().filter(|&cost| may_be(cost));
        let penalty = 4 * costs.max().unwrap_or(0) + 1;
        Self { machines, penalty, highest: 64 * penalty, messages: Vec::new() }
    }

    /// Makes it dearer to break a window.
    pub(super) fn harden(&mut self) {
        self.penalty = (2 * self.penalty).min(self.highest);
    }

    /// Fills strips that overlap in random order, those along rows and those along columns.
    pub(super) fn sweep(
        &mut self,
        board: &Board,
        cells: &mut [u8],
        random: &mut Pcg64,
        stop: &dyn Stop,
    ) {
        let mut strips = Vec::new();
        for along in 0..2 {
            let (lines, all) = (self.machines[along].lines, board.lines(along));
            let stride = lines.div_ceil(2);
            let shift = random.random_range(0..stride);
            if board.meet[1 - along] && lines < all {
                strips.extend((shift..all + shift).step_by(stride).map(|line| (along, line % all)));
            } else {
                let inner = (shift..all - lines).step_by(stride).filter(|&line| line > 0);
                strips.extend(inner.map(|line| (along, line)));
                strips.push((along, 0));
                if lines < all {
                    strips.push((along, all - lines));
                }
            }
        }
        for last in (1..strips.len()).rev() {
            strips.swap(last, random.random_range(0..=last));
        }
        for (along, first) in strips {
            if stop.should_stop() {
                return;
            }
            self.fill(board, cells, (along, first), random);
        }
    }

    /// Fills a strip, if it can be filled.
    fn fill(
        &mut self,
        board: &Board,
        cells: &mut [u8],
        (along, first): (usize, usize),
        random: &mut Pcg64,
    ) {
        let machine = Arc::clone(&self.machines[along]);
        let strip = Strip::new(board, along, first, machine.lines);
        let size = board.length(along) * machine.lines;
        let worst = 4 * size as u64 * self.penalty.unsigned_abs();
        let noise = NOISE.min(ROOM.saturating_sub(worst.checked_ilog2().unwrap_or(0)));
        let width = ((1 << noise) / size as Cost).max(1);
        let mut table = strip.table(board, &machine, |cell, tile| match board.cost(cell, tile) {
            cost if may_be(cost) => (cost << noise) + random.random_range(0..width),
            _ => NEVER,
        });
        self.cross(board, &strip, &machine, cells, (&mut table, noise));
        let barred = strip.barred(board, &machine);
        self.all(board, &Job { machine, strip, table, barred }, cells, random);
    }

    /// Fills all strips of a system in turn, each at least cost by its own share, as those before
    /// are filled where they overlap. Gives the cells, and those in which this was not possible.
    pub(super) fn read(
        &mut self,
        board: &Board,
        system: &System,
        worst: Cost,
        random: &mut Pcg64,
    ) -> (Vec<u8>, Vec<usize>) {
        let mut cells = vec![FREE; board.cells()];
        let mut differ = Vec::new();
        let count = system.parts().len();
        let begin = random.random_range(0..count);
        for number in (begin..count).chain((0..begin).rev()) {
            let (strip, costs, barred) = system.parts()[number].view();
            let machine = Arc::clone(system.machine());
            let mut table = costs.to_vec();
            for (at, table) in table.chunks_mut(machine.slices.len()).enumerate() {
                for (slice, cost) in machine.slices.iter().zip(table) {
                    let lines = slice.iter().enumerate().filter(|&(line, &tile)| {
                        let cell = cells[strip.cell(board, line, at)];
                        cell != FREE && cell != tile
                    });
                    *cost = (*cost + worst * lines.count() as Cost).min(NEVER);
                }
            }
            let of_strip = (0..machine.lines)
                .flat_map(|line| (0..board.length(strip.along)).map(move |at| (line, at)))
                .map(|(line, at)| strip.cell(board, line, at));
            let before: Vec<(usize, u8)> = of_strip.map(|cell| (cell, cells[cell])).collect();
            let job = Job { machine, strip: strip.clone(), table, barred: barred.to_vec() };
            if self.all(board, &job, &mut cells, random) {
                let changed = before.iter().filter(|&&(c, tile)| tile != FREE && tile != cells[c]);
                differ.extend(changed.map(|&(cell, _)| cell));
            }
        }
        (cells, differ)
    }

    /// Fills a strip, wherever a ring is cut.
    fn all(&mut self, board: &Board, job: &Job, cells: &mut [u8], random: &mut Pcg64) -> bool {
        let along = job.strip.along;
        if !board.meet[along] {
            return self.path(board, job, cells, (0, 0));
        }
        let length = board.length(along);
        let longest = board.longest(along).min(length);
        let ring = (random.random_range(0..length), longest);
        // If what was to stay is broken, it is filled first.
        self.path(board, job, cells, ring)
            || (self.path(board, job, cells, (ring.0, 0)) && self.path(board, job, cells, ring))
    }

    /// Fills a strip along a shortest path that begins at a place, and reads again so many places
    /// that stay.
    fn path(
        &mut self,
        board: &Board,
        Job { machine, strip, table, barred }: &Job,
        cells: &mut [u8],
        (begin, again): (usize, usize),
    ) -> bool {
        let (length, states, slices) =
            (board.length(strip.along), machine.states(), machine.slices.len());
        self.messages.clear();
        self.messages.resize((length + again) * states, NEVER);
        for step in 0..length + again {
            let at = (begin + step) % length;
            let (past, now) = self.messages.split_at_mut(step * states);
            let now = &mut now[..states];
            match step {
                0 => machine.first.iter().for_each(|&state| now[state as usize] = 0),
                _ => machine.least_before(&past[(step - 1) * states..], now),
            }
            let held = (step < again || step >= length).then(|| {
                let stays = |slice: &Vec<u8>| {
                    (0..machine.lines).all(|l| slice[l] == cells[strip.cell(board, l, at)])
                };
                machine.slices.iter().position(stays)
            });
            let costs = &table[at * slices..][..slices];
            for (state, now) in now.iter_mut().enumerate() {
                let slice = machine.slice[state] as usize;
                let out = held.is_some_and(|held| held != Some(slice))
                    || barred.get(at * states + state) == Some(&true);
                *now = match out {
                    true => NEVER,
                    false if step >= length => *now,
                    false => (*now + costs[slice]).min(NEVER),
                };
            }
        }
        let last = &self.messages[(length + again - 1) * states..];
        let best = (0..states).min_by_key(|&state| last[state]);
        let Some(mut state) = best.filter(|&state| may_be(last[state])) else { return false };
        for step in (0..length + again).rev() {
            let at = (begin + step) % length;
            for (line, &tile) in machine.slices[machine.slice[state] as usize].iter().enumerate() {
                cells[strip.cell(board, line, at)] = tile;
            }
            if step > 0 {
                let past = &self.messages[(step - 1) * states..];
                let before = machine.before(state).iter().min_by_key(|&&b| past[b as usize]);
                state = before.map_or(state, |&before| before as usize);
            }
        }
        true
    }

    /// Adds penalties for windows across the edges of a strip.
    fn cross(
        &self,
        board: &Board,
        strip: &Strip,
        machine: &Machine,
        cells: &[u8],
        (table, noise): (&mut [Cost], u32),
    ) {
        let (across, all, lines) = (1 - strip.along, board.lines(strip.along), machine.lines);
        if lines == all {
            return;
        }
        let (slices, penalty) = (machine.slices.len(), self.penalty << noise);
        let meets = board.meet[across];
        let mut inside = Vec::new();
        for set in &board.runs[across] {
            // The lines in which a window that reaches the strip may end.
            let reach = (lines + set.longest() as usize).min(all);
            for (at, ahead) in
                (0..board.length(strip.along)).flat_map(|at| (0..reach).map(move |a| (at, a)))
            {
                let line = strip.lines[0] + ahead;
                if line >= all && !meets {
                    continue;
                }
                let line = line % all;
                let limit = set.limit(board.cell(across, at, line));
                if limit == ENDLESS || (!meets && line < limit as usize) {
                    continue;
                }
                inside.clear();
                let mut held = true;
                for back in 0..=limit as usize {
                    let other = (line + all - back % all) % all;
                    let place = (other + all - strip.lines[0]) % all;
                    if place < lines {
                        inside.push(place);
                    } else {
                        let tile = cells[board.cell(across, at, other)];
                        held &= set.set >> tile & 1 == 1;
                    }
                }
                if !held || inside.is_empty() || inside.len() > limit as usize {
                    continue;
                }
                for (slice, cost) in machine.slices.iter().zip(&mut table[at * slices..]) {
                    if may_be(*cost) && inside.iter().all(|&l| set.set >> slice[l] & 1 == 1) {
                        *cost += penalty;
                    }
                }
            }
        }
    }
}
