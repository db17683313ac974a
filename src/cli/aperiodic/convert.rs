//! `aperiodic convert`: corner tiles of Wang tiles and back, and what that proves.

use super::source;
use super::tables::{Verdict, verdict};
use crate::aperiodic::Set;
use crate::aperiodic::convert::{Converted, Method, convert};
use crate::cli::args::ConvertArgs;
use crate::cli::exit::Exit;
use crate::cli::output;
use crate::store::{check_writable, write_file};
use anyhow::ensure;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ConvertArgs) -> anyhow::Result<Exit> {
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    ensure!(
        args.method != Method::ToWang || args.repeat == 1,
        "--repeat {} goes with a method that gives corner tiles",
        args.repeat
    );
    let set = source::set(&args.file)?;
    let sound = verdict(&set, args.method);
    let mut steps: Vec<(Method, Converted)> = Vec::new();
    for round in 0..args.repeat {
        if round > 0 {
            let wang = convert(&steps[steps.len() - 1].1.set, Method::ToWang)?;
            steps.push((Method::ToWang, wang));
        }
        let from = steps.last().map_or(&set, |(_, converted)| &converted.set);
        let converted = convert(from, args.method)?;
        steps.push((args.method, converted));
    }
    let last = &steps[steps.len() - 1].1.set;
    if let Some(file) = &args.output {
        write_file(file, |out| write_set(out, last))?;
    }
    if args.json {
        let list: Vec<Value> = steps
            .iter()
            .map(|(method, step)| {
                json!({
                    "method": method.name(), "tiles": step.set.tiles().len(),
                    "colors": step.colors, "injective": step.is_injective(),
                })
            })
            .collect();
        let mut fields = vec![
            ("result", json!("converted")),
            ("method", json!(args.method.name())),
            ("steps", json!(list)),
            ("mixed", json!(sound.mixed)),
            ("sound", json!(sound.sound)),
            ("status", json!(sound.words())),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ];
        if args.output.is_none() && last.tiles().len() <= 1000 {
            fields.push(("kind", json!(last.kind().name())));
            fields.push(("tiles", json!(last.tiles())));
        }
        output::object(&fields)?;
    } else {
        output::result(|out| write_steps(out, &steps, &sound))?;
    }
    Ok(Exit::Yes)
}

fn write_steps(
    out: &mut dyn Write,
    steps: &[(Method, Converted)],
    sound: &Verdict,
) -> io::Result<()> {
    for (method, step) in steps {
        let (tiles, colors) = (step.set.tiles().len(), step.colors);
        let fails = match step.pairs {
            Some(pairs) if pairs != tiles => format!(", of {pairs} pairs: not injective"),
            _ => String::new(),
        };
        writeln!(out, "{method:<12}{tiles:>9} tiles over {colors} colors{fails}")?;
    }
    writeln!(out, "{}", sound.words())
}

/// A tile set file, whose labels may be too large for other commands than those about aperiodic
/// sets.
pub(super) fn write_set(out: &mut dyn Write, set: &Set) -> io::Result<()> {
    writeln!(out, "{{\n  \"kind\": \"{}\",\n  \"tiles\": [", set.kind())?;
    for (at, [a, b, c, d]) in set.tiles().iter().enumerate() {
        let comma = if at + 1 < set.tiles().len() { "," } else { "" };
        writeln!(out, "    [{a}, {b}, {c}, {d}]{comma}")?;
    }
    writeln!(out, "  ]\n}}")
}
