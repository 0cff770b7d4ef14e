"""Lengths, curvatures, areas and volumes against closed forms, laws and other quadrature."""

import json
import math
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import dense_rules
import splinecore as sc
from shapes import circle, cubic, curves, hermite_chain, hyperbola, inside, nurbs_curves, patches, semicircle
from shapes import sphere_octant, wavy_patch
from splinecore import build

PI = math.pi
TEAPOT = Path(__file__).resolve().parents[2] / "addon/splinewright/core/shape/teapot.json"
NODES, WEIGHTS = (array / 2 for array in np.polynomial.legendre.leggauss(40))
NODES = NODES + 0.5


def spans(knots, domain):
    cuts = np.unique(np.clip(knots, *domain))
    return zip(cuts, cuts[1:])


def nodes_of(knots, domain, parts=4):
    """Parameters and weights of a dense rule on every span."""
    at, weights = [], []
    for start, end in spans(knots, domain):
        for cut in np.linspace(start, end, parts + 1)[:-1]:
            at.append(cut + (end - start) / parts * NODES)
            weights.append((end - start) / parts * WEIGHTS)
    return np.concatenate(at), np.concatenate(weights)


def integral(patch, function, parts=4):
    """Of function(u, v) |S_u x S_v| over a patch."""
    form = patch.to_nurbs()
    (u, wu), (v, wv) = (nodes_of(*axis, parts) for axis in zip(form.knots, form.domain))
    jets = form.derivatives(u[:, None], v, 1)
    density = np.linalg.norm(np.cross(jets[..., 1, 0, :], jets[..., 0, 1, :]), axis=-1)
    return float(wu @ (density * function(u[:, None], v)) @ wv)


def near(value, expected, relative):
    return abs(value - expected) <= relative * abs(expected)


def double_parabola():
    """Runs to infinity in the middle, where its weight is zero in every bit."""
    return sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, -1, 1])


# Curves


def test_a_circle_is_as_long_as_its_radius_says():
    for radius in (1.0, 1e-9, 1e12):
        curve = sc.conics.circle((0, radius, 0), radius, (1, 1, 1))
        assert near(curve.length(), 2 * PI * radius, 1e-13)
    assert near(semicircle().length(), PI, 1e-14)
    assert near(circle().length(0.5, 2.5), PI, 1e-14)
    assert circle().length(1, 1) == 0


def test_a_curve_with_a_pythagorean_hodograph_has_a_rational_length():
    # x' = a² - b², y' = 2 a b with a = 1 + t, b = 2 - 3 t: the speed is a² + b².
    a, b = [Fraction(1), Fraction(1)], [Fraction(2), Fraction(-3)]
    times = lambda p, q: [p[0] * q[0], p[0] * q[1] + p[1] * q[0], p[1] * q[1]]
    dx = [x - y for x, y in zip(times(a, a), times(b, b))]
    dy = [2 * x for x in times(a, b)]
    speed = [x + y for x, y in zip(times(a, a), times(b, b))]
    grown = lambda p: [0.0] + [float(c / (k + 1)) for k, c in enumerate(p)]
    curve = sc.PowerCurve(np.column_stack([grown(dx), grown(dy)]))
    exact = sum(c / (k + 1) for k, c in enumerate(speed))
    assert near(curve.length(), float(exact), 1e-14)
    assert near(curve.to_bezier()[0].length(), float(exact), 1e-14)


@pytest.mark.parametrize("end", [1.0, 0.7, 1e-2, 1e-4])
def test_the_length_goes_through_a_cusp(end):
    arm = lambda t: 8 / 27 * math.expm1(1.5 * math.log1p(9 / 4 * t * t))
    curve = sc.PowerCurve([(0, 0), (0, 0), (1, 0), (0, 1)], 0.0, (-1, end))
    assert near(curve.length(), arm(1) + arm(end), 1e-13)
    assert near(curve.length(0.0, end), arm(end), 1e-11)
    assert curve.curvature(0.0) == math.inf


def test_a_helix_has_its_length_curvature_and_torsion():
    helix = build.curve_from_formulas(["2*cos(t)", "2*sin(t)", "t"], (0, 4 * PI), tolerance=1e-10).value
    assert near(helix.length(), 4 * PI * math.sqrt(5), 1e-11)
    at = np.unique(helix.knots)
    assert np.abs(helix.curvature(at) - 2 / 5).max() <= 1e-9
    assert np.abs(helix.torsion(inside(helix.domain)) - 1 / 5).max() <= 1e-4
    frame = helix.frenet_frame(at)
    normal = -np.column_stack([np.cos(at), np.sin(at), 0 * at])
    assert np.abs(frame[:, 1] - normal).max() <= 1e-8
    assert np.abs(frame @ frame.swapaxes(1, 2) - np.eye(3)).max() <= 1e-14


@settings(max_examples=40)
@given(nurbs_curves(), st.floats(0.1, 0.9))
def test_the_length_is_that_of_a_dense_rule_and_of_its_parts(curve, share):
    start, end = curve.domain
    middle = start + share * (end - start)
    whole = curve.length()
    assert abs(curve.length(end=middle) + curve.length(start=middle) - whole) <= 4e-13 * whole
    u, weights = nodes_of(curve.knots, curve.domain, 16)
    dense = weights @ np.linalg.norm(curve.derivatives(u, 1)[:, 1], axis=1)
    rounding = 1e-13 * np.abs(curve.points).max()
    assert abs(dense - whole) <= 1e-3 * whole + rounding  # where the rule itself is good
    scaled = curve.with_points(curve.points * -2.0)
    assert abs(scaled.length() - 2 * whole) <= 4e-13 * whole


def test_every_kind_of_curve_is_measured():
    for curve in curves():
        form = curve.to_nurbs()
        u, weights = nodes_of(form.knots, form.domain, 16)
        dense = weights @ np.linalg.norm(form.derivatives(u, 1)[:, 1], axis=1)
        assert near(curve.length(), dense, 1e-11)
        at = inside(curve.domain, 7).reshape(7, 1)
        assert curve.curvature(at).shape == curve.torsion(at).shape == (7, 1)
        assert curve.frenet_frame(at).shape == (7, 1, 3, 3)
        jets = curve.derivatives(at, 3)
        first, second, third = jets[..., 1, :], jets[..., 2, :], jets[..., 3, :]
        across = np.cross(first, second)
        expected = np.linalg.norm(across, axis=-1) / np.linalg.norm(first, axis=-1) ** 3
        assert np.abs(curve.curvature(at) - expected).max() <= 1e-11 * expected.max()
        turning = (across * third).sum(axis=-1) / (across * across).sum(axis=-1)
        assert np.abs(curve.torsion(at) - turning).max() <= 1e-9 * max(1, np.abs(turning).max())


def test_a_straight_line_has_no_torsion_and_a_knot_two_curvatures():
    line = sc.BezierCurve([(0, 0, 0), (1, 2, 3)])
    assert line.curvature(0.5) == 0 and np.isnan(line.torsion(0.5))
    assert np.isnan(line.frenet_frame(0.5)[1:]).all()
    chain = hermite_chain()
    assert chain.curvature(1.0, side="left") != chain.curvature(1.0)


def test_a_periodic_curve_goes_on_however_far():
    ring = sc.NurbsCurve(3, range(8), np.random.default_rng(5).normal(size=(7, 3)), periodic=True)
    whole, part = ring.length(), ring.length(0, 1)
    for start, end, expected in [
            (0, 8, whole + part), (-1, 0, ring.length(6, 7)), (6.5, 7.5, ring.length(6.5, 7) + ring.length(0, 0.5)),
            (7, 14, whole), (0, 70, 10 * whole), (-3.5, 17.5, 3 * whole), (3, 3, 0), (7, 7, 0), (14, 15, part),
            (6.5, 14.25, ring.length(6.5, 7) + whole + ring.length(0, 0.25)), (-7e6, 7e6, 2e6 * whole)]:
        assert near(ring.length(start, end), expected, 1e-12), (start, end)
    assert near(ring.length(start=-2), ring.length(5, 7) + whole, 1e-12)
    assert ring.evaluate(8).tolist() == ring.evaluate(1).tolist()


def test_a_curve_of_any_parameters_has_a_length():
    for size in (1e-200, 1e160, 1e308):
        ring = sc.NurbsCurve(1, [0, size / 2, size], [(0, 0), (1, 0)], periodic=True)
        assert near(ring.length(-size, size / 2), 3, 1e-13) and near(ring.length(-size / 4, size / 4), 1, 1e-13)


@pytest.mark.parametrize("call, error, message", [
    (lambda: circle().to_periodic().value.length(0, math.inf), sc.InvalidShape, "end = inf"),
    (lambda: hyperbola().length(), sc.PointAtInfinity, "infinity"),
    (lambda: circle().length(2, 1), sc.InvalidShape, "start = 2 is above end = 1"),
    (lambda: circle().length(-1), sc.InvalidShape, "start = -1 is outside the domain [0, 4]"),
    (lambda: circle().length(0, float("nan")), sc.InvalidShape, "end"),
    (lambda: circle().length(tolerance=-1), sc.InvalidShape, "tolerance = -1 is not a positive number"),
    (lambda: circle().curvature([0, 5]), sc.InvalidShape, "u[1] = 5"),
    (lambda: circle().torsion(math.nan), sc.InvalidShape, "u"),
    (lambda: circle().frenet_frame(0, side="up"), sc.InvalidShape, "side"),
    (lambda: double_parabola().curvature(0.5), sc.PointAtInfinity, "infinity"),
    (lambda: circle().curvature("u"), TypeError, "u"),
])
def test_curves_refuse_with_a_sentence(call, error, message):
    with pytest.raises(error) as refused:
        call()
    assert message in str(refused.value)


# Patches


def sphere(radius=1.5):
    return build.sphere((0.5, 1, 2), radius, axis=(1, -2, 2))


@pytest.mark.parametrize("v", [0.0, 1e-6, 0.5, 1.0, 1.9, 2.0])
def test_a_sphere_bends_equally_everywhere_also_at_its_poles(v):
    found = sphere().curvatures(np.linspace(0, 4, 9), v)
    slack = 1e-12 if v != 1e-6 else 1e-8
    assert np.abs(found.gauss * 1.5**2 - 1).max() <= slack
    assert np.abs(found.mean * 1.5 + 1).max() <= slack
    assert np.abs(found.principal * 1.5 + 1).max() <= slack
    assert np.abs(np.linalg.norm(found.directions, axis=-1) - 1).max() <= 1e-14


def test_an_octant_knows_its_pole():
    found = sphere_octant().curvatures([0.0, 0.3, 1.0], 1.0)
    assert isinstance(found, sc.Curvatures) and "(3,)" in repr(found)
    assert found.gauss == pytest.approx(1, abs=1e-12) and np.abs(found.mean) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize('axis', range(3))
def test_small_heights_beside_large_ones_bend_a_patch(axis):
    """Heights of 1e-12 make the curvature where the patch begins; where it ends it is 6e4 high."""
    heights, step = [0.0, -2.0**-40, 2.0**-42, 6e4], 2.0**-7
    points = [[(step * i, j, z) for j in range(2)] for i, z in enumerate(heights)]
    patch = sc.BezierPatch(np.roll(points, axis, axis=2))
    bend = 6 * (heights[2] - 2 * heights[1] + heights[0]) / (3 * step) ** 2
    assert np.max(np.abs(patch.curvatures(0.0, 0.5).principal)) == pytest.approx(bend, rel=1e-12)


def test_the_tip_of_a_cone_has_no_curvature():
    cone = build.cone((0, 0, 0), (0, 0, 1), 1, 1)
    assert np.isnan(cone.curvatures(0.5, 1.0).gauss) and np.isnan(cone.curvatures(0.5, 1.0).directions).all()
    at = cone.curvatures(0.5, np.array([0.0, 0.5]))
    assert np.abs(at.gauss).max() <= 1e-13
    assert at.principal[:, 1] == pytest.approx(-math.sqrt(0.5) / np.array([1, 0.5]), rel=1e-13)


def test_both_forms_are_those_of_the_derivatives():
    for patch in patches():
        u, v = (inside(domain, 5)[1:-1] for domain in patch.domain)
        first, second = patch.fundamental_forms(u[:, None], v)
        assert first.shape == second.shape == (3, 3, 2, 2)
        jets = patch.derivatives(u[:, None], v, 2)
        slopes = np.stack([jets[..., 1, 0, :], jets[..., 0, 1, :]], axis=-2)
        normal = np.cross(slopes[..., 0, :], slopes[..., 1, :])
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        bends = np.stack([jets[..., 2, 0, :], jets[..., 1, 1, :], jets[..., 1, 1, :], jets[..., 0, 2, :]], axis=-2)
        expected = (bends @ normal[..., None]).reshape(3, 3, 2, 2)
        metric = slopes @ slopes.swapaxes(-1, -2)
        assert np.abs(first - metric).max() <= 1e-12 * metric.max()
        assert np.abs(second - expected).max() <= 1e-11 * np.abs(bends).max()


def moved(patch, matrix, shift):
    return patch.with_points(patch.points @ matrix.T + shift)


def test_curvatures_turn_scale_and_swap_as_they_should():
    patch = wavy_patch()
    u, v = (inside(domain, 6)[1:-1] for domain in patch.domain)
    plain = patch.curvatures(u[:, None], v)
    turn, _ = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    rigid = moved(patch, 3 * turn, (5, -7, 9)).curvatures(u[:, None], v)
    size = np.abs(plain.principal).max()
    assert np.abs(9 * rigid.gauss - plain.gauss).max() <= 1e-10 * size**2
    assert np.abs(3 * rigid.principal - plain.principal).max() <= 1e-10 * size
    for other in (patch.swapped().curvatures(v, u[:, None]), patch.reversed("u").curvatures(
            (sum(patch.domain[0]) - u)[:, None], v)):
        assert np.abs(other.gauss - plain.gauss).max() <= 1e-10 * size**2
        assert np.abs(other.mean + plain.mean).max() <= 1e-10 * size
        assert np.abs(other.principal[..., ::-1] + plain.principal).max() <= 1e-10 * size


@pytest.mark.parametrize('weight', [np.finfo(float).max, 1e-300])
def test_forms_and_curvatures_are_those_of_weights_divided_by_any_number(weight):
    rng = np.random.default_rng(3)
    net, weights = rng.normal(size=(4, 5, 3)), rng.uniform(0.2, 1.0, (4, 5))
    weights[2, 2] = 1.0
    plain, heavy = sc.BezierPatch(net, weights), sc.BezierPatch(net, weights * weight)
    u, v = np.linspace(0, 1, 5)[:, None], np.linspace(0, 1, 4)
    for ours, theirs in zip(heavy.fundamental_forms(u, v), plain.fundamental_forms(u, v)):
        np.testing.assert_allclose(ours, theirs, rtol=1e-11, atol=1e-11 * np.abs(theirs).max())
    np.testing.assert_allclose(heavy.curvatures(u, v).gauss, plain.curvatures(u, v).gauss, rtol=1e-8)


def test_principal_directions_are_where_the_normal_curvature_is_extreme():
    patch = wavy_patch()
    first, second = patch.fundamental_forms(0.7, 1.3)
    found = patch.curvatures(0.7, 1.3)
    jets = patch.derivatives(0.7, 1.3, 1)
    slopes = np.array([jets[1, 0], jets[0, 1]])
    for direction, principal in zip(found.directions, found.principal):
        steps = np.linalg.lstsq(slopes.T, direction, rcond=None)[0]
        assert steps @ first @ steps == pytest.approx(1, abs=1e-12)
        assert second @ steps == pytest.approx(principal * first @ steps, rel=1e-10)


def test_gauss_and_bonnet_agree():
    ball, ring = sphere(), build.torus((0, 0, 0), (0, 0, 1), 3, 1)
    assert integral(ball, lambda u, v: ball.curvatures(u, v).gauss, 1) == pytest.approx(4 * PI, rel=1e-11)
    assert integral(ring, lambda u, v: ring.curvatures(u, v).gauss, 1) == pytest.approx(0, abs=1e-11)


def brioschi(metric, step):
    """Gauss's curvature from the first form alone, on a 3 x 3 grid of places `step` apart."""
    e, f, g = metric[..., 0, 0], metric[..., 0, 1], metric[..., 1, 1]
    du = lambda x: (x[2, 1] - x[0, 1]) / (2 * step)
    dv = lambda x: (x[1, 2] - x[1, 0]) / (2 * step)
    duv = (f[2, 2] - f[2, 0] - f[0, 2] + f[0, 0]) / (4 * step**2)
    twice = duv - ((e[1, 2] - 2 * e[1, 1] + e[1, 0]) + (g[2, 1] - 2 * g[1, 1] + g[0, 1])) / (2 * step**2)
    e1, f1, g1 = e[1, 1], f[1, 1], g[1, 1]
    one = [[twice, du(e) / 2, du(f) - dv(e) / 2], [dv(f) - du(g) / 2, e1, f1], [dv(g) / 2, f1, g1]]
    two = [[0, dv(e) / 2, du(g) / 2], [dv(e) / 2, e1, f1], [du(g) / 2, f1, g1]]
    return (np.linalg.det(one) - np.linalg.det(two)) / (e1 * g1 - f1 * f1) ** 2


def test_the_first_form_alone_knows_the_gauss_curvature():
    step = 1e-4
    steps = step * np.array([-1, 0, 1])
    ring = build.torus((0, 0, 0), (0, 0, 1), 3, 1)
    for patch, u, v in ((wavy_patch(), 1.1, 1.4), (sphere(), 0.3, 0.6), (ring, 1.4, 2.4)):
        metric, _ = patch.fundamental_forms(u + steps[:, None], v + steps)
        found = patch.curvatures(u, v)
        size = np.abs(found.principal).max() ** 2
        assert abs(brioschi(metric, step) - found.gauss) <= 1e-5 * size


def test_a_catenoid_is_a_minimal_surface():
    profile = build.curve_from_formulas(["cosh(t)", "0", "t"], (-1, 1), tolerance=1e-11).value
    patch = build.revolve(profile, (0, 0, 0), (0, 0, 1))
    assert near(patch.area(), PI * (2 + math.sinh(2)), 1e-10)
    at = np.unique(profile.knots)
    found = patch.curvatures(0.3, at)
    assert np.abs(found.mean).max() <= 1e-8
    assert np.abs(found.gauss + np.cosh(at) ** -4).max() <= 1e-8


# Areas and volumes


def body(mantle, radius, height=None):
    """A mantle on a disc and, with a height, below one of radius 1."""
    parts = [mantle, build.disc((0, 0, 0), (0, 0, 1), radius).reversed("v")]
    return sc.PatchSet.from_patches(parts + ([build.disc((0, 0, height), (0, 0, 1), 1)] if height else []))


def closed_forms():
    up = (0, 0, 1)
    one = lambda patch: sc.PatchSet.from_patches([patch])
    return [(one(sphere()), 9 * PI, 4.5 * PI),
            (one(build.torus((7, 8, 9), (1, 2, 2), 3, 1.25)), 15 * PI**2, 2 * PI**2 * 3 * 1.25**2),
            (body(build.cylinder((0, 0, 0), up, 1, 3), 1, 3), 8 * PI, 3 * PI),
            (body(build.cone((0, 0, 0), up, 3, 4), 3), 24 * PI, 12 * PI),
            (body(build.cone((0, 0, 0), up, 4, 4, 1), 4, 4), (25 + 16 + 1) * PI, 28 * PI)]


@pytest.mark.parametrize("body, area, volume", closed_forms())
def test_bodies_have_the_area_and_volume_of_their_closed_form(body, area, volume):
    assert near(body.area(), area, 1e-12) and near(body.volume(), volume, 1e-12)
    assert near(body.flipped().volume(), -volume, 1e-12)
    far = body.with_points(2 * body.points + 1000.0)
    assert near(far.area(), 4 * area, 1e-11) and near(far.volume(), 8 * volume, 1e-11)


def test_areas_of_all_kinds_are_those_of_a_dense_rule():
    for patch in patches():
        form = patch.to_nurbs()
        area, unsure = dense_rules.settled_area(form.degree, form.knots, form.points, form.weights, form.periodic)
        assert unsure < 1e-10 and near(patch.area(), area, 2e-12 + unsure)
    pieces = [piece for row in wavy_patch().to_bezier() for piece in row]
    assert near(sum(piece.area() for piece in pieces), wavy_patch().area(), 4e-12)


def test_the_teapot_has_the_area_of_a_dense_rule():
    data = json.loads(TEAPOT.read_text())
    teapot = sc.PatchSet(np.array(data["points"]), [np.array(rows).reshape(4, 4) for rows in data["patches"]])
    dense = sum(integral(teapot[i], lambda u, v: 1.0) for i in range(len(teapot)))
    assert near(teapot.area(), dense, 1e-9)
    assert near(teapot.area(tolerance=1e-6), dense, 1e-6)
    with pytest.raises(sc.InvalidShape, match="meets no other"):
        teapot.volume()


def test_a_tetrahedron_of_four_collapsed_patches_has_its_volume():
    corners = np.array([(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 4)], float)
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    patches = [sc.BezierPatch([[corners[a], corners[a]], [corners[b], corners[c]]]) for a, b, c in faces]
    solid = sc.PatchSet.from_patches(patches)
    assert near(solid.volume(), 4.0, 1e-13)
    assert near(solid.area(), 3 + 4 + 6 + 0.5 * math.sqrt(6**2 + 8**2 + 12**2), 1e-13)


def infinite_patch():
    return build.extrude(hyperbola(), (0, 0, 1))


@pytest.mark.parametrize("call, error, message", [
    (lambda: infinite_patch().area(), sc.PointAtInfinity, "infinity"),
    (lambda: sc.PatchSet.from_patches([infinite_patch()]).area(), sc.PointAtInfinity, "infinity"),
    (lambda: sphere().area(tolerance=0), sc.InvalidShape, "tolerance = 0 is not a positive number"),
    (lambda: sphere(1e160).area(), sc.InvalidShape, "the area is too large for a number"),
    (lambda: body(build.cylinder((0, 0, 0), (0, 0, 1), 1, 3), 1).volume(), sc.InvalidShape, "v = end of patches[0]"),
    (lambda: sphere().curvatures([0, 9], 3), sc.InvalidShape, "v = 3"),
    (lambda: wavy_patch().curvatures([0, 9], 0), sc.InvalidShape, "u[1] = 9"),
    (lambda: sphere().fundamental_forms([0, 1], [0, 1, 2]), sc.InvalidShape, "do not broadcast"),
    (lambda: sphere().curvatures(0, 0, side="top"), sc.InvalidShape, "side"),
    (lambda: sphere().curvatures(None, 0), TypeError, "u"),
    (lambda: build.extrude(double_parabola(), (0, 0, 1)).curvatures(0.5, 0), sc.PointAtInfinity, "infinity"),
])
def test_patches_refuse_with_a_sentence(call, error, message):
    with pytest.raises(error) as refused:
        call()
    assert message in str(refused.value)


def test_no_parameters_have_no_curvatures():
    found = sphere().curvatures([], 0.5)
    assert found.gauss.shape == (0,) and found.directions.shape == (0, 2, 3)
    assert cubic().curvature([]).shape == (0,)
