"""exact-cover (PyPI), dancing links in C: the plain exact cover problem, without colors.

A row of the matrix puts a tile into a cell; it covers the cell, the tile and, of every side it
shares, either its color (as the first of the two neighbors) or all colors but its own (as the
second): neighbors cover each color of a side once exactly when they agree. The sides of corner
tiles have two corners, so C^2 colors. On a board a tile is a square in one rotation, and the row
covers the square; outer sides that show another color than the border are left out. Encodings: cells and tiles before sides, or after.
"""

import random
from collections import Counter
from itertools import product

import numpy
import exact_cover

import report


def rows(problem):
    sides = {cell: problem.sides(*cell) for cell in problem.cells()}
    met = Counter(v for side in sides.values() for v, _ in side)
    fixed = problem.fixed()
    for (row, column), side in sides.items():
        for shown in product(range(problem.colors), repeat=4):
            colors = [problem.color(s, power) for (_, power), s in zip(side, shown)]
            if any(fixed.get(v, color) != color for (v, _), color in zip(side, colors)):
                continue
            items = [("cell", row, column), ("tile", problem.orbit(shown))]
            for place, own, first in parts(problem, row, column, side, shown, colors):
                if problem.kind == "board" and met[place[0]] == 1:
                    continue
                for color in product(range(problem.colors), repeat=len(own)):
                    if (color == own) == first:
                        items.append(place + (color,))
            yield items, [(v, color) for (v, _), color in zip(side, colors)]


def parts(problem, row, column, side, shown, colors):
    """The north, south, west and east side: its place, its colors, whether it is the first."""
    if problem.kind != "corner":
        for i, first in [(0, True), (2, False), (3, True), (1, False)]:
            yield (side[i][0],), (colors[i],), first
        return
    # Two corners each.
    for axis, r, c, corners, first in [
        ("h", row, column, (3, 0), True), ("h", row + 1, column, (2, 1), False),
        ("v", row, column, (3, 2), True), ("v", row, column + 1, (0, 1), False),
    ]:
        power = c % problem.side // problem.width
        own = tuple(problem.color(shown[i], power) for i in corners)
        yield (axis, r % problem.side, c % problem.width), own, first


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
    laid = dict(each for i in exact_cover.get_exact_cover(matrix) for each in listed[i][1])
    return [laid[v] for v in range(problem.labels())]


report.main(solve)
