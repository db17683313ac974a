//! Files that are written: whole, in place, and told of.

use crate::{Place, run};

#[test]
fn the_same_question_gives_the_same_bytes() {
    let place = Place::new();
    for threads in ["1", "3"] {
        let args = format!(
            "find --kind corner --colors 3 --method search --threads {threads} -o {threads}.json"
        );
        let found = place.run(&args).exits(0);
        assert_eq!(found.stdout, "");
        assert!(found.stderr.ends_with(&format!("; written to {threads}.json\n")), "{found:#?}");
    }
    assert_eq!(place.read("1.json"), place.read("3.json"));
}

#[test]
fn nothing_else_is_left_in_the_directory() {
    let place = Place::new();
    place.run("find --kind corner --colors 2 -o a.json").exits(0);
    place.run("list --kind corner --colors 2 -o b.jsonl").exits(0);
    place.run("count --kind corner --colors 3 --node-limit 1000").exits(75);
    place
        .run("find --kind corner --colors 3 --method search --node-limit 1000 -o c.json")
        .exits(75);
    let mut names: Vec<_> = std::fs::read_dir(place.path(""))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["a.json", "b.jsonl"]);
}

#[test]
fn an_output_that_cannot_be_written_is_told_before_the_search() {
    let begin = std::time::Instant::now();
    // This search would go on for years.
    let refused = run("count --kind corner --colors 4 --time-limit 0").exits(75);
    assert!(refused.stdout.starts_with("at least 0 packings"), "{refused:#?}");
    run("list --kind corner --colors 4 -o no/where.jsonl").exits(2);
    run("find --kind corner --colors 5 -o no/where.json").exits(2);
    assert!(begin.elapsed().as_secs() < 30);
}

/// Commands with examples that need nothing but each other.
const COMMANDS: &[&str] = &[
    "",
    "find",
    "count",
    "sets",
    "export",
    "import",
    "tile",
    "atlas",
    "lint",
    "fill",
    "dapple",
    "dapple make",
    "dapple check",
    "dapple decide",
    "dapple draw",
    "dapple flow",
    "brick",
    "dapple count",
    "dapple sample",
    "dapple closest",
];

#[test]
fn help_and_version() {
    let version = run("--version").exits(0);
    assert_eq!(version.stdout, format!("tilepack {}\n", env!("CARGO_PKG_VERSION")));
    for command in COMMANDS.iter().chain(&["locate", "list", "verify", "show", "cube", "walk"]) {
        for option in ["--help", "-h"] {
            let help = run(&format!("{command} {option}")).exits(0);
            assert!(help.stdout.contains("Examples:"), "{command} {option}");
            assert!(help.stdout.contains(&format!("tilepack {command}")), "{command} {option}");
            assert_eq!(help.stderr, "");
        }
    }
}

/// Every example of the help texts works as it stands.
#[test]
fn the_examples_run() {
    let place = Place::new();
    place.write("begun.txt", "0 0 . .\n. . . .\n. . . .\n. . . .\n");
    place.write("field.txt", "1111\n1111\n0110\n");
    place.write("kept.txt", "....\n.11.\n....\n");
    place.write("weights.txt", "1 2 3 4\n5 6 7 8\n9 0 1 2\n");
    place.write("given.txt", "00...\n.....\n.11..\n.....\n..0..\n");
    place.run("find --kind corner --colors 4 --automorphism 4,0:1,2,3,0 --values random --quiet");
    let mut tried = 0;
    for command in COMMANDS.iter().chain(&[
        "aperiodic color",
        "aperiodic sets",
        "aperiodic convert",
        "aperiodic patch",
    ]) {
        let help = run(&format!("{command} --help")).stdout;
        for line in help.lines().filter(|line| line.starts_with("  tilepack ")) {
            let line = line.split("   ").next().unwrap();
            for part in line.split(';').take_while(|part| !part.contains('|')) {
                let args = part.split('#').next().unwrap().trim();
                let args = args.strip_prefix("tilepack ").unwrap();
                let code = place.run(&args.replace("1m", "100ms")).code;
                assert!(code == 0 || code == 75 && args.contains("limit"), "{args}: {code}");
                tried += 1;
            }
        }
    }
    assert!(tried >= 17, "{tried}");
}
