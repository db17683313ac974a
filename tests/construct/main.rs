//! Constructions, each against the definition: every window counted by a few lines that know
//! nothing of constructions, then the verifier, then every tile looked up.

#![allow(clippy::unwrap_used)]

mod corners;
mod cubes;
mod members;
mod recursive;
mod rings;
mod shapes;
mod wang;

use tilepack::construct::{Constructed, NotConstructed, construct};
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::Shape;
use tilepack::verify;

/// All tiles.
pub(crate) fn complete(kind: Kind, colors: &str) -> TileSet {
    let colors: Colors = colors.parse().unwrap();
    TileSet::new(kind, colors, Members::Complete).unwrap()
}

/// All corner tiles over some colors, on a torus of this size.
pub(crate) fn corner(
    colors: usize,
    width: usize,
    height: usize,
    seed: Option<u64>,
) -> Result<Constructed, NotConstructed> {
    let shape = Shape::new(width as u64, height as u64).unwrap();
    construct(&complete(Kind::Corner, &colors.to_string()), shape, seed)
}

/// The labels, rows one after the other.
pub(crate) fn labels(torus: &Constructed) -> Vec<u8> {
    let mut labels = Vec::new();
    let all: Result<(), ()> = torus.try_for_each_row(|row, _| {
        labels.extend_from_slice(row);
        Ok(())
    });
    all.unwrap();
    labels
}

/// Whether every 2 x 2 window of colors occurs exactly once, from the definition.
pub(crate) fn has_every_window_once(colors: usize, width: usize, cells: &[u8]) -> bool {
    let height = cells.len() / width;
    let mut seen = vec![false; colors.pow(4)];
    let at = |row: usize, column: usize| usize::from(cells[row % height * width + column % width]);
    let once = (0..height).all(|row| {
        (0..width).all(|column| {
            let window = [(0, 0), (0, 1), (1, 0), (1, 1)];
            let colors_of = window.map(|(r, c)| at(row + r, column + c));
            let number = colors_of.into_iter().fold(0, |number, color| number * colors + color);
            colors_of.into_iter().all(|color| color < colors)
                && !std::mem::replace(&mut seen[number], true)
        })
    });
    once && cells.len() == seen.len()
}

/// Checks a construction in every way there is.
pub(crate) fn check(what: &Constructed) {
    let (set, shape) = (what.set(), what.shape());
    let name = format!("{} {} {shape}: {}", set.kind(), set.colors(), what.name());
    if set.kind() == Kind::Corner {
        let colors = set.colors().largest();
        assert!(has_every_window_once(colors, shape.width(), &labels(what)), "{name}");
    }
    let packing = what.packing();
    let verdict = verify::check(&packing);
    assert!(verdict.is_valid(), "{name}: {verdict}");
    for (cell, &tile) in packing.tiles.iter().enumerate() {
        let place = (cell / shape.width(), cell % shape.width());
        assert_eq!(what.locate(tile), Some(place), "{name}: tile {tile}");
    }
    let beyond = set.kind().tiles(set.colors()) as u32;
    assert_eq!(what.locate(TileId(beyond)), None);
}
