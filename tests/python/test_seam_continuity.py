"""How smoothly one patch goes on as another across a side of each (rows S16, S21)."""

import math

import numpy as np
import pytest

import splinecore as sc
from random_patches import random_patch
from seams import OPPOSITE, SIDES, curvature_across, jet, normals, pairs, rounding_of
from shapes import cylinder, hermite_net, sphere_octant, torus, wavy_patch

NAN = math.nan
IDENTITY = np.eye(3)


def measure(*arguments, **options):
    return sc.seam_continuity(*arguments, **options)


def square(origin=(0, 0, 0), a=(1, 0, 0), b=(0, 1, 0)):
    """A bilinear patch: u along a, v along b."""
    origin, a, b = (np.array(one, float) for one in (origin, a, b))
    return sc.BezierPatch([[origin, origin + b], [origin + a, origin + a + b]])


def turned(angle):
    """A square that leaves the first one's side x = 1 at an angle to its plane."""
    return square((1, 0, 0), (math.cos(angle), 0, math.sin(angle)))


def quarter(radius, height=1.0):
    """A quarter of a cylinder about the y axis that begins on the x axis' plane z = 0 with its tangent along x."""
    half = math.sqrt(0.5)
    arc = [(0, 0), (radius, 0), (radius, radius)]
    return sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]),
                         [[(x, 0, z), (x, height, z)] for x, z in arc], [[1, 1], [half, half], [1, 1]])


def test_a_value_that_only_measures_make():
    found = measure(square(), "u_end", square((1, 0, 0)), "u_start")
    assert isinstance(found, sc.SeamContinuity)
    assert repr(found) == "SeamContinuity(gap=0, angle=0, curvature_difference=0, c=2, g=2)"
    with pytest.raises(TypeError):
        sc.SeamContinuity()
    with pytest.raises(AttributeError):
        found.gap = 3


@pytest.mark.parametrize("angle", [1e-3, 0.3, math.pi / 2, 3.0, math.pi])
def test_squares_at_an_angle(angle):
    """pi / 2 is a corner of a box; at pi one is folded onto the other."""
    found = measure(square(), "u_end", turned(angle), "u_start")
    assert abs(found.angle - angle) <= 1e-15 and (found.c, found.g) == (0, 0)
    assert found.gap == 0 and found.curvature_difference == 0
    assert abs(found.first_difference - 2 * math.sin(angle / 2)) <= 1e-15 and found.second_difference == 0


@pytest.mark.parametrize("pace", [1, 100])
def test_the_largest_between_places_is_found(pace):
    """Beside 20,001 places; angles also with a pace that lets all that happens happen in a hundredth of the way."""
    rng = np.random.default_rng(3)
    for _ in range(30):
        nets = [np.moveaxis(np.mgrid[i:i + 4, :4, :1], 0, -1)[:, :, 0] + rng.uniform(-0.5, 0.5, (4, 4, 3)) for i in (0, 3)]
        pair = [sc.BezierPatch(net, rng.uniform(0.3, 3, (4, 4))) for net in nets]
        points = pair[1].points.copy()
        points[0] = pair[0].points[-1]
        pair[1] = sc.BezierPatch(points, np.r_[pair[0].weights[-1:], pair[1].weights[1:]])
        a, b = (patch.to_nurbs().moebius("v", pace) for patch in pair)
        found = measure(a, "u_end", b, "u_start")
        dense = sc.seam_continuity(a, "u_end", b, "u_start", parameters=np.linspace(0, 1, 20001), reversed=False)
        assert dense.angle * (1 - 1e-3) <= found.angle <= dense.angle * (1 + 1e-3) + 1e-9
        if pace == 1:
            assert dense.curvature_difference * (1 - 1e-2) <= found.curvature_difference


def test_two_sides_that_lie_apart():
    found = measure(square(), "u_end", square((1, 0, 2)), "u_start")
    assert found.gap == 2 and (found.c, found.g) == (-1, -1) and found.angle == 0
    sheared = measure(square(), "u_end", sc.BezierPatch([[(1, 0, 0), (1, 1, 3)], [(2, 0, 0), (2, 1, 3)]]), "u_start")
    assert sheared.gap == 3 and np.allclose(sheared.gaps, 3 * sheared.parameters, rtol=0, atol=1e-15)


@pytest.mark.parametrize("radius", [1e-3, 0.5, 1, 7, 1e4])
def test_a_cylinder_on_its_tangent_plane_differs_by_its_curvature(radius):
    ground = square((-1, 0, 0))
    found = measure(ground, "u_end", quarter(radius), "u_start")
    assert found.g == 1 and found.angle <= 1e-15 and found.gap == 0
    rounding = 1e-15 * max(10, 1 / radius)
    assert abs(found.curvature_difference * radius - 1) <= rounding
    assert np.abs(found.curvature_differences * radius - 1).max() <= rounding
    # On its other side the cylinder has a plane again, and another cylinder that goes on as one with it.
    wall = square((radius, 0, radius), (0, 0, 1))
    assert abs(measure(quarter(radius), "u_end", wall, "u_start").curvature_difference * radius - 1) <= rounding


def test_cylinders_of_two_radii():
    """Inside one another they differ by the difference, on both sides of their plane by the sum of curvatures."""
    inner, outer = quarter(1), quarter(4)
    over = quarter(4).transformed(np.diag([-1, 1, 1]))
    assert abs(measure(over, "u_start", inner, "u_start").curvature_difference - 0.75) <= 1e-14
    under = quarter(4).transformed(np.diag([-1, 1, -1]))
    assert abs(measure(under, "u_start", inner, "u_start").curvature_difference - 1.25) <= 1e-14
    folded = measure(outer, "u_start", inner, "u_start")
    assert folded.angle == math.pi and folded.g == 0


@pytest.mark.parametrize("axis", "uv")
def test_the_two_halves_of_a_sphere(axis):
    """Along a meridian, which ends in both poles, and along the equator: arcs whose homogeneous forms meet."""
    ball = sc.build.sphere((1, 2, 3), 2.0)
    at = float(np.mean(ball.domain["uv".index(axis)]))
    ball = ball if not ball.periodic["uv".index(axis)] else ball.clamped(axis)
    one, two = ball.split(axis, at)
    found = measure(one, axis + "_end", two, axis + "_start")
    assert found.g == 2 and found.c >= 1 and found.gap <= 1e-14
    assert found.angle <= 1e-7 and found.curvature_difference <= 1e-8
    assert np.isfinite(found.angles).all() and np.isfinite(found.curvature_differences).all()
    assert np.abs(np.linalg.norm(found.points - [1, 2, 3], axis=1) - 2).max() <= 1e-14


def test_two_octants_share_a_meridian_up_to_their_pole():
    """One comes from the other by a quarter turn; then the equator, with the octant below."""
    octant = sphere_octant()
    turn = octant.transformed([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    found = measure(octant, "u_end", turn, "u_start")
    assert found.g == 2 and found.c >= 1 and found.angle <= 1e-12 and found.curvature_difference <= 1e-10
    south = octant.transformed(np.diag([1, 1, -1]))
    found = measure(octant, "v_start", south, "v_start")
    assert found.g == 2 and found.angle <= 1e-14 and found.curvature_difference <= 1e-13 and not found.reversed


def test_a_hemisphere_on_its_cylinder_has_one_tangent_plane():
    ball = sc.build.sphere((0, 0, 0), 2)
    dome = ball.split("v", float(np.mean(ball.domain[1])))[1]
    below = sc.build.cylinder((0, 0, -3), (0, 0, 1), 2, 3)
    found = measure(below, "v_end", dome, "v_start")
    assert found.g == 1 and found.angle <= 1e-14 and abs(found.curvature_difference - 0.5) <= 1e-13


@pytest.mark.parametrize("axis", "uv")
def test_the_parts_of_a_split_patch_go_on(axis):
    rng = np.random.default_rng(90)
    for index in range(100):
        whole = random_patch(rng, degree=int(rng.integers(2, 7)), ends="clamped", spans=1)
        one, two = whole.split(axis, float(np.mean(whole.domain["uv".index(axis)])))
        found = measure(one, axis + "_end", two, axis + "_start")
        assert (found.c, found.g) == (2, 2), (index, found, found.first_difference, found.second_difference)


def test_the_numbers_are_those_of_the_derivatives():
    """At places that are no knots, computed from the derivatives alone."""
    rng = np.random.default_rng(91)
    for index, (first, side, second, other) in enumerate(pairs(92, 200, degrees=(2, 5))):
        t = np.sort(rng.uniform(0.01, 0.99, 20))
        found = measure(first, side, second, other, parameters=t)
        assert np.array_equal(found.parameters, t)
        a, b = jet(first, side, t, True), jet(second, other, t, False, found.reversed)
        gaps = np.linalg.norm(a[:, 0, 0] - b[:, 0, 0], axis=1)
        assert np.abs(found.points - a[:, 0, 0]).max() <= 1e-9 and np.abs(found.gaps - gaps).max() <= 1e-9
        angles = np.arccos(np.clip((normals(a) * normals(b)).sum(-1), -1, 1))
        assert np.abs(found.angles - angles).max() <= 1e-6, index

        def bends_of(one, two):
            jets = jet(one, side, t, True), jet(two, other, t, False, found.reversed)
            return np.abs(np.subtract(*map(curvature_across, jets)))

        bends = bends_of(first, second)
        rounding = rounding_of(bends_of, first, second, rng)
        far = np.abs(found.curvature_differences - bends)
        assert (far <= 1e-5 * bends + 1e-8 * bends.max() + 10 * rounding).all(), index
        assert found.gap == found.gaps.max() and found.angle == found.angles.max()
        slopes = np.linalg.norm(b[:, 1, 0] - a[:, 1, 0], axis=1).max() / max(
            np.linalg.norm(one[:, 1, 0], axis=1).max() for one in (a, b))
        assert math.isclose(found.first_difference, slopes, rel_tol=1e-8)


def test_the_directions_of_parameters_make_no_difference():
    for index, (first, side, second, other) in enumerate(pairs(93, 48, degrees=(2, 4))):
        found = measure(first, side, second, other)
        ways = [(first.swapped(), "vu"["uv".index(side[0])] + side[1:], second, other),
                (first, side, second.swapped(), "vu"["uv".index(other[0])] + other[1:]),
                (first.reversed(side[0]), OPPOSITE[side], second, other),
                (first, side, second.reversed(other[0]), OPPOSITE[other]),
                (first, side, second.reversed("vu"["uv".index(other[0])]), other), (second, other, first, side)]
        for way in ways:
            again = measure(*way)
            for name in ("gap", "angle", "curvature_difference", "first_difference", "second_difference"):
                one, two = getattr(found, name), getattr(again, name)
                assert math.isclose(one, two, rel_tol=1e-5, abs_tol=1e-8), (index, name, way)
            assert (again.c, again.g) == (found.c, found.g)


def test_the_seam_is_looked_at_from_the_side_of_the_first():
    """Colors are for its points, from its start to its end, on both sides of every knot."""
    rim, lid = cylinder(), sc.build.disc((0, 0, 2), (0, 0, 1), 1)
    found = measure(rim, "v_end", lid, "v_start")
    assert found.parameters[0] == 0 and found.parameters[-1] == 1 and (np.diff(found.parameters) >= 0).all()
    count = len(found.parameters)
    assert found.points.shape == (count, 3) and count >= 4 * 7
    for values in (found.gaps, found.angles, found.curvature_differences):
        assert values.shape == (count,) and values.dtype == np.float64 and not values.flags.writeable
    assert not found.points.flags.writeable and not found.parameters.flags.writeable
    for knot in (0.25, 0.5, 0.75):
        assert (found.parameters == knot).sum() == 2
    assert np.abs(found.angles - math.pi / 2).max() <= 1e-14 and found.c == 0 and found.gap <= 1e-15
    assert np.abs(found.points - rim.evaluate(4 * found.parameters, rim.domain[1][1])).max() <= 1e-15


def test_a_kink_along_the_seam_is_seen_from_both_sides():
    """Two roofs whose ridges meet: at the ridge the normals jump, but together."""
    points = np.array([[(0, -1, 0), (0, 0, 1), (0, 1, 0)], [(1, -1, 0), (1, 0, 1), (1, 1, 0)]], float)
    roof = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 0.3, 1, 1]), points)
    other = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [2, 2, 2 + 3 * 0.3, 5, 5]), points + [1, 0, 0])
    found = measure(roof, "u_end", other, "u_start")
    assert found.angle <= 1e-15 and found.g == 2
    assert measure(roof, "u_end", other.reversed("v"), "u_start").angle <= 1e-15


def test_one_place_that_differs_is_found():
    """A wave of a fifth of the side, in the row beside the edge."""
    flat = sc.NurbsPatch((3, 3), ([0] * 4 + [1] * 4, [0] * 4 + [0.2, 0.4, 0.6, 0.8] + [1] * 4),
                         np.stack(np.meshgrid(range(4), range(8), [0], indexing="ij"), -1)[:, :, 0].astype(float))
    points = flat.points + [3, 0, 0]
    assert measure(flat, "u_end", flat.with_points(points), "u_start").g == 2
    points[1, 3, 2] = 0.1
    found = measure(flat, "u_end", flat.with_points(points), "u_start")
    assert found.g == 0 and 0.05 <= found.angle <= 0.1 and found.angles[0] == 0 and found.angles[-1] == 0
    points[1, 3, 2] = 0
    points[2, 3, 2] = 0.1
    found = measure(flat, "u_end", flat.with_points(points), "u_start")
    assert found.g == 1 and found.curvature_difference > 0.01


def test_poles_at_the_seam():
    """Cones tip to tip share a point and no normal; a hemisphere's pole has one, and so has the disc's."""
    cone = sc.build.cone((0, 0, 0), (0, 0, 1), 1, 1)
    found = measure(cone, "v_end", cone, "v_end")
    assert found.c >= 0 and found.gap <= 1e-15
    assert np.isnan(found.curvature_differences).all() and found.curvature_difference == 0


def test_what_runs_to_infinity_is_left_out():
    sheet = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 1, 1], [0, 0, 1, 1]),
                          [[(1, 0, 0), (1, 1, 0)], [(0, 0, 1), (0, 1, 1)], [(-1, 0, 0), (-1, 1, 0)]],
                          [[1, 1], [-1, -1], [1, 1]])
    found = measure(sheet, "v_end", sheet.transformed(np.c_[IDENTITY, [0, 1, 0]]), "v_start",
                    parameters=np.linspace(0, 1, 5))
    assert np.isnan(found.gaps).tolist() == [False, False, True, False, False] and np.isnan(found.points[2]).all()
    assert found.g == 2 and found.gap == 0


@pytest.mark.parametrize("scale", [1e-250, 1e-100, 1e-3, 1e100, 1e250])
def test_measuring_does_not_depend_on_the_units(scale):
    for index, (first, side, second, other) in enumerate(pairs(94, 16)):
        small = measure(first, side, second, other)
        large = measure(first.with_points(first.points * scale), side, second.with_points(second.points * scale), other)
        assert np.isclose(large.gap / scale, small.gap, rtol=1e-9) and np.isclose(large.angle, small.angle, rtol=1e-6)
        assert np.isclose(large.curvature_difference * scale, small.curvature_difference, rtol=1e-5), index
        assert (large.c, large.g) == (small.c, small.g)


def test_the_caller_may_choose_the_direction_of_the_seam():
    first, second = square(), turned(0.3)
    assert measure(first, "u_end", second, "u_start", reversed=None).gap == 0
    along = measure(first, "u_end", second, "u_start", reversed=False)
    against = measure(first, "u_end", second, "u_start", reversed=True)
    assert (along.reversed, along.gap) == (False, 0) and (against.reversed, against.gap) == (True, 1)
    assert np.allclose(against.gaps, np.abs(1 - 2 * against.parameters), rtol=0, atol=1e-15)
    found = first.continuity_to("u_end", second.reversed("v"), "u_start", reversed=True)
    assert found.gap <= 1e-16 and found.c == 0
    assert first.continuity_to("u_end", second, "u_start", reversed=True).c == -1


def test_a_corner_is_one_for_derivatives_and_for_normals():
    for angle in (5e-5, 2e-8):
        found = measure(square(), "u_end", turned(angle), "u_start")
        assert (found.c, found.g) == (0, 0), angle
    assert measure(square(), "u_end", turned(5e-9), "u_start").g == 2


def test_classes_do_not_depend_on_the_place():
    rng = np.random.default_rng(95)
    for _ in range(40):
        whole = random_patch(rng, degree=int(rng.integers(2, 6)), ends="clamped", spans=1)
        whole = whole.with_points(whole.points + [4e5, -2e5, 1e5])
        one, two = whole.split("u", float(np.mean(whole.domain[0])))
        found = measure(one, "u_end", two, "u_start")
        assert (found.c, found.g) == (2, 2), (found, found.second_difference)


@pytest.mark.parametrize("kind", ["C0", "G1", "C1", "G2", "C2"])
def test_what_joining_promises_is_measured(kind):
    rng, unclear = np.random.default_rng(97), 0
    for index, (first, side, second, other) in enumerate(pairs(96, 150)):
        done = sc.build.join_patches(first, side, second, other, kind, ("second", "first", "both")[index % 3])
        found = measure(done.first, side, done.second, other)
        size = max(np.abs(patch.points).max() for patch in (done.first, done.second))
        assert found.gap <= 1e-11 * size and found.reversed == done.reversed
        if (found.c if kind[0] == "C" else found.g) < int(kind[1]):
            # Where an edge nearly stands still its curvature across is rounding.
            assert kind == "G2" and found.g == 1, (index, found)
            rounding = rounding_of(lambda one, two: measure(one, side, two, other, reversed=done.reversed).curvature_difference,
                                   done.first, done.second, rng)
            assert found.curvature_difference <= 10 * rounding, (index, found)
            unclear += 1
        if kind in ("C1", "C2"):
            assert found.g >= found.c - 1
    assert unclear <= 5


def test_other_kinds_are_measured_by_their_method():
    octant, net, patch = sphere_octant(), hermite_net(), wavy_patch()
    found = octant.continuity_to("u_end", net, "v_start")
    assert found.gap == measure(octant, "u_end", net, "v_start").gap > 0
    assert net.continuity_to("u_start", octant, "u_end").c == -1
    assert patch.continuity_to("u_end", patch.to_nurbs(), "u_end").angle > 3.14
    assert torus().continuity_to("u_start", torus(), "u_end").g == 2
    loose = square().continuity_to("u_end", turned(0.01), "u_start", 0.02)
    assert loose.g == 2 and square().continuity_to("u_end", turned(0.01), "u_start").g == 0


def test_parameters_choose_the_places():
    found = measure(square(), "u_end", turned(1.0), "u_start", parameters=[0, 0.25, 0.25, 1])
    assert found.parameters.tolist() == [0, 0.25, 0.25, 1]
    assert found.points.tolist() == [[1, 0, 0], [1, 0.25, 0], [1, 0.25, 0], [1, 1, 0]]
    assert measure(square(), "u_end", turned(1.0), "u_start", parameters=[]).g == -1


INFINITE = sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, [[(0, 0, 0), (1, 0, 0)], [(0, 0, 1), (0, 1, 1)]],
                         [[1, 1], [0, 0]])
REFUSED = [
    (("u", square(), "u_start"), {}, "first_side = 'u' is not 'u_start', 'u_end', 'v_start' or 'v_end'"),
    (("u_end", square(), None), {}, "second_side = None is not"),
    (("u_end", square(), 1), {}, "second_side = 1 is not"),
    (("u_end", wavy_patch(), "v_start"), {}, "side of the second patch is the seam of a periodic direction"),
    (("u_end", INFINITE, "u_end"), {}, "side of the second patch lies at infinity"),
    (("u_end", square(), "u_start"), {"tolerance": -1}, "tolerance = -1 is not 0 or more"),
    (("u_end", square(), "u_start"), {"tolerance": NAN}, "tolerance = nan"),
    (("u_end", square(), "u_start"), {"parameters": [0, 1.5]}, r"parameters\[1\] = 1.5 is outside \[0, 1\]"),
    (("u_end", square(), "u_start"), {"parameters": [NAN]}, r"parameters\[0\] = nan"),
    (("u_end", square(), "u_start"), {"parameters": [[0, 1]]}, "parameters has shape"),
]


@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_bad_input_is_refused_in_a_sentence(number):
    arguments, options, sentence = REFUSED[number]
    with pytest.raises(sc.InvalidShape, match=sentence):
        measure(square(), *arguments, **options)


def test_sides_of_the_method_are_named_as_it_names_them():
    with pytest.raises(sc.InvalidShape, match="^side = 'x'"):
        square().continuity_to("x", square(), "u_end")
    with pytest.raises(sc.InvalidShape, match="^other_side = 'x'"):
        square().continuity_to("u_end", square(), "x")
    with pytest.raises(sc.InvalidShape, match="side of the first patch is the seam"):
        wavy_patch().continuity_to("v_end", square(), "u_end")


@pytest.mark.parametrize("bad", [None, 3, "patch", [square()]])
def test_what_is_no_patch_raises_type_error(bad):
    with pytest.raises(TypeError, match="second must be a patch"):
        measure(square(), "u_end", bad, "u_start")
    with pytest.raises(TypeError, match="other must be a patch"):
        square().continuity_to("u_end", bad, "u_start")


@pytest.mark.parametrize("options", [{"tolerance": "1"}, {"tolerance": None}, {"parameters": "x"}])
def test_arguments_of_another_type_are_refused(options):
    with pytest.raises(TypeError):
        measure(square(), "u_end", square(), "u_start", **options)


def test_every_side_of_a_box_meets_four_others():
    faces = [square((0, 0, 0), (1, 0, 0), (0, 1, 0)), square((0, 0, 1), (1, 0, 0), (0, 1, 0)),
             square((0, 0, 0), (1, 0, 0), (0, 0, 1)), square((0, 1, 0), (1, 0, 0), (0, 0, 1)),
             square((0, 0, 0), (0, 1, 0), (0, 0, 1)), square((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    met = 0
    for i, one in enumerate(faces):
        for other in faces[i + 1:]:
            for side in SIDES:
                for at in SIDES:
                    found = measure(one, side, other, at)
                    met += found.c == 0
                    assert found.c < 0 or abs(found.angle - math.pi / 2) <= 1e-15
    assert met == 12
