//! A torus of corner tiles from two over coprime numbers of colors, one laid over the other.
//!
//! `a[i][j] = C2 a1[i mod R1][j mod S1] + a2[i mod R2][j mod S2]` over `C1 C2` colors, on
//! `R1 R2 x S1 S2` cells. *Why every window occurs once:* it shows a window of `a1`, which says
//! `i mod R1` and `j mod S1`, and one of `a2`; as `R1` divides a power of `C1` and `R2` one of
//! `C2`, they are coprime, likewise `S1` and `S2`, and the Chinese remainder theorem gives `i`
//! and `j`.

use super::corner::{CornerTorus, Window};

/// A product of two tori.
#[derive(Debug, Clone)]
pub struct Product {
    first: Box<CornerTorus>,
    second: Box<CornerTorus>,
}

impl Product {
    /// The product of tori over coprime numbers of colors.
    pub fn new(first: CornerTorus, second: CornerTorus) -> Self {
        Self { first: Box::new(first), second: Box::new(second) }
    }

    /// The two tori.
    pub fn factors(&self) -> (&CornerTorus, &CornerTorus) {
        (&self.first, &self.second)
    }

    /// The number of colors.
    pub fn colors(&self) -> usize {
        self.first.colors() * self.second.colors()
    }

    /// Rows and columns.
    pub fn sides(&self) -> (usize, usize) {
        let ((r1, s1), (r2, s2)) = (self.first.sides(), self.second.sides());
        (r1 * r2, s1 * s2)
    }

    /// Writes the colors of a row.
    pub fn row(&self, row: usize, colors: &mut [u8]) {
        let line = |torus: &CornerTorus| {
            let (height, width) = torus.sides();
            let mut line = vec![0; width];
            torus.row(row % height, &mut line);
            line
        };
        let (first, second) = (line(&self.first), line(&self.second));
        let factor = self.second.colors() as u8;
        let lines = first.iter().cycle().zip(second.iter().cycle());
        for (color, (high, low)) in colors.iter_mut().zip(lines) {
            *color = high * factor + low;
        }
    }

    /// The row and column of a window.
    pub fn find(&self, window: Window) -> (usize, usize) {
        let factor = self.second.colors() as u8;
        let (i1, j1) = self.first.find(window.map(|pair| pair.map(|color| color / factor)));
        let (i2, j2) = self.second.find(window.map(|pair| pair.map(|color| color % factor)));
        let ((r1, s1), (r2, s2)) = (self.first.sides(), self.second.sides());
        (chinese(i1, r1, i2, r2), chinese(j1, s1, j2, s2))
    }
}

/// The number below `p q` that leaves `a` modulo `p` and `b` modulo `q`, which are coprime.
fn chinese(a: usize, p: usize, b: usize, q: usize) -> usize {
    let inverse = invert(p, q);
    a + p * ((b + q - a % q) % q * inverse % q)
}

/// The inverse of `p` modulo `q`, by Euclid's algorithm; they must be coprime.
fn invert(p: usize, q: usize) -> usize {
    let (mut r0, mut r1) = (q as i64, (p % q) as i64);
    let (mut t0, mut t1) = (0i64, 1i64);
    while r1 != 0 {
        let quotient = r0 / r1;
        (r0, r1) = (r1, r0 - quotient * r1);
        (t0, t1) = (t1, t0 - quotient * t1);
    }
    t0.rem_euclid(q as i64) as usize
}
