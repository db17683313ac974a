//! Clauses, one after another in one list of words, and who watches them.
//!
//! A clause is a word with its length, a word with its worth ([`GIVEN`], or for learned ones how
//! many guesses its literals came from: fewer are better), and its literals. Its first two are
//! watched.
//!
//! Invariant: when all conclusions are drawn, no clause has a false literal among its first two,
//! unless another of its literals has been true at least as long.

use super::Literal;

/// No clause.
pub(super) const NO_CLAUSE: u32 = u32::MAX;
/// The worth of a clause that was not learned.
const GIVEN: u32 = 0;
/// Learned clauses of this worth or better are never forgotten.
const PRECIOUS: u32 = 2;
/// Words before the literals.
const HEAD: usize = 2;

/// Looks at a clause when a literal becomes false; not while another one is true.
#[derive(Debug, Clone, Copy)]
struct Watch {
    clause: u32,
    other: Literal,
}

/// What a clause says when all its other literals are false.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forced {
    pub(super) literal: Literal,
    pub(super) clause: u32,
}

/// Clauses and their watches.
#[derive(Debug, Clone)]
pub(super) struct Clauses {
    words: Vec<u32>,
    /// By literal.
    watches: Vec<Vec<Watch>>,
    learned: usize,
}

impl Clauses {
    pub(super) fn new(variables: usize) -> Self {
        Self { words: Vec::new(), watches: vec![Vec::new(); 2 * variables], learned: 0 }
    }

    /// One more variable.
    pub(super) fn grow(&mut self) {
        self.watches.extend([Vec::new(), Vec::new()]);
    }

    /// How many learned clauses there are.
    pub(super) fn learned(&self) -> usize {
        self.learned
    }

    /// The literals of a clause.
    pub(super) fn literals(&self, clause: u32) -> impl Iterator<Item = Literal> {
        let first = clause as usize + HEAD;
        self.words[first..first + self.length(clause)].iter().map(|&word| Literal(word))
    }

    /// How many literals a clause has.
    pub(super) fn length(&self, clause: u32) -> usize {
        self.words[clause as usize] as usize
    }

    /// One of the literals of a clause.
    pub(super) fn literal(&self, clause: u32, at: usize) -> Literal {
        Literal(self.words[clause as usize + HEAD + at])
    }

    /// Adds a clause of two literals or more, the first two to be watched; the worth, if it was
    /// learned.
    pub(super) fn add(&mut self, literals: &[Literal], worth: Option<u32>) -> u32 {
        let clause = self.words.len() as u32;
        self.words.extend([literals.len() as u32, worth.map_or(GIVEN, |worth| worth.max(1))]);
        self.words.extend(literals.iter().map(|literal| literal.0));
        self.learned += usize::from(worth.is_some());
        self.watch(clause);
        clause
    }

    fn watch(&mut self, clause: u32) {
        let at = clause as usize + HEAD;
        let (a, b) = (Literal(self.words[at]), Literal(self.words[at + 1]));
        self.watches[a.index()].push(Watch { clause, other: b });
        self.watches[b.index()].push(Watch { clause, other: a });
    }

    /// Goes on, from `at`, through the clauses that watch a literal that has become false, to the
    /// next one that forces another literal, or is contradicted.
    pub(super) fn next_forced(
        &mut self,
        lost: Literal,
        at: &mut usize,
        value: &[i8],
    ) -> Option<Forced> {
        let mut watches = std::mem::take(&mut self.watches[lost.index()]);
        let mut forced = None;
        while let Some(&Watch { clause, other }) = watches.get(*at) {
            if value[other.index()] > 0 {
                *at += 1;
                continue;
            }
            let first = clause as usize + HEAD;
            let length = self.words[clause as usize] as usize;
            let literals = &mut self.words[first..first + length];
            if literals[0] == lost.0 {
                literals.swap(0, 1);
            }
            let other = Literal(literals[0]);
            let watch = Watch { clause, other };
            if value[other.index()] > 0 {
                watches[*at] = watch;
                *at += 1;
                continue;
            }
            let next = literals[2..].iter().position(|&word| value[word as usize] >= 0);
            if let Some(next) = next {
                literals.swap(1, next + 2);
                let literal = literals[1] as usize;
                self.watches[literal].push(watch);
                watches.swap_remove(*at);
                continue;
            }
            *at += 1;
            forced = Some(Forced { literal: other, clause });
            break;
        }
        self.watches[lost.index()] = watches;
        forced
    }

    /// Forgets the worse half of what was learned, and all that is always true. To be called
    /// without guesses, all conclusions drawn.
    pub(super) fn forget(&mut self, value: &[i8]) {
        let mut worths: Vec<u32> =
            self.all().map(|at| self.words[at + 1]).filter(|&worth| worth > PRECIOUS).collect();
        worths.sort_unstable();
        let bound = worths.get(worths.len() / 2).copied().unwrap_or(u32::MAX);
        // Of those at the bound, the older ones go.
        let below = worths.partition_point(|&worth| worth < bound);
        let upto = worths.partition_point(|&worth| worth <= bound);
        let mut spare = upto - worths.len().div_ceil(2).clamp(below, upto);
        let old = std::mem::take(&mut self.words);
        self.watches.iter_mut().for_each(Vec::clear);
        self.learned = 0;
        let mut at = 0;
        while at < old.len() {
            let (length, worth) = (old[at] as usize, old[at + 1]);
            let literals = &old[at + HEAD..at + HEAD + length];
            at += HEAD + length;
            if literals.iter().any(|&word| value[word as usize] > 0) || worth > bound {
                continue;
            }
            if worth == bound && spare > 0 {
                spare -= 1;
                continue;
            }
            let open = literals.iter().filter(|&&word| value[word as usize] == 0);
            let open: Vec<Literal> = open.map(|&word| Literal(word)).collect();
            self.add(&open, (worth != GIVEN).then_some(worth));
        }
    }

    /// Where clauses begin.
    fn all(&self) -> impl Iterator<Item = usize> {
        let mut at = 0;
        std::iter::from_fn(move || {
            let begin = at;
            let length = *self.words.get(begin)?;
            at += HEAD + length as usize;
            Some(begin)
        })
    }
}
