//! Raw arguments to a tile set, or to a claim about one.
//!
//! `--set` is a word of the notation or names a file; a file knows its kind and may know its
//! colors, and what the options say must then agree.

use super::args::{ClaimArgs, SetArgs};
use crate::store::{Claim, Input, StoreError, read_squares, read_tile_set};
use crate::tiles::{Colors, Kind, Members, TileError, TileSet, notation};
use crate::torus::Shape;
use anyhow::{Context, bail};
use std::path::Path;

/// What the options say about a set; nothing is required. The colors of dominoes are those of
/// a ring of this shape (of a row, if there is none).
///
/// # Errors
/// Text of another form, a file that cannot be read, a contradiction.
pub fn claim(args: &SetArgs, shape: Option<Shape>) -> anyhow::Result<Claim> {
    claim_of(args, shape, false)
}

/// The same, also about squares that may be turned.
fn claim_of(args: &SetArgs, shape: Option<Shape>, squares: bool) -> anyhow::Result<Claim> {
    let mut claim = Claim { kind: args.kind, ..Claim::default() };
    if let Some(text) = &args.colors {
        claim.colors = Some(text.parse().with_context(|| format!("--colors {text}"))?);
    }
    let Some(set) = &args.set else { return Ok(claim) };
    let word = set.to_string_lossy();
    match notation::parse_members(&word)? {
        Some(members) => claim.members = Some(members),
        None => {
            let ring = |kind| kind == Some(Kind::Domino);
            if ring(claim.kind) {
                claim.colors = claim.colors.map(|colors| ring_colors(colors, shape));
            }
            let named = read_set(set, claim.colors, squares)?;
            if let Some(kind) = claim.kind.filter(|&kind| kind != named.kind()) {
                bail!("{word}: kind {} in the file, but --kind {kind}", named.kind());
            }
            claim.kind = Some(named.kind());
            claim.colors = Some(named.colors());
            claim.members = Some(named.members().clone());
        }
    }
    Ok(claim)
}

/// What the options say about packings in a file.
///
/// # Errors
/// As [`claim`].
pub fn packing_claim(args: &ClaimArgs) -> anyhow::Result<Claim> {
    let claim = claim(&args.set, None)?;
    if let (Some(kind), Some(colors)) = (claim.kind, claim.colors) {
        // A mistake in the options is one, whatever the files are.
        TileSet::new(kind, colors, claim.members.clone().unwrap_or(Members::Complete))?;
    }
    Ok(Claim { cover: args.cover.then_some(true), ..claim })
}

/// The set that the options describe.
///
/// # Errors
/// As [`claim`]; also when kind or colors are missing, or the set cannot be.
pub fn tile_set(args: &SetArgs, shape: Option<Shape>) -> anyhow::Result<TileSet> {
    let claim = claim(args, shape)?;
    let missing = |option| format!("{option} is missing (only a tile set file can stand in)");
    let kind = claim.kind.with_context(|| missing("--kind corner|wang|domino"))?;
    let colors = claim.colors.with_context(|| missing("--colors C"))?;
    let colors = if kind == Kind::Domino { ring_colors(colors, shape) } else { colors };
    Ok(TileSet::new(kind, colors, claim.members.unwrap_or(Members::Complete))?)
}

/// The set of squares that the options describe, which may be turned.
///
/// # Errors
/// As [`tile_set`]; also another kind than Wang tiles, or two palettes.
pub fn squares(args: &SetArgs) -> anyhow::Result<TileSet> {
    if let Some(kind) = args.kind.filter(|&kind| kind != Kind::Wang) {
        bail!("--rotations: {kind} tiles are not turned, only Wang tiles are");
    }
    let claim = claim_of(args, None, true)?;
    match (claim.members, claim.colors) {
        (Some(Members::Explicit(tiles)), Some(colors)) => Ok(TileSet::squares(colors, tiles)?),
        _ => tile_set(args, None),
    }
}

fn ring_colors(colors: Colors, shape: Option<Shape>) -> Colors {
    shape.map_or(colors.of_row(), |shape| shape.ring_colors(colors))
}

fn read_set(file: &Path, colors: Option<Colors>, squares: bool) -> anyhow::Result<TileSet> {
    let input = Input::open(file).map_err(|error| match error {
        StoreError::Missing { .. } => {
            let syntax = TileError::SetSyntax(file.display().to_string());
            anyhow::anyhow!("{syntax}, but there is no such file")
        }
        error => error.into(),
    })?;
    let named = match squares {
        true => read_squares(&input, colors)?,
        false => read_tile_set(&input, colors)?,
    };
    Ok(named.set)
}
