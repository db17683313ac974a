//! Visiting orders: in which order a search fills the cells of a torus.
//!
//! The order decides how early a contradiction shows, and changes node counts by orders of
//! magnitude. `row` and `column` keep the frontier one row or column long; `diagonal` fills
//! anti-diagonals; `spiral` starts in the middle and winds outward.

use super::{Cell, Shape};
use std::fmt;
use std::str::FromStr;

/// A visiting order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Order {
    /// Row by row from the north, each from the west.
    Row,
    /// Column by column from the west, each from the north.
    Column,
    /// Anti-diagonal by anti-diagonal from the north-west corner, each from the north.
    Diagonal,
    /// From the middle outward, clockwise.
    Spiral,
}

impl Order {
    /// All orders.
    pub const ALL: [Order; 4] = [Order::Row, Order::Column, Order::Diagonal, Order::Spiral];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Order::Row => "row",
            Order::Column => "column",
            Order::Diagonal => "diagonal",
            Order::Spiral => "spiral",
        }
    }

    /// Every cell of the torus once, in this order.
    pub fn cells(self, shape: Shape) -> Vec<Cell> {
        let (w, h) = (shape.width(), shape.height());
        match self {
            Order::Row => (0..shape.cells() as u32).map(Cell).collect(),
            Order::Column => (0..w).flat_map(|c| (0..h).map(move |r| shape.cell(r, c))).collect(),
            Order::Diagonal => (0..w + h - 1)
                .flat_map(|sum| {
                    let rows = sum.saturating_sub(w - 1)..h.min(sum + 1);
                    rows.map(move |r| shape.cell(r, sum - r))
                })
                .collect(),
            Order::Spiral => spiral(shape),
        }
    }
}

/// Unrolls the spiral inward from the north-west corner, then reverses it.
fn spiral(shape: Shape) -> Vec<Cell> {
    let (mut top, mut left) = (0, 0);
    let (mut bottom, mut right) = (shape.height(), shape.width());
    let mut cells = Vec::with_capacity(shape.cells());
    while top < bottom && left < right {
        cells.extend((left..right).map(|c| shape.cell(top, c)));
        cells.extend((top + 1..bottom).map(|r| shape.cell(r, right - 1)));
        if bottom - top > 1 {
            cells.extend((left..right - 1).rev().map(|c| shape.cell(bottom - 1, c)));
        }
        if right - left > 1 {
            cells.extend((top + 1..bottom - 1).rev().map(|r| shape.cell(r, left)));
        }
        (top, left, bottom, right) = (top + 1, left + 1, bottom - 1, right - 1);
    }
    cells.reverse();
    cells
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Order {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Order::ALL
            .into_iter()
            .find(|order| order.name() == text)
            .ok_or_else(|| format!("order '{text}': expected row, column, diagonal or spiral"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_order_visits_every_cell_once() {
        for (w, h) in [(1, 1), (1, 7), (7, 1), (2, 2), (3, 5), (6, 4), (9, 9), (2, 8)] {
            let shape = Shape::new(w, h).unwrap();
            for order in Order::ALL {
                let mut cells = order.cells(shape);
                cells.sort_unstable();
                assert_eq!(cells, Order::Row.cells(shape), "{order} {shape}");
            }
        }
    }

    #[test]
    fn spiral_winds_outward_from_the_middle() {
        let shape = Shape::new(3, 3).unwrap();
        let cells: Vec<u32> = Order::Spiral.cells(shape).iter().map(|c| c.0).collect();
        assert_eq!(cells, [4, 3, 6, 7, 8, 5, 2, 1, 0]);
    }
}
