//! Pins of boards: squares that are given before a search, each with its turns.
//!
//! The file is as for a torus ([`read_pins`](super::read_pins)), with `null` also in the
//! `rotations` of JSON; a grid has a first line with the words of the board. The hints of
//! edge-matching puzzles are such pins. A square pins the colors of its four sides.

use super::grid::Grid;
use super::solutions::object;
use super::{Input, StoreError};
use crate::tiles::{Kind, TileId, TileSet, turn};
use crate::torus::{Board, Cell, Edges, Pins, Shape};

/// The pins of a file, for packings of `set` on a board of this shape.
///
/// # Errors
/// A malformed file; another kind, colors, size or board than the problem's; two squares that
/// disagree on a side they share, or one that disagrees with the border; a square that is not
/// in the set.
pub fn read_pins_on_board(
    input: &Input,
    set: &TileSet,
    shape: Shape,
    board: &Board,
) -> Result<Pins, StoreError> {
    let mut cells: Vec<(Cell, TileId, u8)> = Vec::new();
    let (said_set, said_shape, said_board);
    if input.is_json() {
        let (object, end) = object(input, input.start())?;
        if let Some(rest) = input.text()[end..].find(|c: char| !c.is_whitespace()) {
            return Err(input.error_at(end + rest, "expected the end of the file"));
        }
        (said_set, said_shape) = object.frame()?;
        said_board = object.board(said_shape)?;
        let mut turns = vec![0; said_shape.cells()];
        if said_board.rotations {
            object.turns(said_shape, true, |cell, turned| {
                turns[cell.index()] = turned.unwrap_or(0) as u8;
            })?;
        }
        object.tiles(&said_set, said_shape, true, |cell, tile| {
            cells.extend(tile.map(|tile| (cell, TileId(tile as u32), turns[cell.index()])));
        })?;
    } else {
        let grid = Grid::split(input)?;
        (said_shape, said_board) = (grid.shape, grid.board.clone());
        let colors = grid.header.colors.unwrap_or(set.colors());
        let kind = grid.header.kind.unwrap_or(set.kind());
        said_set = TileSet::new(kind, colors, crate::tiles::Members::Complete)
            .map_err(|error| input.error(error.to_string()))?;
        if said_board.rotations {
            grid.squares(&said_set, true, |cell, square| {
                cells.extend(square.map(|(tile, turned)| (cell, tile, turned)));
            })?;
        } else {
            grid.cells(&said_set, true, |cell, tile| {
                cells.extend(tile.map(|tile| (cell, TileId(tile), 0)));
            })?;
        }
    }
    for (what, file, asked) in [
        ("kind", said_set.kind().to_string(), set.kind().to_string()),
        ("colors", said_set.colors().to_string(), set.colors().to_string()),
        ("size", said_shape.to_string(), shape.to_string()),
        ("topology", said_board.topology.to_string(), board.topology.to_string()),
        ("rotations", said_board.rotations.to_string(), board.rotations.to_string()),
    ] {
        if file != asked {
            let message = format!("{what} {file} in the file, but {asked} in the problem");
            return Err(input.error(message));
        }
    }
    let edges = Edges { shape, topology: board.topology };
    let border = edges.given(&board.border);
    let mut pins = Pins::free_labels(edges.labels());
    for (cell, tile, turned) in cells {
        let wrong = |message: String| input.error_in(shape.position(cell), message);
        if !holds(set, tile, board.rotations) {
            let sides = set.kind().describe(tile, set.colors());
            return Err(wrong(format!(
                "tile {tile} ({sides}) is pinned here, but is not in the set"
            )));
        }
        let sides = turn::turned(Kind::Wang.unpack(tile, set.colors()), turned);
        for (side, (place, color)) in edges.sides(cell).into_iter().zip(sides).enumerate() {
            let name = Kind::Wang.sides()[side];
            if let Some(asked) = border[place].filter(|&asked| asked != color) {
                let message = format!("{name} has color {color}, but the border has {asked} there");
                return Err(wrong(message));
            }
            if let Err(known) = pins.pin(place, color) {
                let message = format!("{name} has color {color}, but it is pinned to {known}");
                return Err(wrong(message));
            }
        }
    }
    Ok(pins)
}

/// Whether a square, however it is turned, is in the set.
fn holds(set: &TileSet, tile: TileId, rotations: bool) -> bool {
    match turn::turns(tile, set.colors()) {
        Ok(shown) if rotations => shown.into_iter().any(|tile| set.allows(tile)),
        _ => set.allows(tile),
    }
}
