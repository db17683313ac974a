//! What the shaders of different colorings differ in: templates, constants, limits, words.

use super::AtlasError;
use crate::tiles::Kind;
use crate::tiling::{Coloring, Compact, Halton, Tiling, hash};

/// Texels in a row or column of a texture at most.
const LARGEST: usize = 16384;

/// Whether a shader can do it.
pub(super) fn check(tiling: &Tiling) -> Result<(), AtlasError> {
    match tiling.coloring() {
        Coloring::Halton(halton) => fits(halton)?,
        Coloring::Map(map) if map.shape().width().max(map.shape().height()) > LARGEST => {
            return Err(AtlasError::Asked(format!(
                "a color map of {} cells: expected at most {LARGEST} in a row or column of a texture",
                map.shape()
            )));
        }
        Coloring::Probabilities(map) => {
            let (shape, colors, [x, y]) = (map.shape(), map.colors(), map.scale());
            if (shape.width() * colors).max(shape.height()) > LARGEST {
                return Err(AtlasError::Asked(format!(
                    "a map of probabilities of {shape} cells: expected at most {LARGEST} texels in \
                     a row or column of a texture, here {} and {}",
                    shape.width() * colors,
                    shape.height()
                )));
            }
            let points = |cells: usize, scale: u32| cells as u64 * u64::from(scale);
            let most = points(shape.width(), x).max(points(shape.height(), y));
            if most > 1 << 30 {
                return Err(AtlasError::Asked(format!(
                    "a map of probabilities of {most} points in a row or column: a shader counts \
                     to 2^30"
                )));
            }
        }
        Coloring::Compact(Compact::Frames(frames)) => {
            return Err(AtlasError::Asked(format!(
                "the compact set over {} colors is tiled by blocks of {1}x{1} tiles, too much work \
                 for a shader at every pixel: take --coloring diagonal, or map:FILE with a packing",
                frames.colors(),
                frames.side()
            )));
        }
        _ => {}
    }
    Ok(())
}

/// A shader has 32 bits.
fn fits(halton: &Halton) -> Result<(), AtlasError> {
    let (points, rows) = (halton.points(), halton.p2);
    if points > 1 << 30 || rows > u64::from(u16::MAX) {
        return Err(AtlasError::Asked(format!(
            "halton: {} x {rows} points: a shader counts to 2^30 points and 65535 rows; expected a \
             smaller grid, which repeats",
            halton.p1
        )));
    }
    Ok(())
}

/// Numbers of a texel of the map, if there is one.
pub(super) fn map_channels(tiling: &Tiling) -> Option<usize> {
    match tiling.coloring() {
        Coloring::Map(_) if tiling.kind() == Kind::Corner => Some(1),
        Coloring::Map(_) | Coloring::Probabilities(_) => Some(2),
        Coloring::Compact(Compact::Block4(_)) | Coloring::Permuted(_) => Some(1),
        _ => None,
    }
}

/// The parts that give the sides of a tile.
pub(super) fn templates(tiling: &Tiling) -> Vec<&'static str> {
    const MIX: &str = include_str!("template/mix.wgsl");
    const KEYED: &str = include_str!("template/keyed.wgsl");
    const AROUND: &str = include_str!("template/around.wgsl");
    let mut parts = match tiling.coloring() {
        Coloring::Hash { .. } => vec![MIX, include_str!("template/hash.wgsl")],
        Coloring::Halton(_) => vec![include_str!("template/halton.wgsl")],
        Coloring::Map(_) => vec![include_str!("template/map.wgsl")],
        Coloring::Compact(Compact::Xor(_)) => vec![MIX, KEYED, include_str!("template/xor.wgsl")],
        Coloring::Compact(Compact::Diagonal(_)) => {
            vec![MIX, KEYED, include_str!("template/diagonal.wgsl")]
        }
        Coloring::Compact(Compact::Block4(_)) => {
            vec![MIX, KEYED, include_str!("template/block4.wgsl")]
        }
        // Refused above.
        Coloring::Compact(Compact::Frames(_)) => vec![],
        Coloring::Sums(_) => vec![MIX, KEYED, include_str!("template/sums.wgsl")],
        Coloring::Permuted(_) => vec![
            AROUND,
            include_str!("template/entry.wgsl"),
            include_str!("template/permuted.wgsl"),
        ],
        Coloring::Probabilities(_) => {
            vec![MIX, KEYED, AROUND, include_str!("template/probabilities.wgsl")]
        }
    };
    match (tiling.coloring(), tiling.kind()) {
        // These give all four at once.
        (Coloring::Compact(Compact::Block4(_)) | Coloring::Sums(_), _) => {}
        (Coloring::Map(_), Kind::Corner) => parts.push(include_str!("template/map_corner.wgsl")),
        (Coloring::Map(_), _) => parts.push(include_str!("template/map_wang.wgsl")),
        (_, Kind::Corner) => parts.push(include_str!("template/corner.wgsl")),
        _ => parts.push(include_str!("template/wang.wgsl")),
    }
    parts
}

/// The seeds of the hashes, each with the name of the constant that is its key.
pub(super) fn seeds(tiling: &Tiling) -> Vec<(&'static str, u32)> {
    match tiling.coloring() {
        Coloring::Hash { seed } => vec![("KEY", *seed)],
        Coloring::Compact(Compact::Xor(xor)) => vec![("KEY", xor.hash_seed())],
        Coloring::Compact(Compact::Block4(block)) => {
            vec![("KEY", block.frame_seed()), ("KEY_BLOCK", block.block_seed())]
        }
        Coloring::Compact(Compact::Diagonal(diagonal)) => {
            let [begins, ends, bits] = diagonal.hash_seeds();
            vec![("KEY", begins), ("KEY_ENDS", ends), ("KEY_BITS", bits)]
        }
        Coloring::Sums(sums) => {
            let [horizontal, vertical] = sums.hash_seeds();
            vec![("KEY", horizontal), ("KEY_VERTICAL", vertical)]
        }
        Coloring::Probabilities(map) => {
            let [first, second] = map.hash_seeds();
            vec![("KEY", first), ("KEY_SECOND", second)]
        }
        Coloring::Compact(Compact::Frames(_)) => Vec::new(),
        Coloring::Halton(_) | Coloring::Map(_) | Coloring::Permuted(_) => Vec::new(),
    }
}

/// The constants that they name.
pub(super) fn constants(tiling: &Tiling) -> Vec<(&'static str, u64)> {
    let keys = seeds(tiling).into_iter().map(|(name, seed)| (name, hash::key(seed).into()));
    let mut constants: Vec<(&'static str, u64)> = keys.collect();
    match tiling.coloring() {
        Coloring::Halton(halton) => constants.extend([
            ("N1", halton.n1.into()),
            ("N2", halton.n2.into()),
            ("P1", halton.p1),
            ("P2", halton.p2),
            ("M1", halton.m1),
            ("M2", halton.m2),
        ]),
        Coloring::Map(map) => constants.extend([
            ("MAP_W", map.shape().width() as u64),
            ("MAP_H", map.shape().height() as u64),
        ]),
        Coloring::Compact(Compact::Xor(xor)) => constants.push(("BITS", xor.bits.into())),
        Coloring::Permuted(hash) => constants.push(("TABLES", hash.tables().len() as u64)),
        Coloring::Probabilities(map) => constants.extend([
            ("MAP_W", map.shape().width() as u64),
            ("MAP_H", map.shape().height() as u64),
            ("SCALE_X", map.scale()[0].into()),
            ("SCALE_Y", map.scale()[1].into()),
        ]),
        _ => {}
    }
    constants
}

/// A line of the head.
pub(super) fn words(tiling: &Tiling) -> String {
    match tiling.coloring() {
        Coloring::Hash { seed } => format!("colors by hash with seed {seed},"),
        Coloring::Halton(halton) => {
            format!("Halton colors on {} x {} points, repeated,", halton.p1, halton.p2)
        }
        Coloring::Map(map) => format!("the colors of a map of {} cells, repeated,", map.shape()),
        Coloring::Compact(compact) => format!(
            "the compact {} set ({}) with seed {},",
            compact.rule().name(),
            compact.rule().words(),
            compact.seed()
        ),
        Coloring::Sums(sums) => format!(
            "edges by sums of {} a corner, with seed {},",
            if sums.two { "two hashes" } else { "one hash" },
            sums.seed
        ),
        Coloring::Permuted(hash) => format!(
            "colors by {} of permutations shuffled by {}, a period of {} points,",
            if hash.tables().len() > 1 { "tables" } else { "a table" },
            hash.seed(),
            hash.period()
        ),
        Coloring::Probabilities(map) => format!(
            "colors by a map of {} cells of probabilities, {}x{} points each, with seed {},",
            map.shape(),
            map.scale()[0],
            map.scale()[1],
            map.seed()
        ),
    }
}
