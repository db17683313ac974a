//! Tiles put together: a packing with what lies around it, every tile of a set, a tiling.

use super::marks::{Detail, INK, Marks, PAPER};
use super::{Paint, Path, Scene, digits};
use crate::atlas::demo::Demo;
use crate::tiles::{Members, TileId};
use crate::torus::Packing;

/// Tiles of a picture at most.
pub const MAX_TILES: usize = 1 << 16;

/// Tiles up to which colors are numbered: more would be dust.
const WITH_GLYPHS: usize = 1024;

/// Texels of a tile from which colors are numbered and tiles have lines around them.
const LEGIBLE: u32 = 24;

/// What to draw of so many tiles of so many texels.
fn detail(tiles: usize, size: u32, indices: bool) -> Detail {
    let legible = size >= LEGIBLE;
    Detail { glyphs: legible && tiles <= WITH_GLYPHS, indices, lines: legible }
}

/// The packing, and around it, faded, the tiles of the other side: the torus closes.
pub fn preview(packing: &Packing, size: u32, indices: bool) -> Scene {
    let (w, h) = (packing.shape.width(), packing.shape.height());
    let mut marks = Marks::new(&packing.set, detail(packing.tiles.len(), size, indices));
    for row in 0..h + 2 {
        for column in 0..w + 2 {
            let tile = packing.tiles[(row + h - 1) % h * w + (column + w - 1) % w];
            marks.tile(tile, (column as f64, row as f64));
        }
    }
    let (width, height) = (w as f64, h as f64);
    let mut scene = Scene::new(width + 2.0, height + 2.0);
    marks.put(&mut scene);
    let mut around = Path::default();
    around.rectangle(0.0, 0.0, width + 2.0, 1.0);
    around.rectangle(0.0, height + 1.0, width + 2.0, 1.0);
    around.rectangle(0.0, 1.0, 1.0, height);
    around.rectangle(width + 1.0, 1.0, 1.0, height);
    scene.draw_through(around, Paint::Fill, PAPER, 65);
    let mut frame = Path::default();
    frame.rectangle(1.0, 1.0, width, height);
    scene.draw(frame, Paint::Stroke(0.05), INK);
    scene
}

/// Distance from a tile of a contact sheet to the next one, across and down: below is its number.
const PITCH: (f64, f64) = (1.3, 1.6);
/// White around all tiles, and height of the numbers.
const MARGIN: f64 = 0.4;
const NUMBER: f64 = 0.2;

/// Every tile of the packing once, by number. A row of a complete set has the tiles that differ
/// in the last two sides only, where that is not too long.
pub fn contact_sheet(packing: &Packing, size: u32) -> Scene {
    let mut tiles: Vec<TileId> = packing.tiles.clone();
    tiles.sort_unstable();
    tiles.dedup();
    let set = &packing.set;
    let square = (tiles.len() as f64 * PITCH.1 / PITCH.0).sqrt().ceil() as usize;
    let last_two = set.kind().radices(set.colors()).iter().rev().take(2).product();
    let columns = match set.members() {
        Members::Complete if (3..=36).contains(&last_two) => last_two,
        _ => square.clamp(1, tiles.len()),
    };
    let rows = tiles.len().div_ceil(columns);
    let mut marks = Marks::new(set, detail(tiles.len(), size, false));
    let mut numbers = Path::default();
    let last = tiles.last().map_or(0, |tile| tile.0);
    let height = digits::height(last, NUMBER, 1.0);
    for (place, &tile) in tiles.iter().enumerate() {
        let x = MARGIN + (place % columns) as f64 * PITCH.0;
        let y = MARGIN + (place / columns) as f64 * PITCH.1;
        marks.tile(tile, (x, y));
        let center = (x + 0.5, y + 1.0 + 0.13 + NUMBER / 2.0);
        digits::add(&mut numbers, tile.0, center, height);
    }
    let length = |count: usize, pitch: f64| 2.0 * MARGIN + (count - 1) as f64 * pitch + 1.0;
    let mut scene = Scene::new(length(columns, PITCH.0), length(rows, PITCH.1) + PITCH.1 - PITCH.0);
    marks.put(&mut scene);
    scene.draw(numbers, Paint::Stroke(digits::STROKE * height), INK);
    scene
}

/// A piece of a tiling, without lines between tiles and without numbers: as a whole.
pub fn tiling(packing: &Packing, demo: &Demo, size: u32, indices: bool) -> Scene {
    let detail =
        Detail { glyphs: false, lines: indices, ..detail(demo.tiles.len(), size, indices) };
    let mut marks = Marks::new(&packing.set, detail);
    let width = demo.shape.width();
    for (cell, &tile) in demo.tiles.iter().enumerate() {
        marks.tile(tile, ((cell % width) as f64, (cell / width) as f64));
    }
    let mut scene = Scene::new(width as f64, demo.shape.height() as f64);
    marks.put(&mut scene);
    scene
}
