"""What holds for every curve, on examples that Hypothesis invents."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import coordinates, inside, nurbs_curves, point_lists, positive, size_of

fractions = st.floats(0.02, 0.98)


def gap(one, other, shape):
    return np.abs(one - other).max() / size_of(shape)


def within(domain, fraction):
    start, end = domain
    return start + fraction * (end - start)


@given(nurbs_curves())
def test_every_point_lies_in_the_box_of_the_points_of_its_span(curve):
    knots, degree = curve.knots, curve.degree
    slack = 1e-13 * size_of(curve)
    for u in inside(curve.domain, 17):
        span = int(curve.knot_vector.span(u))
        near = curve.points[span - degree:span + 1]
        point = curve.evaluate(u)
        assert knots[span] <= u <= knots[span + 1]
        assert (near.min(axis=0) - slack <= point).all() and (point <= near.max(axis=0) + slack).all()


@given(point_lists(3, 8), st.tuples(coordinates, coordinates, coordinates), fractions)
def test_every_point_lies_on_the_right_side_of_every_plane(points, normal, t):
    curve = sc.BezierCurve(points)
    heights = curve.points @ np.array(normal)
    height = curve.evaluate(t) @ np.array(normal)
    slack = 1e-12 * max(1.0, np.abs(heights).max(), np.linalg.norm(normal) * size_of(curve))
    assert heights.min() - slack <= height <= heights.max() + slack


@given(nurbs_curves(), st.integers(0, 2**32))
def test_affine_maps_of_points_are_affine_maps_of_the_curve(curve, seed):
    rng = np.random.default_rng(seed)
    matrix, shift = rng.uniform(-1, 1, (3, 3)), rng.uniform(-10, 10, 3)
    u = inside(curve.domain)
    moved = curve.with_points(curve.points @ matrix.T + shift)
    assert gap(moved.evaluate(u), curve.evaluate(u) @ matrix.T + shift, curve) <= 1e-12


@given(nurbs_curves())
def test_functions_are_not_negative_and_add_up_to_one(curve):
    values = curve.knot_vector.functions(inside(curve.domain, 50))
    assert (values >= 0).all()
    assert np.abs(values.sum(axis=-1) - 1).max() <= 1e-14


@given(point_lists(), st.data())
def test_clamped_curves_start_and_end_in_their_end_points(points, data):
    count = len(points)
    degree = data.draw(st.integers(1, count - 1))
    weights = data.draw(st.lists(positive, min_size=count, max_size=count))
    inner = sorted(data.draw(st.lists(fractions, min_size=count - degree - 1, max_size=count - degree - 1, unique=True)))
    curve = sc.NurbsCurve(degree, [0] * (degree + 1) + inner + [1] * (degree + 1), points, weights)
    ends = curve.evaluate([0, 1])
    assert gap(ends, curve.points[[0, -1]], curve) <= 1e-15


@given(nurbs_curves())
def test_the_reversed_curve_runs_the_other_way(curve):
    start, end = curve.domain
    u = inside(curve.domain)
    turned = curve.reversed()
    assert turned.domain == curve.domain
    assert gap(turned.evaluate(start + (end - u)), curve.evaluate(u), curve) <= 1e-11
    assert gap(turned.reversed().points, curve.points, curve) == 0


@given(nurbs_curves(), positive)
def test_scaling_all_weights_changes_nothing(curve, factor):
    u = inside(curve.domain)
    scaled = curve.with_weights(curve.weights * factor)
    assert gap(scaled.evaluate(u), curve.evaluate(u), curve) <= 1e-12


@given(nurbs_curves(), st.lists(fractions, min_size=1, max_size=5, unique=True), st.integers(1, 3))
def test_a_sheet_over_a_curve_has_the_points_of_the_curve(curve, at, times):
    """The verbs of patches go through matrices, those of plain curves do not."""
    def sheet():
        net, weights = np.stack([curve.points] * 2, axis=1), np.stack([curve.weights] * 2, axis=1)
        return sc.NurbsPatch((curve.degree, 1), (curve.knots, [0, 0, 1, 1]), net, weights)

    inserted = [within(curve.domain, fraction) for fraction in at]
    for made, over in ((curve.elevate(times), sheet().elevate("u", times)),
                       (curve.refine(inserted), sheet().refine("u", inserted))):
        assert made.knots.tolist() == over.knots[0].tolist()
        assert np.abs(made.points - over.points[:, 0]).max() <= 4e-15 * size_of(curve)
        assert np.abs(made.weights / over.weights[:, 0] - 1).max() <= 4e-15


@given(nurbs_curves(), st.integers(1, 3))
def test_elevating_keeps_every_digit_of_the_ends(curve, times):
    whole = curve.clamped()
    raised = whole.elevate(times)
    for end in (0, -1):
        assert raised.points[end].tolist() == whole.points[end].tolist()
        assert raised.weights[end] == whole.weights[end]


@given(nurbs_curves(), st.lists(fractions, min_size=1, max_size=5, unique=True))
def test_refining_keeps_the_curve(curve, at):
    refined = curve.refine([within(curve.domain, fraction) for fraction in at])
    assert len(refined.points) == len(curve.points) + len(at)
    u = inside(curve.domain)
    assert gap(refined.evaluate(u), curve.evaluate(u), curve) <= 1e-12


@given(nurbs_curves(), fractions)
def test_splitting_keeps_the_curve(curve, at):
    middle = within(curve.domain, at)
    for part in curve.split(middle):
        u = inside(part.domain)
        side = "left" if part.domain[1] == middle else "right"
        assert gap(part.evaluate(u, side=side), curve.evaluate(u, side=side), curve) <= 1e-12


@given(nurbs_curves())
def test_bezier_pieces_are_the_curve_span_by_span(curve):
    knots = np.unique(curve.knots)
    start, end = curve.domain
    spans = knots[(knots >= start) & (knots <= end)]
    pieces = curve.to_bezier()
    assert len(pieces) == len(spans) - 1
    t = np.linspace(0, 1, 9)[1:-1]
    for piece, low, high in zip(pieces, spans, spans[1:]):
        assert gap(piece.evaluate(t), curve.evaluate(low + t * (high - low)), curve) <= 1e-12


@given(nurbs_curves(rational=False), fractions)
def test_the_derivative_is_the_limit_of_differences(curve, at):
    u = within(curve.domain, at)
    shortest = np.diff(np.unique(curve.knots)).min()
    step = 1e-5 * shortest
    start, end = curve.domain
    if u - step < start or u + step > end:
        return
    around = curve.evaluate([u - step, u + step])
    slope = curve.derivatives(u, 1)[1]
    if np.any(np.abs(curve.knots - u) <= step):
        return
    scale = max(1.0, np.abs(curve.derivatives(u, 3)[1:]).max(), size_of(curve) / shortest)
    assert np.abs((around[1] - around[0]) / (2 * step) - slope).max() <= 1e-4 * scale


@given(nurbs_curves(), st.permutations(range(12)))
def test_results_are_the_same_bits_in_any_batch_and_order(curve, order):
    u = inside(curve.domain, 12)
    together = curve.evaluate(u)
    assert np.array_equal(together[list(order)], curve.evaluate(u[list(order)]))
    assert np.array_equal(together, [curve.evaluate(one) for one in u])
    slopes = curve.derivatives(u, 2)
    assert np.array_equal(slopes, [curve.derivatives(one, 2) for one in u])


@given(nurbs_curves())
def test_json_and_pickle_give_back_every_bit(curve):
    import pickle

    for again in (sc.loads(curve.dumps()), sc.loads(sc.dumps(curve)), pickle.loads(pickle.dumps(curve))):
        assert again == curve and hash(again) == hash(curve)
        for name in ("knots", "points", "weights"):
            assert getattr(again, name).tobytes() == getattr(curve, name).tobytes()


@pytest.mark.parametrize('seed', range(40))
def test_the_nearest_curve_of_fewer_knots_or_a_lower_degree_stays_near_where_knots_are_full(seed):
    """Once errors of 1e18 and points that are no numbers came out: steps along rounding grew without end."""
    random = np.random.default_rng(seed)
    chain = sc.HermiteCurve(random.uniform(-1, 1, (4, 3)), random.uniform(-1, 1, (4, 3)), [0, 0.1, 1 / 3, 2])
    curve = chain.to_nurbs()
    size = np.ptp(curve.points, axis=0).max()
    assert curve.remove_knots(0.5).error <= 0.5
    assert curve.reduce().error < 2 * size
    assert curve.elevate().reduce().error < 1e-13
