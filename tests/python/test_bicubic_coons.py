"""Bicubic Coons patches: sides and derivatives across are those given, twists, patches come back, bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from splinecore import build

BORDERS = ("v_start", "u_end", "v_end", "u_start")


def grid(patch, count=17):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def line(*points):
    return sc.BezierCurve(points)


def over_unit(curve):
    return curve.to_nurbs().with_domain((0, 1))


def vectors_across(patch, border):
    """The derivative into the patch across a border of a patch without weights, clamped, over [0, 1] across."""
    points = np.swapaxes(patch.points, 0, 1) if border.startswith("v") else patch.points
    along, across = (0, 1) if border.startswith("v") else (1, 0)
    knots, degree = patch.knots[across], patch.degree[across]
    rows, span = (points[:2], knots[degree + 1] - knots[1]) if border.endswith("start") else (points[-1:-3:-1], knots[-2] - knots[-degree - 2])
    return sc.NurbsCurve(patch.degree[along], patch.knots[along], degree / span * (rows[1] - rows[0]))


def around(patch):
    return [patch.boundary(border) for border in BORDERS], [vectors_across(patch, border) for border in BORDERS]


def clamped_knots(rng, degree):
    inner = np.repeat(np.arange(1, rng.integers(1, 4)), rng.integers(1, degree + 1))
    return np.r_[[0] * (degree + 1), inner, [inner.max(initial=0) + 1] * (degree + 1)].astype(float) / (inner.max(initial=0) + 1)


def cubic_across(rng, degree):
    """A patch of any degree and knots along u, one cubic along v."""
    knots = clamped_knots(rng, degree)
    return sc.NurbsPatch((degree, 3), (knots, [0] * 4 + [1] * 4), rng.uniform(-1, 1, (len(knots) - degree - 1, 4, 3)))


def test_a_patch_that_is_cubic_in_one_direction_comes_back():
    rng = np.random.default_rng(1)
    for degree in (*range(1, 10), 20):
        for _ in range(5):
            patch = cubic_across(rng, degree)
            sides, across = around(patch)
            made, error = build.coons(sides, across=across)
            assert error <= 1e-12 and made.degree == (max(degree, 3), 3)
            assert np.abs(grid(made) - grid(patch)).max() <= (1e-12 if degree < 10 else 1e-10)


def test_scales_and_far_from_the_origin():
    patch = cubic_across(np.random.default_rng(2), 4)
    sides, across = around(patch)
    for scale in (1e-150, 1e-9, 1e9, 1e150):
        by = scale * np.eye(3)
        made = build.coons([side.transformed(by) for side in sides], across=[one.transformed(by) for one in across]).value
        assert np.abs(grid(made) / scale - grid(patch)).max() <= 1e-12
    move = np.column_stack([np.eye(3), (1e9, -1e9, 1e9)])
    made = build.coons([side.transformed(move) for side in sides], across=across, tolerance=1e-5).value
    assert np.abs(grid(made) - (1e9, -1e9, 1e9) - grid(patch)).max() <= 1e-5


def test_sides_in_any_direction_take_their_vectors_with_them():
    patch = cubic_across(np.random.default_rng(3), 3)
    sides, across = around(patch)
    for turned in ((1,), (2,), (3,), (1, 2, 3), (1, 3)):
        pairs = [(a.reversed(), b.reversed()) if i in turned else (a, b) for i, (a, b) in enumerate(zip(sides, across))]
        made = build.coons([a for a, _ in pairs], across=[b for _, b in pairs]).value
        assert np.abs(grid(made) - grid(patch)).max() <= 1e-13


def test_without_vectors_a_surface_of_translation_comes_back():
    """Adini's twists are its own, 0."""
    rng = np.random.default_rng(4)
    for _ in range(20):
        along, over = rng.uniform(-1, 1, (4, 3)), rng.uniform(-1, 1, (4, 3))
        patch = sc.BezierPatch(along[:, None] + over[None])
        made, error = build.coons([patch.boundary(border) for border in BORDERS], across=[None] * 4)
        assert error == 0.0 and np.abs(made.points - patch.points).max() <= 1e-14


def test_without_vectors_twists_are_those_of_the_bilinear_patch():
    sides, _ = around(cubic_across(np.random.default_rng(5), 3))
    made, flat = (build.coons(sides, **way).value for way in ({"across": [None] * 4}, {}))
    for u in (0, 1):
        for v in (0, 1):
            a, b = (patch.derivatives([u], [v], 2, side="left" if u else "right")[0] for patch in (made, flat))
            assert np.abs(a[1, 1] - b[1, 1]).max() <= 1e-12


@pytest.mark.parametrize("weight", [10, 100, 1e4])
def test_sides_that_leave_corners_fast_let_nothing_swing_out(weight):
    sides = [sc.BezierCurve([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [1, weight, 1]), sc.BezierCurve([(2, 0, 0), (2, 2, 0)]),
             sc.BezierCurve([(2, 2, 0), (0, 2, 0)]), sc.BezierCurve([(0, 2, 0), (0, 0, 0)])]
    points = grid(build.coons(sides, across=[None] * 4).value)
    assert points.min() >= 0 and points[..., :2].max() <= 2


def corner_sides(rng, positive=True):
    """Four random rational curves round four corners, over [0, 1]."""
    corners = rng.uniform(-10, 10, (4, 3))
    sides = []
    for i in range(4):
        curve = random_curve(rng, ends="clamped", positive=positive, degree=int(rng.integers(1, 6)), spans=int(rng.integers(1, 4)))
        knots = curve.knots
        inner = [np.count_nonzero(knots == knot) for knot in np.unique(knots)[1:-1]]
        if max(inner, default=0) > curve.degree:
            return corner_sides(rng, positive)
        points = curve.points.copy()
        points[0], points[-1] = corners[i], corners[(i + 1) % 4]
        sides.append(over_unit(sc.NurbsCurve(curve.degree, knots, points, curve.weights)))
    return sides


def end_slopes(sides):
    """Derivatives of the sides at their ends, (4, 2, 3): as they go round."""
    return np.array([[side.derivatives([s], 1, side="left" if s else "right")[0, 1] for s in (0, 1)] for side in sides])


def fitting_vectors(rng, sides, twists):
    """For each side a random curve of vectors that fits at its ends: degree 6, with values and twists there."""
    slopes = end_slopes(sides)
    across = []
    for i in range(4):
        points = rng.uniform(-10, 10, (7, 3))
        points[0], points[-1] = -slopes[i - 1, 1], slopes[(i + 1) % 4, 0]
        points[1] = points[0] + twists[i] / 6
        points[-2] = points[-1] - -twists[(i + 1) % 4] / 6
        across.append(sc.BezierCurve(points))
    return across


def leaving(patch, border, s):
    """The derivative into the patch, at places of a border as it goes round."""
    ends = {"v_start": (s, 0 * s), "u_end": (0 * s + 1, s), "v_end": (1 - s, 0 * s + 1), "u_start": (0 * s, 1 - s)}
    found = patch.derivatives(*ends[border], 1, side="left")
    return {"v_start": 1, "u_end": -1, "v_end": -1, "u_start": 1}[border] * (found[:, 0, 1] if border[0] == "v" else found[:, 1, 0])


def test_sides_and_derivatives_are_those_given_also_of_rational_sides(inputs):
    """Twists go round too: u and v turn by a quarter from corner to corner."""
    rng = np.random.default_rng(6)
    places = (np.arange(20) + 0.37) / 20
    done, count = 0, inputs(1000)
    while done < count:
        sides = corner_sides(rng)
        across = fitting_vectors(rng, sides, rng.uniform(-10, 10, (4, 3)))
        try:
            made, error = build.coons(sides, across=across)
        except sc.InvalidShape as refused:
            assert "stay positive" in str(refused)
            continue
        done += 1
        assert error <= 1e-7
        for side, vectors, border in zip(sides, across, BORDERS):
            edge = made.boundary(border)
            there = places if border in ("v_start", "u_end") else 1 - places
            assert np.abs(edge.evaluate(there) - side.evaluate(places)).max() <= 1e-8
            wanted = vectors.evaluate(places)
            size = max(1.0, np.abs(made.points).max(), np.abs(wanted).max())
            assert np.abs(leaving(made, border, places) - wanted).max() <= 1e-7 * size


def test_a_side_without_vectors_takes_the_twists_of_its_neighbors():
    patch = cubic_across(np.random.default_rng(7), 3)
    sides, across = around(patch)
    made = build.coons(sides, across=[across[0], None, across[2], None]).value
    assert np.abs(grid(made) - grid(patch)).max() <= 1e-13      # cubic both ways: nothing else is left


def test_of_two_twists_the_mean_is_taken_and_the_change_is_said():
    patch = sc.BezierPatch(np.random.default_rng(8).uniform(-1, 1, (4, 4, 3))).to_nurbs()
    sides, across = around(patch)
    points = across[0].points.copy()
    points[1] += (0, 0, 0.3)                                     # its twist at the start grows by 0.9
    bent = [sc.BezierCurve(points), *across[1:]]
    made, error = build.coons(sides, across=bent)
    assert error == pytest.approx(0.45 * 4 / 27, rel=1e-9)
    twist, own = (one.derivatives([0], [0], 2)[0][1, 1] for one in (made, patch))
    assert np.abs(twist - own - (0, 0, 0.45)).max() <= 1e-12


def square(corner=(1, 1, 0)):
    return [line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), corner), line(corner, (0, 1, 0)), line((0, 1, 0), (0, 0, 0))]


UP = line((0, 1, 0), (0, 1, 0))


@pytest.mark.parametrize("sides, across, error, words", [
    (square()[:3], [None] * 3, sc.InvalidShape, "four are needed"),
    (square(), [UP], sc.InvalidShape, "across has 1 values"),
    (square(), [line((1, 1, 0), (0, 1, 0)), None, None, None], sc.ToleranceNotReached, r"across\[0\] is not, at an end"),
    (square(), [None, None, None, UP], sc.ToleranceNotReached, r"across\[3\] is not"),
    (square(), [sc.BezierCurve([(0, 1, 0), (0, 1, 0)], [1, 2]), None, None, None], sc.InvalidShape, r"across\[0\] has weights"),
    (square(), [sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 1, 0)] * 4), None, None, None], sc.InvalidShape, "jumps"),
    (square(), [None, None, sc.NurbsCurve(2, [0, 1, 2, 3, 4], [(0, 1, 0)] * 4, periodic=True), None], sc.InvalidShape,
     r"across\[2\] is closed"),
    (square(), UP, TypeError, "list of curves and None"),
    (square(), ["up", None, None, None], (sc.InvalidShape, TypeError), "curve"),
])
def test_what_cannot_be_is_refused_by_name(sides, across, error, words):
    with pytest.raises(error, match=words):
        build.coons(sides, across=across)


def test_a_derivative_within_the_tolerance_is_moved_and_that_is_said():
    near = line((0, 1, 0.01), (0, 1, 0))
    made, error = build.coons(square(), across=[near, None, None, None], tolerance=0.02)
    assert error == pytest.approx(0.01)
    assert np.abs(leaving(made, "v_start", np.array([0.0, 1.0])) - (0, 1, 0)).max() <= 1e-12
