"""What Blender makes of a NURBS spline: its knots, where it is valid, where it samples.

Blender calls degree + 1 the order.
"""

import itertools
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np


class Flags(NamedTuple):
    """Blender's use_cyclic, use_endpoint and use_bezier of one direction."""

    cyclic: bool = False
    endpoint: bool = False
    bezier: bool = False

    def __str__(self):
        return "+".join(name for name, on in zip(self._fields, self) if on) or "plain"


ALL_FLAGS = tuple(Flags(*flags) for flags in itertools.product((False, True), repeat=3))


class Sampling(NamedTuple):
    """How a version of Blender samples NURBS curves."""

    by_span: bool                   # so many steps in every span, not so many for each point
    polygon_at_1: bool              # a cyclic curve of resolution 1 is its control polygon


class Direction(NamedTuple):
    """A curve, or u or v of a surface: how many points of which degree with which flags."""

    count: int
    degree: int
    flags: Flags = Flags()


@dataclass(frozen=True)
class NativeSpline:
    """The numbers of one of Blender's splines, in float64."""

    kind: str                       # 'BEZIER', 'NURBS' or 'POLY'
    points: np.ndarray              # (n, 4): x, y, z, weight; surfaces (nu, nv, 4);
                                    # 'BEZIER' (n, 3, 3): left handle, point, right handle
    directions: tuple               # of Direction: one of a curve, two of a surface


def is_valid_curve(direction):
    """Whether Blender evaluates such a curve; if not it shows the control polygon."""
    needs_more = direction.flags.bezier and not direction.flags.endpoint
    return is_valid_surface(direction) and not (needs_more and direction.count <= direction.degree + 1)


def is_valid_surface(direction):
    """Whether Blender evaluates a surface with such a direction; if not it makes an empty mesh."""
    count, degree, flags = direction
    if count <= degree:
        return False
    if not flags.bezier:
        return True
    if flags.cyclic:
        return count % degree == 0
    return flags.endpoint or count > degree + 1


def _growing_knots(degree, flags):
    """Blender's knots from the start on, without an end."""
    start = 0.0
    if flags.cyclic and flags.endpoint:
        yield start
        start = 1.0
    if flags.endpoint:
        multiplicity = degree if flags.cyclic else degree + 1
    else:
        multiplicity = min(2, degree) if flags.bezier else 1
    yield from itertools.repeat(start, multiplicity)
    for value in itertools.count(start + 1.0):
        yield from itertools.repeat(value, degree if flags.bezier else 1)


def all_knots(direction):
    """count + degree + 1 knots; degree more, for the points that come round again, if cyclic."""
    count, degree, flags = direction
    own = count if flags.cyclic or flags.endpoint else count + degree + 1
    knots = list(itertools.islice(_growing_knots(degree, flags), own + 1))
    following = knots.pop()
    if flags.cyclic:
        for i in range(2 * degree + 1):         # may read what it has appended
            knots.append(following + knots[i] - knots[0])
    elif flags.endpoint:
        knots += [following] * (degree + 1)
    return np.array(knots)


def domain(direction):
    """(start, end) of Blender's parameter."""
    knots = all_knots(direction)
    last = direction.count + direction.degree if direction.flags.cyclic else direction.count
    return knots[direction.degree], knots[last]


def used_count(direction):
    """How many points the shape depends on: clamped Bezier pieces leave an incomplete one out."""
    count, degree, flags = direction
    if flags.endpoint and flags.bezier and not flags.cyclic:
        return count - (count - 1) % degree
    return count


def plain_knots(direction):
    """The knots of the plain spline on wrapped() points."""
    used = direction._replace(count=used_count(direction))
    return all_knots(used)


def wrapped(points, direction, axis=0):
    """The points of the plain spline along an axis: the first ones again if cyclic."""
    count = used_count(direction) + (direction.degree if direction.flags.cyclic else 0)
    return np.take(points, range(count), axis=axis, mode="wrap")


def periodic_knots(direction):
    """One period of a cyclic direction, for its own points, unrepeated."""
    return all_knots(direction)[direction.degree:direction.count + direction.degree + 1]


def curve_samples(spline, resolution, sampling):
    """Where a Blender of that Sampling samples a NURBS curve or a polygon, in its parameter: those of
    a polygon are the numbers of its points, also where Blender takes an invalid curve for one."""
    direction, = spline.directions
    if spline.kind == 'NURBS' and is_valid_curve(direction):
        return curve_parameters(direction, resolution, sampling)
    return np.arange(float(direction.count))


def bezier_samples(straight, is_cyclic, resolution):
    """The same for a Bezier spline: `resolution` steps to a segment, one where it is straight because
    both its handles are vectors. `straight` says of every segment whether it is."""
    steps = [np.arange(1) if is_straight else np.arange(resolution) / resolution for is_straight in straight]
    inner = np.concatenate([i + at for i, at in enumerate(steps)])
    return inner if is_cyclic else np.append(inner, len(straight))


def curve_parameters(direction, resolution, sampling):
    """Where a Blender of that Sampling samples a curve, if it does not show the polygon."""
    if sampling.by_span:
        return _parameters_by_span(direction, resolution)
    cyclic = direction.flags.cyclic
    return _spread(direction, resolution * (direction.count if cyclic else direction.count - 1))


def surface_parameters(direction, resolution):
    """Where every version samples a surface in one direction."""
    return _spread(direction, resolution * direction.count)


def _spread(direction, count):
    start, end = domain(direction)
    return np.linspace(start, end, count, endpoint=not direction.flags.cyclic)


def _parameters_by_span(direction, resolution):
    start, end = domain(direction)
    joints = np.unique(all_knots(direction))
    joints = joints[(joints >= start) & (joints <= end)]
    steps = np.arange(resolution) / resolution
    parameters = (joints[:-1, None] + np.diff(joints)[:, None] * steps).ravel()
    return parameters if direction.flags.cyclic else np.append(parameters, end)


def span_count(direction):
    """Non-empty spans of the domain."""
    start, end = domain(direction)
    joints = np.unique(all_knots(direction))
    return np.count_nonzero((joints >= start) & (joints <= end)) - 1


def gives_polygon(direction, resolution, sampling):
    """Whether a Blender of that Sampling shows the control polygon of a valid curve."""
    return sampling.polygon_at_1 and resolution == 1 and direction.flags.cyclic
