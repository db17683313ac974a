//! What is known about a packing besides its tiles.
//!
//! A bare text grid says neither its kind nor its colors; the first line of a grid or the
//! caller can. When both speak, they must agree.

use crate::tiles::{Colors, Kind, Members, TileError, TileSet, notation};
use crate::torus::Shape;

/// What a caller, or the first line of a grid, says about the packings of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Claim {
    /// The kind of the tiles.
    pub kind: Option<Kind>,
    /// The numbers of colors; for dominoes `CV` counts along a row and `CH` down a column.
    pub colors: Option<Colors>,
    /// The set.
    pub members: Option<Members>,
    /// Whether it is a covering.
    pub cover: Option<bool>,
}

impl Claim {
    /// What this claim says, else what the other one says.
    pub(super) fn or(self, other: &Claim) -> Claim {
        Claim {
            kind: self.kind.or(other.kind),
            colors: self.colors.or(other.colors),
            members: self.members.or_else(|| other.members.clone()),
            cover: self.cover.or(other.cover),
        }
    }

    /// Says how a file contradicts this claim.
    pub(super) fn contradiction(
        &self,
        set: &TileSet,
        shape: Shape,
        cover: bool,
    ) -> Result<Option<String>, TileError> {
        let differ = |what: &str, file: String, asked: String| {
            (file != asked).then(|| format!("{what} {file} in the file, but {asked} was asked for"))
        };
        let kind = set.kind();
        if let Some(asked) = self.kind
            && asked != kind
        {
            return Ok(differ("kind", kind.to_string(), asked.to_string()));
        }
        if let Some(asked) = self.colors {
            let asked = ring_colors(kind, shape, asked);
            if asked != set.colors() {
                return Ok(differ("colors", set.colors().to_string(), asked.to_string()));
            }
        }
        if let Some(asked) = &self.members {
            let asked = TileSet::new(kind, set.colors(), asked.clone())?;
            if asked != *set {
                let [file, asked] = [set, &asked].map(|s| notation::write_members(s.members()));
                let same_words = file == asked;
                let other = if same_words { format!("{asked}, but others,") } else { asked };
                return Ok(differ("set", file, other));
            }
        }
        Ok(self.cover.filter(|&asked| asked != cover).map(|asked| {
            let word = |cover| if cover { "covering" } else { "packing" };
            format!("a {} in the file, but a {} was asked for", word(cover), word(asked))
        }))
    }
}

/// The colors of a packing of this shape: dominoes have those of the axis of their ring.
pub(super) fn ring_colors(kind: Kind, shape: Shape, colors: Colors) -> Colors {
    if kind == Kind::Domino { shape.ring_colors(colors) } else { colors }
}
