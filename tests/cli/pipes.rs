//! A reader that goes away is no error; a full disk is one.

use crate::Place;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};

fn program() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin!("tilepack"))
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let place = Place::new();
    let list = "list --kind wang --colors 2 --quiet";
    place.run(&format!("{list} -o all.jsonl")).exits(0);
    for args in [list, "show all.jsonl", "sets --kind corner --colors 40 --list"] {
        let mut child = program()
            .args(args.split_whitespace())
            .current_dir(place.path(""))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut first = String::new();
        let mut reader = BufReader::new(child.stdout.take().unwrap());
        reader.read_line(&mut first).unwrap();
        assert!(!first.is_empty());
        drop(reader);
        let mut stderr = String::new();
        child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
        let status = child.wait().unwrap();
        assert_eq!((status.code(), stderr.as_str()), (Some(0), ""), "{args}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let full = || std::fs::File::options().write(true).open("/dev/full").unwrap();
    for args in ["find --kind corner --colors 2 --quiet", "sets --kind corner --colors 2 --list"] {
        let output = program().args(args.split_whitespace()).stdout(full()).output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args}");
        assert!(stderr.starts_with("tilepack: standard output: cannot be written"), "{stderr}");
    }
    // Nobody hears the complaints: that is no reason to panic.
    let status = program()
        .args(["find", "--kind", "corner", "--colors", "2"])
        .stderr(full())
        .stdout(Stdio::null())
        .status()
        .unwrap();
    assert_eq!(status.code(), Some(0));
    let status = program().args(["verify", "none"]).stderr(full()).status().unwrap();
    assert_eq!(status.code(), Some(2));
}
