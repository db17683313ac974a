//! Rings of given dominoes: Eulerian circuits of a directed graph.
//!
//! A domino with the colors `x`, `y` is an arc from `x` to `y`, and a ring that uses every
//! domino once is a closed walk that uses every arc once. One exists just when as many arcs
//! enter every vertex as leave it and all arcs hang together (Euler). Hierholzer's algorithm
//! (1873) finds it in time proportional to the arcs: walk until stuck, which can only be where
//! the walk began, and while walking back insert a detour wherever an arc is left.
//!
//! A degree that does not match, or an arc that was not reached, is named in the error.

use super::Seed;

/// Vertices 0, 1, … and arcs between them, loops and parallel arcs included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Digraph {
    vertices: usize,
    arcs: Vec<(u8, u8)>,
}

/// Why a graph has no Eulerian circuit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NoCircuit {
    /// Not as many arcs enter a vertex as leave it.
    #[error("no Eulerian circuit: vertex {vertex} has in-degree {into}, out-degree {out}")]
    Degrees {
        /// The vertex: a color.
        vertex: u8,
        /// Arcs that end there.
        into: usize,
        /// Arcs that begin there.
        out: usize,
    },
    /// The arcs fall into parts without a common vertex.
    #[error("no Eulerian circuit: not connected, no way leads from vertex {from} to vertex {to}")]
    NotConnected {
        /// A vertex with arcs.
        from: u8,
        /// Another, out of reach.
        to: u8,
    },
    /// There is no arc at all.
    #[error("no Eulerian circuit: there is no arc")]
    Empty,
}

impl Digraph {
    /// A graph with these arcs; it has at least `vertices` vertices.
    pub fn new(vertices: usize, arcs: Vec<(u8, u8)>) -> Self {
        let needed = arcs.iter().map(|&(from, to)| usize::from(from.max(to)) + 1).max();
        Self { vertices: vertices.max(needed.unwrap_or(0)), arcs }
    }

    /// All arcs, loops included, between `colors` vertices (at most 256).
    pub fn complete(colors: usize) -> Self {
        let all = (0..colors).flat_map(|x| (0..colors).map(move |y| (x as u8, y as u8)));
        Self { vertices: colors, arcs: all.collect() }
    }

    /// How many vertices there are.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// The arcs, from and to.
    pub fn arcs(&self) -> &[(u8, u8)] {
        &self.arcs
    }

    /// For every vertex how many arcs enter it and how many leave it.
    pub fn degrees(&self) -> Vec<(usize, usize)> {
        let mut degrees = vec![(0, 0); self.vertices];
        for &(from, to) in &self.arcs {
            degrees[usize::from(from)].1 += 1;
            degrees[usize::from(to)].0 += 1;
        }
        degrees
    }

    /// The vertices along an Eulerian circuit: as many as there are arcs, the last followed by
    /// the first. Without a seed arcs are taken in the order in which they were given.
    ///
    /// # Errors
    /// Why there is none.
    pub fn circuit(&self, seed: Option<&mut Seed>) -> Result<Vec<u8>, NoCircuit> {
        let start = self.arcs.first().ok_or(NoCircuit::Empty)?.0;
        for (vertex, (into, out)) in self.degrees().into_iter().enumerate() {
            if into != out {
                return Err(NoCircuit::Degrees { vertex: vertex as u8, into, out });
            }
        }
        let mut left: Vec<Vec<u8>> = vec![Vec::new(); self.vertices];
        for &(from, to) in self.arcs.iter().rev() {
            left[usize::from(from)].push(to);
        }
        if let Some(seed) = seed {
            left.iter_mut().for_each(|ends| seed.shuffle(ends));
        }
        let mut walk = vec![start];
        let mut circuit = Vec::with_capacity(self.arcs.len() + 1);
        while let Some(&here) = walk.last() {
            match left[usize::from(here)].pop() {
                Some(next) => walk.push(next),
                None => circuit.extend(walk.pop()),
            }
        }
        if let Some(to) = left.iter().position(|ends| !ends.is_empty()) {
            return Err(NoCircuit::NotConnected { from: start, to: to as u8 });
        }
        circuit.reverse();
        circuit.pop();
        Ok(circuit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn says_why_not() {
        let none = |arcs: &[(u8, u8)]| {
            Digraph::new(0, arcs.to_vec()).circuit(None).unwrap_err().to_string()
        };
        assert_eq!(none(&[]), "no Eulerian circuit: there is no arc");
        assert_eq!(
            none(&[(0, 1), (1, 0), (1, 2)]),
            "no Eulerian circuit: vertex 1 has in-degree 1, out-degree 2"
        );
        assert_eq!(
            none(&[(0, 1), (1, 0), (2, 2)]),
            "no Eulerian circuit: not connected, no way leads from vertex 0 to vertex 2"
        );
    }
}
