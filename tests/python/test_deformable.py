"""Circles and surfaces of revolution to be sculpted: as near to the exact ones as they say, smooth, and smooth when pulled; creases
inside patches are found."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build

deformable, definitions, failures, seams = core("deform.deformable"), core("shape.definition"), core("base.failures"), core("joints.seams")
table = core("recipes.table")
FULL = 2 * np.pi


@pytest.mark.parametrize("tolerance", (1e-2, 1e-3, 1e-4, 1e-6, 1e-8))
@pytest.mark.parametrize("radius", (1e-3, 1.0, 250.0))
def test_a_circle_is_as_near_as_it_says(radius, tolerance):
    curve, error = deformable.ellipse((1, 2, 3), (radius, 0, 0), (0, radius, 0), tolerance * radius)
    away = np.linalg.norm(curve.evaluate(np.linspace(*curve.domain, 20001)[:-1]) - (1, 2, 3), axis=1)
    assert error <= tolerance * radius and np.abs(away - radius).max() == pytest.approx(error, rel=1e-6, abs=1e-15)
    assert curve.periodic and (curve.weights == 1).all() and curve.degree == 3 and len(np.unique(curve.knots)) == len(curve.knots)
    assert np.abs(curve.evaluate(curve.domain[0]) - (1 + radius, 2, 3)).max() <= 1.001 * error


def test_an_ellipse_is_as_near_as_it_says():
    curve, error = deformable.ellipse((0, 0, 0), (3, 0, 0), (0, 0.2, 0.1), 1e-3)
    exact = sc.conics.ellipse((0, 0, 0), (3, 0, 0), (0, 0.2, 0.1), "single")
    points = curve.evaluate(np.linspace(*curve.domain, 501)[:-1])
    assert exact.nearest(points).distances.max() <= error * (1 + 1e-9) and error <= 1e-3


def profile(rng):
    degree = int(rng.integers(1, 6))
    count = degree + 1 + int(rng.integers(0, 4))
    knots = np.concatenate([[0.0] * (degree + 1), np.sort(rng.uniform(0.1, 0.9, count - degree - 1)), [1.0] * (degree + 1)])
    points = np.stack([rng.uniform(0.2, 2, count), rng.normal(0, 0.1, count), np.linspace(0, 3, count)], 1)
    return sc.NurbsCurve(degree, knots, points, rng.uniform(0.4, 2.5, count) if rng.random() < 0.5 else None)


def test_random_revolves_are_as_near_as_they_say_and_smooth(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng(seed)
        curve, through = profile(rng), rng.normal(size=3)
        direction = rng.normal(size=3) * 10 ** rng.uniform(-3, 3)
        start, sweep = rng.uniform(-4, 4), None if rng.random() < 0.5 else float(rng.uniform(0.05, FULL) * rng.choice([-1, 1]))
        tolerance = 10 ** rng.uniform(-5, -1)
        made, error = deformable.revolved(curve, through, direction, start, sweep, tolerance)
        exact = build.revolve(curve, through, direction, start, sweep)
        assert error <= tolerance and made.periodic[0] is (sweep is None) and made.degree[0] == 3
        assert made.domain[0] == pytest.approx(exact.domain[0]) or sweep is not None
        v = np.linspace(*exact.domain[1], 5)
        for share in (0.0, 0.37, 0.5, 1 - 1e-12):
            angle = start + share * (FULL if sweep is None else sweep)
            u = made.domain[0][0] + share * (made.domain[0][1] - made.domain[0][0])
            away = made.evaluate(np.full(5, u), v) - through
            unit = direction / np.linalg.norm(direction)
            own = curve.evaluate(curve.domain[0] + (curve.domain[1] - curve.domain[0]) * np.linspace(0, 1, 5)) - through
            heights, radii = own @ unit, np.linalg.norm(own - np.outer(own @ unit, unit), axis=1)
            assert np.abs(away @ unit - heights).max() <= 1e-11
            assert np.abs(np.linalg.norm(away - np.outer(away @ unit, unit), axis=1) - radii).max() <= error * (1 + 1e-9) + 1e-12
            if share in (0.0, 0.5):     # there it lies at the angle itself
                turned = _turned(own, unit, angle)
                assert np.abs(away - turned).max() <= error * (1 + 1e-9) + 1e-11
        inner = made.knots[0][4:-4] if sweep is not None else made.knots[0]
        assert len(np.unique(inner)) == len(inner)


def _turned(points, unit, angle):
    along = np.outer(points @ unit, unit)
    radial = points - along
    return along + np.cos(angle) * radial + np.sin(angle) * np.cross(unit, radial)


def test_it_runs_as_the_exact_one():
    curve = sc.BezierCurve([(1, 0, 0), (1.5, 0, 1), (0.5, 0, 2)])
    made, error = deformable.revolved(curve, (0, 0, 0), (0, 0, 2), 0.3, None, 1e-4)
    exact = build.revolve(curve, (0, 0, 0), (0, 0, 2), 0.3, None)
    for u in (0.1, 1.2, 3.3):
        assert np.cross(*made.derivatives(u, 0.4, 1)[[1, 0], [0, 1]]) @ np.cross(*exact.derivatives(u, 0.4, 1)[[1, 0], [0, 1]]) > 0


def test_what_would_take_too_many_points_is_refused():
    with pytest.raises(failures.Refusal, match="larger tolerance"):
        deformable.ellipse((0, 0, 0), (1, 0, 0), (0, 1, 0), 1e-14)


def pulled(patch, u, v):
    return patch.dragged(u, v, (0.4, 0.1, 0.2))


def surveyed(patch):
    return seams.surveyed(definitions.from_value(patch), 50)


def lathe():
    return sc.BezierCurve([(1, 0, 0), (1.5, 0, 1), (0.5, 0, 2), (1, 0, 3)])


def test_a_pull_creases_the_exact_one_and_is_listed_and_leaves_the_deformable_one_smooth():
    exact = build.revolve(lathe(), (0, 0, 0), (0, 0, 1), 0.0, None)
    before = surveyed(exact)
    assert before.joints == () and before.bendable == 4
    after = surveyed(pulled(exact, 0.9, 0.5))
    names = [joint.name for joint in after.joints]
    assert "crease u 1" in names and after.count == len(names) and after.count + after.bendable == 4
    assert all(joint.continuity.g == 0 and joint.sides == () for joint in after.joints)
    soft, _ = deformable.revolved(lathe(), (0, 0, 0), (0, 0, 1), 0.0, None, 1e-3)
    survey = surveyed(pulled(soft, 0.9, 0.5))
    assert survey.joints == () and survey.bendable == 0


def test_creases_inside_patches_of_a_set_have_the_number_of_the_patch():
    knots = [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], [0, 0, 1, 1]
    x = np.array([0, 1, 2, 3, 4, 5, 6.0])
    bent = np.stack([np.stack([x, 0 * x + y, np.maximum(x - 3, 0)], 1) for y in (0, 1)], 1)
    flat = bent * (1, 1, 0) + (0, 5, 0)
    survey = surveyed(sc.PatchSet.from_patches([sc.NurbsPatch((3, 1), knots, net.astype(float)) for net in (flat, bent)]))
    assert [joint.name for joint in survey.joints] == ["2 crease u 1"] and survey.bendable == 1
    assert np.degrees(survey.joints[0].continuity.angle) == pytest.approx(45)
    # what is measured along the crease lies on it
    line, = seams.lines_of(definitions.from_value(sc.PatchSet.from_patches([sc.NurbsPatch((3, 1), knots, bent.astype(float))])), 9)
    assert np.allclose(line.points[:, 0], 3)


def test_a_hole_inside_a_patch_is_a_gap():
    knots = [0, 0, 1, 1, 2, 2], [0, 0, 1, 1]
    net = np.array([[(x, y, 0.0) for y in (0, 1)] for x in (0, 1, 1.5, 2)])
    joint, = surveyed(sc.NurbsPatch((1, 1), knots, net)).joints
    assert joint.continuity.c == -1 and joint.continuity.gap == pytest.approx(0.5)


def test_the_recipes_are_exact_unless_asked():
    circle, revolve = table.RECIPES["circle"], table.RECIPES["revolve"]
    assert circle.defaults["form"] == "square" and revolve.defaults["deformable"] is False
    made = circle.make(circle.start, radius=2.0, form="deformable", tolerance=1e-3)
    assert 0 < made.error <= 1e-3 and made.value.periodic
    given = [definitions.from_value(lathe())]
    values = {**revolve.defaults, "deformable": True, "tolerance": 1e-4}
    made = revolve.make(given, **values)
    assert 0 < made.error <= 1e-4 and (made.value.weights == 1).all()
    assert revolve.make(given, **{**values, "deformable": False}).error == 0
