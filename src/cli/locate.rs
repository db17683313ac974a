//! `locate`: where tiles lie in the constructed packing, which is not written out for it.

use super::args::{BoardArgs, LocateArgs, ProblemArgs};
use super::exit::Exit;
use super::{construct, output, problem, ring};
use crate::construct::NotConstructed;
use crate::tiles::{TileId, TileSet};
use crate::torus::Packing;
use anyhow::{Context, bail};
use serde_json::{Value, json};

/// Runs the command.
///
/// # Errors
/// Bad input.
pub fn run(args: &LocateArgs) -> anyhow::Result<Exit> {
    let problem = ProblemArgs {
        set: args.set.clone(),
        size: args.size.clone(),
        board: BoardArgs::default(),
        cover: false,
        automorphism: None,
        pin: None,
    };
    let (set, shape) = problem::set_and_shape(&problem)?;
    construct::check_size(&set, shape)?;
    let tiles: Vec<TileId> =
        args.tiles.iter().map(|text| tile(text, &set)).collect::<anyhow::Result<_>>()?;
    let constructed = match ring::find(&set, shape, args.seed, args.ring)? {
        Ok(constructed) => constructed,
        Err(why) => {
            let result = match why {
                NotConstructed::Impossible(_) => "none",
                NotConstructed::Unknown(_) => "unknown",
            };
            let why = why.to_string();
            match args.json {
                true => output::object(&[("result", json!(result)), ("reason", json!(why))])?,
                false => output::line(&format!("{result}: {why}"))?,
            }
            return Ok(Exit::No);
        }
    };
    let mut places = Vec::with_capacity(tiles.len());
    for &tile in &tiles {
        let place = constructed.locate(tile);
        places.push(place.with_context(|| {
            let place = if set.is_compact() { "this packing" } else { "the set" };
            format!("tile {tile} is not in {place}")
        })?);
    }
    let found = tiles.iter().zip(&places);
    if args.json {
        let about = Packing::new(set.clone(), shape, false, Vec::new());
        let description = output::description(&about);
        let list: Vec<Value> = found
            .map(|(tile, (row, column))| json!({ "tile": tile.0, "row": row, "column": column }))
            .collect();
        output::object(&[
            ("kind", description["kind"].clone()),
            ("colors", description["colors"].clone()),
            ("width", json!(shape.width())),
            ("height", json!(shape.height())),
            ("construction", json!(constructed.name())),
            ("source", json!(constructed.source())),
            ("seed", json!(args.seed)),
            ("tiles", json!(list)),
        ])?;
    } else {
        output::result(|out| {
            found.into_iter().try_for_each(|(&tile, (row, column))| {
                let sides = set.kind().describe(tile, set.colors());
                writeln!(out, "tile {tile} ({sides}): row {row}, column {column}")
            })
        })?;
    }
    Ok(Exit::Yes)
}

/// A tile by its number or its colors.
fn tile(text: &str, set: &TileSet) -> anyhow::Result<TileId> {
    let (kind, colors) = (set.kind(), set.colors());
    let number = |digits: &str| -> anyhow::Result<u64> {
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            bail!("tile '{text}': expected a number, or {}", kind.sides().join(","));
        }
        Ok(digits.parse().unwrap_or(u64::MAX))
    };
    if !text.contains(',') {
        let (tile, max) = (number(text)?, kind.tiles(colors) - 1);
        if tile > max {
            bail!("tile {tile} is out of range: expected 0 to {max}");
        }
        return Ok(TileId(tile as u32));
    }
    let sides: Vec<u8> = text
        .split(',')
        .map(|side| Ok(u8::try_from(number(side)?).unwrap_or(u8::MAX)))
        .collect::<anyhow::Result<_>>()?;
    if sides.len() != kind.sides().len() {
        let (expected, given) = (kind.sides(), sides.len());
        bail!("tile '{text}': expected {}, but {given} colors are given", expected.join(","));
    }
    kind.pack(&sides, colors).with_context(|| format!("tile '{text}'"))
}
