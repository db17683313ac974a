//! What a SAT solver prints, and the packing it means.
//!
//! The solver says `s SATISFIABLE` and lists the literals that hold after `v`, or it says
//! `s UNSATISFIABLE`; lines with `c` are remarks. MiniSat and others write `SAT` and the literals
//! without `v`, which is read, too. Only the colors of the points matter, and they give a whole
//! torus, which is for [`crate::verify`] to check.

use super::Cnf;

/// What a solver said.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Model {
    /// There is no model.
    None,
    /// The solver gave up.
    Unknown,
    /// The labels of a packing.
    Labels(Vec<u8>),
}

/// Why a text is no model.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ModelError {
    /// A word that is no literal.
    #[error("line {line}: '{word}' is neither a literal nor an answer of a SAT solver")]
    Word {
        /// 1-based.
        line: usize,
        /// The word.
        word: String,
    },
    /// A literal beyond the variables.
    #[error("line {line}: there is no variable {variable}: the problem has {variables}")]
    Range {
        /// 1-based.
        line: usize,
        /// The variable.
        variable: u32,
        /// The number of variables.
        variables: i32,
    },
    /// Nothing was said at all.
    #[error("no answer and no literals: expected the output of a SAT solver")]
    Empty,
    /// A point without exactly one color.
    #[error(
        "{colors} of the variables {first} to {last} hold: row {row}, column {column} needs one color"
    )]
    Colors {
        /// How many hold.
        colors: usize,
        /// The first variable of the point.
        first: i32,
        /// The last.
        last: i32,
        /// The row of its cell.
        row: usize,
        /// The column.
        column: usize,
    },
}

impl Model {
    /// Reads what a solver printed about these clauses.
    ///
    /// # Errors
    /// A text of another form, or colors that are no torus.
    pub fn read(text: &str, cnf: &Cnf<'_>) -> Result<Self, ModelError> {
        let mut holds = vec![false; cnf.variables as usize + 1];
        let mut said = false;
        for (line, text) in (1..).zip(text.lines()) {
            let mut words = text.split_whitespace().peekable();
            let Some(&first) = words.peek() else { continue };
            match first {
                "c" => continue,
                "s" | "v" => drop(words.next()),
                _ => {}
            }
            for word in words {
                match word {
                    "UNSATISFIABLE" | "UNSAT" => return Ok(Self::None),
                    "UNKNOWN" | "INDETERMINATE" => return Ok(Self::Unknown),
                    "SATISFIABLE" | "SAT" => continue,
                    _ => {}
                }
                let wrong = || ModelError::Word { line, word: word.into() };
                let literal: i32 = word.parse().map_err(|_| wrong())?;
                let variable = literal.unsigned_abs();
                let variables = cnf.variables;
                let Some(held) = holds.get_mut(variable as usize) else {
                    return Err(ModelError::Range { line, variable, variables });
                };
                *held = literal > 0;
                said = true;
            }
        }
        if !said {
            return Err(ModelError::Empty);
        }
        Ok(Self::Labels(cnf.instance().labels(&colors(cnf, &holds)?)))
    }
}

/// The color of every point.
fn colors(cnf: &Cnf<'_>, holds: &[bool]) -> Result<Vec<u8>, ModelError> {
    let instance = cnf.instance();
    let color = |(point, about): (usize, &super::instance::Point)| {
        let colors = 0..about.colors as u8;
        let mut shown = colors.filter(|&color| holds[cnf.color(point, color) as usize]);
        match (shown.next(), shown.count()) {
            (Some(color), 0) => Ok(color),
            (one, more) => {
                let (row, column) = instance.position(about.label);
                let (first, last) = (cnf.color(point, 0), cnf.color(point, about.colors as u8 - 1));
                let colors = usize::from(one.is_some()) + more;
                Err(ModelError::Colors { colors, first, last, row, column })
            }
        }
    };
    instance.points.iter().enumerate().map(color).collect()
}
