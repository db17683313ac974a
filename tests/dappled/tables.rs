//! Numbers that are known: the tables that other programs made, whole.

use num_bigint::BigUint;
use tilepack::dappled::count::{count, numbers};
use tilepack::dappled::{Condition, Direction, Edges, Limit, Rule};

fn two(size: (usize, usize), edges: Edges) -> Rule {
    Rule::uniform(size, 2, edges, Some(2), Some(2)).unwrap()
}

/// Limits of two tiles in a row, and in a column; 0 for none.
fn limits(size: (usize, usize), edges: Edges, across: [u32; 2], down: [u32; 2]) -> Rule {
    let mut conditions = Vec::new();
    for (direction, limits) in [(Direction::Horizontal, across), (Direction::Vertical, down)] {
        for (tile, limit) in limits.into_iter().enumerate().filter(|&(_, limit)| limit > 0) {
            conditions.push(Condition { set: 1 << tile, direction, limit: Limit::Same(limit) });
        }
    }
    Rule::new(size, 2, edges, conditions).unwrap()
}

fn is(rule: &Rule, expected: u64) {
    assert_eq!(count(rule, None).unwrap(), BigUint::from(expected), "{rule:?}");
}

/// Free edges, limits of 2: rows of 1 to 10 cells, 1 to 10 rows (OEIS A203407, shifted).
const FREE: [[u64; 10]; 10] = [
    [2, 4, 6, 10, 16, 26, 42, 68, 110, 178],
    [4, 16, 36, 100, 256, 676, 1764, 4624, 12100, 31684],
    [6, 36, 102, 378, 1260, 4374, 14946, 51384, 176238, 605022],
    [10, 100, 378, 2030, 9484, 46746, 225654, 1098136, 5327258, 25875154],
    [16, 256, 1260, 9484, 60232, 408432, 2699464, 18021052, 119835492, 798096928],
    [26, 676, 4374, 46746, 408432, 3858082, 35345798, 327725888, 3024430930, 27962750194],
    [42, 1764, 14946, 225654, 2699464, 35345798, 446672706, 5723980832, 72950746702, 931753350314],
    [
        68,
        4624,
        51384,
        1098136,
        18021052,
        327725888,
        5723980832,
        101578277384,
        1791372199364,
        31670053199428,
    ],
    [
        110,
        12100,
        176238,
        5327258,
        119835492,
        3024430930,
        72950746702,
        1791372199364,
        43680343039806,
        1068074622125486,
    ],
    [
        178,
        31684,
        605022,
        25875154,
        798096928,
        27962750194,
        931753350314,
        31670053199428,
        1068074622125486,
        36133311325799774,
    ],
];

/// Edges that meet, limits of 2: rows of 3 to 10 cells, 3 to 10 rows.
const TORUS: [[u64; 8]; 8] = [
    [102, 90, 390, 2220, 4872, 18546, 71850, 217566],
    [90, 90, 270, 1380, 2940, 9858, 34146, 98766],
    [390, 270, 2470, 21460, 50680, 333350, 1871490, 7164470],
    [2220, 1380, 21460, 359312, 1081024, 11998564, 110336172, 613221500],
    [4872, 2940, 50680, 1081024, 3937948, 48190380, 527665908, 3738687428],
    [18546, 9858, 333350, 11998564, 48190380, 1055948890, 17765248650, 155830783126],
    [71850, 34146, 1871490, 110336172, 527665908, 17765248650, 436385508834, 5116760405118],
    [217566, 98766, 7164470, 613221500, 3738687428, 155830783126, 5116760405118, 83359698702062],
];

/// Rows that meet their end, of so many cells, limits of 2: 1 to 10 rows.
const CYLINDER: [(usize, [u64; 10]); 4] = [
    (4, [6, 36, 90, 318, 960, 3102, 9726, 30900, 97602, 309078]),
    (5, [10, 100, 390, 2090, 9900, 49130, 239490, 1175440, 5754050, 28195750]),
    (6, [20, 400, 2220, 19420, 141616, 1107620, 8431428, 64863368, 496966292, 3813737908]),
    (
        8,
        [
            46,
            2116,
            18546,
            295446,
            3702128,
            50946662,
            676224358,
            9104953924,
            121916466138,
            1636096118206,
        ],
    ),
];

/// Limits of 3: rows of 1 to 6 cells, 1 to 8 rows.
const THREE: [[u64; 8]; 6] = [
    [2, 4, 8, 14, 26, 48, 88, 162],
    [4, 16, 64, 196, 676, 2304, 7744, 26244],
    [8, 64, 512, 2744, 17576, 110592, 681472, 4251528],
    [14, 196, 2744, 22874, 240470, 2467368, 24640792, 250146966],
    [26, 676, 17576, 240470, 4387034, 77628864, 1328425072, 23202132978],
    [48, 2304, 110592, 2467368, 77628864, 2354389864, 68606038436, 2048733795660],
];

/// Limits in a row of 2 and 3, in a column of 3 and 2: rows of 1 to 6 cells, 1 to 8 rows.
const MIXED: [[u64; 8]; 6] = [
    [2, 4, 7, 12, 21, 36, 63, 109],
    [4, 16, 49, 144, 441, 1296, 3969, 11881],
    [7, 49, 174, 768, 3318, 13722, 58752, 248412],
    [12, 144, 768, 4998, 32480, 201158, 1292044, 8167098],
    [21, 441, 3318, 32480, 315232, 2887570, 27644834, 259844746],
    [36, 1296, 13722, 201158, 2887570, 38936998, 551590500, 7657965486],
];

/// A limit of 2 on tile 0 in a row and on tile 1 in a column: rows of 1 to 6 cells, 1 to 8 rows.
const BRICKS: [[u64; 8]; 6] = [
    [2, 4, 7, 13, 24, 44, 81, 149],
    [4, 16, 49, 169, 576, 1936, 6561, 22201],
    [7, 49, 174, 840, 3858, 17460, 80070, 365784],
    [13, 169, 840, 6510, 46878, 329952, 2371090, 16939450],
    [24, 576, 3858, 46878, 516724, 5517786, 60684900, 661767626],
    [44, 1936, 17460, 329952, 5517786, 88819714, 1482397764, 24487141408],
];

#[test]
fn free_edges() {
    for (m, row) in FREE.iter().enumerate() {
        for (n, &expected) in row.iter().enumerate() {
            is(&two((m + 1, n + 1), Edges::Free), expected);
        }
    }
    let eleven: BigUint = "57061338836892846628".parse().unwrap();
    assert_eq!(count(&two((11, 11), Edges::Free), None).unwrap(), eleven);
    let twelve: BigUint = "172603583392706027305210".parse().unwrap();
    assert_eq!(count(&two((12, 12), Edges::Free), None).unwrap(), twelve);
}

/// Three columns follow a linear recurrence, two are squares of Fibonacci numbers: both far beyond a
/// word.
#[test]
fn long_ones_follow_their_recurrence() {
    let narrow = |m, n| count(&two((m, n), Edges::Free), None).unwrap();
    let three: Vec<BigUint> = (2..=120).map(|n| narrow(3, n)).collect();
    for four in three.windows(5) {
        assert_eq!(&four[4] + &four[0], 2u32 * &four[3] + 5u32 * &four[2]);
    }
    let mut fibonacci = [BigUint::from(1u32), BigUint::from(1u32)];
    for n in 1..300 {
        let twice = 2u32 * &fibonacci[1];
        if n % 50 < 3 {
            assert_eq!(narrow(2, n), &twice * &twice, "{n}");
        }
        fibonacci = [fibonacci[1].clone(), &fibonacci[0] + &fibonacci[1]];
    }
}

#[test]
fn edges_that_meet() {
    for (m, row) in TORUS.iter().enumerate() {
        for (n, &expected) in row.iter().enumerate() {
            // What is left takes seconds; the numbers are in benches/runs.
            if m.min(n) + 3 <= 7 || m.max(n) + 3 <= 8 {
                is(&two((m + 3, n + 3), Edges::Torus), expected);
            }
        }
    }
}

#[test]
fn rows_that_meet_their_end() {
    for (m, row) in CYLINDER {
        for (n, expected) in row.into_iter().enumerate() {
            is(&two((m, n + 1), Edges::Cylinder), expected);
        }
    }
    for (n, expected) in FREE[2].into_iter().enumerate() {
        is(&two((3, n + 1), Edges::Cylinder), expected);
    }
    // Words without a run of three in a circle: OEIS A007040.
    for (m, expected) in (3..).zip([6, 6, 10, 20, 28, 46, 78, 122]) {
        is(&limits((m, 1), Edges::Cylinder, [2, 2], [0, 0]), expected);
    }
}

#[test]
fn other_limits() {
    for m in 1..=6 {
        for n in 1..=8 {
            let at = |table: [[u64; 8]; 6]| table[m - 1][n - 1];
            is(&limits((m, n), Edges::Free, [3, 3], [3, 3]), at(THREE));
            is(&limits((m, n), Edges::Free, [2, 3], [3, 2]), at(MIXED));
            is(&limits((m, n), Edges::Free, [2, 0], [0, 2]), at(BRICKS));
        }
    }
    let first = [[2, 3, 4, 5, 7, 9, 12, 16], [3, 2, 2, 2, 2, 2, 2, 2]];
    for m in 1..=6 {
        for n in 1..=8 {
            let expected = match (m, n) {
                (1 | 2, _) => first[m - 1][n - 1],
                (_, 1) => [4, 5, 7, 9][m - 3],
                _ => 2,
            };
            is(&limits((m, n), Edges::Free, [1, 2], [2, 1]), expected);
        }
    }
    let three = |size| Rule::uniform(size, 3, Edges::Free, Some(2), Some(2)).unwrap();
    is(&three((2, 2)), 81);
    is(&three((2, 4)), 4356);
    is(&three((3, 3)), 9750);
    for (size, expected) in [((3, 3), 102), ((3, 5), 2220), ((4, 4), 22874)] {
        is(&Rule::uniform(size, 2, Edges::Torus, Some(3), Some(3)).unwrap(), expected);
    }
}

/// How many ones, and in how many tilings.
#[test]
fn by_number() {
    let halves: [(usize, &[(usize, u64)]); 4] = [
        (3, &[(3, 6), (4, 45)]),
        (4, &[(5, 4), (6, 82), (7, 488), (8, 882)]),
        (5, &[(8, 5), (9, 179), (10, 1916), (11, 8880), (12, 19136)]),
        (
            6,
            &[
                (12, 6),
                (13, 220),
                (14, 4732),
                (15, 55804),
                (16, 325208),
                (17, 907660),
                (18, 1270822),
            ],
        ),
    ];
    for (m, half) in halves {
        let mirror = half.iter().map(|&(ones, number)| (m * m - ones, number));
        let mut expected: Vec<(usize, u64)> = half.iter().copied().chain(mirror).collect();
        expected.sort_unstable();
        expected.dedup();
        let expected: Vec<_> =
            expected.into_iter().map(|(ones, number)| (ones, BigUint::from(number))).collect();
        assert_eq!(numbers(&two((m, m), Edges::Free), None, 1).unwrap(), expected);
    }
    let eight = numbers(&two((8, 8), Edges::Free), None, 1).unwrap();
    assert_eq!((eight[0].0, eight[eight.len() - 1].0), (21, 43));
    assert_eq!(eight.iter().map(|(_, number)| number).sum::<BigUint>(), FREE[7][7].into());
    let torus = numbers(&two((6, 6), Edges::Torus), None, 0).unwrap();
    assert_eq!(torus.iter().map(|(_, number)| number).sum::<BigUint>(), TORUS[3][3].into());
}
