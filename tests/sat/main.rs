//! A second opinion: a SAT solver answers the problems that the search answers, from the CNF that
//! is written for it. Where it says that there is no packing, its proof is checked ([`proof`]).
//!
//! Built with the feature `sat` only: `cargo test --features sat --test sat`.

#![allow(clippy::unwrap_used)]

mod proof;

use tilepack::export::{Cnf, Model};
use tilepack::packing::{Settings, Task, list};
use tilepack::symmetry::Automorphism;
use tilepack::tiles::{Color, Colors, Kind, Members, TileId, TileSet};
use tilepack::torus::{Cell, Shape};
use tilepack::verify;
use varisat::{ExtendFormula, Lit, ProofFormat, Solver};

/// All packings that the solver finds, as labels in order, with a proof that there are no more.
fn second_opinion(task: &Task) -> Vec<Vec<u8>> {
    let cnf = Cnf::new(task).unwrap();
    let mut formula = Vec::new();
    cnf.make(&mut |clause| formula.push(clause.to_vec()));
    let colors: i32 = cnf.instance().points.iter().map(|point| point.colors as i32).sum();
    let mut found = Vec::new();
    let mut solver = Solver::new();
    formula.iter().for_each(|clause| add(&mut solver, clause));
    while solver.solve().unwrap() {
        let model: Vec<isize> = solver.model().unwrap().iter().map(|l| l.to_dimacs()).collect();
        let words: Vec<String> = model.iter().map(isize::to_string).collect();
        let Model::Labels(labels) = Model::read(&words.join(" "), &cnf).unwrap() else {
            unreachable!("a model was given");
        };
        let packing = task.lattice().packing(&labels, &task.set, task.cover);
        assert!(verify::check(&packing).is_valid());
        found.push(labels);
        // Not the same colors again.
        let shown = model.iter().map(|&literal| literal as i32);
        let blocking: Vec<i32> =
            shown.filter(|l| (1..=colors).contains(l)).map(|literal| -literal).collect();
        add(&mut solver, &blocking);
        formula.push(blocking);
    }
    check_that_there_are_no_more(&formula);
    found.sort();
    found
}

fn add(solver: &mut Solver<'_>, clause: &[i32]) {
    let literals: Vec<Lit> = clause.iter().map(|&l| Lit::from_dimacs(l as isize)).collect();
    solver.add_clause(&literals);
}

/// The solver's proof that the formula cannot be satisfied. It writes none when clauses are added
/// later, so it begins again.
fn check_that_there_are_no_more(formula: &[Vec<i32>]) {
    let mut written = Vec::new();
    let mut solver = Solver::new();
    solver.write_proof(&mut written, ProofFormat::Drat);
    formula.iter().for_each(|clause| add(&mut solver, clause));
    assert!(!solver.solve().unwrap());
    solver.close_proof().unwrap();
    drop(solver);
    proof::check(formula, &String::from_utf8(written).unwrap()).unwrap();
}

fn task(kind: Kind, colors: u64, members: Members, size: &str) -> Task {
    let set = TileSet::new(kind, Colors::one(colors).unwrap(), members).unwrap();
    let shape: Shape = size.parse().unwrap();
    let mut task = Task::new(set, shape);
    task.cover = task.set.size() != shape.cells() as u64;
    task.check().unwrap();
    task
}

fn with(mut task: Task, automorphism: &str) -> Task {
    let colors = task.set.colors();
    task.automorphism = Some(Automorphism::parse(automorphism, colors, task.shape).unwrap());
    task.check().unwrap();
    task
}

fn pinned(mut task: Task, cell: u32, tile: u32) -> Task {
    let colors = task.set.kind().unpack(TileId(tile), task.set.colors());
    for (label, color) in task.lattice().sides(Cell(cell)).into_iter().zip(colors) {
        task.pins.pin(label, color).unwrap();
    }
    task
}

/// The same packings by both; how many.
fn agree(task: &Task) -> usize {
    let ours = list(task, &Settings::PLAIN, false).unwrap().value;
    assert_eq!(second_opinion(task), ours, "{task:?}");
    ours.len()
}

#[test]
fn small_problems() {
    use Kind::{Corner, Domino, Wang};
    use Members::{Compact, Complete};
    assert_eq!(agree(&task(Corner, 2, Complete, "4x4")), 32);
    assert_eq!(agree(&task(Domino, 1, Complete, "1x1")), 1);
    assert_eq!(agree(&task(Domino, 2, Complete, "4x1")), 4);
    assert_eq!(agree(&task(Domino, 3, Complete, "9x1")), 216);
    assert_eq!(agree(&task(Corner, 2, Compact, "4x4")), 32);
    assert_eq!(agree(&with(task(Corner, 2, Compact, "4x4"), "2,2:+1")), 32);
    let wang = task(Wang, 2, Complete, "4x4");
    for tiles in [[0, 15], [3, 9], [6, 9], [1, 4]] {
        let both = pinned(wang.clone(), 0, tiles[0]);
        agree(&pinned(both, 10, tiles[1]));
    }
    assert_eq!(agree(&with(pinned(wang, 0, 0), "2,0:+1")), 96);
}

#[test]
fn impossible_problems() {
    use Kind::{Corner, Domino};
    use Members::{Compact, Complete, Pruned};
    let pruned = || Pruned(vec![(Color(0), Color(1))]);
    assert_eq!(agree(&task(Corner, 2, Complete, "2x8")), 0);
    assert_eq!(agree(&task(Corner, 2, Complete, "1x16")), 0);
    assert_eq!(agree(&task(Corner, 2, Compact, "8x2")), 0);
    assert_eq!(agree(&with(task(Corner, 2, Compact, "4x4"), "2,0:+1")), 0);
    assert_eq!(agree(&with(task(Domino, 3, Complete, "9x1"), "3,0:+1")), 0);
    assert_eq!(agree(&task(Corner, 3, pruned(), "31x1")), 0);
}
