//! `import`: a tile set of the map editor Tiled as one of ours, so that it can be packed.

use super::args::ImportArgs;
use super::exit::Exit;
use super::{describe, output, source};
use crate::atlas::formats::wangsets::{self, Choice, Wangset};
use crate::store::{check_writable, write_file, write_tile_set};
use anyhow::{anyhow, bail};
use serde_json::json;

/// Runs the command.
///
/// # Errors
/// Bad input, or a file that cannot be written.
pub fn run(args: &ImportArgs) -> anyhow::Result<Exit> {
    if args.json && args.output.is_none() {
        bail!("--json needs -o FILE: without it, standard output is for the tile set");
    }
    let input = source::open(&args.file)?;
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let choice = Choice {
        wangset: args.wangset.as_deref(),
        keep_first: args.keep_first,
        skip_unset: args.skip_unset,
    };
    let file = input.file().display();
    let wangset =
        wangsets::read(input.text(), choice).map_err(|error| anyhow!("{file}:{error}"))?;
    let name = Some(wangset.name.as_str()).filter(|name| !name.is_empty());
    let from = input.file().to_string_lossy();
    match &args.output {
        Some(out) => write_file(out, |out| write_tile_set(out, &wangset.set, name, Some(&from)))?,
        None => output::result(|out| write_tile_set(out, &wangset.set, name, Some(&from)))?,
    }
    if args.json {
        tell(args, &wangset)?;
    }
    if !args.quiet {
        remark(&wangset);
    }
    Ok(Exit::Yes)
}

fn tell(args: &ImportArgs, wangset: &Wangset) -> anyhow::Result<()> {
    let (set, [first, second]) = (&wangset.set, &wangset.colors);
    let colors = set.colors();
    let count = match colors.single() {
        Some(count) => json!(count),
        None => json!([colors.horizontal(), colors.vertical()]),
    };
    let table: Vec<_> =
        wangset.tiles.iter().map(|(id, tile)| json!({"id": id, "tile": tile.0})).collect();
    let doubles: Vec<_> =
        wangset.doubles.iter().map(|(id, first)| json!({"id": id, "first": first})).collect();
    output::object(&[
        ("result", json!("imported")),
        ("wangset", json!(wangset.name)),
        ("kind", json!(set.kind().name())),
        ("colors", count),
        ("tiles", json!(set.size())),
        ("file", json!(args.output.as_ref().map(|file| file.to_string_lossy()))),
        ("table", json!(table)),
        ("horizontal_colors", json!(first)),
        ("vertical_colors", json!(if second.is_empty() { first } else { second })),
        ("doubles", json!(doubles)),
        ("unset", json!(wangset.unset)),
    ])
}

fn remark(wangset: &Wangset) {
    let tiles = describe::number(wangset.tiles.len() as u64, "tile");
    output::remark(&format!(
        "wangset '{}': {tiles}, {}",
        wangset.name,
        describe::set(&wangset.set)
    ));
    let (kind, colors) = (wangset.set.kind(), wangset.set.colors());
    if wangset.set.size() == kind.tiles(colors) {
        let known = format!("--kind {kind} --colors {colors}");
        output::remark(&format!(
            "these are all tiles over their colors: find knows them as {known}"
        ));
    }
    if !wangset.doubles.is_empty() {
        let listed = wangset.doubles.iter().map(|(id, first)| format!("{id} (as {first})"));
        let listed: Vec<String> = listed.collect();
        output::remark(&format!("left out, with the colors of others: {}", listed.join(", ")));
    }
    if !wangset.unset.is_empty() {
        let listed: Vec<String> = wangset.unset.iter().map(u64::to_string).collect();
        output::remark(&format!("left out, with unset colors: {}", listed.join(", ")));
    }
    if wangset.transformed {
        output::remark("Tiled may flip or rotate these tiles; here they lie as they are drawn");
    }
}
