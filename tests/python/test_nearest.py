"""The nearest point: the global minimum, judged by brute force, closed forms and many kinds of shapes."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.spatial import cKDTree

import splinecore as sc
from random_curves import random_curve, random_knots
from random_patches import random_patch
from splinecore import build, conics


def queries(rng, points, count):
    """In the box of points, blown up."""
    low, high = points.min(0), points.max(0)
    return rng.uniform(low - 0.3 * (high - low) - 0.1, high + 0.3 * (high - low) + 0.1, (count, 3))


def breaks(knots, domain):
    return np.unique(np.r_[domain, knots[(knots > domain[0]) & (knots < domain[1])]])


def samples(knots, domain, each):
    """Parameters of every span, its ends among them."""
    ends = breaks(knots, domain)
    return np.unique(np.concatenate([np.linspace(a, b, each) for a, b in zip(ends[:-1], ends[1:])]))


def lengths(vectors):
    return np.linalg.norm(vectors, axis=-1)


def least_of_curve(curve, places, each=200, rounds=60):
    """Upper bounds of the distances, by dense samples and golden sections about the best of them."""
    u = samples(curve.knots, curve.domain, each)
    both = [curve.evaluate(u, side=side, at_infinity="nan") for side in ("left", "right")]
    points, at = np.concatenate(both), np.r_[u, u]
    finite = np.isfinite(points).all(1)
    distance, index = cKDTree(points[finite]).query(places)
    best = np.searchsorted(u, at[finite][index])
    low, high = u[np.maximum(best - 1, 0)], u[np.minimum(best + 1, len(u) - 1)]
    for _ in range(rounds):
        inner = low + 0.382 * (high - low), high - 0.382 * (high - low)
        left, right = (lengths(curve.evaluate(t, at_infinity="nan") - places) for t in inner)
        distance = np.fmin(distance, np.fmin(left, right))
        low, high = np.where(left < right, low, inner[0]), np.where(left < right, inner[1], high)
    return distance


def least_of_patch(patch, places, each=25, rounds=12):
    """The same on a patch, by finer and finer grids about the best sample."""
    domains = patch.domain
    u, v = (samples(knots, domain, each) for knots, domain in zip(patch.knots, domains))
    points = patch.evaluate_grid(u, v, at_infinity="nan").reshape(-1, 3)
    finite = np.flatnonzero(np.isfinite(points).all(1))
    distance, index = cKDTree(points[finite]).query(places)
    place = np.stack(np.unravel_index(finite[index], (len(u), len(v))))
    middle = np.stack([u[place[0]], v[place[1]]])
    reach = np.array([np.diff(u).max(), np.diff(v).max()])
    steps = np.linspace(-1, 1, 9)
    for _ in range(rounds):
        at = [np.clip(middle[a][:, None, None] + reach[a] * (steps[:, None] if a == 0 else steps), *domains[a])
              for a in range(2)]
        at = np.broadcast_arrays(*at)
        found = lengths(patch.evaluate(*at, at_infinity="nan") - places[:, None, None]).reshape(len(places), -1)
        found[np.isnan(found)] = np.inf
        best = found.argmin(1)
        distance = np.minimum(distance, found.min(1))
        middle = np.stack([np.take_along_axis(one.reshape(len(places), -1), best[:, None], 1)[:, 0] for one in at])
        reach = reach * 0.3
    return distance


def check_curve(curve, places, tolerance=1e-12, brute=True):
    found = curve.nearest(places)
    size = np.abs(curve.points).max() + np.abs(places).max()
    assert ((found.parameters >= curve.domain[0]) & (found.parameters <= curve.domain[1])).all()
    assert np.abs(lengths(found.points - places) - found.distances).max() <= tolerance * size
    sides = [lengths(curve.evaluate(found.parameters, side=side) - found.points) for side in ("left", "right")]
    assert np.minimum(*sides).max() <= 1e3 * tolerance * size
    if brute:
        assert (found.distances <= least_of_curve(curve, places) + tolerance * size).all()
    return found


def check_patch(patch, places, tolerance=1e-12):
    found = patch.nearest(places)
    size = np.abs(patch.points).max() + np.abs(places).max()
    assert np.abs(lengths(found.points - places) - found.distances).max() <= tolerance * size
    u, v = np.moveaxis(found.parameters, -1, 0)
    sides = [lengths(patch.evaluate(u, v, side=(a, b)) - found.points) for a in ("left", "right")
             for b in ("left", "right")]
    assert np.min(sides, axis=0).max() <= 1e3 * tolerance * size
    assert (found.distances <= least_of_patch(patch, places) + tolerance * size).all()
    return found


@pytest.mark.parametrize("degree", range(1, 10))
def test_of_curves_none_is_wrong(degree):
    rng = np.random.default_rng(degree)
    for _ in range(10):
        curve = random_curve(rng, degree=degree)
        check_curve(curve, queries(rng, curve.points, 120))


@pytest.mark.parametrize("degree", range(1, 7))
def test_of_patches_none_is_wrong(degree):
    """Ten thousand queries in all."""
    rng = np.random.default_rng(100 + degree)
    for _ in range(14):
        patch = random_patch(rng, degree=degree, spans=2)
        check_patch(patch, queries(rng, patch.points.reshape(-1, 3), 120))


def test_ten_thousand_queries_of_one_curve():
    rng = np.random.default_rng(1)
    knots = random_knots(rng, 3, 60, "clamped")
    t = np.linspace(0, 1, len(knots) - 4)
    points = np.stack([np.cos(12 * t), np.sin(12 * t), 2 * t], 1) + rng.uniform(-0.05, 0.05, (len(t), 3))
    curve = sc.NurbsCurve(3, knots, points, rng.uniform(0.5, 2, len(t)))
    check_curve(curve, queries(rng, points, 10_000))


def test_ten_thousand_queries_of_a_sheet_many_of_them_with_their_foot_on_the_border():
    rng = np.random.default_rng(2)
    grid = np.stack(np.meshgrid(np.arange(10.0), np.arange(10.0), [0], indexing="ij"), -1)[:, :, 0]
    grid[..., 2] = 2 * np.sin(grid[..., 0]) * np.cos(grid[..., 1])
    knots = np.r_[[0] * 4, np.arange(1, 7), [7] * 4]
    patch = sc.NurbsPatch((3, 3), (knots, knots), grid, rng.uniform(0.5, 2, (10, 10)))
    found = check_patch(patch, queries(rng, grid.reshape(-1, 3), 10_000))
    on_border = ((found.parameters == 0) | (found.parameters == 7)).any(1)
    assert 1000 < on_border.sum() < 9000


def count_of_several(shape, places, least):
    """From how many places a shape that is its own image is nearest on both sides of x = 0."""
    size, several = np.abs(shape.points).max(), 0
    for place, distance in zip(places, least):
        found = shape.nearest_all(place)
        assert (found.distances <= distance + 1e-12 * size).all()
        assert np.abs(lengths(found.points - place) - found.distances).max() <= 1e-12 * size
        several += (found.points[:, 0] > 1e-3).any() and (found.points[:, 0] < -1e-3).any()
    return several


@pytest.mark.parametrize("degree", [2, 3, 5])
def test_ten_thousand_queries_of_curves_that_are_nearest_at_several_places(degree):
    """Curves that are their own image: from the plane in the middle both sides are as near."""
    rng, several = np.random.default_rng(20 + degree), 0
    for _ in range(5):
        half = rng.uniform((0.5, -4, -4), (6, 4, 4), (5, 3))
        points = np.concatenate([half, half[::-1] * (-1, 1, 1)])
        knots = np.r_[[0] * degree, np.arange(len(points) - degree + 1), [len(points) - degree] * degree]
        curve = sc.NurbsCurve(degree, knots, points)
        places = rng.uniform((0, -5, -5), (0, 5, 5), (700, 3))
        several += count_of_several(curve, places, least_of_curve(curve, places))
    assert several > 1500


def test_ten_thousand_queries_of_patches_that_are_nearest_at_several_places():
    rng, several = np.random.default_rng(24), 0
    knots = np.array([0, 0, 0, 0, 1, 2, 3, 3, 3, 3.0])
    for _ in range(20):
        half = np.stack(np.meshgrid(np.linspace(0.5, 3, 3), np.linspace(-3, 3, 6), [0.0], indexing="ij"), -1)[:, :, 0]
        half[..., 2] = rng.uniform(-2, 2, (3, 6)) + half[..., 0] ** 2
        net = np.concatenate([half[::-1] * (-1, 1, 1), half])
        patch = sc.NurbsPatch((3, 3), (knots, knots), net)
        places = rng.uniform((0, -4, 3), (0, 4, 9), (500, 3))
        several += count_of_several(patch, places, least_of_patch(patch, places))
    assert several > 5000


def test_weights_of_both_signs_leave_the_finite_part():
    rng = np.random.default_rng(3)
    for index in range(20):
        curve = random_curve(rng, positive=False, degree=1 + index % 5, spans=3)
        places = queries(rng, curve.points, 20)
        found = curve.nearest(places)
        assert (found.distances <= least_of_curve(curve, places) * (1 + 1e-9) + 1e-9).all()
        assert np.abs(lengths(found.points - places) - found.distances).max() < 1e-9


def test_weights_that_are_wild_or_all_negative():
    rng = np.random.default_rng(4)
    for degree in (2, 3, 5):
        points = rng.uniform(-1, 1, (degree + 1, 3))
        weights = 10 ** rng.uniform(-3, 3, degree + 1)
        places = queries(rng, points, 50)
        plain = check_curve(sc.BezierCurve(points, weights).to_nurbs(), places)
        turned = check_curve(sc.BezierCurve(points, -weights).to_nurbs(), places)
        assert np.array_equal(plain.distances, turned.distances)


@pytest.mark.parametrize("size", [1e-150, 1e-6, 1e6, 1e150])
def test_of_any_size(size):
    rng = np.random.default_rng(5)
    points, places = rng.uniform(-1, 1, (7, 3)), rng.uniform(-2, 2, (40, 3))
    knots = [0, 0, 0, 0, 1, 2, 2.5, 3, 3, 3, 3]
    plain, scaled = (sc.NurbsCurve(3, knots, factor * points).nearest(factor * places) for factor in (1, size))
    assert scaled.distances == pytest.approx(size * plain.distances, rel=1e-12)
    net = rng.uniform(-1, 1, (3, 4, 3))
    plain, scaled = (sc.BezierPatch(factor * net).nearest(factor * places) for factor in (1, size))
    assert scaled.distances == pytest.approx(size * plain.distances, rel=1e-12)


def test_far_from_the_origin():
    rng = np.random.default_rng(6)
    points, places = rng.integers(-64, 64, (8, 3)) / 64, rng.integers(-128, 128, (50, 3)) / 64
    knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5]
    here, there = (sc.NurbsCurve(3, knots, points + far).nearest(places + far) for far in (0, 2.0**27))
    assert there.distances == pytest.approx(here.distances, rel=1e-12)
    assert there.parameters == pytest.approx(here.parameters, abs=1e-7)


@pytest.mark.parametrize("far", [1e3, 1e6, 1e12, 1e100, 1e300])
def test_points_far_away(far):
    rng = np.random.default_rng(7)
    circle = conics.circle((0, 0, 0), 2.0).to_nurbs()
    directions = rng.normal(size=(20, 3)) * (1, 1, 0)
    directions /= lengths(directions)[:, None]
    found = circle.nearest(far * directions)
    assert found.distances == pytest.approx(far - 2, rel=4e-16 * 40)
    assert np.abs(found.points - 2 * directions).max() < 1e-2


def test_circle_line_and_ellipse_in_closed_form():
    rng = np.random.default_rng(8)
    places = rng.uniform(-4, 4, (300, 3))
    for form in ("square", "triangle", "halves"):
        found = conics.circle((0, 0, 0), 2.0, form=form).nearest(places)
        rho = np.hypot(places[:, 0], places[:, 1])
        assert found.distances == pytest.approx(np.hypot(rho - 2, places[:, 2]), rel=1e-13)
    line = sc.BezierCurve([(0, 0, 0), (3, 0, 0)])
    found = line.nearest(places)
    assert found.parameters == pytest.approx(np.clip(places[:, 0] / 3, 0, 1), abs=1e-14)
    flat = places * (1, 1, 0)
    found = conics.ellipse((0, 0, 0), (3, 0, 0), (0, 1, 0)).nearest(flat)
    for place, distance in zip(flat, found.distances):
        x, y = np.abs(place[:2])
        # (a x / (t + a²))² + (b y / (t + b²))² = 1 has one root above -b² (Eberly), which s = t + b² tells from it.
        s = brentq(lambda s: (3 * x / (s + 8)) ** 2 + (y / s) ** 2 - 1, y, np.hypot(3 * x, y), xtol=1e-300, rtol=1e-15)
        assert distance == pytest.approx(np.hypot(x - 9 * x / (s + 8), y - y / s), rel=1e-13, abs=1e-14)


def test_plane_sphere_and_torus_in_closed_form():
    rng = np.random.default_rng(9)
    places = rng.uniform(-4, 4, (200, 3))
    found = build.sphere((0, 0, 0), 2.0).nearest(places)
    assert found.distances == pytest.approx(np.abs(lengths(places) - 2), rel=1e-13, abs=1e-14)
    found = build.torus((0, 0, 0), (0, 0, 1), 2.0, 0.5).nearest(places)
    ring = np.hypot(np.hypot(places[:, 0], places[:, 1]) - 2, places[:, 2])
    assert found.distances == pytest.approx(np.abs(ring - 0.5), rel=1e-13, abs=1e-14)
    found = build.plane((0, 0, 0), (1, 0, 0), (0, 2, 0)).nearest(places)
    foot = np.clip(places, (0, 0, 0), (1, 2, 0))
    assert found.distances == pytest.approx(lengths(places - foot), rel=1e-13)
    assert found.points == pytest.approx(foot, abs=1e-14)


def test_of_equal_places_the_first():
    circle = conics.circle((1, 2, 3), 2.0).to_nurbs()
    found = circle.nearest((1, 2, 3))
    assert found.distances == pytest.approx(2, rel=1e-14)
    assert found.parameters == circle.domain[0]
    sphere = build.sphere((0, 0, 0), 1.0)
    assert sphere.nearest((0, 0, 0)).parameters.tolist() == [domain[0] for domain in sphere.domain]
    cylinder = build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0)
    found = cylinder.nearest((0, 0, 0.5))
    assert found.distances == pytest.approx(1, rel=1e-14)
    assert min(abs(found.parameters - [domain[0] for domain in cylinder.domain])) < 1e-5
    arch = sc.BezierCurve([(-1, 0), (-1, 2), (1, 2), (1, 0)])
    assert arch.nearest((0, -5)).parameters == 0
    assert arch.nearest([(0, -5), (1e-6, -5)]).parameters.tolist() == [0, 1]


def test_a_whole_curve_of_nearest_places_ends():
    """Patches whose points lie on one line: it takes no end of halving to tell apart where they are as near."""
    rng = np.random.default_rng(7)
    direction = rng.normal(size=3)
    for weights in (None, 10.0 ** rng.uniform(-1, 1, (5, 5))):
        patch = sc.NurbsPatch((2, 2), ([0, 0, 0, 1, 2, 3, 3, 3],) * 2, rng.normal(size=(5, 5, 1)) * direction, weights)
        places = np.r_[queries(rng, patch.points.reshape(-1, 3), 6), 0.3 * direction[None]]
        found = patch.nearest(places)
        least = least_of_patch(patch, places)
        size = np.abs(patch.points).max() + found.distances
        assert (found.distances <= least + 1e-7 * size).all() and (found.distances >= least - 1e-6).all()
        on_patch = patch.evaluate(found.parameters[:, 0], found.parameters[:, 1])
        assert np.allclose(on_patch, found.points, atol=1e-9)


def test_what_no_search_tells_is_refused():
    """Points of a patch through infinity, 1e8 times its size away, lie along a curve: near it, it comes as near."""
    rng = np.random.default_rng(3)
    weights = rng.choice([-1, 1], (5, 6)) * 10.0 ** rng.uniform(-1, 1, (5, 6))
    patch = sc.NurbsPatch((3, 4), ([0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]),
                          rng.normal(size=(5, 6, 3)) + 1e8, weights)
    for place in rng.normal(size=(1, 3)):
        try:
            assert np.isfinite(patch.nearest(place).distances)
        except sc.InvalidShape as error:
            assert "cannot be told" in str(error)


def test_a_periodic_shape_has_one_seam():
    circle = sc.NurbsCurve(2, np.arange(7), [(np.cos(a), np.sin(a)) for a in np.arange(6) * np.pi / 3], periodic=True)
    seam = circle.evaluate(0.0)
    assert circle.nearest(2 * seam).parameters == 0
    assert circle.nearest(seam).distances < 1e-15


def test_points_of_the_shape_itself():
    rng = np.random.default_rng(10)
    for _ in range(10):
        curve = random_curve(rng)
        u = rng.uniform(*curve.domain, 50)
        size = np.abs(curve.points).max()
        assert curve.nearest(curve.evaluate(u)).distances.max() < 1e-13 * size
        patch = random_patch(rng, spans=2, degree=3)
        u, v = (rng.uniform(*domain, 20) for domain in patch.domain)
        assert patch.nearest(patch.evaluate(u, v)).distances.max() < 1e-13 * np.abs(patch.points).max()


def test_cusps_corners_and_shapes_that_are_a_point():
    cusp = sc.BezierCurve([(0, 0), (2, 2), (-1, 2), (1, 0)])
    rng = np.random.default_rng(11)
    check_curve(cusp.to_nurbs(), np.c_[rng.uniform(-1, 2, (500, 2)), np.zeros(500)])
    corner = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0), (1, 1), (2, 0)])
    found = corner.nearest([(1, 2), (1, 7.5), (1.1, 5)])
    assert found.parameters.tolist() == [1, 1, 1] and found.distances[:2].tolist() == [1, 6.5]
    point = sc.BezierCurve([(1, 2, 3)] * 4)
    found = point.nearest([(1, 2, 3), (1, 2, 5)])
    assert found.distances.tolist() == [0, 2] and found.parameters.tolist() == [0, 0]
    flat = sc.BezierPatch([[(1, 2, 3)] * 3] * 3)
    assert flat.nearest((1, 2, 5)).distances == 2
    cone = sc.BezierPatch([[(0, 0, 1)] * 3, [(1, 0, 0), (1, 1, 0), (0, 1, 0)]])
    check_patch(cone.to_nurbs(), rng.uniform(-2, 2, (300, 3)))
    assert cone.nearest((0, 0, 3)).parameters.tolist() == [0, 0]


def test_at_a_gap_the_nearer_side():
    curve = sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], [(0, 0), (1, 0), (3, 0), (4, 0)])
    found = curve.nearest([(1.2, 0), (2.9, 0)])
    assert found.parameters.tolist() == [1, 1] and found.points[:, 0].tolist() == [1, 3]


def test_hermite_and_power_curves_and_hermite_patches():
    place = (0.3, 0.8, 0.5)
    hermite = sc.HermiteCurve([(0, 0), (1, 1), (2, 0)], [(1, 0), (1, 1), (0, -1)])
    assert hermite.nearest(place).distances == hermite.to_nurbs().nearest(place).distances
    power = sc.PowerCurve([(0, 0, 0), (1, 0, 0), (0, 2, 0)])
    assert power.nearest(place).distances == power.to_nurbs().nearest(place).distances
    net = np.random.default_rng(12).uniform(size=(2, 2, 3))
    patch = sc.HermitePatch(net, net, net)
    assert patch.nearest(place).distances == patch.to_nurbs().nearest(place).distances


def test_the_same_bits_in_any_batch_and_on_any_number_of_threads():
    rng = np.random.default_rng(13)
    for shape in (random_curve(rng, degree=3, spans=8), random_patch(rng, degree=3)):
        places = rng.uniform(-12, 12, (4, 60, 3))
        whole = shape.nearest(places, threads=1)
        shared = shape.nearest(places, threads=3)
        assert whole.distances.shape == (4, 60) and whole.points.shape == (4, 60, 3)
        assert repr(whole) == "Nearest(shape=(4, 60))"
        for name in ("parameters", "points", "distances"):
            assert np.array_equal(getattr(whole, name), getattr(shared, name))
            assert np.array_equal(getattr(whole, name)[2, 7], getattr(shape.nearest(places[2, 7]), name))
        assert shape.nearest(places[..., :2]).distances.shape == (4, 60)
        assert shape.nearest(np.empty((0, 3))).distances.shape == (0,)


def test_bad_points_are_named():
    for shape in (sc.BezierCurve([(0, 0), (1, 1)]), sc.BezierPatch(np.random.default_rng(14).uniform(size=(2, 2, 3)))):
        with pytest.raises(sc.InvalidShape, match=r"points\[1, 2\] = nan is not finite"):
            shape.nearest([(0, 0, 0), (0, 0, np.nan)])
        with pytest.raises(sc.InvalidShape, match=r"points\[0\] = inf"):
            shape.nearest((np.inf, 0))
        for wrong in (3.0, [1.0], np.zeros((2, 4))):
            with pytest.raises(sc.InvalidShape, match="points has shape"):
                shape.nearest(wrong)
        with pytest.raises(TypeError):
            shape.nearest("here")
        with pytest.raises(sc.InvalidShape, match="threads"):
            shape.nearest((0, 0), threads=-1)
        with pytest.raises(TypeError, match="cancel"):
            shape.nearest((0, 0), cancel=3)
    with pytest.raises(sc.InvalidShape, match="too large for a number"):
        sc.BezierCurve([(-1e308, 0), (-1.7e308, 1)]).nearest((1.7e308, 0))


def test_a_long_call_is_cancelled():
    rng = np.random.default_rng(15)
    with pytest.raises(sc.Cancelled):
        random_patch(rng, degree=3).nearest(rng.uniform(-10, 10, (100_000, 3)), cancel=lambda: True)


def test_a_call_within_the_making_of_the_tree_ends():
    """cancel is asked while the tree is made that the call within asks for."""
    count = 60
    u, v = np.meshgrid(np.linspace(0, 9, count), np.linspace(0, 9, count), indexing='ij')
    knots = np.concatenate([[0] * 9, np.linspace(0, 1, count - 8), [1] * 9])
    patch = sc.NurbsPatch((9, 9), (knots, knots), np.stack([u, v, np.sin(3 * u) * np.cos(2 * v)], -1))
    inner = []

    def cancel():
        if not inner:
            inner.append(patch.nearest([1, 2, 3]).distances)
        return False

    outer = patch.nearest([1, 2, 3], cancel=cancel).distances
    assert inner and inner[0] == outer
