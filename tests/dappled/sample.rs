//! Random tilings: every tiling has exactly one number, so a random number is a random tiling.

use crate::count::{EDGES, Random};
use crate::oracle;
use num_bigint::BigUint;
use std::collections::BTreeMap;
use tilepack::dappled::count::{MEMORY, Sampler};
use tilepack::dappled::{Edges, FREE, Field, Rule};

/// The tilings with the numbers from 0 on are all tilings, each once.
#[test]
fn numbers_and_tilings_correspond() {
    let mut random = Random(3);
    for edges in EDGES {
        for (size, tiles, across, down) in [
            ((4, 3), 2, Some(2), Some(2)),
            ((3, 4), 2, Some(2), Some(1)),
            ((2, 5), 2, Some(3), None),
            ((3, 2), 3, Some(1), Some(2)),
            ((3, 3), 2, Some(2), Some(2)),
            ((5, 2), 2, None, Some(3)),
        ] {
            let rule = Rule::uniform(size, tiles, edges, across, down).unwrap();
            let cells = (0..size.0 * size.1).map(|_| match random.below(5) {
                0 => random.below(tiles as u64) as u8,
                _ => FREE,
            });
            let given = Field::new(size.0, size.1, cells.collect()).unwrap();
            for given in [None, Some(&given)] {
                let mut expected = oracle::tilings(&rule, given);
                for memory in [MEMORY, 1 << 13] {
                    let Ok(sampler) = Sampler::new(&rule, given, memory) else { continue };
                    assert_eq!(*sampler.total(), BigUint::from(expected.len()));
                    let numbers: Vec<BigUint> = (0..expected.len()).map(BigUint::from).collect();
                    let Ok(mut tilings) = sampler.tilings(&numbers) else { continue };
                    tilings.sort_by(|a, b| a.cells().cmp(b.cells()));
                    expected.sort_by(|a, b| a.cells().cmp(b.cells()));
                    assert!(tilings == expected, "{rule:?}");
                }
            }
        }
    }
}

/// Draws, and whether each of all tilings comes as often as it should: the sum of squares lies
/// where it lies with 99.9 % of all generators.
#[test]
fn all_are_equally_likely() {
    for (size, edges) in [
        ((3, 3), Edges::Free),
        ((3, 3), Edges::Torus),
        ((4, 4), Edges::Torus),
        ((4, 3), Edges::Cylinder),
    ] {
        let rule = Rule::uniform(size, 2, edges, Some(2), Some(2)).unwrap();
        let all = oracle::tilings(&rule, None);
        let sampler = Sampler::new(&rule, None, MEMORY).unwrap();
        let draws = 40 * all.len();
        let drawn = sampler.draw(draws, 5).unwrap();
        let mut often: BTreeMap<&[u8], f64> =
            all.iter().map(|field| (field.cells(), 0.0)).collect();
        for field in &drawn {
            *often.get_mut(field.cells()).unwrap() += 1.0;
        }
        let square: f64 = often.values().map(|often| (often - 40.0) * (often - 40.0) / 40.0).sum();
        let free = (all.len() - 1) as f64;
        assert!(
            (square - free).abs() < 3.3 * (2.0 * free).sqrt() + 5.0,
            "{size:?} {square} {free}"
        );
    }
}

/// Large ones keep the rule, with little memory too, and are those of the same seed.
#[test]
fn large_ones_are_dappled() {
    for (size, edges) in [
        ((7, 40), Edges::Free),
        ((30, 6), Edges::Free),
        ((6, 12), Edges::Cylinder),
        ((6, 7), Edges::Torus),
    ] {
        let rule = Rule::uniform(size, 2, edges, Some(2), Some(2)).unwrap();
        let draw = |memory| {
            let sampler = Sampler::new(&rule, None, memory).unwrap();
            sampler.draw(5, 11).unwrap()
        };
        let drawn = draw(MEMORY);
        assert_eq!(drawn.len(), 5);
        assert!(drawn.iter().all(|field| rule.accepts(field)));
        assert!(drawn == draw(3 << 20));
    }
    let none = Rule::uniform((1, 4), 2, Edges::Cylinder, Some(2), Some(2)).unwrap();
    let sampler = Sampler::new(&none, None, MEMORY).unwrap();
    assert_eq!(sampler.draw(3, 0).unwrap(), []);
}
