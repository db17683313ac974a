//! What cuts the tree of corner packings, each to be switched off: the packings stay the same,
//! the nodes do not.
//!
//! | name | law | file |
//! |---|---|---|
//! | `caps` | no domino occurs more often than in the tiles of the set | [`caps`](super::caps) |
//! | `last-rows` | the rows still open can be closed with tiles still free | [`last_lines`](super::last_lines) |
//!
//! What each saves stands in `docs/search.md`. Caps cost nearly nothing and are always worth
//! their while; the look at the last rows takes longer than the nodes it saves, but for
//! estimates, which make one of their own.

use std::fmt;
use std::str::FromStr;

/// Which prunings are in use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Prunings {
    /// Dominoes are counted.
    pub caps: bool,
    /// Whether the last lines can be filled is looked at.
    pub last_lines: bool,
}

impl Default for Prunings {
    fn default() -> Self {
        Self { caps: true, last_lines: false }
    }
}

impl Prunings {
    fn names(self) -> impl Iterator<Item = &'static str> {
        let all = [(self.caps, "caps"), (self.last_lines, "last-rows")];
        all.into_iter().filter_map(|(used, name)| used.then_some(name))
    }
}

impl fmt::Display for Prunings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.names().collect();
        f.write_str(if names.is_empty() { "none" } else { "" })?;
        f.write_str(&names.join(","))
    }
}

impl FromStr for Prunings {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut prunings = Self { caps: false, last_lines: false };
        if text == "none" {
            return Ok(prunings);
        }
        for name in text.split(',') {
            match name {
                "caps" => prunings.caps = true,
                "last-rows" => prunings.last_lines = true,
                _ => return Err(format!("'{name}' is none of: caps, last-rows, none")),
            }
        }
        Ok(prunings)
    }
}
