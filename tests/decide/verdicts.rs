//! Verdicts on small sets against trying everything.

use crate::naive::{smallest_square, smallest_torus};
use crate::random_tiles;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use tilepack::aperiodic::Set;
use tilepack::aperiodic::classify::Quick;
use tilepack::aperiodic::decide::square::{Square, fill};
use tilepack::aperiodic::decide::{Bounds, Verdict, decide, lonely, useful, wang};
use tilepack::tiles::Kind;
use tilepack::verify::{Claim, ClaimFault, check_claim};

/// Cells of a torus that are tried.
const AREA: usize = 9;
/// Sides of a square that are tried.
const SIDE: usize = 4;

fn agrees(kind: Kind, tiles: Vec<[u32; 4]>) -> &'static str {
    let corner = kind == Kind::Corner;
    let set = Set::new(kind, tiles.clone()).unwrap();
    let forms = wang(&set);
    let verdict = decide(&forms, &Bounds::default(), &());
    if let Some(quick) = Quick::default().decide(&forms) {
        assert_eq!(quick, matches!(verdict, Verdict::Periodic(_)), "{tiles:?}");
    }
    match verdict {
        Verdict::Periodic(torus) => {
            assert!(torus.smallest, "{tiles:?}");
            let area = torus.cells.len();
            let (width, height) = (torus.width, torus.height);
            let claim = Claim::Torus { width, height, cells: torus.cells };
            assert_eq!(check_claim(kind, &tiles, &claim, 0), Ok(()));
            let tried = smallest_torus(&tiles, corner, AREA);
            assert_eq!(tried, (area <= AREA).then_some(area), "{tiles:?}");
            "periodic"
        }
        Verdict::NoSquare { side, .. } => {
            assert_eq!(check_claim(kind, &tiles, &Claim::NoSquare { side }, 1 << 20), Ok(()));
            let tried = smallest_square(&tiles, corner, SIDE);
            assert_eq!(tried, (side <= SIDE).then_some(side), "{tiles:?}");
            assert_eq!(smallest_torus(&tiles, corner, 6), None);
            // Without squares the empty power itself is the proof.
            let no_squares = Bounds { nodes: 0, ..Bounds::default() };
            let Verdict::NoStrip(strip) = decide(&forms, &no_squares, &()) else {
                panic!("{tiles:?}")
            };
            let claim = Claim::NoStrip { rows: strip.rows, power: strip.power };
            assert_eq!(check_claim(kind, &tiles, &claim, 1 << 20), Ok(()), "{tiles:?}");
            if strip.power > 1 {
                let claim = Claim::NoStrip { rows: strip.rows, power: strip.power - 1 };
                let said = check_claim(kind, &tiles, &claim, 1 << 20);
                assert!(matches!(said, Err(ClaimFault::Left { .. })), "{tiles:?}");
            }
            "no tiling"
        }
        other => panic!("{tiles:?}: {other:?}"),
    }
}

#[test]
fn random_sets_are_decided_as_by_trying_everything() {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    for (kind, sizes, labels) in [
        (Kind::Wang, 1..8, 2),
        (Kind::Wang, 2..8, 3),
        (Kind::Corner, 1..9, 2),
        (Kind::Corner, 3..12, 3),
    ] {
        let (mut periodic, mut none) = (0, 0);
        for size in sizes {
            for _ in 0..40 {
                match agrees(kind, random_tiles(&mut random, size, labels)) {
                    "periodic" => periodic += 1,
                    _ => none += 1,
                }
            }
        }
        assert!(periodic > 10 && none > 10, "{kind}: {periodic} {none}");
    }
}

#[test]
fn the_empty_set_and_useless_tiles() {
    assert_eq!(decide(&[], &Bounds::default(), &()), Verdict::NoSquare { side: 1, nodes: 0 });
    // A tile that fits beside itself, one that nothing fits beside.
    let tiles = [[0, 0, 0, 0], [0, 1, 1, 0]];
    assert_eq!(useful(&tiles), [0]);
    assert_eq!(lonely(&tiles), [(1, vec![1, 2])]);
    assert!(
        matches!(decide(&tiles, &Bounds::default(), &()), Verdict::Periodic(t) if t.area() == 1)
    );
}

#[test]
fn squares_that_can_be_filled_and_not() {
    // Labels of N and S count to 4: a square of 4 rows, not of 5.
    let tiles: Vec<[u32; 4]> = (0..4).map(|n| [n, 0, n + 1, 0]).collect();
    assert_eq!(fill(&tiles, 4, 1000, &()), Square::Filled);
    assert!(matches!(fill(&tiles, 5, 1 << 20, &()), Square::Impossible(_)));
    assert_eq!(fill(&tiles, 5, 3, &()), Square::Stopped);
    let verdict = decide(&tiles, &Bounds::default(), &());
    assert!(matches!(verdict, Verdict::NoSquare { side: 5, .. }), "{verdict:?}");
}

#[test]
fn bounds_leave_a_set_undecided() {
    let tiles: Vec<[u32; 4]> = (0..6).map(|n| [n, 0, (n + 1) % 6, n % 2]).collect();
    let tight = Bounds { limit: 1, ..Bounds::default() };
    let verdict = decide(&tiles, &tight, &());
    let wide = decide(&tiles, &Bounds::default(), &());
    assert!(!matches!(wide, Verdict::Undecided(_)), "{wide:?}");
    assert!(matches!(verdict, Verdict::Undecided(_) | Verdict::NoSquare { .. }), "{verdict:?}");
    let stopped = std::sync::atomic::AtomicBool::new(true);
    let verdict = decide(&tiles, &Bounds::default(), &stopped);
    assert!(matches!(verdict, Verdict::Undecided(gap) if gap.stopped));
}
