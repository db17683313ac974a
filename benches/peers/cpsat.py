"""OR-tools CP-SAT, one worker.

`plain`: tiles and points are 0/1 variables, a point being the sum of the tiles that show it.
`caps`: the same with pairs of neighbors and the counts. `integers`: the colors are integers, the
numbers of the tiles (of all images under the automorphism) linear in them and all different
(on a board, the numbers of the squares by a table of the sides). All packings by enumerate_all_solutions.
"""

from itertools import product

from ortools.sat.python import cp_model

import report
from problem import Model


class Counter(cp_model.CpSolverSolutionCallback):
    def __init__(self):
        super().__init__()
        self.found = 0

    def on_solution_callback(self):
        self.found += 1


def booleans(cp, problem, caps, seed):
    model = Model(problem, caps, seed)
    x = [None] + [cp.new_bool_var("") for _ in range(model.variables)]
    for group in model.exactly_one:
        cp.add_exactly_one(x[v] for v in group)
    ands = dict(model.ands)
    for group in model.blocks:
        for point in sorted({p for v in group for p in ands[v]}):
            cp.add(sum(x[v] for v in group if point in ands[v]) == x[point])
    for group, number in model.counts:
        cp.add(sum(x[v] for v in group) == number)
    for v in model.true:
        cp.add(x[v] == 1)
    return lambda solver: model.labels(lambda v: solver.boolean_value(x[v]))


def integers(cp, problem):
    colors = problem.colors
    # For every label one variable for each image: the color it shows.
    shown = [[cp.new_int_var(0, colors - 1, "") for _ in range(problem.order)]
             for _ in range(problem.labels())]
    for images in shown:
        if len(images) > 1:
            turns = [[(c + turn) % colors for turn in range(problem.order)] for c in range(colors)]
            cp.add_allowed_assignments(images, turns)
    tiles = []
    for (row, column), turn in product(problem.cells(), range(problem.order)):
        if problem.kind == "board":
            tiles.append(square(cp, problem, [shown[v][0] for v, _ in problem.sides(row, column)]))
            continue
        tile = 0
        for v, power in problem.sides(row, column):
            tile = tile * colors + shown[v][(power + turn) % problem.order]
        tiles.append(tile)
    cp.add_all_different(tiles)
    for v, color in problem.fixed().items():
        cp.add(shown[v][0] == color)
    return lambda solver: [solver.value(images[0]) for images in shown]


def square(cp, problem, sides):
    """The number of the square with these sides, in any rotation."""
    squares = problem.squares()
    laid = cp.new_int_var(0, len(squares) - 1, "")
    every = product(range(problem.colors), repeat=4)
    cp.add_allowed_assignments([*sides, laid], [(*s, squares.index(problem.orbit(s))) for s in every])
    return laid


def solve(problem, encoding, seed, clock):
    cp = cp_model.CpModel()
    if encoding == "integers":
        labels = integers(cp, problem)
    else:
        labels = booleans(cp, problem, encoding == "caps", seed)
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    solver.parameters.random_seed = seed
    solver.parameters.enumerate_all_solutions = problem.all
    counter = Counter()
    clock.start()
    solver.solve(cp, counter)
    return counter.found if problem.all else labels(solver)


report.main(solve)
