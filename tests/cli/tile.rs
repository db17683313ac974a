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
    place.write("sum.txt", "0.5,0.5\n0.5,0.4\n");
    place.write("half.txt", "0.5,0.5\n");
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
        ("tile --packing compact.json --coloring compact 0 0", "the compact difference set"),
        ("tile --kind wang --colors 2,3 --coloring compact 0 0", "one palette"),
        ("tile --kind wang --colors 2 --coloring diagonal 0 0", "expected corner tiles"),
        ("tile --kind corner --colors 2 --coloring two-hash 0 0", "not a tiling of corner tiles"),
        ("tile --kind corner --colors 65 --coloring compact 0 0", "65 colors: expected 2 to 64"),
        ("tile --kind corner --colors 1 --coloring compact 0 0", "1 colors: expected 2 to 64"),
        ("tile --kind corner --colors 200 --coloring diagonal 0 0", "expected 2 to 128 colors"),
        ("tile --coloring scanline 0 0", "--kind corner|wang is missing"),
        ("tile --kind corner --colors 3 --set compact --coloring scanline 0 0", "does not say"),
        ("tile --kind domino --colors 3 --coloring scanline 0 0", "dominoes have no endless"),
        (
            "tile --coloring probabilities:sum.txt 0 0",
            "sum.txt:2:1: the probabilities add up to 0.9",
        ),
        ("tile --coloring probabilities:none.txt 0 0", "none.txt"),
        ("tile --coloring probabilities:0x3:half.txt 0 0", "at least 1"),
        ("tile --kind wang --coloring probabilities:half.txt 0 0", "not a tiling of wang tiles"),
        ("tile --colors 3 --coloring probabilities:half.txt 0 0", "half.txt has 2 colors"),
        ("tile --kind corner --colors 3 0 0 --stats", "--size"),
        ("tile --kind corner --colors 3 0 0 --set-out no/where.json", "no/where.json"),
        ("tile --kind corner --colors 100 0 0 --size 9x9 --stats", "expected at most 16777216"),
        ("tile --packing broken.txt 0 0", "not a packing"),
        ("tile --packing p.txt --kind corner --colors 3 0 0", "colors 2"),
    ] {
        let refused = place.run(args).exits(2);
        assert_eq!(refused.stdout, "", "{args}");
        assert!(refused.stderr.contains(expected), "{args}: {}", refused.stderr);
    }
}

/// The set of a direct tiling, written and packed; the packing then serves the coloring.
#[test]
fn the_set_of_a_coloring_can_be_packed() {
    let place = Place::new();
    place.run("tile --kind wang --colors 2 --coloring compact 0 0 --set-out set.json").exits(0);
    let sizes = place.run("sets --set set.json --json").exits(0).json();
    assert_eq!(sizes["size"], json!("8"));
    place.run("find --set set.json -o packed.json").exits(0);
    place.run("tile --packing packed.json --coloring compact --seed 5 3 4").exits(0);
    let refused = place.run("tile --packing packed.json 3 4").exits(2);
    assert!(refused.stderr.contains("needs the complete set"), "{refused:?}");
    let shader = place.run("export packed.json --to glsl-330 --coloring compact --seed 5").exits(0);
    assert!(shader.stdout.contains("edges by sums of one hash a corner, with seed 5"));
    let refused = place.run("export packed.json --to wgsl --coloring scanline").exits(2);
    assert!(refused.stderr.contains("only tile --size knows it"), "{refused:?}");
}

/// From a packing of a compact corner set to its atlas and its shader.
#[test]
fn compact_corner_sets_end_to_end() {
    let place = Place::new();
    let solutions = concat!(env!("CARGO_MANIFEST_DIR"), "/solutions/corner-difference-3-9x6.json");
    place.write("three.json", std::fs::read_to_string(solutions).unwrap());
    place.run("verify three.json").exits(0);
    place.run("atlas three.json -o atlas.png --tile-size 16 --strip 2").exits(0);
    let glsl = place.run("export three.json --to glsl-330 --coloring compact --seed 7").exits(0);
    assert!(glsl.stdout.contains("the compact difference set (NE - NW - SE + SW is 0 or 1 mod C)"));
    place.run("tile --packing three.json --coloring compact -5 7 --size 30x20").exits(0);
    place.run("tile --packing three.json --coloring scanline -5 7 --size 30x20").exits(0);
    place.run("tile --packing three.json --coloring diagonal 0 0").exits(2);
}

/// What is counted; the same as an object.
#[test]
fn windows_are_counted() {
    let args =
        "tile --kind corner --colors 3 --coloring compact --seed 1 0 0 --size 200x100 --stats";
    let said = run(args).exits(0);
    assert!(said.stdout.starts_with("20000 tiles: 0 misfits\n54 of 54 tiles seen, chi2/df "));
    assert!(said.stdout.ends_with("0.9966 bits of freedom a tile\n"), "{}", said.stdout);
    let object = run(&format!("{args} --json")).exits(0).json();
    assert_eq!(
        names(&object),
        [
            "chi2_per_df",
            "coloring",
            "colors",
            "column_agreement",
            "entropy",
            "equal_neighbors",
            "height",
            "information",
            "kind",
            "lag",
            "misfits",
            "row_agreement",
            "seed",
            "seen",
            "set",
            "width"
        ]
    );
    assert_eq!((&object["misfits"], &object["seen"]), (&json!(0), &json!(54)));
    let equal = object["equal_neighbors"].as_f64().unwrap();
    assert!((equal - 8.0 / 3.0).abs() < 0.05, "{equal}");
    let wang =
        run("tile --kind wang --colors 3 --coloring scanline 0 0 --size 99x99 --stats --json");
    assert_eq!(wang.exits(0).json()["equal_neighbors"], json!(null));
}

/// Colors whose probabilities change from place to place: text and pictures, and the tiles needed.
#[test]
fn maps_of_probabilities() {
    let place = Place::new();
    // Two colors that never meet, with a third between them.
    place.write("p.txt", "1,0,0 0.5,0,0.5 0,0,1 0,0.5,0.5 0,1,0 0,0.5,0.5 0,0,1 0.5,0,0.5\n");
    let said = place.run("tile --coloring probabilities:4x4:p.txt 0 0 --set-out set.json").exits(0);
    assert!(said.stderr.contains("--set pruned:0-1"), "{said:?}");
    let tiles = place.run("sets --set set.json --json").exits(0).json();
    let pruned = place.run("sets --kind corner --colors 3 --set pruned:0-1 --json").exits(0).json();
    assert_eq!((&tiles["size"], &pruned["size"]), (&json!("31"), &json!("31")));
    let far = "tile --coloring probabilities:4x4:p.txt -70 -50 --size 64x64 --stats --json";
    let counted = place.run(far).exits(0).json();
    assert_eq!((&counted["misfits"], &counted["chi2_per_df"]), (&json!(0), &json!(null)));
    // A picture, red, green and blue the same probabilities in every point.
    let mut png = Vec::new();
    let format = tilepack::atlas::Format {
        channels: tilepack::atlas::Channels::Rgb,
        depth: tilepack::atlas::Depth::Eight,
        light: tilepack::atlas::Light::Srgb,
    };
    let image = tilepack::atlas::Image::from_data(1, 1, format, vec![100, 0, 100]).unwrap();
    tilepack::atlas::write_png(&mut png, &image, &[]).unwrap();
    std::fs::write(place.path("p.png"), &png).unwrap();
    place.write("same.txt", "0.5,0,0.5\n");
    let window = |file: &str| {
        place.run(&format!("tile --coloring probabilities:{file} 0 0 --size 9x9 --seed 3")).exits(0)
    };
    assert_eq!(window("p.png").stdout, window("same.txt").stdout);
}
