//! The nearest dappled tiling against all fillings, against a search row by row, and against
//! numbers that are known.

use crate::program::run;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use serde_json::Value;
use std::collections::HashMap;
use std::time::Instant;
use tempfile::TempDir;
use tilepack::dappled::closest::{Answer, Task, closest};
use tilepack::dappled::{Condition, Direction, Edges, FREE, Field, Limit, Rule};

fn random_field(size: (usize, usize), tiles: u8, seed: u64) -> Field {
    let mut random = Pcg64::seed_from_u64(seed);
    let cells = (0..size.0 * size.1).map(|_| random.random_range(0..tiles));
    Field::new(size.0, size.1, cells.collect()).unwrap()
}

fn two_two(size: (usize, usize), edges: Edges) -> Rule {
    Rule::uniform(size, 2, edges, Some(2), Some(2)).unwrap()
}

/// Solves, and checks what can be checked.
fn solve(task: &Task<'_>) -> Answer {
    let answer = closest(task, 1, &()).unwrap();
    if let Some(tiling) = &answer.tiling {
        assert!(task.rule.accepts(tiling));
        assert!(task.fixed.is_none_or(|fixed| fixed.agrees_with(tiling)));
        assert_eq!(answer.distance, Some(distance(task, tiling.cells())));
    }
    assert!(answer.is_proved(), "{answer:?}");
    answer
}

fn plain(rule: &Rule, field: &Field) -> Option<u64> {
    solve(&Task { rule, field, fixed: None, weights: None }).distance
}

fn distance(task: &Task<'_>, cells: &[u8]) -> u64 {
    let pairs = cells.iter().zip(task.field.cells()).enumerate();
    let differ = pairs.filter(|&(_, (a, b))| *b != FREE && a != b);
    differ.map(|(cell, _)| task.weights.map_or(1, |weights| u64::from(weights[cell]))).sum()
}

/// The least distance of all fillings.
fn brute(task: &Task<'_>) -> Option<u64> {
    let (rule, mut best) = (task.rule, None);
    let size = (rule.width(), rule.height());
    let mut field = Field::filled(size.0, size.1, 0).unwrap();
    loop {
        let found = distance(task, field.cells());
        if best.is_none_or(|best| found < best)
            && task.fixed.is_none_or(|fixed| fixed.agrees_with(&field))
            && rule.accepts(&field)
        {
            best = Some(found);
        }
        let cells = field.cells_mut();
        let Some(at) = cells.iter().position(|&tile| usize::from(tile) + 1 < rule.tiles()) else {
            return best;
        };
        cells[at] += 1;
        cells[..at].fill(0);
    }
}

fn random_limit(size: usize, random: &mut Pcg64) -> Limit {
    match random.random_range(0..6) {
        0 => Limit::None,
        1 => {
            let cell = |random: &mut Pcg64| match random.random_range(0..5) {
                0 => u32::MAX,
                limit => limit,
            };
            Limit::Map((0..size).map(|_| cell(random)).collect())
        }
        _ => Limit::Same(random.random_range(1..4)),
    }
}

#[test]
fn it_is_the_least_of_all_fillings() {
    let mut random = Pcg64::seed_from_u64(7);
    let (mut none, mut with) = (0, 0);
    for _ in 0..120 {
        let tiles = if random.random_range(0..3) == 0 { 3 } else { 2 };
        let size = loop {
            let size = (random.random_range(1..6_usize), random.random_range(1..6_usize));
            if size.0 * size.1 <= if tiles == 3 { 7 } else { 12 } {
                break size;
            }
        };
        let cells = size.0 * size.1;
        let edges = [Edges::Free, Edges::Cylinder, Edges::Torus][random.random_range(0..3)];
        let mut conditions = Vec::new();
        for direction in [Direction::Horizontal, Direction::Vertical] {
            for tile in 0..tiles {
                let limit = random_limit(cells, &mut random);
                conditions.push(Condition { set: 1 << tile, direction, limit });
            }
            if random.random_range(0..3) == 0 {
                let limit = random_limit(cells, &mut random);
                conditions.push(Condition { set: 3, direction, limit });
            }
        }
        let rule = Rule::new(size, tiles, edges, conditions).unwrap();
        let mut tile_or_free = |free: u32| match random.random_range(0..10) < free {
            true => FREE,
            false => random.random_range(0..tiles as u8),
        };
        let field: Vec<u8> = (0..cells).map(|_| tile_or_free(1)).collect();
        let fixed: Vec<u8> = (0..cells).map(|_| tile_or_free(8)).collect();
        let field = Field::new(size.0, size.1, field).unwrap();
        let fixed = Field::new(size.0, size.1, fixed).unwrap();
        let weights: Vec<u32> = (0..cells).map(|_| random.random_range(0..6)).collect();
        let task = Task {
            rule: &rule,
            field: &field,
            fixed: Some(&fixed).filter(|_| random.random_range(0..2) == 0),
            weights: Some(&weights[..]).filter(|_| random.random_range(0..2) == 0),
        };
        let expected = brute(&task);
        assert_eq!(solve(&task).distance, expected, "{task:?}");
        *if expected.is_none() { &mut none } else { &mut with } += 1;
    }
    assert!(none > 5 && with > 50, "{none} {with}");
}

/// The least distance of 2,2-dappled tilings with free edges, row by row: the last two rows are
/// all that counts.
fn by_rows(field: &Field, weights: &[u32]) -> u64 {
    let width = field.width();
    let full = (1_u32 << width) - 1;
    let three = |row: u32| row & row >> 1 & row >> 2;
    let rows: Vec<u32> =
        (0..=full).filter(|&row| three(row) == 0 && three(!row & full) == 0).collect();
    let mut best: HashMap<(u32, u32), u64> = HashMap::new();
    for (number, (wish, weights)) in field.rows().zip(weights.chunks(width)).enumerate() {
        let cost = |row: u32| -> u64 {
            let cells = wish.iter().zip(weights).enumerate();
            cells
                .filter(|(at, (tile, _))| row >> at & 1 != u32::from(**tile))
                .map(|(_, (_, &weight))| u64::from(weight))
                .sum()
        };
        let costs: HashMap<u32, u64> = rows.iter().map(|&row| (row, cost(row))).collect();
        let mut next = HashMap::new();
        for &row in &rows {
            if number == 0 {
                next.insert((!row & full, row), costs[&row]);
            }
            for (&(a, b), &before) in &best {
                if a & b & row == 0 && (a | b | row) == full {
                    let least = next.entry((b, row)).or_insert(u64::MAX);
                    *least = (*least).min(before + costs[&row]);
                }
            }
        }
        best = next;
    }
    best.into_values().min().unwrap()
}

#[test]
fn it_is_the_least_row_by_row() {
    for (width, height, seed, most) in [(6, 14, 1, 1), (6, 9, 2, 9), (5, 24, 3, 1), (7, 8, 4, 3)] {
        let field = random_field((width, height), 2, seed);
        let mut random = Pcg64::seed_from_u64(seed);
        let weights: Vec<u32> =
            (0..width * height).map(|_| random.random_range(1..=most)).collect();
        let rule = two_two((width, height), Edges::Free);
        let task = Task { rule: &rule, field: &field, fixed: None, weights: Some(&weights) };
        assert_eq!(solve(&task).distance, Some(by_rows(&field, &weights)), "{width}x{height}");
    }
}

#[test]
fn a_third_of_a_field_of_ones_is_changed() {
    for side in [8, 10, 12, 14, 16] {
        let field = Field::filled(side, side, 1).unwrap();
        let found = plain(&two_two((side, side), Edges::Free), &field);
        assert_eq!(found, Some((side * side / 3) as u64), "{side}");
    }
}

/// Strips along rows and strips along columns prove the same.
#[test]
fn transposed_fields_are_as_far() {
    let cases = [(16, Edges::Free, 2, 49), (16, Edges::Torus, 2, 51), (24, Edges::Free, 3, 112)];
    for (side, edges, seed, expected) in cases {
        let field = random_field((side, side), 2, seed);
        let mut turned = field.clone();
        for cell in 0..side * side {
            turned.set(cell / side, cell % side, field.at(cell % side, cell / side));
        }
        let rule = two_two((side, side), edges);
        assert_eq!(plain(&rule, &field), Some(expected));
        assert_eq!(plain(&rule, &turned), Some(expected));
    }
}

#[test]
fn what_is_dappled_stays() {
    let rule = two_two((12, 9), Edges::Torus);
    let first = solve(&Task {
        rule: &rule,
        field: &random_field((12, 9), 2, 5),
        fixed: None,
        weights: None,
    });
    let tiling = first.tiling.unwrap();
    let again = solve(&Task { rule: &rule, field: &tiling, fixed: None, weights: None });
    assert_eq!((again.distance, again.tiling), (Some(0), Some(tiling)));
}

#[test]
fn threads_do_not_matter_and_time_ends_it() {
    let field = random_field((24, 20), 2, 9);
    let rule = two_two((24, 20), Edges::Cylinder);
    let task = Task { rule: &rule, field: &field, fixed: None, weights: None };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| closest(&task, 3, &()).unwrap())
    };
    assert_eq!(with(1), with(3));
    let stopped = closest(&task, 3, &Instant::now()).unwrap();
    assert!(!stopped.is_proved());
    assert_eq!(stopped.bound, Some(0));
}

#[test]
fn fixed_cells_that_have_no_completion_are_told() {
    let rule = two_two((5, 4), Edges::Free);
    let field = Field::filled(5, 4, 1).unwrap();
    let mut fixed = Field::filled(5, 4, FREE).unwrap();
    (0..3).for_each(|column| fixed.set(column, 1, 0));
    fixed.set(4, 3, 1);
    let found = solve(&Task { rule: &rule, field: &field, fixed: Some(&fixed), weights: None });
    assert_eq!((found.distance, found.bound, found.core), (None, None, Some(vec![5, 6, 7])));
    let free = solve(&Task { rule: &rule, field: &field, fixed: None, weights: None });
    assert_eq!(free.distance, Some(6));
}

#[test]
fn tasks_that_make_no_sense_are_refused() {
    let rule = two_two((3, 2), Edges::Free);
    let field = Field::filled(3, 2, 1).unwrap();
    let wrong = Field::filled(2, 3, 1).unwrap();
    let strange = Field::filled(3, 2, 2).unwrap();
    let task = Task { rule: &rule, field: &field, fixed: None, weights: None };
    let refused = |task: Task<'_>| closest(&task, 0, &()).unwrap_err().to_string();
    assert_eq!(refused(Task { field: &wrong, ..task }), "the field: 2x3 cells, expected 3x2");
    let fixed = refused(Task { fixed: Some(&strange), ..task });
    assert_eq!(fixed, "the fixed cells: tile 2, expected one below 2");
    assert!(refused(Task { weights: Some(&[1; 5]), ..task }).starts_with("the weights: 5"));
    assert!(refused(Task { weights: Some(&[2_000_000; 6]), ..task }).contains("or less"));
}

#[test]
fn the_command() {
    let place = TempDir::new().unwrap();
    let write = |name: &str, text: &str| std::fs::write(place.path().join(name), text).unwrap();
    write("ones.txt", "11111\n11111\n11111\n11111\n");
    write("kept.txt", ".....\n.11..\n.....\n.....\n");
    write("torn.txt", "000..\n.....\n.....\n....1\n");
    write("heavy.txt", "1 1 9 1 1\n1 1 1 1 1\n1 1 1 1 1\n9 1 1 1 1\n");
    write("light.txt", "1 1\n1 x\n");

    let (code, out, remarks) = run(&place, "dapple closest ones.txt");
    assert_eq!((code, out.lines().count()), (0, 4));
    let proved = "distance 6 of 20 cells, lower bound 6: optimal (proved); ";
    assert!(remarks.contains(proved), "{remarks}");
    write("near.txt", &out);
    assert_eq!(run(&place, "dapple check near.txt").0, 0);
    let (code, again, _) = run(&place, "dapple closest near.txt --quiet");
    assert_eq!((code, again), (0, out));

    let args = "dapple closest ones.txt --fixed kept.txt --weights heavy.txt --json -o near.png";
    let (code, out, remarks) = run(&place, args);
    assert_eq!((code, remarks.as_str()), (0, ""));
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["result"], "optimal");
    assert_eq!((&object["distance"], &object["changed"]), (&object["bound"], &object["distance"]));
    assert_eq!((object["file"].as_str(), object["tiles"].is_null()), (Some("near.png"), true));
    assert_eq!(run(&place, "dapple check near.png").0, 0);

    let (code, out, _) = run(&place, "dapple closest ones.txt --fixed torn.txt -o no.txt");
    assert_eq!(code, 1);
    let blamed = "# impossible: these fixed cells have no completion\n000..\n.....\n.....\n.....\n";
    assert_eq!(out, blamed);
    assert!(!place.path().join("no.txt").exists());
    let (code, out, _) = run(&place, "dapple closest ones.txt --limits 1,1 --cyclic --json");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (1, Some("impossible")));

    let (code, _, remarks) = run(&place, "dapple closest ones.txt --time-limit 0");
    assert_eq!(code, 75);
    assert!(remarks.contains("stopped early by the time limit"), "{remarks}");
    for (args, expected) in [
        ("closest none.txt", "none.txt"),
        ("closest ones.txt --weights light.txt", "light.txt:2:3: 'x': expected a weight"),
        ("closest ones.txt --fixed light.txt", "light.txt:2:3: 'x': expected a tile"),
        ("closest kept.txt --fixed near.txt --limits 0,1", "a limit of 0"),
    ] {
        let (code, out, remarks) = run(&place, &format!("dapple {args}"));
        assert_eq!((code, out.as_str()), (2, ""), "{args}");
        assert!(remarks.contains(expected), "{args}: {remarks}");
    }
}
