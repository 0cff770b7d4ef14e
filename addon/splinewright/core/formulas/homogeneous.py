"""A rational curve of a plane as the polynomial curve of space that it is the image of (S9): (X, Y, W), seen from 0 on the plane W = 1.

W is drawn along z: the plane W = 1 is the plane of the curve, or 0 lies in it.
"""

import math
from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from ..shape import definition as definitions
from . import axes, signs
from .functions import AXIS, TICK, Part, line

CURVE, IMAGE, POLYGON, IMAGE_POLYGON = "homogeneous curve", "image", "homogeneous polygon", "polygon"
RAY, CONE, ORIGIN = "ray", "cone", f"{signs.MARK} O"
#: A curve that leaves its plane by no more than this part of its size lies in it: Blender moves points in single precision.
_FLAT = 1e-6
#: Lines of the grid on the plane W = 1 along each axis, and how far it reaches beyond what lies there, as a part of that.
_LINES, _BEYOND = 9, 0.15
#: The highest degree of a factor of all coordinates.
MOST_DEGREE = 4
#: So many times as far as the farthest control point from 0 rays reach at most.
_REACH = 3.0


class Space(NamedTuple):
    """Where (X, Y, W) is drawn."""

    height: float                       # of W = 1 above W = 0
    base: float                         # the W that is at z = 0
    x: float = 0.0                      # where 0 lies, beside its height
    y: float = 0.0

    def at(self, rows):
        """(…, 3) of homogeneous points (…, 4) without their Z."""
        return np.stack([rows[..., 0] + self.x, rows[..., 1] + self.y, self.height * (rows[..., 3] - self.base)], axis=-1)

    def rows_at(self, places):
        """at() backwards."""
        x, y, z = np.moveaxis(places, -1, 0)
        return np.stack([x - self.x, y - self.y, np.zeros_like(x), z / self.height + self.base], axis=-1)

    def image(self, rows):
        """(…, 4): homogeneous points of space that are the images on W = 1."""
        x, y, _, w = np.moveaxis(rows, -1, 0)
        return np.stack([x + self.x * w, y + self.y * w, self.height * (1.0 - self.base) * w, w], axis=-1)


def space_of(height, is_on_curve):
    """A Space; is_on_curve: whether the plane W = 1 is that of the curve. Raises Refusal."""
    if height == 0.0:
        raise Refusal("the plane W = 1 has no distance from 0")
    return Space(height, 1.0 if is_on_curve else 0.0)


def multiplied(curve, start, end):
    """A curve, its homogeneous coordinates times the linear function that is `start` and `end` at its ends."""
    return curve if start == end == 1.0 else curve.multiplied(start, end)


def factor_of(formula, domain):
    """(m + 1,): the Bernstein coefficients over a domain of the polynomial that a Formula is; one alone where it is constant. Raises Refusal."""
    made, _ = sc.build.curve_from_formulas([formula, "0"], domain)
    found = made.points[:, 0]
    if made.degree > MOST_DEGREE:
        raise Refusal("a(t) is no polynomial of degree {most} or less", most=MOST_DEGREE)
    if not found.any():
        raise Refusal("a(t) is 0: nothing is left of the curve")
    return found[:1] if (found == found[0]).all() else found


def multiplied_by(curve, coefficients):
    """A NurbsCurve, its homogeneous coordinates times the polynomial with these Bernstein coefficients over its domain: of the degree of
    both together, not periodic unless the polynomial is constant. Where that is 0 the curve goes through 0."""
    if len(coefficients) == 1:
        rows = coefficients[0] * curve.homogeneous_points
        return curve if coefficients[0] == 1.0 else sc.NurbsCurve.from_homogeneous(curve.degree, curve.knots, rows, curve.periodic)
    plain, last = curve.unrolled() if curve.periodic else curve, len(coefficients) - 1
    power = _Rows(plain.degree, plain.knots, plain.homogeneous_points)
    found = power._replace(rows=coefficients[0] * power.rows)
    for i in range(1, last + 1):        # Horner's scheme: times 1 - s, and s^i beside it
        power, found = _times(power, 0.0, 1.0), _times(found, 1.0, 0.0)
        found = found._replace(rows=found.rows + coefficients[i] * math.comb(last, i) * power.rows)
    return sc.NurbsCurve.from_homogeneous(*found)


class _Rows(NamedTuple):
    """A spline of four coordinates, all of which may be 0."""

    degree: int
    knots: np.ndarray
    rows: np.ndarray                    # (n, 4)


def _times(spline, start, end):
    """_Rows times the linear function that is `start` and `end` at the ends of the domain. The library multiplies by positive ones: that is
    the difference of two of them."""
    parts = []
    for columns in (spline.rows[:, :3], np.pad(spline.rows[:, 3:], ((0, 0), (0, 2)))):
        plain = sc.NurbsCurve(spline.degree, spline.knots, columns)
        more, once = plain.multiplied(1.0 + start, 1.0 + end), plain.multiplied(1.0, 1.0)
        parts.append(more.homogeneous_points[:, :3] - once.homogeneous_points[:, :3])
    return _Rows(more.degree, more.knots, np.column_stack([parts[0], parts[1][:, 0]]))


def lifted(curve, space):
    """The homogeneous curve of a NurbsCurve in the plane z = 0. Raises Refusal for one that leaves that."""
    rows = curve.homogeneous_points
    finite = rows[rows[:, 3] != 0.0]
    places = finite[:, :3] / finite[:, 3:]
    size = np.ptp(places[:, :2], axis=0).max()
    away = max(np.abs(places[:, 2]).max(), np.abs(rows[rows[:, 3] == 0.0, 2]).max(initial=0.0))
    if away > _FLAT * max(size, np.abs(places[:, :2]).max()):
        raise Refusal("the curve leaves the plane z = 0 by {away}: that of a curve in space has four coordinates",
                      away=decimals.text_of(float(away), 3))
    return sc.NurbsCurve(curve.degree, curve.knots, space.at(rows), periodic=curve.periodic)


def picture(curve, space, marker, has_polygons, has_plane, rays, cone):
    """The Parts of the homogeneous view of a NurbsCurve. rays: whether there is one through each control point; cone: in how many equal
    steps of the parameter there are others. Raises Refusal."""
    upon, rows = lifted(curve, space), curve.homogeneous_points
    reach = _REACH * _farthest(rows, space)
    parts = [Part(CURVE, upon)]
    if space.base != 1.0:
        parts.append(Part(IMAGE, sc.NurbsCurve.from_homogeneous(curve.degree, curve.knots, space.image(rows), curve.periodic)))
    if has_polygons:
        parts += _polygons(rows, space, curve.periodic)
    if rays:
        parts += [ray for row in rows for ray in _ray(RAY, row, space, reach)]
    parts += [ray for row in _steps(upon, space, cone) for ray in _ray(CONE, row, space, reach)]
    if has_plane:
        parts += _plane(rows, space)
    return parts + _marks(rows, space, marker)


def _farthest(rows, space):
    """Of control points and their images from 0."""
    zero = space.at(np.zeros(4))
    image = space.image(rows[rows[:, 3] != 0.0])
    places = np.concatenate([space.at(rows), image[:, :3] / image[:, 3:]])
    return np.linalg.norm(places - zero, axis=1).max()


def _polygons(rows, space, is_closed):
    rows = np.concatenate([rows, rows[:1]]) if is_closed else rows
    return [Part(POLYGON, signs.polyline(space.at(rows))), *(Part(IMAGE_POLYGON, one) for one in signs.polygon(space.image(rows)))]


def _steps(upon, space, count):
    """(n, 4): homogeneous points of a curve in space at equal steps of the parameter, without those at infinity."""
    if count == 0:
        return np.empty((0, 4))
    start, end = upon.domain
    places = upon.evaluate(start + (end - start) * np.arange(count + 1) / count, at_infinity='nan')
    return space.rows_at(places[np.isfinite(places).all(axis=1)])


def _ray(name, row, space, reach):
    """From 0 through a point and its image, as far as the reach; in a list, which is empty where the point is 0."""
    zero = space.at(np.zeros(4))
    length, weight = float(np.linalg.norm(space.at(row) - zero)), float(row[3])
    if length == 0.0:
        return []
    multiples = [0.0, 1.0]
    if weight != 0.0:
        most = max(reach / length, 1.0)
        multiples.append(min(max(1.0 / weight, -most), most) if abs(weight) * most >= 1.0 else most if weight > 0.0 else -most)
    first, last = min(multiples), max(multiples)
    return [Part(name, line(tuple(space.at(first * row)), tuple(space.at(last * row))))]


def _plane(rows, space):
    """A grid on W = 1; the border of as much of W = 0, where a point is there; the axis of W with both marked."""
    image = space.image(rows[rows[:, 3] != 0.0])
    places = np.concatenate([image[:, :2] / image[:, 3:], np.zeros((1, 2))])
    low, high = places.min(axis=0), places.max(axis=0)
    more = _BEYOND * max((high - low).max(), 1e-9)
    low, high = low - more, high + more
    parts = _grid(low, high, space.at(np.array([0, 0, 0, 1.0]))[2], _LINES)
    if (rows[:, 3] == 0.0).any():
        directions = space.at(rows[rows[:, 3] == 0.0])[:, :2]
        parts += _grid(np.minimum(low, directions.min(axis=0)), np.maximum(high, directions.max(axis=0)), space.at(np.zeros(4))[2], 2)
    tick = more / 4.0
    top, bottom = max(1.0, rows[:, 3].max()), min(0.0, rows[:, 3].min())
    ends = [tuple(space.at(np.array([0, 0, 0, w]))) for w in (bottom, top)]
    parts.append(Part(AXIS, line(*ends)))
    for w in (0.0, 1.0):
        x, y, z = space.at(np.array([0, 0, 0, w]))
        parts.append(Part(f"{TICK} W = {w:g}", line((x - tick, y, z), (x, y, z))))
    return parts


def _grid(low, high, z, count):
    found = []
    for axis in (0, 1):
        for share in np.arange(count) / (count - 1):
            start, end = np.array([*low, z]), np.array([*high, z])
            start[axis] = end[axis] = low[axis] + share * (high[axis] - low[axis])
            found.append(Part(axes.GRID, line(tuple(start), tuple(end))))
    return found


def _marks(rows, space, radius):
    shown = signs.cross("O", space.at(np.zeros(4)), radius)
    for i, row in enumerate(rows):
        shown += signs.cross(f"P_{{{i}}}  W = {row[3]:.4g}", space.at(row), radius)
        shown += signs.cross(f"p_{{{i}}}", signs.place(space.image(row)), radius)
    return shown


def image(curve, eye, plane):
    """The curve on the plane z = `plane` that a NurbsCurve stands for, as seen from the eye: weights are as far from the eye's height as the
    points, in parts of the distance of the plane. Raises Refusal."""
    x, y, z = eye
    if z == plane:
        raise Refusal("the eye lies in the plane of the image, z = {plane:g}", plane=plane)
    z -= plane
    down, up = np.eye(4), np.eye(4)
    down[2, 3], up[2, 3] = -plane, plane
    seen = np.array([[1, 0, -x / z, 0], [0, 1, -y / z, 0], [0, 0, 0, 0], [0, 0, -1 / z, 1]])
    found = curve.transformed(up @ seen @ down)
    return curve.transformed(up @ -seen @ down) if found.weights.max() <= 0.0 else found


def seen(curve, eye, plane, rays, cone):
    """The Parts of image(), and of rays as picture() has them: through the eye, the points of the curve in space and their images."""
    x, y, z = eye
    parts = [Part(IMAGE, image(curve, eye, plane))]
    space = Space(plane - z, -z / (plane - z), x, y)
    rows = _directions(curve, space)
    if not len(rows):
        return parts
    reach = _REACH * _farthest(rows, space)
    chosen = [(RAY, rows if rays else []), (CONE, _steps(curve, space, cone))]
    return parts + [ray for name, those in chosen for row in those for ray in _ray(name, row, space, reach)]


def _directions(curve, space):
    """(n, 4): the homogeneous points of a Space at the control points of a curve in space: those at infinity are left out."""
    return space.rows_at(curve.points[curve.weights != 0.0])


#: What stays right when the homogeneous curve is edited by itself.
_FIXED = (CURVE, ORIGIN, AXIS, axes.GRID)


def applied(definition):
    """What of a picture() does not depend on its curve, and the curve: rays and marks would not follow it."""
    names = [piece.name for piece in definition.pieces]
    stays = [name in _FIXED or name.startswith(f"{TICK} ") for name in names]
    curves = [curve for curve, this in zip(definitions.to_value(definition), stays) if this]
    return definitions.named(definitions.from_value(curves), [name for name, this in zip(names, stays) if this])


def view_of(definition):
    """{name: number}: the eye and the plane that give back the curve of a picture(), as far as it shows them."""
    found = {}
    for piece in definition.pieces:
        places = definition.pool[piece.indices, :3]
        if piece.name == ORIGIN:
            found.update(zip(("x", "y", "z"), map(float, (places.min(axis=0) + places.max(axis=0)) / 2.0)))
        elif piece.name == axes.GRID and 'plane' not in found:
            found['plane'] = float(places[0, 2])
    return found
