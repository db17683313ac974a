//! The boards of the Eternity II kind under `data/`, and how they are made.
//!
//! A picture of a framed board is cut into squares: the outer sides have color 0, the edges
//! between two squares of the frame have colors of their own, and all others the rest; each
//! color is used equally often, as far as that goes. It is shuffled until no two squares are
//! alike and none looks the same when turned. The squares are then sorted, each turned so that
//! it is least, which leaves nothing of the picture. With `WRITE_BOARDS=1` the test writes the
//! files instead of comparing them.

use std::collections::BTreeSet;
use std::fs;
use tilepack::store::{Input, read_squares, write_tile_set};
use tilepack::tiles::{Colors, Kind, TileId, TileSet};
use tilepack::torus::{Cell, Edges, Shape, Topology};

/// Side, colors of edges in the frame, other inner colors, seed.
const BOARDS: &[(u64, u8, u8, u64)] = &[(6, 3, 6, 1), (10, 4, 13, 1), (16, 5, 17, 1)];

/// The finalizer of SplitMix64 on a counter.
fn random(state: &mut u64, below: usize) -> usize {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((x ^ (x >> 31)) % below as u64) as usize
}

fn shuffled(count: usize, colors: std::ops::Range<u8>, state: &mut u64) -> Vec<u8> {
    let mut list: Vec<u8> = colors.cycle().take(count).collect();
    for i in (1..count).rev() {
        list.swap(i, random(state, i + 1));
    }
    list
}

/// The squares of a board with a solution, and after how many shuffles.
fn board(side: u64, frame: u8, inner: u8, seed: u64) -> (TileSet, usize) {
    let shape = Shape::new(side, side).unwrap();
    let edges = Edges { shape, topology: Topology::Rectangle };
    let colors = Colors::one(u64::from(1 + frame + inner)).unwrap();
    let cells = || (0..shape.cells() as u32).map(Cell);
    let in_frame = |cell: Cell| {
        let (row, column) = shape.position(cell);
        let last = side as usize - 1;
        row == 0 || column == 0 || row == last || column == last
    };
    let mut touching = vec![Vec::new(); edges.labels()];
    cells().for_each(|cell| edges.sides(cell).into_iter().for_each(|at| touching[at].push(cell)));
    let of_frame = |at: &usize| touching[*at].iter().all(|&cell| in_frame(cell));
    let (between, rest): (Vec<usize>, Vec<usize>) =
        (0..edges.labels()).filter(|&at| touching[at].len() == 2).partition(of_frame);
    let mut state = seed;
    for tries in 1.. {
        let mut labels = vec![0; edges.labels()];
        let colors_between = shuffled(between.len(), 1..1 + frame, &mut state);
        let others = shuffled(rest.len(), 1 + frame..1 + frame + inner, &mut state);
        between.iter().zip(colors_between).for_each(|(&at, color)| labels[at] = color);
        rest.iter().zip(others).for_each(|(&at, color)| labels[at] = color);
        let mut squares = BTreeSet::new();
        for cell in cells() {
            let sides = edges.sides(cell).map(|at| labels[at]);
            let mut turns = [sides; 4];
            (0..4).for_each(|turn| turns[turn].rotate_right(turn));
            turns.sort_unstable();
            if turns.windows(2).all(|pair| pair[0] != pair[1]) {
                squares.insert(turns[0]);
            }
        }
        if squares.len() == shape.cells() {
            let tile = |sides: &[u8; 4]| Kind::Wang.pack(sides, colors).unwrap();
            let tiles: Vec<TileId> = squares.iter().map(tile).collect();
            return (TileSet::squares(colors, tiles).unwrap(), tries);
        }
    }
    unreachable!()
}

#[test]
fn the_boards_are_made_like_this() {
    for &(side, frame, inner, seed) in BOARDS {
        let (set, tries) = board(side, frame, inner, seed);
        let name = format!("{side}x{side} squares in a frame");
        let source = format!(
            "tests/boards/puzzles.rs, seed {seed}, shuffle {tries}: {frame} colors in the frame, \
             {inner} others; --border 0"
        );
        let mut text = Vec::new();
        write_tile_set(&mut text, &set, Some(&name), Some(&source)).unwrap();
        let root = env!("CARGO_MANIFEST_DIR");
        let file = format!("{root}/data/frame-{side}x{side}.json");
        if std::env::var_os("WRITE_BOARDS").is_some() {
            fs::write(&file, &text).unwrap();
        }
        assert!(fs::read(&file).unwrap() == text, "{file}: made in another way");
        assert_eq!(read_squares(&Input::open(&file).unwrap(), None).unwrap().set, set);
    }
}
