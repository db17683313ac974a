//! That cells cannot be completed, for others to check: the formula in the format DIMACS, and what
//! was learned, clause by clause, in the format DRAT (without deletions).
//!
//! Each clause of the proof follows from those before by drawing conclusions from single clauses;
//! the last one is empty. Programs that know nothing of tilings check that; what the variables of
//! the formula say is written into it.

use super::encode::Formula;
use super::sat::{Answer, Literal, Record, Solver};
use super::{ExactError, Question};
use crate::dappled::{Field, Rule};
use crate::search::Stop;
use std::io::{self, Write};

/// A formula that contradicts itself, and how.
#[derive(Debug, Clone)]
pub struct Proof {
    record: Record,
    variables: usize,
    size: (usize, usize),
    tiles: usize,
}

/// A proof that a partial tiling has no completion; nothing if it has one, or when stopped.
///
/// # Errors
/// As [`super::complete`].
pub fn proof(rule: &Rule, partial: &Field, stop: &dyn Stop) -> Result<Option<Proof>, ExactError> {
    // Refuses what cannot be asked.
    let given = Question::new(rule, partial, 0)?.given;
    let mut solver = Solver::new(0);
    solver.keep_record();
    let mut formula = Formula::new(rule, solver);
    given.iter().for_each(|&literal| formula.solver.add(&[literal]));
    let failed = matches!(formula.solver.solve(&[], stop), Answer::Failed(_));
    let variables = formula.solver.variables();
    let size = (rule.width(), rule.height());
    let record = formula.solver.record().filter(|_| failed).cloned();
    Ok(record.map(|record| Proof { record, variables, size, tiles: rule.tiles() }))
}

impl Proof {
    /// How many clauses the proof has.
    pub fn steps(&self) -> usize {
        self.record.learned.len()
    }

    /// Writes the formula.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_formula(&self, out: &mut dyn Write) -> io::Result<()> {
        let (width, height) = self.size;
        writeln!(out, "c dappled tiling, {width}x{height} cells, {} tiles", self.tiles)?;
        match self.tiles {
            2 => writeln!(out, "c 1 + column + {width} row: tile 1 there, else tile 0")?,
            tiles => {
                writeln!(
                    out,
                    "c 1 + tile + {tiles} (column + {width} row): the tile may be there"
                )?;
            }
        }
        writeln!(out, "p cnf {} {}", self.variables, self.record.given.len())?;
        self.record.given.iter().try_for_each(|clause| write_clause(out, clause))
    }

    /// Writes the proof.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_steps(&self, out: &mut dyn Write) -> io::Result<()> {
        self.record.learned.iter().try_for_each(|clause| write_clause(out, clause))
    }
}

fn write_clause(out: &mut dyn Write, clause: &[Literal]) -> io::Result<()> {
    for literal in clause {
        let sign = if literal.is_positive() { "" } else { "-" };
        write!(out, "{sign}{} ", literal.variable() + 1)?;
    }
    writeln!(out, "0")
}
