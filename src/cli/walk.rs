//! `walk`: from a packing to another one, by filling patches again.

use super::args::WalkArgs;
use super::exit::Exit;
use super::session::Clock;
use super::{describe, duration, output, set, source};
use crate::patch::{Drift, Walk, Walked};
use crate::search::Stop;
use crate::store::{Layout, check_writable, solutions, write_file, write_grid, write_solution};
use crate::torus::{Lattice, Packing, Shape};
use crate::verify;
use anyhow::{Context, bail};
use serde_json::{Value, json};

/// Runs the command.
///
/// # Errors
/// A file that cannot be read or holds no packing, patches that do not suit it, a file that cannot
/// be written.
pub fn run(args: &WalkArgs) -> anyhow::Result<Exit> {
    let claim = set::packing_claim(&args.claim)?;
    let input = source::open(&args.file)?;
    let file = input.file().display();
    let first =
        solutions(&input, &claim).next().with_context(|| format!("{file}: no packing"))??;
    let (line, start) = (first.line, first.packing);
    let verdict = verify::check(&start);
    if !verdict.is_valid() {
        bail!("{file}, line {line}: not a packing: {verdict}");
    }
    let patch: Shape = args.patch.parse().context("--patch")?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let lattice = Lattice { kind: start.set.kind(), shape: start.shape };
    let Ok(begin) = Lattice::labels_of(&start) else { bail!("{file}: neighbors do not fit") };
    let clock = Clock::start(args.time_limit, Some(1))?;
    let size = (patch.width(), patch.height());
    let walk = Walk::new(&start.set, lattice, begin.clone(), size, args.seed);
    let mut walk = walk.with_context(|| format!("--patch {patch}"))?;
    let stop = clock.stop();
    walk.run(args.steps, &stop);
    let stopped = walk.walked().steps < args.steps && stop.should_stop();
    let end = lattice.packing(walk.labels(), &start.set, start.cover);
    let verdict = verify::check(&end);
    if !verdict.is_valid() {
        bail!("internal error: the walk left the packings: {verdict}; please report this");
    }
    let colors = start.set.colors();
    let drifts = [&begin[..], walk.labels()].map(|labels| Drift::of(lattice, colors, labels));
    let changed = start.tiles.iter().zip(&end.tiles).filter(|(a, b)| a != b).count();
    let done = Done { args, patch, walked: walk.walked(), changed, drifts, end, clock, stopped };
    done.give()
}

/// A walk that has ended.
struct Done<'a> {
    args: &'a WalkArgs,
    patch: Shape,
    walked: Walked,
    /// Cells with another tile than at the start.
    changed: usize,
    /// At the start and at the end.
    drifts: [Drift; 2],
    end: Packing,
    clock: Clock,
    stopped: bool,
}

impl Done<'_> {
    fn give(&self) -> anyhow::Result<Exit> {
        let Self { args, patch, walked, end, .. } = self;
        let how =
            format!("walk by patches of {patch} ({} steps, seed {})", walked.steps, args.seed);
        let Walked { steps, moves, .. } = walked;
        if let Some(file) = &args.output {
            let provenance = json!({
                "method": how,
                "program": "tilepack",
                "version": env!("CARGO_PKG_VERSION"),
                "from": args.file.to_string_lossy(),
                "seed": args.seed,
                "steps": steps.to_string(),
                "moves": moves.to_string(),
            });
            write_file(file, |out| write_solution(out, end, &provenance, Layout::Pretty))?;
        }
        match (args.json, &args.output) {
            (true, _) => output::object(&self.fields())?,
            (false, Some(_)) => {}
            (false, None) => output::result(|out| {
                writeln!(out, "# {how}")?;
                write_grid(out, end)
            })?,
        }
        if !args.quiet {
            self.tell();
        }
        if self.stopped {
            let by = super::session::spoken(self.clock.stopped_by());
            output::remark(&format!("stopped early by {by} after {steps} of {} steps", args.steps));
            return Ok(Exit::Stopped);
        }
        Ok(Exit::Yes)
    }

    /// What happened, on standard error.
    fn tell(&self) {
        let Walked { steps, moves, skipped, .. } = self.walked;
        let share = 100.0 * moves as f64 / steps.max(1) as f64;
        let (cells, time) = (self.end.shape.cells(), duration::words(self.clock.elapsed()));
        let skipped = match skipped {
            0 => String::new(),
            _ => format!(", {skipped} too long to fill"),
        };
        let patches = describe::number(steps, "patch").replace("patchs", "patches");
        output::remark(&format!(
            "{patches} in {time}: {moves} had another filling ({share:.1} %){skipped}; \
             {} of {cells} cells have another tile",
            self.changed
        ));
        let words = |drift: Option<f64>| drift.map_or("none".into(), |drift| format!("{drift:.2}"));
        let [before, after] = &self.drifts;
        output::remark(&format!(
            "drift of colors (1: as at random) among rows {} before, {} after; among columns {} \
             before, {} after",
            words(before.rows),
            words(after.rows),
            words(before.columns),
            words(after.columns)
        ));
    }

    fn fields(&self) -> Vec<(&'static str, Value)> {
        let Walked { steps, moves, skipped, fillings, nodes } = self.walked;
        let [before, after] = &self.drifts;
        let file = self.args.output.as_deref().map(|file| file.to_string_lossy());
        let mut fields = vec![
            ("result", json!(if self.stopped { "stopped" } else { "walked" })),
            ("stopped_by", json!(self.stopped.then(|| self.clock.stopped_by()))),
            ("width", json!(self.end.shape.width())),
            ("height", json!(self.end.shape.height())),
            ("seed", json!(self.args.seed)),
            ("patch", json!(self.patch.to_string())),
            ("steps", json!(steps.to_string())),
            ("moves", json!(moves.to_string())),
            ("skipped", json!(skipped.to_string())),
            ("fillings", json!(fillings.to_string())),
            ("nodes", json!(nodes.to_string())),
            ("changed", json!(self.changed)),
            ("drift_rows", json!([before.rows, after.rows])),
            ("drift_columns", json!([before.columns, after.columns])),
            ("rows_before", json!(before.profile)),
            ("rows_after", json!(after.profile)),
            ("seconds", json!(self.clock.elapsed().as_secs_f64())),
            ("file", json!(file)),
        ];
        if self.args.output.is_none() {
            fields.extend(output::solution_fields(&self.end));
        }
        fields
    }
}
