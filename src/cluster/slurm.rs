//! Slurm: one array job, or several where the site does not allow one so long.
//!
//! Run by a user, the script submits itself; run by Slurm, it runs one part. An array may have
//! indices below MaxArraySize only (1001 unless the site changed it), so a longer plan becomes
//! several arrays, each with the number of its first part as the argument of the script.
//!
//! Slurm itself requeues jobs whose node failed (`--requeue`). Before the time limit it signals the
//! script; the part stops with 75 and the script requeues it. A job that was cancelled, preempted
//! or lost its node is not RUNNING any more, and what becomes of it is not ours to decide.

use super::shell::ATTEND;
use super::{ClusterError, Job};

/// What only Slurm wants to know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slurm {
    /// The time limit of a part's run in Slurm's notation; the site's own if there is none.
    pub time: Option<String>,
    /// Indices of an array at most: MaxArraySize of the site, at least one.
    pub max_array: u64,
}

/// Seconds between the signal and the time limit; Slurm looks at the clock about once a minute.
const WARNING: u32 = 120;

/// The script that submits and runs all parts with Slurm.
///
/// # Errors
/// When Slurm could not write logs to the folder of the parts.
pub fn slurm(job: &Job, options: &Slurm) -> Result<String, ClusterError> {
    if job.dir.contains(['%', '\\']) {
        return Err(ClusterError::SlurmFolder(job.dir.clone()));
    }
    let time = match &options.time {
        Some(time) => format!("#SBATCH --time={time}\n"),
        None => String::new(),
    };
    let head = job.head("sbatch");
    let (threads, logs) = (job.threads, job.logs());
    let submit = submit(job.parts, options.max_array.max(1));
    let command = job.command(r#""$part""#);
    Ok(format!(
        r#"#!/bin/sh
{head}#SBATCH --job-name=tilepack
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={threads}
{time}#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@{WARNING}
#SBATCH --output=slurm-%A_%a.log

if [ -z "${{SLURM_ARRAY_TASK_ID-}}" ]; then
    folder=$(cd "$(dirname "$0")" && pwd) || exit
    self=$folder/$(basename "$0")
    mkdir -p {logs} && cd {logs} || exit
{submit}    exit
fi

{ATTEND}
id=${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID
part=$(($1 + SLURM_ARRAY_TASK_ID))
echo "part $part on $SLURMD_NODENAME, restarts: ${{SLURM_RESTART_COUNT:-0}}"
attend {command}
echo "part $part: exit code $code"
# Stopped in time, with a checkpoint: once more, unless Slurm has decided otherwise.
if [ "$code" -eq 75 ] && [ "$(squeue -h -j "$id" -o %T)" = RUNNING ]; then
    scontrol requeue "$id"
fi
exit "$code"
"#
    ))
}

/// The lines that submit all parts.
fn submit(parts: u64, max_array: u64) -> String {
    if parts <= max_array {
        return format!("    sbatch --array=0-{} \"$@\" \"$self\" 0\n", parts.saturating_sub(1));
    }
    format!(
        r#"    first=0
    while [ "$first" -lt {parts} ]; do
        size=$(({parts} - first))
        [ "$size" -le {max_array} ] || size={max_array}
        sbatch --array="0-$((size - 1))" "$@" "$self" "$first" || exit
        first=$((first + size))
    done
"#
    )
}
