//! A search in JSON, and its fingerprint.
//!
//! Everything that decides which tree is walked stands in it, with nothing left to defaults, so
//! that a later version with other defaults still means the same search. Equal searches have
//! the same text, byte for byte; the fingerprint is its BLAKE3 hash.

use crate::packing::{Job, Prunings, Question, Task};
use crate::search::{Part, Values};
use crate::symmetry::Automorphism;
use crate::tiles::{Colors, Kind, Members, TileId, TileSet, notation};
use crate::torus::{Board, Border, Order, Shape, Topology};
use serde::{Deserialize, Serialize};

/// The version of the search tree. To be raised whenever a change makes some search visit other
/// nodes or in another order: what an older version has left undone means something else then.
const TREE: u32 = 1;

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Text {
    tree: u32,
    question: String,
    up_to_symmetry: bool,
    kind: String,
    colors: String,
    set: String,
    /// The tiles of an explicit set.
    #[serde(skip_serializing_if = "Option::is_none")]
    tiles: Option<Vec<u32>>,
    size: String,
    /// Of a board, where it is no torus.
    #[serde(skip_serializing_if = "Option::is_none")]
    topology: Option<String>,
    /// `true` where tiles may be turned.
    #[serde(skip_serializing_if = "Option::is_none")]
    rotations: Option<bool>,
    /// By side, north, east, south, west, where any color is prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    border: Option<[Vec<Option<u8>>; 4]>,
    cover: bool,
    automorphism: Option<String>,
    pins: Option<Vec<Option<u8>>>,
    order: String,
    /// Left out where they are the usual ones.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    prunings: Option<String>,
    /// Of random values; else they are lexicographic.
    seed: Option<u64>,
    /// Without a seed: the largest value first.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    highest_first: bool,
    symmetry_removed: bool,
    /// Left out where it is not so: searches saved before there was anything else.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    by_lines: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<PartText>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct PartText {
    number: u64,
    of: u64,
    depth: usize,
}

/// The text of a job.
pub fn write_job(job: &Job) -> String {
    let Job { task, question, values, reduce, part, by_lines } = job;
    let tiles = match task.set.members() {
        Members::Explicit(tiles) => Some(tiles.iter().map(|tile| tile.0).collect()),
        _ => None,
    };
    let set = match tiles {
        Some(_) => "tiles".to_owned(),
        None => notation::write_members(task.set.members()),
    };
    let text = Text {
        tree: TREE,
        question: match question {
            Question::First => "first",
            Question::Count { .. } => "count",
            Question::List { .. } => "list",
        }
        .to_owned(),
        up_to_symmetry: job.up_to_symmetry(),
        kind: task.set.kind().to_string(),
        colors: task.set.colors().to_string(),
        set,
        tiles,
        size: task.shape.to_string(),
        topology: Some(task.board.topology)
            .filter(|&topology| topology != Topology::Torus)
            .map(|topology| topology.to_string()),
        rotations: task.board.rotations.then_some(true),
        border: (!task.board.border.is_free())
            .then(|| std::array::from_fn(|side| task.board.border.side(side).to_vec())),
        cover: task.cover,
        automorphism: task.automorphism.as_ref().map(ToString::to_string),
        pins: task.has_pins().then(|| task.pins.labels().to_vec()),
        order: job.order().to_string(),
        prunings: (task.prunings != Prunings::default()).then(|| task.prunings.to_string()),
        seed: match values {
            Values::Lexicographic | Values::Highest => None,
            Values::Random(seed) => Some(*seed),
        },
        highest_first: *values == Values::Highest,
        symmetry_removed: *reduce,
        by_lines: *by_lines,
        part: part.map(|Part { number, of, depth }| PartText { number, of, depth }),
    };
    // Numbers, words and lists of them have a JSON form.
    serde_json::to_string(&text).unwrap_or_default()
}

/// The job of a text.
///
/// # Errors
/// When it is not the text of a job that this version runs, and why.
pub fn read_job(text: &str) -> Result<Job, String> {
    let said: Text = serde_json::from_str(text).map_err(|error| error.to_string())?;
    if said.tree != TREE {
        return Err(format!(
            "the search is of version {}, but this program walks version {TREE}: \
             finish it with the program that began it",
            said.tree
        ));
    }
    let job = job(&said)?;
    job.check().map_err(|error| error.to_string())?;
    if write_job(&job) != text {
        return Err("the search is described in a form that this program does not write".into());
    }
    Ok(job)
}

fn job(said: &Text) -> Result<Job, String> {
    fn wrong(error: impl ToString) -> String {
        error.to_string()
    }
    let up_to_symmetry = said.up_to_symmetry;
    let question = match said.question.as_str() {
        "first" => Question::First,
        "count" => Question::Count { up_to_symmetry },
        "list" => Question::List { up_to_symmetry },
        other => return Err(format!("unknown question {other:?}")),
    };
    let kind: Kind = said.kind.parse().map_err(wrong)?;
    let colors: Colors = said.colors.parse().map_err(wrong)?;
    let members = match &said.tiles {
        Some(tiles) => Members::Explicit(tiles.iter().copied().map(TileId).collect()),
        None => notation::parse_members(&said.set)
            .map_err(wrong)?
            .ok_or_else(|| format!("unknown set {:?}", said.set))?,
    };
    let rotations = said.rotations.unwrap_or(false);
    let set = match members {
        Members::Explicit(tiles) if rotations && kind == Kind::Wang => {
            TileSet::squares(colors, tiles)
        }
        members => TileSet::new(kind, colors, members),
    };
    let set = set.map_err(wrong)?;
    let shape: Shape = said.size.parse().map_err(wrong)?;
    Task::check_size(&set, shape).map_err(wrong)?;
    let topology = said.topology.as_deref().unwrap_or("torus").parse::<Topology>()?;
    let border = Border::new(topology, shape, said.border.clone().unwrap_or_default());
    let board = Board { topology, rotations, border: border.map_err(wrong)? };
    let mut task = Task::on(set, shape, board);
    task.cover = said.cover;
    task.order = Some(said.order.parse::<Order>().map_err(wrong)?);
    if let Some(text) = &said.prunings {
        task.prunings = text.parse()?;
    }
    if let Some(text) = &said.automorphism {
        task.automorphism = Some(Automorphism::parse(text, colors, shape).map_err(wrong)?);
    }
    if let Some(pins) = &said.pins {
        let labels = task.pins.labels().len();
        if pins.len() != labels {
            return Err(format!("{} pins for {labels} labels", pins.len()));
        }
        for (label, color) in pins.iter().enumerate() {
            let Some(color) = *color else { continue };
            // The labels of a Wang tile are those of its north and west edges.
            let odd = match label.checked_sub(2 * shape.cells()) {
                // The outer east edges come after those of all cells.
                Some(outer) => topology == Topology::Rectangle && outer < shape.height(),
                None => label % 2 == 1,
            };
            let palette = match kind == Kind::Wang && odd {
                true => colors.vertical(),
                false => colors.horizontal(),
            };
            if usize::from(color) >= palette {
                return Err(format!("pin {label}: color {color} is not one of the set's"));
            }
            // Every label once, so there is nothing to contradict.
            let _ = task.pins.pin(label, color);
        }
    }
    let part = match said.part {
        None => None,
        Some(PartText { number, of, depth }) if number < of && depth > 0 => {
            Some(Part { depth, number, of })
        }
        Some(ref part) => return Err(format!("there is no part {} of {}", part.number, part.of)),
    };
    let values = match (said.seed, said.highest_first) {
        (None, false) => Values::Lexicographic,
        (None, true) => Values::Highest,
        (Some(seed), false) => Values::Random(seed),
        (Some(_), true) => return Err("values are in random order, or highest first".into()),
    };
    let (reduce, by_lines) = (said.symmetry_removed, said.by_lines);
    Ok(Job { task, question, values, reduce, part, by_lines })
}

/// The fingerprint of a text.
pub fn fingerprint(text: &str) -> [u8; 32] {
    *blake3::hash(text.as_bytes()).as_bytes()
}
