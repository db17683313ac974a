//! `aperiodic color`: small aperiodic sets of corner tiles, by coloring vertices.
//!
//! For `jeandel-rao` the windows are exact, and the answer comes with a certificate that is read
//! back and checked before it is written. For a set from a file they are those of a legal patch:
//! then only the way back to the Wang tiles is checked, and it is said that the corner tiles are
//! not known to fill the plane.

use super::super::args::{ColorArgs, ConditionArg};
use super::super::exit::Exit;
use super::super::session::Clock;
use super::super::{describe, duration, output, source};
use super::certificate;
use crate::aperiodic::coloring::certificate::{certificate as certify, renumbered};
use crate::aperiodic::coloring::condition::{Colored, Condition, MOST_TILES};
use crate::aperiodic::coloring::language::{Window, patterns, patterns_of_patch, windows};
use crate::aperiodic::coloring::partition::{JEANDEL_RAO, Partition};
use crate::aperiodic::coloring::rounds::{self, Outcome, Search};
use crate::aperiodic::coloring::vertices::Vertices;
use crate::aperiodic::decide::wang;
use crate::aperiodic::{Set, patch};
use crate::search::Stop;
use crate::store::{
    Input, check_writable, read_certificate, read_tile_set, write_certificate, write_file,
    write_tile_set,
};
use crate::tiles::{Colors, Kind, Members, TileSet};
use crate::verify::{WayBack, check_certificate, check_corner_tiles};
use anyhow::{Context, anyhow, bail};
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

/// The name of the set whose windows are known exactly.
const JEANDEL_RAO_NAME: &str = "jeandel-rao";
/// The longest side of a pattern around a vertex.
const LONGEST: usize = 12;
/// Most cells of a patch.
const MOST_CELLS: usize = 1 << 20;
/// Rounds when nothing ends them.
const ROUNDS: u64 = 100;
/// Time between two lines of progress.
const BETWEEN_LINES: Duration = Duration::from_secs(5);

/// The tilings whose vertices are colored.
struct Base {
    name: String,
    vertices: Vertices,
    /// With the points that give them, where they are exact.
    windows: Option<Vec<Window>>,
    /// How much is known of the windows.
    status: String,
}

/// Runs the command.
///
/// # Errors
/// Bad input, or files that cannot be written.
pub fn run(args: &ColorArgs) -> anyhow::Result<Exit> {
    let shape = sides("--window", &args.window, LONGEST)?;
    if shape.contains(&1) {
        bail!("--window {}: expected at least 2x2, for a vertex touches four tiles", args.window);
    }
    for file in [&args.output, &args.set_out].into_iter().flatten() {
        check_writable(file)?;
    }
    if args.moves == 0 {
        bail!("--moves 0: expected at least 1");
    }
    let clock = Clock::start(args.time_limit, args.threads)?;
    let stop = clock.stop();
    let Some(base) = base(args, shape, &stop)? else {
        if stop.should_stop() {
            let by = clock.stopped_by();
            output::remark("stopped early: no legal patch was found yet");
            return none(args, &clock, "stopped", Some(by), Exit::Stopped);
        }
        let size = &args.patch;
        output::remark(&format!("{}: no legal {size} patch exists", args.base.display()));
        return none(args, &clock, "none", None, Exit::No);
    };
    if base.windows.is_none() && args.output.is_some() {
        bail!(
            "-o: a certificate needs the exact windows, which are known for {JEANDEL_RAO_NAME} \
             only; --set-out writes the corner tiles"
        );
    }
    let condition = match args.condition {
        ConditionArg::Pair => Condition::Pair,
        ConditionArg::Radius1 => Condition::Radius(1),
        ConditionArg::Radius2 => Condition::Radius(2),
    };
    let search = Search {
        condition,
        colors: usize::from(args.colors),
        seed: args.seed,
        moves: args.moves,
        rounds: args.rounds.unwrap_or(if args.time_limit.is_some() { u64::MAX } else { ROUNDS }),
        target: args.target,
        threads: clock.threads,
    };
    let told = Mutex::new((Duration::ZERO, usize::MAX));
    let watch = |outcome: &Outcome| {
        let Ok(mut told) = told.lock() else { return };
        let best = outcome.best.as_ref().map_or(usize::MAX, |(_, found)| found.tiles);
        if !args.quiet && (best < told.1 || clock.elapsed() > told.0 + BETWEEN_LINES) {
            *told = (clock.elapsed(), best);
            output::remark(&progress(outcome, clock.elapsed()));
        }
    };
    let outcome = rounds::run(&base.vertices, &search, &stop, &watch);
    let stopped = stop.should_stop().then(|| clock.stopped_by());
    report(args, &base, &search, &outcome, &clock, stopped)
}

/// `RxC` or `WxH`.
fn sides(option: &str, text: &str, longest: usize) -> anyhow::Result<[usize; 2]> {
    let parse = |side: &str| side.parse().ok().filter(|side| (1..=longest).contains(side));
    let both = text.split_once('x').and_then(|(a, b)| Some([parse(a)?, parse(b)?]));
    both.ok_or_else(|| {
        anyhow!("{option} '{text}': expected two numbers from 1 to {longest}, as in 4x2")
    })
}

/// The tilings to color; `None` when no patch was found.
fn base(args: &ColorArgs, shape: [usize; 2], stop: &dyn Stop) -> anyhow::Result<Option<Base>> {
    let [rows, columns] = shape.map(|side| side + 1);
    if args.base == Path::new(JEANDEL_RAO_NAME) {
        let windows = windows(&Partition::jeandel_rao(), [rows, columns])?;
        let vertices = Vertices::new(JEANDEL_RAO.to_vec(), shape, &patterns(&windows))?;
        let status = "exact windows: almost every tiling that the torus codes".to_owned();
        let name = JEANDEL_RAO_NAME.to_owned();
        return Ok(Some(Base { name, vertices, windows: Some(windows), status }));
    }
    let input = source::open(&args.base)
        .with_context(|| format!("BASE is {JEANDEL_RAO_NAME} or a tile set file"))?;
    let read = read_tile_set(&input, None)?;
    let set = Set::of(&read.set)?;
    let file = args.base.display();
    if set.kind() != Kind::Wang {
        bail!("{file}: expected Wang tiles, not {} tiles", set.kind());
    }
    if set.tiles().len() > MOST_TILES {
        bail!("{file}: {} Wang tiles, more than {MOST_TILES}", set.tiles().len());
    }
    let [width, height] = sides("--patch", &args.patch, 10_000)?;
    if width * height > MOST_CELLS || height < rows || width < columns {
        let size = &args.patch;
        bail!("--patch {size}: expected at least {columns}x{rows} and at most {MOST_CELLS} cells");
    }
    let Ok(found) = patch::fill(&wang(&set), width, height, args.seed, stop) else {
        return Ok(None);
    };
    let found: Vec<Vec<usize>> = found.cells.chunks(width).map(<[usize]>::to_vec).collect();
    let seen = patterns_of_patch(&found, [rows, columns]);
    let vertices = Vertices::new(set.tiles().to_vec(), shape, &seen)?;
    let status = format!("windows from a patch of {width} x {height}: existence is not proved");
    let name = read.name.unwrap_or_else(|| file.to_string());
    Ok(Some(Base { name, vertices, windows: None, status }))
}

/// How far it is, in words.
fn progress(outcome: &Outcome, time: Duration) -> String {
    let best = match &outcome.best {
        Some((round, found)) => format!("best {} corner tiles, of round {round}", found.tiles),
        None => "no coloring meets the condition yet".to_owned(),
    };
    let rate = outcome.moves as f64 / time.as_secs_f64().max(1e-3) / 1e6;
    format!(
        "{}, {} moves, {rate:.1} million/s, {}: {best}",
        describe::number(outcome.rounds, "round"),
        outcome.moves,
        duration::words(time)
    )
}

/// The end without a set.
fn none(
    args: &ColorArgs,
    clock: &Clock,
    result: &str,
    by: Option<&str>,
    exit: Exit,
) -> anyhow::Result<Exit> {
    if args.json {
        output::object(&[
            ("result", json!(result)),
            ("stopped_by", json!(by)),
            ("seconds", json!(clock.elapsed().as_secs_f64())),
        ])?;
    }
    Ok(exit)
}

/// Checks, writes and tells what was found.
fn report(
    args: &ColorArgs,
    base: &Base,
    search: &Search,
    outcome: &Outcome,
    clock: &Clock,
    stopped: Option<&'static str>,
) -> anyhow::Result<Exit> {
    let effort = progress(outcome, clock.elapsed());
    let Some((round, found)) = &outcome.best else {
        output::remark(&effort);
        return match stopped {
            Some(by) => none(args, clock, "stopped", Some(by), Exit::Stopped),
            None => none(args, clock, "none", None, Exit::No),
        };
    };
    let colors = renumbered(&found.colors);
    let colored = Colored::new(&base.vertices, &colors);
    let used = colors.iter().max().map_or(0, |&most| u64::from(most) + 1);
    let title = format!(
        "{} corner tiles over {used} colors, from {} by windows of {}, condition {}, seed {}, \
         round {round}",
        found.tiles,
        base.name,
        args.window,
        search.condition.name(),
        search.seed
    );
    let way_back = check(base, &colored, &colors, &title, args.output.as_deref())?;
    if let Some(file) = &args.set_out {
        let palette = Colors::one(used)?;
        let ids = colored
            .tiles
            .iter()
            .map(|&[nw, ne, se, sw]| Kind::Corner.pack(&[ne, se, sw, nw], palette));
        let ids = ids.collect::<Result<Vec<_>, _>>()?;
        let set = TileSet::new(Kind::Corner, palette, Members::Explicit(ids))?;
        write_file(file, |out| write_tile_set(out, &set, Some(&title), Some(&base.status)))?;
    }
    let path = |file: &Option<std::path::PathBuf>| {
        file.as_deref().map(|file| file.to_string_lossy().into_owned())
    };
    if args.json {
        output::object(&[
            ("result", json!("found")),
            ("base", json!(base.name)),
            ("status", json!(base.status)),
            ("window", json!(args.window)),
            ("condition", json!(way_back.name())),
            ("tiles", json!(found.tiles)),
            ("colors", json!(used)),
            ("corner_tiles", json!(colored.tiles)),
            ("seed", json!(search.seed)),
            ("round", json!(round)),
            ("rounds", json!(outcome.rounds)),
            ("moves", json!(outcome.moves.to_string())),
            ("examined", json!(outcome.examined.to_string())),
            ("ends", ends(outcome)),
            ("stopped_by", json!(stopped)),
            ("seconds", json!(clock.elapsed().as_secs_f64())),
            ("file", json!(path(&args.output))),
            ("set_file", json!(path(&args.set_out))),
        ])?;
    } else {
        output::result(|out| {
            writeln!(out, "{} corner tiles over {used} colors, by {way_back}", found.tiles)?;
            let tile = |tile: &[u8; 4]| tile.map(|color| color.to_string()).concat();
            let tiles: Vec<String> = colored.tiles.iter().map(tile).collect();
            tiles.chunks(12).try_for_each(|line| writeln!(out, "  {}", line.join(" ")))?;
            match &base.windows {
                Some(_) => writeln!(out, "given that {}", certificate::ASSUMED),
                None => writeln!(out, "aperiodic if {} is; {}", base.name, base.status),
            }
        })?;
    }
    if !args.quiet {
        let written: Vec<String> = [&args.output, &args.set_out]
            .into_iter()
            .flatten()
            .map(|file| format!("; written to {}", file.display()))
            .collect();
        output::remark(&format!("{effort}{}", written.concat()));
    }
    Ok(Exit::Yes)
}

/// For each number of tiles the rounds that ended with it.
fn ends(outcome: &Outcome) -> Value {
    let ends = outcome.ends.iter().map(|(tiles, rounds)| json!([tiles, rounds]));
    ends.collect()
}

/// Has what was found checked by the verifier, from the text of the certificate where there is
/// one, and writes that.
fn check(
    base: &Base,
    colored: &Colored,
    colors: &[u8],
    title: &str,
    output: Option<&Path>,
) -> anyhow::Result<WayBack> {
    let refused =
        |fault| anyhow!("internal error: what was found is refused: {fault}; please report this");
    let Some(windows) = &base.windows else {
        let tiles: Vec<[u32; 4]> = colored.tiles.iter().map(|tile| tile.map(u32::from)).collect();
        return check_corner_tiles(&base.vertices.wang, &tiles, &colored.image).map_err(refused);
    };
    let certificate = certify(title.to_owned(), &base.vertices, windows, colors);
    let mut text = Vec::new();
    write_certificate(&mut text, &certificate)?;
    let read = read_certificate(&Input::from_bytes("certificate", text.clone())?)?;
    let proved = check_certificate(&read).map_err(refused)?;
    if let Some(file) = output {
        write_file(file, |out| out.write_all(&text))?;
    }
    Ok(proved.way_back)
}
