//! Portfolios: the same way wins on any number of threads, and what it gives is a packing.

use crate::task::task;
use tilepack::portfolio::{self, Way};
use tilepack::search::Limits;
use tilepack::verify;

#[test]
fn the_same_way_wins_on_any_number_of_threads() {
    for (kind, colors, members, size, symmetric, wanted) in [
        ("corner", "3", "complete", "", false, "InOrder"),
        ("corner", "4", "complete", "", true, "Symmetric"),
        ("corner", "4", "compact", "16x8", false, "Beam"),
        ("wang", "2,3", "complete", "", true, "InOrder"),
    ] {
        let task = task(kind, colors, members, size);
        let run = |threads| portfolio::run(&task, symmetric, 1, threads, &Limits::NONE).unwrap();
        let outcome = run(1);
        let (way, _) = outcome.won.as_ref().unwrap();
        assert!(format!("{way:?}").starts_with(wanted), "{way:?}");
        assert_eq!(run(3), outcome);
        let labels = outcome.labels.unwrap();
        let packing = task.lattice().packing(&labels, &task.set, false);
        assert!(verify::check(&packing).is_valid());
        if let Way::Symmetric(automorphism) = way {
            let (w, h) = (task.shape.width(), task.shape.height());
            let (dx, dy) = (automorphism.dx as usize, automorphism.dy as usize);
            assert!((0..w * h).all(|cell| {
                let to = (cell / w + dy) % h * w + (cell % w + dx) % w;
                labels[to] == automorphism.map.vertical()[usize::from(labels[cell])]
            }));
        }
    }
}

#[test]
fn what_has_no_packing_and_what_takes_too_long() {
    let none = task("corner", "4", "pruned:0-1,2-3", "4x15");
    for threads in [1, 2] {
        let outcome = portfolio::run(&none, true, 0, threads, &Limits::NONE).unwrap();
        assert!(outcome.won.is_some() && outcome.labels.is_none(), "{outcome:?}");
        let few = Limits { nodes: 3_000_000, ..Limits::NONE };
        let five = task("corner", "5", "complete", "");
        let outcome = portfolio::run(&five, false, 0, threads, &few).unwrap();
        assert!(outcome.won.is_none() && outcome.labels.is_none());
        assert!((3_000_000..6_000_000).contains(&outcome.nodes), "{outcome:?}");
    }
    assert_eq!(portfolio::ways(&task("wang", "2", "complete", ""), false).len(), 2);
    assert_eq!(portfolio::ways(&task("corner", "3", "complete", ""), true).len(), 4);
}
