"""Numbers at the ends of what a double holds: a finite result or a refusal that says why, never NaN."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc

REFUSALS = (sc.InvalidShape, sc.PointAtInfinity, sc.ToleranceNotReached)
number = st.sampled_from([0.0, -0.0, 1.0, -1.0, 0.1, 5e-324, -2.2e-308, 1e-160, 1e160, -1.7e308, 1.7e308, 1 + 2.0**-52]) | st.floats(-1e3, 1e3)
row = st.tuples(number, number, number)
rows = st.lists(row, min_size=2, max_size=7)
build = sc.build


def numbers_of(result):
    """Every number of a curve, an array, or of a list of them."""
    if isinstance(result, sc.Approximation):
        return [np.array([result.error]), *numbers_of(result.value)]
    if isinstance(result, (list, tuple)):
        return [array for item in result for array in numbers_of(item)]
    names = ("points", "weights", "tangents", "parameters", "knots", "homogeneous_coefficients")
    arrays = [getattr(result, name) for name in names if hasattr(result, name)]
    return arrays or [np.asarray(result, float)]


def assert_finite_or_refused(call):
    try:
        result = call()
    except REFUSALS as reason:
        assert str(reason)
        return
    assert all(np.isfinite(array).all() for array in numbers_of(result))


CALLS = {
    "power": lambda p, a, b, c: sc.PowerCurve(p, a, (b, c)),
    "with_origin": lambda p, a, b, c: sc.PowerCurve(p).with_origin(a),
    "derivative": lambda p, a, b, c: sc.PowerCurve(p, a).derivative(),
    "rational derivative": lambda p, a, b, c: sc.PowerCurve.from_homogeneous([(*x, a) for x in p]).derivative(),
    "reversed": lambda p, a, b, c: sc.PowerCurve(p, a, (b, c)).reversed(),
    "to_power": lambda p, a, b, c: sc.BezierCurve(p).to_power(a),
    "elevate": lambda p, a, b, c: sc.BezierCurve(p).elevate(3),
    "reduce": lambda p, a, b, c: sc.BezierCurve(p).reduce(),
    "flatten": lambda p, a, b, c: sc.BezierCurve(p).flatten(max(abs(a), np.abs(p).max() * 1e-3)),
    "catmull_rom": lambda p, a, b, c: build.catmull_rom(p, tension=a),
    "chordal": lambda p, a, b, c: build.catmull_rom(p, "chordal", closed=len(p) > 2),
    "explicit": lambda p, a, b, c: build.catmull_rom(p[:3] + [p[0]] * (3 - len(p)), sorted([a, b, c]), ends="natural"),
    "kochanek_bartels": lambda p, a, b, c: build.kochanek_bartels(p, a, b, c, "centripetal"),
    "polynomial": lambda p, a, b, c: build.polynomial_through(p),
    "polynomial at": lambda p, a, b, c: build.polynomial_through(p[:2] + p[:1], [a, b, c]),
    "lagrange": lambda p, a, b, c: build.lagrange_evaluate(p, np.linspace(0, 1, 7)),
    "osculating": lambda p, a, b, c: build.osculating_polynomial([p, p[:1]], [a, b]),
    "chain": lambda p, a, b, c: build.polygon_of_chain(build.chain_from_polygon(p + p)),
    "chain at": lambda p, a, b, c: build.chain_from_polygon(p[:2] + p[:2] + p[:1], [a, b, c]),
    "pair": lambda p, a, b, c: build.c2_pair(p[0], p[1], p[0], p[-1], p[1], abs(a), abs(b)),
    "join": lambda p, a, b, c: build.join_beziers([sc.BezierCurve(p), sc.BezierCurve(p[::-1])], [a, b, c]),
    "join weights": lambda p, a, b, c: build.join_beziers([sc.BezierCurve(p[:2], [1, a]), sc.BezierCurve(p[1::-1], [b, c])]),
    "functions": lambda p, a, b, c: sc.basis.KnotVector(2, sorted([a, b, c, 0.5, 1, 2])).function_derivatives(1, a, 0),
    "triangle": lambda p, a, b, c: [list(r) for r in sc.basis.KnotVector(2, sorted([a, b, c, 0.5, 1, 2])).triangle(a)],
}


@pytest.mark.parametrize("name", CALLS)
@given(rows, number, number, number)
def test_every_result_is_finite_or_refused(name, points, a, b, c):
    assert_finite_or_refused(lambda: CALLS[name](points, a, b, c))


@pytest.mark.parametrize("size", [1e-60, 1e60, 1e155, 1e200, 1e290])
def test_normals_of_a_patch_of_any_size(size):
    rng = np.random.default_rng(8)
    points, weights = rng.random((4, 5, 3)), rng.uniform(0.5, 2, (4, 5))
    u = np.linspace(0, 1, 7)
    expected = sc.BezierPatch(points, weights).evaluate_grid_with_normals(u, u)[1]
    found = sc.BezierPatch(points * size, weights).evaluate_grid_with_normals(u, u)[1]
    assert np.allclose(np.linalg.norm(found, axis=-1), 1, rtol=1e-14) and np.allclose(found, expected, rtol=0, atol=1e-12)
