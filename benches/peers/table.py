"""Runs every row for tilepack and its peers and prints its tables in markdown.

tilepack's time is that of its whole process, on one thread; a peer's begins when its solver has the model.
A line is the median over the repetitions (rows that ask for a first packing: over the seeds),
for the better encoding, with what the others took; a time-out counts as longer than any time.
What times out twice is not run again. What is missing, fails or answers wrongly gets a line that
says so, and the rest goes on.
"""

import argparse
import datetime
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from shutil import which

import alone
from check import check
from runs import Failed, run, seconds

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TILEPACK = ROOT / "target/release/tilepack"
PINS = {
    "PIN_WANG": "kind=wang colors=2\n0 . . .\n. . . .\n. . . .\n. . . .\n",
    "PIN_BOARD": "topology=rectangle border=0 rotations\n. . 0/0 . . .\n" + ". . . . . .\n" * 3,
}

CORNER_3 = "find --kind corner --colors 3 --values random"
CORNER_4 = "find --kind corner --colors 4"
MACMAHON = ("count --kind wang --colors 3 --set data/macmahon.json --size 6x4 "
            "--topology rectangle --border 0 --rotations")


@dataclass(frozen=True)
class Row:
    what: str
    commands: dict  # ours
    answer: int  # the number all must give; 1 for a first packing
    seeded: bool = False
    # An easier row: of every peer only the encoding that was best there is run here.
    after: str = ""
    # The long time-out, one run, and only what should end in time, from the easier row's seconds
    # for each packing.
    long: bool = False


ROWS = {
    "B1": Row("Wang C=2, all, no symmetry broken", {"plain": "count --kind wang --colors 2 --plain"}, 203520),
    "B2": Row("Wang C=2, all, tile 0 pinned", {"plain": "count --kind wang --colors 2 --pin PIN_WANG"}, 12720),
    "B4": Row("corner C=3, a[i][j+3] = a[i][j]+1, all, tile 0 pinned",
              {"meet": "count --kind corner --colors 3 --automorphism 3,0:+1 --method meet",
               "search": "count --kind corner --colors 3 --automorphism 3,0:+1"}, 3744),
    "B5": Row("corner C=3, first", {"search": f"{CORNER_3} --method search",
                                    "beam": "find --kind corner --colors 3 --method beam"}, 1, True),
    "B6": Row("corner C=4, a[i][j+4] = a[i][j]+1, first",
              {"search": f"{CORNER_4} --method search --values random --automorphism 4,0:1,2,3,0"}, 1, True),
    "B6u": Row("corner C=4, unrestricted, first",
               {"search": f"{CORNER_4} --method search --values random",
                "beam": f"{CORNER_4} --method beam"}, 1, True, after="B6"),
    "MMp": Row("MacMahon's 24 squares, 6 x 4, border 0, all, square 0 in row 0, column 2",
               {"meet": f"{MACMAHON} --pin PIN_BOARD --method meet", "search": f"{MACMAHON} --pin PIN_BOARD"}, 1908),
    "MM": Row("MacMahon's 24 squares, 6 x 4, border 0, all, no symmetry broken", {"meet": f"{MACMAHON} --method meet"}, 106624,
              after="MMp", long=True),
}
ALONE = ["B7", "B8"]
# Peer: its name in the table, its encodings.
PEERS = {
    "dlx": ("exact-cover", ["plain", "caps"]),
    "cpsat": ("CP-SAT", ["plain", "caps", "integers"]),
    "asp": ("clingo", ["plain", "caps"]),
    "cadical": ("CaDiCaL", ["plain", "caps"]),
    "gecode": ("Gecode", ["plain", "caps"]),
}
NAMES = {("dlx", "plain"): "tiles first", ("dlx", "caps"): "sides first"}
PACKAGES = {"dlx": "exact-cover", "cpsat": "ortools", "asp": "clingo", "cadical": "python-sat"}


def missing(peer):
    """Why a peer cannot be run, or nothing."""
    if peer == "gecode":
        return "" if which("minizinc") else "no minizinc"
    try:
        version(PACKAGES[peer])
        return ""
    except PackageNotFoundError:
        return f"{PACKAGES[peer]} is not installed"


def ours(row, options, seed, limit, pins):
    words = [pins.get(word, word) for word in options.split()]
    words += ["--threads", "1", "--json", "--quiet", "--seed", str(seed)]
    done = run([TILEPACK, *words], limit, cwd=ROOT)
    if done is None:
        return None
    text, cpu, wall = done
    object = json.loads(text)
    answer = object.get("up_to_translation") if row == "B4" else object.get("solutions")
    answer = int(answer) if answer else int(object["result"] == "found")
    return {"answer": answer, "cpu": cpu, "wall": wall} if cpu <= limit else None


def theirs(row, peer, encoding, seed, limit):
    # Making the model is not part of the time, but must end, too; the peer ends itself earlier.
    done = run([sys.executable, HERE / f"{peer}.py", row, encoding, str(seed), str(limit)], 2 * limit + 10)
    result = json.loads(done[0]) if done and done[0].strip() else None
    return result if result and result["cpu"] <= limit else None


def rank(results, share):
    """The result at this share of the sorted ones, None for a time-out."""
    results = sorted(results, key=lambda r: r["cpu"] if r else float("inf"))
    return results[min(len(results) - 1, int(share * len(results)))]


@dataclass
class Line:
    name: str
    how: str
    results: list
    failed: str = ""

    @property
    def out(self):
        return self.results.count(None)

    @property
    def middle(self):
        return rank(self.results, 0.5) if self.results and not self.failed else None

    @property
    def order(self):
        """Better ones first: by time, then time-outs, then failures."""
        return bool(self.failed), self.middle["cpu"] if self.middle else float("inf"), self.out

    def short(self):
        if self.failed:
            return f"{self.how}: {self.failed}"
        return f"{self.how}: {seconds(self.middle['cpu']) if self.middle else 'time-out'}"

    def text(self, seeded, best, limit, others):
        """The line of the table; `best` is our time, `others` the other encodings."""
        if self.failed:
            return f"| {self.name} | {self.how} | {self.failed} | | | {'; '.join(o.short() for o in others)} |"
        middle, notes = self.middle, []
        if seeded and middle:
            tenth = rank(self.results, 0.9)
            notes.append(f"90 %: {seconds(tenth['cpu']) if tenth else 'time-out'}")
        if self.out:
            notes.append(f"{self.out} of {len(self.results)} timed out")
        notes += [other.short() for other in others]
        cells = ["time-out", "time-out", f"> {limit / best:.1f}" if best else ""]
        if middle:
            ratio = f"{middle['cpu'] / best:.1f}" if best else ""
            cells = [seconds(middle["cpu"]), seconds(middle["wall"]), ratio]
        return f"| {self.name} | {self.how} | {' | '.join(cells)} | {'; '.join(notes)} |"


class Table:
    def __init__(self, args, pins):
        self.args, self.pins = args, pins
        self.wrong = False
        self.best = {}  # (row, peer): the line of its better encoding

    def measure(self, name, how, once, row, runs, label):
        """A line from all runs, or those up to the time-outs that end them."""
        line = Line(name, how, [])
        for seed in runs:
            try:
                result = once(seed)
            except (Failed, ValueError, KeyError) as error:
                line.failed = f"failed: {error}"
                print(f"{label} {seed}: {line.failed}", file=sys.stderr, flush=True)
                break
            print(f"{label} {seed}: {result}", file=sys.stderr, flush=True)
            line.results.append(result)
            if result and result["answer"] != row.answer:
                self.wrong = True
                line.failed = f"WRONG: {result['answer']} instead of {row.answer}"
                break
            # Without seeds the next run would be the same one; with them, twice is enough.
            if line.out == (2 if row.seeded else 1):
                break
        return line

    def peer(self, key, row, peer, runs, limit):
        """The lines of a peer, best first, or why there is none."""
        name, encodings = PEERS[peer]
        if missing(peer):
            return f"skipped: {missing(peer)}"
        encodings = [e for e in encodings if e in (self.args.encodings or encodings)]
        before = self.best.get((row.after, peer))
        if before:
            if row.long and not before.middle:
                return f"not run: {before.failed or 'time-out'} on {row.after}"
            factor = row.answer / ROWS[row.after].answer
            if row.long and before.middle["cpu"] * factor > limit:
                return f"not run: {seconds(before.middle['cpu'])} s on {row.after} times {factor:.0f} packings"
            encodings = [e for e in encodings if NAMES.get((peer, e), e) == before.how]
        lines = []
        for how in encodings:
            once = lambda seed: theirs(key, peer, how, seed, limit)
            lines.append(self.measure(name, NAMES.get((peer, how), how), once, row, runs, f"{key} {name} {how}"))
        return sorted(lines, key=lambda line: line.order)

    def row(self, key):
        row, args = ROWS[key], self.args
        limit = args.long if row.long else args.timeout
        runs = range(1, args.seeds + 1) if row.seeded else [0] * (1 if row.long else args.repetitions)
        told = f"; time-out {limit:.0f} CPU s, one run" if row.long else ""
        print(f"\n**{key}** {row.what}; checksum {row.answer}{told}\n")
        print("| solver | how | CPU s | wall s | times ours | |\n|---|---|---|---|---|---|", flush=True)
        best = None
        for how, options in row.commands.items():
            once = lambda seed: ours(key, options, seed, limit, self.pins)
            line = self.measure("tilepack", how, once, row, runs, f"{key} tilepack {how}")
            print(line.text(row.seeded, best, limit, []), flush=True)
            best = best or (line.middle and line.middle["cpu"])
        for peer in args.peers or PEERS:
            lines = self.peer(key, row, peer, runs, limit)
            if isinstance(lines, str):
                print(f"| {PEERS[peer][0]} | {lines} | | | | |", flush=True)
            elif lines:
                self.best[key, peer] = lines[0]
                print(lines[0].text(row.seeded, best, limit, lines[1:]), flush=True)

    def check(self):
        def answer(name, peer, how):
            try:
                result = theirs(name, peer, how, 0, 60)
                return result["answer"] if result else "time-out"
            except (Failed, ValueError, KeyError) as error:
                return str(error)
        there = {peer: PEERS[peer] for peer in self.args.peers or PEERS if not missing(peer)}
        self.wrong = not check(there, answer) or self.wrong


def first_line(command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout.strip()
    except OSError:
        return ""


def machine():
    model = next((l.split(":")[1].strip() for l in open("/proc/cpuinfo") if l.startswith("model name")), "?")
    versions = [f"{package} {version(package)}" for peer, package in PACKAGES.items() if not missing(peer)]
    solvers = first_line(["minizinc", "--solvers"]).splitlines()
    versions += [l.split("(")[0].strip() for l in solvers if "Gecode 6" in l][:1]
    versions += [f"Python {sys.version.split()[0]}"]
    tilepack = first_line([TILEPACK, "--version"]) or "no tilepack"
    return f"{model}, {os.cpu_count()} cores; {tilepack}; {', '.join(versions)}"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rows", nargs="*", help="rows, such as B1 [default: all]")
    parser.add_argument("--check", action="store_true", help="only check the encodings on tiny problems")
    parser.add_argument("--quick", action="store_true", help="1 repetition, 3 seeds, 10 s, also for MM")
    parser.add_argument("--repetitions", type=int, help="of rows without seeds [default: 5]")
    parser.add_argument("--seeds", type=int, help="[default: 20]")
    parser.add_argument("--timeout", type=float, help="CPU seconds of a run [default: 60]")
    parser.add_argument("--long", type=float, help="CPU seconds of a run of MM [default: 1800]")
    parser.add_argument("--peers", nargs="*", choices=PEERS, help="these peers only")
    parser.add_argument("--encodings", nargs="*", help="these encodings only, such as plain")
    args = parser.parse_args()
    defaults = {"repetitions": (5, 1), "seeds": (20, 3), "timeout": (60, 10), "long": (1800, 10)}
    for name, (usual, quick) in defaults.items():
        if getattr(args, name) is None:
            setattr(args, name, quick if args.quick else usual)
    wrong = set(args.rows) - set(ROWS) - set(ALONE)
    if wrong:
        parser.error(f"no such row: {', '.join(sorted(wrong))}")
    return args


def main():
    args = arguments()
    rows = args.rows or [*ROWS, *ALONE]
    print(f"{datetime.date.today()}; {machine()}")
    with tempfile.TemporaryDirectory() as folder:
        pins = {name: Path(folder) / f"{name}.txt" for name in PINS}
        for name, path in pins.items():
            path.write_text(PINS[name])
        table = Table(args, pins)
        if args.check:
            table.check()
        else:
            print(f"\nRepetitions {args.repetitions}, seeds {args.seeds}, time-out {args.timeout:.0f} CPU s.")
            for key in [row for row in rows if row in ROWS]:
                table.row(key)
            if "B7" in rows:
                alone.b7(TILEPACK)
            if "B8" in rows:
                alone.b8(TILEPACK, args.repetitions)
    sys.exit(table.wrong)


main()
