//! Tile sets: which tiles a packing is made of.
//!
//! * **complete**: every tile over the colors.
//! * **compact** (Lagae 2007, 3.2.2; Schlömer 2012, 3.3): for corner tiles, exactly two tiles
//!   with different NE for each (NW, SW, SE); for Wang tiles, exactly two tiles for each (N, W).
//!   Many sets have this property; *which* one a packing uses is free.
//! * **pruned** (Schlömer 2012, 2.4): the complete set less every tile that shows both colors
//!   of an excluded pair. The pairs are the edges of any graph on the colors.
//! * **explicit**: any list of different tiles; or of squares ([`super::turn`]), which may be
//!   equal.
//!
//! Invariant: the colors of every pair and tile lie in their palettes, pairs are `a < b`,
//! sorted and different, explicit tiles are sorted, and different but for squares.

use super::{Color, Colors, Kind, TileError, TileId, formula};

/// Which tiles over the colors belong to a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Members {
    /// All of them.
    Complete,
    /// Two for each (NW, SW, SE) of a corner tile, or each (N, W) of a Wang tile.
    Compact,
    /// All but those that show both colors of one of these pairs.
    Pruned(Vec<(Color, Color)>),
    /// These.
    Explicit(Vec<TileId>),
}

/// A set of tiles of one kind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TileSet {
    kind: Kind,
    colors: Colors,
    members: Members,
}

impl TileSet {
    /// A set of tiles; pairs and tiles are put in order.
    ///
    /// # Errors
    /// A pair or tile out of range, a pair of one color, a tile listed twice, an empty list, a
    /// compact set of dominoes, two palettes for corner tiles.
    pub fn new(kind: Kind, colors: Colors, members: Members) -> Result<Self, TileError> {
        let colors = match kind {
            Kind::Domino => colors.of_row(),
            Kind::Corner if colors.single().is_none() => {
                let (h, v) = (colors.horizontal() as u16, colors.vertical() as u16);
                return Err(TileError::TwoColorCounts(h, v));
            }
            Kind::Corner | Kind::Wang => colors,
        };
        let members = match members {
            Members::Compact if kind == Kind::Domino => return Err(TileError::CompactDomino),
            Members::Pruned(pairs) => Members::Pruned(checked_pairs(pairs, colors)?),
            Members::Explicit(tiles) => Members::Explicit(checked_tiles(tiles, kind, colors)?),
            other => other,
        };
        Ok(Self { kind, colors, members })
    }

    /// The same with tiles listed again: `tiles` are sorted and those of the set.
    pub(super) fn with_repeated(mut self, tiles: Vec<TileId>) -> Self {
        self.members = Members::Explicit(tiles);
        self
    }

    /// The kind of its tiles.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The numbers of colors of its palettes.
    pub fn colors(&self) -> Colors {
        self.colors
    }

    /// Which tiles belong to it.
    pub fn members(&self) -> &Members {
        &self.members
    }

    /// The number of tiles in the set, by formula (see [`formula`]).
    pub fn size(&self) -> u64 {
        match &self.members {
            Members::Complete => self.kind.tiles(self.colors),
            Members::Compact => formula::compact(self.kind, self.colors),
            Members::Pruned(pairs) => formula::pruned(self.kind, self.colors, pairs),
            Members::Explicit(tiles) => tiles.len() as u64,
        }
    }

    /// Whether a packing may use this tile. A compact set may use any.
    pub fn allows(&self, tile: TileId) -> bool {
        match &self.members {
            Members::Complete | Members::Compact => {
                u64::from(tile.0) < self.kind.tiles(self.colors)
            }
            Members::Pruned(pairs) => {
                let sides = self.kind.unpack(tile, self.colors);
                let sides = &sides[..self.kind.sides().len()];
                u64::from(tile.0) < self.kind.tiles(self.colors)
                    && !pairs.iter().any(|(a, b)| sides.contains(&a.0) && sides.contains(&b.0))
            }
            Members::Explicit(tiles) => tiles.binary_search(&tile).is_ok(),
        }
    }

    /// All tiles a packing may use, in increasing order; for every set but the compact ones,
    /// the set itself.
    pub fn allowed(&self) -> Box<dyn Iterator<Item = TileId> + '_> {
        match &self.members {
            Members::Explicit(tiles) => Box::new(tiles.iter().copied()),
            _ => {
                let all = self.kind.tiles(self.colors) as u32;
                Box::new((0..all).map(TileId).filter(|&tile| self.allows(tile)))
            }
        }
    }

    /// Whether the search chooses the tiles of the set (compact) or they are given (all others).
    pub fn is_compact(&self) -> bool {
        self.members == Members::Compact
    }
}

fn checked_pairs(
    pairs: Vec<(Color, Color)>,
    colors: Colors,
) -> Result<Vec<(Color, Color)>, TileError> {
    let max = colors.largest() as u64 - 1;
    let mut checked = Vec::with_capacity(pairs.len());
    for (a, b) in pairs {
        if let Some(bad) = [a, b].into_iter().find(|c| u64::from(c.0) > max) {
            return Err(TileError::ColorRange { color: bad.0.into(), max });
        }
        if a == b {
            return Err(TileError::PairOfOne(a.0));
        }
        checked.push((a.min(b), a.max(b)));
    }
    checked.sort_unstable();
    checked.dedup();
    Ok(checked)
}

fn checked_tiles(
    mut tiles: Vec<TileId>,
    kind: Kind,
    colors: Colors,
) -> Result<Vec<TileId>, TileError> {
    let all = kind.tiles(colors);
    tiles.sort_unstable();
    let Some(&last) = tiles.last() else { return Err(TileError::EmptySet) };
    if u64::from(last.0) >= all {
        return Err(TileError::TileRange { tile: last.0.into(), max: all - 1 });
    }
    if let Some(pair) = tiles.windows(2).find(|pair| pair[0] == pair[1]) {
        let sides = kind.describe(pair[0], colors);
        return Err(TileError::DuplicateTile { tile: pair[0].0, sides });
    }
    Ok(tiles)
}
