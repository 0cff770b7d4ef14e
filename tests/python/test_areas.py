"""Areas and volumes: closed forms of patches of many spans, at every scale of their parameters, on every processor."""

import time

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_kernels import found_by_sets


def near(value, expected, relative=1e-12):
    return abs(value - expected) <= relative * expected


def inner(patch, axis, count):
    start, end = patch.domain[axis]
    return np.linspace(start, end, count + 2)[1:-1]


def with_spans(patch, count):
    """The same surface, with so many knots more in each direction."""
    return patch.refine("u", inner(patch, 0, count)).refine("v", inner(patch, 1, count))


def sphere():
    return build.sphere((1, 2, 3), 2.0)


def test_a_hundred_by_a_hundred_spans_have_the_area_of_the_few_that_they_were():
    wide = with_spans(sphere(), 97)
    assert min(len(np.unique(knots)) for knots in wide.knots) > 98
    assert near(wide.area(tolerance=1e-9), 16 * np.pi)
    flat = sc.NurbsPatch((1, 1), ([0, *range(101), 100],) * 2,
                         np.stack(np.meshgrid(np.arange(101.0), np.arange(101.0), [0.0]), -1)[:, :, 0])
    assert near(flat.area(), 1e4)


def test_spans_may_be_as_short_as_rounding():
    flat = sc.NurbsPatch((2, 1), ([0, 0, 0, 0.5, np.nextafter(0.5, 1), 1, 1, 1], [0, 0, 1, 1]),
                         [[(x, y, 0.0) for y in (0, 1)] for x in (0, 1, 2, 3, 4)])
    assert near(flat.area(), 4.0)


@pytest.mark.parametrize("size", [1e-140, 1e-20, 1e20, 1e140])
def test_the_scale_of_the_parameters_changes_nothing(size):
    patch = with_spans(sphere(), 3)
    u, v = patch.knots
    wide = sc.NurbsPatch(patch.degree, (u * size, v / size), patch.points, patch.weights, patch.periodic)
    assert near(wide.area(), 16 * np.pi)


def test_the_time_of_an_area_grows_as_its_spans():
    rng = np.random.default_rng(12)

    def seconds(count, side):
        knots = np.concatenate([[0] * 4, np.arange(1, count), [count] * 4])
        short = np.concatenate([[0] * 4, np.arange(1, side), [side] * 4])
        net = np.stack([*np.meshgrid(np.arange(count + 3.0), np.arange(side + 3.0), indexing="ij"),
                        0.1 * rng.normal(size=(count + 3, side + 3))], -1)
        patch = sc.NurbsPatch((3, 3), (knots, short), net)
        best = np.inf
        for _ in range(5):
            start = time.process_time()
            patch.area(tolerance=1e-6)
            best = min(best, time.process_time() - start)
        return best

    few = seconds(20, 20)
    assert seconds(80, 80) <= 2.5 * 16 * few
    assert seconds(1600, 4) <= 2.5 * 16 * few


MANY = """
import json, sys
sys.path.insert(0, sys.argv[1])
import numpy as np
import splinecore, test_areas, test_kernels
patches = [*test_kernels.patches(np.random.default_rng(3)), test_areas.sphere()]
print(json.dumps([splinecore.__instruction_set__, [patch.area(tolerance=1e-4) for patch in patches]]))
"""


def test_every_processor_finds_nearly_the_same():
    first, *others = found_by_sets(MANY)
    for other in others:
        assert np.abs(first / other - 1).max() <= 1e-12
