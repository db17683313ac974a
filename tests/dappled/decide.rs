//! `dapple decide` as users meet it.

use crate::program::run;
use serde_json::Value;
use tempfile::TempDir;

fn place() -> TempDir {
    let place = TempDir::new().unwrap();
    let write = |name: &str, text: &str| std::fs::write(place.path().join(name), text).unwrap();
    write("five.txt", "???0?\n0?1??\n?????\n???1?\n????1\n");
    write("wrong.txt", "000.\n....\n");
    write("strange.txt", "01\n02\n");
    write("ragged.txt", "01\n0\n");
    place
}

#[test]
fn completions_and_cores() {
    let place = place();
    let (code, out, remarks) = run(&place, "dapple decide five.txt");
    assert_eq!((code, out.lines().count()), (0, 5));
    assert!(remarks.contains("5 given cells, found by search; checked"), "{remarks}");
    std::fs::write(place.path().join("done.txt"), &out).unwrap();
    assert_eq!(run(&place, "dapple check done.txt").0, 0);

    let core = "...0.\n0.1..\n.....\n...1.\n.....\n";
    let (code, out, _) = run(&place, "dapple decide five.txt --cyclic");
    assert_eq!(code, 1);
    let head = "# impossible: 4 of 5 given cells have no completion; \
                without any one of them there is one\n";
    assert_eq!(out, format!("{head}{core}"));
    // What is told is a file that can be decided again.
    std::fs::write(place.path().join("core.txt"), &out).unwrap();
    let args = "dapple decide core.txt --cyclic --proof p.drat --formula p.cnf --quiet -o no.txt";
    let (code, out, remarks) = run(&place, args);
    assert_eq!((code, remarks.as_str()), (1, ""));
    assert!(out.ends_with(core), "{out}");
    assert!(!place.path().join("no.txt").exists());
    let formula = std::fs::read_to_string(place.path().join("p.cnf")).unwrap();
    assert!(formula.contains("\np cnf 25 "), "{formula}");
    let proof = std::fs::read_to_string(place.path().join("p.drat")).unwrap();
    assert!(proof.ends_with("\n0\n"), "{proof}");

    let (code, out, _) = run(&place, "dapple decide wrong.txt --json");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (1, Some("impossible")));
    assert_eq!(object["core_cells"].to_string(), "[[0,0],[1,0],[2,0]]");
    assert_eq!(object["core"][0].to_string(), "[0,0,0,null]");
    assert_eq!((object["minimal"].as_bool(), object["given"].as_u64()), (Some(true), Some(3)));
}

#[test]
fn files_and_seeds() {
    let place = place();
    for seed in ["1", "2", "1"] {
        let name =
            format!("dapple decide --size 9x7 --cylinder --seed {seed} -o {seed}.png --json");
        let (code, out, _) = run(&place, &name);
        let object: Value = serde_json::from_str(&out).unwrap();
        assert_eq!((code, object["result"].as_str()), (0, Some("found")));
        assert!(object["tiles"].is_null());
        assert_eq!(run(&place, &format!("dapple check {seed}.png --cylinder")).0, 0);
    }
    let bytes = |name: &str| std::fs::read(place.path().join(name)).unwrap();
    assert_ne!(bytes("1.png"), bytes("2.png"));
}

#[test]
fn numbers() {
    let place = place();
    let (code, out, _) = run(&place, "dapple decide --size 8x8 --counts 1");
    let run_of = "disjoint runs of cells, each of which needs one";
    let expected = format!(
        "tile 1: 21..43 of 64 cells\nfewer than 21: none ({run_of})\nmore than 43: none ({run_of})\n"
    );
    assert_eq!((code, out), (0, expected));
    let (code, out, _) = run(&place, "dapple decide --size 8x8 --count 1=21 --quiet");
    assert_eq!((code, out.matches('1').count()), (0, 21));
    let (code, out, _) = run(&place, "dapple decide --size 8x8 --count 1=20");
    assert_eq!(code, 1);
    assert_eq!(out, format!("# impossible: 20 of tile 1; there are at least 21 ({run_of})\n"));
    let (code, out, _) = run(&place, "dapple decide five.txt --count 1=8 --json");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (1, Some("impossible")));
    assert!(object["reason"].as_str().unwrap().contains("8 of tile 1"));
    let (code, out, _) = run(&place, "dapple decide --size 3x1 --cyclic --counts 0 --json");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (1, Some("none")));
}

#[test]
fn stopping() {
    let place = place();
    let args = "dapple decide --size 200x200 --time-limit 0";
    assert_eq!(run(&place, args).0, 75);
    assert_eq!(run(&place, args).1, "stopped: not decided\n");
    let (code, out, _) = run(&place, &format!("{args} --json"));
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (75, Some("stopped")));
    let (code, out, _) = run(&place, "dapple decide --size 80x80 --counts 0 --time-limit 0");
    assert_eq!(code, 75);
    assert!(out.contains("not decided: "), "{out}");
}

#[test]
fn bad_input() {
    let place = place();
    for (args, message) in [
        ("strange.txt", "strange.txt:2:2: '2': expected a tile below 2"),
        ("ragged.txt", "ragged.txt:2:1: 1 cells in this row, expected 2"),
        ("missing.txt", "missing.txt"),
        ("--size 0x4", "--size: size 0x4"),
        ("--size 9", "--size"),
        ("--size 60000x60000", "--size"),
        ("--size 4000x4000", "too large for an exact answer"),
        ("five.txt --size 5x5", "cannot be used with"),
        ("", "required"),
        ("five.txt --limits 0,2", "a limit of 0"),
        ("five.txt --limits 2:2,2", "tile 2: expected one below 2"),
        ("five.txt --count 1", "expected a tile and a number, such as 1=20"),
        ("five.txt --count 1=26", "there are only 25 cells"),
        ("five.txt --count 2=5", "--count: tile 2: expected one below 2"),
        ("five.txt --counts 2", "--counts: tile 2: expected one below 2"),
        ("five.txt --counts 1 --count 1=9", "cannot be used with"),
        ("five.txt --formula f.cnf", "required"),
        ("five.txt -o no/where.txt", "no/where.txt"),
        ("five.txt --cyclic --cylinder", "cannot be used with"),
    ] {
        let (code, out, remarks) = run(&place, &format!("dapple decide {args}"));
        assert_eq!((code, out.as_str()), (2, ""), "{args}: {remarks}");
        assert!(remarks.contains(message), "{args}: {remarks}");
    }
}
