//! `show`: the drawings, line by line.

use crate::{CORNER_2, Place};

fn drawn(args: &str, content: &str) -> String {
    let place = Place::new();
    place.write("f", content);
    place.run(&format!("show f {args}")).exits(0).stdout
}

const WANG_2: &str = "kind=wang colors=2\n0 4 5 1\n2 6 7 3\n10 14 15 11\n8 12 13 9\n";

#[test]
fn corner_tiles() {
    let expected = "\
packing, complete corner set over 2 colors, 4x4 torus
0───0───0───1───0
│   │   │   │   │
0───0───1───0───0
│   │   │   │   │
1───0───1───1───1
│   │   │   │   │
0───1───1───1───0
│   │   │   │   │
0───0───0───1───0
";
    assert_eq!(drawn("", CORNER_2), expected);
    assert_eq!(drawn("--color never", CORNER_2), expected);
    let indices = drawn("--indices", CORNER_2);
    assert!(indices.contains("│  5 │ 14 │ 15 │ 11 │\n"), "{indices}");
}

#[test]
fn wang_tiles() {
    let expected = "\
packing, complete wang set over 2 colors, 4x4 torus
┌─0─┬─0─┬─0─┬─0─┐
0   0   1   1   0
├─0─┼─0─┼─0─┼─0─┤
";
    assert!(drawn("", WANG_2).starts_with(expected), "{}", drawn("", WANG_2));
    let indices = drawn("--indices", WANG_2);
    assert!(indices.ends_with("└─0──┴─0──┴─0──┴─0──┘\n"), "{indices}");
    assert!(indices.contains("│ 10 │ 14 │ 15 │ 11 │\n"), "{indices}");
}

#[test]
fn dominoes() {
    let ring = "kind=domino colors=2\n0 1 3 2\n";
    assert!(drawn("", ring).ends_with("\n[0 0][0 1][1 1][1 0]\n"));
    assert!(drawn("--indices", ring).ends_with("\n[0 (0) 0][0 (1) 1][1 (3) 1][1 (2) 0]\n"));
    let column = "kind=domino colors=2\n0\n1\n3\n2\n";
    assert!(drawn("", column).ends_with("\n[0 0]\n[0 1]\n[1 1]\n[1 0]\n"));
}

#[test]
fn blocks_of_color() {
    for content in [CORNER_2, WANG_2, "kind=domino colors=2\n0 1 3 2\n"] {
        let plain = drawn("", content);
        let colored = drawn("--color always", content);
        assert!(!plain.contains('\u{1b}') && colored.contains("\u{1b}[0;"));
        // No color runs over the end of a line.
        assert!(colored.lines().skip(1).all(|line| line.ends_with("\u{1b}[0m")));
    }
    // Four characters by two lines a tile; labels once a lattice point.
    let colored = drawn("--color always", CORNER_2);
    let first = "\u{1b}[0;38;5;16;48;5;203m0\u{1b}[0;48;5;203m   ";
    assert_eq!(colored.lines().count(), 1 + 8);
    assert!(colored.lines().nth(1).unwrap().starts_with(first), "{colored:?}");
}

#[test]
fn color_is_for_terminals() {
    // Standard output is a pipe here.
    assert!(!drawn("--color auto", CORNER_2).contains('\u{1b}'));
}

#[test]
fn what_does_not_fit_is_drawn_too() {
    let place = Place::new();
    place.write(
        "swapped.json",
        "{\"format\":\"tilepack/1\",\"kind\":\"corner\",\"colors\":2,\"set\":\"complete\",\"width\":4,\
         \"height\":4,\"topology\":\"torus\",\"tiles\":[[0,4,10,1],[2,12,7,6],[5,15,14,11],[8,9,13,3]]}",
    );
    let shown = place.run("show swapped.json").exits(0);
    assert!(shown.stdout.starts_with("tiles, complete corner set"), "{shown:#?}");
    assert!(shown.stdout.contains("1───×───×───1───1\n"), "{shown:#?}");
    assert!(shown.stderr.contains("not a packing: row 1, column 1: SW corner"), "{shown:#?}");
    assert_eq!(shown.stderr.lines().count(), 1);
    let small = drawn("--kind corner --colors 2", "0 1\n");
    assert!(small.ends_with("0───1───0\n│   │   │\n0───1───0\n"), "{small}");
}

#[test]
fn many_colors_have_labels() {
    let row: Vec<String> = (0..64).map(|color| color.to_string()).collect();
    let shown = drawn("--kind corner --colors 64 --cover", &row.join(" "));
    assert!(shown.contains(" 9───10───11───"), "{shown}");
    let shown = drawn("--kind corner --colors 62 --cover", &row[..62].join(" "));
    assert!(shown.contains("9───a───b───") && shown.contains("z───A───B"), "{shown}");
}

#[test]
fn lists_are_drawn_one_after_the_other() {
    let place = Place::new();
    let list = place.run("list --kind domino --colors 2 --quiet").exits(0).stdout;
    let shown = place.feed("show -", &list).exits(0).stdout;
    assert_eq!(shown.matches("packing, complete domino set").count(), 4);
    assert_eq!(shown.lines().count(), 4 * 2 + 3);
}
