//! Halton colorings: the published vectors, the sequence itself, and how well colors keep apart.

use tilepack::tiles::Kind;
use tilepack::tiling::Halton;
use tilepack::torus::Shape;

/// Points, then n1, n2, p1, p2, m1, m2, the visit of (5, 7), the colors of (0..16, 0) for C = 6.
#[test]
fn parameters_and_visits_are_those_published() {
    type Row = ((u64, u64), [u64; 6], u64, [u8; 16]);
    let rows: [Row; 5] = [
        ((17, 9), [5, 2, 32, 9, 25, 2], 212, [0, 3, 1, 4, 0, 3, 2, 5, 3, 0, 4, 1, 4, 1, 5, 2]),
        ((31, 31), [5, 4, 32, 81, 17, 38], 1908, [0, 3, 1, 4, 0, 3, 2, 5, 0, 3, 1, 4, 1, 4, 2, 5]),
        (
            (257, 257),
            [9, 6, 512, 729, 361, 215],
            25920,
            [0, 3, 1, 4, 0, 3, 2, 5, 3, 0, 4, 1, 4, 1, 5, 2],
        ),
        (
            (1025, 1025),
            [11, 7, 2048, 2187, 1827, 236],
            4_416_768,
            [0, 3, 4, 1, 2, 5, 0, 3, 1, 4, 5, 2, 3, 0, 1, 4],
        ),
        (
            (4097, 4097),
            [13, 8, 8192, 6561, 2657, 4433],
            21_648_384,
            [0, 3, 1, 4, 0, 3, 2, 5, 0, 3, 1, 4, 1, 4, 2, 5],
        ),
    ];
    for ((width, height), parameters, visit, colors) in rows {
        let h = Halton::of_points(width, height).unwrap();
        let found = [h.n1.into(), h.n2.into(), h.p1, h.p2, h.m1, h.m2];
        assert_eq!(found, parameters, "{width}x{height}");
        assert_eq!(h.visit(5, 7), visit, "{width}x{height}");
        let row: Vec<u8> = (0..16).map(|x| h.color(x, 0, 6)).collect();
        assert_eq!(row, colors, "{width}x{height}");
    }
}

#[test]
fn the_grid_of_8x9_is_that_published() {
    let halton = Halton::of_points(8, 9).unwrap();
    let rows = [
        [0, 36, 18, 54, 9, 45, 27, 63],
        [48, 12, 66, 30, 57, 21, 3, 39],
        [24, 60, 42, 6, 33, 69, 51, 15],
        [64, 28, 10, 46, 1, 37, 19, 55],
        [40, 4, 58, 22, 49, 13, 67, 31],
        [16, 52, 34, 70, 25, 61, 43, 7],
        [56, 20, 2, 38, 65, 29, 11, 47],
        [32, 68, 50, 14, 41, 5, 59, 23],
        [8, 44, 26, 62, 17, 53, 35, 71],
    ];
    for (y, row) in rows.iter().enumerate() {
        for (x, &visit) in row.iter().enumerate() {
            assert_eq!(halton.visit(x as i64, y as i64), visit);
            // Endless: the grid repeated.
            assert_eq!(halton.visit(x as i64 - 8 * 5, y as i64 - 9 * 7), visit);
        }
    }
}

/// The digits of a number behind the point, in the reverse order, times the grid's side.
fn radical_inverse(mut number: u64, base: u64, side: u64) -> i64 {
    let (mut inverse, mut weight) = (0, side / base);
    while number > 0 && weight > 0 {
        inverse += number % base * weight;
        number /= base;
        weight /= base;
    }
    inverse as i64
}

/// The sequence itself, visit by visit.
#[test]
fn visits_are_those_of_the_halton_sequence() {
    for (width, height) in [(8, 9), (17, 9), (31, 31), (3, 100), (1, 1), (257, 2)] {
        let halton = Halton::of_points(width, height).unwrap();
        for visit in 0..halton.points() {
            let x = radical_inverse(visit, 2, halton.p1);
            let y = radical_inverse(visit, 3, halton.p2);
            assert_eq!(halton.visit(x, y), visit, "{width}x{height}");
        }
    }
}

/// The mean number of the 8 neighbors with a point's own color, in a window of 1000 x 1000 points of
/// the grid of 4096 x 2187, for 2 to 8 colors; a hash would give 8/C.
#[test]
fn equal_colors_keep_their_distance() {
    let halton = Halton::of_points(4096, 2187).unwrap();
    let side = 1000usize;
    let visits: Vec<u64> =
        (0..side * side).map(|i| halton.visit((i % side) as i64, (i / side) as i64)).collect();
    let published = [3.4868, 2.1779, 1.5783, 1.1683, 0.8213, 0.7124, 0.6063];
    for (colors, expected) in (2..).zip(published) {
        let color: Vec<u8> =
            visits.iter().map(|visit| (visit * colors / halton.points()) as u8).collect();
        assert_eq!(color[1234], halton.color(234, 1, colors as usize));
        let mut equal = 0u64;
        // Half of the neighbors; every pair counts for both.
        for y in 1..side - 1 {
            for x in 1..side - 1 {
                let at = y * side + x;
                let near = [at + 1, at + side - 1, at + side, at + side + 1];
                let here = color[at];
                equal += 2 * near.into_iter().filter(|&near| color[near] == here).count() as u64;
            }
        }
        let mean = equal as f64 / ((side - 2) * (side - 2)) as f64;
        assert!((mean - expected).abs() < 0.004, "{colors} colors: {mean}, expected {expected}");
    }
}

#[test]
fn grids_of_tiles_hold_their_points() {
    let tiles = Shape::new(16, 8).unwrap();
    let corner = Halton::of_tiles(Kind::Corner, tiles).unwrap();
    assert_eq!((corner.p1, corner.p2), (32, 9));
    // Edges lie on a lattice twice as fine.
    let wang = Halton::of_tiles(Kind::Wang, tiles).unwrap();
    assert_eq!((wang.p1, wang.p2), (64, 27));
    let huge = Shape::new(1 << 31, 1).unwrap();
    assert!(Halton::of_tiles(Kind::Corner, huge).is_ok());
    let error = Halton::of_tiles(Kind::Wang, huge).unwrap_err().to_string();
    assert!(error.contains("2147483648x1"), "{error}");
}
