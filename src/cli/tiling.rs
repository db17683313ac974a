//! Raw arguments to an endless tiling: `--coloring`, and the files that it names.

use super::args::ColoringArg;
use super::source;
use crate::atlas::{Channels, read_png};
use crate::store::{Claim, Input, ProbabilityGrid, read_probabilities, read_solution};
use crate::tiles::{Colors, Kind};
use crate::tiling::{
    ColorMap, Coloring, Compact, Diagonal, Halton, Permuted, Probabilities, Sums, Tiling,
};
use crate::torus::{Packing, Shape, Topology};
use crate::verify;
use anyhow::{Context, anyhow, bail};
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
    if seed != 0 && !coloring.is_random() {
        bail!("a seed goes with random colorings only, not with --coloring {coloring}");
    }
    let named = || format!("--coloring {coloring}");
    if let ColoringArg::Map(file) = coloring {
        let claim = Claim { kind, colors, ..Claim::default() };
        let map = read_solution(&source::open(file)?, &claim)?.packing;
        on_torus(&map).with_context(named)?;
        let map = ColorMap::of(&map).with_context(named)?;
        return Ok(Tiling::new(map.kind(), map.colors(), Coloring::Map(map))?);
    }
    if let ColoringArg::Probabilities(scale, file) = coloring {
        let map = probabilities(scale.as_deref(), file, seed)?;
        let own = Colors::one(map.colors() as u64)?;
        let tiling = Tiling::new(
            kind.unwrap_or(Kind::Corner),
            colors.unwrap_or(own),
            Coloring::Probabilities(map),
        );
        return tiling.with_context(|| format!("{} has {own} colors", file.display()));
    }
    let missing = |option| format!("{option} is missing (a packing or a map can stand in)");
    let kind = kind.with_context(|| missing("--kind corner|wang"))?;
    let colors = colors.with_context(|| missing("--colors C"))?;
    let corner = |what: &str| match (kind, colors.single()) {
        (Kind::Corner, Some(count)) => Ok(count),
        _ => {
            bail!("--coloring {what}: expected corner tiles, not {kind} tiles over {colors} colors")
        }
    };
    let coloring = match coloring {
        ColoringArg::Halton(size) => {
            let tiles: Shape = size.parse().with_context(named)?;
            Coloring::Halton(Halton::of_tiles(kind, tiles)?)
        }
        ColoringArg::Compact if kind == Kind::Wang => Coloring::Sums(Sums::one_hash(colors, seed)?),
        ColoringArg::Compact => Coloring::Compact(Compact::of(corner("compact")?, seed)?),
        ColoringArg::Diagonal => {
            let diagonal = Diagonal::new(corner("diagonal")?, seed)?;
            Coloring::Compact(Compact::Diagonal(diagonal))
        }
        ColoringArg::TwoHash => Coloring::Sums(Sums::two_hashes(seed)),
        ColoringArg::Table => Coloring::Permuted(Permuted::short(seed)),
        ColoringArg::LongPeriod => Coloring::Permuted(Permuted::long(seed)),
        ColoringArg::Scanline => bail!(
            "--coloring scanline: tiles are laid one after the other, so only tile --size knows it"
        ),
        _ => Coloring::Hash { seed },
    };
    Tiling::new(kind, colors, coloring).with_context(named)
}

/// A map of probabilities: a picture, or text.
///
/// # Errors
/// A file that is neither, or whose probabilities make no sense.
fn probabilities(scale: Option<&str>, file: &Path, seed: u32) -> anyhow::Result<Probabilities> {
    let scale = match scale {
        None => [1, 1],
        Some(text) => {
            let shape: Shape =
                text.parse().with_context(|| format!("--coloring probabilities:{text}:..."))?;
            [shape.width() as u32, shape.height() as u32]
        }
    };
    let bytes = std::fs::read(file).with_context(|| file.display().to_string())?;
    let grid = match bytes.starts_with(b"\x89PNG") {
        true => picture(&bytes).map_err(|error| anyhow!("{}: {error}", file.display()))?,
        false => read_probabilities(&Input::from_bytes(file, bytes)?)?,
    };
    let map = Probabilities::new(grid.shape, scale, grid.colors, &grid.weights, seed);
    map.with_context(|| file.display().to_string())
}

/// The largest picture, in bytes.
const LARGEST: u64 = 1 << 26;

/// The probabilities of a picture: of gray ones black is color 0 and white is color 1; of others red,
/// green and blue are the weights of colors 0, 1, 2.
fn picture(bytes: &[u8]) -> Result<ProbabilityGrid, String> {
    let image = read_png(std::io::Cursor::new(bytes), LARGEST)?;
    let (channels, max) = (image.format().channels, f64::from(image.format().max()));
    if channels.has_alpha() {
        return Err(
            "opacity has no meaning here: expected a gray or a red, green and blue picture"
                .to_owned(),
        );
    }
    let colors = if channels == Channels::Gray { 2 } else { 3 };
    let mut weights = Vec::with_capacity(image.width() * image.height() * colors);
    for y in 0..image.height() {
        for x in 0..image.width() {
            if channels == Channels::Gray {
                let white = f64::from(image.sample(x, y, 0)) / max;
                weights.extend([1.0 - white, white]);
                continue;
            }
            let shares = [0, 1, 2].map(|channel| f64::from(image.sample(x, y, channel)));
            let sum: f64 = shares.iter().sum();
            if sum == 0.0 {
                return Err(format!("row {y}, column {x} is black: no color has a weight there"));
            }
            weights.extend(shares.map(|share| share / sum));
        }
    }
    let shape = Shape::new(image.width() as u64, image.height() as u64);
    Ok(ProbabilityGrid { shape: shape.map_err(|error| error.to_string())?, colors, weights })
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
