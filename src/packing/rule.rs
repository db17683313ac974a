//! Which tiles a window may still become: the law of the set, kept while the search runs.
//!
//! A *row* is the index of three known corners, in the order of
//! [`Window`](super::corner_plan::Window); the tiles of a row are the colors of the free corner,
//! the bits of one word.

use super::table::Table;

/// The law of a tile set.
pub trait Rule: Clone + Send + Sync {
    /// Whether [`Rule::open`] alone decides, for a single window. Otherwise every candidate is
    /// tried out.
    const EXACT: bool;

    /// The tiles of a row that may be placed.
    fn open(&self, row: usize) -> u64;

    /// Places a tile.
    fn take(&mut self, row: usize, tile: u32);

    /// Takes back a tile placed.
    fn release(&mut self, row: usize, tile: u32);

    /// Whether what has been placed may belong to a solution.
    fn holds(&self) -> bool {
        true
    }
}

/// Every tile exactly once.
#[derive(Debug, Clone)]
pub struct Once<const ROWS: usize> {
    free: Table<u64, ROWS>,
}

impl<const ROWS: usize> Once<ROWS> {
    /// All `allowed` tiles are free.
    pub fn new(allowed: Vec<u64>) -> Self {
        Self { free: Table::new(allowed, 0) }
    }
}

impl<const ROWS: usize> Rule for Once<ROWS> {
    const EXACT: bool = true;

    #[inline(always)]
    fn open(&self, row: usize) -> u64 {
        self.free[row]
    }

    #[inline(always)]
    fn take(&mut self, row: usize, tile: u32) {
        self.free[row] &= !(1 << tile);
    }

    #[inline(always)]
    fn release(&mut self, row: usize, tile: u32) {
        self.free[row] |= 1 << tile;
    }
}

/// Two different tiles of every row, each once: a compact set chosen by the search.
#[derive(Debug, Clone)]
pub struct Pairs<const ROWS: usize> {
    allowed: Table<u64, ROWS>,
    taken: Table<u64, ROWS>,
}

impl<const ROWS: usize> Pairs<ROWS> {
    /// Nothing is taken.
    pub fn new(allowed: Vec<u64>) -> Self {
        Self { allowed: Table::new(allowed, 0), taken: Table::new(Vec::new(), 0) }
    }
}

impl<const ROWS: usize> Rule for Pairs<ROWS> {
    const EXACT: bool = true;

    #[inline(always)]
    fn open(&self, row: usize) -> u64 {
        let taken = self.taken[row];
        let fewer_than_two = taken & taken.wrapping_sub(1) == 0;
        if fewer_than_two { self.allowed[row] & !taken } else { 0 }
    }

    #[inline(always)]
    fn take(&mut self, row: usize, tile: u32) {
        self.taken[row] |= 1 << tile;
    }

    #[inline(always)]
    fn release(&mut self, row: usize, tile: u32) {
        self.taken[row] &= !(1 << tile);
    }
}

/// Every tile at least once; with a limit, that many different tiles of every row, whichever.
///
/// The law is kept by counting *spare* cells: a torus with more cells than tiles allows that
/// many repetitions and no more.
#[derive(Debug, Clone)]
pub struct Cover<const ROWS: usize> {
    allowed: Table<u64, ROWS>,
    taken: Table<u64, ROWS>,
    uses: Vec<u32>,
    spare: i64,
    /// Different tiles of a row at most.
    limit: u32,
}

impl<const ROWS: usize> Cover<ROWS> {
    /// Nothing is taken; `spare` is the number of cells beyond the number of tiles.
    pub fn new(allowed: Vec<u64>, spare: u64, limit: Option<u32>) -> Self {
        Self {
            uses: vec![0; 64 * allowed.len()],
            allowed: Table::new(allowed, 0),
            taken: Table::new(Vec::new(), 0),
            spare: spare as i64,
            limit: limit.unwrap_or(u64::BITS),
        }
    }
}

impl<const ROWS: usize> Rule for Cover<ROWS> {
    const EXACT: bool = false;

    fn open(&self, row: usize) -> u64 {
        let taken = self.taken[row];
        let fresh = if taken.count_ones() < self.limit { self.allowed[row] & !taken } else { 0 };
        if self.spare > 0 { fresh | taken } else { fresh }
    }

    fn take(&mut self, row: usize, tile: u32) {
        let uses = &mut self.uses[64 * row + tile as usize];
        *uses += 1;
        if *uses == 1 {
            self.taken[row] |= 1 << tile;
        } else {
            self.spare -= 1;
        }
    }

    fn release(&mut self, row: usize, tile: u32) {
        let uses = &mut self.uses[64 * row + tile as usize];
        *uses -= 1;
        if *uses == 0 {
            self.taken[row] &= !(1 << tile);
        } else {
            self.spare += 1;
        }
    }

    fn holds(&self) -> bool {
        self.spare >= 0
    }
}
