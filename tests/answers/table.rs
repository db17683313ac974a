//! The table of known answers.
//!
//! Sources: (C!)^C rings of dominoes by the BEST theorem; 32 and 203,520 (Lagae 2007, 5.5 has
//! the 32 as one packing in disguise); the others were first counted by other means: the oracle
//! of these tests, or independent programs.

use crate::engines::Effort::{All, Each, Reduced};
use crate::engines::{Effort, agreed_count, agreed_orbits, check_against_oracle, check_first};
use crate::oracle;
use tilepack::packing::{Settings, Task, count};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{TileSet, notation};
use tilepack::torus::Shape;

/// A task in words: kind, colors, set, size (empty: the usual one), automorphism (or none).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Words<'a>(
    pub(crate) &'a str,
    pub(crate) &'a str,
    pub(crate) &'a str,
    pub(crate) &'a str,
    pub(crate) &'a str,
);

impl Words<'_> {
    pub(crate) fn task(self) -> Task {
        let Words(kind, colors, members, size, automorphism) = self;
        let members = notation::parse_members(members).unwrap().unwrap();
        let set = TileSet::new(kind.parse().unwrap(), colors.parse().unwrap(), members).unwrap();
        let shape = match size {
            "" => Shape::default_for(&set).unwrap(),
            _ => size.parse().unwrap(),
        };
        let mut task = Task::new(set, shape);
        if !automorphism.is_empty() {
            let parsed = Automorphism::parse(automorphism, task.set.colors(), shape);
            task.automorphism = Some(parsed.unwrap());
        }
        task
    }
}

/// Who else counts.
#[derive(Debug, Clone, Copy, PartialEq)]
enum By {
    /// The oracle too.
    Oracle,
    /// The engines only: too much for the oracle.
    Engines,
}
use By::{Engines, Oracle};

/// Task, packings, packings up to symmetry if known, who counts, how thoroughly.
type Row = (Words<'static>, u64, Option<u64>, By, Effort);

const KNOWN: &[Row] = &[
    // Complete sets.
    (Words("corner", "2", "complete", "4x4", ""), 32, Some(1), Oracle, All),
    (Words("corner", "2", "complete", "2x8", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "complete", "8x2", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "complete", "16x1", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "complete", "1x16", ""), 0, Some(0), Oracle, All),
    (Words("wang", "2", "complete", "4x4", ""), 203_520, Some(538), Engines, Each),
    // Rings of dominoes: (C!)^C.
    (Words("domino", "1", "complete", "", ""), 1, Some(1), Oracle, All),
    (Words("domino", "2", "complete", "", ""), 4, Some(1), Oracle, All),
    (Words("domino", "3", "complete", "", ""), 216, Some(2), Oracle, All),
    (Words("domino", "4", "complete", "", ""), 331_776, Some(432), Engines, Each),
    (Words("domino", "2", "complete", "1x4", ""), 4, Some(1), Oracle, All),
    (Words("domino", "3", "complete", "1x9", ""), 216, Some(2), Oracle, All),
    (Words("domino", "4", "complete", "1x16", ""), 331_776, Some(432), Engines, Each),
    // One color of one kind of edge: rings of dominoes again.
    (Words("wang", "1,2", "complete", "4x1", ""), 4, Some(1), Oracle, All),
    (Words("wang", "2,1", "complete", "1x4", ""), 4, Some(1), Oracle, All),
    (Words("wang", "1,3", "complete", "", ""), 216, Some(2), Oracle, All),
    (Words("wang", "3,1", "complete", "", ""), 216, Some(2), Oracle, All),
    (Words("wang", "1,4", "complete", "", ""), 331_776, Some(432), Engines, Each),
    // One color of everything.
    (Words("corner", "1", "complete", "", ""), 1, Some(1), Oracle, All),
    (Words("wang", "1", "complete", "", ""), 1, Some(1), Oracle, All),
    (Words("corner", "1", "compact", "2x1", ""), 0, Some(0), Oracle, All),
    (Words("corner", "1", "compact", "1x2", ""), 0, Some(0), Oracle, All),
    (Words("wang", "1", "compact", "2x1", ""), 0, Some(0), Oracle, All),
    // Compact sets.
    (Words("corner", "2", "compact", "4x4", ""), 32, Some(1), Oracle, All),
    (Words("corner", "2", "compact", "8x2", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "compact", "2x8", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "compact", "16x1", ""), 0, Some(0), Oracle, All),
    (Words("corner", "2", "compact", "1x16", ""), 0, Some(0), Oracle, All),
    (Words("wang", "2", "compact", "4x2", ""), 1408, Some(60), Oracle, All),
    (Words("wang", "2", "compact", "2x4", ""), 1408, Some(60), Oracle, All),
    (Words("wang", "2", "compact", "8x1", ""), 576, Some(20), Oracle, All),
    (Words("wang", "2", "compact", "1x8", ""), 576, Some(20), Oracle, All),
    // Pruned sets.
    (Words("corner", "3", "pruned:0-1", "31x1", ""), 0, Some(0), Oracle, All),
    (Words("corner", "3", "pruned:0-1", "1x31", ""), 0, Some(0), Oracle, All),
    (Words("domino", "3", "pruned:0-1", "", ""), 14, Some(1), Oracle, All),
    (Words("domino", "3", "pruned:0-1", "1x7", ""), 14, Some(1), Oracle, All),
    (Words("corner", "2", "pruned:0-1", "2x1", ""), 0, Some(0), Oracle, All),
    (Words("wang", "2", "pruned:0-1", "1x2", ""), 0, Some(0), Oracle, All),
    (Words("wang", "3", "pruned:0-1", "31x1", ""), 0, Some(0), Engines, Each),
    (Words("wang", "1,3", "pruned:0-1", "2x2", ""), 0, Some(0), Oracle, All),
    (Words("wang", "1,3", "pruned:0-1", "4x1", ""), 4, Some(1), Oracle, All),
    (Words("wang", "1,3", "pruned:1-2", "7x1", ""), 14, Some(1), Oracle, All),
    // Those that have an automorphism.
    (Words("wang", "2", "complete", "", "2,0:1,0"), 1536, Some(18), Oracle, All),
    (Words("wang", "2", "complete", "", "2,2:1,0"), 1024, Some(11), Oracle, All),
    (Words("corner", "2", "complete", "", "2,2:1,0"), 32, Some(1), Oracle, All),
    (Words("corner", "2", "complete", "", "2,0:1,0"), 0, Some(0), Oracle, All),
    (Words("corner", "2", "complete", "", "0,2:+1"), 0, Some(0), Oracle, All),
    (Words("corner", "3", "complete", "", "3,0:+1"), 303_264, None, Engines, Reduced),
];

#[test]
fn known_answers() {
    for &(words, packings, orbits, by, effort) in KNOWN {
        let (task, what) = (words.task(), format!("{words:?}"));
        match by {
            Oracle => assert_eq!(check_against_oracle(&task, effort, &what), packings, "{what}"),
            Engines => {
                assert_eq!(agreed_count(&task, effort, &what), packings, "{what}");
                check_first(&task, packings > 0, effort, &what);
                assert!(packings == 0 || task.impossible().is_none(), "{what}");
            }
        }
        if let Some(orbits) = orbits {
            assert_eq!(agreed_orbits(&task, Each, &what), orbits, "{what}");
        }
    }
}

/// Complete corner sets on narrow tori: also said without a search.
#[test]
fn a_short_argument() {
    for size in ["2x8", "8x2", "16x1", "1x16"] {
        assert!(Words("corner", "2", "complete", size, "").task().impossible().is_some());
    }
    for size in ["31x1", "1x31"] {
        assert!(Words("corner", "3", "pruned:0-1", size, "").task().impossible().is_some());
    }
    assert!(Words("corner", "1", "compact", "2x1", "").task().impossible().is_some());
    assert!(Words("corner", "2", "complete", "", "").task().impossible().is_none());
}

/// The rings of 25 dominoes, (5!)^5: too many to look at one by one, but a reduced search
/// counts them.
#[test]
fn rings_of_five_colors() {
    let task = Words("domino", "5", "complete", "", "").task();
    let counted = count(&task, &Settings { threads: 2, ..Settings::PLAIN }, false).unwrap();
    assert_eq!(counted.value.packings, 120u64.pow(5).into());
    assert_eq!(counted.value.up_to_translation, Some(995_328_000u64.into()));
}

/// The sixteen Wang tiles over two colors, counted by the oracle too.
#[test]
fn wang_tiles_of_two_colors() {
    for (size, packings) in [("4x4", 203_520), ("8x2", 228_096), ("2x8", 228_096), ("16x1", 0)] {
        let task = Words("wang", "2", "complete", size, "").task();
        assert_eq!(oracle::count(&task), packings, "{size}");
        assert_eq!(agreed_count(&task, Each, size), packings, "{size}");
    }
}

/// The 60 tiles over four colors with the pairs 0-1 and 2-3 excluded have no packing in any
/// shape: by argument where a side is below 3, else by complete searches.
#[test]
fn sixty_pruned_tiles_have_no_packing() {
    for size in ["6x10", "10x6", "5x12", "12x5", "4x15", "15x4", "3x20", "20x3"] {
        let task = Words("corner", "4", "pruned:0-1,2-3", size, "").task();
        assert_eq!(task.impossible(), None, "{size}");
        let answer = count(&task, &Settings { threads: 2, ..Settings::PLAIN }, false).unwrap();
        assert!(answer.work.complete, "{size}");
        assert_eq!(answer.value.packings, 0u32.into(), "{size}");
    }
    for size in ["2x30", "30x2", "1x60", "60x1"] {
        let task = Words("corner", "4", "pruned:0-1,2-3", size, "").task();
        assert!(task.impossible().is_some(), "{size}");
    }
}
