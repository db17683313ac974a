//! `list`: all packings, sorted, each once, each one valid.

use crate::{Place, names, run};

#[test]
fn lists_are_complete_sorted_and_valid() {
    let place = Place::new();
    for (problem, number) in [
        ("--kind corner --colors 2", 32),
        ("--kind domino --colors 3", 216),
        ("--kind domino --colors 2 --size 1x4", 4),
        ("--kind corner --colors 2 --up-to-symmetry", 1),
        ("--kind corner --colors 1", 1),
    ] {
        let listed = place.run(&format!("list {problem} -o all.jsonl")).exits(0);
        assert_eq!(listed.stdout, "");
        let text = place.read("all.jsonl");
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), number, "{problem}");
        let different: std::collections::HashSet<_> = lines.iter().collect();
        assert_eq!(different.len(), number, "{problem}");
        let verified = place.run("verify all.jsonl --json").exits(0).json();
        assert_eq!(verified["files"][0]["packings"], number);
        let piped = place.run(&format!("list {problem} --quiet --threads 3")).exits(0);
        assert_eq!((piped.stdout, piped.stderr.as_str()), (text, ""), "{problem}");
    }
}

#[test]
fn json_fields() {
    let place = Place::new();
    let object = place.run("list --kind domino --colors 2 -o all.jsonl --json").exits(0).json();
    let fields = ["file", "nodes", "reason", "result", "seconds", "solutions", "stopped_by"];
    assert_eq!(names(&object), fields);
    assert_eq!((&object["result"], &object["solutions"]), (&"complete".into(), &"4".into()));
    assert_eq!(object["file"], "all.jsonl");
}

#[test]
fn as_many_as_are_counted() {
    for problem in ["--kind corner --colors 2 --set compact", "--kind wang --colors 1,3"] {
        for option in ["", "--up-to-symmetry"] {
            let object = run(&format!("count {problem} {option} --json")).exits(0).json();
            let field = if option.is_empty() { "solutions" } else { "fundamental" };
            let listed = run(&format!("list {problem} {option}")).exits(0).stdout.lines().count();
            assert_eq!(object[field], listed.to_string(), "{problem} {option}");
        }
    }
}

#[test]
fn an_incomplete_list_says_so() {
    let place = Place::new();
    let listed = place.run("list --kind wang --colors 2 --node-limit 3000 -o l.jsonl").exits(75);
    assert!(listed.stderr.contains("stopped early by the node limit: 3000 nodes"), "{listed:#?}");
    assert!(listed.stderr.contains("the list is incomplete"), "{listed:#?}");
    let lines = place.read("l.jsonl").lines().count();
    assert!(lines > 0 && lines < 203_520);
    place.run("verify l.jsonl").exits(0);
    let object =
        place.run("list --kind wang --colors 2 --node-limit 3000 -o l.jsonl --json").json();
    assert_eq!(
        (&object["result"], &object["stopped_by"]),
        (&"stopped".into(), &"node-limit".into())
    );
}
