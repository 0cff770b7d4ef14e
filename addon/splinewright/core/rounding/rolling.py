"""Edges of surfaces of any kind, chains of them and closed rims, rounded by the library; planes beside them, and those in which
they end, go up to the ball."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from . import strips
from .outlines import filled, outline_of, segment
from .planes import named


class Rolled(NamedTuple):
    cells: list
    error: float


def rolled(body, edge, radius, tolerance, cancel=None):
    """The Rolled cells of a Body with one of its edges rounded. Raises Refusal or an error of the library."""
    rolling, refused, first = _Rolling(body, edge, radius, tolerance, cancel), None, None
    for width in (None, *strips.WIDTHS) if rolling.fits_as_it_is() else (*strips.WIDTHS, None):
        if width is None and first is not None:
            break
        try:
            found = rolling.tried(width)
        except (Refusal, sc.InvalidShape, sc.ToleranceNotReached) as error:
            refused = refused or error
            continue
        if not rolling.is_finer_than_needed():
            return found
        first = first or found
    if first is not None:
        return first
    if _names_an_edge(refused.args[0]):
        raise refused
    raise Refusal("edge {number}: {refused}", number=edge.number, refused=refused) from refused


def _names_an_edge(text):
    """Whether a sentence, or one within it, was filled with numbers of edges."""
    filled = getattr(text, 'arguments', {})
    return bool({'number', 'numbers'} & filled.keys()) or any(map(_names_an_edge, filled.values()))


class _Rolling:
    def __init__(self, body, edge, radius, tolerance, cancel):
        self.body, self.edge, self.radius, self.tolerance, self.cancel = body, edge, radius, tolerance, cancel
        found = [{body.face_of[pair[i].cell] for pair in edge.pairs} for i in range(2)]
        #: On both sides of the edge its face, where that is one.
        self.faces = tuple(min(faces) if len(faces) == 1 else None for faces in found)
        self.planes = [i for i, face in enumerate(self.faces) if face is not None and body.faces[face].plane is not None]
        self.ends = () if edge.is_closed else (edge.pairs[0][0].start, edge.pairs[-1][0].end)

    def _require_alone(self):
        """Raises Refusal where other patches end at joints of the chain, or one would be rounded twice."""
        pairs = self.edge.pairs if self.edge.is_closed else self.edge.pairs[:-1]
        own = [pair[i].cell for pair in self.edge.pairs for i in range(2) if i not in self.strips]
        if len(set(own)) < len(own):
            raise Refusal("edge {number}: a patch lies along it twice: split it there first", number=self.edge.number)
        along = {self.faces[i] for i in self.strips}
        for corner in {first.end for first, _ in pairs}:
            if any(cell not in own and self.body.face_of[cell] not in along for cell in self._cells_at(corner)):
                raise Refusal("edge {number}: another patch ends at a joint of it", number=self.edge.number)

    def _cells_at(self, corner):
        return {side.cell for side in self.body.sides if corner in (side.start, side.end)}

    def fits_as_it_is(self):
        """Whether the patches of plane faces are such that a ball touches both sides at one parameter."""
        sides = [pair[i] for i in self.planes for pair in self.edge.pairs]
        return all(strips.runs_square(self.body.cells[side.cell], side.name) for side in sides)

    def tried(self, width):
        """Rolled, with strips of a width, by the radius, in place of planes; None for the patches as they are."""
        self.strips = self.planes if width else []
        if width and not self.planes:
            raise Refusal("edge {number}: its surfaces are no planes", number=self.edge.number)
        self.outlines, self.new, self.at, self.left = {}, {}, {}, {}
        self._require_alone()
        asked = [self._asked(pair, width) for pair in self.edge.pairs]
        if len(asked) == 1:
            parts = [sc.build.fillet_patches(*asked[0], self.radius, tolerance=self.tolerance, cancel=self.cancel)]
        else:
            parts = sc.build.fillet_chain(asked, self.radius, tolerance=self.tolerance, cancel=self.cancel)
        self.sides = [(part.first, part.second) for part in parts]
        self.degree = max(part.fillet.degree[0] for part in parts)
        if self.edge.is_closed:
            self._require_closed(parts)
        for pair, sides in zip(self.edge.pairs, self.sides):
            self.new.update({pair[i].cell: sides[i] for i in range(2) if i not in self.strips})
        for i in self.strips:
            self.at.update({(self.faces[i], corner): self._contact(i, corner) for corner in self.ends})
        ends_in = {}
        for corner, part in zip(self.ends, (parts[0], parts[-1])):
            face = self._end(corner)
            if face is not None:
                ends_in.setdefault(face, []).append((corner, part))
        for face, ends in ends_in.items():
            self._take_back(face, ends)
        for i in self.strips:
            self._refill(i)
        return Rolled([*self._cells(), *map(_facing, parts)], max(part.error for part in parts))

    def is_finer_than_needed(self):
        """Whether segments and arcs, beside which strips are exact, were fitted after all, for digits that were lost."""
        curves = [pair[i].curve for pair in self.edge.pairs for i in range(2)]
        return bool(self.strips) and max(curve.degree for curve in curves) <= 2 < self.degree

    def outline(self, face):
        if face not in self.outlines:
            edge_of = {self.body.side(side.cell, side.name): self.edge.number for pair in self.edge.pairs for side in pair}
            self.outlines[face] = outline_of(self.body, face, edge_of, phrase("edge {number}", number=self.edge.number))
        return self.outlines[face]

    def _asked(self, pair, width):
        found = []
        for i, side in enumerate(pair):
            if i in self.strips:
                found += [self._strip(pair, i, width * self.radius), 'v_start']
            else:
                found += [self.body.cells[side.cell], side.name]
        return tuple(found)

    def _strip(self, pair, i, width):
        """Of the plane face on one side of a pair, on the curve that the other side has, as its outline runs."""
        face, other = self.faces[i], pair[1 - i]
        curve = self.body.cells[other.cell].boundary(other.name)
        normal, own = self.outline(face).normal, pair[i]
        runs_with = self.body.planes[own.cell][1] @ normal > 0.0
        place = own.curve.evaluate(0.5 * sum(own.curve.domain))
        ways = [one.derivatives(one.nearest(place[None]).parameters, 1)[0, 1] for one in (curve, own.curve)]
        if (ways[0] @ ways[1] > 0.0) != runs_with:
            curve = curve.reversed()
        return strips.strip_of(curve, normal, width, self._slides(face, own, curve))

    def _slides(self, face, own, curve):
        """The directions in which a strip ends where the edge does, along the sides of the face beside it."""
        found = [None, None]
        for corner in {own.start, own.end} & set(self.ends):
            beside = self._beside(face, corner)
            place = self.body.corners[corner]
            gaps = np.linalg.norm(np.asarray(curve.points)[[0, -1]] - place, axis=1)
            found[int(gaps.argmin())] = self.body.corners[beside.start if beside.end == corner else beside.end] - place
        return found

    def _beside(self, face, corner):
        """The Span of a plane face beside the edge in a corner."""
        outline = self.outline(face)
        span = next(outline.spans[i] for i in outline.at(corner) if outline.spans[i].edge != self.edge.number)
        if not span.is_line:
            raise Refusal("{where}: a side that is no straight line ends there, and would have to be trimmed",
                          where=self._where(corner))
        return span

    def _require_closed(self, parts):
        """Raises Refusal where the start of the first fillet is not the end of the last one."""
        first, last = parts[0].fillet, parts[-1].fillet
        if first.periodic[0]:
            return
        start, end = (np.asarray(patch.boundary(side).points) for patch, side in ((first, 'u_start'), (last, 'u_end')))
        if start.shape != end.shape or not np.abs(start - end).max() <= 1e-9 * self.body.size:
            raise Refusal("edge {number}: it is closed, but has a corner where it closes", number=self.edge.number)

    def _where(self, corner):
        return phrase("edge {number}, {body}", number=self.edge.number, body=named(self.body, corner))

    def _end(self, corner):
        """The plane face in which the edge ends, or None."""
        body, where = self.body, self._where(corner)
        own = {pair[i].cell for pair in self.edge.pairs for i in range(2) if i not in self.strips}
        kept = {body.face_of[cell] for cell in own}
        if any(body.face_of[cell] in kept for cell in self._cells_at(corner) - own):
            raise Refusal("{where}: a surface beside it has a seam there", where=where)
        others = body.faces_at(corner) - kept - set(self.faces)
        if not others:
            return None
        face = min(others)
        if len(others) > 1 or body.faces[face].plane is None:
            raise Refusal("{where}: surfaces end there that would have to be trimmed; one plane could be cut back", where=where)
        spans = self.outline(face).spans
        if {spans[i].across for i in self.outline(face).at(corner)} != set(self._faces_at(corner)):
            raise Refusal("{where}: the surface at its end does not meet both surfaces of the edge there", where=where)
        return face

    def _take_back(self, face, ends):
        """Fill the rest of a plane in which the edge ends, once or twice. ends: (corner, a part of the edge)."""
        outline = self.outline(face)
        pieces = [list(span.curves) for span in outline.spans]
        for corner, _ in ends:
            for i in outline.at(corner):
                pieces[i] = [self._shortened(outline.spans[i], corner, face)]
        for corner, part in ends:
            ending, starting = outline.at(corner)
            arc = self._arc(part.fillet, _ends(pieces[ending][0])[1], _ends(pieces[starting][0])[0], self._where(corner))
            for piece in (pieces[ending][0], arc, pieces[starting][0]):
                off = np.abs((_points(piece) - self.body.faces[face].plane[0]) @ outline.normal).max()
                if not off <= self.tolerance:
                    raise Refusal("{where}: the rounded edge leaves the plane in which it ends by {off:.2g}, and would have to be "
                                  "trimmed",
                                  where=self._where(corner), off=off)
            pieces[ending].append(arc)
        self._fill(face, [piece for those in pieces for piece in those], self._where(ends[0][0]))

    def _faces_at(self, corner):
        pair = self.edge.pairs[0] if corner == self.ends[0] else self.edge.pairs[-1]
        return [self.body.face_of[side.cell] for side in pair]

    def _contact(self, i, corner):
        """Where the rest of a strip ends in a corner."""
        left = self.sides[0 if corner == self.ends[0] else -1][i]
        ends = np.asarray(left.boundary('v_start').points)[[0, -1]]
        beside = self._beside(self.faces[i], corner)
        gaps = np.linalg.norm(ends - self.body.corners[corner], axis=1)
        point = ends[int(gaps.argmin())]
        start, end = (self.body.corners[number] for number in (beside.start, beside.end))
        way = (end - start) if beside.start == corner else (start - end)
        share = (point - self.body.corners[corner]) @ way / (way @ way)
        off = np.linalg.norm(point - self.body.corners[corner] - share * way)
        if not (0.0 < share < 1.0 and off <= self.tolerance):
            raise Refusal("{where}: the radius is too large for the side of the plane there", where=self._where(corner))
        return point

    def _shortened(self, span, corner, face):
        """The rest of a side of a plane face that a surface beside the edge has, as it runs in the face."""
        if (span.across, corner) in self.at:
            return self._line(span.across, span)
        body = self.body
        for i, side in enumerate(body.sides):
            other = body.across.get(i)
            if other is None or side.cell not in self.new or body.face_of[body.sides[other].cell] != face:
                continue
            if {side.start, side.end} == {span.start, span.end} and body.face_of[side.cell] == span.across:
                curve = self.new[side.cell].boundary(side.name)
                far = body.corners[span.start if span.end == corner else span.end]
                gaps = np.linalg.norm(np.asarray(curve.points)[[0, -1]] - far, axis=1)
                return curve if (gaps[0] <= gaps[1]) == (span.end == corner) else curve.reversed()
        raise Refusal("{body}: the surface at its end does not meet both surfaces of the edge there", body=named(body, corner))

    def _line(self, face, span):
        """A straight side of which one end, or both, are where the ball touches a plane face beside the edge."""
        return segment(*(self.at.get((face, corner), self.body.corners[corner]) for corner in (span.start, span.end)))

    def _arc(self, fillet, start, end, where):
        """The end of a fillet from one point to another."""
        for side in ('u_start', 'u_end'):
            curve = fillet.boundary(side)
            for one in (curve, curve.reversed()):
                gaps = np.abs(np.asarray(one.points)[[0, -1]] - [start, end]).max()
                if gaps <= 1e-9 * self.body.size:
                    return one
        raise Refusal("{where}: the rounded edge and the trimmed surfaces do not end together", where=where)

    def _refill(self, i):
        """The rest of the plane face of strips."""
        face, pieces = self.faces[i], []
        if face in self.left:
            raise Refusal("edge {number}: it ends on a plane that it runs along", number=self.edge.number)
        contacts = [sides[i].boundary('v_start') for sides in self.sides]
        for span in self.outline(face).spans:
            if span.edge == self.edge.number:
                pieces += _in_order([_clamped(curve) for curve in contacts])
            elif {span.start, span.end} & {corner for of, corner in self.at if of == face}:
                pieces.append(self._line(face, span))
            else:
                pieces += span.curves
        self._fill(face, pieces, phrase("edge {number}", number=self.edge.number))

    def _fill(self, face, pieces, where):
        made = filled(pieces, self.outline(face).normal, self.body.size)
        if not made:
            raise Refusal("{where}: the rest of the plane there cannot be filled: the radius is too large for it", where=where)
        self.left[face] = made

    def _cells(self):
        cells = []
        for number, cell in enumerate(self.body.cells):
            face = self.body.face_of[number]
            if face in self.left:
                cells += self.left[face] if number == self.body.faces[face].cells[0] else []
            else:
                cells.append(self.new.get(number, cell))
        return cells


def _facing(part):
    """The fillet with its normals to where those of the first patch point."""
    fillet = part.fillet
    middle = 0.5 * sum(fillet.domain[0])
    points, normals = fillet.evaluate_grid_with_normals([middle], fillet.domain[1][:1])
    (u, v), = part.first.nearest(points.reshape(1, 3)).parameters
    _, others = part.first.evaluate_grid_with_normals([u], [v])
    return fillet if np.vdot(normals, others) > 0.0 else fillet.reversed('u')


def _clamped(curve):
    return curve.split(curve.domain[0])[0] if curve.periodic else curve


def _in_order(curves):
    """Each from where the one before it ends; they are that, or the other way round."""
    first, second, last = curves[0], curves[min(1, len(curves) - 1)], curves[-1]
    gaps = [np.linalg.norm(first.points[-1] - other.points[0]) for other in (second, last)]
    return curves if gaps[0] <= gaps[1] else curves[::-1]


def _points(piece):
    return piece[:, :3] if isinstance(piece, np.ndarray) else np.asarray(piece.points)


def _ends(piece):
    return _points(piece)[[0, -1]]
