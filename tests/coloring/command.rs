//! `aperiodic color`, and `verify` for certificates, as users meet them.

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// Runs the program in a folder: exit code, standard output, standard error.
fn run(place: &TempDir, args: &str) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tilepack"));
    let output = command.args(args.split_whitespace()).current_dir(place).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// Wang tiles of three rows of labels, [N, E, S, W].
const STRIPES: &str = r#"{"kind":"wang","name":"stripes","tiles":[[0,0,1,0],[1,0,0,0],[1,0,1,0]]}"#;

#[test]
fn the_published_certificate() {
    let place = TempDir::new().unwrap();
    std::fs::write(place.path().join("c.json"), crate::PUBLISHED).unwrap();
    let (code, out, _) = run(&place, "verify c.json");
    assert_eq!(code, 0);
    assert!(out.starts_with(
        "c.json: valid: 24 corner tiles over 4 colors, aperiodic given Jeandel and Rao 2021\n  \
         proved: the 11 Wang tiles fill the plane"
    ));
    assert!(out.contains("\n  assumed: no tiling by the 11 Wang tiles of Jeandel and Rao is"));
    let (code, out, _) = run(&place, "verify --json c.json");
    let object: Value = serde_json::from_str(&out).unwrap();
    let file = &object["files"][0];
    assert_eq!((code, file["valid"].as_bool(), file["tiles"].as_u64()), (0, Some(true), Some(24)));
    assert_eq!(file["condition"], "radius1");
    assert_eq!(file["proved"].as_array().unwrap().len(), 3);

    let changed = crate::PUBLISHED.replace("\"corner_tiles\":[[0,0,0,1],", "\"corner_tiles\":[");
    std::fs::write(place.path().join("c.json"), changed).unwrap();
    let (code, out, _) = run(&place, "verify c.json");
    assert_eq!(code, 1);
    assert!(out.starts_with("c.json: proves nothing: corner tiles: window "), "{out}");
    let broken = &crate::PUBLISHED[..20_000];
    std::fs::write(place.path().join("c.json"), broken).unwrap();
    let (code, out, errors) = run(&place, "verify c.json");
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(errors.contains("c.json:1:"), "{errors}");
    let (code, _, errors) = run(&place, "verify --kind corner c.json");
    assert_eq!(code, 2);
    assert!(errors.contains("options are about packings"), "{errors}");
}

#[test]
fn colorings_are_found_written_and_proved() {
    let place = TempDir::new().unwrap();
    let args = "aperiodic color jeandel-rao --condition pair --window 4x2 --target 30 --seed 1 \
                --set-out s.json --quiet";
    for threads in ["1 -o c1.json", "3 -o c3.json"] {
        let (code, out, errors) = run(&place, &format!("{args} --threads {threads}"));
        assert_eq!((code, errors.as_str()), (0, ""));
        assert!(out.contains("given that no tiling by the 11 Wang tiles"), "{out}");
    }
    let read = |name: &str| std::fs::read(place.path().join(name)).unwrap();
    assert_eq!(read("c1.json"), read("c3.json"));
    let certificate = crate::read(read("c1.json"));
    assert!(certificate.tiles.len() <= 30, "{}", certificate.title);
    assert_eq!(run(&place, "verify c1.json --quiet").0, 0);
    // The set is one that sets reads, with the same tiles.
    let set: Value = serde_json::from_slice(&read("s.json")).unwrap();
    let listed = certificate.tiles.iter().map(|tile| serde_json::json!(tile));
    let mut listed: Vec<Value> = listed.collect();
    let mut tiles = set["tiles"].as_array().unwrap().clone();
    for list in [&mut listed, &mut tiles] {
        list.sort_by_key(Value::to_string);
    }
    assert_eq!(tiles, listed);
    assert_eq!(run(&place, "sets --kind corner --set s.json").0, 0);
}

#[test]
fn a_set_from_a_file_has_a_way_back_and_no_certificate() {
    let place = TempDir::new().unwrap();
    std::fs::write(place.path().join("w.json"), STRIPES).unwrap();
    let args = "aperiodic color w.json --patch 12x12 --window 2x2 --condition pair --rounds 3 --moves 5000 --json";
    let (code, out, _) = run(&place, args);
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["base"].as_str()), (0, Some("stripes")));
    let status = "windows from a patch of 12 x 12: existence is not proved";
    assert_eq!(object["status"], status);
    assert_eq!(object["file"], Value::Null);
    let (code, _, errors) = run(&place, "aperiodic color w.json -o c.json");
    assert_eq!(code, 2);
    assert!(errors.contains("a certificate needs the exact windows"), "{errors}");
    assert!(!place.path().join("c.json").exists());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let place = TempDir::new().unwrap();
    std::fs::write(place.path().join("w.json"), STRIPES).unwrap();
    let corner = r#"{"kind":"corner","tiles":[[0,0,0,0]]}"#;
    std::fs::write(place.path().join("corner.json"), corner).unwrap();
    let lonely = r#"{"kind":"wang","tiles":[[0,0,1,0]]}"#;
    std::fs::write(place.path().join("lonely.json"), lonely).unwrap();
    for (args, code, words) in [
        ("jeandel-rao --window 4", 2, "expected two numbers from 1 to 12"),
        ("jeandel-rao --window 4x1", 2, "at least 2x2"),
        ("jeandel-rao --window 99x2", 2, "from 1 to 12"),
        ("jeandel-rao --colors 9", 2, "9 is not in 2..=8"),
        ("jeandel-rao --moves 0", 2, "expected at least 1"),
        ("jeandel-rao -o no/where.json", 2, "no/where.json"),
        ("nowhere.json", 2, "BASE is jeandel-rao or a tile set file"),
        ("corner.json", 2, "expected Wang tiles"),
        ("w.json --patch 3x3", 2, "--patch 3x3"),
        ("w.json --patch 9999x9999", 2, "1048576 cells"),
        ("lonely.json", 1, "no legal 60x60 patch exists"),
        ("jeandel-rao --rounds 1 --moves 10 --colors 2", 1, "no coloring meets"),
        ("jeandel-rao --time-limit 0", 75, "0 rounds"),
    ] {
        let (found, out, errors) = run(&place, &format!("aperiodic color {args}"));
        assert!(found == code && errors.contains(words), "{args}: {found} {out} {errors}");
    }
    let (code, _, errors) = run(&place, "aperiodic color");
    assert_eq!(code, 2);
    assert!(errors.contains("BASE"), "{errors}");
}
