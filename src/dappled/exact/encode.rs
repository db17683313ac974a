//! A rule as a formula.
//!
//! **Two tiles**: a variable for each cell, true for tile 1. A window of a set with one tile is one
//! clause: some cell holds the other tile.
//!
//! **More tiles**: a variable for each cell and tile, and for each cell and set of several tiles
//! that has a limit. Some tile stands in each cell; a tile brings its sets along; the cells of a
//! window are not all in its set. Nothing says that a cell holds *one* tile: with fewer true
//! variables fewer conditions are broken, so any of the true ones will do. Where tiles are counted,
//! that is said of the one that counts ([`Formula::only`]).

use super::sat::{Literal, Solver};
use crate::dappled::{Condition, Direction, FREE, Field, Limit, Rule};
use std::collections::BTreeMap;

/// Words that the clauses of a rule may take at most.
const MOST_WORDS: u64 = 1 << 27;

/// A rule as a formula, and what its variables say.
#[derive(Debug, Clone)]
pub(super) struct Formula {
    pub(super) solver: Solver,
    width: usize,
    height: usize,
    tiles: usize,
}

impl Formula {
    /// Whether the clauses of a rule are not too many.
    pub(super) fn fits(rule: &Rule) -> bool {
        let cells = (rule.width() * rule.height()) as u64;
        let (tiles, conditions) = (rule.tiles() as u64, rule.conditions().len() as u64);
        // Tiles and the sets that they bring along, and pairs of sets.
        let sets = if tiles == 2 { 0 } else { conditions * (4 * tiles + 4 * conditions) };
        let mut words = cells * (4 * tiles + sets);
        for Condition { direction, limit, .. } in rule.conditions() {
            let line = match direction {
                Direction::Horizontal => rule.width() as u64,
                Direction::Vertical => rule.height() as u64,
            };
            let window = |limit: u32| 6 + line.min(u64::from(limit) + 1);
            words += match limit {
                Limit::None => 0,
                Limit::Same(limit) => cells * window(*limit),
                Limit::Map(map) => map.iter().map(|&limit| window(limit)).sum(),
            };
        }
        words <= MOST_WORDS
    }

    /// The formula of a rule, by a solver without variables.
    pub(super) fn new(rule: &Rule, solver: Solver) -> Self {
        let (width, height, tiles) = (rule.width(), rule.height(), rule.tiles());
        let cells = width * height;
        let variables = if tiles == 2 { cells } else { cells * tiles };
        let mut formula = Self { solver, width, height, tiles };
        (0..variables).for_each(|_| {
            formula.solver.variable();
        });
        let everything = u64::MAX >> (64 - tiles);
        let mut sets: BTreeMap<u64, u32> = BTreeMap::new();
        if tiles != 2 {
            for cell in 0..cells as u32 {
                let some: Vec<Literal> =
                    (0..tiles as u8).map(|tile| formula.holds(cell, tile)).collect();
                formula.solver.add(&some);
            }
            for condition in rule.conditions() {
                let set = condition.set;
                if set.count_ones() > 1 && set != everything && !sets.contains_key(&set) {
                    sets.insert(set, formula.together(set));
                }
            }
        }
        // Two sets that have all tiles between them: one of them is there. That follows, but not
        // by drawing conclusions from single clauses.
        for (&set, &first) in &sets {
            for (_, &other) in sets.range(..set).filter(|(other, _)| *other | set == everything) {
                for cell in 0..cells as u32 {
                    let either = [first + cell, other + cell].map(|v| Literal::new(v, true));
                    formula.solver.add(&either);
                }
            }
        }
        let mut clause = Vec::new();
        for window in rule.windows() {
            clause.clear();
            if window.set != everything {
                clause.extend(window.cells.iter().map(|&cell| match sets.get(&window.set) {
                    Some(first) => Literal::new(first + cell, false),
                    None => !formula.holds(cell, window.set.trailing_zeros() as u8),
                }));
            }
            formula.solver.add(&clause);
        }
        formula
    }

    /// Variables, one for each cell, that are true wherever one of these tiles stands; the first.
    fn together(&mut self, set: u64) -> u32 {
        let first = self.solver.variables() as u32;
        let cells = (self.width * self.height) as u32;
        for cell in 0..cells {
            let member = Literal::new(self.solver.variable(), true);
            for tile in (0..self.tiles as u8).filter(|&tile| set >> tile & 1 == 1) {
                let tile = self.holds(cell, tile);
                self.solver.add(&[!tile, member]);
            }
        }
        first
    }

    /// A tile stands in a cell.
    pub(super) fn holds(&self, cell: u32, tile: u8) -> Literal {
        match self.tiles {
            2 => Literal::new(cell, tile == 1),
            tiles => Literal::new(cell * tiles as u32 + u32::from(tile), true),
        }
    }

    /// Where this tile stands, no other does.
    pub(super) fn only(&mut self, tile: u8) {
        if self.tiles == 2 {
            return;
        }
        for cell in 0..(self.width * self.height) as u32 {
            for other in (0..self.tiles as u8).filter(|&other| other != tile) {
                let both = [!self.holds(cell, tile), !self.holds(cell, other)];
                self.solver.add(&both);
            }
        }
    }

    /// What a field says of its cells that are not free.
    pub(super) fn given(&self, field: &Field) -> Vec<Literal> {
        let filled = (0..).zip(field.cells()).filter(|(_, tile)| **tile != FREE);
        filled.map(|(cell, &tile)| self.holds(cell, tile)).collect()
    }

    /// The cell of which a literal of [`Formula::given`] speaks.
    pub(super) fn cell(&self, literal: Literal) -> u32 {
        match self.tiles {
            2 => literal.variable(),
            tiles => literal.variable() / tiles as u32,
        }
    }

    /// The tiling that the last model is; cells of the partial one stay as they are.
    pub(super) fn tiling(&self, partial: &Field) -> Field {
        let mut tiling = partial.clone();
        for (cell, tile) in (0..).zip(tiling.cells_mut()) {
            if *tile == FREE {
                let standing =
                    (0..self.tiles as u8).find(|&t| self.solver.holds(self.holds(cell, t)));
                *tile = standing.unwrap_or(FREE);
            }
        }
        tiling
    }
}
