//! Counts of colors and dominoes: the most valuable pruning.
//!
//! Every lattice point is the NW corner of one window, every horizontal domino the top of one
//! and every vertical domino the left of one. So a packing shows each color and each domino
//! exactly as often as the tiles of the set do: in a complete set every color `C^3` times and
//! every domino `C^2` times, in a compact one `2C^2` and `2C` times. What has been used up
//! leaves the candidates. A covering may exceed the counts by its spare cells.
//!
//! The caps follow from the law of the set; they only show contradictions earlier (compact
//! C = 3: 2,217 nodes to the first packing instead of 581,558).

use super::corner_plan::Window;

/// How often colors and dominoes may still occur.
#[derive(Debug, Clone)]
pub struct Caps {
    shift: u32,
    color: Vec<i32>,
    across: Vec<i32>,
    along: Vec<i32>,
    color_open: u64,
    across_open: Vec<u64>,
    along_open: Vec<u64>,
    /// Counts below zero.
    excess: u32,
}

impl Caps {
    /// Counts the colors and dominoes of `tiles`, given as the colors of a window's known
    /// corners and free corner, each `weight` times, and allows `spare` more of each.
    pub fn new(
        shift: u32,
        tiles: impl Iterator<Item = [u8; 4]>,
        weight: (i32, i32),
        spare: i32,
    ) -> Self {
        let side = 1usize << shift;
        let mut caps = Self {
            shift,
            color: vec![0; side],
            across: vec![0; side * side],
            along: vec![0; side * side],
            color_open: 0,
            across_open: vec![0; side],
            along_open: vec![0; side],
            excess: 0,
        };
        for [_, b, c, free] in tiles {
            caps.color[usize::from(free)] += 1;
            caps.across[usize::from(c) << shift | usize::from(free)] += 1;
            caps.along[usize::from(b) << shift | usize::from(free)] += 1;
        }
        // A compact set takes the same share of the tiles of every color and domino.
        let (take, of) = weight;
        for count in caps.color.iter_mut().chain(&mut caps.across).chain(&mut caps.along) {
            if *count > 0 {
                *count = *count * take / of + spare;
            }
        }
        for color in 0..side {
            caps.color_open |= u64::from(caps.color[color] > 0) << color;
            for first in 0..side {
                let place = first << shift | color;
                caps.across_open[first] |= u64::from(caps.across[place] > 0) << color;
                caps.along_open[first] |= u64::from(caps.along[place] > 0) << color;
            }
        }
        caps
    }

    /// The colors that may follow as free corner of a window with these known corners.
    #[inline(always)]
    pub fn open(&self, known: [u8; 3]) -> u64 {
        self.color_open
            & self.across_open[usize::from(known[2])]
            & self.along_open[usize::from(known[1])]
    }

    /// The colors that may occur once more.
    pub fn open_colors(&self) -> u64 {
        self.color_open
    }

    /// Whether no count is exceeded.
    pub fn hold(&self) -> bool {
        self.excess == 0
    }

    /// Counts a color.
    #[inline(always)]
    pub fn take_color(&mut self, color: u8) {
        take(&mut self.color[usize::from(color)], &mut self.color_open, color, &mut self.excess);
    }

    /// Takes back a color counted.
    #[inline(always)]
    pub fn release_color(&mut self, color: u8) {
        release(&mut self.color[usize::from(color)], &mut self.color_open, color, &mut self.excess);
    }

    /// Counts a horizontal domino.
    #[inline(always)]
    pub fn take_across(&mut self, first: u8, second: u8) {
        let place = usize::from(first) << self.shift | usize::from(second);
        let open = &mut self.across_open[usize::from(first)];
        take(&mut self.across[place], open, second, &mut self.excess);
    }

    /// Takes back a horizontal domino counted.
    #[inline(always)]
    pub fn release_across(&mut self, first: u8, second: u8) {
        let place = usize::from(first) << self.shift | usize::from(second);
        let open = &mut self.across_open[usize::from(first)];
        release(&mut self.across[place], open, second, &mut self.excess);
    }

    /// Counts a vertical domino, the end visited first coming first.
    #[inline(always)]
    pub fn take_along(&mut self, first: u8, second: u8) {
        let place = usize::from(first) << self.shift | usize::from(second);
        let open = &mut self.along_open[usize::from(first)];
        take(&mut self.along[place], open, second, &mut self.excess);
    }

    /// Takes back a vertical domino counted.
    #[inline(always)]
    pub fn release_along(&mut self, first: u8, second: u8) {
        let place = usize::from(first) << self.shift | usize::from(second);
        let open = &mut self.along_open[usize::from(first)];
        release(&mut self.along[place], open, second, &mut self.excess);
    }
}

#[inline(always)]
fn take(count: &mut i32, open: &mut u64, bit: u8, excess: &mut u32) {
    *count -= 1;
    *open &= !(u64::from(*count <= 0) << bit);
    *excess += u32::from(*count < 0);
}

#[inline(always)]
fn release(count: &mut i32, open: &mut u64, bit: u8, excess: &mut u32) {
    *excess -= u32::from(*count < 0);
    *count += 1;
    *open |= u64::from(*count > 0) << bit;
}

/// The colors of a window.
#[inline(always)]
pub fn colors(window: &Window, value: &[u8]) -> ([u8; 3], u8) {
    (window.known.map(|cell| value[cell as usize]), value[window.free as usize])
}
