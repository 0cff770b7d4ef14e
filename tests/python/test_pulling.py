"""The tangent and the osculating circle of a curve are pulled: the handle goes where it is pulled to, what stays stays."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from random_curves import random_curve, random_curves

definitions, failures, pulling = core("shape.definition"), core("base.failures"), core("deform.pulling")
BY = np.array([0.3, -0.5, 0.7])


def middle(curve):
    start, end = curve.domain
    return start + 0.37 * (end - start)


def curvature(curve, u):
    _, velocity, acceleration = curve.derivatives(u, 2)
    speed = np.linalg.norm(velocity)
    return (acceleration - (acceleration @ velocity) * velocity / speed**2) / speed**2


def pulled(curve, u, by, handle):
    return definitions.to_value(pulling.pulled(definitions.from_value(curve), 0, (u,), by, handle=handle))


def curves():
    """Of degree 2 to 9, rational, periodic, unclamped and with multiple knots."""
    return [curve for curve in random_curves(41, 200, positive=True) if curve.degree > 1 and len(curve.points) > 3]


def test_the_tangent_goes_along_and_the_point_stays():
    count = 0
    for curve in curves():
        u, size = middle(curve), 10 + np.abs(curve.points).max()
        try:
            after = pulled(curve, u, BY, 'TANGENT')
        except sc.InvalidShape as error:
            assert "too few" in str(error)
            continue
        size = max(size, np.abs(after.points).max())
        assert np.abs(after.evaluate(u) - curve.evaluate(u)).max() < 1e-10 * size
        assert np.abs(pulling.handle_at(after, u, 'TANGENT') - pulling.handle_at(curve, u, 'TANGENT') - BY).max() < 1e-9 * size
        count += 1
    assert count > 100


def test_the_circle_goes_through_where_it_was_pulled_to():
    count = 0
    for curve in curves():
        u = middle(curve)
        try:
            after = pulled(curve, u, BY, 'CIRCLE')
        except sc.InvalidShape as error:
            assert "too few" in str(error)
            continue
        size = 10 + np.abs(after.points).max()
        place, velocity = curve.derivatives(u, 1)
        assert np.abs(after.derivatives(u, 1) - (place, velocity)).max() < 1e-9 * size * max(1, np.abs(velocity).max())
        bend = curvature(after, u)
        chord = pulling.handle_at(curve, u, 'CIRCLE') + BY - place
        away = np.linalg.norm(chord - bend / (bend @ bend)) * np.linalg.norm(bend)     # from the middle, in radii
        assert abs(away - 1) < 1e-6 * max(1.0, 1 / np.linalg.norm(bend) / np.linalg.norm(chord)), (away, curve)
        count += 1
    assert count > 80


def test_at_the_ends_of_a_cubic_the_tangent_is_its_handle():
    points = np.array([[0, 0, 0], [1, 2, 0], [3, 2, 1], [4, 0, 0.0]])
    for curve in (sc.BezierCurve(points), sc.NurbsCurve(3, [0, 0, 0, 0, 3, 3, 3, 3.0], points)):
        assert np.allclose(pulling.handle_at(curve, curve.domain[0], 'TANGENT'), points[1])
        after = pulled(curve, curve.domain[0], BY, 'TANGENT')
        assert np.allclose(after.points, points + np.outer([0, 1, 0, 0], BY))
        end = curve.domain[1]
        assert np.allclose(pulled(curve, end, BY, 'TANGENT').points, points - np.outer([0, 0, 1, 0], BY))
        third = pulled(curve, curve.domain[0], BY, 'CIRCLE').points - points
        assert np.allclose(third[[0, 1, 3]], 0) and np.abs(third[2]).max() > 0.1
    chain = sc.HermiteCurve(points, np.ones((4, 2, 3)), [0, 1, 2, 3.0])
    assert np.allclose(pulled(chain, 0.0, BY, 'TANGENT').derivatives(0.0, 1)[1], chain.derivatives(0.0, 1)[1] + 3 * BY)


@pytest.mark.parametrize('size', (1e-140, 1e-9, 1e9, 1e140))
@pytest.mark.parametrize('handle', ('TANGENT', 'CIRCLE'))
def test_at_any_size(handle, size):
    for degree in range(2, 10):
        base = random_curve(np.random.default_rng(degree), degree=degree, spans=6, positive=True)
        u = middle(base)
        scaled = base.with_points(base.points * size)
        plain, after = pulled(base, u, BY, handle), pulled(scaled, u, BY * size, handle)
        assert np.allclose(after.points / size, plain.points, rtol=0, atol=1e-8 * np.abs(plain.points).max())


def test_a_line_has_a_straight_circle_that_can_be_bent():
    line = sc.BezierCurve(np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0.0]]))
    shown = pulling.drawn(line, 0.5, 'CIRCLE')
    assert np.isfinite(shown).all() and not shown[..., 1:].any()
    after = pulled(line, 0.5, (0, 0.25, 0), 'CIRCLE')
    chord = pulling.handle_at(line, 0.5, 'CIRCLE') + (0, 0.25, 0) - line.evaluate(0.5)
    assert np.allclose(curvature(after, 0.5), 2 * chord * (0, 1, 0) / (chord @ chord))
    around = pulling.drawn(after, 0.5, 'CIRCLE')
    middle_of_it = after.evaluate(0.5) + curvature(after, 0.5) / np.linalg.norm(curvature(after, 0.5))**2
    radii = np.linalg.norm(around - middle_of_it, axis=-1)
    assert np.allclose(radii, radii[0, 0]) and np.allclose(around[0, 0], around[-1, 1])


def test_what_cannot_be_pulled_is_refused():
    still = sc.BezierCurve(np.zeros((4, 3)))
    with pytest.raises(failures.Refusal, match="no direction"):
        pulled(still, 0.5, BY, 'CIRCLE')
    segment = sc.BezierCurve(np.array([[0, 0, 0], [1, 0, 0.0]]))
    with pytest.raises(sc.InvalidShape, match="too few"):
        pulled(segment, 0.5, BY, 'CIRCLE')
    line = sc.BezierCurve(np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0.0]]))
    back = line.evaluate(0.5) - pulling.handle_at(line, 0.5, 'CIRCLE')
    with pytest.raises(failures.Refusal, match="twice"):
        pulled(line, 0.5, back, 'CIRCLE')
