//! How even parts are: the nodes of their own, which do not depend on the machine.

use crate::{Place, result};

/// The largest number of own nodes over the median, and the sum of all.
fn spread(problem: &str, parts: u64) -> (f64, u64) {
    let place = Place::new();
    let plan = place.plan(problem, parts, "some.plan");
    let above = plan.frontier.above;
    let mut own: Vec<u64> =
        (0..parts).map(|number| result(&plan, number).standing.state.nodes - above).collect();
    own.sort_unstable();
    let (median, largest) = (own[own.len() / 2], own[own.len() - 1]);
    let spread = largest as f64 / median as f64;
    println!(
        "{problem}, {parts} parts: {} nodes above the frontier; own nodes {} to {largest}, median \
         {median}, largest/median {spread:.2}",
        above, own[0]
    );
    (spread, above + own.iter().sum::<u64>())
}

#[test]
fn wang() {
    for parts in [7, 64, 256] {
        let (spread, nodes) = spread("--kind wang --colors 2", parts);
        assert!(spread < 1.5, "{parts} parts: {spread}");
        assert_eq!(nodes, 537_503);
    }
}

#[test]
fn the_quotient_of_three_corner_colors() {
    for parts in [7, 64] {
        let problem = "--kind corner --colors 3 --automorphism 3,0:+1";
        let (spread, nodes) = spread(problem, parts);
        assert!(spread < 1.5, "{parts} parts: {spread}");
        assert_eq!(nodes, 1_594_475);
    }
}
