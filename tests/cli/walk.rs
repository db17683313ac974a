//! `walk`: another packing, what is told of the way, and what is refused.

use crate::{CORNER_2, Place, names};

#[test]
fn another_packing_with_the_same_tiles() {
    let place = Place::new();
    place.run("find --kind corner --colors 3 --method beam --quiet -o p.json").exits(0);
    let walk = "walk p.json --steps 200 --patch 6x6 --seed 3";
    let walked = place.run(walk).exits(0);
    assert!(walked.stdout.starts_with("# walk by patches of 6x6 (200 steps, seed 3)\n"));
    for part in ["200 patches in ", " had another filling (", " of 81 cells have another tile"] {
        assert!(walked.stderr.contains(part), "{walked:#?}");
    }
    assert!(walked.stderr.contains("drift of colors (1: as at random) among rows "), "{walked:#?}");
    place.feed("verify -", &walked.stdout).exits(0);
    assert_eq!(place.run(walk).stdout, walked.stdout);
    place.run(&format!("{walk} -o q.json --quiet")).exits(0);
    place.run("verify q.json").exits(0);
    let q: serde_json::Value = serde_json::from_str(&place.read("q.json")).unwrap();
    assert_eq!(
        (&q["provenance"]["from"], &q["provenance"]["steps"]),
        (&"p.json".into(), &"200".into())
    );
    // A list, standard input, other kinds, coverings.
    let listed = place.run("list --kind wang --colors 2 --up-to-symmetry --quiet").exits(0).stdout;
    let walked = place.feed("walk - --patch 3x3 --quiet", &listed).exits(0);
    place.feed("verify -", &walked.stdout).exits(0);
    for find in [
        "find --kind domino --colors 4 --quiet -o r.json",
        "find --kind corner --colors 3 --set compact --size 9x6 --quiet -o r.json",
        "find --kind corner --colors 2 --cover --size 5x4 --quiet -o r.json",
    ] {
        place.run(find).exits(0);
        let patch = if find.contains("domino") { "9x1" } else { "4x4" };
        let walked = place.run(&format!("walk r.json --patch {patch} --steps 50 --quiet")).exits(0);
        place.feed("verify -", &walked.stdout).exits(0);
    }
}

#[test]
fn json_fields() {
    let place = Place::new();
    place.run("find --kind corner --colors 3 --quiet -o p.json").exits(0);
    let object = place.run("walk p.json --steps 20 --json -o q.json").exits(0).json();
    assert_eq!(
        names(&object),
        [
            "changed",
            "drift_columns",
            "drift_rows",
            "file",
            "fillings",
            "height",
            "moves",
            "nodes",
            "patch",
            "result",
            "rows_after",
            "rows_before",
            "seconds",
            "seed",
            "skipped",
            "steps",
            "stopped_by",
            "width"
        ]
    );
    assert_eq!((&object["result"], &object["steps"]), (&"walked".into(), &"20".into()));
    // Nine of each color in every row: none is used up.
    assert_eq!(object["rows_before"].as_array().unwrap().len(), 9);
    let whole = place.run("walk p.json --steps 20 --json").exits(0);
    place.feed("verify -", &whole.stdout).exits(0);
}

#[test]
fn what_is_refused_and_what_stops() {
    let place = Place::new();
    place.write("p.txt", CORNER_2).write("empty.txt", "");
    place.write("bad.txt", CORNER_2.replace("0 0 0 1", "0 0 0 0"));
    for (args, complaint) in [
        ("walk p.txt --patch 5x5", "larger than the torus"),
        ("walk p.txt --patch 1x1", "no color inside"),
        ("walk p.txt --patch five", "--patch"),
        ("walk empty.txt", "empty.txt"),
        ("walk bad.txt", "bad.txt, line 1: not a packing"),
        ("walk nowhere.json", "nowhere.json"),
        ("walk p.txt --patch 3x3 -o no/where.json", "where.json"),
        ("walk p.txt --kind wang", "kind"),
    ] {
        let refused = place.run(args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(complaint), "{args}: {refused:#?}");
    }
    let stopped = "walk p.txt --patch 4x4 --steps 1000000000 --time-limit 100ms";
    let stopped = place.run(stopped).exits(75);
    assert!(stopped.stderr.contains("stopped early by the time limit after "), "{stopped:#?}");
    place.feed("verify -", &stopped.stdout).exits(0);
}
