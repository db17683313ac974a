//! The step across a seam, against the steps beside it.

use crate::atlas::Image;
use crate::tiles::Side;
use rayon::prelude::*;

/// Two tiles that may lie side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seam {
    /// The cell of the western or northern tile.
    pub first: usize,
    /// The cell of the other one.
    pub second: usize,
    /// The side of the first tile: east or south.
    pub side: Side,
    /// The largest step across the seam, in 1/255.
    pub largest: f64,
    /// The root of the mean of the squares of the steps across the seam, in 1/255.
    pub step: f64,
    /// The same within the two tiles, from the border texels to the next `strip` (at least 1).
    pub inside: f64,
}

impl Seam {
    /// Whether one sees the seam: its steps are more than twice those beside it, by more than
    /// 4/255.
    pub fn is_visible(&self) -> bool {
        self.step > 2.0 * self.inside + 4.0
    }
}

/// All pairs that may lie side by side, those with the largest steps for what is beside them
/// first.
pub(super) fn seams(images: &[Image], sides: &[[u32; 4]], strip: usize) -> Vec<Seam> {
    let mut seams: Vec<Seam> = (0..images.len())
        .into_par_iter()
        .flat_map_iter(|first| {
            let pairs = [Side::East, Side::South].into_iter().flat_map(move |side| {
                let key = sides[first][side as usize];
                let fits = move |&second: &usize| sides[second][side.opposite() as usize] == key;
                (0..images.len()).filter(fits).map(move |second| (side, second))
            });
            pairs.map(move |(side, second)| seam(images, first, second, side, strip))
        })
        .collect();
    let excess = |seam: &Seam| seam.step - 2.0 * seam.inside;
    seams.sort_by(|a, b| {
        let order = excess(b).total_cmp(&excess(a));
        order.then((a.first, a.second, a.side as u8).cmp(&(b.first, b.second, b.side as u8)))
    });
    seams
}

fn seam(images: &[Image], first: usize, second: usize, side: Side, strip: usize) -> Seam {
    let (a, b) = (&images[first], &images[second]);
    let texels = a.width();
    let channels = a.format().channels.count();
    let scale = 255.0 / f64::from(a.format().max());
    // A sample so many texels before the seam in the first tile, or after it in the second.
    let at = |image: &Image, depth: usize, along: usize, channel: usize| match side {
        Side::East => image.sample(depth, along, channel),
        _ => image.sample(along, depth, channel),
    };
    let (mut across, mut largest) = (0.0, 0.0f64);
    let mut inside = [0.0; 2];
    let deep = strip.max(1).min(texels - 1);
    for along in 0..texels {
        for channel in 0..channels {
            let step = |x: u16, y: u16| f64::from(x.abs_diff(y)) * scale;
            let here = step(at(a, texels - 1, along, channel), at(b, 0, along, channel));
            across += here * here;
            largest = largest.max(here);
            for depth in 0..deep {
                let back = texels - 1 - depth;
                let before = step(at(a, back, along, channel), at(a, back - 1, along, channel));
                let after = step(at(b, depth, along, channel), at(b, depth + 1, along, channel));
                inside[0] += before * before;
                inside[1] += after * after;
            }
        }
    }
    let count = (texels * channels) as f64;
    // The rougher of the two hides the seam.
    let inside = (inside[0].max(inside[1]) / (count * deep.max(1) as f64)).sqrt();
    Seam { first, second, side, largest, step: (across / count).sqrt(), inside }
}
