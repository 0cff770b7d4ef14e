"""The homogeneous view of rational curves (S9): (X, Y, W), its rays and its image, and the way back; of wild curves, too."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

axes, definitions, homogeneous, signs = (core(name) for name in (
    "formulas.axes", "shape.definition", "formulas.homogeneous", "formulas.signs"))
Refusal = core("base.failures").Refusal
ONE, ZERO = homogeneous.space_of(1.0, True), homogeneous.space_of(2.0, False)


def plane_curves(count):
    random = np.random.default_rng(9)
    for number in range(count):
        degree = int(random.integers(1, 6))
        points = np.column_stack([random.uniform(-5, 5, (degree + 4, 2)), np.zeros(degree + 4)])
        weights = random.uniform(0.1, 4.0, degree + 4)
        if number % 3 == 1:
            weights[random.integers(1, degree + 2)] *= -1.0
        if number % 3 == 2:
            weights[random.integers(1, degree + 2)] = 0.0
        knots = np.concatenate([np.zeros(degree + 1), [1, 2, 4], np.full(degree + 1, 5.0)])
        yield sc.NurbsCurve(degree, knots, points, weights)


def picture(curve, space=ONE, **changed):
    return homogeneous.picture(curve, space, **{'marker': 0.05, 'has_polygons': True, 'has_plane': True, 'rays': True, 'cone': 8, **changed})


def parts_of(parts, name):
    return [part.curve for part in parts if part.name == name]


@pytest.mark.parametrize('space', (ONE, ZERO, homogeneous.space_of(-0.5, True)))
def test_the_curve_in_space_divided_by_w_is_the_curve(space):
    for curve in plane_curves(30):
        upon = homogeneous.lifted(curve, space)
        assert not upon.is_rational
        u = np.linspace(*curve.domain, 33)
        places = upon.evaluate(u)
        w = places[:, 2] / space.height + space.base
        plain = curve.evaluate(u, at_infinity='nan')
        is_there = np.isfinite(plain).all(axis=1) & (np.abs(w) > 1e-3)
        assert np.allclose(places[is_there, :2] / w[is_there, None], plain[is_there, :2], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize('eye, plane', (((0.0, 0.0, -1.0), 0.0), ((0.7, -2.0, 9.0), 1.5)))
def test_rays_of_an_image_go_from_the_eye_through_points_and_images(eye, plane):
    random = np.random.default_rng(5)
    for curve in plane_curves(30):
        space = sc.NurbsCurve(curve.degree, curve.knots, random.uniform(-5, 5, curve.points.shape), curve.weights)
        parts = homogeneous.seen(space, eye, plane, True, 8)
        image, rays = parts_of(parts, homogeneous.IMAGE)[0], parts_of(parts, homogeneous.RAY)
        there = space.weights != 0.0
        assert len(rays) == there.sum() and 1 <= len(parts_of(parts, homogeneous.CONE)) <= 9
        for ray, point, shown, weight in zip(rays, space.points[there], image.points[there], image.weights[there]):
            for place in (point, *([shown] if abs(weight) > 0.5 else [])):
                assert distance_to(ray, place) < 1e-9 * max(1.0, np.abs(place).max())
            assert distance_to(ray, np.array(eye)) < 1e-9


def distance_to(segment, place):
    start, end = segment.points
    share = np.clip(np.dot(place - start, end - start) / np.dot(end - start, end - start), 0.0, 1.0)
    return np.linalg.norm(start + share * (end - start) - place)


@pytest.mark.parametrize('height', (1.0, 2.5, -0.7))
def test_the_image_of_the_homogeneous_curve_is_the_curve_with_its_weights(height):
    for curve in plane_curves(30):
        upon = homogeneous.lifted(curve, homogeneous.space_of(height, True))
        back = homogeneous.image(upon, (0.0, 0.0, -height), 0.0)
        assert np.allclose(back.homogeneous_points, curve.homogeneous_points, rtol=0, atol=1e-12)
        high = homogeneous.lifted(curve, homogeneous.space_of(height, False))
        rows = homogeneous.image(high, (0.0, 0.0, 0.0), height).homogeneous_points
        assert np.allclose(rows[:, [0, 1, 3]], curve.homogeneous_points[:, [0, 1, 3]], rtol=0, atol=1e-12)
        assert np.allclose(rows[:, 2], height * rows[:, 3], rtol=0, atol=1e-12)


def test_the_conic_of_one_zero_weight_has_its_point_in_the_plane_through_the_origin():
    curve = sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]).to_nurbs()
    parts = picture(curve)
    points = parts_of(parts, homogeneous.CURVE)[0].points
    assert np.array_equal(points, [(1, 0, 0), (0, 1, -1), (-1, 0, 0)])
    rays = parts_of(parts, homogeneous.RAY)
    assert np.array_equal(rays[1].points, [(0, 0, -1), (0, 1, -1)])
    names = [part.name for part in parts]
    assert "mark P_{1}  W = 0" in names and "mark p_{1}" not in names and "mark p_{0}" in names
    border = [one.points for one in parts_of(parts, axes.GRID) if (one.points[:, 2] == -1.0).all()]
    assert len(border) == 4 and np.concatenate(border)[:, 1].max() >= 1.0


def test_rays_go_from_the_origin_through_points_and_images_and_end():
    for curve in plane_curves(30):
        rows = curve.homogeneous_points
        parts = picture(curve)
        reach = 3.0001 * homogeneous._farthest(rows, ONE)
        for name, count in ((homogeneous.RAY, len(rows)), (homogeneous.CONE, 9)):
            rays = parts_of(parts, name)
            assert len(rays) == count
            for ray in rays:
                start, end = ray.points - (0, 0, -1)
                assert np.linalg.norm(np.cross(start, end)) <= 1e-9 * (1 + np.linalg.norm(start) * np.linalg.norm(end))
                assert max(np.linalg.norm(start), np.linalg.norm(end)) <= reach
        for row, ray in zip(rows, parts_of(parts, homogeneous.RAY)):
            along = ray.points - (0, 0, -1)
            direction = row[[0, 1, 3]]
            multiples = np.sort(along @ direction / (direction @ direction))
            assert multiples[0] <= 1e-12 and multiples[1] >= 1.0 - 1e-12
            if abs(row[3]) > 0.1:
                assert multiples[0] <= 1.0 / row[3] + 1e-9 and multiples[1] >= 1.0 / row[3] - 1e-9


def test_a_linear_factor_gives_another_curve_on_the_same_cone():
    curve = next(plane_curves(1))
    other = homogeneous.multiplied(curve, 0.5, 3.0)
    assert homogeneous.multiplied(curve, 1.0, 1.0) is curve and other.degree == curve.degree + 1
    u = np.linspace(*curve.domain, 17)
    one, two = (homogeneous.lifted(each, ZERO).evaluate(u) for each in (curve, other))
    factor = 0.5 + 2.5 * (u - u[0]) / (u[-1] - u[0])
    assert np.allclose(two, one * factor[:, None], rtol=1e-12, atol=1e-12)


def test_what_leaves_its_plane_is_refused_but_not_what_single_precision_leaves():
    points = np.array([(0, 0, 0), (1, 2, 0), (3, 0, 0)], float)
    homogeneous.lifted(sc.BezierCurve(points + (0, 0, 5e-8)).to_nurbs(), ONE)
    with pytest.raises(Refusal, match="leaves the plane z = 0 by 0.1"):
        homogeneous.lifted(sc.BezierCurve(points + (0, 0, 0.1)).to_nurbs(), ONE)
    with pytest.raises(Refusal, match="no distance"):
        homogeneous.space_of(0.0, True)
    with pytest.raises(Refusal, match="eye lies in the plane"):
        homogeneous.image(sc.BezierCurve(points).to_nurbs(), (1.0, 1.0, 2.0), 2.0)


@pytest.mark.parametrize('space', (ONE, ZERO))
def test_the_eye_and_the_plane_of_a_picture_are_found_in_it(space):
    parts = picture(next(plane_curves(1)), space)
    drawn = definitions.named(definitions.from_value([part.curve for part in parts]), [part.name for part in parts])
    assert homogeneous.view_of(drawn) == pytest.approx({'x': 0.0, 'y': 0.0, 'z': -space.height * space.base,
                                                        'plane': space.height * (1 - space.base)}, abs=1e-12)
    assert len(parts_of(parts, homogeneous.IMAGE)) == (space.base == 0.0)


def test_extreme_weights_keep_rays_finite():
    for small in (1e-300, 1e-12, 1e-3, -1e-9):
        curve = sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)], [1.0, small, 1.0]).to_nurbs()
        parts = picture(curve, cone=50)
        assert all(np.isfinite(part.curve.points).all() for part in parts if part.name in (homogeneous.RAY, homogeneous.CONE))
