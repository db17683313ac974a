//! `find --restarts` and the orders of values: what they say, what they refuse.

use crate::{Place, run};

#[test]
fn a_packing_and_how_it_was_found() {
    let place = Place::new();
    let find = "find --kind wang --colors 3 --restarts 20000 --seed 4";
    let found = place.run(&format!("{find} --threads 1")).exits(0);
    let first = found.stdout.lines().next().unwrap();
    assert!(first.starts_with("# found by search with restarts (run "), "{first}");
    assert!(first.ends_with(" in column order, values random, seed 4, unit 20000)"), "{first}");
    place.feed("verify -", &found.stdout).exits(0);
    assert_eq!(place.run(&format!("{find} --threads 3")).exits(0).stdout, found.stdout);
    place.run(&format!("{find} -o p.json --quiet")).exits(0);
    let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    assert_eq!(solution["provenance"]["unit"], 20000);
    let object = place.run(&format!("{find} --json --order row")).exits(0).json();
    assert_eq!((&object["method"], &object["unit"]), (&"search".into(), &20000.into()));
    assert!(object["run"].is_u64());
    let under = "find --kind corner --colors 4 --automorphism 4,0:1,2,3,0 --restarts --json";
    let object = run(under).exits(0).json();
    assert_eq!(object["automorphism"], "4,0:1,2,3,0");
    assert_eq!(object["unit"], 100_000);
}

#[test]
fn no_packing_and_early_ends() {
    let tiles = "--kind corner --colors 4 --set pruned:0-1,2-3";
    let none = run(&format!("find {tiles} --size 4x15 --restarts 100")).exits(1);
    assert!(none.stdout.starts_with("none: "), "{none:#?}");
    assert!(none.stderr.contains("complete search"), "{none:#?}");
    let none = run(&format!("find {tiles} --size 4x15 --restarts 100 --json")).exits(1).json();
    assert_eq!((&none["result"], &none["method"]), (&"none".into(), &"search".into()));
    let none = run("find --kind corner --colors 2 --size 8x2 --restarts").exits(1);
    assert!(none.stdout.contains("both sides must be at least 3"), "{none:#?}");
    let long = "find --kind corner --colors 5 --restarts 1000 --node-limit 50000";
    let stopped = run(long).exits(75);
    for part in ["stopped early by the node limit", " runs, deepest level ", "no packing found"] {
        assert!(stopped.stderr.contains(part), "{stopped:#?}");
    }
    assert!(run(&format!("{long} --json")).exits(75).json()["runs"].is_u64());
}

#[test]
fn what_does_not_go_together_is_refused() {
    let place = Place::new();
    let corner = "find --kind corner --colors 2";
    for (args, complaint) in [
        (format!("{corner} --restarts 5 --checkpoint c"), "--checkpoint do not go together"),
        (format!("{corner} --restarts 5 --status s"), "--status do not go together"),
        (format!("{corner} --restarts 5 --values highest"), "--values highest do not"),
        (format!("{corner} --restarts 0"), "not in"),
        (format!("{corner} --restarts 5 --method beam"), "--restarts do not go together"),
        (format!("{corner} --restarts 5 --method construct"), "--restarts is for a search"),
        (format!("{corner} --values highest --method beam"), "--values highest do not"),
        (format!("{corner} --values highest --method construct"), "--values highest is for"),
    ] {
        let refused = place.run(&args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(complaint), "{args}: {refused:#?}");
    }
}

#[test]
fn the_highest_first() {
    let place = Place::new();
    let find = "find --kind corner --colors 3 --set compact --size 9x6 --values highest";
    let found = place.run(find).exits(0);
    assert!(found.stdout.contains("values highest first"), "{found:#?}");
    place.feed("verify -", &found.stdout).exits(0);
    let lexicographic = place.run(&find.replace("highest", "lexicographic")).exits(0);
    assert_ne!(lexicographic.stdout, found.stdout);
    // Saved, and gone on with.
    let save = format!("{find} --checkpoint c --quiet");
    place.run(&format!("{save} --node-limit 10")).exits(75);
    let resumed = place.run("resume c --quiet").exits(0);
    assert_eq!(resumed.stdout, found.stdout);
}
