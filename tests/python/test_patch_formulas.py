"""De Boor's and de Casteljau's numbers of patches as text: what is written is read back and compared with the surface."""

import re

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

formulas = core("formulas.formulas")
POINT = re.compile(r"(\S+(?: = \S+)?)  \(([^)]*)\) w = (\S+)")


def number(text):
    over, _, below = text.partition("/")
    return float(over) / float(below or 1)


def grid(seed, *shape):
    return np.random.default_rng(seed).integers(-9, 10, (*shape, 3)).astype(float)


def weights(seed, *shape):
    return np.random.default_rng(seed).integers(1, 5, shape).astype(float)


PATCHES = {
    'bezier': sc.BezierPatch(grid(1, 4, 3), weights(1, 4, 3)),
    'nurbs': sc.NurbsPatch((3, 2), ([0, 1, 2, 3, 4, 5.5, 6, 7, 8], [0, 0, 0, 1 / 3, 2, 2, 2]), grid(2, 5, 4), weights(2, 5, 4)),
    'periodic': sc.NurbsPatch((2, 1), ([0, 1, 2, 4, 5], [0, 0, 1, 1]), grid(3, 4, 2), periodic=(True, False)),
}


def steps(patch, position):
    """[(heading, [[(name, point, weight)] by level])] of the algorithm along u by rows, then along v."""
    block = next(part for part in formulas.text(patch, position).split("\n\n") if " algorithm at u = " in part)
    found = []
    for line in block.splitlines()[1:]:
        if line.startswith("    "):
            found[-1][1].append([(name, np.array([number(x) for x in place.split(", ")]), number(weight))
                                 for name, place, weight in POINT.findall(line)])
        else:
            found.append((line.strip(), []))
    return found


@pytest.mark.parametrize('position', (0, 0.3, 1))
@pytest.mark.parametrize('name', PATCHES)
def test_the_numbers_lead_from_control_points_of_the_span_to_the_point_of_the_surface(name, position):
    patch = PATCHES[name]
    *rows, last = steps(patch, position)
    u, v = (start + position * (end - start) for start, end in patch.to_nurbs().domain)
    assert len(rows) == patch.degree[1] + 1 and last[0] == "along v, of these:"
    for heading, levels in rows:
        j = int(re.match(r"row (\d+), which gives Q\1:$", heading)[1])
        assert [len(level) for level in levels] == list(range(patch.degree[0] + 1, 0, -1))
        for called, point, weight in levels[0]:
            i, row = map(int, re.match(r"P(\d+),(\d+)$", called).groups())
            assert row == j and np.array_equal(point, patch.points[i, j]) and weight == patch.weights[i, j]
        (_, point, weight), = levels[-1]
        assert (f"Q{j}", tuple(point), weight) in [(name, tuple(place), w) for name, place, w in last[1][0]]
    (_, point, _), = last[1][-1]
    assert np.allclose(point, patch.evaluate(u, v), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize('name', PATCHES)
def test_each_level_divides_the_one_above_it_in_its_ratio(name):
    for _, levels in steps(PATCHES[name], 0.3):
        for above, level in zip(levels, levels[1:]):
            for (_, p, w), (_, q, x), (ratio, found, weight) in zip(above, above[1:], level):
                a = number(ratio.removeprefix("a = "))
                assert 0 <= a <= 1 and np.isclose(weight, (1 - a) * w + a * x, rtol=1e-8)
                assert np.allclose(found, ((1 - a) * w * p + a * x * q) / weight, rtol=1e-7, atol=1e-8)


def test_the_name_of_the_algorithm_and_what_is_too_long_are_said():
    assert "de Casteljau's algorithm at u = 0.5, v = 0.5" in formulas.text(PATCHES['bezier'], 0.5)
    assert "de Boor's algorithm at u = " in formulas.text(PATCHES['nurbs'], 0.5)
    assert "algorithm is written up to degree 9" in formulas.text(sc.BezierPatch(grid(4, 11, 2)), 0.5)
    flat = [grid(5 + i, 2, 2) for i in range(4)]
    assert "algorithm" not in formulas.text(sc.HermitePatch(*flat), 0.5)
