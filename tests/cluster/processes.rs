//! Processes that a test starts: ended when it ends, and found by what is theirs alone.

use std::fs;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

/// A process that does not outlive the test.
pub(crate) struct Daemon(Child);

impl Daemon {
    pub(crate) fn start(command: &mut Command) -> Self {
        Self(command.spawn().unwrap())
    }

    /// Ends it as a power cut would.
    pub(crate) fn kill(&mut self) {
        self.0.kill().unwrap();
        self.0.wait().unwrap();
    }

    pub(crate) fn has_ended(&mut self) -> bool {
        self.0.try_wait().unwrap().is_some()
    }
}

impl Drop for Daemon {
    fn drop(&mut self) {
        if self.has_ended() {
            return;
        }
        signal(self.0.id(), "TERM");
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(5) {
            if self.has_ended() {
                return;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        self.kill();
    }
}

/// Sends a signal to one process; it may have ended.
pub(crate) fn signal(pid: u32, name: &str) {
    let pid = pid.to_string();
    let _ = Command::new("kill").args(["-s", name, &pid]).output();
}

/// The processes whose file `name` in /proc, entries separated by zeros, has all these entries.
/// An entry must be one of this test alone, such as the path of a temporary file.
pub(crate) fn with(name: &str, entries: &[String]) -> Vec<u32> {
    let mut found = Vec::new();
    for process in fs::read_dir("/proc").unwrap().flatten() {
        let Some(pid) = process.file_name().to_str().and_then(|name| name.parse().ok()) else {
            continue;
        };
        let content = fs::read(process.path().join(name)).unwrap_or_default();
        let has = |entry: &String| content.split(|&b| b == 0).any(|part| part == entry.as_bytes());
        if entries.iter().all(has) {
            found.push(pid);
        }
    }
    found
}

/// The parents of processes that are named `slurmstepd`.
pub(crate) fn parents(pids: &[u32]) -> Vec<u32> {
    let mut parents = Vec::new();
    for pid in pids {
        let status = fs::read_to_string(format!("/proc/{pid}/status")).unwrap_or_default();
        let parent = status.lines().find_map(|line| line.strip_prefix("PPid:"));
        let parent = parent.and_then(|parent| parent.trim().parse().ok()).unwrap_or(0);
        let name = fs::read_to_string(format!("/proc/{parent}/comm")).unwrap_or_default();
        if name.starts_with("slurmstepd") && !parents.contains(&parent) {
            parents.push(parent);
        }
    }
    parents
}
