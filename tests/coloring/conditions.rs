//! Conditions: the search and the verifier, which share no code, agree; and what they accept is
//! read back from real tilings.

use crate::jeandel_rao;
use proptest::prelude::*;
use tilepack::aperiodic::coloring::condition::{Colored, Condition};
use tilepack::aperiodic::coloring::language::patterns_of_patch;
use tilepack::aperiodic::coloring::vertices::{Vertices, VerticesError};
use tilepack::aperiodic::decide::Tile;
use tilepack::aperiodic::patch::fill;
use tilepack::verify::{WayBack, check_corner_tiles};

/// A coloring that keeps apart what the pattern in the two rows and columns next to the vertex
/// keeps apart, up to a few classes that get a color of another.
fn merged(vertices: &Vertices, classes: usize, merges: &[(usize, usize)]) -> Vec<u8> {
    let near = |pattern: &Vec<usize>| [pattern[2], pattern[3], pattern[4], pattern[5]];
    let mut names: Vec<[usize; 4]> = vertices.patterns.iter().map(near).collect();
    names.sort_unstable();
    names.dedup();
    let mut color: Vec<usize> = (0..names.len()).collect();
    for &(one, other) in merges {
        let (one, other) = (color[one % names.len()], color[other % names.len()]);
        color.iter_mut().filter(|color| **color == one).for_each(|color| *color = other);
    }
    assert!(names.len() <= classes);
    let number = |pattern| names.iter().position(|&name| name == near(pattern)).unwrap();
    vertices.patterns.iter().map(|pattern| color[number(pattern)] as u8).collect()
}

fn agree(vertices: &Vertices, colors: &[u8]) -> Result<(), TestCaseError> {
    let colored = Colored::new(vertices, colors);
    let tiles: Vec<[u32; 4]> = colored.tiles.iter().map(|tile| tile.map(u32::from)).collect();
    let verdict = check_corner_tiles(&vertices.wang, &tiles, &colored.image);
    for (condition, way_back) in [
        (Condition::Pair, WayBack::Pair),
        (Condition::Radius(1), WayBack::Radius1),
        (Condition::Radius(2), WayBack::Radius2),
    ] {
        let ours = colored.meets(condition, &vertices.wang);
        let theirs = verdict.as_ref().is_ok_and(|&found| found <= way_back);
        prop_assert_eq!(ours, theirs, "{:?} {:?}", condition, verdict);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn the_search_and_the_verifier_agree(
        merges in prop::collection::vec((0usize..1000, 0usize..1000), 0..12),
    ) {
        let (_, vertices) = jeandel_rao([4, 2]);
        agree(&vertices, &merged(&vertices, 64, &merges))?;
    }
}

#[test]
fn every_tiling_by_found_corner_tiles_is_read() {
    // The published set, all its 5 x 5 patches with a margin; read by its own options.
    let certificate = crate::read(crate::PUBLISHED);
    let tiles = &certificate.tiles;
    // A corner tile as a Wang tile whose labels are pairs of colors.
    let pair = |a: u32, b: u32| 4 * a + b;
    let as_wang: Vec<Tile> = tiles
        .iter()
        .map(|&[nw, ne, se, sw]| [pair(nw, ne), pair(ne, se), pair(sw, se), pair(nw, sw)])
        .collect();
    for seed in 0..5 {
        let (rows, columns) = (14, 14);
        let filled = fill(&as_wang, columns, rows, seed, &()).unwrap().cells;
        let options =
            |row: usize, column: usize| &certificate.options[filled[row * columns + column]];
        let read = |row: usize, column: usize| {
            let fits = |&&wang: &&usize| {
                let [n, e, s, w] = certificate.wang[wang];
                options(row - 1, column).iter().any(|&o| certificate.wang[o][2] == n)
                    && options(row, column + 1).iter().any(|&o| certificate.wang[o][3] == e)
                    && options(row + 1, column).iter().any(|&o| certificate.wang[o][0] == s)
                    && options(row, column - 1).iter().any(|&o| certificate.wang[o][1] == w)
            };
            let all = options(row, column);
            let left: Vec<usize> = match all.len() {
                1 => all.clone(),
                _ => all.iter().filter(fits).copied().collect(),
            };
            assert_eq!(left.len(), 1, "row {row}, column {column}");
            certificate.wang[left[0]]
        };
        for (row, column) in (3..11).flat_map(|row| (3..11).map(move |column| (row, column))) {
            assert_eq!(read(row, column)[1], read(row, column + 1)[3]);
            assert_eq!(read(row, column)[2], read(row + 1, column)[0]);
        }
    }
}

#[test]
fn a_set_that_reads_nothing_is_refused() {
    // One color: every Wang tile is an option everywhere.
    let (_, vertices) = jeandel_rao([4, 2]);
    let colored = Colored::new(&vertices, &[0; 107]);
    assert_eq!(colored.tiles, [[0; 4]]);
    for condition in [Condition::Pair, Condition::Radius(1), Condition::Radius(2)] {
        assert!(!colored.meets(condition, &vertices.wang));
    }
    agree(&vertices, &[0; 107]).unwrap();
    let missing = check_corner_tiles(&vertices.wang, &[[0; 4]], &[vec![]]).unwrap_err();
    assert!(missing.to_string().starts_with("corner tiles: "), "{missing}");
    let unknown = check_corner_tiles(&vertices.wang, &[[0; 4]], &[vec![11]]);
    assert!(unknown.is_err());
}

#[test]
fn vertices_touch_four_tiles() {
    let wang = vec![[0, 0, 0, 0]];
    let windows = patterns_of_patch(&[vec![0; 3], vec![0; 3]], [2, 3]);
    assert_eq!(windows.len(), 1);
    let small = Vertices::new(wang.clone(), [1, 2], &windows);
    assert_eq!(small, Err(VerticesError::Small(1, 2)));
    let none = Vertices::new(wang, [2, 2], &patterns_of_patch(&[], [3, 3]));
    assert_eq!(none, Err(VerticesError::None(3, 3)));
}
