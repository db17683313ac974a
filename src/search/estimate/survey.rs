//! The survey: a first, rough look at the numbers of nodes level by level.
//!
//! A fixed number of nodes goes down the tree together; at each level all their alternatives
//! are weighed and as many of them chosen (sequential Monte Carlo). The nodes are kept in the
//! order of the walk, so that going from one to the next replays few choices. What comes of it
//! only sets the thresholds of the probes.

use crate::search::{Alternatives, Problem};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A node of the population.
struct Node {
    path: Vec<u32>,
    weight: f64,
}

/// A problem and the choices it has been brought to.
struct Standing<'a, P> {
    problem: &'a mut P,
    path: Vec<u32>,
}

impl<P: Problem> Standing<'_, P> {
    fn go(&mut self, path: &[u32]) {
        let common = self.path.iter().zip(path).take_while(|(a, b)| a == b).count();
        while self.path.len() > common {
            if let Some(choice) = self.path.pop() {
                self.problem.pop(self.path.len(), choice);
            }
        }
        for &choice in &path[common..] {
            self.problem.push(self.path.len(), choice);
            self.path.push(choice);
        }
    }
}

/// Goes down with `size` nodes: estimates of the numbers of choices by level, 0 from the level
/// on where none was left. The problem is left without choices.
pub fn survey<P: Problem>(problem: &mut P, size: usize, seed: u64) -> Vec<f64> {
    let levels = problem.levels();
    let mut choices = vec![0.0; levels];
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut population = vec![Node { path: Vec::new(), weight: 1.0 }];
    let mut standing = Standing { problem, path: Vec::new() };
    for (level, total) in choices.iter_mut().enumerate() {
        let mut children = Vec::new();
        for (parent, node) in population.iter().enumerate() {
            standing.go(&node.path);
            let alternatives = standing.problem.alternatives(level);
            *total += node.weight * f64::from(alternatives.count());
            children.extend(alternatives.numbers().map(|choice| (parent, choice)));
        }
        if children.is_empty() {
            break;
        }
        let aim = *total / size as f64;
        let mut next: f64 = random.random();
        let mut chosen = Vec::with_capacity(children.len().min(2 * size));
        for (parent, choice) in children {
            let node: &Node = &population[parent];
            if node.weight < aim {
                next -= node.weight / aim;
                if next >= 0.0 {
                    continue;
                }
                next += 1.0;
            }
            let mut path = node.path.clone();
            path.push(choice);
            chosen.push(Node { path, weight: node.weight.max(aim) });
        }
        population = chosen;
    }
    standing.go(&[]);
    choices
}
