//! Edge matching on boards: squares that may be turned, outer sides, a prescribed border.
//!
//! A level fills one cell. Its alternatives are numbered along the list of tiles that fit the
//! colors around the cell (`BoardPlan`), less those whose squares all lie elsewhere and those
//! that ask for a color nobody has left (`Caps`). The lists of hard puzzles are short, so that
//! a word is nearly always enough, whatever the number of squares.
//!
//! Invariant: `labels` holds the colors at all places of the levels pushed, `free` the squares
//! that do not lie there, `caps` what these leave.

use super::board_caps::Caps;
use super::board_plan::{BoardPlan, Record};
use super::board_sprint::Track;
use super::table::Table;
use super::{Labeled, Task};
use crate::search::{Alternatives, Problem, Sprint, Stretch, Words};
use std::sync::Arc;

/// As many places as a [`Place`](super::board_plan::Place) can name. After those of the board
/// comes the dummy; the last is never read.
pub(super) const PLACES: usize = 1 << 16;
/// Classes of squares.
const CLASSES: usize = 1 << 12;

/// The colors by place.
pub(super) type Labels = Table<u8, PLACES>;

/// The search for packings of a board, for lists of at most `64 * N` tiles.
#[derive(Debug, Clone)]
pub struct OnBoard<const N: usize> {
    pub(super) plan: Arc<BoardPlan>,
    pub(super) labels: Labels,
    /// By class.
    pub(super) free: Table<u16, CLASSES>,
    pub(super) caps: Caps,
    /// What sprints need, where there are any.
    pub(super) track: Option<Box<Track>>,
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
            labels: Table::new(plan.labels.clone(), 0),
            free: Table::new(plan.squares.clone(), 0),
            caps: plan.caps.clone(),
            track: Track::new(plan).map(Box::new),
            plan: Arc::clone(plan),
        }
    }
}

impl<const N: usize> OnBoard<N> {
    /// Whether a tile of the list of a level may be laid.
    #[inline(always)]
    fn fits(&self, level: usize, record: &Record) -> bool {
        self.free[usize::from(record.class)] > 0
            && !self.caps.are_closed(record.asks)
            && self.plan.levels[level].matches(record, &self.labels)
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
            self.caps.take(color, cost);
        }
    }

    fn pop(&mut self, level: usize, choice: u32) {
        let record = self.record(level, choice);
        self.free[usize::from(record.class)] += 1;
        for (place, cost) in self.plan.levels[level].fresh() {
            self.caps.give(record.sides[usize::from(place.side)], cost);
        }
    }

    const SPRINTS: bool = true;

    fn sprint(&mut self, stretch: Stretch<'_, Words<N>>) -> Option<Sprint> {
        self.run(stretch)
    }
}

impl<const N: usize> Labeled for OnBoard<N> {
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
        labels.extend((0..self.plan.labels.len() - 1).map(|place| self.labels[place]));
    }
}
