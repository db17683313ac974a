//! Solutions of boards in files, searches in words, and what the verifier says to changes.

use crate::answers::{Puzzle, puzzles};
use crate::sprints::frame;
use proptest::prelude::*;
use serde_json::Value;
use tilepack::packing::{self, Job, Question, Settings, Task, standing};
use tilepack::search::Limits;
use tilepack::store::{
    Claim, Input, Layout, read_border, read_job, read_pins_on_board, read_solution, write_grid,
    write_job, write_solution,
};
use tilepack::torus::{Packing, Shape, Topology};
use tilepack::verify;

fn input(bytes: Vec<u8>) -> Input {
    Input::from_bytes("file", bytes).unwrap()
}

fn read(bytes: Vec<u8>) -> Result<Packing, String> {
    let read = read_solution(&input(bytes), &Claim::default());
    read.map(|solution| solution.packing).map_err(|error| error.to_string())
}

fn solution(task: &Task) -> Option<Packing> {
    let labels = packing::find(task, &Settings::PLAIN).unwrap().value?;
    Some(task.packing(&labels))
}

proptest! {
    #[test]
    fn files_and_jobs_round_trip(puzzle in puzzles()) {
        let Some(task) = puzzle.task() else { return Ok(()) };
        let text = write_job(&Job::new(task.clone(), Question::First));
        prop_assert_eq!(write_job(&read_job(&text).unwrap()), text);
        let Some(packing) = solution(&task) else { return Ok(()) };
        for layout in [Layout::Pretty, Layout::Line] {
            let mut json = Vec::new();
            write_solution(&mut json, &packing, &Value::Null, layout).unwrap();
            prop_assert_eq!(&read(json).unwrap(), &packing);
        }
        let mut grid = Vec::new();
        write_grid(&mut grid, &packing).unwrap();
        prop_assert_eq!(&read(grid.clone()).unwrap(), &packing);
        // The whole solution as pins leaves itself.
        let pins = read_pins_on_board(&input(grid), &task.set, task.shape, &task.board).unwrap();
        let task = Task { pins, ..task };
        let labels = packing::list(&task, &Settings::PLAIN, false).unwrap().value;
        prop_assert_eq!(labels.len(), 1);
        prop_assert_eq!(task.packing(&labels[0]), packing);
    }

    /// A square turned, two exchanged: refused, unless it is another solution.
    #[test]
    fn changes_are_told(seed in any::<u64>(), cell in 0..9usize, other in 0..9usize) {
        let puzzle = Puzzle {
            width: 3, height: 3, colors: 4, seed, topology: Topology::ALL[seed as usize % 3],
            rotations: true, border: 1, cut: true,
        };
        let task = puzzle.task().unwrap();
        let all = crate::naive::pictures(&task);
        let mut packing = solution(&task).unwrap();
        if cell == other {
            packing.turns[cell] = (packing.turns[cell] + 1) % 4;
        } else {
            packing.tiles.swap(cell, other);
        }
        let verdict = verify::check(&packing);
        let right = all.contains(&crate::naive::picture(&packing));
        prop_assert_eq!(verdict.is_valid(), right, "{}", verdict);
        if !right {
            prop_assert!(verdict.to_string().contains("side has color"), "{}", verdict);
            prop_assert!(verdict.to_string().starts_with("row "), "{}", verdict);
        }
        if packing.tiles[cell] != packing.tiles[other] {
            packing.tiles[cell] = packing.tiles[other];
            prop_assert!(!verify::check(&packing).is_valid());
        }
    }
}

#[test]
fn faults_are_named() {
    let text = |tiles: &str, rotations: &str, rest: &str| {
        format!(
            "{{\"format\":\"tilepack/1\",\"kind\":\"wang\",\"colors\":2,\"set\":{{\"tiles\":[1,1]}},\
             \"width\":2,\"height\":1,\"tiles\":[{tiles}]{rotations}{rest}}}"
        )
    };
    let rectangle = ",\"topology\":\"rectangle\"";
    let bordered = ",\"topology\":\"rectangle\",\"border\":0";
    let turns = |turns: &str| format!(",\"rotations\":[[{turns}]]");
    // Tile 1 is (0, 0, 0, 1).
    for (tiles, turns, rest, expected) in [
        ("[1,1]", "2,0", bordered, ""),
        (
            "[1,1]",
            "2,1",
            bordered,
            "row 0, column 0: east side has color 1, but the tile to the east",
        ),
        (
            "[1,1]",
            "0,2",
            bordered,
            "row 0, column 1: east side has color 1, but the border has color 0",
        ),
        ("[1,0]", "2,0", bordered, "tile 0"),
    ] {
        let verdict = verify::check(&read(text(tiles, &self::turns(turns), rest).into()).unwrap());
        assert_eq!(verdict.is_valid(), expected.is_empty(), "{verdict}");
        assert!(verdict.to_string().contains(expected), "{verdict}");
    }
    for (turns, rest, expected) in [
        (turns("4,0"), bordered, "a number of quarter turns from 0 to 3"),
        (turns("0"), bordered, "row 0 has 1 of 2 tiles"),
        (String::new(), rectangle, "listed twice"),
        (turns("0,0"), ",\"topology\":\"torus\",\"border\":0", "a torus has no border"),
        (turns("0,0"), ",\"topology\":\"disk\"", "\"torus\" or \"cylinder\" or \"rectangle\""),
        (
            turns("0,0"),
            ",\"topology\":\"cylinder\",\"border\":{\"east\":[0]}",
            "no border in the east",
        ),
        (
            turns("0,0"),
            ",\"topology\":\"rectangle\",\"border\":{\"north\":[0]}",
            "1 colors in the north",
        ),
        (turns("0,0"), ",\"topology\":\"rectangle\",\"border\":\"red\"", "expected a color"),
    ] {
        let error = read(text("[1,1]", &turns, rest).into()).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}

fn turns(turns: &str) -> String {
    format!(",\"rotations\":[[{turns}]]")
}

#[test]
fn borders_are_read() {
    let shape = Shape::new(3, 2).unwrap();
    let read = |text: &str| {
        read_border(&input(text.into()), Topology::Rectangle, shape).map_err(|e| e.to_string())
    };
    let border = read("# colors\nnorth 0 . 2\r\n\nwest 1 1 # all\neast . .\n").unwrap();
    assert_eq!(border.side(0), [Some(0), None, Some(2)]);
    assert_eq!(border.side(3), [Some(1), Some(1)]);
    assert!(border.side(1).is_empty() && border.side(2).is_empty());
    for (text, expected) in [
        ("north 0 0\n", "file:1:1: the border has 2 colors in the north, but the board has 3"),
        ("\nup 0\n", "file:2:1: 'up': expected a side"),
        ("east 0 x\n", "file:1:8: color 'x'"),
        ("east 0 255\n", "file:1:8: color '255'"),
        ("east\n", "file:1:1: east: expected its colors"),
        ("east 0 0\neast 0 0\n", "file:2:1: east: said before"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.starts_with(expected), "{error}");
    }
    let cylinder = read_border(&input("west 0 0\n".into()), Topology::Cylinder, shape);
    assert!(cylinder.unwrap_err().to_string().contains("a cylinder has no border in the west"));
}

/// Stopped again and again, with other numbers of threads, a search comes to the same.
#[test]
fn a_search_is_taken_up_again() {
    let job = Job::new(frame(6), Question::Count { up_to_symmetry: true });
    let mut from = None;
    for round in 0.. {
        let limits = Limits { nodes: 200_003, ..Limits::NONE };
        let settings = Settings { threads: 1 + round % 3, limits, ..Settings::PLAIN };
        let standing = standing::run(&job, from, &settings).unwrap();
        if standing.is_complete() {
            assert!(round > 7);
            assert_eq!((standing.state.nodes, standing.state.solutions), (1_788_857, 12));
            assert_eq!(standing.orbits, 3);
            return;
        }
        from = Some(standing);
    }
}
