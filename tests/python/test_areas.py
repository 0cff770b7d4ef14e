"""Areas and volumes: closed forms of patches of many spans, at every scale of their parameters, on every processor."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


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


MANY = """
import json, sys
sys.path.insert(0, sys.argv[1])
import numpy as np
import test_areas, test_kernels
patches = [*test_kernels.patches(np.random.default_rng(3)), test_areas.sphere()]
print(json.dumps([patch.area(tolerance=1e-4) for patch in patches]))
"""


def areas(kernels):
    made = subprocess.run([sys.executable, "-c", MANY, os.path.dirname(__file__)], capture_output=True, text=True,
                          check=True, env={**os.environ, "SPLINECORE_KERNELS": kernels})
    return np.array(json.loads(made.stdout))


def test_every_processor_finds_nearly_the_same():
    first, second = areas("baseline"), areas("x86-64-v3")
    assert np.abs(first / second - 1).max() <= 1e-12
