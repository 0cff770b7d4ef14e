"""KnotVector and Samples: the lectures' worked numbers and the sums of functions (row S14)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import circle, closed_cubic, cubic, inside, nurbs_curves, wavy_patch

KnotVector, Samples = sc.basis.KnotVector, sc.basis.Samples


def test_linear_functions_on_0_1_2_3_are_the_lectures():
    knots = KnotVector(1, [0, 1, 2, 3])
    u = np.array([-1, 0, 0.25, 1, 1.75, 2, 2.5, 3, 4])
    first = np.select([(u >= 0) & (u < 1), (u >= 1) & (u < 2)], [u, 2 - u], 0)
    second = np.select([(u >= 1) & (u < 2), (u >= 2) & (u < 3)], [u - 1, 3 - u], 0)
    assert knots.function(0, u).tolist() == first.tolist()
    assert knots.function(1, u).tolist() == second.tolist()


def test_the_quadratic_function_on_0_1_2_3_is_the_lectures_although_it_has_no_domain():
    knots = KnotVector(2, [0, 1, 2, 3])
    u = np.linspace(-0.5, 3.5, 65)
    pieces = [u**2 / 2, -u**2 + 3 * u - 1.5, (3 - u) ** 2 / 2]
    expected = np.select([(u >= 0) & (u < 1), (u >= 1) & (u < 2), (u >= 2) & (u < 3)], pieces, 0)
    assert np.abs(knots.function(0, u) - expected).max() <= 2e-16
    assert knots.support(0) == (0, 3)
    with pytest.raises(sc.InvalidShape, match="no domain"):
        knots.domain
    with pytest.raises(sc.InvalidShape, match="no domain"):
        knots.functions(1.5)


def test_degree_zero_is_steps():
    knots = KnotVector(0, [0, 1, 3])
    assert knots.functions([0, 0.5, 1, 3]).tolist() == [[1, 0], [1, 0], [0, 1], [0, 1]]
    assert knots.functions(1, side="left").tolist() == [1, 0]
    assert knots.count == 2 and knots.domain == (0, 3)


@given(nurbs_curves())
def test_functions_are_the_recursion_of_cox_and_de_boor(curve):
    knots = curve.knot_vector
    u = inside(curve.domain, 21)
    table = np.stack([knots.function(i, u) for i in range(knots.count)], axis=-1)
    assert np.abs(table - knots.functions(u)).max() <= 1e-13


@given(nurbs_curves(), st.integers(0, 100))
def test_a_function_is_zero_outside_its_support(curve, which):
    knots = curve.knot_vector
    i = which % knots.count
    start, end = knots.support(i)
    assert (start, end) == (curve.knots[i], curve.knots[i + curve.degree + 1])
    values = knots.function(i, [start - 1, np.nextafter(start, -np.inf), end + 1])
    assert (values == 0).all()


def test_spans_hold_their_parameters():
    knots = cubic().knot_vector
    u = inside(knots.domain, 50)
    span = knots.span(u)
    assert span.dtype == np.int64
    assert (knots.knots[span] <= u).all() and (u[:-1] < knots.knots[span + 1][:-1]).all()
    assert knots.span(1.0) == 5 and knots.span(1.0, side="left") == 3
    assert knots.span([[0.5]]).shape == (1, 1)


def test_multiplicity_counts_equal_knots_only():
    knots = cubic().knot_vector
    assert [knots.multiplicity(u) for u in (1.0, 2.5, 0.7, np.nextafter(1.0, 2))] == [2, 1, 0, 0]


def test_periodic_functions_add_up_to_one_and_repeat():
    knots = closed_cubic().knot_vector
    u = np.linspace(0, 6, 31)
    values = knots.functions(u)
    assert values.shape == (31, 5) and np.abs(values.sum(axis=1) - 1).max() <= 1e-15
    assert np.array_equal(values[0], knots.functions(6.0)) and knots.periodic and knots.count == 5
    assert np.abs(values[:, 2] - knots.function(2, u)).max() <= 1e-16


@pytest.mark.parametrize("curve", [cubic(), closed_cubic()])
def test_samples_applied_to_homogeneous_points_are_the_curve(curve):
    u = inside(curve.domain, 20)
    samples = Samples(curve.knot_vector, u, 2)
    rows = samples.apply(curve.homogeneous_points)
    assert np.abs(rows[:, :3] / rows[:, 3:] - curve.evaluate(u)).max() <= 4e-15
    weights = samples.weights()
    count = len(curve.points)
    by_hand = sum(weights[:, j, None] * curve.homogeneous_points[(samples.first + j) % count] for j in range(4))
    assert np.abs(by_hand - rows).max() <= 1e-15 and len(samples) == 20
    assert np.abs(weights.sum(axis=1) - 1).max() <= 1e-15
    assert np.abs(samples.weights(1).sum(axis=1)).max() <= 1e-13


def test_samples_apply_to_rows_of_any_shape():
    samples = Samples(circle().knot_vector, [0.5, 1.5], order=1, side="left")
    colors = np.random.default_rng(0).random((9, 2, 4))
    assert samples.apply(colors).shape == (2, 2, 4) and samples.apply(np.ones(9)).tolist() == [1, 1]
    assert np.abs(samples.apply(colors[:, 0, 0], 1)).shape == (2,)
    assert Samples(circle().knot_vector, []).apply(np.ones((9, 3))).shape == (0, 3)
    assert Samples(circle().knot_vector, []).weights().shape == (0, 3)


def test_samples_of_both_directions_make_a_grid():
    patch = wavy_patch()
    u, v = np.linspace(0, 2, 6), np.linspace(0, 5, 7)
    rows = Samples(patch.knot_vectors[0], u).apply(patch.homogeneous_points)
    grid = Samples(patch.knot_vectors[1], v).apply(rows.swapaxes(0, 1)).swapaxes(0, 1)
    assert np.abs(grid[..., :3] / grid[..., 3:] - patch.evaluate_grid(u, v)).max() <= 4e-15


@pytest.mark.parametrize("call, error, words", [
    (lambda: KnotVector(1, [0, 1, 2]).function(5, 0), sc.InvalidShape, "i = 5"),
    (lambda: KnotVector(1, [0, 1, 2]).function(-1, 0), sc.InvalidShape, "i = -1"),
    (lambda: KnotVector(1, [0, 1, 2]).function(0, [0, np.nan]), sc.InvalidShape, r"u\[1\] = nan"),
    (lambda: KnotVector(1, [0, 1, 2]).support(2**40), sc.InvalidShape, "i = 1099511627776"),
    (lambda: KnotVector(-1, [0, 1]), sc.InvalidShape, "degree = -1"),
    (lambda: circle().knot_vector.functions([[1, 7]]), sc.InvalidShape, r"u\[0, 1\] = 7"),
    (lambda: circle().knot_vector.span([1, -7]), sc.InvalidShape, r"u\[1\] = -7"),
    (lambda: circle().knot_vector.multiplicity("1"), TypeError, "u = '1'"),
    (lambda: circle().knot_vector.multiplicity([1, 2]), TypeError, r"u must be one number"),
    (lambda: Samples(circle().knot_vector, [9]), sc.InvalidShape, r"u\[0\] = 9"),
    (lambda: Samples(circle().knot_vector, [[1]]), sc.InvalidShape, r"u has shape \(1, 1\)"),
    (lambda: Samples(circle().knot_vector, [1], -1), sc.InvalidShape, "order = -1"),
    (lambda: Samples(circle().knot_vector, [1], 2**31 - 1), sc.InvalidShape, "order = 2147483647"),
    (lambda: Samples(circle().knot_vector, [1]).weights(1), sc.InvalidShape, "order = 1"),
    (lambda: Samples(circle().knot_vector, [1]).apply(np.ones(8)), sc.InvalidShape, r"values has shape \(8,\), 9"),
    (lambda: Samples(circle().knot_vector, [1]).apply(3.0), sc.InvalidShape, r"values has shape \(\)"),
    (lambda: Samples([0, 1], [1]), TypeError, "knots must be a KnotVector, not list"),
])
def test_bad_arguments_are_named(call, error, words):
    with pytest.raises(error, match=words):
        call()
