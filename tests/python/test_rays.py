"""Rays on patches and sets: closed forms, the same places one by one, nothing lost, and bad calls."""

import numpy as np
import pytest

import splinecore as sc
from random_patches import random_patch
from splinecore import build

SPHERE = build.sphere((0, 0, 0), 1)
TORUS = build.torus((0, 0, 0), (0, 0, 1), 3, 1)
FLAT = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
LINES = (-np.inf, np.inf)


def directions(rng, count):
    found = rng.normal(size=(count, 3))
    return found / np.linalg.norm(found, axis=1)[:, None]


def size_of(patch):
    return np.abs(patch.points.reshape(-1, 3)).max()


def check(patch, origins, ways, found, roundings=256):
    """Every place is one of the patch and of its ray, up to so many roundings of what is largest."""
    rays = found.rays
    on_ray = origins[rays] + found.along[:, None] * ways[rays]
    on_patch = patch.evaluate(*found.parameters.T)
    scale = size_of(patch) + np.linalg.norm(origins[rays], axis=1)
    sharp = ~found.touches
    for a, b in ((on_ray, found.points), (on_patch, found.points)):
        apart = np.linalg.norm(a - b, axis=1)
        assert np.all(apart[sharp] <= roundings * 2.0**-52 * scale[sharp])
        assert np.all(apart <= 2.0**-30 * scale)


def test_a_sphere_is_met_where_the_equation_says():
    rng = np.random.default_rng(1)
    origins, ways = rng.uniform(-3, 3, (3000, 3)), directions(rng, 3000)
    found = SPHERE.rays(origins, ways, hits="all", limits=LINES)
    check(SPHERE, origins, ways, found)
    middle = -(origins * ways).sum(1)
    half = 1 - (origins**2).sum(1) + middle**2
    counts = np.bincount(found.rays, minlength=len(origins))
    clear = np.abs(half) > 1e-9
    assert np.array_equal(counts[clear], np.where(half > 0, 2, 0)[clear])
    for i in np.flatnonzero(clear & (half > 0)):
        own = found.along[found.rays == i]
        assert own == pytest.approx([middle[i] - np.sqrt(half[i]), middle[i] + np.sqrt(half[i])], abs=1e-9)
    assert not found.touches[clear[found.rays]].any() and np.array_equal(found.until, found.along)


def test_the_first_place_is_the_first_of_all():
    rng = np.random.default_rng(2)
    for patch in (SPHERE, TORUS, random_patch(rng)):
        origins = rng.uniform(-4, 4, (500, 3)) * size_of(patch)
        ways = directions(rng, 500) * rng.uniform(0.1, 10, (500, 1))
        every, first = patch.rays(origins, ways, hits="all"), patch.rays(origins, ways)
        for i in range(500):
            own = np.flatnonzero(every.rays == i)
            assert len(own) == 0 and np.isnan(first.along[i]) and first.patches[i] == -1 or (
                first.along[i] == every.along[own[0]] and np.array_equal(first.parameters[i], every.parameters[own[0]]))


def line_of(origin, way, reach):
    return sc.BezierCurve([origin - reach * way, origin + reach * way])


def test_wild_patches_are_met_where_lines_meet_them_one_by_one(inputs):
    """What the search for one curve and a patch finds, which goes another way."""
    met = 0
    for seed in range(inputs(200)):
        rng = np.random.default_rng([3, seed])
        patch = random_patch(rng)
        points = patch.points.reshape(-1, 3)
        low, high = points.min(0), points.max(0)
        origins, ways = rng.uniform(low, high, (12, 3)), directions(rng, 12)
        reach = 4 * np.linalg.norm(high - low)
        found = patch.rays(origins, ways, hits="all", limits=(-reach, reach))
        check(patch, origins, ways, found, roundings=4096)
        for i in range(12):
            want = line_of(origins[i], ways[i], reach).patch_intersections(patch)
            if want.touches.any() or len(want.overlaps):
                continue
            own = found.along[found.rays == i]
            met += len(own)
            assert own == pytest.approx((2 * want.parameters[:, 0] - 1) * reach, abs=1e-7 * reach), (seed, i)
    assert met > inputs(200)


def test_poles_seams_and_corners_are_met_once():
    for way in ((0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0.6, 0, 0.8)):
        found = SPHERE.rays((0, 0, 0), way, hits="all", limits=LINES)
        assert found.along == pytest.approx([-1, 1], abs=1e-12), way
        assert not found.touches.any()
    for corner in ((0, 0), (0, 1), (1, 0), (1, 1), (0.5, 0), (0, 0.5)):
        found = FLAT.rays((*corner, 1), (0, 0, -2), hits="all")
        assert found.along == pytest.approx([0.5]) and found.parameters[0] == pytest.approx(corner)
    assert np.isnan(FLAT.rays((1 + 1e-12, 0.5, 1), (0, 0, -1)).along)


def test_where_knots_are_a_ray_meets_the_patch_once():
    rng = np.random.default_rng(5)
    knots = [0, 0, 0, 1, 2, 3, 4, 4, 4]
    patch = sc.NurbsPatch((2, 2), (knots, knots), np.stack(np.broadcast_arrays(
        np.arange(6.0)[:, None], np.arange(6.0), rng.normal(size=(6, 6))), -1))
    places = np.array([(u, v) for u in range(5) for v in range(5)], float)
    origins = patch.evaluate(*places.T) + (0, 0, 5)
    found = patch.rays(origins, (0, 0, -1), hits="all")
    assert np.array_equal(found.rays, np.arange(len(origins)))
    assert found.along == pytest.approx(np.full(len(origins), 5.0), abs=1e-13)


def test_a_ray_that_touches_says_so():
    for angle in (0.0, 0.4, 2.0):
        out = np.array([np.cos(angle), np.sin(angle), 0])
        along = np.array([-np.sin(angle), np.cos(angle), 0])
        found = SPHERE.rays(out - 3 * along, along, hits="all")
        assert len(found.along) == 1 and found.touches[0]
        assert found.along[0] == pytest.approx(3, abs=1e-4)
        first = SPHERE.rays(out - 3 * along, along)
        assert first.touches and first.along == found.along[0]
        assert np.isnan(SPHERE.rays(1.00001 * out - 3 * along, along).along)


def test_a_ray_that_lies_on_a_patch_says_how_far():
    found = FLAT.rays((-1, 0.5, 0), (2, 0, 0), hits="all")
    assert found.along == pytest.approx([0.5]) and found.until == pytest.approx([1.0]) and found.touches[0]
    inner = FLAT.rays((0.25, 0.5, 0), (1, 0, 0))
    assert inner.along == 0 and inner.until == pytest.approx(0.75) and inner.parameters == pytest.approx((0.25, 0.5))
    assert FLAT.rays((0.25, 0.5, 0), (1, 0, 0), limits=(0.5, 0.6)).until == pytest.approx(0.6)
    tube = build.cylinder((0, 0, 0), (0, 0, 1), 1, 2)
    found = tube.rays((0.6, 0.8, -1), (0, 0, 1), hits="all")
    assert found.along == pytest.approx([1]) and found.until == pytest.approx([3])


def test_limits_are_in_multiples_of_the_directions():
    ways = np.array([0, 0, 2.0])
    assert SPHERE.rays((0, 0.1, -3), ways).along == pytest.approx(0.5 * (3 - np.sqrt(0.99)))
    assert SPHERE.rays((0, 0.1, 0), ways).along == pytest.approx(0.5 * np.sqrt(0.99))
    assert SPHERE.rays((0, 0.1, 0), ways, limits=LINES).along == pytest.approx(-0.5 * np.sqrt(0.99))
    assert np.isnan(SPHERE.rays((0, 0.1, 0), ways, limits=(0, 0.4)).along)
    at = SPHERE.rays((0.3, 0.1, -3), (0, 0, 1))
    again = SPHERE.rays(at.points, (0, 0, 1), hits="all")
    assert again.along == pytest.approx([0, -2 * at.points[2]], abs=1e-14) and again.along[0] >= 0
    assert len(SPHERE.rays(at.points, (0, 0, 1), hits="all", limits=(1e-9, np.inf)).along) == 1


def test_a_ray_has_the_same_bits_in_any_batch():
    rng = np.random.default_rng(7)
    origins, ways = rng.uniform(-4, 4, (4, 60, 3)), directions(rng, 60)
    whole = TORUS.rays(origins, ways, threads=2)
    assert whole.along.shape == (4, 60) and whole.parameters.shape == (4, 60, 2) and whole.points.shape == (4, 60, 3)
    assert np.array_equal(whole.rays.ravel(), np.arange(240))
    for i, j in ((0, 0), (2, 31), (3, 59)):
        one = TORUS.rays(origins[i, j], ways[j], threads=1)
        for name in ("along", "until", "parameters", "points", "touches", "patches"):
            assert np.array_equal(getattr(one, name), getattr(whole, name)[i, j], equal_nan=name not in ("touches",))
    none = TORUS.rays(np.empty((0, 3)), (0, 0, 1), hits="all")
    assert none.along.shape == (0,) and none.points.shape == (0, 3)


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1.0, 1e9, 1e150])
@pytest.mark.parametrize("shift", [0.0, 1e3])
def test_sizes_and_places_change_nothing(scale, shift):
    rng = np.random.default_rng(9)
    origins, ways = rng.uniform(-4, 4, (200, 3)), directions(rng, 200)
    moved = TORUS.translated((shift, shift, shift)).scaled(scale)
    want, found = TORUS.rays(origins, ways), moved.rays(scale * (origins + shift), scale * ways)
    assert np.array_equal(np.isnan(want.along), np.isnan(found.along))
    assert found.along == pytest.approx(want.along, abs=1e-8, nan_ok=True)


def test_from_far_away_rays_are_as_right_as_their_origins():
    rng = np.random.default_rng(11)
    ways = directions(rng, 200)
    for far in (1e3, 1e6, 1e9):
        aims = rng.uniform(-0.5, 0.5, (200, 3))
        origins = aims - far * ways
        found = SPHERE.rays(origins, ways, hits="all")
        assert np.array_equal(np.bincount(found.rays), np.full(200, 2))
        on_ray = origins[found.rays] + found.along[:, None] * ways[found.rays]
        assert np.linalg.norm(on_ray - found.points, axis=1).max() <= 64 * 2.0**-52 * far
        assert np.abs(np.linalg.norm(found.points, axis=1) - 1).max() <= 1e-14


def lens():
    def profile(height, bend):
        x = np.linspace(0, 20, 5)
        return sc.fit.interpolate(np.c_[x, 0 * x, height + bend * x**2]).value
    return [build.revolve(profile(*of), (0, 0, 0), (0, 0, 1)) for of in ((-5, 0.01), (5, -0.01))]


def test_of_a_set_each_patch_is_met_as_alone():
    rng = np.random.default_rng(13)
    patches = [*lens(), TORUS, FLAT.to_nurbs()]
    whole = sc.PatchSet.from_patches(patches)
    origins, ways = rng.uniform(-20, 20, (800, 3)), directions(rng, 800)
    found = whole.rays(origins, ways, hits="all")
    for number, patch in enumerate(patches):
        alone = patch.rays(origins, ways, hits="all")
        own = found.patches == number
        for name in ("rays", "along", "parameters", "points"):
            assert np.array_equal(getattr(found, name)[own], getattr(alone, name))
    first = whole.rays(origins, ways)
    for i in np.unique(found.rays):
        assert first.along[i] == found.along[found.rays == i].min()
    assert np.isnan(first.along).sum() == 800 - len(np.unique(found.rays))


def test_into_a_closed_body_a_ray_goes_as_often_as_out():
    rng = np.random.default_rng(17)
    corners = np.array([[[(x, y, z) for z in (0, 1)] for y in (0, 1)] for x in (0, 1)], float)
    faces = [corners[0], corners[1][::-1], corners[:, 0][::-1], corners[:, 1], corners[:, :, 0], corners[::-1, :, 1]]
    box = sc.PatchSet.from_patches([sc.BezierPatch(face) for face in faces])
    origins, ways = rng.uniform(0.05, 0.95, (2000, 3)), directions(rng, 2000)
    counts = np.bincount(box.rays(origins, ways, hits="all").rays, minlength=2000)
    assert np.all(counts == 1)
    assert np.all(np.bincount(box.rays(origins - 5 * ways, ways, hits="all").rays, minlength=2000) == 2)


def test_an_edge_of_two_patches_is_never_missed():
    """Rays through places of the common edge, however they are rounded, meet one patch at least."""
    rng = np.random.default_rng(19)
    for seed in range(40):
        row = rng.normal(size=(4, 3))
        one = sc.BezierPatch(np.stack([row + rng.normal(size=(4, 3)), row + rng.normal(size=(4, 3)), row]))
        two = sc.BezierPatch(np.stack([row, row + rng.normal(size=(4, 3)), row + rng.normal(size=(4, 3))]))
        both = sc.PatchSet.from_patches([one, two])
        aims = two.evaluate(0, np.linspace(0, 1, 50))
        ways = directions(rng, 50)
        found = both.rays(aims - 3 * ways, ways, limits=(3 - 1e-9, 3 + 1e-9))
        assert not np.isnan(found.along).any(), seed


def test_where_weights_have_both_signs_places_are_finite():
    rng = np.random.default_rng(23)
    for seed in range(30):
        patch = random_patch(np.random.default_rng([23, seed]), positive=False)
        origins, ways = rng.normal(size=(20, 3)), directions(rng, 20)
        try:
            found = patch.rays(origins, ways, hits="all", limits=LINES)
        except sc.InvalidShape as error:
            assert "origins[" in str(error)
            continue
        assert np.isfinite(found.along).all() and np.isfinite(found.points).all()


@pytest.mark.parametrize("origins, ways, more, text", [
    ((0, 0), (0, 0, 1), {}, r"origins has shape \(2,\)"),
    ((0, 0, 0), (0, 1), {}, r"directions has shape \(2,\)"),
    (np.zeros((3, 3)), np.ones((2, 3)), {}, "do not broadcast"),
    ((0, 0, np.nan), (0, 0, 1), {}, r"origins\[0\]"),
    ([(0, 0, 0), (0, np.inf, 0)], (0, 0, 1), {}, r"origins\[1\]"),
    ((0, 0, 0), [(0, 0, 1), (0, 0, 0)], {}, r"directions\[1\] is zero"),
    ((0, 0, 0), (0, 0, np.nan), {}, r"directions\[0\]"),
    ((1e300, 0, 0), (0, 0, 1), {}, r"origins\[0\] is too far away"),
    ((0, 0, 0), (0, 0, 1), {"hits": "last"}, "none of 'first', 'all'"),
    ((0, 0, 0), (0, 0, 1), {"hits": 3}, "none of 'first', 'all'"),
    ((0, 0, 0), (0, 0, 1), {"limits": (1, 0)}, "not in order"),
    ((0, 0, 0), (0, 0, 1), {"limits": (0, np.nan)}, "not in order"),
    ((0, 0, 0), (0, 0, 1), {"limits": (0, 1, 2)}, "limits has 3 values"),
])
def test_bad_calls_say_what_is_wrong(origins, ways, more, text):
    for shape in (SPHERE, sc.PatchSet.from_patches([SPHERE])):
        with pytest.raises(sc.InvalidShape, match=text):
            shape.rays(origins, ways, **more)


def test_a_long_call_ends_when_it_is_cancelled():
    with pytest.raises(sc.Cancelled):
        TORUS.rays(np.random.default_rng(1).normal(size=(200000, 3)), (0, 0, 1), threads=1, cancel=lambda: True)
