"""exact-cover (PyPI), dancing links in C: the plain exact cover problem, without colors.

A row of the matrix puts a tile into a cell; it covers the cell, the tile and, of every side it
shares, either its color (as the first of the two neighbors) or all colors but its own (as the
second): neighbors cover each color of a side once exactly when they agree. The sides of corner
tiles have two corners, so C^2 colors. Encodings: cells and tiles before sides, or after.
"""

import random
from itertools import product

import numpy
import exact_cover

import report


def rows(problem):
    corner = problem.kind == "corner"
    for row, column in problem.cells():
        side = problem.sides(row, column)
        for shown in product(range(problem.colors), repeat=4):
            if problem.pinned and (row, column) == (0, 0) and any(shown):
                continue
            items = [("cell", row, column), ("tile", problem.orbit(shown))]
            if corner:
                # North, south, west, east side: its two corners.
                parts = [("h", row, column, (3, 0), True), ("h", row + 1, column, (2, 1), False),
                         ("v", row, column, (3, 2), True), ("v", row, column + 1, (0, 1), False)]
            else:
                parts = [("h", row, column, (0,), True), ("h", row + 1, column, (2,), False),
                         ("v", row, column, (3,), True), ("v", row, column + 1, (1,), False)]
            for axis, r, c, corners, first in parts:
                power = c % problem.side // problem.width
                place = (axis, r % problem.side, c % problem.width)
                own = tuple((shown[i] - power) % problem.colors for i in corners)
                for color in product(range(problem.colors), repeat=len(corners)):
                    if (color == own) == first:
                        items.append(place + (color,))
            yield items, (side[3], shown[3])


def solve(problem, encoding, seed, clock):
    listed = list(rows(problem))
    names = list(dict.fromkeys(item for items, _ in listed for item in items))
    random.Random(seed).shuffle(listed)
    sides_first = encoding == "caps"
    names.sort(key=lambda item: (item[0] in ("cell", "tile")) == sides_first)
    number = {item: i for i, item in enumerate(names)}
    matrix = numpy.zeros((len(listed), len(names)), dtype=bool)
    for i, (items, _) in enumerate(listed):
        matrix[i, [number[item] for item in items]] = True
    clock.start()
    if problem.all:
        return exact_cover.get_solution_count(matrix)
    shown = (listed[i][1] for i in exact_cover.get_exact_cover(matrix))
    corners = {v: problem.color(color, power) for (v, power), color in shown}
    return [corners[v] for v in range(problem.labels())]


report.main(solve)
