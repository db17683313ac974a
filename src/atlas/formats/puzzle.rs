//! A packing as a jigsaw puzzle, to be cut by a laser (Lagae 2007, section 5.5.4).
//!
//! Colors become knobs. The knob of an edge stands where its color says: on a Wang tile one on
//! each edge, on a corner tile two, one toward each end, for the color of the corner there. So
//! pieces fit where their colors agree. All knobs point to the south and to the east, round ones
//! and dovetails: a piece that is turned has a knob where it needs a notch, and one that is turned
//! over has them of the wrong shape.
//!
//! Each line is cut once, for both pieces; they have the play of one cut. The lines around the
//! sheet have their knobs, too, those of opposite sides alike, so that copies of the sheet
//! continue it.
//!
//! Lengths within an edge are in sides of a piece; `Knob` says why knobs stay apart.

use crate::atlas::AtlasError;
use crate::atlas::picture::path::QUARTER;
use crate::atlas::picture::{Path, Point, digits, svg};
use crate::tiles::Kind;
use crate::torus::Packing;
use std::io::{self, Write};

/// Millimeters by which the knobs of two colors are apart at least.
pub const LEAST_STEP: f64 = 2.0;

/// Pieces at most.
pub const MAX_PIECES: usize = 1 << 14;

/// Millimeters of a side, at least: smaller pieces break.
pub const LEAST_SIDE: f64 = 10.0;

/// White around the sheet, in millimeters.
const MARGIN: f64 = 3.0;

/// A control point of an arc whose cosine is 0.6, in radii from its end: 4/3 tan of a quarter of
/// its angle.
const ARC: f64 = 0.314_757;

/// Knobs of a kind of tile.
///
/// A knob reaches `radius` to both sides and at most 1.8 radii into the neighbor. Within a piece
/// the notches of its north and west side come near each other in the north-west corner only, and
/// there `first - radius` is more than 1.8 radii. At the other end `first + range + radius` is less
/// than 1; `second` does not reach the first of the two.
#[derive(Debug, Clone, Copy)]
struct Knob {
    radius: f64,
    /// Where the knob of color 0 stands.
    first: f64,
    /// How far from there that of the last color stands.
    range: f64,
    /// Where the second knob of an edge stands for color 0.
    second: Option<f64>,
}

/// One knob an edge.
const WANG: Knob = Knob { radius: 0.085, first: 0.27, range: 0.56, second: None };
/// Two knobs an edge.
const CORNER: Knob = Knob { radius: 0.045, first: 0.16, range: 0.27, second: Some(0.57) };

impl Knob {
    fn of(kind: Kind) -> Self {
        if kind == Kind::Wang { WANG } else { CORNER }
    }
}

/// How many colors an edge or corner of pieces of this side, in millimeters, can have.
pub fn most_colors(kind: Kind, side: f64) -> usize {
    (Knob::of(kind).range * side / LEAST_STEP + 1e-9) as usize + 1
}

/// Which way a line runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Axis {
    /// West to east, knobs to the south, round.
    Row,
    /// North to south, knobs to the east, dovetails.
    Column,
}

/// The lines along which a packing is cut.
#[derive(Debug, Clone, Copy)]
pub struct Puzzle<'a> {
    packing: &'a Packing,
    /// In millimeters.
    side: f64,
    knob: Knob,
}

impl<'a> Puzzle<'a> {
    /// Pieces of this side, in millimeters, of a packing of corner or Wang tiles on a torus.
    ///
    /// # Errors
    /// Pieces that are too small or too many, or have too many colors for their size.
    pub fn new(packing: &'a Packing, side: f64) -> Result<Self, AtlasError> {
        let (kind, colors) = (packing.set.kind(), packing.set.colors().largest());
        let knob = Knob::of(kind);
        let most = most_colors(kind, side);
        let problem = if side < LEAST_SIDE {
            Some(format!("pieces of {side} mm: expected {LEAST_SIDE} mm or more"))
        } else if packing.tiles.len() > MAX_PIECES {
            Some(format!("{} pieces: expected {MAX_PIECES} or fewer", packing.tiles.len()))
        } else if colors > most {
            let least = ((colors - 1) as f64 * LEAST_STEP / knob.range).ceil();
            Some(format!(
                "{colors} colors: knobs on pieces of {side} mm tell {most} apart ({LEAST_STEP} mm \
                 each); this many need {least} mm"
            ))
        } else {
            None
        };
        match problem {
            Some(message) => Err(AtlasError::Asked(message)),
            None => Ok(Self { packing, side, knob }),
        }
    }

    /// The outline of a piece, in millimeters from the north-west of the sheet, clockwise from
    /// its north-west corner; curves as short straight lines.
    pub fn piece(&self, row: usize, column: usize) -> Vec<Point> {
        let mut points = self.line(Axis::Row, row, column);
        points.extend(self.line(Axis::Column, row, column + 1));
        points.extend(self.line(Axis::Row, row + 1, column).into_iter().rev());
        points.extend(self.line(Axis::Column, row, column).into_iter().rev());
        points.dedup();
        points
    }

    /// The line north (row) or west (column) of a cell, as points.
    fn line(&self, axis: Axis, row: usize, column: usize) -> Vec<Point> {
        let mut path = Path::default();
        path.move_to(self.at(axis, row, column, 0.0, 0.0));
        self.cut(&mut path, axis, row, column);
        path.flattened(1.0).into_iter().flat_map(|(points, _)| points).collect()
    }

    /// The point so far along the line, and so far across it toward south or east.
    fn at(&self, axis: Axis, row: usize, column: usize, along: f64, across: f64) -> Point {
        let (x, y) = match axis {
            Axis::Row => (along, across),
            Axis::Column => (across, along),
        };
        ((column as f64 + x) * self.side, (row as f64 + y) * self.side)
    }

    /// Where the knobs of a line are, in its order.
    fn knobs(&self, axis: Axis, row: usize, column: usize) -> Vec<f64> {
        let Packing { set, shape, tiles, .. } = self.packing;
        let tile = tiles[row % shape.height() * shape.width() + column % shape.width()];
        let colors = set.colors();
        let sides = set.kind().unpack(tile, colors);
        let count = if axis == Axis::Row { colors.horizontal() } else { colors.vertical() };
        let step = self.knob.range / (count.max(2) - 1) as f64;
        let place = |from: f64, color: u8| from + step * f64::from(color);
        match (self.knob.second, axis) {
            (None, Axis::Row) => vec![place(self.knob.first, sides[0])],
            (None, Axis::Column) => vec![place(self.knob.first, sides[3])],
            // From north-west to north-east, or to south-west.
            (Some(second), _) => {
                let end = if axis == Axis::Row { sides[0] } else { sides[2] };
                vec![place(self.knob.first, sides[3]), place(second, end)]
            }
        }
    }

    /// Goes along a line from its beginning, where the path is, to its end.
    fn cut(&self, path: &mut Path, axis: Axis, row: usize, column: usize) {
        let r = self.knob.radius;
        for place in self.knobs(axis, row, column) {
            let at =
                |along: f64, across: f64| self.at(axis, row, column, place + r * along, r * across);
            path.line_to(at(-0.6, 0.0));
            if axis == Axis::Row {
                // A disc around (0, 0.8) whose part above the line is missing. On an arc from
                // (-0.6, 0) to (-1, 0.8) the tangents are (-0.8, 0.6) and (0, 1).
                let (near, far) = (0.6 + 0.8 * ARC, 0.8 - ARC);
                path.cubic_to(at(-near, 0.6 * ARC), at(-1.0, far), at(-1.0, 0.8));
                let q = QUARTER;
                path.cubic_to(at(-1.0, 0.8 + q), at(-q, 1.8), at(0.0, 1.8));
                path.cubic_to(at(q, 1.8), at(1.0, 0.8 + q), at(1.0, 0.8));
                path.cubic_to(at(1.0, far), at(near, 0.6 * ARC), at(0.6, 0.0));
            } else {
                path.line_to(at(-1.0, 1.5));
                path.line_to(at(1.0, 1.5));
                path.line_to(at(0.6, 0.0));
            }
        }
        path.line_to(self.at(axis, row, column, 1.0, 0.0));
    }

    /// Writes the sheet: in red what is cut, in blue the number of each tile, to be engraved.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn write_svg(&self, out: &mut dyn Write, title: &str) -> io::Result<()> {
        let (w, h) = (self.packing.shape.width(), self.packing.shape.height());
        let reach = 1.8 * self.knob.radius * self.side;
        let length = |cells: usize| svg::number(cells as f64 * self.side + reach + 2.0 * MARGIN);
        let (wide, high) = (length(w), length(h));
        write!(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}mm\" ")?;
        write!(out, "height=\"{high}mm\" viewBox=\"{0} {0} ", svg::number(-MARGIN))?;
        writeln!(out, "{wide} {high}\" fill=\"none\" stroke-width=\".1\">")?;
        writeln!(out, "<title>{}</title>", super::escape(title))?;

        let mut numbers = Path::default();
        let largest = self.packing.tiles.iter().map(|tile| tile.0).max().unwrap_or(0);
        let height = digits::height(largest, 0.15 * self.side, 0.4 * self.side);
        for (cell, tile) in self.packing.tiles.iter().enumerate() {
            let middle = |line: usize| (line as f64 + 0.5) * self.side;
            let center = (middle(cell % w), middle(cell / w));
            digits::add(&mut numbers, tile.0, center, height);
        }
        writeln!(out, "<g id=\"engrave\" stroke=\"#00f\" stroke-linecap=\"round\">")?;
        writeln!(out, "<path d=\"{}\"/>\n</g>", svg::data(&numbers, 1.0))?;

        writeln!(out, "<g id=\"cut\" stroke=\"#f00\">")?;
        for row in 0..=h {
            let mut path = Path::default();
            path.move_to(self.at(Axis::Row, row, 0, 0.0, 0.0));
            (0..w).for_each(|column| self.cut(&mut path, Axis::Row, row, column));
            writeln!(out, "<path d=\"{}\"/>", svg::data(&path, 1.0))?;
        }
        for column in 0..=w {
            let mut path = Path::default();
            path.move_to(self.at(Axis::Column, 0, column, 0.0, 0.0));
            (0..h).for_each(|row| self.cut(&mut path, Axis::Column, row, column));
            writeln!(out, "<path d=\"{}\"/>", svg::data(&path, 1.0))?;
        }
        out.write_all(b"</g>\n</svg>\n")
    }
}
