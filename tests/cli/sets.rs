//! `sets`: sizes and tiles.

use crate::{Place, names, run};

#[test]
fn sizes() {
    for (args, size, checked) in [
        ("--kind corner --colors 1", "1", true),
        ("--kind corner --colors 4", "256", true),
        ("--kind corner --colors 3 --set pruned:0-1", "31", true),
        ("--kind corner --colors 4 --set pruned:0-1,2-3", "60", true),
        ("--kind corner --colors 4 --set compact", "128", false),
        ("--kind wang --colors 2,3", "36", true),
        ("--kind wang --colors 1,3", "9", true),
        ("--kind domino --colors 8", "64", true),
        ("--kind corner --colors 255", "4228250625", false),
    ] {
        let object = run(&format!("sets {args} --json")).exits(0).json();
        assert_eq!(names(&object), ["checked", "colors", "kind", "set", "size"]);
        assert_eq!(
            (&object["size"], &object["checked"]),
            (&size.into(), &checked.into()),
            "{args}"
        );
        let words = run(&format!("sets {args}")).exits(0).stdout;
        assert!(words.contains(&format!(": {size} tile")), "{words}");
        assert!(words.contains(if checked { "by formula and by listing" } else { "by formula;" }));
    }
}

#[test]
fn tiles() {
    let object = run("sets --kind domino --colors 2 --list --json").exits(0).json();
    assert_eq!(object["tiles"], serde_json::json!([0, 1, 2, 3]));
    let words = run("sets --kind wang --colors 1,2 --list").exits(0).stdout;
    let lines: Vec<_> = words.lines().skip(2).collect();
    assert_eq!(
        lines,
        [
            "tile    N   E   S   W",
            "   0    0   0   0   0",
            "   1    0   0   0   1",
            "   2    0   1   0   0",
            "   3    0   1   0   1"
        ]
    );
}

#[test]
fn sets_from_files() {
    let place = Place::new();
    place.write("s.json", "{\"kind\":\"wang\",\"tiles\":[[0,1,1,0],[0,0,1,1],[1,0,0,0]]}");
    let object = place.run("sets --set s.json --list --json").exits(0).json();
    assert_eq!((&object["kind"], &object["colors"]), (&"wang".into(), &2.into()));
    assert_eq!(object["tiles"], serde_json::json!([3, 6, 8]));
    assert_eq!(object["set"], serde_json::json!({"tiles": [3, 6, 8]}));
}
