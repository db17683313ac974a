//! What is to be solved, in the form that strips ask for: what each tile costs in each cell, and
//! how long a run of each set may be when it ends there.
//!
//! A line that meets its own end and is no longer than its limit allows may still not lie in one
//! set: there the limit is the line's length less one, which is the same window.

use crate::dappled::{Direction, Rule};

/// Costs; [`NEVER`] is that of what may not be. Sums of a few of them do not overflow.
pub(super) type Cost = i64;

/// The cost of what may not be.
pub(super) const NEVER: Cost = Cost::MAX / 8;

/// Whether a cost is that of something that may be.
pub(super) fn may_be(cost: Cost) -> bool {
    cost < NEVER / 2
}

/// No limit.
pub(super) const ENDLESS: u32 = u32::MAX;

/// A set of tiles with its limits.
#[derive(Debug, Clone)]
pub(super) struct Runs {
    /// The tiles, a bit each.
    pub set: u64,
    /// The limit of each cell, or one for all.
    limits: Vec<u32>,
}

impl Runs {
    /// How long a run that ends in a cell may be.
    pub(super) fn limit(&self, cell: usize) -> u32 {
        if self.limits.len() == 1 { self.limits[0] } else { self.limits[cell] }
    }

    /// The limit of all cells, if they have the same.
    pub(super) fn uniform(&self) -> Option<u32> {
        let first = self.limits[0];
        self.limits.iter().all(|&limit| limit == first).then_some(first)
    }

    /// The longest run that some limit allows; limits that allow any are left out.
    pub(super) fn longest(&self) -> u32 {
        self.limits.iter().copied().filter(|&limit| limit != ENDLESS).max().unwrap_or(0)
    }
}

/// Cells, costs and limits.
#[derive(Debug, Clone)]
pub(super) struct Board {
    pub width: usize,
    pub height: usize,
    pub tiles: usize,
    /// Whether rows, and columns, meet their own end.
    pub meet: [bool; 2],
    /// What limits rows, and columns.
    pub runs: [Vec<Runs>; 2],
    /// By cell, then by tile.
    pub costs: Vec<Cost>,
}

/// The number of a direction.
pub(super) fn index(direction: Direction) -> usize {
    match direction {
        Direction::Horizontal => 0,
        Direction::Vertical => 1,
    }
}

impl Board {
    /// A rule with the costs of tiles, by cell, then by tile.
    pub(super) fn new(rule: &Rule, costs: Vec<Cost>) -> Self {
        let (width, height) = (rule.width(), rule.height());
        let mut runs = [Vec::new(), Vec::new()];
        for condition in rule.conditions() {
            let direction = condition.direction;
            let line = match direction {
                Direction::Horizontal => width,
                Direction::Vertical => height,
            };
            let meet = rule.edges().meet(direction);
            let limit = |cell: usize| {
                let limit = condition.limit.at(cell)?;
                let line = line as u32;
                match meet {
                    true => Some(limit.min(line - 1)),
                    // Longer than the line is no limit.
                    false => Some(limit).filter(|&limit| limit < line),
                }
            };
            let mut limits: Vec<u32> =
                (0..width * height).map(|cell| limit(cell).unwrap_or(ENDLESS)).collect();
            if limits.iter().all(|&limit| limit == limits[0]) {
                limits.truncate(1);
            }
            if limits != [ENDLESS] {
                runs[index(direction)].push(Runs { set: condition.set, limits });
            }
        }
        let meet = [Direction::Horizontal, Direction::Vertical].map(|d| rule.edges().meet(d));
        Self { width, height, tiles: rule.tiles(), meet, runs, costs }
    }

    /// Cells.
    pub(super) fn cells(&self) -> usize {
        self.width * self.height
    }

    /// How long lines of a direction are.
    pub(super) fn length(&self, along: usize) -> usize {
        [self.width, self.height][along]
    }

    /// How many lines of a direction there are.
    pub(super) fn lines(&self, along: usize) -> usize {
        [self.height, self.width][along]
    }

    /// The cell of a line at a place along it.
    pub(super) fn cell(&self, along: usize, line: usize, at: usize) -> usize {
        match along {
            0 => line * self.width + at,
            _ => at * self.width + line,
        }
    }

    /// The longest run of lines of a direction that some limit allows.
    pub(super) fn longest(&self, along: usize) -> usize {
        self.runs[along].iter().map(|set| set.longest() as usize).max().unwrap_or(0)
    }

    /// Whether more than one tile may be in a cell.
    pub(super) fn is_open(&self, cell: usize) -> bool {
        let costs = &self.costs[cell * self.tiles..][..self.tiles];
        costs.iter().filter(|&&cost| may_be(cost)).count() > 1
    }

    /// The line of a direction that a cell lies on.
    pub(super) fn line(&self, along: usize, cell: usize) -> usize {
        [cell / self.width, cell % self.width][along]
    }

    /// What a tile costs in a cell.
    pub(super) fn cost(&self, cell: usize, tile: usize) -> Cost {
        self.costs[cell * self.tiles + tile]
    }

    /// What all cells cost together.
    pub(super) fn total(&self, cells: &[u8]) -> Cost {
        cells.iter().enumerate().map(|(cell, &tile)| self.cost(cell, usize::from(tile))).sum()
    }
}
