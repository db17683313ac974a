//! Wang packings: whole tiles in cells.
//!
//! The candidates of a cell are the tiles the law of the set leaves open ([`WangRule`]), AND
//! those that match each neighbor already placed, AND those that may ever stand in this cell
//! ([`WangPlan`]). Tiles are numbered densely in the order of the set, so that a set of `n`
//! tiles takes `n/64` words, whatever its colors. A placed tile writes down what it asks of its
//! neighbors, so that the candidates are an AND of words read straight from them.
//!
//! All that a level reads and writes is one slot, for one word of tiles one cache line.
//!
//! Invariant: the slots hold the tiles at all levels pushed (a step only reads neighbors at
//! earlier levels); `rule` holds exactly these tiles.

use super::reduction::Reduction;
use super::table::Table;
use super::wang_herd::Herd;
use super::wang_plan::{NEIGHBORS, WangPlan};
use super::wang_rule::WangRule;
use super::wang_sprint::Track;
use super::{Labeled, Task, TaskError};
use crate::search::{Alternatives, Bounds, Problem, Sprint, Stretch, Visited, Words};
use crate::torus::Cell;

/// Which labels of a cell to give: dominoes have but one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// North and west.
    Both,
    /// North: a ring of dominoes down a column.
    North,
    /// West: a ring of dominoes along a row.
    West,
}

/// What the search keeps for a cell.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct Slot<const N: usize> {
    /// What its tile asks of the neighbors N, E, S, W; the dummy asks nothing.
    pub(super) asked: [Words<N>; 4],
    /// The tiles that may ever stand there.
    ever: Words<N>,
    /// The slots of the neighbors placed before, or of the dummy.
    neighbors: [u32; 4],
    /// Its tile.
    tile: u32,
}

/// The search for Wang packings under a rule, for at most `64 * N` tiles, fewer than `L` cells
/// and at most `L` tiles; `QUOTIENT` with a prescribed automorphism.
#[derive(Debug, Clone)]
pub struct Wang<const N: usize, const L: usize, R, const QUOTIENT: bool> {
    pub(super) rule: R,
    pub(super) slots: Table<Slot<N>, L>,
    /// By tile: the tiles that may be its neighbors N, E, S, W.
    pub(super) partners: Table<[Words<N>; 4], L>,
    /// Whether the order of colors is fixed.
    pub(super) ordered: bool,
    /// By level: colors of the two palettes used before it, when their order is fixed.
    pub(super) used: Vec<(u8, u8)>,
    /// All colors of the two palettes.
    pub(super) all_used: (u8, u8),
    /// By those numbers, the first times `stride`: the tiles that may follow.
    follow: Vec<Words<N>>,
    stride: usize,
    shown: Shown,
    plan: WangPlan<N>,
    /// What sprints need, where there are any.
    pub(super) track: Option<Box<Track<N, L>>>,
    /// What batches need, where there may be any.
    herd: Option<Box<Herd>>,
}

impl<const N: usize, const L: usize, R: WangRule<N>, const QUOTIENT: bool> Wang<N, L, R, QUOTIENT> {
    /// The problem of a task that has been checked.
    ///
    /// `Ok(None)` means that what the reduction fixes already contradicts itself.
    ///
    /// # Errors
    /// When the pins contradict each other.
    pub fn new(
        task: &Task,
        reduction: &Reduction,
        shown: Shown,
        rule: R,
    ) -> Result<Option<Self>, TaskError> {
        let Some(plan) = WangPlan::<N>::new(task, reduction) else { return Ok(None) };
        let (colors, ordered) = (task.set.colors(), reduction.ordered_from);
        let stride = colors.vertical() + 1;
        let palettes = (colors.horizontal(), colors.vertical());
        let nothing = [Words::ALL; 4];
        let dummy = Slot { asked: nothing, ever: Words::ALL, neighbors: [0; 4], tile: 0 };
        let used = ordered.unwrap_or(0) as u8;
        let mut problem = Self {
            rule,
            slots: Table::new(vec![dummy; plan.slots.len() + 1], dummy),
            partners: Table::new(plan.partners(), nothing),
            ordered: ordered.is_some(),
            used: vec![(used, used); plan.steps.len() + 1],
            follow: if ordered.is_some() { plan.follow(palettes, stride) } else { Vec::new() },
            all_used: (palettes.0 as u8, palettes.1 as u8),
            stride,
            shown,
            track: None,
            herd: None,
            plan,
        };
        match problem.prepare(task) {
            Ok(()) => {
                if Self::SPRINTS {
                    problem.track = problem.track();
                    problem.herd = Herd::new(task, &problem.plan).map(Box::new);
                }
                Ok(Some(problem))
            }
            Err(_) if !task.has_pins() => Ok(None),
            Err(cell) => {
                let (row, column) = task.shape.position(cell);
                Err(TaskError::Pins(format!("no tile is left for row {row}, column {column}")))
            }
        }
    }

    /// Fills the slots and places the tiles known beforehand, or names a cell that contradicts.
    fn prepare(&mut self, task: &Task) -> Result<(), Cell> {
        let known = std::mem::take(&mut self.plan.known);
        for step in known.iter().chain(&self.plan.steps) {
            let slot = &mut self.slots[step.orbit[0] as usize];
            (slot.ever, slot.neighbors) = (step.ever, step.neighbors);
            if step.ever.is_empty() {
                return Err(step.cell);
            }
        }
        for step in &known {
            let mut candidates = self.candidates(0, step.orbit[0] as usize);
            if task.automorphism.is_some() {
                candidates = self.tried(0, candidates);
            }
            if candidates.is_empty() {
                return Err(step.cell);
            }
            let tile = candidates.first();
            let images = &self.plan.images[tile as usize];
            for (&slot, &image) in step.orbit.iter().zip(images) {
                self.slots[slot as usize].tile = image;
                self.slots[slot as usize].asked = self.partners[image as usize];
            }
            self.rule.fix(images);
        }
        Ok(())
    }

    /// What sprints need.
    fn track(&self) -> Option<Box<Track<N, L>>> {
        let steps = self.plan.steps.iter();
        let steps: Vec<_> = steps.map(|step| (step.ever, step.neighbors)).collect();
        Track::new(&self.plan.partners(), &steps).map(Box::new)
    }

    #[inline(always)]
    fn candidates(&self, level: usize, slot: usize) -> Words<N> {
        let slot = &self.slots[slot];
        let asked =
            |side: usize| self.slots[slot.neighbors[side] as usize].asked[NEIGHBORS[side].2];
        // What was written last, by the tile just placed, comes last.
        slot.ever & asked(1) & asked(2) & asked(0) & (asked(3) & self.rule.open(level))
    }

    /// Of some candidates those whose images may be placed along with them.
    #[inline(never)]
    fn tried(&mut self, level: usize, candidates: Words<N>) -> Words<N> {
        let mut fitting = candidates;
        for tile in candidates.numbers() {
            if !self.rule.fits(level, &self.plan.images[tile as usize]) {
                fitting.remove(tile);
            }
        }
        fitting
    }
}

impl<const N: usize, const L: usize, R: WangRule<N>, const QUOTIENT: bool> Problem
    for Wang<N, L, R, QUOTIENT>
{
    type Alternatives = Words<N>;

    const SPRINTS: bool = !QUOTIENT && R::BY_LEVEL && N <= 4;

    fn sprint(&mut self, stretch: Stretch<'_, Words<N>>) -> Option<Sprint> {
        if Self::SPRINTS { self.run(stretch) } else { None }
    }

    fn gathers_from(&self) -> Option<usize> {
        self.herd.as_ref().map(|herd| herd.from())
    }

    fn gather(&mut self, level: usize) -> bool {
        let Some(herd) = &mut self.herd else { return false };
        // While the order of colors is open it takes part in every choice.
        if self.ordered && self.used[level] != self.all_used {
            return false;
        }
        herd.gather(level, self.rule.open(level), |slot| self.slots[slot as usize].tile);
        true
    }

    fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        self.herd.as_mut().map_or(Ok(Visited::default()), |herd| herd.expand(bounds))
    }

    fn levels(&self) -> usize {
        self.plan.steps.len()
    }

    #[inline(always)]
    fn alternatives(&mut self, level: usize) -> Words<N> {
        let mut candidates = self.candidates(level, level);
        if self.ordered {
            let (h, v) = self.used[level];
            candidates &= self.follow[usize::from(h) * self.stride + usize::from(v)];
        }
        if QUOTIENT && !R::EXACT { self.tried(level, candidates) } else { candidates }
    }

    #[inline(always)]
    fn push(&mut self, level: usize, choice: u32) {
        let slot = &mut self.slots[level];
        slot.asked = self.partners[choice as usize];
        slot.tile = choice;
        if QUOTIENT {
            let images = &self.plan.images[choice as usize];
            for (&slot, &image) in self.plan.steps[level].orbit.iter().zip(images).skip(1) {
                self.slots[slot as usize].asked = self.partners[image as usize];
                self.slots[slot as usize].tile = image;
            }
            self.rule.take(level, images);
        } else {
            self.rule.take(level, &[choice]);
        }
        if self.ordered {
            let (h, v) = self.used[level];
            let [n, e, s, w] = self.plan.tiles[choice as usize];
            self.used[level + 1] = (h.max(n + 1).max(s + 1), v.max(e + 1).max(w + 1));
        }
    }

    #[inline(always)]
    fn pop(&mut self, level: usize, choice: u32) {
        if QUOTIENT {
            self.rule.release(level, &self.plan.images[choice as usize]);
        } else {
            self.rule.release(level, &[choice]);
        }
    }
}

impl<const N: usize, const L: usize, R: WangRule<N>, const QUOTIENT: bool> Labeled
    for Wang<N, L, R, QUOTIENT>
{
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        for &slot in &self.plan.slots {
            let tile = self.slots[slot as usize].tile;
            let [n, _, _, w] = self.plan.tiles[tile as usize];
            match self.shown {
                Shown::Both => labels.extend([n, w]),
                Shown::North => labels.push(n),
                Shown::West => labels.push(w),
            }
        }
    }
}
