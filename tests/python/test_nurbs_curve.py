"""NurbsCurve: closed forms, and changes that keep the curve (rows S11, S15)."""

import numpy as np
import pytest

import splinecore as sc
from shapes import CIRCLE_KNOTS, SQUARE, SQUARE_WEIGHTS, circle, closed_cubic, cubic, inside


def test_circle_has_radius_one_everywhere():
    points = circle().evaluate(np.linspace(0, 4, 1001))
    assert np.abs(np.hypot(points[:, 0], points[:, 1]) - 1).max() <= 4e-16
    assert (points[:, 2] == 0).all()


def test_derivative_of_the_circle_is_across_its_radius():
    values = circle().derivatives(np.linspace(0, 4, 101), 2)
    assert np.abs((values[:, 0] * values[:, 1]).sum(axis=1)).max() <= 2e-15
    # On a circle of radius one |C'|² + C · C'' = 0.
    assert np.abs((values[:, 1] ** 2).sum(1) + (values[:, 0] * values[:, 2]).sum(1)).max() <= 4e-15


def test_parabola_is_its_formula():
    u = np.linspace(-1, 1, 101)
    parabola = sc.NurbsCurve(2, [-1, -1, -1, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
    assert np.abs(parabola.evaluate(u) - np.stack([u, u * u, 0 * u], axis=1)).max() <= 3e-16
    derivatives = parabola.derivatives(u, 3)
    assert np.abs(derivatives[:, 1] - np.stack([1 + 0 * u, 2 * u, 0 * u], axis=1)).max() <= 1e-15
    assert np.abs(derivatives[:, 2] - (0, 2, 0)).max() <= 1e-15
    assert (derivatives[:, 3] == 0).all()


def test_uniform_cubic_has_the_lectures_matrix():
    points = np.array([(0, 0, 0), (1, 2, 0), (3, 1, 1), (4, 4, 2)], float)
    curve = sc.NurbsCurve(3, range(8), points)
    t = np.linspace(0, 1, 11)
    matrix = np.array([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 0, 3, 0], [1, 4, 1, 0]]) / 6
    expected = np.stack([t**3, t**2, t, np.ones(11)], axis=1) @ matrix @ points
    assert np.abs(curve.evaluate(3 + t) - expected).max() <= 4e-15


def test_homogeneous_points_are_weights_times_points():
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0), (0, 1), (-1, 0)], [2, 0, 4])
    assert curve.homogeneous_points.tolist() == [[2, 0, 0, 2], [0, 1, 0, 0], [-4, 0, 0, 4]]
    again = sc.NurbsCurve.from_homogeneous(2, curve.knots, curve.homogeneous_points)
    assert again == curve
    assert not curve.homogeneous_points.flags.writeable


def test_from_homogeneous_takes_periodic_curves():
    curve = closed_cubic()
    assert sc.NurbsCurve.from_homogeneous(3, curve.knots, curve.homogeneous_points, periodic=True) == curve


@pytest.mark.parametrize("curve", [circle(), cubic(), closed_cubic()])
def test_inserted_knots_keep_the_curve(curve):
    u = inside(curve.domain, 200)
    start, end = curve.domain
    inserted = curve.insert_knot(start + 0.3 * (end - start), 2)
    refined = curve.refine(np.linspace(start, end, 9)[1:-1])
    assert len(inserted.points) == len(curve.points) + 2
    assert len(refined.points) == len(curve.points) + 7
    for other in (inserted, refined):
        assert np.abs(other.evaluate(u) - curve.evaluate(u)).max() <= 1e-14


def test_points_far_from_an_inserted_knot_keep_every_bit():
    curve = sc.NurbsCurve(2, range(13), np.random.default_rng(1).normal(size=(10, 3)), np.linspace(0.3, 3, 10))
    inserted = curve.insert_knot(2.1)
    assert inserted.points[3:].tolist() == curve.points[2:].tolist()
    assert inserted.points[0].tolist() == curve.points[0].tolist()


@pytest.mark.parametrize("curve", [circle(), cubic()])
def test_split_gives_the_parts_on_their_parts_of_the_domain(curve):
    start, end = curve.domain
    middle = start + 0.4 * (end - start)
    before, after = curve.split(middle)
    assert before.domain == (start, middle) and after.domain == (middle, end)
    for part in (before, after):
        u = inside(part.domain)
        assert np.abs(part.evaluate(u) - curve.evaluate(u)).max() <= 2e-15


def test_split_of_a_periodic_curve_opens_it():
    curve = closed_cubic()
    (opened,) = curve.split(1.7)
    assert opened.domain == (1.7, 7.7) and not opened.periodic
    u = np.linspace(1.7, 7.7, 50)
    assert np.abs(opened.evaluate(u) - curve.evaluate(u)).max() <= 1e-14


def test_periodic_parameters_count_modulo_the_period():
    curve = closed_cubic()
    u = np.array([0.25, 1.5, 5.75])
    for turns in (-12, 6, 600):
        for of in (curve.evaluate, curve.curvature, curve.frames, lambda at: curve.derivatives(at, 2)):
            assert np.array_equal(of(u), of(u + turns))
        assert curve.continuity(1.0 + turns).g == curve.continuity(1.0).g
        assert curve.insert_knot(1.5 + turns) == curve.insert_knot(1.5)
    assert np.abs(curve.evaluate(0.0) - curve.evaluate(6.0, side="left")).max() <= 1e-15


def test_unrolled_is_a_plain_curve_of_the_same_points():
    curve = closed_cubic()
    plain = curve.unrolled()
    assert curve.periodic and not plain.periodic
    assert len(plain.points) == len(curve.points) + 3
    u = np.linspace(0, 6, 100)
    assert np.array_equal(plain.evaluate(u), curve.evaluate(u))
    assert cubic().unrolled() == cubic()


def test_other_points_and_weights_share_the_knots():
    curve = circle()
    moved = curve.with_points(curve.points + 1)
    assert moved.knot_vector == curve.knot_vector and (moved.weights == curve.weights).all()
    assert (moved.points == curve.points + 1).all()
    flat = curve.with_weights(np.ones(9))
    assert not flat.is_rational and curve.is_rational
    assert (flat.points == curve.points).all()


def test_properties_are_what_was_given():
    curve = circle()
    assert curve.degree == 2 and curve.domain == (0.0, 4.0) and not curve.periodic
    assert curve.knots.tolist() == CIRCLE_KNOTS
    assert curve.points[:, :2].tolist() == [list(point) for point in SQUARE]
    assert curve.weights.tolist() == SQUARE_WEIGHTS
    assert curve.to_nurbs() == curve


def test_a_gap_is_a_jump_with_two_sides():
    curve = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (5, 5), (6, 5)])
    assert curve.evaluate(1).tolist() == [5, 5, 0]
    assert curve.evaluate(1, side="left").tolist() == [1, 0, 0]
    assert curve.evaluate(2).tolist() == [6, 5, 0]
    assert curve.pieces() == [(0, 1), (1, 2)]
    assert [points.tolist() for points, _ in curve.polylines(1)] == [[[0, 0, 0], [1, 0, 0]], [[5, 5, 0], [6, 5, 0]]]


def test_polylines_of_closed_curves_do_not_repeat_the_start():
    ((points, closed),) = circle().polylines(8)
    assert closed and points.shape == (32, 3)
    ((points, closed),) = cubic().polylines(5)
    assert not closed and np.array_equal(points[-1], cubic().evaluate(cubic().domain[1]))


def test_a_uniform_cubic_of_lectures_knots_becomes_a_hermite_chain():
    curve = sc.NurbsCurve(3, range(9), np.random.default_rng(2).normal(size=(5, 3)))
    chain = curve.to_hermite()
    u = np.linspace(3, 5, 41)
    assert np.abs(chain.evaluate(u) - curve.evaluate(u)).max() <= 4e-15
    with pytest.raises(sc.InvalidShape, match="weights"):
        circle().to_hermite()


def test_the_bezier_pieces_keep_the_points_that_they_share_with_the_curve_bit_for_bit():
    rng = np.random.default_rng(8)
    points, weights = rng.uniform(-1, 1, (7, 3)), rng.uniform(0.5, 2, 7)
    first, last = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], points, weights).to_bezier()
    assert np.array_equal(first.points, points[:4]) and np.array_equal(last.points, points[3:])
    net, net_weights = rng.uniform(-1, 1, (3, 4, 3)), rng.uniform(0.5, 2, (3, 4))
    patch = sc.BezierPatch(net, net_weights)
    assert patch.to_nurbs().to_bezier() == [[patch]]
