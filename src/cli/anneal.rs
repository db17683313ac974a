//! `find --method anneal`: a packing of a compact corner set by annealing under a symmetry.
//!
//! Where it cannot work it is refused, with what would. It never says that there is no packing.

use super::args::FindArgs;
use super::exit::Exit;
use super::found::{Found, Heuristic};
use super::session::Session;
use super::{construct, problem};
use crate::anneal::{self, Annealed};
use crate::store::check_writable;
use crate::tiles::{Kind, TileSet};
use crate::torus::{Lattice, Shape};
use anyhow::bail;
use serde_json::json;

/// Runs the command; `why` it was chosen, if the program did.
///
/// # Errors
/// Options that annealing does not know, bad input, or a file that cannot be written.
pub fn run(args: &FindArgs, why: Option<String>) -> anyhow::Result<Exit> {
    if let Some(option) = construct::asks_for_search(args) {
        bail!("--method anneal and {option} do not go together");
    }
    let (set, shape) = problem::set_and_shape(&args.problem)?;
    construct::check_size(&set, shape)?;
    if set.kind() != Kind::Corner || !set.is_compact() {
        bail!("--method anneal is for compact corner sets, and for coverings (--cover)");
    }
    let colors = set.colors().largest();
    if !anneal::compact::suits(colors, shape) {
        bail!(
            "--method anneal: size {shape} has no side that is a multiple of {colors} and above it"
        );
    }
    if let Some(file) = &args.output {
        check_writable(file)?;
    }
    let session = Session::new(&args.search.run)?;
    let seed = args.search.seed;
    let fields = vec![("seed", json!(seed)), ("why", json!(why))];
    let heuristic = Heuristic { args, shape: Some(shape), fields };
    let (Annealed { labels, moves }, ended) =
        session.bounded(|_, limits| anneal::compact_corner(colors, shape, seed, limits));
    let Some(labels) = labels else {
        let how_far = format!("{moves} moves; no packing found so far");
        return heuristic.stopped("anneal", &ended, moves, Vec::new(), &how_far);
    };
    let found = Found {
        packing: &Lattice { kind: Kind::Corner, shape }.packing(&labels, &set, false),
        method: "anneal",
        how: &format!("annealing under a symmetry (seed {seed})"),
        remark: &format!("{moves} moves"),
        nodes: moves,
        fields: Vec::new(),
        provenance: vec![("nodes", json!(moves.to_string())), ("seed", json!(seed))],
    };
    heuristic.found(&session, found, &ended)
}

/// Whether annealing finds a packing in seconds, as far as was measured.
pub fn is_quick(set: &TileSet, shape: Shape) -> bool {
    let colors = set.colors().largest();
    set.kind() == Kind::Corner
        && set.is_compact()
        && colors <= 8
        && set.size() == shape.cells() as u64
        && anneal::compact::suits(colors, shape)
}
