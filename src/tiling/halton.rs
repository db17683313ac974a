//! Colors along the Halton sequence, by the Chinese remainder theorem.
//!
//! The Halton sequence in bases 2 and 3 visits the points of a grid of `p1 = 2^n1` columns and
//! `p2 = 3^n2` rows once each, and keeps points apart that it visits soon after each other. The
//! visits are divided among the colors in order, so equal colors keep their distance: of the 8
//! neighbors of a point, far fewer than one in `C` have its color.
//!
//! When a point is visited follows without the sequence. Its column, its binary digits reversed,
//! is the remainder `l1` of the visit modulo `p1`; its row, its ternary digits reversed, the
//! remainder `l2` modulo `p2`; so the visit is
//! `(p2 ((l1 m1) mod p1) + p1 ((l2 m2) mod p2)) mod p1 p2`, `m1 = 1/p2 mod p1`, `m2 = 1/p1 mod p2`.
//! (Schlömer 2012, section 2.4, whose text has the two inverses in the other order, which is not
//! even a bijection.) The color is `floor(visit C / (p1 p2))`, in whole numbers.
//!
//! Beyond the grid the coloring repeats after `p1` columns and `p2` rows, negative ones too: the
//! remainders go on. Across these seams colors are as good as hashed, not as well spread.

use super::TilingError;
use crate::tiles::Kind;
use crate::torus::Shape;

/// The most points, as a power of two: a visit times 255 colors, and the products of remainders,
/// then fit 64 bits.
const MOST_DIGITS: u32 = 48;

/// A Halton coloring of a grid of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Halton {
    /// Binary digits of a column.
    pub n1: u32,
    /// Ternary digits of a row.
    pub n2: u32,
    /// Columns, `2^n1`.
    pub p1: u64,
    /// Rows, `3^n2`.
    pub p2: u64,
    /// The inverse of `p2` modulo `p1`.
    pub m1: u64,
    /// The inverse of `p1` modulo `p2`.
    pub m2: u64,
}

impl Halton {
    /// The smallest grid with these numbers of points; `None` if it is too large.
    pub fn of_points(width: u64, height: u64) -> Option<Self> {
        let n1 = (0..=MOST_DIGITS).find(|&n| 1 << n >= width)?;
        let n2 = (0..=MOST_DIGITS).find(|&n| 3u64.checked_pow(n).is_none_or(|p| p >= height))?;
        let (p1, p2) = (1u64 << n1, 3u64.checked_pow(n2)?);
        let points = p1.checked_mul(p2)?;
        // Both sides are kept to 32 bits, for l1 * m1 and l2 * m2.
        let fits = points <= 1 << MOST_DIGITS && p1.max(p2) <= 1 << 32;
        fits.then(|| Self { n1, n2, p1, p2, m1: inverse(p2, p1), m2: inverse(p1, p2) })
    }

    /// The grid whose points are the corners of this many tiles, or for Wang tiles the points of
    /// the finer lattice on which their edges lie.
    ///
    /// # Errors
    /// A grid that is too large.
    pub fn of_tiles(kind: Kind, tiles: Shape) -> Result<Self, TilingError> {
        let steps = if kind == Kind::Wang { 2 } else { 1 };
        let points = |side: usize| steps * side as u64 + 1;
        let (width, height) = (tiles.width(), tiles.height());
        let limit = MOST_DIGITS;
        Self::of_points(points(width), points(height)).ok_or(TilingError::HaltonTooLarge {
            width,
            height,
            limit,
        })
    }

    /// The number of points, of which each is visited once.
    pub fn points(&self) -> u64 {
        self.p1 * self.p2
    }

    /// When a point is visited.
    pub fn visit(&self, x: i64, y: i64) -> u64 {
        let column = x.rem_euclid(self.p1 as i64) as u64;
        let row = y.rem_euclid(self.p2 as i64) as u64;
        let (l1, l2) = (reversed(column, 2, self.n1), reversed(row, 3, self.n2));
        let sum = self.p2 * (l1 * self.m1 % self.p1) + self.p1 * (l2 * self.m2 % self.p2);
        sum % self.points()
    }

    /// The color of a point, below `colors`.
    pub fn color(&self, x: i64, y: i64, colors: usize) -> u8 {
        (self.visit(x, y) * colors as u64 / self.points()) as u8
    }
}

/// The number whose digits are those of `number`, from the last to the first.
fn reversed(mut number: u64, base: u64, digits: u32) -> u64 {
    (0..digits).fold(0, |reversed, _| {
        let digit = number % base;
        number /= base;
        reversed * base + digit
    })
}

/// `1 / a` modulo `modulus`, which have no common factor: Euclid's algorithm.
fn inverse(a: u64, modulus: u64) -> u64 {
    let (mut old, mut rest) = (modulus as i128, (a % modulus) as i128);
    let (mut before, mut now) = (0i128, 1i128);
    while rest != 0 {
        let quotient = old / rest;
        (old, rest) = (rest, old - quotient * rest);
        (before, now) = (now, before - quotient * now);
    }
    before.rem_euclid(modulus as i128) as u64
}

/// Rows of colors: what a column adds to a visit is kept.
#[derive(Debug)]
pub(super) struct HaltonRows {
    halton: Halton,
    colors: u64,
    /// `2^64 / points`, and a little more: division by multiplication.
    inverse: u64,
    columns: Vec<u64>,
}

impl HaltonRows {
    pub(super) fn new(halton: Halton, x: i64, step: u32, count: usize, colors: usize) -> Self {
        let column = |at: usize| {
            let x = x.wrapping_add((at * step as usize) as i64);
            let column = x.rem_euclid(halton.p1 as i64) as u64;
            halton.p2 * (reversed(column, 2, halton.n1) * halton.m1 % halton.p1)
        };
        // A grid of one point would need 2^64, and every product is 0 there.
        let inverse = u64::MAX / halton.points() + u64::from(halton.points() > 1);
        let columns = (0..count).map(column).collect();
        Self { halton, colors: colors as u64, inverse, columns }
    }

    /// The colors of the row `y`.
    pub(super) fn row(&self, y: i64, colors: &mut [u8]) {
        let halton = self.halton;
        let row = y.rem_euclid(halton.p2 as i64) as u64;
        let row = halton.p1 * (reversed(row, 3, halton.n2) * halton.m2 % halton.p2);
        let points = halton.points();
        for (color, column) in colors.iter_mut().zip(&self.columns) {
            let sum = column + row;
            let visit = if sum >= points { sum - points } else { sum };
            // Below 2^56, so the quotient is at most one too large.
            let product = visit * self.colors;
            let quotient = ((u128::from(product) * u128::from(self.inverse)) >> 64) as u64;
            *color = (quotient - u64::from(quotient * points > product)) as u8;
        }
    }
}
