//! Atlases: their texels, levels, tables and files; what filtering does to them; sheets of
//! others.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod command;
mod exactness;
mod lint;
mod oracle;
mod strips;
mod texels;

use tilepack::atlas::fill::{Canvas, Noise};
use tilepack::atlas::{Channels, Depth, Format, Light};
use tilepack::construct::construct;
use tilepack::packing::{self, Settings, Task};
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::{Packing, Shape};

/// Hardly anything is lost in these.
pub(crate) const FINE: Format =
    Format { channels: Channels::Gray, depth: Depth::Sixteen, light: Light::Linear };

/// The constructed packing of a complete set.
pub(crate) fn complete(kind: Kind, colors: Colors) -> Packing {
    let set = TileSet::new(kind, colors, Members::Complete).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    construct(&set, shape, None).unwrap_or_else(|_| panic!("no construction")).packing()
}

pub(crate) fn corner(colors: u64) -> Packing {
    complete(Kind::Corner, Colors::one(colors).unwrap())
}

pub(crate) fn wang(horizontal: u64, vertical: u64) -> Packing {
    complete(Kind::Wang, Colors::pair(horizontal, vertical).unwrap())
}

/// The first packing of a compact set.
pub(crate) fn compact(kind: Kind, colors: u64) -> Packing {
    let set = TileSet::new(kind, Colors::one(colors).unwrap(), Members::Compact).unwrap();
    let shape = Shape::default_for(&set).unwrap();
    let task = Task::new(set.clone(), shape);
    let labels = packing::find(&task, &Settings::PLAIN).unwrap().value.unwrap();
    task.lattice().packing(&labels, &set, false)
}

pub(crate) fn noise(packing: &Packing, side: usize, strip: usize, format: Format) -> Noise {
    let (kind, colors) = (packing.set.kind(), packing.set.colors());
    let canvas = Canvas { kind, colors, side, strip, format };
    Noise { canvas, seed: 7, loose_corners: false }
}
