//! Pieces of tilings: neighbors agree, only tiles of the set occur.

use crate::{complete, packing, row};
use tilepack::atlas::demo::{Demo, How, tiling};
use tilepack::tiles::{Color, Kind, Members, TileId};
use tilepack::torus::{Packing, Shape};

fn lay(packing: &Packing, size: &str, seed: u64) -> Demo {
    tiling(packing, size.parse().unwrap(), seed)
}

/// From the definition: what two neighbors share is of one color.
#[track_caller]
fn check(packing: &Packing, demo: &Demo, how: How) {
    let (w, h) = (demo.shape.width(), demo.shape.height());
    assert_eq!((demo.how, demo.tiles.len()), (how, w * h));
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let sides = |row: usize, column: usize| kind.unpack(demo.tiles[row * w + column], colors);
    for r in 0..h {
        for c in 0..w {
            assert!(packing.tiles.contains(&demo.tiles[r * w + c]));
            let [a, b, s, d] = sides(r, c);
            if kind == Kind::Corner {
                // NE, SE, SW, NW.
                if c + 1 < w {
                    let east = sides(r, c + 1);
                    assert_eq!([a, b], [east[3], east[2]], "row {r}, column {c}");
                }
                if r + 1 < h {
                    let south = sides(r + 1, c);
                    assert_eq!([b, s], [south[0], south[3]], "row {r}, column {c}");
                }
            } else {
                // N, E, S, W.
                let _ = (a, d);
                assert!(c + 1 == w || b == sides(r, c + 1)[3], "row {r}, column {c}");
                assert!(r + 1 == h || s == sides(r + 1, c)[0], "row {r}, column {c}");
            }
        }
    }
}

#[test]
fn complete_sets_by_random_colors() {
    for packing in [complete(Kind::Corner, "3"), complete(Kind::Wang, "3,2")] {
        for size in ["1x1", "17x9", "1x30"] {
            check(&packing, &lay(&packing, size, 5), How::Colors);
        }
        assert_eq!(lay(&packing, "9x9", 1), lay(&packing, "9x9", 1));
        assert_ne!(lay(&packing, "9x9", 1), lay(&packing, "9x9", 2));
        // Every tile occurs, about as often as any other.
        let many = lay(&packing, "90x90", 0);
        let times = |tile: &TileId| many.tiles.iter().filter(|&t| t == tile).count();
        let mean = 8100 / packing.tiles.len();
        assert!(packing.tiles.iter().all(|tile| (mean / 2..mean * 2).contains(&times(tile))));
    }
}

#[test]
fn compact_sets_without_a_step_back() {
    for kind in [Kind::Corner, Kind::Wang] {
        let packing = packing(kind, "3", Members::Compact);
        for seed in 0..5 {
            check(&packing, &lay(&packing, "40x30", seed), How::TileByTile);
        }
        assert_ne!(lay(&packing, "9x9", 1), lay(&packing, "9x9", 2));
    }
}

#[test]
fn other_sets_with_steps_back() {
    let pair = |a, b| (Color(a), Color(b));
    for members in [vec![pair(0, 1)], vec![pair(0, 1), pair(2, 3)]] {
        let packing = row(Kind::Corner, "4", Members::Pruned(members));
        for seed in 0..5 {
            check(&packing, &lay(&packing, "24x24", seed), How::TileByTile);
        }
    }
    // Two colors of bricks that only fit in one way.
    let tiles = [[0, 1, 1, 0], [1, 0, 0, 1], [0, 0, 1, 1], [1, 1, 0, 0]];
    let colors = "2".parse().unwrap();
    let tiles = tiles.map(|sides| Kind::Wang.pack(&sides, colors).unwrap());
    let packing = row(Kind::Wang, "2", Members::Explicit(tiles.to_vec()));
    check(&packing, &lay(&packing, "12x12", 3), How::TileByTile);
}

#[test]
fn where_nothing_fits_the_packing_is_repeated() {
    let alone = row(Kind::Wang, "2", Members::Explicit(vec![TileId(0b0011)]));
    let demo = lay(&alone, "3x2", 0);
    assert_eq!((demo.how, demo.tiles), (How::Repeated, vec![TileId(3); 6]));
    let shape = Shape::new(2, 2).unwrap();
    let mut bricks = row(Kind::Wang, "2", Members::Explicit(vec![TileId(1), TileId(2)]));
    bricks.shape = shape;
    bricks.tiles = vec![TileId(1), TileId(2), TileId(2), TileId(1)];
    let demo = lay(&bricks, "3x3", 0);
    if demo.how == How::Repeated {
        assert_eq!(
            demo.tiles.iter().map(|tile| tile.0).collect::<Vec<_>>(),
            [1, 2, 1, 2, 1, 2, 1, 2, 1]
        );
    }
}
