//! A search as a whole: the task, what is asked about it, and what decides which tree is walked.
//!
//! Two searches with equal jobs visit the same nodes in the same order, whatever the number of
//! threads, so what one has left undone the other can take up. All that may differ without
//! making another search (threads, limits, what is shown) is in [`Settings`](super::Settings).

use super::Task;
use super::halves;
use super::reduction::Reduction;
use super::rows::{self, RowsError, line::Frame};
use super::sinks::{Forms, Purpose};
use super::solve::SolveError;
use crate::search::{Part, Values};
use crate::symmetry::{BoardCanonizer, Canonizer, Group};
use crate::tiles::Kind;
use crate::torus::Order;

/// What is asked about a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Question {
    /// The first packing.
    First,
    /// How many there are.
    Count {
        /// Also up to symmetry.
        up_to_symmetry: bool,
    },
    /// Which there are.
    List {
        /// Only one of each orbit.
        up_to_symmetry: bool,
    },
}

/// A search.
#[derive(Debug, Clone)]
pub struct Job {
    /// Which packings.
    pub task: Task,
    /// What is asked about them.
    pub question: Question,
    /// The order in which the alternatives of a level are tried.
    pub values: Values,
    /// Whether symmetry may be removed before the search (the answer is the same).
    pub reduce: bool,
    /// Only this part of the search.
    pub part: Option<Part>,
    /// Packings are counted by two halves that meet ([`super::rows`], [`super::halves`]) instead
    /// of one by one.
    pub by_lines: bool,
}

/// The search for all that a task asks about, in lexicographic order, reduced.
impl From<&Task> for Job {
    fn from(task: &Task) -> Self {
        Self::new(task.clone(), Question::First)
    }
}

impl Job {
    /// The whole search, in lexicographic order, reduced.
    pub fn new(task: Task, question: Question) -> Self {
        Self {
            task,
            question,
            values: Values::Lexicographic,
            reduce: true,
            part: None,
            by_lines: false,
        }
    }

    /// The order in which cells are visited; of a count by lines, how these lie.
    pub fn order(&self) -> Order {
        let lines = self.by_lines && self.task.set.kind() == Kind::Corner;
        match (lines, Frame::of(&self.task).transposed) {
            (false, _) => self.task.visiting_order(),
            (true, false) => Order::Row,
            (true, true) => Order::Column,
        }
    }

    /// Checks that the job makes sense.
    ///
    /// # Errors
    /// When the task does not, or has no orbits where they are asked for.
    pub fn check(&self) -> Result<(), SolveError> {
        if self.up_to_symmetry() && self.task.has_pins() {
            return Err(SolveError::PinnedOrbits);
        }
        self.task.check()?;
        if self.by_lines {
            if self.question != (Question::Count { up_to_symmetry: false }) {
                return Err(RowsError::Asked("single packings or orbits").into());
            }
            if !self.reduce {
                return Err(RowsError::Asked("symmetry that is not removed").into());
            }
            match self.task.set.kind() {
                Kind::Wang => halves::check(&self.task)?,
                _ => rows::check(&self.task)?,
            }
        }
        Ok(())
    }

    /// Whether orbits are asked for.
    pub fn up_to_symmetry(&self) -> bool {
        match self.question {
            Question::First => false,
            Question::Count { up_to_symmetry } | Question::List { up_to_symmetry } => {
                up_to_symmetry
            }
        }
    }

    /// Whether the packings are to be kept.
    pub fn is_list(&self) -> bool {
        matches!(self.question, Question::List { .. })
    }

    /// What the search assumes: as much as the question allows.
    pub fn reduction(&self) -> Reduction {
        match (self.reduce && !self.by_lines, self.question) {
            (false, _) => Reduction::none(),
            (_, Question::First | Question::Count { up_to_symmetry: false }) => {
                Reduction::full(&self.task)
            }
            // Colors in order would leave out packings to list, and canonical ones.
            _ => Reduction::anchored(&self.task),
        }
    }

    /// What is done with each solution.
    ///
    /// # Errors
    /// When the symmetries cannot be had.
    pub(super) fn purpose(&self) -> Result<Purpose, SolveError> {
        let keep = self.is_list();
        if self.up_to_symmetry() {
            let task = &self.task;
            if !task.board.is_plain() {
                let canonizer = BoardCanonizer::new(&task.set, task.shape, &task.board)?;
                return Ok(Purpose::Orbits { canonizer: Box::new(Forms::Board(canonizer)), keep });
            }
            let group = Group::of(&task.set, task.shape, task.automorphism.as_ref())?;
            let canonizer = Canonizer::new(&group, self.reduction().anchor);
            let canonizer = Box::new(Forms::Torus(canonizer));
            return Ok(Purpose::Orbits { canonizer, keep });
        }
        Ok(match self.question {
            _ if self.by_lines => Purpose::Met,
            Question::First => Purpose::First,
            Question::Count { .. } => Purpose::Count,
            Question::List { .. } => Purpose::Keep,
        })
    }
}
