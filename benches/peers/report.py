"""What every peer does around its solver: arguments in, one line of JSON out.

`main(solve)` is called by the file of a peer as `python PEER.py ROW ENCODING SEED [LIMIT]`. `solve` gets
the problem, whether to add the caps, and the seed; it builds its model, calls `clock.start()`
when the solver has it, and gives the number of packings, or the labels of one. The time of the
model is not counted, in favor of the peers; what is found is checked. The process ends itself
soon after the limit in CPU seconds, counted from the same moment.
"""

import json
import resource
import sys
import time

from problem import PROBLEMS, TINY


class Clock:
    def __init__(self, limit=None):
        self.limit = limit

    def start(self):
        self.cpu, self.wall = time.process_time(), time.perf_counter()
        if self.limit:
            # Whole seconds; never beyond what the caller allows.
            most = resource.getrlimit(resource.RLIMIT_CPU)[1]
            soft = int(self.cpu + self.limit) + 2
            soft = soft if most == resource.RLIM_INFINITY else min(soft, most)
            resource.setrlimit(resource.RLIMIT_CPU, (soft, most))

    def elapsed(self):
        return time.process_time() - self.cpu, time.perf_counter() - self.wall


def main(solve):
    row, encoding, seed = sys.argv[1], sys.argv[2], int(sys.argv[3])
    problem, clock = (PROBLEMS | TINY)[row], Clock(float(sys.argv[4]) if len(sys.argv) > 4 else None)
    answer = solve(problem, encoding, seed, clock)
    cpu, wall = clock.elapsed()
    if not problem.all:
        if not problem.check(answer):
            sys.exit("not a packing")
        answer = 1
    print(json.dumps({"answer": answer, "cpu": cpu, "wall": wall}))
