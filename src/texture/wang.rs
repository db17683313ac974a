//! Wang tiles from diamonds (Cohen et al. 2003), with the corner problem solved.
//!
//! Each edge color has a sample centred on the middle of the edge: a diamond, of which one half
//! fills the triangle of a tile at that edge, the other half that of its neighbor. The samples of
//! two edges that meet in a corner overlap in a band along the diagonal of that quarter of the
//! tile, where they are cut apart once for each pair of colors.
//!
//! Tiles that meet in a corner only share no color, so all must show the same there. One more
//! patch is centred on all corners. First it is woven into both ends of every sample, such that
//! the square of the strip's width shows it alone; then the samples are cut. So what shows within
//! the strip of a side depends on the color of that edge alone, and in the corners on nothing.

use super::Shape;
use super::quilt::Quilt;
use super::settle::{Contact, Settling, Site, scattered};
use super::stock::{Stock, Texel};
use super::weave::{Hold, weave};
use crate::tiles::Colors;
use rand_pcg::Pcg64;

/// Places of a band that are compared.
const PLACES: usize = 96;

/// Quarters of a tile: NW, NE, SW, SE.
const QUARTERS: [(bool, bool); 4] = [(false, false), (false, true), (true, false), (true, true)];

/// Samples, and the seams between them.
#[derive(Debug, Clone)]
pub struct Edges {
    shape: Shape,
    colors: Colors,
    /// For each color of horizontal edges its sample, a tile's size, the edge across its middle.
    horizontal: Vec<Quilt>,
    /// The same for vertical edges.
    vertical: Vec<Quilt>,
    /// For each quarter, and each pair of a horizontal and a vertical edge: where the sample of
    /// the vertical edge shows.
    seams: [Vec<Vec<bool>>; 4],
    /// What is paid for the seams.
    pub price: u64,
}

/// How far the patch on the corners reaches.
fn corner_reach(shape: Shape) -> usize {
    (shape.side / 6).max(shape.strip + 2).min(shape.side / 2)
}

/// What has to be placed: horizontal edges, vertical edges, the corner.
fn sites(stock: &Stock, shape: Shape, colors: Colors) -> Vec<Site> {
    let (edges, examples) = (colors.horizontal() + colors.vertical(), stock.places().len());
    let edge = |at: usize| Site { example: at % examples, reach: shape.side / 2 };
    let corner = Site { example: 0, reach: corner_reach(shape) };
    (0..edges).map(edge).chain([corner]).collect()
}

/// The bands along the diagonals, and the ends of the edges.
fn contacts(shape: Shape, colors: Colors, random: &mut Pcg64) -> Vec<Contact> {
    let (half, wide) = ((shape.side / 2) as isize, shape.overlap() as isize);
    let corner = colors.horizontal() + colors.vertical();
    let mut contacts = Vec::new();
    for horizontal in 0..colors.horizontal() {
        for vertical in 0..colors.vertical() {
            for (south, east) in QUARTERS {
                let mut places = Vec::new();
                for (along, off) in scattered(0..half, -wide..wide, PLACES / 2, random) {
                    let (x, y) = (along, (along + off).clamp(0, half - 1));
                    // In the quarter at the NW, mirrored to the others.
                    let mirror = |at: isize, far: bool| if far { 2 * half - 1 - at } else { at };
                    let (x, y) = (mirror(x, east), mirror(y, south));
                    let shift = |far: bool| if far { 2 * half } else { 0 };
                    places.push([(x - half, y - shift(south)), (x - shift(east), y - half)]);
                }
                contacts
                    .push(Contact { sites: [horizontal, colors.horizontal() + vertical], places });
            }
        }
    }
    let reach = corner_reach(shape) as isize;
    for edge in 0..corner {
        for end in [-half, half] {
            let inner = if end < 0 { 0..reach } else { -reach..0 };
            let all = scattered(inner, -reach..reach, PLACES / 2, random);
            let places = all.iter().map(|&(along, across)| match edge < colors.horizontal() {
                true => [(end + along, across), (along, across)],
                false => [(across, end + along), (across, along)],
            });
            contacts.push(Contact { sites: [edge, corner], places: places.collect() });
        }
    }
    contacts
}

impl Edges {
    /// Places samples and the patch on the corners, and cuts the seams.
    pub fn new(stock: &Stock, shape: Shape, colors: Colors, random: &mut Pcg64) -> Self {
        let (sites, contacts) = (sites(stock, shape, colors), contacts(shape, colors, random));
        let settling = Settling::new(stock, &sites, &contacts, random);
        let (positions, _) = settling.walk(shape.moves * sites.len(), random);
        Self::of_samples(stock, shape, colors, &positions)
    }

    /// Cuts the seams between given samples: horizontal edges, vertical edges, the corner.
    pub fn of_samples(stock: &Stock, shape: Shape, colors: Colors, positions: &[Texel]) -> Self {
        let count = colors.horizontal();
        let mut price = 0;
        let corner = positions[positions.len() - 1];
        let mut sample = |at: usize| {
            let (quilt, paid) = with_ends(stock, shape, positions[at], corner, at >= count);
            price += paid;
            quilt
        };
        let horizontal: Vec<Quilt> = (0..count).map(&mut sample).collect();
        let vertical: Vec<Quilt> = (count..positions.len() - 1).map(&mut sample).collect();
        let seams = QUARTERS.map(|quarter| {
            let pairs = horizontal.iter().flat_map(|h| vertical.iter().map(move |v| (h, v)));
            pairs
                .map(|(horizontal, vertical)| {
                    let (seam, paid) = cut(stock, shape, horizontal, vertical, quarter);
                    price += paid;
                    seam
                })
                .collect()
        });
        Self { shape, colors, horizontal, vertical, seams, price }
    }

    /// The picture of a tile, from its colors N, E, S, W.
    pub fn tile(&self, [n, e, s, w]: [u8; 4]) -> Quilt {
        let half = self.shape.side / 2;
        let [n, e, s, w] = [n, e, s, w].map(usize::from);
        Quilt::new(self.shape.side, self.shape.side, |x, y| {
            let (south, east) = (y >= half, x >= half);
            let (horizontal, vertical) = (if south { s } else { n }, if east { e } else { w });
            let quarter = 2 * usize::from(south) + usize::from(east);
            let seam = &self.seams[quarter][horizontal * self.colors.vertical() + vertical];
            let (column, row) = (x % half, y % half);
            match seam[row * half + column] {
                true => self.vertical[vertical].at(sample_line(x, east, half), y),
                false => self.horizontal[horizontal].at(x, sample_line(y, south, half)),
            }
        })
    }
}

/// From a row of a tile to that of a sample: the northern edge is in its middle, so is the
/// southern one. The same for columns.
fn sample_line(at: usize, far: bool, half: usize) -> usize {
    if far { at - half } else { at + half }
}

/// A sample with the patch of the corners woven into both ends; what is paid for that.
fn with_ends(
    stock: &Stock,
    shape: Shape,
    middle: Texel,
    corner: Texel,
    turned: bool,
) -> (Quilt, u64) {
    let (side, half, stride) = (shape.side, (shape.side / 2) as isize, stock.stride() as isize);
    let (reach, strip) = (corner_reach(shape) as isize, shape.strip as isize);
    let texel = |of: Texel, x: isize, y: isize| (of as isize + y * stride + x) as Texel;
    let place = |x: usize, y: usize| (x as isize - half, y as isize - half);
    let plain = Quilt::new(side, side, |x, y| {
        let (x, y) = place(x, y);
        texel(middle, x, y)
    });
    // Along the edge from its nearer end, and across it.
    let from_end = |x: usize, y: usize| {
        let (x, y) = place(x, y);
        let (along, across) = if turned { (y, x) } else { (x, y) };
        (if along < 0 { along + half } else { along - half }, across)
    };
    let near = |from: isize, reach: isize| from >= -reach && from < reach;
    let ends = Quilt::new(side, side, |x, y| {
        let (along, across) = from_end(x, y);
        match near(along, reach) && near(across, reach) {
            true if turned => texel(corner, across, along),
            true => texel(corner, along, across),
            false => plain.at(x, y),
        }
    });
    let hold: Vec<Hold> = (0..side * side)
        .map(|at| {
            let (along, across) = from_end(at % side, at / side);
            match () {
                () if near(along, strip) && near(across, strip) => Hold::Second,
                () if near(along, reach - 1) && near(across, reach - 1) => Hold::Free,
                () => Hold::First,
            }
        })
        .collect();
    let woven = weave(stock, &plain, &ends, &hold);
    (woven.quilt(&plain, &ends), woven.price)
}

/// Cuts the samples of a horizontal and a vertical edge apart in a quarter of a tile; what is
/// paid.
fn cut(
    stock: &Stock,
    shape: Shape,
    horizontal: &Quilt,
    vertical: &Quilt,
    (south, east): (bool, bool),
) -> (Vec<bool>, u64) {
    let half = shape.side / 2;
    let shift = |far: bool| if far { half } else { 0 };
    let (left, top) = (shift(east), shift(south));
    let first =
        Quilt::new(half, half, |x, y| horizontal.at(left + x, sample_line(top + y, south, half)));
    let second =
        Quilt::new(half, half, |x, y| vertical.at(sample_line(left + x, east, half), top + y));
    let hold: Vec<Hold> = (0..half * half)
        .map(|at| {
            // From the corner of the tile.
            let from = |at: usize, far: bool| if far { half - 1 - at } else { at };
            let (x, y) = (from(at % half, east), from(at / half, south));
            // The band narrows toward the middle, where all four meet.
            let wide = shape.overlap().min(half - 1 - x.max(y));
            match () {
                () if x.min(y) >= shape.strip && x.abs_diff(y) < wide => Hold::Free,
                () if x < y => Hold::Second,
                () => Hold::First,
            }
        })
        .collect();
    let woven = weave(stock, &first, &second, &hold);
    (woven.second, woven.price)
}
