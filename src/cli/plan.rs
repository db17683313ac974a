//! `plan`: a count or a list in parts that need nothing of each other.

use super::args::PlanArgs;
use super::exit::Exit;
use super::{describe, output, problem};
use crate::packing::{Cut, Job, Question, frontier};
use crate::store::{SearchPlan, check_writable};
use serde_json::json;

/// Nodes of the frontier that are wanted, at least; the same for most numbers of parts, so that
/// plans of the same search refine each other.
const FRONTIER: u64 = 1 << 16;
/// Nodes of the frontier to a part, at least.
const PER_PART: u64 = 16;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &PlanArgs) -> anyhow::Result<Exit> {
    let task = problem::task(&args.problem, args.order)?;
    let up_to_symmetry = args.up_to_symmetry;
    let question = match args.list {
        true => Question::List { up_to_symmetry },
        false => Question::Count { up_to_symmetry },
    };
    let job = Job { reduce: !args.plain, by_lines: args.meet, ..Job::new(task, question) };
    job.check()?;
    check_writable(&args.output)?;
    if let Some(reason) = job.task.impossible() {
        if args.json {
            output::object(&[
                ("result", json!("none")),
                ("parts", json!(0)),
                ("done", json!(0)),
                ("reason", json!(reason)),
            ])?;
        } else {
            output::line(&format!("none: {reason}"))?;
        }
        return Ok(Exit::No);
    }
    let cut = match args.depth {
        Some(depth) => Cut::Depth(depth as usize),
        None => Cut::Nodes(FRONTIER.max(PER_PART.saturating_mul(args.parts))),
    };
    let frontier = frontier(&job, cut)?;
    let plan = SearchPlan { job, parts: args.parts, frontier, name: String::new() };
    plan.write(&args.output)?;
    // Read again, for its name and to be sure.
    let plan = SearchPlan::read(&args.output)?;
    let file = args.output.display();
    if args.json {
        output::object(&[
            ("result", json!("planned")),
            ("parts", json!(plan.parts)),
            ("done", json!(0)),
            ("file", json!(args.output.to_string_lossy())),
            ("plan", json!(plan.name)),
            ("depth", json!(frontier.depth)),
            ("frontier", json!(frontier.nodes.to_string())),
            ("above", json!(frontier.above.to_string())),
        ])?;
    } else {
        output::result(|out| {
            writeln!(out, "{}", describe::job(&plan.job))?;
            writeln!(
                out,
                "{} in {file}: {} at depth {}, dealt out; {} above them, which every part visits",
                describe::number(plan.parts, "part"),
                describe::number(frontier.nodes, "node"),
                frontier.depth,
                frontier.above
            )
        })?;
    }
    Ok(Exit::Yes)
}
