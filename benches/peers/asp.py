"""clingo: the colors of the points are chosen, tiles and pairs follow by rules.

Cardinality constraints say that every tile lies once and, with the caps, how often colors and
pairs occur. Grounding is not counted. All packings by asking for models without end, projected
to the points.
"""

import clingo

import report
from problem import Model


def program(model):
    name = lambda v: f"x({v})"
    points = {v for group in model.point for v in group}
    chosen = {tuple(group) for group in model.point}
    for group in model.exactly_one:
        elements = ";".join(map(name, group))
        if tuple(group) in chosen:
            yield f"1 {{{elements}}} 1."
        else:
            yield f":- not 1 {{{elements}}} 1."
    for variable, group in model.ands:
        yield f"{name(variable)} :- {','.join(map(name, group))}."
    for group, number in model.counts:
        yield f":- not {number} {{{';'.join(map(name, group))}}} {number}."
    for v in model.true:
        yield f":- not {name(v)}."
    for v in points:
        yield f"#show {name(v)} : {name(v)}."
    yield "#show."


def solve(problem, encoding, seed, clock):
    model = Model(problem, encoding == "caps", seed)
    limit = 0 if problem.all else 1
    control = clingo.Control([str(limit), f"--seed={seed}"])
    control.add("base", [], "\n".join(program(model)))
    control.ground([("base", [])])
    clock.start()
    found, last = 0, None
    with control.solve(yield_=True) as models:
        for each in models:
            found += 1
            if not problem.all:
                last = {int(str(atom)[2:-1]) for atom in each.symbols(shown=True)}
    return found if problem.all else model.labels(last.__contains__)


report.main(solve)
