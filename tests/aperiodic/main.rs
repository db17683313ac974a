//! Conversions of aperiodic sets against the published tables, what they prove, and patches.

#![allow(clippy::unwrap_used)]

mod command;
mod naive;
mod patches;
mod soundness;
mod tables;

use tilepack::aperiodic::Set;
use tilepack::tiles::Kind;

/// A published set, by the name of its file.
pub(crate) fn published(name: &str) -> Set {
    let file = format!("{}/data/aperiodic/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(file).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let tiles = json["tiles"].as_array().unwrap().iter().map(|tile| {
        std::array::from_fn(|side| u32::try_from(tile[side].as_u64().unwrap()).unwrap())
    });
    let kind: Kind = json["kind"].as_str().unwrap().parse().unwrap();
    Set::new(kind, tiles.collect()).unwrap()
}

/// The names of all files.
pub(crate) const NAMES: [&str; 7] = [
    "jeandel_rao11_4colors",
    "jeandel_rao11_5labels",
    "culik13",
    "kari14",
    "ammann16",
    "labbe19",
    "knuth92",
];
