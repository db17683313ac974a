//! All models of a CNF, by unit propagation and branching on the first free variable.

/// Clauses and what is assigned.
struct Search<'a> {
    clauses: Vec<Vec<i32>>,
    /// For every literal, by [`place`], the clauses that hold it.
    of: Vec<Vec<usize>>,
    /// 1 true, -1 false, 0 free.
    value: Vec<i8>,
    trail: Vec<i32>,
    found: &'a mut dyn FnMut(&[i32]) -> bool,
    nodes: u64,
}

fn place(literal: i32) -> usize {
    2 * literal.unsigned_abs() as usize + usize::from(literal < 0)
}

/// The number of models.
pub(crate) fn models(text: &str) -> u64 {
    let mut number = 0;
    each(text, &mut |_| number += 1);
    number
}

/// Every model, as literals.
pub(crate) fn each(text: &str, found: &mut dyn FnMut(&[i32])) {
    search(text, u64::MAX, &mut |model| {
        found(model);
        true
    });
}

/// One model, if there is one within so many nodes.
pub(crate) fn first(text: &str, nodes: u64) -> Option<Vec<i32>> {
    let mut one = None;
    search(text, nodes, &mut |model| {
        one = Some(model.to_vec());
        false
    });
    one
}

fn search(text: &str, nodes: u64, found: &mut dyn FnMut(&[i32]) -> bool) {
    let mut lines = text.lines().filter(|line| !line.starts_with('c'));
    let head: Vec<&str> = lines.next().unwrap().split(' ').collect();
    assert_eq!(head[..2], ["p", "cnf"]);
    let variables: usize = head[2].parse().unwrap();
    let mut of = vec![Vec::new(); 2 * variables + 2];
    let mut clauses: Vec<Vec<i32>> = Vec::new();
    for line in lines {
        let mut clause: Vec<i32> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        assert_eq!(clause.pop(), Some(0));
        clause.iter().for_each(|&literal| of[place(literal)].push(clauses.len()));
        clauses.push(clause);
    }
    assert_eq!(clauses.len().to_string(), head[3]);
    let value = vec![0; variables + 1];
    let mut search = Search { clauses, of, value, trail: Vec::new(), found, nodes };
    let all = 0..search.clauses.len();
    if all.into_iter().all(|clause| search.look_at(clause)) && search.propagate(0) {
        search.branch(1);
    }
}

impl Search<'_> {
    fn holds(&self, literal: i32) -> i8 {
        self.value[literal.unsigned_abs() as usize] * literal.signum() as i8
    }

    fn assign(&mut self, literal: i32) {
        self.value[literal.unsigned_abs() as usize] = literal.signum() as i8;
        self.trail.push(literal);
    }

    /// Draws the conclusion from a clause; whether it can still hold.
    fn look_at(&mut self, clause: usize) -> bool {
        let mut free = None;
        for &literal in &self.clauses[clause] {
            match self.holds(literal) {
                1 => return true,
                0 if free.is_some_and(|known| known != literal) => return true,
                0 => free = Some(literal),
                _ => {}
            }
        }
        free.is_some_and(|literal| {
            self.assign(literal);
            true
        })
    }

    /// Follows what has been assigned from here on.
    fn propagate(&mut self, mut from: usize) -> bool {
        while let Some(&literal) = self.trail.get(from) {
            from += 1;
            for i in 0..self.of[place(-literal)].len() {
                if !self.look_at(self.of[place(-literal)][i]) {
                    return false;
                }
            }
        }
        true
    }

    /// Whether to go on.
    fn branch(&mut self, from: usize) -> bool {
        if self.nodes == 0 {
            return false;
        }
        self.nodes -= 1;
        let Some(next) = (from..self.value.len()).find(|&v| self.value[v] == 0) else {
            return (self.found)(&self.trail);
        };
        let depth = self.trail.len();
        for literal in [next as i32, -(next as i32)] {
            self.assign(literal);
            let on = !self.propagate(depth) || self.branch(next + 1);
            for literal in self.trail.drain(depth..) {
                self.value[literal.unsigned_abs() as usize] = 0;
            }
            if !on {
                return false;
            }
        }
        true
    }
}
