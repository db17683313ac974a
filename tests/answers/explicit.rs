//! Random small sets of tiles, packed and covered on all small tori.
//!
//! Most random lists of tiles have no packing at all. So half of the lists are read off a torus
//! with random labels: those have at least one packing, or a covering.

use crate::engines::{Effort, check_against_oracle};
use crate::oracle;
use proptest::prelude::*;
use proptest::sample::select;
use tilepack::packing::Task;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Lattice, Shape};

/// Palettes, and cells and labels that the oracle can handle.
const KINDS: &[(Kind, (u64, u64), usize)] = &[
    (Kind::Corner, (2, 2), 12),
    (Kind::Corner, (3, 3), 9),
    (Kind::Corner, (4, 4), 7),
    (Kind::Wang, (2, 2), 8),
    (Kind::Wang, (3, 3), 6),
    (Kind::Wang, (2, 3), 6),
    (Kind::Wang, (4, 1), 7),
    (Kind::Domino, (2, 2), 4),
    (Kind::Domino, (3, 3), 9),
    (Kind::Domino, (4, 4), 9),
];

pub(crate) fn shapes(kind: Kind, cells: usize) -> impl Iterator<Item = Shape> {
    let sides = (1..=cells).filter(move |&width| cells.is_multiple_of(width));
    let sides = sides.map(move |width| (width, cells / width));
    let sides = sides.filter(move |&(w, h)| kind != Kind::Domino || w == 1 || h == 1);
    sides.map(|(w, h)| Shape::new(w as u64, h as u64).unwrap())
}

/// The tiles that labels show.
pub(crate) fn shown(kind: Kind, colors: Colors, shape: Shape, labels: &[u8]) -> Vec<TileId> {
    let any = TileSet::new(kind, colors, Members::Complete).unwrap();
    let tile = |sides: Vec<usize>| {
        let sides: Vec<u8> = sides.iter().map(|&at| labels[at]).collect();
        kind.pack(&sides, any.colors()).unwrap()
    };
    let mut tiles: Vec<_> =
        oracle::sides(&Task::new(any.clone(), shape)).into_iter().map(tile).collect();
    tiles.sort_unstable();
    tiles.dedup();
    tiles
}

/// Labels in their palettes, from any numbers.
pub(crate) fn labels(kind: Kind, colors: Colors, shape: Shape, numbers: &[u8]) -> Vec<u8> {
    let count = Lattice { kind, shape }.labels();
    let palette = |label: usize| match kind {
        Kind::Wang if label.is_multiple_of(2) => colors.horizontal(),
        _ => colors.vertical(),
    };
    (0..count).map(|i| numbers[i % numbers.len()] % palette(i) as u8).collect()
}

fn check(kind: Kind, colors: Colors, tiles: Vec<TileId>, most: usize) -> u64 {
    let set = TileSet::new(kind, colors, Members::Explicit(tiles)).unwrap();
    let size = set.size() as usize;
    let mut all = 0;
    for cells in size..=(size + 3).min(most.max(size)) {
        for shape in shapes(kind, cells) {
            let task = Task { cover: cells > size, ..Task::new(set.clone(), shape) };
            let what = format!("{kind} {colors} {:?} on {shape}", set.members());
            all += check_against_oracle(&task, Effort::Each, &what);
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn tiles_of_a_torus(
        (kind, (h, v), most) in select(KINDS),
        cells in 1usize..=12,
        choice in 0usize..6,
        numbers in prop::collection::vec(0u8..12, 24),
    ) {
        let colors = Colors::pair(h, v).unwrap();
        let shapes: Vec<_> = shapes(kind, cells.min(most)).collect();
        let shape = shapes[choice % shapes.len()];
        let labels = labels(kind, colors, shape, &numbers);
        let tiles = shown(kind, colors, shape, &labels);
        let spare = shape.cells() - tiles.len();
        let found = check(kind, colors, tiles, most);
        prop_assert!(found > 0 || spare > 3);
    }

    #[test]
    fn any_tiles(
        (kind, (h, v), most) in select(KINDS),
        numbers in prop::collection::btree_set(0u32..256, 1..8),
    ) {
        let colors = Colors::pair(h, v).unwrap();
        let all = kind.tiles(colors) as u32;
        let mut tiles: Vec<_> = numbers.into_iter().map(|number| TileId(number % all)).collect();
        tiles.sort_unstable();
        tiles.dedup();
        check(kind, colors, tiles, most);
    }
}
