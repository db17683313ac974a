"""The problems of the table, once for all peers.

A problem is a torus of labels (lattice colors of corner tiles, edge colors of Wang tiles), one
variable each, cut down to a fundamental domain where an automorphism a[row][column + DX] =
a[row][column] + 1 is prescribed. `Model` says it in 0/1 variables: exactly-one groups, ands and
counts, for a `board.Board` as well. Redundant counts ("caps": how often a color and a pair of neighbors occur in every
packing) can be left out. Every peer reads this, so all of them solve the same thing.
"""

import random
from dataclasses import dataclass, field
from itertools import product

from board import Board


@dataclass(frozen=True)
class Problem:
    kind: str  # corner or wang
    colors: int
    step: int = 0  # columns of the prescribed automorphism, 0 for none
    pinned: bool = True  # tile 0 lies at the origin
    all: bool = True  # all packings, or the first

    @property
    def side(self):
        return self.colors**2

    @property
    def width(self):
        """Columns of the fundamental domain."""
        return self.step or self.side

    @property
    def order(self):
        return self.side // self.width

    def cells(self):
        return list(product(range(self.side), range(self.width)))

    def label(self, plane, row, column):
        """The variable of a label and what the automorphism adds to its color."""
        row, column = row % self.side, column % self.side
        number = (plane * self.side + row) * self.width + column % self.width
        return number, column // self.width

    def labels(self):
        return self.side * self.width * (1 if self.kind == "corner" else 2)

    def sides(self, row, column):
        """The labels of the tile of a cell, in the order of the digits of its number."""
        if self.kind == "corner":
            at = [(0, 0, 1), (0, 1, 1), (0, 1, 0), (0, 0, 0)]  # NE SE SW NW
        else:
            at = [(0, 0, 0), (1, 0, 1), (0, 1, 0), (1, 0, 0)]  # N E S W
        return [self.label(plane, row + south, column + east) for plane, south, east in at]

    def color(self, shown, power):
        """The color of the variable when its label shows a color."""
        return (shown - power) % self.colors

    def orbit(self, shown):
        """The first of the tiles (or pairs) that the automorphism makes of one."""
        turns = range(self.order)
        return min(tuple((s + turn) % self.colors for s in shown) for turn in turns)

    def fixed(self):
        """Labels whose color is given."""
        origin = self.sides(0, 0) if self.pinned else []
        return {v: self.color(0, power) for v, power in origin}

    def caps(self):
        """Labels, and how often each color occurs among them."""
        if self.order > 1:
            return []
        size = self.side**2
        planes = range(0, self.labels(), size)
        return [(list(range(p, p + size)), [self.colors**3] * self.colors) for p in planes]

    def check(self, labels):
        """Whether labels, one color for each variable, are a packing: from the definition."""
        seen = set()
        for row, column in product(range(self.side), repeat=2):
            side = self.sides(row, column)
            seen.add(tuple((labels[v] + power) % self.colors for v, power in side))
        return len(seen) == self.colors**4


@dataclass
class Model:
    """0/1 variables 1, 2, ...; `point[v][c]` says that label v has color c."""

    problem: Problem | Board
    caps: bool
    seed: int = 0
    variables: int = 0
    point: list = field(default_factory=list)
    exactly_one: list = field(default_factory=list)
    blocks: list = field(default_factory=list)  # the exactly-one groups of one cell or pair
    ands: list = field(default_factory=list)  # (x, [y, ...]): x is the and of the y
    counts: list = field(default_factory=list)  # (variables, number)
    true: list = field(default_factory=list)

    def __post_init__(self):
        p, colors = self.problem, range(self.problem.colors)
        self.point = [[self.new() for _ in colors] for _ in range(p.labels())]
        self.exactly_one += self.point
        used = {}
        for row, column in p.cells():
            used_here = []
            for shown in product(colors, repeat=4):
                tile = self.conjunction(p.sides(row, column), shown)
                used_here.append(tile)
                used.setdefault(p.orbit(shown), []).append(tile)
            self.blocks.append(used_here)
        self.exactly_one += used.values()
        self.true = [self.point[v][color] for v, color in p.fixed().items()]
        if self.caps:
            self.add_caps()
        self.exactly_one += self.blocks
        self.shuffle()

    def new(self):
        self.variables += 1
        return self.variables

    def conjunction(self, labels, shown):
        points = [self.point[v][self.problem.color(s, power)] for (v, power), s in zip(labels, shown)]
        variable = self.new()
        self.ands.append((variable, sorted(set(points))))
        return variable

    def add_caps(self):
        p, colors = self.problem, range(self.problem.colors)
        for labels, numbers in p.caps():
            self.counts += [([self.point[v][c] for v in labels], numbers[c]) for c in colors]
        if p.kind != "corner":
            return
        for south, east in [(0, 1), (1, 0)]:
            pairs = {}
            for row, column in p.cells():
                two = [p.label(0, row, column), p.label(0, row + south, column + east)]
                here = []
                for shown in product(colors, repeat=2):
                    here.append(self.conjunction(two, shown))
                    pairs.setdefault(p.orbit(shown), []).append(here[-1])
                self.blocks.append(here)
            self.counts += [(pair, p.colors**2) for pair in pairs.values()]

    def shuffle(self):
        """Another order of everything, and other numbers: what a seed changes."""
        if not self.seed:
            return
        rng = random.Random(self.seed)
        names = list(range(1, self.variables + 1))
        rng.shuffle(names)
        new = lambda group: [names[v - 1] for v in group]
        self.point = [new(group) for group in self.point]
        self.exactly_one = [new(group) for group in self.exactly_one]
        self.blocks = [new(group) for group in self.blocks]
        self.ands = [(names[x - 1], new(group)) for x, group in self.ands]
        self.counts = [(new(group), number) for group, number in self.counts]
        self.true = new(self.true)
        for constraints in (self.exactly_one, self.ands, self.counts):
            rng.shuffle(constraints)

    def labels(self, holds):
        """The labels of a solution, from what says whether a variable holds."""
        return [next(c for c, x in enumerate(group) if holds(x)) for group in self.point]


PROBLEMS = {
    "B1": Problem("wang", 2, pinned=False),
    "B2": Problem("wang", 2),
    "B4": Problem("corner", 3, step=3),
    "B5": Problem("corner", 3, all=False),
    "B6": Problem("corner", 4, step=4, all=False),
    "B6u": Problem("corner", 4, all=False),
    "MM": Board(3, 6, 4),
    "MMp": Board(3, 6, 4, pin=(0, 2)),
}
# Small enough to try all labels: `check.py` does, and asks every peer.
TINY = {
    "corner": Problem("corner", 2),
    "quotient": Problem("corner", 2, step=2),
    "free": Problem("corner", 2, pinned=False),
    "lying": Board(2, 3, 2),
    "standing": Board(2, 2, 3),
    "row": Board(2, 6, 1, border=None),
    "open": Board(2, 3, 2, border=None),
    "pinned": Board(2, 3, 2, border=None, pin=(0, 1)),
    "framed": Board(2, 3, 2, border=(0, 0, 1, 0, 1, 0, 0, 1, 1, 0)),
}
