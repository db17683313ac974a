//! `find --method portfolio`: which way won, and what is refused.

use crate::{Place, run};

#[test]
fn which_way_won() {
    let place = Place::new();
    for (problem, way) in [
        ("--colors 3", "search in order"),
        ("--colors 4 --set compact --size 16x8", "beam search"),
        ("--colors 4 --symmetric", "search under a symmetry"),
    ] {
        let find = format!("find --kind corner {problem} --method portfolio");
        let found = place.run(&find).exits(0);
        let first = found.stdout.lines().next().unwrap();
        assert!(first.starts_with(&format!("# found by portfolio: {way}, round ")), "{first}");
        assert_eq!(first.contains("it has the automorphism 4,0:1,2,3,0"), way.contains("symmetry"));
        place.feed("verify -", &found.stdout).exits(0);
        let again = place.run(&format!("{find} --threads 1")).exits(0);
        assert_eq!(again.stdout, found.stdout);
        let object = place.run(&format!("{find} --json -o p.json")).exits(0).json();
        assert_eq!((&object["method"], &object["way"]), (&"portfolio".into(), &way.into()));
        assert!(object["round"].is_u64() && object["turns"].is_u64());
        place.run("verify p.json").exits(0);
    }
}

#[test]
fn no_packing_and_early_ends() {
    let tiles = "--kind corner --colors 4 --set pruned:0-1,2-3";
    let none = run(&format!("find {tiles} --size 4x15 --method portfolio")).exits(1);
    assert!(none.stdout.starts_with("none: "), "{none:#?}");
    let long = "find --kind corner --colors 5 --method portfolio --node-limit 1000";
    let stopped = run(long).exits(75);
    assert!(stopped.stderr.contains("stopped early by the node limit"), "{stopped:#?}");
    assert!(run(&format!("{long} --json")).exits(75).json()["turns"].is_u64());
}

#[test]
fn what_does_not_go_together_is_refused() {
    let place = Place::new();
    let portfolio = "find --kind corner --colors 2 --method portfolio";
    for (args, complaint) in [
        (format!("{portfolio} --values random"), "--values do not go together"),
        (format!("{portfolio} --restarts 5"), "--restarts do not go together"),
        (format!("{portfolio} --checkpoint c"), "--checkpoint do not go together"),
        (format!("{portfolio} --symmetric --automorphism auto"), "do not go together"),
        (format!("{portfolio} --beam-width 5"), "--beam-width needs --method beam"),
        ("find --kind corner --colors 2 --symmetric".into(), "needs --method portfolio"),
    ] {
        let refused = place.run(&args).exits(2);
        assert!(refused.stderr.contains(complaint), "{args}: {refused:#?}");
    }
}
