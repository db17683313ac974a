//! An automorphism to look for packings with, when nobody says which.
//!
//! The more cells an orbit has, the fewer there are to choose: so the largest order `k` comes
//! first that divides the number of colors, with the permutation that adds `C / k` to every color
//! (no power of it but the identity keeps a color) and a translation by the `k`-th part of a side,
//! the longer one first, for the frontier of the search is then short. What suits a set need not
//! suit a packing: some of these symmetries have none.
//!
//! Source: this project (search.md 1: complete sets over four colors and compact ones over five to
//! eight were first found so).

use super::{Automorphism, ColorMap};
use crate::tiles::TileSet;
use crate::torus::Shape;

/// An automorphism that the set and the torus allow, or `None` when no translation of this sort
/// does.
pub fn suggest(set: &TileSet, shape: Shape, cover: bool) -> Option<Automorphism> {
    let (h, v) = (set.colors().horizontal(), set.colors().vertical());
    let (width, height) = (shape.width(), shape.height());
    (2..=h.min(v)).rev().filter(|k| h.is_multiple_of(*k) && v.is_multiple_of(*k)).find_map(|k| {
        let add = |count: usize| (0..count).map(|c| ((c + count / k) % count) as u8).collect();
        let map = ColorMap::new(set.colors(), add(h), add(v))?;
        let along = |side: usize| side.is_multiple_of(k).then_some((side / k) as u32);
        let east = along(width).map(|dx| (dx, 0));
        let south = along(height).map(|dy| (0, dy));
        let steps = if width >= height { [east, south] } else { [south, east] };
        let found =
            steps.into_iter().flatten().map(|(dx, dy)| Automorphism { dx, dy, map: map.clone() });
        found.into_iter().find(|automorphism| automorphism.check(set, shape, cover).is_ok())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tiles::{Colors, Kind, Members};

    #[test]
    fn what_is_suggested() {
        for (kind, (h, v), members, size, wanted) in [
            (Kind::Corner, (4, 4), Members::Complete, "16x16", Some("4,0:1,2,3,0")),
            (Kind::Corner, (3, 3), Members::Complete, "9x9", Some("3,0:1,2,0")),
            (Kind::Corner, (3, 3), Members::Complete, "3x27", Some("0,9:1,2,0")),
            (Kind::Corner, (5, 5), Members::Compact, "25x10", Some("5,0:1,2,3,4,0")),
            (Kind::Corner, (4, 4), Members::Compact, "16x8", Some("4,0:1,2,3,0")),
            (Kind::Wang, (2, 4), Members::Complete, "16x4", Some("8,0:1,0/2,3,0,1")),
            (Kind::Wang, (2, 3), Members::Complete, "9x4", None),
            (Kind::Corner, (1, 1), Members::Complete, "1x1", None),
        ] {
            let set = TileSet::new(kind, Colors::pair(h, v).unwrap(), members).unwrap();
            let shape: Shape = size.parse().unwrap();
            let found = suggest(&set, shape, false);
            assert_eq!(found.as_ref().map(ToString::to_string).as_deref(), wanted, "{size}");
            if let Some(found) = found {
                let text = found.to_string();
                assert_eq!(Automorphism::parse(&text, set.colors(), shape), Ok(found));
            }
        }
    }
}
