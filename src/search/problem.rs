//! What a search walks over.

use super::{Alternatives, Bounds, Sprint, Stretch, Visited};

/// A tree of choices: at each of a fixed number of levels one of a set of alternatives.
///
/// A value of this type is the state after the choices made so far. `push` and `pop` are exact
/// inverses: after `pop` the problem answers as before the `push`. There is no I/O, clock,
/// thread or randomness in a problem; cloning gives an independent copy.
///
/// What must be extended when a level gets more state: only what `push` changes, so that a
/// [`Path`](super::Path) of choices alone restores it.
pub trait Problem: Clone + Send + Sync {
    /// The type of a set of alternatives.
    type Alternatives: Alternatives;

    /// The number of levels; a path of that many choices is a solution.
    fn levels(&self) -> usize;

    /// The valid alternatives at `level`, when exactly the levels below it have been pushed.
    /// Leaves the state as it was.
    fn alternatives(&mut self, level: usize) -> Self::Alternatives;

    /// Commits one of the alternatives of `level`.
    fn push(&mut self, level: usize, choice: u32);

    /// Takes back the choice last pushed, which was `choice` at `level`.
    fn pop(&mut self, level: usize, choice: u32);

    /// Nodes of the first slice of a walk: fewer where a node takes long.
    const FIRST_SLICE: u64 = 1 << 10;

    /// Whether [`Problem::sprint`] may ever do something.
    const SPRINTS: bool = false;

    /// Walks on by itself, smallest alternatives first; `None` when it leaves that to the walk.
    /// Afterwards the problem stands where [`Sprint::level`] and the choices of the stretch say.
    fn sprint(&mut self, stretch: Stretch<'_, Self::Alternatives>) -> Option<Sprint> {
        let _ = stretch;
        None
    }

    /// The first level at which [`Problem::gather`] may ever do something, if there is one.
    fn gathers_from(&self) -> Option<usize> {
        None
    }

    /// Puts the node where it stands, at `level`, into a batch; false when that cannot be.
    fn gather(&mut self, level: usize) -> bool {
        let _ = level;
        false
    }

    /// Visits all below the nodes gathered; afterwards there are none. The problem stays where
    /// it stands.
    ///
    /// # Errors
    /// When the bounds do not allow it: how many nodes were visited in vain.
    fn expand(&mut self, bounds: Bounds) -> Result<Visited, u64> {
        let _ = bounds;
        Ok(Visited::default())
    }
}
