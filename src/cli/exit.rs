//! Exit codes: what a script learns without reading a word.

use std::process::ExitCode;

/// How the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// Done, and the answer is yes: found, valid, counted.
    Yes,
    /// Done, and the answer is no: not a packing, none exists.
    No,
    /// Wrong usage, or input that cannot be read, understood or reconciled.
    Bad,
    /// Stopped early by a signal or a limit.
    Stopped,
}

impl Exit {
    /// Yes or no.
    pub fn of(yes: bool) -> Self {
        if yes { Exit::Yes } else { Exit::No }
    }

    /// The number that the shell sees.
    pub fn code(self) -> u8 {
        match self {
            Exit::Yes => 0,
            Exit::No => 1,
            Exit::Bad => 2,
            // EX_TEMPFAIL of sysexits.h: try again.
            Exit::Stopped => 75,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        exit.code().into()
    }
}
