//! The question a search answers: which packings, of what, where, with what given beforehand.
//!
//! A task is checked once, here; the problems built from it may rely on what is checked.

use super::impossible;
use super::last_lines;
use super::prunings::Prunings;
use crate::symmetry::{Automorphism, AutomorphismError};
use crate::tiles::{Kind, TileSet};
use crate::torus::{Lattice, Order, Pins, Shape};

/// The largest number of colors the search handles: the colors of a cell are one word.
pub const MAX_SEARCH_COLORS: usize = 64;

/// The largest number of cells of a corner packing the search handles.
pub const MAX_CORNER_CELLS: usize = 65_535;

/// The largest number of cells of a Wang packing, or dominoes of a ring, the search handles.
pub const MAX_WANG_CELLS: usize = 8_191;

/// The largest number of Wang tiles, or dominoes, the search chooses from.
pub const MAX_WANG_TILES: u64 = 4_096;

/// A question about packings.
#[derive(Debug, Clone)]
pub struct Task {
    /// The tiles.
    pub set: TileSet,
    /// The torus.
    pub shape: Shape,
    /// Every tile at least once instead of exactly once.
    pub cover: bool,
    /// A symmetry the packing must have.
    pub automorphism: Option<Automorphism>,
    /// Labels given beforehand.
    pub pins: Pins,
    /// The visiting order; `None` leaves the choice to the program.
    pub order: Option<Order>,
    /// What cuts the tree, for corner tiles.
    pub prunings: Prunings,
}

/// Why a question cannot be asked.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TaskError {
    /// The number of cells does not suit the set.
    #[error("size {shape} has {cells} cells, but the set has {tiles} tiles{hint}")]
    Size {
        /// The torus asked for.
        shape: Shape,
        /// Its cells.
        cells: u64,
        /// The tiles of the set.
        tiles: u64,
        /// What would suit.
        hint: &'static str,
    },
    /// Too many cells for the search.
    #[error("size {shape} has {cells} cells: the search handles up to {most}")]
    TooManyCells {
        /// The torus asked for.
        shape: Shape,
        /// Its cells.
        cells: usize,
        /// The largest number handled.
        most: usize,
    },
    /// Too many colors for the search.
    #[error("{0} colors: the search handles up to {MAX_SEARCH_COLORS}")]
    TooManyColors(usize),
    /// Too many Wang tiles for the search.
    #[error("{0} different tiles may occur: the search handles up to {MAX_WANG_TILES}")]
    TooManyTiles(u64),
    /// A ring of dominoes has one side of length 1.
    #[error("size {0}: dominoes form a ring, so one side must be 1")]
    NotARing(Shape),
    /// Prunings asked for what is not corner tiles.
    #[error("prunings {0}: only searches for corner tiles have any to choose")]
    Prunings(Prunings),
    /// Last lines that cannot be looked at.
    #[error(
        "pruning last-rows: only for packings (no coverings) of up to {} cells over 2 to {} colors, in row or column order",
        last_lines::MOST_CELLS,
        last_lines::MOST_COLORS
    )]
    LastLines,
    /// The automorphism does not suit.
    #[error(transparent)]
    Automorphism(#[from] AutomorphismError),
    /// The pins alone break a rule.
    #[error("contradictory pins: {0}")]
    Pins(String),
}

impl Task {
    /// A task without anything given beforehand.
    pub fn new(set: TileSet, shape: Shape) -> Self {
        let pins = Pins::free(Lattice { kind: set.kind(), shape });
        Self {
            set,
            shape,
            cover: false,
            automorphism: None,
            pins,
            order: None,
            prunings: Prunings::default(),
        }
    }

    /// The label positions of the packing asked for.
    pub fn lattice(&self) -> Lattice {
        Lattice { kind: self.set.kind(), shape: self.shape }
    }

    /// Whether any label is given beforehand.
    pub fn has_pins(&self) -> bool {
        self.pins.labels().iter().any(Option::is_some)
    }

    /// The visiting order: the one asked for, or else the one that measured best.
    ///
    /// The frontier should be short: along the short side of the torus, or of the cells that
    /// an automorphism leaves to choose. Compact corner sets do better along the long side, and
    /// Wang tiles by columns.
    pub fn visiting_order(&self) -> Order {
        let (w, h) = (self.shape.width(), self.shape.height());
        self.order.unwrap_or(match (self.set.kind(), &self.automorphism) {
            (Kind::Corner, Some(automorphism)) if automorphism.dx == 0 => Order::Column,
            (Kind::Corner, Some(_)) => Order::Row,
            (Kind::Corner, None) if self.set.is_compact() || w <= h => Order::Row,
            (Kind::Domino, _) => Order::Row,
            _ => Order::Column,
        })
    }

    /// Checks that the question makes sense.
    ///
    /// # Errors
    /// Too many colors, a size that does not suit the set, an automorphism that does not suit.
    pub fn check(&self) -> Result<(), TaskError> {
        Self::check_size(&self.set, self.shape)?;
        let ring = self.shape.width() == 1 || self.shape.height() == 1;
        if self.set.kind() == Kind::Domino && !ring {
            return Err(TaskError::NotARing(self.shape));
        }
        let (cells, tiles) = (self.shape.cells() as u64, self.set.size());
        if if self.cover { cells < tiles } else { cells != tiles } {
            let hint = match self.cover {
                true => ": a covering needs at least as many cells",
                false => ": a packing needs exactly as many cells",
            };
            return Err(TaskError::Size { shape: self.shape, cells, tiles, hint });
        }
        self.check_prunings()?;
        if let Some(automorphism) = &self.automorphism {
            automorphism.check(&self.set, self.shape, self.cover)?;
        }
        Ok(())
    }

    fn check_prunings(&self) -> Result<(), TaskError> {
        let Self { prunings, set, shape, .. } = self;
        if set.kind() != Kind::Corner && *prunings != Prunings::default() {
            return Err(TaskError::Prunings(*prunings));
        }
        let in_lines = matches!(self.visiting_order(), Order::Row | Order::Column);
        let small = (2..=last_lines::MOST_COLORS).contains(&set.colors().largest())
            && shape.cells() <= last_lines::MOST_CELLS;
        if prunings.last_lines && (self.cover || !in_lines || !small) {
            return Err(TaskError::LastLines);
        }
        Ok(())
    }

    /// Checks that the tables of the search hold a problem; a task keeps something for every
    /// cell, so this comes before there is one.
    ///
    /// # Errors
    /// Too many colors, cells or tiles.
    pub fn check_size(set: &TileSet, shape: Shape) -> Result<(), TaskError> {
        let colors = set.colors().largest();
        if colors > MAX_SEARCH_COLORS {
            return Err(TaskError::TooManyColors(colors));
        }
        let (cells, tiles) = (shape.cells(), tiles_to_choose(set));
        let most = match set.kind() {
            Kind::Corner => MAX_CORNER_CELLS,
            _ if tiles > MAX_WANG_TILES => return Err(TaskError::TooManyTiles(tiles)),
            Kind::Wang | Kind::Domino => MAX_WANG_CELLS,
        };
        if cells > most {
            return Err(TaskError::TooManyCells { shape, cells, most });
        }
        Ok(())
    }

    /// Why there is plainly no solution, when a short argument shows it.
    pub fn impossible(&self) -> Option<String> {
        impossible::reason(self)
    }
}

/// How many different tiles may occur: for a compact set, all over its colors.
pub(super) fn tiles_to_choose(set: &TileSet) -> u64 {
    if set.is_compact() { set.kind().tiles(set.colors()) } else { set.size() }
}
