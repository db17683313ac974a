//! Published aperiodic sets: undecided, and recognized in any guise.

use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::fs;
use tilepack::aperiodic::Set;
use tilepack::aperiodic::decide::{Bounds, SYMMETRIES, Verdict, decide, likeness, wang};
use tilepack::tiles::Kind;
use tilepack::verify::{Claim, check_claim};

fn sets() -> Vec<(String, Set)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/aperiodic");
    let mut sets = Vec::new();
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.is_dir() {
            continue;
        }
        let json: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if json["kind"] != "wang" {
            continue;
        }
        let tiles = serde_json::from_value(json["tiles"].clone()).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        sets.push((name, Set::new(Kind::Wang, tiles).unwrap()));
    }
    sets.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(sets.len() >= 7);
    sets
}

/// With other names of labels, turned or reflected, in another order.
fn disguised(set: &Set, random: &mut Pcg64Mcg) -> Set {
    let sides = SYMMETRIES[random.random_range(0..8)];
    let mut names: [Vec<u32>; 2] = std::array::from_fn(|_| (0..40).collect());
    names.iter_mut().for_each(|names| names.shuffle(random));
    let renamed = |tile: &[u32; 4]| {
        let tile: [u32; 4] = std::array::from_fn(|i| names[i % 2][tile[i] as usize]);
        sides.map(|side| tile[side])
    };
    let mut tiles: Vec<[u32; 4]> = set.tiles().iter().map(renamed).collect();
    tiles.shuffle(random);
    Set::new(Kind::Wang, tiles).unwrap()
}

#[test]
fn they_stay_undecided() {
    let bounds = Bounds { limit: 5, arcs: 1 << 16, ..Bounds::default() };
    for (name, set) in sets() {
        let verdict = decide(&wang(&set), &bounds, &());
        assert!(matches!(verdict, Verdict::Undecided(_)), "{name}: {verdict:?}");
    }
}

#[test]
fn they_are_recognized_in_any_guise() {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let sets = sets();
    for (name, set) in &sets {
        for _ in 0..6 {
            let guise = disguised(set, &mut random);
            let like = likeness(&guise, set).unwrap_or_else(|| panic!("{name}"));
            let (other, sides) = (set.tiles().to_vec(), like.sides);
            let claim = Claim::Like { other, sides, images: like.tiles };
            assert_eq!(check_claim(Kind::Wang, guise.tiles(), &claim, 0), Ok(()), "{name}");
            // No other symmetry and no other images will do.
            let Claim::Like { other, sides, images } = claim else { panic!() };
            let refused = |sides, images: &[usize]| {
                let claim = Claim::Like { other: other.clone(), sides, images: images.to_vec() };
                check_claim(Kind::Wang, guise.tiles(), &claim, 0).is_err()
            };
            for turned in SYMMETRIES.into_iter().filter(|turned| *turned != sides) {
                assert!(refused(turned, &images), "{name}");
            }
            assert!(refused([0, 2, 1, 3], &images) && refused([4, 5, 6, 7], &images));
            let mut swapped = images.clone();
            let pair: [usize; 2] = std::array::from_fn(|i| (random.random_range(0..5) * 2) + i);
            swapped.swap(pair[0], pair[1]);
            assert!(refused(sides, &swapped), "{name}");
            swapped[pair[0]] = swapped[pair[1]];
            assert!(refused(sides, &swapped) && refused(sides, &images[1..]), "{name}");
            // With one label of one tile changed it is another set.
            let mut tiles = guise.tiles().to_vec();
            let (tile, side) = (random.random_range(0..tiles.len()), random.random_range(0..4));
            tiles[tile][side] = 99;
            let changed = Set::new(Kind::Wang, tiles).unwrap();
            assert_eq!(likeness(&changed, set), None, "{name}");
        }
        for (other, another) in &sets {
            assert_eq!(likeness(set, another).is_some(), name == other, "{name} {other}");
        }
    }
}
