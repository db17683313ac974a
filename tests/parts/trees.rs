//! Random trees.

use std::convert::Infallible;
use std::ops::ControlFlow;
use tilepack::search::{Alternatives, Part, Plan, Problem, Sink, State, Values, Words, run};

/// A tree made by a seed: up to five alternatives to a node, many dead ends, lopsided.
#[derive(Debug, Clone)]
pub(crate) struct Tree {
    pub(crate) levels: usize,
    pub(crate) seed: u64,
    choices: Vec<u32>,
}

/// A number that looks random.
fn mix(x: u64) -> u64 {
    let x = (x ^ (x >> 31)).wrapping_mul(0x7fb5_d329_728e_a185);
    let x = (x ^ (x >> 27)).wrapping_mul(0x81da_def4_bc2d_d44d);
    x ^ (x >> 33)
}

impl Tree {
    pub(crate) fn new(levels: usize, seed: u64) -> Self {
        Self { levels, seed, choices: Vec::new() }
    }

    fn below(&self) -> u64 {
        let start = mix(self.seed ^ 0x5eed);
        let number = self
            .choices
            .iter()
            .fold(start, |number, &choice| mix(number.wrapping_mul(31) + u64::from(choice) + 1));
        match number % 8 {
            0 => 0,
            1 | 2 => 1 << ((number >> 8) % 5),
            3 => 0b1_1111,
            _ => (number >> 20) & 0b1_1011,
        }
    }
}

impl Problem for Tree {
    type Alternatives = Words<1>;

    fn levels(&self) -> usize {
        self.levels
    }

    fn alternatives(&mut self, level: usize) -> Words<1> {
        assert_eq!(level, self.choices.len());
        Words([self.below()])
    }

    fn push(&mut self, level: usize, choice: u32) {
        assert_eq!(level, self.choices.len());
        assert!(Words([self.below()]).contains(choice));
        self.choices.push(choice);
    }

    fn pop(&mut self, level: usize, choice: u32) {
        assert_eq!(self.choices.pop(), Some(choice));
        assert_eq!(level, self.choices.len());
    }
}

/// What a search came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Came {
    /// The choices of all solutions, sorted.
    pub(crate) solutions: Vec<Vec<u32>>,
    pub(crate) nodes: u64,
    pub(crate) deepest: usize,
}

#[derive(Default)]
struct All(Vec<Vec<u32>>);

impl<P: Problem> Sink<P> for All {
    type Found = Infallible;

    fn breaks(&self) -> bool {
        false
    }

    fn solution(&mut self, _: &P, choices: &[u32]) -> ControlFlow<Infallible> {
        self.0.push(choices.to_vec());
        ControlFlow::Continue(())
    }

    fn join(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

/// How to walk: it must make no difference.
#[derive(Debug, Clone, Copy)]
pub(crate) struct How {
    pub(crate) threads: usize,
    pub(crate) values: Values,
}

impl How {
    pub(crate) const PLAIN: Self = Self { threads: 1, values: Values::Lexicographic };

    fn over<P: Problem>(
        self,
        problem: P,
        part: Option<Part>,
        state: State<tilepack::search::Path<P::Alternatives>, Infallible>,
    ) -> Came {
        let threads = self.threads;
        let mut plan = Plan { threads, part, ..Plan::simple(problem, self.values) };
        let (state, All(mut solutions)) = run(&mut plan, state, All::default);
        assert!(state.is_complete());
        assert_eq!(state.solutions, solutions.len() as u64);
        solutions.sort_unstable();
        Came { solutions, nodes: state.nodes, deepest: state.deepest }
    }

    pub(crate) fn whole(self, mut tree: Tree) -> Came {
        let state = State::whole(&mut tree);
        self.over(tree, None, state)
    }

    /// A part; nodes above the frontier included.
    pub(crate) fn part(self, tree: &Tree, part: Part) -> Came {
        let mut problem = tree.clone();
        let state = State::part(&mut problem, part);
        self.over(problem, Some(part), state)
    }
}
