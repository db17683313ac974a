//! Faults that a pass has left, repaired exactly.
//!
//! Cells around the faults are freed, and the rest of the field is completed; if it cannot be, more
//! cells are freed, at last all of them: then there is no tiling. So a field changes near its faults
//! only, which lie along the seams where edges meet.

use super::super::exact::{Completion, ExactError, complete_near};
use super::super::{Direction, FREE, Field, Rule, faults};
use crate::search::Stop;

/// How far from the faults cells are freed, at first. Every time it is twice as far.
const NEAR: usize = 2;

/// Repairs a field. What was found is a tiling; impossible means that there is none at all.
///
/// # Errors
/// A field that is too large.
pub fn repair(rule: &Rule, draft: Field, stop: &dyn Stop) -> Result<Completion, ExactError> {
    let mut freed = faults::broken(rule, &draft);
    if !freed.contains(&true) {
        return Ok(Completion::Found(draft));
    }
    let mut further = NEAR;
    loop {
        for _ in 0..further {
            grow(rule, &mut freed);
        }
        further *= 2;
        let mut partial = draft.clone();
        for (cell, _) in partial.cells_mut().iter_mut().zip(&freed).filter(|(_, free)| **free) {
            *cell = FREE;
        }
        match complete_near(rule, &partial, &draft, stop)? {
            Completion::Impossible { core, .. } if !core.is_empty() => {}
            answer => return Ok(answer),
        }
    }
}

/// Frees the neighbors of cells that are free.
fn grow(rule: &Rule, freed: &mut [bool]) {
    let (width, height) = (rule.width(), rule.height());
    for direction in [Direction::Horizontal, Direction::Vertical] {
        let meet = rule.edges().meet(direction);
        let (lines, length, step, next) = match direction {
            Direction::Horizontal => (height, width, 1, width),
            Direction::Vertical => (width, height, width, 1),
        };
        for line in 0..lines {
            let old: Vec<bool> = (0..length).map(|at| freed[line * next + at * step]).collect();
            for at in 0..length {
                let before = if at > 0 { old[at - 1] } else { meet && old[length - 1] };
                let after = if at + 1 < length { old[at + 1] } else { meet && old[0] };
                freed[line * next + at * step] |= before || after;
            }
        }
    }
}
