"""Vertices of a net, collected one after the other."""

from dataclasses import replace

import numpy as np

from .exact_net import Net


class Vertices:
    """Grows the arrays of a Net, and the pool where two handles would share a row."""

    def __init__(self, pool):
        self.pool = pool
        self._new_rows = []
        self.positions, self.weights, self.rows, self.origins, self.factors = [], [], [], [], []
        self.arrows = []

    def __len__(self):
        return len(self.rows)

    def point(self, row):
        return self._add(self.pool[row, :3], row, weight=self.pool[row, 3])

    def points(self, rows):
        """Vertices for many rows at once; the number of the first."""
        first = len(self)
        self.positions.extend(self.pool[rows, :3])
        self.weights.extend(self.pool[rows, 3])
        self.rows.extend(rows)
        self.origins.extend([(-1, -1, -1)] * len(rows))
        self.factors.extend([1.0] * len(rows))
        return first

    def foot(self, position):
        return self._add(position, -1)

    def arrow(self, row, foot_position):
        """The head of an arrow that shows a direction at infinity."""
        foot = self.foot(foot_position)
        head = self.handle(row, (foot, foot, foot), 1.0)
        self.arrows.append((foot, head))
        return head

    def handle(self, row, origin, factor):
        """A vertex at origin + factor * row."""
        a, b, c = origin
        start = self.positions[a] + self.positions[b] - self.positions[c]
        return self._add(start + factor * self.pool[row, :3], row, origin, factor)

    def new_row(self, row):
        """A new row of the pool, equal to another."""
        self._new_rows.append(self.pool[row])
        return len(self.pool) + len(self._new_rows) - 1

    def place_handle(self, vertex, row, anchor, factor):
        """Make a vertex that is there already a handle at anchor + factor * row."""
        self.positions[vertex] = self.positions[anchor] + factor * self.pool[row, :3]
        self.rows[vertex], self.origins[vertex], self.factors[vertex] = row, (anchor,) * 3, factor

    def set_row(self, vertex, row):
        """What the vertex sets, where that is not the row it was placed by."""
        self.rows[vertex] = row

    def _add(self, position, row, origin=(-1, -1, -1), factor=1.0, weight=1.0):
        self.positions.append(np.asarray(position, dtype=np.float64))
        self.rows.append(row)
        self.origins.append(origin)
        self.factors.append(factor)
        self.weights.append(weight)
        return len(self.rows) - 1

    def net(self, source, pieces, **shown):
        pool = np.concatenate([self.pool, *[row[None] for row in self._new_rows]])
        return Net(source, replace(source, pool=pool, pieces=tuple(pieces)) if self._new_rows else source,
                   np.array(self.positions).reshape(-1, 3), np.array(self.weights),
                   np.array(self.rows, dtype=np.int32), np.array(self.origins, dtype=np.int32).reshape(-1, 3),
                   np.array(self.factors), arrows=tuple(self.arrows), **shown)
