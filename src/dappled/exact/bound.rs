//! How few and how many of a tile there can be, by arguments that take no search over the rectangle.
//!
//! * [`Reason::Windows`]: disjoint windows, each of which needs one ([`super::pack`]).
//! * [`Reason::Rows`], [`Reason::Columns`]: each line has a least number, found by the solver for
//!   that line alone; the sum counts.
//!
//! The same for what is not the tile bounds its number from above. Cells that are filled play no
//! part, so the bounds hold for every partial tiling.

use super::encode::Formula;
use super::pack;
use super::sat::{Answer, Literal, Solver};
use super::total::total;
use crate::dappled::{Condition, Direction, Edges, Limit, Rule};
use crate::search::Stop;
use std::collections::HashMap;

/// Longer lines are not looked at.
const LONGEST: usize = 256;

/// Why there are no fewer, or no more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// There are no fewer cells than none, and no more than all.
    Cells,
    /// Disjoint windows.
    Windows,
    /// Each row has some.
    Rows,
    /// Each column has some.
    Columns,
    /// A search.
    Search,
}

/// Bounds for the number of a tile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Bounds {
    pub(super) least: (u32, Reason),
    pub(super) most: (u32, Reason),
    /// For each row the least and the largest number in it.
    pub(super) rows: Vec<(u32, u32)>,
}

/// The bounds of a tile.
pub(super) fn bounds(rule: &Rule, tile: u8, stop: &dyn Stop) -> Bounds {
    let (width, height) = (rule.width(), rule.height());
    let cells = (width * height) as u32;
    let rows = lines(rule, tile, Direction::Horizontal, stop);
    let columns = lines(rule, tile, Direction::Vertical, stop);
    let sum = |lines: &[(u32, u32)]| -> (u32, u32) {
        lines.iter().fold((0, 0), |(a, b), (least, most)| (a + least, b + most))
    };
    let (by_rows, by_columns) = (sum(&rows), sum(&columns));
    let everything = u64::MAX >> (64 - rule.tiles());
    let windows = |set: u64| pack::runs((width, height), lengths(rule, set)).len() as u32;
    let mut least = (0, Reason::Cells);
    let mut most = (cells, Reason::Cells);
    for (few, many, reason) in [
        (windows(everything & !(1 << tile)), cells - windows(1 << tile), Reason::Windows),
        (by_rows.0, by_rows.1, Reason::Rows),
        (by_columns.0, by_columns.1, Reason::Columns),
    ] {
        if few > least.0 {
            least = (few, reason);
        }
        if many < most.0 {
            most = (many, reason);
        }
    }
    Bounds { least, most, rows }
}

/// How long the windows of a set are, where that is the same everywhere and shorter than the lines.
fn lengths(rule: &Rule, set: u64) -> pack::Lengths {
    [(Direction::Horizontal, rule.width()), (Direction::Vertical, rule.height())].map(
        |(direction, line)| {
            let of_it = |c: &&Condition| c.set == set && c.direction == direction;
            let limits = rule.conditions().iter().filter(of_it).filter_map(|c| match c.limit {
                Limit::Same(limit) => Some(limit as usize + 1),
                _ => None,
            });
            limits.min().filter(|&length| length <= line)
        },
    )
}

/// The least and the largest number in each line of a direction.
fn lines(rule: &Rule, tile: u8, direction: Direction, stop: &dyn Stop) -> Vec<(u32, u32)> {
    let (length, number, step, next) = match direction {
        Direction::Horizontal => (rule.width(), rule.height(), 1, rule.width()),
        Direction::Vertical => (rule.height(), rule.width(), rule.width(), 1),
    };
    let mut known: HashMap<Vec<Vec<u32>>, (u32, u32)> = HashMap::new();
    let mut bounds = Vec::new();
    for line in 0..number {
        let mut conditions = Vec::new();
        let mut maps = Vec::new();
        for condition in rule.conditions().iter().filter(|c| c.direction == direction) {
            let limit = match &condition.limit {
                Limit::Map(map) => {
                    let own = (0..length).map(|at| map[line * next + at * step]);
                    maps.push(own.collect::<Vec<u32>>());
                    Limit::Map(maps[maps.len() - 1].clone())
                }
                same => same.clone(),
            };
            conditions.push(Condition { limit, direction: Direction::Horizontal, ..*condition });
        }
        let edges = match rule.edges().meet(direction) {
            true => Edges::Cylinder,
            false => Edges::Free,
        };
        let bound = match known.get(&maps) {
            Some(&bound) => bound,
            None => Rule::new((length, 1), rule.tiles(), edges, conditions)
                .ok()
                .filter(|line| length <= LONGEST && Formula::fits(line))
                .and_then(|rule| line_bounds(&rule, tile, stop))
                .unwrap_or((0, length as u32)),
        };
        known.insert(maps, bound);
        bounds.push(bound);
    }
    bounds
}

/// The least and the largest number in a line of its own, if the search comes to an end; nothing if
/// there is no such line.
fn line_bounds(rule: &Rule, tile: u8, stop: &dyn Stop) -> Option<(u32, u32)> {
    let mut formula = Formula::new(rule, Solver::new(0));
    formula.only(tile);
    let length = rule.width() as u32;
    let literals: Vec<Literal> = (0..length).map(|cell| formula.holds(cell, tile)).collect();
    let outputs = total(&mut formula.solver, std::slice::from_ref(&literals), |_, _, _| {});
    let mut bound = [0, 0];
    for (many, bound) in [false, true].into_iter().zip(&mut bound) {
        literals.iter().for_each(|&l| formula.solver.prefer(if many { l } else { !l }));
        let mut assumed = None;
        loop {
            match formula.solver.solve(assumed.as_slice(), stop) {
                Answer::Model => {}
                Answer::Failed(_) if assumed.is_some() => break,
                _ => return None,
            }
            let number = literals.iter().filter(|&&l| formula.solver.holds(l)).count();
            *bound = number as u32;
            // More than that, or fewer.
            assumed = match many {
                true => outputs.get(number).copied(),
                false => number.checked_sub(1).map(|fewer| !outputs[fewer]),
            };
            if assumed.is_none() {
                break;
            }
        }
    }
    Some((bound[0], bound[1]))
}
