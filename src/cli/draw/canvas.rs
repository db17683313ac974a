//! A few lines of characters, each with colors, to be drawn on and then written.

use std::io::{self, Write};

/// A character with its colors of the 256-color palette.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Spot {
    character: char,
    foreground: Option<u8>,
    background: Option<u8>,
}

const BLANK: Spot = Spot { character: ' ', foreground: None, background: None };

/// Lines of characters.
#[derive(Debug)]
pub struct Canvas {
    width: usize,
    spots: Vec<Spot>,
}

impl Canvas {
    /// Blank lines.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, spots: vec![BLANK; width * height] }
    }

    /// Writes text without colors. What does not fit is an error of the layout and left out.
    pub fn text(&mut self, x: usize, y: usize, text: &str) {
        for (i, character) in text.chars().enumerate() {
            self.set(x + i, y, Spot { character, ..BLANK });
        }
    }

    /// Writes text in a color onto a color.
    pub fn ink(&mut self, x: usize, y: usize, text: &str, foreground: u8, background: u8) {
        let (foreground, background) = (Some(foreground), Some(background));
        for (i, character) in text.chars().enumerate() {
            self.set(x + i, y, Spot { character, foreground, background });
        }
    }

    /// Fills `width` spots with a color.
    pub fn fill(&mut self, x: usize, y: usize, width: usize, color: u8) {
        for x in x..x + width {
            self.set(x, y, Spot { background: Some(color), ..BLANK });
        }
    }

    /// Fills `width` spots with two colors, one above the other; `None` is that of the terminal.
    pub fn halves(
        &mut self,
        x: usize,
        y: usize,
        width: usize,
        (above, below): (Option<u8>, Option<u8>),
    ) {
        let (character, foreground, background) = match (above, below) {
            _ if above == below => (' ', None, below),
            (None, _) => ('▄', below, None),
            _ => ('▀', above, below),
        };
        for x in x..x + width {
            self.set(x, y, Spot { character, foreground, background });
        }
    }

    fn set(&mut self, x: usize, y: usize, spot: Spot) {
        if x < self.width
            && let Some(place) = self.spots.get_mut(y * self.width + x)
        {
            *place = spot;
        }
    }

    /// Writes the lines, without blanks at their ends.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for line in self.spots.chunks(self.width.max(1)) {
            let end = line.iter().rposition(|spot| *spot != BLANK).map_or(0, |last| last + 1);
            let mut colors = (None, None);
            for spot in &line[..end] {
                let wanted = (spot.foreground, spot.background);
                if wanted != colors {
                    write_colors(out, wanted)?;
                    colors = wanted;
                }
                write!(out, "{}", spot.character)?;
            }
            if colors != (None, None) {
                write_colors(out, (None, None))?;
            }
            writeln!(out)?;
        }
        Ok(())
    }
}

/// Select Graphic Rendition (ECMA-48, 8.3.117), with the 256 colors of xterm.
fn write_colors(out: &mut dyn Write, colors: (Option<u8>, Option<u8>)) -> io::Result<()> {
    write!(out, "\x1b[0")?;
    if let Some(foreground) = colors.0 {
        write!(out, ";38;5;{foreground}")?;
    }
    if let Some(background) = colors.1 {
        write!(out, ";48;5;{background}")?;
    }
    write!(out, "m")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_where_the_drawing_ends() {
        let mut canvas = Canvas::new(4, 3);
        canvas.text(1, 0, "ab");
        canvas.ink(0, 1, "c", 1, 2);
        canvas.fill(3, 1, 9, 7);
        canvas.halves(0, 2, 1, (Some(3), Some(4)));
        canvas.halves(1, 2, 1, (None, Some(4)));
        let mut out = Vec::new();
        canvas.write(&mut out).unwrap();
        let expected = " ab\n\x1b[0;38;5;1;48;5;2mc\x1b[0m  \x1b[0;48;5;7m \x1b[0m\n\
                        \x1b[0;38;5;3;48;5;4m▀\x1b[0;38;5;4m▄\x1b[0m\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }
}
