//! The program, as users run it.

use assert_cmd::Command;
use tempfile::TempDir;

/// Runs it in a folder: exit code, standard output, standard error.
pub(crate) fn run(place: &TempDir, args: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tilepack"));
    let output = command.args(args.split_whitespace()).current_dir(place).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}
