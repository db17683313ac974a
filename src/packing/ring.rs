//! Rings of dominoes as Wang tiles.
//!
//! A domino is a Wang tile that has one color on its two other edges: a ring along a row is a
//! torus of height 1 whose north and south edges all show color 0, a ring down a column one of
//! width 1. So dominoes need no search of their own.

use super::Task;
use super::reduction::Reduction;
use super::wang::Shown;
use crate::symmetry::{Anchor, Automorphism, ColorMap};
use crate::tiles::{Color, Colors, Domino, Kind, Members, TileError, TileId, TileSet, Wang};
use crate::torus::{Lattice, Pins};

/// Whether the ring lies along a row.
fn is_row(task: &Task) -> bool {
    task.shape.height() == 1
}

fn wang_colors(task: &Task) -> Result<Colors, TileError> {
    let count = task.set.colors().vertical() as u64;
    if is_row(task) { Colors::pair(1, count) } else { Colors::pair(count, 1) }
}

fn wang_tile(task: &Task, colors: Colors, domino: TileId) -> TileId {
    let Domino { first, second } = Domino::from_id(domino, task.set.colors());
    let blank = Color(0);
    match is_row(task) {
        true => Wang { n: blank, e: second, s: blank, w: first }.id(colors),
        false => Wang { n: first, e: blank, s: second, w: blank }.id(colors),
    }
}

/// The same question about Wang tiles.
///
/// # Errors
/// None for a task that has been checked.
pub fn task(task: &Task) -> Result<Task, TileError> {
    let colors = wang_colors(task)?;
    let members = match task.set.members() {
        Members::Complete => Members::Complete,
        _ => Members::Explicit(
            task.set.allowed().map(|domino| wang_tile(task, colors, domino)).collect(),
        ),
    };
    let set = TileSet::new(Kind::Wang, colors, members)?;
    let lattice = Lattice { kind: Kind::Wang, shape: task.shape };
    let mut pins = Pins::free(lattice);
    for (cell, pin) in task.pins.labels().iter().enumerate() {
        if let Some(color) = *pin {
            // The blank edges are known too; every label is pinned once, so nothing clashes.
            let _ = pins.pin(label(is_row(task), cell), color);
            let _ = pins.pin(label(!is_row(task), cell), 0);
        }
    }
    let automorphism = task.automorphism.as_ref().map(|automorphism| {
        let ends = automorphism.map.vertical().to_vec();
        let maps = if is_row(task) { (vec![0], ends) } else { (ends, vec![0]) };
        let map = ColorMap::new(colors, maps.0, maps.1);
        let map = map.unwrap_or_else(|| ColorMap::identity(colors));
        Automorphism { dx: automorphism.dx, dy: automorphism.dy, map }
    });
    Ok(Task { set, pins, automorphism, ..task.clone() })
}

/// The same assumptions about Wang tiles.
///
/// # Errors
/// None for a task that has been checked.
pub fn reduction(task: &Task, reduction: &Reduction) -> Result<Reduction, TileError> {
    let colors = wang_colors(task)?;
    let mut reduction = reduction.clone();
    if let Anchor::Tile(domino) = reduction.anchor {
        reduction.anchor = Anchor::Tile(wang_tile(task, colors, domino));
    }
    Ok(reduction)
}

/// Where the label of a cell of a ring stands among the labels of Wang tiles.
fn label(is_row: bool, cell: usize) -> usize {
    2 * cell + usize::from(is_row)
}

/// Which labels of the Wang tiles are those of the ring.
pub fn shown(task: &Task) -> Shown {
    if is_row(task) { Shown::West } else { Shown::North }
}
