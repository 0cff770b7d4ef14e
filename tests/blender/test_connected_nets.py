"""Curves of a net are connected by F and split by Y: the shape follows, through undo."""

import bpy
import numpy as np
import pytest

from shapes import add, enter, leave, move, op, points
from support import part, splinecore as sc
from test_grown_nets import CHAINS, POLYGONS, choose, choose_among, followed, held, points_of, spline, value, value_of

live = part('bridge.net.live')


def two(name):
    """A curve, and the same farther away."""
    curve = value_of(name)
    far = curve.points + [9, 1, 2]
    if isinstance(curve, sc.HermiteCurve):
        return [curve, sc.HermiteCurve(far, curve.tangents, curve.parameters)]
    if isinstance(curve, sc.BezierCurve):
        return [curve, sc.BezierCurve(far, curve.weights)]
    return [curve, sc.NurbsCurve(curve.degree, curve.knots, far, curve.weights)]


@pytest.mark.parametrize('ends', ((-1, 0), (0, -1), (0, 0), (-1, -1)))
@pytest.mark.parametrize('name', POLYGONS)
def test_f_connects_the_ends_of_two_polygons(name, ends):
    before = two(name)
    add(before)
    enter()
    choose_among(enumerate(ends))
    op(bpy.ops.curve.make_segment)
    [after] = followed()
    assert after.degree == before[0].degree and len(held().data.splines) == 1
    for curve in before:                # its points are there, one after the other, in this order or the other
        known = [int(np.flatnonzero((after.points == point).all(1))[0]) for point in curve.points]
        assert np.isin(np.diff(known), (1, -1)).all() and len(set(np.diff(known))) == 1
        assert np.array_equal(after.weights[known], curve.weights)
    joint = [at for curve, end in zip(before, ends)
             for at in np.flatnonzero((after.points == curve.points[end]).all(1))]
    assert abs(joint[0] - joint[1]) == 1
    choose(0)
    move(0, 0, 1)
    assert followed() != [after]
    leave()


def test_where_polygons_were_connected_the_shapes_stay_but_for_the_spans_beside_the_joint():
    knots = np.concatenate([np.zeros(3), [0, 1, 3, 4, 4.5, 6, 8, 9], np.full(4, 10)])
    before = sc.NurbsCurve(3, knots, points(11), np.linspace(1, 2, 11))
    other = sc.NurbsCurve(3, knots, points(11) + [9, 1, 2], np.linspace(1, 2, 11))
    add([before, other])
    enter()
    choose_among(enumerate((-1, 0)))
    op(bpy.ops.curve.make_segment)
    [after] = followed()
    u = np.linspace(0, knots[9], 50)
    assert np.abs(after.evaluate(u) - before.evaluate(u)).max() < 1e-13
    u = np.linspace(knots[5], 10, 50)
    assert np.abs(after.evaluate(u + (after.domain[1] - 10)) - other.evaluate(u)).max() < 1e-13
    leave()


@pytest.mark.parametrize('ends', ((-1, 0), (0, -1), (0, 0), (-1, -1)))
@pytest.mark.parametrize('name', CHAINS)
def test_f_connects_the_ends_of_two_chains_which_keep_their_shapes(name, ends):
    before = two(name)
    add(before)
    enter()
    choose_among(enumerate(ends))
    op(bpy.ops.curve.make_segment)
    [after] = followed()
    assert isinstance(after, sc.HermiteCurve) and len(held().data.splines) == 1
    whole, at = after.to_nurbs(), 0
    for curve in before if (after.points[0] == before[0].points[-1 - ends[0]]).all() else before[::-1]:
        chain = curve.to_hermite() if isinstance(curve, sc.BezierCurve) else curve
        u = np.linspace(chain.parameters[0], chain.parameters[-1], 9)
        there = chain.to_nurbs().evaluate(u)
        own = after.parameters[at:at + len(chain.parameters)]
        at += len(chain.parameters)
        found = whole.evaluate(np.linspace(own[0], own[-1], 9))
        assert min(np.abs(found - there).max(), np.abs(found[::-1] - there).max()) < 1e-12
    assert len(after.parameters) == at
    leave()


@pytest.mark.parametrize('name', ('nurbs', 'hermite'))
def test_curves_that_were_connected_come_apart_by_undo_and_are_parted_again_by_deleting_the_segment(name):
    add(two(name))
    enter()
    before = value()
    choose_among(enumerate((-1, 0)))
    op(bpy.ops.curve.make_segment)
    after = followed()
    op(bpy.ops.ed.undo)
    assert followed() == before
    op(bpy.ops.ed.redo)
    assert followed() == after
    count = len(points_of(spline())) // 2
    choose(count - 1, count)
    op(bpy.ops.curve.delete, type='SEGMENT')
    parted = followed()
    assert len(parted) == 2 and [len(curve.points) for curve in parted] == [len(curve.points) for curve in before]
    leave()


@pytest.mark.parametrize('pair, words', (
    ((value_of('nurbs'), value_of('quintic')), "raise the lower degree"),
    ((value_of('nurbs'), sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], points(4), [1, 0, 1, 1])), "infinity"),
))
def test_ends_that_cannot_be_connected_are_refused_in_words(pair, words):
    add(list(pair))
    enter()
    value_before = value()
    choose_among(enumerate((-1, 0)))
    op(bpy.ops.curve.make_segment)
    held().data.update_tag()
    bpy.context.view_layer.update()
    assert words in live.problem(held()) and value() == value_before
    bpy.ops.ed.undo()
    assert followed() == value_before
    leave()


@pytest.mark.parametrize('name', ('nurbs', 'hermite', 'unclamped'))
def test_what_is_split_off_is_a_curve_of_its_own_in_the_same_shape(name):
    before = value_of(name)
    add(before)
    enter()
    count = len(points_of(spline()))
    choose(count - 2, count - 1)
    op(bpy.ops.curve.split)
    parted = followed()
    assert [len(curve.points) for curve in parted] == [count - 1, 2] and len(held().data.splines) == 2
    assert np.array_equal(parted[0].points, before.points[:-1]) and np.array_equal(parted[1].points, before.points[-2:])
    bpy.ops.ed.undo()
    assert followed() == before
    leave()


def test_the_middle_of_a_curve_is_split_off():
    before = value_of('nurbs')
    add(before)
    enter()
    choose(2, 3)
    op(bpy.ops.curve.split)
    assert [curve.points.tolist() for curve in followed()] == [
        before.points[:3].tolist(), before.points[2:4].tolist(), before.points[3:].tolist()]
    leave()
