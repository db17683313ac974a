//! The search: bounds from below and from above in turns, with strips that grow, until they meet.

use super::board::{Board, Cost, NEVER, may_be};
use super::dual::{Pool, System};
use super::machine::Machine;
use super::mend::Mender;
use crate::search::Stop;
use rand::SeedableRng;
use rand_pcg::Pcg64;
use std::sync::Arc;

/// Steps of machines at most, stage by stage.
const STEPS: [usize; 4] = [1 << 10, 1 << 13, 1 << 16, 1 << 20];

/// What was found.
#[derive(Debug, Clone)]
pub struct Found {
    /// A tiling that keeps the rule, and its cost.
    pub best: Option<(Vec<u8>, Cost)>,
    /// No tiling costs less.
    pub bound: Cost,
    pub log: Vec<String>,
}

/// The tallest machine of so many steps.
pub fn tallest(board: &Board, along: usize, most: usize) -> Arc<Machine> {
    let mut best = None;
    for lines in 1..=board.lines(along) {
        match Machine::new(board, along, lines, most) {
            Some(machine) => best = Some(machine),
            None => break,
        }
    }
    Arc::new(best.or_else(|| Machine::new(board, along, 1, usize::MAX)).unwrap())
}

pub fn solve(board: &Board, start: &[u8], check: impl Fn(&[u8]) -> bool + Sync, seed: u64, stop: &impl Stop) -> Found {
    let largest = board.costs.iter().copied().filter(|&c| may_be(c)).max().unwrap_or(0).max(1);
    let unit: Cost = 1 << 16;
    let _ = largest;
    let mut found = Found { best: None, bound: 0, log: vec![] };
    let mut cells = start.to_vec();
    let mut random = Pcg64::seed_from_u64(seed);
    for stage in 0..STEPS.len() {
        let machines = [0, 1].map(|along| tallest(board, along, STEPS[stage]));
        let mut mender = Mender::new(board, machines.clone());
        let mut systems: Vec<System> = Vec::new();
        let covers = [0, 1].map(|along| {
            let m = &machines[along];
            let longest = board.runs[1 - along].iter().map(|set| set.longest() as usize).max().unwrap_or(0);
            if m.lines == board.lines(along) { return Some(1) }
            (m.lines > longest).then(|| (m.lines / 2).min(m.lines - longest).max(1))
        });
        let both = !(covers[0].is_some() || covers[1].is_some()) || std::env::var("BOTH").is_ok();
        let along = if covers[0].is_some() && (stage % 2 == 0 || covers[1].is_none()) { 0 } else { 1 };
        if both {
            for along in 0..2 {
                let stride = covers[along].unwrap_or((machines[along].lines / 2).max(1));
                systems.push(System::new(board, along, machines[along].clone(), stride, |c, t| {
                    let whole = board.cost(c, t) * unit;
                    let half = whole.div_euclid(2);
                    if along == 0 { half } else { whole - half }
                }));
            }
        } else {
            let whole = |c, t| board.cost(c, t).saturating_mul(unit);
            systems.push(System::new(board, along, machines[along].clone(), covers[along].unwrap(), whole));
        }
        let mut pool: Pool = vec![0; board.costs.len()];
        let mut last = 0;
        let mut stale = 0;
        let mut stale_up = 0;
        for round in 0.. {
            if stop.should_stop() { return found; }
            let n = systems.len();
            let mut sum = 0;
            for system in &mut systems {
                sum += system.forward(board, (n > 1).then_some(&mut pool));
                system.backward(true);
            }
            if n > 1 { sum = 0; for s in &mut systems { sum += s.forward(board, None); s.backward(true); } }
            let bound = if may_be(sum) { (sum + unit - 1).div_euclid(unit) } else { NEVER };
            found.bound = found.bound.max(bound);
            if found.bound == NEVER { return found; }
            let done = found.best.as_ref().is_some_and(|b| b.1 <= found.bound);
            if done { found.log.push(format!("stage {stage} round {round} {:.3}", sum as f64 / unit as f64)); return found; }
            if stale_up < 20 {
                mender.sweep(board, &mut cells, &mut random);
                let total = board.total(&cells);
                if check(&cells) {
                    if found.best.as_ref().is_none_or(|b| total < b.1) { found.best = Some((cells.clone(), total)); stale_up = 0; }
                    else { stale_up += 1; }
                } else { stale_up += 1; if round > 3 { mender.penalty *= 2; } }
                if found.best.as_ref().is_some_and(|b| b.1 <= found.bound) { 
                    found.log.push(format!("stage {stage} round {round} {:.3}", sum as f64 / unit as f64));
                    return found; }
            }
            if sum - last < unit / 200 { stale += 1 } else { stale = 0 }
            last = last.max(sum);
            if stale > 5 && stale_up >= 10 { 
                found.log.push(format!("stage {stage} left at round {round} with {:.3} {:?}", sum as f64 / unit as f64, found.best.as_ref().map(|b| b.1)));
                break; }
        }
    }
    found
}
