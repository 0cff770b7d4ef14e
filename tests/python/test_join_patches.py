"""Two patches brought together along a side of each, and what that leaves as it was (row S21)."""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import splinecore as sc
from random_patches import error, homogeneous, parameters, random_patch, sampled_distance
from seams import OPPOSITE, SIDES, curvature_across, jet, joinable, normals, pairs, rounding_of, unlikeness
from shapes import hermite_net, sphere_octant, torus, wavy_patch

COUNT = 1000
KINDS = ("C0", "G1", "C1", "G2", "C2")
ROWS = {"C0": 1, "G1": 2, "C1": 2, "G2": 3, "C2": 3}
MOVES = ("second", "first", "both")
NAN = math.nan


def square(origin=(0, 0, 0), a=(1, 0, 0), b=(0, 1, 0)):
    """A bilinear patch: u along a, v along b."""
    origin, a, b = (np.array(one, float) for one in (origin, a, b))
    return sc.BezierPatch([[origin, origin + b], [origin + a, origin + a + b]])


def edge_rows(patch, side):
    """Points and weights along a side of a clamped patch, (n, 4)."""
    net = np.concatenate([patch.points, patch.weights[..., None]], axis=-1)
    net = net if side[0] == "u" else net.swapaxes(0, 1)
    return net[-1 if side.endswith("end") else 0]


def join(*arguments):
    return sc.build.join_patches(*arguments)


def test_the_second_edge_goes_to_the_first_and_the_other_side_stays():
    done = join(square(), "u_end", square((1.5, 0, 1)), "u_start", "C0")
    assert isinstance(done, sc.JoinedPatches) and isinstance(done.second, sc.BezierPatch)
    assert done.first == square() and done.first_error == 0 and not done.reversed
    assert done.second.points.tolist() == [[[1, 0, 0], [1, 1, 0]], [[2.5, 0, 1], [2.5, 1, 1]]]
    far = math.hypot(0.5, 1)
    assert far <= done.second_error <= 1.02 * far


@pytest.mark.parametrize("moves", MOVES)
@pytest.mark.parametrize("kind", KINDS)
def test_the_caller_may_choose_the_direction_of_the_edge(kind, moves):
    def done_with(**options):
        return sc.build.join_patches(square(), "u_end", square((1.5, 0, 1)), "u_start", kind, moves, **options)

    assert not done_with().reversed and done_with(reversed=None).first == done_with().first
    for against in (False, True):
        done = done_with(reversed=against)
        assert done.reversed is against
        first, second = edge_rows(done.first, "u_end"), edge_rows(done.second, "u_start")
        assert np.abs(first - (second[::-1] if against else second)).max() <= 1e-15
        found = sc.seam_continuity(done.first, "u_end", done.second, "u_start", reversed=against)
        assert found.reversed is against and found.gap <= 1e-14


def test_both_edges_go_to_their_middle():
    done = join(square(), "u_end", square((1.5, 0, 1)), "u_start", "C0", "both")
    for patch, side in ((done.first, "u_end"), (done.second, "u_start")):
        assert edge_rows(patch, side).tolist() == [[1.25, 0, 0.5, 1], [1.25, 1, 0.5, 1]]
    assert 0.559 <= done.first_error <= 0.571 and 0.559 <= done.second_error <= 0.571


def test_a_first_derivative_across_takes_one_degree():
    """The row beside the edge lies half a leg of the first on: B_t = 2 (B_1 - B_0)."""
    second = join(square(), "u_end", square((1, 0, 0), (0, 0, 1)), "u_start", "C1").second
    assert second.degree == (2, 1)
    assert second.points[:, 0].tolist() == [[1, 0, 0], [1.5, 0, 0], [1, 0, 1]]


def test_a_second_derivative_across_takes_two_degrees():
    second = join(square(), "u_end", square((1, 0, 0), (0, 0, 1)), "u_start", "C2").second
    assert second.degree == (3, 1)
    assert np.allclose(second.points[:, 0], [[1, 0, 0], [4 / 3, 0, 0], [5 / 3, 0, 0], [1, 0, 1]], rtol=0, atol=1e-15)


def test_two_sides_of_a_box_get_one_tangent_plane():
    """k is that of the legs' lengths, because the nearest one would be 0."""
    done = join(square(), "u_end", square((1, 0, 0), (0, 0, 1)), "u_start", "G1")
    assert np.allclose(done.second.points[:, 0], [[1, 0, 0], [1.5, 0, 0], [1, 0, 1]], rtol=0, atol=1e-15)
    both = join(square(), "u_end", square((1, 0, 0), (0, 0, 1)), "u_start", "G1", "both")
    leg_a, leg_b = both.first.points[2] - both.first.points[1], both.second.points[1] - both.second.points[0]
    assert np.allclose(leg_a, leg_b, rtol=0, atol=1e-15) and np.allclose(leg_a[0], [0.25, 0, 0.25], rtol=0, atol=1e-15)


def test_another_pace_is_a_common_tangent_plane_and_not_a_common_derivative():
    first, second = square(), square((1, 0, 0), (3, 0, 0))
    assert join(first, "u_end", second, "u_start", "G1").second_error <= 1e-15
    assert join(first, "u_end", second, "u_start", "G2").second_error <= 1e-15
    assert 0.4 <= join(first, "u_end", second, "u_start", "C1").second_error <= 1.1


def test_the_nearer_ends_meet():
    first, second = square(), square((1.1, 0, 0)).reversed("v")
    done = join(first, "u_end", second, "u_start", "C0")
    assert done.reversed
    assert np.array_equal(edge_rows(done.second, "u_start")[::-1], edge_rows(done.first, "u_end"))
    ring = sc.build.cylinder((0, 0, 0), (0, 0, 1), 1, 1)
    above = sc.build.cylinder((0, 0, 1), (0, 0, 1), 1.2, 1)
    assert not join(ring, "v_end", above, "v_start").reversed
    assert join(ring, "v_end", above.reversed("u"), "v_start").reversed


def check(found_a, found_b, kind, size):
    """What is asked for, from derivatives alone. Relative to the largest of each kind."""
    def agree(a, b, least=0.0):
        return np.abs(a - b).max() <= 1e-9 * max(np.abs(a).max(), least)

    # What rounding of the parameter itself makes of a point where the edge is run along at such a pace.
    pace = max(np.abs(found[:, 0, 1]).max() for found in (found_a, found_b))
    assert np.abs(found_a[:, 0, 0] - found_b[:, 0, 0]).max() <= 1e-12 * size + 1e-14 * pace
    if kind in ("C1", "C2"):
        assert agree(found_a[:, 1, 0], found_b[:, 1, 0])
    if kind == "C2":
        assert agree(found_a[:, 2, 0], found_b[:, 2, 0], np.abs(found_a[:, 1, 0]).max())
    if kind in ("G1", "G2"):
        assert np.abs(normals(found_a) - normals(found_b)).max() <= 1e-9


def check_curvatures(measure, first, second):
    """Where an edge nearly stands still, or a patch nearly leaves it along it, they are rounding."""
    one, two = measure(first, second)
    rounding = rounding_of(measure, first, second, np.random.default_rng(9)).sum(axis=0)
    assert (np.abs(one - two) <= 1e-9 * np.abs(one).max() + 10 * rounding).all()
    return 1e6 * rounding.min() <= np.abs(one).max()


@pytest.mark.parametrize("kind", KINDS)
def test_a_thousand_pairs_meet_as_they_should(kind):
    rng = np.random.default_rng(70)
    known = 0
    for index, (first, side, second, other) in enumerate(pairs(71, COUNT)):
        done = join(first, side, second, other, kind, MOVES[index % 3])
        one, two = edge_rows(done.first, side), edge_rows(done.second, other)
        if not done.first.periodic["vu".index(side[0])]:
            assert np.array_equal(one, two[::-1] if done.reversed else two), index
        t = rng.uniform(0, 1, 12)
        size = max(np.abs(patch.points).max() for patch in (done.first, done.second))
        check(jet(done.first, side, t, True), jet(done.second, other, t, False, done.reversed), kind, size)
        if kind == "G2":
            known += check_curvatures(lambda one, two: (curvature_across(jet(one, side, t, True)), curvature_across(
                jet(two, other, t, False, done.reversed))), done.first, done.second)
        assert min(done.first.weights.min(), done.second.weights.min()) > 0, index
    assert kind != "G2" or known >= 0.99 * COUNT


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_not_to_move_stays(kind):
    """The patch that stays is the same surface; of one that moves the opposite side is the same curve."""
    for index, (first, side, second, other) in enumerate(pairs(72, 200)):
        moves = MOVES[index % 3]
        done = join(first, side, second, other, kind, moves)
        for name, patch, at, after, moved in (("first", first, side, done.first, done.first_error),
                                              ("second", second, other, done.second, done.second_error)):
            assert after.domain == patch.domain
            if moves not in (name, "both"):
                assert error(patch, after) <= 1e-12 and moved == 0, index
            before, curve = patch.boundary(OPPOSITE[at]), after.boundary(OPPOSITE[at])
            t = np.linspace(*before.domain, 30)[1:-1]
            assert np.abs(before.evaluate(t) - curve.evaluate(t)).max() <= 1e-12 * 10, index


@pytest.mark.parametrize("kind", KINDS)
def test_the_rows_that_move_are_as_few_as_the_derivatives(kind):
    rng = np.random.default_rng(73)
    for _ in range(40):
        first, second = (joinable(rng, "u_start", (3, 5), ends="clamped", spans=(2, 2)) for _ in "ab")
        second = sc.NurbsPatch(second.degree, (second.clamped("u").knots[0], second.knots[1]),
                               second.clamped("u").points)
        after = join(first, "u_start", second, "u_start", kind).second
        raised = second.elevate("v", after.degree[1] - second.degree[1])
        known = [knot for knot in after.knots[1] if knot not in raised.knots[1]]
        lines = raised.refine("v", known)
        if lines.points.shape == after.points.shape:
            assert np.abs(lines.points - after.points)[ROWS[kind]:].max() <= 1e-12 * 10


@pytest.mark.parametrize("moves", MOVES)
@pytest.mark.parametrize("kind", KINDS)
def test_the_errors_are_how_far_the_patches_moved(kind, moves):
    for first, side, second, other in pairs(74, 16, degrees=(1, 4), spans=(1, 2)):
        done = join(first, side, second, other, kind, moves)
        for before, after, bound in ((first, done.first, done.first_error), (second, done.second, done.second_error)):
            far = sampled_distance(before, after, 40)
            if bound > 1.05 * far + 1e-12:
                far = sampled_distance(before, after, 400)    # a narrow peak
            if bound > 0:
                assert far * (1 - 1e-12) - 1e-12 <= bound <= 1.05 * far + 1e-12
            else:
                assert far <= 1e-11


@pytest.mark.parametrize("moves", MOVES)
@pytest.mark.parametrize("kind", KINDS)
def test_the_halves_of_a_patch_come_out_as_they_were(kind, moves):
    rng = np.random.default_rng(75)
    for index in range(60):
        whole = random_patch(rng, degree=int(rng.integers(3, 7)), ends="clamped", spans=1)
        axis = "uv"[index % 2]
        one, two = whole.split(axis, float(np.mean(whole.domain[index % 2])))
        done = join(one, axis + "_end", two, axis + "_start", kind, moves)
        size = np.abs(whole.points).max()
        assert not done.reversed and max(done.first_error, done.second_error) <= 1e-12 * size, index
        assert error(one, done.first) <= 1e-12 and error(two, done.second) <= 1e-12
        # In another direction and with other weights, knots and parameters they are the halves they were.
        other = "vu"[index % 2]
        odd = two.reversed(other).with_domain(other, (3, 8)).with_weights(two.reversed(other).weights * 3)
        done = join(one, axis + "_end", odd, axis + "_start", kind, moves)
        assert done.reversed and max(done.first_error, done.second_error) <= 1e-12 * size, index


def test_moving_the_first_is_moving_the_second_of_the_pair_exchanged():
    for index, (first, side, second, other) in enumerate(pairs(76, 60)):
        kind = KINDS[index % 5]
        one, two = join(first, side, second, other, kind, "first"), join(second, other, first, side, kind)
        assert one.first == two.second and one.second == two.first
        assert (one.first_error, one.second_error) == (two.second_error, 0) and one.reversed == two.reversed


@pytest.mark.parametrize("kind", ["C0", "G1", "C1", "C2"])
def test_both_move_alike_whichever_is_the_first(kind):
    for first, side, second, other in pairs(77, 60, rational=False):
        one, two = join(first, side, second, other, kind, "both"), join(second, other, first, side, kind, "both")
        size = max(np.abs(one.first.points).max(), np.abs(one.second.points).max())
        # What rounding of a derivative of the side with short spans makes of long ones.
        rounding = 2.0 ** -52 * unlikeness(one.first, side, one.second, other) ** (ROWS[kind] - 1)
        allowed = (1e-11 + 100 * rounding) * size
        assert np.abs(one.first.points - two.second.points).max() <= allowed
        assert np.abs(one.second.points - two.first.points).max() <= allowed


@pytest.mark.parametrize("kind", ["C0", "C1", "C2"])
def test_no_smaller_move_of_the_rows_gives_the_same_continuity(kind):
    rng = np.random.default_rng(78)
    conditions = np.array([[0, 0, 1, -1, 0, 0], [0, -1, 1, 1, -1, 0], [1, -2, 1, -1, 2, -1]], float)
    conditions = conditions[:ROWS[kind]]
    for _ in range(30):
        first, second = (sc.BezierPatch(rng.uniform(-1, 1, (6, 4, 3))) for _ in "ab")
        done = join(first, "u_end", second, "u_start", kind, "both")
        turned = second.points[:, ::-1] if done.reversed else second.points
        result = done.second.points[:, ::-1] if done.reversed else done.second.points
        rows = np.concatenate([first.points[3:], turned[:3]]).reshape(6, -1)
        expected = np.linalg.lstsq(conditions, -conditions @ rows, rcond=None)[0]
        moves = np.concatenate([done.first.points[3:], result[:3]]).reshape(6, -1) - rows
        assert np.abs(moves - expected).max() <= 1e-12


def test_no_other_ratio_moves_the_second_less():
    """Of rows beside the edge that lie about a multiple of the first's legs on."""
    rng = np.random.default_rng(79)
    for _ in range(30):
        first = sc.BezierPatch(rng.uniform(-1, 1, (4, 4, 3)))
        second = rng.uniform(-1, 1, (4, 4, 3))
        second[0] = first.points[3]
        legs = first.points[3] - first.points[2]
        second[1] = second[0] + rng.uniform(0.3, 3) * legs + rng.uniform(-0.1, 0.1, (4, 3))
        moved = join(first, "u_end", sc.BezierPatch(second), "u_start", "G1").second.points[1] - second[1]
        others = second[0] + np.linspace(0.1, 5, 500)[:, None, None] * legs - second[1]
        assert (moved ** 2).sum() <= (others ** 2).sum(axis=(1, 2)).min() + 1e-15


def test_weights_that_are_positive_stay_so():
    for index, (first, side, second, other) in enumerate(pairs(80, 300, rational=True)):
        done = join(first, side, second, other, KINDS[index % 5], MOVES[index % 3])
        assert done.first.weights.min() > 0 and done.second.weights.min() > 0
    for first, side, second, other in pairs(81, 60, rational=False):
        done = join(first, side, second, other, KINDS[index % 5], MOVES[index % 3])
        assert not done.first.is_rational and not done.second.is_rational


def with_near(curve, places):
    """Homogeneous points there, and as near to them as rounding of a parameter is, and a little more."""
    step = 4 * np.spacing(np.abs(curve.domain).max())
    return (sc.basis.Samples(curve.knot_vector, at).apply(curve.homogeneous_points) for at in (places, places + step))


def test_weights_of_any_sign_meet_in_homogeneous_points():
    met = 0
    for index, (first, side, second, other) in enumerate(pairs(82, 200, rational=True, positive=False)):
        try:
            done = join(first, side, second, other, KINDS[index % 5], MOVES[index % 3])
        except sc.InvalidShape as refused:
            assert "lies at infinity" in str(refused) or "not finite" in str(refused)
            continue
        met += 1
        one, two = done.first.boundary(side), done.second.boundary(other)
        t = parameters(done.first, axis="vu"["uv".index(side[0])])[1:-1]
        i, j = 1 - "uv".index(side[0]), 1 - "uv".index(other[0])
        share = (t - done.first.domain[i][0]) / np.diff(done.first.domain[i])[0]
        start, end = done.second.domain[j]
        there = start + (1 - share if done.reversed else share) * (end - start)
        (on_one, near_one), (on_two, near_two) = with_near(one, t), with_near(two, there)
        allowed = 1e-12 * np.abs(one.homogeneous_points).max() + np.abs(on_one - near_one) + np.abs(on_two - near_two)
        assert (np.abs(on_one - on_two) <= allowed).all(), index
    assert met >= 190


def test_a_period_along_the_edge_stays_one_if_both_have_it():
    for index, (first, side, second, other) in enumerate(pairs(83, 80, ends="periodic")):
        done = join(first, side, second, other, KINDS[index % 5])
        along = 1 - "uv".index(side[0]), 1 - "uv".index(other[0])
        assert done.first.periodic[along[0]] and done.second.periodic[along[1]]
        assert done.first.points.shape[along[0]] == done.second.points.shape[along[1]]
    plain = join(wavy_patch(), "u_end", wavy_patch().clamped("v"), "u_start")
    assert not plain.first.periodic[1] and not plain.second.periodic[1]


def test_a_set_of_the_two_patches_shares_the_edge():
    for index, (first, side, second, other) in enumerate(pairs(84, 48, ends="clamped")):
        done = join(first, side, second, other, KINDS[index % 5], MOVES[index % 3])
        assert sc.PatchSet.from_patches([done.first, done.second]).edge_counts()["shared"] >= 1, index


def test_every_kind_of_patch_joins():
    octant, net, ring = sphere_octant(), hermite_net(), torus().split("u", 1.0)[0]
    for first, second in ((octant, net), (net, octant), (net, net), (ring, net), (octant, ring)):
        done = join(first, "u_end", second, "u_start")
        assert isinstance(done.first, sc.NurbsPatch) and isinstance(done.second, sc.NurbsPatch)
        assert sc.seam_continuity(done.first, "u_end", done.second, "u_start").g >= 1
    bent = join(octant, "u_end", octant, "u_start", "C2")
    assert isinstance(bent.first, sc.BezierPatch) and isinstance(bent.second, sc.BezierPatch)


def test_patches_of_the_teapot_get_tangent_planes():
    path = Path(__file__).parents[2] / "addon" / "splinewright" / "core" / "shape" / "teapot.json"
    data = json.loads(path.read_text("utf-8"))
    body = [sc.BezierPatch(np.array(data["points"])[np.reshape(rows, (4, 4))]) for rows in data["patches"]][4:8]
    above, below = body[0], body[1]
    found = [(one, other) for one in SIDES for other in SIDES if above.continuity_to(one, below, other).c >= 0]
    (side, other), = found
    done = join(above, side, below, other, "G2", "both")
    assert done.first.continuity_to(side, done.second, other).g == 2
    assert max(done.first_error, done.second_error) <= 0.05


def test_the_words_may_be_small():
    assert join(square(), "u_end", square((1, 0, 1)), "u_start", "c1").second == (
        join(square(), "u_end", square((1, 0, 1)), "u_start", "C1").second)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [2.0 ** -830, 2.0 ** -332, 2.0 ** 332, 2.0 ** 830])
def test_joining_does_not_depend_on_the_units(kind, scale):
    for first, side, second, other in pairs(85, 12):
        small = join(first, side, second, other, kind, "both")
        large = join(first.with_points(first.points * scale), side, second.with_points(second.points * scale), other,
                     kind, "both")
        for name in ("first", "second"):
            assert np.array_equal(getattr(large, name).points / scale, getattr(small, name).points)
            assert getattr(large, name + "_error") / scale == getattr(small, name + "_error")


def test_joining_does_not_depend_on_the_place():
    """Beyond the digits that points have left there."""
    rng = np.random.default_rng(87)
    for index, (first, side, second, other) in enumerate(pairs(86, 60)):
        kind, moves, there = KINDS[index % 5], MOVES[index % 3], np.array([3e6, -1e6, 2e6])
        first, second = first.clamped(side[0]), second.clamped(other[0])
        near = join(first, side, second, other, kind, moves)
        far = join(first.with_points(first.points + there), side, second.with_points(second.points + there), other,
                   kind, moves)

        def moved(one, two):
            done = join(one, side, two, other, kind, moves)
            return max(np.abs(getattr(done, name).points - getattr(near, name).points).max() for name in ("first", "second"))

        digits = 2.0 ** -52 * 3e6 * unlikeness(near.first, side, near.second, other) ** (ROWS[kind] - 1)
        rounding = digits + rounding_of(moved, first, second, rng, size=3e6)
        for one, two in ((far.first, near.first), (far.second, near.second)):
            assert np.abs(one.points - there - two.points).max() <= 1000 * rounding, index


def cone_tip():
    return sc.build.cone((0, 0, 0), (0, 0, 1), 1, 1)


INFINITE = sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, [[(0, 0, 0), (1, 0, 0)], [(0, 0, 1), (0, 1, 1)]],
                         [[1, 1], [0, 0]])
FLAT = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(0, 0, 0), (0, 1, 0)]])
REFUSED = [
    ((square(), "u", square(), "u_start"), "first_side = 'u' is not 'u_start', 'u_end', 'v_start' or 'v_end'"),
    ((square(), "u_end", square(), 2), "second_side = 2 is not 'u_start'"),
    ((square(), None, square(), "u_end"), "first_side = None"),
    ((square(), "u_end", square(), "u_start", "C3"), "continuity = 'C3' is not 'C0', 'C1', 'G1', 'C2' or 'G2'"),
    ((square(), "u_end", square(), "u_start", ""), "continuity = ''"),
    ((square(), "u_end", square(), "u_start", 1), "continuity = 1"),
    ((square(), "u_end", square(), "u_start", "C1", "none"), "moves = 'none' is not 'second', 'first' or 'both'"),
    ((square(), "u_end", square(), "u_start", "C1", None), "moves = None"),
    ((wavy_patch(), "v_end", square(), "u_start"), "side 'v_end' of the first patch is the seam of a periodic"),
    ((square(), "u_end", wavy_patch(), "v_start"), "side 'v_start' of the second patch is the seam of a periodic"),
    ((sphere_octant(), "v_end", square(), "u_start"), "side 'v_end' of the first patch is one point"),
    ((square(), "u_end", sphere_octant(), "v_end", "C0"), "side 'v_end' of the second patch is one point"),
    ((INFINITE, "u_end", square(), "u_start"), "side 'u_end' of the first patch lies at infinity"),
    ((square(), "u_start", INFINITE, "u_end", "C0", "first"), "side 'u_end' of the second patch lies at infinity"),
    ((FLAT, "u_end", square(), "u_start", "G1"), "leaves the edge in no direction"),
    ((square(), "u_start", FLAT, "u_start", "G2", "both"), "leaves the edge in no direction"),
]


@pytest.mark.parametrize("number", range(len(REFUSED)))
def test_what_cannot_be_joined_is_refused_in_a_sentence(number):
    arguments, sentence = REFUSED[number]
    with pytest.raises(sc.InvalidShape, match=sentence):
        join(*arguments)


@pytest.mark.parametrize("bad", [None, 3, "patch", [square()], sc.PatchSet.from_patches([square()])])
def test_what_is_no_patch_raises_type_error(bad):
    with pytest.raises(TypeError, match="first must be a patch"):
        join(bad, "u_end", square(), "u_start")
    with pytest.raises(TypeError, match="second must be a patch"):
        join(square(), "u_end", bad, "u_start")
    with pytest.raises(TypeError):
        sc.JoinedPatches()


def test_knots_that_the_other_domain_cannot_tell_apart_are_refused():
    fine = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1e-15, 2e-15, 1, 1]), np.random.default_rng(1).random((2, 4, 3)))
    wide = sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [1000, 1000, 1001, 1001]), square().points)
    with pytest.raises(sc.InvalidShape, match="the other cannot tell them apart"):
        join(fine, "u_end", wide, "u_start", "C0")


def test_a_flat_patch_can_still_share_an_edge_and_a_derivative():
    for kind in ("C0", "C1"):
        assert join(square(), "u_end", FLAT, "u_start", kind).second.points.shape[1] == 2


def test_joining_changes_neither_patch():
    first, second = square(), square((2, 0, 0))
    points = first.points.copy(), second.points.copy()
    join(first, "u_end", second, "u_start", "C2", "both")
    assert np.array_equal(first.points, points[0]) and np.array_equal(second.points, points[1])
    assert homogeneous(first, [0.0], [0.0]).shape == (1, 1, 4)
