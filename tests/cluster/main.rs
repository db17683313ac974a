//! The parts of a plan as jobs of schedulers: the texts of the job files, and the schedulers
//! themselves, started here, with a node, a worker or a part killed while it counts.
//!
//! Where a scheduler is not installed its test says so and passes; `.ci/run` installs all three.

#![allow(clippy::unwrap_used, clippy::panic)]

#[cfg(target_os = "linux")]
mod hyperqueue;
#[cfg(target_os = "linux")]
mod parallel;
#[cfg(target_os = "linux")]
mod processes;
#[cfg(target_os = "linux")]
mod slurm;
mod text;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Long enough for a part to be killed while it counts: some 20 seconds of one core in all.
const PROBLEM: &str = "--kind corner --colors 3 --automorphism 3,0:+1 --plain";
/// Its packings.
const PACKINGS: &str = "303264";
/// Its parts: each takes some seconds beside three others, so that it is still at work when a test
/// has seen what it waits for.
const PARTS: u64 = 8;

/// The program under test.
const PROGRAM: &str = env!("CARGO_BIN_EXE_tilepack");

/// A folder with a plan, and a name that a script has to quote.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        let place = Self(tempfile::Builder::new().prefix("tile pack's $x").tempdir().unwrap());
        let plan = format!("plan {PROBLEM} --parts {PARTS} -o");
        let mut command = place.tilepack(&plan);
        let output = command.arg(place.plan()).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        place
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn plan(&self) -> PathBuf {
        self.path("plan.json")
    }

    /// The program with arguments separated by blanks.
    fn tilepack(&self, args: &str) -> Command {
        let mut command = Command::new(PROGRAM);
        command.args(args.split_whitespace()).current_dir(self.0.path());
        command
    }

    /// Writes the job file for a scheduler.
    fn script(&self, scheduler: &str) -> PathBuf {
        let script = self.path("job file");
        let mut command = self.tilepack(&format!("cluster {scheduler} plan.json --program"));
        let command = command.arg(PROGRAM).args(["--checkpoint-every", "200ms", "-o"]);
        let output = command.arg(&script).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        script
    }

    /// The exit code of a merge, and what it said.
    fn merge(&self) -> (i32, String) {
        said(&self.tilepack("merge plan.json --json").output().unwrap())
    }

    /// The merged count is that of the whole problem.
    #[track_caller]
    fn counts(&self) {
        let (code, said) = self.merge();
        assert!(code == 0 && said.contains(&format!("\"solutions\":\"{PACKINGS}\"")), "{said}");
    }

    /// Whether a part has saved what it did so far, and is not done.
    fn has_checkpoint(&self, part: u64) -> bool {
        self.path(&format!("plan.json.parts/part-{part}.checkpoint")).exists()
    }

    /// The logs of all parts, sorted by their names.
    fn logs(&self) -> Vec<(String, String)> {
        let mut logs = Vec::new();
        for file in fs::read_dir(self.path("plan.json.parts/logs")).into_iter().flatten() {
            let file = file.unwrap();
            let content = fs::read(file.path()).unwrap();
            let name = file.file_name().into_string().unwrap();
            logs.push((name, String::from_utf8_lossy(&content).into_owned()));
        }
        logs.sort();
        logs
    }
}

/// The exit code and all that was printed.
fn said(output: &Output) -> (i32, String) {
    let text = [&output.stdout[..], &output.stderr].concat();
    (output.status.code().unwrap_or(-1), String::from_utf8_lossy(&text).into_owned())
}

/// Where a program is on the path, or where Debian keeps daemons.
fn find(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    folders.extend(["/usr/sbin", "/sbin"].map(PathBuf::from));
    folders.iter().map(|folder| folder.join(program)).find(|file| file.is_file())
}

/// Says that a test is skipped; not by a macro, whose output is shown for failed tests only.
fn skip(why: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {why}");
}

/// Waits until something is so.
#[track_caller]
fn wait(seconds: u64, what: &str, mut so: impl FnMut() -> bool, state: impl Fn() -> String) {
    let begin = Instant::now();
    while !so() {
        if begin.elapsed() > Duration::from_secs(seconds) {
            panic!("waited {seconds} s in vain until {what}:\n{}", state());
        }
        std::thread::sleep(Duration::from_millis(100));
    }
}

/// Runs a script with sh in another folder than its own.
fn sh(script: &Path) -> Command {
    let mut command = Command::new("sh");
    command.arg(script).current_dir("/");
    command
}
