//! `--ring`: the order of the rings that dominoes and Wang tiles are constructed from.
//!
//! The least ring is ours; that of Wei (2004) begins with the ring for fewer colors, which makes
//! the packing recursive. Where there is no ring, or a seed chooses one, the option is refused
//! rather than left out of account.

use super::args::{FindArgs, Method};
use super::construct;
use crate::construct::{Constructed, NotConstructed, construct_wei};
use crate::tiles::{Kind, Members, TileSet};
use crate::torus::Shape;
use anyhow::bail;
use clap::ValueEnum;

/// Rings of all dominoes in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum RingOrder {
    /// The lexicographically least ring
    #[default]
    Least,
    /// Wei's ring, which begins with that for fewer colors: packings are recursive
    Wei,
}

/// Refuses Wei's ring for what is not constructed.
///
/// # Errors
/// When it is asked for along with another method.
pub fn refuse(args: &FindArgs) -> anyhow::Result<()> {
    if args.ring == RingOrder::Wei
        && matches!(args.method, Method::Search | Method::Beam | Method::Anneal)
    {
        bail!("--ring wei is for a construction: use --method construct");
    }
    Ok(())
}

/// The construction with rings of this order, as [`construct::find`].
///
/// # Errors
/// When there is no choice of rings; the inner error says why there is no construction.
pub(super) fn find(
    set: &TileSet,
    shape: Shape,
    seed: u64,
    ring: RingOrder,
) -> anyhow::Result<Result<Constructed, NotConstructed>> {
    if ring == RingOrder::Least {
        return Ok(construct::find(set, shape, seed));
    }
    if set.kind() == Kind::Corner || *set.members() != Members::Complete {
        bail!("--ring wei is for all dominoes or all Wang tiles over some colors");
    }
    if seed != 0 {
        bail!("--ring wei and --seed do not go together: a seed chooses other rings");
    }
    Ok(construct_wei(set, shape))
}
