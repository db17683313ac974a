//! The slow and obvious way: put a large tiling together, filter it, filter the atlas, and look
//! for the largest difference. It shares nothing with the program's way but the pictures.

use tilepack::atlas::{Image, Layout, TileImages};
use tilepack::tiles::{Kind, TileId};
use tilepack::torus::Packing;

/// Brightness, row by row.
#[derive(Clone)]
pub(crate) struct Picture {
    width: usize,
    height: usize,
    light: Vec<f64>,
}

impl Picture {
    /// The only channel of a linear picture.
    pub(crate) fn of(image: &Image) -> Self {
        let (width, height) = (image.width(), image.height());
        let max = f64::from(image.format().max());
        let at = |i: usize| f64::from(image.sample(i % width, i / width, 0)) / max;
        Self { width, height, light: (0..width * height).map(at).collect() }
    }

    fn texel(&self, x: i64, y: i64) -> f64 {
        let x = x.rem_euclid(self.width as i64) as usize;
        let y = y.rem_euclid(self.height as i64) as usize;
        self.light[y * self.width + x]
    }

    fn half(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mean = |i: usize| {
            let (x, y) = (2 * (i % width) as i64, 2 * (i / width) as i64);
            let upper = self.texel(x, y) + self.texel(x + 1, y);
            (upper + self.texel(x, y + 1) + self.texel(x + 1, y + 1)) / 4.0
        };
        Self { width, height, light: (0..width * height).map(mean).collect() }
    }

    pub(crate) fn levels(self, count: usize) -> Vec<Self> {
        let mut levels = vec![self];
        while levels.len() < count {
            levels.push(levels[levels.len() - 1].half());
        }
        levels
    }

    /// x and y in texels of level 0.
    fn bilinear(&self, level: usize, x: f64, y: f64) -> f64 {
        let size = (1 << level) as f64;
        let (u, v) = (x / size - 0.5, y / size - 0.5);
        let (i, j) = (u.floor(), v.floor());
        let (a, b) = (u - i, v - j);
        let at = |di: i64, dj: i64| self.texel(i as i64 + di, j as i64 + dj);
        (1.0 - b) * ((1.0 - a) * at(0, 0) + a * at(1, 0))
            + b * ((1.0 - a) * at(0, 1) + a * at(1, 1))
    }
}

/// A sample; x and y in texels.
pub(crate) fn filtered(levels: &[Picture], way: Way, x: f64, y: f64) -> f64 {
    match way {
        Way::Bilinear(level) => levels[level].bilinear(level, x, y),
        Way::Trilinear(level) => {
            let fine = levels[level].bilinear(level, x, y);
            (fine + levels[level + 1].bilinear(level + 1, x, y)) / 2.0
        }
        Way::Anisotropic(ratio, dx, dy) => {
            let offset = |i: usize| i as f64 - (ratio as f64 - 1.0) / 2.0;
            let at = |i| levels[0].bilinear(0, x + dx * offset(i), y + dy * offset(i));
            (0..ratio).map(at).sum::<f64>() / ratio as f64
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    Bilinear(usize),
    Trilinear(usize),
    /// So many samples, this step apart.
    Anisotropic(usize, f64, f64),
}

/// A random legal tiling, `size` tiles a side, of a complete set; of any other set row by row,
/// from the north-west, among the tiles that fit, starting again when none does.
pub(crate) fn tiling(packing: &Packing, size: usize) -> Vec<TileId> {
    let mut state = 1u64;
    let mut random = move |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 33) as usize) % below
    };
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let sides = |tile: TileId| kind.unpack(tile, colors);
    'again: loop {
        let mut tiles: Vec<TileId> = Vec::new();
        for cell in 0..size * size {
            let fits = |&tile: &TileId| {
                let [a, _, c, d] = sides(tile);
                let west = (cell % size > 0).then(|| sides(tiles[cell - 1]));
                let north = (cell >= size).then(|| sides(tiles[cell - size]));
                match kind {
                    Kind::Wang => {
                        west.is_none_or(|west| west[1] == d)
                            && north.is_none_or(|north| north[2] == a)
                    }
                    // NE, SE, SW, NW.
                    _ => {
                        west.is_none_or(|west| (west[0], west[1]) == (d, c))
                            && north.is_none_or(|north| (north[2], north[1]) == (d, a))
                    }
                }
            };
            let fitting: Vec<TileId> = packing.tiles.iter().copied().filter(fits).collect();
            match fitting.len() {
                0 => continue 'again,
                count => tiles.push(fitting[random(count)]),
            }
        }
        return tiles;
    }
}

/// The largest difference, in 1/255, over all samples on a grid of half texels in all tiles of a
/// tiling but those at its rim.
pub(crate) fn largest(
    layout: &Layout,
    atlas: &[Picture],
    images: &dyn TileImages,
    tiles: &[TileId],
    way: Way,
) -> f64 {
    let size = tiles.len().isqrt();
    let side = layout.side;
    let whole = tilepack::atlas::assemble(images, tiles, size).unwrap();
    let tiling = Picture::of(&whole).levels(atlas.len());
    let mut largest: f64 = 0.0;
    for row in 1..size - 1 {
        for column in 1..size - 1 {
            let (x, y) = layout.position(layout.cell(tiles[row * size + column]).unwrap());
            let (block, gutter) = (layout.block(), layout.gutter);
            for half in 0..(2 * side + 1) * (2 * side + 1) {
                let (dx, dy) = (half % (2 * side + 1), half / (2 * side + 1));
                let (dx, dy) = (dx as f64 / 2.0, dy as f64 / 2.0);
                let (left, top) = ((x * block + gutter) as f64, (y * block + gutter) as f64);
                let shown = filtered(atlas, way, left + dx, top + dy);
                let (left, top) = ((column * side) as f64, (row * side) as f64);
                let meant = filtered(&tiling, way, left + dx, top + dy);
                largest = largest.max((shown - meant).abs());
            }
        }
    }
    255.0 * largest
}
