//! The published aperiodic sets that are recognized, with their sources.

use crate::aperiodic::Set;
use crate::tiles::Kind;
use anyhow::Context;
use serde::Deserialize;

/// The sets: what they are called here, the files, and what is known about them.
const FILES: [(&str, &str, &str); 7] = [
    (
        "jeandel-rao",
        include_str!("../../../data/aperiodic/jeandel_rao11_4colors.json"),
        "proved aperiodic, and no smaller Wang set is (Jeandel and Rao 2021)",
    ),
    (
        "jeandel-rao-5",
        include_str!("../../../data/aperiodic/jeandel_rao11_5labels.json"),
        "proved aperiodic (Jeandel and Rao 2021)",
    ),
    (
        "culik",
        include_str!("../../../data/aperiodic/culik13.json"),
        "proved aperiodic (Culik 1996)",
    ),
    ("kari", include_str!("../../../data/aperiodic/kari14.json"), "proved aperiodic (Kari 1996)"),
    (
        "ammann",
        include_str!("../../../data/aperiodic/ammann16.json"),
        "proved aperiodic (Ammann; Grünbaum and Shephard 1987)",
    ),
    (
        "labbe",
        include_str!("../../../data/aperiodic/labbe19.json"),
        "proved aperiodic (Labbé 2019)",
    ),
    (
        "knuth",
        include_str!("../../../data/aperiodic/knuth92.json"),
        "proved aperiodic (Berger 1966; Knuth 1968)",
    ),
];

/// A set that is proved aperiodic in print.
pub(super) struct Published {
    /// What it is called on the command line.
    pub(super) short: &'static str,
    /// What it is called.
    pub(super) name: String,
    /// What is known about it.
    pub(super) status: &'static str,
    /// Where the proof is.
    pub(super) source: String,
    /// Its tiles.
    pub(super) set: Set,
}

/// All of them.
///
/// # Errors
/// Never, as a test makes sure.
pub(super) fn published() -> anyhow::Result<Vec<Published>> {
    #[derive(Deserialize)]
    struct Document {
        name: String,
        kind: String,
        source: String,
        tiles: Vec<[u32; 4]>,
    }
    let read = |&(short, text, status): &(&'static str, &str, &'static str)| {
        let document: Document = serde_json::from_str(text)?;
        let kind: Kind = document.kind.parse()?;
        let set = Set::new(kind, document.tiles)?;
        anyhow::Ok(Published { short, name: document.name, status, source: document.source, set })
    };
    FILES.iter().map(read).collect::<Result<_, _>>().context("the published sets")
}
