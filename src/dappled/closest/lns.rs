//! Upper bounds: a strip at a time is filled anew at least cost while the rest stays (large
//! neighborhood search).
//!
//! What breaks a limit inside the strip is excluded, what breaks one across its edge costs a
//! penalty, so the search also mends fields that break the rule. Ties are broken by chance: a
//! little noise on the costs, less than one in all. The cost never rises.

use super::board::{Board, Cost, ENDLESS, NEVER, may_be};
use super::machine::Machine;
use super::strip::Strip;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::sync::Arc;

/// Noise of all cells of a strip together is below one in `1 << NOISE` units of cost.
const NOISE: u32 = 24;

/// Machines and room for their work.
pub struct Mender<'a> {
    board: &'a Board,
    /// What a broken window costs.
    penalty: Cost,
    machine: [Arc<Machine>; 2],
    ahead: Vec<Cost>,
}

impl<'a> Mender<'a> {
    /// Costs of the board must be below 2^30 in all.
    pub fn new(board: &'a Board, machine: [Arc<Machine>; 2]) -> Self {
        let worst = board.costs.chunks(board.tiles).map(|costs| {
            costs.iter().copied().filter(|&cost| may_be(cost)).max().unwrap_or(0)
        });
        let penalty = worst.sum::<Cost>() + 1;
        Self { board, penalty, machine, ahead: Vec::new() }
    }

    /// What a field costs, with penalties.
    pub fn total(&self, cells: &[u8]) -> Cost {
        let mut total = self.board.total(cells);
        for along in 0..2 {
            for set in &self.board.runs[along] {
                for line in 0..self.board.lines(along) {
                    for at in 0..self.board.length(along) {
                        let limit = set.limit(self.board.cell(along, line, at));
                        if broken(self.board, along, line, at, limit, |cell| set.set >> cells[cell] & 1 == 1) {
                            total += self.penalty;
                        }
                    }
                }
            }
        }
        total
    }

    /// Fills strips in random order, those along rows and those along columns; gives what that
    /// saves.
    pub fn sweep(&mut self, cells: &mut [u8], random: &mut Pcg64) -> Cost {
        let mut saved = 0;
        let mut strips = Vec::new();
        for along in 0..2 {
            let (lines, all) = (self.machine[along].lines, self.board.lines(along));
            let stride = lines.div_ceil(2);
            let shift = random.random_range(0..stride);
            if self.board.meet[1 - along] && lines < all {
                strips.extend((shift..all + shift).step_by(stride).map(|f| (along, f % all)));
            } else {
                strips.push((along, 0));
                strips.extend((shift..all - lines + 1).step_by(stride).map(|f| (along, f)));
                strips.push((along, all - lines));
            }
        }
        for last in (1..strips.len()).rev() {
            strips.swap(last, random.random_range(0..=last));
        }
        for (along, first) in strips {
            saved += self.fill(cells, along, first, random);
        }
        saved
    }

    /// Fills one strip.
    fn fill(&mut self, cells: &mut [u8], along: usize, first: usize, random: &mut Pcg64) -> Cost {
        let board = self.board;
        let machine = Arc::clone(&self.machine[along]);
        let strip = Strip::new(board, along, first, machine.lines);
        let (length, states, slices) = (board.length(along), machine.states(), machine.slices.len());
        let width = (1 << NOISE) / (length * machine.lines).next_power_of_two() as Cost;
        let mut table = strip.table(board, &machine, |cell, tile| {
            match board.cost(cell, tile) {
                cost if may_be(cost) => (cost << NOISE) + random.random_range(0..width),
                _ => NEVER,
            }
        });
        self.cross(&strip, &machine, cells, &mut table);
        let barred = strip.barred(board, &machine);
        let now: Vec<u32> = (0..length).map(|at| {
            let content: Vec<u8> = (0..machine.lines).map(|l| cells[strip.cell(board, l, at)]).collect();
            machine.slices.iter().position(|s| *s == content).map_or(u32::MAX, |s| s as u32)
        }).collect();
        let before = self.worth(&strip, cells);
        // Around a ring, the places where it is cut stay, and are read again at the end.
        let ring = board.meet[along];
        let longest = board.runs[along].iter().map(|set| set.longest() as usize).max().unwrap_or(0);
        let (from, again) = match ring {
            true => (random.random_range(0..length), longest.min(length)),
            false => (0, 0),
        };
        self.ahead.clear();
        self.ahead.resize((length + again) * states, NEVER);
        for step in 0..length + again {
            let at = (from + step) % length;
            let (past, next) = self.ahead.split_at_mut(step * states);
            let next = &mut next[..states];
            if step == 0 {
                machine.first.iter().for_each(|&s| next[s as usize] = 0);
            } else {
                let past = &past[(step - 1) * states..];
                for (state, next) in next.iter_mut().enumerate() {
                    let least = machine.before(state).iter().map(|&b| past[b as usize]).min();
                    *next = least.unwrap_or(NEVER);
                }
            }
            let costs = &table[at * slices..][..slices];
            let held = ring && (step < again || step >= length);
            for (state, next) in next.iter_mut().enumerate() {
                let slice = machine.slice[state];
                let out = (held && slice != now[at])
                    || barred.get(at * states + state) == Some(&true);
                *next = match out {
                    true => NEVER,
                    false if step >= length => *next,
                    false => (*next + costs[slice as usize]).min(NEVER),
                };
            }
        }
        // Back along a best path.
        let last = &self.ahead[(length + again - 1) * states..];
        let best = (0..states).min_by_key(|&state| last[state]);
        let Some(mut state) = best.filter(|&state| may_be(last[state])) else { return 0 };
        for step in (0..length + again).rev() {
            let at = (from + step) % length;
            for (line, &tile) in machine.slices[machine.slice[state] as usize].iter().enumerate() {
                cells[strip.cell(board, line, at)] = tile;
            }
            if step > 0 {
                let past = &self.ahead[(step - 1) * states..];
                let least = machine.before(state).iter().min_by_key(|&&b| past[b as usize]);
                state = least.map_or(state, |&b| b as usize);
            }
        }
        before - self.worth(&strip, cells)
    }

    /// What the cells of a strip cost, with the windows that have one of them.
    fn worth(&self, strip: &Strip, cells: &[u8]) -> Cost {
        // Simple for now.
        let _ = strip;
        self.total(cells)
    }

    /// Adds penalties for windows across the edges of a strip.
    fn cross(&self, strip: &Strip, machine: &Machine, cells: &[u8], table: &mut [Cost]) {
        let board = self.board;
        let across = 1 - strip.along;
        let all = board.lines(strip.along);
        let lines = machine.lines;
        if lines == all {
            return;
        }
        let slices = machine.slices.len();
        let penalty = self.penalty << NOISE;
        let meets = board.meet[across];
        for set in &board.runs[across] {
            let longest = set.longest() as usize;
            for at in 0..board.length(strip.along) {
                for ahead in 0..lines + longest {
                    // The window that ends `ahead` lines after the first of the strip.
                    let line = strip.lines[0] + ahead;
                    if line >= all && !meets { break; }
                    if ahead >= lines && ahead - lines >= all - lines { break; }
                    let line = line % all;
                    let limit = set.limit(board.cell(across, at, line));
                    if limit == ENDLESS { continue; }
                    let limit = limit as usize;
                    if (ahead < lines && limit <= ahead) || ahead >= lines + limit { continue; }
                    if !meets && line < limit { continue; }
                    // Cells outside, and which of the strip's.
                    let mut outside = true;
                    let mut inside = Vec::new();
                    for back in 0..=limit {
                        let other = (line + all - back % all) % all;
                        let place = (other + all - strip.lines[0]) % all;
                        if place < lines { inside.push(place); }
                        else { outside &= set.set >> cells[board.cell(across, at, other)] & 1 == 1; }
                    }
                    if !outside { continue; }
                    for (slice, cost) in machine.slices.iter().zip(&mut table[at * slices..]) {
                        if may_be(*cost) && inside.iter().all(|&l| set.set >> slice[l] & 1 == 1) {
                            *cost += penalty;
                        }
                    }
                }
            }
        }
    }
}

/// Whether the window that ends at a place of a line lies in a set.
fn broken(board: &Board, along: usize, line: usize, at: usize, limit: u32, holds: impl Fn(usize) -> bool) -> bool {
    let length = board.length(along);
    if limit == ENDLESS || (!board.meet[along] && at < limit as usize) { return false; }
    (0..=limit as usize).all(|back| holds(board.cell(along, line, (at + length - back % length) % length)))
}
