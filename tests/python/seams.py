"""Sides of patches: pairs to join, and what lies on both sides of a seam by the derivatives alone."""

import numpy as np

import splinecore as sc
from random_curves import ENDS, random_knots, random_weights

SIDES = ("u_start", "u_end", "v_start", "v_end")
OPPOSITE = {"u_start": "u_end", "u_end": "u_start", "v_start": "v_end", "v_end": "v_start"}


def joinable(rng, side, degrees=(1, 9), positive=True, ends=None, spans=(1, 3)):
    """A patch that ends at the side: plain across it, of any kind along it unless told."""
    along = ends or ENDS[rng.integers(3)]
    kinds = [ENDS[rng.integers(2)], along] if side[0] == "u" else [along, ENDS[rng.integers(2)]]
    degree = [int(rng.integers(degrees[0], degrees[1] + 1)) for _ in "uv"]
    # A period of one span may have one point alone, and no length.
    least = [max(spans[0], 2) if kind == "periodic" else spans[0] for kind in kinds]
    knots = [random_knots(rng, p, int(rng.integers(few, max(few, spans[1]) + 1)), kind)
             for p, few, kind in zip(degree, least, kinds)]
    count = [len(k) - 1 if kind == "periodic" else len(k) - p - 1 for p, k, kind in zip(degree, knots, kinds)]
    weights = random_weights(rng, count[0] * count[1], positive).reshape(count)
    return sc.NurbsPatch(degree, knots, rng.uniform(-10, 10, (*count, 3)), weights,
                         [kind == "periodic" for kind in kinds])


def pairs(seed, count, rational=None, **kind):
    """(first, side, second, side): all sixteen pairs of sides, every second pair without weights unless told."""
    rng = np.random.default_rng(seed)
    for index in range(count):
        sides = SIDES[index % 4], SIDES[index // 4 % 4]
        both = [joinable(rng, side, **kind) for side in sides]
        if not (index % 2 == 0 if rational is None else rational):
            both = [patch.with_weights(np.ones(patch.weights.shape)) for patch in both]
        yield both[0], sides[0], both[1], sides[1]


def shaken(patch, rng, size=None):
    """The patch with other last digits: in points, weights and knots, or in points alone, of numbers of that size."""
    def other(values, of):
        return values + of * 2.0 ** -52 * rng.choice([-1.0, 0.0, 1.0], np.shape(values))

    if size is not None:
        return patch.with_points(other(patch.points, size))
    distinct = [np.unique(knots, return_inverse=True) for knots in patch.knots]
    return sc.NurbsPatch(patch.degree, [other(values, values)[places] for values, places in distinct],
                         other(patch.points, patch.points), other(patch.weights, patch.weights), patch.periodic)


def rounding_of(measure, first, second, rng, **kind):
    """How far apart the last digits of two patches bring the numbers that are measured of them."""
    found = [np.array(measure(first, second))]
    found += [np.array(measure(shaken(first, rng, **kind), shaken(second, rng, **kind))) for _ in range(4)]
    return np.max(np.abs(found - found[0]), axis=0)


def unlikeness(first, side, second, other):
    """How many times as large legs beside the edge are on one side as on the other, of like derivatives."""
    def pace(patch, at):
        axis = "uv".index(at[0])
        start, end = patch.domain[axis]
        knots = np.unique(np.clip(patch.knots[axis], start, end))
        return patch.degree[axis] / (knots[-1] - knots[-2] if at.endswith("end") else knots[1] - knots[0])

    paces = pace(first, side), pace(second, other)
    return max(paces) / min(paces)


def jet(patch, side, t, outwards, reversed=False):
    """Derivatives (n, 3, 3, 3), [k, l] being k across a side and l along it, at shares t of it that are no knots.

    Across is out of the patch or into it; `reversed` goes along the side the other way.
    """
    i = "uv".index(side[0])
    start, end = patch.domain[1 - i]
    along = start + (1 - t if reversed else t) * (end - start)
    across = np.full_like(along, patch.domain[i][side.endswith("end")])
    inward = "left" if side.endswith("end") else "right"
    at, sides = ((across, along), (inward, "right")) if i == 0 else ((along, across), ("right", inward))
    found = patch.derivatives(*at, 2, side=sides)
    found = found if i == 0 else found.swapaxes(-3, -2)
    turns = np.array([1, 1 if side.endswith("end") == outwards else -1, 1])[:, None] * [1, -1 if reversed else 1, 1]
    return turns[..., None] * found


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def normals(found):
    return unit(np.cross(found[:, 1, 0], found[:, 0, 1]))


def curvature_across(found):
    """The normal curvature at right angles to the seam: both fundamental forms in that direction."""
    def dot(a, b):
        return (a * b).sum(-1)

    across, along, normal = found[:, 1, 0], found[:, 0, 1], normals(found)
    share = -dot(across, along) / dot(along, along)
    way = across + share[:, None] * along
    bend = found[:, 2, 0] + 2 * share[:, None] * found[:, 1, 1] + share[:, None] ** 2 * found[:, 0, 2]
    return dot(bend, normal) / dot(way, way)
