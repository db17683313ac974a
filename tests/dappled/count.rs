//! The count against all fillings of small rectangles, for rules of every kind.

use crate::oracle;
use num_bigint::BigUint;
use tilepack::dappled::count::{Counting, MEMORY, Need, Sampler, count, numbers};
use tilepack::dappled::{Condition, Direction, Edges, FREE, Field, Limit, Rule};

/// Numbers that look random.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 31)).wrapping_mul(0x7fb5_d329_728e_a185);
        (x ^ (x >> 29)) % bound
    }
}

pub(crate) const EDGES: [Edges; 3] = [Edges::Free, Edges::Cylinder, Edges::Torus];

/// Counts, and counts by every tile, and what all fillings give.
fn agrees(rule: &Rule, given: Option<&Field>) {
    let all = oracle::tilings(rule, given);
    let about = || format!("{rule:?} {given:?}");
    assert_eq!(count(rule, given).unwrap(), BigUint::from(all.len()), "{}", about());
    for tile in 0..rule.tiles() as u8 {
        let mut expected = vec![0u64; rule.width() * rule.height() + 1];
        for field in &all {
            expected[field.cells().iter().filter(|&&cell| cell == tile).count()] += 1;
        }
        let found = numbers(rule, given, tile).unwrap();
        let expected = expected.into_iter().enumerate().filter(|&(_, number)| number > 0);
        let expected: Vec<_> = expected.map(|(n, number)| (n, BigUint::from(number))).collect();
        assert_eq!(found, expected, "tile {tile} {}", about());
    }
}

#[test]
fn the_same_limits_for_all() {
    let limits = [Some(1), Some(2), Some(3), None];
    for edges in EDGES {
        for (width, height) in
            [(1, 1), (1, 4), (5, 1), (2, 2), (2, 3), (3, 2), (3, 3), (4, 3), (2, 5), (5, 2)]
        {
            for across in limits {
                for down in limits {
                    let rule = Rule::uniform((width, height), 2, edges, across, down).unwrap();
                    agrees(&rule, None);
                    if width * height <= 6 {
                        agrees(
                            &Rule::uniform((width, height), 3, edges, across, down).unwrap(),
                            None,
                        );
                    }
                }
            }
        }
    }
    agrees(&Rule::uniform((4, 4), 2, Edges::Torus, Some(2), Some(3)).unwrap(), None);
    agrees(&Rule::uniform((3, 5), 2, Edges::Torus, Some(3), Some(2)).unwrap(), None);
    agrees(&Rule::uniform((1, 1), 1, Edges::Torus, Some(2), Some(2)).unwrap(), None);
}

#[test]
fn rules_and_cells_at_random() {
    let mut random = Random(7);
    let mut some = 0;
    for _ in 0..600 {
        let tiles = 2 + random.below(2) as usize;
        let (width, height) = loop {
            let size = (1 + random.below(5) as usize, 1 + random.below(5) as usize);
            if (tiles as f64).powi((size.0 * size.1) as i32) < 5000.0 {
                break size;
            }
        };
        let cells = width * height;
        let mut conditions = Vec::new();
        for _ in 0..1 + random.below(5) {
            let limit = match random.below(3) {
                0 => Limit::Map(
                    (0..cells)
                        .map(|_| match random.below(4) {
                            0 => u32::MAX,
                            limit => limit as u32,
                        })
                        .collect(),
                ),
                1 => Limit::None,
                _ => Limit::Same(1 + random.below(6) as u32),
            };
            let direction = [Direction::Horizontal, Direction::Vertical][random.below(2) as usize];
            conditions.push(Condition {
                set: 1 + random.below((1 << tiles) - 1),
                direction,
                limit,
            });
        }
        let edges = EDGES[random.below(3) as usize];
        let rule = Rule::new((width, height), tiles, edges, conditions).unwrap();
        let given: Vec<u8> = (0..cells)
            .map(|_| match random.below(4) {
                0 => random.below(tiles as u64) as u8,
                _ => FREE,
            })
            .collect();
        let given = Field::new(width, height, given).unwrap();
        let given = (random.below(2) == 0).then_some(&given);
        agrees(&rule, given);
        some += usize::from(count(&rule, given).unwrap() > BigUint::ZERO);
    }
    assert!(some > 300, "{some}");
}

/// A count that is saved and gone on with after every step.
#[test]
fn saved_at_every_step() {
    let cases = [
        (Rule::uniform((4, 5), 2, Edges::Free, Some(2), Some(2)).unwrap(), None),
        (Rule::uniform((3, 6), 3, Edges::Cylinder, Some(2), Some(1)).unwrap(), Some(1)),
        (Rule::uniform((4, 5), 2, Edges::Torus, Some(2), Some(2)).unwrap(), Some(0)),
    ];
    for (rule, by) in cases {
        let new = || Counting::new(&rule, None, by, MEMORY).unwrap();
        let mut whole = new();
        let mut counting = new();
        while !whole.is_done() {
            whole.step().unwrap();
            if !counting.is_done() {
                counting.step().unwrap();
            }
            let mut bytes = Vec::new();
            counting.save(&mut bytes).unwrap();
            assert_eq!(bytes.len() as u64, counting.saved_bytes());
            counting = new();
            counting.restore(&mut &bytes[..]).unwrap();
            for cut in [0, 7, 16, bytes.len() - 1] {
                assert!(new().restore(&mut &bytes[..cut.min(bytes.len() - 1)]).is_err());
            }
        }
        while !counting.is_done() {
            counting.step().unwrap();
        }
        assert_eq!(counting.numbers(), whole.numbers());
    }
}

#[test]
fn states_of_another_count_are_refused() {
    let rule = |m| Rule::uniform((m, 8), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let mut other = Counting::new(&rule(7), None, None, MEMORY).unwrap();
    for _ in 0..20 {
        other.step().unwrap();
    }
    let mut bytes = Vec::new();
    other.save(&mut bytes).unwrap();
    assert!(Counting::new(&rule(5), None, None, MEMORY).unwrap().restore(&mut &bytes[..]).is_err());
}

#[test]
fn more_than_the_memory_is_refused_with_the_number() {
    let rule = Rule::uniform((18, 18), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let need = Need::of(&rule, None, None).unwrap();
    assert!((9e7..2e8).contains(&need.states) && need.bytes > 4e9, "{need:?}");
    let rule = Rule::uniform((10, 10), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let mut counting = Counting::new(&rule, None, None, 1 << 18).unwrap();
    let error = loop {
        if let Err(error) = counting.step() {
            break error.to_string();
        }
    };
    assert!(error.ends_with("the limit is 256 KiB"), "{error}");
    assert!(Sampler::new(&rule, None, 1 << 18).is_err());
    let wide = Rule::uniform((40, 40), 2, Edges::Free, Some(2), Some(2)).unwrap();
    assert!(Counting::new(&wide, None, None, MEMORY).is_err());
    let given = Field::filled(9, 10, FREE).unwrap();
    assert!(count(&rule, Some(&given)).is_err());
}

/// Where most cells are given, width is no obstacle.
#[test]
fn wide_fields_that_are_nearly_full() {
    let rule = Rule::uniform((60, 40), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let cell = |at: usize| ((at % 60 / 2 + at / 60) % 2) as u8;
    let mut cells: Vec<u8> = (0..2400).map(cell).collect();
    assert_eq!(
        count(&rule, Some(&Field::new(60, 40, cells.clone()).unwrap())).unwrap(),
        1u32.into()
    );
    for at in [0, 59, 1234, 2399] {
        cells[at] = FREE;
    }
    let given = Field::new(60, 40, cells.clone()).unwrap();
    let mut expected = 0u32;
    for tiles in 0..16 {
        let mut cells = cells.clone();
        for (bit, at) in [0, 59, 1234, 2399].into_iter().enumerate() {
            cells[at] = tiles >> bit & 1;
        }
        expected += u32::from(rule.accepts(&Field::new(60, 40, cells).unwrap()));
    }
    assert_eq!(count(&rule, Some(&given)).unwrap(), expected.into());
}

/// However many threads there are, what is saved is the same to the last byte.
#[test]
fn threads_make_no_difference() {
    let rule = Rule::uniform((10, 10), 2, Edges::Free, Some(2), Some(2)).unwrap();
    let saved = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut counting = Counting::new(&rule, None, None, MEMORY).unwrap();
            let mut bytes = Vec::new();
            for _ in 0..37 {
                counting.step().unwrap();
            }
            counting.save(&mut bytes).unwrap();
            while !counting.is_done() {
                counting.step().unwrap();
            }
            (bytes, counting.numbers())
        })
    };
    let one = saved(1);
    assert!(one.0.len() > 16 * 20_000, "{}", one.0.len());
    assert_eq!(one.1, ["36133311325799774".parse::<BigUint>().unwrap()]);
    assert!([2, 3, 5].into_iter().all(|threads| saved(threads) == one));
}
