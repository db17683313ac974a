//! Sets of tiles decided and classified: verdicts against trying everything, tables against a
//! naive program, certificates and what is made of them when they are changed.

#![allow(clippy::unwrap_used, clippy::panic)]

mod certificates;
mod classes;
mod naive;
mod published;
mod verdicts;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

/// So many different tiles with random labels below `labels`.
fn random_tiles(random: &mut Pcg64Mcg, count: usize, labels: u32) -> Vec<[u32; 4]> {
    let mut tiles = Vec::new();
    while tiles.len() < count {
        let tile: [u32; 4] = std::array::from_fn(|_| random.random_range(0..labels));
        if !tiles.contains(&tile) {
            tiles.push(tile);
        }
    }
    tiles
}
