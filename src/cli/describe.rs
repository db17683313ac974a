//! Sets, packings and sizes in words.

use crate::packing::{Job, Question, Task};
use crate::tiles::{Kind, Members, TileSet};
use crate::torus::{Board, Packing, Shape, Topology};

/// A set: `complete corner set over 4 colors`.
pub fn set(set: &TileSet) -> String {
    let (kind, colors) = (set.kind(), colors(set));
    match set.members() {
        Members::Complete => format!("complete {kind} set over {colors}"),
        Members::Compact => format!("compact {kind} set over {colors}"),
        Members::Pruned(pairs) => {
            let pairs: Vec<String> = pairs.iter().map(|(a, b)| format!("{a}-{b}")).collect();
            format!("pruned {kind} set (no {}) over {colors}", pairs.join(", "))
        }
        Members::Explicit(_) => format!("explicit {kind} set over {colors}"),
    }
}

/// `4 colors`, `2 horizontal and 3 vertical colors`.
fn colors(set: &TileSet) -> String {
    let colors = set.colors();
    match colors.single() {
        Some(count) => number(count as u64, "color"),
        None => format!(
            "{} on north and south edges and {} on east and west edges",
            number(colors.horizontal() as u64, "color"),
            number(colors.vertical() as u64, "color")
        ),
    }
}

/// A torus: `16x16 torus`, or `ring of 9 (9x1)` for dominoes.
pub fn torus(kind: Kind, shape: Shape) -> String {
    match kind {
        Kind::Domino => format!("ring of {} ({shape})", shape.cells()),
        _ => format!("{shape} torus"),
    }
}

/// What a packing lies on: as [`torus`], or `6x4 rectangle with border 1`.
pub fn board(kind: Kind, shape: Shape, board: &Board) -> String {
    let Board { topology, rotations, border } = board;
    let on = match topology {
        Topology::Torus => torus(kind, shape),
        _ => format!("{shape} {topology}"),
    };
    let border = match border.single(*topology, shape) {
        _ if border.is_free() => String::new(),
        Some(color) => format!(" with border {color}"),
        None => " with a border".to_owned(),
    };
    let turned = if *rotations { ", squares turned" } else { "" };
    format!("{on}{border}{turned}")
}

/// How often the tiles of a valid packing occur: `each of 256 tiles once`.
pub fn occurrences(packing: &Packing) -> String {
    let tiles = number(packing.set.size(), "tile");
    match (packing.cover, packing.set.is_compact()) {
        (false, false) => format!("each of {tiles} once"),
        (true, false) => format!("each of {tiles} at least once"),
        (false, true) => format!("{tiles}, {}, each once", fixed(&packing.set)),
        (true, true) => format!("{tiles}, {}, each at least once", fixed(&packing.set)),
    }
}

fn fixed(set: &TileSet) -> &'static str {
    match set.kind() {
        Kind::Corner => "two for each (NW, SW, SE)",
        _ => "two for each (N, W)",
    }
}

/// What a question is about: `packing`, `covering`.
pub fn sought(task: &Task) -> &'static str {
    if task.cover { "covering" } else { "packing" }
}

/// What is asked of it besides: ` with this automorphism and these pins`.
pub fn conditions(task: &Task) -> &'static str {
    match (task.automorphism.is_some(), task.has_pins()) {
        (false, false) => "",
        (true, false) => " with this automorphism",
        (false, true) => " with these pins",
        (true, true) => " with this automorphism and these pins",
    }
}

/// A search: `count: complete corner set over 3 colors, 9x9 torus, with this automorphism`.
pub fn job(job: &Job) -> String {
    let task = &job.task;
    let question = match job.question {
        Question::First => "find",
        Question::Count { .. } => "count",
        Question::List { .. } => "list",
    };
    let symmetry = if job.up_to_symmetry() { " up to symmetry" } else { "" };
    let part = match job.part {
        Some(part) => format!(", part {} of {}", part.number, part.of),
        None => String::new(),
    };
    let (set, torus) = (set(&task.set), board(task.set.kind(), task.shape, &task.board));
    format!("{question}{symmetry}: {set}, {torus}{}{part}", conditions(task))
}

/// The same in a few characters that suit the name of a file: `count-corner-3-9x9`.
pub fn slug(job: &Job) -> String {
    let set = &job.task.set;
    let question = match job.question {
        Question::First => "find",
        Question::Count { .. } => "count",
        Question::List { .. } => "list",
    };
    let members = match set.members() {
        Members::Complete => "",
        Members::Compact => "-compact",
        Members::Pruned(_) => "-pruned",
        Members::Explicit(_) => "-explicit",
    };
    let colors = set.colors().to_string().replace(',', "x");
    let board = match &job.task.board {
        Board { topology: Topology::Torus, rotations: false, .. } => String::new(),
        Board { topology, rotations, .. } => {
            format!("-{topology}{}", if *rotations { "-turned" } else { "" })
        }
    };
    format!("{question}-{}-{colors}{members}-{}{board}", set.kind(), job.task.shape)
}

/// That a finished search found nothing.
pub fn nothing(task: &Task) -> String {
    let (sought, conditions) = (sought(task), conditions(task));
    format!("there is no {sought}{conditions}: the search went through all possibilities")
}

/// What a search meets, when that are solutions.
pub const SOLUTION: &str = "solution";

/// What the search of a job meets: solutions, or choices that stand for many.
pub fn leaf(job: &Job) -> &'static str {
    if job.by_lines { "choice" } else { SOLUTION }
}

/// How many solutions were met; nothing where what is met stands for many.
pub fn solutions_met(job: &Job, met: u64) -> Option<String> {
    (!job.by_lines).then(|| met.to_string())
}

/// How packings are counted: `search`.
pub fn method(job: &Job) -> &'static str {
    if job.by_lines { "meeting in the middle" } else { "search" }
}

/// `1 tile`, `2 tiles`.
pub fn number(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
