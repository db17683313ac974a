//! Descents one after the other, or several at a time, until one finds a packing: a race that the
//! lowest number wins.

use super::descent::Beam;
use super::rule::Rule;
use crate::search::{Limits, Race, Turn, race};

/// Descends until a packing, in plain colors, is found, `most` times have been in vain or the
/// limits say stop.
pub(super) fn run<R: Rule>(
    beam: &Beam<'_, R>,
    most: u64,
    threads: usize,
    limits: &Limits<'_>,
) -> Race<Vec<u8>> {
    race(most, threads, limits, || {
        |turn: &Turn<'_>| beam.descend(turn.number, |nodes| turn.visited(nodes))
    })
}
