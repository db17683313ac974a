//! A list of different tiles whose labels may be any numbers.
//!
//! Labels are listed as in tile set files: N, E, S, W for Wang tiles, where N and S have labels
//! of their own and E and W others; NW, NE, SE, SW for corner tiles.

use crate::tiles::{Kind, TileSet};
use std::collections::BTreeSet;

/// Tiles in the order in which they are given, all different.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Set {
    kind: Kind,
    tiles: Vec<[u32; 4]>,
}

/// A list that is no set of tiles.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SetError {
    /// Dominoes.
    #[error("expected corner or Wang tiles, not dominoes")]
    Dominoes,
    /// A tile listed twice; which.
    #[error("tile {0:?} is listed twice")]
    Twice([u32; 4]),
}

impl Set {
    /// These tiles.
    ///
    /// # Errors
    /// Dominoes, a tile listed twice.
    pub fn new(kind: Kind, tiles: Vec<[u32; 4]>) -> Result<Self, SetError> {
        if kind == Kind::Domino {
            return Err(SetError::Dominoes);
        }
        let mut seen = BTreeSet::new();
        match tiles.iter().find(|&&tile| !seen.insert(tile)) {
            Some(&tile) => Err(SetError::Twice(tile)),
            None => Ok(Self { kind, tiles }),
        }
    }

    /// Tiles that are known to be different.
    pub(super) fn of_different(kind: Kind, tiles: Vec<[u32; 4]>) -> Self {
        Self { kind, tiles }
    }

    /// The tiles that a packing of this set may use, by increasing number.
    ///
    /// # Errors
    /// Dominoes.
    pub fn of(set: &TileSet) -> Result<Self, SetError> {
        let kind = set.kind();
        let listed = |sides: [u8; 4]| match kind {
            // NE, SE, SW, NW to NW, NE, SE, SW.
            Kind::Corner => [sides[3], sides[0], sides[1], sides[2]],
            _ => sides,
        };
        let tiles =
            set.allowed().map(|tile| listed(kind.unpack(tile, set.colors())).map(u32::from));
        Self::new(kind, tiles.collect())
    }

    /// Corner or Wang tiles.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The labels of the tiles.
    pub fn tiles(&self) -> &[[u32; 4]] {
        &self.tiles
    }

    /// Whether a tile may have another one to its east.
    pub fn fits_east(&self, west: [u32; 4], east: [u32; 4]) -> bool {
        match self.kind {
            Kind::Wang => west[1] == east[3],
            _ => west[1] == east[0] && west[2] == east[3],
        }
    }

    /// Whether a tile may have another one to its south.
    pub fn fits_south(&self, north: [u32; 4], south: [u32; 4]) -> bool {
        match self.kind {
            Kind::Wang => north[2] == south[0],
            _ => north[3] == south[0] && north[2] == south[1],
        }
    }
}
