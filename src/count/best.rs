//! How many rings a set of dominoes has: Eulerian circuits of a directed graph.
//!
//! In a graph with as many arcs into every vertex as out of it, the number of Eulerian circuits
//! (up to where they begin) is `t * product of (out-degree - 1)!`, where `t` counts the spanning
//! trees directed towards any one vertex (de Bruijn, van Aardenne-Ehrenfest 1951; Smith, Tutte
//! 1941). `t` is the determinant of the Laplacian without the row and column of that vertex
//! (Tutte 1948), here by elimination without fractions (Bareiss 1968), exactly.
//!
//! All dominoes over `C` colors have `(C!)^C / C^2` rings.

use crate::construct::Digraph;
use num_bigint::{BigInt, BigUint};

/// The number of Eulerian circuits, those that differ only in where they begin being one; 0 if
/// the graph has none.
pub fn rings(graph: &Digraph) -> BigUint {
    if graph.circuit(None).is_err() {
        return BigUint::ZERO;
    }
    let degrees = graph.degrees();
    let used: Vec<usize> = (0..graph.vertices()).filter(|&v| degrees[v].1 > 0).collect();
    let orders: BigUint = used.iter().flat_map(|&v| (1..degrees[v].1).map(BigUint::from)).product();
    orders * trees(graph, &used).magnitude()
}

/// The number of ring packings: a ring may begin with any of its dominoes.
pub fn packings(graph: &Digraph) -> BigUint {
    rings(graph) * graph.arcs().len()
}

/// The spanning trees directed towards the first of the vertices in use.
fn trees(graph: &Digraph, used: &[usize]) -> BigInt {
    let mut index = vec![None; graph.vertices()];
    for (at, &vertex) in used.iter().skip(1).enumerate() {
        index[vertex] = Some(at);
    }
    let size = used.len().saturating_sub(1);
    let mut laplacian = vec![vec![BigInt::ZERO; size]; size];
    for &(from, to) in graph.arcs() {
        let (from, to) = (index[usize::from(from)], index[usize::from(to)]);
        if let Some(from) = from {
            laplacian[from][from] += 1;
            if let Some(to) = to {
                laplacian[from][to] -= 1;
            }
        }
    }
    determinant(laplacian)
}

/// The determinant, if all leading minors but perhaps the last differ from 0: as they do here,
/// for each counts the spanning forests of a connected graph. A step replaces what is below and
/// to the right of the pivot by minors of the matrix, so all divisions are exact.
fn determinant(mut matrix: Vec<Vec<BigInt>>) -> BigInt {
    let mut before = BigInt::from(1);
    for step in 0..matrix.len() {
        let (above, below) = matrix.split_at_mut(step + 1);
        let pivots = &above[step];
        for row in below {
            for column in step + 1..row.len() {
                let minor = &pivots[step] * &row[column] - &row[step] * &pivots[column];
                row[column] = minor / &before;
            }
        }
        before.clone_from(&matrix[step][step]);
        if before == BigInt::ZERO {
            return before;
        }
    }
    before
}
