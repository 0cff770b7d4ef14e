"""Random hard edits of sets of patches that share their borders: what was closed stays closed, and moves stay bounded."""

from dataclasses import replace

import numpy as np

import splinecore as sc
from addon_core import core

bounds, definitions, holds, joints = core("joints.held_bounds"), core("shape.definition"), core("joints.held"), core("joints.patch_joints")
seams, strips, verbs, patch_verbs = core("joints.seams"), core("joints.held_strips"), core("verbs.verbs"), core("verbs.patch_verbs")
SIDES = ('u_start', 'u_end', 'v_start', 'v_end')
#: Continuity sees this much where seams cross.
_SEEN = core("joints.joints").SMOOTH


def knots(rng, degree):
    return np.concatenate([[0.0] * (degree + 1), np.sort(rng.uniform(0.05, 0.95, rng.integers(0, 4))), [1.0] * (degree + 1)])


def whole(rng, least):
    """Steep or flat, large or small, far from the origin or at it, rational or not."""
    degree = [int(n) for n in rng.integers(least, 6, 2)]
    along = [knots(rng, p) for p in degree]
    u, v = np.meshgrid(*(np.linspace(0, 1, len(one) - p - 1) for one, p in zip(along, degree)), indexing='ij')
    steep = 10 ** rng.uniform(-2, 0.3)
    points = np.stack([u, v * 10 ** rng.uniform(-1, 1), rng.uniform(-steep, steep, u.shape)], -1)
    points = 10 ** rng.uniform(-3, 3) * (points + rng.normal(size=3) * 10 ** rng.uniform(-1, 1))
    return sc.NurbsPatch(degree, along, points, rng.uniform(0.3, 3.0, u.shape) if rng.random() < 0.4 else None)


def cut(rng, patches, axis):
    start, end = patches[0].domain['uv'.index(axis)]
    at = start + (end - start) * rng.uniform(0.05, 0.95)
    return [part for patch in patches for part in patch.split(axis, at)]


def patch_set(rng, least=1):
    """Patches in rows and columns, each turned or exchanged as it comes."""
    rows = [whole(rng, least)]
    for _ in range(rng.integers(0, 3)):
        rows = [*rows[:-1], *cut(rng, rows[-1:], 'u')]
    places = [(0.0, 1.0)]
    for _ in range(rng.integers(1, 3)):
        low, high = places.pop()
        middle = low + (high - low) * rng.uniform(0.05, 0.95)
        places += [(low, middle), (middle, high)]
    patches = []
    for row in rows:
        for low, high in places[:-1]:
            part, row = row.split('v', high)
            patches.append(part)
        patches.append(row)
    return definitions.from_value(sc.PatchSet.from_patches([turned(rng, patch) for patch in patches]))


def turned(rng, patch):
    for axis in 'uv':
        patch = patch.reversed(axis) if rng.random() < 0.5 else patch
    return patch.swapped() if rng.random() < 0.5 else patch


def open_border(definition):
    """The length of all sides that no other patch has."""
    value = definitions.to_patch_set(definition)
    shared = {side for pair in value.seams() for side in pair}
    return sum(value[i].boundary(side).length() for i in range(len(value)) for side in SIDES if (i, side) not in shared)


def split(rng, definition):
    """The verbs.Changed that cutting one patch in one direction, or in both, makes, as Split does."""
    number, axes = int(rng.integers(len(definition.pieces))), str(rng.choice(['u', 'v', 'uv']))
    part = {axis: rng.uniform(0.02, 0.98) for axis in axes}
    domain = dict(zip('uv', verbs.pieces_of(definition)[number].domain))
    make = lambda axis, carry, spent: verbs.split(carry(domain[axis][0] + part[axis] * (domain[axis][1] - domain[axis][0])))
    return verbs.each_changed(definition, patch_verbs.with_neighbors(definition, number, axes, make))


def require_closed(before, changed):
    assert not seams.opened(before, changed.definition, changed.parents)
    was, now = open_border(before), open_border(changed.definition)
    assert abs(now - was) <= 1e-9 * was


def held_of(rng, definition):
    """Some of its seams, which hold."""
    smoothness = str(rng.choice(joints.SMOOTHNESS[1:3]))
    pairs = definitions.to_patch_set(definition).seams()
    chosen = rng.choice(len(pairs), min(len(pairs), int(rng.integers(1, 4))), replace=False)
    return tuple(holds.Held(*pairs[i], smoothness, str(rng.choice(joints.MOVES))) for i in chosen)


def moved(rng, definition, rows):
    """(the definition after a hand has moved some rows of the pool, which those are, by how much)."""
    led = rng.choice(rows, min(int(rng.choice([1, 1, 2, 5])), len(rows)), replace=False)
    size = 10 ** rng.uniform(-2, 0.3) * np.linalg.norm(np.ptp(definition.pool[:, :3], axis=0))
    steps = rng.normal(size=(len(led), 3))
    pool = definition.pool.copy()
    pool[led, :3] += steps * (size / np.linalg.norm(steps, axis=1).max())
    return replace(definition, pool=pool), set(led.tolist()), size


def pairs_of(definition):
    return set(definitions.to_patch_set(definition).seams())


def test_splits_keep_closed_what_was_closed(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([71, seed])
        definition = patch_set(rng)
        for _ in range(2):
            changed = split(rng, definition)
            assert len(changed.definition.pieces) > len(definition.pieces)
            require_closed(definition, changed)
            definition = changed.definition


def test_moves_keep_closed_what_was_closed_and_holds_stay_bounded(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([72, seed])
        definition = patch_set(rng, least=3)
        seams_held = held_of(rng, definition)
        rows = np.unique(np.concatenate([strip.rows.ravel() for one in seams_held for strip in strips.strips_of(definition, one)]))
        now, led, size = moved(rng, definition, rows)
        found = bounds.kept(now, seams_held, led, definition.pool)
        assert pairs_of(found.definition) == pairs_of(definition)
        assert np.linalg.norm(found.definition.pool[:, :3] - now.pool[:, :3], axis=1).max() <= 1.001 * bounds.REACH * size
        require_kept(found, seams_held)


def require_kept(found, seams_held):
    lost, value = dict(found.lost), definitions.to_patch_set(found.definition)
    for one in seams_held:
        (first, side), (second, other) = one.first, one.second
        measured = sc.seam_continuity(value[first], side, value[second], other, tolerance=_SEEN)
        assert measured.g >= int(lost.get(one, one.smoothness)[1]), (one, measured)


def test_joins_in_sets_open_no_other_seam_and_stay_bounded(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([73, seed])
        definition, _, size = moved(rng, base := patch_set(rng, least=3), np.arange(len(base.pool)))
        (first, side), (second, other) = sorted(pairs_of(definition))[int(rng.integers(len(pairs_of(definition))))]
        smoothness, moves = str(rng.choice(joints.SMOOTHNESS[1:3])), str(rng.choice(joints.MOVES))
        made = joints.joined(definition, joints.Choice(first + 1, side), joints.Choice(second + 1, other), smoothness, moves)
        assert made.came_apart == () and pairs_of(made.changed.definition) == pairs_of(definition)
        assert made.measured.g >= int(smoothness[1])
        way = np.linalg.norm(made.changed.definition.pool[:, :3] - definition.pool[:, :3], axis=1).max()
        assert way <= 10 * size


def test_what_holds_goes_on_holding_in_all_parts_of_a_cut_seam(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([74, seed])
        definition = patch_set(rng, least=3)
        seams_held = held_of(rng, definition)
        changed = split(rng, definition)
        carried = holds.carried(seams_held, changed.parents, definition, changed.definition)
        parts = {tuple(sorted((a[0], b[0]))) for a, b in pairs_of(changed.definition)
                 if {changed.parents[a[0]], changed.parents[b[0]]} in [{one.first[0], one.second[0]} for one in seams_held]}
        assert {tuple(sorted((one.first[0], one.second[0]))) for one in carried} == parts
        rows = np.unique(np.concatenate([strip.rows.ravel() for one in carried for strip in strips.strips_of(changed.definition, one)]))
        now, led, size = moved(rng, changed.definition, rows)
        found = bounds.kept(now, carried, led, changed.definition.pool)
        assert pairs_of(found.definition) == pairs_of(changed.definition)
        assert np.linalg.norm(found.definition.pool[:, :3] - now.pool[:, :3], axis=1).max() <= 1.001 * bounds.REACH * size
        require_kept(found, carried)
