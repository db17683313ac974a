//! `dapple sample`: random dappled tilings, all equally likely.

use super::count::describe;
use super::rule;
use super::write::{rows_json, write};
use crate::cli::args::DappleSampleArgs;
use crate::cli::exit::Exit;
use crate::cli::{memory, output, session};
use crate::dappled::count::{CountError, Need, Sampler};
use crate::dappled::notation::write_field;
use crate::store::{check_writable, write_file};
use anyhow::{anyhow, bail, ensure};
use serde_json::json;
use std::io::Write;

/// Runs the command.
///
/// # Errors
/// Bad input, more memory than there may be, or a file that cannot be written.
pub fn run(args: &DappleSampleArgs) -> anyhow::Result<Exit> {
    let (rule, given) = rule::problem(&args.size, &args.rule, args.given.as_deref())?;
    if let Some(file) = &args.output {
        check_writable(file)?;
        let png = file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"));
        ensure!(
            !png || args.number == 1,
            "--number {}: a picture holds one tiling, expected 1 or a text file",
            args.number
        );
    }
    session::threads(args.threads)?;
    let explain = |error: CountError| match error {
        CountError::Memory { .. } => anyhow!("{}: {error} (--memory)", describe(&rule)),
        _ => anyhow!("{}: {error}", describe(&rule)),
    };
    if let Some(need) = Need::of_tilings(&rule, given.as_ref())
        && need.bytes > args.memory as f64
    {
        bail!(
            "{}: drawing needs about {} of memory, --memory allows {}",
            describe(&rule),
            memory::words(need.bytes),
            memory::words(args.memory as f64)
        );
    }
    let sampler = Sampler::new(&rule, given.as_ref(), args.memory).map_err(explain)?;
    let tilings = sampler.draw(args.number as usize, args.seed).map_err(explain)?;
    ensure!(
        tilings.iter().all(|tiling| rule.accepts(tiling)),
        "internal error: a tiling that is not dappled; please report"
    );
    let total = sampler.total();
    let about = format!("one of {total} dappled tilings, {}, seed {}", describe(&rule), args.seed);
    if let (Some(file), false) = (&args.output, tilings.is_empty()) {
        match &tilings[..] {
            [tiling] => write(tiling, args.rule.tiles, Some(file), &about)?,
            _ => write_file(file, |out| several(out, args, &about, &tilings))?,
        }
    }
    if args.json {
        let rows: Vec<_> = tilings.iter().map(rows_json).collect();
        output::object(&[
            ("result", json!(if tilings.is_empty() { "none" } else { "sampled" })),
            ("of", json!(total.to_string())),
            ("width", json!(rule.width())),
            ("height", json!(rule.height())),
            ("seed", json!(args.seed)),
            ("tilings", json!(rows)),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ])?;
    } else if tilings.is_empty() {
        output::line(&format!("none: there is no such tiling, {}", describe(&rule)))?;
    } else if args.output.is_none() {
        match &tilings[..] {
            [tiling] => write(tiling, args.rule.tiles, None, &about)?,
            _ => output::result(|out| several(out, args, &about, &tilings))?,
        }
        output::remark(&about);
    }
    Ok(Exit::of(!tilings.is_empty()))
}

/// Several tilings in one text.
fn several(
    out: &mut dyn Write,
    args: &DappleSampleArgs,
    about: &str,
    tilings: &[crate::dappled::Field],
) -> std::io::Result<()> {
    for (number, tiling) in tilings.iter().enumerate() {
        let text = write_field(tiling, usize::from(args.rule.tiles));
        write!(out, "# {} of {}: {about}\n{text}", number + 1, tilings.len())?;
    }
    Ok(())
}
