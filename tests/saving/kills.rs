//! Killed at random moments, a hundred times.

use crate::{LIST, LISTED, PINS, Place, Random, Run, text};
use std::fs;
use std::time::{Duration, Instant};

/// Kills the program after so long, unless it ends by itself before.
fn kill_after(place: &Place, args: &str, time: Duration) -> Option<Run> {
    let mut child = place.start(args);
    let end = Instant::now() + time;
    while Instant::now() < end {
        if child.try_wait().unwrap().is_some() {
            return Some(Run::of(child.wait_with_output().unwrap()));
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    // SIGKILL where there are signals.
    child.kill().unwrap();
    let output = child.wait_with_output().unwrap();
    match output.status.code() {
        None => None,
        // It ended just before.
        Some(_) => Some(Run::of(output)),
    }
}

/// Runs a search again and again, killed each time, until so many kills; whenever it ends, what
/// it printed is checked and it starts anew.
fn survives(place: &Place, begin: &str, kills: u32, keep: &[&str], check: impl Fn(&Run)) {
    let mut random = Random(17);
    let (mut killed, mut ended, mut in_writing, mut going_on) = (0, 0, 0, 0);
    while killed < kills {
        let threads = 1 + random.below(3);
        let every = [1, 20, 60][random.below(3) as usize];
        let options = format!("--checkpoint x.ck --checkpoint-every {every}ms --threads {threads}");
        let resume = place.path("x.ck").exists() && random.below(2) == 0;
        let args = match resume {
            true => format!("resume {}", options.replace("--checkpoint x.ck", "x.ck --quiet")),
            false => format!("{begin} {options}"),
        };
        let time = Duration::from_millis(20 + random.below(180));
        match kill_after(place, &args, time) {
            None => {
                killed += 1;
                in_writing += u32::from(place.path("x.ck.part").exists());
                going_on += u32::from(place.path("x.ck").exists());
            }
            Some(run) => {
                check(&run);
                ended += 1;
                for file in place.files() {
                    if !keep.contains(&file.as_str()) {
                        fs::remove_file(place.path(&file)).unwrap();
                    }
                }
            }
        }
    }
    if place.path("x.ck").exists() {
        check(&place.run("resume x.ck --quiet"));
        ended += 1;
    }
    println!("{killed} kills, {in_writing} in the middle of writing, {ended} searches ended");
    assert!(ended > 0 && going_on > kills / 3, "{ended} ended, {going_on} saved");
}

/// All rings of the 25 dominoes over five colors, and the nodes that takes.
#[test]
fn a_count_of_several_seconds_killed_a_hundred_times() {
    let place = Place::new();
    survives(&place, "count --kind domino --colors 5 --json --quiet", 100, &[], |run| {
        let object = run.json();
        assert_eq!(run.code, Some(0), "{run:?}");
        assert_eq!(text(&object, "solutions"), "24883200000");
        assert_eq!(text(&object, "nodes"), "533248617");
    });
}

#[test]
fn a_list_killed_again_and_again() {
    let place = Place::new();
    fs::write(place.path("pins.txt"), PINS).unwrap();
    place.run(&format!("{LIST} -o whole.jsonl")).exits(0);
    let whole = fs::read_to_string(place.path("whole.jsonl")).unwrap();
    assert_eq!(whole.lines().count(), LISTED);
    let keep = ["pins.txt", "whole.jsonl"];
    survives(&place, &format!("{LIST} -o list.jsonl --json"), 30, &keep, |run| {
        assert_eq!(run.code, Some(0), "{run:?}");
        assert_eq!(text(&run.json(), "solutions"), LISTED.to_string());
        let list = fs::read_to_string(place.path("list.jsonl")).unwrap();
        assert!(list == whole, "the list is another");
        // No temporary file of a killed process is in the way, and nothing grows without end.
        assert!(place.files().len() < 40, "{:?}", place.files());
    });
}

/// The first packing, and the nodes before it, which are counted exactly across kills.
#[test]
fn a_search_for_the_first_killed_again_and_again() {
    let place = Place::new();
    let find = "find --kind corner --colors 4 --set compact --size 16x8 --json --quiet";
    survives(&place, find, 30, &[], |run| {
        assert_eq!(run.code, Some(0), "{run:?}");
        assert_eq!(text(&run.json(), "nodes"), "43954130");
    });
}
