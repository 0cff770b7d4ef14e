"""Volumes, centroids, moments, flux and areas in the plane keep the tolerance that they were asked for: random ones against a
dense rule. `--inputs 1000` draws as many of each."""

import math

import numpy as np
import pytest

import dense_rules
import splinecore as sc

TOLERANCES = (1e-3, 1e-6, 1e-9, None)
ROUNDING = 1e-12


def periodic_knots(rng, degree):
    count = degree + 1 + int(rng.integers(1, 6))
    inner = np.sort(rng.choice(np.arange(1, 64), count - 1, replace=False)) / 64.0
    return np.concatenate([[0.0], inner, [1.0]]) + rng.choice([0.0, 0.0, 1e7]), count


def random_ring(rng):
    """A patch that is closed in both directions and goes round a ring: (degree, knots, points, weights, both periodic)."""
    degree = tuple(int(p) for p in rng.integers(1, 6, 2))
    (u, count_u), (v, count_v) = (periodic_knots(rng, p) for p in degree)
    around, across = (2 * math.pi * np.arange(n) / n for n in (count_u, count_v))
    far = 3 + rng.normal(0, 0.2, (count_u, count_v)) + np.cos(across)
    points = np.stack([far * np.cos(around)[:, None], far * np.sin(around)[:, None],
                       np.sin(across) + rng.normal(0, 0.2, (count_u, count_v))], -1)
    weights = np.ones((count_u, count_v)) if rng.random() < 0.4 else rng.uniform(0.5, 2.0, (count_u, count_v))
    return degree, [u, v], np.round(points * 2**20) / 2**20, weights, (True, True)


def body_of(degree, knots, points, weights, periodic):
    rational = None if (weights == 1).all() else weights
    return sc.PatchSet.from_patches([sc.NurbsPatch(degree, knots, points, rational, periodic)])


def dense(degree, knots, points, weights, periodic, parts):
    """(volume, centroid, second moments about it, surface's centroid)."""
    shifted = [k - k[0] for k in knots]
    at, normals, shares = dense_rules.surface(degree, shifted, points, weights, periodic, dense_rules.even_parts(parts))
    through = normals * shares[..., None]
    volume = (at * through).sum() / 3
    middle = (at**2 * through).sum((0, 1)) / (2 * volume)
    away = at - middle
    moments = np.einsum("uvi,uvj,uvk,uvk->ij", away, away, away, through) / 5
    return volume, middle, moments, dense_rules.surface_centroid(degree, shifted, points, weights, periodic,
                                                                 dense_rules.even_parts(parts))


def kept(measure, truth, size, unsure):
    """Whether each result is off by no more than the tolerance times the size, and by less where less is asked."""
    for tolerance in TOLERANCES:
        found = measure(**({} if tolerance is None else {"tolerance": tolerance}))
        assert np.abs(found - truth).max() <= ((tolerance or 1e-12) + ROUNDING) * size + unsure, (tolerance, found, truth)


@pytest.mark.parametrize("seed", range(8))
def test_random_solids_keep_every_tolerance(seed, inputs):
    rng, shells, count = np.random.default_rng(seed), 0, inputs(200) // 8
    for _ in range(count):
        ring = random_ring(rng)
        coarse, fine = (dense(*ring, parts) for parts in (3, 5))
        unsure = [np.abs(a - b).max() for a, b in zip(coarse, fine)]
        volume, middle, moments, shell = fine
        exponent = int(rng.integers(-90, 90)) if rng.random() < 0.4 else 0
        degree, knots, points, weights, periodic = ring
        body = body_of(degree, knots, points * 2.0**exponent, weights * 2.0 ** int(rng.integers(-300, 300)), periodic)
        half = np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)) / 2
        back = [math.ldexp(1.0, -power * exponent) for power in (1, 3, 5)]
        assert max(unsure[0] / abs(volume), unsure[1], unsure[2] / abs(np.trace(moments))) < 1e-10
        kept(lambda **how: body.volume(**how) * back[1], volume, abs(volume), unsure[0])
        kept(lambda **how: body.centroid(**how) * back[0], middle, half, unsure[1])
        kept(lambda **how: body.second_moments(**how) * back[2], moments, abs(np.trace(moments)), unsure[2])
        if unsure[3] < 1e-12:           # not where the normal comes near to zero, which the rule sees by chance
            kept(lambda **how: body.surface_centroid(**how) * back[0], shell, half, unsure[3])
            shells += 1
    assert shells > 0.7 * count


@pytest.mark.parametrize("seed", range(4))
def test_random_flux_keeps_every_tolerance(seed, inputs):
    rng = np.random.default_rng(100 + seed)
    for _ in range(inputs(200) // 4):
        ring = random_ring(rng)
        slopes, turns = rng.normal(size=(3, 3)), rng.uniform(0.5, 1.5, 3)

        def field(points):
            return np.sin(points @ slopes * 0.5) + turns * points

        shifted = [k - k[0] for k in ring[1]]
        (coarse, _), (through, all_through) = (
            dense_rules.flux(field, ring[0], shifted, *ring[2:], dense_rules.even_parts(parts)) for parts in (3, 5))
        assert abs(coarse - through) < 1e-9 * all_through
        kept(lambda **how: body_of(*ring).flux(field, **how), through, all_through, abs(coarse - through))


def closed_curve(rng):
    degree = int(rng.integers(1, 10))
    knots, count = periodic_knots(rng, degree)
    turns = int(rng.choice([1, 1, -1, 2]))
    angle = 2 * math.pi * turns * np.arange(count) / count
    points = np.stack([np.cos(angle), np.sin(angle), 0 * angle], -1) * rng.uniform(0.7, 1.4, (count, 1))
    weights = np.ones(count) if rng.random() < 0.4 else rng.uniform(0.5, 2.0, count)
    return degree, knots, points, weights


def dense_curve(degree, knots, points, weights, parts):
    """Points and derivatives (n, 3) at Gauss's nodes of every span, and their shares (n,)."""
    plain, net = dense_rules.unrolled([degree], [knots - knots[0]], points, weights, [True])
    u, shares = dense_rules.rule(plain[0], degree, dense_rules.even_parts(parts))
    values, slopes = (each @ net for each in dense_rules.basis(plain[0], degree, u))
    return values[:, :3] / values[:, 3:], dense_rules.quotient(slopes, values), shares


@pytest.mark.parametrize("seed", range(4))
def test_random_areas_in_a_plane_keep_every_tolerance(seed, inputs):
    rng = np.random.default_rng(200 + seed)
    for _ in range(inputs(1000) // 4):
        degree, knots, points, weights = closed_curve(rng)
        areas = []
        for parts in (3, 5):
            at, slope, shares = dense_curve(degree, knots, points, weights, parts)
            swept = 0.5 * np.cross(at[:, :2], slope[:, :2]) * shares
            areas.append(swept.sum())
        exponent = int(rng.integers(-200, 200)) if rng.random() < 0.4 else 0
        rational = None if (weights == 1).all() else weights * 2.0 ** int(rng.integers(-300, 300))
        curve = sc.NurbsCurve(degree, knots, points * 2.0**exponent, rational, periodic=True)
        unsure = abs(areas[0] - areas[1])
        assert unsure < 1e-9
        kept(lambda **how: math.ldexp(curve.signed_area(**how), -2 * exponent), areas[1], 1.5 * np.abs(swept).sum(), unsure)


@pytest.mark.parametrize("seed", range(4))
def test_random_curves_go_round_points_as_often_as_their_angle_tells(seed, inputs):
    rng = np.random.default_rng(300 + seed)
    counted = set()
    for _ in range(inputs(240) // 4):
        degree, knots, points, weights = closed_curve(rng)
        rational = None if (weights == 1).all() else weights
        curve = sc.NurbsCurve(degree, knots, points, rational, periodic=True)
        along = curve.evaluate(np.linspace(*curve.domain, 4001))[:, :2]
        for point in rng.uniform(-1.5, 1.5, (8, 2)):
            away = along - point
            if np.linalg.norm(away, axis=1).min() < 0.02:
                continue
            angle = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
            expected = round((angle[-1] - angle[0]) / (2 * math.pi))
            assert curve.winding_number((*point, 0.0)) == expected
            counted.add(expected)
    assert counted >= {-1, 0, 1, 2}
