"""What Coons patches, networks and offsets of patches say they are off by is what they are off by: seen densely."""

import time

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

BORDERS = ("v_start", "u_end", "v_end", "u_start")


def by_spans(knots, domain, each):
    knots = np.unique(np.clip(knots, *domain))
    return np.concatenate([np.linspace(a, b, each) for a, b in zip(knots[:-1], knots[1:])])


def wild_side(rng, start, end):
    degree, more = int(rng.integers(1, 8)), int(rng.integers(0, 7))
    inner = np.sort(rng.uniform(0, 1, more))
    if more > 1 and rng.random() < 0.2:
        inner[1] = inner[0] + 10 ** rng.uniform(-10, -4)
    count = degree + 1 + more
    points = start + (end - start) * np.linspace(0, 1, count)[:, None] + rng.normal(0, 0.3, (count, 3))
    points[0], points[-1] = start, end
    weights = 10 ** rng.uniform(-3, 3, count) if rng.random() < 0.5 else None
    return sc.NurbsCurve(degree, np.r_[[0] * (degree + 1), np.sort(inner), [1] * (degree + 1)], points, weights)


def wild_loop(rng):
    """Sides, how far out they lie, how far ends lie apart, and how large they are."""
    scale, count = 10 ** rng.uniform(-12, 9), int(rng.choice([3, 4]))
    far = rng.choice([0.0, 1e4])
    gap = 10 ** rng.uniform(-12, -3) if rng.random() < 0.5 else 0.0
    corners = rng.uniform(-1, 1, (count, 3)) + far
    sides = []
    for k in range(count):
        ends = [corners[i % count] + gap * rng.uniform(-0.3, 0.3, 3) for i in (k, k + 1)]
        side = wild_side(rng, *ends).transformed(scale * np.eye(3))
        sides.append(side.reversed() if k and rng.random() < 0.5 else side)
    return sides, far, gap, scale


def test_sides_of_coons_patches_are_as_far_off_as_they_say(inputs):
    for seed in range(inputs(1000)):
        sides, far, gap, scale = wild_loop(np.random.default_rng([21, seed]))
        made, error = build.coons(sides, tolerance=2 * max(gap, 1e-9) * scale)
        assert np.allclose(made.domain, [(0, 1), (0, 1)]), seed
        for side, border in zip(sides, BORDERS):
            places = side.evaluate(by_spans(side.knots, side.domain, 20))
            off = made.boundary(border).nearest(places).distances.max()
            assert off <= 1.02 * error + 1e-13 * scale * (1 + far), seed


def test_coons_patches_across_whose_sides_have_near_equal_knots():
    """Some run back over other parameters: the patch is over [0, 1] all the same, and between its sides."""
    rng = np.random.default_rng(2)
    for gap in (1e-3, 1e-6, 1e-9):
        corners = np.array([(0, 0, 0), (1, 0, 0.3), (1, 1, 0), (0, 1, 0.2)])
        sides = [sc.NurbsCurve(2, [0, 0, 0, 0.4, 0.4 + gap, 1, 1, 1], np.linspace(corners[k], corners[(k + 1) % 4], 5)
                               + np.r_[[(0, 0, 0)], rng.normal(0, 0.05, (3, 3)), [(0, 0, 0)]]) for k in range(4)]
        made, error = build.coons(sides)
        assert error <= 1e-8 and np.allclose(made.domain, [(0, 1), (0, 1)])
        inner = made.evaluate_grid(np.linspace(0, 1, 9), np.linspace(0, 1, 9))
        assert (np.abs(inner - [0.5, 0.5, 0.1]).max(axis=(0, 1)) <= 0.9).all()


def lines_and_polylines(rng, count, across):
    """Straight lines from one side of a strip to the other, and polylines through them."""
    heights = np.cumsum(rng.normal(0, 0.1, (2, count)), axis=1)
    y = np.arange(count, dtype=float)
    lines = [sc.BezierCurve([(0, y[j], heights[0, j]), (count / 8, y[j], heights[1, j])]) for j in range(count)]
    others = []
    for share in np.linspace(0, 1, across):
        points = np.c_[np.full(count, share * count / 8), y, (1 - share) * heights[0] + share * heights[1]]
        others.append(sc.NurbsCurve(1, np.r_[0, np.arange(count), count - 1], points))
    return lines, others


@pytest.mark.parametrize("count, across", [(257, 2), (257, 5), (130, 3)])
def test_networks_of_many_lines_say_how_far_they_are_from_them(count, across):
    lines, others = lines_and_polylines(np.random.default_rng(count + across), count, across)
    begin = time.perf_counter()
    for tolerance in (None, 1e-2):
        made, error = build.network(lines, others, tolerance=tolerance)
        off = 0.0
        for curve in (*others, *lines[::16]):
            nurbs = curve.to_nurbs()
            places = nurbs.evaluate(by_spans(nurbs.knots, nurbs.domain, 5))
            off = max(off, made.nearest(places).distances.max())
        assert off <= 1.02 * error + 1e-12 * count
    assert time.perf_counter() - begin < 30


def bent_patch(rng):
    degree = [int(rng.integers(1, 6)) for _ in "uv"]
    count = [p + 1 + int(rng.integers(0, 5)) for p in degree]
    knots = []
    for p, n in zip(degree, count):
        inner = np.sort(rng.uniform(0.02, 0.98, n - p - 1)) if p > 1 else np.array([])
        knots.append(np.r_[[0] * (p + 1), inner, [1] * (p + 1)])
    count = [len(k) - p - 1 for k, p in zip(knots, degree)]
    x, y = np.meshgrid(np.linspace(0, 1, count[0]), np.linspace(0, rng.uniform(0.3, 3), count[1]), indexing="ij")
    net = np.dstack([x, y, rng.normal(0, rng.choice([0.02, 0.1, 0.3]), count)])
    weights = 10 ** rng.uniform(-0.5, 0.5, count) if rng.random() < 0.5 else None
    return sc.NurbsPatch(degree, knots, net, weights)


def test_offsets_of_patches_say_how_far_they_are_off(inputs):
    made_some, count = 0, inputs(1000)
    for seed in range(count):
        rng = np.random.default_rng([31, seed])
        scale = 10 ** rng.uniform(-12, 9)
        patch = bent_patch(rng).transformed(scale * np.eye(3))
        distance = scale * 10 ** rng.uniform(-3, -0.5) * rng.choice([-1, 1])
        try:
            made, error = build.offset_patch(patch, distance, tolerance=scale * 10 ** rng.uniform(-5, -2))
        except (sc.InvalidShape, sc.ToleranceNotReached):
            continue
        made_some += 1
        at = [by_spans(knots, domain, 9) for knots, domain in zip(made.knots, made.domain)]
        points, normals = patch.evaluate_grid_with_normals(*at)
        off = np.linalg.norm(made.evaluate_grid(*at) - points - distance * normals, axis=-1).max()
        assert off <= error / 0.98 + 1e-14 * scale, (seed, off / error)
    assert made_some > 0.3 * count
