"""Thick shells and centroids of wild surfaces, of any size and far from the origin, against closed forms and another rule."""

import numpy as np

import splinecore as sc
from splinecore import build

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)


def places(knots, parts):
    """Nodes and weights of the rule of Gauss on parts of each span."""
    distinct = np.unique(knots)
    ends = np.r_[np.concatenate([np.linspace(a, b, parts + 1)[:-1] for a, b in zip(distinct[:-1], distinct[1:])]), distinct[-1]]
    half, middle = np.diff(ends) / 2, (ends[1:] + ends[:-1]) / 2
    return (middle[:, None] + half[:, None] * NODES).ravel(), (half[:, None] * WEIGHTS).ravel()


def integrals(patch, parts):
    """Area, centroid, integrals of the mean and of the Gaussian curvature, and the largest curvature."""
    (u, across_u), (v, across_v) = (places(knots, parts) for knots in patch.knots)
    at = np.meshgrid(u, v, indexing="ij")
    jets = patch.derivatives(at[0].ravel(), at[1].ravel(), 2)
    du, dv = jets[:, 1, 0], jets[:, 0, 1]
    normals = np.cross(du, dv)
    speed = np.linalg.norm(normals, axis=1)
    shares = np.outer(across_u, across_v).ravel() * speed
    e, f, g = (du * du).sum(1), (du * dv).sum(1), (dv * dv).sum(1)
    bent, mixed, other = ((jets[:, k, l] * normals).sum(1) / speed for k, l in ((2, 0), (1, 1), (0, 2)))
    gauss = (bent * other - mixed**2) / speed**2
    mean = (e * other - 2 * f * mixed + g * bent) / (2 * speed**2)
    area = shares.sum()
    middle = jets[:, 0, 0].mean(0)
    largest = (np.abs(mean) + np.sqrt(np.maximum(mean**2 - gauss, 0))).max()
    return area, middle + shares @ (jets[:, 0, 0] - middle) / area, shares @ mean, shares @ gauss, largest


def wild(rng, roughness):
    degrees, knots, means = [int(p) for p in rng.integers(2, 6, 2)], [], []
    for degree in degrees:
        inner = np.sort(rng.uniform(0.05, 0.95, int(rng.choice([0, 1, 3]))))
        knots.append(np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)])
        means.append([knots[-1][i + 1:i + 1 + degree].mean() for i in range(len(inner) + degree + 1)])
    x, y = np.meshgrid(*means, indexing="ij")
    points = np.stack([x * 10**rng.uniform(-1, 1), y, roughness * rng.normal(size=x.shape)], -1)
    points = points @ np.linalg.qr(rng.normal(size=(3, 3)))[0] * 10**rng.uniform(-9, 9)
    far = rng.choice([0, 1, 100]) * np.ptp(points.reshape(-1, 3), axis=0).max()
    weights = np.exp(rng.normal(0, 0.3, x.shape)) if rng.random() < 0.4 else None
    return sc.NurbsPatch(degrees, knots, points + far * rng.normal(size=3), weights)


def size_of(patch):
    return np.ptp(patch.points.reshape(-1, 3), axis=0).max()


def test_centroids_and_areas_are_those_of_another_rule(inputs):
    for seed in range(inputs(100)):
        rng = np.random.default_rng([seed, 71])
        patch = wild(rng, rng.uniform(0, 1))
        rough, fine = integrals(patch, 1), integrals(patch, 3)
        rounding = 1e-11 + 1e-12 * np.abs(patch.points).max() / size_of(patch)
        assert abs(patch.area() / fine[0] - 1) <= 10 * abs(rough[0] / fine[0] - 1) + rounding, seed
        off = np.abs(patch.surface_centroid() - fine[1]).max() / size_of(patch)
        assert off <= 10 * np.abs(rough[1] - fine[1]).max() / size_of(patch) + rounding, seed


def test_thick_shells_have_the_volume_of_steiners_formula(inputs):
    """Between the offsets by a and b: A (b - a) - M (b^2 - a^2) + K (b^3 - a^3) / 3, with the integrals of mean and Gaussian
    curvature."""
    made = 0
    for seed in range(inputs(100)):
        rng = np.random.default_rng([seed, 72])
        patch = wild(rng, rng.uniform(0, 0.3))
        area, _, mean, gauss, largest = integrals(patch, 2)
        reach = min(1 / largest, size_of(patch))
        a, b = np.sort(rng.choice([-1, 1], 2) * reach * rng.uniform(0.01, 0.8, 2))
        if rng.random() < 0.5:
            a, b = np.sort([0, b])
        if b - a < 1e-6 * size_of(patch):
            continue
        tolerance = size_of(patch) * 10**rng.uniform(-7, -3)
        try:
            shell, error = build.thicken(patch, a, b, tolerance=tolerance)
        except sc.InvalidShape as refused:
            assert "bends" in str(refused) or "normal" in str(refused)
            continue
        made += 1
        assert error <= tolerance
        expected = area * (b - a) - mean * (b**2 - a**2) + gauss * (b**3 - a**3) / 3
        volume = sc.PatchSet.from_patches(shell).volume()
        assert abs(volume - expected) <= area * (3 * error + 1e-6 * (b - a)), seed
    assert made > 0.7 * inputs(100)
