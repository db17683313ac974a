//! What `plan`, `run` and `merge` come to: the answer of the undivided command.

use crate::{Place, lasting, result};
use serde_json::{Value, json};
use tilepack::cluster::merge;
use tilepack::packing::solve::counted;

const WANG: &str = "--kind wang --colors 2";
const QUOTIENT: &str = "--kind corner --colors 3 --automorphism 3,0:+1";

/// A count by parts, which must agree with the undivided one in all but time.
#[track_caller]
fn counted_in(problem: &str, parts: u64) -> Value {
    let place = Place::new();
    place.plan(problem, parts, "count.plan");
    place.run_all("count.plan", parts);
    // The depth of the cut is no option of a search.
    let problem = problem.split(" --depth").next().unwrap();
    let count = place.run(&format!("count {problem} --json"));
    let merged = place.run("merge count.plan --json").exits(count.code);
    assert_eq!(merged.stderr, "");
    let mut expected = lasting(count.json());
    expected["parts"] = json!(parts);
    expected["done"] = json!(parts);
    let merged = lasting(merged.json());
    assert_eq!(merged, expected, "{problem}");
    merged
}

#[test]
fn wang_in_7_parts() {
    let object = counted_in(WANG, 7);
    let told = [&object["result"], &object["solutions"], &object["nodes"]];
    assert_eq!(told, ["complete", "203520", "537503"]);
    assert_eq!((&object["parts"], &object["done"]), (&json!(7), &json!(7)));
}

#[test]
fn wang_in_64_parts() {
    let object = counted_in(WANG, 64);
    assert_eq!((&object["solutions"], &object["nodes"]), (&"203520".into(), &"537503".into()));
}

/// In one process: what a part comes to is written by the same lines.
#[test]
fn wang_in_1000_parts() {
    let place = Place::new();
    let plan = place.plan(WANG, 1000, "wang.plan");
    std::fs::create_dir(place.path("wang.plan.parts")).unwrap();
    let results: Vec<_> = (0..1000)
        .map(|number| {
            let file = place.path(&format!("wang.plan.parts/part-{number:03}.result.json"));
            let result = result(&plan, number);
            result.write(&file).unwrap();
            (file, result)
        })
        .collect();
    let merged = merge(&plan, results).unwrap();
    let counted = counted(&plan.job, &merged.standing).unwrap();
    assert_eq!(counted.packings.to_string(), "203520");
    assert_eq!(merged.standing.state.nodes, 537_503);
    let object = place.run("merge wang.plan --json").exits(0).json();
    let told = [&object["solutions"], &object["nodes"], &object["up_to_translation"]];
    assert_eq!(told, ["203520", "537503", "12720"]);
    assert_eq!((&object["parts"], &object["done"]), (&json!(1000), &json!(1000)));
}

#[test]
fn the_quotient_of_three_corner_colors_in_64_parts() {
    let object = counted_in(QUOTIENT, 64);
    assert_eq!((&object["result"], &object["solutions"]), (&"complete".into(), &"303264".into()));
}

#[test]
fn up_to_symmetry() {
    let object = counted_in("--kind wang --colors 2 --up-to-symmetry", 5);
    assert_eq!((&object["solutions"], &object["fundamental"]), (&"203520".into(), &"538".into()));
}

/// Every option that makes another search is in the plan.
#[test]
fn whatever_is_asked() {
    let place = Place::new();
    place.write("pins.txt", "0 0 . .\n0 0 . .\n. . . .\n. . . .\n");
    place.write("set.json", r#"{"kind": "domino", "tiles": [[0, 1], [1, 2], [2, 0], [1, 1]]}"#);
    let (pins, set) = (place.path("pins.txt"), place.path("set.json"));
    let (pins, set) = (pins.to_str().unwrap(), set.to_str().unwrap());
    for (problem, parts) in [
        ("--kind domino --colors 3", 4),
        ("--kind domino --colors 2,2 --size 1x4 --up-to-symmetry", 3),
        ("--kind domino --colors 2 --size 1x6 --cover", 3),
        (&format!("--kind domino --set {set}"), 2),
        (&format!("--kind corner --colors 2 --pin {pins}"), 2),
        ("--kind corner --colors 2 --plain --order spiral", 3),
        ("--kind corner --colors 2 --depth 2", 9),
        ("--kind corner --colors 2 --depth 400", 3),
        ("--kind corner --colors 2 --set compact --up-to-symmetry", 2),
        ("--kind corner --colors 1", 3),
        ("--kind corner --colors 2 --size 6x3 --cover --plain", 2),
        ("--kind wang --colors 1,3", 2),
        ("--kind wang --colors 2 --set compact --size 4x2 --automorphism 0,1:1,0", 2),
        // None, found by search.
        ("--kind wang --colors 2 --set pruned:0-1", 3),
        ("--kind corner --colors 2 --size 6x3 --cover --automorphism 3,0:0,1", 3),
    ] {
        counted_in(problem, parts);
    }
}

/// Lists by parts, byte for byte those of the undivided command.
fn listed_in(problem: &str, parts: u64, lines: usize) {
    let place = Place::new();
    place.plan(&format!("{problem} --list"), parts, "list.plan");
    place.run_all("list.plan", parts);
    let list = place.run(&format!("list {problem} -o whole.jsonl --json"));
    let merged = place.run("merge list.plan -o merged.jsonl --json").exits(list.code);
    let mut expected = lasting(list.json());
    expected["parts"] = json!(parts);
    expected["done"] = json!(parts);
    expected["file"] = json!("merged.jsonl");
    assert_eq!(lasting(merged.json()), expected, "{problem}");
    let bytes = place.bytes("merged.jsonl");
    assert!(bytes == place.bytes("whole.jsonl"), "{problem}");
    assert_eq!(bytes.iter().filter(|&&byte| byte == b'\n').count(), lines, "{problem}");
    if lines < 1000 {
        let piped = place.run("merge list.plan --quiet").exits(list.code);
        assert_eq!((piped.stdout.as_bytes(), piped.stderr.as_str()), (&bytes[..], ""));
        let told = place.run("merge list.plan -o merged.jsonl").exits(list.code).stderr;
        let words = if lines > 0 { " listed: " } else { "none: there is no " };
        assert!(told.contains(words), "{told}");
    }
}

#[test]
fn lists() {
    listed_in(WANG, 5, 203_520);
    listed_in(&format!("{WANG} --up-to-symmetry"), 7, 538);
    listed_in("--kind domino --colors 3", 4, 216);
    listed_in("--kind corner --colors 2 --set compact", 40, 32);
    listed_in("--kind corner --colors 1", 2, 1);
    listed_in("--kind wang --colors 2 --set pruned:0-1", 2, 0);
}

#[test]
fn the_same_options_make_the_same_plan() {
    let place = Place::new();
    place.plan(WANG, 7, "first.plan");
    let object = place.run(&format!("plan {WANG} --parts 7 -o again.plan --json")).exits(0).json();
    assert_eq!(place.bytes("first.plan"), place.bytes("again.plan"));
    assert_eq!((&object["result"], &object["done"]), (&"planned".into(), &json!(0)));
    assert_eq!((&object["parts"], &object["file"]), (&json!(7), &"again.plan".into()));
    assert!(
        String::from_utf8(place.bytes("again.plan"))
            .unwrap()
            .contains(object["plan"].as_str().unwrap())
    );
    for depth in ["depth", "frontier", "above"] {
        assert!(!object[depth].is_null());
    }
    // Plans of one search refine each other as far as 4096 parts.
    let frontier = |parts: u64| {
        let args = format!("plan {WANG} --parts {parts} -o other.plan --json");
        place.run(&args).exits(0).json()["frontier"].clone()
    };
    assert_eq!(frontier(4096), object["frontier"]);
    assert_ne!(frontier(5000), object["frontier"]);
}

#[test]
fn where_there_is_plainly_none_there_is_no_plan() {
    let place = Place::new();
    let args = "plan --kind corner --colors 2 --size 2x8 --parts 4 -o none.plan";
    let told = place.run(args).exits(1);
    assert!(told.stdout.starts_with("none: size 2x8: "), "{told:?}");
    let object = place.run(&format!("{args} --json")).exits(1).json();
    assert_eq!((&object["result"], &object["parts"]), (&"none".into(), &json!(0)));
    assert!(!place.path("none.plan").exists());
}

#[test]
fn plans_that_make_no_sense() {
    let place = Place::new();
    for args in
        ["--parts 0", "--parts -3", "--parts 1000001", "--parts x", "", "--depth 0 --parts 2"]
    {
        place.run(&format!("plan {WANG} {args} -o some.plan")).exits(2);
    }
    place
        .run(&format!("plan {WANG} --parts 2 -o no/folder/some.plan"))
        .exits(2)
        .says(&["no/folder"]);
    place.run(&format!("plan {WANG} --parts 2")).exits(2);
    place.write("pins.txt", "0 . . .\n. . . .\n. . . .\n. . . .\n");
    let pinned = "--kind corner --colors 2 --pin pins.txt --up-to-symmetry";
    place.run(&format!("plan {pinned} --parts 2 -o some.plan")).exits(2).says(&["pins"]);
    assert!(!place.path("some.plan").exists());
}
