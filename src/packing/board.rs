//! Edge matching on boards: squares that may be turned, outer sides, a prescribed border.
//!
//! A level fills one cell. Its alternatives are numbered along the list of tiles that fit the
//! colors around the cell ([`BoardPlan`]), less those whose squares all lie elsewhere and those
//! that ask for a color nobody has left ([`Caps`]). The lists of hard puzzles are short, so that
//! a word is nearly always enough, whatever the number of squares.
//!
//! Invariant: `labels` holds the colors at all places of the levels pushed, `free` the squares
//! that do not lie there, `caps` what these leave.

use super::board_caps::Caps;
use super::board_plan::{BoardPlan, Record};
use super::{Labeled, Task};
use crate::search::{Alternatives, Problem, Sprint, Stretch, Words};
use std::sync::Arc;

/// The search for packings of a board, for lists of at most `64 * N` tiles.
#[derive(Debug, Clone)]
pub struct OnBoard<const N: usize> {
    pub(super) plan: Arc<BoardPlan>,
    /// By place, the dummy at the end.
    pub(super) labels: Vec<u8>,
    /// By class.
    pub(super) free: Vec<u16>,
    pub(super) caps: Caps,
}

/// A plan to be searched with words that hold its lists.
#[derive(Debug, Clone)]
pub struct Planned(Arc<BoardPlan>);

impl Planned {
    /// For a task on a board that has been checked. Without caps there are more nodes, and the
    /// same packings.
    pub fn new(task: &Task, with_caps: bool) -> Self {
        Self(Arc::new(BoardPlan::new(task, with_caps)))
    }

    /// The words that a problem needs.
    pub fn words(&self) -> usize {
        self.0.longest().div_ceil(64)
    }

    /// The problem.
    pub fn problem<const N: usize>(&self) -> OnBoard<N> {
        let plan = &self.0;
        OnBoard {
            labels: plan.labels.clone(),
            free: plan.squares.clone(),
            caps: plan.caps.clone(),
            plan: Arc::clone(plan),
        }
    }
}

impl<const N: usize> OnBoard<N> {
    /// Whether a tile of the list of a level may be laid.
    #[inline(always)]
    fn fits(&self, level: usize, record: &Record) -> bool {
        let checks = self.plan.levels[level].checks().iter();
        self.free[usize::from(record.class)] > 0
            && !self.caps.are_closed(record.asks)
            && checks.into_iter().all(|check| {
                record.sides[usize::from(check.side) % 4] == self.labels[usize::from(check.at)]
            })
    }

    /// The tile that a choice at a level stands for.
    fn record(&self, level: usize, choice: u32) -> Record {
        let list = self.plan.list(&self.plan.levels[level], &self.labels);
        self.plan.records[list.start + choice as usize]
    }
}

impl<const N: usize> Problem for OnBoard<N> {
    type Alternatives = Words<N>;

    fn levels(&self) -> usize {
        self.plan.levels.len()
    }

    fn alternatives(&mut self, level: usize) -> Words<N> {
        let list = self.plan.list(&self.plan.levels[level], &self.labels);
        let mut fitting = Words::EMPTY;
        for (choice, record) in self.plan.records[list].iter().enumerate() {
            if self.fits(level, record) {
                fitting.insert(choice as u32);
            }
        }
        fitting
    }

    fn push(&mut self, level: usize, choice: u32) {
        let record = self.record(level, choice);
        self.free[usize::from(record.class)] -= 1;
        for (place, cost) in self.plan.levels[level].fresh() {
            let color = record.sides[usize::from(place.side)];
            self.labels[usize::from(place.at)] = color;
            if self.caps.counts() {
                self.caps.take(color, cost);
            }
        }
    }

    fn pop(&mut self, level: usize, choice: u32) {
        let record = self.record(level, choice);
        self.free[usize::from(record.class)] += 1;
        if self.caps.counts() {
            for (place, cost) in self.plan.levels[level].fresh() {
                self.caps.give(record.sides[usize::from(place.side)], cost);
            }
        }
    }

    const SPRINTS: bool = true;

    fn sprint(&mut self, stretch: Stretch<'_, Words<N>>) -> Option<Sprint> {
        let _ = stretch;
        None
    }
}

impl<const N: usize> Labeled for OnBoard<N> {
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        labels.extend_from_slice(&self.labels[..self.labels.len() - 1]);
    }
}
