"""Lengths in the messages of what is refused are those of the shapes that were given, of any size and anywhere."""

import re

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SQUARE = [sc.BezierCurve([a, b]) for a, b in (((0, 0, 0), (1, 0, 0)), ((1, 0, 0), (1, 1, 0)), ((1, 1, 0), (0, 1, 0)), ((0, 1, 0.25), (0, 0, 0)))]
WAVE = sc.BezierCurve([(0, 0, 0), (1, 2, 0), (2, -2, 1), (3, 1, 0)])
ARC = sc.conics.arc((0, 0, 0), (1, 0, 0), (0, 1, 0), 0.0, 2.0)
KINKED = sc.NurbsCurve(3, [0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1], [(0, 0, 0), (1, 1, 0), (2, 0, 1), (2, 1, 1), (1, 3, 0), (0, 2, 0.5)])
BENT = sc.BezierPatch(np.array([[(i, j, (i * j) % 3 - 1 + 0.3 * i * i) for j in range(4)] for i in range(4)], float))
EDGE = sc.BezierCurve([(0, 0, 0), (1, 0.3, 0), (2, -0.3, 0), (3, 0, 0)])
FLOOR, WALL = build.extrude(EDGE, (0, 1, 0)), build.extrude(EDGE, (0, 0.2, 1))
CROSSED = [sc.BezierCurve([(x, -1, 0), (x, 2, 0)]) for x in (0.0, 1.0)]
ALONG = [sc.BezierCurve([(-1, y, z), (2, y, z)]) for y, z in ((0.0, 0.0), (1.0, 0.125))]
TINY = 1e-18


def scaled(size):
    """What places shapes there, curves and patches alike."""
    place = np.array([0.5, -0.25, 1.0])
    return lambda shapes: [shape.with_points(size * (np.asarray(shape.points) + place)) for shape in shapes]


CALLS = {
    "fill: a gap": lambda at, size: build.fill(at(SQUARE), tolerance=1e-6 * size),
    "coons: a gap": lambda at, size: build.coons(at(SQUARE), tolerance=1e-6 * size),
    "fill: arcs": lambda at, size: build.fill(at([ARC.part(*np.array(ends) / 3 * ARC.domain[1]) for ends in ((0, 1), (1, 2), (2, 3))]
                                                 + [sc.BezierCurve([ARC.evaluate(ARC.domain[1]), ARC.evaluate(0.0)])]), tolerance=TINY * size),
    "network: no crossing": lambda at, size: build.network(at(ALONG), at(CROSSED), tolerance=1e-3 * size),
    "offset": lambda at, size: build.offset_patch(*at([BENT]), 0.01 * size, tolerance=TINY * size),
    "sweep": lambda at, size: build.sweep(*at([WAVE]), [sc.BezierCurve([(-0.1 * size, 0, 0), (0.1 * size, 0, 0)])], tolerance=TINY * size),
    "two rails": lambda at, size: build.sweep_two_rails(*at([WAVE, sc.BezierCurve(WAVE.points + [(0, 0.3, 1), (0, 0, 1), (0, 1, 2), (0, 0, 1)])]),
                                                        [sc.BezierCurve(size * np.array([(0, 0, 0), (0.5, 0.2, 0), (1, 0, 0)]))], tolerance=TINY * size),
    "pipe": lambda at, size: build.pipe(*at([WAVE]), 0.05 * size, tolerance=TINY * size),
    "fillet": lambda at, size: build.fillet_patches(*(x for pair in zip(at([FLOOR, WALL]), ("v_start", "v_start")) for x in pair),
                                                    [(0.0, 0.1 * size), (1.0, 0.15 * size)], tolerance=TINY * size),
    "degree of a Bezier curve": lambda at, size: at([WAVE])[0].reduce(1, 1e-3 * size),
    "degree": lambda at, size: at([KINKED])[0].reduce(1, 1e-3 * size),
    "knot": lambda at, size: at([KINKED])[0].remove_knot(0.5, 2, 1e-3 * size),
    "closed": lambda at, size: at([KINKED])[0].to_periodic(1e-3 * size),
    "rebuilt": lambda at, size: at([KINKED])[0].rebuild(tolerance=TINY * size),
    "approximated": lambda at, size: sc.fit.approximate(at([KINKED])[0].points, 4, tolerance=1e-3 * size),
}


def lengths_said(call, size):
    """What is said, and the numbers in it."""
    with pytest.raises((sc.InvalidShape, sc.ToleranceNotReached)) as caught:
        call(scaled(size), size)
    return str(caught.value), [float(number) for number in re.findall(r"\d+\.?\d*(?:e[+-]\d+)?", str(caught.value))]


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_lengths_are_those_of_the_shapes(call):
    """The last two are lengths; of errors that are rounding nearly so."""
    said, here = lengths_said(call, 1.0)
    for size in (2.0 ** -20, 1000.0):
        text, there = lengths_said(call, size)
        assert re.sub(r"[\d.e+-]+", "#", text) == re.sub(r"[\d.e+-]+", "#", said)
        powers = [np.log(b / a) / np.log(size) for a, b in zip(here[-2:], there[-2:])]
        assert powers == pytest.approx([1, 1], abs=0.1), (said, text)
