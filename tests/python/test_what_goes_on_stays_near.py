"""Blends, lofts and extensions of wild patches: none shoots out beside what it goes on from, and as much is added as was asked for."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

SIDES = ("u_start", "u_end", "v_start", "v_end")


def knots_of(rng, degree):
    count = int(rng.choice([0, 1, 3, 12]))
    inner = np.sort(rng.uniform(0.03, 0.97, count))
    if count > 1 and rng.random() < 0.3:
        inner[1] = inner[0] + 10.0**rng.uniform(-8, -3)
    inner = np.sort(inner)
    return np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)], count + degree + 1


def wavy(rng):
    """A patch of any degrees, knots and proportions, some of them rough, some rational."""
    degrees = [int(rng.integers(1, 8)) for _ in "uv"]
    (along, n), (across, m) = (knots_of(rng, degree) for degree in degrees)
    means = [np.array([knots[i + 1:i + 1 + degree].mean() for i in range(count)])
             for knots, degree, count in ((along, degrees[0], n), (across, degrees[1], m))]
    x, y = np.meshgrid(*means, indexing="ij")
    z = 0.15 * np.sin(rng.uniform(0.5, 3) * x + rng.uniform(0, 6)) * np.cos(rng.uniform(0.5, 3) * y)
    aspect = 10**rng.uniform(-1, 1)
    points = np.stack([aspect * x, y, min(1, aspect) * (z + rng.choice([0, 0, 0.01]) * rng.normal(size=x.shape))], -1)
    return sc.NurbsPatch(degrees, (along, across), points, np.exp(rng.normal(0, 0.4, x.shape)) if rng.random() < 0.4 else None)


def moved(rng):
    return np.c_[np.linalg.qr(rng.normal(size=(3, 3)))[0] * np.exp(rng.normal(0, 0.3)), rng.normal(0, 2, 3)]


def reach(patch, around):
    """How far it reaches from the middle of some points, by how far these do."""
    points = patch.evaluate_grid(*(np.linspace(*domain, 41) for domain in patch.domain)).reshape(-1, 3)
    middle = around.mean(0)
    return np.linalg.norm(points - middle, axis=1).max() / np.linalg.norm(around - middle, axis=1).max()


def drawn(rng):
    a, b = wavy(rng), wavy(rng).transformed(moved(rng))
    sides = [str(side) for side in rng.choice(SIDES, 2)]
    around = np.concatenate([patch.boundary(side).evaluate(np.linspace(0, 1, 60)) for patch, side in zip((a, b), sides)])
    return a, sides[0], b, sides[1], around


def test_blends_do_not_shoot_out(inputs):
    """With curvatures and how these change, beside patches that bend sharply: 11,000 times as far as their sides before."""
    made_count, refused = 0, 0
    for seed in range(inputs(600)):
        rng = np.random.default_rng([seed, 81])
        a, side_a, b, side_b, around = drawn(rng)
        word = str(rng.choice(["G1", "G2", "G3"]))
        try:
            made = build.blend_patches(a, side_a, b, side_b, word)
        except (sc.InvalidShape, sc.ToleranceNotReached) as error:
            assert len(str(error)) > 20
            refused += 1
            continue
        made_count += 1
        assert reach(made, around) <= 5, seed
        for patch, side, own in ((a, side_a, "v_start"), (b, side_b, "v_end")):
            seam = sc.seam_continuity(patch, side, made, own)
            assert seam.gap <= 1e-9 and seam.angle <= 2e-4, seed
    assert refused <= 0.2 * (made_count + refused)


def test_lofts_between_neighbors_do_not_shoot_out(inputs):
    made_count = 0
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, 82])
        a, side_a, b, side_b, around = drawn(rng)
        middle = wavy(rng).transformed(moved(rng)).boundary("v_start")
        around = np.concatenate([around, middle.evaluate(np.linspace(0, 1, 60))])
        ends = [(patch, side, str(rng.choice(["G1", "G2"]))) for patch, side in ((a, side_a), (b, side_b))]
        try:
            made = build.loft([middle], start_neighbor=ends[0], end_neighbor=ends[1]).value
        except (sc.InvalidShape, sc.ToleranceNotReached) as error:
            assert len(str(error)) > 20
            continue
        made_count += 1
        assert reach(made, around) <= 6, seed
    assert made_count > 0


def test_a_patch_is_made_longer_by_the_mean_of_all_its_lines(inputs):
    """Where weights differ much some lines are far longer than the others."""
    made_count = 0
    for seed in range(inputs(200)):
        rng = np.random.default_rng([seed, 83])
        patch, side, length = wavy(rng), str(rng.choice(SIDES)), float(10**rng.uniform(-2, 0.3))
        try:
            made = build.extend_patch(patch, side, length, str(rng.choice(["natural", "straight"])))
        except sc.InvalidShape as error:
            assert "infinity" in str(error) or "stands still" in str(error)
            continue
        made_count += 1
        axis = "uv".index(side[0])
        before, after = patch.domain[axis], made.domain[axis]
        part = (before[1], after[1]) if side.endswith("end") else (after[0], before[0])
        places = [np.linspace(*part, 200), np.linspace(*made.domain[1 - axis], 801)]
        grid = made.evaluate_grid(*(places if axis == 0 else places[::-1]))
        lines = np.linalg.norm(np.diff(grid, axis=axis), axis=-1).sum(axis)
        assert abs(lines.mean() / length - 1) <= 0.1, seed      # of 64 lines, one of which may be 19 times as long
    assert made_count > 0.5 * inputs(200)


def test_a_loft_says_with_how_much_of_the_strength_it_follows(inputs):
    """With that part asked for, and no more calmed, it is the same surface; with what is asked for it is refused."""
    less = 0
    for seed in range(inputs(200)):
        rng = np.random.default_rng([seed, 84])
        a, side_a, b, side_b, _ = drawn(rng)
        strength, word = float(10**rng.uniform(-0.5, 0.5)), str(rng.choice(["G1", "G2", "G3"]))

        def made(part, **options):
            return build.loft([], start_neighbor=(a, side_a, word, part * strength), end_neighbor=(b, side_b, word, part * strength), **options)

        try:
            found = made(1)
        except (sc.InvalidShape, sc.ToleranceNotReached):
            continue
        value, error = found
        assert value is not None and error == found.error and found.followed in 0.5**np.arange(9)
        asked = made(found.followed, calm=False)
        assert asked.followed == 1 and np.array_equal(asked.value.points, found.value.points), seed
        if found.followed == 1:
            continue
        less += 1
        for refused in (lambda: made(1, calm=False), lambda: made(2 * found.followed, calm=False),
                        lambda: build.blend_patches(a, side_a, b, side_b, word, strength, calm=False)):
            with pytest.raises(sc.InvalidShape):
                refused()
    assert less > 0.03 * inputs(200)
