//! Raw arguments to a board.

use super::args::{BoardArgs, ProblemArgs};
use crate::store::{Input, read_border};
use crate::tiles::TileSet;
use crate::torus::{Board, Border, Shape, Topology};
use anyhow::{Context, bail};

/// The board that the options describe.
///
/// # Errors
/// A border where there is none, or one that does not suit.
pub(super) fn board(args: &BoardArgs, set: &TileSet, shape: Shape) -> anyhow::Result<Board> {
    let (topology, rotations) = (args.topology.unwrap_or_default(), args.rotations);
    let border = match &args.border {
        None => Border::default(),
        Some(_) if topology == Topology::Torus => {
            bail!("--border: a torus has none: it needs --topology rectangle or cylinder")
        }
        Some(text) => {
            let word = text.to_string_lossy();
            match word.bytes().all(|byte| byte.is_ascii_digit()) && !word.is_empty() {
                false => read_border(&Input::open(text)?, topology, shape)?,
                true => {
                    let color: u64 = word.parse().unwrap_or(u64::MAX);
                    let colors = set.colors();
                    let palette = match topology {
                        Topology::Rectangle => colors.horizontal().min(colors.vertical()),
                        _ => colors.horizontal(),
                    };
                    let color = u8::try_from(color).ok().filter(|&c| usize::from(c) < palette);
                    let color = color.with_context(|| {
                        format!("--border {word}: expected a color from 0 to {}", palette - 1)
                    })?;
                    Border::of_one(topology, shape, color)
                }
            }
        }
    };
    Ok(Board { topology, rotations, border })
}

/// Refuses what is about boards, for a command that knows only tori of tiles as they are.
///
/// # Errors
/// When such an option is given.
pub(super) fn refuse(args: &ProblemArgs, command: &str) -> anyhow::Result<()> {
    match args.board.given() {
        Some(option) => {
            bail!("{command} and {option} do not go together: it knows tori and no turns")
        }
        None => Ok(()),
    }
}
