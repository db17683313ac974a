//! Text grids: numbers in rows, the form to write by hand.
//!
//! A corner grid shows the lattice colors, so its tiles always fit; Wang and domino grids show
//! tile numbers. `#` begins a comment, lines without a number are skipped, and the first line
//! may say what the grid is: `kind=wang colors=2,3 set=pruned:0-1 cover`.

use super::border::{border_in, border_word};
use super::claim::{Claim, ring_colors};
use super::solution::Solution;
use super::{Input, StoreError};
use crate::tiles::{Kind, Members, TileId, TileSet, notation};
use crate::torus::{Board, Border, Cell, Lattice, Packing, Shape, Topology};
use serde_json::Value;
use std::fmt::Display;
use std::io::{self, Write};

/// The rows of a grid, not yet read as numbers, and what its first line says.
pub(super) struct Grid<'a> {
    input: &'a Input,
    pub(super) header: Claim,
    /// What it says about the board.
    pub(super) board: Board,
    pub(super) shape: Shape,
    /// The byte offset of the first line that says anything.
    start: usize,
    /// The byte offset and text of every line that holds cells.
    rows: Vec<(usize, &'a str)>,
}

impl<'a> Grid<'a> {
    /// Finds the first line and the rows, which must have the same length.
    pub(super) fn split(input: &'a Input) -> Result<Self, StoreError> {
        let mut lines = lines(input).peekable();
        let start = lines.peek().map_or(0, |line| line.0);
        let is_header = |word: &str| word.contains('=') || ["cover", "rotations"].contains(&word);
        let header = lines.next_if(|(_, line)| words(line).next().is_some_and(|w| is_header(w.1)));
        let said = header.map_or(Ok(Default::default()), |line| read_header(input, line))?;
        let (header, said): (Claim, BoardWords<'_>) = said;
        let rows: Vec<_> = lines.collect();
        let width = rows.first().map_or(0, |(_, line)| words(line).count());
        for (row, (offset, line)) in rows.iter().enumerate() {
            let count = words(line).count();
            if count != width {
                let place = words(line).nth(width).map_or(line.trim_end().len(), |word| word.0);
                let message = format!("row {row} has {count} cells, but row 0 has {width}");
                return Err(input.error_at(offset + place, message));
            }
        }
        if rows.is_empty() {
            return Err(input.error("expected a solution, as JSON or as rows of numbers"));
        }
        let shape = Shape::new(width as u64, rows.len() as u64);
        let shape = shape.map_err(|error| input.error(error.to_string()))?;
        let border = match said.border {
            None => Border::default(),
            Some((offset, word)) => border_in(word, said.topology, shape)
                .map_err(|message| input.error_at(offset, message))?,
        };
        let board = Board { topology: said.topology, rotations: said.rotations, border };
        Ok(Self { input, header, board, shape, start, rows })
    }

    /// Passes on the cells of a board with their quarter turns, written `12/3`, row by row.
    pub(super) fn squares(
        &self,
        all: &TileSet,
        free: bool,
        mut take: impl FnMut(Cell, Option<(TileId, u8)>),
    ) -> Result<(), StoreError> {
        let max = all.kind().tiles(all.colors()) - 1;
        for (row, (start, line)) in self.rows.iter().enumerate() {
            for (column, (offset, word)) in words(line).enumerate() {
                let square = word.split_once('/').and_then(|(tile, turns)| {
                    let tile = decimal(tile).filter(|&tile| tile <= max)?;
                    let turns = decimal(turns).filter(|&turns| turns < 4)?;
                    Some((TileId(tile as u32), turns as u8))
                });
                if square.is_none() && !(free && word == ".") {
                    let or = if free { " or ." } else { "" };
                    let message = format!(
                        "square '{word}': expected N/T, a tile from 0 to {max} and 0 to 3 \
                         quarter turns{or}"
                    );
                    return Err(self.input.error_at(start + offset, message));
                }
                take(self.shape.cell(row, column), square);
            }
        }
        Ok(())
    }

    /// Passes on the cells row by row; `.` is a free cell where `free` allows it.
    pub(super) fn cells(
        &self,
        all: &TileSet,
        free: bool,
        mut take: impl FnMut(Cell, Option<u32>),
    ) -> Result<(), StoreError> {
        let (what, max) = match all.kind() {
            Kind::Corner => ("color", all.colors().horizontal() as u64 - 1),
            kind => ("tile", kind.tiles(all.colors()) - 1),
        };
        for (row, (start, line)) in self.rows.iter().enumerate() {
            for (column, (offset, word)) in words(line).enumerate() {
                let number = decimal(word).filter(|&number| number <= max);
                if number.is_none() && !(free && word == ".") {
                    let or = if free { " or ." } else { "" };
                    let message = format!("{what} '{word}': expected a number from 0 to {max}{or}");
                    return Err(self.input.error_at(start + offset, message));
                }
                take(self.shape.cell(row, column), number.map(|number| number as u32));
            }
        }
        Ok(())
    }
}

/// The lines that hold more than a comment, with their byte offsets, without comments.
fn lines(input: &Input) -> impl Iterator<Item = (usize, &str)> {
    let text = input.text();
    let place = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    text.lines()
        .map(|line| line.trim_start_matches('\u{feff}'))
        .map(|line| line.split('#').next().unwrap_or_default())
        .filter(|line| !line.trim().is_empty())
        .map(move |line| (place(line), line))
}

/// The words of a line with their byte offsets in it.
fn words(line: &str) -> impl Iterator<Item = (usize, &str)> {
    line.split_whitespace().map(|word| (word.as_ptr() as usize - line.as_ptr() as usize, word))
}

/// A number of decimal digits and nothing else.
fn decimal(word: &str) -> Option<u64> {
    let digits = !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
    if digits { word.parse().ok() } else { None }
}

/// What a first line says about the board.
#[derive(Default)]
struct BoardWords<'a> {
    topology: Topology,
    rotations: bool,
    border: Option<(usize, &'a str)>,
}

fn read_header<'a>(
    input: &Input,
    (start, line): (usize, &'a str),
) -> Result<(Claim, BoardWords<'a>), StoreError> {
    let mut header = Claim::default();
    let mut board = BoardWords::default();
    let mut topology = None;
    for (offset, word) in words(line) {
        let wrong = |message: &dyn Display| input.error_at(start + offset, message.to_string());
        let twice = match word.split_once('=') {
            Some(("kind", kind)) => {
                header.kind.replace(kind.parse().map_err(|error| wrong(&error))?).is_some()
            }
            Some(("colors", colors)) => {
                header.colors.replace(colors.parse().map_err(|error| wrong(&error))?).is_some()
            }
            Some(("set", set)) => {
                let members = read_members(set).map_err(|error| wrong(&error))?;
                header.members.replace(members).is_some()
            }
            Some(("topology", text)) => {
                board.topology = text.parse().map_err(|error: String| wrong(&error))?;
                topology.replace(()).is_some()
            }
            Some(("border", text)) => board.border.replace((start + offset, text)).is_some(),
            None if word == "cover" => header.cover.replace(true).is_some(),
            None if word == "rotations" => std::mem::replace(&mut board.rotations, true),
            _ => {
                let expected =
                    "expected kind=, colors=, set=, cover, topology=, border= or rotations";
                return Err(wrong(&format!("'{word}': {expected}")));
            }
        };
        if twice {
            return Err(wrong(&format!("'{word}': said before on this line")));
        }
    }
    Ok((header, board))
}

/// The notation of the command line, and `tiles:5,7` for an explicit set.
fn read_members(text: &str) -> Result<Members, String> {
    if let Some(tiles) = text.strip_prefix("tiles:") {
        let wrong = || format!("set '{text}': expected tiles:N,N,...");
        let number = |word| decimal(word).and_then(|n| u32::try_from(n).ok()).ok_or_else(wrong);
        return Ok(Members::Explicit(
            tiles.split(',').map(|word| number(word).map(TileId)).collect::<Result<_, _>>()?,
        ));
    }
    match notation::parse_members(text) {
        Ok(Some(members)) => Ok(members),
        // No pairs at all: the command line has no use for it, but a set may be like that.
        _ if text == "pruned:" => Ok(Members::Pruned(Vec::new())),
        _ => Err(format!(
            "set '{text}': expected complete, compact, pruned:A-B,C-D,... or tiles:N,N,..."
        )),
    }
}

/// Reads the packing of a grid.
pub(super) fn read(input: &Input, claim: &Claim) -> Result<Solution, StoreError> {
    let grid = Grid::split(input)?;
    let wrong = |message: &dyn Display| input.error_at(grid.start, message.to_string());
    let first = grid.rows.first().and_then(|(row, line)| Some((row, words(line).next()?)));
    if let Some((row, (offset, word))) = first
        && decimal(word).is_none()
        && !(grid.board.rotations && word.contains('/'))
    {
        let message = format!("'{word}': expected '{{', as JSON begins, or a number of a grid");
        return Err(input.error_at(row + offset, message));
    }
    let said = grid.header.clone().or(claim);
    let (Some(kind), Some(colors)) = (said.kind, said.colors) else {
        let what =
            if said.kind.is_some() { "colors of the grid are" } else { "kind of the grid is" };
        return Err(wrong(&format!(
            "the {what} not known: expected a first line like 'kind=corner colors=4', \
             or the options --kind and --colors"
        )));
    };
    let colors = ring_colors(kind, grid.shape, colors);
    let members = said.members.unwrap_or(Members::Complete);
    let board = grid.board.clone();
    if kind != Kind::Wang && !board.is_plain() {
        return Err(wrong(&format!("only Wang tiles lie on boards, but the kind is {kind}")));
    }
    let set = match members {
        Members::Explicit(tiles) if board.rotations => TileSet::squares(colors, tiles),
        members => TileSet::new(kind, colors, members),
    };
    let set = set.map_err(|error| wrong(&error))?;
    let cover = said.cover.unwrap_or(false);
    if let Some(message) =
        claim.contradiction(&set, grid.shape, cover).map_err(|error| wrong(&error))?
    {
        return Err(wrong(&message));
    }
    let packing = if kind == Kind::Corner {
        let mut labels = Vec::new();
        grid.cells(&set, false, |_, color| labels.extend(color.map(|color| color as u8)))?;
        Lattice { kind, shape: grid.shape }.packing(&labels, &set, cover)
    } else if board.rotations {
        let (mut tiles, mut turns) = (Vec::new(), Vec::new());
        grid.squares(&set, false, |_, square| {
            tiles.extend(square.map(|(tile, _)| tile));
            turns.extend(square.map(|(_, turned)| turned));
        })?;
        Packing { board, turns, ..Packing::new(set, grid.shape, cover, tiles) }
    } else {
        let mut tiles = Vec::new();
        grid.cells(&set, false, |_, tile| tiles.extend(tile.map(TileId)))?;
        Packing { board, ..Packing::new(set, grid.shape, cover, tiles) }
    };
    let line = 1 + input.text()[..grid.start].bytes().filter(|&byte| byte == b'\n').count();
    Ok(Solution { packing, provenance: Value::Null, line })
}

/// Writes a packing as a text grid with a first line; equal arguments give equal bytes.
///
/// # Errors
/// What `out` reports, and [`io::ErrorKind::InvalidInput`] for corner tiles that do not fit, for
/// no lattice colors describe them.
pub fn write_grid(mut out: impl Write, packing: &Packing) -> io::Result<()> {
    let set = &packing.set;
    let numbers: Vec<u32> = if set.kind() == Kind::Corner {
        let labels = Lattice::labels_of(packing).map_err(|cell| {
            let (row, column) = packing.shape.position(cell);
            let message = format!("the corners at row {row}, column {column} do not fit");
            io::Error::new(io::ErrorKind::InvalidInput, message)
        })?;
        labels.into_iter().map(u32::from).collect()
    } else {
        packing.tiles.iter().map(|tile| tile.0).collect()
    };
    let largest = numbers.iter().max().copied().unwrap_or(0);
    write_grid_head(&mut out, packing)?;
    if packing.board.rotations {
        let squares = packing.tiles.iter().zip(&packing.turns);
        let words: Vec<_> = squares.map(|(tile, turns)| format!("{tile}/{turns}")).collect();
        let longest = words.iter().map(String::len).max().unwrap_or(0);
        return words.chunks(packing.shape.width()).try_for_each(|row| {
            let row: Vec<_> = row.iter().map(|word| format!("{word:>longest$}")).collect();
            writeln!(out, "{}", row.join(" "))
        });
    }
    numbers
        .chunks(packing.shape.width())
        .try_for_each(|row| write_grid_row(&mut out, row.iter().copied(), largest))
}

/// Writes the first line of a grid: what the packing is; its tiles are not looked at.
///
/// # Errors
/// What `out` reports.
pub fn write_grid_head(mut out: impl Write, about: &Packing) -> io::Result<()> {
    let set = &about.set;
    let members = match set.members() {
        Members::Explicit(tiles) => {
            let tiles: Vec<_> = tiles.iter().map(TileId::to_string).collect();
            format!("tiles:{}", tiles.join(","))
        }
        members => notation::write_members(members),
    };
    write!(out, "kind={} colors={} set={members}", set.kind(), set.colors())?;
    write!(out, "{}", if about.cover { " cover" } else { "" })?;
    let Board { topology, rotations, border } = &about.board;
    if *topology != Topology::Torus {
        write!(out, " topology={topology}")?;
    }
    if !border.is_free() {
        write!(out, " border={}", border_word(border, *topology, about.shape))?;
    }
    writeln!(out, "{}", if *rotations { " rotations" } else { "" })
}

/// Writes a row of a grid, lattice colors for corner tiles, else tile numbers; `largest` is the
/// largest number of the grid.
///
/// # Errors
/// What `out` reports.
pub fn write_grid_row(
    mut out: impl Write,
    row: impl Iterator<Item = u32>,
    largest: u32,
) -> io::Result<()> {
    let digits = largest.to_string().len();
    let row: Vec<_> = row.map(|number| format!("{number:>digits$}")).collect();
    writeln!(out, "{}", row.join(" "))
}
