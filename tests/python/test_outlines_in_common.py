"""What two surfaces have in common is bounded by whole outlines, or refused with the place at which its border was lost."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import splinecore as sc
from splinecore import build


def flat(rng):
    degrees = [int(p) for p in rng.integers(1, 4, 2)]
    counts = [p + 1 + int(rng.integers(0, 3)) for p in degrees]
    knots = [np.r_[[0.0] * p, np.linspace(0, 1, n - p + 1), [1.0] * p] for p, n in zip(degrees, counts)]
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in counts), indexing="ij")
    plane = (np.stack([x, y], -1) + rng.uniform(-0.15, 0.15, (*x.shape, 2))) @ rng.normal(size=(2, 2)).T + 0.6 * rng.normal(size=2)
    weights = np.exp(rng.normal(0, 0.3, x.shape)) if rng.random() < 0.5 else None
    return sc.NurbsPatch(degrees, knots, np.concatenate([plane, 0 * x[..., None]], -1), weights)


def of_cylinder(rng):
    return build.cylinder((0, 0, rng.uniform(-1, 1)), (0, 0, 1), 1.0, rng.uniform(0.5, 3), rng.uniform(0, 6.3), rng.uniform(0.5, 6.2))


def of_sphere(rng):
    patch = build.sphere((0, 0, 0), 1.0, rng.normal(size=3), rng.uniform(0, 6.3), rng.uniform(1, 6.2))
    return patch.split("v", np.quantile(patch.domain[1], rng.uniform(0.2, 0.8)))[rng.integers(2)]


def of_cone(rng):
    height = rng.uniform(0.5, 0.95)
    return build.cone((0, 0, 0), (0, 0, 1), 1.0, height, 1 - height, rng.uniform(0, 6.3), rng.uniform(1, 6.2))


def moved(rng):
    return np.c_[Rotation.from_quat(rng.normal(size=4)).as_matrix() * 10.0**rng.uniform(-2, 2), rng.normal(size=3)]


def loose_ends(curves, near):
    """Of open ones those ends that none of the others comes near."""
    ends = [curve.evaluate(np.array(curve.domain)) for curve in curves]
    ends = np.concatenate([pair for pair in ends if np.linalg.norm(pair[0] - pair[1]) > near] or [np.zeros((0, 3))])
    far = np.linalg.norm(ends[:, None] - ends, axis=-1) + np.diag(np.full(len(ends), np.inf))
    return [end for end, row in zip(ends, far) if row.min() > near]


@pytest.mark.parametrize("kind", [flat, of_cylinder, of_sphere, of_cone])
def test_parts_of_one_surface_have_closed_outlines(kind, inputs):
    made, refused = 0, 0
    for seed in range(inputs(32)):
        rng = np.random.default_rng([seed, 401])
        a, b = kind(rng), kind(rng)
        motion = moved(rng)
        a, b = a.transformed(motion), b.transformed(motion)
        try:
            found = a.sections(b)
        except sc.InvalidShape as error:
            assert "nearly one" in str(error) or "folded" in str(error)
            refused += 1
            continue
        made += found.are_one
        borders = [curve for curve, word in zip(found.curves, found.kinds) if word == "border"]
        assert not loose_ends(borders, 1e-4 * np.ptp(a.points.reshape(-1, 3), axis=0).max()), seed
    assert made > 0.5 * inputs(32) and refused <= 0.1 * inputs(32)


def test_where_the_border_ends_at_a_fold_the_part_is_refused(inputs):
    """It was given with an outline that lacked the fold."""
    for seed in range(inputs(24)):
        rng = np.random.default_rng([seed, 402])
        back, shear = rng.uniform(0, 0.5), rng.uniform(-0.1, 0.1)
        folded = sc.BezierPatch([[(x, y + s, 0) for y in (0, 1)] for x, s in ((0, 0), (2, shear), (back, 0))])
        low, high = np.sort(rng.uniform(0.2, 0.8, 2)) + [0, 0.05]
        start = rng.uniform(0.55, 0.9)
        plain = sc.BezierPatch([[(x, y, 0) for y in (low, high)] for x in (start, 1.5)])
        motion = moved(rng)
        pair = [folded.transformed(motion), plain.transformed(motion)]
        with pytest.raises(sc.InvalidShape, match=r"cannot be followed beyond \(.*folded"):
            pair[seed % 2].sections(pair[1 - seed % 2])


@pytest.mark.parametrize("heights, length", [
    ([[1, 2, 3, 4], [2, 5, 5, 1], [3, 5, 5, 2], [1, 2, 1, 3]], 4),
    ([[1, 2, 3, 4], [2, 5, 5, 1], [3, 5, 5, 2]], 4),
    ([[1, 2, 1], [3, 5, 5], [0, 5, 5]], 4),
    ([[1, 1, 1], [5, 5, 5], [2, 5, 5]], 5),
    ([[5, 5, 5], [2, 5, 5]], 5),
    ([[5, 5, 5], [4.99, 5, 5]], 5),
    ([[5, 5, 5], [2, 5, 5], [1, 1, 1]], 5),
    ([[2, 0, 5, 5, 5], [0, 1, 2, 5, 5]], 5)])
def test_a_level_face_has_four_borders(heights, length):
    """Beyond creases and where the surface ends; an edge that lies in the plane alone is none."""
    heights = np.array(heights, float)
    x, y = np.meshgrid(*(np.arange(n) for n in heights.shape), indexing="ij")
    knots = [np.r_[0.0, np.arange(n), n - 1.0] for n in heights.shape]
    patch = sc.NurbsPatch((1, 1), knots, np.stack([x, y, heights], -1))
    for way in (patch, patch.reversed("u"), patch.swapped()):
        found = way.plane_sections((0, 0, 5), (0, 0, 1))
        assert found.are_one and found.kinds.count("border") == 4
        total = sum(curve.length() for curve in found.curves)
        assert total == pytest.approx(length, abs=1e-3)
