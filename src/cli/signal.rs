//! Signals: the first asks a search to stop; one that comes later, when that took too long, ends
//! the program at once.
//!
//! Schedulers like to send a signal to all processes of a job and to each of them, so those that
//! follow closely mean the same as the first: the search is given time to save itself.
//!
//! The only user of `ctrlc`. It listens to SIGINT (Ctrl-C), SIGTERM and SIGHUP.

use super::exit::Exit;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Set by the first signal.
static STOP: AtomicBool = AtomicBool::new(false);
/// When that was.
static FIRST: OnceLock<Instant> = OnceLock::new();
/// What a search is given to stop and save itself, which takes well under a second.
const GRACE: Duration = Duration::from_secs(3);

/// Begins to listen; gives the flag that a signal sets, which is a [`crate::search::Stop`].
///
/// # Errors
/// When the system does not let us listen.
pub fn listen() -> anyhow::Result<&'static AtomicBool> {
    ctrlc::set_handler(|| {
        STOP.store(true, Ordering::SeqCst);
        if FIRST.get_or_init(Instant::now).elapsed() > GRACE {
            std::process::exit(Exit::Stopped.code().into());
        }
    })
    .map_err(|error| anyhow::anyhow!("cannot listen to signals: {error}"))?;
    Ok(&STOP)
}
