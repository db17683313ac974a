//! Any field made into a dappled tiling, in one pass where that can be.
//!
//! * [`scheme`] says which algorithm a rule allows;
//! * [`mod@pair`] is Algorithm 1 for two labels, [`greedy`] the simpler one for more, both on [`lines`]
//!   that count how tiles repeat, in an order of [`schedule`];
//! * [`cyclic`] is Algorithm 2, for edges that meet;
//! * [`repair`] is exact: for edges that meet where Algorithm 2 has nothing to say, for limits of 1,
//!   for sets that overlap;
//! * [`start`] fills what is free.
//!
//! A tiling that is dappled comes back as it is.

pub mod cyclic;
pub mod greedy;
pub mod lines;
pub mod pair;
pub mod repair;
pub mod schedule;
pub mod scheme;
pub mod start;

use super::exact::{Completion, ExactError};
use super::{Edges, Field, Limit, Rule, faults};
use crate::search::Stop;
use greedy::Pass;
use lines::{Runs, Shared};
use pair::{Bounds, Pair, Same};
use schedule::Step;
use scheme::{Classes, Greedy, Scheme};

/// The order of Algorithm 1; results differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Anti-diagonals, from west to east in each: that of the paper.
    Diagonal,
    /// Anti-diagonals, in each first the even columns, then the odd ones: in parallel.
    Wavefront,
}

/// How to go on.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// The order of cells.
    pub order: Order,
    /// Of random choices among three tiles and more.
    pub seed: u64,
}

/// How a tiling came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// It was dappled from the start.
    Unchanged,
    /// Algorithm 1 for two tiles or classes of tiles.
    Pair,
    /// Algorithm 1 for more.
    Greedy,
    /// Algorithm 2.
    Cyclic,
    /// A pass, and what was left to do exactly.
    Repaired,
    /// Two dappled words, one along the rows and one along the columns.
    Words,
}

/// What became of a field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Made {
    /// A tiling.
    Tiling(Field, How),
    /// No field of this size is dappled: proved.
    Impossible,
    /// Stopped before the answer was known.
    Stopped,
}

/// Changes a field without free cells into a dappled tiling.
///
/// # Errors
/// A field for which there is no algorithm in one pass and that is too large for an exact answer.
pub fn make(
    rule: &Rule,
    start: Field,
    options: Options,
    stop: &dyn Stop,
) -> Result<Made, ExactError> {
    // In one pass, free edges: a dappled field comes back anyway.
    if rule.edges() != Edges::Free && faults::is_faultless(rule, &start) {
        return Ok(Made::Tiling(start, How::Unchanged));
    }
    let (field, how, sure) = pass(rule, start, options);
    if sure || faults::is_faultless(rule, &field) {
        return Ok(Made::Tiling(field, how));
    }
    match repair::repair(rule, field, stop) {
        Ok(Completion::Found(field)) => Ok(Made::Tiling(field, How::Repaired)),
        Ok(Completion::Impossible { .. }) => Ok(Made::Impossible),
        answer => match (words(rule), answer) {
            (Some(field), _) => Ok(Made::Tiling(field, How::Words)),
            (None, Err(error)) => Err(error),
            (None, _) => Ok(Made::Stopped),
        },
    }
}

/// A tiling for edges that meet, two classes, and limits from 2 on: `f(i, j) = u(i) xor v(j)` of
/// two words in which, in a circle, no label stands more than twice. There are none of length 1.
fn words(rule: &Rule) -> Option<Field> {
    let Scheme::Pair(classes) = scheme::scheme(rule) else {
        return None;
    };
    let (width, height) = (rule.width(), rule.height());
    // 0101.. or, for an odd length, 00101..
    let word = |length: usize, at: usize| (at + 1 - length % 2 * usize::from(at > 0)) % 2;
    let cells = (0..width * height).map(|cell| {
        let label = word(width, cell % width) ^ word(height, cell / width) ^ 1;
        classes.sets[label & 1].trailing_zeros() as u8
    });
    Some(Field::of(width, height, cells.collect()))
        .filter(|field| faults::is_faultless(rule, field))
}

/// One pass of the algorithm that a rule allows, from a field without free cells; and whether the
/// result is sure to be dappled.
pub fn pass(rule: &Rule, start: Field, options: Options) -> (Field, How, bool) {
    let free = rule.edges() == Edges::Free;
    match scheme::scheme(rule) {
        Scheme::Pair(classes) if !free && classes.uniform_from(3) => {
            let edges = rule.edges();
            let change = |mut labels: Field| {
                cyclic::rectify(&mut labels, &classes, edges);
                labels
            };
            (by_class(start, &classes, options.seed, change), How::Cyclic, false)
        }
        Scheme::Pair(classes) => {
            let change = |labels| pair(labels, &classes, options.order);
            (by_class(start, &classes, options.seed, change), How::Pair, free)
        }
        Scheme::Greedy(greedy) => (run_greedy(rule, start, &greedy, options), How::Greedy, free),
        Scheme::Neither(greedy) => (run_greedy(rule, start, &greedy, options), How::Greedy, false),
    }
}

/// Changes a field by what happens to its classes: a cell whose class stays keeps its tile.
fn by_class(
    field: Field,
    classes: &Classes,
    seed: u64,
    change: impl FnOnce(Field) -> Field,
) -> Field {
    if classes.sets == [1, 2] {
        return change(field);
    }
    let class = |tile: u8| (classes.sets[1] >> tile & 1) as u8;
    let mut labels = field.clone();
    labels.cells_mut().iter_mut().for_each(|tile| *tile = class(*tile));
    let (labels, mut field) = (change(labels), field);
    for (cell, (tile, &label)) in field.cells_mut().iter_mut().zip(labels.cells()).enumerate() {
        if class(*tile) != label {
            let choices = classes.sets[usize::from(label)];
            *tile = greedy::choose(choices, start::mixed(seed, cell as u64));
        }
    }
    field
}

fn run_greedy(rule: &Rule, mut start: Field, greedy: &Greedy, options: Options) -> Field {
    let shared = Shared::new(&start);
    let pass = Pass::new(&shared, greedy, scheme::all(rule.tiles()), options.seed);
    in_order(&shared, &pass, options.order);
    shared.copy_to(&mut start);
    start
}

/// Labels by class, where limits differ by cell.
#[derive(Debug, Clone, Copy)]
struct Mapped<'a>([&'a Limit; 2]);

impl Bounds for Mapped<'_> {
    fn at(&self, label: u8, cell: usize) -> u64 {
        self.0[usize::from(label & 1)].at(cell).map_or(u64::MAX, u64::from)
    }
}

/// Algorithm 1 on labels 0 and 1.
fn pair(mut labels: Field, classes: &Classes, order: Order) -> Field {
    let shared = Shared::new(&labels);
    let same =
        |limits: [&Limit; 2]| Same(limits.map(|limit| limit.at(0).map_or(u64::MAX, u64::from)));
    match classes.uniform_from(2) {
        true => run_pair(&shared, same(classes.horizontal), same(classes.vertical), order),
        false => run_pair(&shared, Mapped(classes.horizontal), Mapped(classes.vertical), order),
    }
    shared.copy_to(&mut labels);
    labels
}

fn run_pair(labels: &Shared, horizontal: impl Bounds, vertical: impl Bounds, order: Order) {
    let (rows, columns) = (Runs::new(labels.size().1), Runs::new(labels.size().0));
    let pair = Pair { labels, rows, columns, horizontal, vertical };
    in_order(labels, &pair, order);
}

fn in_order(cells: &Shared, step: &impl Step, order: Order) {
    match order {
        Order::Diagonal => schedule::diagonal(cells.size(), step),
        Order::Wavefront => schedule::wavefront(cells.size(), step),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_words_are_a_tiling() {
        for width in 1..14 {
            for height in 1..14 {
                let rule =
                    Rule::uniform((width, height), 2, Edges::Torus, Some(2), Some(2)).unwrap();
                let found = words(&rule);
                assert_eq!(found.is_some(), width > 1 && height > 1);
                assert!(found.is_none_or(|field| rule.accepts(&field)), "{width}x{height}");
            }
        }
    }
}
