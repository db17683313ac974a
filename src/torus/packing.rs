//! A packing as files and people have it: a tile in every cell.
//!
//! This type promises nothing about its tiles; whether they fit and whether each occurs as
//! often as the set asks is for [`crate::verify`] to say.

use super::{Board, Cell, Edges, Shape};
use crate::tiles::{Kind, TileId, TileSet, turn};
use std::collections::HashMap;

/// Tiles on a torus or board, claimed to be a packing or covering of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Packing {
    /// The set whose tiles these should be.
    pub set: TileSet,
    /// The width and height.
    pub shape: Shape,
    /// Whether every tile occurs at least once (covering) instead of exactly once (packing).
    pub cover: bool,
    /// The tile of every cell, row by row; a square that is turned as it lies in the set.
    pub tiles: Vec<TileId>,
    /// Which sides meet, what is prescribed at others, and whether tiles are turned.
    pub board: Board,
    /// The quarter turns clockwise of every cell, row by row; empty where no tile may be turned.
    pub turns: Vec<u8>,
}

impl Packing {
    /// Fixed tiles on a torus.
    pub fn new(set: TileSet, shape: Shape, cover: bool, tiles: Vec<TileId>) -> Self {
        Self { set, shape, cover, tiles, board: Board::default(), turns: Vec::new() }
    }

    /// The Wang tiles that a picture of a board shows, its colors in the order of [`Edges`].
    ///
    /// Of squares that cannot be told apart, the first in the set comes first on the board, with
    /// the fewest turns.
    pub fn of_picture(labels: &[u8], set: &TileSet, shape: Shape, board: &Board) -> Self {
        let edges = Edges { shape, topology: board.topology };
        let cells = (0..shape.cells() as u32).map(Cell);
        let shown = cells.map(|cell| {
            let sides = edges.sides(cell).map(|place| labels[place]);
            // What a search met is made of colors of the set.
            Kind::Wang.pack(&sides, set.colors()).unwrap_or(TileId(0))
        });
        let mut packing = Self::new(set.clone(), shape, false, shown.collect());
        packing.board = board.clone();
        if board.rotations {
            packing.lay_squares();
        }
        packing
    }

    /// Takes the tiles for what is shown, and finds squares that show it.
    fn lay_squares(&mut self) {
        let colors = self.set.colors();
        let all_turns = |tile| turn::turns(tile, colors).unwrap_or([tile; 4]);
        let class = |tile| all_turns(tile).into_iter().min();
        let mut squares: HashMap<_, Vec<TileId>> = HashMap::new();
        for square in self.set.allowed() {
            squares.entry(class(square)).or_default().push(square);
        }
        squares.values_mut().for_each(|of_class| of_class.reverse());
        for tile in &mut self.tiles {
            let square = squares.get_mut(&class(*tile)).and_then(Vec::pop).unwrap_or(*tile);
            let turns = all_turns(square).iter().position(|shown| shown == tile).unwrap_or(0);
            self.turns.push(turns as u8);
            *tile = square;
        }
    }

    /// The tile in a cell.
    pub fn tile(&self, cell: Cell) -> TileId {
        self.tiles[cell.index()]
    }

    /// The tiles row by row.
    pub fn rows(&self) -> impl Iterator<Item = &[TileId]> {
        self.tiles.chunks(self.shape.width())
    }
}
