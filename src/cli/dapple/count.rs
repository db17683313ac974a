//! `dapple count`: how many dappled tilings there are.

use super::job::{Job, edges_name};
use super::rule;
use super::saving::{Request, Saving};
use crate::cli::args::{DappleCountArgs, ResumeArgs};
use crate::cli::eta::{self, Eta};
use crate::cli::exit::Exit;
use crate::cli::session::{Clock, spoken};
use crate::cli::{duration, memory, output};
use crate::dappled::count::{CountError, Counting, MEMORY, Need};
use crate::dappled::{Direction, Limit, Rule};
use crate::search::Stop;
use crate::store::read_long;
use anyhow::{Context, bail, ensure};
use num_bigint::BigUint;
use serde_json::json;
use std::path::Path;
use std::time::Duration;

/// Time between two remarks on how far it is.
const BETWEEN: Duration = Duration::from_secs(5);

/// How to count.
struct Run<'a> {
    clock: Clock,
    request: Request,
    checkpoint: Option<&'a Path>,
    every: Duration,
    quiet: bool,
}

/// Runs the command.
///
/// # Errors
/// Bad input, or more memory than there may be.
pub fn run(args: &DappleCountArgs) -> anyhow::Result<Exit> {
    let (rule, given) = rule::problem(&args.size, &args.rule, args.given.as_deref())?;
    if let Some(tile) = args.by_number {
        let tiles = rule.tiles();
        ensure!(usize::from(tile) < tiles, "--by-number {tile}: expected a tile below {tiles}");
    }
    let job = Job { rule, given, by: args.by_number };
    let run = Run {
        clock: Clock::start(args.time_limit, args.threads)?,
        request: Request { json: args.json, memory: args.memory, before: Duration::ZERO },
        checkpoint: args.checkpoint.as_deref(),
        every: args.checkpoint_every,
        quiet: args.quiet,
    };
    answer(&job, run)
}

/// Goes on with a count that was saved.
///
/// # Errors
/// A file that cannot be read, or options that mean nothing here.
pub fn resume(args: &ResumeArgs) -> anyhow::Result<Exit> {
    let file = args.file.display();
    ensure!(args.output.is_none(), "{file}: holds a count, which writes no file (--output)");
    ensure!(
        args.run.node_limit.is_none(),
        "{file}: a count of tilings has no nodes (--node-limit)"
    );
    ensure!(args.run.status.is_none(), "{file}: a count of tilings writes no --status");
    let opened = read_long(&args.file)?;
    let job = Job::read(&opened.job).with_context(|| file.to_string())?;
    let mut request = Request::read(&opened.request);
    request.json |= args.json;
    request.memory = request.memory.max(MEMORY);
    let run = Run {
        clock: Clock::start(args.run.time_limit, args.run.threads)?,
        request,
        checkpoint: Some(&args.file),
        every: args.run.checkpoint_every,
        quiet: args.run.quiet,
    };
    answer(&job, run)
}

fn answer(job: &Job, mut run: Run<'_>) -> anyhow::Result<Exit> {
    let limit = run.request.memory;
    if let Some(need) = Need::of(&job.rule, job.given.as_ref(), job.by)
        && need.bytes > limit as f64
    {
        bail!(
            "{}: counting needs about {} of memory ({} states), --memory allows {}",
            describe(&job.rule),
            memory::words(need.bytes),
            rounded(need.states),
            memory::words(limit as f64)
        );
    }
    let explain = |error: CountError| match error {
        CountError::Memory { .. } => anyhow::anyhow!("{}: {error} (--memory)", describe(&job.rule)),
        _ => anyhow::anyhow!("{}: {error}", describe(&job.rule)),
    };
    let mut counting =
        Counting::new(&job.rule, job.given.as_ref(), job.by, limit).map_err(explain)?;
    let mut saving = None;
    if let Some(file) = run.checkpoint {
        let (opened, before) = Saving::open(file, job, &mut counting, run.every, run.quiet)?;
        run.request.before = before;
        saving = Some(opened);
    }
    let was_done = counting.is_done();
    let stop = run.clock.stop();
    let (mut most, mut stopped, mut told, mut left) =
        (counting.states(), false, Duration::ZERO, Eta::new());
    while !counting.is_done() {
        if stop.should_stop() {
            stopped = true;
            break;
        }
        counting.step().map_err(explain)?;
        most = most.max(counting.states());
        let time = run.clock.elapsed();
        if let Some(saving) = saving.as_mut().filter(|saving| saving.is_due(&counting))
            && let Err(error) = saving.save(&counting, run.request, time)
        {
            let meaning = "going on; the next attempt comes with the next checkpoint";
            output::remark(&format!("warning: no checkpoint: {error}; {meaning}"));
        }
        let (done, all) = counting.progress();
        left.add(time, done as f64 / all as f64);
        if !run.quiet && time >= told + BETWEEN {
            told = time;
            let left = left.left().map_or(String::new(), |left| format!(", {}", eta::words(left)));
            let (states, time) = (counting.states(), duration::words(time));
            output::remark(&format!("{done} steps of {all}, {states} states, {time}{left}"));
        }
    }
    let saved = match &mut saving {
        Some(saving) if !was_done => saving.save(&counting, run.request, run.clock.elapsed()),
        _ => Ok(()),
    };
    let file = saving.as_ref().map(|saving| saving.file.display().to_string());
    if let Err(error) = &saved {
        output::remark(&format!("the last checkpoint was not saved: {error}"));
    }
    let time = run.request.before + run.clock.elapsed();
    let numbers = if stopped { Vec::new() } else { counting.numbers() };
    if run.request.json {
        let by = job.by.filter(|_| !stopped).map(|tile| {
            let some = of_some(&numbers).map(|(count, number)| json!([count, number.to_string()]));
            json!({"tile": tile, "numbers": some.collect::<Vec<_>>()})
        });
        let total = (!stopped).then(|| numbers.iter().sum::<BigUint>().to_string());
        output::object(&[
            ("result", json!(if stopped { "stopped" } else { "counted" })),
            ("tilings", json!(total)),
            ("by_number", json!(by)),
            ("width", json!(job.rule.width())),
            ("height", json!(job.rule.height())),
            ("tiles", json!(job.rule.tiles())),
            ("edges", json!(edges_name(job.rule.edges()))),
            ("states", json!(most)),
            ("seconds", json!(time.as_secs_f64())),
            ("stopped_by", json!(stopped.then(|| run.clock.stopped_by()))),
            ("checkpoint", json!(file)),
        ])?;
    }
    if stopped {
        let (done, all) = counting.progress();
        let saved = match (&file, &saved) {
            (Some(file), Ok(())) => format!("; saved: tilepack resume {file}"),
            _ => String::new(),
        };
        let (by, time) = (spoken(run.clock.stopped_by()), duration::words(time));
        output::remark(&format!(
            "stopped early by {by}: {done} steps of {all} in {time}; no number yet{saved}"
        ));
        return Ok(if saved.is_empty() && file.is_some() { Exit::Bad } else { Exit::Stopped });
    }
    let total: BigUint = numbers.iter().sum();
    if !run.request.json {
        let about = describe(&job.rule);
        let given = job.given.as_ref().map_or("", |_| " that agree with the cells given");
        let time = duration::words(time);
        output::result(|out| {
            writeln!(out, "{total} dappled tilings{given}")?;
            if let Some(tile) = job.by {
                for (count, number) in of_some(&numbers) {
                    writeln!(out, "{number} with tile {tile} {count} times")?;
                }
            }
            writeln!(out, "{about}; counted exactly, {most} states, {time}")
        })?;
    }
    Ok(Exit::of(total != BigUint::ZERO))
}

/// A number of which only the size is known.
fn rounded(number: f64) -> String {
    if number < 1e6 { format!("{number:.0}") } else { format!("{:.0} million", number / 1e6) }
}

/// Counts of a tile that occur, and their numbers.
fn of_some(numbers: &[BigUint]) -> impl Iterator<Item = (usize, &BigUint)> {
    numbers.iter().enumerate().filter(|(_, number)| **number != BigUint::ZERO)
}

/// `8x8, 2 tiles, limits 2,2, free edges`.
pub(super) fn describe(rule: &Rule) -> String {
    let edges = match edges_name(rule.edges()) {
        "free" => "free edges",
        edges => edges,
    };
    let (width, height, tiles) = (rule.width(), rule.height(), rule.tiles());
    // Told when they are the same for every tile alone.
    let same = |direction: Direction| {
        let of = rule.conditions().iter().filter(|condition| condition.direction == direction);
        let of: Vec<_> = of.collect();
        match of.first() {
            None => Some("inf".to_owned()),
            Some(first) => match first.limit {
                Limit::Same(limit) => {
                    let all = (0..tiles).all(|tile| of.iter().any(|c| c.set == 1 << tile));
                    let alike = of.iter().all(|c| c.limit == first.limit) && of.len() == tiles;
                    (all && alike).then(|| limit.to_string())
                }
                _ => None,
            },
        }
    };
    let limits = match (same(Direction::Horizontal), same(Direction::Vertical)) {
        (Some(across), Some(down)) => format!("limits {across},{down}"),
        _ => "limits by tile".to_owned(),
    };
    format!("{width}x{height}, {tiles} tiles, {limits}, {edges}")
}
