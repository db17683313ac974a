//! Counting packings of Wang tiles and squares by merging what cannot be told apart.
//!
//! What lies in the cells filled so far matters to the rest only by the tiles it has used and by
//! the colors it shows to cells still empty. So partial packings are filled in cell by cell, all
//! at once, and those that agree in both are counted as one. That is done from both ends of the
//! board, each half way (`sweep`); a packing is a pair of halves that show each other the same
//! colors and together use every tile. Where tiles are many and colors few, as with MacMahon's
//! squares, that is some thousand times less than all packings; where tiles decide each other,
//! as on boards of the Eternity kind, nothing agrees and nothing is gained.
//!
//! What is prescribed, at the border or inside, thins out both.
//!
//! The tree has one level: the tile in the first cell. A leaf is worked out when somebody asks.

mod plan;
mod sweep;

use super::{Labeled, Task};
use crate::search::{Problem, Words};
use crate::tiles::Kind;
use num_bigint::BigUint;
use plan::{Plan, Stage};
use std::sync::{Arc, OnceLock};
use sweep::{Partial, sweep};

/// Tiles, or squares, at most: a set of them is a word.
const MOST_TILES: usize = 64;
/// Colors at most: there are lists of tiles by the colors of all four sides.
const MOST_COLORS: usize = 32;
/// Bits for the colors shown at once.
const MOST_BITS: usize = 64;

/// Why the packings of a task cannot be counted this way.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HalvesError {
    /// Only Wang tiles.
    #[error("counting by halves is for Wang tiles, not for {0} tiles")]
    Kind(Kind),
    /// Only packings of a given set, with nothing else given.
    #[error("counting by halves cannot do with {0}")]
    Asked(&'static str),
    /// Too many tiles.
    #[error("{0} tiles: counting by halves handles up to {MOST_TILES}")]
    Tiles(u64),
    /// Too many colors.
    #[error("{0} colors: counting by halves handles up to {MOST_COLORS}")]
    Colors(usize),
    /// A cell would meet itself, or too many colors are shown.
    #[error(
        "counting by halves needs sides of at least 2, and a short side that shows no more than \
         {MOST_BITS} bits of colors"
    )]
    Shape,
}

/// Checks that the packings of a task can be counted this way.
///
/// # Errors
/// What stands in the way.
pub fn check(task: &Task) -> Result<(), HalvesError> {
    let (set, shape) = (&task.set, task.shape);
    if set.kind() != Kind::Wang {
        return Err(HalvesError::Kind(set.kind()));
    }
    let asked = [
        (task.cover, "coverings"),
        (set.is_compact(), "compact sets"),
        (task.automorphism.is_some(), "automorphisms"),
    ];
    if let Some((_, what)) = asked.into_iter().find(|(asked, _)| *asked) {
        return Err(HalvesError::Asked(what));
    }
    if set.size() > MOST_TILES as u64 {
        return Err(HalvesError::Tiles(set.size()));
    }
    let colors = set.colors().largest();
    if colors > MOST_COLORS {
        return Err(HalvesError::Colors(colors));
    }
    if shape.width().min(shape.height()) < 2 || !Plan::new(task).fits() {
        return Err(HalvesError::Shape);
    }
    Ok(())
}

/// The tiles of the first cell, and the halves that complete each.
#[derive(Debug, Clone)]
pub struct Halves {
    plan: Arc<Plan>,
    /// The other half, made when first needed.
    behind: Arc<OnceLock<(Vec<Partial>, u64)>>,
    first: u32,
}

impl Halves {
    /// The problem of a task that has been checked.
    pub fn new(task: &Task) -> Self {
        Self { plan: Arc::new(Plan::new(task)), behind: Arc::default(), first: 0 }
    }

    /// The stages of a half: the first half of all cells, or the others from the end.
    fn stages(&self, behind: bool) -> &[Stage] {
        &self.plan.halves[usize::from(behind)]
    }
}

impl Problem for Halves {
    type Alternatives = Words<{ 4 * MOST_TILES / 64 }>;

    /// A leaf takes seconds.
    const FIRST_SLICE: u64 = 1;

    fn levels(&self) -> usize {
        1
    }

    fn alternatives(&mut self, _: usize) -> Self::Alternatives {
        Words::below(self.stages(false)[0].list(0).len())
    }

    fn push(&mut self, _: usize, choice: u32) {
        self.first = choice;
    }

    fn pop(&mut self, _: usize, _: u32) {}
}

impl Labeled for Halves {
    /// Nothing: a leaf stands for many packings, and there are no labels of any.
    fn write_labels(&self, labels: &mut Vec<u8>) {
        labels.clear();
    }

    fn met(&self) -> Option<(u64, BigUint)> {
        let plan = &*self.plan;
        let (ahead, mut steps) = sweep(plan, self.stages(false), Some(self.first as usize));
        // The leaf of the first tile pays for the half that all share.
        let (behind, shared) = self.behind.get_or_init(|| {
            let (mut behind, steps) = sweep(plan, self.stages(true), None);
            for partial in &mut behind {
                let used = plan.complement(partial.used());
                *partial = Partial::new(used, partial.shown(), partial.ways);
            }
            behind.sort_unstable_by_key(|partial| partial.key);
            (behind, steps)
        });
        steps += if self.first == 0 { *shared } else { 0 };
        let mut packings = BigUint::ZERO;
        let mut rest = behind.iter().peekable();
        for half in &ahead {
            while rest.next_if(|other| other.key < half.key).is_some() {}
            if let Some(other) = rest.peek().filter(|other| other.key == half.key) {
                packings += BigUint::from(half.ways) * other.ways;
            }
        }
        Some((steps, packings))
    }
}
