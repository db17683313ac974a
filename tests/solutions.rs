//! The packings in `solutions/`: all of them valid, all of them listed, and those that do not
//! take long written again byte for byte.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tilepack::store::{Claim, Input, read_cubes, read_solution};
use tilepack::tiles::{Colors, Kind, Members};
use tilepack::tiling::{Rule, alternating};
use tilepack::torus::CubeKind;
use tilepack::verify;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("solutions")
}

fn names() -> BTreeSet<String> {
    let entries = fs::read_dir(folder()).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.ends_with(".json")).collect()
}

/// Name, kind, colors, tiles.
const WANTED: &[(&str, Kind, &str, usize)] = &[
    ("corner-complete-2-4x4.json", Kind::Corner, "2", 16),
    ("corner-complete-3-9x9.json", Kind::Corner, "3", 81),
    ("corner-complete-4-16x16.json", Kind::Corner, "4", 256),
    ("corner-compact-3-9x6.json", Kind::Corner, "3", 54),
    ("corner-compact-4-16x8.json", Kind::Corner, "4", 128),
    ("corner-compact-4-16x8-unrestricted.json", Kind::Corner, "4", 128),
    ("corner-pruned-3-1-cover-11x3.json", Kind::Corner, "3", 33),
    ("corner-pruned-4-1-cover-21x7.json", Kind::Corner, "4", 147),
    ("corner-pruned-4-1-cover-15x10.json", Kind::Corner, "4", 150),
    ("corner-pruned-4-2-cover-22x3.json", Kind::Corner, "4", 66),
    ("corner-pruned-5-1-cover-24x18.json", Kind::Corner, "5", 432),
    ("corner-pruned-5-2-29x9.json", Kind::Corner, "5", 261),
    ("corner-pruned-5-2-cover-22x12.json", Kind::Corner, "5", 264),
    ("corner-pruned-5-2-cover-17x16.json", Kind::Corner, "5", 272),
    ("corner-pruned-6-1-142x7.json", Kind::Corner, "6", 994),
    ("corner-pruned-6-1-cover-36x28.json", Kind::Corner, "6", 1008),
    ("corner-pruned-6-1-cover-32x32.json", Kind::Corner, "6", 1024),
    ("corner-pruned-6-2-179x4.json", Kind::Corner, "6", 716),
    ("corner-pruned-6-2-cover-30x24.json", Kind::Corner, "6", 720),
    ("corner-pruned-6-3-66x7.json", Kind::Corner, "6", 462),
    ("corner-pruned-6-3-77x6.json", Kind::Corner, "6", 462),
    ("corner-pruned-6-3-cover-39x12.json", Kind::Corner, "6", 468),
    ("corner-pruned-6-3-cover-27x18.json", Kind::Corner, "6", 486),
    ("corner-pruned-6-3-cover-24x21.json", Kind::Corner, "6", 504),
    ("wang-complete-2-4x4.json", Kind::Wang, "2", 16),
    ("wang-complete-3-9x9.json", Kind::Wang, "3", 81),
    ("wang-complete-2-3-9x4.json", Kind::Wang, "2,3", 36),
    ("wang-compact-3-6x3.json", Kind::Wang, "3", 18),
    ("corner-constructed-2.json", Kind::Corner, "2", 16),
    ("corner-constructed-3.json", Kind::Corner, "3", 81),
    ("corner-constructed-4.json", Kind::Corner, "4", 256),
    ("corner-constructed-5.json", Kind::Corner, "5", 625),
    ("corner-constructed-6.json", Kind::Corner, "6", 1296),
    ("corner-constructed-7.json", Kind::Corner, "7", 2401),
    ("corner-constructed-8.json", Kind::Corner, "8", 4096),
    ("corner-compact-2.json", Kind::Corner, "2", 16),
    ("corner-compact-3.json", Kind::Corner, "3", 54),
    ("corner-compact-4.json", Kind::Corner, "4", 128),
    ("corner-compact-5.json", Kind::Corner, "5", 250),
    ("corner-compact-6.json", Kind::Corner, "6", 432),
    ("corner-compact-7.json", Kind::Corner, "7", 686),
    ("corner-compact-8.json", Kind::Corner, "8", 1024),
    ("wang-compact-2.json", Kind::Wang, "2", 8),
    ("wang-compact-3.json", Kind::Wang, "3", 18),
    ("wang-compact-4.json", Kind::Wang, "4", 32),
    ("wang-compact-5.json", Kind::Wang, "5", 50),
    ("wang-compact-6.json", Kind::Wang, "6", 72),
    ("wang-compact-7.json", Kind::Wang, "7", 98),
    ("wang-compact-8.json", Kind::Wang, "8", 128),
    ("corner-difference-3-9x6.json", Kind::Corner, "3", 54),
    ("corner-difference-4-16x8.json", Kind::Corner, "4", 128),
    ("corner-difference-4-8x16.json", Kind::Corner, "4", 128),
    ("corner-xor-4-8x16.json", Kind::Corner, "4", 128),
    ("corner-diagonal-3-9x6.json", Kind::Corner, "3", 54),
    ("corner-diagonal-4-16x8.json", Kind::Corner, "4", 128),
    ("wang-alternating-3-9x3.json", Kind::Wang, "3", 27),
    ("wang-alternating-4-8x8.json", Kind::Wang, "4", 64),
    ("corner-recursive-3-9x9.json", Kind::Corner, "3", 81),
    ("corner-recursive-4-16x16.json", Kind::Corner, "4", 256),
    ("wang-recursive-3-9x9.json", Kind::Wang, "3", 81),
    ("wang-recursive-4-16x16.json", Kind::Wang, "4", 256),
    ("domino-complete-2.json", Kind::Domino, "2", 4),
    ("domino-complete-3.json", Kind::Domino, "3", 9),
    ("domino-complete-4.json", Kind::Domino, "4", 16),
    ("domino-complete-5.json", Kind::Domino, "5", 25),
    ("domino-complete-6.json", Kind::Domino, "6", 36),
    ("domino-complete-7.json", Kind::Domino, "7", 49),
    ("domino-complete-8.json", Kind::Domino, "8", 64),
];

/// Packings of cubes: name, kind, sides (layers, rows, columns).
const CUBES: &[(&str, CubeKind, [usize; 3])] = &[
    ("cube-corner-2-8x8x4.json", CubeKind::Corner, [4, 8, 8]),
    ("cube-wang-2-4x4x4.json", CubeKind::Wang, [4, 4, 4]),
];

/// Pruned sets whose packings and coverings are found in about a second.
const QUICK: &[&str] = &[
    "corner-pruned-3-1-cover-11x3.json",
    "corner-pruned-4-1-cover-21x7.json",
    "corner-pruned-4-1-cover-15x10.json",
    "corner-pruned-5-1-cover-24x18.json",
];

#[test]
fn all_are_valid() {
    let tiles = WANTED.iter().map(|row| row.0);
    let wanted: BTreeSet<String> =
        tiles.chain(CUBES.iter().map(|row| row.0)).map(str::to_owned).collect();
    assert_eq!(names(), wanted, "files and the table of this test");
    for &(name, kind, colors, tiles) in WANTED {
        let input = Input::open(folder().join(name)).unwrap();
        let solution = read_solution(&input, &Claim::default()).unwrap();
        let packing = &solution.packing;
        assert_eq!(packing.set.kind(), kind, "{name}");
        assert_eq!(packing.set.colors(), colors.parse::<Colors>().unwrap(), "{name}");
        assert_eq!(packing.tiles.len(), tiles, "{name}");
        assert!(verify::check(packing).is_valid(), "{name}: {}", verify::check(packing));
        assert!(solution.provenance.get("method").is_some(), "{name} has no provenance");
        if name.contains("recursive") {
            let recursion = verify::check_recursion(packing);
            let depth = packing.set.colors().largest() - 1;
            assert_eq!((recursion.blocks.len(), recursion.fault), (depth, None), "{name}");
        }
    }
    for &(name, kind, sides) in CUBES {
        let solution = read_cubes(&Input::open(folder().join(name)).unwrap()).unwrap();
        assert_eq!((solution.packing.set.kind, solution.packing.sides), (kind, sides), "{name}");
        assert_eq!(verify::check_cube_packing(&solution.packing), Ok(()), "{name}");
        assert!(solution.provenance.get("method").is_some(), "{name} has no provenance");
    }
}

#[test]
fn the_published_packing_is_valid() {
    let input = Input::open(folder().join("published/lagae-dutre-2006-corner-4.txt")).unwrap();
    let claim = Claim {
        kind: Some(Kind::Corner),
        colors: Some(Colors::one(4).unwrap()),
        ..Claim::default()
    };
    let solution = read_solution(&input, &claim).unwrap();
    assert!(verify::check(&solution.packing).is_valid());
    let recursion = verify::check_recursion(&solution.packing);
    let blocks: Vec<_> = recursion.blocks.iter().map(|b| (b.width, b.at.row)).collect();
    assert_eq!((blocks, recursion.fault), (vec![(9, 7), (4, 12), (1, 15)], None));
}

#[test]
fn commands_write_the_files_again() {
    let readme = fs::read_to_string(folder().join("README.md")).unwrap();
    let target = tempfile::tempdir().unwrap();
    let (mut written, mut skipped) = (0, 0);
    for row in readme.lines().filter(|line| line.starts_with("| `")) {
        let code: Vec<&str> = row.split('`').skip(1).step_by(2).collect();
        let &[name, command] = &code[..] else { continue };
        // A matter of seconds to a minute, but not for a test.
        if name.contains("unrestricted") || name.contains("pruned") && !QUICK.contains(&name) {
            skipped += 1;
            continue;
        }
        let colors = if name.contains("-C.") { 2..=8 } else { 0..=0 };
        for c in colors {
            let (name, command) = (
                name.replace("-C.", &format!("-{c}.")),
                command.replace("colors C", &format!("colors {c}")),
            );
            let out = target.path().join(&name);
            let mut again = std::process::Command::new(env!("CARGO_BIN_EXE_tilepack"));
            again.args(command.split(' ').skip(1)).arg("--quiet").arg("-o").arg(&out);
            assert!(again.status().unwrap().success(), "{command}");
            let read = |path: PathBuf| fs::read_to_string(path).unwrap();
            assert_eq!(read(out), read(folder().join(&name)), "{name}");
            written += 1;
        }
    }
    // One covering has no command, nor have the packings of sets with a direct tiling: six found by a
    // SAT solver, two of sets in files.
    assert_eq!(written + skipped, WANTED.len() + CUBES.len() - 9);
}

/// The packings of sets that are tiled directly are of those very sets.
#[test]
fn sets_with_a_direct_tiling_are_packed() {
    for (name, rule) in [
        ("corner-difference-3-9x6.json", Rule::Difference),
        ("corner-difference-4-16x8.json", Rule::Difference),
        ("corner-difference-4-8x16.json", Rule::Difference),
        ("corner-xor-4-8x16.json", Rule::Xor),
        ("corner-diagonal-3-9x6.json", Rule::Diagonal),
        ("corner-diagonal-4-16x8.json", Rule::Diagonal),
    ] {
        let input = Input::open(folder().join(name)).unwrap();
        let packing = read_solution(&input, &Claim::default()).unwrap().packing;
        assert_eq!(packing.set, rule.set(packing.set.colors()).unwrap(), "{name}");
    }
    for (name, colors) in [("wang-alternating-3-9x3.json", 3), ("wang-alternating-4-8x8.json", 4)] {
        let input = Input::open(folder().join(name)).unwrap();
        let packing = read_solution(&input, &Claim::default()).unwrap().packing;
        let members = Members::Explicit(alternating(colors));
        assert_eq!(packing.set.members(), &members, "{name}");
    }
}
