//! Boards on the command line: wrong usage, told with what was expected.

use std::process::Command;

const MACMAHON: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/macmahon.json");

fn run(arguments: &str) -> (i32, String) {
    let mut words = arguments.split_whitespace();
    let mut command = Command::new(env!("CARGO_BIN_EXE_tilepack"));
    command.arg(words.next().unwrap()).args(["--kind", "wang", "--set", MACMAHON]);
    let output = command.args(words).output().unwrap();
    let text = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    (output.status.code().unwrap(), text.concat())
}

#[test]
fn wrong_usage_is_told() {
    for (arguments, expected) in [
        ("count --rotations --border 0", "it needs --topology rectangle or cylinder"),
        ("count --rotations --topology rectangle --border 3", "expected a color from 0 to 2"),
        ("count --rotations --topology rectangle --border missing", "missing"),
        ("count --rotations --topology disk", "disk"),
        ("count --rotations --size 5x5", "25 cells, but the set has 24 tiles"),
        ("count --rotations --cover", "coverings are on a torus"),
        ("count --rotations --colors 2,3", "colors 3 in the file"),
        ("count --topology cylinder --automorphism 1,0:+0", "automorphisms are on a torus"),
        ("find --rotations --method beam", "--method beam and --rotations"),
        ("find --rotations --method construct", "--rotations is for a search"),
        ("export-cnf --rotations", "export-cnf and --rotations"),
        ("export-xcc --topology rectangle", "export-xcc and --topology"),
    ] {
        let (code, text) = run(arguments);
        assert_eq!(code, 2, "{arguments}: {text}");
        assert!(text.contains(expected), "{arguments}: {text}");
    }
    let corner = "--kind corner --colors 2".split(' ');
    for option in [&["--rotations"][..], &["--topology", "rectangle"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tilepack"));
        let output = command.arg("count").args(corner.clone()).args(option).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(text.contains("for Wang tiles") || text.contains("only Wang tiles"), "{text}");
    }
}

#[test]
fn short_arguments_are_given() {
    let (code, text) = run("find --rotations --topology rectangle --border 0 --size 24x1");
    assert_eq!(code, 1);
    assert!(text.contains("fewer than the 50 places of the border"), "{text}");
}
