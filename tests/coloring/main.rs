//! Small aperiodic sets of corner tiles: certificates, that tampering with them is refused, the
//! search, the command.

#![allow(clippy::unwrap_used)]

mod certificates;
mod command;
mod conditions;
mod tampering;

use tilepack::aperiodic::coloring::language::{Window, patterns, windows};
use tilepack::aperiodic::coloring::partition::{JEANDEL_RAO, Partition};
use tilepack::aperiodic::coloring::vertices::Vertices;
use tilepack::store::{Input, read_certificate};
use tilepack::torus::toral::ToralCertificate;

/// The certificate of 24 tiles over 4 colors.
const PUBLISHED: &str = include_str!("../../data/aperiodic/cert-24-tiles-4-colors.json");

fn read(text: impl Into<Vec<u8>>) -> ToralCertificate {
    read_certificate(&Input::from_bytes("certificate.json", text.into()).unwrap()).unwrap()
}

/// The windows of Jeandel and Rao's tilings around a cell whose vertices see `shape`, and the
/// vertices.
fn jeandel_rao(shape: [usize; 2]) -> (Vec<Window>, Vertices) {
    let windows = windows(&Partition::jeandel_rao(), shape.map(|side| side + 1)).unwrap();
    let vertices = Vertices::new(JEANDEL_RAO.to_vec(), shape, &patterns(&windows)).unwrap();
    (windows, vertices)
}
