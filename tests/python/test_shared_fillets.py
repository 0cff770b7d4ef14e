"""What rounds an edge shares its sides with what is left of the patches: the same points and knots, and no crack in a mesh."""

import re

import numpy as np
import splinecore as sc
from splinecore import build


def side(patch, name):
    """(points, weights, knots, degree) of a border, in the direction of its parameter."""
    curve = patch.boundary(name)
    return curve.points, curve.weights, np.array(curve.knots), curve.degree


def require_shared(made, first_side, second_side):
    for patch, own, border in ((made.first, first_side, 'v_start'), (made.second, second_side, 'v_end')):
        points, weights, knots, degree = side(patch, own)
        others, other_weights, other_knots, other_degree = side(made.fillet, border)
        assert degree == other_degree
        if not np.array_equal(points, others):
            points, weights, knots = points[::-1], weights[::-1], (knots[0] + knots[-1]) - knots[::-1]
        assert np.array_equal(points, others) and np.array_equal(weights, other_weights)
        assert np.abs(knots - other_knots).max() <= 1e-15
    together = sc.PatchSet.from_patches([made.first, made.fillet, made.second])
    pairs = {frozenset((a[0], b[0])) for a, b in together.seams()}
    assert {frozenset((0, 1)), frozenset((1, 2))} <= pairs
    return together


PARABOLA = build.polynomial_through([(0, 0, 0), (5, 2, 0), (10, 0, 0)])


def test_a_wall_on_a_parabola_and_a_floor():
    wall, floor = build.extrude(PARABOLA, (0, 0, 4)), build.extrude(PARABOLA, (0, -8, 0))
    made = build.fillet_patches(wall, 'v_start', floor, 'v_start', 1.0)
    require_shared(made, 'v_start', 'v_start')
    inside = build.extrude(PARABOLA, (0, 8, 0))
    require_shared(build.fillet_patches(wall, 'v_start', inside, 'v_start', 0.7, tolerance=1e-4), 'v_start', 'v_start')


def test_the_rim_of_a_tube_and_its_lid_are_exact():
    tube, lid = build.cylinder((0, 0, 0), (0, 0, 1), 5, 10), build.disc((0, 0, 10), (0, 0, 1), 5)
    made = build.fillet_patches(tube, 'v_end', lid, 'v_start', 1.0)
    together = require_shared(made, 'v_end', 'v_start')
    points = made.fillet.evaluate_grid(*(np.linspace(*domain, 65) for domain in made.fillet.domain)).reshape(-1, 3)
    off = np.hypot(np.hypot(points[:, 0], points[:, 1]) - 4, points[:, 2] - 9) - 1
    assert np.abs(off).max() < 1e-13 and made.error < 1e-13
    assert together.edge_counts()['free'] == 1


def spline_rim(rng, count):
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    size = 3 + rng.uniform(-0.3, 0.3, count)
    return np.c_[size * np.cos(turn), size * np.sin(turn), np.zeros(count)]


def test_rims_of_splines(inputs):
    for seed in range(inputs(40)):
        rng = np.random.default_rng([seed, 21])
        points = spline_rim(rng, int(rng.integers(7, 12)))
        rim = sc.NurbsCurve(3, np.arange(len(points) + 1.0), points, periodic=True)
        wall = build.extrude(rim, (0, 0, 3))
        lid = build.ruled(rim, rim.with_points(0.2 * points))
        made = build.fillet_patches(wall, 'v_start', lid, 'v_start', 0.3, tolerance=1e-4)
        assert made.error <= 1e-4
        require_shared(made, 'v_start', 'v_start')


def bent_pair(rng):
    """Two patches with a border in common, of several degrees and spans, sides that slant, perhaps with weights."""
    degree = int(rng.integers(1, 4))
    count = degree + 1 + int(rng.integers(0, 3))
    knots = np.r_[np.zeros(degree + 1), np.sort(rng.uniform(0.1, 0.9, count - degree - 1)), np.ones(degree + 1)]
    border = np.c_[np.linspace(0, 4, count), 0.25 * rng.normal(size=(count, 2)) * (degree > 1)]
    weights = 10**rng.uniform(-0.2, 0.2, count) if rng.random() < 0.3 else np.ones(count)
    angle = rng.uniform(0.8, 2.3)
    pair = []
    for way in ((0.0, 2.0, 0.0), (0.0, 2 * np.cos(angle), 2 * np.sin(angle))):
        slant = np.c_[np.linspace(*rng.uniform(-0.4, 0.4, 2), count), np.zeros((count, 2))]
        net = np.stack([border, border + slant + way], axis=1)
        if rng.random() < 0.5:
            net = np.stack([border, border + 0.5 * (slant + way), border + slant + way], axis=1)
            net[:, 2] += 0.15 * rng.normal(size=(count, 3))
        width = net.shape[1]
        pair.append(sc.NurbsPatch((degree, width - 1), (knots, np.r_[np.zeros(width), np.ones(width)]), net,
                                  np.repeat(weights[:, None], width, axis=1)))
    return pair


def test_random_edges(inputs):
    """Whatever is rounded is shared; what is left lies on the patches, and the fillet on the ball."""
    made_count = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 22])
        a, b = bent_pair(rng)
        size = 10**rng.uniform(-6, 6)
        axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        matrix = np.c_[size * axes, size * rng.normal(size=3)]
        a, b = a.transformed(matrix), b.transformed(matrix)
        radius = size * rng.uniform(0.1, 0.4)
        sides = []
        for k, patch in enumerate((a, b)):
            name = 'v_start'
            if rng.random() < 0.3:
                patch, name = patch.reversed('v'), 'v_end'
            if rng.random() < 0.3:
                patch = patch.reversed('u')
            if rng.random() < 0.3:
                patch, name = patch.swapped(), name.replace('v', 'u')
            sides += [patch, name]
        try:
            made = build.fillet_patches(*sides, radius, tolerance=1e-4 * size)
        except sc.InvalidShape as error:
            assert "ball" in str(error) or "crease" in str(error) or "tangent plane" in str(error) or "inner one" in str(error), (seed, error)
            continue
        except sc.ToleranceNotReached as error:
            # Of degree 2, with knots: they bend abruptly there, and the ball with them.
            assert re.search(r"bends abruptly at 0\.\d+ of the edge|the rest of the (first|second) patch .* near 0\.\d+ of its edge", str(error))
            continue
        made_count += 1
        assert made.error <= 1e-4 * size
        require_shared(made, sides[1], sides[3])
        for patch, left in ((sides[0], made.first), (sides[2], made.second)):
            points = left.evaluate_grid(*(np.linspace(*domain, 7) for domain in left.domain)).reshape(-1, 3)
            assert patch.nearest(points).distances.max() <= 1e-4 * size, seed
    assert made_count > 0.6 * inputs(1000)


def test_radii_grow_along_an_edge_whose_sides_slant():
    """The ball runs beyond the end of one patch where the other ends: its radius goes on, and all stays linear."""
    for slant in (-2.0, -0.7, 0.3, 1.0, 2.5):
        ground, wall = build.plane((0, 0, 0), (3, 0, 0), (slant, 2, 0)), build.plane((0, 0, 0), (3, 0, 0), (0, 0, 2))
        for radii in ([(0, 0.1), (1, 0.4)], [(0, 0.4), (1, 0.1)], [(0, 0.02), (1, 0.6)]):
            for pair in ((ground, wall), (wall, ground)):
                made = build.fillet_patches(pair[0], 'v_start', pair[1], 'v_start', radii)
                require_shared(made, 'v_start', 'v_start')
                assert made.error < 1e-12 and made.fillet.points.shape[0] <= 4


def test_radii_change_along_a_rim_whose_lid_is_turned():
    """The ball runs over the seam of a closed edge: its radius goes round."""
    turn = np.linspace(0, 2 * np.pi, 9, endpoint=False)
    rings = [np.c_[size * np.cos(turn + by), size * np.sin(turn + by), 0 * turn] for size, by in ((3, 0), (1, 0.5))]
    rim = sc.NurbsCurve(3, np.arange(10.0), rings[0], periodic=True)
    lid, wall = build.ruled(rim, rim.with_points(rings[1])), build.extrude(rim, (0, 0, 3))
    for radii in ([(0, 0.2), (4.5, 0.4)], [(1, 0.2), (4, 0.4), (8, 0.3)], [(0.5, 0.3), (5, 0.2)]):
        for pair in ((lid, wall), (wall, lid)):
            made = build.fillet_patches(pair[0], 'v_start', pair[1], 'v_start', radii, tolerance=1e-5)
            require_shared(made, 'v_start', 'v_start')
            assert made.error <= 1e-5
