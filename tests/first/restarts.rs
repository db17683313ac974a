//! Searches begun again: against the same runs made one after the other, on any number of threads.

use tilepack::packing::{self, Job, Question, Restarted, Settings, Task};
use tilepack::search::restarts::{Restarts, luby};
use tilepack::search::{Limits, Stop};
use tilepack::tiles::{TileSet, notation};
use tilepack::torus::Shape;
use tilepack::verify;

fn job(kind: &str, colors: &str, members: &str, size: &str) -> Job {
    let members = notation::parse_members(members).unwrap().unwrap();
    let set = TileSet::new(kind.parse().unwrap(), colors.parse().unwrap(), members).unwrap();
    let shape = match size {
        "" => Shape::default_for(&set).unwrap(),
        size => size.parse().unwrap(),
    };
    Job::new(Task::new(set, shape), Question::First)
}

fn restarting(job: &Job, restarts: Restarts, threads: usize, limits: &Limits<'_>) -> Restarted {
    packing::find_restarting(job, restarts, threads, limits).unwrap()
}

/// One run after the other by the search that knows nothing of restarts: the run, what it came
/// to, and the nodes of all.
fn one_by_one(job: &Job, restarts: Restarts) -> (u64, Option<Vec<u8>>, u64) {
    let mut nodes = 0;
    for run in 0.. {
        let most = restarts.unit * luby(run + 1);
        let job = Job { values: restarts.values(run), ..job.clone() };
        let limits = Limits { stop: &(), nodes: most };
        let answer = packing::find(job, &Settings { limits, ..Settings::PLAIN }).unwrap();
        nodes += answer.work.nodes;
        if answer.work.complete {
            return (run, answer.value, nodes);
        }
        assert_eq!(answer.work.nodes, most);
    }
    unreachable!()
}

#[test]
fn as_one_run_after_the_other_on_any_number_of_threads() {
    let mut later = 0;
    for (kind, colors, members, size, unit) in [
        ("corner", "2", "complete", "", 10),
        ("corner", "3", "complete", "", 3000),
        ("corner", "3", "compact", "9x6", 700),
        ("wang", "2,3", "complete", "", 2000),
        ("wang", "3", "compact", "", 300),
        ("domino", "5", "complete", "", 7),
    ] {
        let job = job(kind, colors, members, size);
        for seed in 0..4 {
            let restarts = Restarts { unit, seed };
            let (run, labels, nodes) = one_by_one(&job, restarts);
            later += u64::from(run > 2);
            for threads in [1, 2, 5] {
                let found = restarting(&job, restarts, threads, &Limits::NONE);
                assert_eq!((found.run, &found.labels, found.nodes), (run, &labels, nodes));
                assert!(!found.none);
            }
            let (labels, task) = (labels.unwrap(), &job.task);
            let packing = task.lattice().packing(&labels, &task.set, false);
            assert!(verify::check(&packing).is_valid());
        }
    }
    assert!(later > 3, "few were begun again");
}

#[test]
fn a_run_that_sees_the_whole_tree_ends_it() {
    // 60 tiles without a packing: a tree of some two thousand nodes.
    let job = job("corner", "4", "pruned:0-1,2-3", "4x15");
    for threads in [1, 3] {
        let ended = restarting(&job, Restarts { unit: 100, seed: 1 }, threads, &Limits::NONE);
        assert!(ended.none && ended.labels.is_none() && ended.run > 0, "{ended:?}");
    }
}

#[test]
fn limits_end_what_finds_nothing() {
    struct Now;
    impl Stop for Now {
        fn should_stop(&self) -> bool {
            true
        }
    }
    let job = job("corner", "5", "complete", "");
    for threads in [1, 2] {
        let restarts = Restarts { unit: 1000, seed: 0 };
        let few = Limits { stop: &(), nodes: 100_000 };
        let stopped = restarting(&job, restarts, threads, &few);
        assert!(!stopped.none && stopped.labels.is_none() && stopped.nodes >= 100_000);
        assert!(stopped.run > 10 && stopped.deepest > 30 && stopped.levels == 621, "{stopped:?}");
        let now = restarting(&job, restarts, threads, &Limits { stop: &Now, nodes: u64::MAX });
        assert_eq!((now.nodes, now.run, now.labels), (0, 0, None));
    }
}
