//! Searches in parts: whatever the parts, together they are the undivided search.
//!
//! The laws of parts are tried on the library, with random trees and problems of every kind; the
//! commands `plan`, `run` and `merge` as users and schedulers meet them.

#![allow(clippy::unwrap_used, clippy::panic)]

mod answers;
mod damage;
mod jobs;
mod law;
mod merging;
mod running;
mod spread;
mod trees;

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use tempfile::TempDir;
use tilepack::packing::{self, Settings};
use tilepack::store::{PartResult, SearchPlan};

/// What a run of the program came to.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Run {
    /// Standard output as one JSON object on one line.
    #[track_caller]
    pub(crate) fn json(&self) -> Value {
        assert_eq!(self.stdout.lines().count(), 1, "{self:?}");
        serde_json::from_str(&self.stdout).unwrap()
    }

    #[track_caller]
    pub(crate) fn exits(self, code: i32) -> Self {
        assert_eq!(self.code, code, "{self:#?}");
        self
    }

    /// Standard error says all of this.
    #[track_caller]
    pub(crate) fn says(self, words: &[&str]) -> Self {
        for word in words {
            assert!(self.stderr.contains(word), "{word:?}: {self:#?}");
        }
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

    pub(crate) fn bytes(&self, file: &str) -> Vec<u8> {
        std::fs::read(self.path(file)).unwrap()
    }

    pub(crate) fn write(&self, file: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(file), content).unwrap();
    }

    pub(crate) fn copy(&self, from: &str, to: &str) {
        std::fs::copy(self.path(from), self.path(to)).unwrap();
    }

    /// Runs the program with arguments separated by blanks.
    pub(crate) fn run(&self, args: &str) -> Run {
        self.start(args).wait_with_output().unwrap().into()
    }

    /// Starts the program.
    pub(crate) fn start(&self, args: &str) -> Child {
        Command::new(assert_cmd::cargo::cargo_bin!("tilepack"))
            .current_dir(self.0.path())
            .args(args.split_whitespace())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// Plans a search in so many parts; gives the plan.
    #[track_caller]
    pub(crate) fn plan(&self, problem: &str, parts: u64, file: &str) -> SearchPlan {
        self.run(&format!("plan {problem} --parts {parts} -o {file}")).exits(0);
        SearchPlan::read(&self.path(file)).unwrap()
    }

    /// Runs all parts of a plan.
    #[track_caller]
    pub(crate) fn run_all(&self, file: &str, parts: u64) {
        for part in 0..parts {
            let run = self.run(&format!("run {file} --part {part} --quiet --threads 1")).exits(0);
            assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""));
        }
    }
}

/// The result of a part, without a file.
pub(crate) fn result(plan: &SearchPlan, number: u64) -> PartResult {
    let standing = packing::run(&plan.part(number), None, &Settings::PLAIN).unwrap();
    assert!(standing.is_complete());
    let (plan, of) = (plan.name.clone(), plan.parts);
    PartResult { plan, number, of, standing, kept: None, version: "0.1.0".into() }
}

/// The fields of an object that do not depend on how fast it went.
pub(crate) fn lasting(mut object: Value) -> Value {
    object.as_object_mut().unwrap().remove("seconds").unwrap();
    object
}
