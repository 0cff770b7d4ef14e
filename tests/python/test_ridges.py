"""Creases along which surfaces touch, and level faces between them: terrain of whole heights against its closed form."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc


def terrain(heights, degrees=(1, 1)):
    heights = np.array(heights, float)
    x, y = np.meshgrid(*(np.arange(n, dtype=float) for n in heights.shape), indexing="ij")
    knots = [np.r_[[0.0] * p, np.arange(n - p + 1), [n - p] * p] for n, p in zip(heights.shape, degrees)]
    return sc.NurbsPatch(degrees, knots, np.stack([x, y, heights], -1))


def lengths(found, kind=None):
    return sum(curve.length() for curve, word in zip(found.curves, found.kinds) if kind in (None, word))


def test_a_ridge_is_one_touching_curve():
    """It was a crossing there and back, of twice its length."""
    for heights in ([[1, 1, 1, 1], [0, 5, 5, 0], [1, 1, 1, 1]], [[7, 8, 9, 9], [9, 5, 5, 6], [7, 7, 7, 7]]):
        for patch in (terrain(heights), terrain(heights).reversed("v"), terrain(heights).swapped()):
            found = patch.plane_sections((0, 0, 5), (0, 0, 1))
            assert found.kinds == ("touching",) and not found.are_one
            assert found.curves[0].length() == pytest.approx(1, abs=1e-9)


def test_a_ridge_that_becomes_a_crossing_is_cut_there():
    found = terrain([[0, 0], [1, 1], [0, 2]]).plane_sections((0, 0, 1), (0, 0, 1))
    assert lengths(found, "touching") == pytest.approx(0.5, abs=1e-9)
    assert lengths(found, "crossing") == pytest.approx(1.5, abs=1e-9)


def test_a_crossing_along_creases_of_both_is_given_once():
    """It was given from both sides of the creases, as long as 3.064 in all."""
    one = terrain([[0, 1, 2, 0], [0, 0, 1, 2], [1, 2, 0, 1], [0, 0, 2, 0]])
    other = terrain([[2, 1, 1], [2, 0, 2]])
    pairs = ((one, other), (other, one), (one.reversed("u"), other.swapped()), (one.swapped(), other))
    for first, second in pairs:
        found = first.sections(second)
        assert lengths(found, "crossing") == pytest.approx(1.5 * 2**0.5, rel=1e-8)
        assert lengths(found, "touching") == pytest.approx(0.5**0.5, rel=1e-8)


def on_one_crease(rng):
    """A bilinear patch, and a terrain that has one of its creases on it."""
    n = int(rng.integers(3, 5))
    heights = rng.integers(0, 3, (n, n)).astype(float)
    corners = rng.integers(0, 3, (2, 2)).astype(float)
    sheet = sc.BezierPatch([[(0, 0, corners[0, 0]), (0, n - 1, corners[0, 1])], [(n - 1, 0, corners[1, 0]), (n - 1, n - 1, corners[1, 1])]])
    crease = int(rng.integers(1, n - 1))
    u, v = crease / (n - 1), np.linspace(0, 1, n)
    heights[crease] = np.array([1 - u, u]) @ corners @ np.array([1 - v, v])
    return terrain(heights), sheet


def parts_twice(found):
    """Pairs of curves of which one runs along a part of the other."""
    pairs = []
    for i, curve in enumerate(found.curves):
        inner = curve.evaluate(np.linspace(*curve.domain, 41)[1:-1])
        pairs += [(i, j) for j, other in enumerate(found.curves) if i != j and (other.nearest(inner).distances < 1e-5).sum() > 3]
    return pairs


def test_creases_on_a_smooth_patch_are_given_once_and_without_splinters(inputs):
    """They were given from both sides, and ridges that end in a corner without an angle had crossings of 1e-5 there."""
    refused = 0
    for seed in range(inputs(200)):
        one, other = on_one_crease(np.random.default_rng([seed, 78]))
        found = []
        for a, b in ((one, other), (other, one), (one.reversed("u"), other.swapped()), (one.swapped(), other)):
            try:
                found.append(a.sections(b))
            except sc.InvalidShape as error:
                assert "cannot be followed" in str(error), seed
                refused += 1
        assert not any(map(parts_twice, found)), seed
        totals = [lengths(each) for each in found]
        assert totals == pytest.approx(totals[:1] * len(totals), rel=1e-6), seed
    assert refused <= inputs(200) // 25


def test_bent_ridges_touch_a_plane(inputs):
    for seed in range(inputs(40)):
        rng = np.random.default_rng([seed, 403])
        ridge = np.c_[np.linspace(-1, 1, 3) + rng.uniform(-0.2, 0.2, 3), rng.uniform(-0.4, 0.4, 3), np.zeros(3)]
        sides = [ridge + [0, side, 0] - np.c_[np.zeros((3, 2)), rng.uniform(0.2, 1, 3)] for side in (-1, 1)]
        roof = sc.NurbsPatch((1, 2), ([0, 0, 0.5, 1, 1], [0, 0, 0, 1, 1, 1]), [sides[0], ridge, sides[1]])
        motion = np.c_[Rotation.from_quat(rng.normal(size=4)).as_matrix() * 10.0**rng.uniform(-2, 2), rng.normal(size=3)]
        normal = motion[:, :3] @ [0, 0, 1]
        found = roof.transformed(motion).plane_sections(motion[:, 3], normal)
        length = sc.BezierCurve(ridge @ motion[:, :3].T + motion[:, 3]).length()
        assert set(found.kinds) == {"touching"}, seed
        assert lengths(found) == pytest.approx(length, rel=1e-5), seed


def branch_length(corners):
    """Of the zeros of a bilinear function inside a cell, u0 v0, u0 v1, u1 v0, u1 v1."""
    a, b, c, d = corners
    bend = a - b - c + d
    if bend == 0:
        ends = [(t, -(a + (c - a) * t) / (b - a)) for t in (0, 1) if b != a]
        ends += [(-(a + (b - a) * t) / (c - a), t) for t in (0, 1) if c != a]
        ends = np.array([e for e in ends if -1e-9 <= min(e) and max(e) <= 1 + 1e-9]).reshape(-1, 2)
        if len(ends) < 2:
            return 0.0
        far = np.linalg.norm(ends[:, None] - ends, axis=-1)
        i, j = np.unravel_index(far.argmax(), far.shape)
        middle = (ends[i] + ends[j]) / 2
        return far.max() if 1e-9 < middle.min() and middle.max() < 1 - 1e-9 else 0.0
    u0, v0 = (a - b) / bend, (a - c) / bend
    rest = -(a - bend * u0 * v0) / bend
    if abs(rest) < 1e-12:
        return float(1e-9 < u0 < 1 - 1e-9) + float(1e-9 < v0 < 1 - 1e-9)
    total = 0.0
    for side in (-1, 1):
        t = np.linspace(0, 1, 4001)
        u, v = t[side * (t - u0) > 1e-12], t[side * np.sign(rest) * (t - v0) > 1e-12]
        at = np.r_[np.c_[u, v0 + rest / (u - u0)], np.c_[u0 + rest / (v - v0), v]]
        at = at[(at.min(1) >= -1e-12) & (at.max(1) <= 1 + 1e-12)]
        at = at[np.argsort(at[:, 0] - np.sign(rest) * at[:, 1])]
        total += np.linalg.norm(np.diff(at, axis=0), axis=1).sum()
    return total


def expected(heights, level):
    """The length of all curves, that of ridges, and whether there is a level face."""
    heights = np.array(heights, float) - level
    total = ridges = 0.0
    for i, j in np.ndindex(heights.shape[0] - 1, heights.shape[1] - 1):
        total += branch_length(heights[i:i + 2, j:j + 2].ravel()) if heights[i:i + 2, j:j + 2].any() else 0.0
    t = (np.arange(2000) + 0.5) / 2000
    for grid in (heights, heights.T):
        rows, columns = grid.shape
        for i, j in np.ndindex(rows, columns - 1):
            if grid[i, j] or grid[i, j + 1]:
                continue
            beside = [grid[k, j] * (1 - t) + grid[k, j + 1] * t for k in (i - 1, i + 1) if 0 <= k < rows]
            total += len(beside) == 1 or any(side.any() for side in beside)
            ridges += (beside[0] * beside[1] > 0).mean() if len(beside) == 2 else 0.0
    levels = [not heights[i:i + 2, j:j + 2].any() for i, j in np.ndindex(heights.shape[0] - 1, heights.shape[1] - 1)]
    return total, ridges, any(levels)


def test_terrain_of_whole_heights(inputs):
    """Level faces at borders, of which an edge is one of the patch's own, were refused after 12 s."""
    for seed in range(inputs(240)):
        rng = np.random.default_rng([seed, 404])
        heights, level = rng.integers(0, 3, rng.integers(2, 7, 2)), int(rng.integers(0, 3))
        patch = terrain(heights)
        patch = [patch, patch.reversed("u"), patch.swapped(), patch.swapped().reversed("u")][seed % 4]
        found = patch.plane_sections((0, 0, level), (0, 0, 1))
        total, ridges, is_one = expected(heights, level)
        assert found.are_one == is_one, seed
        assert lengths(found) == pytest.approx(total, abs=1e-3), seed
        assert lengths(found, "touching") == pytest.approx(ridges, abs=1e-3), seed
