"""Corners made as large as fits: what the lengths of sides say of polygons, what a search by hand says of bent sides, every size."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def with_largest_corners(points, closed, taken_of):
    """The length of a polygon whose corners take what taken_of(turn) says of both sides, half of a side at most or all up to an end,
    and what replaces them: (lengths taken, lengths left of sides, turns)."""
    ways = np.diff(points, axis=0, append=points[:1])[:None if closed else -1]
    lengths = np.linalg.norm(ways, axis=1)
    ways = ways / lengths[:, None]
    count, left, corners = len(points), lengths.copy(), []
    for i in range(count) if closed else range(1, count - 1):
        before, behind = ways[i - 1], ways[i % len(ways)]
        turn = np.arctan2(np.linalg.norm(np.cross(before, behind)), before @ behind)
        shares = [1.0 if not closed and i == 1 else 0.5, 1.0 if not closed and i == count - 2 else 0.5]
        taken = min(taken_of(turn), shares[0] * lengths[i - 1], shares[1] * lengths[i % len(lengths)])
        left[i - 1] -= taken
        left[i % len(left)] -= taken
        corners.append((taken, turn))
    return corners, left


def polygon(rng):
    """Anywhere, at any size; no corner is almost straight or goes back."""
    while True:
        points = rng.normal(size=(int(rng.integers(3, 9)), 3)) * rng.choice([1.0, 0.1], (1, 3)) * 10.0**rng.uniform(-6, 6)
        ways = np.diff(np.concatenate([points, points[:2]]), axis=0)
        ways /= np.linalg.norm(ways, axis=1)[:, None]
        if (np.abs((ways[:-1] * ways[1:]).sum(1)) < 0.99).all():
            return points + rng.choice([0.0, 1.0]) * np.abs(points).max()


def test_corners_of_polygons_take_what_their_sides_have(inputs):
    for seed in range(inputs(400)):
        rng = np.random.default_rng(seed)
        points, closed = polygon(rng), rng.random() < 0.5
        size = np.abs(points).max() * 10.0**rng.uniform(-2, 2)
        whole = build.contour(points, closed=closed)
        corners, left = with_largest_corners(points, closed, lambda turn: size * np.tan(turn / 2))
        made = whole.rounded(size, shrink=True)
        wanted = left.sum() + sum(taken / np.tan(turn / 2) * turn for taken, turn in corners)
        assert made.length() == pytest.approx(wanted, rel=1e-9)
        assert max((joint.angle for _, joint in made.joints()), default=0.0) < 1e-5
        corners, left = with_largest_corners(points, closed, lambda turn: size)
        wanted = left.sum() + sum(2 * taken * np.cos(turn / 2) for taken, turn in corners)
        assert whole.chamfered(size, shrink=True).length() == pytest.approx(wanted, rel=1e-9)


def test_where_all_fits_nothing_shrinks(inputs):
    for seed in range(inputs(100)):
        rng = np.random.default_rng(seed)
        points, closed = polygon(rng), rng.random() < 0.5
        whole = build.contour(points, closed=closed)
        size = 10.0**rng.uniform(-5, -3) * np.linalg.norm(np.diff(points, axis=0), axis=1).min()
        for name in ('rounded', 'chamfered'):
            plain, made = getattr(whole, name)(size), getattr(whole, name)(size, shrink=True)
            assert np.array_equal(plain.degree, made.degree)
            assert np.abs(plain.points - made.points).max() <= 1e-10 * np.abs(points).max()


def bent(rng):
    """Two long arcs of a plane, and a short line between them, with a corner at each end."""
    arcs = [sc.conics.arc_through((-2, 0, 0), (-1, -0.3, 0), (0, 0, 0)), sc.BezierCurve([(0, 0, 0), (0, 0.5, 0)]),
            sc.conics.arc_through((0, 0.5, 0), (-1, 0.8, 0), (-2, 0.5, 0))]
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix = np.eye(4)
    matrix[:3, :3] = 10.0**rng.uniform(-3, 3) * axes
    return build.join_curves([arc.transformed(matrix) for arc in arcs], 1e-6 * np.abs(matrix).max())[0], matrix[:3, :3]


def test_arcs_between_bent_sides_are_as_large_as_fits():
    for seed in range(6):
        whole, matrix = bent(np.random.default_rng(seed))
        unit = np.linalg.norm(matrix[:, 0])
        corners = [u for u, joint in whole.joints() if joint.g == 0]
        assert len(corners) == 2
        made = whole.rounded(5 * unit, shrink=True)
        assert max(joint.angle for _, joint in made.joints()) < 1e-5
        sharp = whole.evaluate(np.array(corners))
        assert made.nearest(sharp).distances.min() > 0.05 * unit
        # The side between both corners is shared: each arc takes up to half of it, and one of them all of its half.
        middle = whole.parameter_at_length(0.5 * sum(whole.length(u) for u in corners))
        assert made.nearest(whole.evaluate(middle)).distances < 1e-6 * unit
        assert made.nearest(whole.evaluate(np.array(whole.domain))).distances.max() < 1e-9 * unit
        small = whole.rounded(1e-2 * unit)
        assert np.abs(small.points - whole.rounded(1e-2 * unit, shrink=True).points).max() < 1e-12 * unit
        with pytest.raises(sc.InvalidShape):
            whole.rounded(5 * unit)


def test_a_corner_that_turns_back_stays():
    back = build.contour([(0, 0), (2, 0), (1, 0), (1, 3)])
    with pytest.raises(sc.InvalidShape, match="turns back"):
        back.rounded(0.1)
    made = back.rounded(0.1, shrink=True)
    assert made.nearest((2, 0)).distances == 0
    assert made.length() == pytest.approx(6 - 0.2 + 0.05 * np.pi)
    assert back.chamfered(0.1, shrink=True).nearest((2, 0)).distances == 0


@pytest.mark.parametrize("scale", (1e-150, 1e-6, 1.0, 1e6, 1e150))
def test_a_square_becomes_a_circle_at_every_size(scale):
    square = build.contour(scale * np.array([(0, 0), (2, 0), (2, 2), (0, 2)], float), closed=True)
    for radius in (1.0, 1.5, 1e6):
        circle = square.rounded(radius * scale, shrink=True)
        assert circle.length() == pytest.approx(2 * np.pi * scale)
        away = np.linalg.norm(circle.evaluate(np.linspace(*circle.domain, 99)) / scale - [1, 1, 0], axis=1)
        assert np.abs(away - 1).max() < 1e-9
    rhomb = square.chamfered(7 * scale, shrink=True)
    assert rhomb.length() == pytest.approx(4 * np.sqrt(2) * scale)


def test_bad_calls_are_refused():
    square = build.contour([(0, 0), (2, 0), (2, 2), (0, 2)], closed=True)
    for bad in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(sc.InvalidShape):
            square.rounded(bad, shrink=True)
        with pytest.raises(sc.InvalidShape):
            square.chamfered(bad, shrink=True)
    with pytest.raises(TypeError, match="shrink"):
        square.rounded(1.0, shrink="yes")
    twisted = build.join_curves([sc.BezierCurve([(0, 0, 0), (1, 0, 1), (2, 0, 0)]), sc.BezierCurve([(2, 0, 0), (2, 1, 1), (2, 2, 0)])],
                                1e-9)[0]
    with pytest.raises(sc.InvalidShape, match="plane"):
        twisted.rounded(0.1, shrink=True)
