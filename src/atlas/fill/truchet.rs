//! Curves that go on from tile to tile (after S. Truchet 1704; C. S. Smith 1987).
//!
//! **Wang tiles**: a ribbon crosses the middle of every edge in the color of the edge; inside the
//! tile two arcs join neighboring edges, or two straight ribbons cross, which of the three by a
//! hash of the tile. Along a ribbon one color turns into the other. Within the strip a ribbon is
//! straight and of one color.
//!
//! **Corner tiles**: every corner is a hill in its color, and the contours of the land between
//! them are drawn. A hill ends before the strips of the other two sides, so that these know
//! nothing of it.

use super::{Canvas, hash, mix};
use crate::atlas::{AtlasError, Format, Image, TileImages};
use crate::tiles::{Kind, TileId};

/// What lies under the ribbons.
const GROUND: [f32; 3] = [0.13, 0.14, 0.19];
const WEAVE: [f32; 3] = [0.19, 0.2, 0.27];
/// Contours between two colors, and within one.
const RIDGE: [f32; 3] = [0.98, 0.97, 0.94];

/// Ribbons and contours.
#[derive(Debug, Clone, Copy)]
pub struct Truchet {
    /// What the pictures have in common.
    pub canvas: Canvas,
    /// Seed of the choice of arcs.
    pub seed: u64,
}

impl TileImages for Truchet {
    fn side(&self) -> usize {
        self.canvas.side
    }

    fn format(&self) -> Format {
        self.canvas.format
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let canvas = &self.canvas;
        let sides = canvas.sides(tile);
        let colors = canvas.looks(sides);
        let style = hash([self.seed, tile.0.into(), 0, 1]) % 3;
        Ok(canvas.paint(|x, y| match canvas.kind {
            Kind::Wang => ribbons(canvas, &colors, style, x, y),
            _ => contours(canvas, sides, &colors, x, y),
        }))
    }
}

/// A ribbon at a texel: how far its middle is away, and how far along it is, from 0 to 1.
type Ribbon = (f32, f32);

/// The ribbon that turns around a corner, given the distances to the two edges that meet
/// there: straight through the strip, then a quarter of a circle.
fn arc(first: f32, second: f32, half: f32, strip: f32) -> Ribbon {
    let radius = half - strip;
    let (u, v) = (first - strip, second - strip);
    if u <= 0.0 {
        return ((second - half).abs(), 0.0);
    }
    if v <= 0.0 {
        return ((first - half).abs(), 1.0);
    }
    // About the inner corner of the two strips; the ribbon leaves `first` where u is 0.
    let distance = (u * u + v * v).sqrt();
    ((distance - radius).abs(), u / (u + v))
}

/// A texel of a Wang tile.
fn ribbons(canvas: &Canvas, colors: &[[f32; 3]; 4], style: u64, x: usize, y: usize) -> [f32; 3] {
    let side = canvas.side as f32;
    let (half, strip) = (side / 2.0, canvas.strip as f32);
    let (right, down) = (x as f32 + 0.5, y as f32 + 0.5);
    // Distances to the edges N, E, S, W.
    let [n, e, s, w] = [down, side - right, side - down, right];
    let rim = (side / 40.0).max(0.6);
    // No ribbon reaches into the strip beside it.
    let width = (half - strip - rim - 1.0).min(0.16 * side);
    if width <= 0.0 {
        return GROUND;
    }
    let mut texel = GROUND;
    let mut lay = |(away, along): Ribbon, from: usize, to: usize| {
        let cover = (width + rim - away + 0.5).clamp(0.0, 1.0);
        texel = mix(texel, WEAVE, cover);
        let along = along * along * (3.0 - 2.0 * along);
        // Lighter along the middle: a ribbon is round.
        let shine = 0.35 * (1.0 - (away / width).min(1.0) * (away / width).min(1.0));
        let color = mix(mix(colors[from], colors[to], along), [1.0; 3], shine);
        texel = mix(texel, color, (width - away + 0.5).clamp(0.0, 1.0));
    };
    let across = |at: f32| ((at - strip) / (side - 2.0 * strip)).clamp(0.0, 1.0);
    match style {
        0 => {
            lay(arc(n, e, half, strip), 0, 1);
            lay(arc(s, w, half, strip), 2, 3);
        }
        1 => {
            lay(arc(n, w, half, strip), 0, 3);
            lay(arc(s, e, half, strip), 2, 1);
        }
        _ => {
            lay(((down - half).abs(), across(right)), 3, 1);
            lay(((right - half).abs(), across(down)), 0, 2);
        }
    }
    texel
}

/// A texel of a corner tile.
fn contours(
    canvas: &Canvas,
    sides: [u8; 4],
    colors: &[[f32; 3]; 4],
    x: usize,
    y: usize,
) -> [f32; 3] {
    let side = canvas.side as f32;
    let reach = side - canvas.strip as f32;
    let (right, down) = (x as f32 + 0.5, y as f32 + 0.5);
    // The corners NE, SE, SW, NW.
    let corners = [(side, 0.0), (side, side), (0.0, side), (0.0, 0.0)];
    let mut heights: [f32; 4] = corners.map(|(cx, cy)| {
        let (dx, dy) = (right - cx, down - cy);
        let rest = (1.0 - (dx * dx + dy * dy) / (reach * reach)).max(0.0);
        rest * rest
    });
    // Hills of one color are one hill.
    for corner in (1..4).rev() {
        if let Some(same) = (0..corner).find(|&other| sides[other] == sides[corner]) {
            heights[same] += heights[corner];
            heights[corner] = 0.0;
        }
    }
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&a, &b| heights[b].total_cmp(&heights[a]).then(sides[a].cmp(&sides[b])));
    let [first, second, ..] = order;
    let above = heights[first] - heights[second];
    // Terraces: alternately darker, with soft edges a texel wide.
    let slope = 2.2 / side;
    let terrace = above * 7.0;
    let step = terrace - terrace.floor();
    let soft = (7.0 * slope).min(0.5);
    let edge = ((0.5 - (step - 0.5).abs()) / soft).min(1.0);
    let dark = if (terrace.floor() as u32).is_multiple_of(2) { 0.0 } else { 0.16 };
    let shade = mix(colors[first], [0.0; 3], dark * edge + 0.08 * (1.0 - edge));
    let ridge = (1.6 - above / slope).clamp(0.0, 1.0);
    mix(shade, RIDGE, ridge)
}
