"""Gecode, called by MiniZinc: integers, numbers of tiles all different, scanned row by row.

With the caps, global_cardinality counts colors and pairs. Colors are tried in increasing order,
or with a seed in random order. CPU time is that of the processes less the time MiniZinc took to
translate the model.
"""

import re
import resource
import subprocess
import time
from itertools import product

import report


def number(problem, labels, turn):
    """The number of the tile or pair that these labels show after some turns, as a term."""
    term = "0"
    for v, power in labels:
        term = f"({term})*{problem.colors}+a[{v},{(power + turn) % problem.order}]"
    return term


# The Debian package joins two versions, so the names of the constraints that Gecode has itself are
# not those of the standard library.
INCLUDES = ["all_different_int", "global_cardinality", "table_int"]


def program(problem, caps, seed):
    colors, order = problem.colors, problem.order
    yield from (f'include "{name}.mzn";' for name in INCLUDES)
    yield f"array[0..{problem.labels() - 1},0..{order - 1}] of var 0..{colors - 1}: a;"
    if order > 1:
        turns = "|".join(",".join(str((c + t) % colors) for t in range(order)) for c in range(colors))
        yield f"array[1..{colors},1..{order}] of int: turns = [|{turns}|];"
        yield f"constraint forall(i in 0..{problem.labels() - 1})(table_int([a[i,t] | t in 0..{order - 1}], turns));"
    every = list(product(problem.cells(), range(order)))
    tiles = [number(problem, problem.sides(*cell), turn) for cell, turn in every]
    yield f"array[1..{len(tiles)}] of var 0..{colors**4 - 1}: tiles = [{','.join(tiles)}];"
    yield "constraint all_different_int(tiles);"
    if problem.pinned:
        for v, power in problem.sides(0, 0):
            yield f"constraint a[{v},{power % order}] = 0;"
    if caps:
        planes = problem.labels() // (problem.side * problem.width)
        size = problem.side * problem.width
        for plane in range(planes):
            points = ",".join(f"a[{v},{t}]" for v in range(plane * size, (plane + 1) * size) for t in range(order))
            count = ",".join([str(colors**3)] * colors)
            yield f"constraint global_cardinality([{points}],[c | c in 0..{colors - 1}],[{count}]);"
    if caps and problem.kind == "corner":
        for south, east in [(0, 1), (1, 0)]:
            pairs = ",".join(
                number(problem, [problem.label(0, r, c), problem.label(0, r + south, c + east)], turn)
                for (r, c), turn in every)
            count = ",".join([str(colors**2)] * colors**2)
            name = "across" if east else "down"
            yield f"array[1..{len(every)}] of var 0..{colors**2 - 1}: {name} = [{pairs}];"
            yield f"constraint global_cardinality({name},[d | d in 0..{colors**2 - 1}],[{count}]);"
    scan = [v for r in range(problem.side) for c in range(problem.width)
            for v in sorted({problem.label(p, r, c)[0] for p in range(1 if problem.kind == "corner" else 2)})]
    choice = "indomain_random" if seed else "indomain_min"
    yield f"solve :: int_search([{','.join(f'a[{v},0]' for v in scan)}], input_order, {choice}) satisfy;"
    yield f'output [show([a[i,0] | i in 0..{problem.labels() - 1}])];'


def solve(problem, encoding, seed, clock):
    text = "\n".join(program(problem, encoding == "caps", seed))
    command = ["minizinc", "--solver", "gecode", "-s", "-r", str(seed), "-"]
    command += ["-a"] if problem.all else []
    clock.wall = time.perf_counter()
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    translating = float(re.search(r"flatTime=([\d.]+)", run.stdout)[1])
    # The clock of the caller sees this process only.
    clock.cpu = time.process_time() - (used.ru_utime + used.ru_stime - translating)
    clock.wall += translating
    if problem.all:
        return run.stdout.count("----------")
    return [int(c) for c in re.search(r"^\[(.*)\]", run.stdout, re.M)[1].split(",")]


report.main(solve)
