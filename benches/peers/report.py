"""What every peer does around its solver: arguments in, one line of JSON out.

`main(solve)` is called by the file of a peer as `python PEER.py ROW ENCODING SEED`. `solve` gets
the problem, whether to add the caps, and the seed; it builds its model, calls `clock.start()`
when the solver has it, and gives the number of packings, or the labels of one. The time of the
model is not counted, in favor of the peers; what is found is checked.
"""

import json
import sys
import time

from problem import PROBLEMS


class Clock:
    def start(self):
        self.cpu, self.wall = time.process_time(), time.perf_counter()

    def elapsed(self):
        return time.process_time() - self.cpu, time.perf_counter() - self.wall


def main(solve):
    row, encoding, seed = sys.argv[1], sys.argv[2], int(sys.argv[3])
    problem, clock = PROBLEMS[row], Clock()
    clock.start()
    answer = solve(problem, encoding, seed, clock)
    cpu, wall = clock.elapsed()
    if not problem.all:
        if not problem.check(answer):
            sys.exit("not a packing")
        answer = 1
    print(json.dumps({"answer": answer, "cpu": cpu, "wall": wall}))
