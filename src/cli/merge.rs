//! `merge`: the parts of a plan put together, to the answer of the undivided search.

use super::args::MergeArgs;
use super::count::Told;
use super::exit::Exit;
use super::request::Request;
use super::session::Done;
use super::{count, describe, list, output, part};
use crate::cluster::{self, Merged, missing_words};
use crate::packing::Standing;
use crate::packing::solve::{Work, counted, listed};
use crate::store::{Kept, PartFiles, PartResult, SearchPlan};
use anyhow::{Context, bail};
use num_bigint::BigUint;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Runs the command.
///
/// # Errors
/// Results that do not belong together or to the plan, or cannot be read.
pub fn run(args: &MergeArgs) -> anyhow::Result<Exit> {
    let plan = SearchPlan::read(&args.plan)?;
    if args.output.is_some() && !plan.job.is_list() {
        bail!("-o: the plan is for a count, not for a list");
    }
    let folder = part::folder(&args.plan, args.dir.as_deref());
    let merged = cluster::merge(&plan, results(&folder, args.dir.is_some())?)?;
    if !merged.missing.is_empty() {
        return incomplete(args, &plan, &merged);
    }
    match plan.job.is_list() {
        true => merged_list(args, &plan, merged, &folder),
        false => merged_count(args, &plan, merged),
    }
}

/// All results in a folder.
fn results(folder: &Path, asked: bool) -> anyhow::Result<Vec<(PathBuf, PartResult)>> {
    let mut results = Vec::new();
    let entries = match fs::read_dir(folder) {
        // The folder of the plan itself is made by the first part that runs.
        Err(error) if error.kind() == io::ErrorKind::NotFound && !asked => return Ok(results),
        entries => entries.with_context(|| folder.display().to_string())?,
    };
    for entry in entries {
        let file = entry.with_context(|| folder.display().to_string())?.path();
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name.starts_with("part-") && name.ends_with(".result.json") {
            let result = PartResult::read(&file)?;
            if PartFiles::new(folder, result.number, result.of).result != file {
                bail!("{}: holds part {} of {}", file.display(), result.number, result.of);
            }
            results.push((file, result));
        }
    }
    Ok(results)
}

/// Parts are missing: their numbers, and no answer.
fn incomplete(args: &MergeArgs, plan: &SearchPlan, merged: &Merged) -> anyhow::Result<Exit> {
    let missing = missing_words(&merged.missing);
    let done = merged.results.len();
    if args.json {
        output::object(&[
            ("result", json!("stopped")),
            ("parts", json!(plan.parts)),
            ("done", json!(done)),
            ("missing", json!(merged.missing)),
            ("solutions", json!(null)),
            ("nodes", json!(merged.standing.state.nodes.to_string())),
            ("seconds", json!(merged.standing.state.elapsed.as_secs_f64())),
        ])?;
    }
    let number = merged.missing.len() as u64;
    let parts = describe::number(number, "part");
    output::remark(&format!(
        "no answer yet: {done} of {} parts are done; {parts} missing: {missing}",
        plan.parts
    ));
    Ok(Exit::Stopped)
}

fn done(merged: &Merged) -> Done {
    Done {
        work: Work::of(&merged.standing),
        time: merged.standing.state.elapsed,
        standing: merged.standing.clone(),
        stopped: None,
        saved: None,
        kept: None,
    }
}

fn merged_count(args: &MergeArgs, plan: &SearchPlan, merged: Merged) -> anyhow::Result<Exit> {
    let (job, done) = (&plan.job, done(&merged));
    let counted = counted(job, &done.standing)?;
    let nothing = counted.packings == BigUint::ZERO;
    let how = format!("{} in {}", describe::method(job), describe::number(plan.parts, "part"));
    let told = Told { job, done: &done, counted, reason: None, how: &how };
    if args.json {
        let mut fields = told.fields();
        fields.extend([("parts", json!(plan.parts)), ("done", json!(merged.results.len()))]);
        output::object(&fields)?;
    } else {
        count::tell(&told, false)?;
    }
    Ok(Exit::of(!nothing))
}

fn merged_list(
    args: &MergeArgs,
    plan: &SearchPlan,
    merged: Merged,
    folder: &Path,
) -> anyhow::Result<Exit> {
    let request = Request { output: args.output.clone(), json: args.json, ..Request::default() };
    list::check_output(&request)?;
    let labels = plan.job.task.labels();
    let mut kept = Vec::new();
    for (file, result) in &merged.results {
        let files = PartFiles::new(folder, result.number, result.of);
        let extent = result
            .kept
            .with_context(|| format!("{}: does not say which packings it met", file.display()))?;
        let packings = Kept::open(files.packings, extent)?.packings(labels)?;
        // Of each solution met one packing, or of each canonical one.
        let Standing { state, orbits, .. } = &result.standing;
        let met = if plan.job.up_to_symmetry() { *orbits } else { state.solutions };
        if packings.len() as u64 != met {
            bail!("{}: met {met} packings, but {} are kept", file.display(), packings.len());
        }
        kept.extend(packings);
    }
    let packings = listed(&plan.job, kept);
    let done = done(&merged);
    let parts = [("parts", json!(plan.parts)), ("done", json!(merged.results.len()))];
    list::tell(&plan.job, &request, &done, &packings, None, &parts)?;
    if !args.quiet {
        output::remark(&list::found(&plan.job, &done, &packings, None));
    }
    Ok(Exit::of(!packings.is_empty()))
}
