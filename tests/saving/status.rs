//! The file for dashboards.

use crate::{Place, text};
use serde_json::Value;
use std::fs;
use std::time::{Duration, Instant};

fn read(place: &Place) -> Option<Value> {
    let text = fs::read_to_string(place.path("status.json")).ok()?;
    // Written whole or not at all: whenever it is there it can be read.
    Some(serde_json::from_str(&text).unwrap())
}

#[test]
fn it_is_always_whole_and_tells_the_end() {
    let place = Place::new();
    let args = "count --kind corner --colors 3 --status status.json --checkpoint-every 30ms \
                --time-limit 1500ms --quiet --checkpoint x.ck";
    let mut child = place.start(args);
    let mut seen: Vec<Value> = Vec::new();
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() && begin.elapsed() < Duration::from_secs(20) {
        seen.extend(read(&place));
        std::thread::sleep(Duration::from_millis(3));
    }
    assert!(seen.iter().any(|status| status["state"] == "running"), "{seen:?}");
    let nodes = |status: &Value| text(status, "nodes").parse::<u64>().unwrap();
    let done = |status: &Value| status["fraction"].as_f64().unwrap();
    for pair in seen.windows(2) {
        assert!(nodes(&pair[0]) <= nodes(&pair[1]) && done(&pair[0]) <= done(&pair[1]));
    }
    let last = read(&place).unwrap();
    assert_eq!(last["state"], "stopped");
    let mut names: Vec<&str> = last.as_object().unwrap().keys().map(String::as_str).collect();
    names.sort_unstable();
    let all = "checkpoint deepest fraction levels nodes nodes_per_second process seconds \
               seconds_left solutions_met state threads";
    assert_eq!(names.join(" "), all);
    assert_eq!(text(&last, "checkpoint"), "x.ck");
    assert_eq!(last["levels"], 77);
}

#[test]
fn a_search_that_ends_says_so() {
    let place = Place::new();
    place.run("count --kind wang --colors 2 --status status.json").exits(0);
    let last = read(&place).unwrap();
    assert_eq!((&last["state"], &last["fraction"]), (&"complete".into(), &1.0.into()));
    assert_eq!(text(&last, "nodes"), "537503");
    assert!(last["checkpoint"].is_null());
    let refused = place.run("count --kind wang --colors 2 --status no/such/status.json").exits(2);
    assert!(refused.stderr.contains("no/such/status.json"), "{refused:?}");
}
