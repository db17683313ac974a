//! Paths: parts of a tree, and the measure of what remains.

use crate::problems::{Tree, irregular, mix};
use std::cell::RefCell;
use std::ops::ControlFlow;
use tilepack::search::{
    Count, First, Limits, Path, Plan, Sink, Slice, State, Values, Walk, Words, run,
};

/// Keeps all solutions.
#[derive(Default)]
pub(crate) struct All(pub(crate) Vec<Vec<u32>>);

impl<P: tilepack::search::Problem> Sink<P> for All {
    type Found = std::convert::Infallible;

    fn breaks(&self) -> bool {
        false
    }

    fn solution(&mut self, _: &P, choices: &[u32]) -> ControlFlow<Self::Found> {
        self.0.push(choices.to_vec());
        ControlFlow::Continue(())
    }

    fn join(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

fn tree() -> Tree {
    Tree::new(12, irregular)
}

fn walked(path: Path<Words<1>>, values: Values) -> (u64, Vec<Vec<u32>>) {
    let mut walk = Walk::new(tree(), values, path);
    let mut all = All::default();
    assert_eq!(walk.run(u64::MAX, &mut all), Slice::Exhausted);
    assert!(walk.path().is_exhausted());
    assert_eq!(walk.solutions, all.0.len() as u64);
    (walk.nodes, all.0)
}

/// The number of nodes and the solutions by plain recursion.
fn by_recursion(choices: &mut Vec<u32>, solutions: &mut Vec<Vec<u32>>) -> u64 {
    if choices.len() == tree().levels {
        solutions.push(choices.clone());
        return 0;
    }
    let open = irregular(choices);
    let mut nodes = 0;
    for choice in (0..64).filter(|choice| open >> choice & 1 == 1) {
        choices.push(choice);
        nodes += 1 + by_recursion(choices, solutions);
        choices.pop();
    }
    nodes
}

#[test]
fn a_walk_is_a_recursion() {
    let mut solutions = Vec::new();
    let nodes = by_recursion(&mut Vec::new(), &mut solutions);
    assert!(nodes > 50_000 && solutions.len() > 1000, "{nodes} {}", solutions.len());
    let whole = walked(Path::root(&mut tree()), Values::Lexicographic);
    assert_eq!(whole, (nodes, solutions.clone()));
    let (random_nodes, mut random) = walked(Path::root(&mut tree()), Values::Random(5));
    assert_eq!(random_nodes, nodes);
    assert_ne!(random, solutions);
    random.sort_unstable();
    assert_eq!(random, solutions);
}

/// Splits at random places of a walk, again and again: the parts, in order, are the whole.
#[test]
fn parts_add_up_to_the_whole() {
    for values in [Values::Lexicographic, Values::Random(3)] {
        let whole = walked(Path::root(&mut tree()), values);
        for seed in 0..20 {
            let mut random = mix(seed + 100);
            let mut draw = |below: u64| {
                random = mix(random.wrapping_add(0x9e37_79b9_7f4a_7c15));
                (random >> 16) % below
            };
            // What has been walked, and the parts to come, the next one last.
            let (mut nodes, mut all) = (0, All::default());
            let mut parts = vec![Path::root(&mut tree())];
            let mut splits = 0;
            while let Some(part) = parts.pop() {
                let mut walk = Walk::new(tree(), values, part);
                let mut given = Vec::new();
                loop {
                    let slice = walk.run(draw(1000), &mut all);
                    if slice == Slice::Exhausted {
                        break;
                    }
                    let before = walk.remaining();
                    if let Some(path) = (splits < 200).then(|| walk.split()).flatten() {
                        splits += 1;
                        assert!(!path.is_exhausted() && !walk.path().is_exhausted());
                        let after = walk.remaining();
                        let gone = Walk::new(tree(), values, path.clone()).remaining();
                        assert!((before - after - gone).abs() < 1e-12, "{before} {after} {gone}");
                        given.push(path);
                    }
                }
                nodes += walk.nodes;
                // Given later means visited earlier.
                parts.extend(given);
            }
            assert!(splits > 10, "{splits} splits");
            // In this order the solutions come out exactly as in the undivided walk.
            assert!(nodes == whole.0 && all.0 == whole.1, "seed {seed} {values:?}");
        }
    }
}

#[test]
fn what_remains_falls_from_1_to_0() {
    for values in [Values::Lexicographic, Values::Random(8)] {
        let mut walk = Walk::whole(tree(), values);
        assert_eq!(walk.remaining(), 1.0);
        let (mut last, mut all) = (1.0, All::default());
        while walk.run(37, &mut all) == Slice::Paused {
            let remaining = walk.remaining();
            assert!((0.0..=last + 1e-12).contains(&remaining), "{remaining} after {last}");
            last = remaining;
        }
        assert_eq!(walk.remaining(), 0.0);
    }
}

thread_local! {
    static PUSHED: RefCell<Vec<u32>> = const { RefCell::new(Vec::new()) };
}

/// The start of a path is the next node.
#[test]
fn starts_are_the_next_nodes() {
    let at = |choices: &[u32]| PUSHED.with_borrow_mut(|pushed| *pushed = choices.to_vec());
    for values in [Values::Lexicographic, Values::Random(2)] {
        let mut walk = Walk::whole(Tree { at, ..tree() }, values);
        while walk.run(501, &mut Count) == Slice::Paused {
            let start = walk.path().start(values);
            walk.run(1, &mut Count);
            PUSHED.with_borrow(|pushed| assert_eq!(*pushed, start));
        }
    }
}

/// Searches all of a small tree.
fn searched<S: Sink<Tree>>(
    tree: Tree,
    threads: usize,
    limits: Limits<'_>,
    sink: fn() -> S,
) -> (State<Path<Words<1>>, S::Found>, S) {
    let whole = State::whole(&mut tree.clone());
    let mut plan = Plan { threads, limits, ..Plan::simple(tree, Values::Lexicographic) };
    run(&mut plan, whole, sink)
}

#[test]
fn a_problem_without_levels_has_one_solution() {
    let tree = || Tree::new(0, |_| 0);
    for threads in [1, 2, 8] {
        let (state, all) = searched(tree(), threads, Limits::NONE, All::default);
        assert!(state.is_complete());
        assert_eq!((state.nodes, state.solutions, state.deepest), (0, 1, 0));
        assert_eq!(all.0, [Vec::<u32>::new()]);
        let (state, _) = searched(tree(), threads, Limits::NONE, || First);
        assert!(state.is_complete());
        assert_eq!(state.best.map(|best| best.found), Some(Vec::new()));
    }
    // Nothing is visited under a limit of no nodes, and nothing lost.
    let limits = Limits { nodes: 0, ..Limits::NONE };
    let (state, _) = searched(tree(), 1, limits, || Count);
    assert_eq!(state.solutions + state.left.len() as u64, 1);
}

#[test]
fn a_problem_without_alternatives_has_none() {
    for threads in [1, 8] {
        let (state, _) = searched(Tree::new(3, |_| 0), threads, Limits::NONE, || Count);
        assert!(state.is_complete());
        assert_eq!((state.nodes, state.solutions, state.deepest), (0, 0, 0));
    }
}
