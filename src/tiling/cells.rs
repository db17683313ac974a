//! Where the tiles of a tiling lie in a packing: by table, or in closed form.
//!
//! A table works for every packing; of a covering it takes the first cell of each tile. The closed
//! forms are those of [`crate::construct`] for complete sets on their square torus (Wang tiles:
//! `CV^2` x `CH^2`), without a seed: a shader computes them, and needs no table. They are only right
//! for that very packing, so it is compared cell by cell.

use super::{Tiling, TilingError};
use crate::construct::{corner_even, corner_odd, ring};
use crate::tiles::{Colors, Kind, Members, TileId};
use crate::torus::{Cell, Packing, Shape};

/// A closed form from the colors of a tile to its cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formula {
    /// Wang tiles: the column is the place of (W, E) in the least ring, the row that of (N, S).
    Wang,
    /// Corner tiles over an odd number of colors.
    CornerOdd,
    /// Corner tiles over an even number of colors.
    CornerEven,
}

impl Formula {
    /// The form for complete sets of a kind.
    pub fn of(kind: Kind, colors: Colors) -> Option<Self> {
        match kind {
            Kind::Wang => Some(Formula::Wang),
            Kind::Corner if colors.horizontal() < 2 => None,
            Kind::Corner if colors.horizontal().is_multiple_of(2) => Some(Formula::CornerEven),
            Kind::Corner => Some(Formula::CornerOdd),
            Kind::Domino => None,
        }
    }

    /// Row and column of the tile with these sides, each below its number of colors.
    pub fn find(self, colors: Colors, [a, b, c, d]: [u8; 4]) -> (usize, usize) {
        let (h, v) = (colors.horizontal(), colors.vertical());
        match self {
            // N, E, S, W.
            Formula::Wang => (ring::least_position(h, a, c), ring::least_position(v, d, b)),
            // NE, SE, SW, NW.
            Formula::CornerOdd => corner_odd::find(h, [[d, a], [c, b]]),
            Formula::CornerEven => corner_even::find(h, [[d, a], [c, b]]),
        }
    }
}

/// How a tile is looked up.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Lookup {
    /// Tiles in order, each with its first cell.
    Table(Vec<(TileId, Cell)>),
    /// A closed form.
    Formula(Formula),
}

/// The cells of a packing, by their tiles.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cells {
    kind: Kind,
    colors: Colors,
    shape: Shape,
    lookup: Lookup,
}

impl Cells {
    /// A table of the cells of a packing or covering.
    pub fn table(packing: &Packing) -> Self {
        let cells = (0..packing.tiles.len() as u32).map(Cell);
        let mut table: Vec<_> = packing.tiles.iter().copied().zip(cells).collect();
        table.sort_unstable();
        table.dedup_by_key(|(tile, _)| *tile);
        Self::by(packing, Lookup::Table(table))
    }

    /// The closed form of a packing.
    ///
    /// # Errors
    /// A packing that is not the constructed one, with the first cell that differs.
    pub fn formula(packing: &Packing) -> Result<Self, TilingError> {
        let (set, shape) = (&packing.set, packing.shape);
        let (kind, colors) = (set.kind(), set.colors());
        let not = |why: String| Err(TilingError::NotTheFormula(why));
        let formula = match (Formula::of(kind, colors), set.members()) {
            (Some(formula), Members::Complete) => formula,
            _ => return not("only those of complete corner and Wang sets have one".to_owned()),
        };
        if Shape::default_for(set).ok() != Some(shape) {
            let (h, v) = (colors.horizontal().pow(2), colors.vertical().pow(2));
            return not(format!("its size is {shape}, expected {v}x{h}"));
        }
        for cell in (0..shape.cells() as u32).map(Cell) {
            let tile = packing.tile(cell);
            let (row, column) = formula.find(colors, kind.unpack(tile, colors));
            if shape.cell(row, column) != cell {
                let (here, at) = shape.position(cell);
                return not(format!(
                    "row {here}, column {at} has tile {tile}, which the formula puts into row \
                     {row}, column {column}"
                ));
            }
        }
        Ok(Self::by(packing, Lookup::Formula(formula)))
    }

    fn by(packing: &Packing, lookup: Lookup) -> Self {
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        Self { kind, colors, shape: packing.shape, lookup }
    }

    /// The kind of tiles.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The numbers of colors.
    pub fn colors(&self) -> Colors {
        self.colors
    }

    /// The torus.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The closed form, where there is no table.
    pub fn as_formula(&self) -> Option<Formula> {
        match self.lookup {
            Lookup::Formula(formula) => Some(formula),
            Lookup::Table(_) => None,
        }
    }

    /// Row and column of a tile; `None` if it is not in the packing.
    pub fn find(&self, tile: TileId) -> Option<(usize, usize)> {
        match &self.lookup {
            Lookup::Table(table) => {
                let at = table.binary_search_by_key(&tile, |(tile, _)| *tile).ok()?;
                Some(self.shape.position(table[at].1))
            }
            Lookup::Formula(formula) => {
                let known = u64::from(tile.0) < self.kind.tiles(self.colors);
                known.then(|| formula.find(self.colors, self.kind.unpack(tile, self.colors)))
            }
        }
    }

    /// The row and column of a tile for all tiles that a tiling can show.
    ///
    /// # Errors
    /// Another kind or other colors, or a tile that the packing lacks.
    pub fn check(&self, tiling: &Tiling) -> Result<(), TilingError> {
        let words = |kind: Kind, colors: Colors| format!("{kind} tiles over {colors} colors");
        if (self.kind, self.colors) != (tiling.kind(), tiling.colors()) {
            return Err(TilingError::OtherPacking {
                packing: words(self.kind, self.colors),
                tiling: words(tiling.kind(), tiling.colors()),
            });
        }
        let missing = match (tiling.needs(), &self.lookup) {
            // A formula is of the complete set.
            (_, Lookup::Formula(_)) => None,
            (Members::Explicit(tiles), _) => {
                tiles.into_iter().find(|&tile| self.find(tile).is_none())
            }
            (_, Lookup::Table(table)) => {
                // Tiles are in order, so the first gap is the first that is missing.
                let all = self.kind.tiles(self.colors);
                let gap =
                    table.iter().zip(0u32..).find(|((tile, _), expected)| tile.0 != *expected);
                let first = gap.map_or(table.len() as u64, |(_, expected)| u64::from(expected));
                (first < all).then_some(TileId(first as u32))
            }
        };
        match missing {
            Some(tile) => Err(TilingError::MissingTile {
                tile: tile.0,
                sides: self.kind.describe(tile, self.colors),
                needs: tiling.needs_words(),
            }),
            None => Ok(()),
        }
    }
}
