"""Trimmed offsets: nowhere nearer than the distance, and whole, against offsets that are sampled densely."""

import numpy as np
import pytest

import splinecore as sc
from sharp_tips import are_under

KINDS = ["polygon", "closed polygon", "arcs", "spline", "rational", "periodic", "cusp", "there and back"]


def flat(points):
    points = np.asarray(points, float)
    return np.c_[points, np.zeros(len(points))]


def polygon(points):
    return sc.NurbsCurve(1, np.r_[0, np.arange(len(points)), len(points) - 1], flat(points))


def chain_of_arcs(rng, count):
    points, weights = [rng.uniform(-1, 1, 2)], [1.0]
    for _ in range(count):
        a, b, half = points[-1], rng.uniform(-1, 1, 2), rng.uniform(-1.2, 1.2)
        across = 0.5 * np.array([a[1] - b[1], b[0] - a[0]])
        points += [0.5 * (a + b) + np.tan(half) * across, b]
        weights += [np.cos(half), 1.0]
    return sc.NurbsCurve(2, np.r_[0, np.repeat(np.arange(count + 1), 2), count], flat(points), weights)


def spline(rng, weights):
    degree, more = int(rng.integers(2, 6)), int(rng.integers(0, 6))
    inner = np.sort(rng.uniform(0, 1, more))
    if more > 1 and rng.random() < 0.3:
        inner[1] = inner[0] + 1e-7
    count = degree + 1 + more
    knots = np.r_[[0] * (degree + 1), np.sort(inner), [1] * (degree + 1)]
    points = flat(rng.uniform(-1, 1, (count, 2)))
    return sc.NurbsCurve(degree, knots, points, 10 ** rng.uniform(-1, 1, count) if weights else None)


def random_curve(rng, kind):
    corners = rng.uniform(-1, 1, (int(rng.integers(3, 9)), 2))
    if rng.random() < 0.3:
        corners = np.unique(np.round(4 * corners) / 4, axis=0)
        rng.shuffle(corners)
        corners = corners if len(corners) > 2 else np.array([(0, 0), (1, 0), (1, 1)], float)
    if kind == "polygon":
        return polygon(corners)
    if kind == "closed polygon":
        return polygon(np.r_[corners, corners[:1]])
    if kind == "arcs":
        return chain_of_arcs(rng, int(rng.integers(2, 8)))
    if kind == "periodic":
        degree = int(rng.integers(2, 5))
        count = degree + int(rng.integers(2, 6))
        return sc.NurbsCurve(degree, np.arange(count + 1.0), flat(rng.uniform(-1, 1, (count, 2))), periodic=True)
    if kind == "cusp":
        return sc.BezierCurve(flat([(0, 0), (1, 1), (0, 1), (1, 0)]) * rng.uniform(0.5, 2, (1, 3))).to_nurbs()
    if kind == "there and back":
        return polygon(np.r_[corners[:3], corners[1:2]])
    return spline(rng, kind == "rational")


def by_spans(curve, each):
    knots = np.unique(curve.knots)
    start, end = curve.domain
    knots = np.unique(np.r_[start, knots[(knots > start) & (knots < end)], end])
    return np.concatenate([np.linspace(a, b, each) for a, b in zip(knots[:-1], knots[1:])])


def true_offset(curve, distance):
    """Places of the offset that belong to it, from normals of dense samples of each span."""
    found = []
    knots = np.unique(by_spans(curve, 2))
    for a, b in zip(knots[:-1], knots[1:]):
        u = a + (b - a) * np.linspace(0.002, 0.998, 60)
        points, slopes = (curve.derivatives(u, 1)[:, k] for k in (0, 1))
        speed = np.linalg.norm(slopes, axis=1)
        moves = speed > 1e-6 * speed.max()
        normals = np.c_[-slopes[:, 1], slopes[:, 0], 0 * speed][moves] / speed[moves, None]
        found.append(points[moves] + distance * normals)
    found = np.concatenate(found)
    return found[curve.nearest(found).distances >= abs(distance) * (1 - 1e-9)]


def random_task(seed):
    rng = np.random.default_rng([41, seed])
    curve = random_curve(rng, KINDS[seed % len(KINDS)])
    size = np.ptp(np.asarray(curve.points)[:, :2], axis=0).max()
    distance = size * 10 ** rng.uniform(-2, -0.3) * rng.choice([-1, 1])
    return rng, curve, distance, size * 10 ** rng.uniform(-6, -3)


def test_random_ones_are_nowhere_nearer_and_whole(inputs):
    made_some = 0
    for seed in range(inputs(1000)):
        rng, curve, distance, tolerance = random_task(seed)
        want = true_offset(curve, distance)
        try:
            corner = str(rng.choice(["round", "sharp"]))
            made = curve.offset(distance, tolerance=tolerance, trimmed=True, corner=corner)
        except sc.InvalidShape as error:
            assert "nothing is left" in str(error) and len(want) == 0, seed
            continue
        made_some += 1
        if corner == "sharp" and curve.degree == 1:
            want = want[~are_under(curve.points[:-1 if curve.is_closed else None, :2], -distance, want[:, :2], curve.is_closed)]
        nearest = min(curve.nearest(part.evaluate(by_spans(part, 40))).distances.min() for part in made)
        assert nearest >= abs(distance) - tolerance * (1 + 1e-6), seed
        if len(want):
            missing = np.min([part.nearest(want).distances for part in made], axis=0).max()
            assert missing <= tolerance, seed
    assert made_some > 0


def placed(points, matrix):
    return np.asarray(points) @ matrix[:3, :3].T + matrix[:3, 3]


@pytest.mark.parametrize("scale, far", [(1e-12, 0.0), (1e9, 0.0), (1.0, 1e5), (1e-3, 1e6)])
def test_moved_scaled_and_turned_they_are_the_same(inputs, scale, far):
    """Within the tolerance, and rounding of coordinates far away."""
    for seed in range(inputs(250)):
        rng, curve, distance, tolerance = random_task(10_000 + seed)
        angle = rng.uniform(0, 2 * np.pi)
        matrix = np.eye(4)
        matrix[:2, :2] = scale * np.array([(np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))])
        matrix[2, 2] = scale
        matrix[:2, 3] = far * scale * rng.uniform(-1, 1, 2)
        moved = curve.transformed(matrix)
        try:
            made = curve.offset(distance, tolerance=tolerance, trimmed=True)
        except sc.InvalidShape:
            continue
        try:
            other = moved.offset(distance * scale, tolerance=tolerance * scale, trimmed=True)
        except sc.InvalidShape as error:  # short spans have no direction where coordinates are rounded
            assert far and "tolerance: it is too small" in str(error), seed
            continue
        slack = tolerance + 1e-13 * far
        points = np.concatenate([placed(part.evaluate(by_spans(part, 9)), matrix) for part in made])
        alike = moved.nearest(points).distances >= (abs(distance) - 0.4 * tolerance) * scale
        if alike.any():
            missing = np.min([part.nearest(points[alike]).distances for part in other], axis=0).max()
            assert missing <= 1.5 * slack * scale, seed
        for part in other:
            nearest = moved.nearest(part.evaluate(by_spans(part, 20))).distances.min()
            assert nearest >= (abs(distance) - slack) * scale, seed


def test_reversed_they_are_on_the_other_side(inputs):
    for seed in range(inputs(200)):
        rng, curve, distance, tolerance = random_task(20_000 + seed)
        try:
            made = curve.offset(distance, tolerance=tolerance, trimmed=True)
        except sc.InvalidShape:
            continue
        other = curve.reversed().offset(-distance, tolerance=tolerance, trimmed=True)
        points = np.concatenate([part.evaluate(by_spans(part, 9)) for part in made])
        points = points[curve.nearest(points).distances >= abs(distance) - 0.4 * tolerance]
        if len(points):
            assert np.min([part.nearest(points).distances for part in other], axis=0).max() <= 1.5 * tolerance, seed


def test_a_slot_as_wide_as_two_distances_keeps_its_middle():
    """Both sides of it are offset to one line."""
    slot = polygon([(0, 0), (4, 0), (4, 1), (0, 1)])
    made = slot.offset(0.5, tolerance=1e-6, trimmed=True)
    middle = np.c_[np.linspace(0.1, 3.4, 30), np.full(30, 0.5), np.zeros(30)]
    assert np.min([part.nearest(middle).distances for part in made], axis=0).max() <= 1e-9


def rounded_slot(seed):
    """(a closed contour of segments and arcs that was stretched after its corners were rounded, a distance)."""
    rng = np.random.default_rng([43, seed])
    corners = np.array([(-2, -1, 0), (2, -1, 0), (2, 1, 0), (-2, 1, 0)]) + rng.uniform(-1, 1, (4, 3)) * (0.05, 0.05, 0) * (seed % 3)
    arc = sc.conics.arc_from_tangent(corners[1], corners[1] - corners[0], corners[2])
    sides = [sc.BezierCurve(corners[:2]), arc, sc.BezierCurve(corners[2:]), sc.BezierCurve(corners[[3, 0]])]
    whole = sc.build.join_curves(sides, 1e-9)[0].to_nurbs().rounded(rng.uniform(0.2, 0.4))
    points = np.asarray(whole.points) * (rng.uniform(1, 2), 1, 1)
    points = points.astype(np.float32).astype(float) if seed % 2 else points
    return (sc.NurbsCurve(whole.degree, whole.knots, points, whole.weights),
            rng.choice([-1, 1]) * rng.uniform(0.25, 0.5))


def test_where_pieces_go_on_as_one_another_there_is_no_loop(inputs):
    crossing = 0
    for seed in range(inputs(1000)):
        curve, distance = rounded_slot(seed)
        for part in curve.offset(distance, (0, 0, 1), trimmed=True, tolerance=1e-4):
            found = part.self_intersections()
            places = np.asarray(found.parameters)[~np.asarray(found.touches)]
            longest = max((np.ptp(part.evaluate(np.linspace(a, b, 20)), axis=0).max() for a, b in places), default=0.0)
            assert longest <= 1e-8, (seed, places)
            crossing += len(places) > 0
            assert curve.nearest(part.evaluate(by_spans(part, 20))).distances.min() >= abs(distance) - 1e-4


def test_loops_are_closed_in_every_bit(inputs):
    rng = np.random.default_rng(47)
    loops = 0
    for seed in range(inputs(40)):
        curve, distance = rounded_slot(seed)
        waists = np.array([(0, 0), (40, 0), (45, 10), (60, 10), (65, 0), (100, 0), (100, 60), (65, 60), (60, 48), (45, 48),
                           (40, 60), (0, 60)], float) + rng.uniform(-2, 2, (12, 2))
        pocket = sc.build.contour(np.c_[waists, np.zeros(12)], np.where(rng.random(12) < 0.5, rng.uniform(-0.4, 0.5, 12), 0),
                                  closed=True)
        for outline, by in ((curve, distance), (pocket, rng.uniform(3, 18)), (pocket, -rng.uniform(1, 5))):
            try:
                made = outline.offset(by, (0, 0, 1), trimmed=True)
            except sc.InvalidShape as error:
                assert "nothing is left" in str(error)
                continue
            for part in made:
                loops += 1
                assert part.is_closed, (seed, by)
                assert all(closed for _, closed in part.polylines(4))
                ends = part.evaluate(np.unique(part.knots))
                middle = part.evaluate((np.unique(part.knots)[1:] + np.unique(part.knots)[:-1]) / 2)
                longest = np.linalg.norm(middle - ends[:-1], axis=1) + np.linalg.norm(ends[1:] - middle, axis=1)
                assert longest.min() > 1e-12 * np.ptp(ends, axis=0).max()
    assert loops > inputs(40)


def area_within(curve):
    """What a closed curve in the plane z = 0 encloses."""
    return abs(sum(part.signed_area((0, 0, 1)) for part in curve))


def test_between_a_contour_and_its_offset_a_ring_is_filled(inputs):
    """Of few that were stretched, the offset comes back in parts, or turns back: that is said."""
    refused, count = 0, inputs(1000)
    for seed in range(count):
        curve, distance = rounded_slot(seed)
        made = curve.offset(distance, (0, 0, 1), trimmed=True, tolerance=1e-4)
        try:
            patches = sc.build.fill_rim([curve, *(part.to_nurbs() for part in made)]).value
        except sc.InvalidShape:
            refused += 1
            continue
        wanted = abs(area_within([curve]) - area_within(made))
        assert abs(sum(patch.area() for patch in patches) - wanted) <= 1e-7 * wanted, seed
    assert refused <= 0.01 * count
