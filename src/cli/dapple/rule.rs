//! Raw arguments to a rule and to fields: `--tiles`, `--limits`, `--cyclic`, and the files that
//! they name.

use crate::atlas::levels::image_field;
use crate::atlas::open_png;
use crate::cli::args::RuleArgs;
use crate::cli::source;
use crate::dappled::notation;
use crate::dappled::{Edges, Field, Rule};
use anyhow::{Context, anyhow};
use std::path::Path;

/// What a tiling of this size, columns first, keeps.
///
/// # Errors
/// Limits that make no sense, or maps that cannot be read.
pub(super) fn rule(args: &RuleArgs, size: (usize, usize)) -> anyhow::Result<Rule> {
    let tiles = usize::from(args.tiles);
    let limits = args.limits.iter().map(|text| notation::limit(text));
    let limits =
        limits.collect::<Result<Vec<_>, _>>().map_err(|error| anyhow!("--limits {error}"))?;
    let map = |file: &str| -> anyhow::Result<Vec<u32>> {
        let input = source::open(Path::new(file))?;
        notation::map(input.text(), size).map_err(|error| anyhow!("{file}:{error}"))
    };
    let conditions = notation::conditions(&limits, tiles, map)?;
    let edges = match (args.cyclic, args.cylinder) {
        (true, _) => Edges::Torus,
        (_, true) => Edges::Cylinder,
        _ => Edges::Free,
    };
    Rule::new(size, tiles, edges, conditions).context("--limits")
}

/// A field from a text file, a PNG with a texel for each cell, or standard input.
///
/// # Errors
/// A file that cannot be read, or holds tiles that there are not.
pub(super) fn field(file: &Path, tiles: u8) -> anyhow::Result<Field> {
    let tiles = usize::from(tiles);
    if file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png")) {
        let named = |error| anyhow!("{}: {error}", file.display());
        return image_field(&open_png(file)?, tiles, 1).map_err(named);
    }
    let input = source::open(file)?;
    notation::field(input.text(), tiles)
        .map_err(|error| anyhow!("{}:{error}", input.file().display()))
}
