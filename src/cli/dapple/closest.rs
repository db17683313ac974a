//! `dapple closest`: the dappled tiling that differs least from a field, with what is proved.

use super::{rule, write};
use crate::atlas::levels::image_field;
use crate::atlas::open_png;
use crate::cli::args::DappleClosestArgs;
use crate::cli::describe::number;
use crate::cli::exit::Exit;
use crate::cli::session::{Clock, spoken};
use crate::cli::{duration, output, source};
use crate::dappled::closest::{Answer, MOST_CELLS, Task, closest};
use crate::dappled::notation::{self, write_field};
use crate::dappled::{FREE, Field, Rule};
use crate::store::check_writable;
use anyhow::{anyhow, ensure};
use serde_json::{Value, json};
use std::path::Path;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &DappleClosestArgs) -> anyhow::Result<Exit> {
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let clock = Clock::start(args.time_limit, args.threads)?;
    let field = rule::field(&args.file, args.rule.tiles)?;
    let size = (field.width(), field.height());
    let cells = field.cells().len();
    let name = args.file.display();
    ensure!(cells <= MOST_CELLS, "{name}: {cells} cells, expected {MOST_CELLS} or fewer");
    let rule = rule::rule(&args.rule, size)?;
    let fixed = args.fixed.as_deref().map(|file| self::fixed(file, args, size)).transpose()?;
    let weights = args.weights.as_deref().map(|file| self::weights(file, size)).transpose()?;
    let fixed = fixed.as_ref();
    let task = Task { rule: &rule, field: &field, fixed, weights: weights.as_deref() };
    let answer = closest(&task, args.seed, &clock.stop())?;
    tell(args, &clock, &rule, &field, fixed, &answer)
}

/// The cells that must stay as they are.
fn fixed(file: &Path, args: &DappleClosestArgs, size: (usize, usize)) -> anyhow::Result<Field> {
    let fixed = rule::field(file, args.rule.tiles)?;
    let (width, height) = (fixed.width(), fixed.height());
    let name = file.display();
    ensure!(
        (width, height) == size,
        "{name}: {width}x{height} cells, expected {}x{} as in {}",
        size.0,
        size.1,
        args.file.display()
    );
    Ok(fixed)
}

/// What it costs to change each cell.
fn weights(file: &Path, size: (usize, usize)) -> anyhow::Result<Vec<u32>> {
    let named = |error: String| anyhow!("{}: {error}", file.display());
    if file.extension().is_some_and(|end| end.eq_ignore_ascii_case("png")) {
        let picture = image_field(&open_png(file)?, 256, 1).map_err(named)?;
        let (width, height) = (picture.width(), picture.height());
        ensure!(
            (width, height) == size,
            "{}: {width}x{height} texels, expected {}x{}",
            file.display(),
            size.0,
            size.1
        );
        return Ok(picture.cells().iter().map(|&level| u32::from(level)).collect());
    }
    let input = source::open(file)?;
    notation::weights(input.text(), size)
        .map_err(|error| anyhow!("{}:{error}", input.file().display()))
}

fn tell(
    args: &DappleClosestArgs,
    clock: &Clock,
    rule: &Rule,
    field: &Field,
    fixed: Option<&Field>,
    answer: &Answer,
) -> anyhow::Result<Exit> {
    let cells = field.cells().len();
    let result = match (&answer.tiling, answer.is_proved()) {
        (Some(_), true) => "optimal",
        (Some(_), false) => "found",
        (None, true) => "impossible",
        (None, false) => "stopped",
    };
    let changed = answer.tiling.as_ref().map(|tiling| {
        let pairs = tiling.cells().iter().zip(field.cells());
        pairs.filter(|&(a, b)| *b != FREE && a != b).count()
    });
    let effort = match answer.rounds {
        0 => duration::words(clock.elapsed()),
        _ => format!(
            "{}, {} decided both ways, strips of up to {}, {}",
            number(answer.rounds, "round"),
            number(answer.nodes, "cell"),
            number(answer.lines as u64, "line"),
            duration::words(clock.elapsed())
        ),
    };
    let about = match (answer.distance, answer.bound) {
        (Some(distance), Some(bound)) => {
            let proved = match distance - bound {
                0 => "optimal (proved)".to_owned(),
                gap => format!("within {gap} of the optimum"),
            };
            let distance = match (&args.weights, changed) {
                (Some(_), Some(changed)) => {
                    format!("distance {distance} ({changed} of {cells} cells)")
                }
                _ => format!("distance {distance} of {}", number(cells as u64, "cell")),
            };
            format!("{distance}, lower bound {bound}: {proved}")
        }
        _ => String::new(),
    };
    if let Some(tiling) = &answer.tiling
        && (args.output.is_some() || !args.json)
    {
        let about = format!("nearest dappled tiling, {about}");
        write::write(tiling, args.rule.tiles, args.output.as_deref(), &about)?;
    }
    let core = answer.core.as_ref().map(|core| {
        let mut blamed = field.clone();
        for (cell, blamed) in blamed.cells_mut().iter_mut().enumerate() {
            let at_fault = core.contains(&(cell as u32));
            *blamed = fixed.filter(|_| at_fault).map_or(FREE, |fixed| fixed.cells()[cell]);
        }
        blamed
    });
    if args.json {
        let rows = match (&answer.tiling, &args.output) {
            (Some(tiling), None) => write::rows_json(tiling),
            _ => Value::Null,
        };
        let file = answer.tiling.as_ref().and(args.output.as_ref());
        output::object(&[
            ("result", json!(result)),
            ("width", json!(field.width())),
            ("height", json!(field.height())),
            ("distance", json!(answer.distance)),
            ("bound", json!(answer.bound)),
            ("changed", json!(changed)),
            ("rounds", json!(answer.rounds)),
            ("nodes", json!(answer.nodes)),
            ("lines", json!(answer.lines)),
            ("seed", json!(args.seed)),
            ("core", core.as_ref().map_or(Value::Null, write::rows_json)),
            ("tiles", rows),
            ("file", json!(file.map(|file| file.to_string_lossy()))),
            ("seconds", json!(clock.elapsed().as_secs_f64())),
        ])?;
    } else {
        match result {
            "impossible" => output::result(|out| {
                writeln!(out, "# impossible: {}", reason(core.as_ref(), fixed))?;
                match core.filter(|core| core.cells().iter().any(|&tile| tile != FREE)) {
                    Some(core) => out.write_all(write_field(&core, rule.tiles()).as_bytes()),
                    None => Ok(()),
                }
            })?,
            "stopped" => output::line("stopped: no tiling found, none excluded")?,
            _ if !args.quiet => output::remark(&format!("{about}; {effort}")),
            _ => {}
        }
    }
    let stopped = !answer.is_proved();
    if stopped && clock.elapsed_limit() {
        output::remark(&format!("stopped early by {}: {effort}", spoken(clock.stopped_by())));
    }
    Ok(match result {
        "impossible" => Exit::No,
        "optimal" => Exit::Yes,
        _ if stopped && clock.elapsed_limit() => Exit::Stopped,
        _ => Exit::Yes,
    })
}

/// Why there is no tiling.
fn reason(core: Option<&Field>, fixed: Option<&Field>) -> &'static str {
    match core {
        Some(core) if core.cells().iter().any(|&tile| tile != FREE) => {
            "these fixed cells have no completion"
        }
        None if fixed.is_some() => "the fixed cells have no completion",
        _ => "there is no dappled tiling of this size",
    }
}
