"""Handle types of chains: where Blender has automatic handles, and which types are true."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

definitions, failures, handles, joints, verbs = (core(name) for name in ("shape.definition", "base.failures", "net.handles", "joints.joints", "verbs.verbs"))
KINDS = "FAVL"


def blenders(points, closed):
    """Blender's own steps (calchandleNurb), one number after the other; None where it leaves handles alone."""
    found = []
    for i, here in enumerate(points):
        before = points[i - 1] if i or closed else None
        after = points[(i + 1) % len(points)] if i + 1 < len(points) or closed else None
        before = [2 * h - a for h, a in zip(here, after)] if before is None else before
        after = [2 * h - b for h, b in zip(here, before)] if after is None else after
        a, b = [h - p for h, p in zip(here, before)], [n - h for n, h in zip(after, here)]
        len_a, len_b = math.hypot(*a) or 1.0, math.hypot(*b) or 1.0
        along = [y / len_b + x / len_a for x, y in zip(a, b)]
        size = math.hypot(*along) * 2.5614
        if size == 0:
            found.append(None)
            continue
        len_a = min(len_a, 5 * len_b)
        len_b = min(len_b, 5 * len_a)
        found.append(([h - t * (len_a / size) for h, t in zip(here, along)], [h + t * (len_b / size) for h, t in zip(here, along)]))
    return found


def some_points(count, seed=0, scale=1.0):
    return np.random.default_rng(seed).uniform(-3, 3, (count, 3)) * scale


@pytest.mark.parametrize('scale', (1e-150, 1e-30, 1.0, 1e8, 1e150))
@pytest.mark.parametrize('closed', (False, True))
@pytest.mark.parametrize('count', (2, 3, 7))
def test_automatic_handles_are_blenders(count, closed, scale):
    for seed in range(10):
        points = some_points(count, seed, scale)
        if seed == 1:
            points[-1] = points[-2]     # Blender takes a distance of 0 for 1
        if seed == 2:
            points[0] = points[1] + 100 * scale
        for own, theirs in zip(handles.automatic(points, closed), blenders(points.tolist(), closed)):
            if theirs is not None and not (count == 2 and closed):      # there and back: its direction is rounding
                assert np.allclose(own, theirs, rtol=1e-12, atol=1e-14 * scale)


def test_where_automatic_handles_have_no_direction_nothing_is_said():
    there_and_back = np.array([(0.0, 0, 0), (1, 0, 0), (0, 0, 0)])
    assert np.isnan(handles.automatic(there_and_back, False)[1]).all()
    assert np.isnan(handles.automatic(np.ones((4, 3)), True)).all()
    assert handles.true(np.ones((4, 3, 3)), "AAVVLLFF", True) == "AAVVLLFF"


def triples_of(points, letters, closed, seed=5):
    """Joints whose handles lie as the letters say; free ones anywhere."""
    triples = np.stack([points, points, points], 1)
    triples[:, ::2] += np.random.default_rng(seed).uniform(-1, 1, (len(points), 2, 3)) * np.abs(points).max()
    pairs = np.array(list(letters)).reshape(-1, 2)
    for letter, places in (('A', handles.automatic(points, closed)), ('V', handles.towards(points, closed))):
        triples[:, ::2][pairs == letter] = places[pairs == letter]
    for i, (before, after) in enumerate(pairs):
        if 'F' not in (before, after) and 'L' in (before, after):
            side = 0 if before == 'L' else 2
            triples[i, side] = handles.in_line(triples)[i, side // 2]
    return triples


@pytest.mark.parametrize('scale', (1e-150, 1.0, 1e150))
@pytest.mark.parametrize('away', (0.0, 1e4))
@pytest.mark.parametrize('closed', (False, True))
def test_types_that_are_true_stay(closed, away, scale):
    letters = "".join(a + b for a in KINDS for b in KINDS)
    points = (some_points(16, 3) + away) * scale
    triples = triples_of(points, letters, closed)
    assert handles.true(triples, letters, closed) == letters
    single = (triples / scale).astype(np.float32).astype(np.float64)
    assert handles.true(single, letters, closed) == letters


@pytest.mark.parametrize('closed', (False, True))
def test_types_that_are_not_true_become_aligned_or_free(closed):
    points = some_points(6, 4)
    triples = triples_of(points, "A" * 12, closed)
    triples[2, ::2] = points[2] + 0.5 * (triples[2, ::2] - points[2])
    assert handles.true(triples, "A" * 12, closed) == "AAAALLAAAAAA"
    triples[3, 2] += 0.1
    assert handles.true(triples, "A" * 12, closed) == "AAAALLAFAAAA"
    triples = triples_of(points, "V" * 12, closed)
    triples[1, 0] += 0.01
    assert handles.true(triples, "V" * 12, closed) == "VVFVVVVVVVVV"
    triples = triples_of(points, "L" * 12, closed)
    triples[5, 2] += 0.01
    assert handles.true(triples, "L" * 12, closed) == "LLLLLLLLLLFF"
    assert handles.true(triples, "L" * 11 + "F", closed) == "L" * 11 + "F"


@pytest.mark.parametrize('letters, part, after', (
    ('AA', 0, 'LL'), ('AA', 2, 'LL'), ('VV', 0, 'FV'), ('VV', 2, 'VF'), ('LL', 2, 'LL'), ('FF', 0, 'FF'), ('LF', 0, 'LF'),
    ('AV', 2, 'LF'), ('AA', 1, 'AA'), ('VL', 1, 'VL')))
def test_a_part_of_a_joint_that_is_moved_makes_types_of_blenders(letters, part, after):
    triple = np.array([(-1.0, 0, 0), (0, 0, 0), (2, 0, 0)])
    moved, pair = handles.moved(triple, tuple(letters), {part: triple[part] + (0, 1, 0)})
    assert "".join(pair) == after
    if part == 1:
        assert np.array_equal(moved, triple + (0, 1, 0))
    elif after == 'LL':
        arms = moved[::2] - moved[1]
        assert np.allclose(np.cross(*arms), 0) and arms[0] @ arms[1] < 0
        assert np.isclose(np.linalg.norm(arms[1 - part // 2]), np.linalg.norm(triple[2 - part]))
    else:
        assert np.array_equal(moved[2 - part], triple[2 - part])


def test_a_joint_that_is_moved_whole_keeps_its_types():
    triple = np.array([(-1.0, 0, 0), (0, 0, 0), (2, 0, 0)])
    moved, pair = handles.moved(triple, ('A', 'V'), dict(enumerate(triple + 5)))
    assert pair == ('A', 'V') and np.array_equal(moved, triple + 5)


# Through verbs -------------------------------------------------------------------------------------------------------


def chain(count=5, closed=False, seed=6, smooth=True):
    points = some_points(count, seed)
    tangents = some_points(2 * count, seed + 1).reshape(count, 2, 3)
    if closed:
        points, tangents = np.append(points, points[:1], 0), np.append(tangents, tangents[:1], 0)
    return sc.HermiteCurve(points, tangents)


LETTERS = "FAAVVLLFAL"


def after(value, types, verb, number=0):
    before = definitions.from_value(value)
    handles.require_valid(types, before)
    changed = verbs.changed(before, number, verb)
    found = handles.carried(types, before, changed)
    handles.require_valid(found, changed.definition)
    return found


def test_types_go_through_verbs():
    assert after(chain(), (LETTERS,), verbs.reverse()) == (LETTERS[::-1],)
    assert after(chain(), (LETTERS,), verbs.split(2.0)) == (LETTERS[:6], LETTERS[4:])
    assert after(chain(), (LETTERS,), verbs.to_nurbs()) == ("",)
    assert after(chain(), (LETTERS,), verbs.to_bezier_chain()) == tuple(LETTERS[i:i + 4] for i in (0, 2, 4, 6))
    assert after([chain(), chain(seed=9)], (LETTERS, ""), verbs.reverse(), 1) == (LETTERS[::-1], "")
    halves = after(chain(), (LETTERS,), verbs.split(1.5))
    assert halves == (LETTERS[:4] + "LL", "LL" + LETTERS[4:])


def test_a_closed_chain_that_is_split_keeps_its_types():
    parts = after(chain(closed=True), (LETTERS,), verbs.split(2.0))
    assert parts == (LETTERS[:6], LETTERS[4:] + LETTERS[:2])


def test_joined_chains_are_nurbs_and_have_none():
    before = definitions.from_value([chain(), chain(seed=9)])
    changed = joints.joined(before, 1, 2, 'C0')
    assert handles.carried((LETTERS, LETTERS), before, changed) == ("",)


@pytest.mark.parametrize('types', ((), ("",), ("FF", ""), (LETTERS, "AX"), (LETTERS + "AA", ""), [LETTERS, ""], (LETTERS, 3),
                                   (LETTERS, None), "AA", None))
def test_what_are_no_types_is_refused(types):
    before = definitions.from_value([chain(), sc.BezierCurve(some_points(3))])
    handles.require_valid((LETTERS, ""), before)
    with pytest.raises(failures.Refusal):
        handles.require_valid(types, before)
