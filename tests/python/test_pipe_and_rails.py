"""Pipes and sections between two rails: distances from the axis, borders on the rails, and what is refused."""

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, closed_cubic, cubic, hermite_chain
from splinecore import build


def grid(patch, count=65):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain))


def line(*points):
    return sc.BezierCurve(points)


BENT = sc.BezierCurve([(0, 0, 0), (1, 0, 1), (2, 2, 0), (4, 1, 1)])


@pytest.mark.parametrize("axis", [BENT, cubic(), closed_cubic(), hermite_chain()], ids=["bezier", "cubic", "closed", "hermite"])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_a_pipe_is_its_radius_from_its_axis(axis, tolerance):
    size = np.ptp(axis.evaluate(np.linspace(*axis.domain, 50)), axis=0).max()
    (mantle, *caps), error = build.pipe(axis, 0.01 * size, tolerance=tolerance * size)
    assert not caps and error <= tolerance * size and mantle.periodic[0]
    points = grid(mantle, 33)
    from_axis = points - axis.evaluate(np.linspace(*mantle.domain[1], 33))[None]
    assert np.abs(np.linalg.norm(from_axis, axis=-1) - 0.01 * size).max() <= tolerance * size
    assert axis.nearest(points.reshape(-1, 3)).distances.max() <= (0.01 + tolerance) * size


def scale_like(curve, numbers):
    """Of numbers in place of the control points of a curve."""
    points = np.column_stack([numbers, np.zeros((len(numbers), 2))])
    weights = curve.weights if curve.is_rational else None
    return sc.NurbsCurve(curve.degree, curve.knots, points, weights, curve.periodic)


def radii_off(mantle, axis, radius_at, size):
    """How far, of the size, points of a mantle are from where a radius (of parameters) has them."""
    v = np.linspace(*mantle.domain[1], 173)
    points = mantle.evaluate_grid(np.linspace(*mantle.domain[0], 9), v)
    away = np.linalg.norm(points - axis.evaluate(v)[None], axis=-1)
    return np.abs(away - radius_at(v)[None]).max() / size


AXES = {"bezier": BENT.to_nurbs(), "cubic": cubic(), "closed": closed_cubic(), "hermite": hermite_chain().to_nurbs(),
        "circle": circle(), "straight": sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0, 0), (1, 0, 0), (2, 0, 0), (4, 0, 0)])}


@pytest.mark.parametrize("axis", AXES.values(), ids=AXES.keys())
def test_a_scale_is_a_spline_of_the_axis(axis):
    size = np.ptp(axis.evaluate(np.linspace(*axis.domain, 50)), axis=0).max()
    rng = np.random.default_rng(5)
    numbers = rng.uniform(0.5, 2.0, len(axis.points))
    if np.allclose(*axis.evaluate(axis.domain)) and not axis.periodic:
        numbers[-1] = numbers[0]
    scale = scale_like(axis, numbers)
    (mantle,), error = build.pipe(axis, 0.01 * size, scale=scale, tolerance=1e-6 * size)
    assert error <= 1e-6 * size
    assert radii_off(mantle, axis, lambda v: 0.01 * size * scale.evaluate(v)[:, 0], size) <= 1.01e-6


def test_a_scale_of_any_kind_with_corners_of_its_own():
    axis = BENT.to_nurbs()
    kinked = sc.NurbsCurve(1, [0, 0, 0.3, 0.7, 1, 1], [(1, 0, 0), (3, 0, 0), (0.5, 0, 0), (2, 0, 0)])
    (mantle, *caps), _ = build.pipe(axis, 0.1, scale=kinked, caps="round", tolerance=1e-7)
    assert radii_off(mantle, axis, lambda v: 0.1 * kinked.evaluate(v)[:, 0], 1.0) <= 1.01e-7
    assert len(caps) == 2 and np.array_equal(caps[1].boundary("v_start").points, mantle.boundary("v_end").points)
    table = [(0.0, 0.1), (1.0, 0.2)]
    (plain,), _ = build.pipe(axis, table, tolerance=1e-7)
    (scaled,), _ = build.pipe(axis, table, scale=sc.BezierCurve([(1, 0, 0), (2, 5, 0), (3, 0, 0)]), tolerance=1e-7)
    v = np.linspace(0, 1, 41)
    radii = [np.linalg.norm(patch.evaluate(np.zeros(41), v) - axis.evaluate(v), axis=1) for patch in (plain, scaled)]
    assert np.abs(radii[1] - radii[0] * (1 + 2 * v)).max() <= 1e-6


def test_sections_are_scaled_too():
    section = sc.BezierCurve([(0.2, 0, 0), (0.1, 0.3, 0), (0, 0.2, 0)])
    scale = sc.BezierCurve([(1, 0, 0), (0.25, 0, 0), (2, 0, 0)])
    plain, _ = build.sweep(BENT, section, tolerance=1e-8)
    scaled, _ = build.sweep(BENT, section, scale=scale, tolerance=1e-8)
    v = np.linspace(0, 1, 31)
    for u in (0.0, 0.4, 1.0):
        at, middle = np.full(31, u), BENT.evaluate(v)
        wanted = middle + scale.evaluate(v)[:, :1] * (plain.evaluate(at, v) - middle)
        assert np.abs(scaled.evaluate(at, v) - wanted).max() <= 1e-7


@pytest.mark.parametrize("axis, scale, words", [
    (BENT, sc.BezierCurve([(1, 0, 0), (0, 0, 0)]), "a scale of 0: above 0"),
    (BENT, sc.NurbsCurve(1, [0, 0, 2, 2], [(1, 0, 0), (2, 0, 0)]), "runs from 0 to 2, the rail from 0 to 1"),
    (BENT, sc.NurbsCurve(1, [0, 0, 0.5, 0.5, 1, 1], [(1, 0, 0), (2, 0, 0), (3, 0, 0), (1, 0, 0)]), "jumps at 0.5"),
    (closed_cubic(), sc.NurbsCurve(1, [closed_cubic().domain[0]] * 2 + [closed_cubic().domain[1]] * 2, [(1, 0, 0), (2, 0, 0)]), "closed"),
    (BENT, 2.0, "a curve is expected"),
])
def test_what_scales_nothing(axis, scale, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.pipe(axis, 0.1, scale=scale)


def test_wild_scales_are_right_or_refused(inputs):
    """On open and closed axes, turned, scaled, far away: the radius is the spline's."""
    made = 0
    for seed in range(inputs(120)):
        rng = np.random.default_rng([91, seed])
        degree, count = int(rng.integers(1, 6)), int(rng.integers(4, 10))
        knots = np.r_[[0] * (degree + 1), np.sort(rng.choice([0.1, 0.25, 0.25, 0.5, 0.75, 0.8], count)), [1] * (degree + 1)]
        knots = knots[[i for i in range(len(knots)) if i < degree + 1 or (knots[i] == 1) or np.sum(knots[:i] == knots[i]) < degree]]
        numbers = 10 ** rng.uniform(-1, 0.5, len(knots) - degree - 1)
        scale = sc.NurbsCurve(degree, knots, np.column_stack([numbers, rng.normal(size=(len(numbers), 2))]))
        axis = sc.NurbsCurve(3, [0] * 4 + [0.4] + [1] * 4, rng.normal(size=(5, 3)) * 10 ** rng.uniform(-6, 6))
        size = np.ptp(axis.points, axis=0).max()
        try:
            (mantle,), error = build.pipe(axis, 0.01 * size, scale=scale, tolerance=1e-4 * size)
        except (sc.InvalidShape, sc.ToleranceNotReached):
            continue
        made += 1
        assert radii_off(mantle, axis, lambda v: 0.01 * size * scale.evaluate(v)[:, 0], size) <= 1.1e-4, seed
    assert made > 0.8 * inputs(120)


@pytest.mark.parametrize("caps", ["flat", "round"])
def test_caps_close_it(caps):
    parts, _ = build.pipe(BENT, 0.2, caps=caps, tolerance=1e-6)
    mantle, start, end = parts
    assert np.array_equal(start.boundary("v_start").reversed().points, mantle.boundary("v_start").points)
    assert np.array_equal(end.boundary("v_start").points, mantle.boundary("v_end").points)
    length = BENT.length()
    volume = np.pi * 0.04 * length + (4 / 3 * np.pi * 0.008 if caps == "round" else 0)
    assert sc.PatchSet.from_patches(parts).volume() == pytest.approx(volume, rel=1e-5)
    if caps == "round":
        points = grid(end).reshape(-1, 3)
        assert np.abs(np.linalg.norm(points - BENT.evaluate(1.0), axis=1) - 0.2).max() <= 1e-6


def test_radii_change_without_overshoot():
    radii = [(0, 0.1), (0.3, 0.3), (0.5, 0.3), (1, 0.05)]
    (mantle,), error = build.pipe(line((0, 0, 0), (0, 0, 4)), radii, tolerance=1e-5)
    v = np.linspace(0, 1, 201)
    found = np.linalg.norm(mantle.evaluate(np.zeros(201), v)[:, :2], axis=1)
    assert found.max() <= 0.3 + 1e-5 and found.min() >= 0.05 - 1e-5
    for at, radius in radii:
        assert np.linalg.norm(mantle.evaluate(0.0, at)[:2]) == pytest.approx(radius, abs=1e-5)
    assert np.abs(found[(v >= 0.3) & (v <= 0.5)] - 0.3).max() <= 1e-5


def test_a_closed_axis_makes_a_ring_without_caps():
    parts, _ = build.pipe(circle().transformed(3 * np.eye(3)), [(0.0, 0.3), (0.4, 0.5)], caps="flat", tolerance=1e-5)
    assert len(parts) == 1 and parts[0].periodic == (True, True)


@pytest.mark.parametrize("size", [1e-150, 1e150])
def test_pipes_of_any_size(size):
    axis = sc.BezierCurve(size * np.asarray(BENT.points))
    (mantle,), _ = build.pipe(axis, 0.1 * size, tolerance=1e-4 * size)
    one = build.pipe(BENT, 0.1, tolerance=1e-4).value[0]
    assert np.abs(np.asarray(mantle.points) / size - one.points).max() <= 1e-9


def test_random_axes_and_radii():
    rng = np.random.default_rng(2)
    for _ in range(60):
        axis = sc.BezierCurve(rng.uniform(-1, 1, (int(rng.integers(2, 6)), 3)))
        places = np.sort(rng.uniform(0, 1, int(rng.integers(1, 5))))
        radii = np.c_[places, rng.uniform(0.001, 0.2, len(places))]
        parts, error = build.pipe(axis, radii, caps="round", tolerance=1e-3)
        assert len(parts) == 3 and error <= 1e-3
        assert all(np.isfinite(part.points).all() for part in parts)


@pytest.mark.parametrize("radius, words", [
    (0.0, "above 0"), (-1.0, "above 0"), ([(0, 1), (0, 2)], "increase"), ([(0, 1), (2, 1)], "off the rail"), ([], "no radius|shape"),
    ([(0, 1), (1, 0)], "above 0"), ([1, 2, 3], "shape"),
])
def test_bad_radii(radius, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.pipe(BENT, radius)


RAILS = line((0, 0, 0), (1, 0, 1), (2, 0.5, 0), (4, 0, 1)), line((0, 2, 0), (1, 3, 1), (2, 4, 0.5), (4, 4, 1))
ARCH = line((0, 0, 0), (1, 1, 0), (2, 0, 0))


@pytest.mark.parametrize("height", ["scaled", "kept"])
@pytest.mark.parametrize("up", [None, (0, 0, 1)])
def test_the_borders_are_the_rails(height, up):
    made, error = build.sweep_two_rails(*RAILS, ARCH, height=height, up=up, tolerance=1e-6)
    t = np.linspace(0, 1, 101)
    for rail, side in zip(RAILS, ("u_start", "u_end")):
        assert np.abs(made.boundary(side).evaluate(t) - rail.evaluate(t)).max() <= 1e-6
    assert error <= 1e-6


def test_heights_are_scaled_or_kept():
    rails = line((0, 0, 0), (4, 0, 0)), line((0, 2, 0), (4, 6, 0))
    for height, top in (("scaled", 3 * 0.5), ("kept", 0.5)):
        made, _ = build.sweep_two_rails(*rails, ARCH, height=height, up=(0, 0, 1), tolerance=1e-9)
        assert np.abs(grid(made)[:, -1, 2]).max() == pytest.approx(top, abs=1e-9)


def test_two_straight_rails_make_a_cylinder():
    arc = circle().part(0.0, 0.5 * circle().domain[1]).transformed(np.array([[-1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]]))
    made, error = build.sweep_two_rails(line((0, 0, 0), (0, 0, 5)), line((2, 0, 0), (2, 0, 5)), arc)
    points = grid(made).reshape(-1, 3)
    assert error <= 1e-12 and np.abs(np.hypot(points[:, 0] - 1, points[:, 1]) - 1).max() <= 1e-12


def test_rings_between_closed_rails():
    a, b = circle().transformed(3 * np.eye(3)), circle().transformed(np.array([[4.0, 0, 0, 0], [0, 4, 0, 0], [0, 0, 4, 1]]))
    made, _ = build.sweep_two_rails(a, b, ARCH, tolerance=1e-5)
    assert made.periodic[1]


def test_sections_change_between_rails():
    flat = line((0, 0, 0), (1, 0, 0), (2, 0, 0))
    made, _ = build.sweep_two_rails(line((0, 0, 0), (4, 0, 0)), line((0, 2, 0), (4, 2, 0)), [flat, ARCH], tolerance=1e-9, up=(0, 0, 1))
    assert np.abs(made.evaluate(np.linspace(0, 1, 9), np.zeros(9))[:, 2]).max() <= 1e-12
    assert np.abs(made.evaluate(0.5, 1.0)[2]) == pytest.approx(0.5)


CORNER = build.contour([(0, 0, 0), (2, 0, 0), (2, 2, 0)])


@pytest.mark.parametrize("rails, more, words", [
    ((line((0, 0, 0), (1, 0, 0)), line((0, 0, 0), (1, 1, 0))), {}, "rails meet"),
    ((line((0, 0, 0), (0, 5, 0)), line((2, 5, 0), (2, 0, 0))), {}, "run against each other"),
    ((line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (2, 0, 0))), {}, "along the upright direction or the rails"),
    ((line((0, 0, 0), (1, 0, 0)), line((0, 0, 1), (1, 0, 1))), {"up": (0, 0, 1)}, "along the upright"),
    ((CORNER, CORNER.transformed(np.c_[np.eye(3), [0, 0, 1]])), {}, "corner"),
    (RAILS, {"up": (0, 0, 0)}, "upright direction is zero"),
    (RAILS, {"at": [2.0]}, "parameter 2"),
    (RAILS, {"height": "none"}, "height"),
    (RAILS, {"tolerance": 0.0}, "tolerance"),
])
def test_what_cannot_be_swept_between_rails(rails, more, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.sweep_two_rails(*rails, ARCH, **more)


def test_corners_are_right_with_an_upright_direction():
    other = CORNER.transformed(np.array([[1.5, 0, 0, -0.5], [0, 1.5, 0, -1], [0, 0, 1, 0]]))
    made, _ = build.sweep_two_rails(CORNER, other, ARCH, up=(0, 0, 1), tolerance=1e-6)
    t = np.linspace(*CORNER.domain, 41)
    assert np.abs(made.boundary("u_start").evaluate(t) - CORNER.evaluate(t)).max() <= 1e-6
