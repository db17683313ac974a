//! `brick`: walls of brick Wang tiles. `wall` makes them, `write` puts them out, along with the
//! tiles themselves.

mod wall;
mod write;

use super::args::BrickArgs;
use super::exit::Exit;
use super::{output, signal};
use crate::dappled::brick::labels::{count, count_all};
use crate::dappled::brick::{Wall, tiles};
use crate::store::check_writable;
use anyhow::{bail, ensure};
use serde_json::json;
use wall::Built;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &BrickArgs) -> anyhow::Result<Exit> {
    for file in args.output.iter().chain(&args.set_out) {
        check_writable(file)?;
    }
    let wanted = args.size.is_some() || args.labels.is_some() || args.region.is_some();
    if !wanted {
        ensure!(
            (args.set_out.is_some() || args.tiles_out.is_some()) && args.output.is_none(),
            "which wall? Expected --size WxH, --labels FILE or --region FILE"
        );
    }
    if let Some(file) = args.output.as_ref().filter(|file| write::ends_with(file, "json")) {
        let file = file.display();
        ensure!(args.cyclic, "{file}: JSON is for walls that repeat: expected --cyclic");
    }
    if args.count {
        return counted(args);
    }
    let stop = signal::listen()?;
    let built = if wanted { Some(wall::build(args, stop)?) } else { None };
    let (wall, how) = match built {
        None => (None, ""),
        Some(Built::Wall(wall, how)) => (Some(wall), how),
        Some(Built::None(reason)) => return none(args, "none", &reason, Exit::No),
        Some(Built::Stopped(reason)) => return none(args, "stopped", &reason, Exit::Stopped),
    };
    if let Some(fault) = wall.as_ref().and_then(|wall| wall.fault(args.cyclic)) {
        bail!("internal error: {fault}; please report");
    }
    write::tiles(args)?;
    if let Some(wall) = &wall {
        write::wall(args, wall, how)?;
    }
    if args.json {
        let name = |file: &Option<std::path::PathBuf>| {
            json!(file.as_ref().map(|file| file.to_string_lossy()))
        };
        let mut fields = vec![
            ("result", json!("built")),
            ("method", json!(how)),
            ("width", json!(wall.as_ref().map(Wall::width))),
            ("height", json!(wall.as_ref().map(Wall::height))),
            ("positions", json!(args.positions)),
            ("set_size", json!(tiles(args.positions).len())),
            ("seed", json!(args.seed)),
            ("file", name(&args.output)),
            ("set_file", name(&args.set_out)),
            ("tiles_file", name(&args.tiles_out)),
        ];
        if let (Some(wall), None) = (&wall, &args.output) {
            fields.push(("tiles", write::rows_json(wall)));
        }
        output::object(&fields)?;
    } else if !args.quiet {
        let set = tiles(args.positions).len();
        let positions = args.positions;
        output::remark(&match &wall {
            Some(wall) => format!(
                "{}x{} tiles by {how}; in every one exactly one joint goes through",
                wall.width(),
                wall.height()
            ),
            None => format!("{set} brick Wang tiles over {positions} positions"),
        });
    }
    Ok(Exit::Yes)
}

/// Counts walls.
fn counted(args: &BrickArgs) -> anyhow::Result<Exit> {
    let (walls, method) = match &args.labels {
        Some(file) => {
            let labels = wall::labels_of(args, file)?;
            let partial = wall::partial(args, (labels.width(), labels.height()))?;
            (count(&partial, &labels, args.cyclic), "walks along every line")
        }
        None => {
            ensure!(
                !args.cyclic && args.boundary.is_none(),
                "--count without --labels: expected no --cyclic and no --boundary"
            );
            let size = wall::size(args)?;
            ensure!(
                size.0.saturating_mul(size.1) <= 1 << 20,
                "--size {}x{}: expected at most {} tiles to count",
                size.0,
                size.1,
                1 << 20
            );
            (count_all(size, args.positions), "formula")
        }
    };
    match args.json {
        true => output::object(&[
            ("result", json!("counted")),
            ("method", json!(method)),
            ("walls", json!(walls.to_string())),
        ])?,
        false => output::line(&format!("{walls} walls"))?,
    }
    Ok(Exit::Yes)
}

/// Says that there is no wall.
fn none(args: &BrickArgs, result: &str, reason: &str, exit: Exit) -> anyhow::Result<Exit> {
    match args.json {
        true => output::object(&[("result", json!(result)), ("reason", json!(reason))])?,
        false => output::line(&format!("{result}: {reason}"))?,
    }
    Ok(exit)
}
