//! Long searches: whatever happens to the process or its files, nothing counts twice and nothing
//! is lost but the time since the last checkpoint.
//!
//! The program runs as its users run it, in a folder of its own, and is killed, starved of disk
//! and given damaged files. What must come out in the end is what an undisturbed run gives.

#![allow(clippy::unwrap_used, clippy::panic)]

mod damage;
mod disk;
mod golden;
mod kills;
mod others;
mod status;

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use tempfile::TempDir;

/// A folder in which the program runs.
pub(crate) struct Place(TempDir);

/// What a run of the program came to.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Place {
    pub(crate) fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub(crate) fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    /// The names of all files, sorted.
    pub(crate) fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The program with arguments separated by blanks.
    pub(crate) fn command(&self, args: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("tilepack"));
        command.current_dir(self.0.path()).args(args.split_whitespace());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    pub(crate) fn start(&self, args: &str) -> Child {
        self.command(args).spawn().unwrap()
    }

    pub(crate) fn run(&self, args: &str) -> Run {
        Run::of(self.command(args).output().unwrap())
    }

    /// A command line of the shell, in which `tilepack` is the program.
    #[cfg(unix)]
    pub(crate) fn shell(&self, script: &str) -> Run {
        let mut shell = Command::new("sh");
        let binary = assert_cmd::cargo::cargo_bin!("tilepack");
        let script = script.replace("tilepack", &format!("'{}'", binary.display()));
        Run::of(shell.arg("-c").arg(script).current_dir(self.0.path()).output().unwrap())
    }
}

impl Run {
    pub(crate) fn of(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    #[track_caller]
    pub(crate) fn exits(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{self:#?}");
        self
    }

    /// Standard output as one JSON object.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error}: {self:#?}"))
    }
}

/// A field of an object as text.
#[track_caller]
pub(crate) fn text(object: &Value, field: &str) -> String {
    match &object[field] {
        Value::String(text) => text.clone(),
        other => panic!("{field}: {other} in {object}"),
    }
}

/// Sends a signal.
#[cfg(unix)]
pub(crate) fn signal(child: &Child, name: &str) {
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-s", name, &pid]).status().unwrap().success());
}

/// Numbers that look random.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 31)).wrapping_mul(0x7fb5_d329_728e_a185);
        (x ^ (x >> 29)) % bound
    }
}

/// A grid that gives a row begun with 0 0 0, on a 9x9 torus.
pub(crate) const PINS: &str = "0 0 0 . . . . . .
. . . . . . . . .\n. . . . . . . . .\n. . . . . . . . .\n. . . . . . . . .
. . . . . . . . .\n. . . . . . . . .\n. . . . . . . . .\n. . . . . . . . .\n";

/// A list of 11,232 packings that takes a second or two.
pub(crate) const LIST: &str =
    "list --kind corner --colors 3 --automorphism 3,0:+1 --pin pins.txt --quiet";
/// So many.
pub(crate) const LISTED: usize = 11_232;
