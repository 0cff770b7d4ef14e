"""Edges of surfaces of any kind, chains of them and closed rims, rounded by the library; plane surfaces in which they end go up to
the ball."""

from typing import NamedTuple

import numpy as np

from ..failures import Refusal
from ..library import sc
from .outlines import filled, outline_of
from .planes import named


class Rolled(NamedTuple):
    cells: list
    error: float


def rolled(body, edge, radius, tolerance, cancel=None):
    """The Rolled cells of a Body with one of its edges rounded. Raises Refusal or an error of the library."""
    _require_alone(body, edge)
    asked = [(body.cells[a.cell], a.name, body.cells[b.cell], b.name) for a, b in edge.pairs]
    try:
        parts = ([sc.build.fillet_patches(*asked[0], radius, tolerance=tolerance, cancel=cancel)] if len(asked) == 1 else
                 sc.build.fillet_chain(asked, radius, tolerance=tolerance, cancel=cancel))
    except (sc.InvalidShape, sc.ToleranceNotReached) as error:
        raise Refusal(f"edge {edge.number}: {error}") from error
    new = {side.cell: patch for pair, part in zip(edge.pairs, parts) for side, patch in zip(pair, (part.first, part.second))}
    error = max(part.error for part in parts)
    replaced = {}
    if edge.is_closed:
        _require_closed(body, edge, parts)
    else:
        for corner, at, part in ((edge.pairs[0][0].start, 0, parts[0]), (edge.pairs[-1][0].end, -1, parts[-1])):
            replaced.update(_end(body, edge, corner, edge.pairs[at], part, new, replaced, tolerance))
    cells = []
    for number, cell in enumerate(body.cells):
        face = body.face_of[number]
        if face in replaced:
            cells += replaced[face] if number == body.faces[face].cells[0] else []
        else:
            cells.append(new.get(number, cell))
    return Rolled([*cells, *map(_facing, parts)], error)


def _facing(part):
    """The fillet with its normals to where those of the first patch point."""
    fillet = part.fillet
    middle = 0.5 * sum(fillet.domain[0])
    points, normals = fillet.evaluate_grid_with_normals([middle], fillet.domain[1][:1])
    (u, v), = part.first.nearest(points.reshape(1, 3)).parameters
    _, others = part.first.evaluate_grid_with_normals([u], [v])
    return fillet if np.vdot(normals, others) > 0.0 else fillet.reversed('u')


def _require_alone(body, edge):
    """Raises Refusal where other surfaces end at corners inside a chain, or a cell would be rounded twice."""
    own = [side.cell for pair in edge.pairs for side in pair]
    if len(set(own)) < len(own):
        raise Refusal(f"edge {edge.number}: a patch lies along it twice: split it there first")
    if edge.is_closed and len(edge.pairs) == 1:
        inner = ()
    else:
        inner = [first.end for first, _ in (edge.pairs if edge.is_closed else edge.pairs[:-1])]
    for corner in inner:
        if not _cells_at(body, corner) <= set(own):
            raise Refusal(f"edge {edge.number}: another surface ends at a joint of it")


def _cells_at(body, corner):
    return {side.cell for side in body.sides if corner in (side.start, side.end)}


def _require_closed(body, edge, parts):
    """The start of the first fillet is the end of the last one."""
    first, last = parts[0].fillet, parts[-1].fillet
    if first.periodic[0]:
        return
    ends = [np.asarray(patch.boundary(side).points) for patch, side in ((first, 'u_start'), (last, 'u_end'))]
    if ends[0].shape != ends[1].shape or not np.abs(ends[0] - ends[1]).max() <= 1e-9 * body.size:
        raise Refusal(f"edge {edge.number}: it is closed, but does not go on smoothly where it closes")


def _end(body, edge, corner, pair, part, new, replaced, tolerance):
    """{number of a plane face in which an edge ends: what is left of it}."""
    cells = _cells_at(body, corner)
    own = [side.cell for side in pair]
    faces = [body.face_of[cell] for cell in own]
    others = {body.face_of[cell] for cell in cells} - set(faces)
    where = f"edge {edge.number}, {named(body, corner)}"
    if any(body.face_of[cell] in faces for cell in cells - set(own)):
        raise Refusal(f"{where}: a surface beside it has a seam there")
    if not others:
        return {}
    if len(others) > 1 or body.faces[min(others)].plane is None or min(others) in replaced:
        raise Refusal(f"{where}: surfaces end there that would have to be trimmed; one plane could be cut back")
    face = others.pop()
    outline = outline_of(body, face, {}, where)
    ending, starting = outline.at(corner)
    if {outline.spans[ending].across, outline.spans[starting].across} != set(faces):
        raise Refusal(f"{where}: the surface at its end does not meet both surfaces of the edge there")
    pieces = [curve for span in outline.spans for curve in span.curves]
    left = {i: _shortened(body, outline.spans[i], corner, face, new, body.corners) for i in (ending, starting)}
    pieces[ending], pieces[starting] = left[ending], left[starting]
    arc = _between(part.fillet, pieces[ending].points[-1], pieces[starting].points[0], body.size, where)
    for curve in (pieces[ending], arc, pieces[starting]):
        off = np.abs((np.asarray(curve.points) - body.faces[face].plane[0]) @ outline.normal).max()
        if not off <= tolerance:
            raise Refusal(f"{where}: the rounded edge leaves the plane in which it ends by {off:.2g}, and would have to be trimmed")
    pieces.insert(ending + 1, arc)
    made = filled(pieces, outline.normal, body.size)
    if not made:
        raise Refusal(f"{where}: what is left of the plane there is not seen from one point: the radius is too large for it, or it "
                      "has corners that go inwards")
    return {face: made}


def _shortened(body, span, corner, face, new, corners):
    """What is left of a side of a plane face that a rounded surface has, in the direction in which the face has it."""
    for i, side in enumerate(body.sides):
        other = body.across.get(i)
        if other is None or side.cell not in new or body.face_of[body.sides[other].cell] != face:
            continue
        if {side.start, side.end} == {span.start, span.end} and body.face_of[side.cell] == span.across:
            curve = new[side.cell].boundary(side.name)
            far = corners[span.start if span.end == corner else span.end]
            gaps = np.linalg.norm(curve.points[[0, -1]] - far, axis=1)
            return curve if (gaps[0] <= gaps[1]) == (span.end == corner) else curve.reversed()
    raise Refusal(f"{named(body, corner)}: the surface at its end does not meet both surfaces of the edge there")


def _between(fillet, start, end, size, where):
    """The end of a fillet from one point to another."""
    for side in ('u_start', 'u_end'):
        curve = fillet.boundary(side)
        for one in (curve, curve.reversed()):
            if max(np.abs(one.points[0] - start).max(), np.abs(one.points[-1] - end).max()) <= 1e-9 * size:
                return one
    raise Refusal(f"{where}: the rounded edge does not end where what is left of the surfaces does")
