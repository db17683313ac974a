//! Raw arguments to an endless tiling: `--coloring`, and the files that it names.

use super::args::ColoringArg;
use super::source;
use crate::store::{Claim, read_solution};
use crate::tiles::{Colors, Kind};
use crate::tiling::{ColorMap, Coloring, Halton, Tiling};
use crate::torus::{Packing, Shape, Topology};
use crate::verify;
use anyhow::{Context, bail};
use std::path::Path;

/// The coloring that the options describe; a map must be about this kind and these colors, where
/// they are known.
///
/// # Errors
/// A size or a file that makes no sense, and a seed that nothing is done with.
pub fn tiling(
    coloring: &ColoringArg,
    seed: u32,
    kind: Option<Kind>,
    colors: Option<Colors>,
) -> anyhow::Result<Tiling> {
    if seed != 0 && *coloring != ColoringArg::Hash {
        bail!("a seed goes with --coloring hash only");
    }
    if let ColoringArg::Map(file) = coloring {
        let named = || format!("--coloring map:{}", file.display());
        let claim = Claim { kind, colors, ..Claim::default() };
        let map = read_solution(&source::open(file)?, &claim)?.packing;
        on_torus(&map).with_context(named)?;
        let map = ColorMap::of(&map).with_context(named)?;
        return Ok(Tiling::new(map.kind(), map.colors(), Coloring::Map(map))?);
    }
    let missing = |option| format!("{option} is missing (a packing or a map can stand in)");
    let kind = kind.with_context(|| missing("--kind corner|wang"))?;
    let colors = colors.with_context(|| missing("--colors C"))?;
    let coloring = match coloring {
        ColoringArg::Halton(size) => {
            let tiles: Shape = size.parse().with_context(|| format!("--coloring halton:{size}"))?;
            Coloring::Halton(Halton::of_tiles(kind, tiles)?)
        }
        _ => Coloring::Hash { seed },
    };
    Ok(Tiling::new(kind, colors, coloring)?)
}

/// A packing from a file, checked from the definition.
///
/// # Errors
/// A file that cannot be read, is no packing, or is not about fixed tiles on a torus.
pub fn packing(file: &Path, claim: &Claim) -> anyhow::Result<Packing> {
    let packing = read_solution(&source::open(file)?, claim)?.packing;
    on_torus(&packing).with_context(|| file.display().to_string())?;
    let verdict = verify::check(&packing);
    if !verdict.is_valid() {
        bail!("{}: not a packing: {verdict}", file.display());
    }
    Ok(packing)
}

/// Refuses what lies on a board, or is turned.
///
/// # Errors
/// For such packings.
pub fn on_torus(packing: &Packing) -> anyhow::Result<()> {
    if packing.board.topology != Topology::Torus || packing.board.rotations {
        bail!("expected fixed tiles on a torus, but this lies on a board");
    }
    Ok(())
}
