//! Round trips of any packing in every format, and what becomes of damaged files.

use crate::{input, written};
use proptest::prelude::*;
use serde_json::{Value, json};
use tilepack::store::{
    Claim, Input, Layout, StoreError, read_pins, read_solution, read_tile_set, solutions,
    write_grid, write_solution, write_tile_set,
};
use tilepack::tiles::{Color, Colors, Kind, Members, TileSet};
use tilepack::torus::{Lattice, Packing, Shape};
use tilepack::verify::check;

/// Any tiles, claimed to be any set.
fn packings() -> impl Strategy<Value = Packing> {
    let kinds = prop::sample::select(vec![Kind::Corner, Kind::Wang, Kind::Domino]);
    let sizes = (kinds, 1..=12u64, 1..=12u64, 1..=5u64, 1..=5u64, any::<bool>());
    sizes
        .prop_flat_map(|(kind, h, v, width, height, cover)| {
            let (width, height) = if kind == Kind::Domino { (width, 1) } else { (width, height) };
            let shape =
                if v % 2 == 0 { Shape::new(width, height) } else { Shape::new(height, width) };
            let shape = shape.unwrap();
            let colors = match kind {
                Kind::Corner => Colors::one(h).unwrap(),
                _ => Colors::pair(h, v).unwrap(),
            };
            let colors = if kind == Kind::Domino { shape.ring_colors(colors) } else { colors };
            let labels = prop::collection::vec(any::<u8>(), 2 * shape.cells());
            let pairs = prop::collection::vec((0..12u8, 0..12u8), 0..4);
            (Just((kind, colors, shape, cover)), labels, 0..4, pairs)
        })
        .prop_map(|((kind, colors, shape, cover), mut labels, members, pairs)| {
            labels.truncate(Lattice { kind, shape }.labels());
            for (i, label) in labels.iter_mut().enumerate() {
                let vertical = kind == Kind::Domino || (kind == Kind::Wang && i % 2 == 1);
                let count = if vertical { colors.vertical() } else { colors.horizontal() };
                *label %= count as u8;
            }
            let all = TileSet::new(kind, colors, Members::Complete).unwrap();
            let mut packing = Lattice { kind, shape }.packing(&labels, &all, cover);
            let mut used = packing.tiles.clone();
            used.sort_unstable();
            used.dedup();
            let pairs = pairs.into_iter().map(|(a, b)| (Color(a), Color(b))).collect();
            let members = match members {
                0 => Members::Complete,
                1 => Members::Compact,
                2 => Members::Pruned(pairs),
                _ => Members::Explicit(used),
            };
            packing.set = TileSet::new(kind, colors, members).unwrap_or(all);
            packing
        })
}

/// A file in every format, all about the same packing.
fn all_formats(packing: &Packing) -> [Vec<u8>; 4] {
    let note = json!({"method": "test", "é": [1, null, "\n"]});
    let explicit = Members::Explicit({
        let mut tiles = packing.tiles.clone();
        tiles.sort_unstable();
        tiles.dedup();
        tiles
    });
    let set = TileSet::new(packing.set.kind(), packing.set.colors(), explicit).unwrap();
    [
        written(|out| write_solution(out, packing, &note, Layout::Pretty)),
        written(|out| write_solution(out, packing, &note, Layout::Line)),
        written(|out| write_grid(out, packing)),
        written(|out| write_tile_set(out, &set, Some("a \"set\""), None)),
    ]
}

/// Reads bytes as everything they could be. An error must name the file and say something.
fn read_as_anything(bytes: Vec<u8>, packing: &Packing) -> Result<(), TestCaseError> {
    let told = |error: StoreError| {
        let message = error.to_string();
        prop_assert!(message.len() > "fuzz: ".len() && message.starts_with("fuzz"), "{}", message);
        prop_assert!(!message.contains(char::is_control), "{}", message);
        Ok(())
    };
    let input = match Input::from_bytes("fuzz", bytes) {
        Ok(input) => input,
        Err(error) => return told(error),
    };
    let claim = Claim {
        kind: Some(packing.set.kind()),
        colors: Some(packing.set.colors()),
        ..Claim::default()
    };
    for claim in [Claim::default(), claim] {
        for solution in solutions(&input, &claim) {
            match solution {
                Ok(solution) => drop(check(&solution.packing)),
                Err(error) => told(error)?,
            }
        }
    }
    let lattice = Lattice { kind: packing.set.kind(), shape: packing.shape };
    read_pins(&input, lattice, &packing.set).map(drop).or_else(told)?;
    read_tile_set(&input, None).map(drop).or_else(told)?;
    read_tile_set(&input, Some(packing.set.colors())).map(drop).or_else(told)
}

#[derive(Debug, Clone)]
enum Damage {
    Flip(prop::sample::Index, u8),
    Replace(prop::sample::Index, u8),
    Delete(prop::sample::Index, usize),
    Insert(prop::sample::Index, Vec<u8>),
    Truncate(prop::sample::Index),
}

fn damages() -> impl Strategy<Value = Damage> {
    let at = any::<prop::sample::Index>;
    // Bytes that mean something in one of the formats find more than any bytes do.
    let telling =
        prop::sample::select(b"{}[],:\"\\.#=- \n\r\t0123456789eEntfabk\xef\xbb\xbf".to_vec());
    prop_oneof![
        (at(), 0..8u8).prop_map(|(at, bit)| Damage::Flip(at, bit)),
        (at(), telling.clone()).prop_map(|(at, byte)| Damage::Replace(at, byte)),
        (at(), 1..9usize).prop_map(|(at, count)| Damage::Delete(at, count)),
        (at(), prop::collection::vec(telling, 1..4)).prop_map(|(at, new)| Damage::Insert(at, new)),
        at().prop_map(Damage::Truncate),
    ]
}

fn damage(bytes: &mut Vec<u8>, damage: Damage) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match damage {
        Damage::Flip(at, bit) => bytes[at.index(length)] ^= 1 << bit,
        Damage::Replace(at, byte) => bytes[at.index(length)] = byte,
        Damage::Delete(at, count) => {
            let at = at.index(length);
            drop(bytes.drain(at..(at + count).min(length)));
        }
        Damage::Insert(at, new) => {
            let at = at.index(length);
            drop(bytes.splice(at..at, new));
        }
        Damage::Truncate(at) => bytes.truncate(at.index(length)),
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000, failure_persistence: None, ..ProptestConfig::default()
    })]

    #[test]
    fn what_is_written_is_read_again(packing in packings()) {
        let [pretty, line, grid, set] = all_formats(&packing);
        prop_assert_eq!(all_formats(&packing), [pretty.clone(), line.clone(), grid.clone(), set.clone()]);
        prop_assert_eq!(line.iter().filter(|&&byte| byte == b'\n').count(), 1);
        for (bytes, provenance) in [(pretty, true), (line, true), (grid, false)] {
            let input = Input::from_bytes("file", bytes).unwrap();
            let solution = read_solution(&input, &Claim::default()).unwrap();
            prop_assert_eq!(&solution.packing, &packing);
            prop_assert_eq!(solution.provenance == Value::Null, !provenance);
        }
        let read = read_tile_set(&Input::from_bytes("file", set).unwrap(), None).unwrap();
        prop_assert_eq!(read.set.colors(), packing.set.colors());
        prop_assert!(packing.tiles.iter().all(|&tile| read.set.allows(tile)));
        prop_assert!(read.set.allowed().all(|tile| packing.tiles.contains(&tile)));
        prop_assert_eq!((read.name.as_deref(), read.source), (Some("a \"set\""), None));
    }

    #[test]
    fn lists_are_read_one_by_one(packings in prop::collection::vec(packings(), 0..6)) {
        let mut list = Vec::new();
        for packing in &packings {
            write_solution(&mut list, packing, &Value::Null, Layout::Line).unwrap();
        }
        let input = Input::from_bytes("list", list).unwrap();
        let claim = Claim::default();
        if !packings.is_empty() {
            let read: Vec<_> = solutions(&input, &claim).map(Result::unwrap).collect();
            prop_assert!(read.iter().enumerate().all(|(i, solution)| solution.line == i + 1));
            prop_assert_eq!(read.into_iter().map(|s| s.packing).collect::<Vec<_>>(), packings);
        }
    }

    #[test]
    fn a_solution_pins_all_of_its_labels(packing in packings()) {
        let mut packing = packing;
        packing.set =
            TileSet::new(packing.set.kind(), packing.set.colors(), Members::Complete).unwrap();
        let lattice = Lattice { kind: packing.set.kind(), shape: packing.shape };
        let labels = Lattice::labels_of(&packing).unwrap();
        for bytes in &all_formats(&packing)[..3] {
            let input = Input::from_bytes("pins", bytes.clone()).unwrap();
            let pins = read_pins(&input, lattice, &packing.set).unwrap();
            let pinned: Vec<u8> = pins.labels().iter().map(|label| label.unwrap()).collect();
            prop_assert_eq!(&pinned, &labels);
        }
    }

    #[test]
    fn damaged_files_give_an_error_or_a_packing(
        packing in packings(),
        format in 0..4usize,
        damages in prop::collection::vec(damages(), 1..4),
    ) {
        let mut bytes = all_formats(&packing)[format].clone();
        for one in damages {
            damage(&mut bytes, one);
        }
        read_as_anything(bytes, &packing)?;
    }

    #[test]
    fn any_bytes_give_an_error_or_a_packing(
        packing in packings(),
        bytes in prop::collection::vec(any::<u8>(), 0..64),
        text in "[{\\[][\\PC\n]{0,40}",
    ) {
        read_as_anything(bytes, &packing)?;
        read_as_anything(text.into_bytes(), &packing)?;
    }
}

#[test]
fn every_truncation_gives_an_error() {
    let text = "kind=wang colors=2\n0 4 5 1\n2 6 7 3\n10 14 15 11\n8 12 13 9\n";
    let packing = read_solution(&input(text), &Claim::default()).unwrap().packing;
    for bytes in &all_formats(&packing)[..2] {
        // All but the newline at the end must be there.
        for length in 0..bytes.len() - 1 {
            let cut = match Input::from_bytes("cut", bytes[..length].to_vec()) {
                Ok(input) => read_solution(&input, &Claim::default()).map(drop),
                Err(error) => Err(error),
            };
            let message = cut.unwrap_err().to_string();
            assert!(message.starts_with("cut:") && message.len() > 6, "{length}: {message}");
        }
    }
}
