//! `find --method beam`: what it says, what it writes, what it refuses.

use crate::{Place, names, run};

#[test]
fn a_packing_and_how_it_was_found() {
    let place = Place::new();
    for problem in ["--colors 3", "--colors 3 --set compact --size 6x9", "--colors 2"] {
        let find = format!("find --kind corner {problem} --method beam --seed 5 --beam-width 500");
        let found = place.run(&find).exits(0);
        let first = found.stdout.lines().next().unwrap();
        assert!(
            first.starts_with("# found by beam search (seed 5, width 500, restart "),
            "{first}"
        );
        assert!(found.stderr.starts_with("tilepack: found by beam search (seed 5"), "{found:#?}");
        place.write("grid.txt", &found.stdout).run("verify grid.txt").exits(0);
        assert_eq!(found.stdout, place.run(&format!("{find} --threads 3")).exits(0).stdout);
        place.run(&format!("{find} --quiet -o p.json")).exits(0);
        place.run("verify p.json").exits(0);
        let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
        assert_eq!(solution["provenance"]["seed"], 5);
    }
}

#[test]
fn json_fields() {
    let place = Place::new();
    let found = place.run("find --kind corner --colors 3 --method beam --json -o p.json").exits(0);
    let object = found.json();
    assert_eq!(
        names(&object),
        [
            "beam_width",
            "file",
            "first_row",
            "height",
            "method",
            "nodes",
            "reason",
            "restart",
            "result",
            "seconds",
            "seed",
            "stopped_by",
            "why",
            "width"
        ]
    );
    assert_eq!((&object["result"], &object["method"]), (&"found".into(), &"beam".into()));
    assert_eq!((&object["seed"], &object["beam_width"]), (&0.into(), &1000.into()));
    assert!(object["stopped_by"].is_null());
    let whole = place.run("find --kind corner --colors 3 --method beam --json").exits(0);
    place.feed("verify -", &whole.stdout).exits(0);
}

#[test]
fn all_colors_in_the_first_row() {
    let place = Place::new();
    let find = "find --kind corner --colors 3 --method beam --first-row all --quiet";
    let found = place.run(find).exits(0);
    let wanted = "# found by beam search (seed 0, width 8000, all colors in the first row, ";
    assert!(found.stdout.starts_with(wanted), "{found:#?}");
    place.run(&format!("{find} -o p.json")).exits(0);
    let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    assert_eq!(solution["provenance"]["first_row"], "all");
    let set = "--colors 3 --set compact --size 6x9";
    let found =
        place.run(&format!("find --kind corner {set} --method beam --first-row all --json"));
    let object = found.exits(0).json();
    assert_eq!((&object["first_row"], &object["beam_width"]), (&"all".into(), &3000.into()));
}

#[test]
fn limits_and_impossible_shapes() {
    let hopeless = "find --kind corner --colors 4 --set pruned:0-1,2-3 --size 10x6 --method beam";
    let stopped = run(&format!("{hopeless} --time-limit 300ms")).exits(75);
    assert_eq!(stopped.stdout, "");
    for part in
        ["stopped early by the time limit", " restarts, ", " of 60; no packing found so far"]
    {
        assert!(stopped.stderr.contains(part), "{stopped:#?}");
    }
    let object = run(&format!("{hopeless} --node-limit 1000 --json")).exits(75).json();
    assert_eq!(
        (&object["result"], &object["stopped_by"]),
        (&"stopped".into(), &"node-limit".into())
    );
    assert!(object["restarts"].is_u64() && object["file"].is_null());
    let none = run("find --kind corner --colors 2 --size 8x2 --method beam").exits(1);
    assert!(none.stdout.starts_with("none: size 8x2: both sides must be at least 3"), "{none:#?}");
    let none = run("find --kind corner --colors 2 --size 8x2 --method beam --json").exits(1).json();
    assert_eq!((&none["result"], &none["method"]), (&"none".into(), &"argument".into()));
    assert!(none["reason"].as_str().unwrap().contains("at least 3"));
}

#[test]
fn what_the_beam_does_not_know_is_refused() {
    let place = Place::new();
    let corner = "find --kind corner --colors 2";
    for (args, complaint) in [
        (format!("{corner} --method beam --automorphism 2,0:+1"), "--automorphism do not"),
        (format!("{corner} --method beam --cover --size 5x4"), "--cover do not"),
        (format!("{corner} --method beam --order column"), "--order do not"),
        (format!("{corner} --method beam --values random"), "random already"),
        (format!("{corner} --method beam --plain"), "--plain do not"),
        (format!("{corner} --method beam --checkpoint c"), "--checkpoint do not"),
        (format!("{corner} --method beam --status s"), "--status do not"),
        (format!("{corner} --method beam --beam-width 0"), "1..=200000"),
        (format!("{corner} --beam-width 10"), "--beam-width needs --method beam"),
        (format!("{corner} --first-row all"), "--first-row needs --method beam"),
        (format!("{corner} --first-row all --recursive"), "the first row is given"),
        (format!("{corner} --first-row one --method beam"), "possible values: two, all"),
        ("find --kind wang --colors 2 --method beam".into(), "for corner tiles, not for wang"),
        ("find --kind domino --colors 2 --method beam".into(), "for corner tiles, not for domino"),
        (format!("{corner} --size 5x4 --method beam"), "20 cells"),
    ] {
        let refused = place.run(&args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(complaint), "{args}: {refused:#?}");
    }
}
