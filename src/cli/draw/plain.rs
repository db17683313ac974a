//! Drawings of lines and labels.
//!
//! Every color stands once, where tiles share it: at the lattice points for corner tiles, on the
//! edges for Wang tiles. Where those who share it disagree there is a cross. The last line and
//! column repeat the first where the board closes. Dominoes show both ends each.

use super::View;
use super::canvas::Canvas;
use std::io::{self, Write};

/// Stands where neighbors disagree.
const CROSS: &str = "×";

/// The label of the one color in `colors`, or a cross.
fn shared<const N: usize>(view: &View<'_>, colors: [u8; N]) -> String {
    match colors.iter().all(|&color| color == colors[0]) {
        true => view.name(colors[0]),
        false => format!("{CROSS:>width$}", width = view.label),
    }
}

/// Writes text in the middle of `width` spots.
fn center(canvas: &mut Canvas, x: usize, y: usize, width: usize, text: &str) {
    canvas.text(x + (width - text.chars().count().min(width)) / 2, y, text);
}

/// Draws corner tiles: labels at the lattice points, lines along the sides.
///
/// # Errors
/// What `out` reports.
pub fn corner(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    let step = (view.label + 3).max(view.digits + 3);
    let (w, h) = (view.width, view.height);
    let point = |row: usize, column: usize| {
        let [_, _, _, nw] = view.sides(row, column);
        let [ne, ..] = view.sides(row, column + w - 1);
        let [_, _, sw, _] = view.sides(row + h - 1, column);
        let [_, se, ..] = view.sides(row + h - 1, column + w - 1);
        shared(view, [nw, ne, sw, se])
    };
    for row in 0..=h {
        let mut canvas = Canvas::new(w * step + view.label, if row < h { 2 } else { 1 });
        for column in 0..=w {
            let x = column * step;
            if column < w {
                canvas.text(x, 0, &"─".repeat(step));
                center(&mut canvas, x + 1, 1, step - 1, &view.number(row, column));
            }
            canvas.text(x, 1, "│");
            canvas.text(x, 0, &point(row, column));
        }
        canvas.write(out)?;
    }
    Ok(())
}

/// Draws Wang tiles: labels in the middle of the edges.
///
/// # Errors
/// What `out` reports.
pub fn wang(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    let step = (view.label + 3).max(view.digits + 3);
    let (w, h) = (view.width, view.height);
    let north = |row: usize, column: usize| {
        let ([n, ..], [_, _, s, _]) = (view.sides(row, column), view.sides(row + h - 1, column));
        match row {
            0 if !view.meets(0) => view.name(n),
            _ if row == h && !view.meets(2) => view.name(s),
            _ => shared(view, [n, s]),
        }
    };
    let west = |row: usize, column: usize| {
        let ([_, _, _, w_], [_, e, ..]) =
            (view.sides(row, column), view.sides(row, column + w - 1));
        match column {
            0 if !view.meets(3) => view.name(w_),
            _ if column == w && !view.meets(1) => view.name(e),
            _ => shared(view, [w_, e]),
        }
    };
    for row in 0..=h {
        // Numbers have a line of their own, where they are not taken for colors.
        let lines = if row == h { 1 } else { 2 + usize::from(view.digits > 0) };
        let mut canvas = Canvas::new(w * step + view.label, lines);
        for column in 0..=w {
            let x = column * step;
            if column < w {
                canvas.text(x, 0, &"─".repeat(step));
                center(&mut canvas, x + 1, 0, step - 1, &north(row, column));
                center(&mut canvas, x + 1, 2, step - 1, &view.number(row, column));
            }
            canvas.text(x, 1, &west(row, column));
            canvas.text(x, 2, "│");
            let crossings = match row {
                0 => ["┌", "┬", "┐"],
                _ if row < h => ["├", "┼", "┤"],
                _ => ["└", "┴", "┘"],
            };
            canvas.text(x, 0, crossings[usize::from(column > 0) + usize::from(column == w)]);
        }
        canvas.write(out)?;
    }
    Ok(())
}

/// Draws dominoes: `[0 1][1 2]` along a row, one below the other down a column.
///
/// # Errors
/// What `out` reports.
pub fn domino(out: &mut dyn Write, view: &View<'_>) -> io::Result<()> {
    for row in 0..view.height {
        for column in 0..view.width {
            let [first, second, ..] = view.sides(row, column).map(|color| view.name(color));
            let number = match view.digits {
                0 => String::new(),
                _ => format!(" ({})", view.number(row, column)),
            };
            write!(out, "[{first}{number} {second}]")?;
        }
        writeln!(out)?;
    }
    Ok(())
}
