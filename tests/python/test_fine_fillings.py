"""Holes whose sides have many spans: they are filled in little time, exactly and as fairly as with few."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def polygon(count):
    angles = 2 * np.pi * np.arange(count) / count
    return np.c_[np.cos(angles), np.sin(angles), 0 * angles]


def wavy_sides(count, spans, knots_of):
    """Cubic sides of a polygon, waves of 0.1 and a little noise on them."""
    rng = np.random.default_rng(spans)
    corners, sides = polygon(count), []
    for start, end in zip(corners, np.roll(corners, -1, 0)):
        knots = np.r_[[0] * 4, np.sort(knots_of(rng, spans)), [1] * 4]
        t = np.array([knots[i + 1:i + 4].mean() for i in range(len(knots) - 4)])
        points = np.outer(1 - t, start) + np.outer(t, end)
        points[:, 2] += 0.1 * np.sin(2 * np.pi * t) + 0.01 / spans * rng.normal(size=len(t)) * t * (1 - t)
        sides.append(sc.NurbsCurve(3, knots, points))
    return sides


def even(_, spans):
    return np.arange(1, spans) / spans


def of_its_own(rng, spans):
    return rng.uniform(0.01, 0.99, spans - 1)


def neighbors(sides, word):
    made = []
    for side in sides:
        points = np.stack([side.points, side.points * 1.4], 1)
        made.append((sc.NurbsPatch((3, 1), (side.knots, [0, 0, 1, 1]), points), "v_start", word))
    return made


def least_upright(filling):
    places = np.linspace(0.001, 0.999, 101)
    normals = np.concatenate([p.evaluate_grid_with_normals(places, places)[1].reshape(-1, 3) for p in filling.patches])
    return (normals[:, 2] * np.sign(np.median(normals[:, 2]))).min()


@pytest.mark.parametrize("knots_of, spans", [(even, 16), (even, 64), (even, 128), (of_its_own, 8), (of_its_own, 16)])
@pytest.mark.parametrize("count", [3, 5])
def test_curves_of_many_spans_are_filled(count, spans, knots_of):
    sides = wavy_sides(count, spans, knots_of)
    filling = build.fill(sides)
    assert filling.gap <= 1e-13 and filling.inner_angle <= 1e-6
    assert least_upright(filling) > 0.7


@pytest.mark.parametrize("word", ["G0", "G1"])
def test_neighbors_of_many_spans_are_followed(word):
    filling = build.fill(neighbors(wavy_sides(5, 64, even), word))
    assert filling.gap <= 1e-13 and filling.inner_angle <= 1e-4
    assert least_upright(filling) > 0.5


def test_what_more_spans_say_alike_is_filled_alike():
    """Sides that are the same but for knots that say nothing."""
    few = wavy_sides(5, 4, even)
    many = [side.refine(np.arange(1, 64) / 64) for side in few]
    points = [np.concatenate([p.evaluate_grid(*[np.linspace(0, 1, 33)] * 2) for p in build.fill(sides).patches]) for sides in (few, many)]
    assert np.abs(points[0] - points[1]).max() <= 2e-2
