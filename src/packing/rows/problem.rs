//! All choices of line 0 and of line `a`, as a tree of two levels.
//!
//! The first choice is the class of line 0, the second line `a`. A leaf is no packing but a
//! number of them, which is only worked out when somebody asks ([`Labeled::met`]): walking the
//! tree itself costs nothing.

use super::line::{Lines, State};
use super::meet::{Met, Room, Side};
use crate::packing::{Labeled, Task};
use crate::search::{Alternatives, Problem, Words};
use num_bigint::BigUint;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

/// What threads at work on the same class share, by class.
type Sides = Vec<Mutex<Weak<Side>>>;

/// The choices made, and what is needed for what comes of them.
#[derive(Debug)]
pub struct Rows {
    lines: Arc<Lines>,
    sides: Arc<Sides>,
    class: u8,
    line: State,
    desk: Mutex<Desk>,
}

/// What one thread works with.
#[derive(Debug, Default)]
struct Desk {
    side: Option<(u8, Arc<Side>)>,
    room: Room,
}

impl Rows {
    /// The problem of a task that has been checked.
    pub fn new(task: &Task) -> Self {
        let lines = Lines::new(task);
        let sides = lines.classes.iter().map(|_| Mutex::default()).collect();
        let (lines, sides) = (Arc::new(lines), Arc::new(sides));
        Self { lines, sides, class: 0, line: 0, desk: Mutex::default() }
    }

    /// The packings with the lines chosen.
    pub fn meet(&self) -> Met {
        let mut desk = lock(&self.desk);
        let Desk { side, room } = &mut *desk;
        if side.as_ref().is_none_or(|&(class, _)| class != self.class) {
            // The old one first: they are large.
            *side = None;
            let mut shared = lock(&self.sides[usize::from(self.class)]);
            let made = shared.upgrade().unwrap_or_else(|| {
                let made = Arc::new(Side::new(&self.lines, self.class));
                *shared = Arc::downgrade(&made);
                made
            });
            *side = Some((self.class, made));
        }
        match side {
            Some((_, side)) => side.meet(&self.lines, self.line, room),
            None => Met::default(),
        }
    }

    /// A packing with `m` lines of the class of line 0 is met `m` times among its rotations; so
    /// that nothing is divided before all is added up, packings count as many times as this.
    pub fn unit(lines: usize) -> u64 {
        let gcd = |mut a: u64, mut b: u64| {
            while b > 0 {
                (a, b) = (b, a % b);
            }
            a
        };
        (1..=lines as u64).fold(1, |lcm, m| lcm / gcd(lcm, m) * m)
    }
}

/// Another thread's copy shares what is large and never changes.
impl Clone for Rows {
    fn clone(&self) -> Self {
        let (lines, sides) = (Arc::clone(&self.lines), Arc::clone(&self.sides));
        Self { lines, sides, desk: Mutex::default(), ..*self }
    }
}

impl Problem for Rows {
    type Alternatives = Words<{ super::MOST_STATES / 64 }>;

    /// A leaf takes seconds.
    const FIRST_SLICE: u64 = 1;

    fn levels(&self) -> usize {
        2
    }

    fn alternatives(&mut self, level: usize) -> Self::Alternatives {
        if level == 0 {
            return Words::below(self.lines.classes.len());
        }
        let mut lines = Words::EMPTY;
        for (line, &class) in self.lines.class.iter().enumerate() {
            if class >= self.class {
                lines.insert(line as u32);
            }
        }
        lines
    }

    fn push(&mut self, level: usize, choice: u32) {
        if level == 0 {
            self.class = choice as u8;
        } else {
            self.line = choice as State;
        }
    }

    fn pop(&mut self, _: usize, _: u32) {}
}

impl Labeled for Rows {
    /// Nothing: a leaf stands for many packings, and there are no labels of any.
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
    }

    fn met(&self) -> Option<(u64, BigUint)> {
        let Met { packings, steps } = self.meet();
        let lines = self.lines.frame.lines;
        let size = self.lines.classes[usize::from(self.class)].size;
        let share = |m: usize| Self::unit(lines) / m as u64 * lines as u64 * size;
        let weights = (1..=lines).map(|m| BigUint::from(packings[m]) * share(m));
        Some((steps, weights.sum()))
    }
}

/// Locks even after a panic of another thread, which is passed on at the end anyway.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
