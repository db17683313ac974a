//! Scenes as texels.
//!
//! Each part of a path covers some of every texel: looked at are eight heights in a row of texels,
//! and there what lies between the places where the outline crosses, by the rule of non-zero
//! winding. A stroke is the union of rectangles along its lines and discs at its points. Parts of
//! an area lie side by side, so that what they cover adds up; parts of strokes lie on each other.

use super::{Paint, Path, Point, Scene, Shape};
use crate::atlas::{Channels, Depth, Format, Image, Light};

/// Heights in a row of texels at which an outline is looked at.
const HEIGHTS: usize = 8;

/// Corners of the polygon that stands for a disc.
const DISC: [Point; 12] = [
    (1.0, 0.0),
    (0.866, 0.5),
    (0.5, 0.866),
    (0.0, 1.0),
    (-0.5, 0.866),
    (-0.866, 0.5),
    (-1.0, 0.0),
    (-0.866, -0.5),
    (-0.5, -0.866),
    (0.0, -1.0),
    (0.5, -0.866),
    (0.866, -0.5),
];

/// Red, green and blue in 8 bits each.
const RGB8: Format = Format { channels: Channels::Rgb, depth: Depth::Eight, light: Light::Srgb };

/// The texels of a scene, `size` to a tile.
pub fn draw(scene: &Scene, size: u32) -> Image {
    let scale = f64::from(size);
    let side = |length: f64| (length * scale).round() as usize;
    let mut image = Image::new(side(scene.width), side(scene.height), RGB8);
    for y in 0..image.height() {
        image.row_mut(y).fill(255);
    }
    let (width, height) = (image.width(), image.height());
    for shape in &scene.shapes {
        let mut mask = Mask { width, height, covered: vec![0; width * height] };
        match shape.paint {
            Paint::Fill => {
                for (points, _) in shape.path.flattened(scale) {
                    mask.add(&[points], u8::saturating_add);
                }
            }
            Paint::Stroke(width) => mask.stroke(&shape.path, scale, width * scale / 2.0),
        }
        for (y, covered) in mask.covered.chunks(width).enumerate() {
            paint(image.row_mut(y), covered, shape);
        }
    }
    image
}

/// Mixes the color of a shape into a row.
fn paint(row: &mut [u8], covered: &[u8], shape: &Shape) {
    for (texel, &covered) in row.chunks_exact_mut(3).zip(covered) {
        if covered > 0 {
            let part = u32::from(covered) * u32::from(shape.opacity);
            for (sample, of) in texel.iter_mut().zip(shape.color) {
                let mixed = u32::from(*sample) * (ALL - part) + u32::from(of) * part;
                *sample = ((mixed + ALL / 2) / ALL) as u8;
            }
        }
    }
}

/// A texel that is covered, by what lets nothing through.
const ALL: u32 = 255 * 100;

/// How much of each texel is covered, of 255.
struct Mask {
    width: usize,
    height: usize,
    covered: Vec<u8>,
}

impl Mask {
    fn stroke(&mut self, path: &Path, scale: f64, half: f64) {
        let disc = |(x, y): Point| DISC.map(|(dx, dy)| (x + dx * half, y + dy * half)).to_vec();
        for (mut points, closed) in path.flattened(scale) {
            if closed && let Some(&first) = points.first() {
                points.push(first);
            }
            let mut parts: Vec<Vec<Point>> = points.iter().map(|&point| disc(point)).collect();
            for line in points.windows(2) {
                let ((ax, ay), (bx, by)) = (line[0], line[1]);
                let length = ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)).sqrt();
                if length > 0.0 {
                    let (nx, ny) = ((by - ay) / length * half, (ax - bx) / length * half);
                    let [a, b] = [(ax + nx, ay + ny), (bx + nx, by + ny)];
                    parts.push(vec![a, b, (bx - nx, by - ny), (ax - nx, ay - ny)]);
                }
            }
            self.add(&parts, u8::max);
        }
    }

    /// Adds the union of polygons that all run the same way around.
    fn add(&mut self, polygons: &[Vec<Point>], join: fn(u8, u8) -> u8) {
        let points = || polygons.iter().flatten();
        let range = |of: fn(&Point) -> f64, end: usize| {
            let low = points().map(of).fold(f64::INFINITY, f64::min).floor().max(0.0);
            let high = points().map(of).fold(f64::NEG_INFINITY, f64::max).ceil().min(end as f64);
            low as usize..high.max(0.0) as usize
        };
        let rows = range(|point| point.1, self.height);
        let columns = range(|point| point.0, self.width);
        if columns.is_empty() {
            return;
        }
        let mut part = vec![0.0; columns.len()];
        let mut crossings: Vec<(f64, i32)> = Vec::new();
        for y in rows {
            part.fill(0.0);
            for height in 0..HEIGHTS {
                let level = y as f64 + (height as f64 + 0.5) / HEIGHTS as f64;
                cross(polygons, level, &mut crossings);
                let mut winding = 0;
                for pair in crossings.windows(2) {
                    winding += pair[0].1;
                    if winding != 0 {
                        let offset = columns.start as f64;
                        cover(&mut part, pair[0].0 - offset, pair[1].0 - offset);
                    }
                }
            }
            let texels = &mut self.covered[y * self.width..][columns.clone()];
            for (texel, part) in texels.iter_mut().zip(&part) {
                *texel = join(*texel, (part / HEIGHTS as f64 * 255.0).round().min(255.0) as u8);
            }
        }
    }
}

/// Where the outlines cross a height, from the left, and which way.
fn cross(polygons: &[Vec<Point>], level: f64, crossings: &mut Vec<(f64, i32)>) {
    crossings.clear();
    for polygon in polygons {
        for (i, &(ax, ay)) in polygon.iter().enumerate() {
            let (bx, by) = polygon[(i + 1) % polygon.len()];
            if (ay <= level) != (by <= level) {
                let x = ax + (level - ay) / (by - ay) * (bx - ax);
                crossings.push((x, if by > ay { 1 } else { -1 }));
            }
        }
    }
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
}

/// Adds how much of each texel lies between two places.
fn cover(covered: &mut [f64], from: f64, to: f64) {
    let (from, to) = (from.max(0.0), to.min(covered.len() as f64));
    let mut x = from;
    while x < to {
        let texel = x as usize;
        let end = to.min(texel as f64 + 1.0);
        covered[texel] += end - x;
        x = end;
    }
}
