//! Corner tiles before their middles are covered (Ng et al. 2005; Lagae 2007).
//!
//! Each color has a patch centred on the lattice points of that color; a tile shows a quarter of
//! four patches, with seams in the shape of a cross. For each ordered pair of colors, side by side
//! or one above the other, the seam between the two patches is cut once, from the middle of one
//! tile through the middle of the shared edge to that of the next, and is then the same in all
//! tiles that have the pair. Its band narrows toward the middle of the tile, where all four meet;
//! there it is covered later. So what shows within the strip of a side depends on the two colors
//! of that side alone, and goes on across it.

use super::Shape;
use super::quilt::Quilt;
use super::settle::{Contact, Settling, Site, scattered};
use super::stock::{Stock, Texel};
use super::weave::{Hold, weave};
use rand_pcg::Pcg64;

/// Places of a band that are compared.
const PLACES: usize = 96;

/// Patches and the seams between them.
#[derive(Debug, Clone)]
pub struct Corners {
    shape: Shape,
    colors: usize,
    stride: usize,
    /// The texel south-east of the lattice point, for each color.
    patches: Vec<Texel>,
    /// For each pair side by side, west first: where the eastern patch shows, in the band.
    beside: Vec<Vec<bool>>,
    /// For each pair one above the other, north first: where the southern patch shows, row by
    /// row of the band.
    above: Vec<Vec<bool>>,
    /// What is paid for the seams.
    pub price: u64,
}

/// What has to be placed: a patch for each color, from the examples in turn.
pub fn sites(stock: &Stock, shape: Shape, colors: usize) -> Vec<Site> {
    let examples = stock.places().len();
    let reach = shape.side / 2 + shape.overlap();
    (0..colors).map(|color| Site { example: color % examples, reach }).collect()
}

/// The bands: any two colors may be neighbors in both directions.
pub fn contacts(shape: Shape, colors: usize, random: &mut Pcg64) -> Vec<Contact> {
    let (half, side) = ((shape.side / 2) as isize, shape.side as isize);
    let wide = shape.overlap() as isize;
    let mut contacts = Vec::new();
    for west in 0..colors {
        for east in 0..colors {
            let band = scattered(half - wide..half + wide, -half..half, PLACES, random);
            let places = band.iter().map(|&(x, y)| [(x, y), (x - side, y)]).collect();
            contacts.push(Contact { sites: [west, east], places });
            let places = band.iter().map(|&(y, x)| [(x, y), (x, y - side)]).collect();
            contacts.push(Contact { sites: [west, east], places });
        }
    }
    contacts
}

impl Corners {
    /// Places the patches and cuts the seams.
    pub fn new(stock: &Stock, shape: Shape, colors: usize, random: &mut Pcg64) -> Self {
        let (sites, contacts) = (sites(stock, shape, colors), contacts(shape, colors, random));
        let moves = shape.moves * colors;
        let settling = Settling::new(stock, &sites, &contacts, random);
        let (patches, _) = settling.walk(moves, random);
        Self::of_patches(stock, shape, patches)
    }

    /// Cuts the seams between given patches.
    pub fn of_patches(stock: &Stock, shape: Shape, patches: Vec<Texel>) -> Self {
        let (colors, stride) = (patches.len(), stock.stride());
        let (beside, above) = (Vec::new(), Vec::new());
        let mut corners = Self { shape, colors, stride, patches, beside, above, price: 0 };
        for pair in 0..colors * colors {
            let (before, after) = (pair / colors, pair % colors);
            let beside = corners.cut(stock, before, after, false);
            corners.beside.push(beside);
            let above = corners.cut(stock, before, after, true);
            corners.above.push(above);
        }
        corners
    }

    /// The texel of a patch, from its lattice point.
    fn patch(&self, color: usize, x: isize, y: isize) -> Texel {
        (self.patches[color] as isize + y * self.stride as isize + x) as Texel
    }

    /// How wide the band of a seam is at some distance from the edge, to one side.
    fn wide(&self, y: isize) -> isize {
        let half = (self.shape.side / 2) as isize;
        // Rows y and -1 - y are alike.
        let from_edge = if y < 0 { -1 - y } else { y };
        (half - 1 - from_edge).min(self.shape.overlap() as isize - 1).max(0)
    }

    /// The seam of a pair: where the second patch shows in the band around it.
    fn cut(&mut self, stock: &Stock, before: usize, after: usize, turned: bool) -> Vec<bool> {
        let (half, side) = ((self.shape.side / 2) as isize, self.shape.side as isize);
        let band = self.shape.overlap() as isize;
        // Along the seam and across it.
        let place = |x: usize, y: usize| {
            let (across, along) = if turned { (y, x) } else { (x, y) };
            (half - band + across as isize, along as isize - half)
        };
        let [width, height] =
            if turned { [side, 2 * band] } else { [2 * band, side] }.map(|n| n as usize);
        let from = |color: usize, shift: isize| {
            Quilt::new(width, height, |x, y| match (place(x, y), turned) {
                ((across, along), false) => self.patch(color, across - shift, along),
                ((across, along), true) => self.patch(color, along, across - shift),
            })
        };
        let (first, second) = (from(before, 0), from(after, side));
        let hold: Vec<Hold> = (0..width * height)
            .map(|at| {
                let (across, along) = place(at % width, at / width);
                let wide = self.wide(along);
                match across - half {
                    far if far < -wide => Hold::First,
                    far if far >= wide => Hold::Second,
                    _ => Hold::Free,
                }
            })
            .collect();
        let woven = weave(stock, &first, &second, &hold);
        self.price += woven.price;
        woven.second
    }

    /// The picture of a tile, from its colors NE, SE, SW, NW.
    pub fn tile(&self, [ne, se, sw, nw]: [u8; 4]) -> Quilt {
        let (side, half) = (self.shape.side as isize, (self.shape.side / 2) as isize);
        let band = self.shape.overlap() as isize;
        let [ne, se, sw, nw] = [ne, se, sw, nw].map(usize::from);
        // In the band of a seam: whether the later patch shows.
        let later = |turned: bool, pair: (usize, usize), across: isize, along: isize| {
            let (across, along) = (across - half + band, along + half);
            let place = if turned { across * side + along } else { along * 2 * band + across };
            let seams = if turned { &self.above } else { &self.beside };
            let seam = &seams[pair.0 * self.colors + pair.1];
            (0..2 * band).contains(&across).then(|| seam[place as usize])
        };
        Quilt::new(self.shape.side, self.shape.side, |x, y| {
            let (x, y) = (x as isize, y as isize);
            let (mut east, mut south) = (x >= half, y >= half);
            // From the middle lines, so that both halves count alike.
            let off = |at: isize| if at < half { half - 1 - at } else { at - half };
            if off(x) < off(y) {
                // The triangle at the north or south edge: columns are divided by its seam.
                let (pair, along) = if south { ((sw, se), y - side) } else { ((nw, ne), y) };
                east = later(false, pair, x, along).unwrap_or(east);
            } else if off(y) < off(x) {
                let (pair, along) = if east { ((ne, se), x - side) } else { ((nw, sw), x) };
                south = later(true, pair, y, along).unwrap_or(south);
            }
            let color = [[nw, ne], [sw, se]][usize::from(south)][usize::from(east)];
            let shift = |far: bool| if far { side } else { 0 };
            self.patch(color, x - shift(east), y - shift(south))
        })
    }

    /// The lattice points, as texels.
    pub fn patches(&self) -> &[Texel] {
        &self.patches
    }
}
