"""Joints of curves that hold are as smooth again as they are to be after any change, and what need not move stays."""

from dataclasses import replace

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

definitions, failures, holds, joints = core("shape.definition"), core("base.failures"), core("joints.held"), core("joints.held_joints")
Held = holds.Held
MOVES = ('second', 'first', 'both')
PLACES = {'start': 0, 'end': -1}


def curve(degree, seed, rational, spans=3):
    rng = np.random.default_rng(seed)
    inner = np.sort(rng.uniform(1, 9, spans - 1))
    knots = np.concatenate([[0.0] * (degree + 1), inner, [10.0] * (degree + 1)])
    points = np.cumsum(rng.uniform(0.3, 1.0, (degree + spans, 3)), axis=0)
    return sc.NurbsCurve(degree, knots, points, rng.uniform(0.7, 1.4, len(points)) if rational else None)


def chain(degree, seed=0, rational=False, ends=('end', 'start'), spans=3):
    """Two curves that meet in these ends."""
    first, second = curve(degree, seed, rational, spans), curve(degree, seed + 100, rational, spans)
    points = second.points + (first.points[PLACES[ends[0]]] - second.points[PLACES[ends[1]]])
    points[PLACES[ends[1]]] = first.points[PLACES[ends[0]]]
    second = sc.NurbsCurve(degree, second.knots, points, second.weights)
    return definitions.from_value([first, second])


def measured(definition, held):
    one, other = (definitions.to_value(replace(definition, form='curve', pieces=(definition.pieces[piece],)))
                  for piece, _ in (held.first, held.second))
    one, other = one.to_nurbs(), other.to_nurbs()
    if held.first == held.second:
        return one.continuity(held.first[1])
    one = one if held.first[1] == 'end' else one.reversed()
    return one.continuity_to(other if held.second[1] == 'start' else other.reversed())


def require_holds(definition, held):
    found = measured(definition, held)
    letter, order = held.smoothness
    assert (found.c if letter == 'C' else found.g) >= int(order), (found, held)


def shaken(definition, seed, size=0.1, part=1.0):
    rng = np.random.default_rng(seed)
    pool = definition.pool.copy()
    chosen = rng.random(len(pool)) < part
    pool[chosen, :3] += rng.uniform(-size, size, (chosen.sum(), 3))
    return replace(definition, pool=pool)


@pytest.mark.parametrize('rational', (False, True))
@pytest.mark.parametrize('moves', MOVES)
@pytest.mark.parametrize('smoothness', joints.SMOOTHNESS)
@pytest.mark.parametrize('degree', range(2, 10))
def test_a_joint_of_two_curves_holds_whatever_moves(degree, smoothness, moves, rational):
    definition = chain(degree, rational=rational)
    held = Held((0, 'end'), (1, 'start'), smoothness, moves)
    for seed in range(3):
        after = holds.applied(shaken(definition, seed), (held,))
        require_holds(after, held)
        assert np.array_equal(after.pool[:, 3], definition.pool[:, 3])
        assert holds.applied(after, (held,)) is after


@pytest.mark.parametrize('ends', (('end', 'start'), ('end', 'end'), ('start', 'start'), ('start', 'end')))
@pytest.mark.parametrize('smoothness', joints.SMOOTHNESS)
def test_it_may_join_any_two_ends(smoothness, ends):
    definition = chain(3, 5, True, ends)
    held = Held((0, ends[0]), (1, ends[1]), smoothness, 'both')
    require_holds(holds.applied(shaken(definition, 1), (held,)), held)


def with_knot(degree, rational):
    """A curve that is only continuous at the knot 5."""
    made = curve(degree, 7, rational, spans=4).insert_knot(5.0, degree)
    return definitions.from_value(made)


@pytest.mark.parametrize('rational', (False, True))
@pytest.mark.parametrize('moves', MOVES)
@pytest.mark.parametrize('smoothness', joints.SMOOTHNESS)
@pytest.mark.parametrize('degree', range(2, 10))
def test_a_knot_holds(degree, smoothness, moves, rational):
    definition = with_knot(degree, rational)
    held = Held((0, 5.0), (0, 5.0), smoothness, moves)
    assert holds.are_one(definition, held)
    for seed in range(3):
        require_holds(holds.applied(shaken(definition, seed, 0.02), (held,)), held)


@pytest.mark.parametrize('smoothness', joints.SMOOTHNESS)
def test_a_closed_curve_holds_at_its_seam(smoothness):
    turn = np.linspace(0, 2 * np.pi, 8)[:-1]
    points = np.stack([np.cos(turn), np.sin(turn), 0.2 * np.sin(3 * turn)], 1)
    definition = definitions.from_value(sc.BezierCurve(np.concatenate([points, points[:1]])))
    held = Held((0, 'end'), (0, 'start'), smoothness, 'second')
    require_holds(holds.applied(shaken(definition, 2), (held,)), held)


def resized(definition, size, offset):
    pool = definition.pool.copy()
    pool[:, :3] = pool[:, :3] * size + offset
    return replace(definition, pool=pool)


@pytest.mark.parametrize('rational', (False, True))
@pytest.mark.parametrize('size, offset', ((1e-150, 0), (1e-20, 0), (1e-6, 0), (1e20, 0), (1e150, 0), (1, 1e6), (1e-3, 1e4), (1, -1e8)))
@pytest.mark.parametrize('smoothness', joints.SMOOTHNESS)
def test_a_joint_holds_at_every_size_and_far_from_the_origin(smoothness, size, offset, rational):
    held = Held((0, 'end'), (1, 'start'), smoothness, 'both')
    there = shaken(chain(3, rational=rational), 4)
    plain, after = (holds.applied(one, (held,)) for one in (there, resized(there, size, offset)))
    rounding = 1e-11 + 64 * np.finfo(float).eps * abs(offset) / size
    assert np.abs((after.pool[:, :3] - offset) / size - plain.pool[:, :3]).max() < rounding * 20
    assert holds.applied(after, (held,)) is after


@pytest.mark.parametrize('scale', (1e-150, 1e-9, 1e9, 1e150))
def test_parameters_may_be_of_any_size(scale):
    definition = chain(3)
    pieces = tuple(replace(piece, knots=(piece.knots[0] * scale,)) for piece in definition.pieces)
    held = Held((0, 'end'), (1, 'start'), 'C2', 'second')
    plain, scaled = (holds.applied(shaken(one, 3), (held,)) for one in (definition, replace(definition, pieces=pieces)))
    assert np.allclose(plain.pool, scaled.pool, rtol=1e-12, atol=1e-12)


def test_the_end_that_a_hand_moves_leads_whichever_gives_way():
    definition = chain(3)
    a, b = definition.pieces[0].indices[-1], definition.pieces[1].indices[0]
    for moves in MOVES:
        for led in (a, b):
            pool = definition.pool.copy()
            pool[led, :3] += (0.3, -0.2, 0.5)
            after = holds.applied(replace(definition, pool=pool), (Held((0, 'end'), (1, 'start'), 'C0', moves),), {int(led)})
            assert (after.pool[[a, b], :3] == pool[led, :3]).all()
            assert np.array_equal(np.delete(after.pool, [a, b], 0), np.delete(definition.pool, [a, b], 0))


def test_what_gives_way_alone_moves_and_keeps_its_length_at_a_tangent():
    definition = shaken(chain(3), 8, part=0.4)
    held = Held((0, 'end'), (1, 'start'), 'G1', 'second')
    after = holds.applied(definition, (held,))
    moved = set(np.flatnonzero((after.pool != definition.pool).any(1)).tolist())
    assert moved <= set(definition.pieces[1].indices[:2].tolist())
    handles = [np.diff(one.pool[definition.pieces[1].indices[:2], :3], axis=0) for one in (definition, after)]
    assert np.isclose(*map(np.linalg.norm, handles))


def test_several_joints_in_a_row_hold_together():
    curves = [curve(3, seed, True) for seed in range(4)]
    definition = definitions.from_value(curves)
    seams = [Held((i, 'end'), (i + 1, 'start'), smoothness, 'second') for i, smoothness in enumerate(('G2', 'C1', 'C2'))]
    after = holds.applied(definition, seams)
    for held in seams:
        require_holds(after, held)


def test_it_is_carried_to_what_pieces_became():
    definition = chain(3)
    held = Held((0, 'end'), (1, 'start'), 'G1', 'second')
    first, second = definitions.to_value(definition)
    parts = definitions.from_value([*first.split(4.0), second])
    assert holds.carried((held,), (0, 0, 1), definition, parts) == (held._replace(first=(1, 'end'), second=(2, 'start')),)
    assert holds.carried((held,), (0, 1), definition, definitions.from_value([first.reversed(), second])) == ()
    assert holds.carried((held,), (0,), definition, definitions.from_value([first])) == ()
    knot = Held((0, 5.0), (0, 5.0), 'G1', 'second')
    assert holds.carried((knot,), (0,), with_knot(3, False), with_knot(3, False)) == (knot,)
    assert holds.carried((knot,), (0,), with_knot(3, False), definitions.from_value(first)) == ()


def test_a_knot_is_carried_to_where_its_point_is():
    points = np.array([[0, 0, 0], [1, 1, 0], [2, 1, 0], [3, 0, 0], [4, -1, 0], [5, 2, 0], [6, 0, 0], [7, 1, 0], [8, 2, 0], [9, 0, 0.0]])
    corners = sc.NurbsCurve(3, [0, 0, 0, 0, 0.25, 0.25, 0.25, 0.75, 0.75, 0.75, 1, 1, 1, 1.0], points)
    before, knot = definitions.from_value(corners), Held((0, 0.25), (0, 0.25), 'C2', 'second')

    def carried(curve):
        return holds.carried((knot,), (0,), before, definitions.from_value(curve))
    assert carried(corners.with_domain((0.0, 2.0))) == (knot._replace(first=(0, 0.5), second=(0, 0.5)),)
    assert carried(corners.elevate()) == (knot,)
    assert carried(corners.insert_knot(0.5)) == (knot,)
    assert carried(corners.reversed()) == () and carried(corners.with_points(corners.points + (0, 0, 1))) == ()


def test_where_a_knot_is_moved_what_holds_there_goes_along():
    before, knot = with_knot(3, False), Held((0, 5.0), (0, 5.0), 'C1', 'second')
    end = Held((0, 'end'), (0, 'start'), 'C0', 'second')
    piece = before.pieces[0]
    moved = replace(before, pieces=(replace(piece, knots=(np.where(piece.knots[0] == 5.0, 5.5, piece.knots[0]),)),))
    assert holds.at_knots_of((knot, end), before, moved) == (knot._replace(first=(0, 5.5), second=(0, 5.5)), end)


def test_sides_of_mirrored_patches_are_exchanged():
    seam = Held((0, 'u_end'), (1, 'v_start'), 'G1', 'both')
    assert holds.mirrored((seam,)) == (seam._replace(first=(0, 'v_end'), second=(1, 'u_start')),)


def test_a_cusp_and_points_that_coincide_do_no_harm():
    points = np.array([[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 0, 0.0]])
    still = np.array([[3, 0, 0], [3, 0, 0], [3, 0, 0], [3, 0, 0.0]])
    back = points[::-1].copy()
    for other in (still, back):
        definition = definitions.from_value([sc.BezierCurve(points), sc.BezierCurve(other)])
        for smoothness in ('G1', 'G2'):
            for moves in MOVES:
                after = holds.applied(definition, (Held((0, 'end'), (1, 'start'), smoothness, moves),))
                assert np.isfinite(after.pool).all()


def test_a_direction_beside_a_joint_is_no_place():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 2, 0.0]])
    one = sc.BezierCurve(points, [1, 1, 0, 1])
    other = sc.BezierCurve(points + points[-1] - points[0], [1, 0.5, 2, 1])
    definition = definitions.from_value([one, other])
    for moves in MOVES:
        held = Held((0, 'end'), (1, 'start'), 'C1', moves)
        require_holds(holds.applied(definition, (held,)), held)


def test_what_cannot_hold_is_refused_in_words():
    definition = chain(1, spans=3)
    with pytest.raises(failures.Refusal, match="degree 1 cannot be made C2"):
        holds.applied(definition, (Held((0, 'end'), (1, 'start'), 'C2', 'second'),))
    periodic = sc.NurbsCurve(3, np.arange(6.0), np.eye(5, 3), periodic=True)
    hermite = sc.HermiteCurve(np.eye(3), np.ones((3, 2, 3)), [0, 1, 2.0])
    unclamped = sc.NurbsCurve(3, np.arange(9.0), np.eye(5, 3))
    for other, words in ((periodic, "periodic"), (hermite, "Hermite"), (unclamped, "control point")):
        definition = definitions.from_value([curve(3, 0, False), other])
        with pytest.raises(failures.Refusal, match=words):
            holds.applied(definition, (Held((0, 'end'), (1, 'start'), 'G1', 'second'),))
        assert not holds.can_hold(definition, (0, 'end'), (1, 'start'))
    far = definitions.from_value([sc.BezierCurve(np.eye(3), [1, 1, 0]), sc.BezierCurve(np.eye(3))])
    with pytest.raises(failures.Refusal, match="infinity"):
        holds.applied(far, (Held((0, 'end'), (1, 'start'), 'C0', 'second'),))
    definition = chain(3)
    with pytest.raises(failures.Refusal, match="no knot"):
        holds.applied(definition, (Held((0, 5.0), (0, 5.0), 'C1', 'second'),))
    for wrong in (Held((0, 'end'), (2, 'start'), 'G1', 'second'), Held((0, 'u_end'), (1, 'start'), 'G1', 'second'),
                  Held((0, 'end'), (0, 'end'), 'G1', 'second'), Held((0, 2.0), (1, 'start'), 'G1', 'second'),
                  Held((0, float('nan')), (0, float('nan')), 'G1', 'second'), Held((0, 2), (0, 2), 'G1', 'second'),
                  Held((0, 'end'), (1, 'start'), 'G3', 'second'), Held((0, ['end']), (1, 'start'), 'G1', 'second')):
        with pytest.raises((failures.Refusal, TypeError)):
            holds.require_valid(wrong, definition)


def test_joints_that_contradict_one_another_are_refused():
    three = definitions.from_value([curve(3, seed, False) for seed in range(3)])
    seams = (Held((0, 'end'), (1, 'start'), 'C1', 'second'), Held((2, 'end'), (1, 'start'), 'C1', 'second'))
    with pytest.raises(failures.Refusal, match="contradict"):
        holds.applied(three, seams)
