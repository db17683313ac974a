//! What a tile looks like: its colors where they are.
//!
//! A Wang tile is four triangles, one on each edge; a corner tile has a quarter of a disc in each
//! corner, on a neutral ground, so that four tiles make a disc. Each color also has its number,
//! in black or white, whichever reads better: no one has to tell colors apart by hue alone. The
//! colors of horizontal and vertical edges never meet, so they have hues of their own.
//!
//! Shapes of one look are one path, however many tiles there are.

use super::{Paint, Path, Point, Scene, digits};
use crate::atlas::palette;
use crate::tiles::{Colors, Kind, TileId, TileSet};
use std::collections::BTreeMap;

/// Lines, dark numbers.
pub const INK: [u8; 3] = [38, 38, 38];
/// White numbers, and what is behind dark ones.
pub const PAPER: [u8; 3] = [255, 255, 255];
/// Behind the quarters of corner tiles.
const GROUND: [u8; 3] = [241, 239, 233];

/// Radius of the discs of corner tiles.
const RADIUS: f64 = 0.4;
/// Width of lines around tiles.
const LINE: f64 = 0.016;
/// Width of the strokes that close the seams between triangles: two neighbors that each cover
/// half of a texel do not cover it all.
const SEAM: f64 = 0.02;
/// From the corner of a corner tile to the number of its color, across and down.
const CORNER_GLYPH: f64 = 0.155;
/// From the edge of a Wang tile to the number of its color.
const EDGE_GLYPH: f64 = 0.14;
/// Size of these numbers: height, and width at most.
const GLYPH: Point = (0.15, 0.19);
/// Size of the number of the tile.
const INDEX: Point = (0.17, 0.34);

/// Red, green and blue of a color on a side, as in [`Kind::sides`].
pub fn look(kind: Kind, colors: Colors, side: usize, color: u8) -> [u8; 3] {
    let before = if kind == Kind::Wang && side % 2 == 1 { colors.horizontal() } else { 0 };
    palette::rgb(((before + usize::from(color)) % 256) as u8)
}

/// What is drawn besides the colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Detail {
    /// The numbers of colors.
    pub glyphs: bool,
    /// The numbers of tiles.
    pub indices: bool,
    /// Lines between tiles.
    pub lines: bool,
}

/// Draws tiles of a set.
#[derive(Debug)]
pub struct Marks {
    kind: Kind,
    colors: Colors,
    detail: Detail,
    ground: Path,
    fills: BTreeMap<[u8; 3], Path>,
    lines: Path,
    dark: Path,
    light: Path,
    badges: Path,
    indices: Path,
    /// Heights of numbers: all alike, so that the longest has room.
    glyph: f64,
    index: f64,
}

impl Marks {
    /// Nothing yet.
    pub fn new(set: &TileSet, detail: Detail) -> Self {
        let path = Path::default;
        let largest = set.kind().tiles(set.colors()) - 1;
        Self {
            kind: set.kind(),
            colors: set.colors(),
            detail,
            ground: path(),
            fills: BTreeMap::new(),
            lines: path(),
            dark: path(),
            light: path(),
            badges: path(),
            indices: path(),
            glyph: digits::height(set.colors().largest() as u32 - 1, GLYPH.0, GLYPH.1),
            index: digits::height(largest as u32, INDEX.0, INDEX.1),
        }
    }

    /// Draws a tile whose north-west corner is here.
    pub fn tile(&mut self, tile: TileId, at: Point) {
        let sides = self.kind.unpack(tile, self.colors);
        if self.kind == Kind::Wang {
            self.wang(sides, at)
        } else {
            self.corner(sides, at)
        }
        let (x, y) = at;
        if self.detail.lines {
            self.lines.rectangle(x, y, 1.0, 1.0);
        }
        if self.detail.indices {
            let center = (x + 0.5, y + 0.5);
            let width = digits::add(&mut self.indices, tile.0, center, self.index);
            if self.kind == Kind::Wang {
                let high = self.index + 0.13;
                self.badges.pill(center, (width + 0.16).max(high), high);
            }
        }
    }

    /// North, east, south, west.
    fn wang(&mut self, sides: [u8; 4], (x, y): Point) {
        let corners = [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)];
        let center = (x + 0.5, y + 0.5);
        let far = 1.0 - EDGE_GLYPH;
        let glyphs = [(0.5, EDGE_GLYPH), (far, 0.5), (0.5, far), (EDGE_GLYPH, 0.5)];
        for (side, color) in sides.into_iter().enumerate() {
            let look = look(self.kind, self.colors, side, color);
            let fill = self.fills.entry(look).or_default();
            fill.polygon(&[corners[side], corners[(side + 1) % 4], center]);
            let (dx, dy) = glyphs[side];
            self.glyph(color, look, (x + dx, y + dy));
            if self.detail.lines {
                self.lines.move_to(corners[side]);
                self.lines.line_to(center);
            }
        }
    }

    /// North-east, south-east, south-west, north-west.
    fn corner(&mut self, sides: [u8; 4], (x, y): Point) {
        self.ground.rectangle(x, y, 1.0, 1.0);
        let corners = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        for ((side, color), (dx, dy)) in sides.into_iter().enumerate().zip(corners) {
            let look = look(self.kind, self.colors, side, color);
            let inward = |d: f64| 1.0 - 2.0 * d;
            let corner = (x + dx, y + dy);
            let fill = self.fills.entry(look).or_default();
            fill.quarter(corner, RADIUS, inward(dx), inward(dy));
            let at = |from: f64, d: f64| from + inward(d) * CORNER_GLYPH;
            self.glyph(color, look, (at(corner.0, dx), at(corner.1, dy)));
        }
    }

    fn glyph(&mut self, color: u8, look: [u8; 3], at: Point) {
        if self.detail.glyphs {
            // Rec. 601, in whole numbers.
            let [r, g, b] = look.map(u32::from);
            let bright = 299 * r + 587 * g + 114 * b > 128_000;
            let path = if bright { &mut self.dark } else { &mut self.light };
            digits::add(path, color.into(), at, self.glyph);
        }
    }

    /// Puts all tiles into a picture.
    pub fn put(self, scene: &mut Scene) {
        scene.draw(self.ground, Paint::Fill, GROUND);
        for (look, path) in self.fills {
            if self.kind == Kind::Wang && !self.detail.lines {
                scene.draw(path.clone(), Paint::Stroke(SEAM), look);
            }
            scene.draw(path, Paint::Fill, look);
        }
        scene.draw(self.lines, Paint::Stroke(LINE), INK);
        let stroke = Paint::Stroke(digits::STROKE * self.glyph);
        scene.draw(self.dark, stroke, INK);
        scene.draw(self.light, stroke, PAPER);
        scene.draw(self.badges, Paint::Fill, PAPER);
        scene.draw(self.indices, Paint::Stroke(digits::STROKE * self.index), INK);
    }
}
