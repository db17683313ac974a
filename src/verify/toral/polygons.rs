//! Polygons with golden coordinates: convex, inside of one another, apart from one another.

use super::number::{Golden, LIMIT, Spot, is_positive, minus, plus, spot, times};

/// The vertices, in the order of the file.
pub(super) struct Shape(pub(super) Vec<Spot>);

/// More than 0 when `c` lies to the left of the way from `a` to `b`, less when to the right.
fn turn(a: Spot, b: Spot, c: Spot) -> Golden {
    let (u, v) = ((minus(b.0, a.0), minus(b.1, a.1)), (minus(c.0, a.0), minus(c.1, a.1)));
    minus(times(u.0, v.1), times(u.1, v.0))
}

fn negative(x: Golden) -> bool {
    is_positive((-x.0, -x.1))
}

impl Shape {
    /// Reads a polygon: at least three vertices, small numbers, and every vertex to the left of
    /// every side it does not belong to.
    pub(super) fn read(vertices: &[[i64; 4]]) -> Result<Self, String> {
        if vertices.len() < 3 {
            return Err(format!("has {} vertices, expected at least 3", vertices.len()));
        }
        let large = |x: &i64| !(-LIMIT..=LIMIT).contains(x);
        if let Some(x) = vertices.iter().flatten().find(|x| large(x)) {
            return Err(format!("has the number {x}, beyond {LIMIT}"));
        }
        let shape = Shape(vertices.iter().copied().map(spot).collect());
        let n = shape.0.len();
        for (i, (a, b)) in shape.sides().enumerate() {
            for (j, &c) in shape.0.iter().enumerate() {
                if j != i && j != (i + 1) % n && !is_positive(turn(a, b, c)) {
                    return Err(format!(
                        "is not convex and counter-clockwise: vertex {j} is not to the left of \
                         the side from vertex {i}"
                    ));
                }
            }
        }
        Ok(shape)
    }

    fn sides(&self) -> impl Iterator<Item = (Spot, Spot)> + '_ {
        (0..self.0.len()).map(|i| (self.0[i], self.0[(i + 1) % self.0.len()]))
    }

    pub(super) fn double_area(&self) -> Golden {
        let zero = ((0, 0), (0, 0));
        let mut area = (0, 0);
        for (a, b) in self.sides() {
            area = plus(area, turn(zero, a, b));
        }
        area
    }

    pub(super) fn moved(&self, by: Spot) -> Shape {
        Shape(self.0.iter().map(|p| (plus(p.0, by.0), plus(p.1, by.1))).collect())
    }

    /// The first vertex that is not in a convex polygon, its boundary included.
    pub(super) fn first_outside(&self, of: &Shape) -> Option<usize> {
        let outside = |&c: &Spot| of.sides().any(|(a, b)| negative(turn(a, b, c)));
        self.0.iter().position(outside)
    }

    /// Whether the line of a side of one of them has the other one on its right.
    pub(super) fn is_apart_from(&self, other: &Shape) -> bool {
        let parts = |one: &Shape, two: &Shape| {
            one.sides().any(|(a, b)| two.0.iter().all(|&c| !is_positive(turn(a, b, c))))
        };
        parts(self, other) || parts(other, self)
    }
}
