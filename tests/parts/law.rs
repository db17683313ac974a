//! Part r of m is the union of the parts r, r+m, r+2m, … of km; all parts are the whole.

use crate::trees::{Came, How, Tree};
use proptest::prelude::*;
use tilepack::search::{Count, Part, Values, cut, frontier};

fn trees() -> impl Strategy<Value = Tree> {
    (0..9usize, any::<u64>()).prop_map(|(levels, seed)| Tree::new(levels, seed))
}

fn hows() -> impl Strategy<Value = How> {
    let values = prop_oneof![Just(Values::Lexicographic), any::<u64>().prop_map(Values::Random)];
    (1..4usize, values).prop_map(|(threads, values)| How { threads, values })
}

/// The nodes above the frontier at a depth that may be below the tree.
fn above(tree: &Tree, depth: usize) -> u64 {
    match tree.levels {
        0 => 0,
        levels => cut(tree, depth.min(levels), &mut Count).above,
    }
}

/// The union of parts, with nodes above the frontier counted once; they must be disjoint.
fn union(parts: impl IntoIterator<Item = Came>, above: u64) -> Came {
    let mut all = Came { solutions: Vec::new(), nodes: above, deepest: 0 };
    for mut part in parts {
        all.nodes += part.nodes.checked_sub(above).unwrap();
        all.deepest = all.deepest.max(part.deepest);
        all.solutions.append(&mut part.solutions);
    }
    all.solutions.sort_unstable();
    let disjoint = all.solutions.windows(2).all(|pair| pair[0] != pair[1]);
    assert!(disjoint, "a solution in two parts");
    all
}

proptest! {
    #[test]
    fn a_part_is_the_union_of_finer_parts(
        tree in trees(), depth in 1..12usize, m in 1..7u64, k in 1..6u64, r in any::<u64>(),
        how in hows(),
    ) {
        let number = r % m;
        let whole = How::PLAIN.part(&tree, Part { depth, number, of: m });
        let finer = (0..k).map(|j| {
            how.part(&tree, Part { depth, number: number + j * m, of: k * m })
        });
        prop_assert_eq!(union(finer, above(&tree, depth)), whole);
    }

    #[test]
    fn all_parts_are_the_whole(
        tree in trees(), depth in 1..12usize, parts in prop_oneof![1..9u64, 50..400u64],
        how in hows(),
    ) {
        let all = (0..parts).map(|number| how.part(&tree, Part { depth, number, of: parts }));
        prop_assert_eq!(union(all, above(&tree, depth)), How::PLAIN.whole(tree));
    }

    #[test]
    fn neither_threads_nor_values_matter(
        tree in trees(), depth in 1..12usize, of in 1..6u64, r in any::<u64>(), how in hows(),
    ) {
        let part = Part { depth, number: r % of, of };
        prop_assert_eq!(how.part(&tree, part), How::PLAIN.part(&tree, part));
    }

    /// The frontier chosen: the first with enough nodes, or the first of the widest.
    #[test]
    fn the_frontier_is_no_deeper_than_needed(tree in trees(), wanted in 1..60u64) {
        let found = frontier(&tree, wanted, &mut Count);
        let cuts: Vec<_> = (1..=tree.levels).map(|depth| cut(&tree, depth, &mut Count)).collect();
        let enough = cuts.iter().find(|cut| cut.nodes >= wanted);
        let most = cuts.iter().map(|cut| cut.nodes).max().unwrap_or(0);
        match enough.or(cuts.iter().find(|cut| cut.nodes == most && most > 0)) {
            Some(expected) => prop_assert_eq!(&found, expected),
            None => prop_assert_eq!((found.depth, found.nodes, found.above), (1, 0, 0)),
        }
        // Nodes at and above a depth, by walking to the next one.
        for pair in cuts.windows(2) {
            prop_assert_eq!(pair[1].above, pair[0].above + pair[0].nodes);
        }
    }
}

/// The empty path is the one solution of a problem without levels: of part 0 alone.
#[test]
fn a_problem_without_levels() {
    let tree = Tree::new(0, 7);
    for of in [1, 2, 5] {
        for number in 0..of {
            let part = How::PLAIN.part(&tree, Part { depth: 1, number, of });
            let solutions = if number == 0 { vec![Vec::new()] } else { Vec::new() };
            assert_eq!(part, Came { solutions, nodes: 0, deepest: 0 }, "{number} of {of}");
        }
    }
}

/// More parts than nodes to deal out: most are empty, none is lost.
#[test]
fn more_parts_than_nodes() {
    let tree = Tree::new(6, 3);
    let whole = How::PLAIN.whole(tree.clone());
    assert!(whole.nodes > 100, "{whole:?}");
    let top = cut(&tree, 2, &mut Count);
    let parts: Vec<Came> = (0..1000)
        .map(|number| How::PLAIN.part(&tree, Part { depth: 2, number, of: 1000 }))
        .collect();
    let empty = parts.iter().filter(|part| part.nodes == top.above).count() as u64;
    assert!(empty >= 1000 - top.nodes && empty < 1000, "{empty} empty, {top:?}");
    assert_eq!(union(parts, top.above), whole);
}
