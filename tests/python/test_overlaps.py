"""What is told of surfaces that cross themselves: where, and of no others."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build
from test_addon_caps import CIRCLE, make, moved

overlaps = core('surfaces.overlaps')
UP = (0.0, 0.0, 1.0)


def through(*points):
    return build.polynomial_through(points).to_nurbs()


LOOP = through((0, 0, 0), (2, 2, 0), (2, 0, 0), (0, 2, 0))
RAIL = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])


def test_extruded_profiles_that_cross_are_told_of():
    assert "the curve crosses itself at u = 0.05904 and u = 0.941" in make('extrude', LOOP).warning
    assert make('extrude', CIRCLE).warning == "" and make('extrude', [moved(CIRCLE, size=3.0), CIRCLE]).warning == ""
    assert "curves 1 and 3 of 3 cross" in make('extrude', [CIRCLE, moved(CIRCLE, x=9.0), moved(CIRCLE, x=1.0)]).warning
    rising = through((0, 0, 0), (2, 2, 1), (2, 0, 2), (0, 2, 3))
    assert make('extrude', rising, z=1.0).warning == "" and "crosses itself" in make('extrude', rising, z=4.0).warning


def test_profiles_across_their_axis_are_told_of():
    across, beside = through((-1, 0, 0), (1, 1, 0), (2, 3, 0)), through((0, 0, 0), (1, 1, 0), (2, 3, 0))
    assert "the curve crosses the axis at u = 0.2192" in make('revolve', across, axis='y').warning
    assert make('revolve', beside, axis='y').warning == "" and make('revolve', across, axis='y', sweep=1.0).warning == ""
    assert "crosses itself" in make('revolve', moved(LOOP, x=5.0), axis='y').warning
    assert make('revolve', through((-1, 0, 0.5), (1, 1, 0.2), (2, 3, 0)), axis='y').warning == ""


@pytest.mark.parametrize('scale', (1e-3, 1.0, 1e3))
def test_pipes_and_sweeps_fold_where_the_rail_bends_more_than_they_allow(scale):
    rail = moved(RAIL, size=scale)
    bend = 1.0 / rail.curvature([0.5])[0]
    for radius, is_too_thick in ((0.9 * bend, False), (0.99 * bend, False), (1.05 * bend, True), (3.0 * bend, True)):
        told = [make('pipe', rail, radius=radius, end_radius=radius, tolerance=1e-4 * scale).warning,
                make('sweep', rail, moved(CIRCLE, size=radius), tolerance=1e-4 * scale).warning]
        for words in told:
            assert ("at u = 0.5: the surface folds there" in words) == is_too_thick, (radius, words)
    assert f"with a radius of {core('base.decimals').text_of(bend)}" in told[0]


def keyhole():
    """Walls 0.3 apart that end in a wide bow."""
    angles = np.linspace(-math.pi / 2 - 0.3, -math.pi / 2 - 2 * math.pi + 0.3, 24)
    rows = [*((-0.15, y, 0) for y in (-4, -3, -2)), *((1.5 * math.cos(a), 1.5 * math.sin(a), 0) for a in angles),
            *((0.15, y, 0) for y in (-2, -3, -4))]
    count = len(rows)
    return build.extrude(sc.NurbsCurve(3, np.r_[[0] * 3, np.arange(count - 2.0), [count - 3] * 3], rows), UP)


@pytest.mark.parametrize('kind, name', (('thickened', 'distance'), ('offset_surface', 'distance')))
def test_what_is_too_thick_is_told_of(kind, name):
    for distance, is_too_thick in ((0.13, False), (0.2, True), (-0.13, False)):
        told = make(kind, keyhole(), **{name: distance, 'tolerance': 1e-3}).warning
        assert ("it goes through itself there" in told) == is_too_thick, (distance, told)
    if kind == 'thickened':
        assert "goes through itself" not in make(kind, keyhole(), distance=0.26, middle=True, tolerance=1e-3).warning
        assert "goes through itself" in make(kind, keyhole(), distance=0.4, middle=True, tolerance=1e-3).warning
