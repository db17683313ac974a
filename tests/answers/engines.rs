//! Every way to search: whatever the order, the values, the threads and the reduction, the
//! answer must be the same, and the number of nodes must depend on the tree alone.

use crate::oracle;
use std::collections::BTreeMap;
use tilepack::packing::solve::SolveError;
use tilepack::packing::{Answer, Job, Settings, Task, TaskError, count, find, list};
use tilepack::search::Values;
use tilepack::symmetry::{Group, burnside};
use tilepack::torus::Order;
use tilepack::verify;

/// One way to search.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Engine {
    pub(crate) order: Option<Order>,
    pub(crate) values: Values,
    pub(crate) threads: usize,
    pub(crate) reduce: bool,
}

/// How many ways are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Effort {
    /// Every combination.
    All,
    /// Every value of each of the four, the others being plain.
    Each,
    /// Reduced searches in the order of rows only.
    Reduced,
}

const PLAIN: Engine =
    Engine { order: None, values: Values::Lexicographic, threads: 1, reduce: true };

impl Engine {
    pub(crate) fn settings(self) -> Settings<'static> {
        Settings { threads: self.threads, ..Settings::PLAIN }
    }

    pub(crate) fn job(self, task: &Task) -> Job {
        let Self { values, reduce, order, .. } = self;
        Job { values, reduce, ..Job::from(&Task { order, ..task.clone() }) }
    }
}

pub(crate) fn engines(effort: Effort) -> Vec<Engine> {
    let orders: Vec<_> = Order::ALL.into_iter().map(Some).chain([None]).collect();
    let values = [Values::Lexicographic, Values::Random(1)];
    let mut all = Vec::new();
    for &order in &orders {
        for values in values {
            for threads in [1, 2, 3, 8] {
                for reduce in [true, false] {
                    all.push(Engine { order, values, threads, reduce });
                }
            }
        }
    }
    let differs = |engine: &Engine| {
        let Engine { order, values, threads, reduce } = *engine;
        [order.is_some(), values != PLAIN.values, threads != 1, !reduce]
    };
    match effort {
        Effort::All => {}
        Effort::Each => all.retain(|e| differs(e).iter().filter(|&&d| d).count() <= 1),
        Effort::Reduced => all.retain(|e| {
            let [order, _, _, whole] = differs(e);
            !order && !whole
        }),
    }
    all
}

/// The answer; `None` when the pins are refused as contradictory, so that there is nothing.
fn answer<T>(given: Result<Answer<T>, SolveError>, task: &Task, what: &str) -> Option<Answer<T>> {
    match given {
        Err(SolveError::Task(TaskError::Pins(_))) if task.has_pins() => None,
        given => {
            let given = given.unwrap_or_else(|error| panic!("{what}: {error}"));
            assert!(given.work.complete, "{what}");
            Some(given)
        }
    }
}

/// The number of packings by every engine, which must agree; `what` is named in messages.
pub(crate) fn agreed_count(task: &Task, effort: Effort, what: &str) -> u64 {
    let mut agreed = None;
    let mut trees = BTreeMap::new();
    for engine in engines(effort) {
        let counted = count(engine.job(task), &engine.settings(), false);
        let (packings, work) = match answer(counted, task, what) {
            None => (0, None),
            Some(counted) => {
                let packings: u64 = counted.value.packings.try_into().unwrap();
                (packings, Some((counted.work.nodes, counted.work.deepest)))
            }
        };
        assert_eq!(packings, *agreed.get_or_insert(packings), "{what} {engine:?}");
        let tree = (format!("{:?}", engine.order), engine.reduce);
        assert_eq!(work, *trees.entry(tree).or_insert(work), "nodes: {what} {engine:?}");
    }
    agreed.unwrap()
}

/// Checks a packing found from the definition.
pub(crate) fn verify(task: &Task, labels: &[u8], what: &str) {
    let verdict = verify::check(&task.lattice().packing(labels, &task.set, task.cover));
    assert!(verdict.is_valid(), "{what}: {labels:?}: {verdict}");
}

/// That the first packing is one, and the same for any number of threads.
pub(crate) fn check_first(task: &Task, exists: bool, effort: Effort, what: &str) {
    let mut firsts = BTreeMap::new();
    for engine in engines(effort) {
        let found = find(engine.job(task), &engine.settings());
        let Some(found) = answer(found, task, what) else {
            assert!(!exists, "{what}");
            continue;
        };
        assert_eq!(found.value.is_some(), exists, "{what} {engine:?}");
        if let Some(labels) = &found.value {
            verify(task, labels, what);
        }
        let walk = format!("{:?} {:?} {}", engine.order, engine.values, engine.reduce);
        let first = (found.value, found.work.nodes);
        assert_eq!(first, *firsts.entry(walk).or_insert(first.clone()), "{what} {engine:?}");
    }
}

/// The list of all packings by several engines: sorted, different, right, and as many as
/// counted.
pub(crate) fn agreed_list(task: &Task, effort: Effort, what: &str) -> Vec<Vec<u8>> {
    let mut agreed: Option<Vec<Vec<u8>>> = None;
    for engine in engines(effort) {
        let listed = list(engine.job(task), &engine.settings(), false);
        let listed = answer(listed, task, what).map_or_else(Vec::new, |answer| answer.value);
        match &agreed {
            Some(first) => assert!(listed == *first, "list: {what} {engine:?}"),
            None => {
                assert!(listed.windows(2).all(|pair| pair[0] < pair[1]), "{what}");
                listed.iter().for_each(|labels| verify(task, labels, what));
                agreed = Some(listed);
            }
        }
    }
    agreed.unwrap()
}

/// The number of packings up to symmetry by several engines.
pub(crate) fn agreed_orbits(task: &Task, effort: Effort, what: &str) -> u64 {
    let mut agreed = None;
    let mut forms: Option<Vec<Vec<u8>>> = None;
    for engine in engines(effort) {
        let job = engine.job(task);
        let counted = count(job.clone(), &engine.settings(), true).unwrap().value;
        let orbits = counted.fundamental.unwrap();
        assert_eq!(orbits, *agreed.get_or_insert(orbits), "{what} {engine:?}");
        let listed = list(job, &engine.settings(), true).unwrap().value;
        assert_eq!(listed.len() as u64, orbits, "{what} {engine:?}");
        listed.iter().for_each(|labels| verify(task, labels, what));
        // The representative depends on what the reduction puts at the origin.
        if engine.reduce {
            assert!(*forms.get_or_insert(listed.clone()) == listed, "{what} {engine:?}");
        }
    }
    agreed.unwrap()
}

/// Everything about a task that the oracle can handle too.
pub(crate) fn check_against_oracle(task: &Task, effort: Effort, what: &str) -> u64 {
    let packings = oracle::all(task);
    packings.iter().for_each(|labels| verify(task, labels, what));
    let count = packings.len() as u64;
    assert_eq!(agreed_count(task, effort, what), count, "{what}");
    check_first(task, count > 0, Effort::Each, what);
    assert!(agreed_list(task, Effort::Each, what) == packings, "{what}");
    if let Some(argument) = task.impossible() {
        assert_eq!(count, 0, "{what}: {argument}");
    }
    if !task.has_pins() {
        let group = Group::of(&task.set, task.shape, task.automorphism.as_ref()).unwrap();
        let orbits = burnside(&group, &packings).unwrap();
        assert_eq!(orbits, agreed_orbits(task, Effort::Reduced, what).into(), "{what}");
    }
    count
}
