"""Rims with holes in them: plates and letters are filled to their area, and capped to closed bodies with normals outwards."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_caps import area_of, polygon, require_closed, require_unfolded

UP = np.array([0.0, 0.0, 1.0])
RECTANGLE = polygon((0, 0), (8, 0), (8, 4), (0, 4))


def circle(x, y, radius):
    return sc.conics.circle((x, y, 0), radius).to_nurbs()


def blob(rng, x, y, radius, degree=3):
    """A closed curve about a point, within a radius."""
    count = int(rng.integers(degree + 2, 9))
    angles = np.sort(rng.uniform(0.0, 0.6, count)) + np.arange(count)
    angles *= 2 * math.pi / count
    rows = [(x + r * math.cos(a), y + r * math.sin(a), 0.0) for a, r in zip(angles, rng.uniform(0.4, 1.0, count) * radius)]
    return sc.NurbsCurve(degree, np.arange(count + 1.0), rows, periodic=True)


PLATES = {
    'two bolt holes': (RECTANGLE, [circle(2, 2, 1), circle(6, 2, 0.5)]),
    'four bolt holes': (RECTANGLE, [circle(x, y, 0.4) for x in (1, 7) for y in (1, 3)]),
    'holes in a disc': (circle(0, 0, 5), [circle(3.5 * math.cos(a), 3.5 * math.sin(a), 0.6) for a in np.arange(8) * math.pi / 4]),
    'square holes': (RECTANGLE, [polygon((x, 1), (x, 3), (x + 1, 3), (x + 1, 1)) for x in (1, 3, 5)]),
    'a letter': (polygon((0, 0), (3, 0), (3.6, 0.7), (3.6, 2), (3, 2.5), (3.4, 3), (3.4, 4.4), (3, 5), (0, 5)),
                 [polygon((1, 1), (2.5, 1), (2.6, 2), (1, 2)), polygon((1, 3), (2.5, 3), (2.5, 4), (1, 4))]),
    'one hole out of the middle': (RECTANGLE, [circle(7.4, 3.4, 0.5)]),
    'large holes near each other': (RECTANGLE, [circle(2, 2, 1.9), circle(6, 2, 1.99)]),
    'a thin star in a disc': (circle(0, 0, 3), [polygon(*((r * math.cos(a), r * math.sin(a)) for a, r in zip(
        np.arange(14) * math.pi / 7, [2.5, 0.5] * 7)))]),
}


def area_left(outer, holes):
    return area_of(build.fill_rim([outer]).value) - sum(area_of(build.fill_rim([hole]).value) for hole in holes)


@pytest.mark.parametrize('turned', (False, True))
@pytest.mark.parametrize('name', PLATES)
def test_plates_are_filled_to_their_area_and_capped_to_closed_bodies(name, turned):
    outer, holes = PLATES[name]
    holes = [hole.reversed() if turned and i % 2 else hole for i, hole in enumerate(holes)]
    wanted = area_left(outer, holes)
    patches, bend = build.fill_rim([*holes, outer])
    assert bend == 0.0 and area_of(patches) == pytest.approx(wanted, rel=1e-9)
    require_unfolded(patches, UP)
    walls = [build.extrude(curve, (0, 0, 2)) for curve in (outer, *holes)]
    sides = [side for end in build.open_ends(walls) for side in end]
    start, end = ([side for side in sides if side[1].endswith(which)] for which in ('start', 'end'))
    require_closed(build.cap(walls, [start, end]).value, 2 * wanted)


def test_regions_in_holes_and_apart_are_filled():
    curves = [circle(0, 0, 5), circle(0, 0, 4), circle(1, 0, 2), circle(1, 0, 1), circle(20, 0, 3), circle(20, 1, 1), circle(20, -1, 0.5)]
    patches, _ = build.fill_rim(curves)
    assert area_of(patches) == pytest.approx(math.pi * (25 - 16 + 4 - 1 + 9 - 1 - 0.25), rel=1e-9)
    require_unfolded(patches, UP)


def test_holes_that_cross_or_touch_are_refused():
    for holes in ([circle(2, 2, 1), circle(3, 2, 1)], [circle(2, 2, 1), circle(4, 2, 1)], [circle(2, 2, 1), circle(8, 2, 1)]):
        with pytest.raises(sc.InvalidShape, match="crosses itself or another"):
            build.fill_rim([RECTANGLE, *holes])


def random_plate(rng):
    """A plate of any size, turned any way, with holes in cells of a grid."""
    columns, rows = rng.integers(1, 4, 2)
    outer = polygon((0, 0), (columns, 0), (columns, rows), (0, rows))
    holes = []
    for x in range(columns):
        for y in range(rows):
            if rng.random() < 0.7:
                kind = rng.integers(3)
                radius = rng.uniform(0.02, 0.48)
                place = x + 0.5, y + 0.5
                holes.append(circle(*place, radius) if kind == 0 else blob(rng, *place, radius, int(rng.integers(1, 5))))
    return outer, [hole.reversed() if rng.random() < 0.5 else hole for hole in holes]


def anywhere(rng):
    """A matrix that turns, moves and scales, and its scale and normal."""
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    axes[:, 2] *= np.linalg.det(axes)
    scale = 10.0 ** rng.uniform(-3, 3)
    return np.c_[axes * scale, rng.normal(0, 10, 3) * scale], scale, axes[:, 2]


def test_random_plates_are_filled_to_their_area_and_capped_to_closed_bodies(inputs):
    rng = np.random.default_rng(7)
    for number in range(inputs(1000)):
        outer, holes = random_plate(rng)
        wanted = area_left(outer, holes)
        matrix, scale, normal = anywhere(rng)
        loops = [curve.transformed(matrix) for curve in (outer, *holes)]
        rng.shuffle(loops)
        patches, bend = build.fill_rim(loops)
        assert bend <= 1e-9 * scale and area_of(patches) == pytest.approx(wanted * scale**2, rel=1e-6), number
        _, normals = patches[0].evaluate_grid_with_normals(*([0.5 * (start + end)] for start, end in patches[0].domain))
        require_unfolded(patches, normal if normals.ravel() @ normal > 0.0 else -normal)
        if number % 4 == 0:
            walls = [build.extrude(curve, normal * scale) for curve in loops]
            sides = [side for end in build.open_ends(walls) for side in end]
            both = [[side for side in sides if side[1].endswith(which)] for which in ('start', 'end')]
            volume = sc.PatchSet.from_patches(build.cap(walls, both).value).volume()
            assert volume == pytest.approx(wanted * scale**3, rel=1e-6), number
