//! `verify`: is it a packing? Every file is reported, also after a bad one.
//!
//! The packings of a list are checked in chunks on all threads; reports keep their order.

use super::aperiodic::certificate::CertificateReport;
use super::aperiodic::claims::{ClaimReport, holds_claim};
use super::args::VerifyArgs;
use super::cube::CubeReport;
use super::exit::Exit;
use super::recursive::Recursive;
use super::{describe, output, session, set, source};
use crate::store::{Claim, Input, Solution, StoreError, holds_certificate, holds_cubes, solutions};
use crate::torus::Packing;
use crate::verify::{self, Recursion, Verdict};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::path::Path;

/// Packings that are read before they are checked together.
const CHUNK: usize = 4096;
/// Packings of one file whose faults are told in full.
pub(super) const TOLD: usize = 10;

/// Whether something could be printed.
type Printed = anyhow::Result<()>;

/// Runs the command.
///
/// # Errors
/// Bad usage, or standard output that cannot be written. Bad files are reported instead.
pub fn run(args: &VerifyArgs) -> anyhow::Result<Exit> {
    let claim = set::packing_claim(&args.claim)?;
    session::threads(args.threads)?;
    let mut exit = Exit::Yes;
    let mut objects = Vec::new();
    for file in &args.files {
        let input = source::open(file);
        let name = || file.display().to_string();
        let mut tell = |of: Exit, object: &dyn Fn() -> String, print: &dyn Fn() -> Printed| {
            exit = worse(exit, of);
            if !args.json {
                return print();
            }
            objects.push(object());
            Ok(())
        };
        let about_packings = args.recursive || claim != Claim::default();
        match input.as_ref() {
            Ok(input) if holds_cubes(input) => {
                let report = CubeReport::new(name(), input, about_packings);
                tell(report.exit(), &|| report.object(), &|| report.print(args.quiet))?;
            }
            Ok(input) if holds_claim(input) => {
                let report = ClaimReport::new(name(), input);
                tell(report.exit(), &|| report.object(), &|| report.print(args.quiet))?;
            }
            Ok(input) if holds_certificate(input) => {
                let report = CertificateReport::new(name(), input, about_packings);
                tell(report.exit(), &|| report.object(), &|| report.print(args.quiet))?;
            }
            _ => {
                let report = check(file, input, &claim, args.recursive);
                tell(report.exit(), &|| report.object(), &|| report.print(args.quiet))?;
            }
        }
    }
    if args.json {
        output::line(&format!("{{\"files\":[{}]}}", objects.join(",")))?;
    }
    Ok(exit)
}

fn worse(a: Exit, b: Exit) -> Exit {
    if a.code() >= b.code() { a } else { b }
}

/// What there is to say about a file.
#[derive(Default)]
struct Report {
    name: String,
    /// The first packing.
    first: Option<Packing>,
    /// Packings checked.
    packings: u64,
    /// Those that are none.
    invalid: u64,
    /// The first of those: its number in the file, its line, what is wrong with it.
    bad: Vec<(u64, usize, Verdict)>,
    wrong_size: bool,
    /// What was asked for besides.
    recursive: Option<Recursive>,
    /// Why the file could not be read to its end.
    error: Option<StoreError>,
}

fn check(file: &Path, input: Result<Input, StoreError>, claim: &Claim, recursive: bool) -> Report {
    let mut report = Report { name: file.display().to_string(), ..Report::default() };
    report.recursive = recursive.then(Recursive::default);
    let input = match input {
        Ok(input) => input,
        Err(error) => return Report { error: Some(error), ..report },
    };
    let mut all = solutions(&input, claim);
    loop {
        let mut chunk: Vec<Solution> = Vec::with_capacity(CHUNK.min(64));
        // A chunk of large packings is as good as one of many.
        let mut cells = 0;
        while chunk.len() < CHUNK && cells < CHUNK * 1024 {
            match all.next() {
                Some(Ok(solution)) => {
                    cells += solution.packing.tiles.len();
                    chunk.push(solution);
                }
                Some(Err(error)) => {
                    report.error = Some(error);
                    break;
                }
                None => break,
            }
        }
        let judge = |solution: &Solution| {
            let verdict = verify::check(&solution.packing);
            let asked = recursive && verdict.is_valid();
            (verdict, asked.then(|| verify::check_recursion(&solution.packing)))
        };
        let verdicts: Vec<(Verdict, Option<Recursion>)> = chunk.par_iter().map(judge).collect();
        let last = report.error.is_some() || chunk.is_empty();
        for (solution, (verdict, recursion)) in chunk.into_iter().zip(verdicts) {
            report.add(solution, verdict, recursion);
        }
        if last {
            return report;
        }
    }
}

impl Report {
    fn add(&mut self, solution: Solution, verdict: Verdict, recursion: Option<Recursion>) {
        self.packings += 1;
        if !verdict.is_valid() {
            self.invalid += 1;
            self.wrong_size |= verdict.is_wrong_size();
            if self.bad.len() < TOLD {
                self.bad.push((self.packings, solution.line, verdict));
            }
        }
        if let (Some(all), Some(recursion)) = (&mut self.recursive, recursion) {
            all.add(self.packings, solution.line, recursion);
        }
        self.first.get_or_insert(solution.packing);
    }

    /// Packings that are not recursive, though they should be.
    fn shallow(&self) -> u64 {
        self.recursive.as_ref().map_or(0, Recursive::failed)
    }

    fn exit(&self) -> Exit {
        match (self.error.is_some() || self.wrong_size, self.invalid + self.shallow()) {
            (true, _) => Exit::Bad,
            (false, 0) => Exit::Yes,
            (false, _) => Exit::No,
        }
    }

    /// The verdicts to standard output; what could not be read to standard error.
    fn print(&self, quiet: bool) -> anyhow::Result<()> {
        let name = if self.name == "-" { "standard input" } else { &self.name };
        output::result(|out| {
            for (number, line, verdict) in &self.bad {
                match self.packings {
                    1 => write!(out, "{name}: ")?,
                    _ => write!(out, "{name}: packing {number}, line {line}: ")?,
                }
                let (faults, total) = (verdict.faults(), verdict.total());
                if let ([fault], 1) = (faults, total) {
                    writeln!(out, "not a packing: {fault}")?;
                    continue;
                }
                writeln!(out, "not a packing: {}", describe::number(total, "fault"))?;
                for fault in faults {
                    writeln!(out, "  {fault}")?;
                }
                let more = total - faults.len() as u64;
                if more > 0 {
                    writeln!(out, "  and {more} more")?;
                }
            }
            let valid = self.packings - self.invalid - self.shallow();
            let untold = self.invalid - self.bad.len() as u64;
            if untold > 0 {
                writeln!(out, "{name}: {untold} more that are not packings")?;
            }
            if let Some(all) = &self.recursive {
                all.print(out, name, self.packings)?;
            }
            let Some(first) = &self.first else { return Ok(()) };
            let blocks = self.recursive.as_ref().map_or(String::new(), Recursive::words);
            match (self.packings, self.invalid + self.shallow()) {
                (1, 0) if !quiet => writeln!(out, "{name}: valid: {}{blocks}", words(first)),
                (packings, 0) if packings > 1 && self.error.is_none() && !quiet => {
                    let each = words(first);
                    writeln!(out, "{name}: valid: {packings} packings, the first: {each}")
                }
                (packings, _) if packings > 1 && !quiet => {
                    writeln!(out, "{name}: {valid} of {packings} packings are valid")
                }
                _ => Ok(()),
            }
        })?;
        if let Some(error) = &self.error {
            output::remark(&error.to_string());
        }
        Ok(())
    }

    /// The JSON object of the file.
    fn object(&self) -> String {
        let description = self.first.as_ref().map(output::description);
        let field =
            |name: &str| description.as_ref().map_or(Value::Null, |fields| fields[name].clone());
        let error = match (&self.error, self.bad.first()) {
            (Some(error), _) => Some(error.to_string()),
            (None, Some((_, _, verdict))) if self.packings == 1 => Some(verdict.to_string()),
            (None, Some((number, line, verdict))) => {
                Some(format!("packing {number}, line {line}: {verdict}"))
            }
            (None, None) => self.recursive.as_ref().and_then(|all| all.error(self.packings)),
        };
        let mut fields = vec![
            ("file", json!(self.name)),
            ("valid", json!(self.exit() == Exit::Yes)),
            ("kind", field("kind")),
            ("colors", field("colors")),
            ("width", field("width")),
            ("height", field("height")),
            ("set", field("set")),
            ("topology", field("topology")),
            ("packings", json!(self.packings)),
            ("error", json!(error)),
        ];
        if let Some(all) = &self.recursive {
            fields.push(("recursive", json!(all.least())));
        }
        output::object_text(&fields)
    }
}

/// A valid packing in words.
fn words(packing: &Packing) -> String {
    let set = describe::set(&packing.set);
    let torus = describe::board(packing.set.kind(), packing.shape, &packing.board);
    format!("{set}, {torus}, {}", describe::occurrences(packing))
}
