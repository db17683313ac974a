//! Which algorithm a rule allows: the sets of its conditions decide.
//!
//! Let `N(x)` be the union of the sets of a direction that hold tile `x`. If for all tiles `x` and
//! `y` some tile is neither in `N(x)` of the rows nor in `N(y)` of the columns, then a cell between
//! `x` and `y` always has a tile that begins anew in every set: *greedy*. That is so for three and
//! more tiles with limits each for itself, and for any three classes.
//!
//! If all sets are one class of tiles or the other, and no limit is below 2, there is Algorithm 1 on
//! the classes: a *pair*.

use super::super::{Condition, Direction, Limit, Rule};

/// What can be done in one pass.
#[derive(Debug)]
pub enum Scheme<'a> {
    /// A tile that begins anew.
    Greedy(Greedy<'a>),
    /// Algorithm 1.
    Pair(Classes<'a>),
    /// Neither; a pass of the first kind may still come near.
    Neither(Greedy<'a>),
}

/// Disjoint sets of one direction with their limits.
#[derive(Debug)]
pub struct Layer<'a> {
    /// For each tile the number of its set, or [`NO_SET`].
    pub set_of: [u8; 64],
    /// The sets.
    pub sets: Vec<u64>,
    /// Their limits.
    pub limits: Vec<&'a Limit>,
}

/// The number of no set.
pub const NO_SET: u8 = u8::MAX;

/// All conditions, by direction, in as few layers as come up.
#[derive(Debug)]
pub struct Greedy<'a> {
    /// Those on rows.
    pub horizontal: Vec<Layer<'a>>,
    /// Those on columns.
    pub vertical: Vec<Layer<'a>>,
}

/// Two classes of tiles.
#[derive(Debug, Clone, Copy)]
pub struct Classes<'a> {
    /// The tiles of each.
    pub sets: [u64; 2],
    /// Their limits in rows.
    pub horizontal: [&'a Limit; 2],
    /// Their limits in columns.
    pub vertical: [&'a Limit; 2],
}

impl Classes<'_> {
    /// Whether every limit is the same in all cells, and at least so much.
    pub fn uniform_from(&self, least: u32) -> bool {
        self.horizontal.iter().chain(&self.vertical).all(|limit| match limit {
            Limit::None => true,
            Limit::Same(limit) => *limit >= least,
            Limit::Map(_) => false,
        })
    }
}

/// All tiles of a rule.
pub fn all(tiles: usize) -> u64 {
    u64::MAX >> (64 - tiles)
}

/// What a rule allows, if its edges were free.
pub fn scheme(rule: &Rule) -> Scheme<'_> {
    if let Some(classes) = classes(rule) {
        return Scheme::Pair(classes);
    }
    let layers = |direction| {
        let mut layers: Vec<Layer> = Vec::new();
        for condition in rule.conditions().iter().filter(|c| c.direction == direction) {
            let apart = |layer: &&mut Layer| layer.sets.iter().all(|set| set & condition.set == 0);
            match layers.iter_mut().find(apart) {
                Some(layer) => layer.add(condition),
                None => {
                    let mut layer =
                        Layer { set_of: [NO_SET; 64], sets: Vec::new(), limits: Vec::new() };
                    layer.add(condition);
                    layers.push(layer);
                }
            }
        }
        layers
    };
    let greedy =
        Greedy { horizontal: layers(Direction::Horizontal), vertical: layers(Direction::Vertical) };
    let union = |layers: &[Layer], tile: usize| {
        let of = |layer: &Layer| layer.sets.get(usize::from(layer.set_of[tile])).copied();
        layers.iter().filter_map(of).fold(0, |union, set| union | set)
    };
    let tiles = rule.tiles();
    let anew = |(x, y)| union(&greedy.horizontal, x) | union(&greedy.vertical, y) != all(tiles);
    match (0..tiles).flat_map(|x| (0..tiles).map(move |y| (x, y))).all(anew) {
        true => Scheme::Greedy(greedy),
        false => Scheme::Neither(greedy),
    }
}

impl<'a> Layer<'a> {
    fn add(&mut self, condition: &'a Condition) {
        for tile in 0..64 {
            if condition.set >> tile & 1 == 1 {
                self.set_of[tile] = self.sets.len() as u8;
            }
        }
        self.sets.push(condition.set);
        self.limits.push(&condition.limit);
    }
}

/// The two classes that all conditions speak of, if there are no more, and no limit is below 2.
fn classes(rule: &Rule) -> Option<Classes<'_>> {
    let lowest = rule.conditions().first().map_or(1, |condition| condition.set);
    let sets = match lowest & 1 {
        1 => [lowest, all(rule.tiles()) & !lowest],
        _ => [all(rule.tiles()) & !lowest, lowest],
    };
    if sets.contains(&0) {
        return None;
    }
    let mut limits = [[&Limit::None; 2]; 2];
    for condition in rule.conditions() {
        let class = sets.iter().position(|&set| set == condition.set)?;
        let least = match &condition.limit {
            Limit::None => u32::MAX,
            Limit::Same(limit) => *limit,
            Limit::Map(map) => map.iter().copied().min().unwrap_or(u32::MAX),
        };
        let limit = &mut limits[usize::from(condition.direction == Direction::Vertical)][class];
        if least < 2 || **limit != Limit::None {
            return None;
        }
        *limit = &condition.limit;
    }
    Some(Classes { sets, horizontal: limits[0], vertical: limits[1] })
}
