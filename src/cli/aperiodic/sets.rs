//! `aperiodic sets`: the sets that are known, and what is known about them.

use super::published::published;
use crate::cli::args::AperiodicSetsArgs;
use crate::cli::exit::Exit;
use crate::cli::output;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Sets that are made of others or have a certificate: name, kind, tiles, colors, what is known,
/// how to get them.
const MORE: [(&str, &str, usize, usize, &str, &str); 3] = [
    (
        "corner-24",
        "corner",
        24,
        4,
        "aperiodic given Jeandel and Rao 2021: certificate cert-24-tiles-4-colors.json",
        "aperiodic color jeandel-rao",
    ),
    (
        "kari, vertical",
        "corner",
        86,
        6,
        "aperiodic given Kari 1996: no mixed tiles (Lagae 2007, table 8.1)",
        "aperiodic convert kari --method vertical",
    ),
    (
        "ammann, horizontal",
        "corner",
        44,
        6,
        "refuted: published as aperiodic (Lagae 2007, table 8.1), it has a periodic tiling",
        "aperiodic convert ammann --method horizontal",
    ),
];

/// Runs the command.
///
/// # Errors
/// When standard output cannot be written.
pub fn run(args: &AperiodicSetsArgs) -> anyhow::Result<Exit> {
    let published = published()?;
    let labels = |sides: [usize; 2], tiles: &[[u32; 4]]| {
        let labels: BTreeSet<u32> =
            tiles.iter().flat_map(|tile| sides.map(|side| tile[side])).collect();
        labels.len()
    };
    if args.json {
        let mut list: Vec<Value> = published
            .iter()
            .map(|known| {
                let tiles = known.set.tiles();
                json!({
                    "name": known.short, "title": known.name, "kind": known.set.kind().name(),
                    "tiles": tiles.len(), "colors": [labels([0, 2], tiles), labels([1, 3], tiles)],
                    "status": known.status, "source": known.source,
                })
            })
            .collect();
        list.extend(MORE.map(|(name, kind, tiles, colors, status, command)| {
            json!({
                "name": name, "kind": kind, "tiles": tiles, "colors": colors, "status": status,
                "command": command,
            })
        }));
        output::object(&[("sets", json!(list))])?;
        return Ok(Exit::Yes);
    }
    output::result(|out| {
        for known in &published {
            let tiles = known.set.tiles();
            writeln!(
                out,
                "{:<20}{:>3} Wang tiles over {},{} labels: {}",
                known.short,
                tiles.len(),
                labels([0, 2], tiles),
                labels([1, 3], tiles),
                known.status
            )?;
        }
        for (name, _, tiles, colors, status, _) in MORE {
            writeln!(out, "{name:<20}{tiles:>3} corner tiles over {colors} colors: {status}")?;
        }
        Ok(())
    })?;
    Ok(Exit::Yes)
}
