//! `count`: the exact number of packings, by search.

use super::args::CountArgs;
use super::exit::Exit;
use super::session::{Done, Session};
use super::{describe, output, problem};
use crate::packing::solve::SolveError;
use crate::packing::{self, Counted, Task};
use crate::search::Values;
use crate::tiles::Kind;
use num_bigint::BigUint;
use serde_json::json;

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &CountArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, args.search.order)?;
    if args.up_to_symmetry && task.has_pins() {
        return Err(SolveError::PinnedOrbits.into());
    }
    let session = Session::new(&args.search, Values::Lexicographic)?;
    let reason = task.impossible();
    let done = match &reason {
        Some(_) => session.without_search(Counted {
            packings: BigUint::ZERO,
            fundamental: args.up_to_symmetry.then_some(0),
            up_to_translation: Some(BigUint::ZERO),
        }),
        None => session.run(|settings| packing::count(&task, settings, args.up_to_symmetry))?,
    };
    if args.json {
        print_json(args, &done, reason.as_deref())?;
    } else {
        print(args, &task, &done, reason.as_deref())?;
    }
    done.tell_stop("the numbers are lower bounds");
    Ok(match done.stopped {
        Some(_) => Exit::Stopped,
        None => Exit::of(done.value.packings != BigUint::ZERO),
    })
}

fn print(
    args: &CountArgs,
    task: &Task,
    done: &Done<Counted>,
    reason: Option<&str>,
) -> anyhow::Result<()> {
    let Counted { packings, fundamental, up_to_translation } = &done.value;
    let at_least = if done.stopped.is_some() { "at least " } else { "" };
    let (sought, conditions) = (describe::sought(task), describe::conditions(task));
    let plural = if *packings == BigUint::from(1u32) { "" } else { "s" };
    output::result(|out| {
        writeln!(out, "{at_least}{packings} {sought}{plural}{conditions}")?;
        if let Some(fundamental) = fundamental {
            writeln!(out, "{at_least}{fundamental} up to symmetry")?;
        }
        if let Some(number) = up_to_translation.as_ref().filter(|_| reason.is_none()) {
            let rings = match task.set.kind() {
                Kind::Domino => " (rings up to rotation)",
                _ => "",
            };
            writeln!(out, "{number} up to translation{rings}")?;
        }
        writeln!(out, "{}", how(args, task, done, reason))
    })
}

/// What was counted and how.
fn how(args: &CountArgs, task: &Task, done: &Done<Counted>, reason: Option<&str>) -> String {
    let set = describe::set(&task.set);
    let torus = describe::torus(task.set.kind(), task.shape);
    let how = match (reason, &done.stopped) {
        (Some(reason), _) => format!("by an argument: {reason}"),
        (None, Some(_)) => format!("by search, stopped early: {}", done.effort()),
        (None, None) => format!("by search, complete: {}", done.effort()),
    };
    let checked = match (reason, args.up_to_symmetry, args.search.plain) {
        (Some(_), ..) => "",
        (None, true, _) if done.stopped.is_none() => ", the sizes of the orbits add up to it",
        (None, _, true) => ", no symmetry removed",
        (None, ..) => ", symmetry removed and multiplied back exactly",
    };
    format!("{set}, {torus}; {how}{checked}")
}

fn print_json(args: &CountArgs, done: &Done<Counted>, reason: Option<&str>) -> anyhow::Result<()> {
    let Counted { packings, fundamental, up_to_translation } = &done.value;
    let mut fields =
        vec![("result", json!(done.state())), ("solutions", json!(packings.to_string()))];
    if args.up_to_symmetry {
        fields.push(("fundamental", json!(fundamental.map(|number| number.to_string()))));
    }
    let up_to_translation = up_to_translation.as_ref().map(BigUint::to_string);
    fields.push(("up_to_translation", json!(up_to_translation)));
    fields.extend(done.fields());
    let method = if reason.is_some() { "argument" } else { "search" };
    fields.extend([("method", json!(method)), ("reason", json!(reason))]);
    output::object(&fields)
}
