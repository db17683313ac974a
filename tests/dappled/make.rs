//! `make`: against the algorithms as they are written down, and against all fields of small size.

use crate::random::Random;
use tilepack::dappled::make::{How, Made, Options, Order, make, pass, start};
use tilepack::dappled::{Condition, Direction, Edges, FREE, Field, Limit, Rule, faults};

const H: Direction = Direction::Horizontal;
const V: Direction = Direction::Vertical;
const ORDERS: [Order; 2] = [Order::Diagonal, Order::Wavefront];

fn options(order: Order) -> Options {
    Options { order, seed: 0 }
}

fn field(size: (usize, usize), tiles: usize, seed: u64) -> Field {
    let mut field = Field::filled(size.0, size.1, FREE).unwrap();
    start::fill_randomly(&mut field, tiles, seed);
    field
}

fn made(rule: &Rule, start: Field, order: Order) -> (Field, How) {
    match make(rule, start, options(order), &()).unwrap() {
        Made::Tiling(field, how) => (field, how),
        other => unreachable!("{other:?}"),
    }
}

/// Steps I and II for a cell that repeats too often.
fn steps(
    field: &mut Field,
    (i, j): (usize, usize),
    violates: impl Fn(&Field, usize, usize) -> bool,
) {
    field.set(i, j, 1 - field.at(i, j));
    if violates(field, i, j) {
        let s = field.at(i - 1, j - 1);
        field.set(i, j, s);
        field.set(i - 1, j, 1 - s);
        field.set(i, j - 1, 1 - s);
    }
}

/// Algorithm 1 as it is written down; `limit` is that of a direction, a label and a cell.
fn obvious(field: &mut Field, limit: impl Fn(Direction, u8, usize) -> Option<u32>, order: Order) {
    let (m, n) = (field.width(), field.height());
    let violates = |field: &Field, i: usize, j: usize| {
        let t = field.at(i, j);
        let p = limit(H, t, j * m + i).map_or(usize::MAX, |limit| limit as usize);
        let q = limit(V, t, j * m + i).map_or(usize::MAX, |limit| limit as usize);
        i >= p && (1..=p).all(|back| field.at(i - back, j) == t)
            || j >= q && (1..=q).all(|back| field.at(i, j - back) == t)
    };
    for weight in 0..m + n - 1 {
        let mut columns: Vec<usize> = (0..m).filter(|&i| i <= weight && weight - i < n).collect();
        if order == Order::Wavefront {
            columns.sort_by_key(|&i| (i % 2, i));
        }
        for i in columns {
            let j = weight - i;
            if violates(field, i, j) {
                steps(field, (i, j), violates);
            }
        }
    }
}

#[test]
fn as_algorithm_1_is_written_down() {
    for seed in 0..120 {
        let mut random = Random(seed);
        let size = match seed % 40 {
            // More than one block and one band.
            0 => (1100 + random.below(100), 90),
            1 => (90, 300),
            _ => (1 + random.below(45), 1 + random.below(45)),
        };
        let cells = size.0 * size.1;
        let mut conditions = Vec::new();
        for tile in 0..2 {
            for direction in [H, V] {
                let limit = match random.below(5) {
                    0 => continue,
                    1 => Limit::Map((0..cells).map(|_| 2 + random.below(3) as u32).collect()),
                    _ => Limit::Same(2 + random.below(3) as u32),
                };
                conditions.push(Condition { set: 1 << tile, direction, limit });
            }
        }
        let rule = Rule::new(size, 2, Edges::Free, conditions).unwrap();
        let limit = |direction, tile, cell| {
            let of = |c: &&Condition| c.direction == direction && c.set == 1_u64 << tile;
            rule.conditions().iter().find(of).and_then(|c| c.limit.at(cell))
        };
        let start = match seed % 3 {
            0 => Field::filled(size.0, size.1, 0).unwrap(),
            _ => field(size, 2, seed),
        };
        for order in ORDERS {
            let (got, _, sure) = pass(&rule, start.clone(), options(order));
            let mut expected = start.clone();
            obvious(&mut expected, limit, order);
            assert!(sure && got == expected, "{size:?}, {order:?}, seed {seed}");
            assert!(faults::is_faultless(&rule, &got));
            // A retraction.
            assert_eq!(pass(&rule, got.clone(), options(order)).0, got);
        }
    }
}

#[test]
fn every_small_field_and_only_dappled_ones_stay() {
    let rule = Rule::uniform((4, 3), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let mut stay = 0;
    for number in 0..1_u32 << 12 {
        let cells = (0..12).map(|cell| (number >> cell & 1) as u8).collect();
        let start = Field::new(4, 3, cells).unwrap();
        for order in ORDERS {
            let (got, _) = made(&rule, start.clone(), order);
            assert!(rule.accepts(&got));
            assert_eq!(got == start, rule.accepts(&start));
        }
        stay += u32::from(rule.accepts(&start));
    }
    assert_eq!(stay, 378);
}

#[test]
fn threads_change_nothing() {
    let rule = Rule::uniform((2300, 300), 2, Edges::Free, Some(2), Some(3)).unwrap();
    let start = field((2300, 300), 2, 5);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| made(&rule, start.clone(), Order::Wavefront).0)
    };
    let one = on(1);
    for threads in [2, 3, 7] {
        assert!(on(threads) == one, "{threads} threads");
    }
}

/// Whether a cell pushes a lighter one depends on those two alone, not on what it held: so a changed
/// cell changes nothing that is lighter.
#[test]
fn a_changed_cell_changes_no_lighter_ones() {
    let size = (20, 16);
    let rule = Rule::uniform(size, 2, Edges::Free, Some(2), Some(2)).unwrap();
    let many = Rule::uniform(size, 3, Edges::Free, Some(1), Some(2)).unwrap();
    let mut lightest = isize::MAX;
    for seed in 0..400 {
        let mut random = Random(seed);
        let (column, row) = (random.below(size.0), random.below(size.1));
        let changed = |rule: &Rule, tiles: usize, order| {
            let start = field(size, tiles, seed);
            let mut other = start.clone();
            other.set(column, row, (start.at(column, row) + 1) % tiles as u8);
            let (a, b) = (made(rule, start, order).0, made(rule, other, order).0);
            let cells = (0..size.0 * size.1).filter(move |&c| a.cells()[c] != b.cells()[c]);
            cells.map(move |cell| (cell % size.0, cell / size.0)).collect::<Vec<_>>()
        };
        for order in ORDERS {
            for (i, j) in changed(&rule, 2, order) {
                lightest = lightest.min((i + j) as isize - (column + row) as isize);
            }
            // With more tiles nothing is pushed: only what lies east and south.
            let cells = changed(&many, 3, order);
            assert!(cells.iter().all(|&(i, j)| i >= column && j >= row));
        }
    }
    assert_eq!(lightest, 0);
}

#[test]
fn more_tiles_and_sets_of_tiles() {
    let limit = Limit::Same;
    for seed in 0..60 {
        let mut random = Random(seed);
        let tiles = 3 + random.below(4);
        let (p, q) = (1 + random.below(3) as u32, 1 + random.below(3) as u32);
        let rule = Rule::uniform((23, 17), tiles, Edges::Free, Some(p), Some(q)).unwrap();
        let start = field((23, 17), tiles, seed);
        let (got, how) = made(&rule, start.clone(), Order::Diagonal);
        assert!(rule.accepts(&got));
        assert_eq!(how, How::Greedy);
        // The order of cells is nothing to it, and it is a retraction.
        assert_eq!(made(&rule, start, Order::Wavefront).0, got);
        assert_eq!(made(&rule, got.clone(), Order::Diagonal).0, got);
    }
    // Six tiles: three classes; two classes; sets that overlap.
    for (sets, expected) in [
        (&[0b11, 0b1100, 0b110000][..], Some(How::Greedy)),
        (&[0b111, 0b111000][..], Some(How::Pair)),
        (&[0b11, 0b110, 0b1100, 0b110000][..], Some(How::Greedy)),
        (&[0b11111, 0b111110][..], None),
    ] {
        for seed in 0..10 {
            let conditions = sets.iter().flat_map(|&set| {
                [H, V].map(|direction| Condition { set, direction, limit: limit(2) })
            });
            let rule = Rule::new((20, 20), 6, Edges::Free, conditions.collect()).unwrap();
            let (got, how) = made(&rule, field((20, 20), 6, seed), Order::Diagonal);
            assert!(rule.accepts(&got), "{sets:?}");
            assert!(expected.is_none_or(|expected| how == expected), "{sets:?}: {how:?}");
            assert_eq!(made(&rule, got.clone(), Order::Diagonal).0, got);
        }
    }
}

/// Whether a field keeps a rule without edges that meet when laid twice in both directions.
fn holds_twice(rule: &Rule, field: &Field) -> bool {
    let (m, n) = (rule.width(), rule.height());
    let cells = (0..4 * m * n).map(|cell| field.at(cell % (2 * m) % m, cell / (2 * m) % n));
    let twice = Field::new(2 * m, 2 * n, cells.collect()).unwrap();
    let free = Rule::new((2 * m, 2 * n), rule.tiles(), Edges::Free, rule.conditions().to_vec());
    free.unwrap().accepts(&twice)
}

#[test]
fn edges_that_meet() {
    let mut hows = std::collections::BTreeSet::new();
    for seed in 0..250 {
        let mut random = Random(seed);
        let size = (2 + random.below(13), 2 + random.below(13));
        let tiles = 2 + random.below(2);
        let mut limit = || Some(2 + random.below(3) as u32).filter(|&limit| limit < 5);
        let rule = Rule::uniform(size, tiles, Edges::Torus, limit(), limit()).unwrap();
        let start = field(size, tiles, seed);
        let (got, how) = made(&rule, start.clone(), Order::Diagonal);
        assert!(rule.accepts(&got) && holds_twice(&rule, &got), "{size:?}, seed {seed}");
        assert_eq!(how == How::Unchanged, rule.accepts(&start));
        assert_eq!(made(&rule, got.clone(), Order::Diagonal), (got, How::Unchanged));
        hows.insert(format!("{how:?}"));
    }
    assert!(hows.contains("Cyclic") && hows.contains("Repaired"), "{hows:?}");
}

/// Anything, small enough to try all fields: there is a tiling or there is none.
#[test]
fn none_where_there_is_none() {
    let (mut none, mut some) = (0, 0);
    for seed in 0..300 {
        let mut random = Random(seed);
        let size = (1 + random.below(4), 1 + random.below(3));
        let edges = [Edges::Free, Edges::Cylinder, Edges::Torus][random.below(3)];
        let mut conditions = Vec::new();
        for set in 1..4 {
            for direction in [H, V] {
                if random.below(if set == 3 { 12 } else { 2 }) == 0 {
                    let limit = Limit::Same(1 + random.below(3) as u32);
                    conditions.push(Condition { set, direction, limit });
                }
            }
        }
        let rule = Rule::new(size, 2, edges, conditions).unwrap();
        let cells = size.0 * size.1;
        let fields = (0..1_u32 << cells).map(|number| {
            let cells = (0..cells).map(|cell| (number >> cell & 1) as u8).collect();
            Field::new(size.0, size.1, cells).unwrap()
        });
        let expected = fields.filter(|field| rule.accepts(field)).count() > 0;
        match make(&rule, field(size, 2, seed), options(Order::Diagonal), &()).unwrap() {
            Made::Tiling(field, _) => assert!(expected && rule.accepts(&field)),
            Made::Impossible => assert!(!expected, "{rule:?}"),
            Made::Stopped => panic!("nothing stops it"),
        }
        if expected { some += 1 } else { none += 1 }
    }
    assert!(none > 30 && some > 100, "{none} {some}");
}

/// The bezel, a way for limits of 2 where edges meet: two rows and two columns like a draughtboard,
/// then Algorithm 2 for all others. It leaves faults along the seams.
fn bezel(field: &mut Field) {
    let (m, n) = (field.width(), field.height());
    for i in (0..m).step_by(2) {
        let a = field.at(i, 0);
        for (column, row, tile) in [(i + 1, 0, 1 - a), (i, 1, 1 - a), (i + 1, 1, a)] {
            field.set(column, row, tile);
        }
    }
    for j in (2..n).step_by(2) {
        let a = field.at(0, j);
        for (column, row, tile) in [(0, j + 1, 1 - a), (1, j, 1 - a), (1, j + 1, a)] {
            field.set(column, row, tile);
        }
    }
    let line = |cells: Vec<u8>, at: usize| {
        let (t, length) = (cells[at], cells.len());
        if at + 1 < length {
            return cells[at - 1] == t && cells[at - 2] == t;
        }
        let before = cells.iter().rev().take_while(|&&tile| tile == t).count();
        before + cells.iter().take_while(|&&tile| tile == t).count() > 2
    };
    let violates = |field: &Field, i: usize, j: usize| {
        line((0..m).map(|i| field.at(i, j)).collect(), i)
            || line((0..n).map(|j| field.at(i, j)).collect(), j)
    };
    for weight in 4..m + n - 1 {
        for i in (2..m).filter(|&i| i + 2 <= weight && weight - i < n) {
            let j = weight - i;
            if violates(field, i, j) {
                steps(field, (i, j), violates);
            }
        }
    }
}

#[test]
fn limits_of_2_where_the_bezel_fails() {
    let rule = Rule::uniform((12, 10), 2, Edges::Torus, Some(2), Some(2)).unwrap();
    let mut failed = 0;
    for seed in 0..200 {
        let start = field((12, 10), 2, seed);
        let mut other = start.clone();
        bezel(&mut other);
        failed += u32::from(!rule.accepts(&other));
        let (got, _) = made(&rule, start, Order::Diagonal);
        assert!(rule.accepts(&got));
    }
    // Counted here; the same seeds give the same fields everywhere.
    assert_eq!(failed, 11);
}

#[test]
fn a_large_field_with_edges_that_meet_changes_along_its_seams() {
    let rule = Rule::uniform((128, 127), 2, Edges::Torus, Some(2), Some(2)).unwrap();
    let start = field((128, 127), 2, 1);
    let free = Rule::uniform((128, 127), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let (draft, _) = made(&free, start.clone(), Order::Diagonal);
    let (got, how) = made(&rule, start, Order::Diagonal);
    assert!(rule.accepts(&got));
    assert_eq!(how, How::Repaired);
    for row in 30..97 {
        for column in 30..98 {
            assert_eq!(got.at(column, row), draft.at(column, row));
        }
    }
}

#[test]
fn faults_are_those_of_the_definition() {
    for seed in 0..600 {
        let mut random = Random(seed);
        let size = (1 + random.below(7), 1 + random.below(7));
        let edges = [Edges::Free, Edges::Cylinder, Edges::Torus][random.below(3)];
        let cells = size.0 * size.1;
        let mut conditions = Vec::new();
        for _ in 0..random.below(4) {
            let limit = match random.below(3) {
                0 => Limit::Same(1 + random.below(9) as u32),
                _ => {
                    let limit = |_| [1, 2, 3, 4, u32::MAX][random.below(5)];
                    Limit::Map((0..cells).map(limit).collect())
                }
            };
            let (set, direction) = (1 + random.below(7) as u64, [H, V][random.below(2)]);
            conditions.push(Condition { set, direction, limit });
        }
        let rule = Rule::new(size, 3, edges, conditions).unwrap();
        let mut field = field(size, if seed % 3 == 0 { 1 } else { 2 }, seed);
        if seed % 2 == 0 {
            field.cells_mut()[random.below(cells)] = FREE;
        }
        assert_eq!(faults::is_faultless(&rule, &field), rule.first_fault(&field).is_none());
        let holds = |w: &tilepack::dappled::Window, cell: u32| {
            let tile = field.cells()[cell as usize];
            tile != FREE && w.set >> tile & 1 == 1
        };
        let mut expected = vec![false; cells];
        for window in rule.windows().filter(|w| w.cells.iter().all(|&cell| holds(w, cell))) {
            window.cells.iter().for_each(|&cell| expected[cell as usize] = true);
        }
        let broken = faults::broken(&rule, &field);
        // Where edges meet, of a line all alike all cells are told, whatever their limits.
        assert!(expected.iter().zip(&broken).all(|(&expected, &broken)| broken || !expected));
        assert!(edges != Edges::Free || broken == expected, "{rule:?} {field:?}");
    }
}

#[test]
fn random_starts_are_even() {
    for tiles in [1, 2, 3, 5, 64] {
        let field = field((300, 200), tiles, 9);
        let mut counts = vec![0_usize; tiles];
        field.cells().iter().for_each(|&tile| counts[usize::from(tile)] += 1);
        let mean = 60_000 / tiles;
        let far = 6 * mean.isqrt();
        assert!(counts.iter().all(|&count| count.abs_diff(mean) <= far), "{counts:?}");
    }
}
