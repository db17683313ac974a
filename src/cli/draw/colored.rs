//! Drawings of colored blocks.
//!
//! Every tile is drawn by itself, so that one sees what it has, and where neighbors fit their
//! blocks join. A color is labeled once where tiles share it, by the tile south-east of it, and
//! once more where a neighbor has another.

use super::View;
use super::canvas::Canvas;
use super::palette::{background, foreground};
use std::io::{self, Write};

impl Canvas {
    /// Writes the label of a color onto that color.
    fn label(&mut self, x: usize, y: usize, view: &View<'_>, color: u8) {
        self.ink(x, y, &view.name(color), foreground(color), background(color));
    }
}

/// Draws corner tiles: quarters, with the number on a line between them.
///
/// # Errors
/// What `out` reports.
pub fn corner(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    let half = view.label.max(2).max((view.digits + 3) / 2);
    let (tile, last) = (2 * half, if view.digits > 0 { 2 } else { 1 });
    for row in 0..view.height {
        let mut canvas = Canvas::new(view.width * tile, last + 1);
        for column in 0..view.width {
            let sides = view.sides(row, column);
            let [ne, se, sw, nw] = sides.map(background);
            let x = column * tile;
            for (x, above, below) in [(x, nw, sw), (x + half, ne, se)] {
                canvas.fill(x, 0, half, above);
                canvas.halves(x, 1, half, (Some(above), Some(below)));
                canvas.fill(x, last, half, below);
            }
            let number = view.number(row, column);
            canvas.text(x + (tile - number.len()) / 2, 1, &number);
            let north_west = |row, column| view.sides(row, column)[3];
            let right = x + tile - view.label;
            canvas.label(x, 0, view, sides[3]);
            for (x, y, color, neighbor) in [
                (right, 0, sides[0], north_west(row, column + 1)),
                (right, last, sides[1], north_west(row + 1, column + 1)),
                (x, last, sides[2], north_west(row + 1, column)),
            ] {
                if color != neighbor {
                    canvas.label(x, y, view, color);
                }
            }
        }
        canvas.write(out)?;
    }
    Ok(())
}

/// Draws Wang tiles: triangles, with the number in the middle.
///
/// # Errors
/// What `out` reports.
pub fn wang(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    let side = view.label.max(2);
    let middle = side.max(view.digits);
    let tile = 2 * side + middle;
    for row in 0..view.height {
        let mut canvas = Canvas::new(view.width * tile, 3);
        for column in 0..view.width {
            let sides = view.sides(row, column);
            let [n, e, s, w] = sides.map(background);
            let (x, east) = (column * tile, (column + 1) * tile - side);
            canvas.fill(x, 0, tile, n);
            canvas.fill(x, 2, tile, s);
            for (x, edge) in [(x, w), (x + tile - 1, e)] {
                // Nothing at the corners: it shows where the tiles are.
                canvas.halves(x, 0, 1, (None, Some(edge)));
                canvas.halves(x, 2, 1, (Some(edge), None));
            }
            canvas.fill(x, 1, side, w);
            canvas.halves(x + side, 1, middle, (Some(n), Some(s)));
            canvas.fill(east, 1, side, e);
            let number = view.number(row, column);
            canvas.text(x + side + (middle - number.len()) / 2, 1, &number);
            let label_x = x + (tile - view.label) / 2;
            canvas.label(label_x, 0, view, sides[0]);
            canvas.label(x, 1, view, sides[3]);
            let (last_row, last_column) = (row + 1 == view.height, column + 1 == view.width);
            let outer = last_column && !view.meets(1);
            if outer || sides[1] != view.sides(row, column + 1)[3] {
                canvas.label(x + tile - view.label, 1, view, sides[1]);
            }
            let outer = last_row && !view.meets(2);
            if outer || sides[2] != view.sides(row + 1, column)[0] {
                canvas.label(label_x, 2, view, sides[2]);
            }
        }
        canvas.write(out)?;
    }
    Ok(())
}

/// Draws dominoes: two halves each, the number between them, a gap between dominoes.
///
/// # Errors
/// What `out` reports.
pub fn domino(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    let half = view.label + 2;
    let middle = if view.digits > 0 { view.digits + 2 } else { 0 };
    let tile = 2 * half + middle;
    for row in 0..view.height {
        let mut canvas = Canvas::new(view.width * (tile + 1), 1);
        for column in 0..view.width {
            let [first, second, ..] = view.sides(row, column);
            let x = column * (tile + 1);
            for (x, color) in [(x, first), (x + half + middle, second)] {
                canvas.fill(x, 0, half, background(color));
                canvas.label(x + 1, 0, view, color);
            }
            canvas.text(x + half + 1, 0, &view.number(row, column));
        }
        canvas.write(out)?;
    }
    Ok(())
}
