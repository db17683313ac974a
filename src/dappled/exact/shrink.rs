//! Fewer and fewer assumptions that contradict a formula, until none can be left out.
//!
//! Each is left out once. If the rest still contradict the formula, what the solver names replaces
//! them; else it is needed, and stays needed when others go. At the end there is a proof for the
//! whole and a model without each one.

use super::sat::{Answer, Literal, Solver};
use crate::search::Stop;

/// A part of assumptions that failed which fails, too, along with others that stay; and whether no
/// smaller part of that does.
pub(super) fn smaller(
    solver: &mut Solver,
    others: &[Literal],
    failed: Vec<Literal>,
    stop: &dyn Stop,
) -> (Vec<Literal>, bool) {
    let mut core = failed;
    // Those before are needed.
    let mut at = 0;
    while at < core.len() {
        let rest: Vec<Literal> = [others, &core[..at], &core[at + 1..]].concat();
        match solver.solve(&rest, stop) {
            Answer::Model => at += 1,
            Answer::Failed(fewer) => {
                // What is known to be needed stays.
                let mut rest = core.split_off(at);
                rest.retain(|literal| fewer.contains(literal));
                core.extend(rest);
            }
            Answer::Stopped => return (core, false),
        }
    }
    (core, true)
}
