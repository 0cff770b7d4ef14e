"""Patches that go on from others, and that are made longer: measured along the seam, in closed form, and refused."""

import numpy as np
import pytest

import splinecore as sc
from random_patches import random_patches
from splinecore import build


def bumpy(seed, at=0.0, rational=False, degree=3, count=6):
    rng = np.random.default_rng(seed)
    net = np.dstack([*np.meshgrid(at + np.arange(float(count)), np.arange(float(count)), indexing="ij"), rng.normal(0, .3, (count, count))])
    knots = [0.0] * (degree + 1) + list(np.linspace(0, 1, count - degree + 1)[1:-1]) + [1.0] * (degree + 1)
    return sc.NurbsPatch((degree, degree), (knots, knots), net, rng.uniform(.8, 1.25, (count, count)) if rational else None)


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("word, g", [("G0", 0), ("G1", 1), ("G2", 2), ("G3", 2)])
def test_a_side_goes_on(word, g, rational):
    for seed in range(10):
        a, b = bumpy(seed, 0, rational), bumpy(seed + 50, 5, rational)
        made, moved = build.match_patch(b, "u_start", a, "u_end", word)
        seam = sc.seam_continuity(a, "u_end", made, "u_start")
        assert seam.g >= g and np.isfinite(moved)
        assert made.domain == b.domain


def test_g3_has_the_third_derivatives_up_to_the_pace():
    a, b = bumpy(1), bumpy(2, 5)
    made, _ = build.match_patch(b, "u_start", a, "u_end", "G3")
    v = np.linspace(0, 1, 17)
    end, start = a.derivatives(np.ones(17), v, 3), made.derivatives(np.zeros(17), v, 3)
    share = lambda of, by: (of * by).sum() / (by * by).sum()
    one, two, three = (end[:, k, 0] for k in (1, 2, 3))
    pace = share(start[:, 1, 0], one)
    gain = share(start[:, 2, 0] - pace**2 * two, one)
    last = share(start[:, 3, 0] - pace**3 * three - 3 * pace * gain * two, one)
    for found, wanted in zip((start[:, k, 0] for k in (1, 2, 3)), (
            pace * one, pace**2 * two + gain * one, pace**3 * three + 3 * pace * gain * two + last * one)):
        assert np.abs(found - wanted).max() <= 1e-9 * max(np.abs(end[:, k, 0]).max() for k in (1, 2, 3))


def mirrored_pair(rng):
    """A half of a body that leaves the plane x = 0 at nearly right angles, and its mirror image."""
    degree, inner = rng.integers(2, 7, 2), rng.integers(1, 5, 2)
    knots = [np.concatenate([[0.0] * (d + 1), np.sort(rng.uniform(0.1, 0.9, n)), [1.0] * (d + 1)]) for d, n in zip(degree, inner)]
    u, v = np.meshgrid(np.linspace(0, 1, degree[0] + 1 + inner[0]), np.linspace(0, 3, degree[1] + 1 + inner[1]), indexing="ij")
    points = np.stack([u, v, 0.5 - 0.4 * u**2 + 0.1 * v - 0.05 * v * v], -1)
    points[2:] += rng.uniform(-0.05, 0.05, points[2:].shape)
    points[1] += rng.uniform(-0.013, 0.013, points[1].shape) * points[1, :, :1]      # some 0.7 degrees
    weights = rng.uniform(0.5, 2, u.shape) if rng.random() < 0.4 else None
    return [sc.NurbsPatch(degree.tolist(), knots, points * way, weights) for way in ([1, 1, 1], [-1, 1, 1])]


@pytest.mark.parametrize("word", ["G1", "G2"])
def test_halves_that_nearly_fit_move_no_more_than_a_join_moves_them(word, inputs):
    ratios = []
    for seed in range(inputs(1000)):
        a, b = mirrored_pair(np.random.default_rng(seed))
        made, moved = build.match_patch(b, "u_start", a, "u_start", word)
        joined = build.join_patches(a, "u_start", b, "u_start", word, "second")
        assert moved <= (1 + 1e-9 if word == "G1" else 2.1) * joined.second_error + 1e-12
        ratios.append(moved / joined.second_error)
        assert sc.seam_continuity(a, "u_start", made, "u_start").g >= int(word[1])
        v = np.linspace(*b.domain[1], 5)
        assert np.abs(made.evaluate(np.full(5, 1.0), v) - b.evaluate(np.full(5, 1.0), v)).max() < 1e-12
    assert np.median(ratios) <= 1 + 1e-9 and np.quantile(ratios, 0.95) < 1.2


def test_a_half_that_is_off_by_less_than_a_degree_keeps_its_corner():
    """A body 3 long and 0.7 degrees off at its edge, wider towards one end."""
    knots = [0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1], [0, 0, 0, 0, 0.5, 1, 1, 1, 1]
    u, v = np.meshgrid([0, 0.1, 0.3, 0.6, 0.9, 1.0], np.linspace(0, 3, 5), indexing="ij")
    points = np.stack([u * (1 + 0.3 * v), v, 1 - u**2], -1)
    points[1, :, 2] -= 0.0003 * (1 + v[1])
    a = sc.NurbsPatch((3, 3), knots, points)
    b = sc.NurbsPatch((3, 3), knots, points * [-1, 1, 1])
    for word in ("G1", "G2"):
        made, moved = build.match_patch(b, "u_start", a, "u_start", word)
        joined = build.join_patches(a, "u_start", b, "u_start", word, "second")
        assert moved <= 1.01 * joined.second_error and moved < 0.04


@pytest.mark.parametrize("word", ["G0", "G1", "G2", "G3"])
def test_random_matches_are_bounded_and_as_smooth_as_they_say(word, inputs):
    made = 0
    for seed in range(inputs(250)):
        rng = np.random.default_rng([seed, int(word[1])])
        a, b = mirrored_pair(rng)
        apart = b.with_points(b.points + rng.uniform(-0.2, 0.2, 3) + rng.uniform(-0.05, 0.05, b.points.shape))
        strength = float(rng.choice([0.5, 1.0, 1.0, 2.0]))
        try:
            found, moved = build.match_patch(apart, "u_start", a, "u_start", word, strength=strength)
        except sc.Error as error:
            assert "patch" in str(error) or "weights" in str(error)
            continue
        made += 1
        size = np.linalg.norm(np.ptp(apart.points.reshape(-1, 3), axis=0))
        assert np.isfinite(moved) and (strength > 1 or moved <= (1.0 if word < "G2" else 10.0) * size), (seed, moved)
        assert sc.seam_continuity(a, "u_start", found, "u_start").g >= min(int(word[1]), 2)
    assert made > 0.9 * inputs(250)


@pytest.mark.parametrize("side", ["u_start", "u_end", "v_start", "v_end"])
@pytest.mark.parametrize("onto", ["u_start", "u_end", "v_start", "v_end"])
@pytest.mark.parametrize("reversed", [None, True, False])
def test_every_side(side, onto, reversed):
    a, b = bumpy(1), bumpy(2, 5)
    made, _ = build.match_patch(b, side, a, onto, "G2", reversed=reversed)
    assert sc.seam_continuity(a, onto, made, side, reversed=reversed).g == 2


def test_rows_say_what_may_move():
    a, b = bumpy(1, count=9), bumpy(2, 8, count=9)
    few, _ = build.match_patch(b, "u_start", a, "u_end", "G1")
    many, _ = build.match_patch(b, "u_start", a, "u_end", "G1", rows=6)
    moved = lambda patch: np.abs(np.asarray(patch.points) - b.points).max(axis=(1, 2)) > 1e-14
    assert moved(few).tolist() == [True] * 2 + [False] * 7 and moved(many).tolist() == [True] * 6 + [False] * 3
    assert np.array_equal(many.points[:2], few.points[:2])
    bend = lambda patch: np.linalg.norm(np.diff(np.asarray(patch.points) - b.points, 2, axis=0))
    assert bend(many) < bend(few)


def test_a_patch_with_few_rows_is_raised():
    a = bumpy(1)
    made, _ = build.match_patch(build.ruled(*(sc.BezierCurve([(x, 0, 0), (x, 5, 1)]) for x in (5, 9))).swapped(), "u_start", a, "u_end", "G3")
    assert made.degree[0] >= 4 and sc.seam_continuity(a, "u_end", made, "u_start").g == 2
    assert np.abs(made.evaluate(1, np.linspace(0, 1, 5)) - np.linspace([9, 0, 0], [9, 5, 1], 5)).max() <= 1e-12


def test_random_pairs_are_matched_or_refused():
    made = 0
    pairs = list(random_patches(11, 400, positive=True, ends="clamped"))
    for a, b in zip(pairs[::2], pairs[1::2]):
        try:
            patch, _ = build.match_patch(b, "v_end", a, "v_start", "G1")
        except sc.InvalidShape:
            continue
        made += 1
        assert sc.seam_continuity(a, "v_start", patch, "v_end").angle <= 1e-5
    assert made > 150


@pytest.mark.parametrize("more, words", [
    ({"continuity": "G4"}, "G4"), ({"rows": 1}, "rows"), ({"strength": 0.0}, "strength"), ({"strength": np.inf}, "strength"),
])
def test_bad_numbers_of_a_match(more, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.match_patch(bumpy(1), "u_start", bumpy(2), "u_end", **more)


def test_seams_and_points_are_no_sides():
    ring = build.cylinder((0, 0, 0), (0, 0, 1), 1, 1)
    with pytest.raises(sc.InvalidShape, match="seam"):
        build.match_patch(ring, "u_start", bumpy(1), "u_end")
    with pytest.raises(sc.InvalidShape, match="seam"):
        build.match_patch(bumpy(1), "u_start", ring, "u_end")


@pytest.mark.parametrize("side", ["u_start", "u_end", "v_start", "v_end"])
@pytest.mark.parametrize("rational", [False, True])
def test_natural_extension_is_the_same_polynomial(side, rational):
    patch = bumpy(3, rational=rational)
    made = build.extend_patch(patch, side, 0.3)
    u, v = (np.linspace(*domain, 21) for domain in patch.domain)
    assert np.abs(made.evaluate_grid(u, v) - patch.evaluate_grid(u, v)).max() <= 1e-12
    axis, at_end = "uv".index(side[0]), side.endswith("end")
    start, end = made.domain[axis]
    assert (start == patch.domain[axis][0]) is at_end and (end == patch.domain[axis][1]) is not at_end
    added = made.split("uv"[axis], patch.domain[axis][at_end])[at_end]
    first, last = added.domain[1 - axis]
    lines = [added.isocurve("vu"[axis], first + (last - first) * (k + 0.5) / 500).length() for k in range(500)]
    assert np.mean(lines) == pytest.approx(0.3, rel=1e-3)
    assert sc.seam_continuity(added, side[:2] + ("start" if at_end else "end"), made.split("uv"[axis], patch.domain[axis][at_end])[not at_end],
                                 side).g == 2


def test_a_cylinder_grows_as_a_cylinder():
    made = build.extend_patch(build.cylinder((0, 0, 0), (0, 0, 1), 1, 2), "v_end", 0.7)
    points = made.evaluate_grid(np.linspace(*made.domain[0], 33), np.linspace(*made.domain[1], 9)).reshape(-1, 3)
    assert np.abs(np.hypot(points[:, 0], points[:, 1]) - 1).max() <= 1e-14
    assert points[:, 2].max() == pytest.approx(2.7, abs=1e-9)


@pytest.mark.parametrize("degree", [1, 2, 3, 5])
def test_straight_extensions_are_straight(degree):
    patch = bumpy(4, degree=degree, count=7)
    made = build.extend_patch(patch, "u_end", 0.5, "straight")
    for v in (0.0, 0.37, 1.0):
        beyond = made.evaluate(np.linspace(1, made.domain[0][1], 5), np.full(5, v))
        step = np.diff(beyond, axis=0)
        assert np.abs(step - step[0]).max() <= 1e-12
        tangent = patch.derivatives(1.0, v, 1)[1, 0]
        assert np.linalg.norm(np.cross(tangent, step[0])) <= 1e-10


@pytest.mark.parametrize("patch, side, length, how, words", [
    (bumpy(1), "u_end", 0.0, "natural", "length"),
    (bumpy(1), "u_end", np.inf, "natural", "finite|length"),
    (bumpy(1), "u_end", 1e-16, "natural", "1e-16 is too short for a surface about"),
    (bumpy(1), "u_start", 1e100, "straight", "is too long for a surface about"),
    (build.cylinder((0, 0, 0), (0, 0, 1), 1, 1), "u_end", 1.0, "natural", "closed"),
    (bumpy(1), "u_end", 1.0, "arc", "arc"),
    (bumpy(1), "x", 1.0, "natural", "side"),
])
def test_what_cannot_grow_is_refused(patch, side, length, how, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.extend_patch(patch, side, length, how)


@pytest.mark.parametrize("how", ["straight", "natural"])
def test_what_lies_at_infinity_at_its_side_is_not_made_longer(how):
    """Random rational patches, one point of whose side, or all of it, is a direction."""
    rng = np.random.default_rng(51)
    for kind in range(60):
        degree = [int(rng.integers(1, 5)) for _ in "uv"]
        count = [p + 1 + int(rng.integers(0, 4)) for p in degree]
        knots = [np.r_[[0] * (p + 1), np.sort(rng.uniform(0, 1, n - p - 1)), [1] * (p + 1)] for p, n in zip(degree, count)]
        weights = 10 ** rng.uniform(-1.5, 1.5, count)
        weights[-1, slice(None) if kind % 3 == 0 else int(rng.integers(count[1]))] = 0
        patch = sc.NurbsPatch(degree, knots, rng.uniform(-1, 1, (*count, 3)), weights)
        with pytest.raises(sc.InvalidShape, match="runs to infinity at its side: it cannot be continued there"):
            build.extend_patch(patch, "u_end", 10 ** rng.uniform(-2, 1), how)
