//! `merge`: nothing but the whole, each part once, all of one plan and version.

use crate::{Place, result};
use serde_json::json;
use std::path::PathBuf;
use std::time::Duration;
use tilepack::cluster::{MergeError, merge};
use tilepack::store::{Extent, PartResult, SearchPlan};

const WANG: &str = "--kind wang --colors 2";

/// A plan with all its parts done.
fn done(problem: &str, parts: u64) -> (Place, SearchPlan) {
    let place = Place::new();
    let plan = place.plan(problem, parts, "some.plan");
    place.run_all("some.plan", parts);
    (place, plan)
}

fn file(number: u64) -> String {
    format!("some.plan.parts/part-{number}.result.json")
}

#[test]
fn missing_parts_are_named() {
    let place = Place::new();
    place.plan(WANG, 7, "some.plan");
    for part in [0, 2, 5] {
        place.run(&format!("run some.plan --part {part} --quiet")).exits(0);
    }
    let merged = place.run("merge some.plan --json").exits(75);
    let merged = merged.says(&["3 of 7 parts are done; 4 parts missing: 1, 3-4, 6"]);
    let object = merged.json();
    assert_eq!(object["missing"], json!([1, 3, 4, 6]));
    assert_eq!((&object["result"], &object["solutions"]), (&"stopped".into(), &json!(null)));
    assert_eq!((&object["parts"], &object["done"]), (&json!(7), &json!(3)));
    let told = place.run("merge some.plan").exits(75);
    assert_eq!(told.stdout, "");
    // A part that was begun is not done.
    place.run("run some.plan --part 1 --node-limit 5").exits(75);
    place.run("merge some.plan").exits(75).says(&["4 parts missing"]);
    for part in [1, 3, 6] {
        place.run(&format!("run some.plan --part {part} --quiet")).exits(0);
    }
    place.run("merge some.plan").exits(75).says(&["6 of 7 parts are done; 1 part missing: 4"]);
    place.run("run some.plan --part 4 --quiet").exits(0);
    let told = place.run("merge some.plan").exits(0);
    assert!(told.stdout.starts_with("203520 packings\n12720 up to translation\n"), "{told:?}");
    assert!(told.stdout.contains("by search in 7 parts, complete: 537503 nodes in "), "{told:?}");
    std::fs::remove_dir_all(place.path("some.plan.parts")).unwrap();
    std::fs::create_dir(place.path("some.plan.parts")).unwrap();
    place.run("merge some.plan").exits(75).says(&["0 of 7 parts are done; 7 parts missing: 0-6"]);
}

#[test]
fn a_result_under_another_name() {
    let (place, _) = done(WANG, 3);
    let second = place.bytes(&file(1));
    place.copy(&file(0), &file(1));
    place.run("merge some.plan").exits(2).says(&["part-1.result.json: holds part 0 of 3"]);
    place.write(&file(1), second);
    place.run("merge some.plan").exits(0);
    // Also where the plan has no such part, and where there are other digits.
    for name in ["part-3.result.json", "part-00.result.json", "part-x.result.json"] {
        let name = format!("some.plan.parts/{name}");
        place.copy(&file(0), &name);
        place.run("merge some.plan").exits(2).says(&[&name, "holds part 0 of 3"]);
        std::fs::remove_file(place.path(&name)).unwrap();
    }
    std::fs::create_dir(place.path(&file(7))).unwrap();
    place.run("merge some.plan").exits(2).says(&["part-7.result.json"]);
}

#[test]
fn results_of_another_plan() {
    let (place, _) = done(WANG, 3);
    for (problem, parts) in [
        ("--kind wang --colors 2 --plain", 3),
        ("--kind wang --colors 2 --depth 3", 3),
        ("--kind wang --colors 2 --order row", 3),
        ("--kind wang --colors 2 --up-to-symmetry", 3),
        ("--kind wang --colors 2 --list", 3),
        ("--kind wang --colors 2", 5),
    ] {
        place.plan(problem, parts, "other.plan");
        place.run("run other.plan --part 1 --quiet").exits(0);
        place.copy("other.plan.parts/part-1.result.json", &file(1));
        let refused = place.run("merge some.plan --json").exits(2);
        assert_eq!(refused.stdout, "", "{problem}");
        refused.says(&["part-1.result.json", "another plan"]);
        std::fs::remove_dir_all(place.path("other.plan.parts")).unwrap();
    }
}

#[test]
fn results_of_another_version() {
    let (place, _) = done(WANG, 3);
    let mut other = PartResult::read(&place.path(&file(2))).unwrap();
    other.version = "0.0.9".into();
    other.write(&place.path(&file(2))).unwrap();
    let refused = place.run("merge some.plan").exits(2);
    refused.says(&["part-2.result.json: was made by version 0.0.9", "part-1.result.json"]);
}

#[test]
fn other_files_are_in_nobodys_way() {
    let (place, _) = done(WANG, 3);
    for name in ["notes.txt", "part-0.checkpoint", "part-0.result.json.lock", ".tilepack-x.part"] {
        place.write(&format!("some.plan.parts/{name}"), "something");
    }
    place.copy(&file(0), "some.plan.parts/part-0.result.json.old");
    place.copy(&file(0), "some.plan.parts/copy of part-0.result.json");
    let object = place.run("merge some.plan --json").exits(0).json();
    assert_eq!(object["solutions"], "203520");
}

#[test]
fn where_lists_go() {
    let (place, _) = done(WANG, 2);
    place.run("merge some.plan -o out").exits(2).says(&["-o", "count"]);
    std::fs::remove_file(place.path(&file(0))).unwrap();
    place.run("merge some.plan -o out").exits(2).says(&["-o", "count"]);
    let (place, _) = done("--kind domino --colors 3 --list", 2);
    place.run("merge some.plan --json").exits(2).says(&["-o"]);
    place.run("merge some.plan -o no/such/folder").exits(2).says(&["no/such"]);
    assert!(!place.path("out").exists());
}

/// A result that is whole and says it kept fewer packings than it met.
#[test]
fn a_list_that_is_short_of_packings() {
    let (place, _) = done("--kind domino --colors 3 --list", 2);
    let mut short = PartResult::read(&place.path(&file(0))).unwrap();
    let packings = place.bytes("some.plan.parts/part-0.packings");
    let length = packings.len() - 9;
    let hash = *blake3::hash(&packings[..length]).as_bytes();
    short.kept = Some(Extent { length: length as u64, hash });
    short.write(&place.path(&file(0))).unwrap();
    place.run("merge some.plan -o list").exits(2).says(&["part-0.result.json: met "]);
    short.kept = None;
    short.write(&place.path(&file(0))).unwrap();
    place.run("merge some.plan -o list").exits(2).says(&["part-0.result.json: does not say"]);
    assert!(!place.path("list").exists());
}

/// What no folder can hold, but a caller of the library can ask for; and results that are whole
/// but make no sense.
#[test]
fn results_that_cannot_be() {
    let place = Place::new();
    let plan = place.plan(WANG, 2, "some.plan");
    let named = |name: &str, result: &PartResult| (PathBuf::from(name), result.clone());
    let [first, second] = [result(&plan, 0), result(&plan, 1)];
    let whole = merge(&plan, vec![named("b", &second), named("a", &first)]).unwrap();
    assert_eq!((whole.missing, whole.standing.state.nodes), (Vec::new(), 537_503));
    let refuse = |results| merge(&plan, results).unwrap_err();
    let twice = refuse(vec![named("a", &first), named("b", &second), named("c", &first)]);
    assert!(matches!(twice, MergeError::Twice { number: 0, .. }), "{twice}");
    let beyond = PartResult { number: 2, ..second.clone() };
    let beyond = refuse(vec![named("a", &first), named("b", &beyond)]);
    assert!(matches!(beyond, MergeError::Number { number: 2, .. }), "{beyond}");
    let with = |change: fn(&mut PartResult)| {
        let mut changed = second.clone();
        change(&mut changed);
        refuse(vec![named("a", &first), named("b", &changed)])
    };
    let few = with(|result| result.standing.state.nodes = 56_470);
    assert!(matches!(few, MergeError::Nodes { .. }), "{few}");
    let none = with(|result| (result.standing.levels, result.standing.state.nodes) = (0, 0));
    assert!(matches!(none, MergeError::Nodes { .. }), "{none}");
    for many in [
        with(|result| result.standing.state.nodes = u64::MAX),
        with(|result| result.standing.state.solutions = u64::MAX),
    ] {
        assert!(matches!(many, MergeError::TooMuch { .. }), "{many}");
        assert!(many.to_string().starts_with("b: "), "{many}");
    }
    // A time beyond all measure is only a time.
    let mut long = second.clone();
    long.standing.state.elapsed = Duration::MAX;
    assert!(merge(&plan, vec![named("a", &first), named("b", &long)]).is_ok());
}
