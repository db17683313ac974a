//! Right packings are accepted, wrong ones refused with the right fault, and verify agrees with
//! an oracle that is too slow and too simple to be wrong.

#![allow(clippy::unwrap_used, clippy::panic)]

use proptest::prelude::*;
use std::path::PathBuf;
use tilepack::store::{Claim, Input, read_solution};
use tilepack::tiles::{Color, Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Lattice, Packing, Shape};
use tilepack::verify::{Fault, KEPT, check};

const CORNER_2: &str = "kind=corner colors=2\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1";
const WANG_2: &str = "kind=wang colors=2\n0 4 5 1\n2 6 7 3\n10 14 15 11\n8 12 13 9";
const WANG_2_1: &str = "kind=wang colors=2,1\n0\n1\n3\n2";
const COMPACT_WANG: &str = "kind=wang colors=2 set=compact\n15 7 13 5\n10 8 2 0";
const COMPACT_CORNER: &str = include_str!("data/compact-corner-3.txt");
const RING: &str = "kind=domino colors=2\n0 1 3 2";
const COLUMN: &str = "kind=domino colors=2,3\n0\n1\n3\n2";
const PRUNED_RING: &str = "kind=domino colors=3 set=pruned:0-1\n0 2 8 7 4 5 6";
const PRUNED_WANG: &str = "kind=wang colors=1,3 set=pruned:0-1\n0 6 8 2";
const EXPLICIT: &str = "kind=wang colors=2 set=tiles:0,4,5,1\n0 4 5 1";
const COVERING: &str = "kind=corner colors=2 cover\n\
    0 0 0 1 0 0 0 1\n0 0 1 0 0 0 1 0\n1 0 1 1 1 0 1 1\n0 1 1 1 0 1 1 1";
const COMPACT_COVERING: &str =
    "kind=wang colors=2 set=compact cover\n15 7 13 5 15 7 13 5\n10 8 2 0 10 8 2 0";
const ONE_COLOR: &str = "kind=corner colors=1\n0";

fn packing(text: &str) -> Packing {
    let input = Input::from_bytes("test", text.into()).unwrap();
    // What a text without a first line is.
    let claim = Claim {
        kind: Some(Kind::Corner),
        colors: Some(Colors::one(4).unwrap()),
        ..Claim::default()
    };
    let claim = if text.contains("kind=") { Claim::default() } else { claim };
    read_solution(&input, &claim).unwrap().packing
}

#[test]
fn right_packings_are_accepted() {
    for text in [
        CORNER_2,
        WANG_2,
        WANG_2_1,
        COMPACT_WANG,
        COMPACT_CORNER,
        RING,
        COLUMN,
        PRUNED_RING,
        PRUNED_WANG,
        EXPLICIT,
        COVERING,
        COMPACT_COVERING,
        ONE_COLOR,
        "kind=wang colors=1\n0",
        "kind=domino colors=1\n0",
        "kind=domino colors=2 set=tiles:1,2\n1\n2",
        "kind=corner colors=2 set=compact\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 1",
    ] {
        let packing = packing(text);
        assert_eq!(check(&packing).to_string(), "valid", "{text}");
        assert!(check(&packing).is_valid() && oracle(&packing), "{text}");
    }
}

#[test]
fn the_published_packing_of_lagae_and_dutre_is_right() {
    let file =
        concat!(env!("CARGO_MANIFEST_DIR"), "/solutions/published/lagae-dutre-2006-corner-4.txt");
    let claim = Claim {
        kind: Some(Kind::Corner),
        colors: Some(Colors::one(4).unwrap()),
        ..Claim::default()
    };
    let packing = read_solution(&Input::open(file).unwrap(), &claim).unwrap().packing;
    assert_eq!(packing.shape.to_string(), "16x16");
    assert_eq!(packing.set.members(), &Members::Complete);
    assert!(check(&packing).is_valid() && oracle(&packing));
}

fn with_set(packing: &mut Packing, members: Members) {
    packing.set = TileSet::new(packing.set.kind(), packing.set.colors(), members).unwrap();
}

fn resize(packing: &mut Packing, width: u64, height: u64) {
    packing.shape = Shape::new(width, height).unwrap();
    let tiles = packing.tiles.clone();
    packing.tiles = tiles.into_iter().cycle().take(packing.shape.cells()).collect();
}

/// The packing whose tile at this place has one color changed; the place is a digit, the most
/// significant first.
fn recolor(packing: &mut Packing, index: usize, digit: usize, color: u8) {
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let mut sides = kind.unpack(packing.tiles[index], colors);
    sides[digit] = color;
    packing.tiles[index] = kind.pack(&sides[..kind.sides().len()], colors).unwrap();
}

/// What is wrong, the right packing to begin with, what is done to it, and the message.
type Wrong = (&'static str, &'static str, fn(&mut Packing), &'static str);

const WRONG: &[Wrong] = &[
    // One color changed.
    (
        "a corner of one tile",
        CORNER_2,
        |p| recolor(p, 7, 0, 1),
        "row 0, column 3: SE corner has color 0, but the tile to the south (row 1, column 3) has \
         color 1 on its NE corner (and 3 more faults)",
    ),
    (
        "a lattice color",
        "kind=corner colors=2\n0 0 0 1\n0 0 1 0\n1 0 1 1\n0 1 1 0",
        |_| {},
        "tile 2 (NE 0, SE 0, SW 1, NW 0) occurs 2 times: at row 1, column 0 and row 3, column 3 \
         (and 5 more faults)",
    ),
    (
        "an edge, seen across the eastern seam",
        WANG_2,
        |p| recolor(p, 3, 1, 1),
        "row 0, column 3: east side has color 1, but the tile to the east (row 0, column 0) has \
         color 0 on its west side (and 2 more faults)",
    ),
    (
        "an edge, seen across the southern seam",
        WANG_2,
        |p| recolor(p, 12, 2, 1),
        "row 3, column 0: south side has color 1, but the tile to the south (row 0, column 0) has \
         color 0 on its north side (and 2 more faults)",
    ),
    (
        "an end of a domino",
        RING,
        |p| recolor(p, 3, 1, 1),
        "row 0, column 3: second end has color 1, but the tile to the east (row 0, column 0) has \
         color 0 on its first end (and 2 more faults)",
    ),
    (
        "an end of a domino in a column",
        COLUMN,
        |p| recolor(p, 1, 0, 1),
        "row 0, column 0: second end has color 0, but the tile to the south (row 1, column 0) has \
         color 1 on its first end (and 2 more faults)",
    ),
    // Two tiles swapped, a row rotated.
    (
        "two tiles swapped",
        WANG_2,
        |p| p.tiles.swap(5, 10),
        "row 0, column 1: south side has color 0, but the tile to the south (row 1, column 1) has \
         color 1 on its north side (and 3 more faults)",
    ),
    (
        "a row of Wang tiles rotated",
        COMPACT_WANG,
        |p| p.tiles[..4].rotate_left(1),
        "row 0, column 1: south side has color 0, but the tile to the south (row 1, column 1) has \
         color 1 on its north side (and 5 more faults)",
    ),
    (
        "a row of corner tiles rotated",
        CORNER_2,
        |p| p.tiles[4..8].rotate_left(1),
        "row 0, column 0: SE corner has color 0, but the tile to the south (row 1, column 0) has \
         color 1 on its NE corner (and 7 more faults)",
    ),
    (
        "a row of lattice colors rotated",
        "kind=corner colors=2\n0 0 0 1\n0 1 0 0\n1 0 1 1\n0 1 1 1",
        |_| {},
        "tile 5 (NE 0, SE 1, SW 0, NW 1) occurs 2 times: at row 1, column 1 and row 2, column 0 \
         (and 5 more faults)",
    ),
    (
        "a row of the published packing rotated",
        include_str!("../solutions/published/lagae-dutre-2006-corner-4.txt"),
        |p| p.tiles[32..48].rotate_right(1),
        "row 1, column 0: SW corner has color 3, but the tile to the south (row 2, column 0) has \
         color 1 on its NW corner (and 53 more faults)",
    ),
    // Tiles that occur again, or not at all.
    (
        "a duplicate that fits",
        "kind=domino colors=2\n0 0 1 2",
        |_| {},
        "tile 0 (first 0, second 0) occurs 2 times: at row 0, column 0 and row 0, column 1 \
         (and 1 more fault)",
    ),
    (
        "a covering with a missing tile",
        "kind=domino colors=2 cover\n0 0 0 1 2 1 2",
        |_| {},
        "tile 3 (first 1, second 1) is missing",
    ),
    (
        "all tiles the same",
        "kind=corner colors=2\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0",
        |_| {},
        "tile 0 (NE 0, SE 0, SW 0, NW 0) occurs 16 times: at row 0, column 0; row 0, column 1; \
         row 0, column 2; row 0, column 3 and 12 more (and 15 more faults)",
    ),
    // Wrong size.
    (
        "too many cells",
        CORNER_2,
        |p| resize(p, 4, 5),
        "size 4x5 has 20 cells, but the set has 16 tiles",
    ),
    (
        "one cell too many",
        "kind=domino colors=2\n0 0 1 3 2",
        |_| {},
        "size 5x1 has 5 cells, but the set has 4 tiles",
    ),
    (
        "too few cells",
        WANG_2,
        |p| resize(p, 3, 5),
        "size 3x5 has 15 cells, but the set has 16 tiles",
    ),
    (
        "too few cells to cover",
        COVERING,
        |p| resize(p, 3, 5),
        "size 3x5 has 15 cells, but the set has 16 tiles to cover",
    ),
    (
        "a covering claimed to be a packing",
        COVERING,
        |p| p.cover = false,
        "size 8x4 has 32 cells, but the set has 16 tiles",
    ),
    (
        "fewer tiles than cells",
        CORNER_2,
        |p| p.tiles.truncate(15),
        "size 4x4 has 16 cells, but there are 15 tiles",
    ),
    (
        "dominoes on a torus with two directions",
        RING,
        |p| resize(p, 2, 2),
        "size 2x2: dominoes lie on a ring, so the width or the height must be 1",
    ),
    // Wrong set.
    (
        "complete claimed compact",
        WANG_2,
        |p| with_set(p, Members::Compact),
        "size 4x4 has 16 cells, but the set has 8 tiles",
    ),
    (
        "complete claimed pruned",
        CORNER_2,
        |p| with_set(p, Members::Pruned(vec![(Color(0), Color(1))])),
        "size 4x4 has 16 cells, but the set has 2 tiles",
    ),
    (
        "complete claimed to cover a pruned set",
        CORNER_2,
        |p| {
            p.cover = true;
            with_set(p, Members::Pruned(vec![(Color(0), Color(1))]));
        },
        "row 0, column 1: tile 4 (NE 0, SE 1, SW 0, NW 0) shows both colors of the excluded pair \
         0-1 (and 13 more faults)",
    ),
    (
        "a set that lacks a tile used",
        EXPLICIT,
        |p| with_set(p, Members::Explicit([0, 4, 5, 2].map(TileId).to_vec())),
        "row 0, column 3: tile 1 (N 0, E 0, S 0, W 1) is not one of the tiles of the set \
         (and 1 more fault)",
    ),
    (
        "complete claimed to cover a compact set",
        WANG_2,
        |p| {
            p.cover = true;
            with_set(p, Members::Compact);
        },
        "compact set: 4 different tiles with N 0, W 0 (E 0, S 0; E 0, S 1; E 1, S 0; E 1, S 1), \
         expected 2 (and 3 more faults)",
    ),
    // Tile numbers that do not exist.
    (
        "a tile out of range",
        CORNER_2,
        |p| p.tiles[6] = TileId(16),
        "row 1, column 2: tile 16 is out of range: expected 0 to 15",
    ),
    (
        "the largest number",
        RING,
        |p| p.tiles[3] = TileId(u32::MAX),
        "row 0, column 3: tile 4294967295 is out of range: expected 0 to 3",
    ),
    // Compact sets.
    (
        "a compact Wang packing with one tile changed",
        COMPACT_WANG,
        |p| p.tiles = [15, 7, 13, 5, 10, 8, 2, 8].map(TileId).to_vec(),
        "row 0, column 3: south side has color 0, but the tile to the south (row 1, column 3) has \
         color 1 on its north side (and 2 more faults)",
    ),
    (
        "one tile twice instead of two",
        "kind=wang colors=1,2 set=compact\n0 2 3 1",
        |p| p.tiles = [0, 0, 2, 1].map(TileId).to_vec(),
        "tile 0 (N 0, E 0, S 0, W 0) occurs 2 times: at row 0, column 0 and row 0, column 1 \
         (and 1 more fault)",
    ),
    (
        "a third tile of a corner class",
        COMPACT_CORNER,
        |p| {
            let lattice = Lattice { kind: Kind::Corner, shape: p.shape };
            let mut labels = Lattice::labels_of(p).unwrap();
            labels[0] = 1;
            p.tiles = lattice.packing(&labels, &p.set, false).tiles;
        },
        "compact set: 3 different tiles with SE 1, SW 0, NW 1 (NE 0; NE 1; NE 2), expected 2 \
         (and 7 more faults)",
    ),
    (
        "a compact set of one color",
        "kind=corner colors=1 set=compact\n0 0",
        |_| {},
        "tile 0 (NE 0, SE 0, SW 0, NW 0) occurs 2 times: at row 0, column 0 and row 0, column 1 \
         (and 1 more fault)",
    ),
];

#[test]
fn wrong_packings_are_refused_with_the_right_message() {
    for &(what, text, spoil, message) in WRONG {
        let mut packing = packing(text);
        spoil(&mut packing);
        let verdict = check(&packing);
        assert_eq!(verdict.to_string(), message, "{what}");
        assert!(!verdict.is_valid() && !oracle(&packing), "{what}");
        assert_eq!(verdict.is_wrong_size(), message.starts_with("size"), "{what}");
    }
}

#[test]
fn faults_are_limited_but_counted() {
    let row = "0 ".repeat(256);
    let text = format!("kind=corner colors=16\n{}", format!("{row}\n").repeat(256));
    let verdict = check(&packing(&text));
    assert_eq!(verdict.total(), 65536);
    assert_eq!(verdict.faults().len(), 1 + KEPT);
    assert!(matches!(&verdict.faults()[0], Fault::Repeated { times: 65536, .. }));
    assert!(matches!(&verdict.faults()[KEPT], Fault::Missing { tile } if tile.number == 20));
}

#[test]
fn a_few_of_very_many_tiles() {
    // A ring of Wang tiles over 255 colors: 4 of 4,228,250,625 tile numbers.
    let colors = Colors::one(255).unwrap();
    let west = [254, 3, 200, 77];
    let tile = |i: usize| Kind::Wang.pack(&[9, west[(i + 1) % 4], 9, west[i]], colors).unwrap();
    let tiles: Vec<TileId> = (0..4).map(tile).collect();
    let set = TileSet::new(Kind::Wang, colors, Members::Explicit(tiles.clone())).unwrap();
    let shape = Shape::new(4, 1).unwrap();
    let mut packing = Packing::new(set, shape, false, tiles);
    assert!(check(&packing).is_valid());
    packing.tiles[3] = packing.tiles[1];
    let verdict = check(&packing);
    let sorts: Vec<_> = verdict.faults().iter().map(std::mem::discriminant).collect();
    assert_eq!((verdict.total(), sorts.len()), (4, 4));
    assert!(verdict.to_string().starts_with("row 0, column 2: east side has color 77, but"));
    assert!(matches!(&verdict.faults()[2], Fault::Repeated { times: 2, .. }));
    assert!(matches!(&verdict.faults()[3], Fault::Missing { .. }));
}

/// What a packing is, word by word, over a table of all tiles.
fn oracle(packing: &Packing) -> bool {
    let (kind, shape) = (packing.set.kind(), packing.shape);
    let colors = packing.set.colors();
    let (h, v) = (colors.horizontal() as u8, colors.vertical() as u8);
    let radices = match kind {
        Kind::Corner => [h, h, h, h],
        Kind::Wang => [h, v, h, v],
        Kind::Domino => [1, 1, v, v],
    };
    let mut table = Vec::new();
    for a in 0..radices[0] {
        for b in 0..radices[1] {
            for c in 0..radices[2] {
                for d in 0..radices[3] {
                    table.push([a, b, c, d]);
                }
            }
        }
    }
    if packing.tiles.len() != shape.cells() {
        return false;
    }
    if packing.tiles.iter().any(|tile| tile.index() >= table.len()) {
        return false;
    }
    let (w, rows) = (shape.width(), shape.height());
    if kind == Kind::Domino && w > 1 && rows > 1 {
        return false;
    }
    let at = |row: usize, column: usize| table[packing.tiles[row % rows * w + column % w].index()];
    for (row, column) in (0..rows).flat_map(|row| (0..w).map(move |column| (row, column))) {
        let [a, b, c, d] = at(row, column);
        let (east, south) = (at(row, column + 1), at(row + 1, column));
        let fits = match kind {
            Kind::Corner => {
                let nw = [east[3], at(row + 1, column + 1)[3], south[3], at(row, column)[3]];
                [a, b, c, d] == nw
            }
            Kind::Wang => b == east[3] && c == south[0],
            Kind::Domino if rows > 1 => d == south[2],
            Kind::Domino => d == east[2],
        };
        if !fits {
            return false;
        }
    }
    let count = |id: usize| packing.tiles.iter().filter(|tile| tile.index() == id).count();
    let enough = |n: usize| if packing.cover { n >= 1 } else { n == 1 };
    let shown = |id: usize| if kind == Kind::Domino { &table[id][2..] } else { &table[id][..] };
    let given = |id: usize| match packing.set.members() {
        Members::Complete | Members::Compact => true,
        Members::Pruned(pairs) => {
            !pairs.iter().any(|(a, b)| shown(id).contains(&a.0) && shown(id).contains(&b.0))
        }
        Members::Explicit(tiles) => tiles.contains(&TileId(id as u32)),
    };
    if *packing.set.members() != Members::Compact {
        return (0..table.len())
            .all(|id| if given(id) { enough(count(id)) } else { count(id) == 0 });
    }
    let class = |id: usize| {
        let [a, b, c, d] = table[id];
        if kind == Kind::Corner { [b, c, d] } else { [a, d, 0] }
    };
    (0..table.len()).all(|id| {
        let used: Vec<usize> = (0..table.len())
            .filter(|&other| class(other) == class(id) && count(other) > 0)
            .collect();
        used.len() == 2 && used.into_iter().all(|other| enough(count(other)))
    })
}

/// Any tiles that fit, claimed to be any set, with up to two of them replaced.
fn claims() -> impl Strategy<Value = Packing> {
    let kinds = prop::sample::select(vec![Kind::Corner, Kind::Wang, Kind::Domino]);
    let sizes = (kinds, 1..=3u64, 1..=3u64, 1..=5u64, 1..=4u64);
    sizes
        .prop_flat_map(|(kind, h, v, width, height)| {
            let colors = match kind {
                Kind::Corner => Colors::one(h).unwrap(),
                Kind::Wang | Kind::Domino => Colors::pair(h, v).unwrap(),
            };
            // Mostly a ring, but a domino packing on a true torus has to be refused, too.
            let width = if kind == Kind::Domino && height > 1 && width < 5 { 1 } else { width };
            let shape = Shape::new(width, height).unwrap();
            let colors = if kind == Kind::Domino { shape.ring_colors(colors) } else { colors };
            let all = TileSet::new(kind, colors, Members::Complete).unwrap();
            let labels = Lattice { kind, shape }.labels();
            let labels = prop::collection::vec(any::<u8>(), labels);
            let spoilt = prop::collection::vec((any::<prop::sample::Index>(), any::<u32>()), 0..3);
            let spoilt = prop_oneof![4 => Just(Vec::new()), 3 => spoilt];
            let pairs = prop::collection::vec((0..3u8, 0..3u8), 0..3);
            (Just(all), Just(shape), labels, spoilt, 0..5, pairs, any::<bool>())
        })
        .prop_map(|(all, shape, mut labels, spoilt, members, pairs, cover)| {
            let (kind, colors) = (all.kind(), all.colors());
            for (i, label) in labels.iter_mut().enumerate() {
                let vertical = kind == Kind::Domino || (kind == Kind::Wang && i % 2 == 1);
                let count = if vertical { colors.vertical() } else { colors.horizontal() };
                *label %= count as u8;
            }
            let mut packing = Lattice { kind, shape }.packing(&labels, &all, cover);
            let mut used = packing.tiles.clone();
            used.sort_unstable();
            used.dedup();
            let pairs = pairs.into_iter().map(|(a, b)| (Color(a), Color(b))).collect();
            let members = match members {
                0 => Members::Complete,
                1 => Members::Compact,
                2 => Members::Pruned(pairs),
                _ => Members::Explicit(used),
            };
            packing.set = TileSet::new(kind, colors, members).unwrap_or(all);
            for (index, tile) in spoilt {
                let universe = kind.tiles(colors) as u32;
                let place = index.index(packing.tiles.len());
                packing.tiles[place] = TileId(tile % (universe + 1));
            }
            packing
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn verify_agrees_with_the_oracle(packing in claims()) {
        let verdict = check(&packing);
        prop_assert_eq!(verdict.is_valid(), oracle(&packing), "{}", verdict);
        prop_assert_eq!(verdict.is_valid(), verdict.faults().is_empty());
        prop_assert!(verdict.total() >= verdict.faults().len() as u64);
    }

    #[test]
    fn verify_agrees_with_the_oracle_near_right_packings(
        base in 0..13usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u32>()), 0..3),
        turn in any::<prop::sample::Index>(),
        cover in any::<bool>(),
    ) {
        let right = [
            CORNER_2, WANG_2, WANG_2_1, COMPACT_WANG, COMPACT_CORNER, RING, COLUMN, PRUNED_RING,
            PRUNED_WANG, EXPLICIT, COVERING, COMPACT_COVERING, ONE_COLOR,
        ];
        let mut packing = packing(right[base]);
        packing.cover |= cover;
        let universe = packing.set.kind().tiles(packing.set.colors()) as u32;
        for (index, tile) in changes {
            let place = index.index(packing.tiles.len());
            packing.tiles[place] = TileId(tile % universe);
        }
        // Turning a packing by whole rows keeps it right.
        let rows = turn.index(packing.shape.height());
        packing.tiles.rotate_left(rows * packing.shape.width());
        prop_assert_eq!(check(&packing).is_valid(), oracle(&packing), "{}", check(&packing));
    }
}

/// A mistake elsewhere must not hide in verify, so it may use nothing but the data types.
#[test]
fn verify_stands_alone() {
    let mut folders = vec![PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/src/verify"))];
    let mut paths = Vec::new();
    while let Some(folder) = folders.pop() {
        for file in std::fs::read_dir(folder).unwrap() {
            let path = file.unwrap().path();
            if path.is_dir() { folders.push(path) } else { paths.push(path) }
        }
    }
    let files = paths.len();
    for path in paths {
        let text = std::fs::read_to_string(path).unwrap();
        let code = text.split("#[cfg(test)]").next().unwrap();
        for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
            for used in line.split("crate::").skip(1) {
                assert!(used.starts_with("tiles::") || used.starts_with("torus::"), "{line}");
            }
            let foreign = ["Lattice", "formula", "unpack", ".allows", ".allowed", "set.size"];
            assert!(!foreign.iter().any(|word| line.contains(word)), "{line}");
        }
    }
    assert!(files >= 5);
}
