//! The vectors that fix the colorings for all programs.

use tilepack::tiles::{Colors, Kind, Members, TileId};
use tilepack::tiling::{Block4, Coloring, Permuted, Rule, Sums, Tiling, Xor};

fn rows(from: i64, width: i64, height: i64, color: impl Fn(i64, i64) -> u8) -> Vec<Vec<u8>> {
    (0..height).map(|y| (from..from + width).map(|x| color(x, y)).collect()).collect()
}

/// `pascal`, seed 1, x from -3.
#[test]
fn xor_sets() {
    let two = Xor::new(4, 1).unwrap();
    let expected = [[3, 1, 3, 3, 2, 0, 2, 3], [2, 2, 2, 2, 1, 3, 2, 2], [2, 0, 0, 0, 3, 1, 3, 3]];
    assert_eq!(rows(-3, 8, 3, |x, y| two.color(x, y)), expected);
    let three = Xor::new(8, 1).unwrap();
    let expected = [[7, 1, 7, 7, 2, 4, 6, 3], [2, 6, 2, 2, 1, 3, 2, 2], [2, 0, 4, 4, 3, 1, 7, 3]];
    assert_eq!(rows(-3, 8, 3, |x, y| three.color(x, y)), expected);
}

/// `table4`, seed 1, x from -3.
#[test]
fn blocks_of_four() {
    let block = Block4 { seed: 1 };
    let expected = [
        [0, 2, 2, 2, 0, 0, 0, 2],
        [0, 0, 1, 2, 1, 1, 2, 1],
        [2, 0, 2, 0, 2, 0, 2, 1],
        [1, 0, 0, 1, 0, 2, 1, 0],
    ];
    assert_eq!(rows(-3, 8, 4, |x, y| block.color(x, y)), expected);
}

#[test]
fn permutations() {
    let short = Permuted::short(12345);
    let p24 =
        [6, 15, 14, 21, 8, 20, 4, 16, 3, 13, 2, 9, 19, 5, 22, 1, 10, 17, 7, 18, 11, 12, 0, 23];
    assert_eq!(short.tables(), [p24.to_vec()]);
    let long = Permuted::long(12345);
    assert_eq!(long.tables()[1], [2, 8, 9, 6, 3, 11, 14, 5, 7, 10, 13, 12, 0, 1, 16, 4, 15]);
    let hashed = |hash: &Permuted| rows(-2, 10, 2, |x, y| hash.hash(x, y) as u8);
    assert_eq!(
        hashed(&short),
        [[6, 23, 4, 1, 22, 12, 3, 11, 8, 10], [15, 6, 16, 10, 1, 0, 13, 12, 20, 17]]
    );
    assert_eq!(
        hashed(&long),
        [[5, 11, 7, 4, 23, 18, 9, 20, 16, 7], [16, 22, 18, 23, 18, 0, 7, 20, 22, 19]]
    );
    // Corner tiles over three colors.
    let tiling = Tiling::new(Kind::Corner, Colors::one(3).unwrap(), Coloring::Permuted(long));
    let tiling = tiling.unwrap();
    let tiles = [0, 1].map(|y| [0, 1, 2, 3].map(|x| tiling.tile(x, y).0));
    assert_eq!(tiles, [[66, 23, 6, 27], [45, 34, 28, 10]]);
    assert_eq!(tiling.sides(0, 0), [2, 1, 1, 0]);
}

/// The long hash repeats after the product of the sizes, and after no n-th part of it.
#[test]
fn the_long_period() {
    let long = Permuted::long(12345);
    let period = long.period() as i64;
    assert_eq!(period, 5_930_659_848);
    let same = |shift: i64| {
        (0..2000i64).all(|at| {
            let (x, y) = (at * 7919 - 999_983, at * 31 - 7);
            long.hash(x, y) == long.hash(x + shift, y)
        })
    };
    assert!(same(period) && same(-period) && same(3 * period));
    // Prime factors: 24 has two of them.
    for part in [2, 3, 17, 19, 23, 29, 31, 37] {
        assert!(!same(period / part), "{part}");
    }
    assert_eq!(Permuted::short(1).period(), 24);
    assert!((0..100).all(|x| (0..100).all(|y| long.hash(x, y) < 24)));
}

/// The largest deviation of the share of a color from an even one, over 300 x 300 points, and the
/// bias of 24 modulo 5.
#[test]
fn colors_of_permutations() {
    let long = Permuted::long(12345);
    let deviation = |colors: usize| {
        let mut counts = vec![0u32; colors];
        for y in 0..300 {
            for x in 0..300 {
                counts[usize::from(long.color(x, y, colors))] += 1;
            }
        }
        let even = 90_000.0 / colors as f64;
        counts.iter().map(|&n| (f64::from(n) / even - 1.0).abs() * 100.0).fold(0.0, f64::max)
    };
    let found = [2, 3, 4, 6, 8].map(deviation);
    for (found, expected) in found.iter().zip([0.02, 0.62, 0.44, 0.79, 1.44]) {
        assert!((found - expected).abs() < 0.006, "{found} for {expected}");
    }
    let short = Permuted::short(12345);
    let mut counts = [0; 5];
    for y in 0..24 {
        for x in 0..24 {
            counts[usize::from(short.color(x, y, 5))] += 1;
        }
    }
    assert_eq!(counts, [120, 120, 120, 120, 96]);
}

/// Edges that are sums of one hash: exactly `C^3` tiles, those of the set; of two hashes: all.
#[test]
fn wang_tiles_by_sums() {
    for c in 2..=5u64 {
        let colors = Colors::one(c).unwrap();
        let one = Sums::one_hash(colors, 1).unwrap();
        for (sums, count) in [(one, c.pow(3)), (Sums::two_hashes(1), c.pow(4))] {
            let tiling = Tiling::new(Kind::Wang, colors, Coloring::Sums(sums)).unwrap();
            let mut seen: Vec<TileId> = Vec::new();
            for y in -60..60 {
                for x in -60..60 {
                    let [n, e, s, w] = tiling.sides(x, y);
                    assert_eq!((e, n), (tiling.sides(x + 1, y)[3], tiling.sides(x, y + 1)[2]));
                    let sum = i32::from(n) - i32::from(e) + i32::from(s) - i32::from(w);
                    assert!(sums.two || sum.rem_euclid(c as i32) == 0);
                    seen.push(tiling.tile(x, y));
                }
            }
            seen.sort_unstable();
            seen.dedup();
            assert_eq!(seen.len() as u64, count);
            match tiling.needs() {
                Members::Explicit(tiles) => assert_eq!(tiles, seen),
                needs => assert!(sums.two && needs == Members::Complete),
            }
        }
    }
    let two = Colors::pair(2, 3).unwrap();
    assert!(Sums::one_hash(two, 1).is_err());
}

/// Windows in print of tilings whose other hashes are not: of the diagonal set over 3 and 6 colors
/// and of blocks of 16 over 4, rows from the south. They obey the rules of their sets.
#[test]
fn windows_in_print_are_of_their_sets() {
    let three = [[2, 0, 0, 0, 0, 1, 2, 2], [2, 2, 0, 0, 0, 1, 2, 1], [1, 2, 1, 1, 0, 1, 0, 1]];
    let six = [[4, 3, 3, 4, 0, 5, 5, 3], [0, 3, 0, 0, 2, 1, 5, 4], [1, 1, 0, 1, 0, 5, 3, 4]];
    let four = [[1, 1, 1, 3, 0, 3, 0, 0], [2, 3, 3, 1, 3, 3, 1, 2], [1, 2, 2, 0, 2, 3, 1, 3]];
    for (rule, colors, rows) in
        [(Rule::Diagonal, 3, three), (Rule::Diagonal, 6, six), (Rule::Difference, 4, four)]
    {
        for two in rows.windows(2) {
            for (south, north) in two[0].windows(2).zip(two[1].windows(2)) {
                let sides = [north[1], south[1], south[0], north[0]];
                assert!(rule.admits(colors, sides), "{rule:?} {colors}: {sides:?}");
            }
        }
    }
}
