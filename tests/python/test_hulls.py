"""Convex hulls against SciPy's (Qhull), by what is true of every hull, and of the lectures' curves."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull, HalfspaceIntersection

import splinecore as sc
from addon_core import core

convex, hulls = core("formulas.convex"), core("formulas.hulls")
FAILURES = core("base.failures")
CUBE = np.array(list(np.ndindex(2, 2, 2)), float)


def holds(hull, points, bound=1e-12):
    size = max(np.abs(hull.corners).max(), 1e-300)
    return (points @ hull.normals.T <= hull.offsets + bound * size).all()


def rows_in_order(points):
    return points[np.lexsort(points.T)]


def edges_of(hull):
    return {frozenset(map(tuple, hull.corners[list(pair)].tolist())) for pair in hull.edges}


def random_points(seed):
    """Of every rank; small, large and far ones; some twice, some within what others span."""
    rng = np.random.default_rng(seed)
    rank, count = seed % 4, int(rng.integers(1, 40))
    points = rng.normal(size=(count, rank)) @ rng.normal(size=(rank, 3))
    points = np.concatenate([points, points[:count // 3], points[rng.integers(count, size=5)] / 2 + points[rng.integers(count, size=5)] / 2])
    return points * 10.0 ** rng.integers(-5, 6) + rng.normal(size=3) * rng.choice([0.0, 1.0])


@pytest.mark.parametrize('seed', range(30))
def test_points_in_general_position_have_the_hull_of_scipy(seed):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(int(rng.integers(4, 80)), 3)) * 10.0 ** rng.integers(-6, 7)
    found, wanted = convex.hull(points), ConvexHull(points)
    assert np.array_equal(rows_in_order(found.corners), rows_in_order(points[wanted.vertices]))
    assert edges_of(found) == {frozenset(map(tuple, points[[face[i], face[i - 1]]].tolist())) for face in wanted.simplices for i in range(3)}
    flat = np.column_stack([points[:, :2], np.zeros(len(points))])
    assert np.array_equal(rows_in_order(convex.hull(flat).corners), rows_in_order(flat[ConvexHull(points[:, :2]).vertices]))


@pytest.mark.parametrize('seed', range(60))
def test_what_is_true_of_every_hull(seed):
    points = random_points(seed)
    found = convex.hull(points)
    assert holds(found, points)
    assert {tuple(corner) for corner in found.corners.tolist()} <= {tuple(point) for point in points.tolist()}
    again = convex.hull(found.corners)
    assert again.rank == found.rank and np.array_equal(rows_in_order(again.corners), rows_in_order(found.corners)) and edges_of(again) == edges_of(found)
    if found.rank == 3:
        assert len(found.corners) - len(found.edges) + len(found.faces) == 2
    if found.rank == 2:
        assert len(found.edges) == len(found.corners) > 2
    mixed = found.corners[:3].mean(axis=0)
    assert holds(found, mixed[None])


@pytest.mark.parametrize('points, rank, corners', (
    ([(1, 2, 3)], 0, 1), ([(1, 2, 3)] * 3, 0, 1), ([(0, 0, 0), (1, 1, 1), (3, 3, 3), (2, 2, 2)], 1, 2), ([(0, 0, 0), (0, 0, 0), (1, 0, 0)], 1, 2),
    ([(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 1, 0)], 2, 3), ([(0, 0, 5), (1, 0, 5), (1, 1, 5), (0, 1, 5), (0.5, 0.5, 5)], 2, 4),
    (CUBE, 3, 8), (np.array(list(np.ndindex(4, 4, 4)), float), 3, 8), ([*CUBE, (0.5, 0.5, 3)], 3, 9),
    (np.repeat(CUBE, 3, axis=0), 3, 8), ([(1e9, 0, 0), (1e9 + 1, 0, 0), (1e9, 1, 0), (1e9, 0, 1)], 3, 4)))
def test_degenerate_and_regular_ones(points, rank, corners):
    found = convex.hull(points)
    assert (found.rank, len(found.corners)) == (rank, corners)


@pytest.mark.parametrize('seed', range(12))
def test_single_precision_leaves_faces_whole(seed):
    """As Blender hands points over: a turned box has 6 faces of 4 corners, whatever lies on them."""
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    grid = (np.array(list(np.ndindex(3, 4, 5)), float) @ turn).astype(np.float32)
    found = convex.hull(grid)
    assert len(found.corners) == 8 and len(found.edges) == 12 and sorted(map(len, found.faces)) == [4] * 6
    flat = convex.hull((np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 2, 0), (0, 1, 0)], float) @ turn).astype(np.float32))
    assert flat.rank == 2 and len(flat.corners) == 4


@pytest.mark.parametrize('seed', range(60))
def test_an_intersection_lies_in_both_and_has_the_points_that_both_have(seed):
    rng = np.random.default_rng(seed)
    one, other = (convex.hull(rng.uniform(0, 1, (int(rng.integers(1, 8)), 3)) * rng.choice([(1, 1, 1), (1, 1, 0)])) for _ in range(2))
    common, swapped = convex.intersection(one, other), convex.intersection(other, one)
    samples = rng.dirichlet(np.ones(len(one.corners)), 200) @ one.corners
    shared = samples[(samples @ other.normals.T <= other.offsets - 1e-4).all(axis=1)] if other.rank == 3 else np.empty((0, 3))
    if common is None:
        assert swapped is None and not len(shared)
        return
    assert swapped.rank == common.rank and holds(one, common.corners, 4e-6) and holds(other, common.corners, 4e-6)
    assert holds(common, shared, 4e-6)
    if common.rank == 3:
        assert ConvexHull(common.corners).volume == pytest.approx(ConvexHull(swapped.corners).volume, abs=1e-5)


@pytest.mark.parametrize('seed', range(20))
def test_hulls_of_many_points_have_the_intersection_of_their_half_spaces(seed):
    """Against SciPy (Qhull)."""
    rng = np.random.default_rng(seed)
    one, other = (convex.hull(rng.uniform(0, 1, (16, 3)) + (0.3 * i, 0, 0)) for i in range(2))
    common = convex.intersection(one, other)
    planes = np.concatenate([np.column_stack([each.normals, -each.offsets]) for each in (one, other)])
    wanted = HalfspaceIntersection(planes, common.corners.mean(axis=0))
    assert ConvexHull(common.corners).volume == pytest.approx(ConvexHull(wanted.intersections).volume, rel=1e-4)
    assert holds(one, common.corners, 4e-6) and holds(other, common.corners, 4e-6)


@pytest.mark.parametrize('by, rank, corners', (((0.5, 0.25, 0.5), 3, 8), ((1, 0, 0), 2, 4), ((1, 1, 0), 1, 2), ((1, 1, 1), 0, 1)))
def test_two_cubes_have_a_box_a_square_a_segment_or_a_point_in_common(by, rank, corners):
    common = convex.intersection(convex.hull(CUBE), convex.hull(CUBE + by))
    assert (common.rank, len(common.corners)) == (rank, corners)
    assert np.allclose(common.corners.min(axis=0), by, rtol=0, atol=1e-15) and np.allclose(common.corners.max(axis=0), 1, rtol=0, atol=1e-15)
    assert convex.intersection(convex.hull(CUBE), convex.hull(CUBE + 1.5)) is None


def uniform(points):
    return sc.NurbsCurve(3, np.arange(len(points) + 4.0), points)


@pytest.mark.parametrize('seed', range(16))
def test_every_span_lies_in_its_hull_and_a_joint_in_the_intersection(seed):
    rng = np.random.default_rng(seed)
    degree, count = int(rng.integers(1, 5)), 9
    points = rng.uniform(-1, 1, (count, 3)) * (1, 1, seed % 2)
    steps = rng.choice([0.0, 1.0, 0.3], count + degree + 1)
    steps[::degree] = 1.0
    knots = np.cumsum(steps)
    curve = sc.NurbsCurve(degree, knots, points, rng.uniform(0.1, 5, count))
    (found,) = hulls.groups([curve], True)
    spans = np.unique(knots[degree:count + 1])
    made = [hulls._hull(rows) for rows in found]
    assert len(found) == len(spans) - 1 and all(len(rows) == degree + 1 for rows in found)
    for hull, start, end in zip(made, spans, spans[1:]):
        assert holds(hull, curve.evaluate(np.linspace(start, end, 20)), 2e-6)
    for one, other, joint in zip(made, made[1:], spans[1:]):
        assert holds(convex.intersection(one, other), curve.evaluate([joint]), 4e-6)


def test_doubled_and_tripled_points_of_the_lectures():
    """001.77, 78: hulls meet in a line, on which the joint lies; tripled, they are segments."""
    p = np.array([(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0), (6, 1, 0), (7, 3, 0)], float)
    doubled = uniform(p[[0, 1, 2, 2, 3, 4]])
    (found,) = hulls.groups([doubled], True)
    one, other = map(hulls._hull, found[:2])
    assert len(found) == 3 and (one.rank, other.rank) == (2, 2)
    tripled = uniform(p[[0, 1, 2, 2, 2, 3, 4]])
    (found,) = hulls.groups([tripled], True)
    assert [hulls._hull(rows).rank for rows in found] == [2, 1, 1, 2]
    meets = convex.intersection(hulls._hull(found[1]), hulls._hull(found[2]))
    assert meets.rank == 0 and np.allclose(meets.corners[0], p[2], rtol=0, atol=1e-5)
    ends = uniform(np.repeat(p[[0, 2]], 4, axis=0))
    assert [hulls._hull(rows).rank for rows in hulls.groups([ends], True)[0]] == [0, 1, 1, 1, 0]


def drawn(shapes, by_spans=True, show='hulls', radius=0.1):
    found = hulls.groups(shapes, by_spans)
    neighboring = hulls.neighbors(shapes, found, by_spans)
    if not by_spans:
        found, neighboring = hulls.whole(found, shapes[0].homogeneous_points.ndim == 2)
    return hulls.picture(found, show, radius, neighboring)


def test_pictures_have_every_edge_once_and_closed_polygons():
    plane, _ = drawn([sc.BezierCurve([(0, 0), (0, 1), (1, 1), (1, 0)])])
    assert [part.name for part in plane] == ["hull 0"] and np.array_equal(plane[0].curve.points[0], plane[0].curve.points[-1])
    box, _ = drawn([sc.BezierPatch(np.array(list(np.ndindex(2, 2, 2)), float).reshape(2, 4, 3))])
    legs = [tuple(sorted(map(tuple, leg.tolist()))) for part in box for points in [part.curve.points] for leg in zip(points, points[1:])
            for leg in [np.array(leg)]]
    assert len(legs) == len(set(legs)) == 12 and {part.name for part in box} == {"hull 0"}
    both, _ = drawn([uniform(np.random.default_rng(1).uniform(-1, 1, (7, 3)))], show='both')
    assert {part.name for part in both} == {"hull 0", "hull 1", "hull 2", "hull 3", "intersection"}


def test_periodic_curves_patches_and_points_at_infinity():
    ring = sc.NurbsCurve(2, np.arange(7.0), np.array([(1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0), (-1, 0, 0), (0, -1, 0)], float), periodic=True)
    parts, _ = drawn([ring], show='both')
    assert {part.name for part in parts} == {*(f"hull {i}" for i in range(6)), "intersection"}
    assert sum(part.name == "intersection" for part in parts) == 6
    patch = sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 2, 2, 2], [0, 0, 1, 2, 2]), np.random.default_rng(2).uniform(-1, 1, (4, 3, 3)))
    assert [len(rows) for rows in hulls.groups([patch], True)[0]] == [6] * 4 and len(hulls.groups([patch], False)[0][0]) == 12
    half, said = drawn([sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1])])
    assert len(half[0].curve.points) == 2 and "may leave its hulls" in said
    chain, said = drawn([sc.HermiteCurve(np.eye(3), np.eye(3))])
    assert {part.name for part in chain} == {"hull 0", "hull 1"} and not said


def intersections(parts):
    return [part.curve for part in parts if part.name == "intersection"]


def random_patch(seed, periodic=(False, False), degree=(2, 3)):
    random = np.random.default_rng(seed)
    sizes = [axis + 2 if not closed else axis + 3 for axis, closed in zip(degree, periodic)]
    knots = [np.cumsum(random.uniform(0.2, 1, size + 1 + (0 if closed else axis))) for size, axis, closed in zip(sizes, degree, periodic)]
    return sc.NurbsPatch(degree, knots, random.uniform(-1, 1, (*sizes, 3)), random.uniform(0.3, 3, sizes), periodic)


@pytest.mark.parametrize('seed', range(12))
def test_neighboring_spans_of_a_patch_have_the_curve_between_them_in_common(seed):
    """Every pair of neighbors, both ways and across seams: points on the knot line lie in both hulls."""
    patch = random_patch(seed, ((seed % 4) in (1, 3), (seed % 4) in (2, 3)))
    (found,), (pairs,) = hulls.groups([patch], True), hulls.neighbors([patch], hulls.groups([patch], True), True)
    bounds = [np.unique(np.clip(np.array(knots), *interval)) for knots, interval in zip(patch.unrolled().knots, patch.domain)]
    across = len(bounds[1]) - 1
    counts = len(bounds[0]) - 1, across
    closed = [is_closed and count > 2 for is_closed, count in zip(patch.periodic, counts)]
    assert len(found) == counts[0] * counts[1]
    assert len(pairs) == (counts[0] - 1 + closed[0]) * counts[1] + counts[0] * (counts[1] - 1 + closed[1])
    made = [hulls._hull(rows) for rows in found]
    for i, j in pairs:
        (a, b), (c, d) = divmod(i, across), divmod(j, across)
        common = convex.intersection(made[i], made[j])
        axis = 0 if b == d else 1
        line, along = (a, b)[axis] + 1, np.linspace(*bounds[1 - axis][[(a, b)[1 - axis], (a, b)[1 - axis] + 1]], 7)
        at = bounds[axis][line:line + 1]
        between = patch.evaluate_grid(*((at, along) if axis == 0 else (along, at)), side='left').reshape(-1, 3)
        assert holds(common, between, 4e-6), (i, j)


def test_intersections_of_patches_are_drawn_by_spans_and_whole():
    spans, said = drawn([random_patch(1)], show='both')
    assert intersections(spans) and not said
    flat = np.array(list(np.ndindex(3, 2, 1)), float).reshape(3, 2, 3)
    one, other = sc.BezierPatch(flat), sc.BezierPatch(flat + (2, 0, 0))
    (common,) = intersections(drawn([one, other], by_spans=False, show='intersections')[0])
    assert {tuple(point) for point in common.points.tolist()} == {(2, 0, 0), (2, 1, 0)}, "the border that both have"
    with pytest.raises(FAILURES.Refusal, match="no two neighboring hulls"):
        drawn([one, sc.BezierPatch(flat + (5, 0, 0))], by_spans=False, show='intersections')


def test_what_is_too_much_or_nothing_is_refused():
    line = sc.BezierCurve([(0, 0), (1, 1)])
    for call, said in ((lambda: drawn([line] * 400), "400 hulls: 300 are the most"), (lambda: drawn([line], show='intersections'), "no two neighboring hulls"),
                       (lambda: drawn([sc.NurbsCurve(1, [0, *range(2600), 2599], np.random.default_rng(1).uniform(-1, 1, (2600, 3)))], False), "2000 are the most"),
                       (lambda: drawn([sc.BezierCurve([(1, 1)] * 3)], radius=0.0), "all hulls are points")):
        with pytest.raises(FAILURES.Refusal, match=said):
            call()
    assert len(drawn([sc.BezierCurve([(1, 1)] * 3)])[0]) == 1


def test_hulls_that_meet_in_rounding_alone_have_a_point_in_common():
    """Neighboring spans of cubics that share one point, which lies on both hulls within rounding."""
    random = np.random.default_rng(77)
    for size in (1e-3, 1.0, 1e4):
        for _ in range(60):
            one, other = random.uniform(-size, size, (2, 4, 3))
            other[0] = one[3] + random.uniform(-2, 2, 3) * np.finfo(float).eps * size
            common = convex.intersection(convex.hull(one), convex.hull(other))
            assert common is None or len(common.corners) >= 1
