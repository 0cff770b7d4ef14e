"""Lofts that go round: nowhere thinner than their sections, however these turn on the way, or refused."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def ring(outline, count, turn, radius=10.0):
    """Plane outlines (n, 2) about a ring, which turn about its middle on the way round."""
    for i in range(count):
        around, about = 2 * np.pi * i / count, turn * i / count
        out, up = np.array([np.cos(around), np.sin(around), 0.0]), np.array([0.0, 0.0, 1.0])
        x, y = outline[:, :1], outline[:, 1:]
        yield radius * out + (x * np.cos(about) - y * np.sin(about)) * out + (x * np.sin(about) + y * np.cos(about)) * up


def polygons(outline, count, turn):
    return [build.contour(points, closed=True) for points in ring(outline, count, turn)]


def ovals(outline, count, turn):
    knots = np.arange(len(outline) + 1.0)
    return [sc.NurbsCurve(3, knots, points, periodic=True) for points in ring(outline, count, turn)]


def widths(patch, count=97):
    u, v = (np.linspace(*domain, n) for domain, n in zip(patch.domain, (65, count)))
    rows = patch.evaluate_grid(u, v).reshape(65, count, 3)
    return np.linalg.norm(rows[:, None] - rows[None, ::4], axis=-1).max(axis=(0, 1))


def width_of(curve):
    points = curve.evaluate(np.linspace(*curve.domain, 257))
    return np.linalg.norm(points[:, None] - points[None, ::4], axis=-1).max()


RECTANGLE = np.array([(1.8, 0.5), (-1.8, 0.5), (-1.8, -0.5), (1.8, -0.5)])


def test_rectangles_that_come_back_turned_by_half_are_refused_and_by_a_whole_turn_are_not():
    with pytest.raises(sc.InvalidShape, match="come back turned"):
        build.loft(polygons(RECTANGLE, 16, np.pi), closed=True)
    for turn in (0.0, 2 * np.pi, -2 * np.pi):
        made = build.loft(polygons(RECTANGLE, 16, turn), closed=True).value
        assert widths(made).min() > 3.7
    assert widths(build.loft(polygons(RECTANGLE, 16, np.pi)).value).min() > 3.7
    assert build.loft(polygons(RECTANGLE, 16, np.pi), closed=True, align=False).value.periodic == (True, True)


def test_a_band_with_one_side_is_refused():
    lines = [sc.BezierCurve(points) for points in ring(np.array([(-1.0, 0.0), (1.0, 0.0)]), 24, np.pi)]
    with pytest.raises(sc.InvalidShape, match="come back turned"):
        build.loft(lines, closed=True)


def test_smooth_sections_share_what_is_left_of_a_turn():
    """An ellipse by half a turn: nowhere thinner, and each section is on the surface."""
    angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    sections = ovals(np.c_[2 * np.cos(angle), np.sin(angle)], 20, np.pi)
    made = build.loft(sections, closed=True).value
    assert widths(made).min() > 0.98 * width_of(sections[0])
    for section in sections:
        assert made.nearest(section.evaluate(np.linspace(*section.domain, 40))).distances.max() < 1e-12


def test_random_rings(inputs):
    refused = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 12])
        count, sides = int(rng.integers(12, 24)), int(rng.integers(3, 8))
        angle = np.sort(rng.uniform(0, 2 * np.pi, sides)) if rng.random() < 0.5 else np.linspace(0, 2 * np.pi, sides, endpoint=False)
        if np.diff(np.r_[angle, angle[0] + 2 * np.pi]).max() > 2.5 or np.diff(np.r_[angle, angle[0] + 2 * np.pi]).min() < 0.2:
            continue
        outline = np.c_[np.cos(angle), np.sin(angle)] * rng.uniform(0.5, 2, 2)
        shares = rng.integers(-3, 4)
        turn = rng.choice([2 * np.pi, np.pi, 2 * np.pi / sides]) * shares
        sections = (polygons if rng.random() < 0.5 else ovals)(outline, max(count, 32 * abs(shares)), turn)
        try:
            made = build.loft(sections, closed=True).value
        except sc.InvalidShape as error:
            assert "come back turned" in str(error) and turn % (2 * np.pi) != 0.0, (seed, error)
            refused += 1
            continue
        least = min(width_of(section) for section in sections)
        assert widths(made, 49).min() > 0.8 * least, seed
    assert refused > 0
