"""A HyperQueue server, workers that can be killed, and as much of `hq` as a job file uses.

    hq.py server SERVER SERVER      runs the server in a new folder
    hq.py worker SERVER OWN         runs a worker with two cores
    hq.py hq SERVER submit ...      submits an array of tasks

A file `ready` appears in the second folder.
"""

import argparse
import os
import shutil
import signal
import sys

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig
from hyperqueue.ffi.protocol import ResourceRequest

ACCESS = os.path.join("hq-current", "access.json")


def serve(server, own, is_worker):
    os.makedirs(own)
    cluster = LocalCluster(own)
    if is_worker:
        # The package starts workers only beside a server of its own. It finds the server by
        # this file, so another file makes it a worker of another server.
        shutil.copy(os.path.join(server, ACCESS), os.path.join(own, ACCESS))
        cluster.start_worker(WorkerConfig(cores=2))
    open(os.path.join(own, "ready"), "w").close()
    signal.pause()


def submit(server, arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("command", choices=["submit"])
    parser.add_argument("--name", required=True)
    parser.add_argument("--array", required=True)
    parser.add_argument("--cpus", type=int, required=True)
    parser.add_argument("--crash-limit", type=int, required=True)
    parser.add_argument("--stdout", choices=["none"], required=True)
    parser.add_argument("--stderr", choices=["none"], required=True)
    end = arguments.index("--")
    options, program = parser.parse_args(arguments[:end]), arguments[end + 1 :]
    first, last = map(int, options.array.split("-"))
    assert first == 0, "the package numbers tasks from 0"
    job = Job(name=options.name)
    for _ in range(first, last + 1):
        job.program(
            program,
            stdout=None,
            stderr=None,
            resources=ResourceRequest(cpus=options.cpus),
            crash_limit=options.crash_limit,
        )
    Client(server).submit(job)


if __name__ == "__main__":
    role, server, *rest = sys.argv[1:]
    if role == "hq":
        submit(server, rest)
    else:
        serve(server, rest[0], role == "worker")
