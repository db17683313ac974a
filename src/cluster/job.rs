//! What a job file is made of: the plan, its parts, and the command for one of them.
//!
//! Each job file is a POSIX shell script which, run once, gives all parts of a plan to a scheduler.
//! What makes it simple is the contract of `tilepack run`: a part may be run any number of times; a
//! finished one ends at once with 0, an unfinished one goes on from its checkpoint, and 75 means
//! stopped, run again. So whatever fails, the remedy is to run the same script again.
//!
//! Pure text: no files, no processes. Paths are absolute, so that the script can be run from any
//! folder, and quoted, so that they may contain anything.

use super::shell::quote;

/// The parts of a plan, and how each is run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Job {
    /// The program: a name to be found on the path of the nodes, or an absolute path.
    pub program: String,
    /// The plan, an absolute path.
    pub plan: String,
    /// Where the parts keep their checkpoints and results, an absolute path.
    pub dir: String,
    /// How many parts there are, at least one; they are numbered from 0.
    pub parts: u64,
    /// Threads of one part, at least one.
    pub threads: u16,
    /// Time from one checkpoint to the next as the program reads it; its default if there is none.
    pub checkpoint_every: Option<String>,
}

impl Job {
    /// The command that runs the part whose number the shell word `part` gives.
    pub(super) fn command(&self, part: &str) -> String {
        let (program, plan, dir) = (quote(&self.program), quote(&self.plan), quote(&self.dir));
        format!("{program} run {plan} --part {part} --dir {dir} {}", self.options())
    }

    /// The options of the command that are the same for all parts and need no quotes.
    pub(super) fn options(&self) -> String {
        let every = match &self.checkpoint_every {
            Some(time) => format!(" --checkpoint-every {}", quote(time)),
            None => String::new(),
        };
        format!("--threads {}{every} --quiet", self.threads)
    }

    /// The shell word for the folder with the logs.
    pub(super) fn logs(&self) -> String {
        quote(&format!("{}/logs", self.dir.trim_end_matches('/')))
    }

    /// The first lines of a script: what it does, and what to do with it.
    pub(super) fn head(&self, scheduler: &str) -> String {
        let parts = match self.parts {
            1 => "The only part".into(),
            parts => format!("All {parts} parts"),
        };
        format!(
            "# {parts} of a tilepack plan. Run this file with sh; options given to it go to\n\
             # {scheduler}. Run it again when parts are missing: finished ones end at once, the\n\
             # others go on from their checkpoints.\n"
        )
    }
}

/// Why a job file cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ClusterError {
    /// The name of a folder means something else to Slurm.
    #[error(
        "{0}: Slurm replaces % and \\ in the names of log files, so the folder of the parts must \
         have neither; choose another with --dir"
    )]
    SlurmFolder(String),
}
