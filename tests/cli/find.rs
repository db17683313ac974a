//! `find`: the packing, where it goes, and that it is one.

use crate::{Place, names, run};

#[test]
fn a_grid_on_standard_output_and_nothing_else() {
    let run = run("find --kind corner --colors 3 --method search").exits(0);
    let mut lines = run.stdout.lines();
    let first = lines.next().unwrap();
    assert!(first.starts_with("# found by search (first in row order"), "{first}");
    assert!(first.ends_with(" nodes"), "{first}");
    assert_eq!(lines.next(), Some("kind=corner colors=3 set=complete"));
    assert_eq!(lines.count(), 9);
    assert!(run.stderr.starts_with("tilepack: found by search"), "{run:#?}");
    assert_eq!(run.stderr.lines().count(), 1);
}

#[test]
fn what_is_found_is_verified_and_drawn() {
    for problem in [
        "--kind corner --colors 1",
        "--kind corner --colors 2",
        "--kind corner --colors 3",
        "--kind corner --colors 3 --set compact",
        "--kind corner --colors 3 --automorphism 3,0:+1",
        "--kind corner --colors 4 --automorphism 4,0:1,2,3,0 --values random --seed 1",
        "--kind corner --colors 2 --cover --size 5x4",
        "--kind corner --colors 2 --order spiral",
        "--kind corner --colors 2 --order column --values random --seed 3",
        "--kind wang --colors 2",
        "--kind wang --colors 1,3",
        "--kind wang --colors 2,3 --order diagonal",
        "--kind wang --colors 2 --set compact",
        "--kind domino --colors 5",
        "--kind domino --colors 3 --size 1x9",
        "--kind domino --colors 2,3 --size 1x4",
        "--kind domino --colors 2,3",
        "--kind domino --colors 3 --set pruned:0-1",
        "--set pair.json",
        "--set pair.json --colors 3,2",
    ] {
        let place = Place::new();
        place.write("pair.json", "{\"kind\":\"wang\",\"tiles\":[[0,0,0,1],[0,1,0,0]]}");
        let json = place.run(&format!("find {problem} --json --quiet -o p.json")).exits(0);
        assert_eq!((&json.json()["file"], json.stderr.as_str()), (&"p.json".into(), ""));
        let grid = place.run(&format!("find {problem} --quiet")).exits(0);
        assert_eq!(grid.stderr, "");
        place.write("p.txt", &grid.stdout);
        let verified = place.run("verify p.json p.txt").exits(0);
        let words: Vec<_> =
            verified.stdout.lines().map(|line| line.split_once(": ").unwrap().1).collect();
        assert_eq!(words.len(), 2, "{verified:#?}");
        assert_eq!(words[0], words[1]);
        for file in ["p.json", "p.txt"] {
            for style in ["", "--indices", "--color always", "--color always --indices"] {
                assert!(place.run(&format!("show {file} {style}")).exits(0).stdout.len() > 40);
            }
        }
    }
}

#[test]
fn json_fields() {
    let place = Place::new();
    let found = place.run("find --kind corner --colors 3 --method search --json").exits(0);
    let object = found.json();
    assert_eq!(
        names(&object),
        [
            "colors",
            "file",
            "format",
            "height",
            "kind",
            "method",
            "nodes",
            "reason",
            "result",
            "seconds",
            "set",
            "stopped_by",
            "tiles",
            "topology",
            "why",
            "width"
        ]
    );
    assert_eq!((&object["result"], &object["method"]), (&"found".into(), &"search".into()));
    assert_eq!((&object["width"], &object["height"]), (&9.into(), &9.into()));
    assert!(object["nodes"].as_str().unwrap().parse::<u64>().unwrap() > 1000);
    assert!(object["seconds"].is_f64());
    assert!(object["file"].is_null() && object["reason"].is_null());
    // The object is a solution file, too.
    place.feed("verify -", &found.stdout).exits(0);

    let filed =
        place.run("find --kind corner --colors 3 --method search --json -o p.json").exits(0).json();
    assert_eq!(
        names(&filed),
        [
            "file",
            "height",
            "method",
            "nodes",
            "reason",
            "result",
            "seconds",
            "stopped_by",
            "why",
            "width"
        ]
    );
    let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    assert_eq!(solution["tiles"], object["tiles"]);
    assert_eq!(solution["provenance"]["nodes"], object["nodes"]);
    assert_eq!(solution["provenance"]["version"], env!("CARGO_PKG_VERSION"));
}

#[test]
fn the_same_packing_whatever_the_number_of_threads() {
    for problem in [
        "find --kind corner --colors 3 --method search",
        "find --kind wang --colors 2,3 --method search",
        "find --kind corner --colors 4 --automorphism 4,0:1,2,3,0 --values random --seed 5",
    ] {
        let one = run(&format!("{problem} --threads 1")).exits(0).stdout;
        let three = run(&format!("{problem} --threads 3")).exits(0).stdout;
        assert_eq!(one, three, "{problem}");
    }
}

#[test]
fn seeds_are_said_and_matter() {
    let find = "find --kind corner --colors 3 --values random";
    let [none, zero, other] =
        ["", "--seed 0", "--seed 1"].map(|seed| run(&format!("{find} {seed}")).exits(0).stdout);
    assert_eq!(none, zero);
    assert_ne!(zero, other);
    assert!(zero.contains("random with seed 0") && other.contains("random with seed 1"));
    assert_eq!(run(&format!("{find} --seed 9 --json")).exits(0).json()["seed"], 9);
}

#[test]
fn an_automorphism_is_said_and_holds() {
    let place = Place::new();
    let found = place.run("find --kind corner --colors 3 --automorphism 3,0:+1").exits(0);
    assert!(found.stdout.contains("only among those with automorphism 3,0:+1"), "{found:#?}");
    let rows: Vec<Vec<u8>> = found
        .stdout
        .lines()
        .skip(2)
        .map(|line| line.split_whitespace().map(|n| n.parse().unwrap()).collect())
        .collect();
    for row in &rows {
        for column in 0..9 {
            assert_eq!(row[(column + 3) % 9], (row[column] + 1) % 3);
        }
    }
    // None with this automorphism says nothing about the others, and says so.
    let none = place.run("find --kind corner --colors 2 --automorphism 2,0:+1").exits(1);
    assert!(none.stdout.contains("there is no packing with this automorphism"), "{none:#?}");
}

#[test]
fn pins_with_dots() {
    let place = Place::new();
    place.write("pins.txt", "# begun\n. . . .\n. 0 0 .\n. 0 0 .\n1 . . .\n");
    let found = place.run("find --kind corner --colors 2 --pin pins.txt").exits(0);
    let rows: Vec<_> = found.stdout.lines().skip(2).collect();
    assert_eq!((&rows[1][2..5], &rows[2][2..5], &rows[3][..1]), ("0 0", "0 0", "1"));
    place.feed("verify -", &found.stdout).exits(0);

    place.write("none.txt", "0 0 0 0\n0 0 . .\n. . . .\n. . . .\n");
    let none = place.run("find --kind corner --colors 2 --pin none.txt");
    assert!(none.code == 2 || none.stdout.contains("with these pins"), "{none:#?}");
    assert!(none.code != 0, "{none:#?}");
}

#[test]
fn plain_gives_the_same_answer() {
    let place = Place::new();
    for problem in ["--kind wang --colors 2", "--kind corner --colors 2"] {
        let found = place.run(&format!("find {problem} --plain")).exits(0);
        place.feed("verify -", &found.stdout).exits(0);
    }
}

/// The automorphism is chosen, told, and can be asked for by what is told.
#[test]
fn an_automorphism_is_chosen() {
    let four = "find --kind corner --colors 4 --values random --seed 1 --json --automorphism";
    let chosen = run(&format!("{four} auto --quiet")).exits(0);
    assert_eq!(chosen.stderr, "tilepack: --automorphism 4,0:1,2,3,0\n");
    let (chosen, asked) = (chosen.json(), run(&format!("{four} 4,0:1,2,3,0")).exits(0).json());
    assert_eq!(chosen["automorphism"], "4,0:1,2,3,0");
    assert_eq!(chosen["tiles"], asked["tiles"]);
    let counted = run("count --kind corner --colors 3 --set compact --automorphism auto").exits(0);
    assert!(counted.stderr.starts_with("tilepack: --automorphism 3,0:1,2,0\n"), "{counted:#?}");
    let none = run("find --kind wang --colors 2,3 --automorphism auto").exits(2);
    assert!(none.stderr.contains("no part of a side of 9x4 is a step for the set"), "{none:#?}");
}
