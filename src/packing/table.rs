//! Tables for inner loops: a length that is a power of two known at compile time.
//!
//! An index is taken modulo the length, which costs one AND, or nothing, where a slice would
//! load its length and compare. Indices are always below the length of what was put in; debug
//! builds check that.

use std::ops::{Index, IndexMut};

/// `L` entries, `L` a power of two.
#[derive(Debug, Clone)]
pub struct Table<T, const L: usize>(Box<[T; L]>);

impl<T: Clone, const L: usize> Table<T, L> {
    /// These values and as many of `rest` as are missing; more than `L` values are cut off.
    pub fn new(mut values: Vec<T>, rest: T) -> Self {
        const { assert!(L.is_power_of_two()) };
        debug_assert!(values.len() <= L);
        values.resize(L, rest);
        match values.into_boxed_slice().try_into() {
            Ok(table) => Self(table),
            Err(_) => unreachable!("the length was just made {L}"),
        }
    }
}

impl<T, const L: usize> Index<usize> for Table<T, L> {
    type Output = T;

    #[inline(always)]
    fn index(&self, index: usize) -> &T {
        debug_assert!(index < L);
        &self.0[index % L]
    }
}

impl<T, const L: usize> IndexMut<usize> for Table<T, L> {
    #[inline(always)]
    fn index_mut(&mut self, index: usize) -> &mut T {
        debug_assert!(index < L);
        &mut self.0[index % L]
    }
}
