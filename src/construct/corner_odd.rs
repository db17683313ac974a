//! All corner tiles over an odd number `C` of colors on a square torus, `n = C^2` a side.
//!
//! Row `i` is a ring `s` of all dominoes, rotated: `a[i][j] = s[j + t(i)]`, where
//! `t(i) = i(i-1)/2` and indices of `s` are taken modulo `n`. Row `i+1` is then rotated by `i`
//! against row `i`: the window at `(i, j)` shows the domino at `x = j + t(i)` over the domino at
//! `x + i`. *Why every window occurs once:* its upper domino says `x`, its lower one `x + i`, so
//! both say `i` and then `j`; and `(i, x)` takes each of the `n^2` values. *Why the rows close:*
//! the differences add up to `n(n-1)/2`, a multiple of `n` as `n` is odd.
//!
//! Any ring and any order of the differences `0 … n-1` do as well: those are the other members.
//! Existence: Hurlbert, Mitchell, Paterson 1996 (de Bruijn tori with two by two windows).

use super::corner::Window;
use super::ring::{least_color, least_position};
use super::{Ring, Seed};

/// The color at a row and column, for odd `colors`.
pub fn color(colors: usize, row: usize, column: usize) -> u8 {
    least_color(colors, (column + triangle(row)) % (colors * colors))
}

/// The row and column of a window, for odd `colors`.
pub fn find(colors: usize, window: Window) -> (usize, usize) {
    let side = colors * colors;
    let [[nw, ne], [sw, se]] = window;
    let above = least_position(colors, nw, ne);
    let below = least_position(colors, sw, se);
    let row = (below + side - above) % side;
    (row, (above + side - triangle(row) % side) % side)
}

/// The sum of the numbers below `row`.
fn triangle(row: usize) -> usize {
    row * row.saturating_sub(1) / 2
}

/// A member of the family: a ring, and how far each row is rotated.
#[derive(Debug, Clone)]
pub struct OddTorus {
    ring: Ring,
    rotations: Vec<u16>,
    /// For every difference the row that has it to the next.
    row_of: Vec<u16>,
}

impl OddTorus {
    /// The closed form, or a member chosen by a seed; `colors` must be odd.
    pub fn new(colors: usize, mut seed: Option<&mut Seed>) -> Self {
        let ring = Ring::choose(colors, seed.as_deref_mut());
        let side = ring.length();
        let mut differences: Vec<usize> = (0..side).collect();
        if let Some(seed) = seed {
            seed.shuffle(&mut differences);
        }
        let mut rotations = Vec::with_capacity(side);
        let mut row_of = vec![0; side];
        let mut rotation = 0;
        for (row, &difference) in differences.iter().enumerate() {
            rotations.push(rotation as u16);
            row_of[difference] = row as u16;
            rotation = (rotation + difference) % side;
        }
        Self { ring, rotations, row_of }
    }

    /// Columns, and rows.
    pub fn side(&self) -> usize {
        self.ring.length()
    }

    /// Writes the colors of a row.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        let ring = self.ring.colors();
        let rotation = self.rotations[row] as usize;
        let (first, second) = colors.split_at_mut(ring.len() - rotation);
        first.copy_from_slice(&ring[rotation..]);
        second.copy_from_slice(&ring[..rotation]);
    }

    /// The row and column of a window.
    pub fn find(&self, [[nw, ne], [sw, se]]: Window) -> (usize, usize) {
        let side = self.side();
        let around = |ahead: usize, behind: usize| match ahead >= behind {
            true => ahead - behind,
            false => ahead + side - behind,
        };
        let above = self.ring.place(nw, ne);
        let row = self.row_of[around(self.ring.place(sw, se), above)] as usize;
        (row, around(above, self.rotations[row] as usize))
    }
}
