//! `count --method meet`: the same numbers as the search, stopped and taken up again, in parts,
//! and refused where it cannot be had.

use crate::{Place, run};

/// Over 3 colors, 27 states of a row: 3,744 packings up to translation.
const QUOTIENT: &str = "--kind corner --colors 3 --automorphism 3,0:+1";

#[test]
fn known_numbers() {
    for (problem, packings, code) in [
        ("--kind corner --colors 2", "32", 0),
        ("--kind corner --colors 2 --set compact", "32", 0),
        ("--kind corner --colors 2 --size 2x8", "0", 1),
        (QUOTIENT, "303264", 0),
        ("--kind wang --colors 2", "203520", 0),
    ] {
        for threads in [1, 3] {
            let args = format!("count {problem} --method meet --threads {threads}");
            let told = run(&args).exits(code);
            assert!(told.stdout.starts_with(packings), "{told:#?}");
            let object = run(&format!("{args} --json")).exits(code).json();
            assert_eq!(object["solutions"], packings, "{problem}");
            assert_eq!(object["result"], "complete");
            if code == 0 {
                assert_eq!(object["method"], "meet");
                assert!(object["steps"].as_str().unwrap().parse::<u64>().unwrap() > 0);
            }
        }
    }
}

#[test]
fn stopped_and_taken_up_again() {
    let place = Place::new();
    let args = format!("count {QUOTIENT} --method meet --checkpoint rows.checkpoint");
    let stopped = place.run(&format!("{args} --node-limit 20 --json")).exits(75).json();
    assert_eq!(stopped["nodes"], "20");
    let more = place.run("resume rows.checkpoint --node-limit 30 --json").exits(75).json();
    assert_eq!(more["nodes"], "50");
    let whole = run(&format!("count {QUOTIENT} --method meet --json")).exits(0).json();
    let resumed = place.run("resume rows.checkpoint --json").exits(0).json();
    for field in ["solutions", "nodes", "steps", "method"] {
        assert_eq!(resumed[field], whole[field], "{field}");
    }
}

#[test]
fn in_parts() {
    let place = Place::new();
    place.run(&format!("plan {QUOTIENT} --meet --parts 3 -o rows.plan")).exits(0);
    for part in 0..3 {
        let done = place.run(&format!("run rows.plan --part {part} --json")).exits(0).json();
        // What is met are choices that stand for many.
        assert!(done["solutions_met"].is_null(), "{done}");
    }
    let merged = place.run("merge rows.plan --json").exits(0).json();
    assert_eq!((&merged["solutions"], &merged["method"]), (&"303264".into(), &"meet".into()));
    let whole = run(&format!("count {QUOTIENT} --method meet --json")).exits(0).json();
    assert_eq!(merged["steps"], whole["steps"]);
    let told = place.run("merge rows.plan").exits(0);
    assert!(told.stdout.contains("by meeting in the middle in 3 parts"), "{told:#?}");
}

/// Which way lines lie stays the same when the search is read again.
#[test]
fn columns() {
    let place = Place::new();
    let problem = "--kind corner --colors 3 --set compact --automorphism 0,2:+1";
    let counted = run(&format!("count {problem} --json")).exits(0).json();
    place.run(&format!("plan {problem} --meet --parts 1 -o rows.plan")).exits(0);
    place.run("run rows.plan --part 0").exits(0);
    let merged = place.run("merge rows.plan --json").exits(0).json();
    assert_eq!(merged["solutions"], counted["solutions"]);
}

#[test]
fn refused() {
    for (problem, why) in [
        ("--kind domino --colors 2", "for corner tiles, not for domino tiles"),
        ("--kind wang --colors 3", "81 tiles: counting by halves handles up to 64"),
        ("--kind corner --colors 3", "lines of 9 cells over 3 colors have too many states"),
        ("--kind corner --colors 4", "256 tiles: counting by lines handles up to 128"),
        ("--kind corner --colors 4 --set compact", "256 tiles: counting by lines"),
        ("--kind corner --colors 2 --up-to-symmetry", "cannot do with single packings or orbits"),
        ("--kind corner --colors 2 --plain", "cannot do with symmetry that is not removed"),
        ("--kind corner --colors 2 --cover --size 5x4", "cannot do with coverings"),
        ("--kind corner --colors 3 --automorphism 3,3:+1", "moves no line to another"),
    ] {
        let refused = run(&format!("count {problem} --method meet")).exits(2);
        assert!(refused.stderr.contains(why), "{problem}: {refused:#?}");
        assert_eq!(refused.stdout, "");
    }
}
