//! How many of some literals hold, as literals: a tree of sorted lists (the *totalizer* of Bailleux
//! and Boufkhad, 2003).
//!
//! Output `k` (from 0) says "more than `k` of them". The outputs of two halves give those of the
//! whole, both ways: more than `i` on the left and more than `j` on the right make more than
//! `i + j + 1`; at most so many on both sides make at most so many.

use super::sat::{Literal, Solver};

/// The outputs for lists of literals, list by list: the lists of neighbors are united first, so each
/// list's own outputs are part of the tree. `known` gets the outputs of each list.
pub(super) fn total(
    solver: &mut Solver,
    lists: &[Vec<Literal>],
    mut known: impl FnMut(&mut Solver, usize, &[Literal]),
) -> Vec<Literal> {
    let mut parts = Vec::new();
    for (at, list) in lists.iter().enumerate() {
        let part = united(solver, list.iter().map(|&literal| vec![literal]).collect());
        known(solver, at, &part);
        parts.push(part);
    }
    united(solver, parts)
}

/// Unites neighbors until one list is left.
fn united(solver: &mut Solver, mut parts: Vec<Vec<Literal>>) -> Vec<Literal> {
    while parts.len() > 1 {
        parts = parts
            .chunks(2)
            .map(|pair| match pair {
                [a, b] => merged(solver, a, b),
                other => other.concat(),
            })
            .collect();
    }
    parts.pop().unwrap_or_default()
}

/// The outputs of two lists together.
fn merged(solver: &mut Solver, a: &[Literal], b: &[Literal]) -> Vec<Literal> {
    let sum: Vec<Literal> =
        (0..a.len() + b.len()).map(|_| Literal::new(solver.variable(), true)).collect();
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            // At least i and at least j.
            if i + j > 0 {
                let mut clause = vec![sum[i + j - 1]];
                clause.extend(i.checked_sub(1).map(|i| !a[i]));
                clause.extend(j.checked_sub(1).map(|j| !b[j]));
                solver.add(&clause);
            }
            // At most i and at most j.
            if i + j < sum.len() {
                let mut clause = vec![!sum[i + j]];
                clause.extend(a.get(i).copied());
                clause.extend(b.get(j).copied());
                solver.add(&clause);
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dappled::exact::sat::Answer;

    #[test]
    fn outputs_count() {
        for size in 0..7u32 {
            let mut solver = Solver::new(size as usize);
            let lists: Vec<Vec<Literal>> = (0..size)
                .map(|v| Literal::new(v, true))
                .collect::<Vec<_>>()
                .chunks(3)
                .map(<[_]>::to_vec)
                .collect();
            let outputs = total(&mut solver, &lists, |_, _, _| {});
            assert_eq!(outputs.len(), size as usize);
            for values in 0..1u32 << size {
                let assumed: Vec<Literal> =
                    (0..size).map(|v| Literal::new(v, values >> v & 1 == 1)).collect();
                assert_eq!(solver.solve(&assumed, &()), Answer::Model);
                for (k, &output) in (0..).zip(&outputs) {
                    assert_eq!(solver.holds(output), values.count_ones() > k);
                }
            }
        }
    }
}
