"""Straight edges of planes, and the corners in which they meet, rounded exactly: by cylinders, spheres and the rest of the
planes."""

import math
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from . import ball_corner
from .outlines import filled, outline_of, segment

#: Faces that fold back by less, in radians, have no room for a ball.
_LEAST_ANGLE = 1e-4
#: Angles, and places as a part of the size, that differ by less are one.
_SAME = 1e-9


class Ridge(NamedTuple):
    """A straight edge of two plane faces."""

    number: int
    faces: tuple                        # (first, second)
    ends: tuple                         # corners, in the direction in which the first face has it
    way: np.ndarray                     # (3,) unit
    inward: tuple                       # (3,) unit: into each face
    half: float                         # of the angle between them

    def into(self, face):
        return self.inward[self.faces.index(face)]

    def other(self, face):
        return self.faces[1 - self.faces.index(face)]


def rounded(body, edges, radius):
    """The patches of a Body, but for its faces that change, and what there is in place of these and of edges, all of planes.
    Raises Refusal."""
    return _Rounding(body, edges, radius).patches()


class _Rounding:
    def __init__(self, body, edges, radius):
        self.body, self.radius = body, radius
        self._edge_of = {body.side(side.cell, side.name): edge.number for edge in edges for pair in edge.pairs for side in pair}
        self._outlines = {}
        self.ridges = [self._ridge(edge) for edge in edges]
        self.at = {}                    # (face, corner) -> (3,): where a corner of a face goes
        self.arcs = {}                  # (number of a ridge, corner) -> (n, 4), from its first face to its second one
        self.arcs_of = {}               # (face, corner) -> the ridge that ends there, and whose arc the face has
        self.balls = []                 # (corner, net, faces)
        ends = {}
        for ridge in self.ridges:
            for corner in ridge.ends:
                ends.setdefault(corner, []).append(ridge)
        for corner, meeting in ends.items():
            self._end(corner, meeting)
        self._raise()

    def outline(self, face, named):
        if face not in self._outlines:
            self._outlines[face] = outline_of(self.body, face, self._edge_of, named)
        return self._outlines[face]

    def _ridge(self, edge):
        named, faces = phrase("edge {number}", number=edge.number), tuple(self.body.face_of[side.cell] for side in edge.pairs[0])
        spans = []
        for face in faces:
            outline = self.outline(face, named)
            spans.append(next(span for span in outline.spans if span.edge == edge.number))
        a, b = spans
        start, end = self.body.corners[a.start], self.body.corners[a.end]
        way = (end - start) / np.linalg.norm(end - start)
        inward = [np.cross(self._outlines[face].normal, way if span.start == a.start else -way) for face, span in zip(faces, spans)]
        half = 0.5 * math.atan2(np.linalg.norm(np.cross(*inward)), np.dot(*inward))
        if not half > 0.5 * _LEAST_ANGLE:
            raise Refusal("{named}: its surfaces fold back on each other, there is no room for a ball", named=named)
        return Ridge(edge.number, faces, (a.start, a.end), way, tuple(inward), half)

    def _end(self, corner, meeting):
        """Find out where the faces of a corner go in which chosen edges end. Raises Refusal."""
        faces = self.body.faces_at(corner)
        if any(self.body.faces[face].plane is None for face in faces):
            raise Refusal("{named}: a surface there is no plane, and would have to be trimmed", named=self._named(corner))
        for face in faces:
            self.outline(face, self._named(corner))
        if len(meeting) == 1 and len(faces) <= 3:
            self._one(corner, meeting[0], faces)
        elif len(meeting) == 3 and len(faces) == 3 and {frozenset(ridge.faces) for ridge in meeting} == _pairs(faces):
            self._ball(corner, meeting, sorted(faces))
        elif len(meeting) == 2 and len(faces) == 3 and len(set(meeting[0].faces) & set(meeting[1].faces)) == 1:
            self._miter(corner, *meeting, faces)
        else:
            raise Refusal("{named}: {first} and {second} meet there; one edge of two or three surfaces can end, and two or "
                          "all three edges of three surfaces can be rounded: choose other edges there",
                          named=self._named(corner), first=phrase("{count} rounded edges", one="{count} rounded edge", count=len(meeting)),
                          second=phrase("{count} surfaces", one="{count} surface", count=len(faces)))

    def _one(self, corner, ridge, faces):
        for face in ridge.faces:
            self.at[face, corner] = self._slid(corner, ridge, face)
        for face in faces - set(ridge.faces):
            ending, starting = (self._outlines[face].spans[i] for i in self._outlines[face].at(corner))
            if {ending.across, starting.across} != set(ridge.faces):
                raise Refusal("{named}: the surface at its end does not meet both surfaces of the edge there",
                              named=self._named(corner))
            self.arcs_of[face, corner] = ridge
        first, second = (self.at[face, corner] for face in ridge.faces)
        self.arcs[ridge.number, corner] = _arc(first, self.body.corners[corner], second, ridge.half)

    def _slid(self, corner, ridge, face):
        """Where the side of a face beside a rounded edge begins."""
        outline = self._outlines[face]
        spans = [outline.spans[i] for i in outline.at(corner)]
        beside = next(span for span in spans if span.edge != ridge.number)
        if not beside.is_line:
            raise Refusal("{named}: a side that is no straight line ends there, and would have to be trimmed",
                          named=self._named(corner))
        place = self.body.corners[corner]
        way = self.body.corners[beside.start if beside.end == corner else beside.end] - place
        into = way @ ridge.into(face)
        if not into > _LEAST_ANGLE * np.linalg.norm(way):
            raise Refusal("{named}: a side is tangent to the edge there", named=self._named(corner))
        return place + way * (self.radius / math.tan(ridge.half) / into)

    def _miter(self, corner, first, second, faces):
        """Two edges at one angle to the face that they share: their cylinders meet in an arc from there to the third edge."""
        place, (shared,) = self.body.corners[corner], set(first.faces) & set(second.faces)
        order = [shared, first.other(shared), second.other(shared)]
        away, normals, sides = self._ball_at(corner, (first, second), order)
        ends = [self._slid(corner, ridge, ridge.other(shared)) for ridge in (first, second)]
        is_one = abs(first.half - second.half) <= _SAME and np.linalg.norm(ends[0] - ends[1]) <= _SAME * self.body.size
        if not is_one:
            numbers = _listed(sorted((first.number, second.number)))
            raise Refusal("{named}: {numbers} meet the surface between them at different angles, and the rest of the third edge "
                          "would have to be trimmed: round all three edges there, or one",
                          named=self._named(corner), numbers=numbers)
        self.at[shared, corner] = place + away - sides[0] * self.radius * normals[0]
        for ridge in (first, second):
            self.at[ridge.other(shared), corner] = ends[0]
            a, b = (self.at[face, corner] for face in ridge.faces)
            self.arcs[ridge.number, corner] = _arc(a, place, b, first.half)

    def _ball_at(self, corner, ridges, faces):
        """(from the corner to the middle of the ball, normals of faces, on which side of each the ball lies)."""
        normals, sides = [], []
        for face in faces:
            normal = self._outlines[face].normal
            found = {np.sign(normal @ ridge.into(ridge.other(face))) for ridge in ridges if face in ridge.faces}
            if len(found) != 1:
                raise Refusal("{named}: inner and outer edges meet there, on which one ball cannot lie: round them one after the "
                              "other, or let them end apart",
                              named=self._named(corner))
            normals.append(normal)
            sides.append(found.pop())
        if abs(np.linalg.det(normals)) < _LEAST_ANGLE:
            raise Refusal("{named}: its surfaces are too near to one plane, or to one direction, for a ball: round fewer edges there",
                          named=self._named(corner))
        return np.linalg.solve(np.array(normals), self.radius * np.array(sides)), normals, sides

    def _ball(self, corner, ridges, faces):
        place = self.body.corners[corner]
        away, normals, sides = self._ball_at(corner, ridges, faces)
        for face, normal, side in zip(faces, normals, sides):
            self.at[face, corner] = place + (away - side * self.radius * normal)
        for ridge in ridges:
            first, second = (self.at[face, corner] for face in ridge.faces)
            self.arcs[ridge.number, corner] = _arc(first, place + ridge.way * (away @ ridge.way), second, ridge.half)
        outline = self._outlines[faces[0]]
        second = outline.spans[outline.at(corner)[1]].across
        third = outline.spans[outline.at(corner)[0]].across
        around = (faces[0], second, third)
        net = ball_corner.net_of(away, self.radius, *(self.at[face, corner] - place for face in around))
        net[..., :3] += net[..., 3:] * place
        self.balls.append((corner, net, around))

    def _raise(self):
        """Arcs and balls to the least degree at which no weight is too small."""
        degree = 2
        for corner, net, _ in self.balls:
            least = ball_corner.degree_for(net)
            if least is None:
                raise Refusal("{named}: it is too sharp for the corner of a ball", named=self._named(corner))
            degree = max(degree, least)
        self.arcs = {key: _in_space(ball_corner.raised(arc, degree)) for key, arc in self.arcs.items()}
        self.balls = [(corner, ball_corner.raised(net, degree), around) for corner, net, around in self.balls]

    def patches(self):
        faces = sorted({face for face, _ in (*self.at, *self.arcs_of)})
        left = {face: self._left(face, faces) for face in faces}
        found = []
        for number, face in enumerate(self.body.faces):
            found += left[number] if number in left else [self.body.cells[cell] for cell in face.cells]
        return [*found, *map(self._fillet, self.ridges), *(self._corner(*ball) for ball in self.balls)]

    def _left(self, face, changing):
        """Patches for the rest of a face."""
        outline, pieces = self._outlines[face], []
        for span in outline.spans:
            pieces += self._pieces(face, span, changing)
            if (face, span.end) in self.arcs_of:
                pieces.append(self._arc_in(face, span))
        made = filled(pieces, outline.normal, self.body.size)
        if not made:
            near = sorted({ridge.number for ridge in self.ridges if face in ridge.faces or any(
                (face, end) in self.arcs_of and self.arcs_of[face, end] is ridge for end in ridge.ends)})
            raise Refusal("the rest of a plane beside {near} cannot be filled: the radius is too large for it", near=_listed(near))
        return made

    def _pieces(self, face, span, changing):
        start, end = (self._place(face, span, corner) for corner in (span.start, span.end))
        is_moved = any((face, corner) in self.at or (face, corner) in self.arcs_of for corner in (span.start, span.end))
        if not is_moved and not (span.is_line and (span.across is None or span.across in changing)):
            return list(span.curves)
        along = self.body.corners[span.end] - self.body.corners[span.start]
        if not (end - start) @ along > 1e-9 * (along @ along):
            raise Refusal("the radius is too large for the surfaces beside {edges_about}: nothing is left of a side",
                          edges_about=self._edges_about(span))
        return [segment(start, end)]

    def _place(self, face, span, corner):
        """Where a span of a face has its end."""
        if (face, corner) in self.arcs_of:
            return self.at[span.across, corner]
        return self.at.get((face, corner), self.body.corners[corner])

    def _arc_in(self, face, span):
        ridge = self.arcs_of[face, span.end]
        arc = self.arcs[ridge.number, span.end]
        return arc if ridge.faces[0] == span.across else arc[::-1]

    def _fillet(self, ridge):
        """v from the first face to the second one; u against the first one, so that normals continue."""
        arcs = np.stack([self.arcs[ridge.number, corner] for corner in ridge.ends[::-1]])
        degree = arcs.shape[1] - 1
        knots = [0.0, 0.0, 1.0, 1.0], np.repeat([0.0, 1.0], degree + 1)
        return sc.NurbsPatch((1, degree), knots, arcs[..., :3], arcs[..., 3])

    def _corner(self, corner, net, around):
        return ball_corner.patch_of(net, *(self._between(corner, around[i], around[j]) for i, j in ((0, 1), (1, 2), (0, 2))))

    def _between(self, corner, first, second):
        ridge = next(ridge for ridge in self.ridges if set(ridge.faces) == {first, second} and corner in ridge.ends)
        arc = self.arcs[ridge.number, corner]
        return arc if ridge.faces[0] == first else arc[::-1]

    def _named(self, corner):
        return named(self.body, corner)

    def _edges_about(self, span):
        numbers = {ridge.number for ridge in self.ridges if {span.start, span.end} & set(ridge.ends)}
        return _listed(sorted(numbers))


def named(body, corner):
    """A corner in words."""
    numbers = [edge.number for edge in body.edges if edge.number and corner in (edge.pairs[0][0].start, edge.pairs[-1][0].end)]
    if not numbers:
        return "a corner"
    return phrase("the corner of {numbers}",
                  numbers=_listed(numbers)) if len(numbers) > 1 else phrase("the end of {numbers}", numbers=_listed(numbers))


def _listed(numbers):
    if len(numbers) == 1:
        return phrase("edge {numbers}", numbers=numbers[0])
    return phrase("edges {numbers} and {last}", numbers=', '.join(map(str, numbers[:-1])), last=numbers[-1])


def _pairs(faces):
    return {frozenset((a, b)) for a in faces for b in faces if a != b}


def _arc(first, tip, second, half):
    """(3, 4): homogeneous points of the conic that leaves the edge's planes in two points, whose lines meet in a tip."""
    weight = math.sin(half)
    return np.array([[*first, 1.0], [*(weight * tip), weight], [*second, 1.0]])


def _in_space(arc):
    return np.c_[arc[:, :3] / arc[:, 3:], arc[:, 3]]
