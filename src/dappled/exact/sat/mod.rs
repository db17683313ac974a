//! A solver for formulas: is there a choice of truth values under which every clause holds?
//!
//! The search guesses values, draws the conclusions that single clauses force, and learns from
//! every contradiction a clause that would have avoided it: *conflict-driven clause learning*
//! (Marques-Silva and Sakallah 1996; Moskewicz et al. 2001; Eén and Sörensson 2003). Each clause is
//! looked at only when one of its first two literals becomes false (`clauses`); guesses go to
//! variables that took part in conflicts lately (`heap`), with the value that they had before;
//! the search begins again in the rhythm of Luby's sequence, and forgets what was of little use.
//!
//! Some literals may be *assumed* for one question; when they contradict the formula, the answer
//! names those that were needed ([`Answer::Failed`]). What was learned stays for the next question,
//! for it follows from the clauses alone.
//!
//! Single-threaded and without chance: the same questions get the same answers.

mod analyze;
mod clauses;
mod heap;

use crate::search::Stop;
use clauses::{Clauses, NO_CLAUSE};
use heap::Heap;

/// A variable or its negation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Literal(u32);

impl Literal {
    /// The variable, or its negation.
    pub fn new(variable: u32, holds: bool) -> Self {
        Self(2 * variable + u32::from(!holds))
    }

    /// Which variable.
    pub fn variable(self) -> u32 {
        self.0 / 2
    }

    /// Whether it is the variable itself.
    pub fn is_positive(self) -> bool {
        self.0 & 1 == 0
    }

    fn index(self) -> usize {
        self.0 as usize
    }
}

impl std::ops::Not for Literal {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

/// What became of a question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// Every clause holds; the values are [`Solver::holds`].
    Model,
    /// These of the assumed literals contradict the formula; none if it contradicts itself.
    Failed(Vec<Literal>),
    /// Stopped before the answer was known.
    Stopped,
}

/// A proof, if nothing was assumed: each learned clause follows, by drawing conclusions from single
/// clauses, from the given ones and those learned before; the last one is empty if the formula
/// contradicts itself (the format DRAT, without deletions).
#[derive(Debug, Clone, Default)]
pub struct Record {
    /// The formula.
    pub given: Vec<Vec<Literal>>,
    /// What was learned, in order.
    pub learned: Vec<Vec<Literal>>,
}

/// A formula, and what was learned from it.
#[derive(Debug, Clone)]
pub struct Solver {
    clauses: Clauses,
    /// By literal: 1 true, -1 false, 0 open.
    value: Vec<i8>,
    /// By variable: how many guesses came before it was known.
    level: Vec<u32>,
    /// By variable: the clause that forced it.
    reason: Vec<u32>,
    /// The value it had before.
    phase: Vec<bool>,
    /// What is true, in the order in which it was found.
    trail: Vec<Literal>,
    /// Where guesses lie on the trail.
    guesses: Vec<u32>,
    /// Up to here conclusions were drawn.
    head: usize,
    heap: Heap,
    /// By variable: seen in the analysis of a conflict.
    seen: Vec<bool>,
    /// The formula contradicts itself.
    hopeless: bool,
    /// The values of the last model, by variable.
    model: Vec<bool>,
    /// What was given and learned, if it is kept.
    record: Option<Record>,
    /// Contradictions so far.
    conflicts: u64,
    /// So many learned clauses are kept.
    room: usize,
}

/// Contradictions before the search begins again, times Luby's number.
const PATIENCE: u64 = 100;

impl Solver {
    /// A formula of so many variables without clauses.
    pub fn new(variables: usize) -> Self {
        Self {
            clauses: Clauses::new(variables),
            value: vec![0; 2 * variables],
            level: vec![0; variables],
            reason: vec![NO_CLAUSE; variables],
            phase: vec![false; variables],
            trail: Vec::new(),
            guesses: Vec::new(),
            head: 0,
            heap: Heap::new(variables),
            seen: vec![false; variables],
            hopeless: false,
            model: Vec::new(),
            record: None,
            conflicts: 0,
            room: 4000,
        }
    }

    /// One more variable.
    pub fn variable(&mut self) -> u32 {
        let variable = self.level.len() as u32;
        self.clauses.grow();
        self.value.extend([0, 0]);
        self.level.push(0);
        self.reason.push(NO_CLAUSE);
        self.phase.push(false);
        self.seen.push(false);
        self.heap.grow();
        variable
    }

    /// How many variables there are.
    pub fn variables(&self) -> usize {
        self.level.len()
    }

    /// Contradictions that were met so far.
    pub fn conflicts(&self) -> u64 {
        self.conflicts
    }

    /// The value to guess first.
    pub fn prefer(&mut self, literal: Literal) {
        self.phase[literal.variable() as usize] = literal.is_positive();
    }

    /// Keeps all clauses that are given and learned from now on.
    pub fn keep_record(&mut self) {
        self.record = Some(Record::default());
    }

    /// What was kept.
    pub fn record(&self) -> Option<&Record> {
        self.record.as_ref()
    }

    /// Whether a literal holds in the last model.
    pub fn holds(&self, literal: Literal) -> bool {
        self.model.get(literal.variable() as usize) == Some(&literal.is_positive())
    }

    /// Adds a clause: one of these literals must hold.
    pub fn add(&mut self, clause: &[Literal]) {
        self.back_to(0);
        self.record.iter_mut().for_each(|record| record.given.push(clause.to_vec()));
        let mut kept = clause.to_vec();
        kept.sort_unstable();
        kept.dedup();
        let always = kept.windows(2).any(|pair| pair[0] == !pair[1]);
        if self.hopeless || always || kept.iter().any(|&literal| self.is(literal) > 0) {
            return;
        }
        kept.retain(|&literal| self.is(literal) == 0);
        match kept[..] {
            [] => self.give_up(),
            [only] => self.assign(only, NO_CLAUSE),
            _ => {
                self.clauses.add(&kept, None);
            }
        }
    }

    /// Looks for values under which all clauses and these literals hold.
    pub fn solve(&mut self, assumed: &[Literal], stop: &dyn Stop) -> Answer {
        self.back_to(0);
        let mut round = 0;
        loop {
            round += 1;
            let answer = self.search(assumed, PATIENCE * luby(round), stop);
            if let Some(answer) = answer {
                self.back_to(0);
                return answer;
            }
            if self.clauses.learned() > self.room {
                self.back_to(0);
                self.reason.fill(NO_CLAUSE);
                self.clauses.forget(&self.value);
                self.room += 500;
            }
            self.back_to(assumed.len().min(self.guesses.len()));
        }
    }

    /// Searches until an answer or so many contradictions.
    fn search(&mut self, assumed: &[Literal], patience: u64, stop: &dyn Stop) -> Option<Answer> {
        let (mut conflicts, mut guesses) = (0, 0u32);
        loop {
            if self.hopeless {
                return Some(Answer::Failed(Vec::new()));
            }
            if let Some(clause) = self.propagate() {
                if self.guesses.is_empty() {
                    self.give_up();
                    continue;
                }
                conflicts += 1;
                self.conflicts += 1;
                self.learn(clause);
                if conflicts % 64 == 0 && stop.should_stop() {
                    return Some(Answer::Stopped);
                }
                continue;
            }
            if conflicts >= patience {
                return None;
            }
            guesses += 1;
            if guesses % 1024 == 0 && stop.should_stop() {
                return Some(Answer::Stopped);
            }
            match assumed.get(self.guesses.len()) {
                Some(&literal) => match self.is(literal) {
                    0 => self.guess(literal),
                    // A guess without a new value, so that guesses count assumptions.
                    1 => self.guesses.push(self.trail.len() as u32),
                    _ => return Some(Answer::Failed(self.why_not(literal))),
                },
                None => match self.next() {
                    Some(literal) => self.guess(literal),
                    None => {
                        let values = self.value.iter().step_by(2);
                        self.model = values.map(|&value| value > 0).collect();
                        return Some(Answer::Model);
                    }
                },
            }
        }
    }

    /// The next guess.
    fn next(&mut self) -> Option<Literal> {
        while let Some(variable) = self.heap.pop() {
            let literal = Literal::new(variable, self.phase[variable as usize]);
            if self.is(literal) == 0 {
                return Some(literal);
            }
        }
        None
    }

    fn guess(&mut self, literal: Literal) {
        self.guesses.push(self.trail.len() as u32);
        self.assign(literal, NO_CLAUSE);
    }

    fn is(&self, literal: Literal) -> i8 {
        self.value[literal.index()]
    }

    fn assign(&mut self, literal: Literal, reason: u32) {
        let variable = literal.variable() as usize;
        self.value[literal.index()] = 1;
        self.value[(!literal).index()] = -1;
        self.level[variable] = self.guesses.len() as u32;
        self.reason[variable] = reason;
        self.trail.push(literal);
    }

    /// Takes back all but so many guesses, and what followed from them.
    fn back_to(&mut self, guesses: usize) {
        let Some(&from) = self.guesses.get(guesses) else { return };
        for literal in self.trail.drain(from as usize..) {
            let variable = literal.variable();
            self.value[literal.index()] = 0;
            self.value[(!literal).index()] = 0;
            self.phase[variable as usize] = literal.is_positive();
            self.heap.insert(variable);
        }
        self.guesses.truncate(guesses);
        self.head = from as usize;
    }

    /// Draws all conclusions; the clause that is contradicted, if one is.
    fn propagate(&mut self) -> Option<u32> {
        while let Some(&literal) = self.trail.get(self.head) {
            self.head += 1;
            let mut at = 0;
            while let Some(forced) = self.clauses.next_forced(!literal, &mut at, &self.value) {
                if self.is(forced.literal) < 0 {
                    return Some(forced.clause);
                }
                self.assign(forced.literal, forced.clause);
            }
        }
        None
    }

    /// The formula contradicts itself.
    fn give_up(&mut self) {
        if !self.hopeless {
            self.hopeless = true;
            self.record.iter_mut().for_each(|record| record.learned.push(Vec::new()));
        }
    }
}

/// Luby's sequence from 1 on: 1 1 2 1 1 2 4 1 1 2 1 1 2 4 8 ...
fn luby(mut at: u64) -> u64 {
    loop {
        let power = (at + 1).ilog2();
        if at + 1 == 1 << power {
            return 1 << (power - 1);
        }
        at -= (1 << power) - 1;
    }
}

#[cfg(test)]
mod tests;
