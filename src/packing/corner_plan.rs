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
    /// Whether the first of the windows has this point as its free corner only: a cheap sieve
    /// for the candidates of the general way.
    pub sieve: bool,
    /// The points of its orbit, one step of the automorphism after the other, itself first.
    pub orbit: Vec<u32>,
    /// The windows known from here on, one of every orbit.
    pub windows: Vec<Window>,
    /// The horizontal dominoes (neighbor, point) known from here on, one of every orbit.
    pub across: Vec<(u32, u32)>,
    /// The vertical dominoes (neighbor, point) known from here on, one of every orbit.
    pub along: Vec<(u32, u32)>,
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
        let level_of: Vec<usize> = {
            let mut levels = vec![0; shape.cells()];
            for (level, cell) in representatives.iter().enumerate() {
                levels[rank[cell.index()]] = level;
            }
            rank.iter().map(|&rank| levels[rank]).collect()
        };
        let mut steps: Vec<Step> = representatives
            .iter()
            .map(|&cell| Step {
                cell: cell.0,
                simple: None,
                sieve: false,
                orbit: quotient.orbit(cell).map(|cell| cell.0).collect(),
                windows: Vec::new(),
                across: Vec::new(),
                along: Vec::new(),
            })
            .collect();
        let known_at =
            |cells: &[u32]| cells.iter().map(|&c| level_of[c as usize]).max().unwrap_or(0);
        // Of an orbit, take the member whose last corner is the point that is chosen.
        let pick = |name: Cell, cells: &dyn Fn(Cell) -> Vec<u32>| {
            let level = known_at(&cells(name));
            let chosen = steps[level].cell;
            let mut members = quotient.orbit(name).map(cells);
            let best = members.find(|cells| cells.last() == Some(&chosen));
            (level, best.unwrap_or_else(|| cells(name)))
        };
        let mut found = Vec::new();
        for &name in &representatives {
            for relation in [window, across, along] {
                found.push(pick(name, &|cell| relation(shape, upward, cell)));
            }
        }
        for (level, cells) in found
            .chunks_exact(3)
            .flat_map(|three| three.iter().enumerate())
            .map(|(relation, (level, cells))| (*level, (relation, cells.clone())))
        {
            let step = &mut steps[level];
            match (cells.0, &cells.1[..]) {
                (0, &[a, b, c, free]) => step.windows.push(Window { known: [a, b, c], free }),
                (1, &[neighbor, point]) => step.across.push((neighbor, point)),
                (_, &[neighbor, point]) => step.along.push((neighbor, point)),
                _ => {}
            }
        }
        for (level, step) in steps.iter_mut().enumerate() {
            let is_known = |cell: u32| level_of[cell as usize] < level;
            let sieves = |window: &Window| {
                window.free == step.cell && window.known.into_iter().all(is_known)
            };
            step.windows.sort_by_key(|window| !sieves(window));
            step.sieve = step.windows.first().is_some_and(sieves);
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

/// The corners of the window with this north-west corner, the free one last.
fn window(shape: Shape, upward: bool, cell: Cell) -> Vec<u32> {
    let at = |rows, columns| shape.step(cell, rows, columns).0;
    let (nw, ne, sw, se) = (at(0, 0), at(0, 1), at(1, 0), at(1, 1));
    if upward { vec![sw, se, nw, ne] } else { vec![nw, ne, sw, se] }
}

/// A horizontal domino, its east end last.
fn across(shape: Shape, _: bool, cell: Cell) -> Vec<u32> {
    vec![cell.0, shape.step(cell, 0, 1).0]
}

/// A vertical domino, the end that is visited last.
fn along(shape: Shape, upward: bool, cell: Cell) -> Vec<u32> {
    let south = shape.step(cell, 1, 0).0;
    if upward { vec![south, cell.0] } else { vec![cell.0, south] }
}

/// The known corners of the only window of a step that decides no more than that window and
/// the two dominoes at its free corner.
fn simple(step: &Step) -> Option<[u32; 3]> {
    let &[Window { known, .. }] = &step.windows[..] else { return None };
    let fits = step.sieve
        && step.across[..] == [(known[2], step.cell)]
        && step.along[..] == [(known[1], step.cell)];
    fits.then_some(known)
}
