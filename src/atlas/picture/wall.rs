//! What a brick wall looks like: around every corner of the grid a brick, mortar between them.
//!
//! Bricks differ a little in tone; with cyclic edges a brick that goes on at the other end keeps its
//! tone, so that the picture repeats without a seam.

use super::path::QUARTER;
use super::{Paint, Path, Scene};
use crate::dappled::brick::{Side, Wall, place};

/// Clays, and how often each: the last ones are rare.
pub const CLAYS: [[u8; 3]; 8] = [
    [170, 88, 68],
    [178, 96, 74],
    [162, 82, 65],
    [184, 106, 82],
    [156, 77, 63],
    [173, 99, 80],
    [147, 72, 61],
    [192, 120, 94],
];
/// Mortar.
pub const MORTAR: [u8; 3] = [211, 204, 193];
/// The shade that a brick throws on it.
const SHADE: [u8; 3] = [92, 70, 60];
/// The light on its upper edge.
const GLEAM: [u8; 3] = [255, 232, 212];
/// Width of a joint, in tile sides.
pub const JOINT: f64 = 0.075;
/// Radius of the corners of bricks.
pub const ROUND: f64 = 0.045;

/// A brick: left, top, right, bottom; and which of these sides are cut by the border.
#[derive(Debug, Clone, Copy)]
struct Brick {
    sides: [f64; 4],
    cut: [bool; 4],
}

impl Brick {
    /// Its outline without half a joint, moved a little.
    fn outline(&self, path: &mut Path, inset: f64, (dx, dy): (f64, f64)) {
        // The border stays where it is.
        let by = |side: usize, by: f64| if self.cut[side] { 0.0 } else { by };
        let [x0, y0, x1, y1] = self.sides;
        let (x0, y0) = (x0 + by(0, dx + inset), y0 + by(1, dy + inset));
        let (x1, y1) = (x1 + by(2, dx - inset), y1 + by(3, dy - inset));
        let round = |a: usize, b: usize| if self.cut[a] || self.cut[b] { 0.0 } else { ROUND };
        let k = 1.0 - QUARTER;
        let [nw, ne, se, sw] = [round(0, 1), round(1, 2), round(2, 3), round(3, 0)];
        path.move_to((x0 + nw, y0));
        path.line_to((x1 - ne, y0));
        path.cubic_to((x1 - ne * k, y0), (x1, y0 + ne * k), (x1, y0 + ne));
        path.line_to((x1, y1 - se));
        path.cubic_to((x1, y1 - se * k), (x1 - se * k, y1), (x1 - se, y1));
        path.line_to((x0 + sw, y1));
        path.cubic_to((x0 + sw * k, y1), (x0, y1 - sw * k), (x0, y1 - sw));
        path.line_to((x0, y0 + nw));
        path.cubic_to((x0, y0 + nw * k), (x0 + nw * k, y0), (x0 + nw, y0));
        path.close();
    }
}

/// The picture of a wall without free edges; with `cyclic` edges it repeats.
pub fn wall(wall: &Wall, cyclic: bool, seed: u64) -> Scene {
    let (width, height) = (wall.width(), wall.height());
    let mut scene = Scene::new(width as f64, height as f64);
    let mut ground = Path::default();
    for (column, row) in wall.cells() {
        ground.rectangle(column as f64, row as f64, 1.0, 1.0);
    }
    let (mut shade, mut gleam) = (Path::default(), Path::default());
    let mut clays = CLAYS.map(|_| Path::default());
    for y in 0..=height {
        for x in 0..=width {
            let corner = if cyclic { (x % width, y % height) } else { (x, y) };
            let clay = &mut clays[tone(corner, seed)];
            for brick in bricks(wall, x, y) {
                brick.outline(&mut shade, JOINT / 2.0 - 0.004, (0.016, 0.02));
                brick.outline(&mut gleam, JOINT / 2.0, (0.0, 0.0));
                // What is left of the one below is the light on its edge.
                brick.outline(clay, JOINT / 2.0 + 0.008, (0.005, 0.006));
            }
        }
    }
    scene.draw(ground, Paint::Fill, MORTAR);
    scene.draw_through(shade, Paint::Fill, SHADE, 55);
    scene.draw(gleam.clone(), Paint::Fill, CLAYS[0]);
    scene.draw_through(gleam, Paint::Fill, GLEAM, 35);
    for (path, color) in clays.into_iter().zip(CLAYS) {
        scene.draw(path, Paint::Fill, color);
    }
    scene
}

/// The parts of the brick around a corner: one, or its quarters where cells are missing.
fn bricks(wall: &Wall, x: usize, y: usize) -> Vec<Brick> {
    // The cells around the corner, and the sides on which its joints cross their edges.
    let quarter = |right: bool, low: bool| {
        let column = if right { Some(x) } else { x.checked_sub(1) };
        let row = if low { Some(y) } else { y.checked_sub(1) };
        let (column, row) = (column?, row?);
        let inside = column < wall.width() && row < wall.height() && wall.holds(column, row);
        inside.then(|| {
            let across = wall.at(column, row, if low { Side::North } else { Side::South });
            let down = wall.at(column, row, if right { Side::West } else { Side::East });
            let at = |from: usize, position| from as f64 + place(position, wall.positions());
            (at(column, across), at(row, down))
        })
    };
    let [nw, ne, sw, se] =
        [(false, false), (true, false), (false, true), (true, true)].map(|(r, l)| quarter(r, l));
    let (cx, cy) = (x as f64, y as f64);
    // A half or the whole is one brick where all of its quarters are there or cut by the border.
    let present = [nw, ne, sw, se].iter().filter(|part| part.is_some()).count();
    let straight = present == 2 && (nw.is_some() != se.is_some());
    if present == 4 || straight || present == 1 {
        let x0 = nw.or(sw).map(|part| part.0);
        let x1 = ne.or(se).map(|part| part.0);
        let y0 = nw.or(ne).map(|part| part.1);
        let y1 = sw.or(se).map(|part| part.1);
        let sides = [x0.unwrap_or(cx), y0.unwrap_or(cy), x1.unwrap_or(cx), y1.unwrap_or(cy)];
        let cut = [x0, y0, x1, y1].map(|side| side.is_none());
        return vec![Brick { sides, cut }];
    }
    let part = |part: Option<(f64, f64)>, right: bool, low: bool| {
        part.map(|(px, py)| Brick {
            sides: [px.min(cx), py.min(cy), px.max(cx), py.max(cy)],
            cut: [right, low, !right, !low],
        })
    };
    [part(nw, false, false), part(ne, true, false), part(sw, false, true), part(se, true, true)]
        .into_iter()
        .flatten()
        .collect()
}

/// The clay of a brick.
fn tone((x, y): (usize, usize), seed: u64) -> usize {
    let mixed = crate::dappled::make::start::mixed(seed, (y as u64) << 32 | x as u64);
    // The last half as often as the first.
    let at = (mixed >> 40) % (3 * CLAYS.len() as u64 / 2);
    (at % CLAYS.len() as u64) as usize
}
