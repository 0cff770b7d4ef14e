"""Cylinders, cones, spheres and tori of several sizes, parts of a turn, elsewhere and turned: against closed forms.

Whole turns at one place are in test_primitives.py (radii) and test_measures.py (a sphere's curvature, bodies).
"""

import math

import numpy as np
import pytest

import splinecore as sc
from shapes import inside
from splinecore import build

TURNS = {'whole': (0.0, 2 * math.pi), 'quarter': (0.0, math.pi / 2), 'half': (-1.0, math.pi), 'narrow': (0.4, 0.5),
         'clockwise': (2.0, -3.9)}
PLACES = {'origin': ((0, 0, 0), (0, 0, 1)), 'away': ((3.5, -2.25, 1.0), (2, -1, 2)),
          'below': ((-1, 4, 2), (-0.3, 0.1, -1))}
SIZES = (1e-3, 1.0, 2.5, 4e4)


def every_case(test):
    for name, values in (('size', SIZES), ('turn', TURNS), ('place', PLACES)):
        test = pytest.mark.parametrize(name, values)(test)
    return test


def settings_of(size, turn, place):
    """Center and unit axis, and start and sweep as arguments; the center as far away as the size says."""
    center, axis = (np.array(numbers, float) for numbers in PLACES[place])
    start, sweep = TURNS[turn]
    return size * center, axis / np.linalg.norm(axis), (start, None if turn == 'whole' else sweep)


def places(patch, skip=0):
    """Parameters inside the patch and on its border but for the last `skip` rows, as columns for u and rows for v."""
    u, v = (inside(domain, 9) for domain in patch.domain)
    return u[:, None], v[:len(v) - skip]


def split(points, center, axis):
    """(height along the axis, distance from it)."""
    height = (points - center) @ axis
    return height, np.linalg.norm(points - center - height[..., None] * axis, axis=-1)


def rounding(size, place):
    """1e-14 of the largest coordinate: what is far from the origin has fewer digits left."""
    return 1e-14 * size * (1 + np.linalg.norm(PLACES[place][0]))


def check_curvatures(patch, at, around, along, sweep):
    """Of magnitudes `around` and `along`, bent away from the normal of a counter-clockwise turn."""
    found, sign = patch.curvatures(*at), -math.copysign(1, sweep)
    around, along = np.broadcast_to(around, found.mean.shape), np.broadcast_to(along, found.mean.shape)
    largest = np.maximum(np.abs(around), np.abs(along))
    expected = np.sort(sign * np.stack([around, along], axis=-1), axis=-1)[..., ::-1]
    assert (np.abs(found.gauss - around * along) <= 1e-12 * largest**2).all()
    assert (np.abs(found.mean - sign * (around + along) / 2) <= 1e-12 * largest).all()
    assert (np.abs(found.principal - expected) <= 1e-12 * largest[..., None]).all()


@every_case
def test_a_cylinder_has_its_radius_curvature_and_area(size, turn, place):
    center, axis, around = settings_of(size, turn, place)
    patch = build.cylinder(center, axis, size, 3 * size, *around)
    at, sweep = places(patch), TURNS[turn][1]
    _, radius = split(patch.evaluate(*at), center, axis)
    assert np.abs(radius - size).max() <= rounding(size, place)
    check_curvatures(patch, at, 1 / size, 0.0, sweep)
    assert patch.area() == pytest.approx(3 * size**2 * abs(sweep), rel=1e-12)


@every_case
@pytest.mark.parametrize('top', (0.0, 0.25, 2.0))
def test_a_cone_has_its_radius_curvature_and_area(size, turn, place, top):
    center, axis, around = settings_of(size, turn, place)
    patch = build.cone(center, axis, size, 3 * size, top * size, *around)
    at, sweep, slant = places(patch, skip=top == 0), TURNS[turn][1], math.hypot(3, 1 - top)
    height, radius = split(patch.evaluate(*at), center, axis)
    expected = size + (top - 1) * height / 3
    assert np.abs(radius - expected).max() <= rounding(size, place)
    check_curvatures(patch, at, 3 / slant / expected, 0.0, sweep)
    assert patch.area() == pytest.approx((1 + top) / 2 * slant * size**2 * abs(sweep), rel=1e-12)


@every_case
def test_a_sphere_has_its_radius_curvature_and_area(size, turn, place):
    center, axis, around = settings_of(size, turn, place)
    patch = build.sphere(center, size, axis, *around)
    at, sweep = places(patch), TURNS[turn][1]
    assert np.abs(np.linalg.norm(patch.evaluate(*at) - center, axis=-1) - size).max() <= rounding(size, place)
    check_curvatures(patch, at, 1 / size, 1 / size, sweep)
    assert patch.area() == pytest.approx(2 * size**2 * abs(sweep), rel=1e-12)


@every_case
@pytest.mark.parametrize('tube', (0.1, 0.75))
def test_a_torus_has_its_radii_curvature_and_area(size, turn, place, tube):
    center, axis, around = settings_of(size, turn, place)
    patch = build.torus(center, axis, size, tube * size, *around)
    at, sweep = places(patch), TURNS[turn][1]
    height, radius = split(patch.evaluate(*at), center, axis)
    assert np.abs(np.hypot(height, radius - size) - tube * size).max() <= rounding(size, place)
    check_curvatures(patch, at, (radius - size) / (tube * size) / radius, 1 / (tube * size), sweep)
    assert patch.area() == pytest.approx(2 * math.pi * tube * size**2 * abs(sweep), rel=1e-12)


def wedge_of_cylinder(center, axis, size, start, sweep):
    """A piece of cake: mantle, two sectors and two flat sides on the axis."""
    mantle = build.cylinder(center, axis, size, 3 * size, start, sweep)
    low = build.disc(center, axis, size, start, sweep).reversed('v')
    high = build.disc(center + 3 * size * axis, axis, size, start, sweep)
    spine = sc.BezierCurve([center, center + 3 * size * axis])
    start, end = mantle.boundary('u_start'), mantle.boundary('u_end')
    return [mantle, low, high, build.ruled(spine, start).swapped(), build.ruled(spine, end)]


@pytest.mark.parametrize('size', SIZES)
@pytest.mark.parametrize('place', PLACES)
def test_bodies_of_any_size_and_place_have_the_volume_of_their_closed_form(size, place):
    center, axis, _ = settings_of(size, 'whole', place)
    lid = lambda height, radius: build.disc(center + height * size * axis, axis, radius * size)
    for patches, volume in (
            ([build.sphere(center, size, axis)], 4 / 3 * math.pi),
            ([build.torus(center, axis, size, 0.3 * size)], 2 * math.pi**2 * 0.09),
            ([build.cylinder(center, axis, size, 3 * size), lid(0, 1).reversed('v'), lid(3, 1)], 3 * math.pi),
            ([build.cone(center, axis, size, 3 * size), lid(0, 1).reversed('v')], math.pi),
            ([build.cone(center, axis, size, 3 * size, 2 * size), lid(0, 1).reversed('v'), lid(3, 2)], 7 * math.pi),
            (wedge_of_cylinder(center, axis, size, 0.3, 1.1), 1.5 * 1.1)):
        assert sc.PatchSet.from_patches(patches).volume() == pytest.approx(volume * size**3, rel=1e-12)
