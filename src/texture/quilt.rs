//! A quilt: a picture put together of texels of the stock.
//!
//! It holds for every place the texel that shows there, and no samples. Texels are copied, never
//! mixed, so all maps of an example follow the same cuts, and two places show the same when they
//! hold the same number. A step from place to place is *smooth* when the texels lie like that in
//! their example, too; else there is a *seam*.

use super::stock::{Stock, Texel};
use crate::atlas::Image;

/// Texels of the stock, row by row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quilt {
    /// Texels of a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The texels.
    pub texels: Vec<Texel>,
}

impl Quilt {
    /// A quilt with the texel that a function gives for each column and row.
    pub fn new(width: usize, height: usize, texel: impl Fn(usize, usize) -> Texel) -> Self {
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Self { width, height, texels: places.map(|(x, y)| texel(x, y)).collect() }
    }

    /// The texel in a column and row.
    #[inline]
    pub fn at(&self, x: usize, y: usize) -> Texel {
        self.texels[y * self.width + x]
    }

    /// Every two places side by side: the first, the second, and the step in the stock.
    pub fn pairs(&self, stock: &Stock) -> impl Iterator<Item = (usize, usize, usize)> + use<> {
        let (width, height, stride) = (self.width, self.height, stock.stride());
        (0..width * height).flat_map(move |at| {
            let beside = (at % width + 1 < width).then_some((at, at + 1, 1));
            let below = (at + width < width * height).then_some((at, at + width, stride));
            beside.into_iter().chain(below)
        })
    }

    /// The seams: places before and after, and the mismatch.
    pub fn seams<'a>(&'a self, stock: &'a Stock) -> impl Iterator<Item = (usize, usize, u32)> + 'a {
        self.pairs(stock).filter_map(|(p, q, step)| {
            let (a, b) = (self.texels[p], self.texels[q]);
            (b != a + step as Texel).then(|| (p, q, stock.mismatch(a, b, step)))
        })
    }

    /// What is paid for all seams.
    pub fn price(&self, stock: &Stock) -> u64 {
        let price = |(p, q, step)| stock.price(self.texels[p], self.texels[q], step) as u64;
        self.pairs(stock).map(price).sum()
    }

    /// The picture, of a map of the examples; 0 is the picture itself.
    pub fn draw(&self, stock: &Stock, map: usize) -> Image {
        let format = stock.images(0)[map].format();
        let bytes = format.bytes();
        let mut image = Image::new(self.width, self.height, format);
        for y in 0..self.height {
            let row = image.row_mut(y);
            for x in 0..self.width {
                let (example, column, line) = stock.locate(self.at(x, y));
                let from = &stock.images(example)[map].row(line)[column * bytes..][..bytes];
                row[x * bytes..][..bytes].copy_from_slice(from);
            }
        }
        image
    }
}
