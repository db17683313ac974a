//! Sorted words as an automaton: which digits can follow which beginnings.
//!
//! The digits of a column are told apart by their place, so beginnings of equal length with the same
//! ends are one state. From sorted words these are found in one pass (Daciuk, Mihov, Watson,
//! Watson, *Incremental construction of minimal acyclic finite-state automata*, 2000): what the next
//! word does not share with the last one can be frozen.

use super::line::DEAD;
use std::collections::HashMap;

/// The states after some digits: by digit the state in the next layer.
#[derive(Debug, Clone, Default)]
struct Layer {
    states: Vec<Vec<u32>>,
    numbers: HashMap<Vec<u32>, u32>,
}

/// Words of equal length.
#[derive(Debug, Clone)]
pub(super) struct Words {
    layers: Vec<Layer>,
}

impl Words {
    /// From increasing words whose digits, the first one highest, have so many bits.
    pub(super) fn new(sorted: impl Iterator<Item = u64>, bits: &[u32]) -> Self {
        let length = bits.len();
        let mut words = Self { layers: vec![Layer::default(); length + 1] };
        // One end.
        words.layers[length].states.push(Vec::new());
        let digits: Vec<usize> = bits.iter().map(|&bits| 1 << bits).collect();
        let mut open: Vec<Vec<u32>> = digits.iter().map(|&digits| vec![DEAD; digits]).collect();
        // Bits below each digit.
        let mut below = vec![0; length];
        for at in (1..length).rev() {
            below[at - 1] = below[at] + bits[at];
        }
        let digit = |word: u64, at: usize| (word >> below[at]) as usize & (digits[at] - 1);
        let mut last = None;
        for word in sorted {
            let shared = last.map_or(0, |last: u64| {
                let highest = (last ^ word).checked_ilog2().unwrap_or(0);
                below.partition_point(|&below| below > highest)
            });
            if let Some(last) = last {
                words.freeze(&mut open, shared, |at| digit(last, at));
            }
            last = Some(word);
        }
        if let Some(last) = last {
            words.freeze(&mut open, 0, |at| digit(last, at));
            let root = std::mem::take(&mut open[0]);
            words.layers[0].states.push(root);
        }
        words
    }

    /// Gives the states beyond the one after so many digits of the last word their numbers.
    fn freeze(&mut self, open: &mut [Vec<u32>], shared: usize, digit: impl Fn(usize) -> usize) {
        let mut number = 0;
        for at in (shared..open.len()).rev() {
            open[at][digit(at)] = number;
            if at == shared {
                return;
            }
            let layer = &mut self.layers[at];
            number = match layer.numbers.get(&open[at]) {
                Some(&number) => number,
                None => {
                    let number = layer.states.len() as u32;
                    layer.states.push(open[at].clone());
                    layer.numbers.insert(open[at].clone(), number);
                    number
                }
            };
            open[at].fill(DEAD);
        }
    }

    /// States after so many digits.
    pub(super) fn states(&self, digits: usize) -> usize {
        self.layers[digits].states.len()
    }

    /// The state after one more digit.
    pub(super) fn next(&self, digits: usize, state: u32, digit: u32) -> u32 {
        self.layers[digits].states[state as usize][digit as usize]
    }
}
