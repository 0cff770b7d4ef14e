"""Exact circles and what turns with one are found in whatever form, and become deformable within the tolerance; nothing else does."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build

deforming, definitions, failures, seams, turning = map(core, ("deform.deforming", "shape.definition", "base.failures", "joints.seams", "deform.turning"))
table = core("recipes.table")
FORMS = ("square", "triangle", "halves", "single")


def deformed(value, tolerance):
    found = deforming.deformed(definitions.from_value(value), tolerance)
    return definitions.to_value(found.changed.definition), found


def random_ellipse(rng):
    axes = rng.normal(size=(2, 3)) * 10 ** rng.uniform(-2, 2, (2, 1))
    axes[1] -= axes[0] * (axes[0] @ axes[1]) / (axes[0] @ axes[0]) * rng.uniform(0, 0.9)
    return rng.normal(size=3) * 10 ** rng.uniform(-2, 4), *axes


def reshaped(curve, rng):
    """The same curve in another form."""
    nurbs = curve.to_nurbs()
    for _ in range(int(rng.integers(0, 3))):
        what = rng.integers(0, 4)
        if what == 0:
            nurbs = nurbs.elevate(1)
        elif what == 1:
            nurbs = nurbs.insert_knot(float(rng.uniform(*nurbs.domain)), 1)
        elif what == 2:
            nurbs = nurbs.reversed()
        else:
            nurbs = nurbs.with_domain((-3.0, 11.0))
    return nurbs


def test_random_ellipses_in_all_forms_are_as_near_as_said(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        center, a, b = random_ellipse(rng)
        size = max(np.linalg.norm(a), np.linalg.norm(b))
        tolerance = size * 10 ** rng.uniform(-5, -1)
        curve = reshaped(sc.conics.ellipse(center, a, b, FORMS[seed % 4]), rng)
        made, found = deformed(curve, tolerance)
        assert made.degree == 3 and made.periodic and (made.weights == 1).all() and made.domain == pytest.approx(curve.domain)
        assert found.changed.error <= tolerance and found.count == 1 and found.rational == 0
        points = made.evaluate(np.linspace(*made.domain, 41)[:-1])
        assert curve.nearest(points).distances.max() <= found.changed.error * (1 + 1e-6) + 1e-9 * (size + np.linalg.norm(center))
        start, way = made.evaluate(made.domain[0]), made.derivatives(made.domain[0], 1)[1] if hasattr(made, "derivatives") else None
        near = found.changed.error * 1.01 + 1e-9 * (size + np.linalg.norm(center))
        assert np.linalg.norm(start - curve.evaluate(curve.domain[0])) <= near
        if way is not None:
            assert way @ curve.derivatives(curve.domain[0], 1)[1] > 0


def test_random_arcs_keep_their_ends(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        center, a, b = random_ellipse(rng)
        size, sweep = max(np.linalg.norm(a), np.linalg.norm(b)), float(rng.uniform(0.1, 6.2) * rng.choice([-1, 1]))
        curve = sc.conics.arc(center, a, b, float(rng.uniform(-9, 9)), sweep)
        made, found = deformed(curve, size * 10 ** rng.uniform(-5, -1))
        assert (made.weights == 1).all() and not made.periodic and made.degree == 3
        away = made.evaluate(np.array(made.domain)) - curve.evaluate(np.array(curve.domain))
        assert np.abs(away).max() <= 1e-9 * (size + np.linalg.norm(center))
        points = made.evaluate(np.linspace(*made.domain, 33))
        assert curve.nearest(points).distances.max() <= found.changed.error * (1 + 1e-6) + 1e-9 * (size + np.linalg.norm(center))


def random_patch(rng):
    center, a, b = random_ellipse(rng)
    kind = rng.integers(0, 6)
    direction = np.cross(a, b)
    radius, height = float(10 ** rng.uniform(-2, 2)), float(10 ** rng.uniform(-2, 2))
    arc = (float(rng.uniform(-4, 4)), None if rng.random() < 0.5 else float(rng.uniform(0.2, 6) * rng.choice([-1, 1])))
    if kind == 0:
        return build.sphere(center, radius, direction, *arc)
    if kind == 1:
        return build.torus(center, direction, radius, radius * float(rng.uniform(0.05, 0.9)), *arc)
    if kind == 2:
        return build.cylinder(center, direction, radius, height, *arc)
    if kind == 3:
        return build.cone(center, direction, radius, height, radius * float(rng.uniform(0, 3)), *arc)
    if kind == 4:
        return build.extrude(sc.conics.ellipse(center, a, b, FORMS[int(rng.integers(4))]), direction)
    return build.disc(center, direction, radius, *arc)


def test_random_surfaces_are_as_near_as_said_smooth_and_without_weights(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        patch = random_patch(rng)
        if rng.random() < 0.3:
            patch = patch.transposed() if hasattr(patch, "transposed") else patch
        size = float(np.linalg.norm(np.ptp(patch.bounding_box(), axis=0)))
        far = float(np.abs(patch.bounding_box()).max())
        tolerance = size * 10 ** rng.uniform(-4, -1.3)
        made, found = deformed(patch, tolerance)
        assert found.changed.error <= tolerance and found.rational == 0 and (made.weights == 1).all(), seed
        assert made.domain == tuple(pytest.approx(each) for each in patch.domain)
        uv = [start + (end - start) * rng.uniform(size=6) for start, end in made.domain]
        points = np.array([made.evaluate(u, v) for u, v in zip(*uv)])
        assert patch.nearest(points).distances.max() <= found.changed.error * (1 + 1e-6) + 1e-9 * (size + far), seed


def test_a_profile_keeps_its_weights_where_it_is_no_arc():
    profile = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(1, 0, 0), (2, 0, 1), (1, 0, 2), (1, 0, 3)], [1, 3, 0.5, 1])
    exact = build.revolve(profile, (0, 0, 0), (0, 0, 1))
    made, found = deformed(exact, 1e-3)
    assert found.rational == 1 and made.periodic == (True, False) and made.degree == (3, 2)
    assert (made.weights == made.weights[:1]).all() and np.allclose(made.weights[0], profile.weights, rtol=1e-9)
    points = np.array([made.evaluate(u, v) for u in np.linspace(*made.domain[0], 9) for v in np.linspace(*made.domain[1], 9)])
    assert exact.nearest(points).distances.max() <= found.changed.error <= 1e-3


@pytest.mark.parametrize("value", (
    sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), (1, 1, 0), (2, 0, 0)]),                    # a parabola
    sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), (1, 1, 0), (2, 0, 0)], [1, 2, 1]),         # a hyperbola
    sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (1, 1, 0)]),
    sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0, 0), (1, 1, 0), (2, 1, 0), (3, 0, 0)]),
    sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0), (1, 1, 0), (2, 1, 1), (3, 0, 0), (4, 2, 2)], [1, 2, 3, 1, 1]),
    build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)),
))
def test_what_does_not_turn_is_refused(value):
    with pytest.raises(failures.Refusal, match="nothing would change"):
        deformed(value, 1e-3)


def test_what_is_deformable_is_refused_the_second_time():
    made, _ = deformed(build.torus((0, 0, 0), (0, 0, 1), 2.0, 0.5), 1e-3)
    with pytest.raises(failures.Refusal, match="nothing would change"):
        deformed(made, 1e-5)


def test_a_closed_cylinder_with_caps_stays_closed_and_what_would_part_is_refused():
    cylinder, low, high = (build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0), build.disc((0, 0, 0), (0, 0, 1), 1.0),
                           build.disc((0, 0, 2), (0, 0, 1), 1.0))
    whole = sc.PatchSet.from_patches([cylinder, low, high])
    assert build.open_ends([whole[i] for i in range(3)]) == []
    made, found = deformed(whole, 1e-4)
    assert found.count == 3 and build.open_ends([made[i] for i in range(3)]) == []


@pytest.mark.parametrize("kind", ("cylinder", "cone", "sphere", "torus"))
@pytest.mark.parametrize("more", ({}, {"sweep": 1.5}, {"start": 0.3, "sweep": -2.0}))
def test_primitives_have_it_as_a_parameter(kind, more):
    recipe = table.RECIPES[kind]
    exact = recipe.make((), **{**recipe.defaults, **more})
    made = recipe.make((), **{**recipe.defaults, **more, "deformable": True, "tolerance": 1e-4})
    assert exact.error == 0.0 and 0.0 < made.error <= 1e-4 and (made.definition.pool[:, 3] == 1.0).all()
    assert len(made.definition.pieces) == len(exact.definition.pieces)
    assert recipe.defaults["deformable"] is False
