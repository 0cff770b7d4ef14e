"""A dragged point arrives, and the control points move by the least change: beside NumPy's pseudo-inverse."""

import numpy as np
import pytest

import splinecore as sc
from random_curves import random_curve, random_curves
from random_patches import random_patch, random_patches

BY = np.array([0.3, -2.0, 1.1])


def middle(curve):
    """Inside the first span, where no weight of these tests is zero."""
    start, end = curve.domain
    return start + 0.37 * (end - start)


def units(curve):
    """The curve with a 1 in place of one point and 0 in place of all others, for each point that may move."""
    for i in np.flatnonzero(curve.weights):
        points = np.zeros((len(curve.points), 3))
        points[i] = 1
        yield i, curve.with_points(points)


def rows(curve, u, order=1):
    """What each point counts in the point at u and in the derivatives, (order + 1, n)."""
    found = np.zeros((order + 1, len(curve.points)))
    for i, unit in units(curve):
        found[:, i] = unit.derivatives(u, order)[:, 0]
    return found


def least(system, wanted, factors):
    """The motion (n, 3) of the least sum of squares over factors, by the pseudo-inverse of rows of a like size."""
    roots = np.sqrt(factors)
    sizes = np.abs(system * roots).max(1)
    return roots[:, None] * (np.linalg.pinv(system * roots / sizes[:, None], 1e-13) @ (wanted / sizes[:, None]))


def is_near_infinity(curve, u):
    weight = curve.with_weights(np.ones(len(curve.weights)))
    basis = rows(weight, u)[0]
    return abs(basis @ curve.weights) < 0.05 * np.abs(basis * curve.weights).sum()


def test_a_point_of_any_curve_arrives_by_least_change():
    rng = np.random.default_rng(5)
    count = 0
    for curve in random_curves(17, 400):
        u = middle(curve)
        if is_near_infinity(curve, u):
            continue
        factors = rng.uniform(0, 2, len(curve.points)) * (rng.random(len(curve.points)) < 0.9)
        system = rows(curve, u)[:1]
        if not (system * factors).any():
            continue
        moved = curve.dragged(u, BY, factors=factors)
        motion = moved.points - curve.points
        expected = least(system, BY[None], factors)
        assert np.abs(motion - expected).max() <= 1e-12 * (10 + np.abs(expected).max())
        assert np.linalg.norm(moved.evaluate(u) - curve.evaluate(u) - BY) <= 1e-12 * (
            np.abs(system) @ np.linalg.norm(moved.points, axis=1)).item()
        assert (moved.weights == curve.weights).all() and (moved.knots == curve.knots).all()
        still = (factors == 0) | (system[0] == 0)
        assert moved.points[still].tobytes() == curve.points[still].tobytes()
        count += 1
    assert count > 300


@pytest.mark.parametrize("tangent_by", [(0, 0, 0), (1.0, -2.0, 0.5)])
def test_a_tangent_stays_or_goes_where_it_is_asked_to(tangent_by):
    count = 0
    for curve in random_curves(23, 300):
        u = middle(curve)
        if is_near_infinity(curve, u):
            continue
        system = rows(curve, u)
        sizes = np.abs(system).max(1)[:, None]
        if not sizes.all() or np.linalg.cond(system / sizes) > 1e4:     # too few finite points
            continue
        moved = curve.dragged(u, BY, tangent_by)
        wanted = np.array([BY, tangent_by])
        expected = least(system, wanted, np.ones(len(curve.points)))
        size = 10 + np.abs(expected).max()
        assert np.abs(moved.points - curve.points - expected).max() <= 1e-9 * size
        gained = moved.derivatives(u, 1) - curve.derivatives(u, 1)
        assert (np.abs(gained - wanted) <= 1e-11 * size * np.abs(system).sum(1)[:, None]).all()
        count += 1
    assert count > 150


def test_a_second_derivative_goes_where_it_is_asked_to():
    count, tangent_by, second_by = 0, np.zeros(3), np.array([0.5, 1.0, -3.0])
    for curve in random_curves(29, 300):
        u = middle(curve)
        if is_near_infinity(curve, u):
            continue
        system = rows(curve, u, 2)
        sizes = np.abs(system).max(1)[:, None]
        if not sizes.all() or system.shape[1] < 3 or np.linalg.cond(system / sizes) > 1e4:      # too few points, or degree 1
            continue
        moved = curve.dragged(u, BY, tangent_by, second_by)
        wanted = np.array([BY, tangent_by, second_by])
        expected = least(system, wanted, np.ones(len(curve.points)))
        size = 10 + np.abs(expected).max()
        assert np.abs(moved.points - curve.points - expected).max() <= 1e-8 * size
        gained = moved.derivatives(u, 2) - curve.derivatives(u, 2)
        assert (np.abs(gained - wanted) <= 1e-10 * size * np.abs(system).sum(1)[:, None]).all()
        count += 1
    assert count > 120


def test_a_second_derivative_of_a_chain():
    rng = np.random.default_rng(3)
    chain = sc.HermiteCurve(rng.normal(size=(4, 3)), rng.normal(size=(4, 2, 3)), [0, 1, 2.5, 3.0])
    for u in (0.0, 0.4, 1.7, 3.0):
        gained = chain.dragged(u, (0, 0, 0), (0, 0, 0), (1, 2, 3)).derivatives(u, 2) - chain.derivatives(u, 2)
        assert np.allclose(gained, [(0, 0, 0), (0, 0, 0), (1, 2, 3)], atol=1e-12)


def test_a_second_derivative_that_cannot_be_chosen_is_refused():
    line = sc.NurbsCurve(1, [0, 0, 1, 1], [[0, 0, 0], [1, 0, 0]])
    with pytest.raises(sc.InvalidShape, match="the second derivative at u = 0.5 cannot be chosen"):
        line.dragged(0.5, BY, (0, 0, 0), (0, 0, 1))
    curve = random_curve(np.random.default_rng(1), degree=3, spans=4)
    with pytest.raises(sc.InvalidShape, match="without tangent_by"):
        curve.dragged(middle(curve), BY, None, (0, 0, 1))
    for wrong in ((1, 2, 3, 4), (0, 0, np.nan), "abc"):
        with pytest.raises((sc.InvalidShape, TypeError)):
            curve.dragged(middle(curve), BY, (0, 0, 0), wrong)


@pytest.mark.parametrize("size", [1e-150, 1e-30, 1.0, 1e30, 1e150])
@pytest.mark.parametrize("spacing", [1e-100, 1.0, 1e100])
def test_at_any_size_and_spacing(size, spacing):
    for degree in range(1, 10):
        base = random_curve(np.random.default_rng(degree), degree=degree, spans=8)
        curve = sc.NurbsCurve(degree, np.array(base.knots) * spacing, base.points * size, base.weights, base.periodic)
        u = middle(curve)
        moved = curve.dragged(u, BY * size, (0, 0, 0), locality=0.5)
        plain = base.dragged(middle(base), BY, (0, 0, 0), locality=0.5)
        assert np.allclose(moved.points / size, plain.points, rtol=0, atol=1e-9 * np.abs(plain.points).max())
        assert np.allclose((moved.evaluate(u) - curve.evaluate(u)) / size, BY, rtol=0, atol=1e-12 * np.abs(
            plain.points).max())


def test_far_from_the_origin_the_motion_is_the_same():
    for curve in random_curves(3, 50, positive=True):
        far = curve.with_points(curve.points + 1e8)
        near = curve.dragged(middle(curve), BY).points - curve.points
        assert np.abs(far.dragged(middle(curve), BY).points - far.points - near).max() <= 1e-15 * 1e8 * 4


def test_a_bezier_curve_is_as_its_nurbs_form():
    curve = sc.BezierCurve(np.random.default_rng(1).uniform(-1, 1, (5, 3)), [1, 2, 0, -0.5, 1])
    assert curve.dragged(0.3, BY).to_nurbs() == curve.to_nurbs().dragged(0.3, BY)
    assert curve.dragged(0.3, BY).points[2].tobytes() == curve.points[2].tobytes()      # at infinity


def test_an_end_moves_alone():
    curve = sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)])
    assert np.array_equal(curve.dragged(0, (0, 0, 5)).points, [(0, 0, 5), (1, 1, 0), (2, 0, 0)])
    kept = curve.dragged(0, (0, 0, 5), (0, 0, 0))
    assert np.allclose(kept.points, [(0, 0, 5), (1, 1, 5), (2, 0, 0)], atol=1e-14)


def test_ends_that_meet_stay_together():
    points = np.random.default_rng(4).uniform(-1, 1, (7, 3))
    points[-1] = points[0]
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], points, [1, 2, 1, 3, 1, 1, 4])
    for u in (0, 0.2, 4):
        moved = curve.dragged(u, BY)
        assert np.array_equal(moved.points[0], moved.points[-1]) and not np.array_equal(moved.points[0], points[0])
        assert np.allclose(moved.evaluate(u) - curve.evaluate(u), BY, atol=1e-14)
    # One unknown for both: the row of the closed system, whose last column is added to the first.
    system = rows(curve, 0.2)[:1]
    closed = np.c_[system[:, :1] + system[:, -1:], system[:, 1:-1]]
    assert np.allclose((curve.dragged(0.2, BY).points - points)[:-1], least(closed, BY[None], np.ones(6)), atol=1e-13)
    unclamped = sc.NurbsCurve(2, range(8), np.r_[points[:4], points[:1]])
    moved = unclamped.dragged(2.1, BY)
    assert not np.array_equal(moved.points[0], moved.points[-1])       # the curve does not begin in these


def test_locality_lets_fewer_follow():
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], np.random.default_rng(2).uniform(-1, 1, (7, 3)))
    counts = rows(curve, 1.7)[0]
    before = None
    for locality in (0, 1, 2, 8, 60):
        moved = curve.dragged(1.7, BY, locality=locality)
        by_factors = curve.dragged(1.7, BY, factors=np.abs(counts) ** locality)
        assert np.allclose(moved.points, by_factors.points, atol=1e-13)
        assert np.allclose(moved.evaluate(1.7) - curve.evaluate(1.7), BY, atol=1e-14)
        part = np.linalg.norm(moved.points - curve.points, axis=1)
        spread = part.sum() / part.max()
        assert before is None or spread < before
        before = spread
    assert before < 1 + 1e-4


def chain(rng, count=5, closed=False):
    tangents = rng.uniform(-1, 1, (count, 2, 3))
    tangents[1, 1] = tangents[1, 0]
    points = rng.uniform(-1, 1, (count, 3))
    if closed:
        points[-1], tangents[0, 1], tangents[:, 0] = points[0], tangents[0, 0], tangents[:, 1]
        tangents[-1] = tangents[0] = tangents[0, 0]
    return sc.HermiteCurve(points, tangents, np.cumsum(rng.uniform(0.2, 2, count)))


def hermite_values(curve):
    return np.concatenate([curve.points, curve.tangents[:, 0], curve.tangents[:, 1]])


def test_a_chain_moves_its_handles_by_least_change():
    """Handles: the inner Bezier points, beside which the points and they are the unknowns."""
    rng = np.random.default_rng(9)
    curve = chain(rng)
    n = len(curve.points)
    steps = np.diff(curve.parameters) / 3
    lengths = np.r_[np.ones(n), steps[:1], steps, steps, steps[-1:]]
    u = float(curve.parameters[1] + 0.4 * np.diff(curve.parameters)[1])
    system = np.zeros((2, 3 * n))
    for i in range(3 * n):
        values = np.zeros((3 * n, 3))
        values[i] = 1
        unit = sc.HermiteCurve(values[:n], np.stack([values[n:2 * n], values[2 * n:]], 1), curve.parameters)
        system[:, i] = unit.derivatives(u, 1)[:, 0]
    # The tangents that are equal at point 1 are one unknown, measured by the mean of both handles.
    joined = np.delete(np.eye(3 * n), 2 * n + 1, 1)
    joined[2 * n + 1, n + 1] = 1
    lengths[n + 1] = 0.5 * (steps[0] + steps[1])
    lengths = np.delete(lengths, 2 * n + 1)
    for wanted, moved in ((np.array([BY]), curve.dragged(u, BY)),
                          (np.array([BY, (1, 2, 3)]), curve.dragged(u, BY, (1, 2, 3)))):
        motion = least((system[:len(wanted)] @ joined) / lengths, wanted, np.ones(3 * n - 1)) / lengths[:, None]
        assert np.allclose(hermite_values(moved) - hermite_values(curve), joined @ motion, atol=1e-12)
        assert np.allclose((moved.derivatives(u, 1) - curve.derivatives(u, 1))[:len(wanted)], wanted, atol=1e-12)
    assert np.array_equal(moved.tangents[1, 0], moved.tangents[1, 1])
    assert not np.array_equal(moved.tangents[2, 0], moved.tangents[2, 1])


def test_a_chain_does_not_care_how_its_parameter_runs():
    curve = chain(np.random.default_rng(11))
    slow = sc.HermiteCurve(curve.points, curve.tangents / 1e90, curve.parameters * 1e90)
    u = float(curve.parameters[2] * 0.9 + curve.parameters[3] * 0.1)
    moved, moved_slowly = curve.dragged(u, BY), slow.dragged(u * 1e90, BY)
    assert np.allclose(moved.points, moved_slowly.points, atol=1e-13)
    assert np.allclose(moved.tangents, moved_slowly.tangents * 1e90, atol=1e-12)
    end = sum(curve.domain)
    turned = curve.reversed().dragged(end - u, BY).reversed()
    assert np.allclose(turned.points, moved.points, atol=1e-12)
    assert np.allclose(turned.tangents, moved.tangents, atol=1e-12)


def test_a_closed_chain_stays_closed_and_smooth():
    curve = chain(np.random.default_rng(12), closed=True)
    for u in (curve.domain[0], curve.domain[0] + 0.1, curve.domain[1] - 0.1):
        moved = curve.dragged(u, BY)
        assert np.array_equal(moved.points[0], moved.points[-1]) and not np.array_equal(moved.points[0], curve.points[0])
        assert np.array_equal(moved.tangents[:, 0], moved.tangents[:, 1])
        assert np.array_equal(moved.tangents[0], moved.tangents[-1])
        assert np.allclose(moved.evaluate(u) - curve.evaluate(u), BY, atol=1e-13)


def test_factors_hold_tangents_of_a_chain():
    curve = chain(np.random.default_rng(13))
    factors = np.zeros((3, 5))
    factors[0] = 1
    moved = curve.dragged(curve.parameters[1] + 0.1, BY, factors=factors)
    assert moved.tangents.tobytes() == curve.tangents.tobytes()
    assert np.allclose(moved.evaluate(curve.parameters[1] + 0.1) - curve.evaluate(curve.parameters[1] + 0.1), BY)


def patch_row(patch, u, v):
    """What each point counts at (u, v), (nu, nv); 0 at infinity."""
    row = np.zeros(patch.weights.shape)
    for at in np.argwhere(patch.weights):
        points = np.zeros(patch.points.shape)
        points[tuple(at)] = 1
        row[tuple(at)] = patch.with_points(points).evaluate(u, v)[0]
    return row


def test_a_point_of_any_patch_arrives_by_least_change():
    rng = np.random.default_rng(6)
    count = 0
    for patch in random_patches(31, 60):
        u, v = (start + 0.41 * (end - start) for start, end in patch.domain)
        plain = patch_row(patch.with_weights(np.ones(patch.weights.shape)), u, v)
        if abs((plain * patch.weights).sum()) < 0.05 * np.abs(plain * patch.weights).sum():
            continue
        factors = rng.uniform(0.1, 2, patch.weights.shape)
        row = patch_row(patch, u, v)
        moved = patch.dragged(u, v, BY, factors=factors)
        expected = least(row.reshape(1, -1), BY[None], factors.ravel()).reshape(patch.points.shape)
        size = 10 + np.abs(expected).max()
        assert np.abs(moved.points - patch.points - expected).max() <= 1e-12 * size
        assert np.abs(moved.evaluate(u, v) - patch.evaluate(u, v) - BY).max() <= 1e-12 * size * np.abs(row).sum()
        assert moved.points[row == 0].tobytes() == patch.points[row == 0].tobytes()
        count += 1
    assert count > 40


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
def test_patches_at_any_size(size):
    for degree in (1, 3, 9):
        base = random_patch(np.random.default_rng(degree), degree=degree)
        patch = base.with_points(base.points * size)
        u, v = (start + 0.41 * (end - start) for start, end in patch.domain)
        assert np.allclose((patch.dragged(u, v, BY * size).evaluate(u, v) - patch.evaluate(u, v)) / size, BY, atol=1e-12)


def hermite_patch(rng, nu=3, nv=4):
    nets = [rng.uniform(-1, 1, (nu, nv, 3)) for _ in range(4)]
    return sc.HermitePatch(*nets, (np.cumsum(rng.uniform(0.2, 2, nu)), np.cumsum(rng.uniform(0.2, 2, nv))))


def nets(patch):
    return np.array([patch.points, patch.tangents_u, patch.tangents_v, patch.twists])


def thirds(parameters):
    steps = np.diff(parameters) / 3
    return 0.5 * (np.r_[steps[:1], steps] + np.r_[steps, steps[-1:]])


def test_a_hermite_patch_moves_tangents_and_twists_too():
    rng = np.random.default_rng(8)
    patch = hermite_patch(rng)
    u, v = (0.3 * p[1] + 0.7 * p[2] for p in patch.parameters)
    row = np.zeros((4, 3, 4))
    for at in np.ndindex(row.shape):
        unit = np.zeros((4, 3, 4, 3))
        unit[at] = 1
        row[at] = sc.HermitePatch(*unit, patch.parameters).evaluate(u, v)[0]
    of_u, of_v = map(thirds, patch.parameters)
    one_u, one_v = np.ones(3), np.ones(4)
    lengths = np.array([np.outer(*pair) for pair in ((one_u, one_v), (of_u, one_v), (one_u, of_v), (of_u, of_v))])
    factors = rng.uniform(0.2, 1, row.shape)
    moved = patch.dragged(u, v, BY, factors=factors)
    expected = least((row / lengths).reshape(1, -1), BY[None], factors.ravel()) / lengths.reshape(-1, 1)
    assert np.allclose(nets(moved) - nets(patch), expected.reshape(4, 3, 4, 3), atol=1e-13)
    assert np.allclose(moved.evaluate(u, v) - patch.evaluate(u, v), BY, atol=1e-13)


def test_neighbors_go_along():
    rng = np.random.default_rng(10)
    left = sc.BezierPatch(rng.uniform(-1, 1, (4, 4, 3)))
    right = rng.uniform(-1, 1, (4, 4, 3))
    right[0] = left.points[-1]
    for merge in (True, False):
        patches = sc.PatchSet.from_patches([left, sc.BezierPatch(right)], merge=merge)
        moved = patches.dragged(0, 0.9, 0.5, BY)
        assert np.allclose(moved[0].evaluate(0.9, 0.5) - left.evaluate(0.9, 0.5), BY, atol=1e-14)
        assert np.array_equal(moved[0].points[-1], moved[1].points[0])
        assert not np.array_equal(moved[1].points[0], right[0])
        assert moved[1].points[1:].tobytes() == right[1:].tobytes()
        # What is shared counts once.
        assert np.allclose(moved[0].points, left.dragged(0.9, 0.5, BY).points, atol=1e-14)


def test_seams_and_poles_of_a_sphere_stay_closed():
    sphere = sc.build.sphere((1, 2, 3), 2.0)
    patches = sphere if isinstance(sphere, sc.PatchSet) else sc.PatchSet.from_patches([sphere], merge=False)
    before = patches.edge_counts()
    domain = patches[0].domain
    for part_u in (0.0, 0.1, 0.9):
        for part_v in (0.0, 0.02, 0.5, 0.97):
            u, v = (start + part * (end - start) for (start, end), part in zip(domain, (part_u, part_v)))
            moved = patches.dragged(0, u, v, BY)
            assert moved.edge_counts() == before
            assert np.allclose(moved[0].evaluate(u, v) - patches[0].evaluate(u, v), BY, atol=1e-13)


def test_a_closed_hermite_patch_keeps_its_seam():
    rng = np.random.default_rng(15)
    patch = hermite_patch(rng)
    closed = nets(patch)
    closed[:, :, -1] = closed[:, :, 0]
    patch = sc.HermitePatch(*closed, patch.parameters)
    moved = nets(patch.dragged(patch.parameters[0][1], patch.parameters[1][0] + 0.05, BY))
    assert np.array_equal(moved[:, :, -1], moved[:, :, 0])
    assert not np.array_equal(moved[:, 1, 0], closed[:, 1, 0])


def test_a_tangent_that_serves_several_corners_stays():
    """Ferguson's patch on a merged pool: all twists are one row."""
    grid = np.stack([*np.meshgrid([0.0, 1.0], [0.0, 1.0], indexing="ij"), np.zeros((2, 2))], -1)
    tangent = np.tile((1.0, 0.0, 0.0), (2, 2, 1))
    tangents_v = np.random.default_rng(3).uniform(-1, 1, (2, 2, 3))
    patches = sc.PatchSet.from_patches([sc.HermitePatch(grid, tangent, tangents_v)])
    moved = patches.dragged(0, 0.4, 0.6, BY)[0]
    assert np.array_equal(moved.tangents_u, tangent) and not moved.twists.any()
    assert not np.isclose(moved.tangents_v, tangents_v).any()
    assert np.allclose(moved.evaluate(0.4, 0.6) - patches[0].evaluate(0.4, 0.6), BY, atol=1e-14)


def curve_of_three(weights=(1, 1, 1)):
    return sc.BezierCurve([(0, 0), (1, 1), (2, 0)], weights)


def test_what_cannot_be_is_refused_in_words():
    curve, patch = curve_of_three(), sc.BezierPatch(np.zeros((3, 3, 3)))
    patches = sc.PatchSet.from_patches([patch])
    for call, words in (
            (lambda: curve.dragged(0.5, BY, factors=[0, 0, 0]), "no control point that the point at u = 0.5 depends on"),
            (lambda: curve.dragged(0.0, BY, factors=[0, 1, 1]), "no control point"),
            (lambda: curve_of_three((0, 1, 0)).dragged(0.5, BY, factors=[1, 0, 1]), "no control point"),
            (lambda: curve.dragged(1.5, BY), "u = 1.5"),
            (lambda: curve.dragged(np.nan, BY), "u"),
            (lambda: curve.dragged(0.5, (1, 2, np.inf)), "by"),
            (lambda: curve.dragged(0.5, 3.0), "by has shape"),
            (lambda: curve.dragged(0.5, BY, (1, 2, 3, 4)), "tangent_by has shape"),
            (lambda: curve.dragged(0.5, BY, factors=[1, -1, 1]), r"factors\[1\] = -1"),
            (lambda: curve.dragged(0.5, BY, factors=[1, np.nan, 1]), r"factors\[1\] = nan"),
            (lambda: curve.dragged(0.5, BY, factors=[1, 1]), "factors has shape"),
            (lambda: curve.dragged(0.5, BY, locality=-1), "locality = -1"),
            (lambda: curve.dragged(0.5, BY, (0, 0, 0), factors=[0, 1, 0]), "tangent at u = 0.5 cannot be chosen"),
            (lambda: patch.dragged(0.5, 2.0, BY), "v = 2"),
            (lambda: patch.dragged(0.5, 0.5, BY, factors=np.ones(9)), "factors has shape"),
            (lambda: patch.dragged(0.5, 0.5, BY, factors=np.zeros((3, 3))), "u = 0.5, v = 0.5 depends"),
            (lambda: patches.dragged(1, 0.5, 0.5, BY), "patch = 1"),
            (lambda: patches.dragged(-1, 0.5, 0.5, BY), "patch = -1"),
            (lambda: curve.dragged(0, (1.7e308, 0, 0)).dragged(0, (1.7e308, 0, 0)), "points")):
        with pytest.raises(sc.InvalidShape, match=words):
            call()
    for call in (lambda: curve_of_three((1, -1, 1)).dragged(0.5, BY),
                 lambda: curve_of_three((0, 1, 1)).dragged(0.0, BY),
                 lambda: sc.BezierPatch(np.zeros((2, 2, 3)), [[1, -1], [1, -1]]).dragged(0.2, 0.5, BY)):
        with pytest.raises(sc.PointAtInfinity, match="infinity at u"):
            call()
    with pytest.raises(TypeError):
        curve.dragged("0.5", BY)


def test_negative_zeros_of_what_stays_stay():
    curve = sc.BezierCurve([(0, -0.0, 0), (1, 1, -0.0), (2, 0, -0.0)])
    moved = curve.dragged(0, (1, 0, 0))
    assert moved.points[1:].tobytes() == curve.points[1:].tobytes()
