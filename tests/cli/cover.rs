//! `find --cover --method anneal`: what it says, what it writes, what it refuses.

use crate::{Place, names, run};

#[test]
fn the_smallest_covering_and_why_it_is() {
    let place = Place::new();
    let find = "find --kind corner --colors 3 --set pruned:0-1 --cover --method anneal";
    let found = place.run(find).exits(0);
    let mut lines = found.stdout.lines();
    assert_eq!(lines.next(), Some("# found by search"));
    let bound = "# 11x3, 33 cells for 31 tiles; no covering has fewer: there are 31 tiles";
    assert!(lines.next().unwrap().starts_with(bound), "{found:#?}");
    assert!(found.stderr.contains("32 cells: 8x4 searched to the end"), "{found:#?}");
    place.feed("verify -", &found.stdout).exits(0);
    place.run(&format!("{find} --quiet -o p.json")).exits(0);
    place.run("verify p.json").exits(0);
    let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    assert_eq!(solution["cover"], true);
    assert_eq!(solution["provenance"]["lower_bound"], 33);
}

#[test]
fn the_aspect_bounds_the_sides() {
    let find = "find --kind corner --colors 4 --set pruned:0-1 --cover --method anneal --aspect 2 \
                --json";
    let object = run(find).exits(0).json();
    let side = |name: &str| object[name].as_u64().unwrap();
    assert!(side("width") <= 2 * side("height") && side("height") <= 2 * side("width"));
    assert_eq!((&object["set_size"], &object["lower_bound"]), (&146.into(), &147.into()));
    assert!(side("width") * side("height") >= 150, "{object}");
    assert_eq!(object, {
        let mut other = run(&format!("{find} --threads 3")).exits(0).json();
        other["seconds"] = object["seconds"].clone();
        other
    });
}

#[test]
fn one_torus_with_and_without_a_symmetry() {
    let place = Place::new();
    let set = "find --kind corner --colors 4 --set pruned:0-1,2-3 --cover --method anneal";
    let found = place.run(&format!("{set} --size 22x3")).exits(0);
    assert!(
        found.stdout.contains("\n# 22x3, 66 cells for 60 tiles; no covering has fewer than 63: ")
    );
    place.feed("verify -", &found.stdout).exits(0);
    let folded = "--size 12x9 --automorphism 6,0:1,0,3,2 --seed 1 -o p.json --json";
    let found = place.run(&format!("{set} {folded}")).exits(0).json();
    assert_eq!(
        names(&found),
        [
            "bound_reason",
            "file",
            "height",
            "how",
            "lower_bound",
            "method",
            "nodes",
            "reason",
            "result",
            "seconds",
            "seed",
            "set_size",
            "stopped_by",
            "why",
            "width"
        ]
    );
    assert_eq!(found["seed"], 1);
    assert!(found["how"].as_str().unwrap().ends_with("under the symmetry 6,0:1,0,3,2"));
    place.run("verify p.json").exits(0);
    place.run(&format!("{set} --size 6x6")).exits(2);
}

#[test]
fn limits_and_what_is_impossible() {
    let set = "find --kind corner --colors 4 --set pruned:0-1,2-3 --cover --method anneal";
    let stopped = run(&format!("{set} --size 9x7 --node-limit 20000")).exits(75);
    assert_eq!(stopped.stdout, "");
    assert!(stopped.stderr.contains("stopped early by the node limit"), "{stopped:#?}");
    let object = run(&format!("{set} --size 9x7 --time-limit 300ms --json")).exits(75).json();
    assert_eq!((&object["result"], &object["width"]), (&"stopped".into(), &9.into()));
    assert_eq!(object["stopped_by"], "time-limit");
    let object = run(&format!("{set} --time-limit 0 --json")).exits(75).json();
    assert!(object["width"].is_null() && object["lower_bound"].is_u64());
    for (size, reason) in [
        ("31x2", "with a side of 2 every window is shown with its mirror image, which takes 72"),
        ("1x64", "with a side of 1 every window is its own mirror image"),
        ("16x4 --automorphism 8,0:2,1,0,3", "out of the set"),
    ] {
        let run = run(&format!("{set} --size {size}"));
        assert!(format!("{}{}", run.stdout, run.stderr).contains(reason), "{run:#?}");
    }
    // 60 tiles with an automorphism of order 5 that moves no color: 5 cells each.
    let none = run(&format!("{set} --size 13x5 --automorphism 0,1:0,1,2,3")).exits(1);
    assert!(none.stdout.contains("60 orbits of the tiles, and each takes 5 cells"), "{none:#?}");
}

#[test]
fn sets_that_no_torus_shows() {
    let place = Place::new();
    place.write("lone.json", r#"{"kind":"corner","tiles":[[0,1,0,0]]}"#);
    let none = place.run("find --set lone.json --cover --method anneal").exits(1);
    assert!(none.stdout.starts_with("none: no torus shows tile "), "{none:#?}");
    let json = place.run("find --set lone.json --cover --method anneal --json").exits(1).json();
    assert_eq!((&json["result"], &json["method"]), (&"none".into(), &"argument".into()));
}

#[test]
fn what_annealing_does_not_know_is_refused() {
    let place = Place::new();
    place.write("pins.txt", "0 . . .\n. . . .\n. . . .\n. . . .\n");
    let cover = "find --kind corner --colors 2 --cover --method anneal";
    for (args, complaint) in [
        (format!("{cover} --size 4x4 --pin pins.txt"), "--pin do not go together"),
        (format!("{cover} --order row"), "--order do not"),
        (format!("{cover} --values random"), "random already"),
        (format!("{cover} --plain"), "--plain do not"),
        (format!("{cover} --checkpoint c"), "--checkpoint do not"),
        (format!("{cover} --status s"), "--status do not"),
        (format!("{cover} --size 4x4 --aspect 2"), "--aspect and --size"),
        (format!("{cover} --aspect 0.5"), "at least 1"),
        (format!("{cover} --aspect x"), "a number such as"),
        (format!("{cover} --automorphism 2,0:+1"), "--automorphism needs --size"),
        (format!("{cover} --beam-width 10"), "--beam-width needs --method beam"),
        (
            "find --kind corner --colors 2 --cover --method search --aspect 2".into(),
            "--aspect needs",
        ),
        ("find --kind corner --colors 2 --aspect 2".into(), "--aspect needs"),
        ("find --kind wang --colors 2 --cover --method anneal".into(), "not of wang tiles"),
        ("find --kind corner --colors 3 --set compact --cover --method anneal".into(), "compact"),
    ] {
        let refused = place.run(&args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(complaint), "{args}: {refused:#?}");
    }
}
