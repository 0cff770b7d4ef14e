"""The conic of any curve: those in other forms, in space, at every size; and what only looks like one."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import conics


def forms(curve):
    """The same curve otherwise."""
    curve = curve.to_nurbs()
    yield curve
    yield curve.elevate(1)
    yield curve.elevate(4)
    start, end = curve.domain
    yield curve.insert_knot(start + 0.3 * (end - start)).insert_knot(start + 0.7 * (end - start), 2)
    yield curve.reversed()


MADE = [
    ("circle", conics.circle((1, 2, 0), 2.0)), ("circle", conics.circle((0, 0, 0), 2.0, form='single')),
    ("circle", conics.circle((1, 2, 3), 2.0, (1, 2, 3), form='triangle')), ("ellipse", conics.ellipse((0, 1, 0), (3, 1, 0), (0, 0, 1))),
    ("hyperbola", conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 2, 0))[0]),
    ("parabola", conics.from_implicit(conics.ImplicitConic([1, 0, 0, 0, -4, 0]))[0]),
    ("parabola", sc.BezierCurve([(0, 0, 0), (1, 2, 0), (2, 0, 0)])), ("circle", conics.arc_through((1, 0), (0.8, 0.6), (0, 1)))]


@pytest.mark.parametrize("kind, curve", MADE, ids=lambda one: one if isinstance(one, str) else "")
@pytest.mark.parametrize("size", (1e-60, 1e-6, 1.0, 1e6, 1e60))
def test_a_conic_is_known_in_every_form(kind, curve, size):
    for form in forms(curve):
        form = form.scaled(size)
        found = conics.implicit(form)
        if kind != "parabola":          # of rounded points a parabola may be a very long ellipse
            assert found.type in (kind, "ellipse")
        points = form.evaluate(np.linspace(*form.domain, 50)[1:-1], at_infinity='nan')
        points = points[np.isfinite(points).all(1)] - found.origin
        x, y = points @ found.x_axis, points @ found.y_axis
        terms = found.coefficients * np.stack([x * x, x * y, y * y, x, y, np.ones_like(x)], -1)
        assert (np.abs(terms.sum(1)) <= 1e-8 * np.abs(terms).sum(1)).all()


def test_curves_of_any_class_are_taken():
    bezier = conics.conic_arc((1, 0, 0), (1, 1, 0), (0, 1, 0), np.sqrt(0.5))
    assert conics.implicit(bezier) == conics.implicit(bezier.to_nurbs())
    parabola = sc.BezierCurve([(0, 0), (1, 2), (2, 0)])
    for form in (parabola.to_hermite(), parabola.to_power()[0] if isinstance(parabola.to_power(), list) else parabola.to_power()):
        assert conics.implicit(form).type == "parabola"


def test_what_is_no_conic_is_refused(inputs):
    with pytest.raises(sc.InvalidShape, match="no conic|line"):
        conics.implicit(sc.BezierCurve([(0, 0), (1, 2), (2, -1), (3, 0)]))
    for straight in ([(0, 0), (1, 1)], [(0, 0), (1, 1), (2, 2), (5, 5)]):
        with pytest.raises(sc.InvalidShape):
            conics.implicit(sc.BezierCurve(straight))
    circle = conics.circle((0, 0, 0), 1.0).elevate(1)
    for seed in range(inputs(200)):
        rng = np.random.default_rng(seed)
        moved = circle.points.copy()
        moved[rng.integers(len(moved))] += 10.0**rng.uniform(-6, 0) * rng.normal(size=3)
        with pytest.raises(sc.InvalidShape):
            conics.implicit(circle.with_points(moved))
        one_span_off = np.concatenate([np.zeros((8, 3)), 1e-6 * rng.normal(size=(len(moved) - 8, 3))])
        with pytest.raises(sc.InvalidShape):
            conics.implicit(circle.with_points(circle.points + one_span_off))


def test_what_is_no_curve_is_refused():
    with pytest.raises(sc.InvalidShape, match="a curve is expected"):
        conics.implicit(sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)))
