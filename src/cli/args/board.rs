//! Options about boards.

use crate::torus::Topology;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;

fn topologies() -> impl TypedValueParser<Value = Topology> {
    PossibleValuesParser::new(Topology::ALL.map(Topology::name))
        .try_map(|text| text.parse::<Topology>())
}

/// What the packing lies on, and whether its tiles may be turned.
#[derive(Debug, Clone, Default, Args)]
pub struct BoardArgs {
    /// Which sides of the board meet: all (torus, the default), east and west (cylinder), or
    /// none (rectangle); Wang tiles only
    #[arg(long, value_name = "TOPOLOGY", value_parser = topologies(), hide_possible_values = true)]
    pub topology: Option<Topology>,
    /// Wang tiles are squares that may be turned by quarter turns, each used once
    #[arg(long)]
    pub rotations: bool,
    /// Outer sides of a rectangle or cylinder: all of one color, or as a file says, with lines
    /// such as: north 0 0 . 1 (. is free) [default: free]
    #[arg(long, value_name = "COLOR|FILE", allow_hyphen_values = true)]
    pub border: Option<PathBuf>,
}

impl BoardArgs {
    /// The option that asks for more than a torus of fixed tiles, if one was given.
    pub fn given(&self) -> Option<&'static str> {
        let options = [
            (self.rotations, "--rotations"),
            (self.border.is_some(), "--border"),
            (self.topology.is_some_and(|topology| topology != Topology::Torus), "--topology"),
        ];
        options.into_iter().find_map(|(given, option)| given.then_some(option))
    }
}
