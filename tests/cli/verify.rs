//! `verify`: verdicts, what they say, and exit codes.

use crate::{CORNER_2, Place, names};

const PUBLISHED: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/solutions/published/lagae-dutre-2006-corner-4.txt");

fn verdict(args: &str, content: &str, code: i32) -> String {
    let place = Place::new();
    place.write("f", content);
    place.run(&format!("verify f {args}")).exits(code).stdout
}

#[test]
fn the_published_packing() {
    let place = Place::new();
    let args = ["verify", "--kind", "corner", "--colors", "4", PUBLISHED];
    let verified = place.run_with(args, "").exits(0);
    let expected =
        "valid: complete corner set over 4 colors, 16x16 torus, each of 256 tiles once\n";
    assert!(verified.stdout.ends_with(expected), "{verified:#?}");
    assert_eq!(verified.stderr, "");
}

#[test]
fn words_for_every_sort_of_set() {
    for (content, words) in [
        (CORNER_2, "complete corner set over 2 colors, 4x4 torus, each of 16 tiles once"),
        (
            "kind=domino colors=2\n0 1 3 2\n",
            "complete domino set over 2 colors, ring of 4 (4x1), each of 4 tiles once",
        ),
        (
            "kind=domino colors=2 set=tiles:1,2 cover\n1 2 1 2\n",
            "explicit domino set over 2 colors, ring of 4 (4x1), each of 2 tiles at least once",
        ),
        (
            "kind=domino colors=3 set=pruned:0-1\n0 2 8 7 4 5 6\n",
            "pruned domino set (no 0-1) over 3 colors, ring of 7 (7x1), each of 7 tiles once",
        ),
        (
            "kind=wang colors=2 set=compact\n15 7 13 5\n10 8 2 0\n",
            "compact wang set over 2 colors, 4x2 torus, 8 tiles, two for each (N, W), each once",
        ),
        (
            "kind=wang colors=2,1\n0\n1\n3\n2\n",
            "complete wang set over 2 colors on north and south edges and 1 color on east and west \
             edges, 1x4 torus, each of 4 tiles once",
        ),
    ] {
        assert_eq!(verdict("", content, 0), format!("f: valid: {words}\n"));
    }
}

#[test]
fn what_is_wrong_is_said() {
    // One color changed: three tiles twice or more, three missing, all told.
    let changed = CORNER_2.replace("1 0 1 1", "1 0 1 0");
    let words = verdict("", &changed, 1);
    let lines: Vec<_> = words.lines().collect();
    assert!(lines[0].starts_with("f: not a packing: ") && lines[0].ends_with(" faults"), "{words}");
    assert!(lines[1..].iter().all(|line| line.starts_with("  tile ")), "{words}");
    assert!(words.contains(" occurs 2 times: at row ") && words.contains(" is missing"), "{words}");

    let tiles = "{\"format\":\"tilepack/1\",\"kind\":\"domino\",\"colors\":2,\"set\":\"complete\",\
                 \"width\":4,\"height\":1,\"topology\":\"torus\",\"tiles\":[[0,1,2,3]]}";
    let words = verdict("", tiles, 1);
    assert!(words.contains("row 0, column 2: second end has color 0, but"), "{words}");

    let words = verdict("--quiet", &changed, 1);
    assert!(words.contains("not a packing"), "{words}");
    assert_eq!(verdict("--quiet", CORNER_2, 0), "");
}

#[test]
fn a_wrong_size_is_a_mistake_rather_than_an_answer() {
    let words = verdict("", "kind=corner colors=2\n0 0\n0 1\n", 2);
    assert!(words.contains("size 2x2 has 4 cells, but the set has 16 tiles"), "{words}");
}

#[test]
fn claims_about_bare_grids() {
    let bare = CORNER_2.split_once('\n').unwrap().1;
    verdict("--kind corner --colors 2", bare, 0);
    verdict("--kind corner --colors 2 --set complete", bare, 0);
    verdict("--kind corner --colors 2 --cover", bare, 0);
    verdict("--kind corner --colors 3 --set compact", bare, 2);
    let place = Place::new();
    place.write("ring.json", "{\"kind\":\"domino\",\"tiles\":[[0,1],[1,2],[2,0]]}");
    place.write("ring.txt", "1 5 6\n");
    place.run("verify ring.txt --set ring.json").exits(0);
    place.run("verify ring.txt --set ring.json --kind wang").exits(2);
}

#[test]
fn every_file_is_reported() {
    let place = Place::new();
    place.write("good", CORNER_2).write("bad", CORNER_2.replace("1 0 1 1", "0 0 1 1"));
    let both = place.run("verify bad good").exits(1);
    assert!(both.stdout.contains("bad: not a packing") && both.stdout.contains("good: valid"));
    let all = place.run("verify none bad good").exits(2);
    assert!(all.stdout.contains("bad: not a packing") && all.stdout.contains("good: valid"));
    assert_eq!(all.stderr, "tilepack: none: no such file\n");

    let object = place.run("verify none bad good - --json").exits(2).json();
    assert_eq!(names(&object), ["files"]);
    let files = object["files"].as_array().unwrap();
    assert_eq!(files.len(), 4);
    for file in files {
        assert_eq!(
            names(file),
            [
                "colors", "error", "file", "height", "kind", "packings", "set", "topology",
                "valid", "width"
            ]
        );
    }
    assert_eq!(
        (&files[0]["valid"], &files[0]["error"]),
        (&false.into(), &"none: no such file".into())
    );
    assert!(files[0]["kind"].is_null());
    assert_eq!((&files[1]["valid"], &files[1]["kind"]), (&false.into(), &"corner".into()));
    assert!(files[1]["error"].as_str().unwrap().contains("more faults"));
    assert_eq!((&files[2]["valid"], &files[2]["error"]), (&true.into(), &().into()));
    assert_eq!((&files[2]["colors"], &files[2]["set"]), (&2.into(), &"complete".into()));
    assert_eq!((&files[2]["width"], &files[2]["topology"]), (&4.into(), &"torus".into()));
    assert_eq!(files[3]["file"], "-");
}

#[test]
fn standard_input() {
    let place = Place::new();
    let verified = place.feed("verify -", CORNER_2).exits(0);
    assert!(verified.stdout.starts_with("standard input: valid: "), "{verified:#?}");
    let malformed = place.feed("verify -", "what\n").exits(2);
    assert!(malformed.stderr.starts_with("tilepack: standard input:1:1: "), "{malformed:#?}");
}

#[test]
fn lists_name_the_bad_packing_and_go_on() {
    let place = Place::new();
    let list = place.run("list --kind domino --colors 2 --quiet").exits(0).stdout;
    let bad = list.replacen("[[1,3,2,0]]", "[[1,3,3,0]]", 1);
    assert_ne!(list, bad);
    let verified = place.feed("verify -", &bad).exits(1);
    assert!(verified.stdout.contains("packing 2, line 2: not a packing: "), "{verified:#?}");
    assert!(verified.stdout.ends_with("3 of 4 packings are valid\n"), "{verified:#?}");
    let object = place.feed("verify - --json", &bad).exits(1).json();
    let error = object["files"][0]["error"].as_str().unwrap();
    assert!(error.starts_with("packing 2, line 2: "), "{error}");

    let cut = &list[..list.len() - 10];
    let verified = place.feed("verify -", cut).exits(2);
    assert!(verified.stderr.contains("standard input:4:"), "{verified:#?}");
    assert!(verified.stdout.contains("3 of 3 packings are valid"), "{verified:#?}");
}
