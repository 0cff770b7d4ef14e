"""Volumes, areas and centroids of wild closed surfaces of any size and place, against Gauss's rule about their own middle."""

import numpy as np

import splinecore as sc

RULES = [np.polynomial.legendre.leggauss(count) for count in (28, 90)]


def rule(knots, domain, nodes, weights):
    edges = np.unique(np.clip(knots, *domain))
    edges = np.unique(np.r_[edges, 0.5 * (edges[1:] + edges[:-1])])
    half, middle = 0.5 * np.diff(edges), 0.5 * (edges[1:] + edges[:-1])
    return (middle[:, None] + half[:, None] * nodes).ravel(), (half[:, None] * weights).ravel()


def by_gauss(patch, about, nodes_and_weights):
    """The volume, the area and the centroid from a point."""
    (u, of_u), (v, of_v) = (rule(knots, domain, *nodes_and_weights) for knots, domain in zip(patch.knots, patch.domain))
    at = [x.ravel() for x in np.meshgrid(u, v, indexing="ij")]
    jets = patch.derivatives(*at, 1)
    jets = jets.reshape(len(at[0]), *jets.shape[-3:])
    points, normals = jets[:, 0, 0] - about, np.cross(jets[:, 1, 0], jets[:, 0, 1])
    weights = np.outer(of_u, of_v).ravel()
    flow = np.einsum("ij,ij->i", points, normals) * weights
    volume = flow.sum() / 3
    return volume, (np.linalg.norm(normals, axis=1) * weights).sum(), flow @ points / 4 / volume


def wild_ring(rng):
    degree = [int(rng.integers(2, 5)) for _ in "uv"]
    count = [p + int(rng.integers(1, 4)) for p in degree]
    knots = [np.r_[0, np.cumsum(rng.uniform(0.3, 1, n))] for n in count]
    a, b = np.meshgrid(*(2 * np.pi * np.arange(n) / n for n in count), indexing="ij")
    round_it = 1 + 0.45 * np.cos(b)
    net = np.stack([round_it * np.cos(a), round_it * np.sin(a), 0.45 * np.sin(b)], -1) * rng.uniform(0.3, 3, 3)
    weights = 10 ** (rng.uniform(-1, 1, count) * rng.choice([0.0, 1.0]))
    return sc.NurbsPatch(degree, knots, net + rng.normal(0, 0.05, net.shape), weights, [True, True])


def test_solids_of_any_size_and_place(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([9, seed])
        scale, far = 10 ** rng.uniform(-12, 9), rng.choice([0.0, 1e3, 1e6])
        move = np.column_stack([scale * np.eye(3), far * scale * rng.uniform(-1, 1, 3)])
        patch = wild_ring(rng).transformed(move)
        points = np.asarray(patch.points).reshape(-1, 3)
        middle, size = 0.5 * (points.min(0) + points.max(0)), np.ptp(points, axis=0).max()
        volume, area, centroid = by_gauss(patch, middle, RULES[0])
        solid = sc.PatchSet.from_patches([patch])
        slack = 1e-9 + 1e-14 * far
        assert abs(solid.volume() - volume) <= slack * size**3, seed
        # Where weights bend the surface sharply, Gauss's rule misses more of the root than of polynomials.
        allowed = (slack + 1e-6) * size**2
        if abs(solid.area() - area) > allowed:
            area = by_gauss(patch, middle, RULES[1])[1]
        assert abs(solid.area() - area) <= allowed, seed
        if abs(volume) > 1e-2 * size**3:
            assert np.abs(solid.centroid() - middle - centroid).max() <= 1e3 * slack * size, seed
