//! How many cells every covering of a corner set has at least, and why.
//!
//! * As many as there are tiles.
//! * With a side of 1 a window is its own mirror image, so a set with another tile has no such
//!   covering. With a side of 2 a window and its mirror image are shown together, a tile that is
//!   its own mirror image therefore twice: every such pair takes two cells.
//! * In a torus each domino is on the north of as many tiles as on the south, and west of as
//!   many as east. What the set lacks must be made up by tiles that occur again; where it lacks
//!   nothing, a single tile that occurs again has one color.
//! * What these leave is searched to the end for sets of up to 100 tiles, shape by shape, as far
//!   as a number of nodes allows. Only what was searched to the end counts.
//!
//! Source: this project.

use crate::packing::{Settings, Task, find};
use crate::search::Limits;
use crate::tiles::{Kind, TileSet};
use crate::torus::Shape;
use std::collections::{BTreeMap, BTreeSet};

/// Sets of more tiles are not searched.
const MOST_TO_SEARCH: u64 = 100;

/// Four colors: NW, NE, SW, SE.
type Window = [u8; 4];

/// A proven lower bound.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bound {
    /// No covering has fewer cells.
    pub cells: u64,
    /// Why, in words.
    pub reason: String,
    /// The shapes that were searched to the end and have none.
    pub searched: Vec<Shape>,
    /// A covering that the search met, with as many cells as the bound: its torus and labels.
    pub found: Option<(Shape, Vec<u8>)>,
    /// Nodes of the searches.
    pub nodes: u64,
}

/// Why there is no bound.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NoBound {
    /// Only corner tiles.
    #[error("coverings are looked for of corner tiles, not of {0} tiles")]
    Kind(Kind),
    /// Only sets whose tiles are given.
    #[error("the tiles of a compact set are not given: there is nothing to cover")]
    Compact,
    /// More tiles than the search handles.
    #[error("the set has {0} tiles: coverings of up to 60000 are looked for")]
    TooMany(u64),
    /// No covering of any size.
    #[error(
        "no torus shows tile {tile} ({sides}): on its {side} no tile of the set fits that has \
         neighbors itself"
    )]
    Lonely {
        /// The tile.
        tile: u32,
        /// Its colors.
        sides: String,
        /// The side.
        side: &'static str,
    },
}

/// The bound, after searches of up to `nodes` nodes for every shape.
///
/// # Errors
/// When the set has no covering of any size, or is none whose coverings are looked for.
pub fn bound(set: &TileSet, nodes: u64, limits: &Limits<'_>) -> Result<Bound, NoBound> {
    let facts = Facts::new(set)?;
    let mut steps: Vec<String> = Vec::new();
    let mut bound = Bound {
        cells: facts.least(),
        reason: String::new(),
        searched: Vec::new(),
        found: None,
        nodes: 0,
    };
    loop {
        let open = facts.shapes(bound.cells);
        let mut ended = Vec::new();
        for &shape in &open {
            if set.size() > MOST_TO_SEARCH || nodes == 0 || limits.stop.should_stop() {
                break;
            }
            let task =
                Task { cover: shape.cells() as u64 > set.size(), ..Task::new(set.clone(), shape) };
            let limits = Limits { nodes, ..*limits };
            let Ok(answer) = find(&task, &Settings { limits, ..Settings::PLAIN }) else { break };
            bound.nodes += answer.work.nodes;
            if let Some(labels) = answer.value {
                bound.found = Some((shape, labels));
                break;
            }
            if !answer.work.complete {
                break;
            }
            ended.push(shape);
        }
        if ended.len() < open.len() {
            break;
        }
        steps.push(step(bound.cells, &ended));
        bound.searched.extend(ended);
        bound.cells += 1;
    }
    bound.reason = facts.reason(&steps);
    Ok(bound)
}

/// Why so many cells are not enough, after the shapes searched.
fn step(cells: u64, searched: &[Shape]) -> String {
    if searched.is_empty() {
        return format!("{cells} cells have no shape");
    }
    let shapes: Vec<String> = searched.iter().map(Shape::to_string).collect();
    format!("{cells} cells: {} searched to the end", shapes.join(", "))
}

/// Why no torus of this shape has a covering, by an argument.
///
/// # Errors
/// As [`bound`].
pub fn excluded(set: &TileSet, shape: Shape) -> Result<Option<String>, NoBound> {
    Ok(Facts::new(set)?.excluded(shape))
}

/// What the arguments need to know of a set.
#[derive(Debug)]
pub(super) struct Facts {
    tiles: u64,
    /// Whether all tiles are their own mirror images, north to south and west to east.
    plain: [bool; 2],
    /// Tiles counted with their mirror images; `None` when one is missing.
    pairs: [Option<u64>; 2],
    /// Tiles that must occur again to make up for what the set lacks.
    lacking: u64,
    one_colored: bool,
    /// Whether exchanging rows and columns keeps the set.
    transposable: bool,
}

impl Facts {
    /// Looks at the tiles.
    pub(super) fn new(set: &TileSet) -> Result<Self, NoBound> {
        if set.kind() != Kind::Corner {
            return Err(NoBound::Kind(set.kind()));
        }
        if set.is_compact() {
            return Err(NoBound::Compact);
        }
        if set.size() > 60_000 {
            return Err(NoBound::TooMany(set.size()));
        }
        let tiles: Vec<Window> = set
            .allowed()
            .map(|tile| {
                let [ne, se, sw, nw] = set.kind().unpack(tile, set.colors());
                [nw, ne, sw, se]
            })
            .collect();
        lonely(set, &tiles)?;
        let all: BTreeSet<Window> = tiles.iter().copied().collect();
        let mirrors: [fn(Window) -> Window; 2] =
            [|[a, b, c, d]| [c, d, a, b], |[a, b, c, d]| [b, a, d, c]];
        let pairs = mirrors.map(|mirror| {
            let closed = all.iter().all(|&tile| all.contains(&mirror(tile)));
            closed.then(|| all.iter().filter(|&&tile| tile <= mirror(tile)).count() as u64)
        });
        let plain = mirrors.map(|mirror| all.iter().all(|&tile| tile == mirror(tile)));
        let transposable = all.iter().all(|&[a, b, c, d]| all.contains(&[a, c, b, d]));
        Ok(Self {
            tiles: set.size(),
            plain,
            pairs,
            lacking: lacking(&tiles),
            one_colored: tiles.iter().any(|tile| tile.iter().all(|&color| color == tile[0])),
            transposable,
        })
    }

    /// The cells without which no shape need be looked at.
    fn least(&self) -> u64 {
        self.tiles + self.lacking
    }

    /// Why this torus has no covering.
    pub(super) fn excluded(&self, shape: Shape) -> Option<String> {
        let (cells, least) = (shape.cells() as u64, self.least());
        if cells < least {
            let lacking = match self.lacking {
                0 => String::new(),
                count => format!(" and lacks {count} to have the same dominoes on opposite sides"),
            };
            return Some(format!("{cells} cells, but the set has {} tiles{lacking}", self.tiles));
        }
        if cells == self.tiles + 1 && self.lacking == 0 && !self.one_colored {
            return Some("a single tile that occurs again has one color, and there is none".into());
        }
        for (axis, side) in [shape.height(), shape.width()].into_iter().enumerate() {
            if side == 1 && !self.plain[axis] {
                return Some(
                    "with a side of 1 every window is its own mirror image, and other tiles are \
                     never shown"
                        .into(),
                );
            }
            if side != 2 {
                continue;
            }
            match self.pairs[axis] {
                None => {
                    return Some(
                        "with a side of 2 the mirror image of every window is shown, and the set \
                         lacks that of a tile"
                            .into(),
                    );
                }
                Some(pairs) if cells < 2 * pairs => {
                    return Some(format!(
                        "with a side of 2 every window is shown with its mirror image, which \
                         takes {} cells",
                        2 * pairs
                    ));
                }
                Some(_) => {}
            }
        }
        None
    }

    /// The shapes of so many cells that no argument excludes, the squarest first; of two that
    /// are alike for this set the wider one.
    pub(super) fn shapes(&self, cells: u64) -> Vec<Shape> {
        let heights = (1..=cells.isqrt()).rev().filter(|&height| cells.is_multiple_of(height));
        let mut shapes = Vec::new();
        for height in heights {
            let width = cells / height;
            let both = [(width, height), (height, width)];
            let number = if self.transposable || width == height { 1 } else { 2 };
            shapes.extend(both[..number].iter().filter_map(|&(w, h)| Shape::new(w, h).ok()));
        }
        shapes.retain(|&shape| self.excluded(shape).is_none());
        shapes
    }

    fn reason(&self, steps: &[String]) -> String {
        let mut reason = format!("there are {} tiles", self.tiles);
        if self.lacking > 0 {
            reason += &format!(
                ", and {} of them must occur again for the same dominoes on opposite sides",
                self.lacking
            );
        }
        if steps.is_empty() {
            return reason;
        }
        let thin = match self.pairs {
            [Some(a), Some(b)] => format!("; a side of 2 takes {} cells", 2 * a.min(b)),
            _ => "; a side of 2 shows mirror images that are not in the set".to_owned(),
        };
        if self.plain == [false, false] {
            reason += "; with a side of 1 not all tiles are shown";
        }
        format!("{reason}{thin}; {}", steps.join("; "))
    }
}

/// How many tiles must occur again so that opposite sides show the same dominoes equally often:
/// each makes up for one on each side at most.
fn lacking(tiles: &[Window]) -> u64 {
    let mut surplus: [BTreeMap<(u8, u8), i64>; 2] = Default::default();
    for &[nw, ne, sw, se] in tiles {
        for (axis, more, less) in [(0, (nw, ne), (sw, se)), (1, (nw, sw), (ne, se))] {
            *surplus[axis].entry(more).or_default() += 1;
            *surplus[axis].entry(less).or_default() -= 1;
        }
    }
    let sum = |counts: &BTreeMap<_, i64>| counts.values().map(|&count| count.max(0)).sum::<i64>();
    surplus.iter().map(sum).max().unwrap_or(0) as u64
}

/// Finds a tile that no torus shows: tiles without a neighbor on some side are put away until
/// every tile left has one on every side.
fn lonely(set: &TileSet, tiles: &[Window]) -> Result<(), NoBound> {
    let sides = ["north side", "south side", "west side", "east side"];
    let dominoes = |[nw, ne, sw, se]: Window| [(nw, ne), (sw, se), (nw, sw), (ne, se)];
    let mut there: [BTreeSet<(u8, u8)>; 4] = Default::default();
    for &tile in tiles {
        for (side, domino) in there.iter_mut().zip(dominoes(tile)) {
            side.insert(domino);
        }
    }
    // The first tile without a neighbor is one too many: every tile of the set is needed.
    for (id, &tile) in set.allowed().zip(tiles) {
        for (side, domino) in dominoes(tile).into_iter().enumerate() {
            if !there[side ^ 1].contains(&domino) {
                let sides_of = set.kind().describe(id, set.colors());
                return Err(NoBound::Lonely { tile: id.0, sides: sides_of, side: sides[side] });
            }
        }
    }
    Ok(())
}
