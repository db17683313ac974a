//! Pictures for people: what a packing, a set or a tiling looks like.
//!
//! A picture is a [`Scene`], a list of [`Shape`]s in tile sides, from the bottom up. The same scene
//! is written as SVG ([`svg`]) or made of texels ([`raster`]). Numbers are drawn as strokes
//! ([`digits`]): no fonts, so that every program shows the same.
//!
//! * [`marks`] draws a tile: four triangles (Wang) or four quarters of discs (corner tiles);
//! * [`mod@field`] draws fields of tiles;
//! * [`sheets`] puts tiles together: preview, contact sheet, tiling; [`mod@wall`] are bricks and
//!   mortar; [`flow`] draws streams through dappled tilings.

pub mod digits;
pub mod field;
pub mod flow;
pub mod marks;
pub mod path;
pub mod raster;
pub mod sheets;
pub mod svg;
pub mod wall;

pub use marks::look;
pub use path::{Command, Path, Point};

/// How a path is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Paint {
    /// Its inside, by the rule of non-zero winding.
    Fill,
    /// A line so wide along it, with round ends and joins.
    Stroke(f64),
}

/// A path and its look.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Where it is, in tile sides.
    pub path: Path,
    /// How it is drawn.
    pub paint: Paint,
    /// Its color, encoded for the eye.
    pub color: [u8; 3],
    /// Its opacity, in percent.
    pub opacity: u8,
}

/// A picture: shapes, the first at the bottom, on white.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// In tile sides.
    pub width: f64,
    /// In tile sides.
    pub height: f64,
    /// What is to be seen.
    pub shapes: Vec<Shape>,
}

impl Scene {
    /// An empty picture.
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, shapes: Vec::new() }
    }

    /// Puts a path on top of all others, unless it is empty.
    pub fn draw(&mut self, path: Path, paint: Paint, color: [u8; 3]) {
        self.draw_through(path, paint, color, 100);
    }

    /// Puts a path on top through which one can see.
    pub fn draw_through(&mut self, path: Path, paint: Paint, color: [u8; 3], opacity: u8) {
        if !path.is_empty() {
            self.shapes.push(Shape { path, paint, color, opacity });
        }
    }
}
