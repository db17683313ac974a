//! Signals, another process, another search, another number of threads, another time of day.

use crate::{LIST, PINS, Place, Run, signal, text};
use std::fs;
use std::time::{Duration, Instant};

const COUNT: &str = "count --kind domino --colors 5 --json --quiet --checkpoint x.ck";

/// Ends a search by a signal as soon as it has saved something.
#[cfg(unix)]
fn end(place: &Place, args: &str, name: &str) -> Run {
    let child = place.start(args);
    let begin = Instant::now();
    while !place.path("x.ck").exists() && begin.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    signal(&child, name);
    let begin = Instant::now();
    let run = Run::of(child.wait_with_output().unwrap());
    assert!(begin.elapsed() < Duration::from_secs(1), "{:?}", begin.elapsed());
    run
}

#[cfg(unix)]
#[test]
fn a_signal_saves_what_there_is() {
    for (name, threads) in [("TERM", 1), ("INT", 2), ("HUP", 3)] {
        let place = Place::new();
        let run = end(&place, &format!("{COUNT} --checkpoint-every 50ms"), name).exits(75);
        assert!(run.stderr.contains("stopped early by a signal"), "{run:?}");
        assert!(run.stderr.contains("saved: tilepack resume x.ck"), "{run:?}");
        let object = run.json();
        assert_eq!(text(&object, "checkpoint"), "x.ck");
        // Exactly where it stopped: not a node is searched twice.
        let args = format!("resume x.ck --node-limit 0 --threads {threads} --json");
        let again = place.run(&args).exits(75).json();
        assert_eq!(text(&again, "nodes"), text(&object, "nodes"));
        let done = place.run(&format!("resume x.ck --threads {threads}")).exits(0).json();
        assert_eq!(text(&done, "solutions"), "24883200000");
        assert_eq!(text(&done, "nodes"), "533248617");
        assert_eq!(place.files(), ["x.ck", "x.ck.previous"]);
    }
}

/// The answer of a search that is complete is given again, without another node.
#[test]
fn a_complete_search_answers_again() {
    let place = Place::new();
    let count = "count --kind wang --colors 2 --up-to-symmetry --json --checkpoint x.ck";
    let first = place.run(count).exits(0).json();
    assert_eq!(text(&first, "fundamental"), "538");
    let bytes = fs::read(place.path("x.ck")).unwrap();
    for args in [count, "resume x.ck --json"] {
        let again = place.run(args).exits(0).json();
        assert_eq!(again, first, "also the seconds");
    }
    assert_eq!(fs::read(place.path("x.ck")).unwrap(), bytes);
    let find = "find --kind corner --colors 3 --checkpoint f.ck -o found.json";
    place.run(find).exits(0);
    let found = fs::read(place.path("found.json")).unwrap();
    fs::remove_file(place.path("found.json")).unwrap();
    place.run("resume f.ck").exits(0);
    assert_eq!(fs::read(place.path("found.json")).unwrap(), found, "provenance and all");
    let none = "find --kind corner --colors 4 --set pruned:0-1,2-3 --size 6x10 --checkpoint n.ck";
    place.run(none).exits(1);
    assert_eq!(place.run("resume n.ck").exits(1).stdout, place.run(none).exits(1).stdout);
}

/// Cut into many pieces by limits, by the same command again and again.
#[test]
fn running_again_goes_on() {
    let place = Place::new();
    fs::write(place.path("pins.txt"), PINS).unwrap();
    place.run(&format!("{LIST} -o whole.jsonl")).exits(0);
    let mut pieces = 0;
    loop {
        let threads = 1 + pieces % 3;
        let args = format!(
            "{LIST} -o list.jsonl --json --checkpoint x.ck --node-limit 900000 --threads {threads}"
        );
        let run = place.run(&args);
        pieces += 1;
        match run.code {
            Some(75) => assert_eq!(text(&run.json(), "stopped_by"), "node-limit"),
            _ => {
                run.exits(0);
                break;
            }
        }
        assert!(pieces < 30);
    }
    assert!(pieces >= 6, "{pieces}");
    let read = |file: &str| fs::read(place.path(file)).unwrap();
    assert!(read("list.jsonl") == read("whole.jsonl"));
}

#[test]
fn a_second_process_is_refused() {
    let place = Place::new();
    let args = "count --kind corner --colors 3 --checkpoint x.ck --checkpoint-every 20ms --quiet";
    let mut first = place.start(args);
    while !place.path("x.ck").exists() {
        std::thread::sleep(Duration::from_millis(5));
    }
    for args in [args, "resume x.ck", "count --kind wang --colors 2 --checkpoint x.ck"] {
        let second = place.run(args).exits(2);
        assert!(second.stderr.contains("x.ck: another process is at work on it"), "{second:?}");
        assert_eq!(second.stdout, "");
    }
    first.kill().unwrap();
    first.wait().unwrap();
    // A lock ends with its process, however that ended.
    assert!(place.path("x.ck.lock").exists());
    place.run("resume x.ck --node-limit 1000").exits(75);
    assert!(!place.path("x.ck.lock").exists());
}

#[test]
fn another_search_is_refused_and_its_file_kept() {
    let place = Place::new();
    place.run("count --kind corner --colors 3 --checkpoint x.ck --node-limit 5000").exits(75);
    let bytes = fs::read(place.path("x.ck")).unwrap();
    for other in [
        "count --kind corner --colors 3 --plain",
        "count --kind corner --colors 3 --up-to-symmetry",
        "count --kind corner --colors 3 --order column",
        "count --kind corner --colors 3 --automorphism 3,0:+1",
        "find --kind corner --colors 3",
        "find --kind corner --colors 3 --values random",
        "list --kind corner --colors 3",
        "count --kind wang --colors 2",
    ] {
        let refused = place.run(&format!("{other} --checkpoint x.ck")).exits(2);
        let told =
            "x.ck: holds another search (count: complete corner set over 3 colors, 9x9 torus)";
        assert!(refused.stderr.contains(told), "{other}: {refused:?}");
        assert_eq!(refused.stdout, "", "{other}");
        assert_eq!(fs::read(place.path("x.ck")).unwrap(), bytes, "{other}");
    }
    // Not another search: other limits, threads, and ways of telling.
    let same = "count --kind corner --colors 3 --checkpoint x.ck --threads 2 --json";
    let object = place.run(&format!("{same} --node-limit 5000")).exits(75).json();
    assert_eq!(text(&object, "nodes"), "10000");
}

/// Without a name, a file in the folder of checkpoints that says what it is of.
#[test]
fn a_checkpoint_without_a_name() {
    let place = Place::new();
    let args = "count --kind corner --colors 3 --json --node-limit 4000 --checkpoint";
    let object = place.run(args).exits(75).json();
    let file = text(&object, "checkpoint");
    let (folder, name) = file.split_once('/').unwrap();
    assert_eq!(folder, "checkpoints");
    assert!(name.starts_with("count-corner-3-9x9-") && name.ends_with(".checkpoint"), "{name}");
    let again = place.run(args).exits(75).json();
    assert_eq!((text(&again, "checkpoint"), text(&again, "nodes")), (file.clone(), "8000".into()));
    let other = place.run(&format!("{args} --order column")).exits(75).json();
    assert_ne!(text(&other, "checkpoint"), file);
}

/// The time of day, and that of the files, decide nothing.
#[cfg(unix)]
#[test]
fn clocks_may_be_set_back() {
    let place = Place::new();
    let count = "count --kind corner --colors 3 --json --quiet --checkpoint x.ck --node-limit 3000";
    for (run, date) in [(1, "2001-01-01"), (2, "2099-01-01"), (3, "1980-01-01")] {
        let object = place.run(count).exits(75).json();
        assert_eq!(text(&object, "nodes"), (3000 * run).to_string());
        place.shell(&format!("touch -d {date} x.ck; touch -d 2030-01-01 x.ck.previous")).exits(0);
    }
}
