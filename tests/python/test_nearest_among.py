"""The nearest of several shapes: what the nearest of each one says, first shapes at equal distances, every size, and bad calls."""

import threading

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve
from random_patches import random_patch
from splinecore import build

SIZES = (1e-150, 1e-20, 1.0, 1e20, 1e150)


def of_each(shapes, points):
    """(n, shapes) distances, by one search after the other."""
    return np.stack([shape.nearest(points).distances for shape in shapes], -1)


def check(shapes, points):
    """The least distance of all; the place is on that shape, and no shape before it is as near."""
    found = sc.nearest(shapes, points)
    every = of_each(shapes, points)
    size = max(np.abs(np.array(shape.bounding_box())).max() for shape in shapes)
    near = 1e-13 * (size + every.min(-1))
    assert (np.abs(found.distances - every.min(-1)) <= near).all()
    own = np.take_along_axis(every, found.shapes[:, None], -1)[:, 0]
    assert (np.abs(own - found.distances) <= near).all()
    for i, number in enumerate(found.shapes):
        assert (every[i, :number] >= every[i].min()).all()
        at = found.parameters[i]
        there = [shapes[number].evaluate(*np.atleast_1d(at), side=side) for side in ('left', 'right')]
        assert min(np.linalg.norm(one - found.points[i]) for one in there) <= 1e-12 * (size + near[i])
    return found


def scattered(rng, count, shape):
    """Shapes of many sizes, here and there, near and far from the origin."""
    shift = rng.choice([0.0, 1e3]) * rng.normal(size=3)
    return [shape(rng).scaled(10.0**rng.uniform(-2, 1)).translated(10 * rng.normal(size=3) + shift) for _ in range(count)], shift


@pytest.mark.parametrize("shape", (random_curve, random_patch))
def test_the_nearest_of_all_is_that_of_one_of_them(shape, inputs):
    for seed in range(inputs(16)):
        rng = np.random.default_rng(seed)
        shapes, shift = scattered(rng, int(rng.integers(1, 30)), shape)
        check(shapes, np.concatenate([15 * rng.normal(size=(20, 3)) + shift, [one.points.reshape(-1, 3)[0] for one in shapes]]))


@pytest.mark.parametrize("size", SIZES)
def test_a_row_of_spheres_at_every_size(size):
    shapes = [build.sphere((3 * size * i, 0, 0), size) for i in range(40)]
    points = size * np.random.default_rng(3).uniform(-5, 125, (500, 3))
    wanted = np.abs(np.linalg.norm(points[:, None] - 3 * size * np.arange(40)[:, None] * [1, 0, 0], axis=-1) - size).min(-1)
    assert np.abs(sc.nearest(shapes, points).distances - wanted).max() <= 1e-13 * 125 * size


def test_of_shapes_at_one_distance_the_first_is_taken():
    line = sc.BezierCurve([(-1, 0), (1, 0)])
    for count in (2, 9, 100):
        assert sc.nearest([line] * count, [(0.3, 1), (5, 5)]).shapes.tolist() == [0, 0]
    beside = [sc.BezierPatch([[(i, 0, 0), (i, 1, 0)], [(i + 1, 0, 0), (i + 1, 1, 0)]]) for i in range(5)]
    on_edges = np.array([(i, 0.3, 0.7) for i in range(6)], float)
    assert sc.nearest(beside, on_edges).shapes.tolist() == [0, 0, 1, 2, 3, 4]
    assert sc.nearest(beside[::-1], on_edges).shapes.tolist() == [4, 3, 2, 1, 0, 0]


def test_any_batch_and_number_of_threads_gives_the_same():
    rng = np.random.default_rng(5)
    shapes = [random_patch(rng, degree=3).translated(3 * rng.normal(size=3)) for _ in range(20)]
    points = 5 * rng.normal(size=(60, 3))
    one = sc.nearest(shapes, points, threads=1)
    many = sc.nearest(tuple(shapes), points, threads=4)
    for name in ('shapes', 'parameters', 'points', 'distances'):
        assert np.array_equal(getattr(one, name), getattr(many, name))
        single = np.array([getattr(sc.nearest(shapes, point), name) for point in points[:20]])
        assert np.array_equal(getattr(one, name)[:20], single)
    assert sc.nearest(shapes, points.reshape(3, 20, 3)).parameters.shape == (3, 20, 2)


def test_infinity_and_far_points():
    line = sc.BezierCurve([(-1, 0), (1, 0)])
    parabola = sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 0])
    far = np.array([(1e3, 2e3, 0), (1e15, 1e15, 0), (0, 1e100, 0)])
    assert sc.nearest([line, parabola], far).distances == pytest.approx(
        of_each([line, parabola], far).min(-1), rel=1e-13)
    with pytest.raises(sc.InvalidShape, match=r"points\[1\] is too far away"):
        sc.nearest([line], [(0, 0), (1.5e308, 1.5e308)])


def test_bad_calls_are_refused():
    line, patch = sc.BezierCurve([(-1, 0), (1, 0)]), build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    with pytest.raises(sc.InvalidShape, match="shapes is empty"):
        sc.nearest([], [(0, 0)])
    with pytest.raises(sc.InvalidShape, match=r"shapes\[1\] is BezierCurve, a patch is expected"):
        sc.nearest([patch, line], [(0, 0)])
    with pytest.raises(sc.InvalidShape, match=r"shapes\[1\] is .*Patch, a curve is expected"):
        sc.nearest([line, patch], [(0, 0)])
    with pytest.raises(TypeError, match="shapes must be a list"):
        sc.nearest(line, [(0, 0)])
    with pytest.raises(sc.InvalidShape, match=r"points\[0, 1\] = nan is not finite"):
        sc.nearest([line], [(0, np.nan)])
    found = sc.nearest([line], np.empty((0, 3)))
    assert found.shapes.shape == (0,) and found.points.shape == (0, 3) and found.shapes.dtype == np.int64
    assert repr(sc.nearest([line], [(0, 1)])) == "NearestAmong(shape=(1,))"


def test_a_list_that_is_emptied_meanwhile_stays_alive():
    rng = np.random.default_rng(7)
    shapes = [random_patch(rng, degree=3) for _ in range(50)]
    points = rng.normal(size=(200, 3))
    wanted = sc.nearest(shapes, points).distances
    given = [sc.loads(shape.dumps()) for shape in shapes]
    found = []
    work = threading.Thread(target=lambda: found.append(sc.nearest(given, points).distances))
    work.start()
    given.clear()
    work.join()
    if len(found):                      # else the list was empty before it was read
        assert np.array_equal(found[0], wanted)
