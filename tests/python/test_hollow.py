"""Caps of all recipes and of tubes within tubes: closed, with normals outwards, of the right volume; or refused."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_addon_caps import CIRCLE, SQUARE, definitions, caps, failures, make, moved, patches_of, polygon, volume

hollow = caps.caps_in_caps.hollow


def is_closed(result):
    return build.open_ends(patches_of(result)) == []


def radial(rng, size, wave=0.25):
    """A random closed curve that is seen from its middle, with random speeds, start and direction."""
    kind, count = rng.integers(0, 4), int(rng.integers(5, 12))
    angles = 2 * np.pi * (np.arange(count) + rng.uniform(-0.25, 0.25, count)) / count + rng.uniform(0, 7)
    points = (size * rng.uniform(1 - wave, 1 + wave, count))[:, None] * np.stack([np.cos(angles), np.sin(angles), 0 * angles], 1)
    if kind == 0:
        curve = sc.conics.ellipse((0, 0, 0), points[0], (-points[0][1], points[0][0], 0), ("square", "triangle", "single")[count % 3])
    elif kind == 1:
        rows = np.vstack([points, points[:1]])
        curve = sc.NurbsCurve(1, np.r_[0, np.arange(count + 1), count], rows)
    else:
        degree = int(rng.integers(2, 4))
        weights = rng.uniform(0.7, 1.4, count) if kind == 3 else np.ones(count)
        rows, weights = np.vstack([points, points[:degree]]), np.concatenate([weights, weights[:degree]])
        curve = sc.NurbsCurve(degree, np.arange(-degree, count + degree + 1.0), rows, weights).clamped()
    return curve.reversed() if rng.random() < 0.5 else curve


def random_profile(rng):
    return radial(rng, 10 ** rng.uniform(-2, 2))


def size_of(curve):
    return float(np.linalg.norm(np.ptp(curve.points, axis=0)))


def of_extrude(rng):
    profile = random_profile(rng)
    return make('extrude', profile, x=0.3 * size_of(profile), z=size_of(profile) * float(rng.choice([-1, 1])), caps='both')


def of_loft(rng):
    profile, count = random_profile(rng), int(rng.integers(2, 5))
    size = size_of(profile)
    rings = [moved(profile, x=size * rng.uniform(-0.2, 0.2), z=size * (i + rng.uniform(-0.2, 0.2)), size=rng.uniform(0.5, 1.5))
             for i in range(count)]
    return make('loft', *rings, caps='both')


def of_revolve(rng):
    profile = random_profile(rng)
    upright = profile.transformed(np.array([[1, 0, 0, 2 * size_of(profile)], [0, 0, 1, 0], [0, 1, 0, 0.0]]))
    return make('revolve', upright, axis='z', sweep=float(rng.uniform(0.3, 6.0) * rng.choice([-1, 1])),
                start=float(rng.uniform(-4, 4)), caps='both')


def of_whole_turn(rng):
    count, size = int(rng.integers(3, 7)), 10 ** rng.uniform(-2, 2)
    points = size * np.stack([rng.uniform(0.5, 2, count), np.zeros(count), np.sort(rng.uniform(0, 3, count)) + 0.2 * np.arange(count)], 1)
    profile = sc.NurbsCurve(2, np.r_[0, 0, np.arange(count - 1), count - 2, count - 2.0], points)
    return make('revolve', profile if rng.random() < 0.5 else profile.reversed(), axis='z', caps='both')


def random_rail(rng, size):
    points = size * np.stack([3 * np.arange(4), rng.uniform(-1, 1, 4), rng.uniform(-1, 1, 4)], 1)
    return sc.BezierCurve(points).to_nurbs()


def of_pipe(rng):
    size = 10 ** rng.uniform(-2, 2)
    return make('pipe', random_rail(rng, size), radius=0.3 * size, end_radius=float(rng.uniform(0.1, 0.5)) * size,
                caps=str(rng.choice(['flat', 'round'])), tolerance=1e-4 * size)


def of_sweep(rng):
    profile = random_profile(rng)
    return make('sweep', random_rail(rng, size_of(profile)), profile, caps='both', tolerance=1e-4 * size_of(profile))


@pytest.mark.parametrize('of', (of_extrude, of_loft, of_revolve, of_whole_turn, of_pipe, of_sweep))
def test_random_ones_are_closed_with_normals_outwards(of, inputs):
    refused = []
    count = inputs(100)
    for seed in range(count):
        try:
            found = of(np.random.default_rng(seed))
        except (failures.Refusal, sc.Error) as error:
            refused.append((seed, str(error)))
            continue
        assert is_closed(found) and volume(found) > 0.0, seed
    assert len(refused) <= 0.05 * count, refused


def area_of(curve):
    """By its prism."""
    return volume(make('extrude', curve, z=1.0, caps='both'))


def test_random_holes_are_left_open_to_the_last_digit(inputs):
    refused, count = [], inputs(200)
    for seed in range(count):
        rng = np.random.default_rng(seed)
        size = 10 ** rng.uniform(-2, 2)
        outer, inner = radial(rng, size), radial(rng, size * rng.uniform(0.05, 0.25))
        inner = moved(inner, x=0.05 * size * rng.uniform(-1, 1), y=0.05 * size * rng.uniform(-1, 1))
        height = size * float(rng.uniform(0.2, 3))
        try:
            found = make('extrude', [outer, inner] if seed % 2 else [inner, outer], z=height, caps='both')
        except failures.Refusal as error:
            assert "would cross" in str(error)
            refused.append(seed)
            continue
        wanted = (area_of(outer) - area_of(inner)) * height
        assert is_closed(found) and len(patches_of(found)) == 4, seed
        assert volume(found) == pytest.approx(wanted, rel=1e-9), seed
        _require_no_fold(patches_of(found)[2:], seed)
    assert len(refused) <= 0.05 * count, refused


def _require_no_fold(rings, seed):
    for ring in rings:
        at = [np.linspace(*domain, 41) for domain in ring.domain]
        heights = ring.evaluate_grid_with_normals(*at)[1][..., 2]
        heights = heights[np.isfinite(heights)]
        assert (heights > 0.5).all() or (heights < -0.5).all(), seed


def test_one_end_alone_and_a_part_of_a_turn():
    for end in ('start', 'end'):
        found = make('extrude', [moved(CIRCLE, size=2.0), CIRCLE], z=3.0, caps=end)
        assert len(build.open_ends(patches_of(found))) == 2 and len(patches_of(found)) == 3
    rings = [CIRCLE.transformed(np.array([[size, 0, 0, 3], [0, 0, 1, 0], [0, size, 0, 0.0]])) for size in (1.0, 0.5)]
    found = make('revolve', rings, axis='z', caps='both', sweep=2.0)
    assert is_closed(found) and volume(found) == pytest.approx(0.75 * math.pi * 6.0, rel=1e-9)


@pytest.mark.parametrize('radii', ([1.0], [2.0, 1.0]))
@pytest.mark.parametrize('height', (2.0, -2.0))
@pytest.mark.parametrize('size', (1e-150, 1e-60, 1e60, 1e150))
def test_normals_point_outwards_at_any_size(size, height, radii):
    found = make('extrude', [moved(CIRCLE, size=radius * size) for radius in radii], z=height * size, caps='both')
    there = sc.PatchSet.from_patches([patch.transformed(np.diag([1 / size] * 3 + [1.0])) for patch in patches_of(found)])
    assert there.volume() == pytest.approx(2 * math.pi * (max(radii) ** 2 - (len(radii) - 1)), rel=1e-9)


def test_an_island_in_a_hole_is_a_body_of_its_own():
    found = make('extrude', [moved(CIRCLE, size=size) for size in (1.0, 3.0, 2.0)], z=1.0, caps='both')
    assert is_closed(found) and volume(found) == pytest.approx(6.0 * math.pi, rel=1e-9)


TUBES = (build.extrude(CIRCLE, (0, 0, 3)), build.extrude(CIRCLE.reversed(), (0, 0, 3)), build.extrude(moved(CIRCLE, z=3.0), (0, 0, -3)),
         build.extrude(CIRCLE, (0, 0, 3)).swapped(), build.extrude(polygon((0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5)), (0, 0, 3)))
OUTER = (build.extrude(moved(CIRCLE, size=2.0), (0, 0, 3)), build.extrude(moved(SQUARE, x=-2.0, y=-2.0, size=4.0), (0, 0, 3)).swapped())


@pytest.mark.parametrize('inner', TUBES)
@pytest.mark.parametrize('outer', OUTER)
def test_the_verb_closes_a_tube_with_an_inner_tube_and_knows_where_its_patches_lay(inner, outer):
    before = definitions.from_value(sc.PatchSet.from_patches([outer, inner]))
    found = caps.capped(before, 'ALL')
    after = definitions.to_patch_set(found.changed.definition)
    areas = [4 * math.pi if outer is OUTER[0] else 16.0, 1.0 if inner is TUBES[-1] else math.pi]
    assert found.count == 2 and found.changed.parents == (0, 1, 0, 0)
    assert after.volume() == pytest.approx(3 * (areas[0] - areas[1]), rel=1e-9)
    for number, (old, place) in enumerate(zip((outer, inner), found.changed.places)):
        for fractions in np.random.default_rng(1).uniform(size=(9, 2)):
            at = [next(part for part in parts if part.start <= fraction <= part.end).of(fraction)
                  for fraction, parts in zip(fractions, (place.u, place.v))]
            assert _at(after[number], at) == pytest.approx(_at(old, fractions), abs=1e-9)
    assert caps.capped(before, 'SHORTEST').count == 1


def _at(patch, fractions):
    return patch.evaluate(*(start + (end - start) * fraction for fraction, (start, end) in zip(fractions, patch.domain)))


def test_several_tubes_and_a_bowl_in_a_tube():
    tubes = [OUTER[0], *(build.extrude(moved(CIRCLE, x=x, size=0.5), (0, 0, 3)) for x in (0.6, -0.6))]
    found = caps.capped(definitions.from_value(sc.PatchSet.from_patches(tubes)), 'ALL')
    assert definitions.to_patch_set(found.changed.definition).volume() == pytest.approx(10.5 * math.pi, rel=1e-9)
    bowl = build.cone((0, 0, 0), (0, 0, 1), 1.0, 2.0, 0.0)
    found = caps.capped(definitions.from_value(sc.PatchSet.from_patches([OUTER[0], bowl])), 'ALL')
    assert definitions.to_patch_set(found.changed.definition).volume() == pytest.approx((12 - 2 / 3) * math.pi, rel=1e-9)


def test_the_verb_refuses_what_it_cannot_close_by_name():
    crossing = build.extrude(moved(CIRCLE, x=1.5), (0, 0, 3))
    with pytest.raises(failures.Refusal, match="cross or touch in one plane"):
        caps.capped(definitions.from_value(sc.PatchSet.from_patches([OUTER[0], crossing])), 'ALL')
