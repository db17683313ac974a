//! The certificate of a coloring: everything a checker needs.

use super::condition::Colored;
use super::language::Window;
use super::partition::{self, DOMAIN, JEANDEL_RAO, JEANDEL_RAO_UNMERGED, LATTICE, Partition};
use super::vertices::{Vertices, north_west};
use crate::torus::toral::{ToralCertificate, ToralWindow, VertexRule};
use std::collections::BTreeMap;

/// The colors numbered in the order in which the classes have them, none left out.
pub fn renumbered(colors: &[u8]) -> Vec<u8> {
    let mut number = BTreeMap::new();
    colors
        .iter()
        .map(|&color| {
            let next = number.len() as u8;
            *number.entry(color).or_insert(next)
        })
        .collect()
}

/// The certificate of a coloring of the vertices of tilings by Jeandel and Rao's set, whose
/// windows, of one row and one column more than the pattern of a vertex, are given.
pub fn certificate(
    title: String,
    vertices: &Vertices,
    windows: &[Window],
    colors: &[u8],
) -> ToralCertificate {
    let [rows, columns] = vertices.shape;
    let [above, left] = north_west(vertices.shape);
    let colored = Colored::new(vertices, colors);
    let entry = |(pattern, &color): (&Vec<usize>, &u8)| (pattern.clone(), u32::from(color));
    let window = |window: &Window| ToralWindow {
        labels: window.labels.clone(),
        polygon: partition::listed(&window.polygon),
        pieces: window.pieces.clone(),
    };
    ToralCertificate {
        title,
        lattice: LATTICE,
        domain: DOMAIN,
        wang: JEANDEL_RAO.to_vec(),
        wang_unmerged: JEANDEL_RAO_UNMERGED.to_vec(),
        partition: Partition::jeandel_rao().listed(),
        rule: VertexRule {
            above,
            below: rows - above,
            left,
            right: columns - left,
            table: vertices.patterns.iter().zip(colors).map(entry).collect(),
        },
        tiles: colored.tiles.iter().map(|tile| tile.map(u32::from)).collect(),
        image: colored.image,
        options: colored.options,
        window_shape: [rows + 1, columns + 1],
        windows: windows.iter().map(window).collect(),
    }
}
