//! HyperQueue: a worker is killed while parts run, they go on elsewhere, the count is exact.
//!
//! The Python package brings the server, the workers and the submission of jobs, but not the
//! program `hq`; `hq.py` stands in for the part of it that the job file uses.

use crate::processes::Daemon;
use crate::{Place, find, said, sh, skip, wait};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

const STAND_IN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cluster/hq.py");

fn python(args: &[&str]) -> Command {
    let mut command = Command::new("python3");
    command.args(args).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Starts the server or a worker; its own folder appears when it is ready.
fn start(place: &Place, role: &str, own: &str) -> Daemon {
    let (server, own) = (place.path("server"), place.path(own));
    let ready = own.join("ready");
    let arguments = [STAND_IN, role, server.to_str().unwrap(), own.to_str().unwrap()];
    let mut daemon = Daemon::start(&mut python(&arguments));
    let state = || format!("{role} in {}", own.display());
    wait(20, "it is ready", || ready.exists() || daemon.has_ended(), state);
    assert!(ready.exists(), "{} ended early", state());
    daemon
}

#[test]
fn a_worker_is_killed() {
    let installed = find("python3").is_some()
        && python(&["-c", "import hyperqueue"]).status().is_ok_and(|status| status.success());
    if !installed {
        return skip("the Python package hyperqueue is not installed");
    }
    let place = Place::new();
    let script = place.script("hyperqueue");
    let _server = start(&place, "server", "server");
    let mut first = start(&place, "worker", "first");
    let _second = start(&place, "worker", "second");

    let bin = place.path("bin");
    stand_in(&bin, &place.path("server"));
    let path = std::env::var("PATH").unwrap();
    let path = format!("{}:{path}", bin.display());
    let (code, text) = said(&sh(&script).env("PATH", path).output().unwrap());
    assert_eq!(code, 0, "{text}");

    let state = || format!("{:#?}", place.logs());
    // Four at a time, in their order.
    let saved = || (0..4).filter(|&part| place.has_checkpoint(part)).count() >= 3;
    wait(30, "parts of both workers are saved", saved, state);
    first.kill();
    wait(120, "all parts are done", || place.merge().0 == 0, state);
    place.counts();
    let again = place.logs().iter().filter(|(_, log)| log.contains("instance 1")).count();
    assert!(again >= 1, "{}", state());
}

/// The program `hq`, to be found on the path.
fn stand_in(bin: &Path, server: &Path) {
    fs::create_dir(bin).unwrap();
    let hq = bin.join("hq");
    let quote = tilepack::cluster::quote;
    let (stand_in, server) = (quote(STAND_IN), quote(server.to_str().unwrap()));
    fs::write(&hq, format!("#!/bin/sh\nexec python3 {stand_in} hq {server} \"$@\"\n")).unwrap();
    fs::set_permissions(&hq, fs::Permissions::from_mode(0o755)).unwrap();
}
