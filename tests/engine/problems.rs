//! Problems to try the search on: all types of packing problem, and bare trees.

use tilepack::packing::corner::Corner;
use tilepack::packing::reduction::Reduction;
use tilepack::packing::wang::{Shown, Wang};
use tilepack::packing::{Labeled, Task, ring, rule, wang_rule};
use tilepack::search::{Alternatives, Problem, Words};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Kind, TileSet, notation};

/// A task: kind, colors, set, size, automorphism (or none); with spare cells a covering.
pub(crate) fn task(words: [&str; 5]) -> Task {
    let [kind, colors, members, size, automorphism] = words;
    let members = notation::parse_members(members).unwrap().unwrap();
    let set = TileSet::new(kind.parse().unwrap(), colors.parse().unwrap(), members).unwrap();
    let shape = size.parse().unwrap();
    let mut task = Task::new(set, shape);
    task.cover = task.shape.cells() as u64 > task.set.size();
    if !automorphism.is_empty() {
        let parsed = Automorphism::parse(automorphism, task.set.colors(), shape).unwrap();
        task.automorphism = Some(parsed);
    }
    task.check().unwrap();
    task
}

/// Something to do with any type of problem.
pub(crate) trait Visitor {
    fn visit<P: Labeled>(&mut self, problem: P);
}

/// Makes the problem of a task, as small and as large in words as it may be.
pub(crate) fn with_problem(task: &Task, reduce: bool, visitor: &mut impl Visitor) {
    let reduction = if reduce { Reduction::full(task) } else { Reduction::none() };
    match task.set.kind() {
        Kind::Corner => {
            with_corner::<1, 4, 64, 512>(task, &reduction, visitor);
            with_corner::<2, 8, 512, 8192>(task, &reduction, visitor);
        }
        Kind::Wang => {
            with_wang::<1, 128>(task, &reduction, Shown::Both, visitor);
            with_wang::<4, 512>(task, &reduction, Shown::Both, visitor);
        }
        Kind::Domino => {
            let reduction = ring::reduction(task, &reduction).unwrap();
            with_wang::<1, 128>(&ring::task(task).unwrap(), &reduction, ring::shown(task), visitor);
        }
    }
}

fn with_corner<const W: usize, const C: usize, const ROWS: usize, const L: usize>(
    task: &Task,
    reduction: &Reduction,
    visitor: &mut impl Visitor,
) {
    let spare = task.shape.cells() as u64 - task.set.size();
    let compact = task.set.is_compact();
    if task.cover {
        let law = |rows| rule::Cover::<ROWS>::new(rows, spare, compact.then_some(2));
        let problem = Corner::<_, W, C, L, true>::new(task, reduction, law);
        visitor.visit(problem.unwrap().unwrap());
    } else if compact {
        let law = rule::Pairs::<ROWS>::new;
        let problem = Corner::<_, W, C, L, true>::new(task, reduction, law);
        visitor.visit(problem.unwrap().unwrap());
        if task.automorphism.is_none() {
            let small = Corner::<_, W, C, L, false>::new(task, reduction, law);
            visitor.visit(small.unwrap().unwrap());
        }
    } else {
        let law = rule::Once::<ROWS>::new;
        let problem = Corner::<_, W, C, L, true>::new(task, reduction, law);
        visitor.visit(problem.unwrap().unwrap());
        if task.automorphism.is_none() {
            let small = Corner::<_, W, C, L, false>::new(task, reduction, law);
            visitor.visit(small.unwrap().unwrap());
        }
    }
}

fn with_wang<const N: usize, const L: usize>(
    task: &Task,
    reduction: &Reduction,
    shown: Shown,
    visitor: &mut impl Visitor,
) {
    let (set, colors) = (&task.set, task.set.colors());
    let tiles = set.allowed().count();
    let class = || -> Vec<u32> {
        let of = |tile| {
            let [n, _, _, w] = set.kind().unpack(tile, colors).map(u32::from);
            n * colors.vertical() as u32 + w
        };
        set.allowed().map(of).collect()
    };
    let spare = task.shape.cells() as u64 - set.size();
    if task.cover {
        let law = wang_rule::Cover::<N>::new(tiles, spare, set.is_compact().then(class));
        visitor.visit(Wang::<N, L, _, true>::new(task, reduction, shown, law).unwrap().unwrap());
    } else if set.is_compact() {
        let law = wang_rule::Pairs::<N>::new(class());
        visitor.visit(Wang::<N, L, _, true>::new(task, reduction, shown, law).unwrap().unwrap());
    } else {
        let law = wang_rule::Once::<N, L>::new(tiles);
        visitor.visit(
            Wang::<N, L, _, true>::new(task, reduction, shown, law.clone()).unwrap().unwrap(),
        );
        if task.automorphism.is_none() {
            let small = Wang::<N, L, _, false>::new(task, reduction, shown, law);
            visitor.visit(small.unwrap().unwrap());
        }
    }
}

/// All kinds of problems, small ones.
pub(crate) const SMALL: &[[&str; 5]] = &[
    ["corner", "2", "complete", "4x4", ""],
    ["corner", "3", "complete", "9x9", ""],
    ["corner", "3", "complete", "9x9", "3,0:+1"],
    ["corner", "2", "complete", "4x4", "2,2:1,0"],
    ["corner", "3", "pruned:0-1", "31x1", ""],
    ["corner", "3", "pruned:0-1", "11x3", ""],
    ["corner", "3", "compact", "9x6", ""],
    ["corner", "3", "compact", "9x6", "3,0:+1"],
    ["corner", "2", "compact", "6x3", ""],
    ["corner", "2", "complete", "6x3", "3,0:0,1"],
    ["wang", "2", "complete", "4x4", ""],
    ["wang", "2", "complete", "4x4", "2,0:1,0"],
    ["wang", "2,3", "complete", "9x4", ""],
    ["wang", "2", "compact", "4x2", ""],
    ["wang", "2", "compact", "4x2", "0,1:1,0"],
    ["wang", "2", "compact", "3x3", ""],
    ["wang", "2", "compact", "5x2", "0,1:1,0"],
    ["wang", "2", "complete", "6x3", "3,0:1,0/0,1"],
    ["domino", "4", "complete", "16x1", ""],
    ["domino", "4", "complete", "1x18", ""],
    ["domino", "2", "complete", "6x1", "3,0:+0"],
];

/// A bare tree given by a function: what lies below a node, from the choices that lead to it.
#[derive(Clone)]
pub(crate) struct Tree {
    pub(crate) levels: usize,
    /// The alternatives after some choices.
    pub(crate) below: fn(&[u32]) -> u64,
    /// Called with all choices after each push: to dawdle, or to panic.
    pub(crate) at: fn(&[u32]),
    pub(crate) choices: Vec<u32>,
}

impl Tree {
    pub(crate) fn new(levels: usize, below: fn(&[u32]) -> u64) -> Self {
        Self { levels, below, at: |_| {}, choices: Vec::new() }
    }
}

impl Problem for Tree {
    type Alternatives = Words<1>;

    fn levels(&self) -> usize {
        self.levels
    }

    fn alternatives(&mut self, level: usize) -> Words<1> {
        assert_eq!(level, self.choices.len());
        Words([(self.below)(&self.choices)])
    }

    fn push(&mut self, level: usize, choice: u32) {
        assert_eq!(level, self.choices.len());
        assert!(Words([(self.below)(&self.choices)]).contains(choice));
        self.choices.push(choice);
        (self.at)(&self.choices);
    }

    fn pop(&mut self, level: usize, choice: u32) {
        assert_eq!(self.choices.pop(), Some(choice));
        assert_eq!(level, self.choices.len());
    }
}

/// A number that looks random.
pub(crate) fn mix(x: u64) -> u64 {
    let x = (x ^ (x >> 31)).wrapping_mul(0x7fb5_d329_728e_a185);
    let x = (x ^ (x >> 27)).wrapping_mul(0x81da_def4_bc2d_d44d);
    x ^ (x >> 33)
}

fn hash(choices: &[u32]) -> u64 {
    choices.iter().fold(1, |hash, &choice| mix(hash.wrapping_mul(31) + u64::from(choice) + 1))
}

/// An irregular tree of some 200,000 nodes: no, one or several of six alternatives, many dead
/// ends, some very lopsided.
pub(crate) fn irregular(choices: &[u32]) -> u64 {
    let hash = hash(choices);
    match (choices.len(), hash % 8) {
        (0, _) => 0b11_1111,
        (_, 0) => 0,
        (_, 1..=2) => 1 << ((hash >> 8) % 6),
        (_, 3) => 0b11_1111,
        _ => (hash >> 20) & 0b11_1011,
    }
}
