//! How good tiles are, in fields and in words.

use super::super::args::FillArgs;
use super::sources::Wanted;
use crate::atlas::demo::{self, How};
use crate::texture::quality::{Quality, Seams};
use crate::texture::{Made, Method, Quilt, Stock, quilting};
use crate::tiles::{Members, TileSet};
use crate::torus::{Packing, Shape};
use serde_json::{Value, json};

/// Tiles of a tiling that is looked at, in a row.
const TILES: usize = 32;
/// Texels of it in a row, at most, but 4 tiles.
const TEXELS: usize = 2048;
/// Texels of a quilt in a row, at most, but 4 tiles and no more than 16.
const QUILT: usize = 1024;

/// The numbers on tiles, and on what they are compared with.
pub(super) struct Report {
    tiles: Quality,
    others: Vec<(&'static str, Quality)>,
}

/// The name of a method.
pub(super) fn method(method: Method) -> &'static str {
    match method {
        Method::Cohen => "cohen",
        Method::Ng => "ng",
        Method::Schlomer => "schlomer",
    }
}

/// Looks at the tiles; `None` where no tiling of them is found.
pub(super) fn report(
    args: &FillArgs,
    stock: &Stock,
    made: &Made,
    wanted: &Wanted,
) -> Option<Report> {
    let side = made.order.shape.side;
    let count = (TEXELS / side).clamp(4, TILES);
    let shape = Shape::new(count as u64, count as u64).ok()?;
    let laid = match &wanted.packing {
        Some(packing) => demo::tiling(packing, shape, 1),
        None => {
            // Not a packing, only what lists the tiles; so it must not be repeated.
            let tiles: Vec<_> = made.tiles.keys().copied().collect();
            let set = match wanted.set.members() {
                Members::Complete => wanted.set.clone(),
                _ => {
                    let members = Members::Explicit(tiles.clone());
                    TileSet::new(wanted.kind, wanted.colors, members).ok()?
                }
            };
            let row = Shape::new(tiles.len() as u64, 1).ok()?;
            let laid = demo::tiling(&Packing::new(set, row, true, tiles), shape, 1);
            (laid.how != How::Repeated).then_some(laid)?
        }
    };
    let quality = |tiling: &Quilt| Quality::of(stock, tiling, side, 1);
    let tiles = quality(&made.tiling(&laid.tiles, count).ok()?);
    let mut others = Vec::new();
    if args.baselines {
        let (seed, candidates) = (made.order.seed, made.order.candidates);
        if made.order.shape.suits(stock, side / 2 + made.order.shape.overlap()).is_ok()
            && let Some(tile) = quilting::periodic(stock, made.order.shape, seed, candidates)
        {
            let texels = count * side;
            let tiling = Quilt::new(texels, texels, |x, y| tile.at(x % side, y % side));
            others.push(("periodic", quality(&tiling)));
        }
        let texels = (QUILT / side).clamp(4, 16) * side;
        let quilt = quilting::quilted(stock, side * 3 / 4, texels, texels, seed);
        others.push(("quilting", quality(&quilt)));
    }
    Some(Report { tiles, others })
}

/// Four digits are all that is worth telling.
fn rounded(value: f64) -> Value {
    json!((value * 1e4).round() / 1e4)
}

fn fields_of(quality: &Quality) -> Value {
    let Quality { size, seams, period, likeness, reuse } = quality;
    let Seams { share, mean, high, largest, at_cuts, at_borders, at_middles } = *seams;
    let channels: Vec<Value> = likeness
        .channels
        .iter()
        .map(|channel| {
            json!({
                "mean": rounded(channel.mean),
                "variance": rounded(channel.variance),
                "moved": rounded(channel.moved),
            })
        })
        .collect();
    let correlation: Vec<Value> = period.correlation.iter().map(|&value| rounded(value)).collect();
    json!({
        "columns": size.0,
        "rows": size.1,
        "seams": {
            "share": rounded(share), "mean": rounded(mean), "high": rounded(high),
            "largest": rounded(largest), "at_cuts": rounded(at_cuts),
            "at_borders": rounded(at_borders), "at_middles": rounded(at_middles),
        },
        "period": {
            "tiles": period.tiles, "comb": rounded(period.comb), "peak": rounded(period.peak),
            "correlation": correlation,
        },
        "likeness": {
            "channels": channels, "patches": rounded(likeness.patches),
            "patches_high": rounded(likeness.patches_high),
        },
        "reuse": {
            "share": rounded(reuse.share), "evenness": rounded(reuse.evenness),
            "largest": rounded(reuse.largest),
        },
    })
}

impl Report {
    /// For programs.
    pub(super) fn fields(&self) -> Vec<(&'static str, Value)> {
        let others = self.others.iter().map(|(name, quality)| (*name, fields_of(quality)));
        let mut fields = vec![("quality", fields_of(&self.tiles))];
        if !self.others.is_empty() {
            let others: serde_json::Map<String, Value> =
                others.map(|(name, value)| (name.to_owned(), value)).collect();
            fields.push(("baselines", Value::Object(others)));
        }
        fields
    }

    /// For people.
    pub(super) fn lines(&self) -> Vec<String> {
        let all = std::iter::once(("tiles", &self.tiles))
            .chain(self.others.iter().map(|(name, quality)| (*name, quality)));
        all.flat_map(|(name, quality)| lines_of(name, quality)).collect()
    }
}

fn lines_of(name: &str, quality: &Quality) -> [String; 2] {
    let Quality { seams, period, likeness, reuse, .. } = quality;
    let moved = likeness.channels.iter().map(|channel| channel.moved).fold(0.0, f64::max);
    let first = period.correlation.first().copied().unwrap_or(0.0);
    [
        format!(
            "{name}: mismatch at seams {:.2}, 95 % below {:.2} (1: neighbors in the example); \
             steps at borders {:.2}, middles {:.2}, cuts {:.2} of those elsewhere",
            seams.mean, seams.high, seams.at_borders, seams.at_middles, seams.at_cuts
        ),
        format!(
            "{name}: {:.0} % of the example shows; correlation {first:.2} one tile apart, comb \
             {:.0} (1 to {}); light moved by {moved:.1}/255, 7x7 patches off by {:.1}/255",
            100.0 * reuse.share,
            period.comb,
            period.tiles,
            likeness.patches
        ),
    ]
}
