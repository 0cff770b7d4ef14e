"""Copies of patches, however written and however noisy, are one within the tolerance up to their borders, or cross where what
parts them is zero, or are refused; patches that cross where they touch have the same curves however they are given."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc
from given_otherwise import sections_otherwise
from splinecore import build

SIDES = ("u_start", "u_end", "v_start", "v_end")


def lengths(curves):
    return sum(curve.length() for curve in curves)


def wave(rng):
    """Creased ones of degree 1, too."""
    degrees = [int(p) for p in rng.integers(1, 4, 2)]
    counts = [p + 1 + int(rng.integers(0, 4)) for p in degrees]
    knots = [np.r_[[0.0] * p, np.linspace(0, 1, n - p + 1), [1.0] * p] for p, n in zip(degrees, counts)]
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in counts), indexing="ij")
    points = np.stack([x, y, rng.uniform(0.1, 0.4) * rng.normal(size=x.shape)], -1)
    weights = 10**rng.uniform(-0.4, 0.4, x.shape) if rng.integers(2) else None
    turn = Rotation.from_quat(rng.normal(size=4)).as_matrix()
    scale = 10.0**rng.integers(-6, 7)
    return sc.NurbsPatch(degrees, knots, scale * (points @ turn.T + rng.normal(size=3)), weights)


def size_of(patch):
    points = patch.points.reshape(-1, 3)
    return np.linalg.norm(points.max(0) - points.min(0))


def noisy(rng, patch, noise):
    return patch.with_points(patch.points + noise * size_of(patch) * rng.uniform(-0.5, 0.5, patch.points.shape))


def rewritten(rng, patch):
    """The same surface."""
    for _ in range(rng.integers(3)):
        way = rng.integers(5)
        axis = "uv"[rng.integers(2)]
        if way == 0:
            patch = patch.refine(axis, sorted(rng.uniform(*patch.domain["uv".index(axis)], 2)))
        elif way == 1:
            patch = patch.elevate(axis)
        elif way == 2:
            patch = patch.reversed(axis)
        elif way == 3:
            patch = patch.swapped()
        else:
            weights = patch.weights
            patch = sc.NurbsPatch(patch.degree, patch.knots, patch.points, 3.7 * (np.ones(patch.points.shape[:2])
                                                                             if weights is None else weights))
    return patch


def test_copies_within_the_tolerance_are_one(inputs):
    rng = np.random.default_rng(0)
    for _ in range(inputs(1000)):
        patch = wave(rng)
        noise = rng.choice([0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-7])
        other = rewritten(rng, noisy(rng, patch, noise))
        one, two = (patch, other) if rng.integers(2) else (other, patch)
        found = one.sections(two, 1e-6 * size_of(patch))
        assert found.are_one and found.kinds == ("border",) * 4 and not len(found.points)
        assert lengths(found.curves) == pytest.approx(lengths(patch.boundary(side) for side in SIDES), rel=1e-4)


def test_a_part_of_a_patch_is_one_with_it_up_to_its_borders(inputs):
    rng = np.random.default_rng(1)
    for _ in range(inputs(200)):
        patch = wave(rng)
        part = patch
        for axis in rng.permutation(["u", "v"])[:rng.integers(1, 3)]:
            part = part.split(axis, rng.uniform(0.3, 0.7))[rng.integers(2)]
        other = rewritten(rng, part)
        found = patch.sections(other) if rng.integers(2) else other.sections(patch)
        assert found.are_one and set(found.kinds) == {"border"} and not len(found.points)
        assert lengths(found.curves) == pytest.approx(lengths(part.boundary(side) for side in SIDES), rel=1e-4)


@pytest.mark.parametrize("scale", [1e-150, 1, 1e150])
@pytest.mark.parametrize("degree", [9, 15, 25])
def test_copies_of_high_degrees_and_of_any_size_are_one(degree, scale):
    knots = np.r_[np.zeros(degree + 1), 0.3, 0.6, np.ones(degree + 1)]
    x, y = np.meshgrid(*[np.linspace(-1, 1, degree + 3)] * 2, indexing="ij")
    z = 0.3 * np.random.default_rng(degree).normal(size=x.shape)
    patch = sc.NurbsPatch((degree, degree), (knots, knots), scale * np.stack([x, y, z], -1))
    found = patch.sections(patch.reversed("u").swapped())
    assert found.are_one and set(found.kinds) == {"border"} and not len(found.points)
    wanted = sum(patch.boundary(side).length(tolerance=1e-6 * scale) for side in SIDES)
    assert sum(curve.length(tolerance=1e-6 * scale) for curve in found.curves) == pytest.approx(wanted, rel=1e-4)


@pytest.mark.parametrize("patch, wanted", [(build.sphere((0, 0, 0), 1), 0),
                                           (build.cylinder((0, 0, 0), (0, 0, 1), 1, 3), 4 * np.pi),
                                           (build.torus((0, 0, 0), (0, 0, 1), 3, 1), 0)])
@pytest.mark.parametrize("noise", [0, 1e-12, 1e-9])
def test_closed_surfaces_are_one_with_their_copies(patch, wanted, noise):
    rng = np.random.default_rng(2)
    for other in (patch.with_points(patch.points * (1 + noise)), patch.reversed("u"), patch.elevate("v")):
        found = patch.sections(other, 1e-6)
        assert found.are_one and set(found.kinds) <= {"border"} and not len(found.points)
        assert lengths(found.curves) == pytest.approx(wanted, abs=1e-5)


def zeros_length(one, other, count=241):
    """Of what parts a patch across from another one by the same parameters, by marching triangles."""
    u, v = (grid.ravel() for grid in np.meshgrid(*[np.linspace(0, 1, count)] * 2, indexing="ij"))
    points, du, dv = np.moveaxis(one.first_derivatives(u, v), 1, 0)
    height = np.einsum("ij,ij->i", other.evaluate(u, v) - points, np.cross(du, dv)).reshape(count, count)
    points = points.reshape(count, count, 3)
    total = 0.0
    for corners in (((0, 0), (1, 0), (0, 1)), ((1, 1), (1, 0), (0, 1))):
        h = [height[i:count - 1 + i, j:count - 1 + j] for i, j in corners]
        p = [points[i:count - 1 + i, j:count - 1 + j] for i, j in corners]
        cuts = []
        for i, k in ((0, 1), (1, 2), (0, 2)):
            is_cut = (h[i] < 0) != (h[k] < 0)
            share = h[i] / np.where(is_cut, h[i] - h[k], 1)
            cuts.append((is_cut, p[i] + share[..., None] * (p[k] - p[i])))
        for i, k in ((0, 1), (1, 2), (0, 2)):
            both = cuts[i][0] & cuts[k][0]
            total += np.linalg.norm(cuts[i][1][both] - cuts[k][1][both], axis=-1).sum()
    return total


def test_copies_beyond_the_tolerance_cross_or_are_refused(inputs):
    rng = np.random.default_rng(3)
    told = 0
    count = inputs(16)
    for _ in range(count):
        patch = wave(rng)
        while 1 in patch.degree:  # on creases normals jump, and the judge knows no sign
            patch = wave(rng)
        other = noisy(rng, patch, 10**rng.uniform(-5.5, -3))
        try:
            found = patch.sections(other, 1e-6 * size_of(patch))
        except sc.InvalidShape as refusal:
            assert "nearly copies" in str(refusal) or "nearly one" in str(refusal)
            continue
        told += 1
        size = size_of(patch)
        assert lengths(found.curves) == pytest.approx(zeros_length(patch, other), abs=0.03 * size)
    assert told >= count // 8


def frame_at(patch, u, v):
    point, du, dv = patch.first_derivatives(u, v)
    normal = np.cross(du, dv)
    frame = np.eye(4)
    frame[:3, 0] = du / np.linalg.norm(du)
    frame[:3, 2] = normal / np.linalg.norm(normal)
    frame[:3, 1] = np.cross(frame[:3, 2], frame[:3, 0])
    frame[:3, 3] = point
    return frame


def touching(rng):
    """A patch of lines and a plane that touches it in a point: they cross along one of the lines, and another curve."""
    points = np.stack([*np.meshgrid(np.linspace(-1, 1, 3), np.linspace(-1, 1, 2), indexing="ij"), np.zeros((3, 2))], -1)
    weights = 10**rng.uniform(-0.5, 0.5, (3, 2))
    ruled = sc.BezierPatch(points + 0.4 * rng.normal(size=points.shape), weights=weights).to_nurbs()
    plane = sc.BezierPatch([[(-9, -9, 0), (-9, 9, 0)], [(9, -9, 0), (9, 9, 0)]]).to_nurbs()
    return ruled, plane.transformed(frame_at(ruled, *rng.uniform(0.25, 0.75, 2)))


def test_patches_that_cross_where_they_touch(inputs):
    """The curves are the same in both orders, moved, scaled, reversed and refined."""
    rng = np.random.default_rng(4)
    for _ in range(inputs(100)):
        a, b = touching(rng)
        found = a.sections(b, 1e-5)
        for other, unit in sections_otherwise(rng, a, b, 1e-5, far=1, magnitudes=6, cuts=2):
            assert other.kinds == found.kinds and not other.are_one
            assert lengths(other.curves) / unit == pytest.approx(lengths(found.curves), abs=1e-3)
