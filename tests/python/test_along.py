"""Radius and tilt along a curve, changed at its control points."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

along, definitions = core("net.along"), core("shape.definition")
RNG = np.random.default_rng(2)
POINTS, WEIGHTS = RNG.uniform(-1, 1, (7, 3)), RNG.uniform(0.5, 2, 7)


def closed_chain():
    points = np.append(POINTS, POINTS[:1], 0)
    tangents = RNG.uniform(-1, 1, (8, 2, 3))
    tangents[-1] = tangents[0]
    return sc.HermiteCurve(points, tangents)


CURVES = {
    'chain': lambda: sc.HermiteCurve(POINTS, RNG.uniform(-1, 1, (7, 2, 3)), [0, 1, 1.5, 4, 5, 6, 9]),
    'closed chain': closed_chain,
    'cubic': lambda: sc.BezierCurve(POINTS[:4]),
    'rational': lambda: sc.BezierCurve(POINTS[:4], [1, 2, 0.5, 1]),
    'nurbs': lambda: sc.NurbsCurve(3, [0, 0, 0, 0, 1, 3, 3.5, 4, 4, 4, 4], POINTS, WEIGHTS),
    'periodic': lambda: sc.NurbsCurve(3, range(8), POINTS, periodic=True),
    'unclamped': lambda: sc.NurbsCurve(2, range(10), POINTS),
    'closed polygon': lambda: sc.NurbsCurve(1, [0, 0, 1, 2, 3, 3], np.append(POINTS[:3], POINTS[:1], 0)),
    'negative weight': lambda: sc.BezierCurve(POINTS[:3], [1, -0.5, 1]),
    'through infinity': lambda: sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1]),
}
#: How many points they have, of which one is at infinity.
COUNTS = {'chain': 7, 'closed chain': 7, 'cubic': 2, 'rational': 4, 'nurbs': 7, 'periodic': 7, 'unclamped': 7, 'closed polygon': 3,
          'negative weight': 3, 'through infinity': 3}


def held(name, values=None, steps=6, way='LINEAR'):
    definition = definitions.from_value(CURVES[name]())
    curve = definitions.to_value(definition)
    at = places_of(name, steps)
    values = np.tile((1.0, 0.0), (len(at), 1)) if values is None else values(at)
    return along.held(at, values, (along.mixture(definition, 0, curve, at, way),) * 2)


def places_of(name, steps=6):
    definition = definitions.from_value(CURVES[name]())
    return along.places(definition, 0, definitions.to_value(definition), steps)


def basis_of(before):
    """(m, n): how much each point counts."""
    return before.mixtures[0].of(np.eye(len(before.own)))


@pytest.mark.parametrize('name', CURVES)
def test_all_points_together_change_all_of_it(name):
    before = held(name)
    count = len(before.own)
    assert count == COUNTS[name]
    after = along.changed(before, np.arange(count), 2.5, 0.3)
    assert np.allclose(after, (2.5, 0.3), atol=1e-12) and (before.values == (1, 0)).all()


@pytest.mark.parametrize('name', CURVES)
def test_points_change_it_where_they_count_and_one_after_the_other_as_together(name):
    before = held(name)
    whole = along.changed(before, np.arange(2), 3.0, 1.0)
    first = along.changed(before, np.array([0]), 3.0, 1.0)
    again = along.changed(along.held(places_of(name), first, before.mixtures), np.array([1]), 3.0, 1.0)
    assert np.allclose(again, whole, atol=1e-4)
    far = basis_of(before)[:, :2].sum(1) == 0
    assert (whole[far] == (1, 0)).all()


def test_a_joint_has_what_it_is_given_and_the_way_there_is_straight():
    before = held('chain', steps=4)
    after = along.changed(before, np.array([2]), 3.0, np.pi / 2)
    assert np.allclose(after[4:13, 0], [1, 1.5, 2, 2.5, 3, 2.5, 2, 1.5, 1]) and (after[13:, 0] == 1).all()
    assert np.isclose(after[8, 1], np.pi / 2) and (after[:5, 1] == 0).all()


def test_the_joint_where_a_chain_closes_counts_on_both_sides():
    after = along.changed(held('closed chain', steps=2), np.array([0]), 2.0, 0.0)
    assert np.allclose(after[:4, 0], [2, 1.5, 1, 1]) and np.allclose(after[-4:, 0], [1, 1, 1.5, 2])


@pytest.mark.parametrize('name', ('nurbs', 'unclamped', 'periodic'))
def test_factors_are_of_what_points_have(name):
    definition = definitions.from_value(CURVES[name]())
    curve = definitions.to_value(definition)
    basis = along.mixture(definition, 0, curve, along.places(definition, 0, curve, 8)).of(np.eye(7))
    own = np.column_stack([RNG.uniform(1, 3, 7), RNG.uniform(-1, 1, 7)])
    before = held(name, lambda at: basis @ own, steps=8)
    assert np.allclose(before.own, own, atol=1e-4)
    own[3, 0] *= 2
    assert np.allclose(along.changed(before, np.array([3]), 2.0, 0.0), basis @ own, atol=1e-4)


def test_a_radius_stays_above_nothing():
    after = along.changed(held('chain'), np.arange(7), 0.0, 0.0)
    assert np.allclose(after[:, 0], along.LEAST_RADIUS)
    assert (along.changed(held('nurbs', lambda at: np.column_stack([at, at])), np.arange(7), 1e-9, 0.0)[:, 0] >= 0).all()


@pytest.mark.parametrize('way', ('LINEAR', 'EASE', 'CARDINAL', 'BSPLINE'))
@pytest.mark.parametrize('name', ('chain', 'closed chain', 'cubic'))
def test_every_way_of_blenders_goes_on_where_it_was(name, way):
    before = held(name, way=way)
    count = len(before.own)
    # At open ends Blender's B-spline has no whole sum: what it makes of ones is what lies there.
    values = np.column_stack([basis_of(before) @ np.arange(1.0, count + 1), basis_of(before) @ np.ones(count)])
    first = along.held(places_of(name), values, before.mixtures)
    assert np.allclose(first.own[:, 0], np.arange(1, count + 1), atol=1e-3)
    after = along.changed(first, np.array([1]), 2.0, 0.0)
    wanted = basis_of(before) @ np.where(np.arange(count) == 1, 4.0, np.arange(1.0, count + 1))
    assert np.allclose(after[:, 0], wanted, atol=1e-3)


@pytest.mark.parametrize('name', ('nurbs', 'periodic', 'unclamped', 'closed polygon', 'rational', 'through infinity'))
def test_where_a_point_counts_most_is_told(name):
    before = held(name, steps=64)
    most = places_of(name, 64)[basis_of(before).argmax(0)]
    apart = np.abs(most - before.mixtures[0].own)
    assert (np.minimum(apart, 1 - apart) < 0.2).all()


def test_a_long_chain_takes_no_matrix():
    points = np.column_stack([np.arange(3000.0), np.zeros((3000, 2))])
    definition = definitions.from_value(sc.HermiteCurve(points, np.ones((3000, 2, 3))))
    at = along.places(definition, 0, definitions.to_value(definition), 12)
    values = np.column_stack([1 + at, at])
    before = along.held(at, values, tuple(along.mixture(definition, 0, None, at, way) for way in ('LINEAR', 'BSPLINE')))
    after = along.changed(before, np.array([1000]), 2.0, 1.0)
    assert np.allclose(before.own[:, 0], 1 + np.arange(3000) / 2999)
    assert np.isclose(after[12000, 0], 2 * values[12000, 0]) and np.count_nonzero((after != values).any(1)) < 60
