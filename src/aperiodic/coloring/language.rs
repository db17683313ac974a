//! The windows of a tiling: every pattern of R rows and C columns that occurs in it.
//!
//! *Exactly*, for the tilings that a partition of a torus codes: the points that give a pattern
//! are the common part of the pieces of its cells, each moved back to the south-west cell. So the
//! partition is refined by its own translates, one cell after the other. What is left has an
//! area, and the areas add up to that of the torus.
//!
//! *From a patch*, for other sets: the patterns that occur in it. Nothing is proved by them.

use super::partition::Partition;
use super::polygon::{OutsideRing, Polygon};
use super::zphi::Zphi;
use std::collections::BTreeSet;

/// A pattern and the points that give it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Window {
    /// Labels, row by row from the north.
    pub labels: Vec<usize>,
    /// Points at the south-west cell.
    pub polygon: Polygon,
    /// For each cell the piece, and which of its translates.
    pub pieces: Vec<[i64; 3]>,
}

/// The step of lattice-free coordinates from the south-west cell to a cell.
fn offset(cell: usize, [rows, columns]: [usize; 2]) -> [Zphi; 2] {
    let (row, column) = (cell / columns, cell % columns);
    [Zphi::new(column as i64, 0), Zphi::new((rows - 1 - row) as i64, 0)]
}

/// The windows of `rows` and `columns` of almost every tiling that the partition codes.
///
/// # Errors
/// A polygon has a vertex outside of the ring.
pub fn windows(partition: &Partition, shape: [usize; 2]) -> Result<Vec<Window>, OutsideRing> {
    let cells = shape[0] * shape[1];
    let here = (shape[0] - 1) * shape[1];
    let unknown = vec![[0; 3]; cells];
    let mut windows = Vec::new();
    for (k, (label, polygon)) in partition.pieces.iter().enumerate() {
        let (mut labels, mut pieces) = (vec![0; cells], unknown.clone());
        (labels[here], pieces[here]) = (*label, [k as i64, 0, 0]);
        windows.push(Window { labels, polygon: polygon.clone(), pieces });
    }
    for cell in (0..cells).filter(|&cell| cell != here) {
        let mut finer = Vec::with_capacity(windows.len());
        for window in &windows {
            refine(partition, window, cell, offset(cell, shape), &mut finer)?;
        }
        windows = finer;
    }
    windows.sort_by(|one, other| (&one.labels, &one.pieces).cmp(&(&other.labels, &other.pieces)));
    Ok(windows)
}

/// Divides a window by the pieces in which its points lie after a step.
fn refine(
    partition: &Partition,
    window: &Window,
    cell: usize,
    step: [Zphi; 2],
    finer: &mut Vec<Window>,
) -> Result<(), OutsideRing> {
    let moved = window.polygon.moved(step);
    let back = [-step[0], -step[1]];
    let [width, height] = [partition.lattice[0][0], partition.lattice[1][1]];
    // The translates of the rectangle that it can meet.
    let ys = bounds(moved.0.iter().map(|p| floor_quotient(p[1], height)));
    for n in ys.0..=ys.1 {
        let down = partition.shift(0, n);
        let xs = bounds(moved.0.iter().map(|p| floor_quotient(p[0] - down[0], width)));
        for m in xs.0..=xs.1 {
            let shift = partition.shift(m, n);
            for (k, (label, piece)) in partition.pieces.iter().enumerate() {
                let Some(common) = moved.common(&piece.moved(shift))? else { continue };
                let mut next = window.clone();
                next.polygon = common.moved(back);
                (next.labels[cell], next.pieces[cell]) = (*label, [k as i64, m, n]);
                finer.push(next);
            }
        }
    }
    Ok(())
}

/// The largest integer `k` with `k d <= x`, for small `x` and positive `d`.
fn floor_quotient(x: Zphi, d: Zphi) -> i64 {
    let mut k = 0;
    while (x - Zphi::new(k, 0) * d).sign().is_lt() {
        k -= 1;
    }
    while (x - Zphi::new(k + 1, 0) * d).sign().is_ge() {
        k += 1;
    }
    k
}

fn bounds(numbers: impl Iterator<Item = i64>) -> (i64, i64) {
    numbers.fold((i64::MAX, i64::MIN), |(low, high), x| (low.min(x), high.max(x)))
}

/// The different patterns of windows.
pub fn patterns(windows: &[Window]) -> BTreeSet<Vec<usize>> {
    windows.iter().map(|window| window.labels.clone()).collect()
}

/// The patterns that occur in a patch, given row by row from the north.
pub fn patterns_of_patch(
    patch: &[Vec<usize>],
    [rows, columns]: [usize; 2],
) -> BTreeSet<Vec<usize>> {
    let mut found = BTreeSet::new();
    for band in patch.windows(rows) {
        let width = band.iter().map(Vec::len).min().unwrap_or(0);
        for column in 0..(width + 1).saturating_sub(columns) {
            let cells = band.iter().flat_map(|row| &row[column..column + columns]);
            found.insert(cells.copied().collect());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_known_numbers_of_windows() {
        let partition = Partition::jeandel_rao();
        for (shape, patterns, polygons) in [
            ([1, 1], 11, 24),
            ([1, 2], 26, 0),
            ([2, 1], 28, 0),
            ([2, 2], 49, 0),
            ([4, 2], 107, 0),
            ([5, 3], 169, 186),
        ] {
            let windows = windows(&partition, shape).unwrap();
            assert_eq!(super::patterns(&windows).len(), patterns, "{shape:?}");
            assert!(polygons == 0 || windows.len() == polygons, "{shape:?}: {}", windows.len());
            let area = |sum: Zphi, window: &Window| sum + window.polygon.double_area();
            let area = windows.iter().fold(Zphi::ZERO, area);
            assert_eq!(area, Zphi::new(2, 0) * Zphi::PHI * Zphi::new(3, 1), "{shape:?}");
        }
    }

    /// The language is that of long orbits of points, up to rare windows.
    #[test]
    fn windows_of_an_orbit_are_among_them() {
        let partition = Partition::jeandel_rao();
        let [[w, _], [s, h]] = partition.lattice;
        let label = |x: i64, y: i64| {
            // A point in the rectangle: a translate of (x, y), off by a little.
            let mut p = [Zphi::new(x, 0), Zphi::new(y, 0)];
            let n = floor_quotient(p[1], h);
            p = [p[0] - Zphi::new(n, 0) * s, p[1] - Zphi::new(n, 0) * h];
            let m = floor_quotient(p[0], w);
            p[0] = p[0] - Zphi::new(m, 0) * w;
            let inside = |polygon: &Polygon| {
                let n = polygon.0.len();
                (0..n).all(|i| {
                    let (a, b) = (polygon.0[i], polygon.0[(i + 1) % n]);
                    let cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                    cross.is_positive()
                })
            };
            partition.pieces.iter().find(|(_, polygon)| inside(polygon)).map(|&(label, _)| label)
        };
        let known = patterns(&windows(&partition, [2, 2]).unwrap());
        let mut seen = BTreeSet::new();
        for (x, y) in (1..60).flat_map(|x| (1..60).map(move |y| (x, y))) {
            let cells = [(x, y + 1), (x + 1, y + 1), (x, y), (x + 1, y)];
            let labels: Option<Vec<usize>> = cells.iter().map(|&(x, y)| label(x, y)).collect();
            seen.extend(labels);
        }
        assert!(seen.is_subset(&known) && seen.len() > 40, "{} of {}", seen.len(), known.len());
    }
}
