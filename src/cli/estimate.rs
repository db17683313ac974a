//! `estimate`: how many packings there are, how large the search tree is, and how long an exact
//! count would take, by random probes.
//!
//! Numbers are rounded to what the interval tells in words for people, and to 17 digits in
//! JSON. But for the seconds and what follows from them, the same seed prints the same bytes.

use super::args::EstimateArgs;
use super::exit::Exit;
use super::session::{Clock, spoken};
use super::{describe, duration, output, problem};
use crate::packing::Task;
use crate::packing::estimate::{Estimated, estimate};
use crate::search::estimate::{Estimate, Interval, Settings};
use serde_json::{Value, json};
use std::time::Duration;

/// Seconds of a year.
const YEAR: f64 = 365.25 * 86400.0;

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &EstimateArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, args.order)?;
    let clock = Clock::start(args.time_limit, args.threads)?;
    let reason = task.impossible();
    let estimated = match &reason {
        Some(_) => nothing(),
        None => {
            let stop = clock.stop();
            let settings = Settings {
                threads: clock.threads,
                effort: args.node_limit,
                seed: args.seed,
                stop: &stop,
                watch: &|_| {},
            };
            estimate(&task, &settings, !args.plain)?
        }
    };
    let done = Done {
        stopped_by: (!estimated.tree.complete).then(|| clock.stopped_by()),
        estimated,
        time: clock.elapsed(),
    };
    if args.json {
        print_json(args, &done, reason.as_deref())?;
    } else {
        print(args, &task, &done, reason.as_deref())?;
    }
    if let Some(by) = done.stopped_by {
        output::remark(&format!(
            "stopped early by {}: {} nodes in {}; the intervals are those of the replicates finished",
            spoken(by),
            done.estimated.tree.probed,
            duration::words(done.time)
        ));
    }
    let tree = &done.estimated.tree;
    let none = tree.exact && tree.solutions.is_some_and(|solutions| solutions.mean == 0.0);
    Ok(match done.stopped_by {
        Some(_) => Exit::Stopped,
        None => Exit::of(!none),
    })
}

/// An estimate that has been made.
struct Done {
    estimated: Estimated,
    time: Duration,
    /// What ended it early.
    stopped_by: Option<&'static str>,
}

/// No packing and nothing to search.
fn nothing() -> Estimated {
    let none = Some(Interval::exact(0.0));
    let (nodes, solutions) = (none, none);
    let tree = Estimate { nodes, solutions, exact: true, complete: true, probed: 0, replicates: 0 };
    Estimated { tree, rate: None }
}

/// Core-years of the exact count, at the rate of the search.
fn core_years(estimated: &Estimated) -> Option<f64> {
    Some(estimated.tree.nodes?.mean / estimated.rate? / YEAR)
}

fn print(
    args: &EstimateArgs,
    task: &Task,
    done: &Done,
    reason: Option<&str>,
) -> anyhow::Result<()> {
    let Estimated { tree, rate } = &done.estimated;
    let (sought, conditions) = (describe::sought(task), describe::conditions(task));
    output::result(|out| {
        match tree.solutions {
            Some(number) => writeln!(out, "{} {sought}s{conditions}", words(number, tree.exact))?,
            None if tree.replicates > 0 => writeln!(
                out,
                "{sought}s{conditions}: no probe reached one, so there is no estimate"
            )?,
            None => writeln!(out, "{sought}s{conditions}: stopped too early for an estimate")?,
        }
        match tree.nodes {
            Some(number) => {
                writeln!(out, "{} nodes in the search tree of count", words(number, tree.exact))?;
            }
            None => writeln!(out, "search tree: stopped too early for an estimate")?,
        }
        writeln!(out, "{}", how(args, task, tree, reason))?;
        if let (Some(years), Some(rate)) = (core_years(&done.estimated), rate) {
            writeln!(
                out,
                "an exact count would take {} core-years, at {:.1} million nodes/s measured on \
                 the beginning of the search",
                rounded(years, 2),
                rate / 1e6
            )?;
        }
        Ok(())
    })
}

/// What was estimated and how.
fn how(args: &EstimateArgs, task: &Task, tree: &Estimate, reason: Option<&str>) -> String {
    let set = describe::set(&task.set);
    let torus = describe::board(task.set.kind(), task.shape, &task.board);
    let nodes = describe::number(tree.probed, "node");
    let how = match (reason, tree.exact) {
        (Some(reason), _) => format!("by an argument: {reason}"),
        (None, true) => format!("exact: the whole tree was searched, {nodes}"),
        (None, false) => format!(
            "random probes, {}, {nodes}, seed {}; intervals of 95 %",
            describe::number(tree.replicates as u64, "replicate"),
            args.seed
        ),
    };
    format!("{set}, {torus}; {how}")
}

fn print_json(args: &EstimateArgs, done: &Done, reason: Option<&str>) -> anyhow::Result<()> {
    let Estimated { tree, rate } = &done.estimated;
    let method = match (reason, tree.exact) {
        (Some(_), _) => "argument",
        (None, true) => "search",
        (None, false) => "probes",
    };
    let digits = |number: Option<Interval>, of: fn(Interval) -> f64, round: fn(f64) -> f64| {
        number.map_or(Value::Null, |number| json!(digits(round(of(number)))))
    };
    let low = |number| digits(number, |number| number.low, f64::floor);
    let mean = |number| digits(number, |number| number.mean, f64::round);
    let high = |number| digits(number, |number| number.high, f64::ceil);
    output::object(&[
        ("result", json!(if done.stopped_by.is_some() { "stopped" } else { "complete" })),
        ("nodes", mean(tree.nodes)),
        ("nodes_low", low(tree.nodes)),
        ("nodes_high", high(tree.nodes)),
        ("solutions", mean(tree.solutions)),
        ("solutions_low", low(tree.solutions)),
        ("solutions_high", high(tree.solutions)),
        ("exact", json!(tree.exact)),
        ("method", json!(method)),
        ("reason", json!(reason)),
        ("nodes_probed", json!(tree.probed.to_string())),
        ("replicates", json!(tree.replicates)),
        ("seed", json!(args.seed)),
        ("stopped_by", json!(done.stopped_by)),
        ("seconds", json!(done.time.as_secs_f64())),
        ("nodes_per_second", json!(rate)),
        ("core_years", json!(core_years(&done.estimated))),
    ])
}

/// A whole number as digits; `None` beyond the range of floating point.
fn digits(number: f64) -> Option<String> {
    number.is_finite().then(|| format!("{number:.0}"))
}

/// A number with its interval: `1.02e16 (0.95e16 to 1.09e16)`, `about` it when not exact.
fn words(number: Interval, exact: bool) -> String {
    if exact {
        return digits(number.mean.round()).unwrap_or_else(|| "too many".to_owned());
    }
    let ends = (rounded(number.low, 3), rounded(number.high, 3));
    format!("about {} ({} to {})", rounded(number.mean, 3), ends.0, ends.1)
}

/// So many digits that count: `203000`, `1.02e16`.
fn rounded(number: f64, digits: usize) -> String {
    let text = format!("{number:.*e}", digits - 1);
    match text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()) {
        Some(-3..0) => format!("{number:.4}"),
        Some(exponent @ 0..7) => {
            let after = (digits as i32 - 1 - exponent).max(0) as usize;
            let whole: f64 = text.parse().unwrap_or(number);
            format!("{whole:.after$}")
        }
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_what_is_known() {
        for (number, expected) in [
            (1.0234e16, "1.02e16"),
            (203_520.0, "204000"),
            (31.96, "32.0"),
            (0.03, "0.0300"),
            (2.5e-9, "2.50e-9"),
        ] {
            assert_eq!(rounded(number, 3), expected);
        }
        assert_eq!(digits(1e20), Some("100000000000000000000".to_owned()));
        assert_eq!(digits(f64::INFINITY), None);
    }
}
