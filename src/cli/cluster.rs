//! `cluster`: job files that run the parts of a plan with a scheduler.

use super::args::{ClusterCommand, JobArgs};
use super::exit::Exit;
use super::{duration, output, part};
use crate::cluster::{self, Job, Slurm};
use crate::store::{SearchPlan, write_file};
use anyhow::{Context, bail};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Runs the command.
///
/// # Errors
/// A plan that cannot be read, names that cannot be written, a file that cannot be.
pub fn run(command: &ClusterCommand) -> anyhow::Result<Exit> {
    let (text, args) = match command {
        ClusterCommand::Slurm(args) => {
            let options = Slurm { time: args.time.clone(), max_array: args.max_array };
            (cluster::slurm(&job(&args.job)?, &options)?, &args.job)
        }
        ClusterCommand::Hyperqueue(args) => (cluster::hyperqueue(&job(args)?), args),
        ClusterCommand::Parallel(args) => (cluster::parallel(&job(args)?), args),
    };
    match &args.output {
        Some(file) => write_file(file, |out| out.write_all(text.as_bytes()))?,
        None => output::result(|out| out.write_all(text.as_bytes()))?,
    }
    Ok(Exit::Yes)
}

/// The parts of the plan, with names that hold everywhere on a shared disk.
fn job(args: &JobArgs) -> anyhow::Result<Job> {
    let parts = SearchPlan::read(&args.plan)?.parts;
    let plan = absolute(&args.plan)?;
    let dir = absolute(&part::folder(&args.plan, args.dir.as_deref()))?;
    // A name without a slash is looked for on the path of the nodes.
    let program = match args.program.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => absolute(&args.program)?,
        _ => text(&args.program)?,
    };
    let checkpoint_every = args.checkpoint_every.clone();
    Ok(Job { program, plan, dir, parts, threads: args.threads, checkpoint_every })
}

fn absolute(path: &Path) -> anyhow::Result<String> {
    text(&std::path::absolute(path).with_context(|| path.display().to_string())?)
}

fn text(path: &Path) -> anyhow::Result<String> {
    match PathBuf::from(path).into_os_string().into_string() {
        Ok(text) if !text.contains('\0') => Ok(text),
        _ => bail!("{}: a name that is not UTF-8 cannot be written to a script", path.display()),
    }
}

/// Reads the time from one checkpoint to the next, to be passed on as it was written.
///
/// # Errors
/// What is wrong with it.
pub fn checkpoint_every(text: &str) -> Result<String, String> {
    duration::parse(text).map(|_| text.into()).map_err(|error| error.to_string())
}

/// Reads a time limit in Slurm's notation: HH:MM:SS, or D-HH:MM:SS for days.
///
/// # Errors
/// What is wrong with it.
pub fn time_limit(text: &str) -> Result<String, String> {
    let (days, time) = text.split_once('-').unwrap_or(("0", text));
    let number = |digits: &str| {
        let digits_only = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
        digits_only.then(|| digits.parse::<u32>().ok()).flatten()
    };
    let fields: Vec<Option<u32>> = time.split(':').map(number).collect();
    match (number(days), &fields[..]) {
        (Some(days), [Some(hours), Some(minutes), Some(seconds)])
            if *minutes < 60 && *seconds < 60 && days + hours + minutes + seconds > 0 =>
        {
            Ok(text.into())
        }
        _ => Err("expected HH:MM:SS or D-HH:MM:SS, such as 24:00:00 or 7-00:00:00".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::time_limit;

    #[test]
    fn time_limits() {
        for right in ["00:05:00", "24:00:00", "100:00:00", "7-00:00:00"] {
            assert_eq!(time_limit(right).as_deref(), Ok(right));
        }
        for wrong in
            ["", "60", "1:2", "00:00:00", "00:60:00", "1-2-3", "a:b:c", "1:00:00 ", "+1:00:00"]
        {
            assert!(time_limit(wrong).is_err(), "{wrong}");
        }
    }
}
