//! What a contradiction teaches.
//!
//! The clause that was contradicted, with every literal that was forced replaced by its reason
//! until one literal of the latest guess is left, is a clause that follows from the formula and
//! that, had it been known, would have forced that literal earlier (the *first unique implication
//! point*). Literals that follow from the others are left out.

use super::clauses::NO_CLAUSE;
use super::{Literal, Solver};

impl Solver {
    /// Learns from a clause that is contradicted, goes back to where the lesson forces something,
    /// and does that.
    pub(super) fn learn(&mut self, conflict: u32) {
        let now = self.guesses.len() as u32;
        let mut lesson = vec![Literal(0)];
        let (mut open, mut at, mut clause) = (0, self.trail.len(), conflict);
        let forced = loop {
            // The literal that the clause forced has been dealt with, and is no longer marked.
            let skip = (clause != conflict).then(|| self.trail[at]);
            for i in 0..self.clauses.length(clause) {
                let literal = self.clauses.literal(clause, i);
                let variable = literal.variable();
                let (v, level) = (variable as usize, self.level[variable as usize]);
                if Some(literal) == skip || self.seen[v] || level == 0 {
                    continue;
                }
                self.seen[v] = true;
                self.heap.bump(variable);
                match level == now {
                    true => open += 1,
                    false => lesson.push(literal),
                }
            }
            loop {
                at -= 1;
                if self.seen[self.trail[at].variable() as usize] {
                    break;
                }
            }
            let literal = self.trail[at];
            let v = literal.variable() as usize;
            self.seen[v] = false;
            open -= 1;
            if open == 0 {
                break !literal;
            }
            clause = self.reason[v];
        };
        lesson[0] = forced;
        self.heap.decay();
        self.keep_what_is_needed(&mut lesson);
        self.draw(lesson);
    }

    /// Leaves out the literals that follow from the others; takes the marks away.
    fn keep_what_is_needed(&mut self, lesson: &mut Vec<Literal>) {
        let mut marked: Vec<u32> = lesson[1..].iter().map(|literal| literal.variable()).collect();
        let mut kept = vec![lesson[0]];
        for &literal in &lesson[1..] {
            if !self.follows(literal, &mut marked) {
                kept.push(literal);
            }
        }
        marked.iter().for_each(|&variable| self.seen[variable as usize] = false);
        *lesson = kept;
    }

    /// Whether a literal is false because others that are marked are; what was found on the way is
    /// marked, too.
    fn follows(&mut self, literal: Literal, marked: &mut Vec<u32>) -> bool {
        let before = marked.len();
        let mut open = vec![literal.variable()];
        while let Some(variable) = open.pop() {
            let reason = self.reason[variable as usize];
            if reason == NO_CLAUSE {
                marked.drain(before..).for_each(|v| self.seen[v as usize] = false);
                return false;
            }
            for other in self.clauses.literals(reason) {
                let v = other.variable() as usize;
                if !self.seen[v] && self.level[v] > 0 {
                    self.seen[v] = true;
                    marked.push(v as u32);
                    open.push(v as u32);
                }
            }
        }
        true
    }

    /// Goes back and adds a clause whose first literal is forced then.
    fn draw(&mut self, mut lesson: Vec<Literal>) {
        self.record.iter_mut().for_each(|record| record.learned.push(lesson.clone()));
        // The second literal is the one that became false last.
        let level = |literal: &Literal| self.level[literal.variable() as usize];
        let last = (1..lesson.len()).max_by_key(|&at| level(&lesson[at]));
        let Some(last) = last else {
            self.back_to(0);
            self.assign(lesson[0], NO_CLAUSE);
            return;
        };
        lesson.swap(1, last);
        let mut levels: Vec<u32> = lesson[1..].iter().map(level).collect();
        let back = levels[0] as usize;
        levels.sort_unstable();
        levels.dedup();
        self.back_to(back);
        let clause = self.clauses.add(&lesson, Some(levels.len() as u32));
        self.assign(lesson[0], clause);
    }

    /// The assumed literals because of which this one, assumed too, is false: with it, they
    /// contradict the formula.
    pub(super) fn why_not(&mut self, literal: Literal) -> Vec<Literal> {
        let mut needed = vec![literal];
        let first = self.guesses.first().map_or(self.trail.len(), |&at| at as usize);
        if self.level[literal.variable() as usize] == 0 {
            return needed;
        }
        self.seen[literal.variable() as usize] = true;
        for at in (first..self.trail.len()).rev() {
            let known = self.trail[at];
            let v = known.variable() as usize;
            if !std::mem::take(&mut self.seen[v]) {
                continue;
            }
            match self.reason[v] {
                // All guesses are assumptions here.
                NO_CLAUSE => needed.push(known),
                reason => {
                    for other in self.clauses.literals(reason) {
                        let o = other.variable() as usize;
                        self.seen[o] |= o != v && self.level[o] > 0;
                    }
                }
            }
        }
        needed
    }
}
