//! Exact numbers a + b phi of the golden ratio, for the verifier alone.
//!
//! For `b > 0` the number is positive when `-a / b` is below phi, the positive root of
//! `r^2 - r - 1`: when `a >= 0` or `a^2 + a b - b^2 < 0`. Coordinates of a file are small
//! (`LIMIT`), so that 128 bits hold all that is made of them here.

/// `a + b phi` as `(a, b)`.
pub(super) type Golden = (i128, i128);

/// A point or a vector.
pub(super) type Spot = (Golden, Golden);

/// The largest coordinate of a file, either way.
pub(super) const LIMIT: i64 = 10_000;

pub(super) fn is_positive((a, b): Golden) -> bool {
    let norm = a * a + a * b - b * b;
    match b {
        0 => a > 0,
        1.. => a >= 0 || norm < 0,
        _ => a > 0 && norm > 0,
    }
}

pub(super) fn minus(x: Golden, y: Golden) -> Golden {
    (x.0 - y.0, x.1 - y.1)
}

pub(super) fn plus(x: Golden, y: Golden) -> Golden {
    (x.0 + y.0, x.1 + y.1)
}

pub(super) fn times(x: Golden, y: Golden) -> Golden {
    let cross = x.0 * y.1 + x.1 * y.0;
    (x.0 * y.0 + x.1 * y.1, cross + x.1 * y.1)
}

/// The point that a file means.
pub(super) fn spot([a, b, c, d]: [i64; 4]) -> Spot {
    ((a.into(), b.into()), (c.into(), d.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_those_of_real_numbers() {
        let phi = f64::midpoint(1.0, 5f64.sqrt());
        for (a, b) in (-40..=40).flat_map(|a| (-40..=40).map(move |b| (a, b))) {
            let real = a as f64 + b as f64 * phi;
            assert_eq!(is_positive((a, b)), real > 1e-9, "{a} + {b} phi");
        }
        // phi^2 = phi + 1.
        assert_eq!(times((0, 1), (0, 1)), (1, 1));
    }
}
