//! Tilings to standard output as text, or to a file, of which the name says whether it is a PNG.

use crate::atlas::levels::field_image;
use crate::atlas::write_png;
use crate::cli::output;
use crate::dappled::Field;
use crate::dappled::notation::write_field;
use crate::store::write_file;
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;

/// Writes a tiling to a file (`.png`: a texel for each cell), or to standard output. `about` is how
/// it was made; it goes into the file.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn write(
    field: &Field,
    tiles: u8,
    output: Option<&Path>,
    about: &str,
) -> anyhow::Result<()> {
    let tiles = usize::from(tiles);
    let Some(file) = output else {
        return output::result(|out| out.write_all(write_field(field, tiles).as_bytes()));
    };
    let png = file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
    write_file(file, |out| match png {
        true => write_png(out, &field_image(field, tiles, 1), &[("Description", about)]),
        false => write!(out, "# {about}\n{}", write_field(field, tiles)),
    })?;
    Ok(())
}

/// The rows of a tiling as JSON: arrays of tiles, `null` for a free cell.
pub(super) fn rows_json(field: &Field) -> Value {
    let cell = |&tile: &u8| match tile {
        crate::dappled::FREE => Value::Null,
        tile => json!(tile),
    };
    field.rows().map(|row| row.iter().map(cell).collect::<Value>()).collect()
}
