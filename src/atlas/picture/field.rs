//! Fields of tiles as people look at them: a square for each cell, and a dot on every cell that
//! differs from another field.

use super::{Paint, Path, Scene};
use crate::atlas::palette;
use crate::dappled::{FREE, Field};

/// The looks of tiles 0 and 1, when these are all.
const TWO: [[u8; 3]; 2] = [[38, 70, 83], [240, 232, 214]];
/// A cell without a tile.
const HOLE: [u8; 3] = [255, 255, 255];
/// The dot on a cell that differs.
const DOT: [u8; 3] = [231, 90, 60];
/// Its radius, in cells.
const RADIUS: f64 = 0.26;

/// The picture of a field, and of how it differs from another of the same size.
pub fn scene(field: &Field, tiles: usize, against: Option<&Field>) -> Scene {
    let mut scene = Scene::new(field.width() as f64, field.height() as f64);
    let mut looks = vec![Path::default(); tiles + 1];
    let mut dots = Path::default();
    for (row, cells) in field.rows().enumerate() {
        for (column, &tile) in cells.iter().enumerate() {
            let (x, y) = (column as f64, row as f64);
            let look = if tile == FREE { tiles } else { usize::from(tile) };
            looks[look].rectangle(x, y, 1.0, 1.0);
            if against.is_some_and(|other| other.at(column, row) != tile) {
                dots.pill((x + 0.5, y + 0.5), 2.0 * RADIUS, 2.0 * RADIUS);
            }
        }
    }
    for (look, path) in looks.into_iter().enumerate() {
        let color = match look {
            free if free == tiles => HOLE,
            tile if tiles == 2 => TWO[tile],
            tile => palette::rgb(tile as u8),
        };
        scene.draw(path, Paint::Fill, color);
    }
    scene.draw(dots, Paint::Fill, DOT);
    scene
}
