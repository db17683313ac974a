//! `find` by construction: a packing that mathematics knows, checked before anybody sees it.
//!
//! Small packings are checked whole by [`verify::check`]. Large ones are never held whole: one
//! pass generates the rows and checks them with a bit a tile, the next generates and writes them.

use super::args::{FindArgs, ValueOrder};
use super::exit::Exit;
use super::ring::RingOrder;
use super::{describe, duration, output, problem, ring};
use crate::construct::{Constructed, NotConstructed, construct};
use crate::packing::Prunings;
use crate::packing::Task;
use crate::packing::task::TaskError;
use crate::store::{
    Layout, check_writable, write_file, write_grid_head, write_grid_row, write_solution_rows,
};
use crate::tiles::{Kind, TileId, TileSet};
use crate::torus::{Packing, Shape};
use crate::verify::{self, RowCheck, RowFault};
use anyhow::{anyhow, bail};
use serde_json::{Value, json};
use std::io::{self, Write};
use std::time::Instant;

/// Packings of so many cells are checked whole.
const MOST_TO_HOLD: usize = 1 << 20;

/// `--method construct`.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &FindArgs) -> anyhow::Result<Exit> {
    if let Some(option) = asks_for_search(args) {
        let by_ring = args.ring != RingOrder::Least;
        let what = if by_ring { "--ring wei" } else { "--method construct" };
        bail!("{what}: {option} is for a search");
    }
    let (set, shape) = problem::set_and_shape(&args.problem)?;
    let begin = Instant::now();
    match ring::find(&set, shape, args.search.seed, args.ring)? {
        Ok(constructed) => give(args, &constructed, begin, None),
        Err(why) => {
            check_size(&set, shape)?;
            not_found(args, shape, &why, begin).map(|()| Exit::No)
        }
    }
}

/// Checks a construction and writes it where it is wanted; `why` it was chosen, if the program
/// did.
///
/// # Errors
/// A file that cannot be written, memory that is not there.
pub fn give(
    args: &FindArgs,
    constructed: &Constructed,
    begin: Instant,
    why: Option<&str>,
) -> anyhow::Result<Exit> {
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    check(constructed)?;
    found(args, constructed, begin, why).map(|()| Exit::Yes)
}

/// The option that only a search can follow, if one was given.
pub(super) fn asks_for_search(args: &FindArgs) -> Option<&'static str> {
    let (problem, search) = (&args.problem, &args.search);
    let options = [
        (problem.board.given().is_some(), problem.board.given().unwrap_or_default()),
        (problem.pin.is_some(), "--pin"),
        (problem.automorphism.is_some(), "--automorphism"),
        (problem.cover, "--cover"),
        (search.order.is_some(), "--order"),
        (args.values == ValueOrder::Random, "--values random"),
        (args.values == ValueOrder::Highest, "--values highest"),
        (args.restarts.is_some(), "--restarts"),
        (search.plain, "--plain"),
        (search.prunings != Prunings::default(), "--prunings"),
        (search.checkpoint.is_some(), "--checkpoint"),
        (search.run.status.is_some(), "--status"),
    ];
    options.into_iter().find_map(|(given, option)| given.then_some(option))
}

/// The construction that a seed chooses; 0 is the closed form.
///
/// # Errors
/// That there is no packing, as far as a short argument shows it; that no construction is known.
pub(super) fn find(set: &TileSet, shape: Shape, seed: u64) -> Result<Constructed, NotConstructed> {
    construct(set, shape, (seed != 0).then_some(seed)).map_err(|why| {
        let known = matches!(why, NotConstructed::Impossible(_));
        if known || set.size() != shape.cells() as u64 || Task::check_size(set, shape).is_err() {
            return why;
        }
        let impossible = Task::new(set.clone(), shape).impossible();
        impossible.map_or(why, NotConstructed::Impossible)
    })
}

/// Whether the torus has the size of the set; the search would ask the same.
///
/// # Errors
/// If not.
pub(super) fn check_size(set: &TileSet, shape: Shape) -> Result<(), TaskError> {
    let (cells, tiles) = (shape.cells() as u64, set.size());
    if cells != tiles {
        let hint = ": a packing needs exactly as many cells";
        return Err(TaskError::Size { shape, cells, tiles, hint });
    }
    if set.kind() == Kind::Domino && shape.width() > 1 && shape.height() > 1 {
        return Err(TaskError::NotARing(shape));
    }
    Ok(())
}

/// Checks what was constructed from the definition.
fn check(constructed: &Constructed) -> anyhow::Result<()> {
    let wrong = |what: &dyn std::fmt::Display| {
        anyhow!("internal error: what was constructed is no packing: {what}; please report this")
    };
    if constructed.shape().cells() <= MOST_TO_HOLD {
        let verdict = verify::check(&constructed.packing());
        return if verdict.is_valid() { Ok(()) } else { Err(wrong(&verdict)) };
    }
    let checked = RowCheck::new(constructed.set(), constructed.shape()).and_then(|mut check| {
        constructed.try_for_each_row(|_, tiles| check.row(tiles))?;
        check.finish()
    });
    checked.map_err(|fault| match fault {
        RowFault::Memory(_) => anyhow!("size {}: {fault}", constructed.shape()),
        fault => wrong(&fault),
    })
}

fn not_found(
    args: &FindArgs,
    shape: Shape,
    why: &NotConstructed,
    begin: Instant,
) -> anyhow::Result<()> {
    let (result, method) = match why {
        NotConstructed::Impossible(_) => ("none", "argument"),
        NotConstructed::Unknown(_) => ("unknown", "construct"),
    };
    if args.json {
        let mut fields = fields(result, method, shape, begin);
        fields.extend([
            ("file", Value::Null),
            ("reason", json!(why.to_string())),
            ("why", Value::Null),
        ]);
        return output::object(&fields);
    }
    match why {
        NotConstructed::Impossible(_) => output::line(&format!("none: {why}")),
        NotConstructed::Unknown(_) => {
            output::line(&format!("unknown: {why}; --method search looks for a packing"))
        }
    }
}

fn fields(result: &str, method: &str, shape: Shape, begin: Instant) -> Vec<(&'static str, Value)> {
    vec![
        ("result", json!(result)),
        ("method", json!(method)),
        ("width", json!(shape.width())),
        ("height", json!(shape.height())),
        ("nodes", json!("0")),
        ("seconds", json!(begin.elapsed().as_secs_f64())),
        ("stopped_by", Value::Null),
    ]
}

/// Writes the packing where it is wanted.
fn found(
    args: &FindArgs,
    constructed: &Constructed,
    begin: Instant,
    why: Option<&str>,
) -> anyhow::Result<()> {
    let (shape, seed) = (constructed.shape(), args.search.seed);
    let set = constructed.set().clone();
    let about = Packing::new(set, shape, false, Vec::new());
    let how = how(constructed, seed);
    if let Some(file) = &args.output {
        let provenance = json!({
            "method": format!("constructed: {how}"),
            "source": constructed.source(),
            "program": "tilepack",
            "version": env!("CARGO_PKG_VERSION"),
            "seed": seed,
        });
        write_file(file, |out| {
            write_solution_rows(out, &about, &provenance, Layout::Pretty, |take| {
                constructed.try_for_each_row(|_, tiles| take(tiles))
            })
        })?;
    }
    if args.json {
        print_json(args, constructed, &about, begin, why)?;
    } else if args.output.is_none() {
        output::result(|out| {
            writeln!(out, "# constructed: {how}")?;
            write_grid(out, constructed, &about)
        })?;
    }
    if !args.search.run.quiet {
        let written = match &args.output {
            Some(file) => format!("; written to {}", file.display()),
            None => String::new(),
        };
        let tiles = describe::number(shape.cells() as u64, "tile");
        let time = duration::words(begin.elapsed());
        output::remark(&format!("constructed: {how}: {tiles} in {time}{written}"));
    }
    Ok(())
}

/// The construction, and which member of its family.
fn how(constructed: &Constructed, seed: u64) -> String {
    match seed {
        0 => constructed.name().to_owned(),
        seed => format!("{}, member chosen by seed {seed}", constructed.name()),
    }
}

fn write_grid(out: &mut dyn Write, constructed: &Constructed, about: &Packing) -> io::Result<()> {
    write_grid_head(&mut *out, about)?;
    let set = constructed.set();
    let corner = set.kind() == Kind::Corner;
    let largest = match corner {
        true => set.colors().largest() as u32 - 1,
        false => (set.kind().tiles(set.colors()) - 1) as u32,
    };
    constructed.try_for_each_row(|labels, tiles| match corner {
        true => write_grid_row(&mut *out, labels.iter().map(|&color| color.into()), largest),
        false => write_grid_row(&mut *out, tiles.iter().map(|tile| tile.0), largest),
    })
}

fn print_json(
    args: &FindArgs,
    constructed: &Constructed,
    about: &Packing,
    begin: Instant,
    why: Option<&str>,
) -> anyhow::Result<()> {
    let file = args.output.as_deref().map(|file| file.to_string_lossy());
    let mut fields = fields("found", "construct", constructed.shape(), begin);
    fields.extend([
        ("file", json!(file)),
        ("reason", Value::Null),
        ("why", json!(why)),
        ("construction", json!(constructed.name())),
        ("source", json!(constructed.source())),
        ("seed", json!(args.search.seed)),
    ]);
    if args.output.is_some() {
        return output::object(&fields);
    }
    // With the rest of a solution's fields the object is a solution, too.
    let description = output::description(about);
    for name in ["format", "kind", "colors", "set", "topology"] {
        fields.push((name, description[name].clone()));
    }
    let head = output::object_text(&fields);
    output::result(|out| {
        write!(out, "{},\"tiles\":[", &head[..head.len() - 1])?;
        let mut comma = "";
        constructed.try_for_each_row(|_, tiles: &[TileId]| {
            let row: Vec<String> = tiles.iter().map(TileId::to_string).collect();
            write!(out, "{}[{}]", std::mem::replace(&mut comma, ","), row.join(","))
        })?;
        writeln!(out, "]}}")
    })
}
