//! `verify --recursive`: what is told about the blocks of packings.
//!
//! Packings that are right but not recursive are told like those that are not right, one by one up
//! to a number of them; of a single packing that is recursive the blocks are named.

use super::verify::TOLD;
use crate::verify::{Block, NotRecursive, Recursion};
use std::io::{self, Write};

/// How recursive the packings of a file are.
#[derive(Default)]
pub struct Recursive {
    /// The blocks of the first packing.
    blocks: Vec<Block>,
    /// The least number of blocks.
    least: Option<usize>,
    /// Packings that are not recursive.
    failed: u64,
    /// The first of those: number, line, why.
    bad: Vec<(u64, usize, NotRecursive)>,
}

impl Recursive {
    /// How many are not recursive.
    pub(super) fn failed(&self) -> u64 {
        self.failed
    }

    /// The least number of blocks; `None` before any packing.
    pub(super) fn least(&self) -> Option<usize> {
        self.least
    }

    /// Adds the packing of this number and line.
    pub(super) fn add(&mut self, number: u64, line: usize, recursion: Recursion) {
        let depth = recursion.blocks.len();
        self.least = Some(self.least.map_or(depth, |least| least.min(depth)));
        if number == 1 {
            self.blocks = recursion.blocks;
        }
        if let Some(fault) = recursion.fault {
            self.failed += 1;
            if self.bad.len() < TOLD {
                self.bad.push((number, line, fault));
            }
        }
    }

    /// Tells the packings that are not recursive.
    pub(super) fn print(&self, out: &mut dyn Write, name: &str, packings: u64) -> io::Result<()> {
        for (number, line, fault) in &self.bad {
            match packings {
                1 => writeln!(out, "{name}: a packing, but not recursive: {fault}")?,
                _ => {
                    writeln!(out, "{name}: packing {number}, line {line}: not recursive: {fault}")?
                }
            }
        }
        match self.failed - self.bad.len() as u64 {
            0 => Ok(()),
            untold => writeln!(out, "{name}: {untold} more that are not recursive"),
        }
    }

    /// What is added to the words about a valid packing.
    pub(super) fn words(&self) -> String {
        let blocks: Vec<String> = self.blocks.iter().map(Block::to_string).collect();
        match blocks.is_empty() {
            true => "; recursive, without blocks".to_owned(),
            false => format!("; recursive: {}", blocks.join("; ")),
        }
    }

    /// Why the first of them is not.
    pub(super) fn error(&self, packings: u64) -> Option<String> {
        let (number, line, fault) = self.bad.first()?;
        Some(match packings {
            1 => format!("not recursive: {fault}"),
            _ => format!("packing {number}, line {line}: not recursive: {fault}"),
        })
    }
}
