//! Raw arguments to a validated [`Task`]: every mistake in them is told before any work is done.

use super::args::ProblemArgs;
use super::set;
use crate::packing::{MAX_SEARCH_COLORS, Task, TaskError};
use crate::store::{Input, read_pins};
use crate::symmetry::Automorphism;
use crate::torus::{Order, Shape};
use anyhow::{Context, bail};

/// Cells of the largest torus for which a task is made. Fewer are searched; but this many do not
/// fill the memory before the search can say so.
const MAX_CELLS: usize = 1 << 20;

/// The task that the options describe.
///
/// # Errors
/// Anything malformed, contradictory, missing or too large.
pub fn task(args: &ProblemArgs, order: Option<Order>) -> anyhow::Result<Task> {
    let shape: Option<Shape> = match &args.size {
        None => None,
        Some(text) => Some(text.parse().context("--size")?),
    };
    let set = set::tile_set(&args.set, shape)?;
    let colors = set.colors().largest();
    if colors > MAX_SEARCH_COLORS {
        return Err(TaskError::TooManyColors(colors).into());
    }
    let shape = match shape {
        Some(shape) => shape,
        None => Shape::default_for(&set)?,
    };
    // A task keeps a few bytes for every cell, so its size is looked at before there is one.
    if shape.cells() > MAX_CELLS {
        let cells = shape.cells();
        bail!("size {shape} has {cells} cells: the search handles up to {MAX_CELLS}");
    }
    let mut task = Task::new(set, shape);
    task.cover = args.cover;
    task.order = order;
    if let Some(text) = &args.automorphism {
        task.automorphism = Some(Automorphism::parse(text, task.set.colors(), shape)?);
    }
    task.check()?;
    if let Some(file) = &args.pin {
        task.pins = read_pins(&Input::open(file)?, task.lattice(), &task.set)?;
    }
    Ok(task)
}
