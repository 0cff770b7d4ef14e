"""Discs whose areas are values of basis functions, and curves of the same points in other orders; of wild curves, too."""

from itertools import permutations

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

discs, orders = core("formulas.discs"), core("formulas.orders")
Refusal = core("base.failures").Refusal
RANDOM = np.random.default_rng(7)


def curves():
    weights = RANDOM.uniform(0.2, 4.0, 7)
    points = RANDOM.uniform(-3, 3, (7, 3))
    yield sc.BezierCurve(points, weights).to_nurbs()
    yield sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 2, 5, 5, 5, 5], points, weights)
    yield sc.NurbsCurve(3, np.cumsum(RANDOM.uniform(0.1, 2, 11)), points)
    yield sc.NurbsCurve(3, np.cumsum(RANDOM.uniform(0.1, 2, 8)), points, weights, periodic=True)
    yield sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3][:10], points)


@pytest.mark.parametrize('curve', curves())
def test_the_curve_is_the_mean_of_its_points_with_the_areas(curve):
    start, end = curve.domain
    for position in (0.0, 0.2, 0.5, 0.77, 1.0):
        u = min(start + position * (end - start), end)
        values = discs.shares(curve, u)
        assert values.sum() == pytest.approx(1.0, abs=1e-13) and (values >= 0).all()
        assert np.allclose(values @ curve.points, curve.evaluate([u], side='left' if u == end else 'right')[0], rtol=0, atol=1e-12)
        parts, warning = discs.picture(curve, position, 0.5)
        assert warning == "" and [part.name for part in parts[:-1]] == [f"N_{{{i},{curve.degree}}}" for i in range(len(curve.points))]
        for value, part, point in zip(values, parts, curve.points):
            if value > 1e-9:
                around = part.curve.evaluate(np.linspace(*part.curve.domain, 40)) - point
                radii = np.linalg.norm(around, axis=1)
                assert np.allclose(np.pi * radii ** 2, np.pi * 0.25 * value, rtol=1e-9)


def patches():
    points, weights = RANDOM.uniform(-3, 3, (6, 5, 3)), RANDOM.uniform(0.2, 4.0, (6, 5))
    yield sc.BezierPatch(points[:4, :3], weights[:4, :3]).to_nurbs()
    yield sc.NurbsPatch((3, 2), ([0, 0, 0, 0, 1, 1, 2, 2, 2, 2], [0, 0, 0, 1, 4, 5, 5, 5]), points, weights)
    yield sc.NurbsPatch((2, 3), (np.cumsum(RANDOM.uniform(0.1, 2, 9)), np.cumsum(RANDOM.uniform(0.1, 2, 9))), points)
    yield sc.NurbsPatch((2, 2), (range(7), range(6)), points, weights, (True, True))


@pytest.mark.parametrize('patch', patches())
def test_a_point_of_a_patch_is_the_mean_of_its_points_with_the_areas(patch):
    for position in ((0.0, 0.0), (0.2, 0.9), (0.5, 0.5), (1.0, 0.3), (1.0, 1.0)):
        u, v = (min(start + share * (end - start), end) for share, (start, end) in zip(position, patch.domain))
        values = discs.shares_of_patch(patch, u, v)
        assert values.shape == patch.points.shape[:2] and values.sum() == pytest.approx(1.0, abs=1e-13) and (values >= 0).all()
        sides = tuple('left' if at == end else 'right' for at, (_, end) in zip((u, v), patch.domain))
        places, normals = patch.evaluate_grid_with_normals([u], [v], side=sides)
        assert np.allclose(np.tensordot(values, patch.points, 2), places[0, 0], rtol=0, atol=1e-12)
        parts, warning = discs.picture_of_patch(patch, position, 0.5)
        assert warning == "" and len(parts) == values.size + 1
        for value, part, point in zip(values.ravel(), parts, patch.points.reshape(-1, 3)):
            if value > 1e-9:
                around = part.curve.evaluate(np.linspace(*part.curve.domain, 40)) - point
                assert np.allclose(np.linalg.norm(around, axis=1) ** 2, 0.25 * value, rtol=1e-9)
                assert np.allclose(around @ normals[0, 0], 0, atol=1e-12), "in the tangent plane"


def test_discs_of_a_patch_are_refused_where_they_are_too_many_and_told_where_they_are_not_numbers():
    with pytest.raises(Refusal, match="1200 functions: 1000 are the most"):
        discs.picture_of_patch(sc.NurbsPatch((1, 1), ([0, *range(30), 29], [0, *range(40), 39]), RANDOM.uniform(-1, 1, (30, 40, 3))), (0.5, 0.5), 1.0)
    points = np.dstack(np.meshgrid([0, 1, 2.0], [0, 1.0], [0.0], indexing='ij')).reshape(3, 2, 3)
    parts, warning = discs.picture_of_patch(sc.BezierPatch(points, [[1, 1], [-1, -1], [1, 1]]).to_nurbs(), (0.5, 0.5), 1.0)
    assert parts == [] and "at infinity" in warning
    parts, warning = discs.picture_of_patch(sc.BezierPatch(points, [[1, 1], [0, -0.5], [1, 1]]).to_nurbs(), (0.5, 0.5), 1.0)
    assert "P1,1 has -" in warning and "1 point at infinity has no circle" in warning


def test_bernstein_by_hand():
    values = discs.shares(sc.BezierCurve(np.eye(4)[:, :3]).to_nurbs(), 0.25)
    assert np.allclose(values, [27 / 64, 27 / 64, 9 / 64, 1 / 64], rtol=0, atol=1e-15)


def test_weights_below_0_and_points_at_infinity_are_told():
    points = np.array([(0, 0, 0), (1, 1, 0), (2, 0, 0)], float)
    parts, warning = discs.picture(sc.BezierCurve(points, [1, -0.2, 1]).to_nurbs(), 0.5, 1.0)
    assert "P1 has -0.25" in warning and len(parts) == 4
    parts, warning = discs.picture(sc.BezierCurve(points, [1, 0, 1]).to_nurbs(), 0.5, 1.0)
    assert warning == "1 point at infinity has no circle" and len(parts) == 3
    parts, warning = discs.picture(sc.BezierCurve(points, [1, -1, 1]).to_nurbs(), 0.5, 1.0)
    assert parts == [] and "at infinity" in warning


def test_24_orders_of_four_points_give_12_curves():
    curve = sc.BezierCurve(RANDOM.uniform(-1, 1, (4, 3))).to_nurbs()
    found = orders.all_of(curve)
    assert len(found) == 12 and found[0] == (0, 1, 2, 3)
    forms = {order: curve.with_points(curve.points[list(order)]).evaluate(np.linspace(0, 1, 9)) for order in permutations(range(4))}
    for order, places in forms.items():
        assert sum(np.allclose(places, forms[one]) or np.allclose(places[::-1], forms[one]) for one in found) == 1, order


def test_knots_without_symmetry_and_periodic_ones_have_all_orders():
    points = RANDOM.uniform(-1, 1, (4, 3))
    assert len(orders.all_of(sc.NurbsCurve(2, [0, 0, 0, 1, 5, 5, 5], points))) == 24
    assert len(orders.all_of(sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], points))) == 12
    assert len(orders.all_of(sc.NurbsCurve(2, range(5), points, periodic=True))) == 24


def test_points_keep_their_weights_and_curves_lie_beside_each_other():
    curve = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (4, 0, 0)], [1, 0.5, 2]).to_nurbs()
    parts = orders.picture(curve, [(0, 1, 2), (1, 0, 2), (0, 2, 1)], 2, False)
    assert [part.name for part in parts] == ["order 012", "order 102", "order 021"]
    assert np.allclose(parts[1].curve.points - (4 + 0.3 * 4, 0, 0), curve.points[[1, 0, 2]]) and np.array_equal(parts[1].curve.weights, [0.5, 1, 2])
    assert np.allclose(parts[2].curve.points[:, 1].min(), -2 - 0.3 * 4)
    assert np.array_equal(orders.picture(curve, [(2, 1, 0)], 0, True)[0].curve.points, curve.points[::-1])


def test_typed_orders():
    assert orders.typed("0 2 1 3; 1023,", 4) == [(0, 2, 1, 3), (1, 0, 2, 3)] and orders.typed("  ", 4) == []
    for text in ("0 1 2", "0 1 1 3", "0 1 2 4", "a b c d", "-1 0 1 2", "0 ² 1 3", "0²13"):
        with pytest.raises(Refusal, match="is not an order of the points 0 to 3"):
            orders.typed(text, 4)
    found = orders.all_of(sc.BezierCurve(RANDOM.uniform(-1, 1, (6, 3))).to_nurbs())
    assert len(found) == 6 and found[:2] == [(0, 1, 2, 3, 4, 5), (1, 0, 2, 3, 4, 5)]
