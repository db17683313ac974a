//! `dapple decide`: can these cells be completed, and with how many of a tile?
//!
//! A completion goes to standard output, or a file. If there is none, the cells to blame are told as
//! a field of their own, all others free: a file that can be decided again.

use super::{rule, write};
use crate::cli::args::DappleDecideArgs;
use crate::cli::describe::number;
use crate::cli::exit::Exit;
use crate::cli::{output, signal};
use crate::dappled::exact::{
    Completion, Counted, Counts, ExactError, Reason, complete, complete_with, counts, proof,
};
use crate::dappled::notation::write_field;
use crate::dappled::{FREE, Field, Rule};
use crate::search::Stop;
use crate::store::{check_writable, write_file};
use crate::torus::Shape;
use anyhow::{Context, anyhow, ensure};
use serde_json::{Value, json};
use std::ops::RangeInclusive;
use std::path::Path;
use std::time::Instant;

/// Cells of a rectangle at most.
const MOST_CELLS: usize = 1 << 24;

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &DappleDecideArgs) -> anyhow::Result<Exit> {
    let begin = Instant::now();
    for file in [&args.output, &args.proof, &args.formula].into_iter().flatten() {
        check_writable(file)?;
    }
    let partial = partial(args)?;
    let rule = rule::rule(&args.rule, (partial.width(), partial.height()))?;
    let count = args.count.as_deref().map(|text| parse_count(text, &partial)).transpose()?;
    let deadline = args.time_limit.and_then(|time| begin.checked_add(time));
    let stop = (signal::listen()?, deadline);
    let filled = partial.cells().iter().filter(|&&tile| tile != FREE).count();
    let task = Task { args, rule, partial, filled, begin };
    if let Some(tile) = args.counts {
        let found = counts(&task.rule, &task.partial, tile, args.seed, &stop)
            .map_err(|error| task.named(error, "--counts"))?;
        return task.tell_counts(tile, &found);
    }
    let Some(count) = count else {
        let found = complete(&task.rule, &task.partial, args.seed, &stop)
            .map_err(|error| task.named(error, "--count"))?;
        return match found {
            Completion::Found(tiling) => task.tell_found(&tiling, None),
            Completion::Impossible { core, minimal } => {
                task.tell_impossible(&core, minimal, None, &stop)
            }
            Completion::Stopped => task.tell_stopped(),
        };
    };
    let found = complete_with(&task.rule, &task.partial, count, args.seed, &stop)
        .map_err(|error| task.named(error, "--count"))?;
    match found {
        Counted::Found(tiling) => task.tell_found(&tiling, Some(count)),
        Counted::Hopeless { core, minimal } => task.tell_impossible(&core, minimal, None, &stop),
        Counted::Impossible { reason, bound, core, minimal } => {
            let what = format!("{} of tile {}", count.1, count.0);
            let why = match reason {
                Reason::Search => what,
                reason if count.1 < bound.0 => {
                    format!("{what}; there are at least {} ({})", bound.0, words(reason))
                }
                reason => format!("{what}; there are at most {} ({})", bound.1, words(reason)),
            };
            task.tell_impossible(&core, minimal, Some(&why), &stop)
        }
        Counted::Stopped => task.tell_stopped(),
    }
}

/// The cells that are given.
fn partial(args: &DappleDecideArgs) -> anyhow::Result<Field> {
    match (&args.file, &args.size) {
        (Some(file), _) => rule::field(file, args.rule.tiles),
        (None, size) => {
            let text = size.as_deref().unwrap_or_default();
            let shape: Shape = text.parse().context("--size")?;
            let cells = shape.cells();
            ensure!(
                cells <= MOST_CELLS,
                "--size {text}: {cells} cells, expected {MOST_CELLS} or fewer"
            );
            Ok(Field::filled(shape.width(), shape.height(), FREE)?)
        }
    }
}

/// A tile and its number.
fn parse_count(text: &str, partial: &Field) -> anyhow::Result<(u8, u32)> {
    let expected = || anyhow!("--count '{text}': expected a tile and a number, such as 1=20");
    let (tile, number_text) = text.split_once('=').ok_or_else(expected)?;
    let tile = tile.parse().map_err(|_| expected())?;
    let wanted: u32 = number_text.parse().map_err(|_| expected())?;
    let cells = partial.cells().len();
    ensure!(
        wanted as usize <= cells,
        "--count {text}: there are only {}",
        number(cells as u64, "cell")
    );
    Ok((tile, wanted))
}

/// Why there are no fewer, or no more.
fn words(reason: Reason) -> &'static str {
    match reason {
        Reason::Cells => "there are no more cells",
        Reason::Windows => "disjoint runs of cells, each of which needs one",
        Reason::Rows => "each row needs some",
        Reason::Columns => "each column needs some",
        Reason::Search => "by search",
    }
}

/// What is asked.
struct Task<'a> {
    args: &'a DappleDecideArgs,
    rule: Rule,
    partial: Field,
    filled: usize,
    begin: Instant,
}

impl Task<'_> {
    /// An error with the option, or the file, that it is about.
    fn named(&self, error: ExactError, option: &str) -> anyhow::Error {
        match (&error, &self.args.file) {
            (ExactError::Counted { .. }, _) => anyhow!("{option}: {error}"),
            (_, Some(file)) => anyhow!("{}: {error}", file.display()),
            _ => anyhow!("--size: {error}"),
        }
    }

    /// The fields that all answers have.
    fn object(&self, result: &str, more: &[(&str, Value)]) -> anyhow::Result<()> {
        let mut fields = vec![
            ("result", json!(result)),
            ("width", json!(self.partial.width())),
            ("height", json!(self.partial.height())),
            ("given", json!(self.filled)),
        ];
        fields.extend_from_slice(more);
        fields.push(("seconds", json!(self.begin.elapsed().as_secs_f64())));
        output::object(&fields)
    }

    fn tell_found(&self, tiling: &Field, count: Option<(u8, u32)>) -> anyhow::Result<Exit> {
        let args = self.args;
        let with = count.map_or(String::new(), |(tile, n)| format!(", {n} of tile {tile}"));
        let (width, height) = (tiling.width(), tiling.height());
        let given = number(self.filled as u64, "given cell");
        let about = format!("dappled tiling, {width}x{height}, {given}{with}, found by search");
        if args.output.is_some() || !args.json {
            write::write(tiling, args.rule.tiles, args.output.as_deref(), &about)?;
        }
        if args.json {
            let tiles = match args.output {
                Some(_) => Value::Null,
                None => write::rows_json(tiling),
            };
            let file = args.output.as_ref().map(|file| file.to_string_lossy());
            self.object("found", &[("tiles", tiles), ("file", json!(file))])?;
        } else if !args.quiet {
            let file = args.output.as_ref().map(|file| format!("; written to {}", file.display()));
            output::remark(&format!("{about}; checked{}", file.unwrap_or_default()));
        }
        Ok(Exit::Yes)
    }

    fn tell_impossible(
        &self,
        core: &[u32],
        minimal: bool,
        why: Option<&str>,
        stop: &dyn Stop,
    ) -> anyhow::Result<Exit> {
        let args = self.args;
        let mut blamed = Field::filled(self.partial.width(), self.partial.height(), FREE)?;
        for &cell in core {
            blamed.cells_mut()[cell as usize] = self.partial.cells()[cell as usize];
        }
        if let Some(file) = &args.proof {
            self.prove(&blamed, file, stop)?;
        }
        if args.json {
            let place = |&cell: &u32| {
                let cell = cell as usize;
                json!([cell % blamed.width(), cell / blamed.width()])
            };
            return self
                .object(
                    "impossible",
                    &[
                        ("reason", json!(why)),
                        ("core", write::rows_json(&blamed)),
                        ("core_cells", core.iter().map(place).collect()),
                        ("minimal", json!(minimal)),
                    ],
                )
                .map(|()| Exit::No);
        }
        let head = match (core.len(), why) {
            (0, Some(why)) if self.filled == 0 => why.to_owned(),
            (0, Some(why)) => format!("{why}; the given cells are not to blame"),
            (0, None) => "there is no dappled tiling of this size at all".to_owned(),
            (cells, why) => format!(
                "{}{} of {} {} no completion{}",
                why.map_or(String::new(), |why| format!("{why}; ")),
                cells,
                number(self.filled as u64, "given cell"),
                if cells == 1 { "has" } else { "have" },
                if minimal {
                    "; without any one of them there is one"
                } else {
                    "; perhaps fewer have none"
                },
            ),
        };
        output::result(|out| {
            writeln!(out, "# impossible: {head}")?;
            match core.is_empty() {
                true => Ok(()),
                false => out.write_all(write_field(&blamed, self.rule.tiles()).as_bytes()),
            }
        })?;
        Ok(Exit::No)
    }

    /// Writes a proof, and the formula that it is about.
    fn prove(&self, blamed: &Field, file: &Path, stop: &dyn Stop) -> anyhow::Result<()> {
        let Some(proof) = proof(&self.rule, blamed, stop).map_err(|e| self.named(e, "--proof"))?
        else {
            output::remark(&format!("{}: not written: stopped", file.display()));
            return Ok(());
        };
        write_file(file, |out| proof.write_steps(out))?;
        if let Some(formula) = &self.args.formula {
            write_file(formula, |out| proof.write_formula(out))?;
        }
        if !self.args.quiet {
            let steps = number(proof.steps() as u64, "clause");
            output::remark(&format!("proof of {steps} written to {}", file.display()));
        }
        Ok(())
    }

    fn tell_stopped(&self) -> anyhow::Result<Exit> {
        match self.args.json {
            true => self.object("stopped", &[])?,
            false => output::line("stopped: not decided")?,
        }
        Ok(Exit::Stopped)
    }

    fn tell_counts(&self, tile: u8, counts: &Counts) -> anyhow::Result<Exit> {
        let possible = ranges(counts, Some(true));
        let undecided = ranges(counts, None);
        let none = possible.is_empty() && undecided.is_empty();
        if self.args.json {
            let pairs = |ranges: &[RangeInclusive<usize>]| -> Value {
                ranges.iter().map(|range| json!([range.start(), range.end()])).collect()
            };
            let result = match (none, undecided.is_empty()) {
                (true, _) => "none",
                (_, true) => "complete",
                (_, false) => "stopped",
            };
            self.object(
                result,
                &[
                    ("tile", json!(tile)),
                    ("possible", pairs(&possible)),
                    ("undecided", pairs(&undecided)),
                    ("fewer", json!(words(counts.least.1))),
                    ("more", json!(words(counts.most.1))),
                ],
            )?;
        } else {
            let list = |ranges: &[RangeInclusive<usize>]| {
                let range = |range: &RangeInclusive<usize>| match range.end() - range.start() {
                    0 => range.start().to_string(),
                    _ => format!("{}..{}", range.start(), range.end()),
                };
                ranges.iter().map(range).collect::<Vec<_>>().join(", ")
            };
            let cells = number(self.partial.cells().len() as u64, "cell");
            let mut lines = match possible.is_empty() {
                true => vec![format!("tile {tile}: no number of it is known to be possible")],
                false => vec![format!("tile {tile}: {} of {cells}", list(&possible))],
            };
            if none {
                lines = vec![format!("tile {tile}: none, there is no dappled tiling")];
            } else {
                let (least, most) = (counts.least, counts.most);
                for (what, (bound, reason)) in [("fewer than", least), ("more than", most)] {
                    if reason != Reason::Cells {
                        lines.push(format!("{what} {bound}: none ({})", words(reason)));
                    }
                }
                if !undecided.is_empty() {
                    lines.push(format!("not decided: {}", list(&undecided)));
                }
            }
            output::line(&lines.join("\n"))?;
        }
        Ok(match (none, undecided.is_empty()) {
            (true, _) => Exit::No,
            (_, true) => Exit::Yes,
            (_, false) => Exit::Stopped,
        })
    }
}

/// The numbers about which this is known, as ranges.
fn ranges(counts: &Counts, verdict: Option<bool>) -> Vec<RangeInclusive<usize>> {
    let mut ranges: Vec<RangeInclusive<usize>> = Vec::new();
    for (number, _) in counts.possible.iter().enumerate().filter(|(_, v)| **v == verdict) {
        match ranges.last_mut() {
            Some(range) if range.end() + 1 == number => *range = *range.start()..=number,
            _ => ranges.push(number..=number),
        }
    }
    ranges
}
