//! Numbers as strokes.
//!
//! Ten figures drawn by hand on a grid 8 wide and 12 high: straight lines and parabolas.

use super::path::{Command, Path, Point};

/// Height of a figure on the grid.
const HEIGHT: f64 = 12.0;
/// Its width, and the distance to the next one.
const WIDTH: f64 = 8.0;
const PITCH: f64 = 11.5;

/// Width of the strokes, in heights of figures.
pub const STROKE: f64 = 0.15;

use Step::{L, M, Q};

/// A step of a figure on the grid.
#[derive(Debug, Clone, Copy)]
enum Step {
    M(f64, f64),
    L(f64, f64),
    Q(f64, f64, f64, f64),
}

const FIGURES: [&[Step]; 10] = [
    &[
        M(4.0, 0.0),
        Q(8.0, 0.0, 8.0, 6.0),
        Q(8.0, 12.0, 4.0, 12.0),
        Q(0.0, 12.0, 0.0, 6.0),
        Q(0.0, 0.0, 4.0, 0.0),
    ],
    &[M(1.2, 2.6), Q(3.6, 1.8, 4.6, 0.0), L(4.6, 12.0)],
    &[
        M(0.3, 3.0),
        Q(0.8, 0.0, 4.0, 0.0),
        Q(7.7, 0.0, 7.7, 3.3),
        Q(7.7, 5.6, 4.2, 8.2),
        L(0.2, 12.0),
        L(8.0, 12.0),
    ],
    &[
        M(0.6, 1.6),
        Q(1.8, 0.0, 4.0, 0.0),
        Q(7.6, 0.0, 7.6, 2.9),
        Q(7.6, 5.7, 3.6, 5.7),
        Q(8.0, 5.7, 8.0, 8.9),
        Q(8.0, 12.0, 4.0, 12.0),
        Q(1.4, 12.0, 0.2, 10.2),
    ],
    &[M(6.2, 12.0), L(6.2, 0.0), L(0.0, 8.6), L(8.2, 8.6)],
    &[
        M(7.4, 0.0),
        L(1.3, 0.0),
        L(0.8, 5.4),
        Q(2.2, 4.4, 4.2, 4.4),
        Q(8.0, 4.4, 8.0, 8.1),
        Q(8.0, 12.0, 4.0, 12.0),
        Q(1.4, 12.0, 0.2, 10.2),
    ],
    &[
        M(6.8, 0.2),
        Q(0.0, 1.6, 0.0, 8.2),
        Q(0.0, 12.0, 4.0, 12.0),
        Q(8.0, 12.0, 8.0, 8.3),
        Q(8.0, 4.8, 4.2, 4.8),
        Q(0.6, 4.8, 0.0, 8.2),
    ],
    &[M(0.0, 0.0), L(8.0, 0.0), Q(4.2, 5.2, 3.2, 12.0)],
    &[
        M(4.0, 5.6),
        Q(0.5, 5.4, 0.5, 2.8),
        Q(0.5, 0.0, 4.0, 0.0),
        Q(7.5, 0.0, 7.5, 2.8),
        Q(7.5, 5.4, 4.0, 5.6),
        Q(0.0, 5.9, 0.0, 8.9),
        Q(0.0, 12.0, 4.0, 12.0),
        Q(8.0, 12.0, 8.0, 8.9),
        Q(8.0, 5.9, 4.0, 5.6),
    ],
    &[
        M(1.2, 11.8),
        Q(8.0, 10.4, 8.0, 3.8),
        Q(8.0, 0.0, 4.0, 0.0),
        Q(0.0, 0.0, 0.0, 3.7),
        Q(0.0, 7.2, 3.8, 7.2),
        Q(7.4, 7.2, 8.0, 3.8),
    ],
];

/// The largest height, up to this one, at which a number is not wider than that.
pub fn height(number: u32, height: f64, width: f64) -> f64 {
    height.min(width / long(number) * HEIGHT)
}

/// The width of a number on the grid.
fn long(number: u32) -> f64 {
    WIDTH + PITCH * f64::from(number.checked_ilog10().unwrap_or(0))
}

/// Adds the strokes of a number of this height around a center; its width.
pub fn add(path: &mut Path, number: u32, center: Point, height: f64) -> f64 {
    let unit = height / HEIGHT;
    let width = long(number) * unit;
    let (left, top) = (center.0 - width / 2.0, center.1 - height / 2.0);
    for (place, figure) in number.to_string().bytes().enumerate() {
        let x = left + PITCH * place as f64 * unit;
        let at = |(dx, dy): Point| (x + dx * unit, top + dy * unit);
        path.commands.extend(FIGURES[usize::from(figure - b'0')].iter().map(|step| match *step {
            M(x, y) => Command::Move(at((x, y))),
            L(x, y) => Command::Line(at((x, y))),
            Q(cx, cy, x, y) => Command::Quadratic(at((cx, cy)), at((x, y))),
        }));
    }
    width
}
