//! A set of tiles from examples.
//!
//! Several choices of patches are tried, each from a seed of its own; the one whose seams cost
//! least is kept, and its tiles are covered. Every tile tries several patches for its middle. All
//! of that is done side by side, and the same whatever the number of threads: random numbers
//! belong to candidates and tiles, and what is chosen depends on prices and order alone.
//!
//! A time limit ends the trying, not the making: one candidate and one patch a tile are always
//! tried.

use super::corner::Corners;
use super::cover::{Cover, Fit, shared_out};
use super::quilt::Quilt;
use super::shape::Shape;
use super::stock::Stock;
use super::wang::Edges;
use super::{TextureError, staircase};
use crate::atlas::{AtlasError, Format, Image, StripCheck, TileImages};
use crate::search::Stop;
use crate::tiles::{Colors, Kind, TileId};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How the tiles are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Wang tiles of diamonds, and nothing more.
    Cohen,
    /// The middle covered along the cheapest cut.
    Ng,
    /// The middle covered along four staircases.
    Schlomer,
}

/// What is to be made.
#[derive(Debug, Clone, Copy)]
pub struct Order {
    /// What carries the colors.
    pub kind: Kind,
    /// The palettes.
    pub colors: Colors,
    /// The tiles' size.
    pub shape: Shape,
    /// How.
    pub method: Method,
    /// Seed of all random choices.
    pub seed: u64,
    /// Choices of patches that are tried.
    pub candidates: usize,
    /// Patches that are tried for the middle of each tile.
    pub tries: usize,
}

/// How far it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Candidates tried.
    pub candidates: usize,
    /// Tiles that are done.
    pub tiles: usize,
}

/// Tiles made from examples.
#[derive(Debug, Clone)]
pub struct Made {
    /// What was asked for.
    pub order: Order,
    /// The tiles, in increasing order.
    pub tiles: BTreeMap<TileId, Quilt>,
    /// What the seams of each candidate that was tried cost, in the order of seeds.
    pub candidates: Vec<u64>,
    /// The one that was taken.
    pub taken: usize,
    /// Whether the time was up before all was tried.
    pub cut_short: bool,
}

/// The most texels of all tiles together.
const MOST_TEXELS: u64 = 1 << 28;

/// Tiles before they are covered.
enum Base {
    Corners(Corners),
    Edges(Edges),
}

impl Base {
    fn price(&self) -> u64 {
        match self {
            Base::Corners(corners) => corners.price,
            Base::Edges(edges) => edges.price,
        }
    }

    fn tile(&self, order: Order, tile: TileId) -> Quilt {
        let sides = order.kind.unpack(tile, order.colors);
        match self {
            Base::Corners(corners) => corners.tile(sides),
            Base::Edges(edges) => edges.tile(sides),
        }
    }
}

/// Refuses more tiles than can be held.
///
/// # Errors
/// When there are.
pub fn check_count(tiles: u64, shape: Shape) -> Result<(), TextureError> {
    let texels = tiles.saturating_mul((shape.side * shape.side) as u64);
    if texels > MOST_TEXELS {
        return Err(TextureError::Asked(format!(
            "{tiles} tiles of {0} x {0} texels have {texels} texels: at most {MOST_TEXELS}",
            shape.side
        )));
    }
    Ok(())
}

/// Refuses what cannot be made.
fn check(stock: &Stock, order: Order, tiles: u64) -> Result<(), TextureError> {
    let asked = |message: String| Err(TextureError::Asked(message));
    let shape = order.shape;
    match (order.kind, order.method) {
        (Kind::Domino, _) => return asked("expected corner or Wang tiles, not dominoes".into()),
        (Kind::Corner, Method::Cohen) => {
            return asked("the method cohen is for Wang tiles; corner tiles: ng, schlomer".into());
        }
        _ => {}
    }
    let colors = order.colors;
    if colors.horizontal().min(colors.vertical()) < 2 {
        return asked(format!("{colors} colors: expected at least 2, for one shows a period"));
    }
    if tiles == 0 {
        return asked("expected at least one tile".into());
    }
    check_count(tiles, shape)?;
    if order.candidates == 0 || order.tries == 0 {
        return asked("expected at least one candidate and one try".into());
    }
    let reach = match order.kind {
        Kind::Corner => shape.side / 2 + shape.overlap(),
        _ => shape.side / 2,
    };
    shape.suits(stock, reach)
}

/// Makes the tiles: `limit` ends the trying, `signal` all.
///
/// # Errors
/// What cannot be made; [`TextureError::Stopped`].
pub fn make(
    stock: &Stock,
    tiles: &[TileId],
    order: Order,
    (limit, signal): (&dyn Stop, &dyn Stop),
    watch: &(dyn Fn(Progress) + Sync),
) -> Result<Made, TextureError> {
    check(stock, order, tiles.len() as u64)?;
    let tried = AtomicUsize::new(0);
    let candidate = |at: usize| {
        if signal.should_stop() || (at > 0 && limit.should_stop()) {
            return None;
        }
        let mut random = random(order.seed, 1, at as u64);
        let base = match order.kind {
            Kind::Corner => Base::Corners(Corners::new(
                stock,
                order.shape,
                order.colors.horizontal(),
                &mut random,
            )),
            _ => Base::Edges(Edges::new(stock, order.shape, order.colors, &mut random)),
        };
        watch(Progress { candidates: tried.fetch_add(1, Ordering::Relaxed) + 1, tiles: 0 });
        Some(base)
    };
    let bases: Vec<Option<Base>> = (0..order.candidates).into_par_iter().map(candidate).collect();
    let mut cut_short = bases.iter().any(Option::is_none);
    let candidates: Vec<u64> = bases.iter().flatten().map(Base::price).collect();
    let best = bases.into_iter().flatten().enumerate().min_by_key(|(at, base)| (base.price(), *at));
    let Some((taken, base)) = best.filter(|_| !signal.should_stop()) else {
        return Err(TextureError::Stopped);
    };
    let plain: Vec<Quilt> = tiles.par_iter().map(|&tile| base.tile(order, tile)).collect();
    let done = match order.method {
        Method::Cohen => plain,
        _ => {
            let (covered, complete) =
                covered(stock, tiles, order, plain, (limit, signal), &|done| {
                    watch(Progress { candidates: candidates.len(), tiles: done });
                })?;
            cut_short |= !complete;
            covered
        }
    };
    let tiles: BTreeMap<TileId, Quilt> = tiles.iter().copied().zip(done).collect();
    let made = Made { order, tiles, candidates, taken, cut_short };
    made.check(stock)?;
    Ok(made)
}

/// Random numbers for one purpose.
fn random(seed: u64, purpose: u64, number: u64) -> Pcg64 {
    // Any two streams differ in the whole seed, so they are independent.
    let mut bytes = [0; 32];
    for (place, word) in bytes.chunks_exact_mut(8).zip([seed, purpose, number, 0x7469_6c65]) {
        place.copy_from_slice(&word.to_le_bytes());
    }
    Pcg64::from_seed(bytes)
}

/// Covers the middle of every tile; and whether there was time for all tries.
fn covered(
    stock: &Stock,
    tiles: &[TileId],
    order: Order,
    plain: Vec<Quilt>,
    (limit, signal): (&dyn Stop, &dyn Stop),
    watch: &(dyn Fn(usize) + Sync),
) -> Result<(Vec<Quilt>, bool), TextureError> {
    let shape = order.shape;
    let cover = Cover::new(shape, &mut random(order.seed, 2, 0));
    let fits: Vec<Option<Vec<Fit>>> = (0..plain.len())
        .into_par_iter()
        .map(|at| {
            if signal.should_stop() {
                return None;
            }
            let tile = &plain[at];
            let mut examples: Vec<usize> =
                tile.texels.iter().map(|&texel| stock.locate(texel).0).collect();
            examples.sort_unstable();
            examples.dedup();
            let mut random = random(order.seed, 3, u64::from(tiles[at].0));
            Some(cover.fits(stock, tile, &examples, &mut random))
        })
        .collect();
    let fits: Option<Vec<Vec<Fit>>> = fits.into_iter().collect();
    let shares = shared_out(&fits.ok_or(TextureError::Stopped)?, order.tries, stock, shape);
    let done = AtomicUsize::new(0);
    let short = AtomicUsize::new(0);
    let covered = plain.into_par_iter().zip(shares).map(|(tile, share)| {
        let mut best: Option<(u64, Quilt)> = None;
        for at in share {
            if signal.should_stop() {
                return None;
            }
            if best.is_some() && limit.should_stop() {
                short.fetch_add(1, Ordering::Relaxed);
                break;
            }
            let (quilt, price) = match order.method {
                Method::Schlomer => staircase::cover(stock, shape, &tile, at),
                _ => cover.cut(stock, &tile, at),
            };
            if best.as_ref().is_none_or(|(least, _)| price < *least) {
                best = Some((price, quilt));
            }
        }
        watch(done.fetch_add(1, Ordering::Relaxed) + 1);
        best.map(|(_, quilt)| quilt)
    });
    let covered: Option<Vec<Quilt>> = covered.collect::<Vec<_>>().into_iter().collect();
    Ok((covered.ok_or(TextureError::Stopped)?, short.into_inner() == 0))
}

impl Made {
    /// Whether all tiles keep the strip, by their texels: the pictures of all maps do then, too.
    ///
    /// # Errors
    /// The first texel that differs.
    fn check(&self, stock: &Stock) -> Result<(), TextureError> {
        let Order { kind, colors, shape, .. } = self.order;
        let maps = stock.images(0).len();
        for map in 0..maps {
            let mut check = StripCheck::new(kind, colors, shape.strip);
            for (&tile, quilt) in &self.tiles {
                check.add(tile, &quilt.draw(stock, map))?;
            }
        }
        Ok(())
    }
}

impl Made {
    /// A tiling, of tiles listed row by row.
    ///
    /// # Errors
    /// A tile that was not made.
    pub fn tiling(&self, tiles: &[TileId], width: usize) -> Result<Quilt, AtlasError> {
        let side = self.order.shape.side;
        let quilts: Vec<&Quilt> = tiles
            .iter()
            .map(|&tile| {
                let missing = || AtlasError::Asked(format!("tile {tile} was not made"));
                self.tiles.get(&tile).ok_or_else(missing)
            })
            .collect::<Result<_, _>>()?;
        Ok(Quilt::new(width * side, tiles.len() / width * side, |x, y| {
            quilts[y / side * width + x / side].at(x % side, y % side)
        }))
    }
}

/// The pictures of tiles that were made, of one map.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// The tiles.
    pub made: &'a Made,
    /// Where their texels come from.
    pub stock: &'a Stock,
    /// Which map; 0 is the picture itself.
    pub map: usize,
}

impl TileImages for Drawn<'_> {
    fn side(&self) -> usize {
        self.made.order.shape.side
    }

    fn format(&self) -> Format {
        self.stock.images(0)[self.map].format()
    }

    fn draw(&self, tile: TileId) -> Result<Image, AtlasError> {
        let quilt = self.made.tiles.get(&tile);
        let quilt = quilt.ok_or_else(|| AtlasError::Asked(format!("tile {tile} was not made")))?;
        Ok(quilt.draw(self.stock, self.map))
    }
}
