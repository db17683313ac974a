//! Programs of others that the tests ask.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where a program is on the path. Without it the test must not pass where all are wanted, else it
/// says that it is skipped; not by a macro, whose output is shown for failed tests only.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&path)
        .map(|folder| folder.join(program))
        .find(|file| file.is_file());
    if found.is_none() {
        let wanted = std::env::var("CI").is_ok_and(|ci| ci == "true");
        assert!(!wanted, "{program} is not installed: see .ci/textures");
        let _ = writeln!(std::io::stderr(), "skipped: {program} is not installed");
    }
    found
}

/// Runs a program, which must succeed, and gives all it printed.
#[track_caller]
pub(crate) fn run(command: &mut Command, about: &str) -> String {
    let output = command.output().unwrap();
    let printed = [&output.stdout[..], &output.stderr].concat();
    let printed = String::from_utf8_lossy(&printed).into_owned();
    assert!(output.status.success(), "{about}: {command:?}\n{printed}");
    printed
}

/// What a page in a headless browser looks like when its scripts are done: the document, as text.
pub(crate) fn browse(chromium: &Path, page: &Path, more: &[&str]) -> String {
    let profile = tempfile::tempdir().unwrap();
    let mut command = Command::new(chromium);
    command
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"])
        .args(["--disable-dev-shm-usage", "--disable-extensions", "--no-first-run"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .args(more)
        .arg("--dump-dom")
        .arg(format!("file://{}", page.display()));
    let output = command.output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The text of the element with this id, which holds nothing that needs quoting.
#[track_caller]
pub(crate) fn element<'a>(document: &'a str, id: &str) -> &'a str {
    let begin = format!("id=\"{id}\">");
    let Some((_, rest)) = document.split_once(&begin) else { panic!("no {id} in\n{document}") };
    rest.split("</").next().unwrap()
}
