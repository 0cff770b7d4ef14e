"""Patches of every kind, the same ones at every call, and where their points lie after a verb."""

import itertools

import numpy as np

import shapes
from shapes import CLAMPED, VALUES, points
from support import splinecore as sc

LETTERS = 'uv'
DIRECTIONS = {'U': 'u', 'V': 'v', 'BOTH': 'uv'}
UNIFORM = np.arange(9.0)


def rational(knots_u, knots_v, counts, periodic=(False, False)):
    return sc.NurbsPatch((3, 2), (knots_u, knots_v), points(*counts), shapes.RANDOM.uniform(0.5, 2, counts), periodic)


MORE = {
    'rational nurbs': lambda: rational(CLAMPED, [0, 0, 0, 1 / 3, 2, 3, 3, 3], (6, 5)),
    'uniform': lambda: rational(UNIFORM - 3, UNIFORM[:7] - 2, (5, 4)),
    'both periodic': lambda: rational(UNIFORM[:6] / 3, UNIFORM[:5], (5, 4), (True, True)),
    'torus': lambda: sc.build.torus((0, 0, 0), (0, 0, 1), 2.0, 0.5).clamped('u').clamped('v'),
    'cylinder': lambda: sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0),
    'sphere': lambda: sc.build.sphere((0, 0, 0), 2.0),
    'bicubic': lambda: sc.BezierPatch(points(4, 4)),
    'biquintic': lambda: sc.BezierPatch(points(6, 6)),
    'plain nurbs': lambda: sc.NurbsPatch((3, 3), (CLAMPED, CLAMPED), points(6, 6)),
    'bilinear': lambda: sc.BezierPatch(points(2, 2)),
    'four around a corner': lambda: around_a_corner(),
}


def value_of(kind):
    """The same one at every call."""
    shapes.RANDOM.bit_generator.state = np.random.default_rng(7).bit_generator.state
    return (VALUES.get(kind) or MORE[kind])()


def around_a_corner():
    """Four bicubic rational patches on one grid of points, each turned in another way."""
    grid, weights = points(7, 7), shapes.RANDOM.uniform(0.5, 2, (7, 7))
    turns = (lambda net: net, lambda net: net[::-1], lambda net: net[:, ::-1], lambda net: net.swapaxes(0, 1)[::-1])
    patches = []
    for turn, (i, j) in zip(turns, itertools.product((0, 3), (0, 3))):
        part = np.s_[i:i + 4, j:j + 4]
        patches.append(sc.BezierPatch(turn(grid[part]), turn(weights[part])))
    return sc.PatchSet.from_patches(patches)


def patches_of(ob):
    value = ob.data.splinewright.value
    return [value[i] for i in range(len(value))] if isinstance(value, sc.PatchSet) else [value]


def meetings(patch_set):
    """In how many places two patches share points, for each two that share as many as an edge has."""
    rows = [set(patch['indices'].ravel().tolist()) for patch in patch_set.patches]
    places = {(a, b): len({tuple(patch_set.points[row]) for row in rows[a] & rows[b]})
              for a, b in itertools.combinations(range(len(rows)), 2)}
    return {pair: count for pair, count in places.items() if count > 2}


def size_of(patches):
    return max(np.abs(patch.points).max() for patch in patches)


def distinct_knots(patch, axis):
    start, end = patch.domain[axis]
    knots = patch.to_nurbs().knots[axis]
    return np.unique(knots[(knots >= start) & (knots <= end)])


def is_periodic(patch, axis):
    return getattr(patch, 'periodic', (False, False))[axis]


def breaks_of(patch, axis, name, settings):
    """The parameters between which the parts lie that come out, on the patch that went in."""
    start, end = patch.domain[axis]
    if name == 'to_bezier':
        return distinct_knots(patch, axis)
    if name == 'split' and LETTERS[axis] in DIRECTIONS[settings.get('direction', 'U')]:
        if settings.get('where') == 'KNOTS':
            return distinct_knots(patch, axis)
        at = settings[f'parameter_{LETTERS[axis]}']
        return [at, at + end - start] if is_periodic(patch, axis) else [start, at, end]
    return [start, end]


def fractions_before(fractions, axis, name, settings):
    """Where, as parts of the domain along an axis, points lay that now lie at these parts."""
    if LETTERS[axis] not in DIRECTIONS[settings.get('direction', 'U')]:
        return fractions
    if name == 'reverse':
        return 1 - fractions
    if settings.get('how') == 'MOEBIUS':
        rho = settings['rho']
        return rho * fractions / (1 - fractions + rho * fractions)
    return fractions


def on_grid(patch, at):
    """Points of a patch at the parameters of each axis; a periodic one goes on beyond its domain."""
    for axis, (start, end) in enumerate(patch.domain):
        if is_periodic(patch, axis):
            at[axis] = start + (at[axis] - start) % (end - start)
    return patch.evaluate_grid(*at)


def farthest(before, after, name, settings):
    """The largest distance of points of the patches that came out of one from where they were."""
    fractions, worst = np.linspace(0, 1, 20)[1:-1], 0.0
    breaks = [breaks_of(before, axis, name, settings) for axis in (0, 1)]
    spans = list(itertools.product(*(list(zip(ends, ends[1:])) for ends in breaks)))
    assert len(after) == len(spans)
    for patch, span in zip(after, spans):
        own = [start + fractions * (end - start) for start, end in patch.domain]
        was = [begin + fractions_before(fractions, axis, name, settings) * (end - begin)
               for axis, (begin, end) in enumerate(span)]
        points = patch.evaluate_grid(*own)
        if name == 'swap_uv':
            points = points.swapaxes(0, 1)
        worst = np.maximum(worst, np.abs(points - on_grid(before, was)).max())
    return worst
