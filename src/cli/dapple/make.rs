//! `dapple make`: a field, given or random, made into a dappled tiling.

use super::{rule, write};
use crate::cli::args::{DappleMakeArgs, OrderArg, StartArg};
use crate::cli::exit::Exit;
use crate::cli::{output, session, signal};
use crate::dappled::make::{How, Made, Options, Order, make, start};
use crate::dappled::{FREE, Field, faults};
use crate::store::check_writable;
use crate::torus::Shape;
use anyhow::{bail, ensure};
use serde_json::json;
use std::time::Instant;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &DappleMakeArgs) -> anyhow::Result<Exit> {
    let begin = Instant::now();
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    session::threads(args.threads)?;
    let deadline = args.time_limit.and_then(|time| begin.checked_add(time));
    let stop = (signal::listen()?, deadline);
    let (given, tiles) = (given(args)?, usize::from(args.rule.tiles));
    let rule = rule::rule(&args.rule, (given.width(), given.height()))?;
    let clock = Instant::now();
    let mut field = given;
    match args.start {
        StartArg::Random => start::fill_randomly(&mut field, tiles, args.seed),
        StartArg::Empty => start::fill_with_nothing(&mut field),
    }
    let start_seconds = clock.elapsed().as_secs_f64();
    let before = field.clone();
    let order = match args.order {
        OrderArg::Diagonal => Order::Diagonal,
        OrderArg::Wavefront => Order::Wavefront,
    };
    let clock = Instant::now();
    let made = make(&rule, field, Options { order, seed: args.seed }, &stop)?;
    let seconds = clock.elapsed().as_secs_f64();
    let (tiling, how) = match made {
        Made::Tiling(tiling, how) => (tiling, how),
        Made::Impossible => {
            return none(args, "none", "no tiling of this size keeps these limits", Exit::No);
        }
        Made::Stopped => return none(args, "stopped", "stopped before it was done", Exit::Stopped),
    };
    ensure!(
        tiling.is_complete() && faults::is_faultless(&rule, &tiling),
        "internal error: a tiling that is not dappled; please report"
    );
    let cells = tiling.cells().len();
    let changed = tiling.cells().iter().zip(before.cells()).filter(|(a, b)| a != b).count();
    let how = name(how, tiles);
    let limits = args.rule.limits.join(" ");
    let about = format!("dappled, limits {limits}, seed {}, by {how}", args.seed);
    if !args.json || args.output.is_some() {
        write::write(&tiling, args.rule.tiles, args.output.as_deref(), &about)?;
    }
    let rate = cells as f64 / seconds.max(1e-9);
    if args.json {
        let mut fields = vec![
            ("result", json!("found")),
            ("method", json!(how)),
            ("width", json!(tiling.width())),
            ("height", json!(tiling.height())),
            ("tiles", json!(tiles)),
            ("changed", json!(changed)),
            ("seed", json!(args.seed)),
            ("start_seconds", json!(start_seconds)),
            ("seconds", json!(seconds)),
            ("cells_per_second", json!(rate)),
            ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ];
        if args.output.is_none() {
            fields.push(("rows", write::rows_json(&tiling)));
        }
        output::object(&fields)?;
    } else if !args.quiet {
        let rate = match cells < 1_000_000 {
            true => String::new(),
            false => format!("{:.0} million cells a second; ", rate / 1e6),
        };
        output::remark(&format!(
            "{}x{} cells, {changed} changed, by {how}; all limits checked; {rate}{start_seconds:.3} s \
             for the start, {seconds:.3} s from there",
            tiling.width(),
            tiling.height()
        ));
    }
    Ok(Exit::Yes)
}

/// The field to begin with, some cells of it free.
fn given(args: &DappleMakeArgs) -> anyhow::Result<Field> {
    let size = args.size.as_deref().map(str::parse::<Shape>).transpose()?;
    let size = size.map(|size| (size.width(), size.height()));
    let Some(file) = &args.from else {
        let Some((width, height)) = size else {
            bail!("which field? Expected --size WxH or --from FILE");
        };
        return Ok(Field::filled(width, height, FREE)?);
    };
    let field = rule::field(file, args.rule.tiles)?;
    let found = (field.width(), field.height());
    if let Some(size) = size.filter(|&size| size != found) {
        let file = file.display();
        bail!("{file}: {}x{} cells, but --size {}x{}", found.0, found.1, size.0, size.1);
    }
    Ok(field)
}

/// How a tiling came about, in words.
fn name(how: How, tiles: usize) -> &'static str {
    match how {
        How::Unchanged => "nothing: it was dappled",
        How::Pair if tiles == 2 => "algorithm 1",
        How::Pair => "algorithm 1 on two classes",
        How::Greedy => "algorithm 1 for many tiles",
        How::Cyclic => "algorithm 2",
        How::Repaired => "algorithm 1, the rest exactly",
        How::Words => "two dappled words",
    }
}

/// Says that there is no tiling.
fn none(args: &DappleMakeArgs, result: &str, reason: &str, exit: Exit) -> anyhow::Result<Exit> {
    match args.json {
        true => output::object(&[("result", json!(result)), ("reason", json!(reason))])?,
        false => output::line(&format!("{result}: {reason}"))?,
    }
    Ok(exit)
}
