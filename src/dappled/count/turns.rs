//! The count where columns meet their end.
//!
//! Going around, the runs that end above the first row must be those that end in the last row. So
//! for each possible combination of them, a *start*, the fillings that lead from it back to it are
//! counted; every column begins with the runs of the start and must end with them, which leaves few
//! states. A column of one tile that breaks a limit breaks it here, too, for its run is as long as
//! runs are told apart, and stays so.
//!
//! Starts that shifts, a reflection of the rows and permutations of the tiles make of each other
//! lead to as many fillings: where the rule is the same everywhere, one of each kind is enough.

use super::CountError;
use super::line::{Ends, Task};
use super::plane::Plane;
use super::sweep::{Lines, Sweep, bits};
use crate::dappled::Condition;
use std::collections::{BTreeMap, HashSet};

/// Permutations are looked for among so many tiles at most.
const MOST_PERMUTED: usize = 5;

/// What columns begin with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Start {
    /// The runs of each column.
    pub(super) runs: Vec<Vec<u32>>,
    /// How many starts it stands for.
    pub(super) alike: u32,
}

/// What makes a start of another that leads to as many fillings.
#[derive(Debug, Clone)]
pub(super) struct Image {
    /// By column the column it goes to.
    columns: Vec<usize>,
    /// By tile the tile it becomes.
    pub(super) tiles: Vec<u8>,
    /// By condition of columns the condition it becomes.
    conditions: Vec<usize>,
}

impl Image {
    /// The image of a start.
    pub(super) fn of(&self, runs: &[Vec<u32>]) -> Vec<Vec<u32>> {
        let mut image = vec![Vec::new(); runs.len()];
        for (&to, runs) in self.columns.iter().zip(runs) {
            let mut permuted = vec![0; runs.len()];
            for (&to, &run) in self.conditions.iter().zip(runs) {
                permuted[to] = run;
            }
            image[to] = permuted;
        }
        image
    }

    /// Where a column goes.
    pub(super) fn column(&self, column: usize) -> usize {
        self.columns[column]
    }
}

/// All images, the first of which changes nothing.
pub(super) fn images(plane: &Plane, by: Option<u8>) -> Vec<Image> {
    let width = plane.width();
    let conditions: Vec<&Condition> = plane.down().collect();
    let same: Vec<u8> = (0..plane.rule().tiles() as u8).collect();
    let identity = |columns: Vec<usize>| Image {
        columns,
        tiles: same.clone(),
        conditions: (0..conditions.len()).collect(),
    };
    let mut images = vec![identity((0..width).collect())];
    if !plane.is_even() {
        return images;
    }
    let shifts = if plane.rows_meet() { width } else { 1 };
    for shift in 0..shifts {
        images.push(identity((0..width).map(|x| (x + shift) % width).collect()));
        images.push(identity((0..width).map(|x| (2 * width - 1 - x - shift) % width).collect()));
    }
    images.remove(1);
    let all = plane.rule().conditions();
    let permuted = |set: u64, tiles: &[u8]| {
        let image = tiles.iter().enumerate().filter(|&(tile, _)| set >> tile & 1 == 1);
        image.fold(0u64, |image, (_, &to)| image | 1 << to)
    };
    for tiles in permutations(same.len()) {
        let fixed = by.is_none_or(|tile| tiles[usize::from(tile)] == tile);
        let kept = all.iter().all(|condition| {
            let set = permuted(condition.set, &tiles);
            all.iter().any(|other| *other == Condition { set, ..condition.clone() })
        });
        if !fixed || !kept || tiles == same {
            continue;
        }
        let to = |condition: &&Condition| {
            let set = permuted(condition.set, &tiles);
            conditions.iter().position(|other| **other == Condition { set, ..(*condition).clone() })
        };
        let Some(to) = conditions.iter().map(to).collect::<Option<Vec<_>>>() else { continue };
        let moved: Vec<Vec<usize>> = images
            .iter()
            .filter(|image| image.tiles == same)
            .map(|image| image.columns.clone())
            .collect();
        let image = |columns| Image { columns, tiles: tiles.clone(), conditions: to.clone() };
        images.extend(moved.into_iter().map(image));
    }
    images
}

/// All permutations of few tiles; of many only the one that changes nothing.
fn permutations(tiles: usize) -> Vec<Vec<u8>> {
    let mut all = vec![Vec::new()];
    for tile in 0..tiles as u8 {
        if tiles > MOST_PERMUTED {
            all[0].push(tile);
            continue;
        }
        all = all
            .into_iter()
            .flat_map(|shorter: Vec<u8>| {
                (0..=shorter.len()).map(move |at| {
                    let mut longer = shorter.clone();
                    longer.insert(at, tile);
                    longer
                })
            })
            .collect();
    }
    all
}

/// All starts, one of each kind.
///
/// # Errors
/// Too many states, or more memory than `memory` bytes.
pub(super) fn starts(
    plane: &Plane,
    images: &[Image],
    memory: usize,
) -> Result<Vec<Start>, CountError> {
    let (width, height) = (plane.width(), plane.height());
    let mut lines = Lines::default();
    let tasks: Vec<Task> = (0..width).map(|x| plane.column(x, Ends::Runs)).collect();
    let longest = tasks.iter().flat_map(|task| task.demands.iter().map(|demand| demand.longest));
    // Of so many rows at the end the runs tell.
    let tail = longest.max().unwrap_or(0) as usize;
    let cut = |mut task: Task| {
        task.given.drain(..height - tail);
        for demand in &mut task.demands {
            demand.limits.drain(..height - tail);
        }
        task
    };
    let columns = tasks.into_iter().map(|task| lines.line(cut(task)));
    let columns: Vec<_> = columns.collect::<Result<_, _>>()?;
    let rows = (height - tail..height).map(|y| lines.line(plane.row(y)));
    let rows: Vec<_> = rows.collect::<Result<_, _>>()?;
    let mut sweep = Sweep::new(columns.clone(), rows, None)?;
    while !sweep.is_done() {
        sweep.step();
        super::within(memory, sweep.bytes() + sweep.table().len() * 96 * width)?;
    }
    let digits: Vec<u32> = columns.iter().map(|line| bits(line.states(tail))).collect();
    let runs = |state: u64| {
        let mut below: u32 = digits.iter().sum();
        let column = |(line, &bits): (&std::sync::Arc<super::line::Line>, &u32)| {
            below -= bits;
            line.runs(tail, (state >> below & ((1 << bits) - 1)) as u32).to_vec()
        };
        columns.iter().zip(&digits).map(column).collect::<Vec<_>>()
    };
    if images.len() == 1 {
        let start = |state| Start { runs: runs(state), alike: 1 };
        return Ok(sweep.table().states().map(start).collect());
    }
    let all: HashSet<Vec<Vec<u32>>> = sweep.table().states().map(runs).collect();
    let mut kinds: BTreeMap<Vec<Vec<u32>>, u32> = BTreeMap::new();
    for runs in &all {
        let least = images.iter().map(|image| image.of(runs)).min();
        if let Some(least) = least {
            *kinds.entry(least).or_default() += 1;
        }
    }
    Ok(kinds.into_iter().map(|(runs, alike)| Start { runs, alike }).collect())
}

/// The fillings that lead from a start back to it, not yet counted.
///
/// # Errors
/// Too many states.
pub(super) fn sweep(
    plane: &Plane,
    start: &Start,
    by: Option<u8>,
    lines: &mut Lines,
) -> Result<Sweep, CountError> {
    let columns = start.runs.iter().enumerate();
    let columns = columns.map(|(x, runs)| lines.line(plane.column(x, Ends::Turn(runs.clone()))));
    let columns = columns.collect::<Result<_, _>>()?;
    let rows = (0..plane.height()).map(|y| lines.line(plane.row(y)));
    Sweep::new(columns, rows.collect::<Result<_, _>>()?, by)
}
