//! Pin files: cells that are given before a search.
//!
//! A pin file is a text grid in which `.` is a free cell, or a solution JSON in which `null` is
//! one. A cell of a corner grid pins one lattice color; a tile pins the labels of all its sides,
//! so the tiles around it feel it, too. Which set and whether it is a covering is for the
//! problem to say; a pin file need not repeat it.

use super::claim::ring_colors;
use super::grid::Grid;
use super::solutions::object;
use super::{Input, StoreError};
use crate::tiles::{Colors, Kind, Members, TileId, TileSet};
use crate::torus::{Cell, Lattice, Pins, Shape};
use std::fmt::Display;

/// The pins of a file, for packings of `set` on `lattice`.
///
/// # Errors
/// A malformed file; another kind, other colors or another size than the problem's; two tiles
/// that disagree on a side they share; a tile that is not in the set, also one whose sides are
/// pinned by its neighbors.
pub fn read_pins(input: &Input, lattice: Lattice, set: &TileSet) -> Result<Pins, StoreError> {
    // Pins are checked against the set with positions at the end, so read any tile here.
    let all = TileSet::new(set.kind(), set.colors(), Members::Complete);
    let all = all.map_err(|error| input.error(error.to_string()))?;
    let mut pinning = Pinning { input, lattice, set, pins: Pins::free(lattice), by: Vec::new() };
    pinning.by = vec![None; lattice.labels()];
    if input.is_json() {
        let (object, end) = object(input, input.start())?;
        if !input.text()[end..].trim().is_empty() {
            let blank = input.text()[end..].len() - input.text()[end..].trim_start().len();
            return Err(input.error_at(end + blank, "expected the end of the file"));
        }
        let (said, shape) = object.frame()?;
        pinning.check_problem(Some(said.kind()), Some(said.colors()), shape)?;
        let mut cells = Vec::new();
        object.tiles(&all, shape, true, |cell, tile| {
            cells.extend(tile.map(|tile| (cell, TileId(tile as u32))));
        })?;
        for (cell, tile) in cells {
            pinning.pin_tile(cell, tile)?;
        }
    } else {
        let grid = Grid::split(input)?;
        pinning.check_problem(grid.header.kind, grid.header.colors, grid.shape)?;
        let mut cells = Vec::new();
        grid.cells(&all, true, |cell, number| cells.extend(number.map(|n| (cell, n))))?;
        for (cell, number) in cells {
            match lattice.kind {
                // A cell of a corner grid is a label of its own, so none can be pinned twice.
                Kind::Corner => {
                    let _ = pinning.pins.pin(cell.index(), number as u8);
                }
                _ => pinning.pin_tile(cell, TileId(number))?,
            }
        }
    }
    pinning.check_members()?;
    Ok(pinning.pins)
}

struct Pinning<'a> {
    input: &'a Input,
    lattice: Lattice,
    set: &'a TileSet,
    pins: Pins,
    /// For each label, the cell and the side that pinned it first.
    by: Vec<Option<(Cell, &'static str)>>,
}

impl Pinning<'_> {
    fn check_problem(
        &self,
        kind: Option<Kind>,
        colors: Option<Colors>,
        shape: Shape,
    ) -> Result<(), StoreError> {
        let (set, size) = (self.set, self.lattice.shape);
        let differ = |what: &str, file: &dyn Display, wanted: &dyn Display| {
            let message = format!("{what} {file} in the file, but {wanted} in the problem");
            Err(self.input.error(message))
        };
        if let Some(kind) = kind.filter(|&kind| kind != set.kind()) {
            return differ("kind", &kind, &set.kind());
        }
        if shape != size {
            return differ("size", &shape, &size);
        }
        let colors = colors.map(|colors| ring_colors(set.kind(), shape, colors));
        if let Some(colors) = colors.filter(|&colors| colors != set.colors()) {
            return differ("colors", &colors, &set.colors());
        }
        Ok(())
    }

    fn pin_tile(&mut self, cell: Cell, tile: TileId) -> Result<(), StoreError> {
        let (kind, shape) = (self.set.kind(), self.lattice.shape);
        if !self.set.allows(tile) {
            return Err(self.not_in_set(cell, tile));
        }
        let colors = kind.unpack(tile, self.set.colors());
        for ((label, color), &side) in
            self.lattice.sides(cell).into_iter().zip(colors).zip(kind.sides())
        {
            if let Err(known) = self.pins.pin(label, color) {
                let what = if kind == Kind::Corner { "corner" } else { "side" };
                let message = match self.by[label] {
                    Some((other, its)) if other == cell => {
                        format!(
                            "{side} has color {color}, but meets {its} of the same tile, {known}"
                        )
                    }
                    Some((other, its)) => {
                        let (row, column) = shape.position(other);
                        format!(
                            "{side} has color {color}, but the tile at row {row}, column {column} \
                             pins this {what}, its {its}, to color {known}"
                        )
                    }
                    None => format!("{side} has color {color}, but it is pinned to {known}"),
                };
                return Err(self.input.error_in(shape.position(cell), message));
            }
            self.by[label].get_or_insert((cell, side));
        }
        Ok(())
    }

    /// Every tile all of whose sides are pinned must be in the set.
    fn check_members(&self) -> Result<(), StoreError> {
        let mut labels: Vec<u8> = Vec::with_capacity(self.lattice.labels());
        labels.extend(self.pins.labels().iter().map(|label| label.unwrap_or(0)));
        for cell in (0..self.lattice.shape.cells() as u32).map(Cell) {
            let sides = self.lattice.sides(cell);
            if sides.into_iter().all(|label| self.pins.get(label).is_some()) {
                let tile = self.lattice.tile(&labels, self.set, cell);
                if !self.set.allows(tile) {
                    return Err(self.not_in_set(cell, tile));
                }
            }
        }
        Ok(())
    }

    fn not_in_set(&self, cell: Cell, tile: TileId) -> StoreError {
        let sides = self.set.kind().describe(tile, self.set.colors());
        let message = format!("tile {tile} ({sides}) is pinned here, but is not in the set");
        self.input.error_in(self.lattice.shape.position(cell), message)
    }
}
