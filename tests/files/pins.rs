//! Pins: which labels they reach, and what is refused.

use crate::{corner_2, input};
use tilepack::store::read_pins;
use tilepack::tiles::{Color, Colors, Kind, Members, TileSet};
use tilepack::torus::{Lattice, Pins, Shape};

/// Pins for a complete corner set over two colors on 4x4 that are refused, and why.
const PINS: &[(&str, &str)] = &[
    ("0 . . 2\n. . . .\n. . . .\n. . . .", "in:1:7: color '2': expected a number from 0 to 1 or ."),
    ("0 . . .\n. . . .\n. . . .", "in: size 4x3 in the file, but 4x4 in the problem"),
    (
        "kind=wang\n0 . . .\n. . . .\n. . . .\n. . . .",
        "in: kind wang in the file, but corner in the problem",
    ),
    (
        "colors=3\n0 . . .\n. . . .\n. . . .\n. . . .",
        "in: colors 3 in the file, but 2 in the problem",
    ),
    (
        r#"{"format":"tilepack/1","kind":"corner","colors":2,"width":4,"height":4,"topology":"torus",
        "tiles":[[0,5,null,null],[null,null,null,null],[null,null,null,null],[null,null,null,null]]}"#,
        "in: row 0, column 1: NW has color 1, but the tile at row 0, column 0 pins this corner, its NE, to color 0",
    ),
    (
        r#"{"format":"tilepack/1","kind":"corner","colors":2,"width":4,"height":4,"topology":"torus",
        "tiles":[[0,null,16,null],[null,null,null,null],[null,null,null,null],[null,null,null,null]]}"#,
        "in:2:26: invalid value: integer `16`, expected a tile number from 0 to 15",
    ),
    (
        r#"{"format":"tilepack/1","kind":"corner","colors":3,"width":4,"height":4,"topology":"torus",
        "tiles":[[0,null,16,null],[null,null,null,null],[null,null,null,null],[null,null,null,null]]}"#,
        "in: colors 3 in the file, but 2 in the problem",
    ),
    (
        r#"{"format":"tilepack/1","kind":"corner","colors":2,"width":4,"height":1,"topology":"torus",
        "tiles":[[0,null,16,null]]} x"#,
        "in:2:37: expected the end of the file",
    ),
];

#[test]
fn wrong_pins_are_refused() {
    let (lattice, set) = corner_2();
    for &(text, message) in PINS {
        let error = read_pins(&input(text), lattice, &set).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn pins_reach_the_labels_of_their_sides() {
    let (lattice, set) = corner_2();
    let grid = read_pins(&input("0 . . 1\n. . . .\n. . . .\n. 1 . ."), lattice, &set).unwrap();
    let pinned = |pins: &Pins| {
        let labels = pins.labels().iter().enumerate();
        labels.filter_map(|(i, color)| color.map(|c| (i, c))).collect::<Vec<_>>()
    };
    assert_eq!(pinned(&grid), [(0, 0), (3, 1), (13, 1)]);
    // Tile 6 of the south-east cell: NE 0, SE 1, SW 1, NW 0, three of them beyond a seam.
    let json = r#"{"format":"tilepack/1","kind":"corner","colors":2,"width":4,"height":4,
        "topology":"torus","tiles":[[null,null,null,null],[null,null,null,null],
        [null,null,null,null],[null,null,null,6]]}"#;
    let pins = read_pins(&input(json), lattice, &set).unwrap();
    assert_eq!(pinned(&pins), [(0, 1), (3, 1), (12, 0), (15, 0)]);

    let wang = TileSet::new(Kind::Wang, Colors::one(2).unwrap(), Members::Complete).unwrap();
    let lattice = Lattice { kind: Kind::Wang, shape: Shape::new(2, 2).unwrap() };
    // Tile 6: N 0, E 1, S 1, W 0.
    let pins = read_pins(&input(". .\n. 6"), lattice, &wang).unwrap();
    assert_eq!(pinned(&pins), [(2, 1), (5, 1), (6, 0), (7, 0)]);
    for (text, message) in [
        (
            "6 0\n. .",
            "in: row 0, column 1: W has color 0, but the tile at row 0, column 0 pins this side, \
             its E, to color 1",
        ),
        (
            "2 .\n0 .",
            "in: row 1, column 0: N has color 0, but the tile at row 0, column 0 pins this side, \
             its S, to color 1",
        ),
    ] {
        let error = read_pins(&input(text), lattice, &wang).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let one_row = Lattice { kind: Kind::Wang, shape: Shape::new(2, 1).unwrap() };
    let error = read_pins(&input("6 ."), one_row, &wang).unwrap_err();
    assert_eq!(
        error.to_string(),
        "in: row 0, column 0: S has color 1, but meets N of the same tile, 0"
    );
}

#[test]
fn pinned_tiles_must_be_in_the_set() {
    let pruned = Members::Pruned(vec![(Color(0), Color(1))]);
    let set = TileSet::new(Kind::Corner, Colors::one(3).unwrap(), pruned).unwrap();
    let lattice = Lattice { kind: Kind::Corner, shape: Shape::new(3, 3).unwrap() };
    assert!(read_pins(&input("0 2 .\n2 . .\n. . ."), lattice, &set).is_ok());
    let error = read_pins(&input("0 2 .\n2 1 .\n. . ."), lattice, &set).unwrap_err();
    assert_eq!(
        error.to_string(),
        "in: row 0, column 0: tile 69 (NE 2, SE 1, SW 2, NW 0) is pinned here, but is not in the set"
    );
    let json = r#"{"format":"tilepack/1","kind":"corner","colors":3,"width":3,"height":3,
        "topology":"torus","tiles":[[null,null,null],[null,1,null],[null,null,null]]}"#;
    let error = read_pins(&input(json), lattice, &set).unwrap_err();
    assert_eq!(
        error.to_string(),
        "in: row 1, column 1: tile 1 (NE 0, SE 0, SW 0, NW 1) is pinned here, but is not in the set"
    );
}
