//! `count`: known numbers, in words and as JSON.

use crate::{names, run};

/// Problems, their packings, those up to symmetry and those up to translation.
const KNOWN: &[(&str, &str, Option<&str>, Option<&str>)] = &[
    ("--kind corner --colors 2", "32", Some("1"), Some("2")),
    ("--kind corner --colors 1", "1", Some("1"), Some("1")),
    ("--kind wang --colors 2", "203520", None, Some("12720")),
    ("--kind wang --colors 1,3", "216", None, Some("24")),
    ("--kind domino --colors 2", "4", None, Some("1")),
    ("--kind domino --colors 3", "216", None, Some("24")),
    ("--kind domino --colors 4", "331776", None, Some("20736")),
    ("--kind domino --colors 3 --size 1x9", "216", None, Some("24")),
    ("--kind domino --colors 2,3 --size 1x4", "4", None, Some("1")),
];

/// By the theorem and, where that is possible, by search.
#[test]
fn rings_by_the_formula() {
    let place = crate::Place::new();
    // 0 and 1 hang together by one domino each way.
    place.write(
        "set.json",
        r#"{"kind":"domino","tiles":[[0,0],[0,1],[1,0],[1,2],[2,1],[2,2],[1,1],[2,0],[0,2]]}"#,
    );
    place.write("open.json", r#"{"kind":"domino","tiles":[[0,1],[1,2]]}"#);
    for problem in [
        "--kind domino --colors 1",
        "--kind domino --colors 2",
        "--kind domino --colors 3",
        "--kind domino --colors 4",
        "--kind domino --colors 2,3",
        "--kind domino --colors 2,3 --size 1x4",
        "--kind domino --colors 3 --set pruned:0-1",
        "--kind domino --colors 4 --set pruned:0-1,2-3",
        "--set set.json",
        "--set open.json",
    ] {
        let by = |method: &str| {
            let run = place.run(&format!("count {problem} --method {method} --json"));
            let (code, object) = (run.code, run.json());
            (code, object["solutions"].clone(), object["up_to_translation"].clone())
        };
        assert_eq!(by("formula"), by("search"), "{problem}");
    }
    // (C!)^C; the search would meet 25 * 995328000.
    let object = run("count --kind domino --colors 5 --json").exits(0).json();
    assert_eq!(object["solutions"], "24883200000");
    assert_eq!(object["up_to_translation"], "995328000");
    assert_eq!(
        (&object["method"], &object["nodes"]),
        (&"formula (BEST theorem)".into(), &"0".into())
    );
    let words = run("count --kind domino --colors 6").exits(0).stdout;
    assert!(words.contains("ring of 36 (36x1); by formula (BEST theorem): in "), "{words}");
    let open = place.run("count --set open.json --method formula").exits(1).stdout;
    assert!(open.starts_with("0 packings\n") && open.contains("there is no ring: "), "{open}");
    let searched = run("count --kind domino --colors 5 --node-limit 1000 --json").exits(75).json();
    assert_eq!(searched["method"], "search");
    for (args, complaint) in [
        ("count --kind wang --colors 2 --method formula", "is for dominoes, not for wang tiles"),
        ("count --kind domino --colors 3 --method formula --plain", "--plain is for a search"),
        ("count --kind domino --colors 3 --method formula --size 3x3", "one side must be 1"),
        ("count --kind domino --colors 3 --method formula --size 8x1", "the set has 9 tiles"),
    ] {
        let run = run(args).exits(2);
        assert!(run.stderr.contains(complaint), "{args}: {run:#?}");
    }
}

#[test]
fn known_numbers() {
    for &(problem, solutions, fundamental, up_to_translation) in KNOWN {
        let object = run(&format!("count {problem} --json")).exits(0).json();
        assert_eq!(object["solutions"], solutions, "{problem}");
        assert_eq!(object["up_to_translation"].as_str(), up_to_translation, "{problem}");
        if let Some(fundamental) = fundamental {
            let object = run(&format!("count {problem} --up-to-symmetry --json")).exits(0).json();
            assert_eq!(object["solutions"], solutions, "{problem}");
            assert_eq!(object["fundamental"], fundamental, "{problem}");
        }
    }
}

#[test]
fn symmetry_removed_or_not_the_number_is_the_same() {
    for problem in [
        "--kind corner --colors 2",
        "--kind wang --colors 1,3",
        "--kind domino --colors 3",
        "--kind corner --colors 2 --set compact",
        "--kind domino --colors 2 --cover --size 6x1",
    ] {
        let count = |options: &str| {
            run(&format!("count {problem} {options} --json")).exits(0).json()["solutions"].clone()
        };
        let reduced = count("");
        assert_eq!(reduced, count("--plain"), "{problem}");
        assert_eq!(reduced, count("--up-to-symmetry"), "{problem}");
        assert_eq!(reduced, count("--order column --threads 3"), "{problem}");
    }
}

#[test]
fn words() {
    let counted = run("count --kind corner --colors 2 --up-to-symmetry").exits(0);
    let lines: Vec<_> = counted.stdout.lines().collect();
    assert_eq!(lines[..3], ["32 packings", "1 up to symmetry", "2 up to translation"]);
    assert!(
        lines[3].starts_with("complete corner set over 2 colors, 4x4 torus; by search, complete: ")
    );
    assert_eq!(lines.len(), 4);
    assert_eq!(counted.stderr, "");
    let rings = run("count --kind domino --colors 3").exits(0).stdout;
    assert!(rings.contains("24 up to translation (rings up to rotation)"), "{rings}");
    let covers = run("count --kind domino --colors 2 --cover --size 5x1").exits(0).stdout;
    assert!(covers.lines().next().unwrap().ends_with(" coverings"), "{covers}");
    let one = run("count --kind corner --colors 1").exits(0).stdout;
    assert!(one.starts_with("1 packing\n"), "{one}");
}

#[test]
fn json_fields() {
    let object = run("count --kind corner --colors 2 --json").exits(0).json();
    let fields = [
        "method",
        "nodes",
        "reason",
        "result",
        "seconds",
        "solutions",
        "stopped_by",
        "up_to_translation",
    ];
    assert_eq!(names(&object), fields);
    assert_eq!((&object["result"], &object["method"]), (&"complete".into(), &"search".into()));
    assert!(object["nodes"].is_string() && object["seconds"].is_f64());
    let object = run("count --kind corner --colors 2 --up-to-symmetry --json").exits(0).json();
    assert!(object["fundamental"].is_string());
    let covered = run("count --kind domino --colors 2 --cover --size 5x1 --json").exits(0).json();
    assert!(covered["up_to_translation"].is_null());
}

#[test]
fn none_by_search() {
    let counted = run("count --kind corner --colors 2 --automorphism 2,0:+1").exits(1);
    assert!(counted.stdout.starts_with("0 packings with this automorphism\n"), "{counted:#?}");
    assert!(counted.stdout.contains("by search, complete"), "{counted:#?}");
}

#[test]
fn the_same_nodes_whatever_the_number_of_threads() {
    let nodes = |threads: u32| {
        let args = format!("count --kind wang --colors 2 --threads {threads} --json");
        run(&args).exits(0).json()["nodes"].clone()
    };
    assert_eq!(nodes(1), nodes(3));
}
