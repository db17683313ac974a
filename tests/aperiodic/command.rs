//! The commands as users meet them.

use serde_json::Value;
use std::fs;
use tempfile::TempDir;

fn run(place: &TempDir, args: &str) -> (i32, String) {
    let mut command = assert_cmd::cargo::cargo_bin_cmd!("tilepack");
    let words = args.split_whitespace();
    let output = command.current_dir(place.path()).arg("aperiodic").args(words).output().unwrap();
    let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), text.concat())
}

#[track_caller]
fn exits(place: &TempDir, code: i32, args: &str) -> String {
    let (is, told) = run(place, args);
    assert_eq!(is, code, "{args}: {told}");
    told
}

#[test]
fn sets_and_tables() {
    let place = TempDir::new().unwrap();
    let told = exits(&place, 0, "sets");
    assert!(told.contains("jeandel-rao") && told.contains("refuted"), "{told}");
    let json: Value = serde_json::from_str(&exits(&place, 0, "sets --json")).unwrap();
    assert_eq!(json["sets"].as_array().unwrap().len(), 10);
    let told = exits(&place, 0, "tables");
    for words in [
        "1213029/58910",
        "failed (36 -> 30)",
        "horizontal  44/6                2 mixed tiles: the corner tiles have a periodic tiling",
        "vertical    86/6                no mixed tiles",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}

#[test]
fn conversions_go_on_from_files() {
    let place = TempDir::new().unwrap();
    let told = exits(&place, 0, "convert kari --method diagonal --repeat 2 -o corner.json");
    assert!(told.contains("3052 tiles over 214 colors"), "{told}");
    let told = exits(&place, 0, "convert corner.json --method to-wang --json");
    let json: Value = serde_json::from_str(&told).unwrap();
    assert_eq!(json["steps"][0]["tiles"], 3052);
    assert_eq!(json["steps"][0]["colors"], 1208);
    // Labels above 254 are read, too.
    exits(&place, 0, "convert kari --method diagonal --repeat 3 -o large.json");
    let told = exits(&place, 0, "convert large.json --method to-wang");
    assert!(told.contains("58910 tiles over 19274 colors"), "{told}");
    for (args, words) in [
        ("convert none.json --method diagonal", "none.json"),
        ("convert corner.json --method diagonal", "diagonal starts from wang tiles"),
        ("convert kari --method sideways", "expected diagonal, horizontal"),
        ("convert corner.json --method to-wang --repeat 2", "--repeat 2 goes with"),
        ("patch kari --size 0x4", "size"),
        ("patch kari --size 60000x60000", "3600000000 tiles, expected 67108864 or fewer"),
        ("patch ammann --torus --size 5x5 --time-limit 1ms", "none"),
    ] {
        let (code, told) = run(&place, args);
        assert!(code == 2 || words == "none" && code == 1, "{args}: {code} {told}");
        assert!(told.contains(words), "{args}: {told}");
    }
    fs::write(
        place.path().join("twice.json"),
        r#"{"kind":"wang","tiles":[[0,0,0,300],[0,0,0,300]]}"#,
    )
    .unwrap();
    let told = exits(&place, 2, "convert twice.json --method diagonal");
    assert!(told.contains("listed twice"), "{told}");
}

#[test]
fn patches_in_every_form() {
    let place = TempDir::new().unwrap();
    let text = exits(&place, 0, "patch ammann --size 9x7 --quiet");
    assert_eq!(text.lines().count(), 7);
    assert!(text.lines().all(|line| line.split(' ').count() == 9));
    for (file, begin) in [("a.svg", "<"), ("a.png", "\u{fffd}PNG"), ("a.json", "{"), ("a.txt", "")]
    {
        exits(&place, 0, &format!("patch ammann --size 9x7 -o {file} --tile-size 8"));
        let bytes = fs::read(place.path().join(file)).unwrap();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        assert!(text.starts_with(begin), "{file}: {text}");
    }
    // Sets that compute are quick at any size.
    for set in ["kari", "culik", "jeandel-rao", "jeandel-rao-5"] {
        let told = exits(&place, 0, &format!("patch {set} --size 1000x400 -o big.txt"));
        assert!(told.contains("computed; every side checked"), "{told}");
    }
    fs::write(place.path().join("two.json"), r#"{"kind":"wang","tiles":[[0,0,1,0],[1,0,0,0]]}"#)
        .unwrap();
    assert_eq!(exits(&place, 0, "patch two.json --torus --quiet").lines().count(), 2);
    let told = exits(&place, 2, "patch two.json --torus --size 3x3");
    assert!(told.contains("expected multiples of 1 and 2"), "{told}");
}
