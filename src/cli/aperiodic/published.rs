//! The published aperiodic sets that are recognized, with their sources.

use crate::aperiodic::Set;
use crate::tiles::Kind;
use anyhow::Context;
use serde::Deserialize;

/// The sets as files.
const FILES: [&str; 7] = [
    include_str!("../../../data/aperiodic/jeandel_rao11_4colors.json"),
    include_str!("../../../data/aperiodic/jeandel_rao11_5labels.json"),
    include_str!("../../../data/aperiodic/culik13.json"),
    include_str!("../../../data/aperiodic/kari14.json"),
    include_str!("../../../data/aperiodic/ammann16.json"),
    include_str!("../../../data/aperiodic/labbe19.json"),
    include_str!("../../../data/aperiodic/knuth92.json"),
];

/// A set that is proved aperiodic in print.
pub(super) struct Published {
    /// What it is called.
    pub(super) name: String,
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
    let read = |text: &&str| {
        let document: Document = serde_json::from_str(text)?;
        let kind: Kind = document.kind.parse()?;
        let set = Set::new(kind, document.tiles)?;
        anyhow::Ok(Published { name: document.name, source: document.source, set })
    };
    FILES.iter().map(read).collect::<Result<_, _>>().context("the published sets")
}
