//! Coverings: what is found against `verify`, what is proved against trying everything.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::time::{Duration, Instant};
use tilepack::anneal;
use tilepack::beam::{self, Refusal};
use tilepack::cover::bound::excluded;
use tilepack::cover::folds::{folds, permutations};
use tilepack::cover::{NoBound, Options, bound, on_torus, smallest};
use tilepack::packing::{Settings, Task, count};
use tilepack::search::Limits;
use tilepack::symmetry::Automorphism;
use tilepack::tiles::notation::parse_members;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Fold, Lattice, Shape};
use tilepack::verify;

fn corner(colors: u64, members: &str) -> TileSet {
    let members = parse_members(members).unwrap().unwrap();
    TileSet::new(Kind::Corner, Colors::one(colors).unwrap(), members).unwrap()
}

fn shape(size: &str) -> Shape {
    size.parse().unwrap()
}

fn fold(size: &str, step: (usize, usize), images: &[u8]) -> Fold {
    Fold::new(shape(size), step, images).unwrap()
}

#[track_caller]
fn assert_covering(set: &TileSet, shape: Shape, labels: &[u8]) {
    let packing = Lattice { kind: Kind::Corner, shape }.packing(labels, set, true);
    let verdict = verify::check(&packing);
    assert!(verdict.is_valid(), "{shape}: {verdict}");
}

/// Whether `a[row + dy][column + dx] = images[a[row][column]]`.
fn has_symmetry(labels: &[u8], fold: &Fold, (dx, dy): (usize, usize)) -> bool {
    let (w, h) = (fold.shape().width(), fold.shape().height());
    let images = &fold.powers()[1];
    (0..w * h).all(|i| {
        let there = labels[(i / w + dy) % h * w + (i % w + dx) % w];
        there == images[usize::from(labels[i])]
    })
}

#[test]
fn annealing_covers() {
    let swap = [1, 0, 3, 2];
    for (colors, members, fold) in [
        (2, "complete", Fold::none(shape("6x4"), 2)),
        (3, "pruned:0-1", Fold::none(shape("11x3"), 3)),
        (3, "pruned:0-1", fold("12x4", (6, 0), &[1, 0, 2])),
        (4, "pruned:0-1,2-3", Fold::none(shape("22x3"), 4)),
        (4, "pruned:0-1,2-3", fold("12x9", (6, 0), &swap)),
        (4, "pruned:0-1", fold("17x10", (0, 5), &swap)),
        (1, "complete", Fold::none(shape("1x1"), 1)),
    ] {
        let set = corner(colors, members);
        let walk = anneal::cover(&set, &fold, 1, &Limits::NONE);
        assert_covering(&set, fold.shape(), walk.labels.as_ref().unwrap());
        assert_eq!(walk, anneal::cover(&set, &fold, 1, &Limits::NONE));
    }
    let (set, fold) = (corner(4, "pruned:0-1,2-3"), fold("12x9", (6, 0), &swap));
    let labels = anneal::cover(&set, &fold, 5, &Limits::NONE).labels.unwrap();
    assert!(has_symmetry(&labels, &fold, (6, 0)));
}

#[test]
fn annealing_ends_with_its_limits() {
    let (set, hopeless) = (corner(4, "pruned:0-1,2-3"), Fold::none(shape("10x6"), 4));
    for nodes in [0, 1, 12_345, 2_000_000] {
        let walk = anneal::cover(&set, &hopeless, 0, &Limits { stop: &(), nodes });
        assert_eq!((walk.labels, walk.moves), (None, nodes));
    }
    let begin = Instant::now();
    let soon = begin + Duration::from_millis(50);
    let limits = Limits { stop: &soon, nodes: u64::MAX };
    assert_eq!(anneal::cover(&set, &hopeless, 0, &limits).labels, None);
    assert!(begin.elapsed() < Duration::from_secs(5));
    // Fewer cells than tiles, a compact set, a symmetry that leads out of the set.
    let nothing = |set: &TileSet, fold: &Fold| {
        let walk = anneal::cover(set, fold, 0, &Limits::NONE);
        assert_eq!((walk.labels, walk.moves), (None, 0));
    };
    nothing(&set, &Fold::none(shape("7x7"), 4));
    nothing(&corner(3, "compact"), &Fold::none(shape("9x6"), 3));
    nothing(&set, &fold("10x8", (5, 0), &[2, 1, 0, 3]));
}

#[test]
fn the_beam_covers_with_tiles_used_again() {
    for (colors, members, fold, step) in [
        (3, "pruned:0-1", Fold::none(shape("11x3"), 3), None),
        (4, "pruned:0-1", Fold::none(shape("7x21"), 4), None),
        (4, "pruned:0-1", fold("15x10", (0, 5), &[0, 1, 3, 2]), Some((0, 5))),
        (5, "pruned:0-1,2-3", fold("24x11", (6, 0), &[2, 3, 1, 0, 4]), Some((6, 0))),
        (5, "pruned:0-1,2-3", fold("11x24", (0, 6), &[2, 3, 1, 0, 4]), Some((0, 6))),
        (5, "pruned:0-1", fold("27x16", (0, 8), &[1, 0, 3, 2, 4]), Some((0, 8))),
        (3, "complete", fold("9x9", (3, 0), &[1, 2, 0]), Some((3, 0))),
        (3, "complete", fold("9x9", (3, 3), &[1, 2, 0]), Some((3, 3))),
    ] {
        let set = corner(colors, members);
        let of = |threads| {
            let options = beam::Options { threads, seed: 3, ..beam::Options::for_set(&set) };
            beam::cover(&set, &fold, &options, &Limits::NONE).unwrap()
        };
        let found = of(1);
        let labels = found.labels.as_ref().unwrap();
        assert_covering(&set, fold.shape(), labels);
        assert!(step.is_none_or(|step| has_symmetry(labels, &fold, step)), "{members} {step:?}");
        assert_eq!(found, of(3), "{members}");
    }
}

#[test]
fn the_beam_ends_after_its_restarts() {
    let (set, hopeless) = (corner(4, "pruned:0-1,2-3"), Fold::none(shape("10x6"), 4));
    for threads in [1, 3] {
        let options =
            beam::Options { restarts: 7, width: 50, threads, ..beam::Options::for_set(&set) };
        let outcome = beam::cover(&set, &hopeless, &options, &Limits::NONE).unwrap();
        assert_eq!((outcome.labels, outcome.restart), (None, 7));
    }
    let refused = |members: &str, fold: &Fold| {
        let set = corner(4, members);
        let options = beam::Options::for_set(&set);
        beam::cover(&set, fold, &options, &Limits::NONE).unwrap_err()
    };
    let (pruned, swap) = ("pruned:0-1,2-3", [1, 0, 3, 2]);
    assert!(matches!(refused(pruned, &Fold::none(shape("7x7"), 4)), Refusal::Size { .. }));
    assert_eq!(refused(pruned, &fold("10x8", (5, 0), &[2, 1, 0, 3])), Refusal::NotKept);
    assert_eq!(refused(pruned, &Fold::none(shape("61x1"), 3)), Refusal::NotKept);
    assert_eq!(refused("compact", &Fold::none(shape("16x8"), 4)), Refusal::Compact);
    assert_eq!(refused("pruned:0-1", &fold("15x10", (0, 5), &swap)), Refusal::Seams);
    let one = corner(1, "complete");
    let options = beam::Options::for_set(&one);
    let row = beam::cover(&one, &Fold::none(shape("1x1"), 1), &options, &Limits::NONE);
    assert_eq!(row.unwrap_err(), Refusal::OneRow);
}

/// Where the beam says that seams do not fit, the search finds nothing.
#[test]
fn seams_that_do_not_fit() {
    let (mut refused, mut not) = (0, 0);
    for (colors, members, size, images) in [
        (2, "complete", "4x4", vec![1, 0]),
        (4, "pruned:0-1,2-3", "10x6", vec![1, 0, 3, 2]),
        (4, "pruned:0-1,2-3", "20x3", vec![1, 0, 3, 2]),
        (4, "pruned:0-1,2-3", "20x3", vec![2, 3, 1, 0]),
        (4, "pruned:0-1,2-3", "20x3", vec![2, 3, 0, 1]),
    ] {
        let (set, shape) = (corner(colors, members), shape(size));
        let steps = (0..shape.height()).flat_map(|y| (0..shape.width()).map(move |x| (x, y)));
        for (dx, dy) in steps {
            let Some(fold) = Fold::new(shape, (dx, dy), &images) else { continue };
            let options = beam::Options { restarts: 0, ..beam::Options::for_set(&set) };
            match beam::cover(&set, &fold, &options, &Limits::NONE) {
                Err(Refusal::Seams) => {
                    let list: Vec<String> = images.iter().map(u8::to_string).collect();
                    let text = format!("{dx},{dy}:{}", list.join(","));
                    let symmetry = Automorphism::parse(&text, set.colors(), shape).unwrap();
                    let task =
                        Task { automorphism: Some(symmetry), ..Task::new(set.clone(), shape) };
                    let counted = count(&task, &Settings::PLAIN, false).unwrap();
                    assert_eq!(counted.value.packings, 0u32.into(), "{members} {size} {text}");
                    refused += 1;
                }
                _ => not += 1,
            }
        }
    }
    assert!(refused > 3 && not > 3, "{refused} {not}");
}

/// For every torus of up to 12 cells the sets of tiles over two colors that it can show.
fn shown() -> Vec<(Shape, BTreeSet<u16>)> {
    let sizes = (1..=12u64).flat_map(|w| (1..=12 / w).map(move |h| (w, h)));
    let sets = |shape: Shape| {
        let (w, h) = (shape.width(), shape.height());
        let shown = |cells: u32| {
            let at = |r: usize, c: usize| cells >> (r % h * w + c % w) & 1;
            let tile = |r: usize, c: usize| {
                ((at(r, c + 1) * 2 + at(r + 1, c + 1)) * 2 + at(r + 1, c)) * 2 + at(r, c)
            };
            (0..w * h).fold(0u16, |set, i| set | 1 << tile(i / w, i % w))
        };
        (0..1 << (w * h)).map(shown).collect()
    };
    let shapes = sizes.map(|(w, h)| Shape::new(w, h).unwrap());
    shapes.map(|shape| (shape, sets(shape))).collect()
}

#[test]
fn the_bound_holds_for_every_small_torus() {
    let shown = shown();
    let possible: BTreeSet<u16> = shown.iter().flat_map(|(_, sets)| sets.iter().copied()).collect();
    let others = (1..=u16::MAX).step_by(701);
    let (mut sharp, mut searched) = (0, 0);
    for tiles in possible.iter().copied().step_by(5).chain(others) {
        let members = (0..16).filter(|i| tiles >> i & 1 == 1).map(TileId).collect();
        let two = Colors::one(2).unwrap();
        let set = TileSet::new(Kind::Corner, two, Members::Explicit(members)).unwrap();
        let with: Vec<Shape> = shown
            .iter()
            .filter_map(|(shape, sets)| sets.contains(&tiles).then_some(*shape))
            .collect();
        for shape in &with {
            assert_eq!(excluded(&set, *shape), Ok(None), "{tiles:016b} {shape}");
        }
        let least = with.iter().map(|shape| shape.cells() as u64).min();
        match bound(&set, 20_000, &Limits::NONE) {
            Ok(bound) => {
                let reason = &bound.reason;
                assert!(least.is_none_or(|least| bound.cells <= least), "{tiles:016b}: {reason}");
                sharp += u32::from(least == Some(bound.cells));
                searched += bound.searched.len();
                if let Some((shape, labels)) = bound.found {
                    assert_covering(&set, shape, &labels);
                    assert_eq!(shape.cells() as u64, bound.cells);
                }
            }
            Err(why) => {
                assert!(matches!(why, NoBound::Lonely { .. }));
                assert_eq!(least, None, "{tiles:016b}: {why}");
            }
        }
    }
    assert!(sharp > 50 && searched > 10, "{sharp} {searched}");
}

#[test]
fn bounds_of_pruned_sets() {
    for (colors, members, cells, searched) in [
        (3, "pruned:0-1", 33, "8x4"),
        (4, "pruned:0-1", 147, ""),
        (4, "pruned:0-1,2-3", 63, "10x6 12x5 15x4 20x3"),
        (5, "pruned:0-1", 432, ""),
        (5, "pruned:0-1,2-3", 261, ""),
        (2, "complete", 16, ""),
    ] {
        let bound = bound(&corner(colors, members), 5_000_000, &Limits::NONE).unwrap();
        let shapes: Vec<String> = bound.searched.iter().map(Shape::to_string).collect();
        assert_eq!((bound.cells, shapes.join(" ").as_str()), (cells, searched), "{members}");
    }
    let wang = TileSet::new(Kind::Wang, Colors::one(2).unwrap(), Members::Complete).unwrap();
    assert_eq!(bound(&wang, 0, &Limits::NONE), Err(NoBound::Kind(Kind::Wang)));
    assert_eq!(bound(&corner(2, "compact"), 0, &Limits::NONE), Err(NoBound::Compact));
}

#[test]
fn symmetries_keep_the_set_and_leave_enough_cells() {
    let set = corner(5, "pruned:0-1,2-3");
    let all = permutations(&set);
    assert!(all.len() >= 3, "{all:?}");
    for size in ["24x11", "17x16", "29x9", "18x18"] {
        let mut some = 0;
        for fold in folds(&all, shape(size)) {
            let orbits = anneal::orbits(&set, &fold).unwrap();
            assert!(orbits <= fold.cells() && fold.powers().len() > 1);
            some += 1;
        }
        assert_eq!(some > 0, size != "29x9", "{size}");
    }
}

#[test]
fn the_smallest_found() {
    let options = |threads, aspect| Options { threads, aspect, rounds: 3, ..Options::default() };
    let three = corner(3, "pruned:0-1");
    let found = smallest(&three, &options(1, f64::INFINITY), &Limits::NONE).unwrap();
    assert_eq!((found.bound.cells, found.covering.unwrap().shape), (33, shape("11x3")));
    let square = smallest(&three, &options(1, 1.3), &Limits::NONE).unwrap().covering.unwrap();
    assert_covering(&three, square.shape, &square.labels);
    assert!(square.shape.cells() <= 49 && square.shape.height() * 13 >= square.shape.width() * 10);

    let four = corner(4, "pruned:0-1");
    let [one, many] =
        [1, 3].map(|threads| smallest(&four, &options(threads, 2.0), &Limits::NONE).unwrap());
    assert_eq!(one, many);
    let covering = one.covering.unwrap();
    assert_covering(&four, covering.shape, &covering.labels);
    assert_eq!((one.bound.cells, covering.shape), (147, shape("15x10")));

    let here = on_torus(&four, shape("21x7"), None, &options(2, 1.0), &Limits::NONE).unwrap();
    assert_covering(&four, shape("21x7"), &here.covering.unwrap().labels);
}

#[test]
fn the_hunt_ends_with_its_limits() {
    let (set, options) =
        (corner(6, "pruned:0-1"), Options { rounds: u32::MAX, ..Options::default() });
    let none = smallest(&set, &options, &Limits { stop: &(), nodes: 0 }).unwrap();
    assert_eq!((none.covering, none.nodes, none.bound.cells), (None, 0, 994));
    let begin = Instant::now();
    let soon = begin + Duration::from_millis(300);
    let limits = Limits { stop: &soon, nodes: u64::MAX };
    smallest(&set, &options, &limits).unwrap();
    on_torus(&set, shape("71x14"), None, &options, &limits).unwrap();
    assert!(begin.elapsed() < Duration::from_secs(10));
    // With sides that no covering below has, it does not go on for ever.
    let four = corner(4, "pruned:0-1");
    let found = smallest(&four, &Options { aspect: 1.6, ..options }, &Limits::NONE).unwrap();
    assert_eq!(found.covering.unwrap().shape, shape("15x10"));
}
