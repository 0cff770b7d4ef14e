"""The net of patches: a cage of the points they share, handles for tangents and twists, arrows."""

from dataclasses import replace

import numpy as np

from ..shape.infinity import foot_of
from .net_vertices import Vertices


def make(definition):
    """The Net of a definition of patches: one vertex for each point of the pool that they use."""
    vertices = Vertices(definition.pool)
    nets = [_point_net(piece) for piece in definition.pieces]
    vertex_of = _points(vertices, nets)
    finite = vertices.pool[:, 3] != 0
    grids = [np.where(finite[net], vertex_of[net], -1) for net in nets]
    faces, along_u, along_v = [], [], []
    for piece, grid in zip(definition.pieces, grids):
        periodic = piece.periodic or (False, False)
        faces += _faces(grid, periodic)
        along_u.append(_pairs(grid, 0, periodic[0]))
        along_v.append(_pairs(grid, 1, periodic[1]))
    _arrows(vertices, definition.pieces, nets)
    handles = _Handles(vertices, vertex_of)
    pieces = [handles.add(piece) if piece.kind == 'hermite' else piece for piece in definition.pieces]
    lines = (_unique(along_u + [handles.pairs_u]), _unique(along_v + [handles.pairs_v]))
    return vertices.net(definition, pieces, faces=tuple(faces), lines=lines)


def _point_net(piece):
    return piece.indices[0] if piece.kind == 'hermite' else piece.indices


def _points(vertices, nets):
    """Vertices for all finite points; the vertex of each row of the pool, or -1."""
    used = np.unique(np.concatenate([net.ravel() for net in nets]))
    vertex_of = np.full(len(vertices.pool), -1)
    finite = used[vertices.pool[used, 3] != 0]
    first = vertices.points(finite)
    vertex_of[finite] = np.arange(first, first + len(finite))
    return vertex_of


def _faces(grid, periodic):
    """The quads of a grid of vertices; triangles at poles, nothing beside directions at infinity."""
    wrapped = np.pad(grid, [(0, int(periodic[0])), (0, int(periodic[1]))], mode='wrap')
    quads = np.stack([wrapped[:-1, :-1], wrapped[1:, :-1], wrapped[1:, 1:], wrapped[:-1, 1:]], -1).reshape(-1, 4)
    quads = quads[(quads >= 0).all(1)]
    whole = (np.diff(np.sort(quads, axis=1), axis=1) > 0).all(1)
    faces = quads[whole].tolist()
    for quad in quads[~whole].tolist():
        corners = [corner for i, corner in enumerate(quad) if corner != quad[i - 1]]
        if len(set(corners)) == len(corners) >= 3:
            faces.append(corners)
    return faces


def _pairs(grid, axis, periodic):
    """Pairs of neighbors along an axis."""
    first, second = grid, np.roll(grid, -1, axis)
    if not periodic:
        keep = [slice(None), slice(None)]
        keep[axis] = slice(0, -1)
        first, second = first[tuple(keep)], second[tuple(keep)]
    pairs = np.stack([first.ravel(), second.ravel()], -1)
    return pairs[(pairs >= 0).all(1) & (pairs[:, 0] != pairs[:, 1])]


def _unique(pairs):
    pairs = [np.asarray(some, dtype=np.int64).reshape(-1, 2) for some in pairs]
    return np.unique(np.sort(np.concatenate(pairs), axis=1), axis=0)


def _arrows(vertices, pieces, nets):
    """An arrow for each direction at infinity."""
    pool, known = vertices.pool, set()
    for piece, net in zip(pieces, nets):
        for at in np.argwhere(pool[net, 3] == 0):
            row = net[tuple(at)]
            if row not in known:
                known.add(row)
                vertices.arrow(row, foot_of(pool, net, at, piece.periodic))


class _Handles:
    """Tangents at a third of their length and twists at a ninth: inner points of the Bezier form.

    At the last row and column they point back, into the patch. A tangent that patches share at one
    point is one vertex; one row that serves two points becomes two.
    """

    def __init__(self, vertices, vertex_of):
        self.vertices, self.vertex_of = vertices, vertex_of
        self._known, self._taken = {}, set(vertices.rows)
        self.pairs_u, self.pairs_v = [], []

    def add(self, piece):
        """The piece, whose handles have their own rows."""
        indices = piece.indices.copy()
        factors = [_thirds(parameters) for parameters in piece.knots]
        count_u, count_v = indices.shape[1:]
        for i in range(count_u):
            for j in range(count_v):
                point = self.vertex_of[indices[0, i, j]]
                at_point = (point, point, point)
                u, indices[1, i, j] = self._handle(indices[1, i, j], at_point, factors[0][i])
                v, indices[2, i, j] = self._handle(indices[2, i, j], at_point, factors[1][j])
                twist, indices[3, i, j] = self._handle(indices[3, i, j], (u, v, point), factors[0][i] * factors[1][j])
                self.pairs_u += [(point, u), (v, twist)]
                self.pairs_v += [(point, v), (u, twist)]
        return replace(piece, indices=indices)

    def _handle(self, row, origin, factor):
        """The vertex of a handle, and the row that it sets."""
        key = (row, origin, factor)
        if key not in self._known:
            own = self.vertices.new_row(row) if row in self._taken else row
            self._taken.add(row)
            vertex = self.vertices.handle(row, origin, factor)
            self.vertices.set_row(vertex, own)
            self._known[key] = vertex, own
        return self._known[key]


def _thirds(parameters):
    """A third of the step after each parameter; of the step before the last, backwards."""
    steps = np.diff(parameters) / 3.0
    return np.append(steps, -steps[-1:])
