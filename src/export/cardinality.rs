//! "Exactly so many of these" in clauses, by a counter that runs along them.
//!
//! The counter has a variable for "at least one of the first i", for two also "at least two"
//! (C. Sinz, *Towards an optimal CNF encoding of Boolean cardinality constraints*, 2005). Every
//! one is defined both ways, so it follows from the variables counted: a problem has as many
//! models as solutions, and a program that counts models counts packings. Up to four variables
//! are excluded pair by pair, which needs no others.
//!
//! A variable that stands twice in the list counts twice.

/// Takes clauses, and hands out new variables.
pub struct Clauses<'a> {
    /// The largest variable in use.
    pub variables: i32,
    /// Takes a clause.
    pub emit: &'a mut dyn FnMut(&[i32]),
}

/// Lists up to this length are excluded pair by pair.
const PAIRWISE: usize = 4;

impl Clauses<'_> {
    /// A clause.
    pub fn clause(&mut self, literals: &[i32]) {
        (self.emit)(literals);
    }

    /// A new variable.
    pub fn fresh(&mut self) -> i32 {
        self.variables += 1;
        self.variables
    }

    /// At most one.
    pub fn at_most_one(&mut self, literals: &[i32]) {
        if literals.len() <= PAIRWISE {
            for (i, &a) in literals.iter().enumerate() {
                literals[..i].iter().for_each(|&b| self.clause(&[-b, -a]));
            }
            return;
        }
        let mut any = literals[0];
        for (i, &next) in literals.iter().enumerate().skip(1) {
            self.clause(&[-any, -next]);
            if i + 1 < literals.len() {
                any = self.or(any, next);
            }
        }
    }

    /// Exactly one.
    pub fn exactly_one(&mut self, literals: &[i32]) {
        self.clause(literals);
        self.at_most_one(literals);
    }

    /// Exactly two.
    pub fn exactly_two(&mut self, literals: &[i32]) {
        // Whether at least one, and at least two, of those so far hold; `None`: surely not.
        let (mut one, mut two): (Option<i32>, Option<i32>) = (None, None);
        for &next in literals {
            if let Some(two) = two {
                self.clause(&[-two, -next]);
            }
            if let Some(one) = one {
                let both = self.and(one, next);
                two = Some(two.map_or(both, |two| self.or(two, both)));
            }
            one = Some(one.map_or(next, |one| self.or(one, next)));
        }
        match two {
            Some(two) => self.clause(&[two]),
            None => self.clause(&[]),
        }
    }

    fn or(&mut self, a: i32, b: i32) -> i32 {
        -self.and(-a, -b)
    }

    fn and(&mut self, a: i32, b: i32) -> i32 {
        let both = self.fresh();
        self.clause(&[-both, a]);
        self.clause(&[-both, b]);
        self.clause(&[both, -a, -b]);
        both
    }
}

impl std::fmt::Debug for Clauses<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Clauses").field("variables", &self.variables).finish_non_exhaustive()
    }
}
