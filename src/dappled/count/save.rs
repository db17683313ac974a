//! A count as bytes, so that it can be gone on with.
//!
//! Words of 64 bits, little-endian: `0`, steps done, limbs, counts, the limbs on top, states in all,
//! then blocks of states and their limbs; or `1`, starts done, counts, and for each count the number
//! of its limbs and these; or, for one that is done, the same with `2`. What the count is of is not in
//! it.

use super::table::{Chunk, Table, number_of};
use super::{Counting, Work};
use num_bigint::BigUint;
use std::io::{self, Read, Write};

/// States in a block at most.
const BLOCK: usize = 1 << 16;

fn write_words(out: &mut dyn Write, words: &[u64]) -> io::Result<()> {
    let mut bytes = Vec::with_capacity(8 * words.len().min(BLOCK));
    for words in words.chunks(BLOCK) {
        bytes.clear();
        bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
        out.write_all(&bytes)?;
    }
    Ok(())
}

fn read_words(input: &mut dyn Read, count: usize) -> io::Result<Vec<u64>> {
    let mut words = Vec::with_capacity(count.min(1 << 24));
    let mut bytes = vec![0; 8 * count.min(BLOCK)];
    while words.len() < count {
        let part = 8 * (count - words.len()).min(BLOCK);
        input.read_exact(&mut bytes[..part])?;
        let word = |bytes: &[u8]| bytes.iter().rev().fold(0, |word, &b| word << 8 | u64::from(b));
        words.extend(bytes[..part].chunks_exact(8).map(word));
    }
    Ok(words)
}

fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what.to_owned())
}

/// Counts at most: one more than cells.
const MOST_COUNTS: u64 = 1 << 31;

fn numbers_bytes(numbers: &[BigUint]) -> u64 {
    let limbs = numbers.iter().map(|number| 8 + 8 * number.iter_u64_digits().len() as u64);
    24 + limbs.sum::<u64>()
}

fn write_numbers(out: &mut dyn Write, head: [u64; 2], numbers: &[BigUint]) -> io::Result<()> {
    write_words(out, &[head[0], head[1], numbers.len() as u64])?;
    for number in numbers {
        let limbs: Vec<u64> = number.iter_u64_digits().collect();
        write_words(out, &[limbs.len() as u64])?;
        write_words(out, &limbs)?;
    }
    Ok(())
}

fn read_numbers(input: &mut dyn Read) -> io::Result<Vec<BigUint>> {
    let counts = read_words(input, 1)?[0];
    if counts > MOST_COUNTS {
        return Err(wrong("too many numbers"));
    }
    let mut numbers = Vec::new();
    for _ in 0..counts {
        let limbs = read_words(input, 1)?[0];
        numbers.push(number_of(&read_words(input, limbs as usize)?));
    }
    Ok(numbers)
}

impl Counting {
    /// How many bytes [`Counting::save`] writes.
    pub fn saved_bytes(&self) -> u64 {
        match &self.work {
            _ if self.is_done() => numbers_bytes(&self.numbers()),
            Work::Once(sweep) => (48 + sweep.standing().1.bytes()) as u64,
            Work::Turns(turns) => numbers_bytes(&turns.numbers),
            Work::Done(numbers) => numbers_bytes(numbers),
        }
    }

    /// Writes what the count stands at.
    ///
    /// # Errors
    /// What writing reports.
    pub fn save(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.work {
            _ if self.is_done() => write_numbers(out, [2, 0], &self.numbers()),
            Work::Once(sweep) => {
                let (done, table) = sweep.standing();
                let (limbs, counts) = (table.limbs as u64, table.counts as u64);
                let head = [0, done as u64, limbs, counts, table.highest, table.len() as u64];
                write_words(out, &head)?;
                // Blocks go across chunks, so that threads make no difference.
                let (mut states, mut numbers) = (Vec::new(), Vec::new());
                for (state, number) in table.iter() {
                    states.push(state);
                    numbers.extend_from_slice(number);
                    if states.len() == BLOCK {
                        write_words(out, &states)?;
                        write_words(out, &numbers)?;
                        states.clear();
                        numbers.clear();
                    }
                }
                write_words(out, &states)?;
                write_words(out, &numbers)
            }
            Work::Turns(turns) => write_numbers(out, [1, turns.done as u64], &turns.numbers),
            Work::Done(numbers) => write_numbers(out, [2, 0], numbers),
        }
    }

    /// Goes on from what was saved of the same count.
    ///
    /// # Errors
    /// What reading reports, or bytes of another count; then nothing has changed.
    pub fn restore(&mut self, input: &mut dyn Read) -> io::Result<()> {
        let head = read_words(input, 2)?;
        match (&mut self.work, head[0]) {
            (work, 2) => {
                *work = Work::Done(read_numbers(input)?);
                Ok(())
            }
            (Work::Once(sweep), 0) => {
                let table = read_table(input)?;
                if !sweep.accepts(head[1] as usize, &table) {
                    return Err(wrong("states of another count"));
                }
                sweep.restore(head[1] as usize, table);
                Ok(())
            }
            (Work::Turns(turns), 1) if head[1] <= turns.starts.len() as u64 => {
                let numbers = read_numbers(input)?;
                if numbers.len() != turns.numbers.len() {
                    return Err(wrong("numbers of another count"));
                }
                (turns.done, turns.numbers) = (head[1] as usize, numbers);
                Ok(())
            }
            _ => Err(wrong("the count of another rectangle")),
        }
    }
}

fn read_table(input: &mut dyn Read) -> io::Result<Table> {
    let head: Vec<usize> = read_words(input, 4)?.into_iter().map(|word| word as usize).collect();
    let (limbs, counts, mut left) = (head[0], head[1], head[3]);
    let stride = limbs.checked_mul(counts).filter(|&stride| (1..1 << 32).contains(&stride));
    let stride = stride.ok_or_else(|| wrong("numbers without limbs"))?;
    let mut chunks = Vec::new();
    while left > 0 {
        let block = left.min(BLOCK);
        let states = read_words(input, block)?;
        chunks.push(Chunk { states, numbers: read_words(input, block * stride)? });
        left -= block;
    }
    Ok(Table { chunks, limbs, counts, highest: head[2] as u64 })
}
