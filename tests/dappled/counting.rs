//! `dapple count` and `dapple sample` as they are met: output, files, stops, damage.

use serde_json::{Value, json};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

struct Place(TempDir);

struct Run {
    code: i32,
    stdout: String,
    stderr: String,
}

impl Place {
    fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn write(&self, file: &str, text: &str) {
        fs::write(self.path(file), text).unwrap();
    }

    fn command(&self, args: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("tilepack"));
        command.current_dir(self.0.path()).arg("dapple").args(args.split_whitespace());
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    #[track_caller]
    fn run(&self, args: &str, code: i32) -> Run {
        let run = Run::of(self.command(args).output().unwrap());
        assert_eq!(run.code, code, "{args}: {} {}", run.stdout, run.stderr);
        run
    }

    #[track_caller]
    fn resume(&self, args: &str, code: i32) -> Run {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("tilepack"));
        command.current_dir(self.0.path()).arg("resume").args(args.split_whitespace());
        let run = Run::of(command.output().unwrap());
        assert_eq!(run.code, code, "{args}: {} {}", run.stdout, run.stderr);
        run
    }
}

impl Run {
    fn of(output: Output) -> Self {
        Self {
            code: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    #[track_caller]
    fn json(&self) -> Value {
        let object = serde_json::from_str(&self.stdout);
        object.unwrap_or_else(|error| panic!("{error}: {} {}", self.stdout, self.stderr))
    }
}

#[test]
fn a_count_says_what_it_counted() {
    let place = Place::new();
    let run = place.run("count --size 4x4", 0);
    assert!(run.stdout.starts_with("2030 dappled tilings\n4x4, 2 tiles, limits 2,2, free edges; "));
    assert_eq!(run.stderr, "");
    let run = place.run("count --size 4x4 --by-number 0", 0);
    assert!(run.stdout.contains("\n4 with tile 0 5 times\n82 with tile 0 6 times\n"));
    let run = place.run("count --size 4x4 --by-number --json", 0).json();
    assert_eq!(run["by_number"]["tile"], 1);
    assert_eq!(run["by_number"]["numbers"][0], json!([5, "4"]));
    assert_eq!((&run["result"], &run["tilings"]), (&json!("counted"), &json!("2030")));
    let run = place.run("count --size 5x3 --cyclic --threads 1 --json", 0).json();
    assert_eq!((&run["edges"], &run["tilings"]), (&json!("torus"), &json!("390")));
    let run = place.run("count --size 4x1 --cylinder", 0);
    assert!(run.stdout.starts_with("6 dappled"));
    let run = place.run("count --size 1x4 --cylinder", 1);
    assert!(run.stdout.starts_with("0 dappled"));
    place.write("given.txt", "0...\n....\n...1\n");
    place.write("map.txt", "1 2 2 2\n2 2 2 2\n2 2 inf 2\n");
    let run = place.run("count --size 4x3 --given given.txt --limits 2,@map.txt --json", 0).json();
    let least: u64 = run["tilings"].as_str().unwrap().parse().unwrap();
    assert!((50..378).contains(&least), "{least}");
}

#[test]
fn bad_input_is_named() {
    let place = Place::new();
    place.write("given.txt", "0..\n..2\n");
    place.write("small.txt", "0..\n");
    for (args, message) in [
        ("count --size 4", "--size: size '4': expected WxH"),
        ("count --size 0x4", "both sides must be at least 1"),
        ("count --size 3x2 --given given.txt", "given.txt:2:3: '2': expected a tile below 2"),
        ("count --size 3x2 --given small.txt", "small.txt: 3x1 cells, expected 3x2"),
        ("count --size 3x2 --given none.txt", "none.txt: no such file"),
        ("count --size 3x2 --by-number 2", "--by-number 2: expected a tile below 2"),
        ("count --size 3x2 --limits 0,2", "--limits '0,2': a limit of 0"),
        ("count --size 20x20", "20x20, 2 tiles, limits 2,2, free edges: counting needs about"),
        ("count --size 200x200", "counting needs about"),
        (
            "count --size 14x14 --memory 20MiB",
            "MiB of memory (3 million states), --memory allows 20 MiB",
        ),
        ("count --size 9x9 --memory 4", "states), --memory allows 1 KiB"),
        ("count --size 4x9 --cyclic --memory 4", "KiB of memory, the limit is 1 KiB (--memory)"),
        ("count --size 8x8 --memory 4x", "expected a number and a unit"),
        ("count --size 3x3 --checkpoint no/where", "no/where"),
        ("sample --size 16x200", "drawing needs about"),
        ("sample --size 10x30 --memory 3MiB", "--memory"),
        ("sample --size 3x3 --number 2 -o a.png", "a picture holds one tiling"),
        ("sample --size 3x3 -o no/where.txt", "no/where.txt"),
    ] {
        let run = place.run(args, 2);
        assert!(run.stderr.contains(message), "{args}: {}", run.stderr);
        assert_eq!(run.stdout, "");
    }
    assert!(!place.path("no").exists());
}

#[test]
fn tilings_are_drawn_and_written() {
    let place = Place::new();
    let one = place.run("sample --size 7x5 --seed 3", 0);
    assert_eq!(one.stdout.lines().count(), 5);
    assert!(one.stderr.contains("one of 2699464 dappled tilings"), "{}", one.stderr);
    assert_eq!(one.stdout, place.run("sample --size 7x5 --seed 3 --threads 1", 0).stdout);
    assert_ne!(one.stdout, place.run("sample --size 7x5 --seed 4", 0).stdout);
    place.run("sample --size 7x5 --seed 3 -o one.txt", 0);
    place.run("check one.txt", 0);
    place.run("sample --size 6x9 --cyclic -o torus.png", 0);
    place.run("check torus.png --cyclic", 0);
    let three = place.run("sample --size 4x3 --number 3", 0).stdout;
    assert_eq!(three.lines().filter(|line| line.starts_with('#')).count(), 3);
    let object = place.run("sample --size 4x3 --number 2 --json", 0).json();
    assert_eq!((&object["of"], object["tilings"].as_array().unwrap().len()), (&json!("378"), 2));
    let none = place.run("sample --size 1x4 --cylinder", 1);
    assert!(none.stdout.starts_with("none: "));
}

const COUNT: &str = "count --size 9x9 --quiet --json --checkpoint c.ck";
const NUMBER: &str = "43680343039806";

/// Stopped again and again by the time limit, it ends with the number.
#[test]
fn a_stopped_count_goes_on() {
    let place = Place::new();
    let (mut stops, mut done) = (0, 0);
    for round in 0..200 {
        let time = 1 + 20 * round;
        let run = match place.path("c.ck").exists() && round % 2 == 1 {
            true => {
                let mut command = Command::new(assert_cmd::cargo::cargo_bin!("tilepack"));
                command.current_dir(place.0.path()).args(["resume", "c.ck", "--quiet"]);
                Run::of(command.args(["--time-limit", &format!("{time}ms")]).output().unwrap())
            }
            false => {
                Run::of(place.command(&format!("{COUNT} --time-limit {time}ms")).output().unwrap())
            }
        };
        let object = run.json();
        if run.code == 0 {
            assert_eq!(object["tilings"], NUMBER);
            done += 1;
            break;
        }
        assert_eq!((run.code, &object["result"]), (75, &json!("stopped")), "{}", run.stderr);
        assert!(run.stderr.contains("stopped early by the time limit"), "{}", run.stderr);
        assert!(run.stderr.contains("saved: tilepack resume c.ck"));
        stops += 1;
    }
    assert!(stops > 0 && done == 1, "{stops}");
    // One that is done gives its answer again.
    assert_eq!(place.resume("c.ck", 0).json()["tilings"], NUMBER);
}

/// Killed at any moment, it loses only what was done since the last checkpoint.
#[test]
fn a_killed_count_goes_on() {
    let place = Place::new();
    let mut kills = 0;
    let begin = Instant::now();
    loop {
        let every = if kills % 2 == 0 { "1ms" } else { "5ms" };
        let args = format!("{COUNT} --threads 2 --checkpoint-every {every}");
        let mut child = place.command(&args).spawn().unwrap();
        let patience = Duration::from_millis(10 + 9 * kills);
        let end = Instant::now() + patience;
        while Instant::now() < end && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        let killed = child.try_wait().unwrap().is_none();
        child.kill().unwrap();
        let run = Run::of(child.wait_with_output().unwrap());
        if !killed || run.code == 0 {
            assert_eq!(run.code, 0, "{}", run.stderr);
            assert_eq!(run.json()["tilings"], NUMBER);
            break;
        }
        kills += 1;
        assert!(begin.elapsed() < Duration::from_secs(60));
    }
    assert!(kills > 0);
}

#[test]
fn damage_and_others_are_refused() {
    let place = Place::new();
    place.run(&format!("{COUNT} --time-limit 30ms --checkpoint-every 1ms"), 75);
    let whole = fs::read(place.path("c.ck")).unwrap();
    // Another count, or a search.
    let run = place.run("count --size 9x8 --checkpoint c.ck", 2);
    assert!(run.stderr.contains("c.ck: holds another count"), "{}", run.stderr);
    let mut search = Command::new(assert_cmd::cargo::cargo_bin!("tilepack"));
    search.current_dir(place.0.path()).args(["count", "--kind", "corner", "--colors", "2"]);
    let run = Run::of(search.args(["--checkpoint", "c.ck"]).output().unwrap());
    assert_eq!(run.code, 2, "{}", run.stderr);
    for option in ["--node-limit 3", "-o x.txt", "--status s.json"] {
        place.resume(&format!("c.ck {option}"), 2);
    }
    assert!(fs::read(place.path("c.ck")).unwrap() == whole);
    // Damaged, with and without one before it.
    let mut bytes = whole.clone();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(place.path("c.ck"), &bytes).unwrap();
    let _ = fs::remove_file(place.path("c.ck.previous"));
    let run = place.run(COUNT, 2);
    assert!(run.stderr.contains("c.ck: is cut short or damaged"), "{}", run.stderr);
    place.resume("c.ck", 2);
    assert!(fs::read(place.path("c.ck")).unwrap() == bytes);
    fs::write(place.path("c.ck.previous"), &whole).unwrap();
    let run = place.run(COUNT, 0);
    assert_eq!(run.json()["tilings"], NUMBER);
    assert!(run.stderr.contains("kept as c.ck.damaged-1"), "{}", run.stderr);
    assert!(fs::read(place.path("c.ck.damaged-1")).unwrap() == bytes);
}

#[cfg(unix)]
#[test]
fn a_signal_saves_the_count() {
    let place = Place::new();
    // This takes long enough in every build.
    let args = "count --size 13x60 --checkpoint long.ck --quiet";
    let child = place.command(args).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(300));
    let second = place.run(args, 2);
    assert!(second.stderr.contains("another process is at work on it"), "{}", second.stderr);
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-s", "INT", &pid]).status().unwrap().success());
    let run = Run::of(child.wait_with_output().unwrap());
    assert_eq!((run.code, &run.stdout[..]), (75, ""), "{}", run.stderr);
    assert!(run.stderr.contains("stopped early by a signal"), "{}", run.stderr);
    assert!(place.path("long.ck").exists());
}
