//! The search: bounds from below and from above in turns, with strips that grow, until they meet.
//!
//! A stage has strips of one height. In each round the bound from below is raised and, beside it,
//! the best tiling mended; now and then a tiling is read off the strips of the lower bound, which
//! is a good one to mend. When neither moves any more, cells in which strips disagree are decided
//! both ways (branch and bound), so many times; then strips grow. The last stage branches until
//! all is decided.
//!
//! Both halves of a round do the same work whatever the threads, so the answer is the same.

use super::board::{Board, Cost, NEVER, may_be};
use super::bounds::Bounds;
use super::machine::Machine;
use super::mend::Mender;
use crate::dappled::exact::{Completion, complete};
use crate::dappled::{FREE, Field, Rule};
use crate::search::Stop;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::sync::Arc;

/// Steps of machines at most, stage by stage.
const STEPS: [usize; 4] = [1 << 10, 1 << 13, 1 << 16, 1 << 19];
/// Decisions of a stage at most, on boards of so many cells; there is no limit in the last.
const NODES: u64 = 24;
const SMALL: usize = 2500;
/// Memory of a stage at most, in bytes.
const MEMORY: usize = 3 << 30;
/// Rounds without gain before a stage ends, and in which nothing is found.
const STALE: (u32, u32) = (6, 10);

/// What the search is about.
pub(super) struct Search<'a, S: Stop> {
    pub board: &'a Board,
    /// What tilings keep, and the cells that are fixed.
    rule: &'a Rule,
    partial: &'a Field,
    pub stop: &'a S,
    /// The best tiling, and its cost.
    pub best: Option<(Vec<u8>, Cost)>,
    /// No tiling costs less; [`NEVER`] if there is none.
    pub bound: Cost,
    /// Fixed cells that have no completion.
    pub core: Option<Vec<u32>>,
    pub rounds: u64,
    pub nodes: u64,
    /// Lines of the strips that were used last.
    pub lines: usize,
    random: Pcg64,
}

/// The tallest machines of so many steps, along rows and along columns.
pub(super) fn machines(board: &Board, most: usize) -> [Arc<Machine>; 2] {
    [0, 1].map(|along| {
        let mut tallest = Machine::new(board, along, 1, usize::MAX);
        for lines in 2..=board.lines(along) {
            match Machine::new(board, along, lines, most) {
                Some(machine) => tallest = Some(machine),
                None => break,
            }
        }
        Arc::new(tallest.unwrap_or_default())
    })
}

impl<'a, S: Stop> Search<'a, S> {
    /// A search that knows nothing yet.
    pub(super) fn new(
        board: &'a Board,
        (rule, partial): (&'a Rule, &'a Field),
        seed: u64,
        stop: &'a S,
    ) -> Self {
        let random = Pcg64::seed_from_u64(seed);
        let (best, bound, lines) = (None, 0, 0);
        Self {
            board,
            rule,
            partial,
            stop,
            best,
            bound,
            core: None,
            rounds: 0,
            nodes: 0,
            lines,
            random,
        }
    }

    /// Whether the bounds have met.
    pub(super) fn is_done(&self) -> bool {
        self.bound >= self.cost()
    }

    /// The cost of the best tiling; [`NEVER`] without one.
    fn cost(&self) -> Cost {
        self.best.as_ref().map_or(NEVER, |best| best.1)
    }

    /// Searches from these cells on, until the bounds meet or it is asked to stop; then, if there
    /// is no tiling, for the cells that are to blame.
    pub(super) fn run(&mut self, start: &[u8]) {
        self.offer(start);
        if self.is_done() {
            return;
        }
        let mut cells = start.to_vec();
        self.stages(&mut cells);
        if !may_be(self.bound) && self.core.is_none() {
            self.complete(&mut cells);
        }
    }

    /// The stages.
    fn stages(&mut self, cells: &mut Vec<u8>) {
        for (stage, &steps) in STEPS.iter().enumerate() {
            let machines = machines(self.board, steps);
            let prefer = stage % 2;
            let last = stage + 1 == STEPS.len();
            let fits = Bounds::memory(self.board, &machines, prefer) <= MEMORY;
            if stage > 0 && !fits {
                return;
            }
            self.lines = machines[prefer].lines;
            let mut mender = Mender::new(self.board, machines.clone());
            let mut bounds = fits.then(|| Bounds::new(self.board, &machines, prefer));
            self.rounds(bounds.as_mut(), &mut mender, cells);
            if self.is_done() || self.stop.should_stop() {
                return;
            }
            if self.best.is_none() && !self.is_done() {
                self.complete(cells);
            }
            if self.is_done() || self.stop.should_stop() {
                return;
            }
            let Some(bounds) = bounds else { return };
            // At a node of a large board little is gained.
            let mut left = match (last, self.board.cells() <= SMALL) {
                (true, _) => u64::MAX,
                (_, small) => {
                    if small {
                        NODES
                    } else {
                        0
                    }
                }
            };
            if self.branch(bounds, self.board.clone(), &mut mender, &mut left) {
                self.bound = self.cost();
            }
            if self.is_done() || self.stop.should_stop() {
                return;
            }
        }
    }

    fn accepts(&self, cells: &[u8]) -> bool {
        let tiling = Field::new(self.board.width, self.board.height, cells.to_vec());
        tiling.is_ok_and(|tiling| self.rule.accepts(&tiling))
    }

    /// Any tiling, or the proof that there is none.
    fn complete(&mut self, cells: &mut Vec<u8>) {
        match complete(self.rule, self.partial, self.random.random(), &self.stop) {
            Ok(Completion::Found(tiling)) => {
                self.offer(tiling.cells());
                *cells = tiling.cells().to_vec();
            }
            Ok(Completion::Impossible { core, .. }) => {
                (self.bound, self.core) = (NEVER, Some(core));
            }
            Ok(Completion::Stopped) | Err(_) => {}
        }
    }

    /// Takes cells if they keep the rule and cost less.
    fn offer(&mut self, cells: &[u8]) -> bool {
        let total = self.board.total(cells);
        let better = total < self.cost() && may_be(total) && self.accepts(cells);
        if better {
            self.best = Some((cells.to_vec(), total));
        }
        better
    }

    /// The rounds of a stage; without bounds only tilings are mended.
    fn rounds(
        &mut self,
        mut bounds: Option<&mut Bounds>,
        mender: &mut Mender,
        cells: &mut Vec<u8>,
    ) {
        let (board, stop) = (self.board, self.stop);
        let (mut stale, mut idle, mut highest) = (0, 0, -NEVER);
        let mut random = Pcg64::seed_from_u64(self.random.random());
        while (stale < STALE.0 || idle < STALE.1) && !stop.should_stop() {
            let raise = bounds.as_deref_mut().filter(|_| stale < STALE.0);
            let (bound, ()) = rayon::join(
                || raise.map(|bounds| bounds.round(board, stop)),
                || mender.sweep(board, cells, &mut random, stop),
            );
            self.rounds += 1;
            match (bound, &bounds) {
                (Some(None), _) => return,
                (Some(Some(bound)), Some(bounds)) => {
                    stale = if bound - highest < bounds.unit / 200 { stale + 1 } else { 0 };
                    highest = highest.max(bound);
                    self.bound = self.bound.max(bounds.rounded(bound));
                }
                _ => stale += 1,
            }
            idle = if self.offer(cells) { 0 } else { idle + 1 };
            if self.is_done() {
                return;
            }
            if idle % 5 != 4 {
                continue;
            }
            if self.best.is_none() {
                mender.harden();
            }
            let Some(bounds) = &bounds else { continue };
            let worst = self.worst(bounds.unit);
            let (mut read, _) = mender.read(board, &bounds.systems[0], worst, &mut random);
            for _ in 0..if read.contains(&FREE) { 0 } else { 2 } {
                mender.sweep(board, &mut read, &mut random, stop);
                if self.offer(&read) {
                    (*cells, idle) = (read.clone(), 0);
                }
            }
            if self.is_done() {
                return;
            }
        }
    }

    /// More than any cell can cost, multiplied.
    fn worst(&self, unit: Cost) -> Cost {
        let most = self.board.costs.iter().copied().filter(|&cost| may_be(cost)).max();
        (4 * most.unwrap_or(0) + 1).saturating_mul(unit)
    }

    /// Decides cells both ways; whether all was decided in the number of nodes left.
    fn branch(
        &mut self,
        mut bounds: Bounds,
        board: Board,
        mender: &mut Mender,
        left: &mut u64,
    ) -> bool {
        let (mut stale, mut highest) = (0, -NEVER);
        while stale < 2 {
            if self.stop.should_stop() {
                return false;
            }
            let Some(bound) = bounds.round(&board, self.stop) else { return false };
            self.rounds += 1;
            if bounds.rounded(bound) >= self.cost() {
                return true;
            }
            stale = if bound - highest < bounds.unit / 100 { stale + 1 } else { 0 };
            highest = highest.max(bound);
        }
        let mut random = Pcg64::seed_from_u64(self.random.random());
        let worst = self.worst(bounds.unit);
        let (read, differ) = mender.read(&board, &bounds.systems[0], worst, &mut random);
        let mut mended = read.clone();
        if !mended.contains(&FREE) {
            self.offer(&mended);
            for _ in 0..2 {
                mender.sweep(&board, &mut mended, &mut random, self.stop);
                self.offer(&mended);
            }
        }
        if bounds.rounded(highest) >= self.cost() {
            return true;
        }
        let open = |cell: &usize| board.is_open(*cell);
        let cell = differ.into_iter().find(open).or_else(|| (0..board.cells()).find(open));
        // With nothing open the bound is the cost, or the cells break the rule.
        let Some(cell) = cell else { return true };
        if *left == 0 {
            return false;
        }
        *left -= 1;
        self.nodes += 1;
        let may = |tile: usize| may_be(board.cost(cell, tile));
        let Some(first) = (0..board.tiles)
            .find(|&tile| may(tile) && usize::from(read[cell]) == tile)
            .or_else(|| (0..board.tiles).find(|&tile| may(tile)))
        else {
            return true;
        };
        [true, false].into_iter().all(|with| {
            let out = |tile: usize| (tile == first) != with;
            let (mut bounds, mut board) = (bounds.clone(), board.clone());
            bounds.bar(&board, cell, out);
            for tile in (0..board.tiles).filter(|&tile| out(tile)) {
                board.costs[cell * board.tiles + tile] = NEVER;
            }
            self.branch(bounds, board, mender, left)
        })
    }
}
