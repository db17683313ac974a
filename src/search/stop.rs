//! When to stop before the end: a deadline, a flag that a signal sets, a number of nodes.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Something that may ask a search to stop. It is asked some twenty times a second.
pub trait Stop: Sync {
    /// Whether to stop now.
    fn should_stop(&self) -> bool;
}

/// Never asks to stop.
impl Stop for () {
    fn should_stop(&self) -> bool {
        false
    }
}

/// Asks to stop once the flag is set.
impl Stop for AtomicBool {
    fn should_stop(&self) -> bool {
        self.load(Ordering::Relaxed)
    }
}

/// Asks to stop from this moment on.
impl Stop for Instant {
    fn should_stop(&self) -> bool {
        Instant::now() >= *self
    }
}

impl<S: Stop> Stop for Option<S> {
    fn should_stop(&self) -> bool {
        self.as_ref().is_some_and(Stop::should_stop)
    }
}

impl<S: Stop, T: Stop> Stop for (S, T) {
    fn should_stop(&self) -> bool {
        self.0.should_stop() || self.1.should_stop()
    }
}

impl<S: Stop + ?Sized> Stop for &S {
    fn should_stop(&self) -> bool {
        (**self).should_stop()
    }
}

/// Everything that bounds a search.
#[derive(Clone, Copy)]
pub struct Limits<'a> {
    /// Asked regularly.
    pub stop: &'a dyn Stop,
    /// Nodes over all threads.
    pub nodes: u64,
}

impl Limits<'_> {
    /// No limit at all.
    pub const NONE: Limits<'static> = Limits { stop: &(), nodes: u64::MAX };
}
