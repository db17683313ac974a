"""CaDiCaL 1.5.3 in python-sat: clauses, exactly-one by pairs or a sequential counter.

At most one of up to 6 by pairs, of more by python-sat's sequential counter; caps by its
totalizer. All packings by blocking clauses on the points.
"""

import report
from problem import Model
from pysat.card import CardEnc, EncType
from pysat.solvers import Cadical153


def clauses(model):
    top = model.variables
    for group in model.exactly_one:
        encoding = EncType.pairwise if len(group) <= 6 else EncType.seqcounter
        cnf = CardEnc.equals(group, 1, top_id=top, encoding=encoding)
        top = max(top, cnf.nv)
        yield from cnf.clauses
    for group, number in model.counts:
        cnf = CardEnc.equals(group, number, top_id=top, encoding=EncType.totalizer)
        top = max(top, cnf.nv)
        yield from cnf.clauses
    for variable, group in model.ands:
        yield from ([-variable, point] for point in group)
        yield [variable] + [-point for point in group]
    yield from ([v] for v in model.true)


def solve(problem, encoding, seed, clock):
    model = Model(problem, encoding == "caps", seed)
    with Cadical153(bootstrap_with=clauses(model)) as solver:
        clock.start()
        found = 0
        while solver.solve():
            found += 1
            holds = solver.get_model()
            points = [v for group in model.point for v in group if holds[v - 1] > 0]
            if not problem.all:
                return model.labels(lambda v: holds[v - 1] > 0)
            solver.add_clause([-v for v in points])
        return found


report.main(solve)
