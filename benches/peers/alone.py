"""The rows of tilepack alone: what an estimate is worth, and nodes per second.

B7: the count of corner C=3, estimated with a number of nodes that takes about a minute of CPU
time. How wide its 95 % interval is, is half the difference of its ends in parts of the estimate;
the interval is wider above than below. B8: a fixed prefix of the search, one thread and more.
"""

import json
import os
import sys

from runs import Failed, median, run

ESTIMATE = "estimate --kind corner --colors 3 --node-limit 400000000 --threads 1"
SPEEDS = {
    "corner C=3, the first 2 * 10^8 nodes": "count --kind corner --colors 3 --node-limit 200000000",
    "corner C=4, the first 2 * 10^8 nodes": "count --kind corner --colors 4 --node-limit 200000000",
    "Wang C=2, no symmetry broken, whole": "count --kind wang --colors 2 --plain",
}
STOPPED = 75  # exit code at a node limit
LIMIT = 600  # CPU seconds; nothing here should come near


def ask(tilepack, options):
    done = run([tilepack, *options.split(), "--json", "--quiet"], LIMIT, good=(0, STOPPED))
    if done is None:
        raise Failed(f"more than {LIMIT} CPU s")
    text, cpu, wall = done
    print(f"{options}: {text.strip()[:400]}, {cpu:.2f} CPU s", file=sys.stderr, flush=True)
    return json.loads(text), cpu, wall


def b7(tilepack):
    print(f"\n**B7** the estimate of the count of corner C=3: `{ESTIMATE}`\n")
    print("| | estimate | 95 % interval | relative half-width | nodes probed | CPU s |")
    print("|---|---|---|---|---|---|", flush=True)
    try:
        found, cpu, _ = ask(tilepack, ESTIMATE)
        for name, what in [("solutions", "packings"), ("nodes", "nodes of the search")]:
            if found[name] is None:
                print(f"| {what} | none: no probe reached one | | | {found['nodes_probed']} | {cpu:.0f} |")
                continue
            middle, low, high = (int(found[name + end]) for end in ("", "_low", "_high"))
            width = (high - low) / 2 / middle
            print(f"| {what} | {middle:.3g} | {low:.3g} to {high:.3g} | {100 * width:.1f} % "
                  f"| {int(found['nodes_probed']):,} | {cpu:.0f} |", flush=True)
    except Failed as error:
        print(f"| failed: {error} | | | | | |", flush=True)


def b8(tilepack, repetitions):
    print(f"\n**B8** nodes per second; medians of {repetitions}; ratio to one thread on the clock\n")
    print("| problem | threads | nodes | CPU s | wall s | million nodes/s (wall) | per CPU s | ratio |")
    print("|---|---|---|---|---|---|---|---|", flush=True)
    for what, options in SPEEDS.items():
        one = None
        for threads in sorted({1, 2, os.cpu_count() or 1}):
            try:
                runs = [ask(tilepack, f"{options} --threads {threads}") for _ in range(repetitions)]
            except Failed as error:
                print(f"| {what} | {threads} | failed: {error} | | | | | |", flush=True)
                continue
            nodes = median([int(found["nodes"]) for found, _, _ in runs])
            cpu, wall = median([cpu for _, cpu, _ in runs]), median([wall for _, _, wall in runs])
            one = one or (wall if threads == 1 else None)
            ratio = f"{one / wall:.2f}" if one else ""
            print(f"| {what} | {threads} | {nodes:,} | {cpu:.2f} | {wall:.2f} "
                  f"| {nodes / wall / 1e6:.1f} | {nodes / cpu / 1e6:.1f} | {ratio} |", flush=True)
