//! GNU parallel: the parts as jobs on the cores of one machine.
//!
//! The log of jobs lies with the parts. With `--resume-failed` parallel starts those parts that
//! are not in it as finished, so the same script goes on after any end. The names reach the jobs
//! through the environment: parallel would replace `{}`, `{.}` and the like in a command.

use super::{Job, quote};

/// Milliseconds from the signal that ends a part to the one that kills it.
const GRACE: u32 = 20_000;

/// The script that runs all parts with GNU parallel.
pub fn parallel(job: &Job) -> String {
    let head = job.head("parallel");
    let (program, plan, dir) = (quote(&job.program), quote(&job.plan), quote(&job.dir));
    let (options, logs, last) = (job.options(), job.logs(), job.parts.saturating_sub(1));
    let share = (100 / u32::from(job.threads.max(1))).max(1);
    format!(
        r#"#!/bin/sh
{head}
export TILEPACK_PROGRAM={program}
export TILEPACK_PLAN={plan}
export TILEPACK_DIR={dir}
export TILEPACK_LOGS={logs}
export PARALLEL_SHELL=/bin/sh
mkdir -p "$TILEPACK_LOGS" && cd "$TILEPACK_LOGS" || exit
seq 0 {last} | parallel --joblog parallel.joblog --resume-failed --jobs {share}% --retries 3 \
    --halt soon,fail=3 --termseq TERM,{GRACE},KILL,1000 "$@" \
    'exec "$TILEPACK_PROGRAM" run "$TILEPACK_PLAN" --part {{}} --dir "$TILEPACK_DIR" {options} >>"$TILEPACK_LOGS/part-{{}}.log" 2>&1'
"#
    )
}
