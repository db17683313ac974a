//! The verdict on a small set by strips of at most four rows or columns, without memory to be
//! asked for: most sets are decided here, in microseconds.
//!
//! Strips are lists of columns with packed labels. Columns to which nothing leads or from which
//! nothing goes on are cut; when no column is left, there is no tiling, and when one is left
//! among those that fit below themselves, there is one with a period.

use crate::aperiodic::decide::Tile;

/// Bits of a label at most.
const BITS: u32 = 4;
/// Rows of a strip at most.
const HEIGHT: u32 = 4;
/// Columns of a strip at most.
const MOST: usize = 1 << 12;

/// A column of tiles: N of the highest, S of the lowest, and the labels of both sides.
#[derive(Debug, Clone, Copy)]
struct Column {
    north: u8,
    south: u8,
    west: u16,
    east: u16,
}

/// Memory that is used again.
#[derive(Debug, Default)]
pub struct Quick {
    columns: Vec<Column>,
    next: Vec<Column>,
    closed: Vec<Column>,
    leaving: Vec<u16>,
    entering: Vec<u16>,
    /// Bits of a label.
    bits: u32,
}

impl Quick {
    /// Whether the tiles fill the plane; `None` when four rows do not suffice, or there are more
    /// than sixteen labels in a space.
    pub fn decide(&mut self, tiles: &[Tile]) -> Option<bool> {
        let largest = tiles.iter().flatten().max().copied().unwrap_or(0);
        if largest >= 1 << BITS {
            return None;
        }
        self.bits = (u32::BITS - largest.leading_zeros()).max(1);
        let column = |&[n, e, s, w]: &Tile| {
            let (west, east) = (w as u16, e as u16);
            Column { north: n as u8, south: s as u8, west, east }
        };
        let turn = |&[n, e, s, w]: &Tile| [w, s, e, n];
        let first: [Vec<Column>; 2] = [
            tiles.iter().map(column).collect(),
            tiles.iter().map(turn).map(|tile| column(&tile)).collect(),
        ];
        let mut strips = first.clone();
        for height in 1..=HEIGHT {
            for (strip, tiles) in strips.iter_mut().zip(&first) {
                if let Some(verdict) = self.step(strip, tiles, height) {
                    return Some(verdict);
                }
            }
        }
        None
    }

    /// Makes a strip of this height of one that is lower by one.
    fn step(&mut self, strip: &mut Vec<Column>, tiles: &[Column], height: u32) -> Option<bool> {
        if height > 1 {
            if strip.len() * tiles.len() > MOST {
                // Too many; the strip stays, to be too many again.
                return None;
            }
            let bits = self.bits;
            self.next.clear();
            for upper in strip.iter() {
                let below = tiles.iter().filter(|tile| tile.north == upper.south);
                self.next.extend(below.map(|tile| Column {
                    north: upper.north,
                    south: tile.south,
                    west: upper.west << bits | tile.west,
                    east: upper.east << bits | tile.east,
                }));
            }
            std::mem::swap(strip, &mut self.next);
        }
        std::mem::swap(&mut self.columns, strip);
        let mut columns = std::mem::take(&mut self.columns);
        self.cut(&mut columns, height);
        std::mem::swap(&mut columns, strip);
        self.columns = columns;
        if strip.is_empty() {
            return Some(false);
        }
        let mut closed = std::mem::take(&mut self.closed);
        closed.clear();
        closed.extend(strip.iter().filter(|column| column.north == column.south));
        self.cut(&mut closed, height);
        let periodic = !closed.is_empty();
        self.closed = closed;
        periodic.then_some(true)
    }

    /// Removes columns to which nothing leads or from which nothing goes on.
    fn cut(&mut self, columns: &mut Vec<Column>, height: u32) {
        let states = 1usize << (self.bits * height);
        loop {
            let before = columns.len();
            for counts in [&mut self.leaving, &mut self.entering] {
                counts.clear();
                counts.resize(states, 0);
            }
            let (mut above, mut below) = (0u32, 0u32);
            for column in columns.iter() {
                self.leaving[usize::from(column.west)] += 1;
                self.entering[usize::from(column.east)] += 1;
                above |= 1 << column.south;
                below |= 1 << column.north;
            }
            columns.retain(|column| {
                self.leaving[usize::from(column.east)] > 0
                    && self.entering[usize::from(column.west)] > 0
                    && above & 1 << column.north != 0
                    && below & 1 << column.south != 0
            });
            if columns.len() == before {
                return;
            }
        }
    }
}
