//! Packings repeated and mixed: still tilings, by the same tiles.

use crate::complete;
use std::collections::HashSet;
use tilepack::construct::construct;
use tilepack::tiles::{Kind, Members, TileId, TileSet};
use tilepack::tiling::{Coloring, Tiling, TilingError, mixed};
use tilepack::torus::{Packing, Shape};

/// Of corner and of Wang tiles, with one palette and with two.
#[test]
fn only_tiles_of_the_packing_occur() {
    let mut packings: Vec<Packing> = [(Kind::Corner, "2"), (Kind::Wang, "2,3")]
        .into_iter()
        .map(|(kind, colors)| {
            let set = complete(kind, colors);
            construct(&set, Shape::default_for(&set).unwrap(), None).unwrap().packing()
        })
        .collect();
    for kind in [Kind::Corner, Kind::Wang] {
        let set = TileSet::new(kind, "4".parse().unwrap(), Members::Compact).unwrap();
        let shape = Shape::default_for(&set).unwrap();
        packings.push(construct(&set, shape, None).unwrap().packing());
    }
    for packing in packings {
        let found = mixed(&packing, 3).unwrap();
        assert_eq!(found, mixed(&packing, 3).unwrap());
        assert_ne!(found.map, mixed(&packing, 4).unwrap().map);
        assert_eq!(found.map.shape().width(), 4 * packing.shape.width());
        assert!(found.changed > found.map.shape().cells() / 2, "{}", found.changed);
        let allowed: HashSet<TileId> = packing.tiles.iter().copied().collect();
        let shape = found.map.shape();
        assert!(found.map.tiles().iter().all(|tile| allowed.contains(tile)));
        // What a map shows fits by itself; this asks the tiling as well.
        let (kind, colors) = (packing.set.kind(), packing.set.colors());
        let tiling = Tiling::new(kind, colors, Coloring::Map(found.map)).unwrap();
        assert!(tiling.window(-9, -9, shape).iter().all(|tile| allowed.contains(tile)));
    }
}

/// Where nothing can be changed, the packing is taken as it is.
#[test]
fn a_rigid_set_stays() {
    let tiles = vec![TileId(0), TileId(15)];
    let set = TileSet::new(Kind::Wang, "2".parse().unwrap(), Members::Explicit(tiles)).unwrap();
    let one = Packing::new(set, Shape::new(1, 1).unwrap(), true, vec![TileId(0)]);
    let found = mixed(&one, 1).unwrap();
    assert_eq!((found.changed, found.map.shape()), (0, one.shape));
    let ring = complete(Kind::Domino, "2");
    let shape = Shape::default_for(&ring).unwrap();
    let ring = construct(&ring, shape, None).unwrap().packing();
    assert_eq!(mixed(&ring, 1), Err(TilingError::Dominoes));
}
