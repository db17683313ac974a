//! The ring `Z[phi]` of the golden ratio phi = (1 + sqrt 5) / 2: exact numbers `a + b phi`.
//!
//! phi^2 = phi + 1. The sign of `a + b phi` is that of `u + v sqrt 5` with `u = 2 a + b`, `v = b`,
//! found by comparing `u^2` with `5 v^2`. A quotient is that by the norm `a^2 + a b - b^2`, if it
//! is in the ring. Coordinates here stay below a thousand, so 64 bits hold every product.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// The number `a + b phi`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Zphi {
    /// The integer part.
    pub a: i64,
    /// The multiple of phi.
    pub b: i64,
}

impl Zphi {
    /// Nothing.
    pub const ZERO: Zphi = Zphi::new(0, 0);
    /// The golden ratio.
    pub const PHI: Zphi = Zphi::new(0, 1);

    /// The number `a + b phi`.
    pub const fn new(a: i64, b: i64) -> Self {
        Self { a, b }
    }

    /// Its sign.
    pub fn sign(self) -> Ordering {
        let (u, v) = (2 * i128::from(self.a) + i128::from(self.b), i128::from(self.b));
        match (u.cmp(&0), v.cmp(&0)) {
            (Ordering::Equal, sign) | (sign, Ordering::Equal) => sign,
            (one, other) if one == other => one,
            (Ordering::Greater, _) => (u * u).cmp(&(5 * v * v)),
            _ => (5 * v * v).cmp(&(u * u)),
        }
    }

    /// Whether it is more than nothing.
    pub fn is_positive(self) -> bool {
        self.sign() == Ordering::Greater
    }

    /// This number divided by another one, if the quotient is in the ring.
    pub fn divided_by(self, other: Zphi) -> Option<Zphi> {
        let norm = other.a * other.a + other.a * other.b - other.b * other.b;
        // The conjugate of a + b phi is a + b - b phi.
        let top = self * Zphi::new(other.a + other.b, -other.b);
        let whole = norm != 0 && top.a % norm == 0 && top.b % norm == 0;
        whole.then(|| Zphi::new(top.a / norm, top.b / norm))
    }
}

impl Add for Zphi {
    type Output = Zphi;
    fn add(self, other: Zphi) -> Zphi {
        Zphi::new(self.a + other.a, self.b + other.b)
    }
}

impl Sub for Zphi {
    type Output = Zphi;
    fn sub(self, other: Zphi) -> Zphi {
        Zphi::new(self.a - other.a, self.b - other.b)
    }
}

impl Neg for Zphi {
    type Output = Zphi;
    fn neg(self) -> Zphi {
        Zphi::new(-self.a, -self.b)
    }
}

impl Mul for Zphi {
    type Output = Zphi;
    fn mul(self, other: Zphi) -> Zphi {
        let bb = self.b * other.b;
        Zphi::new(self.a * other.a + bb, self.a * other.b + self.b * other.a + bb)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn about(x: Zphi) -> f64 {
        x.a as f64 + x.b as f64 * f64::midpoint(1.0, 5f64.sqrt())
    }

    #[test]
    fn signs_products_and_quotients_agree_with_real_numbers() {
        let range = || -12..=12;
        for (a, b) in range().flat_map(|a| range().map(move |b| (a, b))) {
            let x = Zphi::new(a, b);
            let real = about(x);
            let sign = if a == 0 && b == 0 { Ordering::Equal } else { real.total_cmp(&0.0) };
            assert_eq!(x.sign(), sign, "{x:?}");
            for y in [Zphi::new(1, 1), Zphi::new(-3, 2), Zphi::new(4, -7), Zphi::new(2, 0)] {
                assert!((about(x * y) - real * about(y)).abs() < 1e-9);
                assert_eq!((x * y).divided_by(y), Some(x));
            }
        }
        assert_eq!(Zphi::new(1, 0).divided_by(Zphi::new(2, 0)), None);
        assert_eq!(Zphi::new(1, 0).divided_by(Zphi::ZERO), None);
        // Fibonacci numbers: as near to nothing as it gets.
        assert_eq!(Zphi::new(-701_408_733, 433_494_437).sign(), Ordering::Greater);
        assert_eq!(Zphi::new(701_408_733, -433_494_437).sign(), Ordering::Less);
        assert_eq!(Zphi::new(-433_494_437, 267_914_296).sign(), Ordering::Less);
    }
}
