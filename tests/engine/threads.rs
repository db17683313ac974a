//! Threads: the same answer whatever their number and pace, and no panic is swallowed.

use crate::paths::All;
use crate::problems::{Tree, irregular, mix};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tilepack::search::{
    self, Count, Effort, First, Limits, Path, Plan, Problem, Progress, Sink, State, Stop, Values,
    Words,
};

/// Searches the whole tree of a plan.
fn run<S: Sink<Tree>>(
    plan: &mut Plan<'_, Tree>,
    sink: impl Fn() -> S,
) -> (State<Path<Words<1>>, S::Found>, S) {
    let whole = State::whole(&mut plan.problem.clone());
    search::run(plan, whole, sink)
}

fn figures<T, F>(state: &State<T, F>) -> Effort {
    assert!(state.is_complete());
    state.effort()
}

fn plan(tree: Tree, values: Values, threads: usize) -> Plan<'static, Tree> {
    Plan { threads, ..Plan::simple(tree, values) }
}

/// Takes long in some subtrees, so that threads overtake each other.
fn dawdle(choices: &[u32]) {
    if choices.len() == 6 {
        let hash = choices.iter().fold(9, |hash, &choice| mix(hash + u64::from(choice)));
        if hash % 16 == 0 {
            std::thread::sleep(Duration::from_micros(hash % 3000));
        }
    }
}

/// Early subtrees take long, later ones no time: later solutions are found first.
fn slow_start(choices: &[u32]) {
    if choices.len() == 7 && choices[0] < 3 {
        std::thread::sleep(Duration::from_micros(200));
    }
}

/// Has solutions only in a few subtrees.
fn rare(choices: &[u32]) -> u64 {
    let hash =
        choices.iter().fold(3, |hash: u64, &choice| mix(hash.wrapping_mul(7) + u64::from(choice)));
    if choices.len() == 16 && hash % 100_000 != 0 { 0 } else { irregular(choices) }
}

#[test]
fn counts_and_lists_do_not_depend_on_threads() {
    for values in [Values::Lexicographic, Values::Random(1)] {
        let (one, all) = run(&mut plan(Tree::new(13, irregular), values, 1), All::default);
        let mut solutions = all.0;
        solutions.sort_unstable();
        for threads in [2, 3, 8, 8, 8] {
            let tree = Tree { at: dawdle, ..Tree::new(13, irregular) };
            let (several, all) = run(&mut plan(tree, values, threads), All::default);
            assert_eq!(figures(&several), figures(&one));
            let mut others = all.0;
            others.sort_unstable();
            assert!(others == solutions);
        }
    }
}

#[test]
fn the_first_solution_does_not_depend_on_pace() {
    let mut before = 0;
    for seed in 0..6 {
        let values = if seed == 0 { Values::Lexicographic } else { Values::Random(seed) };
        let (one, _) = run(&mut plan(Tree::new(17, rare), values, 1), || First);
        assert!(one.best.is_some());
        before += figures(&one).nodes;
        for (pace, threads) in
            [(dawdle as fn(&[u32]), 3), (slow_start, 8), (slow_start, 2), (|_| {}, 8)]
        {
            let tree = Tree { at: pace, ..Tree::new(17, rare) };
            let (several, _) = run(&mut plan(tree, values, threads), || First);
            assert_eq!(several.best, one.best, "{values:?} {threads}");
            assert_eq!(figures(&several), figures(&one), "{values:?} {threads}");
        }
    }
    assert!(before > 500_000, "only {before} nodes before the first solutions");
}

/// A limit on nodes is never exceeded, and is exact on one thread.
#[test]
fn limits_on_nodes() {
    for nodes in [0, 1, 2, 16_383, 16_384, 16_385, 100_000] {
        for threads in [1, 2, 8] {
            let limits = Limits { nodes, ..Limits::NONE };
            let tree = Tree::new(30, |_| 0b111);
            let mut plan = Plan { limits, ..plan(tree, Values::Lexicographic, threads) };
            let (state, _) = run(&mut plan, || Count);
            assert!(!state.is_complete());
            assert!(state.nodes <= nodes && (threads > 1 || state.nodes == nodes), "{nodes}");
        }
    }
}

/// The fraction done never falls; it and the nodes are reported on the calling thread.
#[test]
fn progress_never_falls() {
    let last = std::sync::Mutex::new((0.0, 0, 0));
    let caller = std::thread::current().id();
    let watch = |progress: &Progress| {
        assert_eq!(std::thread::current().id(), caller);
        let mut last = last.lock().unwrap();
        let now = (progress.fraction, progress.nodes, progress.deepest);
        assert!(now.0 >= last.0 && now.1 >= last.1 && now.2 >= last.2, "{now:?} after {last:?}");
        assert!((0.0..=1.0).contains(&now.0), "{now:?}");
        *last = now;
    };
    let tree = Tree { at: slow_start, ..Tree::new(15, irregular) };
    let (state, _) =
        run(&mut Plan { watch: &watch, ..plan(tree, Values::Lexicographic, 3) }, || Count);
    let (fraction, nodes, _) = *last.lock().unwrap();
    assert!(fraction > 0.0 && nodes > 0 && nodes <= state.nodes);
}

/// The message of the panic of `work`, which must come soon.
fn panic_of(work: impl FnOnce()) -> String {
    let begin = Instant::now();
    let panic = catch_unwind(AssertUnwindSafe(work)).unwrap_err();
    assert!(begin.elapsed() < Duration::from_secs(5), "after {:?}", begin.elapsed());
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap()
}

fn endless(_: &[u32]) -> u64 {
    0b1111
}

#[test]
fn a_panic_of_the_problem_is_passed_on() {
    for threads in [1, 2, 8] {
        let at = |choices: &[u32]| assert!(choices != [0, 1, 2, 3, 3], "broken problem");
        let tree = Tree { at, ..Tree::new(12, endless) };
        let message = panic_of(|| {
            run(&mut plan(tree, Values::Lexicographic, threads), || Count);
        });
        assert_eq!(message, "broken problem");
    }
}

/// Panics at a solution.
struct Fragile<'a>(&'a AtomicU64);

impl<P: Problem> Sink<P> for Fragile<'_> {
    type Found = std::convert::Infallible;

    fn breaks(&self) -> bool {
        false
    }

    fn solution(&mut self, _: &P, _: &[u32]) -> ControlFlow<Self::Found> {
        assert!(self.0.fetch_add(1, Ordering::SeqCst) != 100_000, "broken sink");
        ControlFlow::Continue(())
    }

    fn join(&mut self, _: Self) {}
}

#[test]
fn a_panic_of_the_sink_is_passed_on() {
    for threads in [1, 2, 8] {
        let solutions = AtomicU64::new(0);
        let message = panic_of(|| {
            run(&mut plan(Tree::new(25, endless), Values::Lexicographic, threads), || {
                Fragile(&solutions)
            });
        });
        assert_eq!(message, "broken sink");
    }
}

struct Broken;

impl Stop for Broken {
    fn should_stop(&self) -> bool {
        panic!("broken stop")
    }
}

/// Also of what runs on the calling thread: the others must not go on for ever.
#[test]
fn a_panic_of_the_caller_is_passed_on() {
    for threads in [1, 2] {
        let message = panic_of(|| {
            let watch = |_: &Progress| panic!("broken watch");
            let tree = Tree::new(30, endless);
            run(&mut Plan { watch: &watch, ..plan(tree, Values::Lexicographic, threads) }, || {
                Count
            });
        });
        assert_eq!(message, "broken watch");
        let message = panic_of(|| {
            let limits = Limits { stop: &Broken, nodes: u64::MAX };
            let tree = Tree::new(30, endless);
            run(&mut Plan { limits, ..plan(tree, Values::Lexicographic, threads) }, || Count);
        });
        assert_eq!(message, "broken stop");
    }
}
