//! The program as users and scripts meet it: what it prints where, exit codes, files, signals.
//!
//! Options, JSON fields and exit codes are a contract, so they are spelled out here.

#![allow(clippy::unwrap_used, clippy::panic)]

mod bad_input;
mod beam;
mod construct;
mod count;
mod cover;
mod cube;
mod estimate;
mod export;
mod files;
mod find;
mod list;
mod pipes;
mod portfolio;
mod recursive;
mod restarts;
mod rows;
mod sets;
mod shader;
mod show;
mod stopping;
mod tile;
mod verify;
mod walk;

use serde_json::Value;
use std::ffi::OsStr;
use std::path::PathBuf;
use tempfile::TempDir;

/// What a run of the program came to.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    /// Standard output as one JSON object on one line.
    pub(crate) fn json(&self) -> Value {
        assert_eq!(self.stdout.lines().count(), 1, "{self:?}");
        serde_json::from_str(&self.stdout).unwrap()
    }

    #[track_caller]
    pub(crate) fn exits(self, code: i32) -> Self {
        assert_eq!(self.code, code, "{self:#?}");
        self
    }
}

/// A directory in which the program runs.
pub(crate) struct Place(TempDir);

impl Place {
    pub(crate) fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub(crate) fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    pub(crate) fn write(&self, file: &str, content: impl AsRef<[u8]>) -> &Self {
        std::fs::write(self.path(file), content).unwrap();
        self
    }

    pub(crate) fn read(&self, file: &str) -> String {
        std::fs::read_to_string(self.path(file)).unwrap()
    }

    /// Runs the program with arguments separated by blanks.
    pub(crate) fn run(&self, args: &str) -> Run {
        self.run_with(args.split_whitespace(), "")
    }

    /// Runs the program with something on standard input.
    pub(crate) fn feed(&self, args: &str, stdin: &str) -> Run {
        self.run_with(args.split_whitespace(), stdin)
    }

    pub(crate) fn run_with<S: AsRef<OsStr>>(
        &self,
        args: impl IntoIterator<Item = S>,
        stdin: &str,
    ) -> Run {
        let mut command = assert_cmd::cargo::cargo_bin_cmd!("tilepack");
        let command = command.current_dir(self.0.path()).env_remove("NO_COLOR");
        let output = command.args(args).write_stdin(stdin).output().unwrap();
        Run {
            code: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

/// Runs the program where no file is needed.
pub(crate) fn run(args: &str) -> Run {
    Place::new().run(args)
}

/// The names of the fields of an object, sorted.
pub(crate) fn names(object: &Value) -> Vec<&str> {
    let mut names: Vec<&str> = object.as_object().unwrap().keys().map(String::as_str).collect();
    names.sort_unstable();
    names
}

/// The one packing of the complete corner set over two colors.
pub(crate) const CORNER_2: &str = "kind=corner colors=2\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1\n";
