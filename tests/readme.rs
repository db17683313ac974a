//! Every command shown in the README and on other pages, run as shown, in an empty folder for each
//! page.
//!
//! A line that begins with `$ ` is a command; the lines after it are what it prints, where `...`
//! stands for anything. A command without such lines may print what it likes.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::process::Command;

const README: &str = include_str!("../README.md");

/// Pages, and the fewest commands they show.
const PAGES: &[(&str, &str, usize)] = &[
    ("README.md", README, 10),
    ("docs/long-runs.md", include_str!("../docs/long-runs.md"), 15),
    ("docs/boards.md", include_str!("../docs/boards.md"), 8),
    ("docs/aperiodic.md", include_str!("../docs/aperiodic.md"), 8),
    ("docs/classification.md", include_str!("../docs/classification.md"), 10),
    ("docs/coverings.md", include_str!("../docs/coverings.md"), 3),
    ("docs/exports.md", include_str!("../docs/exports.md"), 6),
    ("docs/atlas.md", include_str!("../docs/atlas.md"), 11),
    ("docs/formats-out.md", include_str!("../docs/formats-out.md"), 18),
    ("docs/tilings.md", include_str!("../docs/tilings.md"), 9),
    ("docs/shaders.md", include_str!("../docs/shaders.md"), 5),
    ("docs/dappled.md", include_str!("../docs/dappled.md"), 30),
    ("docs/texture.md", include_str!("../docs/texture.md"), 7),
    ("docs/search.md", include_str!("../docs/search.md"), 2),
    ("docs/packings.md", include_str!("../docs/packings.md"), 4),
    ("docs/coloring.md", include_str!("../docs/coloring.md"), 4),
    ("docs/first-packings.md", include_str!("../docs/first-packings.md"), 8),
];

/// Programs of others that a page may show, besides our own.
const OTHERS: &[&str] = &["cat", "cmp", "echo", "grep", "sed"];

/// A command and the lines shown below it.
struct Example<'a> {
    command: &'a str,
    shown: Vec<&'a str>,
}

fn examples(page: &'static str) -> Vec<Example<'static>> {
    let mut examples: Vec<Example<'static>> = Vec::new();
    let blocks = page.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    for block in blocks {
        let before = examples.len();
        for line in block.lines() {
            match line.strip_prefix("$ ") {
                Some(command) => examples.push(Example { command, shown: Vec::new() }),
                None => {
                    assert!(examples.len() > before, "output before a command: {line}");
                    examples.last_mut().unwrap().shown.push(line);
                }
            }
        }
    }
    examples
}

/// Whether the lines printed are those shown, `...` standing for any text, also over lines.
fn matches(shown: &str, printed: &str) -> bool {
    let mut parts = shown.split("...");
    let Some(mut rest) = printed.strip_prefix(parts.next().unwrap()) else { return false };
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.trim().is_empty() || shown.trim_end().ends_with("...")
}

/// Whether a command can be run here: all but `b3sum` is part of every system.
fn can_be_run(command: &str) -> bool {
    let there = |program| Command::new(program).arg("--version").output().is_ok();
    let can = !command.ends_with("| b3sum") || there("b3sum");
    if !can {
        eprintln!("skipped, for there is no b3sum: {command}");
    }
    can
}

#[test]
fn commands_do_what_the_pages_show() {
    for &(name, page, fewest) in PAGES {
        let run = run_page(page);
        assert!(run >= fewest, "{name}: only {run} commands found");
    }
}

/// Copies a folder and the folders in it.
fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir(to).unwrap();
    for file in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
        let (from, to) = (file.path(), to.join(file.file_name()));
        match from.is_dir() {
            true => copy_folder(&from, &to),
            false => drop(std::fs::copy(from, to).unwrap()),
        }
    }
}

/// Runs the commands of a page; how many.
fn run_page(page: &'static str) -> usize {
    let binary = Path::new(env!("CARGO_BIN_EXE_tilepack"));
    let folder = tempfile::tempdir().unwrap();
    // Pages name the files of this folder as one finds them.
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/data");
    copy_folder(data.as_ref(), &folder.path().join("data"));
    let solutions = concat!(env!("CARGO_MANIFEST_DIR"), "/solutions");
    copy_folder(solutions.as_ref(), &folder.path().join("solutions"));
    let path = std::env::join_paths(
        std::iter::once(binary.parent().unwrap().to_owned())
            .chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
    )
    .unwrap();
    let mut run = 0;
    for Example { command, shown } in examples(page) {
        // The tests are being run; the program has been built.
        if command == "cargo test" {
            continue;
        }
        let command = command.replace("cargo run --release --", "tilepack");
        let of_others = OTHERS.iter().any(|program| command.starts_with(&format!("{program} ")));
        let known = of_others || command.contains("tilepack ");
        assert!(known, "not a command of ours: {command}");
        if !can_be_run(&command) {
            continue;
        }
        let mut shell = Command::new("sh");
        let output = shell.arg("-c").arg(&command).current_dir(&folder).env("PATH", &path).output();
        let output = output.unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{command}\n{printed}{errors}");
        if !shown.is_empty() {
            let shown = shown.join("\n");
            assert!(matches(&shown, &printed), "{command}\nshown:\n{shown}\nprinted:\n{printed}");
        }
        run += 1;
    }
    run
}

#[test]
fn the_first_two_commands_need_nothing_else() {
    let commands: Vec<&str> = examples(README).iter().map(|example| example.command).collect();
    assert!(commands[0].starts_with("cargo run --release -- find"));
    assert_eq!(commands[1], "cargo test");
}
