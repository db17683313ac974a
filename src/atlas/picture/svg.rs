//! Scenes as SVG: paths only, numbers with at most two decimals, always the same bytes.

use super::{Command, Paint, Path, Point, Scene};
use crate::atlas::formats::escape;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Writes a scene with `size` pixels a tile; the title is not seen in the picture.
///
/// # Errors
/// What `out` reports.
pub fn write_svg(out: &mut dyn Write, scene: &Scene, size: u32, title: &str) -> io::Result<()> {
    let size = f64::from(size);
    let (width, height) = (number(scene.width * size), number(scene.height * size));
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" "
    )?;
    writeln!(out, "viewBox=\"0 0 {width} {height}\">")?;
    writeln!(out, "<title>{}</title>", escape(title))?;
    writeln!(out, "<path fill=\"#fff\" d=\"M0 0h{width}v{height}h-{width}z\"/>")?;
    for shape in &scene.shapes {
        let [r, g, b] = shape.color;
        let color = format!("#{r:02x}{g:02x}{b:02x}");
        let opacity = match shape.opacity {
            100 => String::new(),
            percent => format!(" opacity=\"{}\"", number(f64::from(percent) / 100.0)),
        };
        match shape.paint {
            Paint::Fill => write!(out, "<path fill=\"{color}\"{opacity}")?,
            Paint::Stroke(width) => write!(
                out,
                "<path fill=\"none\" stroke=\"{color}\" stroke-width=\"{}\" \
                 stroke-linecap=\"round\" stroke-linejoin=\"round\"{opacity}",
                number(width * size)
            )?,
        }
        writeln!(out, " d=\"{}\"/>", data(&shape.path, size))?;
    }
    writeln!(out, "</svg>")
}

/// A number with at most two decimals.
pub fn number(value: f64) -> String {
    let mut text = String::new();
    push(&mut text, hundredths(value));
    text
}

fn hundredths(value: f64) -> i64 {
    (value * 100.0).round() as i64
}

/// Adds a number of hundredths, with a blank where it would run into what is before.
fn push(text: &mut String, hundredths: i64) {
    let last = text.as_bytes().last();
    if hundredths >= 0 && last.is_some_and(u8::is_ascii_digit) {
        text.push(' ');
    }
    if hundredths < 0 {
        text.push('-');
    }
    let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    // Writing to a string does not fail.
    let _ = match (whole, part) {
        (0, 0) => write!(text, "0"),
        (_, 0) => write!(text, "{whole}"),
        (0, part) if part % 10 == 0 => write!(text, ".{}", part / 10),
        (0, part) => write!(text, ".{part:02}"),
        (_, part) if part % 10 == 0 => write!(text, "{whole}.{}", part / 10),
        (_, part) => write!(text, "{whole}.{part:02}"),
    };
}

/// The data of a path, enlarged: steps relative to the point before, as whole hundredths, so
/// that rounding does not add up.
pub fn data(path: &Path, scale: f64) -> String {
    let mut text = String::new();
    let fixed = |(x, y): Point| (hundredths(x * scale), hundredths(y * scale));
    let (mut at, mut begin) = ((0, 0), (0, 0));
    for &command in &path.commands {
        match command {
            Command::Move(to) => {
                let to = fixed(to);
                if at == (0, 0) && text.is_empty() {
                    text.push('M');
                    push(&mut text, to.0);
                    push(&mut text, to.1);
                } else {
                    relative(&mut text, 'm', at, &[to]);
                }
                (at, begin) = (to, to);
            }
            Command::Line(to) => {
                let to = fixed(to);
                match (to.0 - at.0, to.1 - at.1) {
                    (dx, 0) => straight(&mut text, 'h', dx),
                    (0, dy) => straight(&mut text, 'v', dy),
                    _ => relative(&mut text, 'l', at, &[to]),
                }
                at = to;
            }
            Command::Quadratic(control, to) => {
                relative(&mut text, 'q', at, &[fixed(control), fixed(to)]);
                at = fixed(to);
            }
            Command::Cubic(first, second, to) => {
                relative(&mut text, 'c', at, &[fixed(first), fixed(second), fixed(to)]);
                at = fixed(to);
            }
            Command::Close => {
                text.push('z');
                at = begin;
            }
        }
    }
    text
}

fn straight(text: &mut String, letter: char, by: i64) {
    text.push(letter);
    push(text, by);
}

fn relative(text: &mut String, letter: char, at: (i64, i64), points: &[(i64, i64)]) {
    text.push(letter);
    for point in points {
        push(text, point.0 - at.0);
        push(text, point.1 - at.1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases = [(0.0, "0"), (0.5, ".5"), (-0.25, "-.25"), (12.0, "12"), (1.05, "1.05")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
        let mut path = Path::default();
        path.polygon(&[(0.0, 0.0), (1.0, 0.0), (0.5, 0.504)]);
        assert_eq!(data(&path, 1.0), "M0 0h1l-.5 .5z");
    }
}
