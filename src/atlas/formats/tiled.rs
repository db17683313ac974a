//! The map editor Tiled (mapeditor.org): a tile set as `.tsx`, and a map of it as `.tmx`.
//!
//! A tile is numbered by its cell in the picture, row by row. Its colors are a *wangid*: eight
//! numbers clockwise from the top, edges and corners in turns, 0 where nothing is said. Colors
//! count from 1, those of vertical edges go on where those of horizontal edges end. A wangid that
//! Tiled does not understand makes it forget the whole set without a word, so tests compare what
//! it reads.
//!
//! Source: doc.mapeditor.org, TMX map format 1.8.

use super::{Sheet, escape};
use crate::atlas::demo::Demo;
use crate::atlas::{AtlasError, palette};
use crate::tiles::{Kind, TileSet};
use std::io::{self, Write};

/// The version of Tiled's formats that is written.
pub(super) const VERSION: &str = "1.8";

/// Colors of a set at most (Tiled 1.10.2: 255 is no color).
pub const MAX_COLORS: usize = 254;

/// The colors of a set as Tiled has them.
#[derive(Debug)]
pub(super) struct Colored<'a> {
    sheet: &'a Sheet<'a>,
    /// Of horizontal edges, or of corners.
    first: usize,
    /// Of vertical edges.
    second: usize,
}

impl<'a> Colored<'a> {
    pub(super) fn new(sheet: &'a Sheet<'a>) -> Result<Self, AtlasError> {
        let (first, second) = counts(&sheet.packing.set);
        if first + second > MAX_COLORS {
            let message = match second {
                0 => format!("{first} corner colors"),
                _ => format!("{first} colors of horizontal and {second} of vertical edges"),
            };
            let message = format!("{message}: Tiled knows at most {MAX_COLORS} colors of a set");
            return Err(AtlasError::Asked(message));
        }
        Ok(Self { sheet, first, second })
    }

    /// What carries the colors, as Tiled calls it.
    pub(super) fn kind(&self) -> &'static str {
        if self.second == 0 { "corner" } else { "edge" }
    }

    /// Names and looks of the colors.
    pub(super) fn colors(&self) -> impl Iterator<Item = (String, String)> {
        let name = if self.second == 0 { "corner" } else { "north-south" };
        let first = (0..self.first).map(move |c| format!("{name} {c}"));
        let second = (0..self.second).map(|c| format!("east-west {c}"));
        let looks = (0..=u8::MAX).map(palette::hex);
        first.chain(second).zip(looks)
    }

    /// The colors of the tile in a cell.
    pub(super) fn wangid(&self, cell: usize) -> [usize; 8] {
        let [a, b, c, d] = self.sheet.sides(cell).map(|color| usize::from(color) + 1);
        match self.second {
            0 => [0, a, 0, b, 0, c, 0, d],
            _ => [a, 0, self.first + b, 0, c, 0, self.first + d, 0],
        }
    }

    /// The wangid as text.
    pub(super) fn text(&self, cell: usize) -> String {
        self.wangid(cell).map(|color| color.to_string()).join(",")
    }
}

/// How many colors corners or horizontal edges have, and vertical edges.
fn counts(set: &TileSet) -> (usize, usize) {
    match set.kind() {
        Kind::Wang => (set.colors().horizontal(), set.colors().vertical()),
        _ => (set.colors().horizontal(), 0),
    }
}

/// Writes a tile set with its wangset.
///
/// # Errors
/// More colors than Tiled knows; what `out` reports.
pub fn write_tsx(out: &mut dyn Write, sheet: &Sheet<'_>, name: &str) -> Result<(), AtlasError> {
    let colored = Colored::new(sheet)?;
    let (width, height) = sheet.size();
    let (cells, columns) = (sheet.packing.shape.cells(), sheet.packing.shape.width());
    let (name, image, tile) = (escape(name), escape(sheet.image), sheet.tile);
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    write!(out, "<tileset version=\"{VERSION}\" name=\"{name}\" tilewidth=\"{tile}\" ")?;
    write!(out, "tileheight=\"{tile}\" ")?;
    if sheet.spacing > 0 {
        write!(out, "spacing=\"{}\" ", sheet.spacing)?;
    }
    if sheet.margin > 0 {
        write!(out, "margin=\"{}\" ", sheet.margin)?;
    }
    writeln!(out, "tilecount=\"{cells}\" columns=\"{columns}\">")?;
    writeln!(
        out,
        " <transformations hflip=\"0\" vflip=\"0\" rotate=\"0\" preferuntransformed=\"0\"/>"
    )?;
    writeln!(out, " <image source=\"{image}\" width=\"{width}\" height=\"{height}\"/>")?;
    writeln!(out, " <wangsets>")?;
    writeln!(out, "  <wangset name=\"{name}\" type=\"{}\" tile=\"-1\">", colored.kind())?;
    for (name, color) in colored.colors() {
        writeln!(
            out,
            "   <wangcolor name=\"{name}\" color=\"{color}\" tile=\"-1\" probability=\"1\"/>"
        )?;
    }
    for cell in 0..cells {
        writeln!(out, "   <wangtile tileid=\"{cell}\" wangid=\"{}\"/>", colored.text(cell))?;
    }
    out.write_all(b"  </wangset>\n </wangsets>\n</tileset>\n")?;
    Ok(())
}

/// Writes a map of a piece of a tiling, whose tile set is the file `tileset`.
///
/// # Errors
/// What `out` reports.
pub fn write_tmx(
    out: &mut dyn Write,
    sheet: &Sheet<'_>,
    demo: &Demo,
    tileset: &str,
) -> io::Result<()> {
    let (width, height, tile) = (demo.shape.width(), demo.shape.height(), sheet.tile);
    let size = format!("width=\"{width}\" height=\"{height}\"");
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    write!(out, "<map version=\"{VERSION}\" orientation=\"orthogonal\" ")?;
    write!(out, "renderorder=\"right-down\" {size} tilewidth=\"{tile}\" tileheight=\"{tile}\" ")?;
    writeln!(out, "infinite=\"0\" nextlayerid=\"2\" nextobjectid=\"1\">")?;
    writeln!(out, " <tileset firstgid=\"1\" source=\"{}\"/>", escape(tileset))?;
    writeln!(out, " <layer id=\"1\" name=\"tiling\" {size}>")?;
    writeln!(out, "  <data encoding=\"csv\">")?;
    let cells = sheet.cells();
    for (row, tiles) in demo.tiles.chunks(width).enumerate() {
        let numbers = tiles.iter().map(|tile| cells.get(tile).map_or(0, |cell| cell + 1));
        let numbers: Vec<String> = numbers.map(|number| number.to_string()).collect();
        let end = if row + 1 < height { "," } else { "" };
        writeln!(out, "{}{end}", numbers.join(","))?;
    }
    out.write_all(b"</data>\n </layer>\n</map>\n")
}
