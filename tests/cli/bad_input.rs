//! Bad input: exit 2 and one clear line; where the answer is simply no: exit 1 and the reason.

use crate::{CORNER_2, Place, run};

/// Files that the cases name.
fn place() -> Place {
    let place = Place::new();
    place
        .write("binary.dat", b"\x89PNG\r\n\x1a\n\0\0")
        .write("empty.txt", "")
        .write("words.txt", "hello world\n")
        .write("corner2.txt", CORNER_2)
        .write("bare.txt", "0 0\n0 1\n")
        .write("ragged.txt", "kind=corner colors=2\n0 0 0\n0 1\n")
        .write("range.txt", "kind=corner colors=2\n0 2\n0 1\n")
        .write("cut.json", "{\"format\":\"tilepack/1\",\"kind\":\"corner\",")
        .write("set.json", "{\"kind\":\"wang\",\"tiles\":[[0,0,0,0],[1,0,1,0]]}")
        .write("twice.json", "{\"kind\":\"wang\",\"tiles\":[[0,0,0,0],[0,0,0,0]]}")
        .write("pins-size.txt", "0 . .\n. . .\n. . .\n")
        .write("pins-clash.txt", "0 . . .\n. . 16 .\n. . . .\n. . . .\n")
        .write("pins-twice.txt", "0 0 . .\n0 0 0 0\n. . 0 0\n. . . .\n")
        .write("pins-wang.txt", "0 15 . .\n. . . .\n. . . .\n. . . .\n");
    std::fs::create_dir(place.path("directory")).unwrap();
    place
}

/// Arguments, and what the complaint contains.
const REFUSED: &[(&str, &str)] = &[
    // Colors.
    ("find --kind corner --colors 0", "--colors 0: 0 colors: expected 1 to 255"),
    ("find --kind corner --colors 256", "256 colors: expected 1 to 255"),
    ("find --kind corner --colors 99999999999999999999", "expected 1 to 255"),
    ("find --kind corner --colors 65 --method search", "65 colors: the search handles up to 64"),
    ("find --kind corner --colors 255 --method search", "255 colors: the search handles up to 64"),
    ("find --kind corner --colors -1", "colors '-1': expected C, or CH,CV"),
    ("find --kind corner --colors two", "colors 'two': expected C, or CH,CV"),
    ("find --kind wang --colors 2,0", "0 colors: expected 1 to 255"),
    ("find --kind corner --colors 2,3", "corner tiles have one number of colors, but 2,3"),
    ("find --kind corner", "--colors C is missing"),
    ("find --colors 2", "--kind corner|wang|domino is missing"),
    ("find --kind wang --colors 12 --method search", "20736 different tiles may occur"),
    // Sets.
    ("find --kind corner --colors 2 --set complet", "set 'complet': expected complete, compact"),
    ("find --kind corner --colors 2 --set pruned:", "set 'pruned:': expected"),
    ("find --kind corner --colors 2 --set pruned:0", "set 'pruned:0': expected"),
    ("find --kind corner --colors 2 --set pruned:0-2", "color 2 is out of range: expected 0 to 1"),
    ("find --kind corner --colors 2 --set pruned:1-1", "excluded pair 1-1: expected two different"),
    ("find --kind domino --colors 2 --set compact", "not for dominoes"),
    ("find --set directory", "directory: is a directory, expected a file"),
    ("find --set binary.dat", "binary.dat: is a binary file"),
    ("find --set twice.json", "twice.json:1:"),
    ("find --set twice.json", "tile [0, 0, 0, 0] is listed twice"),
    ("find --set set.json --kind corner", "set.json: kind wang in the file, but --kind corner"),
    ("find --set set.json --colors 1", "set.json:1:"),
    // Sizes.
    ("find --kind corner --colors 2 --size 4", "size '4': expected WxH"),
    ("find --kind corner --colors 2 --size 4x", "size '4x': expected WxH"),
    ("find --kind corner --colors 2 --size -4x4", "size '-4x4': expected WxH"),
    ("find --kind corner --colors 2 --size 0x4", "both sides must be at least 1"),
    ("find --kind corner --colors 2 --size 4x5", "size 4x5 has 20 cells, but the set has 16 tiles"),
    ("find --kind corner --colors 2 --cover --size 3x5", "at least as many cells"),
    ("find --kind corner --colors 2 --cover --size 60000x60000", "the search handles up to"),
    (
        "find --kind corner --colors 64 --method search",
        "16777216 cells: the search handles up to 65535",
    ),
    ("count --kind corner --colors 12 --up-to-symmetry", "with 12 colors there are more than"),
    ("find --kind corner --colors 2 --size 99999x99999", "more than 4294967295 cells"),
    ("find --kind domino --colors 2 --size 2x2", "one side must be 1"),
    // Automorphisms.
    ("count --kind corner --colors 2 --automorphism 2,0:1,0/0,1", "corner tiles have one palette"),
    ("find --kind corner --colors 3 --automorphism 3", "expected DX,DY:PERM"),
    ("find --kind corner --colors 3 --automorphism 3,0:1,1,2", "not a permutation"),
    ("find --kind corner --colors 3 --automorphism 3,0:0,1", "not a permutation"),
    ("find --kind corner --colors 3 --automorphism 1,0:+1", "the tile would occur twice"),
    ("find --kind corner --colors 3 --automorphism 3,0:1,0,2", "is not the identity"),
    ("find --kind corner --colors 4 --automorphism 8,0:1,0,2,3", "leaves tile"),
    // Pins.
    ("find --kind corner --colors 2 --pin none.txt", "none.txt: no such file"),
    ("find --kind corner --colors 2 --pin pins-size.txt", "size 3x3 in the file, but 4x4"),
    ("find --kind corner --colors 2 --pin pins-clash.txt", "pins-clash.txt:2:5: color '16'"),
    ("find --kind corner --colors 2 --pin pins-twice.txt", "contradictory pins"),
    ("find --kind wang --colors 2 --pin pins-wang.txt", "row 0, column 1: W has color 1"),
    ("find --kind corner --colors 2 --pin directory", "directory: is a directory"),
    ("find --kind corner --colors 2 --pin binary.dat", "binary.dat: is a binary file"),
    (
        "count --kind corner --colors 2 --up-to-symmetry --pin corner2.txt",
        "pins break the symmetry",
    ),
    ("list --kind corner --colors 2 --up-to-symmetry --pin corner2.txt", "pins break the symmetry"),
    // Output.
    ("find --kind corner --colors 2 -o directory", "directory: cannot be written: it is a dir"),
    ("find --kind corner --colors 2 -o no/where.json", "there is no directory no"),
    ("list --kind corner --colors 2 -o directory", "directory: cannot be written"),
    ("list --kind corner --colors 2 --json", "--json needs -o"),
    // Files to check and draw.
    ("verify none.txt", "none.txt: no such file"),
    ("verify directory", "directory: is a directory"),
    ("verify binary.dat", "binary.dat: is a binary file"),
    ("verify empty.txt", "empty.txt: expected a solution"),
    ("verify words.txt", "words.txt:1:1: 'hello'"),
    ("verify bare.txt", "the kind of the grid is not known"),
    ("verify --kind corner bare.txt", "the colors of the grid are not known"),
    ("verify ragged.txt", "ragged.txt:3:4: row 1 has 2 cells, but row 0 has 3"),
    ("verify range.txt", "range.txt:2:3: color '2': expected a number from 0 to 1"),
    ("verify cut.json", "cut.json:1:"),
    ("verify corner2.txt --kind wang", "kind corner in the file, but wang was asked for"),
    ("verify corner2.txt --colors 3", "colors 2 in the file, but 3 was asked for"),
    ("verify corner2.txt --colors 0", "0 colors: expected 1 to 255"),
    ("verify corner2.txt --kind corner --colors 2,3", "corner tiles have one number of colors"),
    ("show none.txt", "none.txt: no such file"),
    ("show directory", "directory: is a directory"),
    ("show binary.dat", "binary.dat: is a binary file"),
    ("show words.txt", "words.txt:1:1: 'hello'"),
    // Sets.
    ("sets --kind corner", "--colors C is missing"),
    ("sets --kind corner --colors 300", "300 colors: expected 1 to 255"),
    ("sets --kind corner --colors 3 --set compact --list", "the search chooses them"),
];

#[test]
fn every_mistake_gets_one_line_and_exit_2() {
    let place = place();
    for (args, complaint) in REFUSED {
        let mut variants = vec![(*args).to_owned()];
        // With --json, verify reports bad files in its object; show has none.
        if !["verify", "show"].iter().any(|c| args.starts_with(c)) && !args.ends_with("--json") {
            variants.push(format!("{args} --json"));
        }
        for args in variants {
            let run = place.run(&args);
            assert_eq!(run.code, 2, "{args}: {run:#?}");
            assert_eq!(run.stdout, "", "{args}");
            assert_eq!(run.stderr.lines().count(), 1, "{args}: {run:#?}");
            assert!(run.stderr.starts_with("tilepack: "), "{args}: {run:#?}");
            assert!(run.stderr.contains(complaint), "{args}: {run:#?}");
        }
    }
}

#[test]
fn mistakes_of_usage_exit_2() {
    for (args, complaint) in [
        ("", "Usage"),
        ("frobnicate", "frobnicate"),
        ("find --kind square --colors 2", "corner, wang, domino"),
        ("find --kind corner --colors 2 --order zigzag", "row, column, diagonal, spiral"),
        ("find --kind corner --colors 2 --values biggest", "lexicographic, random"),
        ("find --kind corner --colors 2 --method guess", "auto, construct, search, beam, anneal"),
        ("find --kind corner --colors 2 --threads 0", "1..=1024"),
        ("find --kind corner --colors 2 --threads many", "invalid"),
        ("find --kind corner --colors 2 --seed -1", "-1"),
        ("find --kind corner --colors 2 --time-limit soon", "as in 90s or 1.5h"),
        ("find --kind corner --colors 2 --time-limit 5x", "as in 90s or 1.5h"),
        ("find --kind corner --colors 2 --node-limit many", "invalid"),
        ("count --kind corner --colors 2 -o file", "-o"),
        ("verify", "FILE"),
        ("show", "FILE"),
        ("show a.txt --color maybe", "auto, always, never"),
    ] {
        let run = run(args).exits(2);
        assert_eq!(run.stdout, "", "{args}");
        assert!(run.stderr.contains(complaint), "{args}: {run:#?}");
    }
}

#[test]
fn names_that_are_not_text_are_no_trouble() {
    #[cfg(unix)]
    {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;
        let odd = OsStr::from_bytes(b"\xff.txt");
        let place = Place::new();
        let run = place.run_with([OsStr::new("verify"), odd], "").exits(2);
        assert!(run.stderr.contains("no such file"), "{run:?}");
        let args = ["find", "--kind", "corner", "--colors", "2", "--set"].map(OsStr::new);
        let run = place.run_with(args.into_iter().chain([odd]), "").exits(2);
        assert!(run.stderr.contains("expected complete, compact"), "{run:?}");
    }
}

/// Arguments, and a part of the reason why there is no packing.
const IMPOSSIBLE: &[(&str, &str)] = &[
    ("--kind corner --colors 2 --size 2x8", "both sides must be at least 3"),
    ("--kind corner --colors 2 --size 8x2", "both sides must be at least 3"),
    ("--kind corner --colors 2 --size 16x1", "a tile is its own neighbor"),
    ("--kind corner --colors 2 --size 1x16", "a tile is its own neighbor"),
    ("--kind corner --colors 1 --set compact", "there is one color"),
    ("--set lonely.json", "unbalanced set: 1 more tiles have color"),
];

#[test]
fn where_the_answer_is_no_it_is_exit_1_with_the_reason() {
    let place = Place::new();
    place.write(
        "lonely.json",
        "{\"kind\":\"wang\",\"tiles\":[[0,0,0,0],[1,0,0,0],[1,0,1,0],[0,1,0,1]]}",
    );
    for (problem, reason) in IMPOSSIBLE {
        let run = place.run(&format!("find {problem}")).exits(1);
        assert!(run.stdout.starts_with("none: "), "{problem}: {run:#?}");
        assert!(run.stdout.contains(reason), "{problem}: {run:#?}");
        assert_eq!(run.stderr, "");

        let found = place.run(&format!("find {problem} --json")).exits(1).json();
        assert_eq!((&found["result"], &found["method"]), (&"none".into(), &"argument".into()));
        assert!(found["reason"].as_str().unwrap().contains(reason));
        assert!(found["file"].is_null());

        let run = place.run(&format!("count {problem}")).exits(1);
        assert!(run.stdout.starts_with("0 packings\n"), "{problem}: {run:#?}");
        let counted = place.run(&format!("count {problem} --json")).exits(1).json();
        assert_eq!((&counted["solutions"], &counted["method"]), (&"0".into(), &"argument".into()));

        let run = place.run(&format!("list {problem} -o list.jsonl --json")).exits(1);
        assert_eq!(run.json()["solutions"], "0");
        assert_eq!(place.read("list.jsonl"), "");
    }
}

#[test]
fn a_file_that_was_there_survives_an_answer_that_is_no() {
    let place = Place::new();
    place.write("old.json", "old");
    place.run("find --kind corner --colors 2 --size 2x8 -o old.json").exits(1);
    assert_eq!(place.read("old.json"), "old");
}
