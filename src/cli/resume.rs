//! `resume`: goes on with a search that was saved, exactly where it stopped.
//!
//! The checkpoint says what the search is and what is to be done with the answer; only limits,
//! threads and what is shown are new.

use super::args::ResumeArgs;
use super::exit::Exit;
use super::request::Request;
use super::saving::Save;
use super::session::Session;
use super::{count, dapple, find, list};
use crate::packing::Question;
use crate::store::{holds_long, read_checkpoint, read_job};
use anyhow::{Context, bail};

/// Runs the command.
///
/// # Errors
/// A file that is no checkpoint, or one of a search that this program does not run.
pub fn run(args: &ResumeArgs) -> anyhow::Result<Exit> {
    if holds_long(&args.file) {
        return dapple::count::resume(args);
    }
    let checkpoint = read_checkpoint(&args.file)?.checkpoint;
    let file = args.file.display();
    let job = read_job(&checkpoint.job).map_err(anyhow::Error::msg);
    let job = job.with_context(|| file.to_string())?;
    if let Some(part) = job.part {
        bail!(
            "{file}: holds part {} of {} of a plan: go on with it by tilepack run PLAN --part {}",
            part.number,
            part.of,
            part.number
        );
    }
    let mut request = Request::read(&checkpoint.request);
    request.json |= args.json;
    if args.output.is_some() {
        request.output.clone_from(&args.output);
    }
    let session = Session::new(&args.run)?;
    let save = Some(Save::at(&args.file));
    match job.question {
        Question::First => find::answer(&job, &request, &session, save),
        Question::Count { .. } => count::answer(&job, &request, &session, save),
        Question::List { .. } => list::answer(&job, &request, &session, save),
    }
}
