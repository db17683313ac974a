//! All Wang tiles, with any numbers of colors.

use crate::{check, complete};
use tilepack::construct::{NotConstructed, construct};
use tilepack::tiles::Kind;
use tilepack::torus::Shape;

#[test]
fn products_of_rings() {
    for colors in ["1", "2", "3", "4", "5", "8", "1,3", "3,1", "2,3", "3,2", "2,7", "12,5", "16,17"]
    {
        let set = complete(Kind::Wang, colors);
        let shape = Shape::default_for(&set).unwrap();
        for seed in [None, Some(0), Some(9)] {
            check(&construct(&set, shape, seed).unwrap());
        }
    }
}

#[test]
fn other_shapes_are_not_covered() {
    let set = complete(Kind::Wang, "2,3");
    let shape = Shape::new(6, 6).unwrap();
    let Err(NotConstructed::Unknown(what)) = construct(&set, shape, None) else { unreachable!() };
    assert_eq!(what, "wang tiles, colors 2,3, set complete, size 6x6");
}
