//! Limits and fields as text.
//!
//! A limit is `H,V` for every tile alone, `T:H,V` for one tile, `T+U+...:H,V` for a set; `H` (in a
//! row) and `V` (in a column) are numbers from 1, `inf`, or `@FILE` for a map. A later limit
//! replaces an earlier one of the same tiles.
//!
//! A field has a line for each row, from the north: a digit for each cell, or numbers with blanks
//! between them; `.` or `?` is a free cell, `#` begins a comment. A map of limits has numbers and
//! `inf`, with blanks between them.

use super::closest::MOST_WEIGHT;
use super::{Condition, Direction, FREE, Field, Limit, MOST_TILES};

/// Why a text is not what was expected: line and column count from 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}:{column}: {message}")]
pub struct TextError {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
    /// What was expected.
    pub message: String,
}

/// A limit of one direction, before maps are read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Bound {
    /// `inf`.
    None,
    /// A number.
    Same(u32),
    /// A map in this file.
    File(String),
}

/// `SET:H,V` as typed; the set is empty for "every tile alone".
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LimitText {
    /// The tiles; none for every tile alone.
    pub tiles: Vec<u8>,
    /// In a row.
    pub horizontal: Bound,
    /// In a column.
    pub vertical: Bound,
}

/// Reads one limit.
///
/// # Errors
/// What was expected, in one line.
pub fn limit(text: &str) -> Result<LimitText, String> {
    let expected = || format!("'{text}': expected H,V or T:H,V or T+U:H,V, such as 2,2 or 0:3,inf");
    let (set, bounds) = match text.split_once(':') {
        Some((set, bounds)) if !set.contains('@') => (Some(set), bounds),
        _ => (None, text),
    };
    let mut tiles = Vec::new();
    for tile in set.into_iter().flat_map(|set| set.split('+')) {
        let tile: u8 = tile.trim().parse().map_err(|_| expected())?;
        if usize::from(tile) >= MOST_TILES {
            return Err(format!("'{text}': tile {tile}, expected one below {MOST_TILES}"));
        }
        tiles.push(tile);
    }
    tiles.sort_unstable();
    tiles.dedup();
    let (horizontal, vertical) = bounds.split_once(',').ok_or_else(expected)?;
    let bound = |bound: &str| match bound.trim() {
        "inf" => Ok(Bound::None),
        "0" => Err(format!("'{text}': a limit of 0, expected 1 or more, or inf")),
        bound => match bound.strip_prefix('@') {
            Some(file) => Ok(Bound::File(file.to_owned())),
            None => match bound.parse() {
                Ok(u32::MAX) | Err(_) => Err(expected()),
                Ok(limit) => Ok(Bound::Same(limit)),
            },
        },
    };
    Ok(LimitText { tiles, horizontal: bound(horizontal)?, vertical: bound(vertical)? })
}

/// The conditions of limits in the order given, their maps read by `map`.
///
/// # Errors
/// What `map` reports.
pub fn conditions<E>(
    limits: &[LimitText],
    tiles: usize,
    mut map: impl FnMut(&str) -> Result<Vec<u32>, E>,
) -> Result<Vec<Condition>, E> {
    let mut conditions: Vec<Condition> = Vec::new();
    for text in limits {
        let sets: Vec<u64> = match text.tiles.is_empty() {
            true => (0..tiles.min(MOST_TILES)).map(|tile| 1 << tile).collect(),
            false => vec![text.tiles.iter().fold(0, |set, &tile| set | 1 << tile)],
        };
        for (direction, bound) in
            [(Direction::Horizontal, &text.horizontal), (Direction::Vertical, &text.vertical)]
        {
            let limit = match bound {
                Bound::None => Limit::None,
                Bound::Same(limit) => Limit::Same(*limit),
                Bound::File(file) => Limit::Map(map(file)?),
            };
            for &set in &sets {
                conditions.retain(|old| (old.set, old.direction) != (set, direction));
                if limit != Limit::None {
                    conditions.push(Condition { set, direction, limit: limit.clone() });
                }
            }
        }
    }
    Ok(conditions)
}

/// The words of a row with their columns, counted from 1; without the comment.
fn words(line: &str) -> Vec<(usize, &str)> {
    let line = line.split('#').next().unwrap_or_default();
    let mut words = Vec::new();
    let mut start = None;
    let end = std::iter::once((line.len(), ' '));
    for (at, c) in line.char_indices().chain(end) {
        match (c.is_whitespace(), start) {
            (false, None) => start = Some(at),
            (true, Some(from)) => {
                words.push((line[..from].chars().count() + 1, &line[from..at]));
                start = None;
            }
            _ => {}
        }
    }
    words
}

/// Rows of equal length, each cell read by `cell`; gives columns, rows and cells.
fn grid<T>(
    text: &str,
    split: bool,
    cell: impl Fn(&str) -> Result<T, String>,
) -> Result<(usize, usize, Vec<T>), TextError> {
    let (mut width, mut height, mut cells) = (0, 0, Vec::new());
    for (number, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line_number = number + 1;
        let mut row = words(line);
        if row.is_empty() {
            continue;
        }
        if split && row.len() == 1 && row[0].1.chars().count() > 1 {
            let (column, word) = row[0];
            let ends = word.char_indices().map(|(at, c)| (at, at + c.len_utf8()));
            row = ends.enumerate().map(|(i, (a, b))| (column + i, &word[a..b])).collect();
        }
        if height > 0 && row.len() != width {
            let message = format!("{} cells in this row, expected {width} as above", row.len());
            return Err(TextError { line: line_number, column: 1, message });
        }
        (width, height) = (row.len(), height + 1);
        for (column, word) in row {
            let at = |message| TextError { line: line_number, column, message };
            cells.push(cell(word).map_err(at)?);
        }
    }
    if cells.is_empty() {
        let message = "no cells, expected a line for each row".to_owned();
        return Err(TextError { line: 1, column: 1, message });
    }
    Ok((width, height, cells))
}

/// Reads a field of tiles below `tiles`.
///
/// # Errors
/// Where it goes wrong, and what was expected.
pub fn field(text: &str, tiles: usize) -> Result<Field, TextError> {
    let cell = |word: &str| match word {
        "." | "?" => Ok(FREE),
        word => match word.parse::<u8>() {
            Ok(tile) if usize::from(tile) < tiles => Ok(tile),
            _ => Err(format!("'{word}': expected a tile below {tiles}, or . for a free cell")),
        },
    };
    let (width, height, cells) = grid(text, true, cell)?;
    Field::new(width, height, cells).map_err(|error| TextError {
        line: 1,
        column: 1,
        message: error.to_string(),
    })
}

/// Reads a map of limits for a rectangle of cells.
///
/// # Errors
/// Where it goes wrong, and what was expected.
pub fn map(text: &str, (width, height): (usize, usize)) -> Result<Vec<u32>, TextError> {
    let cell = |word: &str| match (word, word.parse::<u32>()) {
        ("inf", _) => Ok(u32::MAX),
        (_, Ok(limit)) if limit > 0 && limit < u32::MAX => Ok(limit),
        _ => Err(format!("'{word}': expected a limit from 1 on, or inf")),
    };
    let (columns, rows, limits) = grid(text, false, cell)?;
    if (columns, rows) != (width, height) {
        let message = format!("{columns}x{rows} limits, expected {width}x{height}");
        return Err(TextError { line: 1, column: 1, message });
    }
    Ok(limits)
}

/// Reads a map of weights for a rectangle of cells.
///
/// # Errors
/// Where it goes wrong, and what was expected.
pub fn weights(text: &str, (width, height): (usize, usize)) -> Result<Vec<u32>, TextError> {
    let cell = |word: &str| match word.parse::<u32>() {
        Ok(weight) if weight <= MOST_WEIGHT => Ok(weight),
        _ => Err(format!("'{word}': expected a weight from 0 to {MOST_WEIGHT}")),
    };
    let (columns, rows, weights) = grid(text, false, cell)?;
    if (columns, rows) != (width, height) {
        let message = format!("{columns}x{rows} weights, expected {width}x{height}");
        return Err(TextError { line: 1, column: 1, message });
    }
    Ok(weights)
}

/// A field as text: digits where ten tiles are enough, else numbers with blanks between them.
pub fn write_field(field: &Field, tiles: usize) -> String {
    let mut text = String::new();
    for row in field.rows() {
        let cells = row.iter().map(|&tile| match tile {
            FREE => ".".to_owned(),
            tile => tile.to_string(),
        });
        text.push_str(&cells.collect::<Vec<_>>().join(if tiles > 10 { " " } else { "" }));
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_read() {
        let text = limit("0+3:2,inf").unwrap();
        assert_eq!(text.tiles, [0, 3]);
        assert_eq!((text.horizontal, text.vertical), (Bound::Same(2), Bound::None));
        assert_eq!(limit("@h.txt,4").unwrap().horizontal, Bound::File("h.txt".into()));
        for wrong in ["", "2", "0,2", "a:1,2", "1,b", "-1,2", "64:1,1", ":1,1", "1,2,3"] {
            assert!(limit(wrong).is_err(), "{wrong}");
        }
        let both = [limit("2,2").unwrap(), limit("1:inf,3").unwrap()];
        let read = conditions(&both, 2, |_| Err("no maps")).unwrap();
        let found: Vec<_> = read.iter().map(|c| (c.set, c.direction, c.limit.clone())).collect();
        let (h, v) = (Direction::Horizontal, Direction::Vertical);
        let same = Limit::Same;
        assert_eq!(found, [(1, h, same(2)), (1, v, same(2)), (2, v, same(3))]);
    }

    #[test]
    fn fields_are_read_and_written() {
        let read = field("# two rows\n01?\n.10 # the second\n", 2).unwrap();
        assert_eq!((read.width(), read.height()), (3, 2));
        assert_eq!(write_field(&read, 2), "01.\n.10\n");
        assert_eq!(field("0 11\n1 .\n", 12).unwrap().cells(), [0, 11, 1, FREE]);
        assert_eq!(
            field("01\n0\n", 2).unwrap_err().to_string(),
            "2:1: 1 cells in this row, expected 2 as above"
        );
        let error = field("01\n02\n", 2).unwrap_err();
        assert_eq!((error.line, error.column), (2, 2));
        assert!(field("# none\n", 2).is_err());
        assert_eq!(map("1 inf\n2 3\n", (2, 2)).unwrap(), [1, u32::MAX, 2, 3]);
        assert!(map("1 0\n", (2, 1)).is_err());
        assert!(map("1 1\n", (1, 2)).is_err());
    }
}
