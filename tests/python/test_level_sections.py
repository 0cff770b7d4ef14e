"""A plane cuts patches of which whole pieces lie in it: the border of these, and lines of knots in it."""

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc

#: How far from a curve a place counts as missed, in parts of the patch.
NEAR = 1e-3


@dataclass
class Terrain:
    """A patch that is a graph over its parameters, but for its weights, with pieces of height 0."""

    patch: sc.NurbsPatch
    degrees: tuple
    knots: tuple
    heights: np.ndarray

    @property
    def breaks(self):
        return [np.unique(knots) for knots in self.knots]

    @property
    def level(self):
        """Of each piece whether it is level."""
        (p, q), (u, v) = self.degrees, self.breaks
        return np.array([[not self.heights[i:i + p + 1, k:k + q + 1].any() for k in range(len(v) - 1)] for i in range(len(u) - 1)])

    @property
    def size(self):
        return max(knots[-1] for knots in self.knots)


def knots_of(rng, count, degree):
    inner = np.arange(1, count - degree + 1) if rng.random() < 0.5 else np.cumsum(rng.uniform(0.2, 2, count - degree))
    return np.r_[[0.0] * (degree + 1), inner, [inner[-1]] * degree]


def means(knots, degree):
    """Control points of the function u (Greville)."""
    return np.array([knots[i + 1:i + degree + 1].mean() for i in range(len(knots) - degree - 1)])


def terrain(rng, lowest, heights):
    """One or two rectangles of control points lie in the plane."""
    degrees = tuple(int(degree) for degree in rng.integers(lowest, 5, 2))
    counts = [int(rng.integers(degree + 4, degree + 10)) for degree in degrees]
    knots = tuple(knots_of(rng, count, degree) for count, degree in zip(counts, degrees))
    z = heights(rng.normal(size=counts))
    for _ in range(rng.integers(1, 3)):
        first = [rng.integers(0, count - degree) for count, degree in zip(counts, degrees)]
        last = [rng.integers(at + degree + 1, count + 1) for at, count, degree in zip(first, counts, degrees)]
        z[first[0]:last[0], first[1]:last[1]] = 0
    points = np.stack([*np.meshgrid(*map(means, knots, degrees), indexing='ij'), z], -1)
    weights = None if rng.random() < 0.6 else rng.uniform(0.3, 3, counts)
    return Terrain(sc.NurbsPatch(degrees, knots, points, weights), degrees, knots, z)


def placement(rng):
    """A motion and a scale."""
    found = np.eye(4)
    found[:3, :3] = Rotation.from_quat(rng.normal(size=4)).as_matrix() * 10**rng.uniform(-4, 4)
    found[:3, 3] = rng.normal(size=3) * 10 * np.linalg.norm(found[0, :3])
    return found


def segments_of(found, back):
    """Short ones of all curves, (n, 2, 3), in the space of the terrain."""
    lines = [np.asarray(curve.evaluate(np.linspace(*curve.domain, 1000))) @ back[:3, :3].T + back[:3, 3] for curve in found.curves]
    return [np.stack([line[:-1], line[1:]], 1) for line in lines]


def distance(point, segments):
    start, way = segments[:, 0, :2], segments[:, 1, :2] - segments[:, 0, :2]
    share = np.clip(((point - start) * way).sum(1) / np.maximum((way * way).sum(1), 1e-300), 0, 1)
    return np.linalg.norm(start + way * share[:, None] - point, axis=1).min()


def border_places(of):
    """Parameters of places on the border of what is level."""
    level, (u, v) = np.pad(of.level, 1), of.breaks
    for i, k in np.argwhere(of.level):
        for side in (0, 1):
            for t in (0.1, 0.37, 0.8):
                if not level[i + 2 * side, k + 1]:
                    yield u[i + side], v[k] + t * (v[k + 1] - v[k])
                if not level[i + 1, k + 2 * side]:
                    yield u[i] + t * (u[i + 1] - u[i]), v[k + side]


def lines_with_borders(of, placed):
    """The Sections and their segments_of(), if these have the borders of all that is level."""
    origin, normal = placed[:3, 3], placed[:3, 2] / np.linalg.norm(placed[:3, 2])
    found = of.patch.transformed(placed).plane_sections(origin, normal)
    lines = segments_of(found, np.linalg.inv(placed))
    segments = np.concatenate(lines)
    assert found.are_one and np.abs(segments[..., 2]).max() <= 1e-4 * of.size
    for u, v in border_places(of):
        assert distance(of.patch.evaluate(u, v)[:2], segments) <= NEAR * of.size
    return found, lines


def check(of, placed):
    found, lines = lines_with_borders(of, placed)
    for i, line in enumerate(lines):
        others = [other for k, other in enumerate(lines) if k != i]
        looks = line[50:-50:80, 0, :2]
        near = [distance(point, np.concatenate(others)) < 1e-6 * of.size for point in looks] if others else []
        assert sum(near) <= len(looks) // 2, f"a curve is there twice: {found.kinds[i]}"


@pytest.mark.parametrize('lowest', [1, 2])
@pytest.mark.parametrize('heights', [lambda z: -abs(z) - 0.05, lambda z: abs(z) + 0.05], ids=['hill', 'bowl'])
def test_level_parts(inputs, heights, lowest):
    """Of every degree, alone and two that overlap; turned, moved and scaled."""
    rng = np.random.default_rng(lowest)
    for _ in range(inputs(1000)):
        of = terrain(rng, lowest, heights)
        if of.level.any() and not of.level.all():
            check(of, placement(rng))


@pytest.mark.parametrize('lowest', [1, 2])
def test_level_parts_where_the_patch_also_goes_through_the_plane(inputs, lowest):
    """No border is lost; where it is not told how the patch leaves the plane that is said."""
    rng = np.random.default_rng(10 + lowest)
    for _ in range(inputs(200)):
        of = terrain(rng, lowest, lambda z: z)
        if not of.level.any() or of.level.all():
            continue
        try:
            lines_with_borders(of, placement(rng))
        except sc.InvalidShape as error:
            assert "nearly" in str(error)


def flat_but_for(count, degree, row, column):
    z = np.zeros((count, count))
    z[row, column] = 1
    knots = np.r_[[0.0] * degree, np.arange(count - degree + 1), [float(count - degree)] * degree]
    places = means(knots, degree)
    return sc.NurbsPatch((degree, degree), (knots, knots), np.stack([*np.meshgrid(places, places, indexing='ij'), z], -1))


@pytest.mark.parametrize('degree', [2, 3, 4])
def test_border_of_level_part_ends_with_it(degree):
    """Not where the patch leaves the plane by a tolerance."""
    found = flat_but_for(degree + 5, degree, slice(-1, None), slice(None)).plane_sections((0, 0, 0), (0, 0, 1))
    assert sorted(found.kinds) == ['border'] * 4
    assert sorted(curve.length() for curve in found.curves) == pytest.approx([4, 4, 5, 5], abs=1e-9)


@pytest.mark.parametrize('degree', [2, 3, 4])
def test_a_bump_has_a_border(degree):
    count = 2 * degree + 3
    found = flat_but_for(count, degree, degree + 1, degree + 1).plane_sections((0, 0, 0), (0, 0, 1))
    assert set(found.kinds) == {'border'} and found.are_one
    inner = [curve.length() for curve in found.curves if curve.length() < count - degree - 0.5]
    assert inner == pytest.approx([degree + 1] * 4, abs=1e-9)
