//! Checking a packing of a complete set row by row, when it is too large to hold.
//!
//! A complete set has a packing just when every tile number occurs once, so one bit for each
//! tells whether it has been seen; of the tiles only the first row and the last are kept, for
//! the neighbors across rows and across the seam. The first fault ends the check.

use super::decode::Numbering;
use crate::tiles::{Kind, Members, TileId, TileSet};
use crate::torus::Shape;

/// What is wrong with a packing that comes in rows.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RowFault {
    /// The check does not apply, or the size does not suit the set.
    #[error("size {0}: not that of a packing of a complete set of corner or Wang tiles")]
    Size(Shape),
    /// There is no memory for a bit for every tile.
    #[error("the check needs {0} MB of memory, which cannot be had")]
    Memory(u64),
    /// A row has too many or too few tiles, or there are too many or too few rows.
    #[error("row {0} has a wrong number of tiles, or is missing or one too many")]
    Row(usize),
    /// A tile number is out of range, or occurs again.
    #[error("row {row}, column {column}: tile {tile} is out of range or occurs again")]
    Tile {
        /// From the north.
        row: usize,
        /// From the west.
        column: usize,
        /// The number.
        tile: u32,
    },
    /// A tile does not fit its neighbor to the west or to the north.
    #[error("row {row}, column {column}: the tile does not fit its neighbor")]
    Neighbor {
        /// From the north.
        row: usize,
        /// From the west.
        column: usize,
    },
}

/// A check that rows are given to, from the north.
#[derive(Debug)]
pub struct RowCheck {
    numbering: Numbering,
    shape: Shape,
    seen: Vec<u64>,
    /// The colors of the tiles of the first row and of the last one given.
    first: Vec<[u8; 4]>,
    above: Vec<[u8; 4]>,
    rows: usize,
}

impl RowCheck {
    /// The check of a packing of a complete set of corner or Wang tiles on this torus.
    ///
    /// # Errors
    /// Another set or size; no memory.
    pub fn new(set: &TileSet, shape: Shape) -> Result<Self, RowFault> {
        let numbering = Numbering::new(set);
        let complete = *set.members() == Members::Complete && set.kind() != Kind::Domino;
        if !complete || numbering.universe() != shape.cells() as u64 {
            return Err(RowFault::Size(shape));
        }
        let words = shape.cells().div_ceil(64);
        let mut seen = Vec::new();
        let room = seen.try_reserve_exact(words);
        room.map_err(|_| RowFault::Memory((words as u64 * 8).div_ceil(1_000_000)))?;
        seen.resize(words, 0);
        Ok(Self { numbering, shape, seen, first: Vec::new(), above: Vec::new(), rows: 0 })
    }

    /// Checks the next row.
    ///
    /// # Errors
    /// The first fault.
    pub fn row(&mut self, tiles: &[TileId]) -> Result<(), RowFault> {
        let row = self.rows;
        if tiles.len() != self.shape.width() || row >= self.shape.height() {
            return Err(RowFault::Row(row));
        }
        for (column, &TileId(tile)) in tiles.iter().enumerate() {
            let (word, bit) = (tile as usize / 64, 1 << (tile % 64));
            if u64::from(tile) >= self.numbering.universe() || self.seen[word] & bit != 0 {
                return Err(RowFault::Tile { row, column, tile });
            }
            self.seen[word] |= bit;
        }
        let here: Vec<_> = tiles.iter().map(|&tile| self.numbering.digits(tile)).collect();
        let east = here.iter().cycle().skip(1);
        if let Some(column) = here.iter().zip(east).position(|(w, e)| !self.fit_across(w, e)) {
            return Err(RowFault::Neighbor { row, column });
        }
        if row == 0 {
            self.first.clone_from(&here);
        } else {
            self.check_down(row, &self.above, &here)?;
        }
        self.above = here;
        self.rows += 1;
        Ok(())
    }

    /// Checks the seam between the last row and the first; every row has been given.
    ///
    /// # Errors
    /// The first fault.
    pub fn finish(self) -> Result<(), RowFault> {
        if self.rows != self.shape.height() {
            return Err(RowFault::Row(self.rows));
        }
        self.check_down(0, &self.above, &self.first)
    }

    fn check_down(&self, row: usize, n: &[[u8; 4]], s: &[[u8; 4]]) -> Result<(), RowFault> {
        match n.iter().zip(s).position(|(n, s)| !self.fit_down(n, s)) {
            Some(column) => Err(RowFault::Neighbor { row, column }),
            None => Ok(()),
        }
    }

    /// Whether the east side of one tile is the west side of the next.
    fn fit_across(&self, west: &[u8; 4], east: &[u8; 4]) -> bool {
        match self.numbering.kind() {
            // NE, SE, SW, NW.
            Kind::Corner => west[0] == east[3] && west[1] == east[2],
            // N, E, S, W.
            _ => west[1] == east[3],
        }
    }

    /// Whether the south side of one tile is the north side of the one below.
    fn fit_down(&self, north: &[u8; 4], south: &[u8; 4]) -> bool {
        match self.numbering.kind() {
            Kind::Corner => north[1] == south[0] && north[2] == south[3],
            _ => north[2] == south[0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles::Colors;

    /// The packing of the 16 corner tiles over two colors.
    fn tiles() -> Vec<Vec<TileId>> {
        const BASE: [[u32; 4]; 4] = [[0, 0, 0, 1], [0, 0, 1, 0], [1, 0, 1, 1], [0, 1, 1, 1]];
        let at = |row: usize, column: usize| BASE[row % 4][column % 4];
        let tile = |r, c| ((at(r, c + 1) * 2 + at(r + 1, c + 1)) * 2 + at(r + 1, c)) * 2 + at(r, c);
        (0..4).map(|r| (0..4).map(|c| TileId(tile(r, c))).collect()).collect()
    }

    fn check(rows: &[Vec<TileId>]) -> Result<(), RowFault> {
        let set = TileSet::new(Kind::Corner, Colors::one(2).unwrap(), Members::Complete).unwrap();
        let mut check = RowCheck::new(&set, Shape::new(4, 4).unwrap())?;
        rows.iter().try_for_each(|row| check.row(row))?;
        check.finish()
    }

    #[test]
    fn the_right_one_and_wrong_ones() {
        assert_eq!(check(&tiles()), Ok(()));
        let change = |change: &dyn Fn(&mut Vec<Vec<TileId>>)| {
            let mut rows = tiles();
            change(&mut rows);
            check(&rows).unwrap_err()
        };
        assert!(matches!(change(&|rows| rows[2][1] = rows[0][0]), RowFault::Tile { row: 2, .. }));
        assert!(matches!(change(&|rows| rows[3][3] = TileId(16)), RowFault::Tile { row: 3, .. }));
        assert!(matches!(change(&|rows| rows[1].swap(0, 2)), RowFault::Neighbor { row: 1, .. }));
        assert!(matches!(change(&|rows| rows.swap(0, 1)), RowFault::Neighbor { .. }));
        assert_eq!(change(&|rows| rows.truncate(3)), RowFault::Row(3));
        assert_eq!(change(&|rows| rows[1].truncate(3)), RowFault::Row(1));
        assert_eq!(change(&|rows| rows.push(rows[0].clone())), RowFault::Row(4));
    }

    #[test]
    fn every_seam_counts() {
        // Rows in another order that still are all tiles: rotated by one row is still right.
        let mut rows = tiles();
        rows.rotate_left(1);
        assert_eq!(check(&rows), Ok(()));
        rows.swap(0, 3);
        assert!(check(&rows).is_err());
    }
}
