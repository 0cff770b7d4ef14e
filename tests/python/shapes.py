"""Shapes with a closed form, and strategies for any others."""

import math

import numpy as np
from hypothesis import strategies as st

import splinecore as sc

HALF = math.sqrt(0.5)

SQUARE = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
SQUARE_WEIGHTS = [1, HALF, 1, HALF, 1, HALF, 1, HALF, 1]
CIRCLE_KNOTS = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]


def circle():
    """The unit circle: four rational quarters."""
    return sc.NurbsCurve(2, CIRCLE_KNOTS, SQUARE, SQUARE_WEIGHTS)


def semicircle():
    """The upper unit semicircle, whose middle control point is a direction."""
    return sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1])


def hyperbola():
    """Passes through infinity in the middle of its domain and at none of its ends."""
    return sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, -1.5, 1])


def cubic():
    """A plain cubic with a double knot and no clamped ends."""
    knots = [-2.0, -1.0, -0.5, 0.0, 1.0, 1.0, 2.5, 3.0, 3.5, 4.0, 5.0]
    return sc.NurbsCurve(3, knots, random_points(7, seed=3), weights=np.linspace(0.5, 2, 7))


def closed_cubic():
    return sc.NurbsCurve(3, [0, 1, 2.5, 3, 4, 6], random_points(5, seed=5), periodic=True)


def hermite_chain():
    rows = random_points(8, seed=7)
    return sc.HermiteCurve(rows[:4], rows[4:], parameters=[0, 1, 3, 3.5])


def parabola():
    """A rational quadratic by its coefficients, about an origin outside its domain."""
    return sc.PowerCurve.from_homogeneous([(1, 0, 2, 2), (0.5, 1, 0, 0.25), (0, 0.25, 1, 0.5)], -0.5, (0.25, 2))


def curves():
    """One of every kind."""
    return [circle(), semicircle(), cubic(), closed_cubic(), hermite_chain(), parabola()]


def random_points(*shape, seed):
    return np.random.default_rng(seed).uniform(-2, 2, (*shape, 3))


def revolved(profile, profile_weights, profile_knots, degree):
    """A surface around the z axis; profile points are (r, z)."""
    profile = np.asarray(profile, float)
    ring = np.asarray(SQUARE, float)
    points = np.empty((9, len(profile), 3))
    points[..., :2] = ring[:, None] * profile[None, :, :1]
    points[..., 2] = profile[:, 1]
    weights = np.outer(SQUARE_WEIGHTS, profile_weights)
    return sc.NurbsPatch((2, degree), (CIRCLE_KNOTS, profile_knots), points, weights)


def torus(ring=3.0, tube=1.0):
    profile = [(ring + tube * x, tube * z) for x, z in SQUARE]
    return revolved(profile, SQUARE_WEIGHTS, CIRCLE_KNOTS, 2)


def cylinder():
    return revolved([(1, 0), (1, 2)], [1, 1], [0, 0, 1, 1], 1)


def sphere_octant():
    """An eighth of the unit sphere; its edge v = 1 has shrunk to the north pole."""
    arc = np.array([(1, 0), (1, 1), (0, 1)], float)
    points = np.empty((3, 3, 3))
    points[..., :2] = arc[:, None] * arc[None, :, :1]
    points[..., 2] = arc[:, 1]
    weights = np.outer([1, HALF, 1], [1, HALF, 1])
    return sc.BezierPatch(points, weights)


def wavy_patch():
    """Of different degrees, plain in u and periodic in v."""
    return sc.NurbsPatch((3, 2), ([0, 0, 0, 0, 0.5, 2, 2, 2, 2], [0, 1, 2, 4, 5]),
                         random_points(5, 4, seed=11), np.linspace(1, 2, 20).reshape(5, 4), (False, True))


def hermite_net():
    nets = random_points(4, 3, 2, seed=13)
    return sc.HermitePatch(*nets, parameters=([0, 1, 3], [0, 2]))


def patches():
    """One of every kind."""
    return [torus(), cylinder(), sphere_octant(), wavy_patch(), hermite_net()]


def inside(domain, count=33):
    start, end = domain
    return np.linspace(start, end, count)


coordinates = st.floats(-1e3, 1e3, width=64)
positive = st.floats(0.05, 20)


def point_lists(least=2, most=9):
    return st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=least, max_size=most)


@st.composite
def knot_vectors(draw, count, degree):
    """Increasing in steps of which some are zero, with a domain and no gap."""
    steps = draw(st.lists(st.sampled_from([0.0, 0.25, 1.0, 3.0]), min_size=count + degree, max_size=count + degree))
    knots = [draw(st.floats(-10, 10))]
    for step in steps:
        too_many = knots.count(knots[-1]) >= degree
        knots.append(knots[-1] + (step or (1.0 if too_many else 0.0)))
    if knots[degree] == knots[count]:
        knots[count:] = [knot + 1.0 for knot in knots[count:]]
    return knots


@st.composite
def nurbs_curves(draw, rational=True):
    degree = draw(st.integers(1, 5))
    points = draw(point_lists(degree + 1, degree + 6))
    weights = draw(st.lists(positive, min_size=len(points), max_size=len(points))) if rational else None
    return sc.NurbsCurve(degree, draw(knot_vectors(len(points), degree)), points, weights)


def size_of(shape):
    """A length to which errors of the shape's points are compared."""
    return max(1.0, float(np.abs(shape.points).max()))
