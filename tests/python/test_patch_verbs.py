"""Verbs of curves along each axis of a patch, and the curves on it (rows S19, S20)."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import splinecore as sc
from random_patches import error, homogeneous, parameters, random_patch, random_patches, sampled_distance
from shapes import cylinder, hermite_net, revolved, sphere_octant, torus, wavy_patch

COUNT = 1000
NAN, INF = math.nan, math.inf
TEAPOT = Path(__file__).parents[2] / "addon" / "splinewright" / "core" / "shape" / "teapot.json"
VASE = [(0.0, 0.0), (0.45, 0.0), (0.72, 0.05), (0.95, 0.45), (1.05, 0.9), (0.80, 1.35),
        (0.45, 1.70), (0.28, 2.05), (0.30, 2.40), (0.42, 2.62), (0.56, 2.75), (0.62, 2.80)]


def vase():
    """The profile of the lectures as one Bezier curve of degree 11, revolved: its foot is a pole."""
    return revolved(VASE, np.ones(12), [0] * 12 + [1] * 12, 11)


def teapot():
    data = json.loads(TEAPOT.read_text("utf-8"))
    points = np.array(data["points"])
    return [sc.BezierPatch(points[np.reshape(rows, (4, 4))]) for rows in data["patches"]]


def within(patch, axis, rng):
    start, end = patch.domain["uv".index(axis)]
    return start + rng.uniform(0.05, 0.95) * (end - start)


def degree_of(patch, axis):
    return patch.degree["uv".index(axis)]


def inserted_and_removed(patch, axis, rng):
    u, times = within(patch, axis, rng), int(rng.integers(1, degree_of(patch, axis) + 1))
    return patch.insert_knot(axis, u, times).remove_knot(axis, u, times).value


def mapped_and_back(patch, axis, rng):
    there = patch.with_domain(axis, (rng.uniform(-9, 0), rng.uniform(1, 9)))
    assert np.array_equal(there.points, patch.points)
    return there.with_domain(axis, patch.domain["uv".index(axis)])


KEEPING = {
    "elevate": lambda patch, axis, rng: patch.elevate(axis, int(rng.integers(1, 4))),
    "elevate and reduce": lambda patch, axis, rng: patch.elevate(axis).reduce(axis).value,
    "remove_knot": inserted_and_removed,
    "clamped": lambda patch, axis, rng: patch.clamped(axis),
    "with_domain": mapped_and_back,
}


@pytest.mark.parametrize("verb", KEEPING)
def test_verbs_keep_a_thousand_patches(verb):
    for index, patch in enumerate(random_patches(40, COUNT)):
        rng = np.random.default_rng(index)
        after = KEEPING[verb](patch, "uv"[index % 2], rng)
        assert error(patch, after) <= 1e-12, index


def test_unclamped_and_clamped_again_is_the_same_patch():
    for index, patch in enumerate(random_patches(41, COUNT)):
        axis = "uv"[index % 2]
        plain = patch.unclamped(axis)
        assert not plain.periodic["uv".index(axis)] and plain.domain == patch.domain
        assert error(patch, plain) <= 1e-12 and error(patch, plain.clamped(axis)) <= 1e-12, index


def test_along_one_axis_is_along_the_other_of_the_swapped_patch():
    verbs = [lambda p, axis: p.elevate(axis), lambda p, axis: p.reduce(axis).value, lambda p, axis: p.clamped(axis),
             lambda p, axis: p.unclamped(axis), lambda p, axis: p.with_domain(axis, (-1, 3)),
             lambda p, axis: p.moebius(axis, 0.8)]
    for patch in random_patches(42, 100, degree=3):
        for verb in verbs:
            assert verb(patch, "u") == verb(patch.swapped(), "v").swapped()
        assert patch.isocurve("u", patch.domain[0][0]) == patch.swapped().boundary("v_start")


@pytest.mark.parametrize("axis", "uv")
def test_a_closed_patch_becomes_periodic_and_stays_as_smooth(axis):
    rng = np.random.default_rng(43)
    for _ in range(100):
        ring = random_patch(rng, degree=int(rng.integers(1, 8)), ends="periodic", spans=4)
        again, moved = ring.clamped(axis).to_periodic(axis, 1e-9)
        assert again.periodic == (True, True) and moved <= 1e-9 and error(ring, again) <= 1e-10
        assert ring.to_periodic(axis).value == ring


def test_a_torus_closes_in_both_directions():
    closed = torus().to_periodic("u").value.to_periodic("v").value
    assert closed.periodic == (True, True) and closed.points.shape == (8, 8, 3)
    assert error(torus(), closed) <= 1e-15
    with pytest.raises(sc.ToleranceNotReached, match="the ends do not meet within"):
        cylinder().to_periodic("v")


def test_moebius_keeps_the_surface_and_its_ends():
    for patch in (torus(), wavy_patch(), vase()):
        (start, end), v = patch.domain[0], parameters(patch, axis="v")
        t, rho = np.linspace(0, 1, 21), 2.5
        old = start + rho * t / (1 - t + rho * t) * (end - start)
        new = patch.moebius("u", rho).evaluate_grid(start + t * (end - start), v)
        assert np.abs(new - patch.evaluate_grid(old, v)).max() <= 1e-14 * np.abs(patch.points).max() * 8


def test_transformed_is_the_surface_mapped():
    rng = np.random.default_rng(44)
    for patch in (torus(), wavy_patch(), sphere_octant()):
        u, v = parameters(patch, axis="u"), parameters(patch, axis="v")
        points = patch.evaluate_grid(u, v)
        matrix = rng.uniform(-1, 1, (3, 4))
        image = patch.transformed(matrix)
        assert (image.weights == patch.weights).all()
        assert np.abs(image.evaluate_grid(u, v) - (points @ matrix[:, :3].T + matrix[:, 3])).max() <= 1e-14
        view = np.eye(4)
        view[3] = 0.1, 0.05, 0, 1
        seen = patch.transformed(view).evaluate_grid(u, v)
        assert np.abs(seen - points / (1 + points @ view[3, :3])[..., None]).max() <= 1e-14


@pytest.mark.parametrize("axis", "uv")
def test_isocurves_lie_on_a_thousand_patches(axis):
    other = "vu"["uv".index(axis)]
    for index, patch in enumerate(random_patches(45, COUNT)):
        at = within(patch, axis, np.random.default_rng(index))
        curve = patch.isocurve(axis, at)
        t = parameters(patch, axis=other)
        found = sc.basis.Samples(curve.knot_vector, t).apply(curve.homogeneous_points)
        expected = homogeneous(patch, [at], t)[0] if axis == "u" else homogeneous(patch, t, [at])[:, 0]
        assert np.abs(found - expected).max() <= 1e-13 * np.abs(patch.homogeneous_points).max(), index
        assert curve.knot_vector == patch.knot_vectors["uv".index(other)]


def test_boundaries_are_the_sides_and_those_of_the_parts_of_a_split():
    patch = torus()
    assert np.array_equal(patch.boundary("u_start").points, patch.points[0])
    assert np.array_equal(patch.boundary("u_end").points, patch.points[-1])
    assert np.array_equal(patch.boundary("v_start").points, patch.points[:, 0])
    assert np.array_equal(patch.boundary("v_end").points, patch.points[:, -1])
    for axis in "uv":
        before, after = patch.split(axis, 1.3)
        curve = patch.isocurve(axis, 1.3)
        for side in (before.boundary(axis + "_end"), after.boundary(axis + "_start")):
            assert np.abs(side.homogeneous_points - curve.homogeneous_points).max() <= 2e-15


def test_isocurves_of_other_kinds():
    octant, net = sphere_octant(), hermite_net()
    arc = octant.isocurve("u", 0.25)
    assert isinstance(arc, sc.BezierCurve)
    assert np.abs(np.linalg.norm(arc.evaluate(np.linspace(0, 1, 9)), axis=-1) - 1).max() <= 4e-16
    assert (octant.boundary("v_end").points == [0, 0, 1]).all()
    u = np.linspace(0, 3, 11)
    assert np.abs(net.isocurve("v", 0.7).evaluate(u) - net.evaluate(u, 0.7)).max() <= 4e-15
    assert np.abs(net.boundary("v_end").evaluate(u) - net.evaluate(u, 2.0)).max() <= 4e-15
    assert wavy_patch().isocurve("u", 0.3).periodic and not wavy_patch().isocurve("v", 0.3).periodic


@pytest.mark.parametrize("verb", ["remove_knot", "reduce"])
def test_errors_are_bounds_and_near_the_truth(verb):
    rng = np.random.default_rng(46)
    for index in range(60):
        patch = random_patch(rng, degree=int(rng.integers(2, 5)), spans=2)
        axis = "uv"[index % 2]
        if verb == "remove_knot":
            u = within(patch, axis, rng)
            patch = patch.insert_knot(axis, u)
            patch = patch.with_points(patch.points + rng.uniform(-0.1, 0.1, patch.points.shape))
            after, most = patch.remove_knot(axis, u)
        else:
            after, most = patch.reduce(axis)
        if after.weights.min() <= 0:
            continue
        far, rounding = sampled_distance(patch, after), 1e-12
        assert far - rounding <= most <= 1.15 * far + rounding, index
        assert patch.largest_distance(after) == most


def test_bezier_patches_change_their_degrees():
    for patch in [sphere_octant(), *teapot()]:
        for axis in "uv":
            raised = patch.elevate(axis, 2)
            assert isinstance(raised, sc.BezierPatch) and error(patch, raised) <= 1e-15
            back, moved = raised.reduce(axis, 2, tolerance=1e-12)
            assert back.degree == patch.degree and moved <= 1e-12 and error(patch, back) <= 1e-13
            assert isinstance(patch.transformed(np.eye(3)), sc.BezierPatch)


def test_the_teapot_loses_a_degree_within_the_stated_error():
    for patch in teapot():
        lower, most = patch.reduce("u")
        far = sampled_distance(patch, lower)
        assert far <= most + 1e-15 and most <= 1.1 * far + 1e-15


def test_the_vase_keeps_its_pole_and_its_shape():
    patch = vase()
    assert (patch.boundary("v_start").points == 0).all()
    rim = patch.boundary("v_end").evaluate(np.linspace(0, 4, 33))
    assert np.abs(np.hypot(rim[:, 0], rim[:, 1]) - 0.62).max() <= 4e-16
    profile = patch.isocurve("u", 0.0)
    assert profile == sc.NurbsCurve(11, [0] * 12 + [1] * 12, [(r, 0, z) for r, z in VASE])
    lower, most = patch.reduce("v", 3)
    assert lower.degree == (2, 8) and sampled_distance(patch, lower) <= most <= 0.1
    fine = patch.refine("v", [0.2, 0.5, 0.5]).refine("u", [0.5, 3.5])
    plain, most = fine.remove_knots("v", 1e-9)
    assert plain.knots[1].tolist() == patch.knots[1].tolist() and most <= 1e-9
    assert fine.remove_knots("u", 1e-9).value.knots[0].tolist() == patch.knots[0].tolist()


def test_distance_is_a_bound_and_near_the_truth():
    rng = np.random.default_rng(47)
    for _ in range(60):
        patch = random_patch(rng, degree=3, spans=2)
        moved = patch.with_points(patch.points + rng.uniform(-1, 1, patch.points.shape) * 10.0 ** -rng.integers(0, 7))
        far = sampled_distance(patch, moved)
        assert far - 1e-13 <= patch.largest_distance(moved) <= 1.1 * far + 1e-13
    assert wavy_patch().largest_distance(wavy_patch()) == 0
    assert wavy_patch().largest_distance(wavy_patch().unrolled().elevate("u").clamped("v")) <= 1e-13
    shifted = torus().transformed(np.c_[np.eye(3), [1, 2, 2]])
    assert 3 - 1e-13 <= torus().largest_distance(shifted) <= 3.06


REFUSED = [
    (lambda p: p.elevate("w"), "axis = 'w' is neither 'u' nor 'v'"), (lambda p: p.clamped(0), "axis = 0 is neither"),
    (lambda p: p.unclamped(None), "axis = None"), (lambda p: p.reduce("uv"), "axis = 'uv'"),
    (lambda p: p.remove_knots("", 1), "axis = ''"), (lambda p: p.moebius("U", 1), "axis = 'U'"),
    (lambda p: p.with_domain("x", (0, 1)), "axis = 'x'"), (lambda p: p.to_periodic("x"), "axis = 'x'"),
    (lambda p: p.isocurve("x", 0), "axis = 'x'"), (lambda p: p.boundary("u"), "side = 'u' is not 'u_start'"),
    (lambda p: p.elevate("u", -1), r"times = -1 is outside \[0, 252\]"),
    (lambda p: p.elevate("u", 253), r"times = 253 is outside \[0, 252\]"),
    (lambda p: p.reduce("u", 0), r"times = 0 is outside \[1, 2\]"),
    (lambda p: p.reduce("v", 2), r"times = 2 is outside \[1, 1\]"),
    (lambda p: p.reduce("u", 1, -1), "tolerance = -1 is below 0"), (lambda p: p.reduce("u", 1, NAN), "tolerance = nan"),
    (lambda p: p.remove_knot("u", 0), "u = 0 is not a knot that can be removed"),
    (lambda p: p.remove_knot("u", 0.7), "u = 0.7 is not a knot that can be removed"),
    (lambda p: p.remove_knot("u", 0.5, 2), r"times = 2 is outside \[1, 1\]"),
    (lambda p: p.remove_knot("u", 9), r"u = 9 is outside the domain \[0, 2\]"),
    (lambda p: p.remove_knot("v", NAN), "u = nan"), (lambda p: p.remove_knots("u", -1), "tolerance = -1"),
    (lambda p: p.remove_knots("u", NAN), "tolerance = nan"),
    (lambda p: p.with_domain("u", (1, 1)), "the domain from 1 to 1 is empty"),
    (lambda p: p.with_domain("u", (0, 1, 2)), r"domain has 3 values, \(start, end\) is expected"),
    (lambda p: p.with_domain("u", (0, NAN)), "nan"), (lambda p: p.to_periodic("u", -1), "tolerance = -1 is below 0"),
    (lambda p: p.moebius("u", 0), "rho = 0 is not positive"), (lambda p: p.moebius("v", NAN), "rho = nan"),
    (lambda p: p.moebius("u", 1e-200), r"weights\[2, 0\].*range of numbers"),
    (lambda p: p.isocurve("u", 3), r"at = 3 is outside the domain \[0, 2\]"),
    (lambda p: p.isocurve("v", NAN), "at = nan"), (lambda p: p.transformed(np.eye(2)), r"matrix has shape \(2, 2\)"),
    (lambda p: p.transformed(np.full((3, 3), NAN)), r"matrix\[0, 0\] = nan is not finite"),
    (lambda p: p.largest_distance(torus()), "the domains differ"),
    (lambda p: p.to_periodic("u", 100), "weights at the ends are .* a periodic patch needs equal ones"),
]


@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_bad_input_is_refused_in_a_sentence(number):
    call, sentence = REFUSED[number]
    with pytest.raises(sc.InvalidShape, match=sentence):
        call(wavy_patch())


@pytest.mark.parametrize("call", [
    lambda p: p.elevate("u", 1.5), lambda p: p.remove_knot("u", "0.5"), lambda p: p.remove_knots("u", None),
    lambda p: p.isocurve("u", [0, 1]), lambda p: p.moebius("u", None), lambda p: p.largest_distance(None)])
def test_arguments_of_another_type_are_refused(call):
    with pytest.raises(TypeError):
        call(wavy_patch())


def test_a_tolerance_that_is_not_reached_says_what_would_be():
    patch = wavy_patch()
    for call in (lambda t: patch.reduce("u", 1, t), lambda t: patch.remove_knot("u", 0.5, 1, t),
                 lambda t: sphere_octant().reduce("v", 1, t)):
        with pytest.raises(sc.ToleranceNotReached, match="cannot be .* within 1e-06: the error would be"):
            call(1e-6)
        assert call(10).error > 1e-6
    kept, moved = patch.remove_knots("u", 1e-6)
    assert kept == patch and moved == 0


def test_sides_at_infinity_are_refused_and_lines_at_infinity_are_not():
    points = [[(0, 0, 0), (1, 0, 0)], [(0, 0, 1), (0, 1, 1)]]
    cone = sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, points, [[1, 1], [0, 0]])
    with pytest.raises(sc.InvalidShape, match="weights are all zero"):
        cone.boundary("u_end")
    raised = cone.elevate("v")
    assert error(cone, raised) <= 1e-15 and error(cone, raised.reduce("v").value) <= 1e-15
