//! The count of a rectangle, cell by cell.
//!
//! Cells are filled row by row from the west. What matters of those filled is a digit for each
//! column, its state as a [`Line`], and the state of the row begun. A state of all is a word: the
//! digits of the columns from the next cell on, around to the one before it, then the row.
//!
//! **Two halves.** Where the rule is the same read upwards, the fillings of the lower half by state
//! are those of the upper half. So `n` rows need no more than the first `n/2` or `(n+1)/2`: then, one
//! column after the other, the state of the upper half is replaced by all of the lower half that go
//! together with it, and numbers of equal states are multiplied. Sums stay small meanwhile.

use super::CountError;
use super::line::{DEAD, Ends, Line, Task};
use super::merge::Step;
use super::plane::Plane;
use super::table::{Table, number_of};
use super::words::Words;
use num_bigint::BigUint;
use std::collections::HashMap;
use std::sync::Arc;

/// Bits of a state at most.
const MOST_BITS: u32 = 63;
/// Bits of a digit and a row together at most.
const MOST_SLOT: u32 = 20;

/// Lines that were made, so that equal ones are made once.
#[derive(Debug, Default)]
pub(super) struct Lines(HashMap<Task, Arc<Line>>);

impl Lines {
    /// The line of a task.
    ///
    /// # Errors
    /// Too many states.
    pub(super) fn line(&mut self, task: Task) -> Result<Arc<Line>, CountError> {
        if let Some(line) = self.0.get(&task) {
            return Ok(line.clone());
        }
        let line = Arc::new(Line::new(&task).ok_or(CountError::Line)?);
        self.0.insert(task, line.clone());
        Ok(line)
    }
}

/// A count under way.
#[derive(Debug, Clone)]
pub(super) struct Sweep {
    columns: Vec<Arc<Line>>,
    rows: Vec<Arc<Line>>,
    /// The tile that is counted.
    by: Option<u8>,
    /// Rows of the upper half; without halves all.
    upper: usize,
    /// Rows of the lower half; without halves none.
    lower: usize,
    /// Steps done.
    done: usize,
    /// The fillings by state.
    table: Table,
    /// One that is no longer needed, for its memory.
    spare: Table,
    /// The table of the lower half, and its states as words.
    kept: Option<(Table, Words)>,
}

impl Sweep {
    /// A count with these columns and rows.
    ///
    /// # Errors
    /// States that have no room in a word.
    pub(super) fn new(
        columns: Vec<Arc<Line>>,
        rows: Vec<Arc<Line>>,
        by: Option<u8>,
    ) -> Result<Self, CountError> {
        let possible = columns.iter().chain(&rows).all(|line| line.states(0) > 0);
        let table = if possible { Table::one(0) } else { Table::none() };
        let upper = rows.len();
        let (lower, done, spare, kept) = (0, 0, Table::none(), None);
        let sweep = Self { columns, rows, by, upper, lower, done, table, spare, kept };
        if possible && !(0..sweep.steps()).all(|step| sweep.has_room(step)) {
            return Err(CountError::Word { columns: sweep.columns.len() });
        }
        Ok(sweep)
    }

    /// Whether the states of a step fit in a word.
    fn has_room(&self, step: usize) -> bool {
        let (lead, rest, row, slot) = self.bits(step);
        lead + rest + row <= MOST_BITS && slot + rest <= MOST_BITS && slot <= MOST_SLOT
    }

    /// The count of a plane whose columns do not meet their end.
    ///
    /// # Errors
    /// Too many states.
    pub(super) fn of(plane: &Plane, by: Option<u8>, halves: bool) -> Result<Self, CountError> {
        let mut lines = Lines::default();
        let columns = (0..plane.width()).map(|x| lines.line(plane.column(x, Ends::Free)));
        let columns = columns.collect::<Result<_, _>>()?;
        let rows = (0..plane.height()).map(|y| lines.line(plane.row(y)));
        let rows = rows.collect::<Result<_, _>>()?;
        let mut sweep = Self::new(columns, rows, by)?;
        if halves && by.is_none() && plane.is_even() && plane.height() > 3 {
            sweep.lower = sweep.rows.len() / 2;
            sweep.upper = sweep.rows.len() - sweep.lower;
        }
        Ok(sweep)
    }

    /// Columns.
    pub(super) fn width(&self) -> usize {
        self.columns.len()
    }

    /// Steps in all.
    pub(super) fn steps(&self) -> usize {
        (self.upper + usize::from(self.lower > 0)) * self.width()
    }

    /// Steps done.
    pub(super) fn done(&self) -> usize {
        self.done
    }

    /// Whether all steps are done.
    pub(super) fn is_done(&self) -> bool {
        self.done == self.steps()
    }

    /// Whether a row was completed with the last step.
    pub(super) fn is_at_row(&self) -> bool {
        self.done.is_multiple_of(self.width())
    }

    /// The fillings by state.
    pub(super) fn table(&self) -> &Table {
        &self.table
    }

    /// The memory of all tables.
    pub(super) fn bytes(&self) -> usize {
        self.table.bytes()
            + self.spare.bytes()
            + self.kept.as_ref().map_or(0, |(kept, _)| kept.bytes())
    }

    /// What to save, and how many steps lead to it. Joining halves is not saved: it is short.
    pub(super) fn standing(&self) -> (usize, &Table) {
        match &self.kept {
            Some((kept, _)) => (self.lower * self.width(), kept),
            None => (self.done, &self.table),
        }
    }

    /// Whether these can be the states after so many steps.
    pub(super) fn accepts(&self, done: usize, table: &Table) -> bool {
        let known = done <= self.steps() && (self.lower == 0 || done <= self.lower * self.width());
        let place = (done / self.width(), false);
        let column = done % self.width();
        let around = (column..self.width()).chain(0..column);
        known && table.states().is_sorted_by(|a, b| a < b) && {
            let digits = around.map(|other| {
                let cells = place.0 + usize::from(other < column);
                self.columns[other].states(cells)
            });
            let mut digits: Vec<usize> = digits.collect();
            digits.push(self.row_states(place, column));
            digits.reverse();
            table.states().all(|mut state| {
                let fits = digits.iter().all(|&states| {
                    let bits = bits(states);
                    let digit = state & ((1 << bits) - 1);
                    state >>= bits;
                    digit < states as u64
                });
                fits && state == 0
            })
        }
    }

    /// Goes on from what was saved.
    pub(super) fn restore(&mut self, done: usize, table: Table) {
        (self.done, self.table) = (done, table);
        (self.kept, self.spare) = (None, Table::none());
    }

    /// One cell more.
    pub(super) fn step(&mut self) {
        if self.lower > 0 && self.done == self.lower * self.width() {
            let bits = self.columns.iter().map(|line| bits(line.states(self.lower)));
            let words = Words::new(self.table.states(), &bits.collect::<Vec<_>>());
            self.kept = Some((self.table.clone(), words));
            let joining = self.upper * self.width()..self.steps();
            if joining.into_iter().any(|step| !self.has_room(step)) {
                (self.upper, self.lower, self.kept) = (self.rows.len(), 0, None);
            }
        }
        self.table.make_room();
        let spare = std::mem::replace(&mut self.spare, Table::none());
        let next = match self.table.len() {
            0 => Table::none(),
            _ => self.step_at(self.done).take(&self.table, spare),
        };
        self.spare = std::mem::replace(&mut self.table, next);
        self.done += 1;
        if self.is_done() {
            self.spare = Table::none();
        }
    }

    /// The numbers of all fillings, by count of the tile that is counted, if one is.
    pub(super) fn numbers(&self) -> Vec<BigUint> {
        match &self.kept {
            None => self.table.sums(),
            Some((kept, _)) => vec![product(&self.table, kept)],
        }
    }

    /// Where a step is: the row of its cell, its column, and whether halves are joined.
    fn place(&self, step: usize) -> (usize, usize, bool) {
        let (row, column) = (step / self.width(), step % self.width());
        (row, column, row == self.upper)
    }

    /// The digit of a column before or after its cell in this row.
    fn digit(&self, (row, joining): (usize, bool), column: usize, after: bool) -> u32 {
        let cells = match (joining, after) {
            (false, after) => row + usize::from(after),
            (true, false) => self.upper,
            (true, true) => self.lower,
        };
        bits(self.columns[column].states(cells))
    }

    /// States of the row at a cut: where halves are joined, of the words of the lower half. As long
    /// as these are not known, as many as a row has.
    fn row_states(&self, (row, joining): (usize, bool), columns: usize) -> usize {
        match (&self.kept, joining) {
            (Some((_, words)), true) => words.states(columns),
            (None, true) => self.rows[0].states(columns),
            // After the last row there is none begun.
            (_, false) => self.rows.get(row).map_or(1, |line| line.states(columns)),
        }
    }

    /// Bits of lead, rest, row before, and slot.
    fn bits(&self, step: usize) -> (u32, u32, u32, u32) {
        let (row, column, joining) = self.place(step);
        let place = (row, joining);
        let rest = (0..self.width()).filter(|&other| other != column);
        let rest = rest.map(|other| self.digit(place, other, other < column)).sum();
        let row_after = bits(self.row_states(place, column + 1));
        let slot = self.digit(place, column, true) + row_after;
        (self.digit(place, column, false), rest, bits(self.row_states(place, column)), slot)
    }

    /// Which leads and rows before, as one number, and which tiles lead to each slot of a step; the
    /// bits of the row before, of the rest and of the slot.
    pub(super) fn back(&self, step: usize) -> (Vec<Vec<(u64, u8)>>, [u32; 3]) {
        let (row, column, _) = self.place(step);
        let (_, rest, row_before, slot) = self.bits(step);
        let row_after = bits(self.row_states((row, false), column + 1));
        let mut ways = vec![Vec::new(); 1 << slot];
        let (digits, line) = (&self.columns[column], &self.rows[row]);
        for lead in 0..digits.states(row) as u32 {
            for state in 0..line.states(column) as u32 {
                for tile in 0..digits.tiles() {
                    let digit = digits.next(row, lead, tile);
                    let after = line.next(column, state, tile);
                    if digit != DEAD && after != DEAD {
                        let before = u64::from(lead) << (rest + row_before) | u64::from(state);
                        ways[(digit << row_after | after) as usize].push((before, tile));
                    }
                }
            }
        }
        (ways, [row_before, rest, slot])
    }

    /// The step of a cell.
    pub(super) fn step_at(&self, step: usize) -> Step {
        let (row, column, joining) = self.place(step);
        let (_, rest, row_before, slot) = self.bits(step);
        let row_after = bits(self.row_states((row, joining), column + 1));
        let digits = &self.columns[column];
        let leads = digits.states(if joining { self.upper } else { row });
        let mut moves = vec![Vec::new(); leads << row_before];
        let slot_of = |digit: u32, state: u32| digit << row_after | state;
        for lead in 0..leads as u32 {
            let after = if joining { self.lower_half(column, lead) } else { Vec::new() };
            for state in 0..self.row_states((row, joining), column) as u32 {
                let slots = &mut moves[(lead as usize) << row_before | state as usize];
                if let (Some((_, words)), true) = (&self.kept, joining) {
                    for &digit in &after {
                        let state = words.next(column, state, digit);
                        if state != DEAD {
                            slots.push((slot_of(digit, state), false));
                        }
                    }
                    continue;
                }
                for tile in 0..digits.tiles() {
                    let digit = digits.next(row, lead, tile);
                    let state = self.rows[row].next(column, state, tile);
                    if digit != DEAD && state != DEAD {
                        slots.push((slot_of(digit, state), self.by == Some(tile)));
                    }
                }
            }
        }
        Step { row_before, rest, slot, moves, counts: self.by.is_some() }
    }

    /// The digits of a column of the lower half that go together with one of the upper half.
    fn lower_half(&self, column: usize, digit: u32) -> Vec<u32> {
        let line = &self.columns[column];
        let together = |other: &u32| {
            let mut word = line.word(self.lower, *other).into_iter().rev();
            let next = |(state, row), tile| match line.next(row, state, tile) {
                DEAD => None,
                state => Some((state, row + 1)),
            };
            word.try_fold((digit, self.upper), next).is_some()
        };
        (0..line.states(self.lower) as u32).filter(together).collect()
    }
}

/// Bits that tell so many apart.
pub(super) fn bits(states: usize) -> u32 {
    states.next_power_of_two().trailing_zeros()
}

/// The sum of the products of the numbers of equal states.
fn product(one: &Table, other: &Table) -> BigUint {
    let mut sum = BigUint::ZERO;
    let mut others = other.iter().peekable();
    // Small ones first into a word, for there are millions.
    let mut small = 0u128;
    for (state, number) in one.iter() {
        while others.next_if(|&(other, _)| other < state).is_some() {}
        let Some((_, factor)) = others.next_if(|&(other, _)| other == state) else { continue };
        if let ([number], [factor]) = (number, factor) {
            let product = u128::from(*number) * u128::from(*factor);
            match small.checked_add(product) {
                Some(sum) => small = sum,
                None => sum += std::mem::replace(&mut small, product),
            }
        } else {
            sum += number_of(number) * number_of(factor);
        }
    }
    sum + small
}
