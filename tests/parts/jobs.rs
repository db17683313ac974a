//! The same for problems of every kind and every question, as plans and results in memory.

use crate::result;
use tilepack::cluster::merge;
use tilepack::packing::solve::{Answer, Counted, Work, counted, listed};
use tilepack::packing::{self, Cut, Job, Question, Settings, Standing, Task, frontier};
use tilepack::search::Values;
use tilepack::store::{PartResult, SearchPlan};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{TileSet, notation};

/// Kind, colors, set, size, automorphism (or none); with spare cells a covering.
const TASKS: &[[&str; 5]] = &[
    ["corner", "2", "complete", "4x4", ""],
    ["corner", "2", "complete", "4x4", "2,2:1,0"],
    ["corner", "2", "compact", "4x4", ""],
    ["corner", "2", "complete", "6x3", "3,0:0,1"],
    ["corner", "1", "complete", "1x1", ""],
    ["corner", "2", "complete", "2x8", ""],
    ["wang", "2", "complete", "4x4", "2,0:1,0"],
    ["wang", "1,3", "complete", "9x1", ""],
    ["wang", "2", "compact", "4x2", ""],
    ["wang", "2", "compact", "4x2", "0,1:1,0"],
    ["wang", "2", "pruned:0-1", "1x2", ""],
    ["domino", "3", "complete", "9x1", ""],
    ["domino", "2", "complete", "1x6", ""],
    ["domino", "2", "complete", "6x1", "3,0:+0"],
];

fn task(words: [&str; 5]) -> Task {
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

fn questions() -> impl Iterator<Item = Question> {
    [false, true].into_iter().flat_map(|up_to_symmetry| {
        [Question::Count { up_to_symmetry }, Question::List { up_to_symmetry }]
    })
}

fn plan(job: &Job, cut: Cut, parts: u64) -> SearchPlan {
    let frontier = frontier(job, cut).unwrap();
    SearchPlan { job: job.clone(), parts, frontier, name: "a plan".into() }
}

/// The answer of a search: what is counted, what is listed, and the work.
type Whole = (Answer<Counted>, Vec<Vec<u8>>);

fn answer(job: &Job, mut standing: Standing) -> Whole {
    let kept = std::mem::take(&mut standing.kept);
    let value = counted(job, &standing).unwrap();
    (Answer { value, work: Work::of(&standing) }, listed(job, kept))
}

fn undivided(job: &Job) -> Whole {
    answer(job, packing::run(job, None, &Settings::PLAIN).unwrap())
}

fn merged(plan: &SearchPlan, results: Vec<PartResult>) -> Whole {
    let kept = results.iter().flat_map(|result| result.standing.kept.clone()).collect();
    let results = results.into_iter().map(|result| (format!("{}", result.number).into(), result));
    let merged = merge(plan, results.collect()).unwrap();
    assert!(merged.missing.is_empty());
    answer(&plan.job, Standing { kept, ..merged.standing })
}

fn all(plan: &SearchPlan) -> Vec<PartResult> {
    (0..plan.parts).map(|number| result(plan, number)).collect()
}

#[test]
fn parts_of_every_kind_of_search_are_the_whole() {
    for &words in TASKS {
        for question in questions() {
            for (reduce, values) in [(true, Values::Lexicographic), (true, Values::Random(3))] {
                let job = Job { reduce, values, ..Job::new(task(words), question) };
                let whole = undivided(&job);
                for (cut, parts) in [
                    (Cut::Depth(1), 2),
                    (Cut::Depth(3), 5),
                    (Cut::Depth(1000), 3),
                    (Cut::Nodes(20), 1),
                    (Cut::Nodes(20), 7),
                    (Cut::Nodes(3), 100),
                ] {
                    let plan = plan(&job, cut, parts);
                    let parts = merged(&plan, all(&plan));
                    assert!(parts == whole, "{words:?} {question:?} {cut:?} {parts:?} {whole:?}");
                }
            }
        }
    }
}

#[test]
fn without_symmetry_removed() {
    for words in [["corner", "2", "complete", "4x4", ""], ["wang", "1,3", "complete", "9x1", ""]] {
        for question in questions() {
            let job = Job { reduce: false, ..Job::new(task(words), question) };
            let plan = plan(&job, Cut::Nodes(50), 4);
            assert!(merged(&plan, all(&plan)) == undivided(&job), "{words:?} {question:?}");
        }
    }
}

/// What is a property of a part alone; packings sorted.
fn own(plan: &SearchPlan, results: &[PartResult]) -> (u64, u64, u64, String, Vec<Vec<u8>>) {
    let mut sum = (0, 0, 0, orbit_sizes(results), Vec::new());
    for PartResult { standing, .. } in results {
        sum.0 += standing.state.solutions;
        sum.1 += standing.state.nodes - plan.frontier.above;
        sum.2 += standing.orbits;
        sum.4.extend(standing.kept.iter().cloned());
    }
    sum.4.sort_unstable();
    sum
}

fn orbit_sizes(results: &[PartResult]) -> String {
    let sizes = results.iter().map(|result| &result.standing.orbit_sizes);
    sizes.fold(Standing::nothing().orbit_sizes, |sum, size| sum + size).to_string()
}

#[test]
fn a_plan_is_refined_by_one_of_a_multiple_of_parts() {
    for &words in TASKS {
        for question in questions() {
            let job = Job::new(task(words), question);
            let coarse = plan(&job, Cut::Nodes(30), 3);
            let fine = plan(&job, Cut::Nodes(30), 12);
            assert_eq!(coarse.frontier, fine.frontier);
            let fine_results = all(&fine);
            for number in 0..3 {
                let classes: Vec<PartResult> =
                    fine_results.iter().skip(number).step_by(3).cloned().collect();
                let part = result(&coarse, number as u64);
                assert_eq!(own(&fine, &classes), own(&coarse, &[part]), "{words:?} {question:?}");
            }
        }
    }
}

#[test]
fn threads_make_no_difference_to_a_part() {
    for words in [["corner", "2", "compact", "4x4", ""], ["wang", "2", "compact", "4x2", ""]] {
        for question in questions() {
            let plan = plan(&Job::new(task(words), question), Cut::Nodes(30), 3);
            for number in 0..3 {
                let alone = result(&plan, number);
                let settings = Settings { threads: 3, ..Settings::PLAIN };
                let standing = packing::run(&plan.part(number), None, &settings).unwrap();
                let shared = PartResult { standing, ..alone.clone() };
                assert_eq!(own(&plan, &[shared]), own(&plan, &[alone]), "{words:?} {question:?}");
            }
        }
    }
}
