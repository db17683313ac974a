//! Strips that overlap: where each begins, and what their slices have in common.

use super::board::Board;
use super::machine::Machine;
use std::collections::HashMap;

/// What slices have in common.
#[derive(Debug)]
pub(super) struct Overlap {
    /// How many contents there are.
    pub contents: usize,
    /// By slice of the first strip: the content of its last lines.
    pub tail: Vec<u32>,
    /// By slice of the second strip: the content of its first lines.
    pub head: Vec<u32>,
}

impl Overlap {
    /// Of strips that have so many lines in common.
    pub(super) fn new(machine: &Machine, lines: usize) -> Self {
        let mut numbers = HashMap::new();
        let mut number = |tiles: &[u8]| {
            let next = numbers.len() as u32;
            *numbers.entry(tiles.to_vec()).or_insert(next)
        };
        let slices = machine.slices.iter();
        let tail = slices.map(|slice| number(&slice[slice.len() - lines..])).collect();
        let head = machine.slices.iter().map(|slice| number(&slice[..lines])).collect();
        Self { contents: numbers.len(), tail, head }
    }
}

/// The first lines of strips of which each begins `stride` lines after the one before.
pub(super) fn firsts(board: &Board, along: usize, lines: usize, stride: usize) -> Vec<usize> {
    let all = board.lines(along);
    if board.meet[1 - along] && lines < all {
        return (0..all).step_by(stride).collect();
    }
    (0..all - lines).step_by(stride).chain([all - lines]).collect()
}
