//! `cube`, and `verify` of what it writes and of what is wrong.

use crate::{Place, names, run};
use serde_json::Value;

#[test]
fn written_and_verified() {
    for (problem, kind, size, cubes) in [
        ("--kind corner --colors 1", "corner", "1x1x1", 1),
        ("--kind corner --colors 2", "corner", "4x4x16", 256),
        ("--kind corner --colors 2 --seed 5", "corner", "4x4x16", 256),
        ("--kind corner --colors 2 --size 8x8x4", "corner", "8x8x4", 256),
        ("--kind corner --colors 3", "corner", "9x9x81", 6561),
        ("--kind wang --colors 2", "wang", "4x4x4", 64),
        ("--kind wang --colors 3 --seed 9", "wang", "9x9x9", 729),
        ("--kind wang --colors 2,3,1", "wang", "9x4x1", 36),
    ] {
        let place = Place::new();
        let whole = place.run(&format!("cube {problem}")).exits(0);
        assert!(whole.stderr.starts_with("tilepack: constructed: "), "{whole:#?}");
        let filed = place.run(&format!("cube {problem} --quiet -o c.json")).exits(0);
        assert_eq!((filed.stdout.as_str(), filed.stderr.as_str()), ("", ""));
        assert_eq!(whole.stdout, place.read("c.json"));
        let object = place.run(&format!("cube {problem} --json --quiet")).exits(0);
        place.write("o.json", &object.stdout);
        let told = place.run("verify c.json o.json").exits(0).stdout;
        let words = format!(" colors, {size} torus, each of {cubes} cubes once");
        let one = words.replace(" colors", " color");
        assert!(told.contains(&words) || told.contains(&one), "{told}");
        assert!(told.contains(&format!("complete {kind}-cube set over ")), "{told}");
        let file = &place.run("verify c.json --json").exits(0).json()["files"][0];
        assert_eq!((&file["valid"], &file["error"]), (&true.into(), &Value::Null));
        assert_eq!(object.json()["cubes"], cubes.to_string());
    }
}

#[test]
fn json_fields() {
    let object = run("cube --kind wang --colors 1,2,1 --json").exits(0).json();
    let mut wanted = vec![
        "colors",
        "construction",
        "cubes",
        "depth",
        "file",
        "format",
        "height",
        "kind",
        "layers",
        "method",
        "result",
        "seconds",
        "seed",
        "set",
        "topology",
        "width",
    ];
    assert_eq!(names(&object), wanted);
    // N, E, S, W, bottom, top over 1, 2, 1, 2, 1, 1 colors: E * 2 + W; the ring is 0 0 1 1.
    assert_eq!(object["layers"].to_string(), "[[[0,2,3,1]]]");
    let place = Place::new();
    let object = place.run("cube --kind wang --colors 2 --json -o c.json").exits(0).json();
    wanted.retain(|name| *name != "layers");
    assert_eq!(names(&object), wanted);
    let file = &place.run("verify c.json --json").exits(0).json()["files"][0];
    assert_eq!(
        names(file),
        [
            "colors", "depth", "error", "file", "height", "kind", "packings", "set", "topology",
            "valid", "width"
        ]
    );
}

#[test]
fn what_is_wrong_is_refused() {
    let place = Place::new();
    place.run("cube --kind corner --colors 2 --size 8x8x4 -o c.json").exits(0);
    let good = place.read("c.json");
    let lines: Vec<&str> = good.lines().collect();
    // The first row of the second layer.
    let row = lines.iter().position(|line| line.starts_with("      [")).unwrap() + 8 + 2;
    let numbers: Vec<u32> = lines[row]
        .trim_matches(|c: char| !c.is_ascii_digit())
        .split(", ")
        .map(|number| number.parse().unwrap())
        .collect();
    let with = |change: &dyn Fn(&mut Vec<u32>)| {
        let mut changed = numbers.clone();
        change(&mut changed);
        let texts: Vec<String> = changed.iter().map(u32::to_string).collect();
        let text = format!("      [{}],", texts.join(", "));
        let mut lines = lines.clone();
        lines[row] = &text;
        lines.join("\n")
    };
    for (name, content, code, complaint) in [
        ("digit", with(&|row| row[3] ^= 1), 1, "not a packing: layer 1, row 0, column "),
        ("swapped", with(&|row| row.swap(2, 3)), 1, "not a packing: layer 0, row 0, column "),
        ("upper", with(&|row| row[0] ^= 16), 1, "not a packing: layer "),
        ("short", with(&|row| row.truncate(7)), 2, "layer 1, row 0 has 7 of 8 cubes, the width"),
        ("long", with(&|row| row.push(0)), 2, "layer 1, row 0 has more than 8 cubes, the width"),
        ("large", with(&|row| row[1] = 256), 2, "expected the number of a cube from 0 to 255"),
        ("cut", good[..good.len() / 2].to_owned(), 2, "EOF while parsing"),
        ("more", format!("{good}{good}"), 2, "expected the end of the file"),
        ("size", good.replace("\"depth\": 4", "\"depth\": 5"), 2, "8x8x5, but there are 256 cubes"),
        ("huge", good.replace("\"colors\": 2", "\"colors\": 90"), 2, "at most 67108864 cubes"),
        ("pair", good.replace("\"colors\": 2", "\"colors\": [2,2,3]"), 2, "one number of them"),
        ("kind", good.replace("corner-cube", "wang-cube"), 2, "8x8x4, but there are 64 cubes"),
        ("set", good.replace("complete", "compact"), 2, "expected \"complete\""),
        ("no", good.replace("topology", "topologie"), 2, "expected a field \"topology\""),
    ] {
        place.write(name, content);
        let run = place.run(&format!("verify {name}")).exits(code);
        let told = if code == 1 { &run.stdout } else { &run.stderr };
        assert!(told.contains(complaint), "{name}: {run:#?}");
        place.run(&format!("verify c.json {name} --json")).exits(code);
    }
    for (args, complaint) in [
        ("cube --kind corner --colors 2,2,2", "expected a number from 1 to 255"),
        ("cube --kind wang --colors 2,2", "expected C or CH,CV,CZ"),
        ("cube --kind wang --colors 0", "expected C or CH,CV,CZ"),
        ("cube --kind corner --colors 12", "more than 67108864 cubes"),
        ("cube --kind corner --colors 3 --size 8x8x4", "no construction is known"),
        ("cube --kind corner --colors 3 --size 8x8", "expected WxHxD"),
        ("verify c.json --recursive", "options are about tiles"),
        ("verify c.json --kind corner --colors 2", "options are about tiles"),
        ("show c.json", ""),
    ] {
        let run = place.run(args).exits(2);
        assert!(run.stderr.contains(complaint), "{args}: {run:#?}");
    }
}
