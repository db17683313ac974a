//! The texts of the job files: what they are exactly, that a shell takes names for what they are,
//! and what the command refuses.

use assert_cmd::cargo::cargo_bin_cmd;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use tilepack::cluster::{ClusterError, Job, Slurm, hyperqueue, parallel, quote, slurm};

fn job() -> Job {
    Job {
        program: "tilepack".into(),
        plan: "/disk/plan.json".into(),
        dir: "/disk/plan.json.parts".into(),
        parts: 16,
        threads: 1,
        checkpoint_every: None,
    }
}

const PLAIN: Slurm = Slurm { time: None, max_array: 1001 };

/// Compares with the files in `golden`; `TILEPACK_GOLDEN=write` writes them anew.
#[track_caller]
fn golden(file: &str, text: &str) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cluster/golden");
    if std::env::var_os("TILEPACK_GOLDEN").is_some_and(|value| value == "write") {
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join(file), text).unwrap();
    }
    assert_eq!(text, fs::read_to_string(folder.join(file)).unwrap(), "{file}");
}

#[test]
fn scripts() {
    golden("plain.slurm", &slurm(&job(), &PLAIN).unwrap());
    golden("plain.hyperqueue", &hyperqueue(&job()));
    golden("plain.parallel", &parallel(&job()));
}

#[test]
fn scripts_with_all_options() {
    let job = Job {
        program: "/opt/tile pack/bin/tilepack".into(),
        plan: "/disk/it's/plan.json".into(),
        dir: "/disk/parts".into(),
        parts: 2500,
        threads: 4,
        checkpoint_every: Some("10m".into()),
    };
    let options = Slurm { time: Some("24:00:00".into()), max_array: 1000 };
    golden("options.slurm", &slurm(&job, &options).unwrap());
    golden("options.hyperqueue", &hyperqueue(&job));
    golden("options.parallel", &parallel(&job));
}

/// Programs that say how they were called, one argument a line, in place of the schedulers.
struct Shell(TempDir);

impl Shell {
    fn new() -> Self {
        let shell = Self(TempDir::new().unwrap());
        for program in ["sbatch", "hq", "squeue", "scontrol"] {
            shell.program(program, &format!("printf '%s\\n' {program} \"$@\" END"));
        }
        shell
    }

    /// Puts a program on the path.
    fn program(&self, name: &str, body: &str) {
        let file = self.0.path().join(name);
        fs::write(&file, format!("#!/bin/sh\n{body}\n")).unwrap();
        let chmod = std::process::Command::new("chmod").arg("755").arg(&file).status();
        assert!(chmod.unwrap().success());
    }

    /// Runs a script with variables set; gives its exit code and standard output.
    fn run(&self, script: &str, variables: &[(&str, &str)], args: &[&str]) -> (i32, String) {
        let file = self.0.path().join("a script");
        fs::write(&file, script).unwrap();
        let path = std::env::var("PATH").unwrap();
        let path = format!("{}:{path}", self.0.path().display());
        let mut command = std::process::Command::new("sh");
        command.arg(&file).args(args).env("PATH", path).envs(variables.iter().copied());
        let output = command.output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        (output.status.code().unwrap(), text)
    }
}

const NASTY: [&str; 6] =
    ["it's", "two words", "$(false) `false`", "\"\\\"", "{} {.} {= die =} %", "new\nline * ~ é"];

#[test]
fn a_shell_takes_names_for_what_they_are() {
    let shell = Shell::new();
    for name in NASTY {
        let (code, text) = shell.run(&format!("printf '%s' {}", quote(name)), &[], &[]);
        assert_eq!((code, text.as_str()), (0, name));
    }
}

/// Whatever the names, a part is started with them, and logs go where they should.
#[test]
fn parts_get_their_names() {
    for name in NASTY {
        let shell = Shell::new();
        let folder = shell.0.path().join(name);
        let dir = folder.join("parts").to_str().unwrap().to_owned();
        let plan = folder.join("plan").to_str().unwrap().to_owned();
        let program = shell.0.path().join(format!("program {name}"));
        shell.program(&format!("program {name}"), "printf '%s\\n' \"$@\"; exit 3");
        let job = Job {
            program: program.to_str().unwrap().into(),
            plan: plan.clone(),
            dir: dir.clone(),
            ..job()
        };
        fs::create_dir_all(format!("{dir}/logs")).unwrap();
        let called =
            |part| format!("run\n{plan}\n--part\n{part}\n--dir\n{dir}\n--threads\n1\n--quiet\n");

        let task = [("HQ_TASK_ID", "5"), ("HQ_INSTANCE_ID", "0")];
        let ended = shell.run(&hyperqueue(&job), &task, &[]);
        assert_eq!(ended, (3, String::new()), "{name}");
        let log = fs::read_to_string(format!("{dir}/logs/part-5.log")).unwrap();
        assert!(log.contains(&called(5)), "{log}");

        let Ok(script) = slurm(&job, &PLAIN) else {
            assert!(name.contains(['%', '\\']));
            continue;
        };
        let task = [
            ("SLURM_ARRAY_JOB_ID", "7"),
            ("SLURM_ARRAY_TASK_ID", "2"),
            ("SLURMD_NODENAME", "node"),
        ];
        let (code, log) = shell.run(&script, &task, &["1001"]);
        assert!(code == 3 && log.contains(&called(1003)), "{log}");
    }
}

/// The `--array` and the first part of every submission.
fn arrays(parts: u64, max_array: u64) -> Vec<(String, u64)> {
    let shell = Shell::new();
    let dir = shell.0.path().join("parts").to_str().unwrap().to_owned();
    let options = Slurm { time: None, max_array };
    let script = slurm(&Job { parts, dir, ..job() }, &options).unwrap();
    let (code, text) = shell.run(&script, &[], &["--partition=long", "two words"]);
    assert_eq!(code, 0);
    let submissions = text.split_terminator("END\n").map(|text| {
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines[0], "sbatch");
        assert_eq!(lines[2..4], ["--partition=long", "two words"]);
        assert_eq!(lines[4], shell.0.path().join("a script").to_str().unwrap());
        (lines[1].into(), lines[5].parse().unwrap())
    });
    submissions.collect()
}

#[test]
fn arrays_are_as_long_as_slurm_allows() {
    let array = |last: u64, first| (format!("--array=0-{last}"), first);
    assert_eq!(arrays(1, 1001), [array(0, 0)]);
    assert_eq!(arrays(16, 16), [array(15, 0)]);
    assert_eq!(arrays(17, 16), [array(15, 0), array(0, 16)]);
    assert_eq!(arrays(2500, 1001), [array(1000, 0), array(1000, 1001), array(497, 2002)]);
    assert_eq!(arrays(3, 1), [array(0, 0), array(0, 1), array(0, 2)]);
}

#[test]
fn hyperqueue_gets_all_parts_at_once() {
    let shell = Shell::new();
    let dir = shell.0.path().join("parts").to_str().unwrap().to_owned();
    let (code, text) =
        shell.run(&hyperqueue(&Job { parts: 100, threads: 3, dir, ..job() }), &[], &["--pin"]);
    assert_eq!(code, 0);
    for option in ["hq\nsubmit\n", "\n--array=0-99\n", "\n--cpus=3\n", "\n--pin\n--\nsh\n"] {
        assert!(text.contains(option), "{option} {text}");
    }
}

/// A part that was stopped is requeued only while Slurm takes the job for running.
#[test]
fn slurm_requeues_what_was_stopped() {
    let task =
        [("SLURM_ARRAY_JOB_ID", "7"), ("SLURM_ARRAY_TASK_ID", "2"), ("SLURMD_NODENAME", "node")];
    for (code, state, requeued) in [
        (75, "RUNNING", true),
        (75, "COMPLETING", false),
        (75, "PENDING", false),
        (0, "RUNNING", false),
        (2, "RUNNING", false),
    ] {
        let shell = Shell::new();
        shell.program("squeue", &format!("echo {state}"));
        shell.program("tilepack", &format!("exit {code}"));
        let (ended, text) = shell.run(&slurm(&job(), &PLAIN).unwrap(), &task, &["0"]);
        assert_eq!(ended, code);
        let requeues = text.contains("scontrol\nrequeue\n7_2\nEND\n");
        assert_eq!(requeues, requeued, "{code} {state}: {text}");
    }
}

/// The script waits for the checkpoint of a part that a signal stopped, and knows its exit code.
#[test]
fn a_signal_to_the_script_reaches_the_part() {
    let shell = Shell::new();
    let begun = shell.0.path().join("begun");
    let begun_word = quote(begun.to_str().unwrap());
    shell.program(
        "tilepack",
        &format!("trap 'sleep 1; exit 75' TERM; touch {begun_word}; while :; do sleep 0.1; done"),
    );
    shell.program("squeue", "echo COMPLETING");
    let task =
        [("SLURM_ARRAY_JOB_ID", "7"), ("SLURM_ARRAY_TASK_ID", "2"), ("SLURMD_NODENAME", "node")];
    let script = format!("echo $$ >{begun_word}.pid\n{}", slurm(&job(), &PLAIN).unwrap());
    let (code, text) = std::thread::scope(|scope| {
        let run = scope.spawn(|| shell.run(&script, &task, &["0"]));
        crate::wait(20, "the part runs", || begun.exists(), String::new);
        let pid = fs::read_to_string(format!("{}.pid", begun.display())).unwrap();
        let kill = std::process::Command::new("kill").args(["-s", "TERM", pid.trim()]).status();
        assert!(kill.unwrap().success());
        run.join().unwrap()
    });
    assert!(code == 75 && text.contains("part 2: exit code 75\n"), "{code} {text}");
}

/// A program that is not there is no success.
#[test]
fn a_program_that_is_missing() {
    let shell = Shell::new();
    let dir = shell.0.path().join("parts").to_str().unwrap().to_owned();
    fs::create_dir_all(format!("{dir}/logs")).unwrap();
    let job = Job { program: "/no/such/program".into(), dir, ..job() };
    let task = [("HQ_TASK_ID", "5"), ("HQ_INSTANCE_ID", "0")];
    assert_eq!(shell.run(&hyperqueue(&job), &task, &[]).0, 127);
}

#[test]
fn folders_that_slurm_cannot_write_logs_to() {
    for dir in ["/disk/100%", "/disk/a\\b"] {
        let job = Job { dir: dir.into(), ..job() };
        assert_eq!(slurm(&job, &PLAIN), Err(ClusterError::SlurmFolder(dir.into())));
    }
}

/// The exit code of the command and what it printed.
fn cluster(folder: &TempDir, args: &str) -> (i32, String) {
    let mut command = cargo_bin_cmd!("tilepack");
    let command = command.arg("cluster").args(args.split_whitespace()).current_dir(folder);
    crate::said(&command.output().unwrap())
}

#[test]
fn bad_input() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("no.json"), "{\"kind\":\"corner\"}").unwrap();
    for (args, message) in [
        ("", "Usage"),
        ("pbs plan.json", "pbs"),
        ("slurm", "<PLAN>"),
        ("slurm missing.json", "missing.json"),
        ("slurm no.json", "no.json"),
        ("slurm no.json --time 5", "HH:MM:SS"),
        ("slurm no.json --max-array 0", "--max-array"),
        ("parallel no.json --time 01:00:00", "--time"),
        ("parallel no.json --threads 0", "--threads"),
        ("hyperqueue no.json --checkpoint-every often", "checkpoint-every"),
    ] {
        let (code, text) = cluster(&folder, args);
        assert!(code == 2 && text.contains(message), "{args}: {code} {text}");
    }
}
