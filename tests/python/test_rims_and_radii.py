"""Fillets of closed rims that begin elsewhere or run at another pace, and of radii that change: against balls counted on their own."""

import re

import numpy as np
import pytest
import splinecore as sc
from splinecore import build
from test_shared_fillets import spline_rim


def pairs_of(made):
    together = sc.PatchSet.from_patches([made.first, made.fillet, made.second])
    return together, {frozenset((a[0], b[0])) for a, b in together.seams()}


def require_closed_up(made):
    together, pairs = pairs_of(made)
    assert {frozenset((0, 1)), frozenset((1, 2))} <= pairs
    return together


def turned(patch, angle):
    c, s = np.cos(angle), np.sin(angle)
    return patch.transformed(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]))


def torus_miss(fillet):
    points = fillet.evaluate_grid(*(np.linspace(*domain, 65) for domain in fillet.domain)).reshape(-1, 3)
    return np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 4, points[:, 2] - 9) - 1).max()


@pytest.mark.parametrize("angle", [0.3, np.pi / 2, 2.0, np.pi, 4.0])
def test_a_tube_and_what_is_turned_on_it(angle):
    tube = build.cylinder((0, 0, 0), (0, 0, 1), 5, 10)
    lid = turned(build.disc((0, 0, 10), (0, 0, 1), 5), angle)
    made = build.fillet_patches(tube, 'v_end', lid, 'v_start', 1.0, tolerance=1e-5)
    assert require_closed_up(made).edge_counts()['free'] == 1
    assert torus_miss(made.fillet) <= 1e-5
    if angle % (np.pi / 2) == 0:
        assert made.error < 1e-13  # a lid may begin where the tube does
    rim = lid.boundary('v_start')
    ring = build.ruled(rim, rim.with_points(rim.points * (0.4, 0.4, 1)))
    for other in (ring, ring.reversed('u')):
        made = build.fillet_patches(tube, 'v_end', other, 'v_start', 1.0, tolerance=1e-5)
        require_closed_up(made)
        assert torus_miss(made.fillet) <= 1e-5
        ends = [patch.boundary('v_end') for patch in (made.second, other)]
        t = np.linspace(0, 1, 65)
        at = [one.evaluate(one.domain[0] + t * (one.domain[1] - one.domain[0])) for one in ends]
        assert np.abs(at[0] - at[1]).max() <= 1e-12  # its other side stays an edge of what lies there


def test_rims_of_splines_that_begin_elsewhere(inputs):
    for seed in range(inputs(16)):
        rng = np.random.default_rng([seed, 61])
        points = spline_rim(rng, int(rng.integers(7, 12)))
        rim = sc.NurbsCurve(3, np.arange(len(points) + 1.0), points, periodic=True)
        wall = build.extrude(rim, (0, 0, 3))
        later = rim.with_points(np.roll(points, -int(rng.integers(1, len(points))), axis=0))
        lid = build.ruled(later, later.with_points(0.2 * later.points))
        if rng.random() < 0.5:
            lid = lid.reversed('u')
        radius = 0.3 if rng.random() < 0.5 else [(1.0, 0.2), (4.0, 0.3)]
        made = build.fillet_patches(wall, 'v_start', lid, 'v_start', radius, tolerance=1e-3)
        assert made.error <= 1e-3
        require_closed_up(made)


def radius_at(radii, u):
    """Of two numbers, before the first and behind the last level: with three derivatives everywhere."""
    (start, low), (end, high) = radii
    t = np.clip((u - start) / (end - start), 0, 1)
    return low + (high - low) * t**4 * (35 - 84 * t + 70 * t**2 - 20 * t**3)


def wall_and_floor(rng):
    """Two planes on the x axis; the ball's center is at a closed form."""
    angle = rng.uniform(0.9, 2.2)
    slants = rng.uniform(-0.6, 0.6, 2) if rng.random() < 0.5 else (0, 0)
    floor = build.plane((0, 0, 0), (3, 0, 0), (slants[0], 3, 0))
    wall = build.plane((0, 0, 0), (3, 0, 0), (slants[1], 3 * np.cos(angle), 3 * np.sin(angle)))
    return floor, wall, angle


def test_fillets_are_hulls_of_balls(inputs):
    """Points of a fillet are as near to the nearest ball as the tolerance says, and inside none by more."""
    for seed in range(inputs(40)):
        rng = np.random.default_rng([seed, 62])
        floor, wall, angle = wall_and_floor(rng)
        radii = [(rng.uniform(0.1, 0.3), rng.uniform(0.1, 0.3)), (rng.uniform(0.7, 0.9), rng.uniform(0.1, 0.3))]
        made = build.fillet_patches(floor, 'v_start', wall, 'v_start', radii, tolerance=1e-5)
        require_closed_up(made)
        points = made.fillet.evaluate_grid(*(np.linspace(*domain, 21) for domain in made.fillet.domain)).reshape(-1, 3)
        x = np.linspace(-1, 4, 6001)
        # the floor's contact at u is x = 3 u + slant v, v = |contact - edge| / 3: centers by x, from the floor's parameter u
        slant = floor.evaluate([0], [1])[0][0]
        u = np.linspace(-0.6, 1.6, 6001)
        r = radius_at(radii, u)
        away = r / np.tan(angle / 2)
        x = 3 * u + slant * away / 3
        centers = np.c_[x, away, r]
        for block in np.array_split(points, 21):
            off = np.linalg.norm(block[:, None] - centers[None], axis=2) - r
            assert np.abs(off.min(axis=1)).max() <= 1e-5, seed


def test_fillets_touch_what_they_round(inputs):
    """Normals along the sides are those of the patches."""
    for seed in range(inputs(40)):
        rng = np.random.default_rng([seed, 63])
        floor, wall, _ = wall_and_floor(rng)
        radii = [(rng.uniform(0.1, 0.3), rng.uniform(0.1, 0.3)), (rng.uniform(0.7, 0.9), rng.uniform(0.1, 0.3))]
        made = build.fillet_patches(floor, 'v_start', wall, 'v_start', radii)
        for border, patch, own in (('v_start', made.first, 'v_start'), ('v_end', made.second, 'v_start')):
            found = sc.seam_continuity(made.fillet, border, patch, own)
            assert found.gap <= 1e-12 and found.angle <= 2e-3, (seed, found)


@pytest.mark.parametrize("slant", [-2.0, -0.7, 0.3, 1.0, 2.5])
def test_radii_inside_an_edge_whose_sides_slant(slant):
    """They go on level to its ends."""
    ground, wall = build.plane((0, 0, 0), (3, 0, 0), (slant, 2, 0)), build.plane((0, 0, 0), (3, 0, 0), (0, 0, 2))
    for radii in ([(0.2, 0.1), (0.8, 0.4)], [(0.2, 0.4), (0.8, 0.1)], [(0.5, 0.2)], [(0, 0.1), (0.6, 0.3)]):
        for pair in ((ground, wall), (wall, ground)):
            made = build.fillet_patches(pair[0], 'v_start', pair[1], 'v_start', radii, tolerance=1e-4)
            require_closed_up(made)
            assert made.error <= 1e-4


def test_walls_on_wild_edges_are_closed_up(inputs):
    """Nothing but the outer sides is open; what is refused is named."""
    made_count = 0
    for seed in range(inputs(60)):
        rng = np.random.default_rng([seed, 91])
        degree = int(rng.integers(1, 6))
        count = degree + 1 + int(rng.integers(0, 5))
        knots = np.r_[np.zeros(degree + 1), np.sort(rng.uniform(0.1, 0.9, count - degree - 1)), np.ones(degree + 1)]
        points = np.c_[np.linspace(0, 10, count), rng.normal(0, 0.7, count), np.zeros(count)]
        edge = sc.NurbsCurve(degree, knots, points, 10**rng.uniform(-0.3, 0.3, count) if rng.random() < 0.4 else None)
        wall, floor = build.extrude(edge, (rng.uniform(-0.5, 0.5), 0, 4)), build.extrude(edge, (rng.uniform(-1, 1), -8, 0))
        try:
            made = build.fillet_patches(wall, 'v_start', floor, 'v_start', 0.3, tolerance=1e-3)
        except sc.InvalidShape as refused:
            assert any(word in str(refused) for word in ("crease", "ball")), (seed, refused)
            continue
        made_count += 1
        counts = require_closed_up(made).edge_counts()
        assert counts['shared'] == 2 and counts['free'] == 8, seed
    assert made_count > 0.5 * inputs(60)


def test_radii_that_change_abruptly_beside_sides_that_slant(inputs):
    """They are had, and touch both sides, or the place and the reason are named."""
    made_count = 0
    for seed in range(inputs(200)):
        rng = np.random.default_rng([seed, 92])
        ground, wall = (build.plane((0, 0, 0), (3, 0, 0), (rng.uniform(-2, 2), *way)) for way in ((2, 0), (0, 2)))
        at, width = rng.uniform(0.2, 0.8), 10**rng.uniform(-2.3, -1)
        radii = [(0, 0.2), (at - width / 2, 0.2), (at + width / 2, 0.2 + rng.uniform(0.3, 0.95) * 1.2 * width), (1, 0.2)]
        try:
            made = build.fillet_patches(ground, 'v_start', wall, 'v_start', radii[:int(rng.integers(3, 5))], tolerance=1e-4)
        except sc.ToleranceNotReached as refused:
            assert re.search(r"the fillet, (which bends|whose radius changes) abruptly at 0\.\d+ of the edge.*slants", str(refused)), refused
            continue
        made_count += 1
        require_closed_up(made)
        assert made.error <= 1e-4
        for border, patch in (('v_start', made.first), ('v_end', made.second)):
            assert sc.seam_continuity(made.fillet, border, patch, 'v_start').gap <= 1e-12
        edge = made.fillet.boundary('v_start').points
        assert np.abs(edge[:, 2]).max() <= 1e-12    # on the ground
    assert made_count > 0.5 * inputs(200)
