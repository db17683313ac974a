//! Checks a proof of unsatisfiability in the format DRAT, by itself.
//!
//! Every clause that the proof adds must follow by unit propagation: its negation and the clauses
//! so far must contradict each other. (M. Heule, *The DRAT format and DRAT-trim checker*, 2016;
//! the weaker property RAT is not accepted.) Deletions are passed over, which can only help.

use std::collections::VecDeque;

/// Clauses and what follows from them.
struct Checker {
    clauses: Vec<Vec<i32>>,
    /// For every literal, by [`place`], the clauses that watch it: its first two are watched.
    watched: Vec<Vec<usize>>,
    /// 1 true, -1 false, 0 open.
    value: Vec<i8>,
    trail: Vec<i32>,
    contradiction: bool,
}

/// Checks that a proof shows that the formula cannot be satisfied.
pub(crate) fn check(formula: &[Vec<i32>], proof: &str) -> Result<(), String> {
    let mut checker = Checker {
        clauses: Vec::new(),
        watched: Vec::new(),
        value: Vec::new(),
        trail: Vec::new(),
        contradiction: false,
    };
    for clause in formula {
        checker.add(clause.clone());
    }
    for (line, text) in (1..).zip(proof.lines()) {
        if checker.contradiction {
            return Ok(());
        }
        if text.starts_with('d') {
            continue;
        }
        let literals: Result<Vec<i32>, _> = text.split_whitespace().map(str::parse).collect();
        let mut clause = literals.map_err(|error| format!("line {line}: {error}"))?;
        if clause.pop() != Some(0) {
            return Err(format!("line {line}: no 0 at the end"));
        }
        if !checker.follows(&clause) {
            return Err(format!("line {line}: does not follow: {text}"));
        }
        checker.add(clause);
    }
    checker.contradiction.then_some(()).ok_or_else(|| "no contradiction at the end".to_owned())
}

fn place(literal: i32) -> usize {
    2 * literal.unsigned_abs() as usize + usize::from(literal < 0)
}

impl Checker {
    fn holds(&self, literal: i32) -> i8 {
        self.value[literal.unsigned_abs() as usize] * literal.signum() as i8
    }

    fn assign(&mut self, literal: i32) {
        self.value[literal.unsigned_abs() as usize] = literal.signum() as i8;
        self.trail.push(literal);
    }

    /// Adds a clause, and for good what follows from it.
    fn add(&mut self, mut clause: Vec<i32>) {
        clause.sort_unstable();
        clause.dedup();
        let largest = clause.iter().map(|l| l.unsigned_abs() as usize).max().unwrap_or(0);
        if self.value.len() <= largest {
            self.value.resize(largest + 1, 0);
            self.watched.resize(2 * largest + 2, Vec::new());
        }
        // What is open or true comes first.
        clause.sort_by_key(|&literal| self.holds(literal) < 0);
        let open = clause.iter().filter(|&&literal| self.holds(literal) >= 0).count();
        if clause.len() > 1 {
            for &literal in &clause[..2] {
                self.watched[place(literal)].push(self.clauses.len());
            }
            self.clauses.push(clause.clone());
        }
        let from = self.trail.len();
        match open {
            0 => self.contradiction = true,
            1 if self.holds(clause[0]) == 0 => {
                self.assign(clause[0]);
                self.contradiction |= !self.propagate(from);
            }
            _ => {}
        }
    }

    /// Whether the negation of a clause leads to a contradiction.
    fn follows(&mut self, clause: &[i32]) -> bool {
        let from = self.trail.len();
        let mut contradiction = false;
        for &literal in clause {
            match self.value.get(literal.unsigned_abs() as usize) {
                // Nothing is known about it.
                None => {}
                Some(_) if self.holds(literal) > 0 => contradiction = true,
                Some(0) => self.assign(-literal),
                Some(_) => {}
            }
        }
        contradiction = contradiction || !self.propagate(from);
        for literal in self.trail.drain(from..) {
            self.value[literal.unsigned_abs() as usize] = 0;
        }
        contradiction
    }

    /// Draws all conclusions from what was assigned from here on; whether there is no
    /// contradiction.
    fn propagate(&mut self, from: usize) -> bool {
        let mut queue: VecDeque<i32> = self.trail[from..].iter().copied().collect();
        while let Some(literal) = queue.pop_front() {
            let watching = std::mem::take(&mut self.watched[place(-literal)]);
            for (i, &number) in watching.iter().enumerate() {
                let mut clause = std::mem::take(&mut self.clauses[number]);
                if clause[0] == -literal {
                    clause.swap(0, 1);
                }
                let other = clause[0];
                let next = (2..clause.len()).find(|&at| self.holds(clause[at]) >= 0);
                match next {
                    _ if self.holds(other) > 0 => self.watched[place(-literal)].push(number),
                    Some(at) => {
                        clause.swap(1, at);
                        self.watched[place(clause[1])].push(number);
                    }
                    None => self.watched[place(-literal)].push(number),
                }
                let stuck = next.is_none();
                self.clauses[number] = clause;
                if stuck && self.holds(other) < 0 {
                    self.watched[place(-literal)].extend(&watching[i + 1..]);
                    return false;
                }
                if stuck && self.holds(other) == 0 {
                    self.assign(other);
                    queue.push_back(other);
                }
            }
        }
        true
    }
}

#[test]
fn only_what_follows_is_accepted() {
    let formula = [vec![1, 2], vec![-1, 2], vec![1, -2], vec![-1, -2]];
    assert_eq!(check(&formula, "2 0\nd 1 2 0\n0\n"), Ok(()));
    assert_eq!(check(&formula, "1 0\n"), Ok(()));
    assert!(check(&formula, "").is_err());
    assert!(check(&formula, "0\n").is_err());
    assert!(check(&formula[..3], "2 0\n0\n").is_err());
    assert!(check(&formula[..3], "-2 0\n").is_err());
}
