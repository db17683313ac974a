//! Signals: the first asks a search to stop, the second ends the program at once.
//!
//! The only user of `ctrlc`. It listens to SIGINT (Ctrl-C), SIGTERM and SIGHUP.

use super::exit::Exit;
use std::sync::atomic::{AtomicBool, Ordering};

/// Set by the first signal.
static STOP: AtomicBool = AtomicBool::new(false);

/// Begins to listen; gives the flag that a signal sets, which is a [`crate::search::Stop`].
///
/// # Errors
/// When the system does not let us listen.
pub fn listen() -> anyhow::Result<&'static AtomicBool> {
    ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::SeqCst) {
            std::process::exit(Exit::Stopped.code().into());
        }
    })
    .map_err(|error| anyhow::anyhow!("cannot listen to signals: {error}"))?;
    Ok(&STOP)
}
