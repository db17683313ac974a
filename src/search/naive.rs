//! The oracle: the slow, obvious search that fast ones are tested against.
//!
//! Writes numbers below `values` into an array place by place and keeps the prefixes that a
//! predicate accepts. It shares nothing with the engine.

/// Calls `found` with every array of `places` numbers below `values` all of whose prefixes
/// `accepts`; in lexicographic order.
pub fn search(
    places: usize,
    values: u8,
    accepts: &mut dyn FnMut(&[u8]) -> bool,
    found: &mut dyn FnMut(&[u8]),
) {
    extend(&mut Vec::with_capacity(places), places, values, accepts, found);
}

fn extend(
    prefix: &mut Vec<u8>,
    places: usize,
    values: u8,
    accepts: &mut dyn FnMut(&[u8]) -> bool,
    found: &mut dyn FnMut(&[u8]),
) {
    if prefix.len() == places {
        return found(prefix);
    }
    for value in 0..values {
        prefix.push(value);
        if accepts(prefix) {
            extend(prefix, places, values, accepts, found);
        }
        prefix.pop();
    }
}
