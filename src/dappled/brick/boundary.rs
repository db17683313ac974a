//! Boundaries and regions as text.
//!
//! A boundary has lines of two forms: `SIDE POSITION...` for a whole side of the rectangle, from
//! west to east or from north to south, and `ROW COLUMN SIDE POSITION` for one edge; `.` is a free
//! edge, `#` begins a comment. A region has a line for each row: `.` is outside, any other character
//! but a blank a cell.

use super::{FREE, Side, Wall};
use crate::dappled::notation::TextError;

/// The words of a line, each with its column, counted from 1; without the comment.
fn words(line: &str) -> Vec<(usize, &str)> {
    let line = line.split('#').next().unwrap_or_default();
    let start = |word: &str| word.as_ptr() as usize - line.as_ptr() as usize;
    line.split_whitespace().map(|word| (line[..start(word)].chars().count() + 1, word)).collect()
}

fn side(word: &str) -> Option<Side> {
    Side::ALL.into_iter().find(|side| side.name() == word)
}

/// Reads a boundary into a wall.
///
/// # Errors
/// Where it goes wrong, and what was expected.
pub fn read(text: &str, wall: &mut Wall) -> Result<(), TextError> {
    let positions = wall.positions();
    let position = |word: &str| match word {
        "." | "?" => Ok(FREE),
        word => match word.parse::<u8>() {
            Ok(position) if position < positions => Ok(position),
            _ => Err(format!("'{word}': expected a position below {positions}, or .")),
        },
    };
    for (number, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let words = words(line);
        let Some(&(column, first)) = words.first() else { continue };
        let wrong =
            |column: usize, message: String| TextError { line: number + 1, column, message };
        if let Some(side) = side(first) {
            let length = match side {
                Side::North | Side::South => wall.width(),
                Side::East | Side::West => wall.height(),
            };
            if words.len() != length + 1 {
                let found = words.len() - 1;
                let message = format!("{found} positions in the {first}, expected {length}");
                return Err(wrong(column, message));
            }
            for (at, &(column, word)) in words[1..].iter().enumerate() {
                let cell = match side {
                    Side::North => (at, 0),
                    Side::South => (at, wall.height() - 1),
                    Side::West => (0, at),
                    Side::East => (wall.width() - 1, at),
                };
                let position = position(word).map_err(|message| wrong(column, message))?;
                if wall.holds(cell.0, cell.1) {
                    wall.set(cell.0, cell.1, side, position);
                } else if position != FREE {
                    let message = format!("there is no cell at row {}, column {}", cell.1, cell.0);
                    return Err(wrong(column, message));
                }
            }
            continue;
        }
        let &[(a, row), (b, column), (c, of), (d, word)] = &words[..] else {
            let expected = "expected SIDE POSITION... or ROW COLUMN SIDE POSITION";
            return Err(wrong(column, format!("'{first}': {expected}")));
        };
        let number = |at: usize, word: &str, end: usize| match word.parse::<usize>() {
            Ok(number) if number < end => Ok(number),
            _ => Err(wrong(at, format!("'{word}': expected a number below {end}"))),
        };
        let (row, column) = (number(a, row, wall.height())?, number(b, column, wall.width())?);
        let Some(side) = side(of) else {
            return Err(wrong(c, format!("'{of}': expected north, east, south or west")));
        };
        let position = position(word).map_err(|message| wrong(d, message))?;
        if !wall.holds(column, row) || wall.neighbor(column, row, side).is_some() {
            let message = format!("row {row}, column {column}, {of}: not an edge of the boundary");
            return Err(wrong(a, message));
        }
        wall.set(column, row, side, position);
    }
    Ok(())
}

/// Reads a region: columns, rows, and which cells belong to it.
///
/// # Errors
/// Where it goes wrong, and what was expected.
pub fn region(text: &str) -> Result<((usize, usize), Vec<bool>), TextError> {
    let (mut width, mut height, mut inside) = (0, 0, Vec::new());
    for (number, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = line.trim_end();
        if line.is_empty() {
            continue;
        }
        let cells: Vec<char> = line.chars().collect();
        let wrong = |column, message| Err(TextError { line: number + 1, column, message });
        if height > 0 && cells.len() != width {
            let message = format!("{} cells in this row, expected {width} as above", cells.len());
            return wrong(1, message);
        }
        if let Some(at) = cells.iter().position(|c| c.is_whitespace() || c.is_control()) {
            return wrong(at + 1, "a blank, expected a cell or .".into());
        }
        (width, height) = (cells.len(), height + 1);
        inside.extend(cells.iter().map(|&c| c != '.'));
    }
    if !inside.contains(&true) {
        let message = "no cells, expected a line for each row, . outside".to_owned();
        return Err(TextError { line: 1, column: 1, message });
    }
    Ok(((width, height), inside))
}
