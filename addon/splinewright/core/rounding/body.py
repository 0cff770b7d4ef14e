"""What patches bound together: faces, the edges in which they meet, and the corners in which these end."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..verbs import patch_curves
from .cells import FLAT, SMOOTH_TURN, parts_of, plane_of

#: Places that lie so near to each other, as a part of the size of all, are one.
_SAME = 1e-6
#: So often cells are cut where corners of others lie on their sides.
_ROUNDS = 4
_SHARES = (0.25, 0.5, 0.75)
#: In the direction in which they go round their patch, seen from where its normals point to.
_ROUND = (('v_start', False), ('u_end', False), ('v_end', True), ('u_start', True))


class Side(NamedTuple):
    """A side of a cell, in the direction in which it goes around it."""

    cell: int
    name: str
    curve: object
    start: int                          # numbers of corners
    end: int


@dataclass
class Face:
    """A cell, or cells side by side in one plane."""

    cells: list
    plane: tuple | None                 # (a point, the unit normal)


@dataclass
class Edge:
    """Edges that are rounded as one: pairs of Sides, the first ones of faces that continue as each other, and the second ones."""

    number: int                         # as users count: from 1
    pairs: list = field(default_factory=list)
    is_closed: bool = False


@dataclass
class Body:
    cells: list
    owners: list                        # for each cell a number of whose it is
    planes: list                        # for each cell its cells.plane_of()
    corners: np.ndarray                 # (n, 3)
    sides: list
    across: dict                        # number of a side -> that of the side that is one edge with it
    faces: list
    face_of: list                       # for each cell the number of its face
    edges: list
    size: float

    def side(self, cell, name):
        """The number of a side, or None."""
        return next((i for i, side in enumerate(self.sides) if (side.cell, side.name) == (cell, name)), None)

    def faces_at(self, corner):
        """The numbers of the faces that have a corner."""
        return {self.face_of[side.cell] for side in self.sides if corner in (side.start, side.end)}


def body_of(owned):
    """The Body of pairs of a NurbsPatch and a number of whose it is, cut where corners of others lie on their sides. Raises
    Refusal."""
    for _ in range(_ROUNDS):
        body = _body([cell for cell, _ in owned], [owner for _, owner in owned])
        cuts = _cuts(body)
        if not cuts:
            return body
        owned = [(part, owner) for i, (cell, owner) in enumerate(owned)
                 for part in (parts_of(cell, *cuts[i]) if i in cuts else [cell])]
    raise Refusal("corners of patches lie on sides of others that would have to be cut again and again: let their sides meet first")


def _cuts(body):
    """{number of a cell: (axis, parameters)} where corners of others lie on sides that are one edge with no other one."""
    near, found = _SAME * body.size, {}
    for number, side in enumerate(body.sides):
        if number in body.across or side.cell in found:
            continue
        border = body.cells[side.cell].boundary(side.name)
        nearest = border.nearest(body.corners)
        start, end = border.domain
        inside = [at for i, (at, off) in enumerate(zip(nearest.parameters, nearest.distances))
                  if off <= near and i not in (side.start, side.end) and start < at < end]
        if inside:
            found[side.cell] = ('vu'['uv'.index(side.name[0])], sorted(set(inside)))
    return found


def _body(cells, owners):
    size = max(np.ptp(np.concatenate([np.asarray(cell.points).reshape(-1, 3) for cell in cells]), axis=0).max(), 0.0)
    sides, corners = _sides(cells, _SAME * size)
    across = _across(sides, _SAME * size)
    planes = [plane_of(cell) for cell in cells]
    smooth = {(a, b) for a, b in across.items() if _is_smooth(cells, planes, sides[a], sides[b])}
    faces, face_of = _faces(cells, planes, sides, smooth)
    body = Body(cells, owners, planes, corners, sides, across, faces, face_of, [], size)
    body.edges = _edges(body, smooth)
    return body


def _sides(cells, near):
    sides, places = [], []

    def corner(point):
        for i, place in enumerate(places):
            if np.abs(point - place).max() <= near:
                return i
        places.append(point)
        return len(places) - 1

    for number, cell in enumerate(cells):
        for name, is_turned in _ROUND:
            curve, reason = patch_curves.side_of(cell, name)
            if reason:
                continue
            curve = curve.reversed() if is_turned else curve
            if curve.periodic:
                curve = curve.split(curve.domain[0])[0]
            ends = curve.points[[0, -1]]
            sides.append(Side(number, name, curve, corner(ends[0]), corner(ends[1])))
    return sides, np.array(places).reshape(-1, 3)


def _across(sides, near):
    found = {}
    for i, a in enumerate(sides):
        for j in range(i + 1, len(sides)):
            if i not in found and j not in found and _are_one(a, sides[j], near):
                found[i], found[j] = j, i
    return found


def _are_one(a, b, near):
    is_closed = a.start == a.end
    if {a.start, a.end} != {b.start, b.end} and not (is_closed and b.start == b.end):
        return False
    for one, other in ((a, b), (b, a)):
        start, end = one.curve.domain
        points = one.curve.evaluate([start + share * (end - start) for share in _SHARES])
        if not other.curve.nearest(points).distances.max() <= near:
            return False
    return True


def require_two(body, edge):
    """Raises Refusal where other sides lie on an edge than two."""
    own = {(side.cell, side.name) for pair in edge.pairs for side in pair}
    for pair in edge.pairs:
        for side in body.sides:
            if (side.cell, side.name) not in own and _are_one(pair[0], side, _SAME * body.size):
                raise Refusal("edge {number}: more than two surfaces meet in it", number=edge.number)


def _is_smooth(cells, planes, a, b):
    first, second = planes[a.cell], planes[b.cell]
    if first is not None and second is not None:
        return bool(np.linalg.norm(np.cross(first[1], second[1])) <= SMOOTH_TURN)
    found = sc.seam_continuity(cells[a.cell], a.name, cells[b.cell], b.name)
    return bool(found.angle <= SMOOTH_TURN)


def _faces(cells, planes, sides, smooth):
    root = list(range(len(cells)))

    def of(cell):
        while root[cell] != cell:
            cell = root[cell]
        return cell

    for a, b in sorted(smooth):
        one, other = sides[a].cell, sides[b].cell
        if planes[one] is not None and planes[other] is not None:
            root[max(of(one), of(other))] = min(of(one), of(other))
    roots = sorted({of(cell) for cell in range(len(cells))})
    groups = {one: [cell for cell in range(len(cells)) if of(cell) == one] for one in roots}
    faces = [Face(groups[one], planes[one]) for one in roots]
    return faces, [roots.index(of(cell)) for cell in range(len(cells))]


def _edges(body, smooth):
    pairs = [(i, j) for i, j in sorted(body.across.items()) if i < j and (i, j) not in smooth]
    edges, taken = [], set()
    for pair in pairs:
        if pair in taken:
            continue
        chain = [pair]
        taken.add(pair)
        for at_end in (True, False):
            while (following := _following(body, smooth, chain[-1 if at_end else 0], at_end, pairs, taken)) is not None:
                chain.insert(len(chain) if at_end else 0, following)
                taken.update((following, following[::-1]))
        edges.append(_edge(body, smooth, len(edges) + 1, chain))
    return edges


def _edge(body, smooth, number, chain):
    pairs = [(body.sides[i], body.sides[j]) for i, j in chain]
    first = pairs[0][0]
    is_closed = first.start == first.end if len(chain) == 1 else _goes_on(body, smooth, chain[-1], chain[0])
    return Edge(number, pairs, is_closed)


def _following(body, smooth, pair, at_end, pairs, taken):
    """The pair of sides that continues one, in order, or before it."""
    for one in pairs:
        for candidate in (one, one[::-1]):
            if one in taken or one[::-1] in taken:
                continue
            if _goes_on(body, smooth, pair, candidate) if at_end else _goes_on(body, smooth, candidate, pair):
                return candidate
    return None


def _goes_on(body, smooth, pair, following):
    """Whether a pair of sides ends where another begins, with the direction and the tangent planes of both faces."""
    a, b = body.sides[pair[0]], body.sides[following[0]]
    if a.end != b.start or a.start == a.end or b.start == b.end or pair[0] == following[0]:
        return False
    ways = [_way(side.curve, at) for side, at in ((a, 1), (b, 0))]
    if not np.linalg.norm(ways[0] - ways[1]) <= SMOOTH_TURN:
        return False
    return all(_are_one_face(body, smooth, body.sides[i], body.sides[j]) for i, j in zip(pair, following))


def _way(curve, at):
    start, end = curve.domain
    way = curve.derivatives([end if at else start], 1, side='left' if at else 'right')[0, 1]
    return way / np.linalg.norm(way)


def _are_one_face(body, smooth, a, b):
    """Whether cells of two sides are one, or continue as each other."""
    if body.face_of[a.cell] == body.face_of[b.cell]:
        return True
    return any({body.sides[i].cell, body.sides[j].cell} == {a.cell, b.cell} for i, j in smooth)


def is_straight(curve):
    """Whether a curve is a segment, whatever its pace."""
    points = np.asarray(curve.points)
    along = points[-1] - points[0]
    length = np.linalg.norm(along)
    if not length > 0.0:
        return False
    off = np.cross(points - points[0], along / length)
    shares = (points - points[0]) @ along / length
    return bool(np.abs(off).max() <= FLAT * length and (np.diff(shares) >= 0.0).all())
