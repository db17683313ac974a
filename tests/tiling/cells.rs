//! Where tiles lie: the closed forms against the packings, and what is refused.

use crate::{complete, hashed};
use tilepack::construct::{CornerTorus, construct, corner, corner_even};
use tilepack::tiles::{Color, Kind, Members, TileId, TileSet};
use tilepack::tiling::{Cells, ColorMap, Coloring, Formula, Tiling, TilingError};
use tilepack::torus::{Cell, Packing, Shape};

fn constructed(kind: Kind, colors: &str, seed: Option<u64>) -> Packing {
    let set = complete(kind, colors);
    construct(&set, Shape::default_for(&set).unwrap(), seed).unwrap().packing()
}

#[test]
fn the_formula_and_the_table_say_the_same() {
    let corner = ["2", "3", "4", "5", "6", "7", "10"].map(|colors| (Kind::Corner, colors));
    let wang = ["1", "2", "3", "4", "2,3", "5,2", "1,4"].map(|colors| (Kind::Wang, colors));
    for (kind, colors) in corner.into_iter().chain(wang) {
        let packing = constructed(kind, colors, None);
        let (formula, table) = (Cells::formula(&packing).unwrap(), Cells::table(&packing));
        assert!(formula.as_formula().is_some() && table.as_formula().is_none());
        for cell in (0..packing.shape.cells() as u32).map(Cell) {
            let place = Some(packing.shape.position(cell));
            assert_eq!(formula.find(packing.tile(cell)), place, "{kind} {colors}");
            assert_eq!(table.find(packing.tile(cell)), place, "{kind} {colors}");
        }
        let beyond = TileId(packing.tiles.len() as u32);
        assert_eq!((formula.find(beyond), table.find(beyond)), (None, None));
        let tiling = hashed(kind, colors, 1);
        assert_eq!((formula.check(&tiling), table.check(&tiling)), (Ok(()), Ok(())));
    }
}

/// The free-standing form for even numbers of colors is that of the family without a seed.
#[test]
fn large_even_numbers_of_colors() {
    for colors in [8usize, 16, 46, 64, 254] {
        let Some(plan) = corner::Plan::search(colors, colors * colors, colors * colors) else {
            panic!("{colors}");
        };
        let CornerTorus::Even { torus, .. } = plan.build(None) else { panic!("{colors}") };
        let mut hash = 1u32;
        for _ in 0..2000 {
            let window = [[0; 2]; 2].map(|pair: [u8; 2]| {
                pair.map(|_| {
                    hash = tilepack::tiling::hash::mix(hash + 1);
                    (hash as usize % colors) as u8
                })
            });
            let (row, column) = corner_even::find(colors, window);
            assert_eq!((row, column), torus.find(window), "{colors} {window:?}");
        }
    }
}

#[test]
fn a_covering_has_the_first_of_equal_cells() {
    let packing = constructed(Kind::Corner, "2", None);
    let (set, wide) = (packing.set.clone(), Shape::new(8, 4).unwrap());
    let twice = packing.rows().flat_map(|row| [row, row].concat()).collect();
    let cells = Cells::table(&Packing::new(set, wide, true, twice));
    for (at, &tile) in packing.tiles.iter().enumerate() {
        assert_eq!(cells.find(tile), Some((at / 4, at % 4)));
    }
}

#[test]
fn what_no_formula_describes_is_refused() {
    let message = |packing: &Packing| Cells::formula(packing).unwrap_err().to_string();
    let seeded = message(&constructed(Kind::Corner, "3", Some(5)));
    assert!(seeded.contains("row 0, column") && seeded.contains("has tile"), "{seeded}");
    let set = complete(Kind::Corner, "3");
    let tall = construct(&set, Shape::new(3, 27).unwrap(), None).unwrap().packing();
    assert!(message(&tall).contains("its size is 3x27, expected 9x9"));
    let pairs = vec![(Color(0), Color(1))];
    let pruned = TileSet::new(Kind::Corner, set.colors(), Members::Pruned(pairs)).unwrap();
    let some = Packing::new(pruned, Shape::new(1, 1).unwrap(), true, vec![TileId(0)]);
    assert!(message(&some).contains("only those of complete corner and Wang sets"));
    assert_eq!(Formula::of(Kind::Domino, set.colors()), None);
}

#[test]
fn tilings_that_need_other_tiles_are_refused() {
    let tile = TileId(0);
    let set =
        TileSet::new(Kind::Wang, "2".parse().unwrap(), Members::Explicit(vec![tile])).unwrap();
    let one = Packing::new(set, Shape::new(1, 1).unwrap(), false, vec![tile]);
    let cells = Cells::table(&one);
    let missing = cells.check(&hashed(Kind::Wang, "2", 1));
    assert!(matches!(missing, Err(TilingError::MissingTile { tile: 1, .. })));
    let other = cells.check(&hashed(Kind::Wang, "3", 1));
    assert!(matches!(other, Err(TilingError::OtherPacking { .. })));
    // A map of its own tile is enough.
    let map = Coloring::Map(ColorMap::of(&one).unwrap());
    let tiling = Tiling::new(Kind::Wang, "2".parse().unwrap(), map).unwrap();
    assert_eq!(cells.check(&tiling), Ok(()));
}
