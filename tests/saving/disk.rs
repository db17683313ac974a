//! A disk that is full, a folder that takes no files.

use crate::{LIST, PINS, Place, text};
use std::fs;
use std::process::Command;
use std::time::{Duration, Instant};

/// A file system of a few kilobytes, where we may make one.
#[cfg(target_os = "linux")]
struct Small<'a>(&'a Place);

#[cfg(target_os = "linux")]
impl<'a> Small<'a> {
    fn mount(place: &'a Place, size: &str) -> Option<Self> {
        fs::create_dir(place.path("small")).unwrap();
        let size = format!("size={size}");
        let mut mount = Command::new("mount");
        let mount = mount.args(["-t", "tmpfs", "-o", &size, "tmpfs"]).arg(place.path("small"));
        match mount.output() {
            Ok(output) if output.status.success() => Some(Self(place)),
            _ => {
                println!("skipped: no file system can be mounted here");
                None
            }
        }
    }
}

#[cfg(target_os = "linux")]
impl Drop for Small<'_> {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(self.0.path("small")).status();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_ends_no_search() {
    let place = Place::new();
    let Some(_small) = Small::mount(&place, "16k") else { return };
    let fill = || fs::write(place.path("small/fill"), vec![0; 1 << 14]).unwrap_err();
    let args = "count --kind domino --colors 5 --json --threads 1 --checkpoint small/x.ck \
                --checkpoint-every 50ms";
    let child = place.start(args);
    let begin = Instant::now();
    while !place.path("small/x.ck").exists() && begin.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    fill();
    let run = crate::Run::of(child.wait_with_output().unwrap()).exits(0);
    let warning = "warning: no checkpoint: small/x.ck: cannot be written: ";
    assert!(run.stderr.contains(warning), "{run:?}");
    assert_eq!(text(&run.json(), "solutions"), "24883200000");
    // The last checkpoint before the disk was full is still there and good.
    let saved = place.run("resume small/x.ck --node-limit 0");
    assert_eq!(saved.code, Some(2), "it cannot be saved again: {saved:?}");
    assert!(saved.stderr.contains("the last checkpoint was not saved"), "{saved:?}");
    fs::remove_file(place.path("small/fill")).unwrap();
    let object = place.run("resume small/x.ck --json").exits(0).json();
    assert_eq!(text(&object, "solutions"), "24883200000");
    assert_eq!(text(&object, "nodes"), "533248617");
}

/// Packings that find no room wait in memory: the list is complete all the same.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_loses_no_packing() {
    let place = Place::new();
    let Some(_small) = Small::mount(&place, "200k") else { return };
    fs::write(place.path("pins.txt"), PINS).unwrap();
    place.run(&format!("{LIST} -o whole.jsonl")).exits(0);
    let args = format!("{LIST} -o list.jsonl --checkpoint small/x.ck --checkpoint-every 50ms");
    let run = place.run(&args).exits(0);
    assert!(run.stderr.contains("warning: no checkpoint: small/x.ck.packings: "), "{run:?}");
    let read = |file: &str| fs::read(place.path(file)).unwrap();
    assert!(read("list.jsonl") == read("whole.jsonl"));
}

/// The same by a limit on the size of files, which needs no rights.
#[cfg(unix)]
#[test]
fn a_limit_on_files_is_like_a_full_disk() {
    let place = Place::new();
    // With XFSZ ignored, writing fails instead of ending the process.
    let limited = "trap '' XFSZ; ulimit -f 0; exec tilepack count --kind corner --colors 3 --quiet";
    let run = place.shell(&format!("{limited} --checkpoint x.ck --node-limit 9000"));
    assert_eq!(run.code, Some(2), "{run:?}");
    assert!(run.stdout.starts_with("at least "), "what was found is told: {run:?}");
    assert!(run.stderr.contains("the last checkpoint was not saved: x.ck: "), "{run:?}");
    assert!(!place.path("x.ck").exists() && !place.path("x.ck.part").exists());
}

#[cfg(unix)]
#[test]
fn a_folder_that_takes_no_files() {
    let place = Place::new();
    let refused = |args: &str, told: &str| {
        let run = place.run(args).exits(2);
        assert!(run.stderr.contains(told), "{run:?}");
        assert_eq!(run.stdout, "");
    };
    let count = "count --kind wang --colors 2";
    refused(&format!("{count} --checkpoint none/x.ck"), "none/x.ck");
    fs::create_dir(place.path("folder")).unwrap();
    refused(&format!("{count} --checkpoint folder"), "folder: ");
    refused("resume folder", "folder: is a directory");
    refused("resume none", "none: no such file");
    // Root may write anywhere but here.
    if fs::metadata("/proc/self").is_ok() {
        refused(&format!("{count} --checkpoint /proc/x.ck"), "/proc/x.ck");
    }
    let owner = Command::new("id").arg("-u").output().unwrap().stdout;
    if owner != b"0\n" {
        let script = "mkdir locked; chmod a-w locked";
        place.shell(script).exits(0);
        refused(&format!("{count} --checkpoint locked/x.ck"), "locked/x.ck");
    }
}

/// Makes a folder refuse new files, as far as we may, and takes that back.
#[cfg(target_os = "linux")]
fn set_read_only(place: &Place, folder: &str, read_only: bool) -> bool {
    let owner = Command::new("id").arg("-u").output().unwrap().stdout;
    // Permissions do not bind root, a mark of the file system does where there is one.
    let script = match (owner == b"0\n", read_only) {
        (true, true) => format!("chattr +i {folder} 2>&1"),
        (true, false) => format!("chattr -i {folder} 2>&1"),
        (false, true) => format!("chmod a-w {folder}"),
        (false, false) => format!("chmod u+w {folder}"),
    };
    place.shell(&script).code == Some(0)
}

/// Made read-only while a search runs: it goes on, says so, and the old checkpoint is good.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_becomes_read_only() {
    let place = Place::new();
    fs::create_dir(place.path("folder")).unwrap();
    let args = "count --kind domino --colors 5 --json --threads 1 --checkpoint folder/x.ck \
                --checkpoint-every 50ms";
    let child = place.start(args);
    while !place.path("folder/x.ck").exists() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let locked = set_read_only(&place, "folder", true);
    let run = crate::Run::of(child.wait_with_output().unwrap()).exits(0);
    assert_eq!(text(&run.json(), "solutions"), "24883200000");
    if !locked {
        println!("skipped: no folder can be made read-only here");
        return;
    }
    let refused = place.run("resume folder/x.ck");
    assert!(set_read_only(&place, "folder", false));
    assert!(run.stderr.contains("warning: no checkpoint: folder/x.ck"), "{run:?}");
    assert!(refused.clone().exits(2).stderr.contains("folder/x.ck"), "{refused:?}");
    let object = place.run("resume folder/x.ck --json").exits(0).json();
    assert_eq!(text(&object, "nodes"), "533248617");
}
