//! Every file format: what is written is read again, what is wrong is refused in one line that
//! says where, and no bytes whatever make the readers panic.

#![allow(clippy::unwrap_used, clippy::panic)]

mod damage;
mod disk;
mod documentation;
mod pins;
mod solutions;
mod tile_sets;

use tilepack::store::{Claim, Input};
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::{Lattice, Shape};

pub(crate) fn input(text: &str) -> Input {
    Input::from_bytes("in", text.into()).unwrap()
}

pub(crate) fn bare(kind: Kind, colors: u64) -> Claim {
    let colors = Some(Colors::one(colors).unwrap());
    Claim { kind: Some(kind), colors, ..Claim::default() }
}

pub(crate) fn corner_2() -> (Lattice, TileSet) {
    let set = TileSet::new(Kind::Corner, Colors::one(2).unwrap(), Members::Complete).unwrap();
    (Lattice { kind: Kind::Corner, shape: Shape::new(4, 4).unwrap() }, set)
}

pub(crate) fn written(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    bytes
}
