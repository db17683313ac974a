//! GNU parallel: a part is killed, the same script goes on, the count is exact.

use crate::{Place, find, processes, said, sh, skip, wait};

#[test]
fn a_part_is_killed() {
    if find("parallel").is_none() {
        return skip("GNU parallel is not installed");
    }
    let place = Place::new();
    let script = place.script("parallel");
    let run = |options: &[&str]| {
        let mut command = sh(&script);
        // It asks for citations in papers when its output is seen by a person, once a user.
        command.env("PARALLEL_HOME", place.path("parallel")).args(options);
        command
    };
    // Without further attempts, so that the part is missing in the end.
    let part = ["--part".into(), "3".into(), place.plan().to_str().unwrap().into()];
    let parts = || processes::with("cmdline", &part);
    let output = std::thread::scope(|scope| {
        let parallel = scope.spawn(|| run(&["--jobs", "4", "--retries", "1"]).output().unwrap());
        wait(30, "part 3 is saved", || place.has_checkpoint(3), || format!("{:?}", place.logs()));
        for pid in parts() {
            processes::signal(pid, "KILL");
        }
        parallel.join().unwrap()
    });
    assert_eq!(said(&output).0, 1, "{output:?} {:?}", place.logs());
    let (code, text) = place.merge();
    assert!(code == 75 && text.contains('3'), "{code} {text}");

    let (code, text) = said(&run(&["--jobs", "4"]).output().unwrap());
    assert_eq!(code, 0, "{text} {:?}", place.logs());
    place.counts();
    // Once more: nothing is left to do.
    assert_eq!(said(&run(&[]).output().unwrap()).0, 0);
}
