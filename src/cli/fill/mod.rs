//! `fill`: tile images from examples.
//!
//! * `sources` reads the examples and says which tiles are wanted;
//! * `files` writes sheets and folders, all or none of them;
//! * `report` says how good the tiles are.
//!
//! A time limit ends the trying of further candidates; a signal ends all, and nothing is written.

mod files;
mod report;
mod sources;

use super::args::{FillArgs, FillMethod};
use super::exit::Exit;
use super::session::Clock;
use super::{describe, duration, output};
use crate::search::Stop;
use crate::store::{check_writable, write_file};
use crate::texture::{
    Made, Method, Order, Progress, Shape, TextureError, check_count, example, make,
};
use crate::tiles::Kind;
use crate::{atlas, torus};
use anyhow::{Context, bail, ensure};
use serde_json::json;
use std::io::Write;
use std::sync::Mutex;
use std::time::Duration;

/// Time between two lines about progress.
const BETWEEN_LINES: Duration = Duration::from_secs(5);

/// Only a signal, not the time limit.
struct Signal<'a>(&'a Clock);

impl Stop for Signal<'_> {
    fn should_stop(&self) -> bool {
        self.0.stopped_by() == "signal"
    }
}

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &FillArgs) -> anyhow::Result<Exit> {
    if let Some(name) = &args.example {
        return draw(args, name);
    }
    if let Some(file) = &args.report {
        check_writable(file)?;
    }
    let clock = Clock::start(args.time_limit, args.threads)?;
    let strip = args.strip.unwrap_or_else(|| 4.min(args.tile_size / 4));
    let shape = Shape::new(args.tile_size, strip)
        .with_context(|| format!("--tile-size {}, --strip {strip}", args.tile_size))?;
    let wanted = sources::wanted(args, shape)?;
    let outputs = files::outputs(args)?;
    let stock = sources::stock(args)?;
    let order = Order {
        kind: wanted.kind,
        colors: wanted.colors,
        shape,
        method: match (args.method, wanted.kind) {
            (Some(FillMethod::Cohen), _) | (None, Kind::Wang) => Method::Cohen,
            (Some(FillMethod::Schlomer), _) => Method::Schlomer,
            _ => Method::Ng,
        },
        seed: args.seed,
        candidates: args.candidates as usize,
        tries: args.tries as usize,
    };
    let told = Mutex::new(BETWEEN_LINES);
    let watch = |progress: Progress| {
        let Ok(mut due) = told.lock() else { return };
        if !args.quiet && clock.elapsed() > *due {
            *due = clock.elapsed() + BETWEEN_LINES;
            tell(progress, order, wanted.tiles.len(), clock.elapsed());
        }
    };
    let limits: (&dyn Stop, &dyn Stop) = (&clock.stop(), &Signal(&clock));
    let made = match make(&stock, &wanted.tiles, order, limits, &watch) {
        Err(TextureError::Stopped) => {
            let time = duration::words(clock.elapsed());
            output::remark(&format!("stopped early by a signal after {time}; nothing is written"));
            return Ok(Exit::Stopped);
        }
        made => made?,
    };
    let seconds = clock.elapsed();
    let report = match args.quiet && !args.json && args.report.is_none() {
        true => None,
        false => report::report(args, &stock, &made, &wanted),
    };
    let written = files::write(&outputs, &stock, &made, &wanted)?;
    finish(args, &made, &written, report, seconds)?;
    Ok(Exit::Yes)
}

/// Draws an example.
fn draw(args: &FillArgs, name: &str) -> anyhow::Result<Exit> {
    let given = [
        (!args.map.is_empty(), "--map"),
        (args.packing.is_some(), "--packing"),
        (args.set.kind.is_some(), "--kind"),
        (args.set.colors.is_some(), "--colors"),
        (args.report.is_some(), "--report"),
        (args.baselines, "--baselines"),
    ];
    if let Some((_, option)) = given.iter().find(|(given, _)| *given) {
        bail!("--example draws a picture and makes no tiles: {option} does not go with it");
    }
    let Some((subject, aspect)) = example::named(name) else {
        let names = example::Subject::ALL.map(example::Subject::name).join(", ");
        bail!("--example {name}: expected {names}, or one of them with -height or -normal");
    };
    let size: torus::Shape = args.size.parse().context("--size")?;
    let seed = u32::try_from(args.seed).ok();
    let seed =
        seed.with_context(|| format!("--seed {}: expected at most {}", args.seed, u32::MAX))?;
    let image = example::draw(subject, aspect, (size.width(), size.height()), seed)?;
    let mut bytes = Vec::new();
    let comment = format!("tilepack fill --example {name} --size {size} --seed {seed}");
    atlas::write_png(&mut bytes, &image, &[("Comment", &comment)])?;
    write_file(&args.output, |out| out.write_all(&bytes))?;
    if args.json {
        output::object(&[
            ("result", json!("drawn")),
            ("file", json!(args.output.to_string_lossy())),
            ("width", json!(size.width())),
            ("height", json!(size.height())),
            ("bytes", json!(bytes.len())),
        ])?;
    }
    Ok(Exit::Yes)
}

/// How far it is.
fn tell(progress: Progress, order: Order, tiles: usize, time: Duration) {
    let Progress { candidates, tiles: done } = progress;
    let all = order.candidates;
    let time = duration::words(time);
    output::remark(&format!(
        "{candidates} of {} tried, {done} of {} covered, {time}",
        describe::number(all as u64, "candidate"),
        describe::number(tiles as u64, "tile")
    ));
}

/// Says what was made, to people or programs.
fn finish(
    args: &FillArgs,
    made: &Made,
    written: &files::Written,
    report: Option<report::Report>,
    time: Duration,
) -> anyhow::Result<()> {
    let order = made.order;
    let name = |file: &std::path::PathBuf| json!(file.to_string_lossy());
    let mut fields = vec![
        ("result", json!("made")),
        ("kind", json!(order.kind.name())),
        ("colors", json!(order.colors.to_string())),
        ("method", json!(report::method(order.method))),
        ("tiles", json!(made.tiles.len())),
        ("tile_size", json!(order.shape.side)),
        ("strip", json!(order.shape.strip)),
        ("strip_differences", json!(0)),
        ("seed", json!(order.seed)),
        ("candidates", json!(made.candidates.len())),
        ("taken", json!(made.taken)),
        ("stopped_by", json!(made.cut_short.then_some("time-limit"))),
        ("seconds", json!((time.as_secs_f64() * 1e3).round() / 1e3)),
        ("files", json!(written.files.iter().map(name).collect::<Vec<_>>())),
        ("tile_list", json!(written.list.as_ref().map(name))),
        ("bytes", json!(written.bytes)),
    ];
    fields.extend(report.iter().flat_map(report::Report::fields));
    if let Some(file) = &args.report {
        let text = output::object_text(&fields);
        write_file(file, |out| writeln!(out, "{text}"))?;
    }
    if made.cut_short {
        let (tried, all) = (made.candidates.len(), order.candidates);
        output::remark(&format!(
            "the time limit ended the trying: {tried} of {} tried",
            describe::number(all as u64, "candidate")
        ));
    }
    if !args.quiet {
        output::remark(&format!(
            "{} {} tiles of {} texels over {} colors, strip {}, method {}, the best of {}, {}; \
             written to {}",
            made.tiles.len(),
            order.kind,
            order.shape.side,
            order.colors,
            order.shape.strip,
            report::method(order.method),
            describe::number(made.candidates.len() as u64, "candidate"),
            duration::words(time),
            args.output.display()
        ));
        for line in report.iter().flat_map(report::Report::lines) {
            output::remark(&line);
        }
    }
    if args.json { output::object(&fields) } else { Ok(()) }
}

/// Refuses sets that are too large before they are listed.
fn check_size(tiles: u64, shape: Shape) -> anyhow::Result<()> {
    Ok(check_count(tiles, shape)?)
}

/// What the sets of `fill` are: tiles that are squares in the plane.
fn check_kind(kind: Kind) -> anyhow::Result<()> {
    ensure!(kind != Kind::Domino, "fill makes corner and Wang tiles, not dominoes");
    Ok(())
}
