//! Damaged and foreign checkpoints: named, refused, never believed, never overwritten.

use crate::{LIST, LISTED, PINS, Place, text};
use std::fs;
use std::path::Path;
use tilepack::packing::{Job, Question, Settings, Task, run};
use tilepack::search::{Limits, Trail};
use tilepack::store::{Checkpoint, StoreError, fingerprint, write_job};
use tilepack::tiles::{Colors, Kind, Members, TileSet};
use tilepack::torus::Shape;

const COUNT: &str = "count --kind wang --colors 2 --json --quiet --checkpoint x.ck";

/// A folder with a search under way, and its checkpoint.
fn begun(pieces: u64) -> (Place, Vec<u8>) {
    let place = Place::new();
    for _ in 0..pieces {
        place.run(&format!("{COUNT} --node-limit 100000 --threads 2")).exits(75);
    }
    let bytes = fs::read(place.path("x.ck")).unwrap();
    (place, bytes)
}

/// Without an older one, a file in which a bit is wrong is refused.
#[test]
fn every_bit_of_a_checkpoint_matters() {
    let (place, whole) = begun(1);
    let file = place.path("x.ck");
    fs::remove_file(place.path("x.ck.previous")).unwrap_or_default();
    for bit in 0..8 * whole.len() {
        let mut bytes = whole.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let error = Checkpoint::from_bytes(&file, &bytes).unwrap_err();
        assert_eq!(error.file(), file, "bit {bit}");
        // The program itself: every byte, one bit of it.
        if bit % 8 == bit / 8 % 8 {
            fs::write(&file, &bytes).unwrap();
            for args in [COUNT, "resume x.ck"].iter().take(1 + usize::from(bit % 64 == 0)) {
                let run = place.run(args).exits(2);
                let named = run.stderr.starts_with("tilepack: x.ck: ");
                assert!(named && !run.stderr.contains("panicked"), "bit {bit}: {run:?}");
                assert_eq!(run.stdout, "", "bit {bit}");
                assert_eq!(fs::read(&file).unwrap(), bytes, "never overwritten");
            }
        }
    }
    assert_eq!(place.files(), ["x.ck"]);
    fs::write(&file, &whole).unwrap();
    let object = place.run(COUNT).exits(0).json();
    assert_eq!((text(&object, "solutions"), text(&object, "nodes")), totals());
}

fn totals() -> (String, String) {
    ("203520".into(), "537503".into())
}

/// With an older one, the search goes on from that, and says so.
#[test]
fn a_damaged_checkpoint_is_set_aside_and_the_one_before_taken() {
    let (place, whole) = begun(3);
    let older = fs::read(place.path("x.ck.previous")).unwrap();
    let damages: [(&str, Vec<u8>); 5] = [
        ("empty", Vec::new()),
        ("cut short", whole[..whole.len() / 2].to_vec()),
        ("longer", [&whole[..], b"and more"].concat()),
        ("flipped", whole.iter().map(|byte| byte ^ 4).collect()),
        ("another file", b"{\"format\":\"tilepack/1\"}".to_vec()),
    ];
    for (round, (what, bytes)) in damages.into_iter().enumerate() {
        fs::write(place.path("x.ck"), &bytes).unwrap();
        fs::write(place.path("x.ck.previous"), &older).unwrap();
        let args = if round % 2 == 0 { COUNT } else { "resume x.ck --json --quiet" };
        let run = place.run(args).exits(0);
        let aside = format!("x.ck.damaged-{}", round + 1);
        let told = format!("(kept as {aside}); going on from the one before it");
        assert!(run.stderr.contains("warning: x.ck: "), "{what}: {run:?}");
        assert!(run.stderr.contains(&told), "{what}: {run:?}");
        let object = run.json();
        assert_eq!((text(&object, "solutions"), text(&object, "nodes")), totals(), "{what}");
        assert_eq!(fs::read(place.path(&aside)).unwrap(), bytes, "{what}");
    }
    // The same when a process was killed between two names.
    fs::remove_file(place.path("x.ck")).unwrap();
    fs::write(place.path("x.ck.previous"), &older).unwrap();
    fs::write(place.path("x.ck.part"), &whole[..40]).unwrap();
    let run = place.run(COUNT).exits(0);
    assert!(run.stderr.contains("warning: x.ck: no such file; going on from"), "{run:?}");
    assert_eq!((text(&run.json(), "solutions"), text(&run.json(), "nodes")), totals());
    assert!(!place.path("x.ck.part").exists());
}

/// The packings of a list are in a file of their own; its beginning must be what it was.
#[test]
fn the_file_of_packings_is_checked() {
    let place = Place::new();
    fs::write(place.path("pins.txt"), PINS).unwrap();
    let args = format!("{LIST} -o list.jsonl --json --checkpoint x.ck");
    place.run(&format!("{args} --node-limit 3000000")).exits(75);
    let packings = fs::read(place.path("x.ck.packings")).unwrap();
    assert!(packings.len() > 81 * 100);
    let flipped: Vec<u8> = [&packings[..5000], &[packings[5000] ^ 1], &packings[5001..]].concat();
    for bytes in [&packings[..packings.len() - 1], &packings[..0], &flipped] {
        fs::write(place.path("x.ck.packings"), bytes).unwrap();
        let run = place.run(&args).exits(2);
        assert!(run.stderr.contains("x.ck.packings: does not hold the packings"), "{run:?}");
    }
    fs::remove_file(place.path("x.ck.packings")).unwrap();
    let run = place.run(&args).exits(2);
    assert!(run.stderr.contains("x.ck.packings: no such file"), "{run:?}");
    // What was written after the checkpoint will be met again.
    fs::write(place.path("x.ck.packings"), [&packings[..], &[7; 1000]].concat()).unwrap();
    let object = place.run(&args).exits(0).json();
    assert_eq!(text(&object, "solutions"), LISTED.to_string());
}

fn job() -> Job {
    let set = TileSet::new(Kind::Corner, Colors::one(3).unwrap(), Members::Complete).unwrap();
    let task = Task::new(set, Shape::new(9, 9).unwrap());
    Job::new(task, Question::Count { up_to_symmetry: false })
}

/// A checkpoint whose checksum is right and whose content is not.
#[test]
fn content_is_not_believed() {
    let job = job();
    let limits = Limits { nodes: 100_000, ..Limits::NONE };
    let standing = run(&job, None, &Settings { limits, threads: 2, ..Settings::PLAIN }).unwrap();
    let honest = Checkpoint {
        generation: 0,
        job: write_job(&job),
        request: String::new(),
        standing,
        kept: None,
    };
    let again = Checkpoint::from_bytes(Path::new("x"), &honest.bytes().unwrap()).unwrap();
    assert_eq!(again, honest);
    let place = Place::new();
    let refused = |change: &dyn Fn(&mut Checkpoint), told: &str| {
        let mut false_one = honest.clone();
        change(&mut false_one);
        fs::write(place.path("x.ck"), false_one.bytes().unwrap()).unwrap();
        let run = place.run("resume x.ck --node-limit 10").exits(2);
        assert!(run.stderr.contains(told), "{told}: {run:?}");
        fs::remove_file(place.path("x.ck")).unwrap();
    };
    let misfit = "what was saved does not fit this search: ";
    // Which of two threads got how far is chance: the path that went furthest is the one spoilt.
    let spoilt = |change: &dyn Fn(&mut Trail)| {
        refused(
            &|c| change(c.standing.state.left.iter_mut().max_by_key(|t| t.left.len()).unwrap()),
            misfit,
        );
    };
    spoilt(&|t| t.choices[4] = 77);
    spoilt(&|t| t.left[3] = vec![0, 1, 2]);
    spoilt(&|t| t.left[3] = vec![2, 1]);
    spoilt(&|t| t.left[3] = vec![64_000]);
    spoilt(&|t| drop(t.left.pop()));
    spoilt(&|t| t.choices.extend([0; 100]));
    refused(&|c| c.job = c.job.replace("\"tree\":1", "\"tree\":99"), "is of version 99");
    refused(&|c| c.job = c.job.replace("9x9", "9x8"), "x.ck: ");
    refused(&|c| c.job = c.job.replace("\"3\"", "\"300\""), "x.ck: ");
    refused(&|c| c.job = c.job.replace(":", ": "), "x.ck: ");
    refused(&|c| c.job = "{".into(), "x.ck: ");
    let list = |c: &mut Checkpoint| c.job = c.job.replace("\"count\"", "\"list\"");
    refused(&list, "x.ck: does not say which packings it met");
}

/// The hash of the search stands in the frame, and must be that of the search inside.
#[test]
fn the_fingerprint_is_that_of_the_search() {
    let text = write_job(&job());
    let (place, mut bytes) = begun(1);
    bytes[20..52].copy_from_slice(&fingerprint(&text));
    let end = bytes.len() - 32;
    let hash = blake3::hash(&bytes[..end]);
    bytes[end..].copy_from_slice(hash.as_bytes());
    let error = Checkpoint::from_bytes(&place.path("x.ck"), &bytes).unwrap_err();
    assert!(matches!(error, StoreError::Content { .. }), "{error}");
    // A newer format is named as such.
    bytes[8] = 2;
    let hash = blake3::hash(&bytes[..end]);
    bytes[end..].copy_from_slice(hash.as_bytes());
    let error = Checkpoint::from_bytes(&place.path("x.ck"), &bytes).unwrap_err().to_string();
    let told = "version 2 of the format; this program reads up to version 1";
    assert!(error.contains(told), "{error}");
    // It is no damage: neither set aside nor passed over for the one before it.
    fs::copy(place.path("x.ck"), place.path("x.ck.previous")).unwrap();
    fs::write(place.path("x.ck"), &bytes).unwrap();
    for args in [COUNT, "resume x.ck"] {
        let run = place.run(args).exits(2);
        assert!(run.stderr.contains(told), "{run:?}");
    }
    assert_eq!(place.files(), ["x.ck", "x.ck.previous"]);
}
