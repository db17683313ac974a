//! Endless tilings: the published vectors, the oracle of the Halton sequence itself, and where
//! tiles lie in packings.

#![allow(clippy::unwrap_used, clippy::panic)]

mod cells;
mod compact;
mod halton;
mod mixed;
mod rows;
mod scanline;
mod vectors;

use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::tiling::hash::{hash3, mix, uni};
use tilepack::tiling::{ColorMap, Coloring, Tiling, TilingError};
use tilepack::torus::{Packing, Shape};

pub(crate) fn complete(kind: Kind, colors: &str) -> TileSet {
    TileSet::new(kind, colors.parse().unwrap(), Members::Complete).unwrap()
}

pub(crate) fn hashed(kind: Kind, colors: &str, seed: u32) -> Tiling {
    Tiling::new(kind, colors.parse().unwrap(), Coloring::Hash { seed }).unwrap()
}

/// The vectors that fix the hash for all programs.
#[test]
fn hashes_are_those_published() {
    assert_eq!([0, 1, 2, 3].map(mix), [0, 0x6889_90c0, 0xd113_2181, 0x53f1_e9dd]);
    assert_eq!(hash3(1, 0, 0), 0xd661_ff16);
    assert_eq!(hash3(1, -1i32 as u32, 2), 0xe53d_87ec);
    assert_eq!((uni(u32::MAX, 3), uni(0, 3), uni(1 << 31, 5)), (2, 0, 2));
}

/// The tile at a place from the definition: lattice points for corners, edges in between.
#[test]
fn sides_are_the_colors_around_a_tile() {
    let color = |x: i64, y: i64, n| uni(hash3(7, x as u32, y as u32), n) as u8;
    let corner = hashed(Kind::Corner, "3", 7);
    let wang = hashed(Kind::Wang, "2,5", 7);
    for (x, y) in
        [(0, 0), (-1, 2), (-40, -7), (i64::from(i32::MAX), i64::from(i32::MIN)), (1 << 40, 5)]
    {
        let h = |x, y| color(x, y, 3);
        assert_eq!(corner.sides(x, y), [h(x + 1, y + 1), h(x + 1, y), h(x, y), h(x, y + 1)]);
        let n = color(2 * x + 1, 2 * y + 2, 2);
        let e = color(2 * x + 2, 2 * y + 1, 5);
        let s = color(2 * x + 1, 2 * y, 2);
        let w = color(2 * x, 2 * y + 1, 5);
        assert_eq!(wang.sides(x, y), [n, e, s, w]);
    }
}

/// Neighbors agree, tiles have the numbers that sets give them, and by hash all of them occur.
#[test]
fn tilings_are_tilings() {
    let tilings = [("corner", "3", "hash"), ("wang", "3", "hash"), ("wang", "2,3", "hash")]
        .into_iter()
        .chain([("corner", "3", "halton"), ("wang", "3", "halton"), ("wang", "2,3", "halton")]);
    for (kind, colors, coloring) in tilings {
        let kind: Kind = kind.parse().unwrap();
        let colors: Colors = colors.parse().unwrap();
        let coloring = match coloring {
            "hash" => Coloring::Hash { seed: 1 },
            _ => {
                let shape = Shape::new(256, 256).unwrap();
                Coloring::Halton(tilepack::tiling::Halton::of_tiles(kind, shape).unwrap())
            }
        };
        let tiling = Tiling::new(kind, colors, coloring).unwrap();
        let mut seen = vec![false; kind.tiles(colors) as usize];
        for y in -40..41 {
            for x in -40..41 {
                let sides = tiling.sides(x, y);
                let (east, north) = (tiling.sides(x + 1, y), tiling.sides(x, y + 1));
                match kind {
                    Kind::Corner => {
                        assert_eq!((sides[0], sides[1]), (east[3], east[2]));
                        assert_eq!((sides[0], sides[3]), (north[1], north[2]));
                    }
                    _ => assert_eq!((sides[1], sides[0]), (east[3], north[2])),
                }
                let tile = tiling.tile(x, y);
                assert_eq!(kind.pack(&sides, colors), Ok(tile));
                seen[tile.index()] = true;
            }
        }
        let hashed = matches!(tiling.coloring(), Coloring::Hash { .. });
        assert!(!hashed || seen.iter().all(|&seen| seen), "{kind} {colors}: not every tile occurs");
    }
}

/// A window lists rows from the north, and its south-west tile is the one named.
#[test]
fn windows_are_read_as_pictures() {
    let tiling = hashed(Kind::Corner, "4", 3);
    let window = tiling.window(-2, 5, Shape::new(3, 2).unwrap());
    let expected = [(-2, 6), (-1, 6), (0, 6), (-2, 5), (-1, 5), (0, 5)];
    assert_eq!(window, expected.map(|(x, y)| tiling.tile(x, y)));
}

/// A packing as a map: its cells again, row 0 in the north, (0, 0) in the south-west.
#[test]
fn maps_repeat_their_torus() {
    for (kind, colors) in [(Kind::Corner, "3"), (Kind::Wang, "2,3")] {
        let set = complete(kind, colors);
        let shape = Shape::default_for(&set).unwrap();
        let packing = tilepack::construct::construct(&set, shape, None).unwrap().packing();
        let map = Coloring::Map(ColorMap::of(&packing).unwrap());
        let tiling = Tiling::new(kind, set.colors(), map).unwrap();
        let (width, height) = (shape.width() as i64, shape.height() as i64);
        for y in -2 * height..2 * height {
            for x in -2 * width..2 * width {
                let row = (-1 - y).rem_euclid(height) as usize;
                let column = x.rem_euclid(width) as usize;
                assert_eq!(tiling.tile(x, y), packing.tile(shape.cell(row, column)));
            }
        }
        assert_eq!(tiling.tile(0, 0), packing.tile(shape.cell(shape.height() - 1, 0)));
    }
}

#[test]
fn what_cannot_be_a_tiling_is_refused() {
    let colors = Colors::one(2).unwrap();
    let hash = Coloring::Hash { seed: 0 };
    assert_eq!(Tiling::new(Kind::Domino, colors, hash), Err(TilingError::Dominoes));
    let set = complete(Kind::Corner, "2");
    let shape = Shape::new(2, 1).unwrap();
    let tiles = [1, 2].map(tilepack::tiles::TileId).to_vec();
    let broken = ColorMap::of(&Packing::new(set.clone(), shape, false, tiles));
    assert!(matches!(broken, Err(TilingError::MapDoesNotFit { .. })), "{broken:?}");
    let tiles = [0, 0].map(tilepack::tiles::TileId).to_vec();
    let map = ColorMap::of(&Packing::new(set, shape, false, tiles)).unwrap();
    let other = Tiling::new(Kind::Corner, Colors::one(3).unwrap(), Coloring::Map(map));
    assert!(matches!(other, Err(TilingError::OtherMap { .. })), "{other:?}");
}
