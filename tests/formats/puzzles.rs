//! Jigsaw pieces: outlines of neighbors coincide, no outline meets itself, colors that differ do
//! not fit, pieces that are turned do not fit.

use crate::{complete, text};
use tilepack::atlas::formats::puzzle::{LEAST_STEP, Puzzle, most_colors};
use tilepack::atlas::picture::Point;
use tilepack::tiles::Kind;
use tilepack::torus::Packing;

/// Packings of the most colors that a puzzle can have: in corners; nearly so on edges.
fn packings() -> [(Packing, f64); 2] {
    assert_eq!(most_colors(Kind::Corner, 40.0), 6);
    assert_eq!(most_colors(Kind::Wang, 25.0), 8);
    [(complete(Kind::Corner, "6"), 40.0), (complete(Kind::Wang, "8"), 25.0)]
}

/// The four lines of an outline, each from west to east or from north to south: north, east,
/// south, west.
fn lines(outline: &[Point], row: usize, column: usize, side: f64) -> [Vec<Point>; 4] {
    let corner = |dx: usize, dy: usize| ((column + dx) as f64 * side, (row + dy) as f64 * side);
    let find = |corner: Point| outline.iter().position(|&point| point == corner).unwrap();
    let [east, south, west] = [corner(1, 0), corner(1, 1), corner(0, 1)].map(find);
    let part = |from: usize, to: usize| outline[from..=to].to_vec();
    let mut lines =
        [part(0, east), part(east, south), part(south, west), part(west, outline.len() - 1)];
    lines[2].reverse();
    lines[3].reverse();
    lines
}

#[test]
fn outlines_of_neighbors_coincide() {
    for (packing, side) in packings() {
        let puzzle = Puzzle::new(&packing, side).unwrap();
        let (w, h) = (packing.shape.width(), packing.shape.height());
        let of = |row: usize, column: usize| lines(&puzzle.piece(row, column), row, column, side);
        let mut areas = 0.0;
        for (row, column) in (0..w * h).map(|i| (i / w, i % w)) {
            let [north, east, south, west] = of(row, column);
            let (right, below) = (of(row, (column + 1) % w), of((row + 1) % h, column));
            let shifted = |line: &[Point], dx: f64, dy: f64| -> Vec<Point> {
                line.iter().map(|&(x, y)| (x + dx, y + dy)).collect()
            };
            let (seam_x, seam_y) = (column + 1 == w, row + 1 == h);
            if seam_x || seam_y {
                // Beyond the seam the same, a whole sheet away.
                let (dx, dy) = (w as f64 * side, h as f64 * side);
                if seam_x {
                    same(&shifted(&right[3], dx, 0.0), &east);
                }
                if seam_y {
                    same(&shifted(&below[0], 0.0, dy), &south);
                }
            }
            assert!(seam_x || right[3] == east, "row {row}, column {column}");
            assert!(seam_y || below[0] == south, "row {row}, column {column}");
            // Knobs leave a piece in the south and east and come into it in the north and west:
            // turned pieces do not fit.
            let (x, y) = (column as f64 * side, row as f64 * side);
            let reach = |line: &[Point], of: fn(&Point) -> f64, zero: f64| {
                let values = line.iter().map(|point| of(point) - zero);
                values.fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)))
            };
            for (low, high) in [
                reach(&north, |p| p.1, y),
                reach(&south, |p| p.1, y + side),
                reach(&west, |p| p.0, x),
                reach(&east, |p| p.0, x + side),
            ] {
                assert!(low > -1e-9 && high > 0.06 * side && high < 0.2 * side, "{low} {high}");
            }
            areas += area(&puzzle.piece(row, column));
        }
        assert!((areas - (w * h) as f64 * side * side).abs() < 1e-3, "{areas}");
    }
}

#[track_caller]
fn same(a: &[Point], b: &[Point]) {
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(b).all(|(a, b)| (a.0 - b.0).abs() + (a.1 - b.1).abs() < 1e-9));
}

fn area(outline: &[Point]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>() / 2.0
}

/// No two lines of an outline meet but at their ends, and all stay apart.
#[test]
fn outlines_do_not_meet_themselves() {
    for (packing, side) in packings() {
        let puzzle = Puzzle::new(&packing, side).unwrap();
        let w = packing.shape.width();
        let turn =
            |a: Point, b: Point, c: Point| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        for cell in 0..packing.tiles.len() {
            let outline = puzzle.piece(cell / w, cell % w);
            // The last point is the first.
            let lines: Vec<_> = outline.windows(2).map(|pair| (pair[0], pair[1])).collect();
            assert_eq!(outline.first(), outline.last());
            for (i, &(a, b)) in lines.iter().enumerate() {
                for (j, &(c, d)) in lines.iter().enumerate().skip(i + 2) {
                    if i == 0 && j + 1 == lines.len() {
                        continue;
                    }
                    let beside = a.0.max(b.0) < c.0.min(d.0)
                        || c.0.max(d.0) < a.0.min(b.0)
                        || a.1.max(b.1) < c.1.min(d.1)
                        || c.1.max(d.1) < a.1.min(b.1);
                    let apart = beside
                        || turn(a, b, c) * turn(a, b, d) > 0.0
                        || turn(c, d, a) * turn(c, d, b) > 0.0;
                    assert!(apart, "cell {cell}: {a:?} {b:?} {c:?} {d:?}");
                }
            }
        }
    }
}

/// How far a line goes away from another one: a piece would overlap its neighbor by that.
fn apart(a: &[Point], b: &[Point]) -> f64 {
    let distance = |p: Point, line: &[Point]| {
        let (a, b) = (line[0], line[1]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let t = ((p.0 - a.0) * dx + (p.1 - a.1) * dy) / (dx * dx + dy * dy).max(1e-12);
        let (x, y) = (a.0 + t.clamp(0.0, 1.0) * dx, a.1 + t.clamp(0.0, 1.0) * dy);
        ((p.0 - x).powi(2) + (p.1 - y).powi(2)).sqrt()
    };
    let nearest =
        |p: Point| b.windows(2).map(|line| distance(p, line)).fold(f64::INFINITY, f64::min);
    a.iter().map(|&p| nearest(p)).fold(0.0, f64::max)
}

#[test]
fn colors_that_differ_do_not_fit() {
    for (packing, side) in packings() {
        let puzzle = Puzzle::new(&packing, side).unwrap();
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let w = packing.shape.width();
        // The colors along the north and the west side, and the lines as if at the origin.
        let mut rows: Vec<(Vec<u8>, Vec<Point>)> = Vec::new();
        let mut columns = rows.clone();
        for (cell, &tile) in packing.tiles.iter().enumerate().take(40 * w) {
            let (row, column) = (cell / w, cell % w);
            let sides = kind.unpack(tile, colors);
            let (x, y) = (column as f64 * side, row as f64 * side);
            let outline = puzzle.piece(row, column);
            let [north, _, _, west] = lines(&outline, row, column, side);
            let along = |line: &[Point]| line.iter().map(|p| (p.0 - x, p.1 - y)).collect();
            let (n, s) = match kind {
                Kind::Corner => (vec![sides[3], sides[0]], vec![sides[3], sides[2]]),
                _ => (vec![sides[0]], vec![sides[3]]),
            };
            for (known, colors, line) in
                [(&mut rows, n, along(&north)), (&mut columns, s, along(&west))]
            {
                if !known.iter().any(|(these, _)| *these == colors) {
                    known.push((colors, line));
                }
            }
        }
        let all = if kind == Kind::Corner { 36 } else { 8 };
        for lines in [&rows, &columns] {
            assert_eq!(lines.len(), all);
            for (i, a) in lines.iter().enumerate() {
                for b in &lines[i + 1..] {
                    let distance = apart(&a.1, &b.1);
                    assert!(distance > 0.7 * LEAST_STEP, "{:?} {:?}: {distance} mm", a.0, b.0);
                }
            }
        }
        // Turned over, round knobs meet dovetails.
        let mirrored: Vec<Point> = columns[0].1.iter().map(|&(x, y)| (y, x)).collect();
        for (_, line) in &rows {
            assert!(apart(line, &mirrored) > 0.2, "{}", apart(line, &mirrored));
        }
    }
}

#[test]
fn every_line_is_cut_once() {
    let packing = complete(Kind::Wang, "2,3");
    let puzzle = Puzzle::new(&packing, 40.0).unwrap();
    let svg = text(|out| Ok(puzzle.write_svg(out, "t")?));
    let cut = &svg[svg.find("id=\"cut\"").unwrap()..];
    let (w, h) = (packing.shape.width(), packing.shape.height());
    assert_eq!(cut.matches("<path").count(), w + 1 + h + 1);
    // Curves: four a round knob, in each of the rows of lines.
    assert_eq!(cut.matches('c').count() - cut.matches("cut").count(), 4 * w * (h + 1));
    assert!(svg.contains("width=\"372.12mm\""), "{}", &svg[..200]);
}

#[test]
fn puzzles_that_cannot_be_cut() {
    let corner = complete(Kind::Corner, "6");
    let error = Puzzle::new(&corner, 30.0).unwrap_err().to_string();
    let expected =
        "6 colors: knobs on pieces of 30 mm tell 5 apart (2 mm each); this many need 38 mm";
    assert_eq!(error, expected);
    assert!(Puzzle::new(&corner, 38.0).is_ok());
    let error = Puzzle::new(&complete(Kind::Wang, "2"), 9.0).unwrap_err().to_string();
    assert_eq!(error, "pieces of 9 mm: expected 10 mm or more");
    let error = Puzzle::new(&complete(Kind::Wang, "12"), 40.0).unwrap_err().to_string();
    assert_eq!(error, "20736 pieces: expected 16384 or fewer");
}
