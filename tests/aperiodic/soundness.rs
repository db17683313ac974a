//! Mixed tiles, and what they do to published claims.

use super::published;
use tilepack::aperiodic::Set;
use tilepack::aperiodic::convert::{Method, convert};
use tilepack::aperiodic::decide::{Bounds, Verdict, decide, wang};
use tilepack::aperiodic::sound::{enlarged, mixed};
use tilepack::tiles::Kind;

/// Mixed tiles, and the smallest torus of the set with them.
#[test]
fn mixed_tiles_of_the_published_sets() {
    for (name, method, count, torus) in [
        ("ammann16", Method::Horizontal, 2, Some((2, 3))),
        ("kari14", Method::Horizontal, 24, None),
        ("culik13", Method::Horizontal, 10, None),
        ("jeandel_rao11_5labels", Method::Horizontal, 2, Some((1, 1))),
        ("kari14", Method::Vertical, 0, None),
        ("ammann16", Method::Vertical, 2, None),
        ("culik13", Method::Vertical, 4, Some((2, 3))),
        ("jeandel_rao11_5labels", Method::Vertical, 4, Some((3, 3))),
    ] {
        let set = published(name);
        assert_eq!(mixed(&set, method).len(), count, "{name} {method}");
        if count == 0 {
            continue;
        }
        let never = std::sync::atomic::AtomicBool::new(false);
        let verdict = decide(&wang(&enlarged(&set, method)), &Bounds::default(), &never);
        let Verdict::Periodic(found) = verdict else {
            unreachable!("{name} {method}: {verdict:?}")
        };
        if let Some((width, height)) = torus {
            assert_eq!(found.area(), width * height, "{name} {method}");
        }
    }
}

/// The published set of 44 tiles over 6 colors has this tiling, with period 2 x 3.
#[test]
fn the_44_tiles_are_periodic() {
    let rows = [[5, 1], [2, 0], [3, 1]];
    let corners = convert(&published("ammann16"), Method::Horizontal).unwrap().set;
    assert_eq!(corners.tiles().len(), 44);
    for row in 0..3 {
        for column in 0..2 {
            let color = |row: usize, column: usize| rows[row % 3][column % 2];
            let tile = [
                color(row, column),
                color(row, column + 1),
                color(row + 1, column + 1),
                color(row + 1, column),
            ];
            assert!(corners.tiles().contains(&tile), "{tile:?}");
        }
    }
}

/// The corner sets in the repository are what the constructions give.
#[test]
fn corner_sets_on_file() {
    for (file, name, method) in [
        ("ammann-horizontal-44", "ammann16", Method::Horizontal),
        ("kari-vertical-86", "kari14", Method::Vertical),
    ] {
        let on_file = published(&format!("corner/{file}"));
        assert_eq!(on_file.tiles(), convert(&published(name), method).unwrap().set.tiles());
    }
    let small = published("corner/corner-24");
    assert_eq!(small.tiles().len(), 24);
}

/// Corner tilings of horizontal translation are tilings by the enlarged set: on small tori both
/// exist or neither does.
#[test]
fn the_enlarged_set_tells_what_corner_tiles_do() {
    let mut state = 5u64;
    let mut random = move |below: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % below
    };
    for _ in 0..150 {
        let tiles: std::collections::BTreeSet<[u32; 4]> =
            (0..6).map(|_| std::array::from_fn(|_| random(3) as u32)).collect();
        let set = Set::new(Kind::Wang, tiles.into_iter().collect()).unwrap();
        for method in [Method::Horizontal, Method::Vertical] {
            let corners = convert(&set, method).unwrap().set;
            let never = std::sync::atomic::AtomicBool::new(false);
            let bounds = Bounds { limit: 10, ..Bounds::default() };
            let periodic =
                |tiles: &[[u32; 4]]| matches!(decide(tiles, &bounds, &never), Verdict::Periodic(_));
            let empty = corners.tiles().is_empty();
            let by_corners = !empty && periodic(&wang(&corners));
            assert_eq!(
                by_corners,
                periodic(&wang(&enlarged(&set, method))),
                "{:?} {method}",
                set.tiles()
            );
        }
    }
}
