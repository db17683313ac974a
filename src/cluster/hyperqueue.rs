//! HyperQueue: one job with an array of tasks, the task's number being that of the part.
//!
//! Run by a user, the script submits itself; run by a worker, it runs one part. HyperQueue starts
//! a task again when its worker is lost, but not when it exits with 75; so the script does that.
//! The task of a worker that died gets SIGTERM and may still be writing its checkpoint when
//! another worker starts the part anew, which therefore waits a little.

use super::Job;
use super::shell::ATTEND;

/// Workers that a part may lose; with the 5 of HyperQueue a run of weeks could fail.
const CRASHES: u32 = 100;

/// The script that submits and runs all parts with HyperQueue.
pub fn hyperqueue(job: &Job) -> String {
    let head = job.head("hq submit");
    let (threads, logs, last) = (job.threads, job.logs(), job.parts.saturating_sub(1));
    let command = job.command(r#""$HQ_TASK_ID""#);
    format!(
        r#"#!/bin/sh
{head}# Keep it where the workers can read it until all parts are finished.

if [ -z "${{HQ_TASK_ID-}}" ]; then
    folder=$(cd "$(dirname "$0")" && pwd) || exit
    self=$folder/$(basename "$0")
    mkdir -p {logs} || exit
    exec hq submit --name=tilepack --array=0-{last} --cpus={threads} --crash-limit={CRASHES} \
        --stdout=none --stderr=none "$@" -- sh "$self"
fi

{ATTEND}
exec >>{logs}/"part-$HQ_TASK_ID.log" 2>&1
[ "$HQ_INSTANCE_ID" -eq 0 ] || sleep 5
while :; do
    echo "part $HQ_TASK_ID on $(uname -n), instance $HQ_INSTANCE_ID"
    attend {command}
    echo "part $HQ_TASK_ID: exit code $code"
    [ "$code" -eq 75 ] || exit "$code"
    # Stopped, with a checkpoint. If the worker is gone, too, the part goes on elsewhere.
    sleep 5
    kill -0 "$PPID" 2>/dev/null || exit 75
done
"#
    )
}
