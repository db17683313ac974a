//! Raw arguments to a validated [`Task`]: every mistake in them is told before any work is done.

use super::args::{ProblemArgs, SearchArgs};
use super::{board, output, set};
use crate::packing::Task;
use crate::store::{Input, read_pins, read_pins_on_board};
use crate::symmetry::{self, Automorphism};
use crate::tiles::TileSet;
use crate::torus::{Order, Shape};
use anyhow::Context;

/// The tiles and the torus that the options describe; whether they suit each other is not looked
/// at.
///
/// # Errors
/// Anything malformed, contradictory or missing.
pub fn set_and_shape(args: &ProblemArgs) -> anyhow::Result<(TileSet, Shape)> {
    let shape: Option<Shape> = match &args.size {
        None => None,
        Some(text) => Some(text.parse().context("--size")?),
    };
    let set = match args.board.rotations {
        true => set::squares(&args.set)?,
        false => set::tile_set(&args.set, shape)?,
    };
    let shape = match shape {
        Some(shape) => shape,
        None => Shape::default_for(&set)?,
    };
    Ok((set, shape))
}

/// The task of a search.
///
/// # Errors
/// As [`task`].
pub fn search_task(args: &ProblemArgs, search: &SearchArgs) -> anyhow::Result<Task> {
    let prunings = search.prunings;
    let task = Task { prunings, ..task(args, search.order)? };
    task.check()?;
    Ok(task)
}

/// The task that the options describe.
///
/// # Errors
/// Anything malformed, contradictory, missing or too large.
pub fn task(args: &ProblemArgs, order: Option<Order>) -> anyhow::Result<Task> {
    let (set, shape) = set_and_shape(args)?;
    let board = board::board(&args.board, &set, shape)?;
    Task::check_size(&set, shape)?;
    let mut task = Task::on(set, shape, board);
    task.cover = args.cover;
    task.order = order;
    if let Some(text) = &args.automorphism {
        task.automorphism = Some(match text.as_str() {
            "auto" => {
                let found = symmetry::suggest(&task.set, shape, args.cover).with_context(|| {
                    format!(
                        "--automorphism auto: no part of a side of {shape} is a step for the set"
                    )
                })?;
                // Whoever reads the answer must know what it is about, also when quiet.
                output::remark(&format!("--automorphism {found}"));
                found
            }
            text => Automorphism::parse(text, task.set.colors(), shape)?,
        });
    }
    task.check()?;
    if let Some(file) = &args.pin {
        let input = Input::open(file)?;
        task.pins = match task.board.is_plain() {
            true => read_pins(&input, task.lattice(), &task.set)?,
            false => read_pins_on_board(&input, &task.set, shape, &task.board)?,
        };
    }
    Ok(task)
}
