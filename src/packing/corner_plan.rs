//! What the color of a lattice point decides, prepared before the search.
//!
//! A corner tile is a window of four lattice points, known once the last of them is. In row
//! order a new point is nearly always the last corner of exactly one window, the *free corner*,
//! whose other three corners are known: then the candidates are one word. At the seams a point
//! may complete up to four windows, or none; with narrow tori or prescribed automorphisms it
//! may even be two corners of one. Those points take a slower, general way.
//!
//! Compact sets give two choices for NE once NW, SW and SE are known, so there the rows are
//! visited from the south: the new point is the NE corner. For the others it is the SE corner.

use super::Task;
use super::quotient::Quotient;
use crate::torus::{Cell, Order, Shape};

/// A window, as the positions of its known corners and its free corner.
///
/// With the free corner SE they are NW, NE, SW and SE; with the free corner NE they are the
/// mirror images SW, SE, NW and NE. Either way `known[2], free` is a horizontal domino and
/// `known[1], free` a vertical one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Window {
    /// The other three corners.
    pub known: [u32; 3],
    /// The free corner.
    pub free: u32,
}

/// Everything that is decided at one level.
#[derive(Debug, Clone)]
pub struct Step {
    /// The lattice point whose color is chosen.
    pub cell: u32,
    /// The known corners of its window, when it is just the free corner of just one window.
    pub simple: Option<[u32; 3]>,
    /// How many of the windows and dominoes, which come first, have this point as their last
    /// one and otherwise known ones: a cheap sieve for the candidates of the general way.
    pub sieve: Sieve,
    /// The points of its orbit, one step of the automorphism after the other, itself first.
    pub orbit: Vec<u32>,
    /// The windows known from here on, one of every orbit.
    pub windows: Vec<Window>,
    /// The horizontal dominoes (neighbor, point) known from here on, one of every orbit.
    pub across: Vec<(u32, u32)>,
    /// The vertical dominoes (neighbor, point) known from here on, one of every orbit.
    pub along: Vec<(u32, u32)>,
}

/// Numbers of windows and dominoes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Sieve {
    /// Windows.
    pub windows: usize,
    /// Horizontal dominoes.
    pub across: usize,
    /// Vertical dominoes.
    pub along: usize,
}

/// The steps of a search over lattice points.
#[derive(Debug, Clone)]
pub struct CornerPlan {
    /// What is known before the search: one step for every orbit of fixed points.
    pub fixed: Vec<Step>,
    /// One step a level.
    pub steps: Vec<Step>,
}

impl CornerPlan {
    /// Plans the visits of all orbits, those with a `fixed` point first.
    pub fn new(task: &Task, quotient: &Quotient, fixed: &[bool]) -> Self {
        let upward = task.set.is_compact();
        let shape = task.shape;
        let visits = visits(shape, task.visiting_order(), upward, fixed, quotient);
        let rank = quotient.first_visits(&visits);
        let representatives = quotient.representatives(&visits);
        let mut level_at = vec![0; shape.cells()];
        for (level, cell) in representatives.iter().enumerate() {
            level_at[rank[cell.index()]] = level;
        }
        let level_of: Vec<usize> = rank.iter().map(|&rank| level_at[rank]).collect();
        let mut steps: Vec<Step> = representatives
            .iter()
            .map(|&cell| Step {
                cell: cell.0,
                simple: None,
                sieve: Sieve::default(),
                orbit: quotient.orbit(cell).map(|cell| cell.0).collect(),
                windows: Vec::new(),
                across: Vec::new(),
                along: Vec::new(),
            })
            .collect();
        for &name in &representatives {
            let orbit = || quotient.orbit(name);
            let windows = orbit().map(|cell| window(shape, upward, cell));
            let (level, [a, b, c, free]) = place(&steps, &level_of, windows);
            steps[level].windows.push(Window { known: [a, b, c], free });
            let dominoes = orbit().map(|cell| across(shape, cell));
            let (level, [neighbor, point]) = place(&steps, &level_of, dominoes);
            steps[level].across.push((neighbor, point));
            let dominoes = orbit().map(|cell| along(shape, upward, cell));
            let (level, [neighbor, point]) = place(&steps, &level_of, dominoes);
            steps[level].along.push((neighbor, point));
        }
        for (level, step) in steps.iter_mut().enumerate() {
            let is_known = |cell: u32| level_of[cell as usize] < level;
            let point = step.cell;
            let window =
                |window: &Window| window.free == point && window.known.into_iter().all(is_known);
            let domino = |domino: &(u32, u32)| domino.1 == point && is_known(domino.0);
            step.windows.sort_by_key(|known| !window(known));
            step.across.sort_by_key(|known| !domino(known));
            step.along.sort_by_key(|known| !domino(known));
            step.sieve = Sieve {
                windows: step.windows.iter().take_while(|known| window(known)).count(),
                across: step.across.iter().take_while(|known| domino(known)).count(),
                along: step.along.iter().take_while(|known| domino(known)).count(),
            };
            step.simple = simple(step);
        }
        let is_fixed = |step: &Step| step.orbit.iter().any(|&cell| fixed[cell as usize]);
        let free = steps.iter().position(|step| !is_fixed(step)).unwrap_or(steps.len());
        let rest = steps.split_off(free);
        Self { fixed: steps, steps: rest }
    }
}

/// All cells in the visiting order, those in orbits with a fixed one first.
fn visits(
    shape: Shape,
    order: Order,
    upward: bool,
    fixed: &[bool],
    quotient: &Quotient,
) -> Vec<Cell> {
    let mut visits = order.cells(shape);
    let row_of = |cell| shape.position(cell).0 as i64;
    let column_of = |cell| shape.position(cell).1 as i64;
    if upward {
        for cell in &mut visits {
            // From row 1 to the north, so that the window at the origin is among the first.
            *cell = shape.step(Cell(0), 1 - row_of(*cell), column_of(*cell));
        }
    }
    visits.sort_by_key(|&cell| !quotient.orbit(cell).any(|cell| fixed[cell.index()]));
    visits
}

/// The level at which an orbit of windows or dominoes is known, and of its members the one
/// whose last point is the one chosen there, if any.
fn place<const K: usize>(
    steps: &[Step],
    level_of: &[usize],
    mut members: impl Iterator<Item = [u32; K]>,
) -> (usize, [u32; K]) {
    // An orbit has at least one member, and all are known at the same level.
    let first = members.next().unwrap_or([0; K]);
    let level = first.iter().map(|&cell| level_of[cell as usize]).max().unwrap_or(0);
    let chosen = |points: &[u32; K]| points[K - 1] == steps[level].cell;
    (level, std::iter::once(first).chain(members).find(chosen).unwrap_or(first))
}

/// The corners of the window with this north-west corner, the free one last.
fn window(shape: Shape, upward: bool, cell: Cell) -> [u32; 4] {
    let at = |rows, columns| shape.step(cell, rows, columns).0;
    let (nw, ne, sw, se) = (at(0, 0), at(0, 1), at(1, 0), at(1, 1));
    if upward { [sw, se, nw, ne] } else { [nw, ne, sw, se] }
}

/// A horizontal domino, its east end last.
fn across(shape: Shape, cell: Cell) -> [u32; 2] {
    [cell.0, shape.step(cell, 0, 1).0]
}

/// A vertical domino, the end that is visited last.
fn along(shape: Shape, upward: bool, cell: Cell) -> [u32; 2] {
    let south = shape.step(cell, 1, 0).0;
    if upward { [south, cell.0] } else { [cell.0, south] }
}

/// The known corners of the only window of a step that decides no more than that window and
/// the two dominoes at its free corner.
fn simple(step: &Step) -> Option<[u32; 3]> {
    let &[Window { known, .. }] = &step.windows[..] else { return None };
    let fits = step.sieve.windows == 1
        && step.across[..] == [(known[2], step.cell)]
        && step.along[..] == [(known[1], step.cell)];
    fits.then_some(known)
}
