//! The rectangle as rows and columns, each with what is asked of it.
//!
//! It may lie on its side: what its columns are called here are then the rows of the rule. The cost
//! of a count grows exponentially with the width, and only linearly with the height.

use super::line::{Demand, Ends, Task};
use crate::dappled::{Condition, Direction, FREE, Field, Limit, Rule};

/// A rule and cells given, seen from one side.
#[derive(Debug, Clone)]
pub(super) struct Plane {
    rule: Rule,
    given: Option<Field>,
    /// Whether rows are what the rule calls columns.
    pub(super) turned: bool,
}

impl Plane {
    /// The side from which it is less wide; rows that meet their end remember how they began, so
    /// they count double.
    pub(super) fn new(rule: &Rule, given: Option<&Field>) -> Self {
        let (width, height) = (rule.width(), rule.height());
        let (east, south) =
            (rule.edges().meet(Direction::Horizontal), rule.edges().meet(Direction::Vertical));
        let turned = match (east, south) {
            (true, false) => width > 2 * height + 2,
            _ => width > height,
        };
        Self { rule: rule.clone(), given: given.cloned(), turned }
    }

    /// The same rule for another size.
    pub(super) fn resized(&self, width: usize, height: usize) -> Option<Self> {
        let size = if self.turned { (height, width) } else { (width, height) };
        let (tiles, edges) = (self.rule.tiles(), self.rule.edges());
        let rule = Rule::new(size, tiles, edges, self.rule.conditions().to_vec()).ok()?;
        Some(Self { rule, given: None, turned: self.turned })
    }

    /// What is kept.
    pub(super) fn rule(&self) -> &Rule {
        &self.rule
    }

    /// Columns.
    pub(super) fn width(&self) -> usize {
        if self.turned { self.rule.height() } else { self.rule.width() }
    }

    /// Rows.
    pub(super) fn height(&self) -> usize {
        if self.turned { self.rule.width() } else { self.rule.height() }
    }

    /// The place of a cell in the field.
    pub(super) fn place(&self, column: usize, row: usize) -> (usize, usize) {
        if self.turned { (row, column) } else { (column, row) }
    }

    /// Whether rows meet their end.
    pub(super) fn rows_meet(&self) -> bool {
        self.rule.edges().meet(self.direction(Direction::Horizontal))
    }

    /// Whether columns meet their end.
    pub(super) fn columns_meet(&self) -> bool {
        self.rule.edges().meet(self.direction(Direction::Vertical))
    }

    fn direction(&self, seen: Direction) -> Direction {
        match (self.turned, seen) {
            (true, Direction::Horizontal) => Direction::Vertical,
            (true, Direction::Vertical) => Direction::Horizontal,
            (false, direction) => direction,
        }
    }

    /// The conditions of columns.
    pub(super) fn down(&self) -> impl Iterator<Item = &Condition> {
        let down = self.direction(Direction::Vertical);
        self.rule.conditions().iter().filter(move |condition| condition.direction == down)
    }

    /// Whether all rows are alike, and all columns: no cells given, no maps of limits.
    pub(super) fn is_even(&self) -> bool {
        let free =
            self.given.as_ref().is_none_or(|field| field.cells().iter().all(|&tile| tile == FREE));
        let mapped = |limit: &Limit| matches!(limit, Limit::Map(_));
        free && !self.rule.conditions().iter().any(|condition| mapped(&condition.limit))
    }

    /// What is asked of a row.
    pub(super) fn row(&self, row: usize) -> Task {
        let ends = if self.rows_meet() { Ends::Meet } else { Ends::Free };
        let places = (0..self.width()).map(|column| self.place(column, row)).collect();
        self.line(Direction::Horizontal, places, ends)
    }

    /// What is asked of a column whose ends are these.
    pub(super) fn column(&self, column: usize, ends: Ends) -> Task {
        let places = (0..self.height()).map(|row| self.place(column, row)).collect();
        self.line(Direction::Vertical, places, ends)
    }

    fn line(&self, seen: Direction, places: Vec<(usize, usize)>, ends: Ends) -> Task {
        let direction = self.direction(seen);
        let meet = self.rule.edges().meet(direction);
        let length = places.len() as u32;
        let conditions = self.rule.conditions().iter();
        let demands = conditions.filter(|condition| condition.direction == direction);
        let limit = |limit: &Limit, &(column, row): &(usize, usize)| {
            let limit = limit.at(row * self.rule.width() + column)?;
            match meet {
                true => Some(limit.min(length - 1)),
                false => Some(limit).filter(|&limit| limit < length),
            }
        };
        let demands = demands.map(|condition| {
            let limits = places.iter().map(|place| limit(&condition.limit, place));
            let limits: Vec<Option<u32>> = limits.collect();
            let longest = limits.iter().flatten().copied().max().unwrap_or(0);
            Demand { set: condition.set, limits, longest }
        });
        let at = |&(column, row): &(usize, usize)| {
            self.given.as_ref().map_or(FREE, |field| field.at(column, row))
        };
        let given = places.iter().map(at).collect();
        Task { tiles: self.rule.tiles(), demands: demands.collect(), given, ends }
    }
}
