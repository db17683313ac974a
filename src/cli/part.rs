//! `run`: searches one part of a plan.
//!
//! Safe to be run again: a part that is done ends at once, one that was stopped goes on from its
//! checkpoint, one that another process is at work on is refused with 75. The result takes its name when
//! it is complete on the disk; only then the checkpoint is removed.

use super::args::PartArgs;
use super::exit::Exit;
use super::request::Request;
use super::saving::Save;
use super::session::Session;
use super::{describe, duration, output};
use crate::store::{
    Kept, Lock, PartFiles, PartResult, SearchPlan, StoreError, beside, check_writable, previous,
};
use anyhow::{Context, bail};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the parts of a plan.
pub fn folder(plan: &Path, asked: Option<&Path>) -> PathBuf {
    asked.map_or_else(|| beside(plan, ".parts"), Path::to_path_buf)
}

/// Runs the command.
///
/// # Errors
/// Bad input, a part that another process is at work on, files that do not belong to the plan.
pub fn run(args: &PartArgs) -> anyhow::Result<Exit> {
    let plan = SearchPlan::read(&args.plan)?;
    if args.part >= plan.parts {
        bail!("--part {}: the plan has {} parts, from 0 on", args.part, plan.parts);
    }
    let folder = folder(&args.plan, args.dir.as_deref());
    fs::create_dir_all(&folder).with_context(|| format!("{}: cannot be made", folder.display()))?;
    let files = PartFiles::new(&folder, args.part, plan.parts);
    if let Some(result) = finished(&plan, args.part, &files)? {
        return tell(args, &plan, &result, true);
    }
    let job = plan.part(args.part);
    let session = Session::new(&args.run)?;
    let save = Save { file: files.checkpoint.clone(), kept: files.packings.clone() };
    // Held until the result is there and the checkpoint is gone.
    let lock = match Lock::take(&files.result) {
        Ok(lock) => lock,
        // Not a mistake: when that process is gone, this one may go on.
        Err(busy @ StoreError::Locked { .. }) => return busy_elsewhere(args, &plan, &busy),
        Err(error) => return Err(error.into()),
    };
    if let Some(result) = finished(&plan, args.part, &files)? {
        return tell(args, &plan, &result, true);
    }
    check_writable(&files.result)?;
    let mut done = session.run(&job, &Request::default(), Some(save))?;
    if done.stopped.is_some() {
        if args.json {
            let mut fields = vec![
                ("result", json!("stopped")),
                ("part", json!(args.part)),
                ("parts", json!(plan.parts)),
                ("done", json!(0)),
                (
                    "solutions_met",
                    json!(describe::solutions_met(&job, done.standing.state.solutions)),
                ),
            ];
            fields.extend(done.fields());
            output::object(&fields)?;
        }
        let exit = done.stopped_exit();
        // Not to be gone on with by itself: only with its plan it comes to a result.
        done.saved = done.saved.filter(Result::is_err);
        done.tell_stop("run it again to go on");
        return Ok(exit);
    }
    // Then packings met may be missing from their file, whatever could be written since.
    if let (true, Some(Err(error))) = (job.is_list(), done.saved) {
        return Err(error.into());
    }
    done.standing.kept.clear();
    let kept = done.kept;
    let result = PartResult {
        plan: plan.name.clone(),
        number: args.part,
        of: plan.parts,
        standing: done.standing,
        kept,
        version: env!("CARGO_PKG_VERSION").into(),
    };
    result.write(&files.result)?;
    // What stays of them takes space and does no harm.
    for file in [previous(&files.checkpoint), files.checkpoint.clone()] {
        let _ = fs::remove_file(file);
    }
    drop(lock);
    tell(args, &plan, &result, false)
}

/// Another process is at work on the part.
fn busy_elsewhere(args: &PartArgs, plan: &SearchPlan, busy: &StoreError) -> anyhow::Result<Exit> {
    if args.json {
        output::object(&[
            ("result", json!("stopped")),
            ("part", json!(args.part)),
            ("parts", json!(plan.parts)),
            ("done", json!(0)),
            ("stopped_by", json!("lock")),
        ])?;
    }
    output::remark(&busy.to_string());
    Ok(Exit::Stopped)
}

/// The result of a part, if it is there and belongs to the plan.
fn finished(
    plan: &SearchPlan,
    number: u64,
    files: &PartFiles,
) -> anyhow::Result<Option<PartResult>> {
    let result = match PartResult::read(&files.result) {
        Ok(result) => result,
        Err(StoreError::Missing { .. }) => return Ok(None),
        Err(error) => return Err(error.into()),
    };
    if (&result.plan, result.number, result.of) != (&plan.name, number, plan.parts) {
        bail!("{}: is the result of another plan or part", files.result.display());
    }
    if let Some(extent) = result.kept {
        Kept::open(files.packings.clone(), extent)?;
    }
    Ok(Some(result))
}

fn tell(
    args: &PartArgs,
    plan: &SearchPlan,
    result: &PartResult,
    before: bool,
) -> anyhow::Result<Exit> {
    let state = &result.standing.state;
    let seconds = state.elapsed.as_secs_f64();
    if args.json {
        output::object(&[
            ("result", json!("complete")),
            ("part", json!(result.number)),
            ("parts", json!(plan.parts)),
            ("done", json!(1)),
            ("solutions_met", json!(describe::solutions_met(&plan.job, state.solutions))),
            ("nodes", json!(state.nodes.to_string())),
            ("seconds", json!(seconds)),
            ("stopped_by", json!(null)),
        ])?;
    } else if !args.run.quiet {
        let when = if before { "was done before" } else { "done" };
        output::remark(&format!(
            "part {} of {} {when}: {} met, {} nodes in {}",
            result.number,
            plan.parts,
            describe::number(state.solutions, describe::leaf(&plan.job)),
            state.nodes,
            duration::words(state.elapsed)
        ));
    }
    Ok(Exit::Yes)
}
