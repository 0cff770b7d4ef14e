"""What holds goes along by no more than a few times what the hand does, however near to one another shapes are cut, and says what it
could not keep."""

from dataclasses import replace

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

bounds, definitions, holds, joints = core("joints.held_bounds"), core("shape.definition"), core("joints.held"), core("joints.patch_joints")
#: Of second derivatives there remain so many across a thousandth of a span; where seams cross, they agree to what Continuity sees.
_DIGITS, _SEEN = 1e-7, core("joints.joints").SMOOTH
strips, Held = core("joints.held_strips"), holds.Held


def cut_at(rng):
    """(knots inside 0..10, a place near one of them, down to a thousandth of a span)."""
    inner = np.sort(rng.uniform(0.5, 9.5, rng.integers(1, 5)))
    cut = inner[rng.integers(len(inner))] + rng.choice([-1, 1]) * 10 ** rng.uniform(-3, 0)
    return inner, float(np.clip(cut, 1e-3, 10 - 1e-3))


def with_ends(inner, degree, last=10.0):
    return np.concatenate([[0.0] * (degree + 1), inner, [last] * (degree + 1)])


def patch(rng, inner, least=2):
    p, q = int(rng.integers(least, 8)), int(rng.integers(least, 6))
    knots = with_ends(inner, p), with_ends(np.sort(rng.uniform(0.1, 0.9, 3)), q, 1.0)
    u, v = np.meshgrid(np.linspace(0, 10, p + 1 + len(inner)), np.linspace(0, 4, q + 4), indexing='ij')
    points = np.stack([u, v, 0 * u], -1) + rng.uniform(-0.3, 0.3, (*u.shape, 3))
    return sc.NurbsPatch((p, q), knots, points, rng.uniform(0.3, 3.0, u.shape) if rng.random() < 0.5 else None)


def cut_patch(rng):
    """A definition of two patches cut near a knot, and a Held of their seam."""
    inner, cut = cut_at(rng)
    parts = patch(rng, inner).split('u', cut)
    smoothness, moves = str(rng.choice(joints.SMOOTHNESS)), str(rng.choice(joints.MOVES))
    definition = definitions.from_value(sc.PatchSet.from_patches(parts))
    made = joints.joined(definition, joints.Choice(1, 'u_end'), joints.Choice(2, 'u_start'), smoothness, moves)
    return made.changed.definition, Held((0, 'u_end'), (1, 'u_start'), smoothness, moves)


def cut_curve(rng):
    """The same of a curve, in two or with a knot at which its points alone meet."""
    inner, cut = cut_at(rng)
    degree = int(rng.integers(2, 8))
    points = np.cumsum(rng.uniform(0.3, 1.0, (degree + 1 + len(inner), 3)), axis=0)
    whole = sc.NurbsCurve(degree, with_ends(inner, degree), points, rng.uniform(0.3, 3.0, len(points)) if rng.random() < 0.5 else None)
    smoothness, moves = str(rng.choice(['C0', 'G1', 'C1', 'G2', 'C2'])), str(rng.choice(joints.MOVES))
    if rng.random() < 0.5:
        return definitions.from_value(whole.split(cut)), Held((0, 'end'), (1, 'start'), smoothness, moves)
    return definitions.from_value(whole.insert_knot(cut, degree)), Held((0, cut), (0, cut), smoothness, moves)


def beside(definition, seams):
    """The rows of the pool beside seams."""
    return np.unique(np.concatenate([strip.rows.ravel() for held in seams for strip in strips.strips_of(definition, held)]))


def moved(rng, definition, rows):
    """(the definition after a hand has moved some of the rows, which those are, by how much at most)."""
    led = rng.choice(rows, min(int(rng.choice([1, 1, 2, 3, 8])), len(rows)), replace=False)
    steps = rng.normal(size=(len(led), 3)) if rng.random() < 0.3 else np.tile(rng.normal(size=3), (len(led), 1))
    size = 10 ** rng.uniform(-2, 0.3)
    pool = definition.pool.copy()
    pool[led, :3] += steps * (size / np.linalg.norm(steps, axis=1).max())
    return replace(definition, pool=pool), set(led.tolist()), size


def smoothness_of(definition, held, tolerance=_DIGITS):
    if not definition.has_curves:
        patches = definitions.to_patch_set(definition)
        (first, side), (second, other) = held.first, held.second
        return sc.seam_continuity(patches[first], side, patches[second], other, tolerance=tolerance)
    curves = [definitions.to_value(replace(definition, form='curve', pieces=(piece,))).to_nurbs() for piece in definition.pieces]
    return curves[0].continuity(held.first[1]) if held.first == held.second else curves[0].continuity_to(curves[1])


def require_kept(seams, found, tolerance=_DIGITS):
    lost = {held: now for held, now in found.lost}
    for held in seams:
        said = lost.get(held, held.smoothness)
        measured = smoothness_of(found.definition, held, tolerance)
        assert (measured.c if said[0] == 'C' else measured.g) >= int(said[1]), (held, said, measured)


@pytest.mark.parametrize('make', (cut_patch, cut_curve))
def test_hard_holds_are_bounded_and_keep_what_they_say(make, inputs):
    count, less = inputs(1000), 0
    for seed in range(count):
        rng = np.random.default_rng(seed)
        definition, held = make(rng)
        now, led, size = moved(rng, definition, beside(definition, [held]))
        found = bounds.kept(now, (held,), led, definition.pool)
        require_kept([held], found)
        way = np.linalg.norm(found.definition.pool[:, :3] - now.pool[:, :3], axis=1)
        assert way.max() <= 1.001 * bounds.REACH * size
        assert len(led) > 1 or not found.lost   # for one point there is always a way to keep all of it
        less += bool(found.lost)
    assert less <= 0.1 * count


def one_point(size=1.2):
    """A lathe cut where the knot 6.14 is near, one point beside the seam moved."""
    knots = with_ends([2.0, 4.0, 6.14, 8.0], 3)
    u, v = np.meshgrid(np.linspace(0, 10, 8), np.linspace(0, 4, 7), indexing='ij')
    whole = sc.NurbsPatch((3, 3), (knots, with_ends([0.3, 0.6, 0.8], 3, 1.0)), np.stack([u, v, np.sin(u)], -1))
    definition = definitions.from_value(sc.PatchSet.from_patches(whole.split('u', 6.2)))
    row = int(definition.pieces[0].indices[-2, 3])
    pool = definition.pool.copy()
    pool[row, 1] += size
    return definition, replace(definition, pool=pool), row


@pytest.mark.parametrize('smoothness', ('G1', 'C1', 'G2', 'C2'))
def test_a_seam_beside_a_knot_does_not_throw_the_other_half_away(smoothness):
    before, now, row = one_point()
    held = Held((0, 'u_end'), (1, 'u_start'), smoothness, 'second')
    alone = holds.applied(now, (held,))
    found = bounds.kept(now, (held,), {row}, before.pool)
    if smoothness[0] == 'C':
        assert np.abs(alone.pool - now.pool).max() > 20 * 1.2
    assert found.lost == ()
    require_kept([held], found)
    change = np.abs(found.definition.pool - now.pool)
    assert change.max() <= 2 * 1.2 and change[row].max() == 0
    column = {int(piece.indices[i, 3]) for piece, rows in zip(now.pieces, ((-3, -2, -1), (0, 1, 2))) for i in rows}
    assert set(np.flatnonzero(change.any(1)).tolist()) <= column


def test_where_spans_are_alike_the_side_that_gives_way_alone_goes_along():
    whole = sc.NurbsPatch((3, 3), (with_ends([2.0, 4.0, 6.0, 8.0], 3), with_ends([0.5], 3, 1.0)),
                          np.stack(np.meshgrid(np.linspace(0, 10, 8), np.linspace(0, 4, 5), [0.0], indexing='ij'), -1)[:, :, 0])
    before = definitions.from_value(sc.PatchSet.from_patches(whole.split('u', 5.0)))
    row, pool = int(before.pieces[0].indices[-2, 2]), before.pool.copy()
    pool[row, 2] += 0.5
    found = bounds.kept(replace(before, pool=pool), (Held((0, 'u_end'), (1, 'u_start'), 'G2', 'second'),), {row}, before.pool)
    changed = np.flatnonzero((found.definition.pool != pool).any(1))
    assert changed.tolist() == sorted(before.pieces[1].indices[1:3, 2].tolist()) and found.lost == ()


def test_what_no_motion_within_reach_keeps_is_said():
    before, now, _ = one_point(0.0)
    pool, edge = now.pool.copy(), now.pieces[0].indices[-3:, 3]
    beyond = now.pieces[1].indices[1:3, 3]
    pool[edge, 2] += (0.3, -0.4, 0.2)
    pool[beyond, 2] += (-0.3, 0.5)
    held = Held((0, 'u_end'), (1, 'u_start'), 'C2', 'second')
    found = bounds.kept(replace(now, pool=pool), (held,), set([*edge.tolist(), *beyond.tolist()]), before.pool)
    (lost, smoothness), = found.lost
    assert lost == held and smoothness in ('C0', 'C1')
    assert f"1 u end · 2 u start holds {smoothness} only, not C2" in bounds.sentence(found.lost)
    require_kept([held], found)


def crossed(rng):
    """Four patches cut in a cross near knots, and all four seams."""
    inner, cut = cut_at(rng)
    halves = [part.split('v', 0.5) for part in patch(rng, inner, least=4).split('u', cut)]
    smoothness = str(rng.choice(joints.SMOOTHNESS[1:]))
    definition = definitions.from_value(sc.PatchSet.from_patches([part for half in halves for part in half]))
    pairs = ((0, 'u_end'), (2, 'u_start')), ((1, 'u_end'), (3, 'u_start')), ((0, 'v_end'), (1, 'v_start')), ((2, 'v_end'), (3, 'v_start'))
    return definition, tuple(Held(*pair, smoothness, 'second') for pair in pairs)


def test_seams_that_cross_are_bounded_and_keep_what_they_say(inputs):
    for seed in range(inputs(100)):
        rng = np.random.default_rng(seed)
        definition, seams = crossed(rng)
        now, led, size = moved(rng, definition, beside(definition, seams))
        found = bounds.kept(now, seams, led, definition.pool)
        require_kept(seams, found, _SEEN)
        assert np.linalg.norm(found.definition.pool[:, :3] - now.pool[:, :3], axis=1).max() <= 1.001 * bounds.REACH * size
