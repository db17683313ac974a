//! Slurm: a node goes down while parts run, they go on at the other one, the count is exact.
//!
//! A controller and two nodes, all on this machine, with their own configuration, key, ports and
//! state in a temporary folder. Needs root, as Slurm does.

use crate::processes::{self, Daemon, signal};
use crate::{Place, find, said, sh, skip, wait};
use std::fs;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// A cluster of two nodes, n1 and n2, each with two processors.
struct Cluster {
    folder: tempfile::TempDir,
    nodes: Vec<Daemon>,
    controller: Option<Daemon>,
    munge: Option<Daemon>,
}

impl Cluster {
    /// Starts it, or says what is missing.
    fn start() -> Result<Self, String> {
        for program in ["slurmctld", "slurmd", "sbatch", "munged"] {
            find(program).ok_or(format!("{program} is not installed"))?;
        }
        let id = Command::new("id").arg("-u").output().unwrap();
        if said(&id).1.trim() != "0" {
            return Err("Slurm has to be run by root".into());
        }
        let folder = tempfile::tempdir().unwrap();
        let mut cluster = Self { folder, nodes: Vec::new(), controller: None, munge: None };
        let in_folder = |file: &str| cluster.path(file).to_str().unwrap().to_owned();
        fs::create_dir(cluster.path("munge")).unwrap();
        fs::set_permissions(cluster.path("munge"), fs::Permissions::from_mode(0o711)).unwrap();
        fs::create_dir(cluster.path("state")).unwrap();

        let key: Vec<u8> = (0..8).flat_map(|_| rand::random::<u128>().to_le_bytes()).collect();
        fs::write(cluster.path("munge/key"), key).unwrap();
        fs::set_permissions(cluster.path("munge/key"), fs::Permissions::from_mode(0o400)).unwrap();
        let mut munge = Command::new(find("munged").unwrap());
        munge.args(["--foreground", "--force"]);
        for file in ["socket", "key-file", "pid-file", "log-file", "seed-file"] {
            let name = file.trim_end_matches("-file");
            munge.arg(format!("--{file}={}", in_folder(&format!("munge/{name}"))));
        }
        munge.stdout(Stdio::null()).stderr(Stdio::null());
        fs::write(cluster.path("slurm.conf"), cluster.configuration()).unwrap();

        cluster.munge = Some(Daemon::start(&mut munge));
        let socket = cluster.path("munge/socket");
        wait(10, "munged listens", || socket.exists(), String::new);
        let controller = Daemon::start(cluster.daemon("slurmctld").args(["-D", "-c"]));
        cluster.controller = Some(controller);
        for node in ["n1", "n2"] {
            let daemon = Daemon::start(cluster.daemon("slurmd").args(["-D", "-N", node]));
            cluster.nodes.push(daemon);
        }
        let idle = || cluster.ask("sinfo", "-h -N -o %T").lines().filter(|l| *l == "idle").count();
        wait(30, "both nodes are idle", || idle() == 2, || cluster.ask("sinfo", "-N -l"));
        Ok(cluster)
    }

    fn path(&self, file: &str) -> PathBuf {
        self.folder.path().join(file)
    }

    fn daemon(&self, program: &str) -> Command {
        let mut command = Command::new(find(program).unwrap());
        command.env("SLURM_CONF", self.path("slurm.conf"));
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command
    }

    /// What a command of Slurm prints.
    fn ask(&self, program: &str, args: &str) -> String {
        let mut command = Command::new(program);
        command.env("SLURM_CONF", self.path("slurm.conf")).args(args.split(' '));
        said(&command.output().unwrap()).1
    }

    /// The tasks in the queue: identifier, state and node.
    fn queue(&self) -> Vec<(String, String, String)> {
        let lines = self.ask("squeue", "-h -r -o %F_%K|%T|%N");
        let task = |line: &str| {
            let mut fields = line.split('|').map(str::to_owned);
            Some((fields.next()?, fields.next()?, fields.next()?))
        };
        lines.lines().filter_map(task).collect()
    }

    /// A machine of two nodes for this test alone.
    fn configuration(&self) -> String {
        let folder = self.folder.path().display();
        let host = said(&Command::new("uname").arg("-n").output().unwrap()).1;
        let host = host.trim();
        // All three are taken before any is given back.
        let ports: Vec<_> = (0..3).map(|_| TcpListener::bind("127.0.0.1:0").unwrap()).collect();
        let ports: Vec<_> = ports.iter().map(|port| port.local_addr().unwrap().port()).collect();
        let [controller, n1, n2] = ports[..] else { unreachable!() };
        // A job that was requeued waits as long as cred_expire and a second: 2 minutes by default,
        // and with less than 5 seconds.
        format!(
            "ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,bf_interval=1,sched_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=10
KillWait=5
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/%n.pid
SlurmdLogFile={folder}/%n.log
SlurmdSpoolDir={folder}/%n
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={n1} CPUs=2
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={n2} CPUs=2
PartitionName=all Nodes=n1,n2 Default=YES State=UP MaxTime=INFINITE
"
        )
    }

    /// Processes of this cluster, on one of its nodes or on all.
    fn processes(&self, node: Option<&str>) -> Vec<u32> {
        let mut entries = vec![format!("SLURM_CONF={}", self.path("slurm.conf").display())];
        entries.extend(node.map(|node| format!("SLURMD_NODENAME={node}")));
        processes::with("environ", &entries)
    }

    /// The process that runs the script of a task.
    fn script(&self, id: &str) -> u32 {
        let (job, task) = id.split_once('_').unwrap();
        let of_task = [
            format!("SLURM_CONF={}", self.path("slurm.conf").display()),
            format!("SLURM_ARRAY_JOB_ID={job}"),
            format!("SLURM_ARRAY_TASK_ID={task}"),
        ];
        let is_script = |pid: &u32| {
            let line = fs::read_to_string(format!("/proc/{pid}/cmdline")).unwrap_or_default();
            line.starts_with("/bin/sh\0") && line.contains("/slurm_script\0")
        };
        processes::with("environ", &of_task).into_iter().find(is_script).unwrap()
    }

    /// What is to be seen when something goes wrong.
    fn state(&self, place: &Place) -> String {
        let log = fs::read_to_string(self.path("slurmctld.log")).unwrap_or_default();
        format!("{:#?}\n{:#?}\n{log}", self.queue(), place.logs())
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        self.nodes.clear();
        self.controller = None;
        self.munge = None;
        for pid in self.processes(None) {
            signal(pid, "KILL");
        }
    }
}

#[test]
fn a_node_goes_down() {
    let mut cluster = match Cluster::start() {
        Ok(cluster) => cluster,
        Err(missing) => return skip(&missing),
    };
    let place = Place::new();
    let script = place.script("slurm");
    let mut submit = sh(&script);
    let submit = submit.env("SLURM_CONF", cluster.path("slurm.conf")).arg("--quiet").output();
    assert_eq!(said(&submit.unwrap()), (0, String::new()));

    let running = |node: &str| {
        let tasks = cluster.queue().into_iter();
        let tasks = tasks.filter(|(_, state, on)| state == "RUNNING" && on == node);
        tasks.map(|(id, _, _)| id).collect::<Vec<_>>()
    };
    let both = || running("n1").len() == 2 && running("n2").len() == 2;
    wait(30, "both nodes are busy", both, || cluster.state(&place));
    let saved = || {
        let first = running("n1");
        first.iter().all(|id| place.has_checkpoint(id.split_once('_').unwrap().1.parse().unwrap()))
    };
    wait(30, "the parts of n1 have checkpoints", saved, || cluster.state(&place));

    // The power of one node fails; Slurm is told, which it would find out by itself in a while.
    let lost = running("n1");
    // What the signal before the time limit does: only the script gets it.
    let warned = running("n2")[0].clone();
    signal(cluster.script(&warned), "TERM");
    cluster.nodes[0].kill();
    let parts = cluster.processes(Some("n1"));
    // Their parents first, which would still report how they ended.
    for pid in processes::parents(&parts).into_iter().chain(parts) {
        signal(pid, "KILL");
    }
    assert_eq!(cluster.ask("scontrol", "update nodename=n1 state=DOWN reason=power"), "");

    wait(120, "the queue is empty", || cluster.queue().is_empty(), || cluster.state(&place));
    place.counts();
    let logs = place.logs();
    let log = |id: &str| {
        let name = format!("slurm-{id}.log");
        &logs.iter().find(|(file, _)| *file == name).unwrap().1
    };
    for id in &lost {
        assert!(log(id).contains(" on n1, restarts: 0\n"), "{}", log(id));
        assert!(log(id).contains(" on n2, restarts: 1\n"), "{}", log(id));
    }
    assert!(!lost.is_empty());
    assert!(log(&warned).contains(": exit code 75\n"), "{}", log(&warned));
    assert!(log(&warned).contains(" on n2, restarts: 1\n"), "{}", log(&warned));
}
