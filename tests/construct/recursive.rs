//! Recursive packings: Wei's rings and their products, and what is said about those that are not.

use crate::{check, complete};
use tilepack::construct::{NotConstructed, construct, construct_wei};
use tilepack::tiles::{Kind, TileId, TileSet};
use tilepack::torus::{Packing, Shape};
use tilepack::verify::{NotRecursive, check_recursion};

#[test]
fn products_of_weis_rings() {
    for (colors, blocks) in
        [("1", 0), ("2", 1), ("3", 2), ("4", 3), ("7", 6), ("2,3", 1), ("6,3", 2), ("1,4", 0)]
    {
        let set = complete(Kind::Wang, colors);
        let made = construct_wei(&set, Shape::default_for(&set).unwrap()).unwrap();
        check(&made);
        let recursion = check_recursion(&made.packing());
        assert_eq!((recursion.blocks.len(), recursion.fault), (blocks, None), "{colors}");
    }
}

/// Row by row, the block over one color less is the product over one color less.
#[test]
fn blocks_are_the_products_over_fewer_colors() {
    let labels = |colors: &str| {
        let set = complete(Kind::Wang, colors);
        let made = construct_wei(&set, Shape::default_for(&set).unwrap()).unwrap();
        (made.shape(), crate::labels(&made))
    };
    let ((large, outer), (small, inner)) = (labels("5,4"), labels("4,3"));
    let skipped = large.height() - small.height();
    for row in 0..small.height() {
        let (from, width) = (2 * (row + skipped) * large.width(), 2 * small.width());
        assert_eq!(outer[from..from + width], inner[row * width..(row + 1) * width]);
    }
}

#[test]
fn weis_rings() {
    for colors in 1..=9 {
        let set = complete(Kind::Domino, &colors.to_string());
        for (width, height) in [(colors * colors, 1), (1, colors * colors)] {
            let made = construct_wei(&set, Shape::new(width, height).unwrap()).unwrap();
            check(&made);
            let recursion = check_recursion(&made.packing());
            assert_eq!((recursion.blocks.len() as u64, recursion.fault), (colors - 1, None));
        }
    }
}

#[test]
fn corner_tiles_have_no_rings() {
    let set = complete(Kind::Corner, "3");
    let made = construct_wei(&set, Shape::default_for(&set).unwrap());
    assert!(matches!(made, Err(NotConstructed::Unknown(_))));
}

fn with(set: &TileSet, shape: Shape, change: impl Fn(&mut Vec<TileId>)) -> Option<NotRecursive> {
    let mut packing = construct_wei(set, shape).unwrap().packing();
    change(&mut packing.tiles);
    check_recursion(&packing).fault
}

#[test]
fn where_it_fails() {
    let set = complete(Kind::Wang, "3");
    let shape = Shape::default_for(&set).unwrap();
    assert_eq!(with(&set, shape, |_| {}), None);
    // N, E, S, W = 0, 0, 0, 2 in the block over two colors, at row 5, column 0.
    let fault = with(&set, shape, |tiles| tiles[45] = TileId(2)).unwrap();
    assert!(matches!(fault, NotRecursive::Color { part: "west", color: 2, .. }), "{fault}");
    assert_eq!(
        fault.to_string(),
        "the 4x4 block over 2 colors at row 5, column 0 has color 2 (west of the tile at row 5, \
         column 0)"
    );
    let fault = with(&set, shape, |tiles| tiles[45] = tiles[46]).unwrap();
    assert!(matches!(fault, NotRecursive::Repeated { .. }), "{fault}");
    let fault = with(&set, shape, |tiles| tiles.swap(45, 46)).unwrap();
    assert!(matches!(fault, NotRecursive::Seam { .. }), "{fault}");
    // Outside of the blocks nothing is looked at.
    assert_eq!(with(&set, shape, |tiles| tiles.swap(0, 1)), None);
    // Not recursive, not square, not complete.
    let least = construct(&set, shape, None).unwrap().packing();
    let fault = check_recursion(&least).fault;
    assert!(matches!(fault, Some(NotRecursive::Color { .. })), "{fault:?}");
    let tall = Packing { shape: Shape::new(27, 3).unwrap(), ..least.clone() };
    let fault = check_recursion(&tall).fault.unwrap();
    assert_eq!(fault.to_string(), "size 27x3: a recursive packing over these colors has size 9x9");
    let covering = Packing { cover: true, ..least };
    assert_eq!(check_recursion(&covering).fault, Some(NotRecursive::Set));
}
