//! Raw arguments to a wall: of given labels, of labels without long joints, of a region.

use crate::atlas::levels::image_field;
use crate::atlas::open_png;
use crate::cli::args::BrickArgs;
use crate::cli::source;
use crate::dappled::brick::{Wall, boundary, labels, region};
use crate::dappled::make::{Made, Options, Order, make, start};
use crate::dappled::notation::{self, Bound};
use crate::dappled::{Edges, FREE, Field, MOST_CELLS};
use crate::search::Stop;
use crate::torus::Shape;
use anyhow::{Context, anyhow, bail, ensure};
use std::path::Path;

/// Labels that are tried for a wall: with few positions or short lines the first may not do.
const LABELS: u64 = 200;

/// What became of a wall.
pub(super) enum Built {
    /// It, and how it was built.
    Wall(Wall, &'static str),
    /// There is none.
    None(String),
    /// Not known.
    Stopped(String),
}

/// Builds the wall that the options ask for.
///
/// # Errors
/// Bad input.
pub(super) fn build(args: &BrickArgs, stop: &dyn Stop) -> anyhow::Result<Built> {
    if let Some(file) = &args.region {
        let input = source::open(file)?;
        let (size, inside) = boundary::region(input.text())
            .map_err(|error| anyhow!("{}:{error}", file.display()))?;
        return filled(with_boundary(args, Wall::new(size, args.positions, inside))?, args.seed);
    }
    if let Some(file) = &args.labels {
        let labels = labels_of(args, file)?;
        let partial = partial(args, (labels.width(), labels.height()))?;
        return Ok(match labels::wall(&partial, &labels, args.cyclic, args.seed) {
            Ok(wall) => Built::Wall(wall, "walks of given labels"),
            Err(blocked) => Built::None(format!("no wall has these labels: {blocked}")),
        });
    }
    let size = size(args)?;
    let limits = limits(args.limits.as_deref().unwrap_or("2,2"))?;
    let partial = partial(args, size)?;
    if limits == (None, None) && !args.cyclic {
        return filled(partial, args.seed);
    }
    let edges = if args.cyclic { Edges::Torus } else { Edges::Free };
    let rule = labels::rule(size, edges, limits)?;
    let mut blocked = None;
    for number in 0..LABELS {
        let seed = args.seed.wrapping_add(number << 32);
        let mut field = Field::filled(size.0, size.1, FREE)?;
        start::fill_randomly(&mut field, 2, seed);
        let field = match make(&rule, field, Options { order: Order::Diagonal, seed }, stop)? {
            Made::Tiling(field, _) => field,
            Made::Impossible => return Ok(Built::None("no labels keep these limits".into())),
            Made::Stopped => return Ok(Built::Stopped("stopped by a signal".into())),
        };
        match labels::wall(&partial, &field, args.cyclic, seed) {
            Ok(wall) => return Ok(Built::Wall(wall, "walks of dappled labels")),
            Err(line) => blocked = Some(line),
        }
        if stop.should_stop() {
            return Ok(Built::Stopped("stopped by a signal".into()));
        }
    }
    let last = blocked.map(|line| line.to_string()).unwrap_or_default();
    Ok(Built::Stopped(format!("{LABELS} dappled fields of labels have no wall; the last: {last}")))
}

/// A wall without limits, by the linear algorithm.
fn filled(partial: Wall, seed: u64) -> anyhow::Result<Built> {
    Ok(match region::fill(&partial, seed) {
        Ok(wall) => Built::Wall(wall, "the linear algorithm"),
        Err(unfillable) => Built::None(unfillable.to_string()),
    })
}

/// The size asked for.
///
/// # Errors
/// None, or one that makes no sense.
pub(super) fn size(args: &BrickArgs) -> anyhow::Result<(usize, usize)> {
    let size = args.size.as_deref().context("which size? Expected --size WxH")?;
    let size = size.parse::<Shape>()?;
    ensure!(size.cells() <= MOST_CELLS / 4, "--size: expected at most {} tiles", MOST_CELLS / 4);
    Ok((size.width(), size.height()))
}

/// The labels in a file.
///
/// # Errors
/// A file that cannot be read, cells without a label, another size.
pub(super) fn labels_of(args: &BrickArgs, file: &Path) -> anyhow::Result<Field> {
    let name = file.display();
    let field = if file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png")) {
        image_field(&open_png(file)?, 2, 1).map_err(|error| anyhow!("{name}: {error}"))?
    } else {
        let input = source::open(file)?;
        notation::field(input.text(), 2).map_err(|error| anyhow!("{name}:{error}"))?
    };
    let (width, height) = (field.width(), field.height());
    if let Some(cell) = field.cells().iter().position(|&tile| tile == FREE) {
        let (row, column) = (cell / width, cell % width);
        bail!("{name}: row {row}, column {column}: no label, expected 0 or 1");
    }
    if args.size.is_some() && size(args)? != (width, height) {
        bail!("{name}: {width}x{height} labels, but --size {}", args.size.as_deref().unwrap_or(""));
    }
    Ok(field)
}

/// A rectangle with the boundary that is given.
///
/// # Errors
/// A boundary that cannot be read.
pub(super) fn partial(args: &BrickArgs, size: (usize, usize)) -> anyhow::Result<Wall> {
    with_boundary(args, Wall::rectangle(size, args.positions))
}

fn with_boundary(args: &BrickArgs, mut wall: Wall) -> anyhow::Result<Wall> {
    if let Some(file) = &args.boundary {
        let input = source::open(file)?;
        boundary::read(input.text(), &mut wall)
            .map_err(|error| anyhow!("{}:{error}", file.display()))?;
    }
    Ok(wall)
}

/// Reads `P,Q`.
fn limits(text: &str) -> anyhow::Result<(Option<u32>, Option<u32>)> {
    let expected = || anyhow!("--limits '{text}': expected P,Q, numbers from 1 or inf");
    let read = notation::limit(text).map_err(|_| expected())?;
    let bound = |bound: Bound| match bound {
        Bound::None => Ok(None),
        Bound::Same(limit) => Ok(Some(limit)),
        Bound::File(_) => Err(expected()),
    };
    ensure!(read.tiles.is_empty(), expected());
    Ok((bound(read.horizontal)?, bound(read.vertical)?))
}
