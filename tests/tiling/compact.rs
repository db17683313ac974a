//! Direct tilings of compact sets: no tile but those of the set, all of them, evenly.

use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::tiling::{
    Block4, Coloring, Compact, Diagonal, Frames, PATTERNS, Rule, Tiling, filled, least_side,
};
use tilepack::torus::Shape;

fn compact(colors: u64, compact: Compact) -> Tiling {
    let colors = Colors::one(colors).unwrap();
    Tiling::new(Kind::Corner, colors, Coloring::Compact(compact)).unwrap()
}

/// Every direct tiling, and how wide a window is looked at.
fn all() -> Vec<(Tiling, u64)> {
    let mut tilings = Vec::new();
    for colors in [2, 3, 4, 5, 6, 7, 8, 16] {
        let side = if colors == 16 { 512 } else { 256 };
        tilings.push((compact(colors, Compact::of(colors as usize, 1).unwrap()), side));
    }
    for colors in [2, 3, 4] {
        let frames = Compact::Frames(Frames::new(colors as usize, 1).unwrap());
        tilings.push((compact(colors, frames), 256));
    }
    for colors in [2, 3, 5, 6] {
        let diagonal = Compact::Diagonal(Diagonal::new(colors as usize, 1).unwrap());
        tilings.push((compact(colors, diagonal), 256));
    }
    tilings
}

/// The rules: two tiles for every (NW, SW, SE), balanced, as sets of files have them.
#[test]
fn rules_are_compact_sets() {
    for colors in 1..=9u64 {
        for rule in [Rule::Xor, Rule::Difference, Rule::Diagonal] {
            if rule == Rule::Xor && !colors.is_power_of_two() {
                continue;
            }
            let set = rule.set(Colors::one(colors).unwrap()).unwrap();
            let expected = if colors == 1 { 1 } else { 2 * colors.pow(3) };
            assert_eq!(set.size(), expected, "{rule:?} {colors}");
            let mut shown = vec![[0u64; 4]; colors as usize];
            let mut rest = vec![0; colors.pow(3) as usize];
            let Members::Explicit(tiles) = set.members() else { panic!() };
            for &tile in tiles {
                let sides = Kind::Corner.unpack(tile, set.colors());
                assert!(rule.admits(colors as usize, sides));
                rest[tile.index() % colors.pow(3) as usize] += 1;
                for (side, &color) in sides.iter().enumerate() {
                    shown[usize::from(color)][side] += 1;
                }
            }
            assert!(rest.iter().all(|&n| n == 2.min(colors)), "{rule:?} {colors}");
            assert!(shown.iter().flatten().all(|&n| n == expected / colors), "{rule:?} {colors}");
        }
    }
}

#[test]
fn only_tiles_of_the_set_occur_and_all_of_them() {
    for (tiling, side) in all() {
        let needed = TileSet::new(Kind::Corner, tiling.colors(), tiling.needs()).unwrap();
        let shape = Shape::new(side, side).unwrap();
        let name = format!("{:?}", tiling.coloring());
        let tiles = tiling.window(-100, -90, shape);
        let mut counts = vec![0u32; Kind::Corner.tiles(tiling.colors()) as usize];
        for &tile in &tiles {
            assert!(needed.allows(tile), "{name}: {tile}");
            counts[tile.index()] += 1;
        }
        // 1024 tiles are looked at 64 times each, or 8192 of them 32 times.
        let mean = tiles.len() as f64 / needed.size() as f64;
        let spread = |n: &u32| (f64::from(*n) - mean) / mean.sqrt();
        let worst = needed.allowed().map(|tile| spread(&counts[tile.index()]).abs());
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 6.5, "{name}: {worst} deviations from {mean}");
        let seen = counts.iter().filter(|&&n| n > 0).count() as u64;
        assert_eq!(seen, needed.size(), "{name}");
    }
}

/// Points near each other are independent two by two, but for diagonal sets.
#[test]
fn pairs_of_points_are_even() {
    for (tiling, side) in all() {
        let Coloring::Compact(compact) = tiling.coloring() else { panic!() };
        if compact.rule() == Rule::Diagonal {
            continue;
        }
        let (c, side) = (tiling.colors().horizontal(), side as i64);
        let tiles = tiling.window(0, 0, Shape::new(side as u64, side as u64).unwrap());
        // South-west corners, rows from the north.
        let points: Vec<usize> = tiles.iter().map(|tile| tile.index() / c % c).collect();
        let at = |x: i64, y: i64| points[((side - 1 - y) * side + x) as usize];
        for (dx, dy) in [(1, 0), (0, 1), (1, 1), (1, -1), (2, 0), (4, 0), (0, 4), (2, -2), (4, 4)] {
            let mut pairs = vec![0u32; c * c];
            for y in 4..side - 4 {
                for x in 4..side - 4 {
                    pairs[at(x, y) * c + at(x + dx, y + dy)] += 1;
                }
            }
            let mean = ((side - 8) * (side - 8)) as f64 / (c * c) as f64;
            let worst = pairs.iter().map(|&n| (f64::from(n) - mean).abs() / mean.sqrt());
            let worst = worst.fold(0.0, f64::max);
            assert!(worst < 5.5, "{compact:?} ({dx}, {dy}): {worst}");
        }
    }
}

/// All classes of the table of blocks have their patterns.
#[test]
fn the_table_of_blocks_is_whole() {
    assert_eq!((PATTERNS.patterns.len(), PATTERNS.begins.len()), (65536, 2188));
    let counts: Vec<u32> = PATTERNS.begins.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert_eq!((counts.iter().min(), counts.iter().max()), (Some(&16), Some(&90)));
    // Bits of freedom of a tile: the frame has 7 points a block, the pattern the rest.
    let patterns: f64 = counts.iter().map(|&n| f64::from(n) / 65536.0 * f64::from(n).log2()).sum();
    let uniform: f64 = counts.iter().map(|&n| f64::from(n).log2()).sum::<f64>() / 2187.0;
    let entropy = (7.0 * 3f64.log2() + uniform) / 16.0;
    assert!((entropy - 0.99664).abs() < 5e-6, "{entropy} {patterns}");
    // The frame is not touched.
    let block = Block4 { seed: 9 };
    let frame = |x: i64, y: i64| {
        let hash = tilepack::tiling::hash::hash3(block.frame_seed(), x as u32, y as u32);
        tilepack::tiling::hash::uni(hash, 3) as u8
    };
    for at in -9..9 {
        assert_eq!(block.color(4 * at, 5 * at), frame(4 * at, 5 * at));
        assert_eq!(block.color(3 * at, 8 * at), frame(3 * at, 8 * at));
    }
}

/// Sums are kept, whatever the numbers of colors.
#[test]
fn squares_have_their_sums() {
    for colors in [2, 3, 4, 5, 6, 7, 8, 11] {
        for seed in 0..30u32 {
            let side = least_side(colors) + seed as usize % 4;
            let sum = |at: usize| {
                let hash = tilepack::tiling::hash::hash3(seed, at as u32, 3);
                if seed % 5 == 0 { colors - 1 } else { hash as usize % colors }
            };
            let rows: Vec<usize> = (0..side).map(sum).collect();
            let mut columns: Vec<usize> = (side..2 * side).map(sum).collect();
            let total = |sums: &[usize]| sums.iter().sum::<usize>();
            columns[0] += (total(&rows) + colors * side - total(&columns)) % colors;
            columns[0] %= colors;
            let square = filled(colors, &rows, &columns, seed);
            for line in 0..side {
                let row: usize = (0..side).map(|u| usize::from(square.bits[line * side + u])).sum();
                let column: usize =
                    (0..side).map(|v| usize::from(square.bits[v * side + line])).sum();
                assert_eq!((row % colors, column % colors), (rows[line], columns[line]));
            }
        }
    }
}

/// The bounds in print.
#[test]
fn entropies_of_frames() {
    let entropy = |colors: usize| Frames::new(colors, 0).unwrap().entropy();
    for (colors, expected) in [(3, 0.921), (4, 0.854), (5, 0.765)] {
        let found = entropy(colors);
        assert!((found - expected).abs() < 6e-4, "{colors}: {found}");
    }
}
