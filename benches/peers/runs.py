"""Runs one process: its output, CPU and wall time, its time-out, or how it failed.

Every run is a process of its own that is ended, with all it started, at the time-out, which is CPU
time, so that another load on the machine ends nothing (but ten times as much on the clock does).
"""

import os
import resource
import signal
import subprocess
import tempfile
import time
from pathlib import Path


class Failed(Exception):
    """A run that ended badly, not by the time-out; in one line, for a table."""

    def __init__(self, text):
        lines = [line.strip() for line in text.replace("|", "/").splitlines() if line.strip()]
        # Python tells the error last, others first.
        told = [line for line in lines if line.lower().startswith("error")] + lines[-1:]
        super().__init__(told[0][:120] if told else "no message")


def run(command, limit, good=(0,), cwd=None):
    """The output of a command and its CPU and wall time, or None at the time-out."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begin = time.perf_counter()
        cpu = int(limit) + 1
        try:
            process = subprocess.Popen(command, stdout=out, stderr=err, start_new_session=True, cwd=cwd,
                                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu)))
        except OSError as error:
            raise Failed(f"{Path(command[0]).name}: {error.strerror}") from error
        try:
            status, used, wall = wait(process, begin, 10 * limit)
        except BaseException:
            end(process)
            raise
        process.returncode = status
        if status is None:
            return None
        spent = used.ru_utime + used.ru_stime
        code = os.waitstatus_to_exitcode(status)
        if code not in good:
            # A peer may end itself by SIGXCPU before our limit; SIGKILL may be for want of memory.
            if code == -signal.SIGXCPU or spent > limit:
                return None
            err.seek(0)
            text = err.read().decode(errors="replace")
            raise Failed(f"signal {-code}" if code < 0 else text or f"exit code {code}")
        out.seek(0)
        return out.read().decode(), spent, wall


def wait(process, begin, limit):
    """Status, resources and wall time of a process that ended, or None thrice at the limit."""
    while True:
        done, status, used = os.wait4(process.pid, os.WNOHANG)
        wall = time.perf_counter() - begin
        if done:
            return status, used, wall
        if wall > limit:
            end(process)
            return None, None, None
        time.sleep(0.0005 if wall < 0.1 else 0.01)


def end(process):
    os.killpg(process.pid, signal.SIGKILL)
    os.wait4(process.pid, 0)


def median(numbers):
    return sorted(numbers)[len(numbers) // 2]


def seconds(time):
    return f"{time:.3f}" if time < 10 else f"{time:.0f}"
