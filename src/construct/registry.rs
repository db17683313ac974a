//! What is known by construction: which sets, on which shapes, by what, and from where.
//!
//! | set | shapes (width x height) | by |
//! |---|---|---|
//! | dominoes, any set | ring | the least ring; Hierholzer's algorithm |
//! | Wang, complete | `CV^2 x CH^2` | product of two rings |
//! | corner, complete | `C^2 x C^2`; others that [`Plan::search`] takes apart | [`super::corner`] |
//! | corner, compact | near-square for 2 to 32 colors; others, see [`compact::covers`] | [`compact`] |
//! | Wang, compact | all | [`compact::wang`] |
//!
//! What is not covered is refused with a reason: that no packing exists, or that no construction
//! is known, which says nothing about packings. Nothing here is verified: see [`crate::verify`].

use super::corner::{CornerTorus, Plan};
use super::wang_product::WangProduct;
use super::{Digraph, Ring, Seed};
use crate::compact;
use crate::tiles::{Kind, Members, TileId, TileSet, Unpacker, notation};
use crate::torus::{Lattice, Packing, Shape};

/// A packing known by construction, not yet written out.
#[derive(Debug, Clone)]
pub struct Constructed {
    set: TileSet,
    shape: Shape,
    name: String,
    source: &'static str,
    unpacker: Unpacker,
    how: How,
}

#[derive(Debug, Clone)]
enum How {
    Ring(Ring),
    Wang(WangProduct),
    Corner(CornerTorus),
    /// All labels.
    Held(Vec<u8>),
}

/// Why there is no construction.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NotConstructed {
    /// There is no packing.
    #[error("{0}")]
    Impossible(String),
    /// Nobody knows, here.
    #[error("no construction is known for {0}")]
    Unknown(String),
}

/// The packing of a set on a torus, if mathematics has one: without a seed the closed form, with
/// one a member of its family.
///
/// # Errors
/// Why there is none.
pub fn construct(
    set: &TileSet,
    shape: Shape,
    seed: Option<u64>,
) -> Result<Constructed, NotConstructed> {
    let number = seed.unwrap_or(0);
    let mut seed = seed.map(Seed::new);
    let unknown = || {
        let members = notation::write_members(set.members());
        let colors = set.colors();
        let what = format!("{} tiles, colors {colors}, set {members}, size {shape}", set.kind());
        NotConstructed::Unknown(what)
    };
    let cells = shape.cells() as u64;
    let fits = set.size() == cells;
    let (how, name, source) = match (set.kind(), set.members()) {
        (Kind::Domino, members) if fits && (shape.width() == 1 || shape.height() == 1) => {
            let palette = set.colors().vertical();
            let (ring, name) = match (members, &seed) {
                (Members::Complete, None) => (Ring::least(palette), "least ring"),
                _ => (circuit(set, seed.as_mut())?, "Eulerian circuit"),
            };
            (How::Ring(ring), name.to_owned(), "Hierholzer 1873")
        }
        (Kind::Wang, Members::Complete) if fits => {
            let (h, v) = (set.colors().horizontal(), set.colors().vertical());
            if shape.width() != v * v || shape.height() != h * h {
                return Err(unknown());
            }
            let product = WangProduct::new(set.colors(), seed);
            (How::Wang(product), "product of two rings".to_owned(), "Wei 2004, section 4")
        }
        (Kind::Corner, Members::Complete) if fits => {
            let (width, height, colors) = (shape.width(), shape.height(), set.colors().largest());
            if colors > 1 && width.min(height) < 3 {
                return Err(NotConstructed::Impossible(format!(
                    "size {shape}: both sides must be at least 3 for all corner tiles over \
                     {colors} colors"
                )));
            }
            let plan = Plan::search(colors, height, width).ok_or_else(unknown)?;
            let torus = plan.build(seed.as_mut());
            let name = torus.name();
            (How::Corner(torus), name, "Hurlbert, Mitchell, Paterson 1996; closed form: tilepack")
        }
        (Kind::Corner | Kind::Wang, Members::Compact) if fits => {
            let found = compact::construct(set, shape, number).ok_or_else(unknown)?;
            (How::Held(found.labels), found.name, "tilepack")
        }
        _ => return Err(unknown()),
    };
    let unpacker = Unpacker::new(set.kind(), set.colors());
    Ok(Constructed { set: set.clone(), shape, name, source, unpacker, how })
}

/// As [`construct`] for all dominoes or all Wang tiles, with the rings of Wei 2004, which hold
/// those over fewer colors: the packing is recursive, its south-west blocks are packings.
///
/// # Errors
/// Why there is none; corner tiles and other sets have no such rings.
pub fn construct_wei(set: &TileSet, shape: Shape) -> Result<Constructed, NotConstructed> {
    let mut made = construct(set, shape, None)?;
    let palette = set.colors().vertical();
    made.name = match (&mut made.how, set.members()) {
        (How::Ring(ring), Members::Complete) => {
            let down = shape.height() > 1;
            *ring = if down { Ring::wei_backward(palette) } else { Ring::wei(palette) };
            "Wei's ring".to_owned()
        }
        (How::Wang(product), _) => {
            *product = WangProduct::wei(set.colors());
            "product of two of Wei's rings".to_owned()
        }
        _ => return Err(NotConstructed::Unknown(format!("{} tiles by Wei's ring", set.kind()))),
    };
    made.source = "Wei 2004, section 4.1";
    Ok(made)
}

/// A ring of the dominoes of a set, by Hierholzer's algorithm.
fn circuit(set: &TileSet, seed: Option<&mut Seed>) -> Result<Ring, NotConstructed> {
    let arcs = set.allowed().map(|tile| {
        let [first, second, ..] = Kind::Domino.unpack(tile, set.colors());
        (first, second)
    });
    let graph = Digraph::new(set.colors().vertical(), arcs.collect());
    Ring::of_digraph(&graph, seed).map_err(|error| NotConstructed::Impossible(error.to_string()))
}

impl Constructed {
    /// The tiles.
    pub fn set(&self) -> &TileSet {
        &self.set
    }

    /// The torus.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The construction, in words.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it comes from.
    pub fn source(&self) -> &str {
        self.source
    }

    /// Writes the labels of a row, see [`Lattice`]: `width` of them, for Wang tiles twice that.
    pub fn row(&self, row: usize, labels: &mut [u8]) {
        match &self.how {
            How::Ring(ring) => {
                let from = row * self.shape.width();
                labels.copy_from_slice(&ring.colors()[from..from + self.shape.width()]);
            }
            How::Wang(product) => {
                let north = product.north(row);
                for (pair, &west) in labels.chunks_exact_mut(2).zip(product.wests()) {
                    pair.copy_from_slice(&[north, west]);
                }
            }
            How::Corner(torus) => torus.row(row, labels),
            How::Held(all) => {
                let length = labels.len();
                labels.copy_from_slice(&all[row * length..(row + 1) * length]);
            }
        }
    }

    /// Gives the labels and tiles of every row, from the north, to `take`, until it fails; two
    /// rows are held in memory.
    ///
    /// # Errors
    /// What `take` reports.
    pub fn try_for_each_row<E>(
        &self,
        mut take: impl FnMut(&[u8], &[TileId]) -> Result<(), E>,
    ) -> Result<(), E> {
        let (width, height) = (self.shape.width(), self.shape.height());
        let per_cell = Lattice { kind: self.set.kind(), shape: self.shape }.per_cell();
        let mut here = vec![0; per_cell * width];
        let mut below = here.clone();
        let mut tiles = Vec::with_capacity(width);
        self.row(0, &mut here);
        for row in 0..height {
            self.row(if row + 1 < height { row + 1 } else { 0 }, &mut below);
            tiles.clear();
            self.number(&here, &below, &mut tiles);
            take(&here, &tiles)?;
            std::mem::swap(&mut here, &mut below);
        }
        Ok(())
    }

    /// The tiles between two rows of labels.
    fn number(&self, here: &[u8], below: &[u8], tiles: &mut Vec<TileId>) {
        let colors = self.set.colors();
        let (h, v) = (colors.horizontal() as u32, colors.vertical() as u32);
        let number = u32::from;
        match self.set.kind() {
            Kind::Domino if self.shape.height() > 1 => {
                tiles.extend(
                    here.iter().zip(below).map(|(&x, &y)| TileId(number(x) * v + number(y))),
                );
            }
            Kind::Domino => {
                let next = here.iter().cycle().skip(1);
                tiles.extend(
                    here.iter().zip(next).map(|(&x, &y)| TileId(number(x) * v + number(y))),
                );
            }
            Kind::Wang => {
                let next = here.chunks_exact(2).cycle().skip(1);
                let cells = here.chunks_exact(2).zip(next).zip(below.chunks_exact(2));
                tiles.extend(cells.map(|((cell, east), south)| {
                    let (n, e) = (number(cell[0]), number(east[1]));
                    TileId(((n * v + e) * h + number(south[0])) * v + number(cell[1]))
                }));
            }
            Kind::Corner => {
                // The west side of a tile is the east side of the one before, moved down.
                let side = |at: usize| (number(here[at]), number(below[at]));
                let tile = |(nw, sw): (u32, u32), (ne, se): (u32, u32)| {
                    TileId(((ne * h + se) * h + sw) * h + nw)
                };
                let last = here.len() - 1;
                tiles.extend((0..last).map(|at| tile(side(at), side(at + 1))));
                tiles.push(tile(side(last), side(0)));
            }
        }
    }

    /// The whole packing: four bytes a cell.
    pub fn packing(&self) -> Packing {
        let mut tiles = Vec::with_capacity(self.shape.cells());
        let all: Result<(), std::convert::Infallible> = self.try_for_each_row(|_, row| {
            tiles.extend_from_slice(row);
            Ok(())
        });
        match all {
            Ok(()) => Packing::new(self.set.clone(), self.shape, false, tiles),
        }
    }

    /// Row and column of a tile, looked up row by row.
    fn look_for(&self, tile: TileId) -> Option<(usize, usize)> {
        let mut row = 0;
        let searched = self.try_for_each_row(|_, tiles| {
            let column = tiles.iter().position(|&other| other == tile);
            row += 1;
            column.map_or(Ok(()), |column| Err((row - 1, column)))
        });
        searched.err()
    }

    /// Row and column of a tile; `None` if it does not occur in the packing.
    #[inline]
    pub fn locate(&self, tile: TileId) -> Option<(usize, usize)> {
        // A packing of a complete set has as many cells as there are numbers.
        let known = match self.set.members() {
            Members::Complete => tile.index() < self.shape.cells(),
            Members::Compact => tile.0 < self.set.kind().tiles(self.set.colors()) as u32,
            _ => self.set.allows(tile),
        };
        if !known {
            return None;
        }
        let [a, b, c, d] = self.unpacker.sides(tile);
        match &self.how {
            How::Ring(ring) => {
                let position = ring.position(a, b)?;
                Some((position / self.shape.width(), position % self.shape.width()))
            }
            How::Wang(product) => Some(product.find(a, b, c, d)),
            // NE, SE, SW, NW.
            How::Corner(torus) => Some(torus.find([[d, a], [c, b]])),
            How::Held(_) => self.look_for(tile),
        }
    }
}
