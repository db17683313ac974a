//! All ways to fill a half of the board, merged.
//!
//! Where squares may be turned and the whole border is prescribed, sides of one color pair up:
//! of the squares not yet used there must be a side of its color for every open place and every
//! outer side still to come, and the others must be even in number. What breaks that is dropped.

use super::plan::{ENOUGH, LANES, ONES, Plan, Stage};
use rayon::prelude::*;

/// Ways to fill the cells so far that cannot be told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Partial {
    /// What it is told apart by: the colors shown to empty cells, and the squares used.
    pub(super) key: u128,
    /// How many ways there are.
    pub(super) ways: u128,
}

impl Partial {
    pub(super) fn new(used: u64, shown: u64, ways: u128) -> Self {
        Self { key: u128::from(shown) << 64 | u128::from(used), ways }
    }

    /// The squares used, of those that look the same the first ones.
    #[inline(always)]
    pub(super) fn used(&self) -> u64 {
        self.key as u64
    }

    /// The colors shown to empty cells.
    #[inline(always)]
    pub(super) fn shown(&self) -> u64 {
        (self.key >> 64) as u64
    }
}

/// The partial packings at the end of a half, by their keys, and how many there were on the way;
/// only those with this tile of the list in the first cell, if asked for.
pub(super) fn sweep(plan: &Plan, stages: &[Stage], first: Option<usize>) -> (Vec<Partial>, u64) {
    let mut now = vec![Partial::new(0, 0, 1)];
    let mut steps = 0;
    for (at, stage) in stages.iter().enumerate() {
        let only = first.filter(|_| at == 0);
        let laid = |partial: &Partial| {
            let partial = *partial;
            let list = stage.list(partial.shown()).iter().enumerate();
            list.filter_map(move |(number, laid)| {
                let free = laid.class & !partial.used();
                if free == 0 || only.is_some_and(|only| only != number) {
                    return None;
                }
                let used = partial.used() | free & free.wrapping_neg();
                Some(Partial::new(used, stage.after(partial.shown(), laid), partial.ways))
            })
        };
        let fits = |partial: &Partial| may_end(plan, stage, partial);
        let mut next: Vec<Partial> = now.par_iter().flat_map_iter(laid).filter(fits).collect();
        next.par_sort_unstable_by_key(|partial| partial.key);
        next.dedup_by(|a, b| {
            let same = a.key == b.key;
            b.ways += if same { a.ways } else { 0 };
            same
        });
        steps += next.len() as u64;
        now = next;
    }
    if let Some(last) = stages.last() {
        for partial in &mut now {
            *partial =
                Partial::new(partial.used(), in_order(plan, last, partial.shown()), partial.ways);
        }
        now.par_sort_unstable_by_key(|partial| partial.key);
    }
    (now, steps)
}

/// The open colors without gaps, in an order that both halves share.
fn in_order(plan: &Plan, last: &Stage, shown: u64) -> u64 {
    let field = (1u64 << plan.bits) - 1;
    let colors = last.open.iter().enumerate();
    colors.fold(0, |word, (at, slot)| {
        word | (shown >> (slot * plan.bits) & field) << (at * plan.bits)
    })
}

/// Whether the sides of the squares left can pair up; all colors at once, each in a lane of its
/// own.
#[inline(always)]
fn may_end(plan: &Plan, stage: &Stage, partial: &Partial) -> bool {
    if plan.sides.is_empty() {
        return true;
    }
    let unused = (plan.all & !partial.used()).to_le_bytes();
    let left: u128 =
        plan.sides.iter().zip(unused).map(|(sides, byte)| sides[usize::from(byte)]).sum();
    let field = (1u64 << plan.bits) - 1;
    let color = |slot: &usize| (partial.shown() >> (slot * plan.bits) & field) as usize;
    let asked = stage.open.iter().map(|slot| LANES.get(color(slot)).copied().unwrap_or(0));
    let asked: u128 = stage.awaited + asked.sum::<u128>();
    // The top bit of a lane stays where there are enough.
    ((left | ENOUGH) - asked) & (ENOUGH | ONES) == ENOUGH
}
