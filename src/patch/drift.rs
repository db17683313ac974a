//! How much the rows of a packing differ in their colors, and its columns.
//!
//! For every line and color, the square of the difference between how often the color is there and
//! how often it would be if all lines were alike, divided by the latter; summed, and divided by
//! the number of independent terms. Colors strewn at random give about 1 (a packing is a little
//! more even), colors that are used up early much more. The colors of the two sorts of edges of
//! Wang tiles count separately.
//!
//! Source: Pearson 1900 (chi-square over its degrees of freedom).

use crate::tiles::{Colors, Kind};
use crate::torus::Lattice;

/// How far the lines of a packing are from alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Drift {
    /// Among rows; `None` where there is nothing to compare.
    pub rows: Option<f64>,
    /// Among columns.
    pub columns: Option<f64>,
    /// For every row how often each color is there; of Wang tiles first those of north edges, then
    /// those of west edges.
    pub profile: Vec<Vec<u32>>,
}

impl Drift {
    /// That of a packing, given by its labels.
    pub fn of(lattice: Lattice, colors: Colors, labels: &[u8]) -> Self {
        let (width, height) = (lattice.shape.width(), lattice.shape.height());
        let palettes = match lattice.kind {
            Kind::Wang => vec![colors.horizontal(), colors.vertical()],
            Kind::Corner | Kind::Domino => vec![colors.vertical()],
        };
        let row = |cell: usize| cell / width;
        let column = |cell: usize| cell % width;
        let rows = profile(labels, &palettes, height, row);
        let columns = profile(labels, &palettes, width, column);
        let (across, down) = (drift(&rows, &palettes), drift(&columns, &palettes));
        Self { rows: across, columns: down, profile: rows }
    }
}

/// How often each color is on each line.
fn profile(
    labels: &[u8],
    palettes: &[usize],
    lines: usize,
    line: impl Fn(usize) -> usize,
) -> Vec<Vec<u32>> {
    let mut counts = vec![vec![0; palettes.iter().sum()]; lines];
    for (i, &color) in labels.iter().enumerate() {
        let palette = i % palettes.len();
        let begin: usize = palettes[..palette].iter().sum();
        counts[line(i / palettes.len())][begin + usize::from(color)] += 1;
    }
    counts
}

/// Chi-square over its degrees of freedom.
fn drift(counts: &[Vec<u32>], palettes: &[usize]) -> Option<f64> {
    let (mut sum, mut free, mut begin) = (0.0, 0, 0);
    for &colors in palettes {
        let line = |line: usize| &counts[line][begin..begin + colors];
        let in_all = |color: usize| (0..counts.len()).map(|i| line(i)[color]).sum::<u32>();
        let used: Vec<usize> = (0..colors).filter(|&color| in_all(color) > 0).collect();
        for &color in &used {
            let expected = f64::from(in_all(color)) / counts.len() as f64;
            for i in 0..counts.len() {
                sum += (f64::from(line(i)[color]) - expected).powi(2) / expected;
            }
        }
        free += (counts.len() - 1) * used.len().saturating_sub(1);
        begin += colors;
    }
    (free > 0).then(|| sum / free as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::torus::Shape;

    #[test]
    fn rows_alike_and_rows_of_one_color() {
        let shape = Shape::new(4, 2).unwrap();
        let lattice = Lattice { kind: Kind::Corner, shape };
        let two = Colors::one(2).unwrap();
        let of = |labels: &[u8]| Drift::of(lattice, two, labels);
        let drift = of(&[0, 1, 0, 1, 1, 0, 1, 0]);
        assert_eq!(drift.rows, Some(0.0));
        assert_eq!(drift.profile, [[2, 2], [2, 2]]);
        // Two of each color expected in both rows, four or none found: 4 terms of 2, one free.
        let drift = of(&[0, 0, 0, 0, 1, 1, 1, 1]);
        assert_eq!((drift.rows, drift.columns), (Some(8.0), Some(0.0)));
        assert_eq!(of(&[0; 8]).rows, None);
        let wang = Lattice { kind: Kind::Wang, shape: Shape::new(1, 2).unwrap() };
        let drift = Drift::of(wang, Colors::pair(2, 3).unwrap(), &[1, 2, 0, 2]);
        assert_eq!(drift.profile, [[0, 1, 0, 0, 1], [1, 0, 0, 0, 1]]);
        assert_eq!((drift.rows, drift.columns), (Some(2.0), None));
    }
}
