"""Seams that hold are smooth again after any change of either side, and what need not move stays."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

definitions, failures, held_seams, joints = core("shape.definition"), core("base.failures"), core("joints.held"), core("joints.patch_joints")
Held = held_seams.Held
KINDS = [(smoothness, moves) for smoothness in joints.SMOOTHNESS for moves in joints.MOVES]


def patches(count, seed, rational):
    """Neighbors along u, bumpy."""
    rng = np.random.default_rng(seed)
    u, v = np.meshgrid(np.arange(6.0), np.arange(5.0), indexing='ij')
    knots = [0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [0, 0, 0, 0, 1, 2, 2, 2, 2]
    made = []
    for i in range(count):
        points = np.stack([u + 5 * i, v, np.zeros_like(u)], -1) + rng.uniform(-0.2, 0.2, (6, 5, 3))
        made.append(sc.NurbsPatch((3, 3), knots, points, rng.uniform(0.8, 1.2, (6, 5)) if rational else None))
    return made


def joined(count, smoothness, moves, seed=0, rational=False):
    """A definition of patches that are joined in a row, and the Helds of that."""
    definition = definitions.from_value(sc.PatchSet.from_patches(patches(count, seed, rational)))
    seams = []
    for i in range(count - 1):
        seams.append(Held((i, 'u_end'), (i + 1, 'u_start'), smoothness, moves))
        definition = joints.joined(definition, joints.Choice(i + 1, 'u_end'), joints.Choice(i + 2, 'u_start'), smoothness,
                                   moves).changed.definition
    return definition, seams


def require_smooth(definition, seams):
    patch_set = definitions.to_patch_set(definition)
    for seam in seams:
        found = sc.seam_continuity(patch_set[seam.first[0]], seam.first[1], patch_set[seam.second[0]], seam.second[1])
        letter, order = seam.smoothness
        assert (found.c if letter == 'C' else found.g) >= int(order)


def shaken(definition, seed, part=1.0):
    rng = np.random.default_rng(seed)
    pool = definition.pool.copy()
    chosen = rng.random(len(pool)) < part
    pool[chosen, :3] += rng.uniform(-0.1, 0.1, (chosen.sum(), 3))
    return definition.__class__(definition.form, pool, definition.pieces)


@pytest.mark.parametrize('rational', (False, True))
@pytest.mark.parametrize('smoothness, moves', KINDS)
def test_a_seam_holds_whatever_moves(smoothness, moves, rational):
    definition, seams = joined(2, smoothness, moves, rational=rational)
    require_smooth(definition, seams)
    assert held_seams.applied(definition, seams) is definition
    for seed in range(5):
        after = held_seams.applied(shaken(definition, seed), seams)
        require_smooth(after, seams)
        assert [piece.indices.tolist() for piece in after.pieces] == [piece.indices.tolist() for piece in definition.pieces]
        assert held_seams.applied(after, seams) is after


@pytest.mark.parametrize('smoothness, moves', KINDS)
def test_several_seams_in_a_row_hold_together(smoothness, moves):
    definition, seams = joined(3, smoothness, moves if moves != 'both' else 'second')
    for seed in range(3):
        require_smooth(held_seams.applied(shaken(definition, seed), seams), seams)


def resized(definition, size, offset):
    pool = definition.pool.copy()
    pool[:, :3] = pool[:, :3] * size + offset
    return definition.__class__(definition.form, pool, definition.pieces)


@pytest.mark.parametrize('rational', (False, True))
@pytest.mark.parametrize('size, offset', ((1e-150, 0), (1e-20, 0), (1e-6, 0), (1e20, 0), (1e150, 0), (1, 1e6), (1e-3, 1e4), (1, -1e8)))
@pytest.mark.parametrize('smoothness, moves', [('C0', 'second'), ('G1', 'second'), ('C1', 'both'), ('G2', 'first'), ('C2', 'second')])
def test_a_seam_holds_at_every_size_and_far_away(smoothness, moves, size, offset, rational):
    definition, seams = joined(3 if moves == 'second' else 2, smoothness, moves, rational=rational)
    there = resized(definition, size, offset)
    for seed in range(2):
        moved = resized(shaken(definition, seed), size, offset)
        expected = held_seams.applied(shaken(definition, seed), seams)
        after = held_seams.applied(moved, seams)
        digits = max(1e-10, 1e-14 * abs(offset) / size * 1e2)
        assert np.allclose((after.pool[:, :3] - offset) / size, expected.pool[:, :3], rtol=0, atol=digits)
        assert np.allclose(after.pool[:, 3], expected.pool[:, 3], rtol=1e-9)
    assert np.abs(held_seams.applied(there, seams).pool - there.pool).max() <= 1e-13 * max(size, abs(offset), 1)


def test_only_rows_beside_the_seam_of_the_patch_that_gives_way_move():
    definition, seams = joined(2, 'G1', 'second')
    moved = shaken(definition, 1, part=0.3)
    after = held_seams.applied(moved, seams)
    changed = set(np.flatnonzero((after.pool != moved.pool).any(1)).tolist())
    assert changed <= set(after.pieces[1].indices[:2].ravel().tolist()) - set(after.pieces[0].indices.ravel().tolist())


def test_what_cannot_hold_is_refused_in_words():
    definition, seams = joined(2, 'G1', 'second')
    one, other = (definitions.to_patch_set(definition)[i] for i in (0, 1))
    finer = definitions.from_value(sc.PatchSet.from_patches([one.to_nurbs().insert_knot('v', 0.5), other]))
    with pytest.raises(failures.Refusal, match="none any more"):
        held_seams.applied(finer, seams)
    narrow = sc.NurbsPatch((1, 3), ([0, 0, 1, 1], other.knots[1]), other.points[:2], other.weights[:2])
    with pytest.raises(failures.Refusal, match="other knots or degrees"):
        held_seams.applied(definitions.from_value(sc.PatchSet.from_patches([one, narrow])), seams)
    for wrong in (Held((0, 'u_end'), (2, 'u_start'), 'G1', 'second'), Held((0, 'top'), (1, 'u_start'), 'G1', 'second'),
                  Held((0, 'u_end'), (0, 'u_end'), 'G1', 'second'), Held((0, 'u_end'), (1, 'u_start'), 'G9', 'second'),
                  Held((0, 'u_end'), (1, 'u_start'), 'G1', 'none'), Held((-1, 'u_end'), (1, 'u_start'), 'G1', 'first')):
        with pytest.raises(failures.Refusal):
            held_seams.require_valid(wrong, definition)
    held_seams.require_valid(seams[0], definition)
