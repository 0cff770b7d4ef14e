"""Flux of fields and centroids of surfaces: Gauss's theorem, closed forms, an independent dense rule."""

import math

import numpy as np
import pytest

import dense_rules
import splinecore as sc
from splinecore import build
from test_fair_patch import patch_of, PERIODIC, PLAIN
from test_moments import closed_forms, disc, is_near, solid, wavy_box

PI = math.pi
UP = (0, 0, 1)
ORIGIN = (0, 0, 0)


def outwards(points):
    return points / 3


def squares(points):
    return points**2


def waves(points):
    x, y, z = points.T
    return np.stack([np.sin(y) + z, x * y * z, np.exp(-x * x) + y], -1)


def from_a_charge(points):
    return points / np.linalg.norm(points, axis=-1, keepdims=True) ** 3


def constant(*vector):
    return lambda points: np.broadcast_to(np.array(vector, float), points.shape)


@pytest.mark.parametrize("body, volume, middle, moments", closed_forms())
def test_the_flux_out_of_a_body_is_the_integral_of_the_divergence(body, volume, middle, moments):
    size = np.abs(body.points).max()
    assert is_near(body.flux(outwards), volume)
    assert is_near(body.flux(squares), 2 * volume * np.sum(middle), size=volume * size)
    assert abs(body.flux(constant(1, -2, 3))) < 1e-12 * body.area() * 4
    assert abs(body.flux(lambda p: np.cross(p - middle, (1, 2, 3)))) < 1e-12 * body.area() * 4 * size
    # x³ / 3 has the divergence x², whose integral is a second moment.
    for axis in range(3):
        def cubic(points):
            out = np.zeros_like(points)
            out[:, axis] = points[:, axis] ** 3 / 3
            return out
        whole = np.asarray(moments)[axis, axis] + volume * middle[axis] ** 2
        assert is_near(body.flux(cubic), whole, size=volume * size**2)
    assert body.flipped().flux(outwards) == pytest.approx(-volume, rel=1e-12)


def test_a_charge_inside_is_seen_and_one_outside_is_not():
    for body, expected in ((solid(build.sphere((0.3, -0.2, 0.1), 1.0)), 4 * PI),
                           (solid(build.sphere((3, 0, 0), 1.0)), 0.0), (solid(build.torus(ORIGIN, UP, 3, 1)), 0.0)):
        assert abs(body.flux(from_a_charge) - expected) < 1e-11


def test_open_surfaces_have_a_flux_to_the_side_of_their_normals():
    sheet = disc(2.0, 5.0)
    along_u, along_v = sheet.derivatives(0.3, 0.4, 1)[[1, 0], [0, 1]]
    normal = np.cross(along_u, along_v)
    normal /= np.linalg.norm(normal)
    assert is_near(sheet.flux(constant(7, 8, 0.5)), 2 * PI * normal[2])
    assert is_near(sheet.reversed("u").flux(constant(7, 8, 0.5)), -2 * PI * normal[2])
    half = build.sphere(ORIGIN, 3.0)
    assert is_near(solid(half).flux(constant(0, 0, 1)), 0.0, size=1.0)
    twisted = sc.BezierPatch(np.array([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]], float))    # z = x y
    assert is_near(twisted.flux(lambda p: p), -1 / 4)    # z - x y - y x
    both = sc.PatchSet.from_patches([twisted, sheet.to_nurbs()])
    assert is_near(both.flux(lambda p: p), twisted.flux(lambda p: p) + sheet.flux(lambda p: p))


def dense(patch):
    parts = dense_rules.even_parts(4)
    return patch.degree, patch.knots, patch.points, patch.weights, patch.periodic, parts


KINDS = [dict(), dict(rational=True), dict(kinds=(PERIODIC, PLAIN), rational=True), dict(kinds=(PERIODIC, PERIODIC)),
         dict(kinds=('unclamped', 'multiple'), rational=True)]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("degrees", [(1, 1), (2, 3), (4, 1), (5, 6), (9, 7)])
def test_of_every_kind_as_by_a_dense_rule(kind, degrees):
    patch = patch_of(degrees, (degrees[0] + 4, degrees[1] + 3), **kind)
    expected, through = dense_rules.flux(waves, *dense(patch))
    assert abs(patch.flux(waves) - expected) < 2e-12 * through
    if kind.get('kinds') == (PERIODIC, PERIODIC):
        return    # they fold back on themselves, where areas are not smooth
    wanted = dense_rules.surface_centroid(*dense(patch))
    assert is_near(patch.surface_centroid(tolerance=1e-10), wanted, 1e-9)


@pytest.mark.parametrize("degree", range(1, 10))
def test_bent_boxes_of_every_degree(degree):
    body = wavy_box(degree, True)
    assert is_near(body.flux(outwards), body.volume())
    assert is_near(body.flux(squares), 2 * body.volume() * body.centroid().sum(), 4e-12, size=1.0)


def test_at_the_highest_degree():
    at = np.linspace(0, 1, 256)
    plane = np.stack(np.broadcast_arrays(at[:, None], np.linspace(0, 2, 4)[None], 1.0), -1)
    patch = sc.BezierPatch(plane)
    assert is_near(patch.flux(constant(5, 6, 7)), 14.0) and is_near(patch.surface_centroid(), (0.5, 1, 1))


@pytest.mark.parametrize("tolerance", [1e-2, 1e-5, 1e-8])
def test_tolerances_are_kept(tolerance):
    patch = patch_of((5, 4), (8, 8), rational=True)

    def narrow(points):
        return np.exp(-4 * points**2)
    expected, through = dense_rules.flux(narrow, *dense(patch))
    assert abs(patch.flux(narrow, tolerance=tolerance) - expected) <= tolerance * through
    wanted = dense_rules.surface_centroid(*dense(patch))
    assert np.linalg.norm(patch.surface_centroid(tolerance=tolerance) - wanted) <= tolerance * np.abs(patch.points).max()


@pytest.mark.parametrize("exponent", [-498, -180, -60, 60, 180, 498])
def test_flux_and_centroids_scale_exactly(exponent):
    for body, *_ in closed_forms():
        large = body.with_points(np.ldexp(body.points, exponent))
        field = np.array((3.0, 4.0, 5.0))

        def near(points):
            return field + waves(np.ldexp(points, -exponent))
        assert math.ldexp(large.flux(near), -2 * exponent) == body.flux(lambda p: field + waves(p))
        assert (np.ldexp(large.surface_centroid(), -exponent) == body.surface_centroid()).all()


@pytest.mark.parametrize("size", [1e-200, 1e-100, 1e100, 1e200])
def test_fields_of_every_size(size):
    ball = solid(build.sphere((1, 2, 3), 2.0))
    assert is_near(ball.flux(lambda p: size * p) / size, 32 * PI)


def test_far_from_the_origin():
    for body, volume, middle, _ in closed_forms():
        shift = np.array([2.0**20, -(2.0**21), 2.0**19])
        far = body.with_points(body.points + shift)
        assert is_near(far.flux(lambda p: (p - shift) / 3), volume, 1e-8)
        assert is_near(far.flux(outwards), volume, 1e-8)
        assert is_near(far.surface_centroid() - shift, body.surface_centroid(), 1e-8, 10.0)


def test_centroids_of_surfaces_have_their_closed_form():
    half = build.sphere((1, 2, 3), 2.0)
    for surface, middle in ((half, (1, 2, 3)), (build.torus((4, 5, 6), UP, 3, 1), (4, 5, 6)),
                            (build.cylinder(ORIGIN, UP, 2, 3), (0, 0, 1.5)),
                            (build.cone(ORIGIN, UP, 3, 4), (0, 0, 4 / 3)), (disc(2, 7), (0, 0, 7))):
        assert is_near(surface.surface_centroid(), middle, 1e-11, 5.0)
        assert is_near(solid(surface).surface_centroid(), middle, 1e-11, 5.0)
        assert is_near(solid(surface).flipped().surface_centroid(), middle, 1e-11, 5.0)
    # A hemisphere's lies in the middle of its height.
    upper, lower = half.split("v", np.mean(half.domain[1]))
    assert sorted(np.round(part.surface_centroid()[2] - 3, 9) for part in (upper, lower)) == [-1, 1]


def test_the_field_is_asked_on_the_surface_and_not_too_often():
    asked = []

    def noted(points):
        assert points.shape[1] == 3 and points.dtype == float
        asked.append(points)
        return points
    ball = build.sphere((1, 2, 3), 2.0)
    ball.flux(noted)
    at = np.concatenate(asked)
    assert np.abs(np.linalg.norm(at - (1, 2, 3), axis=1) - 2).max() < 1e-14 * 8
    assert len(asked) <= 3 and max(map(len, asked)) <= 64 * 441


def test_a_field_that_jumps_is_found_as_well_as_it_can_be_and_the_rest_is_said():
    def jumps(points):
        return np.where(points[:, :1] > 0.1234567, 1.0, 0.0) * np.array((0, 0, 1.0))
    square = sc.BezierPatch(np.array([[(-1, -1, 0), (-1, 1, 0)], [(1, -1, 0), (1, 1, 0)]], float))
    assert abs(square.flux(jumps, tolerance=1e-3) - 2 * (1 - 0.1234567)) <= 2e-3
    slanted = sc.BezierPatch(np.array([[(-1, -1, 0), (-1.5, 1, 0)], [(1, -1, 0), (1, 1.5, 0)]], float))
    with pytest.raises(sc.ToleranceNotReached, match="the flux cannot be found"):
        slanted.flux(jumps)


@pytest.mark.parametrize("field, error, message", [
    (lambda p: p[:, :2], sc.InvalidShape, r"shape \(441, 2\) at 441 points, \(441, 3\) is expected"),
    (lambda p: p[1:], sc.InvalidShape, r"shape \(440, 3\)"),
    (lambda p: 1.0, sc.InvalidShape, "values of field have shape"),
    (lambda p: p * np.nan, sc.InvalidShape, r"the field is \(nan, nan, nan\) at the point \(.*not finite there"),
    (lambda p: p + np.inf, sc.InvalidShape, "not finite there"),
    (lambda p: p + 1e300, sc.InvalidShape, "too large for its flux"),
    (lambda p: "much", TypeError, "the values of field"),
    (lambda p: p + 1j, TypeError, "the values of field"),
    (lambda p: 1 / 0, ZeroDivisionError, "division"),
    (3, TypeError, "field = 3 is not callable"),
])
def test_wrong_fields_are_refused_in_a_sentence(field, error, message):
    for surface in (sc.BezierPatch(np.random.default_rng(3).normal(size=(3, 3, 3))), disc(1.0)):
        with pytest.raises(error, match=message):
            (surface if "441" in message or "440" in message else solid(surface)).flux(field)
        if "441" in message or "440" in message:
            break


@pytest.mark.parametrize("measure", [lambda s, **how: s.flux(outwards, **how), lambda s, **how: s.surface_centroid(**how)])
def test_what_cannot_be_measured_is_refused(measure):
    ball = build.sphere(ORIGIN, 1.0)
    for tolerance in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(sc.InvalidShape, match="tolerance"):
            measure(ball, tolerance=tolerance)
    with pytest.raises(TypeError, match="tolerance"):
        measure(ball, tolerance="much")
    weights = np.ones((3, 3))
    weights[1, 1] = -1
    with pytest.raises(sc.PointAtInfinity):
        measure(sc.BezierPatch(np.random.default_rng(1).normal(size=(3, 3, 3)), weights * [[1, 1, 1], [1, 9, 1], [1, 1, 1]]))
    with pytest.raises(sc.Cancelled):
        measure(patch_of((9, 9), (60, 60)), cancel=lambda: True)


def test_a_line_has_no_centroid_as_a_surface_and_no_flux():
    line = sc.BezierPatch(np.array([[(0, 0, 0), (1, 1, 1)], [(0, 0, 0), (1, 1, 1)]], float))
    with pytest.raises(sc.InvalidShape, match="no area"):
        line.surface_centroid()
    assert line.flux(waves) == 0.0
