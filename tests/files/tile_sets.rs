//! Tile sets: the order of the sides, the palettes, and what is refused.

use crate::input;
use tilepack::store::read_tile_set;
use tilepack::tiles::{Colors, Members, TileId};

#[test]
fn tile_sets_list_corners_from_the_north_west() {
    let text = r#"{"kind":"corner","tiles":[[0,1,2,0],[3,0,0,0]]}"#;
    let set = read_tile_set(&input(text), None).unwrap().set;
    assert_eq!(set.colors(), Colors::one(4).unwrap());
    // NE 1, SE 2, SW 0, NW 0 over four colors, and NW 3 alone.
    assert_eq!(set.members(), &Members::Explicit(vec![TileId(3), TileId(64 + 32)]));
    let set = read_tile_set(&input(text), Some(Colors::one(5).unwrap())).unwrap().set;
    assert_eq!(set.members(), &Members::Explicit(vec![TileId(3), TileId(125 + 50)]));
    let text = r#"{"kind":"wang","tiles":[[0,1,2,0],[1,0,0,0]],"horizontal_colors":9}"#;
    let set = read_tile_set(&input(text), None).unwrap().set;
    assert_eq!(set.colors(), Colors::pair(3, 2).unwrap());
}

/// Tile sets that are refused, and why.
const TILE_SETS: &[(&str, &str)] = &[
    (
        "{\"kind\":\"wang\",\n\"tiles\":[[0,1,0,1],[0,1,0,1]]}",
        "in:2:28: tile [0, 1, 0, 1] is listed twice",
    ),
    (
        "{\"kind\":\"wang\",\"tiles\":[[0,1,0]]}",
        "in:1:31: invalid length 3, expected a Wang tile [N, E, S, W]",
    ),
    (
        "{\"kind\":\"wang\",\"tiles\":[[0,1,0,1,0]]}",
        "in:1:35: invalid length 5, expected a Wang tile [N, E, S, W]",
    ),
    (
        "{\"kind\":\"wang\",\"tiles\":[[0,1,0,255]]}",
        "in:1:32: invalid value: integer `255`, expected a color from 0 to 254",
    ),
    (
        "{\"kind\":\"wang\",\"tiles\":[[0,1,0,-1]]}",
        "in:1:32: invalid type: integer `-1`, expected a color from 0 to 254",
    ),
    (
        "{\"kind\":\"wang\",\"colors\":[2,1],\"tiles\":[[1,0,1,0],[0,1,0,0]]}",
        "in:1:53: invalid value: integer `1`, expected a color from 0 to 0",
    ),
    (
        "{\"kind\":\"corner\",\"colors\":[2,1],\"tiles\":[[1,0,1,0]]}",
        "in:1:27: a set of corner tiles has one number of colors, but 2,1 was given",
    ),
    (
        "{\"kind\":\"domino\",\"colors\":[2,1],\"tiles\":[[1,0]]}",
        "in:1:27: a set of domino tiles has one number of colors, but 2,1 was given",
    ),
    ("{\"kind\":\"domino\",\"tiles\":[]}", "in:1:26: the set holds no tile"),
    ("{\"kind\":\"domino\"}", "in:1:1: expected a field \"tiles\""),
    ("{\"tiles\":[[1,0]]}", "in:1:1: expected a field \"kind\""),
    (
        "{\"kind\":\"domino\",\"name\":7,\"tiles\":[[1,0]]}",
        "in:1:25: invalid type: integer `7`, expected a string",
    ),
    ("{\"kind\":\"domino\",\"tiles\":[[1,0]]} {}", "in:1:35: trailing characters"),
    ("[[1,0]]", "in:1:1: expected '{', the beginning of a tile set"),
];

#[test]
fn wrong_tile_sets_are_refused_with_a_place() {
    for &(text, message) in TILE_SETS {
        let error = read_tile_set(&input(text), None).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let text = "{\"kind\":\"wang\",\"tiles\":[[0,1,0,1],\n[0,3,0,1]]}";
    let error = read_tile_set(&input(text), Some(Colors::one(2).unwrap())).unwrap_err();
    assert_eq!(
        error.to_string(),
        "in:2:4: invalid value: integer `3`, expected a color from 0 to 1"
    );
    let text = "{\"kind\":\"wang\",\"colors\":3,\"tiles\":[[0,1,0,1]]}";
    let error = read_tile_set(&input(text), Some(Colors::one(2).unwrap())).unwrap_err();
    assert_eq!(error.to_string(), "in:1:25: colors 3 in the file, but 2 was asked for");
}
