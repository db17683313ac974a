"""Boards: all squares over some colors, which may be turned, in a rectangle with a given border.

The squares are the tiles up to rotation, each lies once; there are 24 with 3 colors (MacMahon) and
6 with 2. The labels are the colors of the edges: those between rows first, then those between
columns. A `Board` answers the questions of `problem.Problem`, so the same `Model` says it.
"""

from dataclasses import dataclass
from functools import cache
from itertools import product


@dataclass(frozen=True)
class Board:
    colors: int
    width: int
    height: int
    border: int | tuple | None = 0  # the color all around, those of `outer`, or None for free
    pin: tuple | None = None  # row and column of the square of color 0 only

    kind = "board"
    order = 1  # no automorphism
    all = True

    def cells(self):
        """Column by column: a board is wider than high, and some peers fill it in this order."""
        return [(row, column) for column in range(self.width) for row in range(self.height)]

    def labels(self):
        return (self.height + 1) * self.width + self.height * (self.width + 1)

    def sides(self, row, column):
        """The labels of the square of a cell, N E S W; no automorphism adds to them."""
        north = row * self.width + column
        west = (self.height + 1) * self.width + row * (self.width + 1) + column
        return [(north, 0), (west + 1, 0), (north + self.width, 0), (west, 0)]

    def color(self, shown, power):
        return shown

    def orbit(self, shown):
        """The square of a tile: the first of its rotations."""
        return min(shown[turn:] + shown[:turn] for turn in range(4))

    @cache
    def squares(self):
        return sorted({self.orbit(shown) for shown in product(range(self.colors), repeat=4)})

    @cache
    def outer(self):
        """The labels of the border: those of one cell only."""
        sides = [v for cell in self.cells() for v, _ in self.sides(*cell)]
        return [v for v in range(self.labels()) if sides.count(v) == 1]

    @cache
    def fixed(self):
        """Labels whose color is given."""
        outer = self.outer() if self.border is not None else []
        border = self.border if isinstance(self.border, tuple) else (self.border,) * len(outer)
        fixed = dict(zip(outer, border))
        if self.pin:
            fixed |= {v: 0 for v, _ in self.sides(*self.pin)}
        return fixed

    def caps(self):
        """Labels, and how often each color occurs among them: two sides meet on an inner edge."""
        if self.border is None:
            return []
        sides = sum(square.count(0) for square in self.squares())
        border = Board(self.colors, self.width, self.height, self.border).fixed().values()
        numbers = [(sides + list(border).count(color)) // 2 for color in range(self.colors)]
        return [(list(range(self.labels())), numbers)]

    def check(self, labels):
        """Whether labels are a packing: from the definition."""
        laid = [self.orbit(tuple(labels[v] for v, _ in self.sides(*cell))) for cell in self.cells()]
        given = all(labels[v] == color for v, color in self.fixed().items())
        return sorted(laid) == self.squares() and given
