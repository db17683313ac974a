//! Rectangles of the tiles of Jeandel and Rao, of any size at once.
//!
//! A point of a torus, moved by one to the east for each tile to the east and by one upward for
//! each to the north, lies in a labeled polygon every time: the labels are a tiling (Labbé 2019;
//! see [`Partition`]). A point is drawn at random and followed in floating point. Where rounding
//! puts one on the wrong side of a border, tiles do not match; then another point is drawn.

use super::super::coloring::partition::{JEANDEL_RAO, JEANDEL_RAO_UNMERGED, Partition};
use super::super::decide::Tile;
use super::Random;

/// Points tried.
const TRIES: usize = 20;

/// Fills a rectangle; `None` when these are other tiles.
pub(super) fn fill(
    tiles: &[Tile],
    width: usize,
    height: usize,
    random: &mut Random,
) -> Option<Vec<usize>> {
    let numbers: Vec<usize> = [JEANDEL_RAO, JEANDEL_RAO_UNMERGED].iter().find_map(|known| {
        let number = |tile: &Tile| tiles.iter().position(|other| other == tile);
        known.iter().map(number).collect::<Option<Vec<usize>>>()
    })?;
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let pieces: Vec<(usize, Vec<[f64; 2]>)> = Partition::jeandel_rao()
        .listed()
        .into_iter()
        .map(|piece| {
            let real = |a: i64, b: i64| a as f64 + b as f64 * phi;
            let vertex = |&[a, b, c, d]: &[i64; 4]| [real(a, b), real(c, d)];
            (piece.label, piece.polygon.iter().map(vertex).collect())
        })
        .collect();
    (0..TRIES).find_map(|_| {
        let start = [random.next() * phi, random.next() * (phi + 3.0)];
        let cell = |i: usize| {
            let (column, row) = (i % width, height - 1 - i / width);
            let y = start[1] + row as f64;
            let turns = (y / (phi + 3.0)).floor();
            let x = (start[0] + column as f64 - turns).rem_euclid(phi);
            let y = y - turns * (phi + 3.0);
            let piece = pieces.iter().find(|(_, polygon)| contains(polygon, [x, y]))?;
            Some(numbers[piece.0])
        };
        let cells: Vec<usize> = (0..width * height).map(cell).collect::<Option<_>>()?;
        let fits = |i: usize| {
            let here = tiles[cells[i]];
            (i.is_multiple_of(width) || tiles[cells[i - 1]][1] == here[3])
                && (i < width || tiles[cells[i - width]][2] == here[0])
        };
        (0..cells.len()).all(fits).then_some(cells)
    })
}

/// Whether a point lies in a convex polygon, counter-clockwise.
fn contains(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    (0..polygon.len()).all(|i| {
        let ([ax, ay], [bx, by]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0.0
    })
}
