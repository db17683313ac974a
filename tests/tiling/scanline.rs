//! Tilings laid tile by tile, and what is counted in windows.

use crate::complete;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::tiling::{
    Coloring, Compact, Halton, Laid, Rule, Tiling, TilingError, alternating, scanline, stats,
};
use tilepack::torus::Shape;

fn square(side: u64) -> Shape {
    Shape::new(side, side).unwrap()
}

fn explicit(kind: Kind, colors: u64, tiles: Vec<TileId>) -> TileSet {
    TileSet::new(kind, Colors::one(colors).unwrap(), Members::Explicit(tiles)).unwrap()
}

/// Tiles of complete, compact and other sets fit, all of them occur, as evenly as they should.
#[test]
fn sets_are_laid() {
    // The 2 C^2 Wang tiles with (S, E) = (W, N), or both one more.
    let wang = (0..3u32).flat_map(|n| (0..3).map(move |w| (n, w))).flat_map(|(n, w)| {
        [0, 1].map(|more| TileId(((n * 3 + (n + more) % 3) * 3 + (w + more) % 3) * 3 + w))
    });
    for (set, entropy) in [
        (complete(Kind::Corner, "3"), 3f64.log2()),
        (complete(Kind::Wang, "3"), 9f64.log2()),
        (complete(Kind::Wang, "2,3"), 6f64.log2()),
        (Rule::Difference.set(Colors::one(3).unwrap()).unwrap(), 1.0),
        (Rule::Xor.set(Colors::one(4).unwrap()).unwrap(), 1.0),
        (Rule::Diagonal.set(Colors::one(3).unwrap()).unwrap(), 1.0),
        (explicit(Kind::Wang, 3, wang.collect()), 1.0),
        (explicit(Kind::Wang, 3, alternating(3)), 3f64.log2()),
    ] {
        let shape = square(200);
        let Laid { tiles, entropy: found } = scanline(&set, -100, 7, shape, 1).unwrap();
        let counted = stats(set.kind(), set.colors(), shape, &tiles, Some(&set));
        assert_eq!(counted.misfits, 0, "{set:?}");
        assert_eq!(counted.seen, set.size(), "{set:?}");
        // The first row and column have more freedom.
        assert!((found - entropy).abs() < 0.03, "{found} for {entropy}");
        assert!(counted.chi2_per_df.unwrap() < 2.5, "{counted:?}");
    }
}

/// Where no tile fits, the place is told; sets that do not name their tiles are refused.
#[test]
fn dead_ends_are_told() {
    let lonely = explicit(Kind::Wang, 2, vec![TileId(4)]);
    let ended = scanline(&lonely, 0, 0, square(9), 1);
    assert_eq!(ended, Err(TilingError::NothingFits { x: 1, y: 8 }));
    let colors = Colors::one(3).unwrap();
    let compact = TileSet::new(Kind::Corner, colors, Members::Compact).unwrap();
    assert_eq!(scanline(&compact, 0, 0, square(3), 1), Err(TilingError::NoTiles));
}

/// A scanline tiling of an xor set with its coins in the right places is the direct one: both have
/// the same numbers; here, the same counts within chance.
#[test]
fn direct_tilings_are_like_laid_ones() {
    for colors in [3usize, 4] {
        let compact = Compact::of(colors, 1).unwrap();
        let set = compact.rule().set(Colors::one(colors as u64).unwrap()).unwrap();
        let tiling = Tiling::new(Kind::Corner, set.colors(), Coloring::Compact(compact)).unwrap();
        let shape = square(256);
        let direct =
            stats(Kind::Corner, set.colors(), shape, &tiling.window(0, 0, shape), Some(&set));
        let laid = scanline(&set, 0, 0, shape, 1).unwrap();
        let laid = stats(Kind::Corner, set.colors(), shape, &laid.tiles, Some(&set));
        for counted in [direct, laid] {
            assert_eq!((counted.misfits, Some(counted.seen)), (0, counted.tiles));
            let equal = counted.equal_neighbors.unwrap();
            assert!((equal - 8.0 / colors as f64).abs() < 0.04, "{counted:?}");
            assert!(counted.information < 4e-4, "{counted:?}");
            assert!(counted.row_agreement < 0.5 && counted.column_agreement < 0.5, "{counted:?}");
            assert!(counted.chi2_per_df.unwrap() < 2.0, "{counted:?}");
        }
    }
}

/// What is counted, on a window made by hand.
#[test]
fn counts_are_those_of_the_definition() {
    // Two colors in stripes: every column is one color, so rows agree and columns tell each other.
    let tiling =
        Tiling::new(Kind::Corner, Colors::one(2).unwrap(), Coloring::Hash { seed: 1 }).unwrap();
    let striped: Vec<TileId> = (0..64)
        .map(|at| {
            let [west, east] = [at % 8 % 2, (at % 8 + 1) % 2];
            Kind::Corner.pack(&[east, east, west, west], tiling.colors()).unwrap()
        })
        .collect();
    let found = stats(Kind::Corner, tiling.colors(), square(8), &striped, None);
    assert_eq!((found.misfits, found.seen, found.tiles), (0, 2, None));
    assert_eq!(found.equal_neighbors, Some(2.0));
    assert_eq!((found.row_agreement, found.column_agreement), (1.0, 1.0));
    assert!(found.information > 0.9, "{found:?}");
    // One tile turned to another: it fits none of its four neighbors.
    let mut broken = striped;
    broken[27] = TileId(15 - broken[27].0);
    let only = explicit(Kind::Corner, 2, vec![TileId(3), TileId(12)]);
    let found = stats(Kind::Corner, tiling.colors(), square(8), &broken, Some(&only));
    assert_eq!(found.misfits, 4);
    // Outside the set, and fits only in the east.
    broken[27] = TileId(0);
    let found = stats(Kind::Corner, tiling.colors(), square(8), &broken, Some(&only));
    assert_eq!(found.misfits, 4);
}

/// The mean number of equal neighbors of Halton colorings, on a grid in print; the whole table is in
/// benches/runs.
#[test]
fn equal_neighbors_of_halton_colorings() {
    let grid = Halton::of_points(1 << 12, 3u64.pow(7)).unwrap();
    for (colors, expected) in [(2, 3.4868), (3, 2.1779), (6, 0.8213)] {
        let colors = Colors::one(colors).unwrap();
        let tiling = Tiling::new(Kind::Corner, colors, Coloring::Halton(grid)).unwrap();
        let shape = square(1000);
        let tiles = tiling.window(0, 0, shape);
        let found = stats(Kind::Corner, colors, shape, &tiles, None).equal_neighbors.unwrap();
        assert!((found - expected).abs() < 5e-4, "{colors}: {found}, expected {expected}");
    }
}
