//! `aperiodic classify`: all sets of a size, each decided.

use super::merge;
use crate::aperiodic::classify::{
    Classified, Sets, Tally, UpTo, classify, exhaust, two_colors, wang,
};
use crate::aperiodic::decide::Bounds;
use crate::cli::args::{ClassifyArgs, UpToArg};
use crate::cli::exit::Exit;
use crate::cli::{output, session, signal};
use crate::search::Stop;
use crate::store::{check_writable, write_file};
use crate::tiles::Kind;
use anyhow::{Context, bail, ensure};
use serde_json::{Value, json};
use std::io::Write;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Time between two lines of progress.
const BETWEEN: Duration = Duration::from_secs(5);
/// Parts at most.
const MOST_PARTS: usize = 1_000_000;
/// Undecided sets that are listed.
const LISTED: usize = 1000;

/// What a run came to, as fields and in words.
pub(super) struct Answer {
    pub(super) exit: Exit,
    pub(super) fields: Vec<(&'static str, Value)>,
    pub(super) words: String,
}

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &ClassifyArgs) -> anyhow::Result<Exit> {
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let answer = if args.merge.is_empty() { decided(args)? } else { merge::merge(&args.merge)? };
    let object = output::object_text(&answer.fields);
    if let Some(file) = &args.output {
        write_file(file, |out| writeln!(out, "{object}"))?;
    }
    match args.json {
        true => output::line(&object)?,
        false => output::line(&answer.words)?,
    }
    Ok(answer.exit)
}

fn decided(args: &ClassifyArgs) -> anyhow::Result<Answer> {
    let begin = Instant::now();
    session::threads(args.threads)?;
    let deadline = args.time_limit.and_then(|time| begin.checked_add(time));
    let stop = (signal::listen()?, deadline);
    let last = Mutex::new(begin);
    let progress = |done: u64, total: u64| {
        let Ok(mut last) = last.lock() else { return };
        if !args.quiet && last.elapsed() >= BETWEEN {
            *last = Instant::now();
            let seconds = begin.elapsed().as_secs();
            output::remark(&format!("{done} of {total} parts of the work done, {seconds} s"));
        }
    };
    let bounds = Bounds { limit: args.limit.into(), ..Bounds::default() };
    let kind = args.kind.context("--kind wang|corner is missing")?;
    let mut answer = match (kind, args.colors, args.tiles) {
        (Kind::Wang, None, Some(tiles)) => of_wang(args, tiles, &bounds, &stop, &progress)?,
        (Kind::Wang, ..) => bail!("--kind wang: expected --tiles N and no --colors"),
        _ if args.part.is_some() => bail!("--part is for --kind wang"),
        (_, Some(2), None) => of_two_colors(),
        (_, Some(colors), Some(tiles)) => of_corner(colors, tiles, &bounds, &stop, &progress),
        _ => bail!("--kind corner: expected --colors 2, or --colors C and --tiles N"),
    };
    answer.fields.push(("seconds", json!(begin.elapsed().as_secs_f64())));
    Ok(answer)
}

/// The fields that every answer has.
pub(super) fn sums(tally: Tally) -> Vec<(&'static str, Value)> {
    let Tally { sets, periodic, no_tiling, undecided } = tally;
    let sums = [sets, periodic, no_tiling, undecided].map(|count| json!(count.to_string()));
    ["sets", "periodic", "no_tiling", "undecided"].into_iter().zip(sums).collect()
}

/// The sums in words.
pub(super) fn words(tally: Tally) -> String {
    let Tally { sets, periodic, no_tiling, undecided } = tally;
    format!("{sets} sets: {periodic} periodic, {no_tiling} without a tiling, {undecided} undecided")
}

fn ended(complete: bool) -> (&'static str, Exit) {
    if complete { ("complete", Exit::Yes) } else { ("stopped", Exit::Stopped) }
}

/// R/M, counted from 0.
fn part(text: &str) -> anyhow::Result<(usize, usize)> {
    let numbers = text.split_once('/').and_then(|(r, m)| Some((r.parse().ok()?, m.parse().ok()?)));
    match numbers {
        Some((part, parts)) if part < parts && parts <= MOST_PARTS => Ok((part, parts)),
        _ => bail!("--part {text}: expected R/M with R from 0 to M - 1, M at most {MOST_PARTS}"),
    }
}

fn of_wang(
    args: &ClassifyArgs,
    tiles: u8,
    bounds: &Bounds,
    stop: &dyn Stop,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> anyhow::Result<Answer> {
    let most = wang::MOST_TILES;
    ensure!(usize::from(tiles) <= most, "--tiles {tiles}: Wang sets of at most {most} tiles");
    let (part, parts) = args.part.as_deref().map_or(Ok((0, 1)), part)?;
    let (up_to, name) = match args.up_to {
        UpToArg::Graphs => (UpTo::Graphs, "graphs"),
        UpToArg::Transposition => (UpTo::Transposition, "transposition"),
        UpToArg::Square => (UpTo::Square, "square"),
    };
    let sets = Sets::new(tiles.into(), up_to);
    let Classified { tally, undecided, complete } =
        classify(&sets, (part, parts), bounds, stop, progress);
    let (result, exit) = ended(complete);
    let mut fields = vec![("result", json!(result)), ("kind", json!("wang"))];
    fields.extend([("tiles", json!(tiles)), ("up_to", json!(name)), ("limit", json!(args.limit))]);
    fields.extend([("part", json!(part)), ("parts", json!(parts))]);
    fields.extend(sums(tally));
    fields.push(("undecided_sets", json!(undecided.iter().take(LISTED).collect::<Vec<_>>())));
    let of = if parts > 1 { format!(" in part {part} of {parts}") } else { String::new() };
    let stopped = if complete { "" } else { "; stopped" };
    Ok(Answer { exit, fields, words: format!("{}{of}{stopped}", words(tally)) })
}

fn of_two_colors() -> Answer {
    let two_colors::TwoColors { tally, generators } = two_colors::classify();
    let mut fields = vec![("result", json!("complete")), ("kind", json!("corner"))];
    fields.push(("colors", json!(2)));
    fields.extend(sums(tally));
    let listed = generators.iter().map(|generator| {
        let tiles = two_colors::corner_tiles(generator.mask);
        json!({"tiles": tiles, "torus": generator.torus, "cells": generator.cells})
    });
    fields.push(("generators", Value::Array(listed.collect())));
    let largest = generators.iter().map(|generator| generator.cells).max().unwrap_or(0);
    let count = generators.len();
    let words = format!(
        "{}\n{count} smallest periodic sets, with periods of at most {largest} cells",
        words(tally)
    );
    Answer { exit: Exit::Yes, fields, words }
}

fn of_corner(
    colors: u8,
    tiles: u8,
    bounds: &Bounds,
    stop: &dyn Stop,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Answer {
    let all = exhaust::exhaust(
        exhaust::Question::new(colors.into(), tiles.into()),
        bounds,
        stop,
        progress,
    );
    let (result, exit) = ended(all.complete);
    let none = all.complete && all.undecided.is_empty();
    let mut fields = vec![("result", json!(result)), ("kind", json!("corner"))];
    fields.extend([("colors", json!(colors)), ("tiles", json!(tiles))]);
    fields.extend(sums(all.tally));
    fields.push(("undecided_sets", json!(all.undecided.iter().take(LISTED).collect::<Vec<_>>())));
    fields.push(("nodes", json!(all.nodes.to_string())));
    fields.push(("no_aperiodic", json!(none)));
    let first = match (none, all.complete) {
        (true, _) => format!(
            "no set of at most {tiles} corner tiles over {colors} colors is aperiodic: each \
             fills the plane with two periods, or not at all"
        ),
        (false, true) => "not all sets could be decided".to_owned(),
        (false, false) => "stopped".to_owned(),
    };
    let words = format!("{first}\n{} nodes; decided: {}", all.nodes, words(all.tally));
    Answer { exit, fields, words }
}
