//! A task in words.

use tilepack::packing::Task;
use tilepack::tiles::{TileSet, notation};
use tilepack::torus::Shape;

/// Kind, colors, set, size (empty: the usual one).
pub(crate) fn task(kind: &str, colors: &str, members: &str, size: &str) -> Task {
    let members = notation::parse_members(members).unwrap().unwrap();
    let set = TileSet::new(kind.parse().unwrap(), colors.parse().unwrap(), members).unwrap();
    let shape = match size {
        "" => Shape::default_for(&set).unwrap(),
        size => size.parse().unwrap(),
    };
    Task::new(set, shape)
}
