//! Reading tile numbers, straight from the definition.
//!
//! A corner tile has the number `((NE*C + SE)*C + SW)*C + NW` (Lagae 2007, equation 2.5), a Wang
//! tile `((N*CV + E)*CH + S)*CV + W` (equation 2.2, each digit with the radix of its palette), a
//! domino `first*C + second`. Written here a second time on purpose: see [`crate::verify`].

use super::Tile;
use crate::tiles::{Kind, TileId, TileSet};

/// How tile numbers of one kind and palette are read.
#[derive(Debug, Clone)]
pub(super) struct Numbering {
    kind: Kind,
    radices: Vec<u64>,
}

impl Numbering {
    pub(super) fn new(set: &TileSet) -> Self {
        let (h, v) = (set.colors().horizontal() as u64, set.colors().vertical() as u64);
        let radices = match set.kind() {
            Kind::Corner => vec![h, h, h, h],
            Kind::Wang => vec![h, v, h, v],
            Kind::Domino => vec![v, v],
        };
        Self { kind: set.kind(), radices }
    }

    pub(super) fn kind(&self) -> Kind {
        self.kind
    }

    /// The number of colors of each digit, most significant first.
    pub(super) fn radices(&self) -> &[u64] {
        &self.radices
    }

    /// How many tile numbers there are.
    pub(super) fn universe(&self) -> u64 {
        self.radices.iter().product()
    }

    /// The names of the digits, most significant first.
    pub(super) fn names(&self) -> &'static [&'static str] {
        match self.kind {
            Kind::Corner => &["NE", "SE", "SW", "NW"],
            Kind::Wang => &["N", "E", "S", "W"],
            Kind::Domino => &["first", "second"],
        }
    }

    /// The digits of a tile number, most significant first; the places after them are 0.
    pub(super) fn digits(&self, tile: TileId) -> [u8; 4] {
        let mut rest = u64::from(tile.0);
        let mut digits = [0; 4];
        for (digit, &radix) in digits.iter_mut().zip(&self.radices).rev() {
            *digit = (rest % radix) as u8;
            rest /= radix;
        }
        digits
    }

    /// The tile with its colors, for messages.
    pub(super) fn name(&self, tile: TileId) -> Tile {
        let digits = self.digits(tile);
        let named: Vec<String> = self
            .names()
            .iter()
            .zip(digits)
            .map(|(name, color)| format!("{name} {color}"))
            .collect();
        Tile { number: tile.0, colors: named.join(", ") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles::{Colors, Members};

    #[test]
    fn digits_by_hand() {
        let set = |kind, h, v| {
            let colors = Colors::pair(h, v).unwrap();
            Numbering::new(&TileSet::new(kind, colors, Members::Complete).unwrap())
        };
        // NE 1, SE 2, SW 0, NW 2 over three colors: 1*27 + 2*9 + 0*3 + 2.
        assert_eq!(set(Kind::Corner, 3, 3).digits(TileId(47)), [1, 2, 0, 2]);
        // N 1, E 2, S 0, W 1 over CH = 2, CV = 3: ((1*3 + 2)*2 + 0)*3 + 1.
        assert_eq!(set(Kind::Wang, 2, 3).digits(TileId(31)), [1, 2, 0, 1]);
        assert_eq!(set(Kind::Domino, 5, 5).digits(TileId(13)), [2, 3, 0, 0]);
        assert_eq!(set(Kind::Corner, 255, 255).digits(TileId(4_228_250_624)), [254; 4]);
    }
}
