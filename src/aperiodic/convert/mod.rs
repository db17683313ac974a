//! The five constructions of corner sets from Wang sets, and the one back (A. Lagae, *Tile-Based
//! Methods in Computer Graphics*, 2007, sections 8.3 and 8.4), with the conventions that give the
//! numbers of his tables.
//!
//! * **diagonal**: a corner tile for each 2 x 2 block of Wang tiles that match; its colors are
//!   the tiles themselves.
//! * **horizontal**: a corner tile for each pair of Wang tiles side by side; its colors are
//!   those of the four horizontal edges, *(vertical)* the same for tiles above each other.
//! * **rotation**: on the lattice of the middles of edges, turned by 45 degrees: a corner tile for
//!   each Wang tile, and one for each way in which four edges meet in a corner.
//! * **subdivision**: four corner tiles for each Wang tile, about its middle.
//! * **to-wang**: the edges of a corner tile, each with the pair of its colors.
//!
//! Corner tilings by what *diagonal*, *rotation* and *subdivision* give are tilings by the Wang
//! set, so those are aperiodic when it is. For *horizontal* and *vertical* that needs more: see
//! [`super::sound`].

mod labels;

use super::Set;
use crate::tiles::Kind;
use labels::Labels;
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::str::FromStr;

/// A construction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// 2 x 2 blocks.
    Diagonal,
    /// Pairs side by side.
    Horizontal,
    /// Pairs above each other.
    Vertical,
    /// Tiles and corners, turned.
    Rotation,
    /// Quarters.
    Subdivision,
    /// Corner tiles to Wang tiles.
    ToWang,
}

impl Method {
    /// Those that give corner tiles.
    pub const TO_CORNER: [Method; 5] = [
        Method::Diagonal,
        Method::Horizontal,
        Method::Vertical,
        Method::Rotation,
        Method::Subdivision,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Method::Diagonal => "diagonal",
            Method::Horizontal => "horizontal",
            Method::Vertical => "vertical",
            Method::Rotation => "rotation",
            Method::Subdivision => "subdivision",
            Method::ToWang => "to-wang",
        }
    }

    /// The kind of tile that it starts from.
    pub fn from_kind(self) -> Kind {
        if self == Method::ToWang { Kind::Corner } else { Kind::Wang }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Method {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let all = Method::TO_CORNER.into_iter().chain([Method::ToWang]);
        let names: Vec<&str> = all.clone().map(Method::name).collect();
        all.into_iter()
            .find(|method| method.name() == text)
            .ok_or_else(|| format!("expected {}", names.join(", ")))
    }
}

/// What a construction gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Converted {
    /// The tiles, sorted.
    pub set: Set,
    /// Colors as the tables count them.
    pub colors: usize,
    /// Of pairs, as many as there are tiles when no two pairs give the same tile (the published
    /// criterion); of the other constructions `None`.
    pub pairs: Option<usize>,
    /// For *rotation*, how many tiles come from Wang tiles.
    pub white: Option<usize>,
}

impl Converted {
    /// Whether the published criterion holds: different pairs give different tiles.
    pub fn is_injective(&self) -> bool {
        self.pairs.is_none_or(|pairs| pairs == self.set.tiles().len())
    }
}

/// A construction that cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ConvertError {
    /// Tiles of the other kind.
    #[error("{method} starts from {expected} tiles, but these are {found} tiles")]
    Kind {
        /// The construction.
        method: Method,
        /// What it needs.
        expected: Kind,
        /// What was given.
        found: Kind,
    },
    /// More tiles than the limit.
    #[error("{method} gives more than {limit} tiles, the limit")]
    TooMany {
        /// The construction.
        method: Method,
        /// The limit.
        limit: usize,
    },
}

/// The most tiles of a set.
pub const MAX_TILES: usize = 1 << 26;

/// Carries a construction out.
///
/// # Errors
/// Tiles of the wrong kind, and results above [`MAX_TILES`].
pub fn convert(set: &Set, method: Method) -> Result<Converted, ConvertError> {
    let (expected, found) = (method.from_kind(), set.kind());
    if expected != found {
        return Err(ConvertError::Kind { method, expected, found });
    }
    let labels = Labels::of(set);
    let mut pairs = None;
    let mut white = None;
    let (kind, mut tiles, colors) = match method {
        Method::Diagonal => {
            let tiles = diagonal(set).ok_or(ConvertError::TooMany { method, limit: MAX_TILES })?;
            (Kind::Corner, tiles, set.tiles().len())
        }
        Method::Horizontal => {
            let tiles = beside(set.tiles());
            pairs = Some(tiles.len());
            (Kind::Corner, tiles, labels.horizontal.len())
        }
        Method::Vertical => {
            let tiles = above(set.tiles());
            pairs = Some(tiles.len());
            (Kind::Corner, tiles, labels.vertical.len())
        }
        Method::Rotation => {
            let tiles = rotation(set.tiles(), &labels);
            white = Some(set.tiles().len());
            (Kind::Corner, tiles, labels.horizontal.len() + labels.vertical.len())
        }
        Method::Subdivision => {
            let larger = labels.horizontal.len().max(labels.vertical.len());
            let tiles = subdivision(set.tiles(), &labels, larger as u32);
            (Kind::Corner, tiles, set.tiles().len() + larger + 1)
        }
        Method::ToWang => {
            let (tiles, colors) = to_wang(set.tiles());
            (Kind::Wang, tiles, colors)
        }
    };
    tiles.sort_unstable();
    tiles.dedup();
    let set = Set::of_different(kind, tiles);
    Ok(Converted { set, colors, pairs, white })
}

/// Tiles by a pair of labels.
fn by<K: std::hash::Hash + Eq>(
    tiles: &[[u32; 4]],
    key: impl Fn([u32; 4]) -> K,
) -> HashMap<K, Vec<u32>> {
    let mut lists: HashMap<K, Vec<u32>> = HashMap::new();
    for (at, &tile) in tiles.iter().enumerate() {
        lists.entry(key(tile)).or_default().push(at as u32);
    }
    lists
}

/// The blocks NW, NE, SE, SW of tiles that match; `None` when there are too many.
fn diagonal(set: &Set) -> Option<Vec<[u32; 4]>> {
    let tiles = set.tiles();
    let (by_west, by_north) = (by(tiles, |tile| tile[3]), by(tiles, |tile| tile[0]));
    let by_both = by(tiles, |tile| (tile[0], tile[3]));
    let none = Vec::new();
    let mut blocks = Vec::new();
    for (nw, a) in tiles.iter().enumerate() {
        for &ne in by_west.get(&a[1]).unwrap_or(&none) {
            for &sw in by_north.get(&a[2]).unwrap_or(&none) {
                let corner = (tiles[ne as usize][2], tiles[sw as usize][1]);
                for &se in by_both.get(&corner).unwrap_or(&none) {
                    if blocks.len() == MAX_TILES {
                        return None;
                    }
                    blocks.push([nw as u32, ne, se, sw]);
                }
            }
        }
    }
    Some(blocks)
}

/// For each pair side by side the labels of its four horizontal edges.
fn beside(tiles: &[[u32; 4]]) -> Vec<[u32; 4]> {
    let by_west = by(tiles, |tile| tile[3]);
    let east_of = |a: &[u32; 4]| by_west.get(&a[1]).into_iter().flatten();
    let pair = |a: [u32; 4], b: [u32; 4]| [a[0], b[0], b[2], a[2]];
    let pairs = tiles.iter().flat_map(|a| east_of(a).map(move |&b| (*a, b)));
    pairs.map(|(a, b)| pair(a, tiles[b as usize])).collect()
}

/// For each pair above each other the labels of its four vertical edges.
fn above(tiles: &[[u32; 4]]) -> Vec<[u32; 4]> {
    let by_north = by(tiles, |tile| tile[0]);
    let south_of = |a: &[u32; 4]| by_north.get(&a[2]).into_iter().flatten();
    let pair = |a: [u32; 4], b: [u32; 4]| [a[3], a[1], b[1], b[3]];
    let pairs = tiles.iter().flat_map(|a| south_of(a).map(move |&b| (*a, b)));
    pairs.map(|(a, b)| pair(a, tiles[b as usize])).collect()
}

/// The tiles W, N, E, S, and the corners in which four edges meet: to the left, above, to the
/// right, below. Labels of horizontal edges come after those of vertical ones.
fn rotation(tiles: &[[u32; 4]], labels: &Labels) -> Vec<[u32; 4]> {
    let shift = labels.vertical.len() as u32;
    let horizontal = |label: u32| shift + labels.horizontal[&label];
    let vertical = |label: u32| labels.vertical[&label];
    let turned =
        |&[n, e, s, w]: &[u32; 4]| [vertical(w), horizontal(n), vertical(e), horizontal(s)];
    let mut all: Vec<[u32; 4]> = tiles.iter().map(turned).collect();
    // By the labels alone: what lies to the left and above is (S, E) of a tile, and so on.
    let corners = |key: fn([u32; 4]) -> (u32, u32)| -> BTreeSet<(u32, u32)> {
        tiles.iter().map(|&tile| key(tile)).collect()
    };
    let lists = |pairs: BTreeSet<(u32, u32)>| {
        let mut lists: HashMap<u32, Vec<u32>> = HashMap::new();
        pairs.into_iter().for_each(|(first, second)| lists.entry(first).or_default().push(second));
        lists
    };
    // North-west tile: left edge is its S, upper edge its E. North-east: its W is the upper edge,
    // its S the right one. South-west: its N is the left edge, its E the lower one. South-east:
    // its N is the right edge, its W the lower one.
    let north_east = lists(corners(|[_, _, s, w]| (w, s)));
    let south_west = lists(corners(|[n, e, _, _]| (n, e)));
    let south_east = corners(|[n, _, _, w]| (n, w));
    let none = Vec::new();
    for (left, up) in corners(|[_, e, s, _]| (s, e)) {
        for &right in north_east.get(&up).unwrap_or(&none) {
            for &down in south_west.get(&left).unwrap_or(&none) {
                if south_east.contains(&(right, down)) {
                    all.push([horizontal(left), vertical(up), horizontal(right), vertical(down)]);
                }
            }
        }
    }
    all
}

/// The quarters of every tile: color 0 in its corners, the labels of its edges from 1 on, then
/// the tile itself in its middle.
fn subdivision(tiles: &[[u32; 4]], labels: &Labels, larger: u32) -> Vec<[u32; 4]> {
    let quarters = |(at, &[n, e, s, w]): (usize, &[u32; 4])| {
        let [n, s] = [n, s].map(|label| 1 + labels.horizontal[&label]);
        let [e, w] = [e, w].map(|label| 1 + labels.vertical[&label]);
        let middle = 1 + larger + at as u32;
        [[0, n, middle, w], [n, 0, e, middle], [middle, e, 0, s], [w, middle, s, 0]]
    };
    tiles.iter().enumerate().flat_map(quarters).collect()
}

/// Every edge with the pair of its colors, west or north first; pairs are numbered in order, for
/// each direction anew. The larger count goes with the tiles.
fn to_wang(tiles: &[[u32; 4]]) -> (Vec<[u32; 4]>, usize) {
    let pairs = |a: (u32, u32), b: (u32, u32)| [a, b];
    let horizontal =
        Labels::number(tiles.iter().flat_map(|&[nw, ne, se, sw]| pairs((nw, ne), (sw, se))));
    let vertical =
        Labels::number(tiles.iter().flat_map(|&[nw, ne, se, sw]| pairs((nw, sw), (ne, se))));
    let tile = |&[nw, ne, se, sw]: &[u32; 4]| {
        [horizontal[&(nw, ne)], vertical[&(ne, se)], horizontal[&(sw, se)], vertical[&(nw, sw)]]
    };
    (tiles.iter().map(tile).collect(), horizontal.len().max(vertical.len()))
}
