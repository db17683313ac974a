//! Maps of probabilities as text: what a semi-stochastic tiling draws its colors from.
//!
//! Rows of cells from north to south, cells separated by blanks, each the probabilities of its colors
//! separated by commas: `0.5,0.25,0.25`. `#` begins a comment. All cells have as many colors, and their
//! probabilities add up to 1.

use super::{Input, StoreError};
use crate::torus::Shape;

/// A map as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct ProbabilityGrid {
    /// Cells.
    pub shape: Shape,
    /// The number of colors.
    pub colors: usize,
    /// Cell by cell, row by row from the north, one for every color.
    pub weights: Vec<f64>,
}

/// Cells times colors at most.
const MOST: usize = 1 << 24;

/// How far a sum may be from 1.
const TOLERANCE: f64 = 1e-6;

/// Reads a map.
///
/// # Errors
/// What is no number from 0 to 1, a cell with another number of colors or another sum, a row of
/// another length, too many cells, none at all.
pub fn read_probabilities(input: &Input) -> Result<ProbabilityGrid, StoreError> {
    let (mut colors, mut width, mut height) = (None, None, 0u64);
    let mut weights: Vec<f64> = Vec::new();
    let mut at = 0;
    for line in input.text().split_inclusive('\n') {
        let start = at;
        at += line.len();
        let said = line.split('#').next().unwrap_or_default().trim_start_matches('\u{feff}');
        let offset = |word: &str| start + (word.as_ptr() as usize - line.as_ptr() as usize);
        let mut cells = 0u64;
        for word in said.split_whitespace() {
            let error = |message: String| Err(input.error_at(offset(word), message));
            let begin = weights.len();
            for number in word.split(',') {
                match number.parse::<f64>() {
                    Ok(weight) if (0.0..=1.0).contains(&weight) => weights.push(weight),
                    _ => return error(format!("'{number}': expected a number from 0 to 1")),
                }
            }
            let count = weights.len() - begin;
            let expected = *colors.get_or_insert(count);
            if count != expected || count > 255 {
                let expected = expected.min(255);
                return error(format!("{count} probabilities, expected {expected}"));
            }
            let sum: f64 = weights[begin..].iter().sum();
            if (sum - 1.0).abs() > TOLERANCE {
                let sum = (sum * 1e9).round() / 1e9;
                return error(format!("the probabilities add up to {sum}, expected 1"));
            }
            if weights.len() > MOST {
                return error(format!("more than {MOST} probabilities"));
            }
            cells += 1;
        }
        if cells > 0 {
            let expected = *width.get_or_insert(cells);
            if cells != expected {
                let first = start + (said.len() - said.trim_start().len());
                let message = format!("{cells} cells in a row, expected {expected}");
                return Err(input.error_at(first, message));
            }
            height += 1;
        }
    }
    let (Some(colors), Some(width)) = (colors, width) else {
        return Err(input.error("no cells: expected rows of probabilities, as in 0.5,0.25,0.25"));
    };
    let shape = Shape::new(width, height).map_err(|error| input.error(error.to_string()))?;
    Ok(ProbabilityGrid { shape, colors, weights })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<ProbabilityGrid, String> {
        let input = Input::from_bytes("p.txt", text.into()).map_err(|error| error.to_string())?;
        read_probabilities(&input).map_err(|error| error.to_string())
    }

    #[test]
    fn grids_are_read() {
        let grid = read("# a map\n1,0 0.5,0.5\r\n\n0.25,0.75 0,1 # the south\n");
        let shape = Shape::new(2, 2).ok();
        let weights = vec![1.0, 0.0, 0.5, 0.5, 0.25, 0.75, 0.0, 1.0];
        assert_eq!(
            shape.map(|shape| Ok(ProbabilityGrid { shape, colors: 2, weights })),
            Some(grid)
        );
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (text, expected) in [
            ("1,0 0.5,0.6\n", "p.txt:1:5: the probabilities add up to 1.1, expected 1"),
            ("1,0\n\n 0.5,x", "p.txt:3:2: 'x': expected a number from 0 to 1"),
            ("-0.5,1.5", "p.txt:1:1: '-0.5': expected a number from 0 to 1"),
            ("1,0 1,0,0", "p.txt:1:5: 3 probabilities, expected 2"),
            ("1,0 1,0\n1,0\n", "p.txt:2:1: 1 cells in a row, expected 2"),
            ("# nothing\n", "p.txt: no cells: expected rows of probabilities, as in 0.5,0.25,0.25"),
            ("nan,1", "p.txt:1:1: 'nan': expected a number from 0 to 1"),
        ] {
            assert_eq!(read(text), Err(expected.to_owned()));
        }
    }
}
