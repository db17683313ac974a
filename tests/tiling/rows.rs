//! Rows of windows, where work is shared, against the tiles one by one.

use tilepack::tiles::{Colors, Kind};
use tilepack::tiling::{
    Coloring, Compact, Diagonal, Frames, Halton, Permuted, Probabilities, Sums, Tiling,
};
use tilepack::torus::Shape;

/// A tiling of every sort.
fn all() -> Vec<Tiling> {
    let one = |colors: u64| Colors::one(colors).unwrap();
    let mut all = Vec::new();
    let mut add = |kind, colors, coloring| all.push(Tiling::new(kind, colors, coloring).unwrap());
    for kind in [Kind::Corner, Kind::Wang] {
        for colors in [1, 2, 3, 7, 255] {
            let halton = Halton::of_tiles(kind, Shape::new(40, 30).unwrap()).unwrap();
            add(kind, one(colors), Coloring::Hash { seed: 3 });
            add(kind, one(colors), Coloring::Halton(halton));
            add(kind, one(colors), Coloring::Permuted(Permuted::long(3)));
        }
        let large = Halton::of_points(1 << 22, 3u64.pow(16)).unwrap();
        add(kind, one(255), Coloring::Halton(large));
        add(kind, one(2), Coloring::Halton(Halton::of_points(1, 1).unwrap()));
    }
    add(Kind::Wang, Colors::pair(2, 5).unwrap(), Coloring::Hash { seed: 3 });
    add(Kind::Wang, Colors::pair(2, 255).unwrap(), Coloring::Sums(Sums::two_hashes(3)));
    add(Kind::Wang, one(3), Coloring::Sums(Sums::one_hash(one(3), 3).unwrap()));
    for colors in [2usize, 3, 4, 5, 8, 128] {
        add(Kind::Corner, one(colors as u64), Coloring::Compact(Compact::of(colors, 3).unwrap()));
    }
    let frames = Compact::Frames(Frames::new(3, 3).unwrap());
    add(Kind::Corner, one(3), Coloring::Compact(frames));
    let diagonal = Compact::Diagonal(Diagonal::new(7, 3).unwrap());
    add(Kind::Corner, one(7), Coloring::Compact(diagonal));
    let weights = [0.5, 0.5, 0.0, 0.0, 0.25, 0.75].repeat(10);
    let map = Probabilities::new(Shape::new(5, 4).unwrap(), [3, 1], 3, &weights, 3).unwrap();
    add(Kind::Corner, one(3), Coloring::Probabilities(map));
    all
}

#[test]
fn rows_are_tiles_one_by_one() {
    for tiling in all() {
        for (x, y) in [(-3, -5), (17, 30), ((1 << 40) + 1, -(1 << 45)), (-(1 << 62), 1 << 61)] {
            let shape = Shape::new(21, 19).unwrap();
            let window = tiling.window(x, y, shape);
            for (at, tile) in window.iter().enumerate() {
                let (dx, dy) = (at as i64 % 21, 18 - at as i64 / 21);
                let place = (x + dx, y + dy);
                assert_eq!(*tile, tiling.tile(place.0, place.1), "{place:?} {tiling:?}");
            }
        }
    }
}

/// Rows come from the north, and an error ends them.
#[test]
fn rows_end_when_asked() {
    let tiling =
        Tiling::new(Kind::Corner, Colors::one(3).unwrap(), Coloring::Hash { seed: 1 }).unwrap();
    let mut seen = Vec::new();
    let ended = tiling.try_for_each_row(0, 5, Shape::new(4, 9).unwrap(), |y, row| {
        seen.push((y, row.len()));
        if y == 11 { Err("enough") } else { Ok(()) }
    });
    assert_eq!((ended, seen), (Err("enough"), vec![(13, 4), (12, 4), (11, 4)]));
}
