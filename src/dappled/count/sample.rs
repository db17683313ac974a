//! Random tilings, all equally likely.
//!
//! The count, gone backwards, numbers the tilings: what follows a state is known, so the number of a
//! tiling among those that end in it says which state was before, and its number among those that end
//! there. So one random number below the count, which is exact, is one random tiling; no choice is
//! made again, and none is biased.
//!
//! The tables between some rows are kept, as many as there is memory for; those between are counted
//! again. All tilings asked for are made together.

use super::plane::Plane;
use super::sweep::{Lines, Sweep};
use super::table::{Table, number_of};
use super::turns::{self, Image, Start};
use super::{CountError, within};
use crate::dappled::{FREE, Field, Rule};
use num_bigint::BigUint;
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64;

/// Tilings by number.
#[derive(Debug)]
pub struct Sampler {
    plane: Plane,
    blank: Field,
    memory: usize,
    total: BigUint,
    work: Work,
}

#[derive(Debug)]
enum Work {
    Once(Box<Kept>),
    /// Columns that meet their end: starts, and how many fillings lead back to each.
    Turns(Vec<Image>, Vec<(Start, BigUint)>),
}

/// A count and its tables between rows, every so many.
#[derive(Debug)]
struct Kept {
    /// Not begun.
    sweep: Sweep,
    gap: usize,
    tables: Vec<Table>,
    total: BigUint,
}

impl Sampler {
    /// Counts the tilings that keep a rule and agree with the cells given, in so many bytes.
    ///
    /// # Errors
    /// More states or memory than there may be.
    pub fn new(rule: &Rule, given: Option<&Field>, memory: usize) -> Result<Self, CountError> {
        super::check(rule, given)?;
        let blank = Field::filled(rule.width(), rule.height(), FREE)?;
        let plane = Plane::new(rule, given);
        if !plane.columns_meet() {
            let kept = Kept::new(Sweep::of(&plane, None, false)?, memory)?;
            let total = kept.total.clone();
            return Ok(Self { plane, blank, memory, total, work: Work::Once(Box::new(kept)) });
        }
        let images = turns::images(&plane, None);
        let mut lines = Lines::default();
        let mut starts = Vec::new();
        let mut total = BigUint::ZERO;
        for start in turns::starts(&plane, &images, memory)? {
            let mut sweep = turns::sweep(&plane, &start, None, &mut lines)?;
            while !sweep.is_done() {
                sweep.step();
                within(memory, sweep.bytes())?;
            }
            let number: BigUint = sweep.numbers().into_iter().sum();
            if number > BigUint::ZERO {
                total += &number * start.alike;
                starts.push((start, number));
            }
        }
        Ok(Self { plane, blank, memory, total, work: Work::Turns(images, starts) })
    }

    /// How many tilings there are.
    pub fn total(&self) -> &BigUint {
        &self.total
    }

    /// So many random tilings, each independent of the others, and the same for the same seed; none
    /// if there are none at all.
    ///
    /// # Errors
    /// More memory than there may be.
    pub fn draw(&self, count: usize, seed: u64) -> Result<Vec<Field>, CountError> {
        if self.total == BigUint::ZERO {
            return Ok(Vec::new());
        }
        let mut random = Pcg64::seed_from_u64(seed);
        let numbers = (0..count).map(|_| below(&self.total, &mut random));
        let numbers: Vec<BigUint> = numbers.collect();
        self.tilings(&numbers)
    }

    /// The tilings with these numbers, each below the total.
    ///
    /// # Errors
    /// More memory than there may be.
    pub fn tilings(&self, numbers: &[BigUint]) -> Result<Vec<Field>, CountError> {
        match &self.work {
            Work::Once(kept) => {
                let fillings = kept.fillings(numbers, self.memory)?;
                Ok(fillings.into_iter().map(|cells| self.field(&cells)).collect())
            }
            Work::Turns(images, starts) => self.turned(images, starts, numbers),
        }
    }

    fn turned(
        &self,
        images: &[Image],
        starts: &[(Start, BigUint)],
        numbers: &[BigUint],
    ) -> Result<Vec<Field>, CountError> {
        // By start: which tiling, by which image, and its number among those of the start.
        let mut asked: Vec<Vec<(usize, usize, BigUint)>> = vec![Vec::new(); starts.len()];
        for (tiling, number) in numbers.iter().enumerate() {
            let mut left = number.clone();
            for (at, (start, number)) in starts.iter().enumerate() {
                let all = number * start.alike;
                if left < all {
                    let image = &left / number;
                    let image = image.iter_u64_digits().next().unwrap_or(0) as usize;
                    asked[at].push((tiling, image, left % number));
                    break;
                }
                left -= all;
            }
        }
        let mut lines = Lines::default();
        let mut fields = Vec::new();
        for ((start, _), asked) in starts.iter().zip(asked).filter(|(_, asked)| !asked.is_empty()) {
            let kept = Kept::new(turns::sweep(&self.plane, start, None, &mut lines)?, self.memory)?;
            let numbers: Vec<BigUint> = asked.iter().map(|asked| asked.2.clone()).collect();
            let fillings = kept.fillings(&numbers, self.memory)?;
            let distinct = distinct(images, start);
            for ((tiling, image, _), cells) in asked.into_iter().zip(fillings) {
                let image = distinct[image];
                let width = self.plane.width();
                let mut moved = cells.clone();
                for (at, &tile) in cells.iter().enumerate() {
                    let to = at - at % width + image.column(at % width);
                    moved[to] = image.tiles[usize::from(tile)];
                }
                fields.push((tiling, self.field(&moved)));
            }
        }
        fields.sort_by_key(|&(tiling, _)| tiling);
        Ok(fields.into_iter().map(|(_, field)| field).collect())
    }

    /// The field of cells as they were counted.
    fn field(&self, cells: &[u8]) -> Field {
        let mut field = self.blank.clone();
        let width = self.plane.width();
        for (at, &tile) in cells.iter().enumerate() {
            let (column, row) = self.plane.place(at % width, at / width);
            field.set(column, row, tile);
        }
        field
    }
}

/// Images that make different starts of one.
fn distinct<'a>(images: &'a [Image], start: &Start) -> Vec<&'a Image> {
    let mut seen = std::collections::BTreeSet::new();
    images.iter().filter(|image| seen.insert(image.of(&start.runs))).collect()
}

/// A random number below a bound, all equally likely.
fn below(bound: &BigUint, random: &mut impl Rng) -> BigUint {
    let bits = bound.bits();
    loop {
        let words = bits.div_ceil(32);
        let mut digits: Vec<u32> = (0..words).map(|_| random.next_u32()).collect();
        if let (Some(last), true) = (digits.last_mut(), !bits.is_multiple_of(32)) {
            *last &= (1 << (bits % 32)) - 1;
        }
        let number = BigUint::new(digits);
        if number < *bound {
            return number;
        }
    }
}

impl Kept {
    fn new(sweep: Sweep, memory: usize) -> Result<Self, CountError> {
        let mut kept =
            Self { sweep: sweep.clone(), gap: 1, tables: Vec::new(), total: BigUint::ZERO };
        let (mut sweep, mut row, mut bytes) = (sweep, 0, 0);
        while !sweep.is_done() {
            if sweep.is_at_row() {
                if row % kept.gap == 0 {
                    bytes += sweep.table().bytes();
                    kept.tables.push(sweep.table().clone());
                }
                row += 1;
            }
            sweep.step();
            // Half of the memory for these, half for those that are counted again.
            if bytes + sweep.bytes() > memory / 2 && kept.tables.len() > 2 {
                let mut stays = [true, false].into_iter().cycle();
                kept.tables.retain(|_| stays.next().unwrap_or(false));
                bytes = kept.tables.iter().map(Table::bytes).sum();
                kept.gap *= 2;
            }
            within(memory, bytes + sweep.bytes())?;
        }
        kept.total = sweep.numbers().into_iter().sum();
        Ok(kept)
    }

    /// The fillings with these numbers.
    fn fillings(&self, numbers: &[BigUint], memory: usize) -> Result<Vec<Vec<u8>>, CountError> {
        let width = self.sweep.width();
        let mut walks: Vec<(u64, BigUint, Vec<u8>)> =
            numbers.iter().map(|number| (0, number.clone(), Vec::new())).collect();
        let held: usize = self.tables.iter().map(Table::bytes).sum();
        let mut end = self.sweep.steps();
        for (at, table) in self.tables.iter().enumerate().rev() {
            // Between rows, and then between cells.
            let rows = self.between(table, at * self.gap * width, end, width, memory - held)?;
            let more: usize = rows.iter().map(Table::bytes).sum();
            for (row, table) in rows.iter().enumerate().rev() {
                let begin = (at * self.gap + row) * width;
                let left = memory.saturating_sub(held + more);
                let cells = self.between(table, begin, begin + width, 1, left)?;
                for (cell, table) in cells.iter().enumerate().rev() {
                    let (ways, [row_before, rest, slot]) = self.sweep.back(begin + cell);
                    for (state, number, tiles) in &mut walks {
                        let kept = (*state >> slot & ((1 << rest) - 1)) << row_before;
                        let ways = &ways[(*state & ((1 << slot) - 1)) as usize];
                        for &(before, tile) in ways {
                            let Some(limbs) = table.get(before | kept) else { continue };
                            let all = number_of(limbs);
                            if *number < all {
                                *state = before | kept;
                                tiles.push(tile);
                                break;
                            }
                            *number -= all;
                        }
                    }
                }
            }
            end = at * self.gap * width;
        }
        let forward = |(_, _, mut tiles): (u64, BigUint, Vec<u8>)| {
            tiles.reverse();
            tiles
        };
        Ok(walks.into_iter().map(forward).collect())
    }

    /// The tables from one step on to another, every so many steps.
    fn between(
        &self,
        table: &Table,
        begin: usize,
        end: usize,
        gap: usize,
        memory: usize,
    ) -> Result<Vec<Table>, CountError> {
        let mut sweep = self.sweep.clone();
        sweep.restore(begin, table.clone());
        let mut tables = Vec::new();
        let mut bytes = 0;
        while sweep.done() < end {
            if (sweep.done() - begin).is_multiple_of(gap) {
                bytes += sweep.table().bytes();
                within(memory, bytes)?;
                tables.push(sweep.table().clone());
            }
            sweep.step();
        }
        Ok(tables)
    }
}
