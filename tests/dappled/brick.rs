//! Brick walls: against trying all positions, and figures that are known.

use crate::random::Random;
use num_bigint::BigUint;
use std::collections::BTreeMap;
use tilepack::dappled::brick::{FREE, Side, Wall, boundary, labels, region, tiles, weight};
use tilepack::dappled::make::{Made, Options, Order, make, start};
use tilepack::dappled::{Edges, FREE as NO_TILE, Field};

/// Calls `found` for every wall that agrees with a partial one, tile by tile.
fn walls(partial: &mut Wall, cell: usize, found: &mut dyn FnMut(&Wall)) {
    let (width, height) = (partial.width(), partial.height());
    let (column, row) = (cell % width, cell / width);
    if row == height {
        return found(partial);
    }
    if !partial.holds(column, row) {
        return walls(partial, cell + 1, found);
    }
    let known = partial.tile(column, row);
    for tile in tiles(partial.positions()) {
        if known.iter().zip(tile).all(|(&known, side)| known == FREE || known == side) {
            for (side, position) in Side::ALL.into_iter().zip(tile) {
                partial.set(column, row, side, position);
            }
            walls(partial, cell + 1, found);
            for (side, position) in Side::ALL.into_iter().zip(known) {
                partial.set(column, row, side, position);
            }
        }
    }
}

fn count(partial: &Wall) -> u64 {
    let mut count = 0;
    walls(&mut partial.clone(), 0, &mut |_| count += 1);
    count
}

#[test]
fn numbers_of_walls() {
    assert_eq!(tiles(3).len(), 36);
    for (size, positions) in [((1, 1), 5), ((2, 1), 3), ((3, 2), 2), ((2, 2), 3), ((4, 2), 2)] {
        let counted = count(&Wall::rectangle(size, positions));
        assert_eq!(labels::count_all(size, positions), counted.into(), "{size:?}, {positions}");
        // Label by label, and all boundaries of one line.
        let cells = size.0 * size.1;
        let all = (0..1_u32 << cells).map(|number| {
            let cells = (0..cells).map(|cell| (number >> cell & 1) as u8).collect();
            Field::new(size.0, size.1, cells).unwrap()
        });
        let partial = Wall::rectangle(size, positions);
        let sum: BigUint = all.map(|of| labels::count(&partial, &of, false)).sum();
        assert_eq!(sum, counted.into());
    }
    // 4^9 3^6
    assert_eq!(labels::count_all((3, 3), 3), 191_102_976_u64.into());
}

#[test]
fn numbers_of_walks() {
    for positions in 2..6_u8 {
        for moves in 0..14_usize {
            // By the matrix of all moves.
            let mut from_0 = vec![0_u64; positions.into()];
            from_0[0] = 1;
            for _ in 0..moves {
                let sum: u64 = from_0.iter().sum();
                from_0 = from_0.iter().map(|&here| sum - here).collect();
            }
            let (same, other) = (weight(moves, true, positions), weight(moves, false, positions));
            if moves < 10 && positions > 2 {
                assert_eq!((same, other), (from_0[0], from_0[1]));
            }
            let part = |a: u64, b: u64| a as f64 / (a + b) as f64;
            assert!((part(same, other) - part(from_0[0], from_0[1])).abs() < 1e-9);
        }
    }
}

#[test]
fn walls_of_labels_are_all_alike() {
    let cells = vec![0, 1, 1, 1, 0, 1];
    let of = Field::new(3, 2, cells).unwrap();
    let mut partial = Wall::rectangle((3, 2), 3);
    boundary::read("west 0 .\neast 1 2\nnorth . . 2\n", &mut partial).unwrap();
    let mut seen = BTreeMap::new();
    walls(&mut partial.clone(), 0, &mut |wall| {
        let fits = of.cells().iter().enumerate().all(|(c, &l)| wall.label(c % 3, c / 3) == l);
        if fits {
            seen.insert(format!("{wall:?}"), 0_u32);
        }
    });
    let all = seen.len() as u32;
    assert_eq!(labels::count(&partial, &of, false), all.into());
    let each = 30;
    for seed in 0..u64::from(each * all) {
        let wall = labels::wall(&partial, &of, false, seed).unwrap();
        assert_eq!(wall.fault(false), None);
        *seen.get_mut(&format!("{wall:?}")).unwrap() += 1;
    }
    // Chi-squared, five standard deviations above its mean.
    let far: f64 =
        seen.values().map(|&n| (f64::from(n) - f64::from(each)).powi(2) / f64::from(each)).sum();
    let free = f64::from(all - 1);
    assert!(far < free + 5.0 * (2.0 * free).sqrt(), "{far} of {free}");
}

fn dappled(size: (usize, usize), edges: Edges, limits: (u32, u32), seed: u64) -> Field {
    let rule = labels::rule(size, edges, (Some(limits.0), Some(limits.1))).unwrap();
    let mut field = Field::filled(size.0, size.1, NO_TILE).unwrap();
    start::fill_randomly(&mut field, 2, seed);
    match make(&rule, field, Options { order: Order::Diagonal, seed }, &()).unwrap() {
        Made::Tiling(field, _) => field,
        other => unreachable!("{other:?}"),
    }
}

fn random_boundary(wall: &mut Wall, random: &mut Random, free: usize) {
    let cells: Vec<_> = wall.cells().collect();
    for (column, row) in cells {
        for side in Side::ALL {
            if wall.neighbor(column, row, side).is_none() && random.below(100) >= free {
                let position = random.below(wall.positions().into()) as u8;
                wall.set(column, row, side, position);
            }
        }
    }
}

/// Labels that keep both limits of 2, on lines of 6 and more: two moves on every line.
#[test]
fn every_boundary_goes_on() {
    let mut parity = 0;
    for seed in 0..300 {
        let mut random = Random(seed);
        let size = (6 + random.below(9), 6 + random.below(9));
        let both = tilepack::dappled::Rule::uniform(size, 2, Edges::Free, Some(2), Some(2));
        let mut field = Field::filled(size.0, size.1, NO_TILE).unwrap();
        start::fill_randomly(&mut field, 2, seed);
        let options = Options { order: Order::Diagonal, seed };
        let Made::Tiling(of, _) = make(&both.unwrap(), field, options, &()).unwrap() else {
            panic!("there are such labels");
        };
        let mut partial = Wall::rectangle(size, 3 + random.below(3) as u8);
        random_boundary(&mut partial, &mut random, 0);
        let wall = labels::wall(&partial, &of, false, seed).unwrap();
        assert_eq!(wall.fault(false), None);
        let same = |(column, row): (usize, usize)| {
            Side::ALL.into_iter().all(|side| {
                let given = partial.at(column, row, side);
                given == FREE || given == wall.at(column, row, side)
            }) && wall.label(column, row) == of.at(column, row)
        };
        assert!(wall.cells().all(same));
        // Two positions: every line must have the right parity.
        let mut two = Wall::rectangle(size, 2);
        random_boundary(&mut two, &mut random, 0);
        parity += u32::from(labels::wall(&two, &of, false, seed).is_ok());
    }
    assert_eq!(parity, 0);
}

#[test]
fn walls_that_repeat_have_no_long_joints() {
    for seed in 0..150 {
        let mut random = Random(seed);
        let size = (6 + random.below(8), 6 + random.below(8));
        let limits = (2 + random.below(2) as u32, 2 + random.below(2) as u32);
        let of = dappled(size, Edges::Torus, limits, seed);
        let Ok(wall) = labels::wall(&Wall::rectangle(size, 3), &of, true, seed) else {
            // One move alone in a circle is no closed walk.
            let moves = |tile, cells: Vec<u8>| cells.iter().filter(|&&l| l == tile).count();
            let row = |row| moves(1, (0..size.0).map(|column| of.at(column, row)).collect());
            let column = |column| moves(0, (0..size.1).map(|row| of.at(column, row)).collect());
            assert!((0..size.1).any(|at| row(at) == 1) || (0..size.0).any(|at| column(at) == 1));
            continue;
        };
        assert_eq!(wall.fault(true), None);
        let rule = labels::rule(size, Edges::Torus, (Some(limits.0), Some(limits.1))).unwrap();
        let found = (0..size.0 * size.1).map(|c| wall.label(c % size.0, c / size.0)).collect();
        assert!(rule.accepts(&Field::new(size.0, size.1, found).unwrap()));
    }
}

#[test]
fn regions_are_decided() {
    let (mut some, mut none, mut cycles) = (0, 0, 0);
    for seed in 0..1500 {
        let mut random = Random(seed);
        let size = (1 + random.below(4), 1 + random.below(3));
        let inside: Vec<bool> = (0..size.0 * size.1).map(|_| random.below(4) > 0).collect();
        if !inside.contains(&true) {
            continue;
        }
        let mut partial = Wall::new(size, 2 + random.below(3) as u8, inside);
        let free = [0, 0, 3, 20][random.below(4)];
        random_boundary(&mut partial, &mut random, free);
        let mut expected = false;
        // Only whether there is one: small walls have thousands.
        if partial.cells().count() <= 6 {
            expected = count(&partial) > 0;
        }
        match region::fill(&partial, seed) {
            Ok(wall) => {
                assert_eq!(wall.fault(false), None, "{partial:?}");
                let kept = partial.cells().all(|(column, row)| {
                    let pairs = partial.tile(column, row).into_iter().zip(wall.tile(column, row));
                    pairs.into_iter().all(|(given, found)| given == FREE || given == found)
                });
                assert!(kept);
                some += 1;
            }
            Err(unfillable) => {
                assert!(!expected && count(&partial) == 0, "{partial:?}: {unfillable}");
                none += 1;
            }
        }
        let holds = |c, r| c < size.0 && r < size.1 && partial.holds(c, r);
        let square =
            |(c, r): (usize, usize)| holds(c + 1, r) && holds(c, r + 1) && holds(c + 1, r + 1);
        cycles += u32::from(partial.cells().any(square));
    }
    assert!(some > 500 && none > 100 && cycles > 200, "{some} {none} {cycles}");
}

#[test]
fn a_region_with_holes_and_any_boundary() {
    let text = "..######..\n.########.\n###....###\n###.##.###\n####..####\n.########.\n";
    let (size, inside) = boundary::region(text).unwrap();
    for seed in 0..40 {
        let mut partial = Wall::new(size, 3, inside.clone());
        random_boundary(&mut partial, &mut Random(seed), 0);
        match region::fill(&partial, seed) {
            Ok(wall) => assert_eq!(wall.fault(false), None),
            // The two cells in the hole are a tree: not every boundary does.
            Err(unfillable) => assert_eq!((unfillable.row, unfillable.cells), (3, 2)),
        }
    }
    // A long corridor: no recursion, linear time.
    let corridor = Wall::new((200_000, 1), 4, vec![true; 200_000]);
    assert_eq!(region::fill(&corridor, 1).unwrap().fault(false), None);
}

#[test]
fn boundaries_are_read() {
    let mut wall = Wall::rectangle((3, 2), 4);
    boundary::read("# all\nnorth 0 1 2\n\n1 2 east 3 # one\nwest . 1\n", &mut wall).unwrap();
    assert_eq!(wall.tile(2, 1), [FREE, 3, FREE, FREE]);
    assert_eq!(wall.tile(0, 0), [0, FREE, FREE, FREE]);
    assert_eq!(wall.at(0, 1, Side::West), 1);
    for (text, line, column) in [
        ("north 0 1\n", 1, 1),
        ("north 0 1 4\n", 1, 11),
        ("\n1 1 east 0\n", 2, 1),
        ("2 0 west 1\n", 1, 1),
        ("0 0 up 1\n", 1, 5),
        ("0 0 north x\n", 1, 11),
        ("0 0\n", 1, 1),
    ] {
        let error = boundary::read(text, &mut wall).unwrap_err();
        assert_eq!((error.line, error.column), (line, column), "{text:?}: {error}");
    }
    assert!(boundary::region("..\n..\n").is_err());
    assert!(boundary::region("##\n#\n").is_err());
    assert_eq!(boundary::region("#.\n##\n").unwrap(), ((2, 2), vec![true, false, true, true]));
}
