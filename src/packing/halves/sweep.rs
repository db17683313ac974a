//! All ways to fill a half of the board, merged.
//!
//! Where squares may be turned and the whole border is prescribed, sides of one color pair up:
//! of the squares not yet used there must be a side of its color for every open place and every
//! outer side still to come, and the others must be even in number. What breaks that is dropped.

use super::plan::{COUNTED, Plan, Stage, bits_of};
use rayon::prelude::*;

/// Ways to fill the cells so far that cannot be told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Partial {
    /// The squares used, of those that look the same the first ones.
    pub(super) used: u64,
    /// The colors shown to empty cells.
    pub(super) shown: u64,
    /// How many ways there are.
    pub(super) ways: u128,
}

impl Partial {
    /// What it is told apart by.
    #[inline(always)]
    pub(super) fn key(&self) -> (u64, u64) {
        (self.shown, self.used)
    }
}

/// The partial packings at the end of a half, by their keys, and how many there were on the way;
/// only those with this tile of the list in the first cell, if asked for.
pub(super) fn sweep(plan: &Plan, stages: &[Stage], first: Option<usize>) -> (Vec<Partial>, u64) {
    let mut now = vec![Partial { used: 0, shown: 0, ways: 1 }];
    let mut steps = 0;
    for (at, stage) in stages.iter().enumerate() {
        let only = first.filter(|_| at == 0);
        let laid = |partial: &Partial| {
            let partial = *partial;
            let list = stage.list(partial.shown).iter().enumerate();
            list.filter_map(move |(number, laid)| {
                let free = laid.class & !partial.used;
                if free == 0 || only.is_some_and(|only| only != number) {
                    return None;
                }
                let used = partial.used | free & free.wrapping_neg();
                Some(Partial { used, shown: stage.after(partial.shown, laid), ..partial })
            })
        };
        let fits = |partial: &Partial| may_end(plan, stage, partial);
        let mut next: Vec<Partial> = now.par_iter().flat_map_iter(laid).filter(fits).collect();
        next.par_sort_unstable_by_key(Partial::key);
        next.dedup_by(|a, b| {
            let same = a.key() == b.key();
            b.ways += if same { a.ways } else { 0 };
            same
        });
        steps += next.len() as u64;
        now = next;
    }
    if let Some(last) = stages.last() {
        for partial in &mut now {
            partial.shown = in_order(plan, last, partial.shown);
        }
        now.par_sort_unstable_by_key(Partial::key);
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

/// Whether the sides of the squares left can pair up.
fn may_end(plan: &Plan, stage: &Stage, partial: &Partial) -> bool {
    let Some(sides) = &plan.sides else { return true };
    let mut left = [0i32; COUNTED];
    for bit in bits_of(!partial.used & plan.all()) {
        for (left, &count) in left.iter_mut().zip(&sides[bit]) {
            *left += i32::from(count);
        }
    }
    for (left, &awaited) in left.iter_mut().zip(&stage.awaited) {
        *left -= i32::from(awaited);
    }
    let field = (1u64 << plan.bits) - 1;
    for slot in &stage.open {
        let color = (partial.shown >> (slot * plan.bits) & field) as usize;
        if color < COUNTED {
            left[color] -= 1;
        }
    }
    left.iter().all(|&left| left >= 0 && left % 2 == 0)
}
