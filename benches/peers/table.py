"""Runs every row for tilepack and its peers and prints one table in markdown.

Every run is a process of its own that is ended, with all it started, at the time-out, which is CPU
time, so that another load on the machine ends nothing (but ten times as much on the clock does).
tilepack's time is that of its whole process, on one thread; a peer's begins when its solver has the model.
A cell is the median over the repetitions (rows that ask for a first packing: over the seeds),
for the better encoding; a time-out counts as longer than any time.
"""

import argparse
import datetime
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path
from shutil import which

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TILEPACK = ROOT / "target/release/tilepack"
PIN = "kind=wang colors=2\n0 . . .\n. . . .\n. . . .\n. . . .\n"

CORNER_3 = "find --kind corner --colors 3 --values random"
CORNER_4 = "find --kind corner --colors 4"
# Row: what it is, our commands, whether it has seeds, the number all must give.
ROWS = {
    "B1": ("Wang C=2, all, no symmetry broken", {"plain": "count --kind wang --colors 2 --plain"},
           False, 203520),
    "B2": ("Wang C=2, all, tile 0 pinned", {"plain": "count --kind wang --colors 2 --pin PIN"},
           False, 12720),
    "B4": ("corner C=3, a[i][j+3] = a[i][j]+1, all, tile 0 pinned",
           {"caps": "count --kind corner --colors 3 --automorphism 3,0:+1"}, False, 3744),
    "B5": ("corner C=3, first", {"search": f"{CORNER_3} --method search",
                                 "beam": "find --kind corner --colors 3 --method beam"}, True, 1),
    "B6": ("corner C=4, a[i][j+4] = a[i][j]+1, first",
           {"search": f"{CORNER_4} --method search --values random --automorphism 4,0:1,2,3,0"}, True, 1),
    "B6u": ("corner C=4, unrestricted, first",
            {"search": f"{CORNER_4} --method search --values random",
             "beam": f"{CORNER_4} --method beam"}, True, 1),
}
# Peer: its name in the table, its encodings.
PEERS = {
    "dlx": ("exact-cover", ["plain", "caps"]),
    "cpsat": ("CP-SAT", ["plain", "caps", "integers"]),
    "asp": ("clingo", ["plain", "caps"]),
    "cadical": ("CaDiCaL", ["plain", "caps"]),
    "gecode": ("Gecode", ["plain", "caps"]),
}
NAMES = {("dlx", "plain"): "tiles first", ("dlx", "caps"): "sides first"}


def run(command, limit):
    """The output of a command and its CPU and wall time, or None at the time-out."""
    with tempfile.TemporaryFile() as out:
        begin = time.perf_counter()
        cpu = int(limit) + 1
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL, start_new_session=True,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu)))
        while True:
            done, status, used = os.wait4(process.pid, os.WNOHANG)
            wall = time.perf_counter() - begin
            if done:
                break
            if wall > 10 * limit:
                os.killpg(process.pid, signal.SIGKILL)
                os.wait4(process.pid, 0)
                return None
            time.sleep(0.0005 if wall < 0.1 else 0.01)
        process.returncode = status
        out.seek(0)
        if status != 0:
            killed = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGKILL, signal.SIGXCPU)
            late = killed or used.ru_utime + used.ru_stime > limit
            return None if late else sys.exit(f"failed: {' '.join(map(str, command))}")
        return out.read().decode(), used.ru_utime + used.ru_stime, wall


def ours(row, options, seed, limit, pin):
    options = options.replace("PIN", pin).split() + ["--threads", "1", "--json", "--quiet"]
    done = run([TILEPACK, *options, "--seed", str(seed)], limit)
    if done is None:
        return None
    text, cpu, wall = done
    object = json.loads(text)
    answer = object.get("up_to_translation") if row == "B4" else object.get("solutions")
    answer = int(answer) if answer else int(object["result"] == "found")
    return {"answer": answer, "cpu": cpu, "wall": wall}


def theirs(row, peer, encoding, seed, limit):
    # Making the model is not part of the time, but must end, too.
    done = run([sys.executable, HERE / f"{peer}.py", row, encoding, str(seed)], limit + 5)
    result = json.loads(done[0]) if done else None
    return result if result and result["cpu"] <= limit else None


def rank(results, share):
    """The result at this share of the sorted ones, None for a time-out."""
    results = sorted(results, key=lambda r: r["cpu"] if r else float("inf"))
    return results[min(len(results) - 1, int(share * len(results)))]


def seconds(time):
    return f"{time:.3f}" if time < 10 else f"{time:.0f}"


def measure(once, seeds, repetitions, limit, expected, label):
    """The results of all runs, or those up to the time-outs that decide the median."""
    results = []
    runs = len(seeds) if seeds else repetitions
    for i in range(runs):
        result = once(seeds[i] if seeds else 0)
        if result and result["answer"] != expected:
            sys.exit(f"{label}: {result['answer']} instead of {expected}")
        results.append(result)
        print(f"{label} {i}: {result}", file=sys.stderr, flush=True)
        # The median is a time-out, whatever follows.
        if not seeds and result is None or 2 * results.count(None) > runs:
            break
    return results


def line(name, how, results, runs, best):
    out = results.count(None)
    middle = rank(results, 0.5) if 2 * out <= len(results) else None
    late = f", {out} of {len(results)} timed out" if out else ""
    if middle is None:
        return f"| {name} | {how} | time-out | time-out | | {late[2:]} |", None
    tenth = rank(results, 0.9)
    spread = "" if not runs else f"90 %: {seconds(tenth['cpu']) if tenth else 'time-out'}"
    ratio = f"{middle['cpu'] / best:.1f}" if best else "1"
    note = ", ".join(filter(None, [spread, late[2:]]))
    text = f"| {name} | {how} | {seconds(middle['cpu'])} | {seconds(middle['wall'])} | {ratio} | {note} |"
    return text, middle["cpu"]


def table(row, args, pin):
    what, commands, seeded, expected = ROWS[row]
    print(f"\n**{row}** {what}; checksum {expected}\n")
    print("| solver | how | CPU s | wall s | times ours | |\n|---|---|---|---|---|---|", flush=True)
    seeds = range(1, args.seeds + 1) if seeded else None
    all = [("tilepack", how, lambda seed, o=options: ours(row, o, seed, args.timeout, pin))
           for how, options in commands.items()]
    best = None
    for name, how, once in all:
        results = measure(once, seeds, args.repetitions, args.timeout, expected, f"{row} {name} {how}")
        text, cpu = line(name, how, results, seeds, None)
        print(text, flush=True)
        best = best or cpu
    for peer, (name, encodings) in PEERS.items():
        if args.peers and peer not in args.peers:
            continue
        if peer == "gecode" and not which("minizinc"):
            print(f"| {name} | skipped: no minizinc | | | | |")
            continue
        lines = []
        for how in [e for e in encodings if e in (args.encodings or encodings)]:
            once = lambda seed: theirs(row, peer, how, seed, args.timeout)
            label = f"{row} {name} {how}"
            results = measure(once, seeds, args.repetitions, args.timeout, expected, label)
            text, cpu = line(name, NAMES.get((peer, how), how), results, seeds, best)
            lines.append((cpu or float("inf"), results.count(None) / len(results), text))
        if lines:
            print(min(lines)[2], flush=True)


def machine():
    model = next((l.split(":")[1].strip() for l in open("/proc/cpuinfo") if l.startswith("model name")), "?")
    versions = [f"{package} {version(package)}" for package in
                ("exact-cover", "ortools", "clingo", "python-sat")]
    if which("minizinc"):
        text = subprocess.run(["minizinc", "--solvers"], capture_output=True, text=True).stdout
        versions += [next((l.split("(")[0].strip() for l in text.splitlines() if "Gecode 6" in l), "")]
    ours = subprocess.run([TILEPACK, "--version"], capture_output=True, text=True).stdout.strip()
    return f"{model}, {os.cpu_count()} cores; {ours}; {', '.join(versions)}; Python {sys.version.split()[0]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rows", nargs="*", help="rows, such as B1 [default: all]")
    parser.add_argument("--quick", action="store_true", help="1 repetition, 3 seeds, 10 s")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--timeout", type=float, default=60, help="CPU seconds of a run")
    parser.add_argument("--peers", nargs="*", choices=PEERS, help="these peers only")
    parser.add_argument("--encodings", nargs="*", help="these encodings only, such as plain")
    args = parser.parse_args()
    if args.quick:
        args.repetitions, args.seeds, args.timeout = 1, 3, 10
    wrong = set(args.rows) - set(ROWS)
    if wrong:
        parser.error(f"no such row: {', '.join(wrong)}")
    print(f"{datetime.date.today()}; {machine()}")
    print(f"\nRepetitions {args.repetitions}, seeds {args.seeds}, time-out {args.timeout:.0f} CPU s.")
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as pin:
        pin.write(PIN)
        pin.flush()
        for row in args.rows or ROWS:
            table(row, args, pin.name)


main()
