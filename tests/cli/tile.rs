//! `tile`: places of endless tilings, alone and in windows, and where they lie in a packing.

use crate::{CORNER_2, Place, names, run};
use serde_json::json;

#[test]
fn a_tile_at_a_place() {
    let said = run("tile --kind corner --colors 3 --seed 7 -5 12").exits(0);
    assert_eq!(said.stdout, "tile 64 (NE 2, SE 1, SW 0, NW 1)\n");
    assert_eq!(said.stderr, "");
    let far =
        run("tile --kind wang --colors 2,3 -4611686018427387904 4611686018427387903").exits(0);
    assert!(far.stdout.starts_with("tile "), "{far:?}");
}

/// A packing repeated is a tiling, whose cells are those of the packing.
#[test]
fn windows_of_a_map() {
    let place = Place::new();
    place.write("p.txt", CORNER_2);
    let solution = place.run("find --kind corner --colors 2 --method search -o p.json").exits(0);
    assert!(solution.stderr.contains("p.json"));
    let window = place.run("tile --packing p.json --coloring map:p.json 0 0 --size 4x4").exits(0);
    let rows: Vec<&str> = window.stdout.lines().collect();
    assert!(rows[0].starts_with("# corner tiles over 2 colors; x 0 to 3, y 0 to 3"), "{rows:?}");
    let packing: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    for (row, numbers) in rows[1..].iter().enumerate() {
        let numbers: Vec<u64> =
            numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
        assert_eq!(json!(numbers), packing["tiles"][row]);
    }
    let object =
        place.run("tile -1 -1 --packing p.json --coloring map:p.json --json").exits(0).json();
    assert_eq!(names(&object), ["coloring", "colors", "kind", "seed", "tiles"]);
    let tile = &object["tiles"][0];
    assert_eq!(names(tile), ["column", "row", "sides", "tile", "x", "y"]);
    assert_eq!((&tile["row"], &tile["column"]), (&json!(0), &json!(3)));
    assert_eq!(tile["tile"], packing["tiles"][0][3]);
    // A grid of lattice colors will do as well.
    let same = place.run("tile --packing p.json --coloring map:p.txt 0 0 --size 4x4").exits(0);
    assert_eq!(same.stdout, window.stdout);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let place = Place::new();
    place.write("p.txt", CORNER_2);
    place.write("broken.txt", "kind=wang colors=2\n0 15\n");
    place.run("find --kind corner --colors 3 --set compact -o compact.json").exits(0);
    for (args, expected) in [
        ("tile --colors 3 0 0", "--kind corner|wang is missing"),
        ("tile --kind corner 0 0", "--colors C is missing"),
        ("tile --kind domino --colors 3 0 0", "dominoes have no endless tiling"),
        (
            "tile --kind corner --colors 3 --coloring spots 0 0",
            "expected hash, halton:WxH or map:FILE",
        ),
        (
            "tile --kind corner --colors 3 --coloring halton:0x4 0 0",
            "both sides must be at least 1",
        ),
        ("tile --kind wang --colors 3 --coloring halton:4000000000x1 0 0", "halton 4000000000x1"),
        ("tile --kind corner --colors 3 --coloring halton:9x9 --seed 3 0 0", "a seed goes with"),
        ("tile --kind corner --colors 3 --coloring map:none.txt 0 0", "none.txt"),
        ("tile --coloring map:broken.txt 0 0", "row 0, column"),
        ("tile --kind corner --colors 3 --coloring map:p.txt 0 0", "colors 2"),
        ("tile --kind corner --colors 3 --seed 4294967296 0 0", "4294967296"),
        ("tile --kind corner --colors 3 4611686018427387905 0", "expected a number from -2^62"),
        ("tile --kind corner --colors 3 0 0 --size 5000x5000", "25000000 tiles, expected at most"),
        ("tile --packing compact.json 0 0", "needs the complete set"),
        ("tile --packing broken.txt 0 0", "not a packing"),
        ("tile --packing p.txt --kind corner --colors 3 0 0", "colors 2"),
    ] {
        let refused = place.run(args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(expected), "{args}: {}", refused.stderr);
    }
}
