"""All places of patches where the distance from a point is stationary: Newton's method from many starts, dense grids,
and closed forms."""

import math

import numpy as np
import pytest
from scipy.optimize import minimize

import shapes
import splinecore as sc
from random_patches import breaks, random_patch

FLAT = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])


def lengths(vectors):
    return np.linalg.norm(vectors, axis=-1)


def slope_and_bend(patch, point, u, v):
    """First and second derivatives of half the squared distance."""
    at = patch.derivatives(u, v, 2)
    offset, su, sv = at[:, 0, 0] - point, at[:, 1, 0], at[:, 0, 1]

    def dot(a, b):
        return (a * b).sum(-1)

    twist = dot(su, sv) + dot(offset, at[:, 1, 1])
    bend = [[dot(su, su) + dot(offset, at[:, 2, 0]), twist], [twist, dot(sv, sv) + dot(offset, at[:, 0, 2])]]
    return np.stack([dot(offset, su), dot(offset, sv)], -1), np.moveaxis(np.array(bend), -1, 0)


def zeros_by_newton(patch, point, each=10, rounds=40):
    """Places inside pairs of spans where the slopes are zero, from a grid of starts in each."""
    found = []
    on_u, on_v = (breaks(patch, axis=axis) for axis in "uv")
    t = (np.arange(each) + 0.5) / each
    for low_u, high_u in zip(on_u[:-1], on_u[1:]):
        for low_v, high_v in zip(on_v[:-1], on_v[1:]):
            low, size = np.array([low_u, low_v]), np.array([high_u - low_u, high_v - low_v])
            at = low + size * np.stack(np.meshgrid(t, t), -1).reshape(-1, 2)
            for _ in range(rounds):
                slope, bend = slope_and_bend(patch, point, *at.T)
                bend[np.linalg.det(bend) == 0] = np.eye(2)
                step = np.clip(np.linalg.solve(bend, slope[..., None])[..., 0], -0.1 * size, 0.1 * size)
                at = np.clip(at - step, low, low + size)
            inside = ((at > low + 1e-6 * size) & (at < low + (1 - 1e-6) * size)).all(1)
            for place in at[inside & (np.abs(step) < 1e-11 * size).all(1)]:
                if not any(np.abs(place - other).max() < 1e-7 for other in found):
                    found.append(place)
    return np.array(found).reshape(-1, 2)


def check(patch, point):
    found = patch.stationary_points(point)
    size = np.abs(patch.points).max() + np.abs(point).max()
    assert (np.diff(found.parameters[:, 0]) >= 0).all()
    assert np.allclose(lengths(found.points - point), found.distances, rtol=1e-12, atol=1e-13 * size)
    u, v = found.parameters.T
    sides = [lengths(patch.evaluate(u, v, side=(a, b)) - found.points) for a in ("left", "right")
             for b in ("left", "right")]
    assert np.min(sides, axis=0).max(initial=0) <= 1e-9 * size
    return found


@pytest.mark.parametrize("degree", range(1, 10))
def test_no_normal_is_missing(degree):
    rng = np.random.default_rng(degree)
    for _ in range(3):
        patch = random_patch(rng, degree=degree, spans=2)
        point = rng.uniform(-8, 8, 3)
        found = check(patch, point)
        for place in zeros_by_newton(patch, point):
            which = np.abs(found.parameters - place).max(1).argmin()
            assert found.parameters[which] == pytest.approx(place, abs=1e-6)
            bend = np.linalg.eigvalsh(slope_and_bend(patch, point, *place[:, None])[1][0])
            if np.abs(bend).min() > 1e-3:
                assert found.kinds[which] == ("minimum" if bend[0] > 0 else "maximum" if bend[1] < 0 else "saddle")
        for place, kind in zip(found.parameters, found.kinds):
            inner = all(np.abs(breaks(patch, axis=axis) - x).min() > 1e-6 for axis, x in zip("uv", place))
            if inner:
                slope, _ = slope_and_bend(patch, point, *place[:, None])
                assert np.abs(slope).max() < 1e-6


def settled(patch, point, start, sign):
    """The value at the minimum, or for sign -1 the maximum, that a search goes to."""
    def inside(at):
        return np.array([low + (x - low) % (high - low) if periodic else min(max(x, low), high)
                         for x, (low, high), periodic in zip(at, patch.domain, patch.periodic)])

    def value(at):
        return sign * float(lengths(patch.evaluate(*inside(at)) - point))

    def searched(at, size):
        return minimize(value, at, method="Nelder-Mead", options={
            "xatol": 1e-10, "fatol": 1e-13, "maxiter": 2000,
            "initial_simplex": at + size * np.array([(0, 0), (1, 0), (0, 1)])})

    # A simplex that collapses on a border or a crease stops short of the end: a new one goes on.
    at, least = start, math.inf
    while True:
        best = min((searched(at, size) for size in (1e-3, -1e-3, 1e-2, -1e-2)), key=lambda end: end.fun)
        if not best.fun < least - 1e-9:
            return sign * min(least, best.fun)
        at, least = inside(best.x), best.fun


@pytest.mark.parametrize("seed", range(12))
def test_searches_from_everywhere_end_at_minima_and_maxima_that_were_found(seed):
    rng = np.random.default_rng(seed)
    patch = random_patch(rng, degree=1 + seed % 4, spans=1 + seed % 2, ends="clamped" if seed % 3 else "unclamped")
    point = rng.uniform(-8, 8, 3)
    found = check(patch, point)
    u, v = (np.linspace(*domain, 40) for domain in patch.domain)
    distance = lengths(patch.evaluate_grid(u, v) - point)
    for sign, kind in ((1, "minimum"), (-1, "maximum")):
        at = np.pad(sign * distance, 1, constant_values=np.inf)
        beside = np.min([at[1 + a:41 + a, 1 + b:41 + b] for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b], axis=0)
        known = found.distances[np.array(found.kinds) == kind]
        for i, j in np.argwhere(sign * distance < beside):
            end = settled(patch, point, np.array([u[i], v[j]]), sign)
            assert np.abs(known - end).min() < 1e-5


def test_a_plane_has_one_foot_and_its_corners():
    found = check(FLAT, (0.25, 0.5, 2))
    assert found.parameters.tolist() == [[0, 0], [0, 1], [0.25, 0.5], [1, 0], [1, 1]]
    assert found.kinds == ("maximum", "maximum", "minimum", "maximum", "maximum")
    found = check(FLAT, (2, 0.5, 2))
    assert found.parameters.tolist() == [[0, 0], [0, 1], [1, 0.5]]
    assert found.kinds == ("maximum", "maximum", "minimum")
    assert check(FLAT, (2, 3, 0)).kinds == ("maximum", "minimum")
    assert repr(found) == "StationaryPoints(count=3)"


def ellipsoid(a=1.0, b=1.0, c=1.0, center=(0, 0, 0), scale=1.0):
    """With its poles on z; not periodic, but closed."""
    profile = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1)]
    ball = shapes.revolved(profile, [1, shapes.HALF, 1, shapes.HALF, 1], [0, 0, 0, 1, 1, 2, 2, 2], 2)
    points = ball.points * np.array([a, b, c]) * scale + center
    return sc.NurbsPatch(ball.degree, ball.knots, points, ball.weights)


def test_from_near_the_center_an_ellipsoid_has_six_normals():
    found = check(ellipsoid(3, 2, 1), (-0.01, 0.02, -0.013))
    assert sorted(found.kinds) == ["maximum", "maximum", "minimum", "minimum", "saddle", "saddle"]
    normal = found.points / np.square([3, 2, 1])
    away = found.points - (-0.01, 0.02, -0.013)
    assert np.abs(np.cross(normal, away)).max() < 1e-12


def test_the_poles_of_an_ellipsoid_are_one_place_each():
    found = check(ellipsoid(3, 2, 1), (0, 0, 0))
    assert found.parameters == pytest.approx(np.array([[0, 0], [0, 1], [0, 2], [1, 1], [2, 1], [3, 1]]), abs=1e-14)
    assert found.kinds == ("minimum", "maximum", "minimum", "saddle", "maximum", "saddle")
    assert ellipsoid(3, 2, 1).nearest_all((0, 0, 0)).parameters.tolist() == [[0, 0], [0, 2]]
    assert check(ellipsoid(1, 3, 2), (0, 0, 0)).kinds == (
        "saddle", "minimum", "saddle", "maximum", "minimum", "maximum")


def test_the_normals_of_a_sphere():
    found = check(ellipsoid(), (-0.1, 0.2, 0.3))
    way = np.array([-0.1, 0.2, 0.3]) / math.sqrt(0.14)
    assert found.points == pytest.approx(np.array([way, -way]), abs=1e-14)
    assert found.kinds == ("minimum", "maximum")
    # On the axis each parallel is at one distance, and only the poles are stationary.
    for height, kinds in ((0.3, ("maximum", "minimum")), (-0.3, ("minimum", "maximum")), (3e9, ("maximum", "minimum"))):
        found = check(ellipsoid(), (0, 0, height))
        assert found.parameters.tolist() == [[0, 0], [0, 2]] and found.kinds == kinds


def test_the_normals_of_a_torus():
    point = np.array([2.5 * math.cos(2), 2.5 * math.sin(2), 0.2])
    found = check(shapes.torus(), point)
    way = np.array([math.cos(2), math.sin(2), 0])
    expected = []
    for side in (1, -1):
        offset = point - 3 * side * way
        expected += [3 * side * way + sign * offset / np.linalg.norm(offset) for sign in (1, -1)]
    assert sorted(found.points.tolist()) == pytest.approx(np.array(sorted(np.array(expected).tolist())), abs=1e-12)


@pytest.mark.parametrize("scale", [1e-150, 1e-20, 1e20, 1e150])
def test_size_does_not_matter(scale):
    plain = ellipsoid(3, 2, 1).stationary_points((0.1, 0.2, 0.3))
    found = ellipsoid(3, 2, 1, scale=scale).stationary_points(np.array([0.1, 0.2, 0.3]) * scale)
    assert found.parameters == pytest.approx(plain.parameters, abs=1e-13)
    assert found.distances == pytest.approx(plain.distances * scale, rel=1e-13)
    assert found.kinds == plain.kinds


def test_far_from_the_origin_and_from_far_away():
    plain = ellipsoid(3, 2, 1).stationary_points((0.25, 0.5, 0.125))
    found = ellipsoid(3, 2, 1, center=(1e8, -1e8, 1e7)).stationary_points((1e8 + 0.25, -1e8 + 0.5, 1e7 + 0.125))
    assert found.parameters == pytest.approx(plain.parameters, abs=1e-6)
    way = np.array([-0.48, 0.6, 0.64])
    for far in (1e12, 1e60, 1e200):
        found = ellipsoid(3, 2, 1).stationary_points(far * way)
        top = way * np.square([3, 2, 1]) / math.sqrt((np.square(way * (3, 2, 1))).sum())
        assert found.points == pytest.approx(np.array([top, -top]), abs=1e-10)
        assert found.distances == pytest.approx([far] * len(found.distances), rel=1e-11)


def test_edges_between_pieces_and_the_tip_of_a_cone_count():
    roof = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]),
                         [[(0, 0, 0), (0, 1, 0)], [(1, 0, 1), (1, 1, 1)], [(2, 0, 0), (2, 1, 0)]])
    found = check(roof, (1, 0.5, 3))
    which = found.kinds.index("minimum")
    assert found.parameters[which].tolist() == [1, 0.5] and found.kinds.count("minimum") == 1
    assert roof.nearest_all((1, 0.5, 0)).parameters == pytest.approx(np.array([[0.5, 0.5], [1.5, 0.5]]))
    cone = shapes.revolved([(1, 0), (0, 1)], [1, 1], [0, 0, 1, 1], 1)
    found = check(cone, (0.1, 0.05, 4))
    assert found.kinds.count("minimum") == 1 and found.distances.min() == pytest.approx(math.sqrt(9 + 0.0125))
    assert found.parameters[found.kinds.index("minimum")].tolist() == [0, 1]


def test_the_seam_of_a_periodic_patch_is_one_place():
    knots = [0, 1, 2, 3, 4]
    square = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    box = sc.NurbsPatch((1, 1), (knots, [0, 0, 1, 1]), [[(x, y, 0), (x, y, 1)] for x, y in square],
                        periodic=(True, False))
    found = check(box, (0, 0, 0.5))
    assert found.parameters[:, 0].max() < 4
    assert found.kinds.count("minimum") == 4 and found.kinds.count("maximum") == 8
    assert len(box.nearest_all((0, 0, 0.5)).distances) == 4
    assert len(box.nearest_all((0, 0.1, 0.5)).distances) == 1
    assert len(box.nearest_all((0, 0.1, 0.5), 0.1).distances) == 3


def test_where_a_focal_point_is_the_place_is_still_one():
    points = [[(x, y, (1 if x else -1) + (1 if y else -1)) for y in (-1, 0, 1)] for x in (-1, 0, 1)]
    bowl = sc.BezierPatch(points)  # z = x² + y²
    found = check(bowl, (0, 0, 0.5))
    assert found.parameters == pytest.approx(np.array([[0, 0], [0, 1], [0.5, 0.5], [1, 0], [1, 1]]), abs=1e-4)
    assert found.kinds[2] == "minimum"
    with pytest.raises(sc.InvalidShape, match="curve"):
        bowl.stationary_points((0, 0, 0.6))


def test_through_infinity_the_finite_places_count():
    rng = np.random.default_rng(8)
    for _ in range(10):
        patch = random_patch(rng, positive=False, degree=2, spans=2, ends="unclamped")
        found = patch.stationary_points(rng.uniform(-8, 8, 3))
        assert np.isfinite(found.points).all() and len(found.kinds) > 0


def test_weights_that_are_wild():
    rng = np.random.default_rng(6)
    for index in range(40):
        patch = random_patch(rng, degree=1 + index % 6, spans=2, ends="clamped")
        wild = sc.NurbsPatch(patch.degree, patch.knots, patch.points, 10 ** rng.uniform(-3, 3, patch.weights.shape))
        point = rng.uniform(-12, 12, 3)
        found, best = wild.stationary_points(point), wild.nearest(point)
        assert found.distances.min() == pytest.approx(best.distances, abs=1e-11)
        assert found.kinds[found.distances.argmin()] == "minimum"


def test_all_nearest_of_many_are_as_near_as_the_nearest():
    rng = np.random.default_rng(5)
    for index in range(30):
        patch = random_patch(rng, degree=1 + index % 5, spans=2)
        for point in rng.uniform(-12, 12, (2, 3)):
            best = patch.nearest(point)
            found = patch.nearest_all(point)
            assert np.abs(found.distances - best.distances).max() <= 1e-12
            assert np.abs(found.parameters - best.parameters).max(1).min() <= 1e-6
            wide = patch.nearest_all(point, 3.0)
            assert (wide.distances <= best.distances + 3).all()
            stationary = patch.stationary_points(point)
            count = sum(kind == "minimum" and distance <= best.distances + 3
                        for kind, distance in zip(stationary.kinds, stationary.distances))
            assert len(wide.distances) == count


@pytest.mark.parametrize("shape, point", [
    (ellipsoid(), (0, 0, 0)), (ellipsoid(center=(1e6, 2, 3)), (1e6, 2, 3)), (shapes.torus(), (0, 0, 0)),
    (shapes.torus(), (0, 0, 1)), (shapes.torus(), (3, 0, 0)), (shapes.cylinder(), (0, 0, 1)),
    (shapes.cylinder(), (0, 0, -1)), (shapes.sphere_octant(), (0, 0, 0.3)),
])
def test_curves_of_stationary_places_are_refused(shape, point):
    with pytest.raises(sc.InvalidShape, match="stationary on a curve of places or more, about u = "):
        shape.stationary_points(point)


@pytest.mark.parametrize("shape, point", [
    (ellipsoid(), (0, 0, 0)), (shapes.torus(), (0, 0, 0)), (shapes.torus(), (0, 0, 1)), (shapes.torus(), (3, 0, 0)),
    (shapes.cylinder(), (0, 0, 1)), (shapes.cylinder(), (0, 0, -1)),
])
def test_where_a_curve_is_nearest_all_nearest_are_refused(shape, point):
    with pytest.raises(sc.InvalidShape, match="stationary on a curve of places or more, about u = "):
        shape.nearest_all(point)


def test_a_curve_of_places_that_is_farther_than_the_nearest_does_no_harm():
    # An eighth of a ball, from above on its axis: the pole is nearest, the rim is at one distance.
    with pytest.raises(sc.InvalidShape, match="curve"):
        shapes.sphere_octant().stationary_points((0, 0, 3))
    assert shapes.sphere_octant().nearest_all((0, 0, 3)).distances == pytest.approx([2])


@pytest.mark.parametrize("call, error, text", [
    (lambda one: one.stationary_points((0, 0, math.nan)), sc.InvalidShape, "point"),
    (lambda one: one.stationary_points((0, 0, 0, 1)), sc.InvalidShape, "point"),
    (lambda one: one.stationary_points(None), TypeError, "point"),
    (lambda one: one.stationary_points((0, 0), cancel=3), TypeError, "cancel"),
    (lambda one: one.nearest_all((0, math.inf)), sc.InvalidShape, "point"),
    (lambda one: one.nearest_all((0, 0), -1), sc.InvalidShape, "tolerance"),
    (lambda one: one.nearest_all((0, 0), math.nan), sc.InvalidShape, "tolerance"),
])
def test_bad_input(call, error, text):
    with pytest.raises(error, match=text):
        call(FLAT)


def test_a_long_search_is_ended_by_its_caller():
    rng = np.random.default_rng(1)
    patch = sc.BezierPatch(rng.uniform(-1, 1, (40, 40, 3)))
    with pytest.raises(sc.Cancelled):
        patch.stationary_points((0, 0, 0), cancel=lambda: True)
