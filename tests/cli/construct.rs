//! `find --method construct` and `locate`: what is constructed, what is refused, and why.

use crate::{Place, names, run};

#[test]
fn constructed_packings_are_verified() {
    for problem in [
        "--kind corner --colors 1",
        "--kind corner --colors 2",
        "--kind corner --colors 3 --seed 4",
        "--kind corner --colors 3 --size 27x3",
        "--kind corner --colors 6 --size 108x12",
        "--kind wang --colors 2,3",
        "--kind domino --colors 6",
        "--kind domino --colors 6 --size 1x36 --seed 2",
        "--kind domino --colors 4 --set pruned:0-1",
    ] {
        let place = Place::new();
        let find = format!("find {problem} --method construct");
        let grid = place.run(&find).exits(0);
        assert!(grid.stdout.starts_with("# constructed: "), "{grid:#?}");
        assert!(grid.stderr.starts_with("tilepack: constructed: "), "{grid:#?}");
        let json = place.run(&format!("{find} --json --quiet")).exits(0);
        assert_eq!(json.stderr, "");
        let filed = place.run(&format!("{find} --quiet -o p.json")).exits(0);
        assert_eq!((filed.stdout.as_str(), filed.stderr.as_str()), ("", ""));
        place.write("grid.txt", &grid.stdout).write("object.json", &json.stdout);
        place.run("verify grid.txt object.json p.json").exits(0);
        let solution: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
        assert_eq!(solution["tiles"], json.json()["tiles"]);
    }
}

#[test]
fn json_fields() {
    let object = run("find --kind corner --colors 3 --method construct --json").exits(0).json();
    let mut wanted = names(&object);
    wanted.retain(|name| !["construction", "source", "seed"].contains(name));
    let found = run("find --kind corner --colors 3 --method search --json").exits(0).json();
    assert_eq!(wanted, names(&found));
    assert_eq!((&object["result"], &object["method"]), (&"found".into(), &"construct".into()));
    assert_eq!(object["construction"], "rotated rings");
}

/// Constructed where a construction is known, unless an option asks for a search; else annealed
/// or by beam search where those are quick; else searched. It says which, and why.
#[test]
fn auto_takes_the_quickest_way() {
    let known = "a construction is known";
    for (problem, method, why) in [
        ("--kind corner --colors 3", "construct", known),
        ("--kind corner --colors 3 --set compact --size 27x2", "construct", known),
        ("--kind corner --colors 12 --set compact", "construct", known),
        ("--kind wang --colors 5 --set compact", "construct", known),
        ("--kind corner --colors 5 --set compact --size 50x5", "anneal", "anneal in seconds"),
        (
            "--kind corner --colors 3 --set pruned:0-1 --size 31x1",
            "argument",
            "does not match itself",
        ),
        ("--kind domino --colors 3 --cover --size 10x1", "search", "--cover is for a search"),
        ("--kind corner --colors 3 --order row", "search", "--order is for a search"),
    ] {
        let object = run(&format!("find {problem} --json --quiet")).json();
        assert_eq!(object["method"], method, "{problem}");
        assert!(object["why"].as_str().unwrap().contains(why), "{problem}: {object:?}");
    }
    for (problem, constructed) in [
        ("--kind corner --colors 3", true),
        ("--kind corner --colors 4", true),
        ("--kind corner --colors 4 --method search --node-limit 9", false),
        ("--kind corner --colors 4 --order row --node-limit 9", false),
        ("--kind corner --colors 4 --values random --node-limit 9", false),
        // A limit is one of the time to wait, not a wish for a search.
        ("--kind corner --colors 4 --node-limit 9", true),
        ("--kind corner --colors 4 --time-limit 10s", true),
        ("--kind corner --colors 12", true),
        ("--kind wang --colors 12", true),
        ("--kind domino --colors 200", true),
    ] {
        let run = run(&format!("find {problem}"));
        assert_eq!(run.stdout.starts_with("# constructed: "), constructed, "{problem}");
    }
}

/// Too large to hold: checked row by row, and the file read back and verified whole.
#[test]
fn a_million_and_a_half_tiles() {
    let place = Place::new();
    let found = place.run("find --kind corner --colors 35 -o p.json").exits(0);
    assert!(found.stderr.contains("1500625 tiles in "), "{found:#?}");
    place.run("verify p.json").exits(0);
    let located = place.run("locate --kind corner --colors 35 --json 0 1500624 777777").exits(0);
    let rows: serde_json::Value = serde_json::from_str(&place.read("p.json")).unwrap();
    for tile in located.json()["tiles"].as_array().unwrap() {
        let [row, column] = ["row", "column"].map(|name| tile[name].as_u64().unwrap() as usize);
        assert_eq!(rows["tiles"][row][column], tile["tile"]);
    }
}

#[test]
fn nothing_is_known() {
    let find = "find --kind corner --colors 6 --size 81x16 --method construct";
    let unknown = run(find).exits(1);
    let reason = "no construction is known for corner tiles, colors 6, set complete, size 81x16";
    assert!(unknown.stdout.starts_with(&format!("unknown: {reason}")), "{unknown:#?}");
    let object = run(&format!("{find} --json")).exits(1).json();
    assert_eq!((&object["result"], &object["reason"]), (&"unknown".into(), &reason.into()));
    for (problem, reason) in [
        ("--kind corner --colors 2 --size 8x2", "both sides must be at least 3"),
        ("--kind corner --colors 4 --size 1x256", "both sides must be at least 3"),
        ("--kind wang --colors 2 --size 16x1", "a tile is its own neighbor"),
    ] {
        let none = run(&format!("find {problem} --method construct")).exits(1);
        assert!(none.stdout.starts_with("none: ") && none.stdout.contains(reason), "{none:#?}");
        let locate = run(&format!("locate {problem} 0")).exits(1);
        assert_eq!(locate.stdout, none.stdout);
    }
    run("find --kind corner --colors 3 --set pruned:0-1 --size 31x1 --method construct").exits(1);
}

#[test]
fn mistakes() {
    for (args, complaint) in [
        ("find --kind corner --colors 3 --method construct --order row", "--order is for a search"),
        ("find --kind corner --colors 3 --method construct --cover", "--cover is for a search"),
        ("find --kind corner --colors 3 --method construct --size 9x8", "the set has 81 tiles"),
        ("find --kind domino --colors 4 --method construct --size 4x4", "one side must be 1"),
        ("find --kind corner --colors 256 --method construct", "expected 1 to 255"),
        ("locate --kind corner --colors 3 81", "tile 81 is out of range: expected 0 to 80"),
        ("locate --kind corner --colors 3 0,1,3,0", "color 3 is out of range"),
        ("locate --kind corner --colors 3 0,1", "expected NE,SE,SW,NW, but 2 colors are given"),
        ("locate --kind corner --colors 3 x", "tile 'x': expected a number, or NE,SE,SW,NW"),
        ("locate --kind corner --colors 3 -1", "unexpected argument '-1'"),
        ("locate --kind domino --colors 3 --set pruned:0-1 1", "tile 1 is not in the set"),
        ("locate --kind corner --colors 3 --size 9x8 1", "the set has 81 tiles"),
        ("locate --kind corner --colors 3", "TILE"),
    ] {
        let run = run(args).exits(2);
        assert!(run.stderr.contains(complaint) && run.stdout.is_empty(), "{args}: {run:#?}");
    }
}

#[test]
fn locate_agrees_with_find() {
    for problem in ["--kind corner --colors 4 --size 64x4 --seed 3", "--kind wang --colors 3,4"] {
        let find = format!("find {problem} --method construct --json");
        let object = run(&find).exits(0).json();
        let rows = object["tiles"].as_array().unwrap();
        for (row, tiles) in rows.iter().enumerate().step_by(3) {
            let tile = &tiles[row % 4];
            let said = run(&format!("locate {problem} {tile}")).exits(0).stdout;
            assert!(said.starts_with(&format!("tile {tile} (")), "{said}");
            assert!(said.ends_with(&format!(": row {row}, column {}\n", row % 4)), "{said}");
        }
    }
    // NE 1, SE 2, SW 0, NW 1 is 1*27 + 2*9 + 0*3 + 1.
    let both = run("locate --kind corner --colors 3 46 1,2,0,1").exits(0).stdout;
    let lines: Vec<_> = both.lines().collect();
    assert_eq!(lines[0], lines[1]);
    // The closed form works for the most colors there are.
    let most = run("locate --kind corner --colors 255 4228250624 --json").exits(0).json();
    assert_eq!(
        (&most["width"], &most["tiles"][0]["tile"]),
        (&65025.into(), &4_228_250_624u64.into())
    );
}

/// Coverings of few tiles are searched, of many annealed.
#[test]
fn auto_covers() {
    for (problem, method) in [
        ("--kind corner --colors 2 --cover --size 5x4", "search"),
        ("--kind corner --colors 3 --set pruned:0-1 --cover", "search"),
        ("--kind corner --colors 4 --set pruned:0-1 --cover --size 15x10", "beam"),
    ] {
        let object = run(&format!("find {problem} --json --quiet")).exits(0).json();
        assert_eq!(object["method"], method, "{problem}");
        let covers = object["why"].as_str().unwrap().contains("too many to search");
        assert_eq!(covers, object["lower_bound"].is_u64(), "{object:?}");
    }
}
