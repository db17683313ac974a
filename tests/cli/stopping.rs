//! Limits and signals: the search ends soon, says how far it got, and exits with 75.

use crate::{Place, run};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

const COUNT: &str = "count --kind corner --colors 3";

#[test]
fn a_time_limit() {
    let begin = Instant::now();
    let counted = run(&format!("{COUNT} --time-limit 300ms")).exits(75);
    assert!(begin.elapsed() < Duration::from_millis(1500), "{:?}", begin.elapsed());
    assert!(counted.stdout.starts_with("at least "), "{counted:#?}");
    assert!(counted.stdout.contains("by search, stopped early"), "{counted:#?}");
    let told = counted.stderr.lines().last().unwrap();
    assert!(told.starts_with("tilepack: stopped early by the time limit: "), "{told}");
    for part in [" nodes in ", "about ", " % of the tree", "deepest level ", " of 77"] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn a_node_limit() {
    for threads in [1, 3] {
        let args = format!("{COUNT} --node-limit 12345 --threads {threads} --json");
        let object = run(&args).exits(75).json();
        assert_eq!((&object["result"], &object["nodes"]), (&"stopped".into(), &"12345".into()));
        assert_eq!(object["stopped_by"], "node-limit");
        assert!(object["up_to_translation"].is_null());
    }
    let nothing = run(&format!("{COUNT} --node-limit 0 --json")).exits(75).json();
    assert_eq!((&nothing["solutions"], &nothing["nodes"]), (&"0".into(), &"0".into()));
}

#[test]
fn a_search_that_finds_nothing_in_time() {
    let find = "find --kind corner --colors 4 --method search --node-limit 1000";
    let found = run(find).exits(75);
    assert_eq!(found.stdout, "");
    assert!(found.stderr.contains("stopped early by the node limit: 1000 nodes"), "{found:#?}");
    assert!(found.stderr.contains("no packing found so far"), "{found:#?}");
    let object = run(&format!("{find} --json")).exits(75).json();
    assert_eq!(
        (&object["result"], &object["stopped_by"]),
        (&"stopped".into(), &"node-limit".into())
    );
    assert!(object["file"].is_null());
    // Also when quiet: the answer is not what it seems.
    assert!(run(&format!("{find} --quiet")).exits(75).stderr.contains("stopped early"));
}

#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let args = "count --kind corner --colors 2 --node-limit 1000000 --time-limit 1h --json";
    assert_eq!(run(args).exits(0).json()["result"], "complete");
}

fn start(args: &str) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin!("tilepack"))
        .args(args.split_whitespace())
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

#[cfg(unix)]
fn signal(child: &Child, name: &str) {
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-s", name, &pid]).status().unwrap().success());
}

/// Ends a search by a signal after a while; gives its output and how long the end took.
#[cfg(unix)]
fn end(args: &str, name: &str) -> (Output, Duration) {
    let child = start(args);
    std::thread::sleep(Duration::from_millis(700));
    let begin = Instant::now();
    signal(&child, name);
    let output = child.wait_with_output().unwrap();
    (output, begin.elapsed())
}

#[cfg(unix)]
#[test]
fn signals_end_a_search_within_a_second() {
    for name in ["INT", "TERM"] {
        for args in [
            COUNT,
            "list --kind corner --colors 4 --order column",
            "find --kind corner --colors 5 --order row",
        ] {
            let (output, time) = end(args, name);
            let stderr = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(75), "{args} {name}: {stderr}");
            assert!(time < Duration::from_secs(1), "{args} {name}: {time:?}");
            let told = stderr.lines().last().unwrap_or_default();
            assert!(told.starts_with("tilepack: stopped early by a signal: "), "{args}: {stderr}");
            assert!(told.contains(" of the tree, deepest level "), "{args}: {stderr}");
        }
    }
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_json_whole() {
    let (output, _) = end(&format!("{COUNT} --json --quiet"), "TERM");
    let object: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&object["result"], &object["stopped_by"]), (&"stopped".into(), &"signal".into()));
    let nodes: u64 = object["nodes"].as_str().unwrap().parse().unwrap();
    assert!(nodes > 1000);
}

#[test]
fn progress_where_there_is_no_terminal() {
    let counted = run(&format!("{COUNT} --time-limit 5500ms")).exits(75);
    let lines: Vec<_> = counted.stderr.lines().collect();
    assert_eq!(lines.len(), 2, "{counted:#?}");
    for part in ["about ", " of the tree, ", " nodes/s, deepest level ", " of 77, ", " met, 5."] {
        assert!(lines[0].contains(part), "{part}: {}", lines[0]);
    }
    assert!(!counted.stderr.contains('\u{1b}') && !counted.stderr.contains('\r'));
    let quick = Place::new().run("find --kind corner --colors 2 --quiet").exits(0);
    assert_eq!(quick.stderr, "");
}
