//! The program `tilepack`: parse, run, exit code. What it does is in [`tilepack::cli`].

use std::process::ExitCode;

fn main() -> ExitCode {
    tilepack::cli::run().into()
}
