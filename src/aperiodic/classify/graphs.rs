//! All directed graphs with n arcs, each on a cycle, up to isomorphism.
//!
//! Loops and parallel arcs are allowed, vertices without arcs are not. Every such graph comes from
//! one with fewer arcs: by an ear (a path from a vertex to a vertex through new ones) or by a
//! cycle of its own. So they are made from the empty graph, and each is kept once, in its
//! canonical form: the smallest list of arcs over all numberings of the vertices that list them
//! by degrees.

use crate::aperiodic::decide::on_cycles;
use std::collections::BTreeSet;

/// Arcs, from and to, in increasing order.
pub(super) type Arcs = Vec<(u8, u8)>;

/// The graphs with `arcs` arcs, in increasing order of their canonical forms.
pub(super) fn graphs(arcs: usize) -> Vec<Arcs> {
    let mut by_size: Vec<BTreeSet<Arcs>> = vec![BTreeSet::new(); arcs + 1];
    by_size[0].insert(Vec::new());
    for size in 0..arcs {
        for graph in by_size[size].clone() {
            for longer in 1..=arcs - size {
                let next = &mut by_size[size + longer];
                let ears = extended(&graph, longer);
                next.extend(ears.iter().filter(|graph| is_cyclic(graph)).map(canonical));
            }
        }
    }
    by_size.pop().unwrap_or_default().into_iter().collect()
}

/// Whether every arc is on a cycle: not so for an ear from one component to another.
fn is_cyclic(graph: &Arcs) -> bool {
    let arcs: Vec<(u32, u32)> = graph.iter().map(|&(from, to)| (from.into(), to.into())).collect();
    !on_cycles(vertices(graph).into(), &arcs).contains(&false)
}

/// The graph with an ear of so many arcs, or with a cycle.
fn extended(graph: &Arcs, length: usize) -> Vec<Arcs> {
    let vertices = vertices(graph);
    let path = |from: u8, to: u8, between: std::ops::Range<u8>| {
        let mut arcs = graph.clone();
        let mut at = from;
        for vertex in between {
            arcs.push((at, vertex));
            at = vertex;
        }
        arcs.push((at, to));
        arcs
    };
    let inner = vertices..vertices + length as u8 - 1;
    let mut all = vec![path(vertices, vertices, vertices + 1..vertices + length as u8)];
    for from in 0..vertices {
        all.extend((0..vertices).map(|to| path(from, to, inner.clone())));
    }
    all
}

/// The canonical form of the graph with all arcs the other way round.
pub(super) fn reversed(graph: &Arcs) -> Arcs {
    canonical(&graph.iter().map(|&(from, to)| (to, from)).collect())
}

/// The number of vertices.
pub(super) fn vertices(graph: &[(u8, u8)]) -> u8 {
    graph.iter().map(|&(from, to)| from.max(to) + 1).max().unwrap_or(0)
}

fn canonical(graph: &Arcs) -> Arcs {
    let count = vertices(graph);
    let degrees = |v: u8| {
        let leaving = graph.iter().filter(|arc| arc.0 == v).count();
        let entering = graph.iter().filter(|arc| arc.1 == v).count();
        let loops = graph.iter().filter(|&&arc| arc == (v, v)).count();
        (leaving, entering, loops)
    };
    let mut order: Vec<u8> = (0..count).collect();
    order.sort_by_key(|&v| degrees(v));
    let blocks: Vec<Vec<u8>> =
        order.chunk_by(|&a, &b| degrees(a) == degrees(b)).map(<[u8]>::to_vec).collect();
    let mut best: Option<Arcs> = None;
    let mut names = vec![0; usize::from(count)];
    numberings(&blocks, 0, &mut names, &mut |names| {
        let mut arcs: Arcs =
            graph.iter().map(|&(a, b)| (names[usize::from(a)], names[usize::from(b)])).collect();
        arcs.sort_unstable();
        if best.as_ref().is_none_or(|best| arcs < *best) {
            best = Some(arcs);
        }
    });
    best.unwrap_or_default()
}

/// All ways to number the vertices block by block.
fn numberings(blocks: &[Vec<u8>], first: u8, names: &mut [u8], visit: &mut impl FnMut(&[u8])) {
    let Some((block, rest)) = blocks.split_first() else { return visit(names) };
    if block.is_empty() {
        return numberings(rest, first, names, visit);
    }
    for i in 0..block.len() {
        names[usize::from(block[i])] = first;
        let mut left = vec![block.clone()];
        left[0].remove(i);
        left.extend_from_slice(rest);
        numberings(&left, first + 1, names, visit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_graphs() {
        assert_eq!(graphs(1), [vec![(0, 0)]]);
        // Two loops on one vertex, on two; a cycle.
        assert_eq!(graphs(2).len(), 3);
        // Three loops on one, two or three vertices; a cycle of two with a loop, beside a loop, or
        // with an arc doubled; a cycle of three.
        assert_eq!(graphs(3).len(), 7);
        for graph in graphs(5) {
            assert!(graph.len() == 5 && is_cyclic(&graph) && canonical(&graph) == graph);
        }
    }
}
