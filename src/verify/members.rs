//! Which tiles belong to the set, how many they are, and which of them does not occur.
//!
//! A pruned set is the complete one less every tile that shows both colors of an excluded pair:
//! its tiles are the digit strings whose digits are pairwise compatible. They are counted digit
//! by digit, carrying the colors that are still compatible with all digits so far; no formula.

use super::decode::Numbering;
use super::{Fault, Place, Verdict};
use crate::tiles::{Color, Kind, Members, TileId, TileSet};
use crate::torus::Packing;

/// A set of colors, one bit each.
type ColorBits = [u64; 4];

/// The members of a set, from its definition.
#[derive(Debug)]
pub(super) enum Membership<'a> {
    Complete(u64),
    /// The number of tiles; any tile may be one of them.
    Compact(u64),
    Pruned(Pruned<'a>),
    Explicit(&'a [TileId]),
}

impl<'a> Membership<'a> {
    pub(super) fn new(set: &'a TileSet, numbering: &Numbering) -> Self {
        match set.members() {
            Members::Complete => Membership::Complete(numbering.universe()),
            Members::Compact => Membership::Compact(2 * classes(numbering)),
            Members::Pruned(pairs) => Membership::Pruned(Pruned::new(pairs, numbering)),
            Members::Explicit(tiles) => Membership::Explicit(tiles),
        }
    }

    /// The number of tiles in the set.
    pub(super) fn size(&self) -> u64 {
        match self {
            Membership::Complete(size) | Membership::Compact(size) => *size,
            Membership::Pruned(pruned) => pruned.size,
            Membership::Explicit(tiles) => tiles.len() as u64,
        }
    }

    /// Whether the tile, whose number is in range, is a member; for a compact set, may be.
    pub(super) fn holds(&self, tile: TileId, numbering: &Numbering) -> bool {
        match self {
            Membership::Complete(_) | Membership::Compact(_) => true,
            Membership::Pruned(pruned) => pruned.pair_in(numbering.digits(tile)).is_none(),
            Membership::Explicit(tiles) => tiles.binary_search(&tile).is_ok(),
        }
    }

    /// The members in increasing order; none for a compact set, which does not name its own.
    pub(super) fn tiles(&self) -> Box<dyn Iterator<Item = TileId> + '_> {
        match self {
            Membership::Complete(size) => Box::new((0..*size).map(|tile| TileId(tile as u32))),
            Membership::Compact(_) => Box::new(std::iter::empty()),
            Membership::Pruned(pruned) => Box::new(pruned.tiles()),
            Membership::Explicit(tiles) => Box::new(tiles.iter().copied()),
        }
    }
}

/// The number of choices of the colors that the two tiles of a class of a compact set share.
pub(super) fn classes(numbering: &Numbering) -> u64 {
    let r = numbering.radices();
    match numbering.kind() {
        Kind::Corner => r[1] * r[2] * r[3],
        Kind::Wang => r[0] * r[3],
        Kind::Domino => 0,
    }
}

/// Reports the tiles that are not in the set.
pub(super) fn check(
    packing: &Packing,
    numbering: &Numbering,
    members: &Membership<'_>,
    verdict: &mut Verdict,
) {
    verdict.next_sort();
    for (index, &tile) in packing.tiles.iter().enumerate() {
        if members.holds(tile, numbering) {
            continue;
        }
        verdict.add(|| {
            let at = Place::of(index, packing.shape);
            let name = numbering.name(tile);
            match members {
                Membership::Pruned(pruned) => match pruned.pair_in(numbering.digits(tile)) {
                    Some(pair) => Fault::Excluded { at, tile: name, pair },
                    None => Fault::Foreign { at, tile: name },
                },
                _ => Fault::Foreign { at, tile: name },
            }
        });
    }
}

/// A pruned set.
#[derive(Debug)]
pub(super) struct Pruned<'a> {
    pairs: &'a [(Color, Color)],
    radices: Vec<u64>,
    /// For each color, the colors that may stand on the same tile.
    compatible: Vec<ColorBits>,
    size: u64,
}

impl<'a> Pruned<'a> {
    fn new(pairs: &'a [(Color, Color)], numbering: &Numbering) -> Self {
        let radices = numbering.radices().to_vec();
        let mut compatible = vec![[u64::MAX; 4]; 256];
        for &(a, b) in pairs {
            remove(&mut compatible[usize::from(a.0)], b.0);
            remove(&mut compatible[usize::from(b.0)], a.0);
        }
        let mut pruned = Self { pairs, radices, compatible, size: 0 };
        pruned.size = pruned.count(0, [u64::MAX; 4]);
        pruned
    }

    /// The number of ways to choose the digits from `place` on, all of them from `usable` and
    /// compatible with each other.
    fn count(&self, place: usize, usable: ColorBits) -> u64 {
        let radix = self.radices[place] as u8;
        if place + 1 == self.radices.len() {
            return (0..4)
                .map(|word| u64::from((usable[word] & first(radix)[word]).count_ones()))
                .sum();
        }
        let colors = (0..radix).filter(|&color| contains(usable, color));
        colors
            .map(|color| {
                let others = self.compatible[usize::from(color)];
                let left = std::array::from_fn(|word| usable[word] & others[word]);
                self.count(place + 1, left)
            })
            .sum()
    }

    /// The first excluded pair that the digits show.
    fn pair_in(&self, digits: [u8; 4]) -> Option<(u8, u8)> {
        let shown = &digits[..self.radices.len()];
        let shows = |color: Color| shown.contains(&color.0);
        self.pairs.iter().find(|(a, b)| shows(*a) && shows(*b)).map(|(a, b)| (a.0, b.0))
    }

    /// The first place whose digit is incompatible with an earlier one.
    fn clash(&self, digits: &[u64]) -> Option<usize> {
        (1..digits.len()).find(|&place| {
            let others = self.compatible[digits[place] as usize];
            digits[..place].iter().any(|&digit| !contains(others, digit as u8))
        })
    }

    /// The tiles in increasing order, by counting up and skipping all that share a clash.
    fn tiles(&self) -> impl Iterator<Item = TileId> + '_ {
        let mut next = Some(vec![0; self.radices.len()]);
        std::iter::from_fn(move || {
            let mut digits = next.take()?;
            while let Some(place) = self.clash(&digits) {
                digits = self.after(digits, place)?;
            }
            let number = digits.iter().zip(&self.radices).fold(0, |n, (d, radix)| n * radix + d);
            let last = digits.len() - 1;
            next = self.after(digits, last);
            Some(TileId(number as u32))
        })
    }

    /// The next digits that differ at `place` or before, the ones after it 0.
    fn after(&self, mut digits: Vec<u64>, place: usize) -> Option<Vec<u64>> {
        digits[place + 1..].fill(0);
        for i in (0..=place).rev() {
            digits[i] += 1;
            if digits[i] < self.radices[i] {
                return Some(digits);
            }
            digits[i] = 0;
        }
        None
    }
}

/// The colors below `radix`.
fn first(radix: u8) -> ColorBits {
    std::array::from_fn(|word| {
        let bits = usize::from(radix).saturating_sub(64 * word);
        if bits < 64 { (1 << bits) - 1 } else { u64::MAX }
    })
}

fn contains(bits: ColorBits, color: u8) -> bool {
    bits[usize::from(color / 64)] >> (color % 64) & 1 == 1
}

fn remove(bits: &mut ColorBits, color: u8) {
    bits[usize::from(color / 64)] &= !(1 << (color % 64));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles::Colors;

    #[test]
    fn many_colors_are_counted_fast() {
        let set = |count| {
            let members = Members::Pruned(vec![(Color(0), Color(1))]);
            TileSet::new(Kind::Corner, Colors::one(count).unwrap(), members).unwrap()
        };
        for count in [63, 64, 65, 128, 255] {
            let set = set(count);
            let members = Membership::new(&set, &Numbering::new(&set));
            assert_eq!(members.size(), crate::tiles::formula::disjoint_pairs(count, 1), "{count}");
        }
    }

    #[test]
    fn pruned_tiles_are_counted_and_listed() {
        let pairs = |list: &[(u8, u8)]| list.iter().map(|&(a, b)| (Color(a), Color(b))).collect();
        for (h, v) in [(1, 1), (2, 2), (3, 3), (4, 4), (2, 4), (5, 3)] {
            for list in [&[][..], &[(0, 1)], &[(0, 1), (2, 3)], &[(0, 1), (0, 2), (1, 2)]] {
                for kind in [Kind::Corner, Kind::Wang, Kind::Domino] {
                    let colors = Colors::pair(h, v).unwrap();
                    let set = TileSet::new(kind, colors, Members::Pruned(pairs(list)));
                    let Ok(set) = set else { continue };
                    let numbering = Numbering::new(&set);
                    let members = Membership::new(&set, &numbering);
                    let all = (0..numbering.universe()).map(|tile| TileId(tile as u32));
                    let slow: Vec<_> = all.filter(|&t| members.holds(t, &numbering)).collect();
                    assert_eq!(members.tiles().collect::<Vec<_>>(), slow, "{set:?}");
                    assert_eq!(members.size(), slow.len() as u64, "{set:?}");
                    assert_eq!(set.size(), members.size(), "the formula, {set:?}");
                }
            }
        }
    }
}
