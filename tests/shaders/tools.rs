//! Programs of others that the tests ask.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

/// Longer than any page takes, on a machine with other work.
const PATIENCE: Duration = Duration::from_secs(150);

/// Where a program is on the path. Without it the test must not pass where all are wanted, else it
/// says that it is skipped; not by a macro, whose output is shown for failed tests only.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let found =
        std::env::split_paths(&path).map(|folder| folder.join(program)).find(|file| file.is_file());
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

/// What a page in a headless browser writes to its console after the word `ANSWERS`: one line, when
/// its scripts are done. The browser is ended then.
pub(crate) fn browse(chromium: &Path, page: &Path) -> String {
    let profile = tempfile::tempdir().unwrap();
    let mut command = Command::new(chromium);
    command
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader"])
        .args(["--disable-dev-shm-usage", "--disable-extensions", "--no-first-run"])
        // Console to standard error; with a port, the browser stays until it is ended.
        .args(["--enable-logging=stderr", "--remote-debugging-port=0", "--window-size=560,420"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("file://{}", page.display()));
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let lines = BufReader::new(child.stderr.take().unwrap()).split(b'\n');
    let (tell, told) = mpsc::channel();
    let reader = thread::spawn(move || {
        for line in lines.map_while(Result::ok) {
            // Nobody listens any more once the answers are there.
            let _ = tell.send(String::from_utf8_lossy(&line).into_owned());
        }
    });
    let end = Instant::now() + PATIENCE;
    let mut said = String::new();
    let answers = loop {
        let left = end.saturating_duration_since(Instant::now());
        let Ok(line) = told.recv_timeout(left) else { break None };
        let answers = line.split_once("\"ANSWERS ").map(|(_, rest)| rest);
        if let Some((answers, _)) = answers.and_then(|rest| rest.rsplit_once("\", source: ")) {
            break Some(answers.to_owned());
        }
        said += &line;
        said.push('\n');
    };
    child.kill().unwrap();
    child.wait().unwrap();
    reader.join().unwrap();
    answers.unwrap_or_else(|| panic!("no answers from {}:\n{said}", page.display()))
}
