"""Curves of every kind by a seed, and how far two of them lie apart before the division by the weight."""

from fractions import Fraction

import numpy as np

import splinecore as sc

ENDS = ("clamped", "unclamped", "periodic")


def random_knots(rng, degree, spans, ends):
    """Unequal spans, inner knots of every multiplicity up to degree, one in ten a gap."""
    def inner():
        return int(rng.integers(1, degree + 1)) if rng.random() < 0.4 else 1 + degree * (rng.random() < 0.04)

    steps = np.where(rng.random(spans) < 0.2, rng.uniform(0.01, 0.02, spans), rng.uniform(0.5, 1.5, spans))
    distinct = rng.uniform(-3, 3) + np.r_[0, np.cumsum(steps)]
    middle = np.repeat(distinct[1:-1], [inner() for _ in distinct[1:-1]])
    if ends == "periodic":
        first = int(rng.integers(1, degree + 1))
        last = int(rng.integers(1, degree + 2 - first)) if rng.random() < 0.3 else 1
        return np.r_[[distinct[0]] * first, middle, [distinct[-1]] * last]
    if ends == "clamped":
        return np.r_[[distinct[0]] * (degree + 1), middle, [distinct[-1]] * (degree + 1)]
    before = distinct[0] - np.cumsum(rng.choice([0, 0.3, 1], degree, p=[0.2, 0.2, 0.6]))
    after = distinct[-1] + np.cumsum(rng.choice([0, 0.3, 1], degree, p=[0.2, 0.2, 0.6]))
    return np.r_[before[::-1], distinct[0], middle, distinct[-1], after]


def random_weights(rng, count, positive):
    """Positive ones, or of any sign and zero; then a zero has neighbors that have a weight."""
    weights = 2 ** rng.uniform(-2, 2, count)
    if not positive:
        kinds = rng.random(count)
        weights[kinds < 0.3] = -rng.uniform(0.1, 2, (kinds < 0.3).sum())
        zero = kinds > 0.8
        zero[1:] &= ~zero[:-1]
        zero[0] = zero[-1] = False
        weights[zero] = 0
    return weights


def random_curve(rng, positive=True, degree=None, ends=None, spans=None):
    degree = degree or int(rng.integers(1, 10))
    ends = ends or ENDS[rng.integers(3)]
    knots = random_knots(rng, degree, spans or int(rng.choice([1, 2, 3, 8])), ends)
    count = len(knots) - 1 if ends == "periodic" else len(knots) - degree - 1
    points = rng.uniform(-10, 10, (count, 3))
    return sc.NurbsCurve(degree, knots, points, random_weights(rng, count, positive), periodic=ends == "periodic")


def random_curves(seed, count=1000, **kind):
    """Half of them with positive weights unless told."""
    rng = np.random.default_rng(seed)
    for index in range(count):
        yield random_curve(rng, **{"positive": index % 2 == 0, **kind})


def homogeneous(curve, u, side="right"):
    """The homogeneous points at parameters of the domain, (m, 4)."""
    nurbs = curve if isinstance(curve, sc.NurbsCurve) else curve.to_nurbs()
    return sc.basis.Samples(nurbs.knot_vector, u, side=side).apply(nurbs.homogeneous_points)


def parameters(curve, count=12):
    """Inside every span and at no knot, where a curve may jump."""
    start, end = curve.domain
    knots = np.unique(np.r_[start, curve.knots[(curve.knots > start) & (curve.knots < end)], end])
    t = (np.arange(count // 4 + 1) + 0.3) / (count // 4 + 1.6)
    return (knots[:-1, None] + np.diff(knots)[:, None] * t).ravel()


def error(before, after, at=lambda u: u):
    """Largest difference of homogeneous points, relative to the largest coordinate of a control point."""
    u = parameters(before)
    far = np.abs(homogeneous(before, u) - homogeneous(after, at(u))).max()
    return far / np.abs(before.homogeneous_points).max()


def homogeneous_at(curve, u):
    """The homogeneous points at fractions: what a double leaves of one is gone along the derivative."""
    near = np.array([float(value) for value in u])
    rest = np.array([float(value - Fraction(float(value))) for value in u])
    samples = sc.basis.Samples(curve.to_nurbs().knot_vector, near, 1)
    points = curve.homogeneous_points
    return samples.apply(points) + rest[:, None] * samples.apply(points, 1)


def shares(curve, u):
    """How far along the domain parameters lie, as fractions."""
    start, end = map(Fraction, curve.domain)
    return [(Fraction(value) - start) / (end - start) for value in u]


def along(domain, t):
    """The parameters that lie as far along a domain, as fractions."""
    start, end = map(Fraction, domain)
    return [start + (end - start) * value for value in t]


def sampled_distance(before, after, count=200):
    """The largest distance found at many parameters of every span of both, both sides of each knot among them."""
    start, end = before.domain
    knots = np.r_[before.knots, after.knots]
    knots = np.unique(np.r_[start, knots[(knots > start) & (knots < end)], end])
    u = (knots[:-1, None] + np.diff(knots)[:, None] * np.linspace(0, 1, count + 1)[1:-1]).ravel()

    def distance(at, side):
        gap = before.evaluate(at, side=side, at_infinity="nan") - after.evaluate(at, side=side, at_infinity="nan")
        return np.linalg.norm(gap, axis=-1)

    return max(np.nanmax(distance(at, side)) for at, side in ((u, "right"), (knots[1:], "left"), (knots[:-1], "right")))
