//! Checkpoints written by earlier versions of the format: they load for ever.
//!
//! `tests/data/checkpoints/v1-*` were written by version 0.1.0 and are never rewritten. As long
//! as the search tree is the same they are also gone on with, to the same totals; should it ever
//! change (`TREE` in `store/job.rs`), they must be refused in words instead.

use crate::{Place, text};
use std::fs;
use std::path::{Path, PathBuf};
use tilepack::store::{Checkpoint, read_job};

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/checkpoints")
}

fn goldens() -> Vec<String> {
    let names = fs::read_dir(data()).unwrap();
    let names = names.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".checkpoint")).collect();
    names.sort();
    names
}

#[test]
fn all_of_them_load() {
    assert_eq!(goldens(), ["v1-count.checkpoint", "v1-find.checkpoint", "v1-list.checkpoint"]);
    for name in goldens() {
        let file = data().join(&name);
        let checkpoint = Checkpoint::from_bytes(&file, &fs::read(&file).unwrap()).unwrap();
        assert!(!checkpoint.standing.is_complete(), "{name}");
        assert!(checkpoint.standing.state.nodes > 0, "{name}");
        let job = read_job(&checkpoint.job).unwrap();
        let word = name.trim_start_matches("v1-").split('.').next().unwrap();
        assert!(checkpoint.job.contains(&format!("\"question\":\"{}\"", question(word))), "{name}");
        assert_eq!(job.is_list(), word == "list");
        assert_eq!(checkpoint.kept.is_some(), word == "list");
    }
}

fn question(word: &str) -> &str {
    if word == "find" { "first" } else { word }
}

#[test]
fn all_of_them_are_gone_on_with() {
    for (name, solutions, nodes) in [
        ("v1-count", Some("203520"), "537503"),
        ("v1-find", None, "260513"),
        ("v1-list", Some("303264"), "1594475"),
    ] {
        let place = Place::new();
        for end in [".checkpoint", ".checkpoint.packings"] {
            let file = data().join(format!("{name}{end}"));
            if file.exists() {
                fs::copy(
                    file,
                    place.path(&format!("x.ck{}", end.trim_start_matches(".checkpoint"))),
                )
                .unwrap();
            }
        }
        let object = place.run("resume x.ck --json -o out").exits(0).json();
        assert_eq!(text(&object, "nodes"), nodes, "{name}");
        if let Some(solutions) = solutions {
            assert_eq!(text(&object, "solutions"), solutions, "{name}");
        }
    }
}

/// Reads values as `checkpoints/README.md` describes them.
struct Values<'a>(&'a [u8]);

impl<'a> Values<'a> {
    fn bytes(&mut self, count: u64) -> &'a [u8] {
        let (bytes, rest) = self.0.split_at(count as usize);
        self.0 = rest;
        bytes
    }

    fn number(&mut self) -> u64 {
        let wide = match self.bytes(1)[0] {
            251 => 2,
            252 => 4,
            253 => 8,
            small => return small.into(),
        };
        self.bytes(wide).iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
    }

    fn text(&mut self) -> String {
        let length = self.number();
        String::from_utf8(self.bytes(length).to_vec()).unwrap()
    }

    fn list<T>(&mut self, item: impl Fn(&mut Self) -> T) -> Vec<T> {
        (0..self.number()).map(|_| item(self)).collect()
    }

    fn numbers(&mut self) -> Vec<u64> {
        self.list(Self::number)
    }

    fn option<T>(&mut self, item: impl Fn(&mut Self) -> T) -> Option<T> {
        (self.bytes(1)[0] == 1).then(|| item(self))
    }
}

#[test]
fn the_format_is_the_documented_one() {
    for name in goldens() {
        let file = data().join(&name);
        let bytes = fs::read(&file).unwrap();
        let read = Checkpoint::from_bytes(&file, &bytes).unwrap();
        let (frame, hash) = bytes.split_at(bytes.len() - 32);
        assert_eq!(hash, blake3::hash(frame).as_bytes());
        assert_eq!(&frame[..12], b"TILEPACK\x01\0\x01\0");
        assert_eq!(frame[12..20], (frame.len() as u64 - 52).to_le_bytes());
        assert_eq!(&frame[20..52], blake3::hash(read.job.as_bytes()).as_bytes());
        let mut values = Values(&frame[52..]);
        assert_eq!(values.number(), read.generation);
        assert_eq!((values.text(), values.text()), (read.job, read.request));
        let state = &read.standing.state;
        assert_eq!((values.number(), values.number()), (state.nodes, state.solutions));
        assert_eq!(values.number() as usize, state.deepest);
        assert_eq!(values.number() as usize, read.standing.levels);
        assert_eq!(u128::from(values.number()), state.elapsed.as_nanos());
        assert_eq!(values.number(), read.standing.orbits);
        let sizes: Vec<u8> = values.list(|values| values.bytes(1)[0]);
        assert_eq!(sizes, read.standing.orbit_sizes.to_bytes_le());
        let paths = values.list(|values| {
            let choices = values.numbers();
            (choices, values.list(Values::numbers))
        });
        for ((choices, left), path) in paths.into_iter().zip(&state.left) {
            assert!(choices.into_iter().eq(path.choices.iter().copied().map(u64::from)));
            for (gaps, numbers) in left.into_iter().zip(&path.left) {
                let sums = gaps.into_iter().scan(0, |sum, gap| {
                    *sum += gap;
                    Some(*sum)
                });
                assert!(sums.eq(numbers.iter().copied().map(u64::from)));
            }
        }
        let best = values.option(|values| (values.numbers(), values.text()));
        assert_eq!(best.is_some(), state.best.is_some());
        let records = values.list(|values| {
            let start = values.numbers();
            (start, values.number(), values.number(), values.number())
        });
        let nodes: Vec<u64> = records.into_iter().map(|record| record.1).collect();
        assert!(nodes.into_iter().eq(state.records.iter().map(|record| record.nodes)));
        let kept = values.option(|values| (values.number(), values.bytes(32).to_vec()));
        assert_eq!(kept, read.kept.map(|kept| (kept.length, kept.hash.to_vec())));
        assert!(values.0.is_empty(), "{name}");
    }
}
