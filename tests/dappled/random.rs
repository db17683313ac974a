//! Numbers for tests: small, and the same everywhere.

use tilepack::dappled::make::start::mixed;

/// The numbers of a seed, one after the other.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 = mixed(self.0, 0x5eed);
        (self.0 >> 33) as usize % end
    }
}
