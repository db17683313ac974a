//! How many of a tile there can be.
//!
//! A tiling with some number of it leads to others, cell by cell ([`super::walk`]); that shows what
//! is possible. What is not is shown by arguments without a search ([`super::bound`]), or by the
//! solver, to which the numbers of the rows and the whole are literals ([`super::total`]).

use super::bound::{Bounds, Reason, bounds};
use super::sat::{Answer, Literal};
use super::shrink::smaller;
use super::total::total;
use super::walk::Walk;
use super::{Completion, ExactError, Question};
use crate::dappled::{Field, Rule};
use crate::search::Stop;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Rectangles of more cells have no formula for their numbers.
const MOST_COUNTED: usize = 2304;
/// First tilings that walks begin with.
const STARTS: usize = 4;

/// What became of a number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Counted {
    /// A completion with so many.
    Found(Field),
    /// There is no completion at all, as in [`Completion::Impossible`].
    Hopeless {
        /// Filled cells that are to blame.
        core: Vec<u32>,
        /// Without any one of them there would be a completion: proved for each.
        minimal: bool,
    },
    /// There is none with so many.
    Impossible {
        /// Why; for all reasons but a search, the bound that was missed.
        reason: Reason,
        /// The least and the largest number there can be, as far as the reason says.
        bound: (u32, u32),
        /// Filled cells that are to blame, as in [`Completion::Impossible`].
        core: Vec<u32>,
        /// Without any one of them there would be a completion with so many: proved for each.
        minimal: bool,
    },
    /// Stopped, or given up, before the answer was known.
    Stopped,
}

/// Completes a partial tiling so that it has exactly so many of a tile.
///
/// # Errors
/// As [`super::complete`], or a tile that there is not.
pub fn complete_with(
    rule: &Rule,
    partial: &Field,
    (tile, wanted): (u8, u32),
    seed: u64,
    stop: &dyn Stop,
) -> Result<Counted, ExactError> {
    let mut counter = Counter::new(rule, partial, tile, seed, stop)?;
    let Bounds { least, most, .. } = counter.bounds;
    let bound = (least.0, most.0);
    for (missed, reason) in [(wanted < least.0, least.1), (wanted > most.0, most.1)] {
        if missed {
            return Ok(Counted::Impossible { reason, bound, core: Vec::new(), minimal: true });
        }
    }
    let mut found = None;
    let impossible = counter.explore(Some(wanted), stop, |number, tiling| {
        if number == wanted && found.is_none() {
            found = Some(tiling.clone());
        }
    })?;
    if let Some(tiling) = found {
        return counter.question.checked(tiling).map(Counted::Found);
    }
    if let Some((core, minimal)) = impossible {
        return Ok(Counted::Hopeless { core, minimal });
    }
    counter.exactly(wanted, stop)
}

/// Which numbers of a tile there are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counts {
    /// For every number, from none to all cells, whether it is possible, if that is known.
    pub possible: Vec<Option<bool>>,
    /// The least number that is not excluded, and why there are no fewer.
    pub least: (u32, Reason),
    /// The largest.
    pub most: (u32, Reason),
}

/// Finds out which numbers of a tile the completions of a partial tiling have.
///
/// # Errors
/// As [`super::complete`], or a tile that there is not.
pub fn counts(
    rule: &Rule,
    partial: &Field,
    tile: u8,
    seed: u64,
    stop: &dyn Stop,
) -> Result<Counts, ExactError> {
    let mut counter = Counter::new(rule, partial, tile, seed, stop)?;
    let cells = partial.cells().len();
    let Bounds { least, most, .. } = counter.bounds;
    let (mut least, mut most) = (least, most);
    let mut possible: Vec<Option<bool>> = (0..=cells as u32)
        .map(|number| (number < least.0 || number > most.0).then_some(false))
        .collect();
    let none = counter.explore(None, stop, |number, _| possible[number as usize] = Some(true))?;
    if none.is_some() {
        possible.fill(Some(false));
    } else if counter.count() {
        // Whatever is not known yet, from the middle outward: all at once while that is none.
        let known = |possible: &[Option<bool>]| {
            let first = possible.iter().position(|&p| p == Some(true));
            first.zip(possible.iter().rposition(|&p| p == Some(true)))
        };
        while let Some((first, last)) = known(&possible) {
            let fewer = first > 0 && possible[..first].contains(&None);
            let more = possible[last + 1..].contains(&None);
            let assumed = match () {
                () if fewer => vec![!counter.outputs[first - 1]],
                () if more => vec![counter.outputs[last]],
                () => break,
            };
            match counter.ask(&assumed, stop) {
                Answer::Model => {
                    let tiling = counter.question.formula.tiling(partial);
                    let tiling = counter.question.checked(tiling)?;
                    let number = tiling.cells().iter().filter(|&&t| t == tile).count();
                    possible[number] = Some(true);
                }
                Answer::Failed(_) if fewer => {
                    possible[..first].fill(Some(false));
                    least = (first as u32, Reason::Search);
                }
                Answer::Failed(_) => {
                    possible[last + 1..].fill(Some(false));
                    most = (last as u32, Reason::Search);
                }
                Answer::Stopped => break,
            }
        }
        for (number, verdict) in possible.iter_mut().enumerate().filter(|(_, v)| v.is_none()) {
            *verdict = match counter.ask(&counter.equals(number), stop) {
                Answer::Model => Some(true),
                Answer::Failed(_) => Some(false),
                Answer::Stopped => break,
            };
        }
    }
    // A walk has shown that the bound is reached; else the least is what is not excluded.
    let open = |&&p: &&Option<bool>| p != Some(false);
    if let Some(first) = possible.iter().position(|p| open(&p)) {
        least.0 = first as u32;
    }
    if let Some(last) = possible.iter().rposition(|p| open(&p)) {
        most.0 = last as u32;
    }
    Ok(Counts { possible, least, most })
}

/// A question about numbers of a tile.
struct Counter<'a> {
    question: Question<'a>,
    tile: u8,
    seed: u64,
    bounds: Bounds,
    /// More than so many, if the formula has been told.
    outputs: Vec<Literal>,
}

impl<'a> Counter<'a> {
    fn new(
        rule: &'a Rule,
        partial: &'a Field,
        tile: u8,
        seed: u64,
        stop: &dyn Stop,
    ) -> Result<Self, ExactError> {
        let question = Question::new(rule, partial, seed)?;
        if usize::from(tile) >= rule.tiles() {
            return Err(ExactError::Counted { tile, tiles: rule.tiles() });
        }
        let bounds = bounds(rule, tile, stop);
        Ok(Self { question, tile, seed, bounds, outputs: Vec::new() })
    }

    /// Walks from tilings that the solver finds: towards a number, or to both ends. The core, if
    /// there is no tiling at all.
    fn explore(
        &mut self,
        wanted: Option<u32>,
        stop: &dyn Stop,
        mut met: impl FnMut(u32, &Field),
    ) -> Result<Option<(Vec<u32>, bool)>, ExactError> {
        let (rule, partial) = (self.question.rule, self.question.partial);
        let mut random = Pcg64::seed_from_u64(self.seed);
        let walk = Walk::new(rule, partial, self.tile);
        let ends = [self.bounds.least.0, self.bounds.most.0];
        for start in 0..STARTS {
            let goal = wanted.unwrap_or(ends[start % 2]);
            let diagonals = (start >= STARTS / 2).then_some(start);
            self.prefer(goal, diagonals, &mut random);
            match self.question.answer(stop)? {
                Completion::Found(mut tiling) => {
                    walk.towards(&mut tiling, goal, &mut random, stop, &mut met);
                    if Some(walk.number(&tiling)) == wanted {
                        return Ok(None);
                    }
                }
                Completion::Impossible { core, minimal } => return Ok(Some((core, minimal))),
                Completion::Stopped => return Ok(None),
            }
        }
        Ok(None)
    }

    /// Has the solver guess about so many of the tile: by chance, or in diagonals from here on,
    /// which is how there are fewest, or most.
    fn prefer(&mut self, goal: u32, diagonals: Option<usize>, random: &mut Pcg64) {
        let (partial, tiles) = (self.question.partial, self.question.rule.tiles() as u8);
        let (width, cells) = (partial.width(), partial.cells().len());
        let density = f64::from(goal) / cells as f64;
        let rare = density <= 0.5;
        let period = (1.0 / density.min(1.0 - density)).min(1e6).round() as usize;
        for cell in 0..cells {
            let has = match diagonals {
                Some(from) => (cell % width + cell / width + from).is_multiple_of(period) == rare,
                None => random.random_bool(density),
            };
            let guess = match has || tiles == 1 {
                true => self.tile,
                false => (self.tile + random.random_range(1..tiles)) % tiles,
            };
            self.question.prefer(cell as u32, guess);
        }
    }

    /// Tells the formula of numbers, if it is not too large; whether it has been told.
    fn count(&mut self) -> bool {
        let (width, cells) =
            (self.question.partial.width() as u32, self.question.partial.cells().len());
        if cells > MOST_COUNTED || self.bounds.rows.is_empty() {
            return false;
        }
        let formula = &mut self.question.formula;
        formula.only(self.tile);
        let rows: Vec<Vec<Literal>> = (0..cells as u32 / width)
            .map(|row| (0..width).map(|x| formula.holds(row * width + x, self.tile)).collect())
            .collect();
        let Bounds { least, most, rows: known } = &self.bounds;
        // What is known of rows and of the whole is of help.
        self.outputs = total(&mut formula.solver, &rows, |solver, row, outputs| {
            let (few, many) = (known[row].0 as usize, known[row].1 as usize);
            outputs[..few].iter().for_each(|&more| solver.add(&[more]));
            outputs[many..].iter().for_each(|&more| solver.add(&[!more]));
        });
        for (number, &more) in (0..).zip(&self.outputs) {
            match () {
                () if number < least.0 => formula.solver.add(&[more]),
                () if number >= most.0 => formula.solver.add(&[!more]),
                () => {}
            }
        }
        true
    }

    /// Exactly so many.
    fn equals(&self, number: usize) -> Vec<Literal> {
        let more = number.checked_sub(1).map(|fewer| self.outputs[fewer]);
        more.into_iter().chain(self.outputs.get(number).map(|&more| !more)).collect()
    }

    fn ask(&mut self, assumed: &[Literal], stop: &dyn Stop) -> Answer {
        let all = [assumed, &self.question.given].concat();
        self.question.formula.solver.solve(&all, stop)
    }

    /// The answer of the solver to exactly so many.
    fn exactly(&mut self, wanted: u32, stop: &dyn Stop) -> Result<Counted, ExactError> {
        if !self.count() {
            return Ok(Counted::Stopped);
        }
        let number = self.equals(wanted as usize);
        Ok(match self.ask(&number, stop) {
            Answer::Model => {
                let tiling = self.question.formula.tiling(self.question.partial);
                Counted::Found(self.question.checked(tiling)?)
            }
            Answer::Failed(failed) => {
                let failed = failed.into_iter().filter(|l| !number.contains(l)).collect();
                let formula = &mut self.question.formula;
                let (core, minimal) = smaller(&mut formula.solver, &number, failed, stop);
                let core = self.question.blamed(&core);
                let bound = (self.bounds.least.0, self.bounds.most.0);
                Counted::Impossible { reason: Reason::Search, bound, core, minimal }
            }
            Answer::Stopped => Counted::Stopped,
        })
    }
}
