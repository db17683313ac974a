//! The oracle: every square in every cell, every way round; nothing prepared, nothing counted.

use std::collections::BTreeSet;
use tilepack::packing::Task;
use tilepack::tiles::Kind;
use tilepack::torus::{Packing, Topology};

/// What a board looks like: the colors N, E, S, W of every cell, row by row.
pub(crate) type Picture = Vec<[u8; 4]>;

/// All pictures of a task, by trying everything.
pub(crate) fn pictures(task: &Task) -> BTreeSet<Picture> {
    let colors = task.set.colors();
    let squares: Vec<[u8; 4]> =
        task.set.allowed().map(|tile| Kind::Wang.unpack(tile, colors)).collect();
    let mut found = BTreeSet::new();
    let mut used = vec![false; squares.len()];
    try_all(task, &squares, &mut used, &mut Vec::new(), &mut found);
    found
}

fn try_all(
    task: &Task,
    squares: &[[u8; 4]],
    used: &mut Vec<bool>,
    laid: &mut Picture,
    found: &mut BTreeSet<Picture>,
) {
    if !fits(task, laid) {
        return;
    }
    if laid.len() == task.shape.cells() {
        found.insert(laid.clone());
        return;
    }
    for (square, &[n, e, s, w]) in squares.iter().enumerate() {
        if used[square] {
            continue;
        }
        used[square] = true;
        let ways = [[n, e, s, w], [w, n, e, s], [s, w, n, e], [e, s, w, n]];
        for way in &ways[..if task.board.rotations { 4 } else { 1 }] {
            laid.push(*way);
            try_all(task, squares, used, laid, found);
            laid.pop();
        }
        used[square] = false;
    }
}

/// Whether the cells filled so far fit each other and the border.
fn fits(task: &Task, laid: &Picture) -> bool {
    let (w, h) = (task.shape.width(), task.shape.height());
    let (across, down) = match task.board.topology {
        Topology::Torus => (true, true),
        Topology::Cylinder => (true, false),
        Topology::Rectangle => (false, false),
    };
    let border = |side: usize, at: usize, color: u8| {
        task.board.border.color(side, at).is_none_or(|asked| asked == color)
    };
    (0..laid.len()).all(|cell| {
        let (row, column) = (cell / w, cell % w);
        let [north, east, south, west] = laid[cell];
        let meets = |row: usize, column: usize, side: usize, color: u8| {
            laid.get(row % h * w + column % w).is_none_or(|other| other[side] == color)
        };
        (column + 1 == w && !across || meets(row, column + 1, 3, east))
            && (row + 1 == h && !down || meets(row + 1, column, 0, south))
            && (row > 0 || down || border(0, column, north))
            && (row + 1 < h || down || border(2, column, south))
            && (column > 0 || across || border(3, row, west))
            && (column + 1 < w || across || border(1, row, east))
    })
}

/// What a packing looks like, read off its squares and turns.
pub(crate) fn picture(packing: &Packing) -> Picture {
    let sides = packing.tiles.iter().map(|&tile| Kind::Wang.unpack(tile, packing.set.colors()));
    let turns = packing.turns.iter().copied().chain(std::iter::repeat(0));
    sides
        .zip(turns)
        .map(|([n, e, s, w], turns)| {
            [[n, e, s, w], [w, n, e, s], [s, w, n, e], [e, s, w, n]][usize::from(turns)]
        })
        .collect()
}
