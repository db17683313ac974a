//! `run`: safe to be run again, stopped, killed and started twice.

use crate::{Place, Run, lasting};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant, SystemTime};
use tilepack::packing::{self, Settings};
use tilepack::store::{Checkpoint, SearchPlan, write_checkpoint, write_job};

const WANG: &str = "--kind wang --colors 2";
const QUOTIENT: &str = "--kind corner --colors 3 --automorphism 3,0:+1";
const ENDLESS: &str = "--kind corner --colors 3";

/// Name, bytes and time of change of every file in a folder.
fn files(folder: &Path) -> BTreeMap<String, (Vec<u8>, SystemTime)> {
    let entries = std::fs::read_dir(folder).unwrap().map(Result::unwrap);
    entries
        .map(|entry| {
            let changed = entry.metadata().unwrap().modified().unwrap();
            let bytes = std::fs::read(entry.path()).unwrap();
            (entry.file_name().into_string().unwrap(), (bytes, changed))
        })
        .collect()
}

/// What a result says, but for the time it took.
fn content(place: &Place, file: &str) -> Value {
    let whole: Value = serde_json::from_slice(&place.bytes(file)).unwrap();
    lasting(whole["content"].clone())
}

#[test]
fn a_part_that_is_done_is_left_alone() {
    let place = Place::new();
    for (problem, kept) in [(WANG, 0), ("--kind wang --colors 2 --up-to-symmetry --list", 1)] {
        place.plan(problem, 3, "some.plan");
        let _ = std::fs::remove_dir_all(place.path("some.plan.parts"));
        let first = place.run("run some.plan --part 1 --json").exits(0);
        let before = files(&place.path("some.plan.parts"));
        assert_eq!(before.len(), 1 + kept, "{:?}", before.keys());
        let second = place.run("run some.plan --part 1 --json").exits(0);
        assert_eq!(second.stdout, first.stdout, "also its time");
        assert_eq!(files(&place.path("some.plan.parts")), before);
        let object = second.json();
        assert_eq!((&object["result"], &object["part"]), (&"complete".into(), &1.into()));
        assert_eq!((&object["parts"], &object["done"]), (&3.into(), &1.into()));
        for field in ["solutions_met", "nodes"] {
            assert!(object[field].as_str().unwrap().parse::<u64>().unwrap() > 0);
        }
        place.run("run some.plan --part 1").exits(0).says(&["part 1 of 3 was done before: "]);
        assert_eq!(files(&place.path("some.plan.parts")), before);
    }
}

/// Runs a part again and again with a limit until it is done; how often it was stopped.
fn run_on(place: &Place, args: impl Fn(usize) -> String) -> usize {
    let mut nodes = 0;
    for round in 0..10_000 {
        let run = place.run(&args(round));
        let object = run.json();
        let now: u64 = object["nodes"].as_str().unwrap().parse().unwrap();
        assert!(now >= nodes, "{run:#?}");
        nodes = now;
        if run.code == 0 {
            assert_eq!((&object["result"], &object["done"]), (&"complete".into(), &1.into()));
            return round;
        }
        let run: Run = run.exits(75).says(&["stopped early by the ", "run it again to go on"]);
        // That would say what it came to without its plan.
        assert!(!run.stderr.contains("tilepack resume"), "{run:#?}");
        assert_eq!((&object["result"], &object["done"]), (&"stopped".into(), &0.into()));
        assert!(object["checkpoint"].as_str().unwrap().ends_with(".checkpoint"));
        assert!(object["solutions_met"].is_string());
    }
    panic!("never done");
}

#[test]
fn cut_by_nodes() {
    let place = Place::new();
    for problem in
        [WANG, "--kind wang --colors 2 --list", "--kind wang --colors 2 --up-to-symmetry"]
    {
        place.plan(problem, 5, "some.plan");
        place.run("run some.plan --part 3 --dir whole").exits(0);
        let stops = run_on(&place, |round| {
            let threads = [1, 3, 2][round % 3];
            format!("run some.plan --part 3 --dir cut --node-limit 9000 --threads {threads} --json")
        });
        // On one thread a limit is exact, on several it may be undercut.
        assert!(stops >= 10, "{stops}");
        assert_eq!(content(&place, "cut/part-3.result.json"), {
            let mut whole = content(&place, "whole/part-3.result.json");
            // The same packings in another order.
            let kept = &mut whole["packings"];
            if !kept.is_null() {
                let cut = content(&place, "cut/part-3.result.json");
                assert_eq!(cut["packings"]["bytes"], kept["bytes"]);
                kept["hash"] = cut["packings"]["hash"].clone();
            }
            whole
        });
        assert!(!place.path("cut/part-3.checkpoint").exists());
        assert!(!place.path("cut/part-3.checkpoint.previous").exists());
        for folder in ["whole", "cut"] {
            std::fs::remove_dir_all(place.path(folder)).unwrap();
        }
    }
}

#[test]
fn cut_by_time_and_merged() {
    let place = Place::new();
    place.plan(QUOTIENT, 1, "some.plan");
    let args = "run some.plan --part 0 --time-limit 1ms --threads 1 --json";
    let stops = run_on(&place, |_| args.into());
    assert!(stops >= 1, "{stops}");
    let merged = place.run("merge some.plan --json").exits(0).json();
    let count = place.run(&format!("count {QUOTIENT} --json")).exits(0).json();
    assert_eq!((&merged["solutions"], &merged["nodes"]), (&count["solutions"], &count["nodes"]));
    assert_eq!(merged["solutions"], "303264");
}

/// Lists whose parts were cut are whole.
#[test]
fn lists_that_were_cut() {
    let place = Place::new();
    place.plan("--kind domino --colors 3 --list", 2, "some.plan");
    for part in 0..2 {
        let args = format!("run some.plan --part {part} --node-limit 7 --json");
        assert!(run_on(&place, |_| args.clone()) > 5);
    }
    place.run("merge some.plan -o merged.jsonl").exits(0);
    place.run("list --kind domino --colors 3 -o whole.jsonl").exits(0);
    assert_eq!(place.bytes("merged.jsonl"), place.bytes("whole.jsonl"));
}

/// A process killed when its last checkpoint was written and its result was not.
#[test]
fn done_but_for_the_result() {
    let place = Place::new();
    let plan = place.plan(WANG, 3, "some.plan");
    place.run("run some.plan --part 2 --dir whole").exits(0);
    std::fs::create_dir(place.path("some.plan.parts")).unwrap();
    let job = plan.part(2);
    let standing = packing::run(&job, None, &Settings::PLAIN).unwrap();
    let checkpoint = Checkpoint {
        generation: 4,
        job: write_job(&job),
        request: String::new(),
        standing,
        kept: None,
    };
    let file = place.path("some.plan.parts/part-2.checkpoint");
    write_checkpoint(&file, &checkpoint).unwrap();
    place.run("run some.plan --part 2").exits(0);
    let result = content(&place, "some.plan.parts/part-2.result.json");
    assert_eq!(result, content(&place, "whole/part-2.result.json"));
    assert!(!file.exists());
}

fn wait_for(file: &Path) {
    let begin = Instant::now();
    while !file.exists() {
        assert!(begin.elapsed() < Duration::from_secs(30), "{} does not come", file.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[cfg(unix)]
fn signal(process: u32, name: &str) {
    let process = process.to_string();
    assert!(Command::new("kill").args(["-s", name, &process]).status().unwrap().success());
}

#[cfg(unix)]
#[test]
fn one_process_at_a_time() {
    let place = Place::new();
    place.plan(ENDLESS, 2, "some.plan");
    let run = "run some.plan --part 0 --threads 1 --json";
    for (name, code) in [("TERM", 75), ("INT", 75), ("KILL", -1)] {
        let child = place.start(run);
        // Taken after the lock of the part.
        wait_for(&place.path("some.plan.parts/part-0.checkpoint.lock"));
        std::thread::sleep(Duration::from_millis(300));
        let refused = place.run(run).exits(75);
        assert!(refused.stderr.contains("part-0.result.json: another process is"), "{refused:#?}");
        assert_eq!(refused.json()["stopped_by"], "lock");
        // Another part is free.
        place.run("run some.plan --part 1 --node-limit 10").exits(75);
        signal(child.id(), name);
        let ended = Run::from(child.wait_with_output().unwrap()).exits(code);
        if code == 75 {
            let object = ended.json();
            assert_eq!(object["stopped_by"], "signal");
            assert!(!place.path("some.plan.parts/part-0.checkpoint.lock").exists());
            assert!(!place.path("some.plan.parts/part-0.result.json.lock").exists());
        }
        // The lock of a process that is gone holds nobody up.
        let on = place.run(&format!("{run} --node-limit 5")).exits(75);
        assert!(on.stderr.contains("going on from"), "{on:#?}");
    }
}

#[test]
fn parts_and_folders_that_are_not_there() {
    let place = Place::new();
    place.plan(WANG, 3, "some.plan");
    place.run("run some.plan --part 3").exits(2).says(&["--part 3", "3 parts, from 0"]);
    for args in ["--part -1", "--part x", "--part 18446744073709551616", ""] {
        place.run(&format!("run some.plan {args}")).exits(2);
    }
    place.run("run other.plan --part 0").exits(2).says(&["other.plan"]);
    place.write("file", "");
    place.run("run some.plan --part 0 --dir file").exits(2).says(&["file: "]);
    place.run("run some.plan --part 0 --dir file/below").exits(2).says(&["file/below: "]);
    place.run("run some.plan --part 0 --dir deep/er/still").exits(0);
    assert!(place.path("deep/er/still/part-0.result.json").exists());
    place.run("merge some.plan").exits(75).says(&["0 of 3 parts are done", "missing: 0-2"]);
    place.run("merge some.plan --dir nowhere").exits(2).says(&["nowhere"]);
}

#[cfg(unix)]
#[test]
fn a_folder_that_is_read_only() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::new();
    place.plan(WANG, 3, "some.plan");
    let folder = place.path("locked");
    std::fs::create_dir(&folder).unwrap();
    std::fs::set_permissions(&folder, std::fs::Permissions::from_mode(0o555)).unwrap();
    if std::fs::write(folder.join("probe"), "").is_ok() {
        eprintln!("skipped: this user may write anywhere");
        return;
    }
    place.run("run some.plan --part 0 --dir locked").exits(2).says(&["locked/part-0"]);
}

/// Files of another part or plan under the names of this one.
#[test]
fn what_belongs_to_another_part() {
    let place = Place::new();
    place.plan(WANG, 3, "some.plan");
    place.run("run some.plan --part 0 --node-limit 30").exits(75);
    let checkpoint = "some.plan.parts/part-0.checkpoint";
    place.copy(checkpoint, "some.plan.parts/part-1.checkpoint");
    let refused = place.run("run some.plan --part 1").exits(2);
    refused.says(&["part-1.checkpoint: holds another search", "part 0 of 3"]);
    let advice = place.run(&format!("resume {checkpoint}")).exits(2);
    advice.says(&[checkpoint, "part 0 of 3", "tilepack run PLAN --part 0"]);
    place.run("run some.plan --part 0").exits(0);
    let result = "some.plan.parts/part-0.result.json";
    place.copy(result, "some.plan.parts/part-2.result.json");
    place
        .run("run some.plan --part 2")
        .exits(2)
        .says(&["part-2.result.json", "another plan or part"]);
    place.plan("--kind wang --colors 2 --plain", 3, "plain.plan");
    let other = place.run("run plain.plan --part 0 --dir some.plan.parts").exits(2);
    other.says(&["part-0.result.json", "another plan or part"]);
    // A damaged result is not taken for one, nor written over.
    let mut bytes = place.bytes(result);
    bytes[200] ^= 1;
    place.write(result, &bytes);
    place.run("run some.plan --part 0").exits(2).says(&["part-0.result.json"]);
    assert_eq!(place.bytes(result), bytes);
}

/// A list whose packings are gone is not done, whatever its result says.
#[test]
fn a_result_without_its_packings() {
    let place = Place::new();
    place.plan("--kind domino --colors 3 --list", 2, "some.plan");
    place.run_all("some.plan", 2);
    let packings = "some.plan.parts/part-1.packings";
    let whole = place.bytes(packings);
    place.write(packings, &whole[1..]);
    for command in ["run some.plan --part 1", "merge some.plan -o list.jsonl"] {
        place.run(command).exits(2).says(&[packings]);
    }
    std::fs::remove_file(place.path(packings)).unwrap();
    for command in ["run some.plan --part 1", "merge some.plan -o list.jsonl"] {
        place.run(command).exits(2).says(&[packings]);
    }
    assert!(!place.path("list.jsonl").exists());
    // Packings that a killed process wrote after its last checkpoint do not count.
    let more: Vec<u8> = whole.iter().chain(&whole).copied().collect();
    place.write(packings, more);
    place.run("run some.plan --part 1").exits(0);
    place.run("merge some.plan -o list.jsonl").exits(0);
    let plan = SearchPlan::read(&place.path("some.plan")).unwrap();
    assert!(plan.job.is_list());
    let lines = place.bytes("list.jsonl").iter().filter(|&&byte| byte == b'\n').count();
    assert_eq!(lines, 216);
}
