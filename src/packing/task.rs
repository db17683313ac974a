//! The question a search answers: which packings, of what, where, with what given beforehand.
//!
//! A task is checked once, here; the problems built from it may rely on what is checked.

use super::last_lines;
use super::prunings::Prunings;
use super::{board_impossible, impossible};
use crate::symmetry::{Automorphism, AutomorphismError};
use crate::tiles::{Colors, Kind, TileSet};
use crate::torus::board::{Border, BorderError, SIDES};
use crate::torus::{Board, Edges, Lattice, Order, Packing, Pins, Shape};

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
    /// The width and height.
    pub shape: Shape,
    /// What the packing lies on: a torus of fixed tiles, or a board.
    pub board: Board,
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
    /// Boards and squares are for Wang tiles.
    #[error("{0} tiles lie on a torus and are not turned: {1} for Wang tiles")]
    NotWang(Kind, &'static str),
    /// What a board does not go with.
    #[error("{what} on a torus of tiles that are not turned only, not {on}")]
    TorusOnly {
        /// The condition.
        what: &'static str,
        /// The board.
        on: String,
    },
    /// The tiles that squares show, with two palettes.
    #[error("colors {0}: squares that may be turned have one number of colors for all edges")]
    Palettes(Colors),
    /// More different tiles than the search chooses from.
    #[error(
        "the squares show up to {0} different tiles: the search handles up to {MAX_WANG_TILES}"
    )]
    TooManyTurns(u64),
    /// A prescribed color is none of the set.
    #[error("border: color {color} in the {side}, expected 0 to {max}")]
    BorderColor {
        /// The color.
        color: u8,
        /// The side.
        side: &'static str,
        /// The largest color there.
        max: usize,
    },
    /// The border does not suit the board.
    #[error(transparent)]
    Border(#[from] BorderError),
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
        Self::on(set, shape, Board::default())
    }

    /// A task on a board without anything else given beforehand.
    pub fn on(set: TileSet, shape: Shape, board: Board) -> Self {
        let pins = match board.is_plain() {
            true => Pins::free(Lattice { kind: set.kind(), shape }),
            false => Pins::free_labels(Edges { shape, topology: board.topology }.labels()),
        };
        let prunings = Prunings::default();
        let (automorphism, order) = (None, None);
        Self { set, shape, board, cover: false, automorphism, pins, order, prunings }
    }

    /// The places of the colors of the board asked for.
    pub fn edges(&self) -> Edges {
        Edges { shape: self.shape, topology: self.board.topology }
    }

    /// The number of labels of a packing.
    pub fn labels(&self) -> usize {
        self.pins.labels().len()
    }

    /// The packing that labels, as a search gives them, describe.
    pub fn packing(&self, labels: &[u8]) -> Packing {
        match self.board.is_plain() {
            true => self.lattice().packing(labels, &self.set, self.cover),
            false => Packing::of_picture(labels, &self.set, self.shape, &self.board),
        }
    }

    /// The label positions of the packing asked for, on a torus.
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
        if !self.board.is_plain() {
            return self.order.unwrap_or(if w <= h { Order::Row } else { Order::Column });
        }
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
        self.check_board()?;
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

    fn check_board(&self) -> Result<(), TaskError> {
        let Self { set, shape, board, .. } = self;
        let Board { topology, rotations, border } = board;
        if board.is_plain() {
            return Ok(());
        }
        if set.kind() != Kind::Wang {
            let what = if *rotations { "rotations are" } else { "other boards are" };
            return Err(TaskError::NotWang(set.kind(), what));
        }
        let conditions = [
            (self.cover, "coverings are"),
            (self.automorphism.is_some(), "automorphisms are"),
            (set.is_compact(), "compact sets are"),
        ];
        if let Some((_, what)) = conditions.into_iter().find(|(asked, _)| *asked) {
            let turned = if *rotations { " of squares that are turned" } else { "" };
            return Err(TaskError::TorusOnly { what, on: format!("on a {topology}{turned}") });
        }
        if *rotations {
            if set.colors().single().is_none() {
                return Err(TaskError::Palettes(set.colors()));
            }
            if 4 * set.size() > MAX_WANG_TILES {
                return Err(TaskError::TooManyTurns(4 * set.size()));
            }
        }
        let sides: [Vec<_>; 4] = std::array::from_fn(|side| border.side(side).to_vec());
        for (side, colors) in sides.iter().enumerate() {
            let palette = match side % 2 {
                0 => set.colors().horizontal(),
                _ => set.colors().vertical(),
            };
            if let Some(color) = colors.iter().flatten().find(|&&c| usize::from(c) >= palette) {
                let (color, side, max) = (*color, SIDES[side], palette - 1);
                return Err(TaskError::BorderColor { color, side, max });
            }
        }
        Border::new(*topology, *shape, sides)?;
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
        match self.board.is_plain() {
            true => impossible::reason(self),
            false => board_impossible::reason(self),
        }
    }
}

/// How many different tiles may occur: for a compact set, all over its colors.
pub(super) fn tiles_to_choose(set: &TileSet) -> u64 {
    if set.is_compact() { set.kind().tiles(set.colors()) } else { set.size() }
}
