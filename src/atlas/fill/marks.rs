//! The colors drawn plainly: corner tiles as four quarter discs, Wang tiles as four triangles.
//!
//! The discs of a corner tile stay below half a side, so a strip meets only those of its side.
//! The triangles of a Wang tile meet along its diagonals, where a strip would show two of them:
//! the squares where two strips cross are left gray.

use super::{Canvas, mix};
use crate::atlas::{AtlasError, Format, Image, TileImages};
use crate::tiles::{Kind, TileId};

/// The ground, and what parts colors.
const GROUND: [f32; 3] = [0.93, 0.92, 0.9];
const LINE: [f32; 3] = [0.2, 0.2, 0.22];

/// The colors of each tile.
#[derive(Debug, Clone, Copy)]
pub struct Marks {
    /// What the pictures have in common.
    pub canvas: Canvas,
}

impl TileImages for Marks {
    fn side(&self) -> usize {
        self.canvas.side
    }

    fn format(&self) -> Format {
        self.canvas.format
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let canvas = &self.canvas;
        let colors = canvas.looks(canvas.sides(tile));
        Ok(canvas.paint(|x, y| match canvas.kind {
            Kind::Wang => triangles(canvas, &colors, x, y),
            _ => discs(canvas, &colors, x, y),
        }))
    }
}

/// Quarter discs about the corners, NE first and clockwise.
fn discs(canvas: &Canvas, colors: &[[f32; 3]; 4], x: usize, y: usize) -> [f32; 3] {
    let side = canvas.side as f32;
    let (east, south) = (2 * x >= canvas.side, 2 * y >= canvas.side);
    let color = colors[match (east, south) {
        (true, false) => 0,
        (true, true) => 1,
        (false, true) => 2,
        (false, false) => 3,
    }];
    let from = |at: usize, far: bool| at as f32 + 0.5 - if far { side } else { 0.0 };
    let (dx, dy) = (from(x, east), from(y, south));
    let distance = (dx * dx + dy * dy).sqrt();
    let radius = 0.42 * side;
    let line = (side / 64.0).clamp(0.5, 3.0);
    let inside = (radius - distance + 0.5).clamp(0.0, 1.0);
    let rim = (radius + line - distance + 0.5).clamp(0.0, 1.0);
    mix(mix(GROUND, LINE, rim), color, inside)
}

/// Triangles on the edges, N first and clockwise.
fn triangles(canvas: &Canvas, colors: &[[f32; 3]; 4], x: usize, y: usize) -> [f32; 3] {
    let (side, strip) = (canvas.side, canvas.strip);
    let corner = |at: usize| at < strip || at >= side - strip;
    if corner(x) && corner(y) {
        return GROUND;
    }
    let (right, down) = (x as f32 + 0.5, y as f32 + 0.5);
    let far = side as f32;
    // How far each edge is away; the nearest has the texel.
    let away = [down, far - right, far - down, right];
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&a, &b| away[a].total_cmp(&away[b]));
    let [first, second, ..] = order;
    let line = (far / 128.0).clamp(0.35, 1.5);
    // The distance to the diagonal between the two nearest edges.
    let gap = (away[second] - away[first]) * std::f32::consts::FRAC_1_SQRT_2;
    // A strip shows nothing but its edge.
    let within = away[first] < strip as f32;
    let cover = if within { 0.0 } else { (line - gap + 0.5).clamp(0.0, 1.0) };
    mix(colors[first], LINE, cover)
}
