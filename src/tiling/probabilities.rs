//! Semi-stochastic tilings: random colors, whose probabilities a map says for every place.
//!
//! A map has a probability for every color in each of its cells. A cell is so many points wide and
//! high; the map repeats, its south-west cell begins at the point (0, 0). The color of a point is drawn
//! by the alias method (A. J. Walker, 1977): a hash chooses one of `C` columns, each as likely as any
//! other; a second one, below the threshold of the column, its own color, else its alias. All is done
//! in whole numbers of 32 bits, so a shader does the same.
//!
//! Invariant: every cell has `C` columns; a threshold of `2^32 - 1` stands for certainty, as the
//! alias is the color itself then.

use super::TilingError;
use super::hash::{hash3, uni};
use crate::torus::Shape;

/// A column of the alias method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Hashes below it take the column's own color,
    pub threshold: u32,
    /// others this one.
    pub alias: u8,
}

/// A map of probabilities, and what draws from it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Probabilities {
    shape: Shape,
    /// Points of a cell, along x and y.
    scale: [u32; 2],
    colors: usize,
    seed: u32,
    /// Cell by cell, row by row from the north, one for every color.
    columns: Vec<Column>,
}

/// How far the sum of probabilities may be from 1.
const TOLERANCE: f64 = 1e-6;

impl Probabilities {
    /// A map with `weights[cell * colors + color]`, rows from the north; those of a cell add up to 1.
    ///
    /// # Errors
    /// A cell whose weights do not add up to 1, a negative one, a scale of 0, another number of
    /// weights than cells times colors.
    pub fn new(
        shape: Shape,
        scale: [u32; 2],
        colors: usize,
        weights: &[f64],
        seed: u32,
    ) -> Result<Self, TilingError> {
        if weights.len() != shape.cells() * colors || colors == 0 {
            let (expected, found) = (shape.cells() * colors, weights.len());
            return Err(TilingError::Weights { expected, found });
        }
        let most = 1u32 << 20;
        if scale.iter().any(|&points| points == 0 || points > most) {
            return Err(TilingError::Scale { scale, most });
        }
        let mut columns = Vec::with_capacity(weights.len());
        for (cell, weights) in weights.chunks(colors).enumerate() {
            let (row, column) = (cell / shape.width(), cell % shape.width());
            let sum: f64 = weights.iter().sum();
            if let Some(&weight) = weights.iter().find(|weight| !(0.0..=1.0).contains(*weight)) {
                return Err(TilingError::Weight { row, column, weight: weight.to_string() });
            }
            if (sum - 1.0).abs() > TOLERANCE {
                return Err(TilingError::Sum { row, column, sum: sum.to_string() });
            }
            columns.extend(alias_columns(weights));
        }
        Ok(Self { shape, scale, colors, seed, columns })
    }

    /// Cells of the map.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Points of a cell, along x and y.
    pub fn scale(&self) -> [u32; 2] {
        self.scale
    }

    /// The number of colors.
    pub fn colors(&self) -> usize {
        self.colors
    }

    /// What chooses the tiling.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// The seeds of the hashes that choose a column and then a color.
    pub fn hash_seeds(&self) -> [u32; 2] {
        [self.seed, self.seed.wrapping_add(1)]
    }

    /// The columns of all cells, row by row from the north.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The columns of the cell of a point.
    fn at(&self, x: i64, y: i64) -> &[Column] {
        let around = |at: i64, scale: u32, cells: usize| {
            (at.div_euclid(scale.into())).rem_euclid(cells as i64) as usize
        };
        let column = around(x, self.scale[0], self.shape.width());
        let row = self.shape.height() - 1 - around(y, self.scale[1], self.shape.height());
        let cell = row * self.shape.width() + column;
        &self.columns[cell * self.colors..][..self.colors]
    }

    /// The color of a point.
    pub fn color(&self, x: i64, y: i64) -> u8 {
        let [first, second] = self.hash_seeds().map(|seed| hash3(seed, x as u32, y as u32));
        let choice = uni(first, self.colors as u32);
        let column = self.at(x, y)[choice as usize];
        if second < column.threshold { choice as u8 } else { column.alias }
    }

    /// The colors with a probability above 0 in each cell, row by row from the north.
    pub fn supports(&self) -> Vec<Vec<u8>> {
        let cells = self.columns.chunks(self.colors);
        let support = |columns: &[Column]| {
            let probabilities = probabilities_of(columns);
            let colors = probabilities.iter().zip(0u8..);
            colors.filter(|(p, _)| **p > 0.0).map(|(_, color)| color).collect()
        };
        cells.map(support).collect()
    }

    /// The mean entropy of a point in bits.
    pub fn entropy(&self) -> f64 {
        let cells = self.columns.chunks(self.colors);
        let of_cell = |columns: &[Column]| -> f64 {
            let probabilities = probabilities_of(columns);
            probabilities.iter().filter(|p| **p > 0.0).map(|p| -p * p.log2()).sum()
        };
        cells.map(of_cell).sum::<f64>() / self.shape.cells() as f64
    }
}

/// How many of `2^32` draws give each color.
fn drawn(columns: &[Column]) -> Vec<u64> {
    let mut sums = vec![0; columns.len()];
    for (color, column) in columns.iter().enumerate() {
        sums[color] += u64::from(column.threshold);
        sums[usize::from(column.alias)] += ONE - u64::from(column.threshold);
    }
    sums.iter().map(|sum| sum / columns.len() as u64).collect()
}

fn probabilities_of(columns: &[Column]) -> Vec<f64> {
    drawn(columns).into_iter().map(|count| count as f64 / ONE as f64).collect()
}

/// Certainty.
const ONE: u64 = 1 << 32;

/// The columns that draw with these weights, rounded to `2^-32`: the column of a color below the mean
/// is filled up by a color above it. In whole numbers nothing is left over.
fn alias_columns(weights: &[f64]) -> Vec<Column> {
    let total: f64 = weights.iter().sum();
    let mut counts: Vec<u64> =
        weights.iter().map(|weight| (weight / total * ONE as f64).round() as u64).collect();
    // What rounding took or gave goes to the largest.
    let largest = (0..counts.len()).max_by_key(|&color| counts[color]).unwrap_or(0);
    let others: u64 = counts.iter().sum::<u64>() - counts[largest];
    counts[largest] = ONE - others;
    let mut heights: Vec<u64> = counts.iter().map(|count| count * counts.len() as u64).collect();
    let own = |color: usize| Column { threshold: u32::MAX, alias: color as u8 };
    let mut columns: Vec<Column> = (0..weights.len()).map(own).collect();
    let mut low: Vec<usize> = (0..weights.len()).filter(|&color| heights[color] < ONE).collect();
    let mut high: Vec<usize> = (0..weights.len()).filter(|&color| heights[color] > ONE).collect();
    while let (Some(color), Some(&giver)) = (low.pop(), high.last()) {
        columns[color] = Column { threshold: heights[color] as u32, alias: giver as u8 };
        heights[giver] -= ONE - heights[color];
        if heights[giver] <= ONE {
            high.pop();
        }
        if heights[giver] < ONE {
            low.push(giver);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The columns give the weights back; colors without any never come up.
    #[test]
    fn columns_are_the_weights() {
        let lists: [&[f64]; 7] = [
            &[0.5, 0.25, 0.125, 0.125],
            &[1.0],
            &[0.0, 1.0],
            &[0.25; 4],
            &[0.1, 0.2, 0.3, 0.4],
            &[0.0, 0.0, 1.0, 0.0, 0.0],
            &[0.9, 0.05, 0.05, 0.0],
        ];
        for weights in lists {
            let found = probabilities_of(&alias_columns(weights));
            for (found, weight) in found.iter().zip(weights) {
                assert!((found - weight).abs() < 1e-9, "{weights:?}: {found}");
                assert!(*weight > 0.0 || *found == 0.0, "{weights:?}: {found}");
            }
        }
        // Columns in print draw the same; their order of construction was another.
        let column = |threshold: u32, alias: u8| Column { threshold, alias };
        let half = 1 << 31;
        let printed = [column(u32::MAX, 0), column(half, 0), column(half, 0), column(half, 1)];
        assert_eq!(probabilities_of(&printed), [0.5, 0.25, 0.125, 0.125]);
    }
}
