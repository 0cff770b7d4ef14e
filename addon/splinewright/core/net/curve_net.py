"""The net of curves: cubics have handles, other curves a polygon, directions at infinity an arrow."""

from dataclasses import replace

import numpy as np

from ..shape.infinity import foot_of
from .exact_net import Spline
from .net_vertices import Vertices


def make(definition):
    """The Net of a definition of curves. Its splines are those of Blender, arrows last."""
    vertices = Vertices(definition.pool)
    pieces, splines = [], []
    infinite = []
    for number, piece in enumerate(definition.pieces):
        if piece.kind == 'hermite':
            piece, spline = _hermite(vertices, piece)
        elif is_plain_cubic(definition.pool, piece):
            spline = _cubic(vertices, piece)
        else:
            spline = _polygon(vertices, piece)
            infinite.append(piece)
        pieces.append(piece)
        splines.append(replace(spline, piece=number))
    for piece in infinite:
        splines += _arrows(vertices, piece)
    splines = tuple(spline for spline in splines if spline.count)
    return vertices.net(definition, pieces, splines=splines)


def is_plain_cubic(pool, piece):
    """Whether a piece is one cubic with handles."""
    return piece.kind == 'bezier' and len(piece.indices) == 4 and (pool[piece.indices, 3] == 1.0).all()


def _cubic(vertices, piece):
    """Two points, whose inner handles are the inner points; the outer handles set nothing."""
    p = vertices.pool[piece.indices, :3]
    vertices.foot(2 * p[0] - p[1])
    vertices.point(piece.indices[0])
    vertices.point(piece.indices[1])
    vertices.point(piece.indices[2])
    vertices.point(piece.indices[3])
    vertices.foot(2 * p[3] - p[2])
    return Spline('BEZIER', 2, smooth=(False, False))


def _polygon(vertices, piece):
    rows = piece.indices
    closed = bool(any(piece.periodic))
    if len(rows) > 2 and rows[0] == rows[-1]:
        rows, closed = rows[:-1], True
    finite = rows[vertices.pool[rows, 3] != 0]
    for row in finite:
        vertices.point(row)
    return Spline('POLY', len(finite), closed)


def _arrows(vertices, piece):
    """An arrow for each direction at infinity."""
    for i in np.flatnonzero(vertices.pool[piece.indices, 3] == 0):
        vertices.arrow(piece.indices[i], foot_of(vertices.pool, piece.indices, (i,), piece.periodic))
        yield Spline('POLY', 2)


def is_closed(piece):
    """Whether a Hermite piece ends in the point in which it begins."""
    points = piece.indices[0]
    return len(points) > 2 and bool(points[0] == points[-1])


def _hermite(vertices, piece):
    """Handles at a third of the tangents: those of the cubic Bezier segments on both sides."""
    points, incoming, outgoing = piece.indices
    closed = is_closed(piece)
    count = len(points) - 1 if closed else len(points)
    before, after = _steps_beside(np.diff(piece.knots[0]) / 3.0, count, closed)
    own = _own_rows(vertices, incoming, outgoing)
    arriving = np.append(incoming[-1:], incoming[1:]) if closed else incoming
    for i in range(count):
        left = vertices.foot(np.zeros(3))
        point = vertices.point(points[i])
        vertices.place_handle(left, arriving[i], point, -before[i])
        vertices.set_row(left, own[arriving[i]])
        vertices.handle(outgoing[i], (point, point, point), after[i])
    indices = np.stack([points, [own[row] for row in incoming], outgoing]).astype(np.int32)
    smooth = tuple(arriving[:count] == outgoing[:count])
    return replace(piece, indices=indices), Spline('BEZIER', count, closed, smooth)


def _own_rows(vertices, incoming, outgoing):
    """The row of each incoming tangent: a new one where an outgoing tangent has it, too."""
    own = {}
    for row, taken in zip(incoming, np.isin(incoming, outgoing)):
        if row not in own:
            own[row] = vertices.new_row(row) if taken else row
    return own


def _steps_beside(steps, count, closed):
    """A third of the parameter's step before and after each point; at open ends that of the other side."""
    if closed:
        return np.append(steps[-1:], steps[:-1])[:count], steps[:count]
    return np.append(steps[:1], steps), np.append(steps, steps[-1:])
