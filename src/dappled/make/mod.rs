//! Any field made into a dappled tiling, in one pass.
//!
//! * [`scheme`] says which algorithm a rule allows;
//! * [`pair`] is Algorithm 1 for two labels, [`greedy`] the simpler one for more, both on [`lines`]
//!   that count how tiles repeat, in an order of [`schedule`];
//! * [`cyclic`] is Algorithm 2, for edges that meet;
//! * [`start`] fills what is free.
//!
//! A tiling that is dappled comes back as it is.

pub mod cyclic;
pub mod greedy;
pub mod lines;
pub mod pair;
pub mod schedule;
pub mod scheme;
pub mod start;

use super::{Edges, Field, Limit, Rule};
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
    let same = |limits: [&Limit; 2]| Same(limits.map(|limit| limit.at(0).map_or(u64::MAX, u64::from)));
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
