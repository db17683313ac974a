//! First packings by beam search, by searches begun again and by portfolios, checked by reading every
//! window of the colors.

#![allow(clippy::unwrap_used, clippy::panic)]

mod portfolio;
mod restarts;
#[path = "../common/task.rs"]
mod task;

use std::collections::BTreeSet;
use std::time::{Duration, Instant};
use tilepack::beam::{self, Options, Outcome, Refusal};
use tilepack::packing::Task;
use tilepack::packing::reduction::Reduction;
use tilepack::search::Limits;
use tilepack::symmetry::{Canonizer, Group};
use tilepack::tiles::notation::parse_members;
use tilepack::tiles::{Colors, Corner, Kind, Members, TileError, TileId, TileSet};
use tilepack::torus::{Lattice, Pins, Shape};
use tilepack::verify;

fn set(kind: Kind, colors: u64, members: &str) -> TileSet {
    let members = parse_members(members).unwrap().unwrap();
    TileSet::new(kind, Colors::one(colors).unwrap(), members).unwrap()
}

fn corner(colors: u64, members: &str) -> TileSet {
    set(Kind::Corner, colors, members)
}

fn options(set: &TileSet, seed: u64) -> Options {
    Options { seed, ..Options::for_set(set) }
}

/// The windows of a torus of colors as (NW, NE, SW, SE).
fn windows(labels: &[u8], shape: Shape) -> Vec<[u8; 4]> {
    let (w, h) = (shape.width(), shape.height());
    let at = |r: usize, c: usize| labels[r % h * w + c % w];
    let window = |r, c| [at(r, c), at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)];
    (0..w * h).map(|i| window(i / w, i % w)).collect()
}

/// Panics unless the labels are a packing of the set, by two independent ways.
fn assert_packing(set: &TileSet, shape: Shape, outcome: &Outcome) {
    let labels = outcome.labels.as_deref().unwrap();
    let windows = windows(labels, shape);
    let different: BTreeSet<_> = windows.iter().copied().collect();
    assert_eq!(different.len() as u64, set.size(), "every window once");
    if set.is_compact() {
        let mut triples: Vec<_> = windows.iter().map(|&[nw, _, sw, se]| [nw, sw, se]).collect();
        triples.sort_unstable();
        assert!(triples.chunks(2).all(|pair| pair[0] == pair[1]), "two of each (NW, SW, SE)");
        assert!(triples.windows(3).all(|three| three[0] != three[2]));
    } else {
        let allowed = |&[nw, ne, sw, se]: &[u8; 4]| {
            set.allows(set.kind().pack(&[ne, se, sw, nw], set.colors()).unwrap())
        };
        assert!(windows.iter().all(allowed), "only tiles of the set");
    }
    let packing = Lattice { kind: Kind::Corner, shape }.packing(labels, set, false);
    let verdict = verify::check(&packing);
    assert!(verdict.is_valid(), "{verdict}");
}

#[test]
fn sets_of_every_sort_in_both_orientations() {
    for (colors, members, size) in [
        (2, "complete", "4x4"),
        (3, "complete", "9x9"),
        (3, "compact", "9x6"),
        (3, "compact", "6x9"),
        (2, "compact", "4x4"),
        (4, "complete", "16x16"),
        (4, "compact", "16x8"),
        (4, "compact", "8x16"),
        // 261, 716 and 994 tiles: sizes once said to have no packing.
        (5, "pruned:0-1,2-3", "29x9"),
        (5, "pruned:0-1,2-3", "9x29"),
        (6, "pruned:0-1,2-3", "179x4"),
        (6, "pruned:0-1", "142x7"),
    ] {
        let (set, shape) = (corner(colors, members), size.parse().unwrap());
        let outcome = beam::find(&set, shape, &options(&set, 1), &Limits::NONE).unwrap();
        assert_packing(&set, shape, &outcome);
    }
}

/// A set that reflection does not keep: the windows of a torus without symmetry.
fn windows_as_a_set(shape: Shape) -> TileSet {
    for start in 1u64.. {
        let mut state = start;
        let mut color = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as u8 % 5
        };
        let labels: Vec<u8> = (0..shape.cells()).map(|_| color()).collect();
        let colors = Colors::one(5).unwrap();
        let tile = |[nw, ne, sw, se]: [u8; 4]| {
            let [nw, ne, sw, se] = [nw, ne, sw, se].map(tilepack::tiles::Color);
            Corner { ne, se, sw, nw }.id(colors)
        };
        let tiles: Vec<TileId> = windows(&labels, shape).into_iter().map(tile).collect();
        match TileSet::new(Kind::Corner, colors, Members::Explicit(tiles)) {
            Ok(set) => return set,
            Err(TileError::DuplicateTile { .. }) => {}
            Err(error) => panic!("{error}"),
        }
    }
    unreachable!()
}

#[test]
fn explicit_sets_that_reflection_changes() {
    for size in ["7x5", "5x7", "3x8", "8x3", "1x6", "6x1", "2x7", "7x2"] {
        let shape: Shape = size.parse().unwrap();
        let set = windows_as_a_set(shape);
        // The row that the set was made from may hold all five colors.
        let options = Options { palette: 5, ..options(&set, 2) };
        let outcome = beam::find(&set, shape, &options, &Limits::NONE).unwrap();
        assert_packing(&set, shape, &outcome);
    }
}

#[test]
fn the_outcome_depends_on_the_seed_and_not_on_the_threads() {
    let (set, shape) = (corner(4, "complete"), Shape::new(16, 16).unwrap());
    let of = |seed, threads| {
        let options = Options { threads, width: 800, ..options(&set, seed) };
        beam::find(&set, shape, &options, &Limits::NONE).unwrap()
    };
    let [one, two, five] = [1, 2, 5].map(|threads| of(7, threads));
    assert_packing(&set, shape, &one);
    assert_eq!(one, two);
    assert_eq!(one, five);
    assert_ne!(one.labels, of(8, 1).labels);
}

/// The labels of a packing, all but some of them taken away, in either orientation.
#[test]
fn cells_given_beforehand_are_kept() {
    for (colors, members, size) in [
        (3, "complete", "9x9"),
        (3, "compact", "9x6"),
        (3, "compact", "6x9"),
        (2, "complete", "4x4"),
    ] {
        let (set, shape): (TileSet, Shape) = (corner(colors, members), size.parse().unwrap());
        let lattice = Lattice { kind: Kind::Corner, shape };
        let known = beam::find(&set, shape, &options(&set, 1), &Limits::NONE).unwrap();
        let known = known.labels.unwrap();
        for keep in
            [|r: usize, _: usize| r == 2, |r, c| (2..5).contains(&r) && c < 3, |_, c| c % 2 == 0]
        {
            let mut pins = Pins::free(lattice);
            for (i, &color) in known.iter().enumerate() {
                if keep(i / shape.width(), i % shape.width()) {
                    pins.pin(i, color).unwrap();
                }
            }
            let options = options(&set, 5);
            let outcome = beam::find_around(&set, shape, Some(&pins), &options, &Limits::NONE);
            let outcome = outcome.unwrap();
            assert_packing(&set, shape, &outcome);
            let labels = outcome.labels.unwrap();
            for (label, pin) in labels.iter().zip(pins.labels()) {
                assert!(pin.is_none_or(|pin| pin == *label), "{size}");
            }
        }
        // The window of one color twice.
        let mut pins = Pins::free(lattice);
        for i in [0, 1, 2, shape.width(), shape.width() + 1, shape.width() + 2] {
            pins.pin(i, 0).unwrap();
        }
        let refused = beam::find_around(&set, shape, Some(&pins), &options(&set, 0), &Limits::NONE);
        assert_eq!(refused, Err(Refusal::Pins), "{size}");
    }
}

#[test]
fn recursive_packings() {
    for colors in 1..=3 {
        let (set, side) = (corner(colors, "complete"), colors * colors);
        let shape = Shape::new(side, side).unwrap();
        let options = options(&set, 4);
        let outcome = beam::find_recursive(colors as usize, &options, &Limits::NONE).unwrap();
        assert_packing(&set, shape, &outcome);
        let packing = Lattice { kind: Kind::Corner, shape }.packing(
            outcome.labels.as_deref().unwrap(),
            &set,
            false,
        );
        let recursion = verify::check_recursion(&packing);
        assert_eq!((recursion.blocks.len() as u64, recursion.fault), (colors - 1, None));
        let again = Options { threads: 3, ..options };
        assert_eq!(beam::find_recursive(colors as usize, &again, &Limits::NONE), Ok(outcome));
    }
    let few = Limits { nodes: 1000, ..Limits::NONE };
    let options = options(&corner(4, "complete"), 0);
    assert_eq!(beam::find_recursive(4, &options, &few).unwrap().labels, None);
    assert!(matches!(
        beam::find_recursive(16, &Options { width: 1, ..options }, &few),
        Ok(Outcome { labels: None, .. })
    ));
}

/// How many symmetries of a torus, with any exchange of colors, map the labels to themselves: by
/// trying all of them. The first row tells what the exchange would have to be.
fn symmetries(labels: &[u8], shape: Shape) -> usize {
    let (w, h) = (shape.width(), shape.height());
    let mut kept = 0;
    for (turned, flipped, mirrored) in [false, true]
        .into_iter()
        .flat_map(|t| [(t, false, false), (t, true, false), (t, false, true), (t, true, true)])
    {
        if turned && w != h {
            continue;
        }
        for shift in 0..w * h {
            let image = |cell: usize| {
                let (r, c) = (cell / w, cell % w);
                let (r, c) = if turned { (c, r) } else { (r, c) };
                let (r, c) =
                    (if flipped { h - 1 - r } else { r }, if mirrored { w - 1 - c } else { c });
                (r + shift / w) % h * w + (c + shift % w) % w
            };
            let mut exchange = [None; 256];
            let fits = (0..w * h).all(|cell| {
                let to = labels[image(cell)];
                *exchange[usize::from(labels[cell])].get_or_insert(to) == to
            });
            let images: BTreeSet<u8> = exchange.iter().flatten().copied().collect();
            kept += usize::from(fits && images.len() == exchange.iter().flatten().count());
        }
    }
    kept
}

#[test]
fn what_is_found_has_no_symmetry() {
    // One that has: a shift by three columns adds 1 to every color.
    let nine = Shape::new(9, 9).unwrap();
    let shifted: Vec<u8> = (0..81).map(|i| (i / 9 * i % 3 + i % 9 / 3) as u8 % 3).collect();
    assert!(symmetries(&shifted, nine) >= 3);
    for (colors, members, size, all) in [
        (3, "complete", "9x9", true),
        (3, "complete", "9x9", false),
        (4, "complete", "16x16", false),
        (4, "compact", "16x8", true),
    ] {
        let (set, shape): (TileSet, Shape) = (corner(colors, members), size.parse().unwrap());
        let options = options(&set, 1);
        let options = if all { options.over_all_colors(&set) } else { options };
        assert_eq!(options.palette, if all { colors as usize } else { 2 });
        let outcome = beam::find(&set, shape, &options, &Limits::NONE).unwrap();
        assert_packing(&set, shape, &outcome);
        let labels = outcome.labels.unwrap();
        assert_eq!(symmetries(&labels, shape), 1, "{size}: only the identity");
        // The library agrees: no symmetry but the identity keeps it, so its orbit is the group.
        let group = Group::of(&set, shape, None).unwrap();
        let anchor = Reduction::anchored(&Task::new(set, shape)).anchor;
        let canonizer = Canonizer::new(&group, anchor);
        let size = canonizer.clone().classify(&canonizer.canonical(&labels));
        assert_eq!(size.unwrap().to_string(), group.order().to_string());
    }
}

#[test]
fn a_wider_beam_looks_at_more() {
    let (set, shape) = (corner(3, "complete"), Shape::new(9, 9).unwrap());
    let of = |width| {
        let options = Options { width, ..options(&set, 0) };
        beam::find(&set, shape, &options, &Limits::NONE).unwrap()
    };
    let (one, many) = (of(1), of(1000));
    // One state alone dies early and often.
    assert!(one.restart > many.restart, "{} {}", one.restart, many.restart);
    assert_packing(&set, shape, &one);
}

#[test]
fn limits_end_what_finds_nothing() {
    // 60 tiles have no packing in any shape, and a beam cannot know.
    let (set, shape) = (corner(4, "pruned:0-1,2-3"), Shape::new(10, 6).unwrap());
    for threads in [1, 3] {
        let options = Options { threads, ..options(&set, 0) };
        let limits = Limits { stop: &(), nodes: 200_000 };
        let outcome = beam::find(&set, shape, &options, &limits).unwrap();
        assert!(outcome.labels.is_none() && outcome.nodes >= 200_000, "{outcome:?}");
        assert!(outcome.depth > 20 && outcome.depth < 60 && outcome.restart > 0, "{outcome:?}");
    }
    let none = Limits { stop: &(), nodes: 0 };
    assert_eq!(beam::find(&set, shape, &options(&set, 0), &none).unwrap().nodes, 0);
    // A set without dominoes for a first row ends by its limit, too.
    let begin = Instant::now();
    let soon = begin + Duration::from_millis(100);
    let (five, thin) = (corner(5, "complete"), Shape::new(625, 1).unwrap());
    let limits = Limits { stop: &soon, nodes: u64::MAX };
    assert!(beam::find(&five, thin, &options(&five, 0), &limits).unwrap().labels.is_none());
    assert!(begin.elapsed() < Duration::from_secs(5));
}

#[test]
fn what_does_not_suit_is_refused() {
    let find = |set: &TileSet, size: &str, options: Options| {
        beam::find(set, size.parse().unwrap(), &options, &Limits::NONE).unwrap_err()
    };
    let wang = set(Kind::Wang, 2, "complete");
    assert_eq!(find(&wang, "4x4", options(&wang, 0)), Refusal::Kind(Kind::Wang));
    let three = corner(3, "complete");
    assert!(matches!(find(&three, "9x8", options(&three, 0)), Refusal::Size { tiles: 81, .. }));
    for width in [0, beam::MAX_WIDTH + 1] {
        let options = Options { width, ..options(&three, 0) };
        assert_eq!(find(&three, "9x9", options), Refusal::Width(width));
    }
    let large = corner(17, "complete");
    assert!(matches!(find(&large, "289x289", options(&large, 0)), Refusal::TooLarge { .. }));
    let lone = Members::Explicit(vec![TileId(1)]);
    let lone = TileSet::new(Kind::Corner, Colors::one(2).unwrap(), lone).unwrap();
    assert_eq!(find(&lone, "1x1", options(&lone, 0)), Refusal::Unbalanced);
}
