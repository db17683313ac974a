//! Powers of a set of tiles, as transducers.
//!
//! A Wang set is a machine with E and W labels as states: at a tile it reads N, writes S and
//! goes from W to E. What its k-th power writes below k rows is read above the next. Three steps
//! keep powers small:
//!
//! * An arc on no cycle of states is cut: a row takes such arcs only finitely often, so far away
//!   there are patches of any size without them, and by compactness a tiling without them.
//! * So is an arc on no cycle of labels, from what it reads to what it writes, for columns.
//! * States from which the same can be read and written are merged (bisimulation), as are those
//!   to which the same leads. That leaves all double infinite rows as they are.
//!
//! A power without arcs refutes every tiling. A cycle that writes what it reads gives a tiling
//! with a period downward; the row is then read by finitely many states, so it has one with a
//! period along, too. Source: Jeandel and Rao, *An aperiodic set of 11 Wang tiles*, Advances in
//! Combinatorics 2021:1, section 3.

use super::cycles::on_cycles;
use super::form::{Tile, labels};

/// From a state to another one, reading and writing a label.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Arc {
    from: u32,
    to: u32,
    read: u32,
    write: u32,
}

/// A power, cut and merged.
#[derive(Debug, Clone)]
pub struct Power {
    arcs: Vec<Arc>,
    states: usize,
    labels: usize,
}

impl Power {
    /// The first one.
    pub fn first(tiles: &[Tile]) -> Self {
        let arcs = tiles.iter().map(|&[read, to, write, from]| Arc { from, to, read, write });
        let (labels, states) = labels(tiles);
        let mut power = Self { arcs: arcs.collect(), states, labels };
        power.reduce();
        power
    }

    /// Whether nothing is left: there is no tiling of the plane.
    pub fn is_empty(&self) -> bool {
        self.arcs.is_empty()
    }

    /// Arcs.
    pub fn len(&self) -> usize {
        self.arcs.len()
    }

    /// Whether a cycle writes what it reads.
    pub fn repeats(&self) -> bool {
        let same = self.arcs.iter().filter(|arc| arc.read == arc.write);
        let arcs: Vec<(u32, u32)> = same.map(|arc| (arc.from, arc.to)).collect();
        on_cycles(self.states, &arcs).contains(&true)
    }

    /// Arcs of the product with another power, before they are cut.
    pub fn product_len(&self, below: &Power) -> u64 {
        let mut readers = vec![0u64; self.labels];
        below.arcs.iter().for_each(|arc| readers[arc.read as usize] += 1);
        self.arcs.iter().map(|arc| readers[arc.write as usize]).sum()
    }

    /// The rows of this one above those of the other one.
    pub fn above(&self, below: &Power) -> Self {
        let mut readers: Vec<Vec<Arc>> = vec![Vec::new(); self.labels];
        below.arcs.iter().for_each(|&arc| readers[arc.read as usize].push(arc));
        let pair = |upper: u32, lower: u32| u64::from(upper) << 32 | u64::from(lower);
        let mut names: Vec<u64> = Vec::new();
        for upper in &self.arcs {
            names.extend(readers[upper.write as usize].iter().map(|l| pair(upper.from, l.from)));
        }
        names.sort_unstable();
        names.dedup();
        let mut arcs = Vec::new();
        for upper in &self.arcs {
            for lower in &readers[upper.write as usize] {
                // What no arc leaves lies on no cycle.
                let from = names.binary_search(&pair(upper.from, lower.from));
                let to = names.binary_search(&pair(upper.to, lower.to));
                if let (Ok(from), Ok(to)) = (from, to) {
                    let (from, to) = (from as u32, to as u32);
                    arcs.push(Arc { from, to, read: upper.read, write: lower.write });
                }
            }
        }
        let mut power = Self { arcs, states: names.len(), labels: self.labels };
        power.reduce();
        power
    }

    /// Cuts and merges until nothing changes.
    fn reduce(&mut self) {
        loop {
            let before = (self.arcs.len(), self.states);
            self.cut();
            self.merge();
            self.turn();
            self.merge();
            self.turn();
            if before == (self.arcs.len(), self.states) {
                return;
            }
        }
    }

    fn cut(&mut self) {
        loop {
            let before = self.arcs.len();
            for down in [false, true] {
                let ends = |a: &Arc| if down { (a.read, a.write) } else { (a.from, a.to) };
                let arcs: Vec<(u32, u32)> = self.arcs.iter().map(ends).collect();
                let vertices = if down { self.labels } else { self.states };
                let mut kept = on_cycles(vertices, &arcs).into_iter();
                self.arcs.retain(|_| kept.next().unwrap_or(false));
            }
            if self.arcs.len() == before {
                return;
            }
        }
    }

    /// Every arc the other way round.
    fn turn(&mut self) {
        for arc in &mut self.arcs {
            (arc.from, arc.to) = (arc.to, arc.from);
        }
    }

    /// Makes one state of those from which the same can be read and written; states are then
    /// numbered without gaps, and no arc is there twice.
    fn merge(&mut self) {
        let mut class = vec![0u32; self.states];
        let mut classes = 1;
        let mut steps: Vec<(u32, [u32; 3])> = Vec::new();
        let step = |step: &(u32, [u32; 3])| step.1;
        loop {
            steps.clear();
            steps.extend(
                self.arcs.iter().map(|a| (a.from, [a.read, a.write, class[a.to as usize]])),
            );
            steps.sort_unstable();
            steps.dedup();
            let mut of_state: Vec<&[(u32, [u32; 3])]> = steps.chunk_by(|a, b| a.0 == b.0).collect();
            of_state.sort_by(|a, b| a.iter().map(|s| s.1).cmp(b.iter().map(|s| s.1)));
            let mut count = 0;
            let alike = |a: &&[_], b: &&[_]| a.iter().map(step).eq(b.iter().map(step));
            for same in of_state.chunk_by(alike) {
                same.iter().for_each(|steps| class[steps[0].0 as usize] = count);
                count += 1;
            }
            if count == classes {
                break;
            }
            classes = count;
        }
        for arc in &mut self.arcs {
            (arc.from, arc.to) = (class[arc.from as usize], class[arc.to as usize]);
        }
        self.arcs.sort_unstable();
        self.arcs.dedup();
        self.states = classes as usize;
    }
}
