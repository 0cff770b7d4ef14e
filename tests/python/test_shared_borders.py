"""Patches that have a border in common, and cross or touch beside it: the border is found whole, and so are the curves that come
to it where the patches touch; the same however the patches are given, and at other tolerances."""

import numpy as np
import pytest

import splinecore as sc
from given_otherwise import sections_otherwise
from splinecore import build

SIDES = ("u_start", "u_end", "v_start", "v_end")


def size_of(*patches):
    points = np.concatenate([patch.points.reshape(-1, 3) for patch in patches])
    return np.linalg.norm(points.max(0) - points.min(0))


def knots(rng, degree):
    """Creased ones, too."""
    inner = np.linspace(0, 1, rng.integers(2, 5))[1:-1]
    if len(inner) and rng.integers(3) == 0:
        inner = np.sort(np.r_[inner, [inner[0]] * int(rng.integers(degree))])
    return np.r_[[0.0] * (degree + 1), inner, [1.0] * (degree + 1)]


def wave(rng, highest=5):
    degrees = [int(p) for p in rng.integers(1, highest + 1, 2)]
    both = [knots(rng, p) for p in degrees]
    x, y = np.meshgrid(*(np.linspace(-1, 1, len(k) - p - 1) for k, p in zip(both, degrees)), indexing="ij")
    points = np.stack([x, y, 10**rng.uniform(-1.5, 0) * rng.normal(size=x.shape)], -1)
    weights = 10**rng.uniform(-1, 1, x.shape) if rng.integers(2) else None
    return sc.NurbsPatch(degrees, both, points, weights)


def wild(rng):
    p, q = (int(k) for k in rng.integers(1, 6, 2))
    x, y = np.meshgrid(np.linspace(-1, 1, p + 1), np.linspace(-1, 1, q + 1), indexing="ij")
    points = np.stack([x, y, 0 * x], -1) + 0.7 * rng.normal(size=(p + 1, q + 1, 3))
    weights = 10**rng.uniform(-1, 1, x.shape) if rng.integers(2) else None
    return sc.BezierPatch(points, weights=weights).to_nurbs()


def ring(rng):
    radius = 10**rng.uniform(-0.5, 0.1)
    return build.torus((0, 0, 0), (0, 0, 1), radius, radius * rng.uniform(0.1, 0.8))


def ball(rng):
    return build.sphere((0, 0, 0), 10**rng.uniform(-0.7, 0.3))


def tube(rng):
    return build.cylinder((0, 0, -1.5), (0, 0, 1), 10**rng.uniform(-0.7, 0.2), 3)


def runs_along_start(image):
    return all(abs(image.evaluate(t)[1]) <= 1e-9 for t in np.linspace(*image.domain, 9))


def found(sections):
    return len(sections.curves), len(sections.points), sections.are_one


def lengths(curves):
    return sum(curve.length() for curve in curves)


@pytest.mark.parametrize("kind", [wave, wild, ring, ball, tube])
def test_a_wall_on_a_border(inputs, kind):
    """Walls that lean any way: along the border the patches touch where the wall has its tangent plane."""
    rng = np.random.default_rng([81, *kind.__name__.encode()])
    refused = 0
    count = inputs(200)
    for _ in range(count):
        patch = kind(rng)
        side = SIDES[rng.integers(4)] if kind in (wave, wild) else "u_start"
        border = patch.boundary(side)
        wall = build.extrude(border, rng.normal(size=3))
        tolerance = 1e-6 * size_of(patch, wall)
        try:
            one = patch.sections(wall, tolerance)
        except sc.InvalidShape as error:
            assert "nearly touch" in str(error) or "degrees so high" in str(error)
            refused += 1
            continue
        along = [curve for curve, image in zip(one.curves, one.on_b) if runs_along_start(image)]
        assert lengths(along) == pytest.approx(border.length(), rel=1e-4)
        for other, scale in sections_otherwise(rng, patch, wall, tolerance, 2.0, 6, 2):
            assert found(other) == found(one)
            assert lengths(other.curves) / scale == pytest.approx(lengths(one.curves), rel=1e-3, abs=100 * tolerance)
    assert refused <= 0.05 * count
