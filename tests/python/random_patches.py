"""Patches of every kind by a seed, and how far two of them lie apart before the division by the weight."""

import numpy as np

import splinecore as sc
from random_curves import ENDS, random_knots, random_weights


def random_patch(rng, positive=True, degree=None, ends=None, spans=None):
    """degree, ends and spans are of both axes, or drawn for each."""
    degrees = [degree or int(rng.integers(1, 10)) for _ in "uv"]
    kinds = [ends or ENDS[rng.integers(3)] for _ in "uv"]
    knots = [random_knots(rng, p, spans or int(rng.integers(1, 4)), kind) for p, kind in zip(degrees, kinds)]
    count = [len(k) - 1 if kind == "periodic" else len(k) - p - 1 for p, k, kind in zip(degrees, knots, kinds)]
    weights = random_weights(rng, count[0] * count[1], positive).reshape(count)
    return sc.NurbsPatch(degrees, knots, rng.uniform(-10, 10, (*count, 3)), weights,
                         [kind == "periodic" for kind in kinds])


def random_patches(seed, count=1000, **kind):
    """Half of them with positive weights unless told."""
    rng = np.random.default_rng(seed)
    for index in range(count):
        yield random_patch(rng, **{"positive": index % 2 == 0, **kind})


def homogeneous(patch, u, v):
    """The homogeneous points of a grid, (a, b, 4)."""
    nurbs = patch.to_nurbs()
    on_u, on_v = (sc.basis.Samples(knots, at) for knots, at in zip(nurbs.knot_vectors, (u, v)))
    rows = np.ascontiguousarray(on_u.apply(nurbs.homogeneous_points).transpose(1, 0, 2))
    return on_v.apply(rows).transpose(1, 0, 2)


def breaks(*patches, axis):
    """The distinct knots of the domain."""
    i = "uv".index(axis)
    start, end = patches[0].domain[i]
    knots = np.concatenate([patch.to_nurbs().knots[i] for patch in patches])
    return np.unique(np.r_[start, knots[(knots > start) & (knots < end)], end])


def parameters(*patches, axis, count=3):
    """Inside every span and at no knot, where a patch may jump."""
    knots = breaks(*patches, axis=axis)
    return (knots[:-1, None] + np.diff(knots)[:, None] * (np.arange(count) + 0.3) / count).ravel()


def error(before, after, map_u=lambda u: u, map_v=lambda v: v):
    """Largest difference of homogeneous points, relative to the largest coordinate of a control point."""
    u, v = parameters(before, axis="u"), parameters(before, axis="v")
    far = np.abs(homogeneous(before, u, v) - homogeneous(after, map_u(u), map_v(v))).max()
    return far / np.abs(before.to_nurbs().homogeneous_points).max()


def sampled_distance(before, after, count=24):
    """The largest distance found at many parameters of every span of both, nearly up to the ends of each."""
    def samples(axis):
        knots = breaks(before, after, axis=axis)
        return (knots[:-1, None] + np.diff(knots)[:, None] * np.r_[0, np.linspace(0, 1, count)[1:-1], 1 - 1e-9]).ravel()

    u, v = np.append(samples("u"), before.domain[0][1]), np.append(samples("v"), before.domain[1][1])
    return np.linalg.norm(before.evaluate_grid(u, v) - after.evaluate_grid(u, v), axis=-1).max()
