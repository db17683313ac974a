//! Convex polygons with vertices in `Z[phi]`, and what two of them have in common.
//!
//! A polygon is cut by the lines of the sides of another one, one after the other (Sutherland and
//! Hodgman 1974). A line meets a side in a point with coordinates in the ring for all polygons
//! that we meet, whose sides have slopes 0, phi, phi^2 and infinity; if it ever does not, the
//! cut says so.

use super::zphi::Zphi;
use std::cmp::Ordering;

/// A point of the plane, or a vector.
pub type Point = [Zphi; 2];

/// A convex polygon, counter-clockwise, without vertices inside of sides.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polygon(pub Vec<Point>);

/// Two sides meet in a point outside of `Z[phi]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("two sides meet in a point that is not in Z[phi]")]
pub struct OutsideRing;

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1]]
}

fn cross(p: Point, q: Point) -> Zphi {
    p[0] * q[1] - p[1] * q[0]
}

/// More than nothing when `p` lies to the left of the way from `a` to `b`.
fn side(a: Point, b: Point, p: Point) -> Zphi {
    cross(minus(b, a), minus(p, a))
}

impl Polygon {
    /// The sides, each from a vertex to the next.
    fn sides(&self) -> impl Iterator<Item = (Point, Point)> {
        let vertices = &self.0;
        vertices.iter().copied().zip(vertices.iter().copied().cycle().skip(1))
    }

    /// Twice its area.
    pub fn double_area(&self) -> Zphi {
        self.sides().fold(Zphi::ZERO, |area, (p, q)| area + cross(p, q))
    }

    /// The polygon moved by a vector.
    pub fn moved(&self, by: Point) -> Polygon {
        Polygon(self.0.iter().map(|p| [p[0] + by[0], p[1] + by[1]]).collect())
    }

    /// What two polygons have in common, `None` unless it has an area.
    ///
    /// # Errors
    /// A vertex of it is outside of the ring.
    pub fn common(&self, other: &Polygon) -> Result<Option<Polygon>, OutsideRing> {
        let mut rest = self.clone();
        for (a, b) in other.sides() {
            // Most polygons lie apart, and are not worth a cut.
            if rest.0.iter().all(|&p| !side(a, b, p).is_positive()) {
                return Ok(None);
            }
            rest = rest.left_of(a, b)?;
        }
        rest.0.dedup();
        while rest.0.len() > 1 && rest.0.first() == rest.0.last() {
            rest.0.pop();
        }
        let n = rest.0.len();
        let corner = |i: usize| {
            let (p, q, r) = (rest.0[(i + n - 1) % n], rest.0[i], rest.0[(i + 1) % n]);
            side(p, q, r).is_positive()
        };
        let corners: Vec<Point> = (0..n).filter(|&i| corner(i)).map(|i| rest.0[i]).collect();
        let polygon = Polygon(corners);
        Ok((polygon.0.len() >= 3).then_some(polygon))
    }

    /// The part to the left of the line from `a` to `b`.
    fn left_of(&self, a: Point, b: Point) -> Result<Polygon, OutsideRing> {
        let mut kept = Vec::with_capacity(self.0.len() + 1);
        for (p, q) in self.sides() {
            let (at_p, at_q) = (side(a, b, p), side(a, b, q));
            if at_p.sign() != Ordering::Less {
                kept.push(p);
            }
            let between = [at_p.sign(), at_q.sign()];
            if between == [Ordering::Less, Ordering::Greater]
                || between == [Ordering::Greater, Ordering::Less]
            {
                let (along, all) = (minus(q, p), at_p - at_q);
                let step = |x: Zphi| (x * at_p).divided_by(all).ok_or(OutsideRing);
                kept.push([p[0] + step(along[0])?, p[1] + step(along[1])?]);
            }
        }
        Ok(Polygon(kept))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(vertices: &[[i64; 4]]) -> Polygon {
        let point = |&[a, b, c, d]: &[i64; 4]| [Zphi::new(a, b), Zphi::new(c, d)];
        Polygon(vertices.iter().map(point).collect())
    }

    #[test]
    fn polygons_are_cut() {
        let square = polygon(&[[0, 0, 0, 0], [2, 0, 0, 0], [2, 0, 2, 0], [0, 0, 2, 0]]);
        assert_eq!(square.double_area(), Zphi::new(8, 0));
        let moved = square.moved([Zphi::new(1, 0), Zphi::new(0, 1)]);
        let common = square.common(&moved).unwrap().unwrap();
        // 1 x (2 - phi).
        assert_eq!(common.double_area(), Zphi::new(4, -2));
        let apart = square.moved([Zphi::new(2, 0), Zphi::ZERO]);
        assert_eq!(square.common(&apart), Ok(None));
        assert_eq!(square.common(&square), Ok(Some(square.clone())));
        let corner = square.moved([Zphi::new(2, 0), Zphi::new(2, 0)]);
        assert_eq!(square.common(&corner), Ok(None));
        // The diagonal of slope phi, and one of slope 2, which leaves the ring.
        let golden = polygon(&[[0, 0, 0, 0], [2, 0, 0, 2], [0, 0, 0, 2]]);
        assert!(square.common(&golden).unwrap().is_some());
        let odd = polygon(&[[0, 0, 0, 0], [3, 0, 5, 0], [0, 0, 5, 0]]);
        assert_eq!(square.common(&odd), Err(OutsideRing));
    }
}
