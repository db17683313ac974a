//! Problems written for other solvers: golden files, and as many models and exact covers as there
//! are packings, by solvers of a few lines that know nothing of tiles.

#![allow(clippy::unwrap_used, clippy::panic)]

mod cover;
mod golden;
mod models;

use cover::covers;
use models::models;
use tilepack::export::{Cnf, Xcc};
use tilepack::packing::{Settings, Task, count};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::Shape;

/// A task in words: kind, colors, members, size and more.
fn task(kind: Kind, colors: &str, members: Members, size: &str, automorphism: &str) -> Task {
    let colors: Colors = colors.parse().unwrap();
    let set = TileSet::new(kind, colors, members).unwrap();
    let shape: Shape = size.parse().unwrap();
    let mut task = Task::new(set, shape);
    task.cover = task.set.size() != shape.cells() as u64;
    if !automorphism.is_empty() {
        let colors = task.set.colors();
        task.automorphism = Some(Automorphism::parse(automorphism, colors, shape).unwrap());
    }
    task.check().unwrap();
    task
}

/// The task with a tile pinned at the origin.
fn pinned(mut task: Task, tile: u32) -> Task {
    let lattice = task.lattice();
    let colors = task.set.kind().unpack(TileId(tile), task.set.colors());
    for (label, color) in lattice.sides(tilepack::torus::Cell(0)).into_iter().zip(colors) {
        task.pins.pin(label, color).unwrap();
    }
    task
}

fn cnf_text(task: &Task) -> String {
    let mut text = Vec::new();
    Cnf::new(task).unwrap().write(&mut text, "test").unwrap();
    String::from_utf8(text).unwrap()
}

fn xcc_text(task: &Task) -> Option<String> {
    let mut text = Vec::new();
    Xcc::new(task).ok()?.write(&mut text, "test").unwrap();
    Some(String::from_utf8(text).unwrap())
}

/// Counts in all ways; `None` where exact cover cannot say it.
fn agree(task: &Task) -> u64 {
    let answer = count(task, &Settings::PLAIN, false).unwrap().value.packings;
    let answer: u64 = answer.to_string().parse().unwrap();
    assert_eq!(models(&cnf_text(task)), answer, "models: {task:?}");
    match xcc_text(task) {
        Some(text) => assert_eq!(covers(&text), answer, "covers: {task:?}"),
        None => assert!(task.cover && task.set.is_compact(), "{task:?}"),
    }
    answer
}

#[test]
fn known_numbers() {
    use Kind::{Corner, Domino, Wang};
    use Members::{Compact, Complete};
    for (kind, colors, members, size, automorphism, packings) in [
        (Corner, "2", Complete, "4x4", "", 32),
        (Corner, "2", Complete, "2x8", "", 0),
        (Corner, "2", Complete, "16x1", "", 0),
        (Corner, "1", Complete, "1x1", "", 1),
        (Domino, "1", Complete, "1x1", "", 1),
        (Domino, "2", Complete, "4x1", "", 4),
        (Domino, "3", Complete, "9x1", "", 24 * 9),
        (Domino, "3", Complete, "1x9", "", 24 * 9),
        (Corner, "2", Compact, "1x16", "", 0),
    ] {
        assert_eq!(agree(&task(kind, colors, members, size, automorphism)), packings);
    }
    assert_eq!(agree(&pinned(task(Wang, "2", Complete, "4x4", ""), 0)), 12_720);
}

#[test]
fn all_sorts_of_problems() {
    use Kind::{Corner, Domino, Wang};
    use Members::{Compact, Complete, Explicit};
    let tiles = |tiles: &[u32]| Explicit(tiles.iter().copied().map(TileId).collect());
    for (kind, colors, members, size, automorphism) in [
        (Corner, "2", Compact, "4x4", ""),
        (Corner, "2", Compact, "8x2", ""),
        (Corner, "2", Compact, "4x4", "2,0:+1"),
        (Corner, "2", Compact, "4x4", "2,2:+1"),
        (Corner, "2", Compact, "4x4", "2,0:+0"),
        (Wang, "2", Compact, "4x2", ""),
        (Wang, "2", Compact, "4x2", "2,1:+1"),
        (Wang, "2", Compact, "3x3", ""),
        (Wang, "1,2", Complete, "4x1", ""),
        (Wang, "2,1", Complete, "2x2", ""),
        (Wang, "2,1", Complete, "3x2", ""),
        (Wang, "2", Complete, "4x4", "2,0:+1"),
        (Wang, "2", Complete, "4x4", "0,2:1,0/0,1"),
        (Domino, "3", Complete, "9x1", "3,0:+1"),
        (Domino, "2", Complete, "6x1", ""),
        (Domino, "2", Complete, "6x1", "3,0:+1"),
        (Corner, "2", tiles(&[0, 15]), "1x2", ""),
        (Corner, "2", tiles(&[0, 3, 12, 15]), "4x1", ""),
        (Corner, "2", tiles(&[0, 3, 12, 15]), "3x2", ""),
        (Wang, "2", tiles(&[0, 5, 10, 15]), "3x2", ""),
    ] {
        agree(&task(kind, colors, members, size, automorphism));
    }
}

#[test]
fn every_model_is_a_packing_and_every_packing_a_model() {
    use tilepack::export::Model;
    let task = task(Kind::Corner, "2", Members::Complete, "4x4", "");
    let cnf = Cnf::new(&task).unwrap();
    let mut found: Vec<Vec<u8>> = Vec::new();
    models::each(&cnf_text(&task), &mut |model| {
        let words: Vec<String> = model.iter().map(i32::to_string).collect();
        let text = format!("c remark\ns SATISFIABLE\nv {} 0\n", words.join(" "));
        let Model::Labels(labels) = Model::read(&text, &cnf).unwrap() else { panic!("{text}") };
        found.push(labels);
    });
    found.sort();
    let listed = tilepack::packing::list(&task, &Settings::PLAIN, false).unwrap().value;
    assert_eq!(found, listed);
}

#[test]
fn the_first_models_under_an_automorphism_are_packings() {
    use tilepack::export::Model;
    let task = task(Kind::Corner, "3", Members::Complete, "9x9", "3,0:+1");
    let cnf = Cnf::new(&task).unwrap();
    let model = models::first(&cnf_text(&task), 2_000_000);
    let Some(model) = model else { panic!("none found") };
    let words: Vec<String> = model.iter().map(i32::to_string).collect();
    let Model::Labels(labels) = Model::read(&words.join(" "), &cnf).unwrap() else { panic!() };
    let packing = task.lattice().packing(&labels, &task.set, false);
    assert!(tilepack::verify::check(&packing).is_valid());
}

#[test]
fn sizes_are_those_announced() {
    let task = task(Kind::Corner, "3", Members::Complete, "9x9", "");
    let cnf = Cnf::new(&task).unwrap();
    let text = cnf_text(&task);
    let clauses = text.lines().filter(|line| !line.starts_with(['c', 'p'])).count();
    assert!(text.contains(&format!("\np cnf {} {}\n", cnf.variables, cnf.clauses)));
    assert_eq!(clauses as u64, cnf.clauses);
    let xcc = Xcc::new(&task).unwrap();
    let text = xcc_text(&task).unwrap();
    assert_eq!(text.lines().count() as u64, xcc.options + 3);
    assert_eq!((xcc.primary(), xcc.secondary(), xcc.options), (162, 81, 81 * 81));
}
