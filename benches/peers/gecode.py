"""Gecode, called by MiniZinc: integers, numbers of tiles all different, scanned row by row.

With the caps, global_cardinality counts colors and pairs. Colors are tried in increasing order,
or with a seed in random order. CPU time is that of the processes less the time MiniZinc took to
translate the model.
"""

import re
import resource
import signal
import subprocess
import sys
import time
from itertools import product

import report


def number(problem, labels, turn):
    """The number of the tile or pair that these labels show after some turns, as a term."""
    term = "0"
    for v, power in labels:
        term = f"({term})*{problem.colors}+a[{v},{(power + turn) % problem.order}]"
    return term


def squares(problem):
    """The numbers of the squares, by a table of their sides."""
    known, every = problem.squares(), product(range(problem.colors), repeat=4)
    rows = "|".join(",".join(map(str, (*s, known.index(problem.orbit(s))))) for s in every)
    yield f"array[1..{problem.colors**4},1..5] of int: squares = [|{rows}|];"
    cells = problem.cells()
    yield f"array[1..{len(cells)}] of var 0..{len(known) - 1}: tiles;"
    for i, cell in enumerate(cells, 1):
        sides = ",".join(f"a[{v},0]" for v, _ in problem.sides(*cell))
        yield f"constraint table_int([{sides},tiles[{i}]], squares);"


def entered(problem, cell):
    """The labels to try for a cell: its north-west corner, its north and west edges, or all edges."""
    sides = [v for v, _ in problem.sides(*cell)]
    return sides[3:] if problem.kind == "corner" else [sides[0], sides[3]] if problem.kind == "wang" else sides


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
    if problem.kind == "board":
        yield from squares(problem)
    else:
        tiles = [number(problem, problem.sides(*cell), turn) for cell, turn in every]
        yield f"array[1..{len(tiles)}] of var 0..{colors**4 - 1}: tiles = [{','.join(tiles)}];"
    yield "constraint all_different_int(tiles);"
    yield from (f"constraint a[{v},0] = {color};" for v, color in problem.fixed().items())
    # Under an automorphism every color occurs equally often, whatever the labels.
    for labels, numbers in problem.caps() if caps else []:
        points, count = ",".join(f"a[{v},0]" for v in labels), ",".join(map(str, numbers))
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
    scan = dict.fromkeys(v for cell in problem.cells() for v in entered(problem, cell))
    choice = "indomain_random" if seed else "indomain_min"
    yield f"solve :: int_search([{','.join(f'a[{v},0]' for v in scan)}], input_order, {choice}) satisfy;"
    yield f'output [show([a[i,0] | i in 0..{problem.labels() - 1}])];'


def solve(problem, encoding, seed, clock):
    text = "\n".join(program(problem, encoding == "caps", seed))
    command = ["minizinc", "--solver", "gecode", "-s", "-r", str(seed), "-"]
    command += ["-a"] if problem.all else []
    clock.start()
    run = subprocess.run(command, input=text, capture_output=True, text=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode != 0:
        # What ended at the limit was a child of MiniZinc.
        if clock.limit and used.ru_utime + used.ru_stime > clock.limit:
            signal.raise_signal(signal.SIGXCPU)
        sys.exit(f"{run.stderr}\nMiniZinc ended with {run.returncode}: {run.stderr.strip()[:80]}")
    translating = float(re.search(r"flatTime=([\d.]+)", run.stdout)[1])
    # The clock of the caller sees this process only.
    clock.cpu = time.process_time() - (used.ru_utime + used.ru_stime - translating)
    clock.wall += translating
    if problem.all:
        return run.stdout.count("----------")
    return [int(c) for c in re.search(r"^\[(.*)\]", run.stdout, re.M)[1].split(",")]


report.main(solve)
