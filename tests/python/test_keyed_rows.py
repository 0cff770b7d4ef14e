"""Which row is which after a verb, and what rows take of what Blender gives."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

definitions, failures, keyed_rows = core("shape.definition"), core("base.failures"), core("shape.keyed_rows")
RANDOM = np.random.default_rng(5)


def curve(count=6, degree=2):
    knots = np.concatenate([np.zeros(degree), np.arange(count - degree + 1.0), np.full(degree, count - degree)])
    return sc.NurbsCurve(degree, knots, RANDOM.uniform(-1, 1, (count, 3)), RANDOM.uniform(0.5, 2, count))


def patch(u=5, v=4):
    def knots(count):
        return [0, 0, *range(count - 1), count - 2, count - 2]
    return sc.NurbsPatch((2, 2), (knots(u), knots(v)), RANDOM.uniform(-1, 1, (u, v, 3)), RANDOM.uniform(0.5, 2, (u, v)))


def of(value):
    return definitions.from_value(value)


def require_right(before, after, kept):
    """Rows that are carried are the same points, and so many are."""
    found = keyed_rows.carried(before, after)
    there = np.flatnonzero(found >= 0)
    assert np.allclose(before.pool[there], after.pool[found[there]], atol=1e-15) and len(there) == kept


@pytest.mark.parametrize('after, kept', (
    (lambda c: c.insert_knot(2.5), 5), (lambda c: c.reversed(), 6), (lambda c: list(c.split(2.0)), 6),
    (lambda c: c.elevate(), 2), (lambda c: [curve(), c], 6), (lambda c: c.with_domain((0, 1)), 6)))
def test_points_of_a_curve_that_lie_where_they_lay_are_the_same(after, kept):
    before = curve()
    require_right(of(before), of(after(before)), kept)


@pytest.mark.parametrize('after, kept', (
    (lambda p: p.insert_knot('u', 1.5), 16), (lambda p: p.swapped(), 20), (lambda p: p.reversed('u'), 20),
    (lambda p: p.reversed('v').swapped(), 20), (lambda p: p.elevate('v'), 10)))
def test_points_of_a_patch_that_lie_where_they_lay_are_the_same(after, kept):
    before = patch()
    require_right(of(before), of(after(before)), kept)


def test_a_chain_that_is_turned_round_keeps_its_points_and_no_tangents():
    before = sc.HermiteCurve(RANDOM.uniform(-1, 1, (3, 3)), RANDOM.uniform(-1, 1, (3, 3)))
    one, other = of(before), of(before.reversed())
    found = keyed_rows.carried(one, other)
    points, tangents = one.pieces[0].indices[0], one.pieces[0].indices[1]
    assert np.array_equal(one.pool[points], other.pool[found[points]]) and (found[tangents] == -1).all()
    assert keyed_rows.carried(one, one).tolist() == list(range(len(one.pool)))


def test_all_points_may_move_and_are_the_same():
    before = of(patch())
    moved = definitions.Definition(before.form, before.pool + [1, 2, 3, 0], before.pieces)
    assert keyed_rows.carried(before, moved).tolist() == list(range(20))


def test_a_piece_that_goes_leaves_the_others_theirs():
    a, b, c = curve(), curve(), curve()
    found = keyed_rows.carried(of([a, b, c]), of([a, c]))
    assert found.tolist() == [*range(6), *[-1] * 6, *range(6, 12)]


def test_other_knots_and_most_places_leave_every_row():
    before = of(curve())
    pool = before.pool.copy()
    pool[2] += 1
    after = definitions.Definition(before.form, pool, of(curve()).pieces)
    assert keyed_rows.carried(before, after).tolist() == list(range(6))


def given(definition, rows, values, is_given=True):
    rows = np.array(rows)
    return keyed_rows.taken(definition, rows, np.array(values, np.float32).reshape(-1, 4),
                            np.full((len(rows), 4), is_given))


def test_what_is_the_same_in_single_precision_stays_and_what_is_other_is_a_short_decimal():
    before = of(curve())
    after, problem = given(before, [1], before.pool[1])
    assert after is before and problem == ""
    after, problem = given(before, [1], [0.1, *before.pool[1, 1:]])
    assert problem == "" and after.pool[1, 0] == 0.1 and np.array_equal(after.pool.ravel()[5:], before.pool.ravel()[5:])


@pytest.mark.parametrize('values, words', (
    ((np.nan, 0, 0, 1), "a number that is none"), ((0, np.inf, 0, 1), "a number that is none"), ((0, 0, 0, 0), "the weight 0")))
def test_what_is_no_place_is_not_taken_and_said(values, words):
    before = of(curve())
    after, problem = given(before, [2], values)
    assert words in problem and np.isfinite(after.pool).all() and after.pool[2, 3] == before.pool[2, 3]
    definitions.to_value(after)


def test_a_direction_keeps_the_weight_0():
    before = of(sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]))
    after, problem = given(before, [1], (0, 2, 0, 1))
    assert "infinity" in problem and after.pool[1].tolist() == [0, 2, 0, 0]


def test_points_of_hermite_pieces_take_no_weight():
    before = of(sc.HermiteCurve(RANDOM.uniform(-1, 1, (3, 3)), RANDOM.uniform(-1, 1, (3, 3))))
    assert not keyed_rows.weighted(before).any()
    after, problem = given(before, [0], [*before.pool[0, :3], 2.0])
    assert after is before and problem == ""


@pytest.mark.parametrize('scale, words', ((1e39, "farther"), (1e-40, "smaller")))
def test_what_single_precision_does_not_hold_is_refused(scale, words):
    definition = of(sc.BezierCurve(np.array([(0, 0, 0), (1, 2, 0), (3, 0, 0)]) * scale))
    with pytest.raises(failures.Refusal, match=words):
        keyed_rows.require_single(definition.pool, np.arange(3))
