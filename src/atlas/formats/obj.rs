//! Wavefront OBJ and MTL: a grid of squares that shows a piece of a tiling, each square with the
//! texture coordinates of its tile in the atlas. It opens in every program for 3-D models.
//!
//! The grid lies in the plane z = 0 and is seen from above z; a tile is a square of side 1, north
//! is up. Texture coordinates have their origin in the lower left of the picture.

use super::Sheet;
use crate::atlas::demo::Demo;
use std::io::{self, Write};

/// A part of a length as a decimal number without needless digits.
fn ratio(part: u64, whole: u64) -> String {
    let text = format!("{:.9}", part as f64 / whole as f64);
    match text.trim_end_matches('0').trim_end_matches('.') {
        "" => "0".to_owned(),
        short => short.to_owned(),
    }
}

/// Writes the grid; its material is in the file `material`.
///
/// # Errors
/// What `out` reports.
pub fn write_obj(
    out: &mut dyn Write,
    sheet: &Sheet<'_>,
    demo: &Demo,
    material: &str,
) -> io::Result<()> {
    let (w, h) = (demo.shape.width(), demo.shape.height());
    let (width, height) = sheet.size();
    writeln!(out, "# tilepack {}: a tiling of {w} x {h} tiles", env!("CARGO_PKG_VERSION"))?;
    writeln!(out, "mtllib {material}\no tiling")?;
    for y in 0..=h {
        for x in 0..=w {
            writeln!(out, "v {x} {} 0", h - y)?;
        }
    }
    // Four for every cell of the atlas: south-west, south-east, north-east, north-west.
    for cell in 0..sheet.packing.shape.cells() {
        let (left, top) = sheet.corner(cell);
        let [left, right] = [left, left + sheet.tile].map(|x| ratio(x, width));
        let [top, bottom] = [top, top + sheet.tile].map(|y| ratio(height - y, height));
        writeln!(
            out,
            "vt {left} {bottom}\nvt {right} {bottom}\nvt {right} {top}\nvt {left} {top}"
        )?;
    }
    writeln!(out, "vn 0 0 1\nusemtl atlas\ns off")?;
    let cells = sheet.cells();
    for (place, tile) in demo.tiles.iter().enumerate() {
        let north = place / w * (w + 1) + place % w + 1;
        let south = north + w + 1;
        let coordinates = 4 * cells.get(tile).copied().unwrap_or(0) + 1;
        write!(out, "f")?;
        for (i, vertex) in [south, south + 1, north + 1, north].into_iter().enumerate() {
            write!(out, " {vertex}/{}/1", coordinates + i)?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Writes the material: the atlas, lit evenly.
///
/// # Errors
/// What `out` reports.
pub fn write_mtl(out: &mut dyn Write, image: &str) -> io::Result<()> {
    writeln!(out, "newmtl atlas\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nd 1\nillum 1\nmap_Kd {image}")
}
