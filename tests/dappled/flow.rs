//! `dapple flow` as users meet it.

use crate::program::run;
use serde_json::Value;
use tempfile::TempDir;

#[test]
fn pictures_and_pages() {
    let place = TempDir::new().unwrap();
    assert_eq!(run(&place, "dapple decide --size 8x6 --cyclic --limits 2,3 -o a.txt").0, 0);
    let (code, out, _) = run(&place, "dapple flow a.txt --cyclic -o a.svg --json");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, object["result"].as_str()), (0, Some("drawn")));
    assert_eq!(object["streams"], object["closed"]);
    assert!(object["straight"][0].as_u64().unwrap() <= 2);
    assert!(object["straight"][1].as_u64().unwrap() <= 3);
    let svg = std::fs::read_to_string(place.path().join("a.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("width=\"192\" height=\"144\""));
    let (code, _, remarks) = run(&place, "dapple flow a.txt -o a.png --cell-size 8");
    assert_eq!(code, 0);
    assert!(remarks.contains("straight through at most "), "{remarks}");
    assert_eq!(
        run(&place, "dapple flow a.txt -o a.html --quiet"),
        (0, String::new(), String::new())
    );
    let page = std::fs::read_to_string(place.path().join("a.html")).unwrap();
    let data = page.lines().find_map(|line| line.strip_prefix("const flow = ")).unwrap();
    let data: Value = serde_json::from_str(data.trim_end_matches(';')).unwrap();
    let mut next: Vec<u64> =
        data["next"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
    next.sort_unstable();
    // Every strand follows one: particles go on for ever.
    assert!(next.into_iter().eq(0..96));
    assert!(!page.contains('@') && !page.contains("http://localhost"));
}

#[test]
fn bad_input() {
    let place = TempDir::new().unwrap();
    std::fs::write(place.path().join("free.txt"), "01\n.0\n").unwrap();
    std::fs::write(place.path().join("three.txt"), "01\n20\n").unwrap();
    for (args, message) in [
        ("free.txt -o a.svg", "some cells are free"),
        ("three.txt -o a.svg", "three.txt:2:1: '2': expected a tile below 2"),
        ("free.txt -o a.gif", "expected a name that ends in svg, png or html"),
        ("free.txt", "required"),
        ("none.txt -o a.svg", "none.txt"),
        ("free.txt -o a.svg --cell-size 1", "4..=256"),
    ] {
        let (code, out, remarks) = run(&place, &format!("dapple flow {args}"));
        assert_eq!((code, out.as_str()), (2, ""), "{args}: {remarks}");
        assert!(remarks.contains(message), "{args}: {remarks}");
        assert!(!place.path().join("a.svg").exists());
    }
}
