//! Do the tiles of a sheet fit? For sheets that others made.
//!
//! * **Strips.** Within `strip` texels of a side all tiles with the same colors there should
//!   show the same. What they should show is taken to be the *median* of what they do show, so
//!   the tile that is off is found, and not those that it is compared with.
//! * **Corners** of Wang tiles should be the same in all tiles ([`super::StripCheck`]).
//! * **Steps.** For every pair of tiles that may lie side by side, the step across the seam is
//!   compared with the steps beside it within the tiles. A step much larger than those is seen.
//! * Tiles that the set has and the sheet has not, tiles that show twice, and sides that nothing
//!   fits.
//!
//! Differences are in 1/255 of the full sample, as stored.

mod heat;
mod steps;

pub use heat::heat_map;
pub use steps::Seam;

use super::sides::{keys, side_keys};
use super::strip::{Area, corner_areas, strip_area};
use super::{AtlasError, Image, Sheet};
use crate::tiles::Side;
use crate::tiles::{Kind, TileId};
use rayon::prelude::*;
use std::collections::{BTreeMap, HashMap};

/// What to look at.
#[derive(Debug, Clone, Copy)]
pub struct Question {
    /// Texels of the common strip, at most half a tile; 0 for none.
    pub strip: usize,
    /// Differences up to this many 1/255 are none.
    pub tolerance: f64,
}

/// How far an area of a tile is from what it should show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// The cell of the sheet.
    pub cell: usize,
    /// The side; for a corner the side clockwise before it (N for NE).
    pub side: Side,
    /// Whether it is the square in a corner.
    pub corner: bool,
    /// The largest difference, in 1/255.
    pub largest: f64,
    /// The root of the mean of the squares, in 1/255.
    pub rms: f64,
    /// Column and row of the largest difference within the tile.
    pub at: (usize, usize),
}

/// What was found.
#[derive(Debug, Clone)]
pub struct Findings {
    /// Areas that are off, the worst first.
    pub deviations: Vec<Deviation>,
    /// Areas looked at.
    pub areas: usize,
    /// All pairs that may lie side by side, the worst first.
    pub seams: Vec<Seam>,
    /// Tiles that show more than once, with their cells.
    pub twice: Vec<(TileId, Vec<usize>)>,
    /// Cells of different tiles that look the same.
    pub alike: Vec<(usize, usize)>,
    /// Sides that no tile fits.
    pub lonely: Vec<(usize, Side)>,
    /// Cells that are off, the one to draw again first at the front, with what speaks against
    /// it: the sum of the squares of all that is off.
    pub redraw: Vec<(usize, f64)>,
    /// How far each sample of each area is off: cell, area, differences sample by sample.
    off: Vec<(usize, Area, Vec<f32>)>,
}

impl Findings {
    /// Pairs whose seam is seen.
    pub fn visible(&self) -> impl Iterator<Item = &Seam> {
        self.seams.iter().filter(|seam| seam.is_visible())
    }
}

/// Looks at a sheet.
///
/// # Errors
/// A strip wider than half a tile.
pub fn lint(sheet: &Sheet, question: Question) -> Result<Findings, AtlasError> {
    let layout = sheet.layout();
    let (side, strip) = (layout.side, question.strip);
    if 2 * strip > side {
        return Err(AtlasError::Asked(format!(
            "a strip of {strip} texels: at most half a tile, {}",
            side / 2
        )));
    }
    let images: Vec<Image> =
        (0..layout.tiles.len()).into_par_iter().map(|cell| sheet.cell(cell)).collect();
    let (kind, colors) = (layout.kind, layout.colors);
    let sides: Vec<[u32; 4]> =
        layout.tiles.iter().map(|&tile| side_keys(kind, tile, colors)).collect();
    let mut deviations = Vec::new();
    let mut off = Vec::new();
    let mut areas = 0;
    let mut compare = |cells: &[usize], side: Side, corner: bool, area: Area| {
        areas += cells.len();
        for (deviation, samples) in against_median(&images, cells, side, corner, area) {
            if deviation.largest > question.tolerance {
                off.push((deviation.cell, area, samples));
                deviations.push(deviation);
            }
        }
    };
    if strip > 0 {
        let stride = keys(kind, colors);
        for (at, of) in Side::ALL.into_iter().enumerate() {
            let mut by_key: Vec<Vec<usize>> = vec![Vec::new(); stride];
            for (cell, keys) in sides.iter().enumerate() {
                by_key[keys[at] as usize].push(cell);
            }
            for cells in by_key.iter().filter(|cells| cells.len() > 1) {
                compare(cells, of, false, strip_area(of, side, strip));
            }
        }
        if kind == Kind::Wang {
            let all: Vec<usize> = (0..images.len()).collect();
            for (of, area) in Side::ALL.into_iter().zip(corner_areas(side, strip)) {
                compare(&all, of, true, area);
            }
        }
    }
    deviations.sort_by(|a, b| b.largest.total_cmp(&a.largest).then(a.cell.cmp(&b.cell)));
    let seams = steps::seams(&images, &sides, strip);
    let redraw = redraw(&deviations, &seams, images.len());
    let lonely = (0..images.len()).flat_map(|cell| Side::ALL.map(|side| (cell, side))).filter(
        |&(cell, side)| {
            let key = sides[cell][side as usize];
            !sides.iter().any(|other| other[side.opposite() as usize] == key)
        },
    );
    let mut cells: BTreeMap<TileId, Vec<usize>> = BTreeMap::new();
    for (cell, &tile) in layout.tiles.iter().enumerate() {
        cells.entry(tile).or_default().push(cell);
    }
    Ok(Findings {
        areas,
        seams,
        lonely: lonely.collect(),
        alike: alike(&images, &layout.tiles),
        twice: cells.into_iter().filter(|(_, cells)| cells.len() > 1).collect(),
        redraw,
        deviations,
        off,
    })
}

/// How far the area of each cell is from the median of all of them.
fn against_median(
    images: &[Image],
    cells: &[usize],
    side: Side,
    corner: bool,
    (x, y, width, height): Area,
) -> Vec<(Deviation, Vec<f32>)> {
    let channels = images[0].format().channels.count();
    let scale = 255.0 / f64::from(images[0].format().max());
    let read = |cell: usize, at: usize| {
        let (texel, channel) = (at / channels, at % channels);
        images[cell].sample(x + texel % width, y + texel / width, channel)
    };
    let samples = width * height * channels;
    let median: Vec<u16> = (0..samples)
        .into_par_iter()
        .map(|at| {
            let mut values: Vec<u16> = cells.iter().map(|&cell| read(cell, at)).collect();
            let middle = (values.len() - 1) / 2;
            *values.select_nth_unstable(middle).1
        })
        .collect();
    let one = |&cell: &usize| {
        let differences: Vec<f32> = (0..samples)
            .map(|at| (f64::from(read(cell, at).abs_diff(median[at])) * scale) as f32)
            .collect();
        let mut worst = 0;
        for at in 1..samples {
            if differences[at] > differences[worst] {
                worst = at;
            }
        }
        let squares: f64 = differences.iter().map(|&d| f64::from(d) * f64::from(d)).sum();
        let texel = worst / channels;
        let deviation = Deviation {
            cell,
            side,
            corner,
            largest: differences[worst].into(),
            rms: (squares / samples as f64).sqrt(),
            at: (x + texel % width, y + texel / width),
        };
        (deviation, differences)
    };
    cells.par_iter().map(one).collect()
}

/// Cells by all that is off about them, the worst first.
fn redraw(deviations: &[Deviation], seams: &[Seam], cells: usize) -> Vec<(usize, f64)> {
    let mut against = vec![0.0; cells];
    for deviation in deviations {
        against[deviation.cell] += deviation.rms * deviation.rms;
    }
    // A seam that is seen speaks against both tiles, and against each the less the more tiles
    // it was tried with.
    let mut tried = vec![0usize; cells];
    for seam in seams {
        tried[seam.first] += 1;
        tried[seam.second] += 1;
    }
    for seam in seams.iter().filter(|seam| seam.is_visible()) {
        for cell in [seam.first, seam.second] {
            against[cell] += seam.step * seam.step / tried[cell] as f64;
        }
    }
    let mut order: Vec<(usize, f64)> =
        against.into_iter().enumerate().filter(|(_, sum)| *sum > 0.0).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    order
}

/// Cells with the same picture, but different tiles: each with the first that looks so.
fn alike(images: &[Image], tiles: &[TileId]) -> Vec<(usize, usize)> {
    let mut seen: HashMap<&[u8], usize> = HashMap::new();
    let mut pairs = Vec::new();
    for (cell, image) in images.iter().enumerate() {
        let first = *seen.entry(image.data()).or_insert(cell);
        if tiles[first] != tiles[cell] {
            pairs.push((first, cell));
        }
    }
    pairs
}
