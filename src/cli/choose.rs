//! What `find --method auto` does, and why: a construction where one is known, a heuristic where
//! one is known to be quick, exhaustive search for everything else.

use super::args::FindArgs;
use super::{anneal, construct, problem, set};
use crate::construct::{Constructed, NotConstructed};
use crate::tiles::{Kind, Members, TileSet};
use crate::torus::Shape;

/// Sets of so many tiles are searched; of more, search finds packings by luck only.
const MOST_TO_SEARCH: u64 = 100;

/// Coverings of sets of so many tiles are searched.
const MOST_TO_COVER: u64 = 30;

/// Sets of so many tiles have been packed by beam search.
const MOST_TO_BEAM: u64 = 1000;

/// A way to find a packing.
#[derive(Debug)]
pub enum Way {
    /// It is constructed already.
    Constructed(Box<Constructed>),
    /// Annealing.
    Anneal,
    /// Beam search.
    Beam,
    /// Annealing and beam search for coverings.
    Cover,
    /// Exhaustive search.
    Search,
}

/// The way for a problem, and the reason in words.
///
/// # Errors
/// Bad input.
pub fn choose(args: &FindArgs) -> anyhow::Result<(Way, String)> {
    if args.aspect.is_some() {
        return Ok((Way::Cover, "--aspect is for coverings by annealing".into()));
    }
    if let Some(tiles) = coverable(args)? {
        let why = format!("{tiles} tiles are too many to search for coverings of them");
        return Ok((Way::Cover, why));
    }
    if let Some(option) = construct::asks_for_search(args) {
        return Ok((Way::Search, format!("{option} is for a search")));
    }
    let (set, shape) = problem::set_and_shape(&args.problem)?;
    Ok(match construct::find(&set, shape, args.search.seed) {
        Ok(constructed) => {
            (Way::Constructed(Box::new(constructed)), "a construction is known".into())
        }
        Err(why @ NotConstructed::Impossible(_)) => (Way::Search, why.to_string()),
        Err(NotConstructed::Unknown(_)) if anneal::is_quick(&set, shape) => {
            let quick = "no construction is known, and sets like this anneal in seconds";
            (Way::Anneal, quick.into())
        }
        Err(NotConstructed::Unknown(_)) if beam_is_quick(&set, shape) => {
            let quick = "no construction is known, and beam search packs sets like this in seconds";
            (Way::Beam, quick.into())
        }
        Err(why) => (Way::Search, why.to_string()),
    })
}

/// The number of tiles, where coverings are asked for that annealing and beam search find sooner
/// than exhaustive search, and nothing but that is asked for.
fn coverable(args: &FindArgs) -> anyhow::Result<Option<u64>> {
    let mut less = args.clone();
    (less.problem.cover, less.problem.automorphism) = (false, None);
    if !args.problem.cover || construct::asks_for_search(&less).is_some() {
        return Ok(None);
    }
    let set = set::tile_set(&args.problem.set, None)?;
    let named = !set.is_compact() && set.kind() == Kind::Corner;
    let sized = args.problem.size.is_some() || args.problem.automorphism.is_none();
    Ok((named && sized && set.size() > MOST_TO_COVER).then_some(set.size()))
}

fn beam_is_quick(set: &TileSet, shape: Shape) -> bool {
    set.kind() == Kind::Corner
        && matches!(set.members(), Members::Pruned(_))
        && (MOST_TO_SEARCH..=MOST_TO_BEAM).contains(&set.size())
        && set.size() == shape.cells() as u64
        && shape.width().min(shape.height()) >= 3
}
