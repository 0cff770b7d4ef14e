"""Caps: what fills closed rims, and open ends of patches: exact borders, plane, not folded, closed with normals outwards."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def polygon(*points, z=0.0):
    rows = np.array([(*p, z) for p in (*points, points[0])], dtype=np.float64)
    at = np.arange(len(rows), dtype=float)
    return sc.NurbsCurve(1, np.r_[at[0], at, at[-1]], rows)


LETTERS = {
    'L': ((0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)),
    'U': ((0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)),
    'T': ((1, 0), (2, 0), (2, 2), (3, 2), (3, 3), (0, 3), (0, 2), (1, 2)),
    'E': ((0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (1, 3), (1, 4), (3, 4), (3, 5), (0, 5)),
    'dart': ((0, 0), (2, 1), (0, 2), (0.5, 1)),
    'bow': ((0, 0), (4, 0), (4, 2), (2, 0.5), (0, 2)),
    'triangle': ((0, 0), (1, 0), (0.3, 1)),
    'Z': ((0, 0), (5, 0), (5, 1), (2, 1), (5, 4), (5, 5), (0, 5), (0, 4), (3, 4), (0, 1)),
}


def banana(count=9):
    """A smooth rim that is seen whole from nowhere."""
    outer = [(3 * math.cos(a), 3 * math.sin(a)) for a in np.linspace(0.2, 2.9, count)]
    within = [(2 * math.cos(a), 2 * math.sin(a)) for a in np.linspace(2.9, 0.2, count)]
    points = np.array([(*p, 0.0) for p in (*outer, *within)])
    return sc.NurbsCurve(3, np.arange(len(points) + 1.0), points, periodic=True)


def area_of(patches):
    return sum(one.area() for one in patches)


def require_unfolded(patches, normal):
    """All normals to one side, inside of every patch."""
    for one in patches:
        u, v = (np.linspace(*domain, 41)[1:-1] for domain in one.domain)
        _, normals = one.evaluate_grid_with_normals(u, v)
        assert (normals.reshape(-1, 3) @ normal > 0.999).all()


def require_closed(patches, volume=None):
    made = sc.PatchSet.from_patches(list(patches))
    found = made.volume()
    assert found > 0.0
    if volume is not None:
        assert abs(found - volume) <= 1e-9 * abs(volume)
    for fineness in ((3, 2), (5, 7)):
        require_watertight(sc.Tessellation(made, fineness))


def require_watertight(mesh):
    """Every edge has two faces, which run along it in opposite ways."""
    corners, starts = mesh.corner_vertices, np.r_[mesh.face_starts, len(mesh.corner_vertices)]
    following = np.arange(1, len(corners) + 1)
    ends = starts[1:][starts[1:] > starts[:-1]]
    following[ends - 1] = starts[:-1][starts[1:] > starts[:-1]]
    edges = np.c_[corners, corners[following]]
    assert len(np.unique(edges, axis=0)) == len(edges)
    assert np.array_equal(np.unique(edges, axis=0), np.unique(edges[:, ::-1], axis=0))


@pytest.mark.parametrize('name', LETTERS)
@pytest.mark.parametrize('turned', [False, True])
def test_polygons_are_filled_and_extruded_to_closed_bodies(name, turned):
    rim = polygon(*(LETTERS[name][::-1] if turned else LETTERS[name]))
    wanted = abs(rim.signed_area())
    patches, bend = build.fill_rim([rim])
    assert bend == 0.0 and abs(area_of(patches) - wanted) <= 1e-12 * wanted
    require_unfolded(patches, (0, 0, -1 if turned else 1))
    made, bend = build.cap([build.extrude(rim, (0, 0, 2.5))])
    assert bend == 0.0
    require_closed(made, 2.5 * wanted)


def test_what_is_seen_whole_is_one_patch_on_the_rim_itself():
    tube = build.extrude(CIRCLE, (0, 0, 3))
    made, bend = build.cap([tube])
    assert len(made) == 3 and bend == 0.0 and made[0] == tube
    assert any(np.array_equal(made[1].points[::step, 0], tube.points[:, 0]) for step in (1, -1)) or \
        np.array_equal(np.sort(made[1].points[:, 0].ravel()), np.sort(tube.points[:, 0].ravel()))
    require_closed(made, 3 * math.pi)


def test_of_a_body_that_was_inside_out_all_normals_are_turned():
    made, _ = build.cap([build.extrude(CIRCLE.reversed(), (0, 0, 3))])
    require_closed(made, 3 * math.pi)
    one, _ = build.cap([build.extrude(CIRCLE.reversed(), (0, 0, 3))], [[(0, "v_start")]])
    both, _ = build.cap(one)
    assert len(one) == 2 and len(both) == 3
    require_closed(both, 3 * math.pi)


def test_a_smooth_rim_that_is_seen_from_nowhere_is_cut():
    rim = banana()
    patches, bend = build.fill_rim([rim])
    assert bend <= 1e-12 and abs(area_of(patches) - abs(rim.signed_area())) <= 1e-9
    require_unfolded(patches, (0, 0, np.sign(rim.signed_area())))
    made, _ = build.cap([build.extrude(rim, (0, 0, 1))])
    require_closed(made, abs(rim.signed_area()))


def test_a_rim_in_no_plane_is_filled_and_how_far_is_said():
    wavy = sc.NurbsCurve(3, np.arange(13.0), [(math.cos(a), math.sin(a), 0.2 * math.cos(3 * a))
                                               for a in np.linspace(0, 2 * np.pi, 13)[:-1]], periodic=True)
    made, bend = build.cap([build.extrude(wavy, (0, 0, 2))])
    assert 0.1 < bend < 0.3
    require_closed(made)


def test_a_revolved_wedge_and_a_cup():
    ring = polygon((1, 0), (2, 0), (2, 1), (1, 1)).transformed(np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0.0]]))
    wedge = build.revolve(ring, (0, 0, 0), (0, 0, 1), 0.0, 1.0)
    made, _ = build.cap([wedge])
    require_closed(made, 1.5)
    profile = sc.BezierCurve([(0, 0, 0), (1, 0, 0), (1, 0, 2)]).to_nurbs()
    cup = build.revolve(profile, (0, 0, 0), (0, 0, 1))
    assert len(build.open_ends([cup])) == 1
    require_closed(build.cap([cup]).value)


def test_open_ends_of_several_patches_go_round_all_of_them():
    tube = build.extrude(CIRCLE, (0, 0, 1))
    parts = []
    for part in tube.clamped("u").split("u", 1.5):
        parts += part.split("v", 0.5)
    ends = build.open_ends(parts)
    assert sorted(map(len, ends)) == [2, 2]
    made, _ = build.cap(parts)
    assert len(made) == 8
    require_closed(made, math.pi)


def test_what_cannot_be_filled_is_refused():
    eight = polygon((0, 0), (2, 2), (2, 0), (0, 2))
    for curve, words in ((eight, "almost no area|crosses itself"), (polygon((0, 0), (3, 3), (3, 0), (0, 2)), "crosses itself"),
                         (polygon((0, 0), (1, 0), (2, 0)), "almost no area"),
                         (sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0, 0), (1, 0, 0), (0, 1, 0)]), "do not form a loop")):
        with pytest.raises(sc.InvalidShape, match=words):
            build.fill_rim([curve])
    limacon = sc.NurbsCurve(3, np.arange(25.0), [((1 + 2 * math.cos(a)) * math.cos(a), (1 + 2 * math.cos(a)) * math.sin(a), 0)
                                                 for a in np.linspace(0, 2 * np.pi, 25)[:-1]], periodic=True)
    with pytest.raises(sc.InvalidShape, match="crosses itself"):
        build.fill_rim([limacon])
    with pytest.raises(sc.InvalidShape, match="there is no side"):
        build.fill_rim([])
    with pytest.raises(sc.InvalidShape, match="there is no patch 3"):
        build.cap([build.extrude(CIRCLE, (0, 0, 1))], [[(3, "v_start")]])
    with pytest.raises(TypeError, match="a side must be a pair"):
        build.cap([build.extrude(CIRCLE, (0, 0, 1))], [["v_start"]])


def random_rim(rng):
    """Round a middle, from smooth to spiky, in a plane of its own, of any size, far out."""
    degree = int(rng.integers(1, 5))
    count = int(rng.integers(3, 9)) * degree
    angles = np.linspace(0, 2 * np.pi, count + 1)[:-1]
    radii = 10.0 ** rng.uniform(-0.35, 0, count)
    rows = np.c_[radii * np.cos(angles), radii * np.sin(angles), np.zeros(count), 2.0 ** rng.uniform(-1, 1, count)]
    if rng.random() < 0.6:
        rows[:, 3] = 1.0
    rows = np.r_[rows, rows[:1]]
    breaks = np.r_[0, np.cumsum(10.0 ** rng.uniform(-2, 2, count // degree))]
    curve = sc.NurbsCurve(degree, np.r_[breaks[0], np.repeat(breaks, degree), breaks[-1]], rows[:, :3], rows[:, 3])
    if rng.random() < 0.3:
        curve = sc.NurbsCurve(min(3, count), np.arange(count + 1.0), rows[:-1, :3], periodic=True)
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    axes[:, 2] *= np.linalg.det(axes)
    matrix = np.zeros((3, 4))
    matrix[:, :3] = axes * 10.0 ** rng.uniform(-3, 3)
    matrix[:, 3] = rng.normal(0, 10, 3) * (1.0 if rng.random() < 0.7 else 0.0)
    return curve.transformed(matrix), axes[:, 2]


def hollow_rim(rng):
    """A comb, or a strip that winds up to one and a half times: seen whole from nowhere."""
    if rng.random() < 0.5:
        steps = np.cumsum(rng.uniform(0.2, 1.0, 2 * int(rng.integers(2, 8)) - 1))
        top = [(x, 1.0 + (rng.uniform(0.3, 4.0) if (i // 2) % 2 == 0 else 0.0)) for i, x in enumerate(np.repeat(np.r_[0, steps], 2)[1:-1])]
        return polygon((0, 0), (steps[-1], 0), *top[::-1]), np.array([0, 0, 1.0])
    count, width = int(rng.integers(12, 20)), rng.uniform(0.15, 0.35)
    angles = np.linspace(0, rng.uniform(0.3, 1.5) * 2 * np.pi, count)
    radii = 1 + angles / (2 * np.pi)
    rows = np.c_[np.r_[radii, (radii + width)[::-1]] * np.cos(np.r_[angles, angles[::-1]]),
                 np.r_[radii, (radii + width)[::-1]] * np.sin(np.r_[angles, angles[::-1]]), np.zeros(2 * count)]
    return sc.NurbsCurve(3, np.arange(2 * count + 1.0), rows, periodic=True), np.array([0, 0, 1.0])


@pytest.mark.parametrize('kind', (random_rim, hollow_rim))
def test_random_rims_are_filled_to_their_area_or_refused(kind, inputs):
    rng = np.random.default_rng(41)
    count, refused = inputs(1000 if kind is random_rim else 100), 0
    for number in range(count):
        rim, normal = kind(rng)
        wanted = rim.signed_area(normal)
        try:
            patches, bend = build.fill_rim([rim])
        except sc.InvalidShape as error:
            assert "the rim" in str(error), number
            refused += 1
            continue
        size = np.ptp(rim.points[:, :3], axis=0).max()
        assert bend <= 1e-9 * size, number
        assert abs(area_of(patches) - abs(wanted)) <= 1e-6 * abs(wanted), number
        require_unfolded(patches, normal * np.sign(wanted))
        tall = normal * size
        made, _ = build.cap([build.extrude(rim, tall)])
        volume = sc.PatchSet.from_patches(made).volume()
        assert abs(volume - abs(wanted) * size) <= 1e-6 * abs(volume), number
    assert refused <= (0.4 if kind is random_rim else 0.05) * count, refused
