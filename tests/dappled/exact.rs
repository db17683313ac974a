//! Completions, cores and numbers against all fillings of small rectangles.

use crate::proof;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeSet;
use tilepack::dappled::exact::{
    Completion, Counted, Reason, complete, complete_with, counts, proof as prove,
};
use tilepack::dappled::{Condition, Direction, Edges, FREE, Field, Limit, Rule};

const EDGES: [Edges; 3] = [Edges::Free, Edges::Cylinder, Edges::Torus];

fn free((width, height): (usize, usize)) -> Field {
    Field::filled(width, height, FREE).unwrap()
}

fn uniform(size: (usize, usize), tiles: usize, edges: Edges, p: u32, q: u32) -> Rule {
    Rule::uniform(size, tiles, edges, Some(p), Some(q)).unwrap()
}

/// The same limit for each of these sets, in both directions.
fn subsets(size: (usize, usize), tiles: usize, edges: Edges, sets: &[u64], p: u32) -> Rule {
    let directions = [Direction::Horizontal, Direction::Vertical];
    let condition = |set| directions.map(|direction| (set, direction));
    let conditions = sets.iter().flat_map(|&set| condition(set));
    let conditions = conditions
        .map(|(set, direction)| Condition { set, direction, limit: Limit::Same(p) })
        .collect();
    Rule::new(size, tiles, edges, conditions).unwrap()
}

/// All dappled tilings, by trying all fillings.
fn all(rule: &Rule) -> Vec<Field> {
    let mut field = Field::filled(rule.width(), rule.height(), 0).unwrap();
    let mut found = Vec::new();
    loop {
        if rule.accepts(&field) {
            found.push(field.clone());
        }
        let last = rule.tiles() as u8 - 1;
        let Some(at) = field.cells().iter().position(|&tile| tile < last) else {
            return found;
        };
        field.cells_mut()[..at].fill(0);
        field.cells_mut()[at] += 1;
    }
}

fn random_partial(rule: &Rule, random: &mut Pcg64) -> Field {
    let density = random.random_range(0.0..0.9);
    let mut field = free((rule.width(), rule.height()));
    for tile in field.cells_mut() {
        if random.random_bool(density) {
            *tile = random.random_range(0..rule.tiles() as u8);
        }
    }
    field
}

/// A part of a field.
fn only(field: &Field, cells: &[u32]) -> Field {
    let mut part = free((field.width(), field.height()));
    for &cell in cells {
        part.cells_mut()[cell as usize] = field.cells()[cell as usize];
    }
    part
}

/// A core has no completion, and has one without any one of its cells.
fn check_core(field: &Field, core: &[u32], completions: impl Fn(&Field) -> bool) {
    assert!(core.iter().all(|&cell| field.cells()[cell as usize] != FREE));
    assert!(!completions(&only(field, core)));
    for &cell in core {
        let rest: Vec<u32> = core.iter().copied().filter(|&other| other != cell).collect();
        assert!(completions(&only(field, &rest)), "{field:?} {core:?}");
    }
}

/// Rules for small rectangles: all edges, limits 1 to 3, two and three tiles, sets, and maps.
fn rules(random: &mut Pcg64) -> Vec<Rule> {
    let mut rules = Vec::new();
    for edges in EDGES {
        for (p, q) in [(1, 1), (1, 2), (2, 2), (2, 3), (3, 3)] {
            rules.extend([(3, 3), (4, 3), (5, 2), (1, 6)].map(|s| uniform(s, 2, edges, p, q)));
            rules.push(uniform((3, 2), 3, edges, p, q));
        }
        rules.push(subsets((3, 2), 3, edges, &[3, 6, 5], 2));
        rules.push(subsets((3, 2), 4, edges, &[3, 6, 12], 1));
        rules.push(subsets((3, 2), 3, edges, &[1, 7], 2));
        rules.push(uniform((3, 1), 1, edges, 2, 1));
        let map: Vec<u32> =
            (0..12).map(|_| [1, 2, 3, u32::MAX][random.random_range(0..4)]).collect();
        let limit = Limit::Map(map);
        let conditions = [1, 2].map(|set| Condition {
            set,
            direction: Direction::Horizontal,
            limit: limit.clone(),
        });
        rules.push(Rule::new((6, 2), 2, edges, conditions.to_vec()).unwrap());
    }
    rules
}

#[test]
fn completions_and_cores_are_those_of_all_fillings() {
    let mut random = Pcg64::seed_from_u64(1);
    let mut verdicts = [0, 0];
    for rule in rules(&mut random) {
        let all = all(&rule);
        let possible = |partial: &Field| all.iter().any(|tiling| partial.agrees_with(tiling));
        for seed in 0..12 {
            let partial = random_partial(&rule, &mut random);
            match complete(&rule, &partial, seed, &()).unwrap() {
                Completion::Found(tiling) => {
                    assert!(all.contains(&tiling) && partial.agrees_with(&tiling));
                    verdicts[0] += 1;
                }
                Completion::Impossible { core, minimal } => {
                    assert!(minimal && !possible(&partial));
                    check_core(&partial, &core, possible);
                    verdicts[1] += 1;
                }
                Completion::Stopped => unreachable!("nobody asked to stop"),
            }
        }
    }
    assert!(verdicts.iter().all(|&n| n > 200), "{verdicts:?}");
}

#[test]
fn numbers_of_a_tile_are_those_of_all_fillings() {
    let mut random = Pcg64::seed_from_u64(2);
    for rule in rules(&mut random) {
        let all = all(&rule);
        let number = |tiling: &Field, tile| tiling.cells().iter().filter(|&&t| t == tile).count();
        for round in 0..3 {
            let tile = random.random_range(0..rule.tiles() as u8);
            let partial = match round {
                0 => free((rule.width(), rule.height())),
                _ => random_partial(&rule, &mut random),
            };
            let completions: Vec<_> = all.iter().filter(|t| partial.agrees_with(t)).collect();
            let known: BTreeSet<usize> = completions.iter().map(|t| number(t, tile)).collect();
            let counted = counts(&rule, &partial, tile, 3, &()).unwrap();
            for (n, &verdict) in counted.possible.iter().enumerate() {
                assert_eq!(verdict, Some(known.contains(&n)), "{n} {rule:?} {partial:?}");
            }
            if let (Some(&first), Some(&last)) = (known.first(), known.last()) {
                assert_eq!((counted.least.0, counted.most.0), (first as u32, last as u32));
            }
            let wanted = random.random_range(0..=partial.cells().len());
            match complete_with(&rule, &partial, (tile, wanted as u32), 5, &()).unwrap() {
                Counted::Found(tiling) => {
                    assert!(completions.contains(&&tiling) && number(&tiling, tile) == wanted);
                }
                Counted::Impossible { reason, bound, core, minimal } => {
                    assert!(minimal && !known.contains(&wanted));
                    match reason {
                        Reason::Search => check_core(&partial, &core, |part| {
                            let wanted = |t: &&Field| number(t, tile) == wanted;
                            all.iter().filter(wanted).any(|tiling| part.agrees_with(tiling))
                        }),
                        _ => assert!(!(bound.0 as usize..=bound.1 as usize).contains(&wanted)),
                    }
                }
                Counted::Hopeless { core, minimal } => {
                    assert!(minimal && known.is_empty());
                    let possible = |part: &Field| all.iter().any(|t| part.agrees_with(t));
                    check_core(&partial, &core, possible);
                }
                Counted::Stopped => unreachable!("nobody asked to stop"),
            }
        }
    }
}

/// Four cells that conclusions from single windows do not refute.
fn four_cells() -> Field {
    let mut field = free((5, 5));
    for (column, row, tile) in [(3, 0, 0), (0, 1, 0), (2, 1, 1), (3, 3, 1)] {
        field.set(column, row, tile);
    }
    field
}

/// All cyclic tilings of 5x5 with limits 2, row by row.
fn five_by_five() -> Vec<Field> {
    let cyclic = |a: u32, b: u32, c: u32| a & b & c == 0 && a | b | c == 31;
    let turned = |row: u32, by: u32| (row << by | row >> (5 - by)) & 31;
    let rows: Vec<u32> = (0..32).filter(|&r| cyclic(r, turned(r, 1), turned(r, 2))).collect();
    assert_eq!(rows.len(), 10);
    let mut found = Vec::new();
    for number in 0..100_000 {
        let row = |at: u32| rows[number / 10usize.pow(at % 5) % 10];
        if (0..5).all(|at| cyclic(row(at), row(at + 1), row(at + 2))) {
            let cells = (0..25).map(|cell| (row(cell / 5) >> (cell % 5) & 1) as u8).collect();
            found.push(Field::new(5, 5, cells).unwrap());
        }
    }
    found
}

#[test]
fn four_cells_without_a_cyclic_completion() {
    let all = five_by_five();
    assert_eq!(all.len(), 2470);
    let (rule, field) = (uniform((5, 5), 2, Edges::Torus, 2, 2), four_cells());
    let core = vec![3, 5, 7, 18];
    let expected = Completion::Impossible { core: core.clone(), minimal: true };
    assert_eq!(complete(&rule, &field, 0, &()).unwrap(), expected);
    let without = |cell: u32| {
        let rest: Vec<u32> = core.iter().copied().filter(|&other| other != cell).collect();
        all.iter().filter(|tiling| only(&field, &rest).agrees_with(tiling)).count()
    };
    assert_eq!(core.iter().map(|&cell| without(cell)).collect::<Vec<_>>(), [182, 68, 182, 68]);
    let free_edges = uniform((5, 5), 2, Edges::Free, 2, 2);
    assert!(matches!(complete(&free_edges, &field, 0, &()), Ok(Completion::Found(_))));
}

/// Clauses of numbers that end with 0; lines that begin with a letter are passed over.
fn read_clauses(text: &str) -> Vec<Vec<i32>> {
    let lines = text.lines().filter(|line| !line.starts_with(['c', 'p']));
    lines
        .map(|line| {
            let mut clause: Vec<i32> =
                line.split_whitespace().map(|word| word.parse().unwrap()).collect();
            assert_eq!(clause.pop(), Some(0));
            clause
        })
        .collect()
}

#[test]
fn proofs_are_proofs() {
    let pairs = [3, 5, 6];
    for (rule, field) in [
        (uniform((5, 5), 2, Edges::Torus, 2, 2), four_cells()),
        (subsets((8, 8), 3, Edges::Torus, &pairs, 2), free((8, 8))),
        (uniform((1, 4), 2, Edges::Torus, 2, 2), free((1, 4))),
    ] {
        let found = prove(&rule, &field, &()).unwrap().unwrap();
        let (mut formula, mut steps) = (Vec::new(), Vec::new());
        found.write_formula(&mut formula).unwrap();
        found.write_steps(&mut steps).unwrap();
        let formula = String::from_utf8(formula).unwrap();
        let clauses = read_clauses(&formula);
        assert!(formula.contains(&format!(" {}\n", clauses.len())));
        proof::check(&clauses, &String::from_utf8(steps).unwrap()).unwrap();
    }
    let rule = uniform((5, 5), 2, Edges::Free, 2, 2);
    assert!(prove(&rule, &four_cells(), &()).unwrap().is_none());
}

#[test]
fn large_tilings() {
    let rule = uniform((128, 128), 2, Edges::Torus, 2, 2);
    let Ok(Completion::Found(one)) = complete(&rule, &free((128, 128)), 1, &()) else {
        unreachable!("there are many");
    };
    let Ok(Completion::Found(other)) = complete(&rule, &free((128, 128)), 2, &()) else {
        unreachable!("there are many");
    };
    assert_ne!(one, other);
    let stopped = std::sync::atomic::AtomicBool::new(true);
    let answer = complete(&rule, &free((128, 128)), 1, &stopped).unwrap();
    assert_eq!(answer, Completion::Stopped);
}

#[test]
fn sets_of_tiles() {
    let size = (32, 32);
    let found = |rule: &Rule| match complete(rule, &free((rule.width(), rule.height())), 0, &()) {
        Ok(Completion::Found(_)) => true,
        Ok(Completion::Impossible { core, .. }) => {
            assert!(core.is_empty());
            false
        }
        other => unreachable!("{other:?}"),
    };
    // Of three tiles, all in every three cells: everything repeats with period 3.
    assert!(found(&subsets(size, 3, Edges::Free, &[3, 5, 6], 2)));
    assert!(!found(&subsets(size, 3, Edges::Torus, &[3, 5, 6], 2)));
    assert!(found(&subsets((33, 33), 3, Edges::Torus, &[3, 5, 6], 2)));
    for edges in [Edges::Free, Edges::Torus] {
        for p in [2, 3] {
            assert!(found(&subsets(size, 4, edges, &[3, 6, 12], p)));
            assert!(found(&subsets(size, 5, edges, &[3, 6, 12, 24], p)));
        }
        assert!(found(&subsets((16, 16), 4, edges, &[3, 5, 9, 6, 10, 12], 2)));
    }
}

#[test]
fn prescribed_numbers() {
    let number = |size: usize, wanted| {
        let rule = uniform((size, size), 2, Edges::Free, 2, 2);
        match complete_with(&rule, &free((size, size)), (1, wanted), 0, &()).unwrap() {
            Counted::Found(_) => true,
            Counted::Impossible { .. } => false,
            other => unreachable!("{other:?}"),
        }
    };
    assert!((0..=20).chain(44..=64).all(|wanted| !number(8, wanted)));
    assert!((21..=43).all(|wanted| number(8, wanted)));
    assert!([85, 86, 90, 128, 171].iter().all(|&wanted| number(16, wanted)));
    assert!([84, 172].iter().all(|&wanted| !number(16, wanted)));
    // As many in each row of a torus.
    let rule = uniform((10, 10), 2, Edges::Torus, 2, 2);
    let counted = counts(&rule, &free((10, 10)), 0, 0, &()).unwrap();
    assert_eq!((counted.least, counted.most), ((40, Reason::Rows), (60, Reason::Rows)));
    assert!(counted.possible[40..=60].iter().all(|&verdict| verdict == Some(true)));
}

#[test]
fn what_cannot_be_asked() {
    let rule = uniform((4, 4), 2, Edges::Free, 2, 2);
    let strange = Field::filled(4, 4, 7).unwrap();
    for field in [free((4, 5)), strange] {
        assert!(complete(&rule, &field, 0, &()).is_err());
        assert!(prove(&rule, &field, &()).is_err());
    }
    assert!(counts(&rule, &free((4, 4)), 2, 0, &()).is_err());
    let large = uniform((4096, 4096), 2, Edges::Free, 2, 2);
    assert!(complete(&large, &free((4096, 4096)), 0, &()).is_err());
}
