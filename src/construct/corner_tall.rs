//! All corner tiles over an odd number `p` of colors on a torus `p` wide and `p^3` high.
//!
//! With `T(x) = x(x-1)/2`, which has period `p` modulo odd `p`, a row is
//! `a[i][j] = c(i) + T(j + t(i)) mod p`: the triangular numbers, rotated by `t(i)` and raised by
//! `c(i)`, the ring of all dominoes over and over (`c(i) = s[i mod p^2]`); `t(i+1) - t(i)` is
//! `i div p^2`. *Why every window occurs once:* `NE - NW = T(x+1) - T(x) = x` says
//! `x = j + t(i)`, likewise `SE - SW` says `x' = j + t(i+1)`; hence `c(i)` and `c(i+1)`, that is
//! `i mod p^2`, and `x' - x = i div p^2`. *Why the rows close:* the differences add up to
//! `p^2 (0 + … + p-1)`, a multiple of `p`.
//!
//! The torus reflected in its diagonal is `p^3` wide and `p` high. For primes this is the first
//! step of Hurlbert, Mitchell, Paterson 1996 towards all shapes; it does not need `p` prime.

use super::corner::Window;
use super::{Ring, Seed};

/// The torus, or its reflection.
#[derive(Debug, Clone)]
pub struct TallTorus {
    p: usize,
    ring: Ring,
    wide: bool,
}

impl TallTorus {
    /// The torus `p` wide (`p^3` wide if `wide`) with the least ring, or one chosen by a seed.
    pub fn new(p: usize, wide: bool, seed: Option<&mut Seed>) -> Self {
        Self { p, ring: Ring::choose(p, seed), wide }
    }

    /// Rows and columns.
    pub fn sides(&self) -> (usize, usize) {
        let (long, short) = (self.p * self.p * self.p, self.p);
        if self.wide { (short, long) } else { (long, short) }
    }

    /// Writes the colors of a row.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        for (column, color) in colors.iter_mut().enumerate() {
            let (i, j) = if self.wide { (column, row) } else { (row, column) };
            let raise = usize::from(self.ring.colors()[i % self.ring.length()]);
            *color = ((raise + self.triangle((j + self.rotation(i)) % self.p)) % self.p) as u8;
        }
    }

    /// The row and column of a window.
    pub fn find(&self, [[nw, ne], [sw, se]]: Window) -> (usize, usize) {
        let (ne, sw) = if self.wide { (sw, ne) } else { (ne, sw) };
        let [nw, ne, sw, se] = [nw, ne, sw, se].map(usize::from);
        let less = |a: usize, b: usize| (a + self.p - b % self.p) % self.p;
        let (x, below) = (less(ne, nw), less(se, sw));
        let raise = |color: usize, x: usize| less(color, self.triangle(x)) as u8;
        let i = self.ring.place(raise(nw, x), raise(sw, below)) + less(below, x) * self.p * self.p;
        let j = less(x, self.rotation(i));
        if self.wide { (j, i) } else { (i, j) }
    }

    /// `T(x)` modulo `p`.
    fn triangle(&self, x: usize) -> usize {
        x * x.saturating_sub(1) / 2 % self.p
    }

    /// How far row `i` of the tall torus is rotated, modulo `p`.
    fn rotation(&self, i: usize) -> usize {
        let square = self.p * self.p;
        i / square * (i % square) % self.p
    }
}
