//! Walls whose h-tiles and v-tiles are given.
//!
//! Every row and every column is a walk of its own (`walk`), so that walls are made, chosen
//! all alike, and counted line by line. With three positions or more the only lines without a walk
//! are those with no move between different ends, and with one move between equal ends. So if every
//! row has two v-tiles and every column two h-tiles, **every** boundary goes on into a wall; that is
//! so for all dappled labels with limits `P`, `Q` on at least `2P + 2` columns and `2Q + 2` rows.

use super::super::{Condition, Direction, Edges, Field, Limit, Rule, RuleError};
use super::walk::walk;
use super::{FREE, Side, Wall, weight};
use num_bigint::BigUint;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

/// A line that has no walk between its ends.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "{line} {at}: from position {} to {} in {moves} moves, one for each {tile}-tile",
    end(*.from), end(*.to)
)]
pub struct Blocked {
    /// "row" or "column".
    pub line: &'static str,
    /// Its number.
    pub at: usize,
    /// What changes the position there.
    pub tile: char,
    /// How many of them there are.
    pub moves: usize,
    /// Its position at the west or north end.
    pub from: u8,
    /// Its position at the other end.
    pub to: u8,
}

fn end(position: u8) -> String {
    if position == FREE { "any (but back)".into() } else { position.to_string() }
}

/// What labels keep so that no horizontal joint goes through more than `limits.0` h-tiles and no
/// vertical one through more than `limits.1` v-tiles; `None` for any number.
///
/// # Errors
/// Limits of 0.
pub fn rule(
    size: (usize, usize),
    edges: Edges,
    limits: (Option<u32>, Option<u32>),
) -> Result<Rule, RuleError> {
    let mut conditions = Vec::new();
    for (set, direction, limit) in
        [(0b01, Direction::Horizontal, limits.0), (0b10, Direction::Vertical, limits.1)]
    {
        if let Some(limit) = limit {
            conditions.push(Condition { set, direction, limit: Limit::Same(limit) });
        }
    }
    Rule::new(size, 2, edges, conditions)
}

/// Whether the position changes, tile by tile, in a row or in a column.
fn moves(labels: &Field, horizontal: bool, line: usize) -> Vec<bool> {
    match horizontal {
        true => (0..labels.width()).map(|column| labels.at(column, line) == 1).collect(),
        false => (0..labels.height()).map(|row| labels.at(line, row) == 0).collect(),
    }
}

/// The ends of a line of a wall.
fn ends(wall: &Wall, horizontal: bool, line: usize) -> (u8, u8) {
    match horizontal {
        true => (wall.at(0, line, Side::West), wall.at(wall.width() - 1, line, Side::East)),
        false => (wall.at(line, 0, Side::North), wall.at(line, wall.height() - 1, Side::South)),
    }
}

/// A wall with these labels and the boundary of `partial`, a rectangle of the same size. With
/// `cyclic` edges both ends of a line are the same. All such walls are alike.
///
/// # Errors
/// A line that has no walk.
pub fn wall(partial: &Wall, labels: &Field, cyclic: bool, seed: u64) -> Result<Wall, Blocked> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let (mut wall, positions) = (partial.clone(), partial.positions());
    for horizontal in [true, false] {
        let lines = if horizontal { wall.height() } else { wall.width() };
        for line in 0..lines {
            let moves = moves(labels, horizontal, line);
            let (from, to) = ends(partial, horizontal, line);
            let Some(walk) = walk(&moves, (from, to), cyclic, positions, &mut random) else {
                let (name, tile) = if horizontal { ("row", 'v') } else { ("column", 'h') };
                let moves = moves.iter().filter(|&&moves| moves).count();
                return Err(Blocked { line: name, at: line, tile, moves, from, to });
            };
            for (at, &position) in walk.iter().enumerate() {
                match (horizontal, at) {
                    (true, 0) => wall.set(0, line, Side::West, position),
                    (true, at) => wall.set(at - 1, line, Side::East, position),
                    (false, 0) => wall.set(line, 0, Side::North, position),
                    (false, at) => wall.set(line, at - 1, Side::South, position),
                }
            }
        }
    }
    Ok(wall)
}

/// How many walls have these labels and the boundary of `partial`.
pub fn count(partial: &Wall, labels: &Field, cyclic: bool) -> BigUint {
    let positions = partial.positions();
    let others = BigUint::from(positions - 1);
    let mut walls = BigUint::from(1_u8);
    for horizontal in [true, false] {
        let lines = if horizontal { labels.height() } else { labels.width() };
        for line in 0..lines {
            let moves = moves(labels, horizontal, line).iter().filter(|&&moves| moves).count();
            let all = others.pow(moves as u32);
            // (all + sign * (c - 1)) / c or (all - sign) / c
            let between = |same: bool| {
                let even = moves.is_multiple_of(2);
                let part = if same { others.clone() } else { BigUint::from(1_u8) };
                let sum = if even == same { &all + part } else { &all - part };
                sum / BigUint::from(positions)
            };
            let (from, to) = ends(partial, horizontal, line);
            walls *= match (from, to) {
                (FREE, FREE) if cyclic => between(true) * BigUint::from(positions),
                (FREE, FREE) => all * BigUint::from(positions),
                (_, FREE) | (FREE, _) if cyclic => between(true),
                (_, FREE) | (FREE, _) => all,
                (from, to) if cyclic && from != to => BigUint::ZERO,
                (from, to) => between(from == to),
            };
        }
    }
    walls
}

/// How many walls of a size there are, free boundary, all labels: `(2(c-1))^(mn) c^(m+n)`.
pub fn count_all((width, height): (usize, usize), positions: u8) -> BigUint {
    let each = BigUint::from(2 * (u32::from(positions) - 1)).pow((width * height) as u32);
    each * BigUint::from(positions).pow((width + height) as u32)
}

/// Whether a line of so many moves has a walk between these ends.
pub fn is_open(moves: usize, same: bool, positions: u8) -> bool {
    weight(moves, same, positions) > 0
}
