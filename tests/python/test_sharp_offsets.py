"""Trimmed offsets with sharp corners against what bounds them: places near the polygon or under the tip of a corner."""

import numpy as np
import pytest

import splinecore as sc
from sharp_tips import are_under, cross, tips


def distances(polygon, points):
    least = np.full(len(points), np.inf)
    for p, q in zip(polygon, np.roll(polygon, -1, 0)):
        t = np.clip((points - p) @ (q - p) / ((q - p) @ (q - p)), 0, 1)
        least = np.minimum(least, np.linalg.norm(points - (p + t[:, None] * (q - p)), axis=1))
    return least


def is_inside(polygon, points):
    odd = np.zeros(len(points), bool)
    for p, q in zip(polygon, np.roll(polygon, -1, 0)):
        across = (p[1] > points[:, 1]) != (q[1] > points[:, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            odd ^= across & (points[:, 0] < p[0] + (points[:, 1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
    return odd


def expected(polygon, distance, points):
    """What belongs to the offset of the region within a polygon that runs counterclockwise."""
    inside = is_inside(polygon, points)
    taken = (distances(polygon, points) < abs(distance)) | are_under(polygon, distance, points)
    return inside | taken if distance > 0 else inside & ~taken


def meet(polygon):
    """Whether sides of a polygon cross or touch others than their neighbors."""
    ends = np.stack([polygon, np.roll(polygon, -1, 0)], 1)
    n = len(polygon)
    return any(are_one(ends[i], ends[j]) for i in range(n) for j in range(i + 2, n - (i == 0)))


def are_one(side, other):
    """Whether two sides have a place in common."""
    (a, b), (c, d) = side, other
    if (np.maximum(side.min(0), other.min(0)) > np.minimum(side.max(0), other.max(0))).any():
        return False
    return cross(b - a, c - a) * cross(b - a, d - a) <= 0 and cross(d - c, a - c) * cross(d - c, b - c) <= 0


def stars(random):
    angles = np.sort(random.uniform(0, 2 * np.pi, random.integers(3, 14)))
    radii = random.uniform(0.1, 1.0, len(angles)) ** random.choice([0.3, 1, 2])
    return np.stack([np.cos(angles), np.sin(angles)], -1) * radii[:, None]


def whole_numbers(random):
    return random.permutation(random.integers(-4, 5, (random.integers(3, 9), 2))).astype(float)


def combs(random):
    """Teeth of different depths and widths, their flanks slanted."""
    count = random.integers(2, 7)
    x = np.cumsum(random.uniform(0.05, 1.0, 4 * count))
    y = np.where(np.arange(4 * count) % 4 < 2, 0.0, random.uniform(0.2, 3.0, 4 * count))
    low = -random.uniform(0.2, 2.0)
    return np.concatenate([np.stack([x, y], -1)[::-1], [(x[0], low), (x[-1], low)]])


KINDS = [stars, whole_numbers, combs]


def polygon_of(kind, random):
    while True:
        polygon = kind(random)
        area = 0.5 * cross(polygon, np.roll(polygon, -1, 0)).sum()
        sides = np.linalg.norm(polygon - np.roll(polygon, 1, 0), axis=1)
        if abs(area) > 1e-3 and sides.min() > 1e-3 and not meet(polygon) and not backs(polygon):
            return polygon if area > 0 else polygon[::-1]


def backs(polygon):
    """Whether a polygon turns back, or is straight, at a corner."""
    a, b = polygon - np.roll(polygon, 1, 0), np.roll(polygon, -1, 0) - polygon
    return (np.abs(cross(a, b)) < 1e-6 * np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)).any()


def misses(polygon, distance, random, scale=1.0, count=400):
    """How many of random places are on the wrong side of the outlines, of those that are not on them."""
    closed = np.concatenate([polygon, polygon[:1]]) * scale
    region = sc.Region.of([sc.NurbsCurve(1, [0, *range(len(closed)), len(closed) - 1], closed)])
    made = region.offset(distance * scale, corner="sharp")
    size = np.ptp(polygon, axis=0).max()
    low, high = polygon.min(0) - 4 * abs(distance), polygon.max(0) + 4 * abs(distance)
    corners = np.concatenate([polygon, tips(polygon, distance).reshape(-1, 2)])
    points = np.concatenate([random.uniform(low, high, (count, 2)),
                             corners[random.integers(len(corners), size=count)] + 0.1 * size * random.normal(size=(count, 2))])
    for outline in made.outlines:
        near = outline.nearest(np.pad(points, ((0, 0), (0, 1))) * scale).distances
        points = points[near > 1e-4 * (size + abs(distance)) * scale]
    found = made.contains(np.pad(points, ((0, 0), (0, 1))) * scale) if made else np.zeros(len(points), bool)
    return int((found != expected(polygon, distance, points)).sum())


@pytest.mark.parametrize("kind", KINDS)
def test_offsets_of_polygons_hold_what_is_near_or_under_a_tip(kind, inputs):
    for seed in range(inputs(1000)):
        random = np.random.default_rng(seed)
        polygon = polygon_of(kind, random)
        size = np.ptp(polygon, axis=0).max()
        distance = random.choice([-1, 1]) * size * 10 ** random.uniform(-2.5, 0.3)
        if kind is whole_numbers:
            distance = random.choice([-2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 4.0])
        assert misses(polygon, distance, random, scale=10.0 ** random.integers(-4, 5)) == 0, (kind.__name__, seed)


def test_tips_that_cross_over_a_notch_end_where_they_cross():
    closed = sc.build.contour([(-3, 0), (0, 2), (3, 0), (0, 8)], closed=True)
    (loop,) = closed.offset(-6, trimmed=True, corner="sharp")
    assert (loop.points[0] == loop.points[-1]).all()
    assert not loop.self_intersections().points.size
    area = sc.Region.of([sc.build.contour([(0, 0), (4, 0), (6, 2.5), (8, 0), (12, 0), (12, 8), (0, 8)], closed=True)])
    assert len(area.offset(2.6, corner="sharp").outlines) == 1
