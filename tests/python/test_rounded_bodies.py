"""Edges of bodies rounded: one, several, all, with corners of three, rims and chains; against closed forms, and watertight."""

import math

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from splinecore import build, conics
from test_addon_caps import make
from test_rounded_meshes import open_edges

rounding, bodies, failures = core('rounding.edges'), core('rounding.body'), core('base.failures')
ball_corner = core('rounding.ball_corner')


def quad(a, b, c, d):
    return sc.NurbsPatch((1, 1), ([0, 0, 1, 1], [0, 0, 1, 1]), [[a, d], [b, c]])


def lid(ring):
    """Around a middle: one patch with corners in its side."""
    ring = np.array([*ring, ring[0]])
    knots = [0.0, *range(len(ring)), len(ring) - 1]
    middle = np.broadcast_to(ring[:-1].mean(axis=0), ring.shape)
    return sc.NurbsPatch((1, 1), (knots, [0, 0, 1, 1]), np.stack([ring, middle], axis=1))


def rings_of(rng):
    """Bottom and top of a prism, or of a frustum: convex, oblique, irregular."""
    count = int(rng.integers(3, 8))
    angles = np.sort(rng.uniform(0, 2 * np.pi, count))
    while np.diff(angles, append=angles[0] + 2 * np.pi).min() < 0.2 or np.diff(angles, append=angles[0] + 2 * np.pi).max() > 3.0:
        angles = np.sort(rng.uniform(0, 2 * np.pi, count))
    bottom = np.c_[np.cos(angles) * rng.uniform(0.5, 2), np.sin(angles), np.zeros(count)]
    scale = 1.0 if rng.random() < 0.5 else rng.uniform(0.5, 1.5)
    return bottom, bottom * (scale, scale, 1) + (*rng.uniform(-1, 1, 2), rng.uniform(0.3, 3))


def body_of(rng, bottom, top):
    """Its patches, in any order, turned in their parameters, and where they are closed of one wall."""
    count = len(bottom)
    following = np.roll(np.arange(count), -1)
    if rng.random() < 0.3:
        closed = [np.array([*ring, ring[0]]) for ring in (bottom, top)]
        walls = [build.ruled(*(sc.NurbsCurve(1, [0, *range(count + 1), count], ring) for ring in closed))]
    else:
        walls = [quad(bottom[i], bottom[j], top[j], top[i]) for i, j in enumerate(following)]
    lids = [quad(*ring) if count == 4 and rng.random() < 0.7 else lid(ring) for ring in (bottom[::-1], top)]
    patches = [_swapped(rng, patch) for patch in (*walls, *lids)]
    return [patches[i] for i in rng.permutation(len(patches))]


def _swapped(rng, patch):
    """With other parameters; its normals stay."""
    if rng.random() < 0.5:
        patch = patch.swapped().reversed('u')
    if rng.random() < 0.3:
        patch = patch.reversed('u').reversed('v')
    return patch.elevate('u', 1) if rng.random() < 0.1 else patch


def placed(rng, bottom, top):
    size = 10**rng.uniform(-3, 3)
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    axes *= np.sign(np.linalg.det(axes))
    shift = size * rng.uniform(-3, 3, 3)
    return size * bottom @ axes + shift, size * top @ axes + shift, size


def faces_of(bottom, top):
    count = len(bottom)
    walls = [(bottom[i], bottom[(i + 1) % count], top[(i + 1) % count]) for i in range(count)]
    triples = [*walls, tuple(bottom[::-1][:3]), tuple(top[:3])]
    found = []
    for a, b, c in triples:
        normal = np.cross(b - a, c - a)
        found.append((normal / np.linalg.norm(normal), a))
    return found


def volume_of_rounded(bottom, top, radius):
    """Of the body within, whose faces lie deeper by the radius, and of all that lies so near to it (Steiner)."""
    faces, count = faces_of(bottom, top), len(bottom)
    inner = [[], []]
    for i in range(count):
        for k in range(2):
            three = [faces[(i - 1) % count], faces[i], faces[count + k]]
            inner[k].append(np.linalg.solve([n for n, _ in three], [n @ p - radius for n, p in three]))
    low, high = map(np.array, inner)
    walls = [(i, (i + 1) % count) for i in range(count)]
    polygons = [*([low[i], low[j], high[j], high[i]] for i, j in walls), list(low[::-1]), list(high)]
    volume = area = 0.0
    for polygon in polygons:
        spokes = np.array(polygon) - polygon[0]
        twice = np.cross(spokes[1:-1], spokes[2:]).sum(axis=0)
        area += np.linalg.norm(twice) / 2
        volume += (polygon[0] - low.mean(axis=0)) @ twice / 6
    edges = 0.0
    for i, j in walls:
        for a, b, m, n in ((low[i], low[j], i, count), (high[i], high[j], i, count + 1), (low[i], high[i], (i - 1) % count, i)):
            edges += np.linalg.norm(b - a) * np.arccos(np.clip(faces[m][0] @ faces[n][0], -1, 1))
    return volume + radius * area + radius**2 / 2 * edges + 4 / 3 * np.pi * radius**3


def require_closed(patches, free=0):
    together = sc.PatchSet.from_patches(patches)
    assert together.edge_counts()['free'] == free, together.edge_counts()
    if not free:
        assert len(open_edges(sc.Tessellation(together, (3, 3)))) == 0
    return together


def require_smooth(together, is_new):
    """Every seam of a new patch goes on."""
    for (a, side_a), (b, side_b) in together.seams():
        if a != b and (is_new(a) or is_new(b)):
            found = sc.seam_continuity(together[a], side_a, together[b], side_b)
            assert found.angle <= 1e-6, (a, side_a, b, side_b, found.angle)


REFUSED = ("radius is too large", "too sharp", "too near to one plane")


def test_all_edges_of_prisms(inputs):
    """Closed, G1 all over, and of the volume that Steiner's formula gives."""
    made_count = 0
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, 411])
        bottom, top, size = placed(rng, *rings_of(rng))
        patches = body_of(rng, bottom, top)
        radius = size * 10**rng.uniform(-3, -0.7)
        try:
            made = rounding.rounded([patches], "", radius, 1e-4 * size)
        except failures.Refusal as refused:
            assert any(word in str(refused) for word in REFUSED), (seed, refused)
            assert radius > 0.01 * size or "sharp" in str(refused), (seed, radius / size, refused)
            continue
        made_count += 1
        assert made.count == 3 * len(bottom) and made.error == 0.0
        together = require_closed(made.patches)
        if seed % 8 == 0:
            require_smooth(together, lambda _: True)
        expected = volume_of_rounded(bottom, top, radius)
        assert together.volume() == pytest.approx(expected, rel=1e-9), seed
    assert made_count > 0.6 * inputs(400)


def test_some_edges_of_prisms(inputs):
    """One edge, several, or those of some corners: closed, or refused by a sentence that names the corner or the edge."""
    made_count = refused_count = 0
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, 412])
        bottom, top, size = placed(rng, *rings_of(rng))
        patches = body_of(rng, bottom, top)
        edges = rounding.body_between([patches]).edges
        ends = [{edge.pairs[0][0].start, edge.pairs[-1][0].end} for edge in edges]
        chosen = {int(rng.integers(len(edges)))}
        if rng.random() < 0.4:
            corner = min(ends[min(chosen)])
            chosen |= {i for i, those in enumerate(ends) if corner in those}
        elif rng.random() < 0.5:
            chosen |= {int(i) for i in rng.integers(len(edges), size=int(rng.integers(1, 4)))}
        meeting = [sum(corner in ends[i] for i in chosen) for corner in {corner for i in chosen for corner in ends[i]}]
        text = ", ".join(str(i + 1) for i in sorted(chosen))
        try:
            made = rounding.rounded([patches], text, size * 10**rng.uniform(-3, -1), 1e-4 * size)
        except failures.Refusal as refused:
            refused_count += 1
            if 2 in meeting and "the corner of edges" in str(refused):
                assert any(word in str(refused) for word in ("at different angles", "inner and outer", *REFUSED)), (seed, refused)
            else:
                assert any(word in str(refused) for word in REFUSED), (seed, refused)
            continue
        made_count += 1
        assert made.count == len(chosen)
        require_closed(made.patches)
    assert made_count > 0.5 * inputs(400)


def edges_at(patches, *places):
    """The numbers of the edges in whose middles these places lie, as a text."""
    middles = rounding.middles_of([patches])
    return ", ".join(str(1 + int(np.linalg.norm(middles - place, axis=1).argmin())) for place in places)


@pytest.mark.parametrize('radius', (0.01, 0.3, 0.49))
def test_two_of_three_edges_of_a_corner_meet_in_an_arc(radius):
    ring = np.array([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)], float)
    top = ring + (0, 0, 1)
    box = [*(quad(ring[i], ring[(i + 1) % 4], top[(i + 1) % 4], top[i]) for i in range(4)), quad(*ring[::-1]), quad(*top)]
    off, again = (1 - math.pi / 4) * radius**2, (5 / 3 - math.pi / 2) * radius**3
    made = rounding.rounded([box], edges_at(box, (1.5, 0, 1), (0, 1, 1)), radius, 1e-4)
    assert made.error == 0.0 and require_closed(made.patches).volume() == pytest.approx(6 - 5 * off + again, rel=1e-12)
    made = rounding.rounded([box], edges_at(box, (1.5, 0, 1), (0, 1, 1), (1.5, 2, 1), (3, 1, 1)), radius, 1e-4)
    assert require_closed(made.patches).volume() == pytest.approx(6 - 10 * off + 4 * again, rel=1e-12)


def test_lids_of_prisms_and_frusta_about_a_circle_are_rounded_alone(inputs):
    """In every corner both edges meet the lid at one angle."""
    for seed in range(inputs(100)):
        rng = np.random.default_rng([seed, 414])
        count = int(rng.integers(3, 8))
        angles = 2 * np.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
        taper = rng.choice([1.0, rng.uniform(0.6, 0.95), rng.uniform(1.05, 1.4)])
        half = 0.5 * np.diff(angles, append=angles[0] + 2 * np.pi)
        # About a circle, which all sides touch.
        bottom = np.c_[np.cos(angles + half) / np.cos(half), np.sin(angles + half) / np.cos(half), np.zeros(count)]
        top = bottom * (taper, taper, 1) + (0, 0, 1)
        bottom, top, size = placed(rng, bottom, top)
        walls = [quad(bottom[i], bottom[j], top[j], top[i]) for i, j in enumerate(np.roll(np.arange(count), -1))]
        patches = [*walls, lid(bottom[::-1]), lid(top)]
        text = edges_at(patches, *(0.5 * (top + np.roll(top, -1, axis=0))))
        made = rounding.rounded([patches], text, 0.02 * size, 1e-4 * size)
        assert made.error == 0.0 and made.count == count
        require_closed(made.patches)


def test_two_edges_at_different_angles_are_refused_with_what_to_do():
    bottom = np.array([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)], float)
    top = np.array([(0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)], float)
    patches = [*(quad(bottom[i], bottom[(i + 1) % 4], top[(i + 1) % 4], top[i]) for i in range(4)), quad(*bottom[::-1]), quad(*top)]
    text = edges_at(patches, (1, 0, 1), (2, 1, 1))
    with pytest.raises(failures.Refusal, match="at different angles.*round all three edges there, or one"):
        rounding.rounded([patches], text, 0.1, 1e-4)


def test_corners_of_balls_at_random(inputs):
    """Any spherical triangle: on the ball, and its sides are arcs of the second degree, raised."""
    made_count = 0
    for seed in range(inputs(400)):
        rng = np.random.default_rng([seed, 413])
        ways = rng.normal(size=(3, 3))
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
        center, radius = rng.normal(size=3), 10**rng.uniform(-2, 2)
        net = ball_corner.net_of(center, radius, *(center + radius * ways))
        degree = ball_corner.degree_for(net)
        if degree is None:
            area = 2 * math.atan2(abs(np.linalg.det(ways)), 1 + ways[0] @ ways[1] + ways[1] @ ways[2] + ways[2] @ ways[0])
            assert area % (4 * np.pi) > 1.0
            continue
        made_count += 1
        rows = ball_corner.raised(net, degree)
        rows = np.concatenate([rows[..., :3] / rows[..., 3:], rows[..., 3:]], axis=-1)
        patch = ball_corner.patch_of(ball_corner.raised(net, degree), rows[0], rows[:, -1], rows[-1])
        points = patch.evaluate_grid(np.linspace(0, 1, 9), np.linspace(0, 1, 9)).reshape(-1, 3) - center
        assert np.abs(np.linalg.norm(points, axis=1) - radius).max() <= 1e-12 * (radius + np.abs(center).max())
        for u, v in ((0.0, 1.0), (1.0, 1.0)):
            corner = (patch.evaluate(u, v) - center) / radius
            assert np.abs(corner - ways[1 + int(u)]).max() <= 1e-12 * (1 + np.abs(center).max() / radius)
    assert made_count > 0.8 * inputs(400)


def capped(curve, *vector):
    return build.cap([build.extrude(curve, vector)], None).value


BOX = capped(build.contour([(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)], closed=True), 0, 0, 1)


def test_an_extruded_box_is_rounded_all_over():
    made = make('rounded_edge', sc.PatchSet.from_patches(BOX), radius=0.25, end_radius=0.25)
    assert made.said == "12 edges rounded" and len(made.value) == 26 and made.error == 0.0
    require_closed(list(made.value))
    inner = np.array([2.5, 1.5, 0.5])
    area = 2 * (inner[0] * inner[1] + inner[1] * inner[2] + inner[0] * inner[2])
    expected = inner.prod() + 0.25 * area + np.pi * 0.25**2 * inner.sum() + 4 / 3 * np.pi * 0.25**3
    assert made.value.volume() == pytest.approx(expected)


@pytest.mark.parametrize("text, message", [
    ("0", "none of number 0"), ("13", "there are 12 edges, none of number 13"), ("1; 2", "is not a number of an edge"),
    ("3-1", "none of number 3-1")])
def test_numbers_of_edges_that_mean_nothing_are_refused(text, message):
    with pytest.raises(failures.Refusal, match=message):
        make('rounded_edge', sc.PatchSet.from_patches(BOX), edges=text)


def test_a_radius_that_is_too_large_is_refused_with_the_edge():
    with pytest.raises(failures.Refusal, match=r"too large for the surfaces beside edge 7: nothing is left"):
        make('rounded_edge', sc.PatchSet.from_patches(BOX), radius=4.0, end_radius=4.0, edges="7")
    with pytest.raises(failures.Refusal, match="First Side and Second Side are for two"):
        make('rounded_edge', sc.PatchSet.from_patches(BOX), first_side='u_end')
    with pytest.raises(failures.Refusal, match="Radius and End Radius are one"):
        make('rounded_edge', sc.PatchSet.from_patches(BOX), radius=0.1, end_radius=0.2)


def test_the_rims_of_a_tube_and_its_lids():
    for tube in (build.cylinder((0, 0, 0), (0, 0, 1), 1, 2), build.extrude(conics.circle((0, 0, 0), 1.0), (0, 0, 2))):
        patches = build.cap([tube], None).value
        made = make('rounded_edge', sc.PatchSet.from_patches(patches), radius=0.2, end_radius=0.2)
        assert made.said == "2 edges rounded" and made.error < 1e-12
        together = require_closed(list(made.value))
        expected = np.pi * (1.6 + 2 * (0.64 * 0.2 + 0.8 * np.pi / 2 * 0.04 + 2 / 3 * 0.008))
        assert together.volume() == pytest.approx(expected, rel=1e-9)


def test_an_edge_that_ends_in_planes_takes_these_back():
    """Upright edges of a half-round bar: its ends go up to the ball."""
    arc, line = conics.arc((0, 0, 0), (1, 0, 0), (0, 1, 0), 0.0, np.pi), sc.BezierCurve([(-1, 0, 0), (1, 0, 0)])
    half = build.join_curves([arc, line], 1e-9)[0]
    patches = capped(half, 0, 0, 1)
    body = rounding.body_between([patches])
    upright = [edge.number for edge in body.edges
               if np.ptp(body.corners[[edge.pairs[0][0].start, edge.pairs[-1][0].end], 2]) > 0.5]
    assert len(upright) == 2
    made = rounding.rounded([patches], " ".join(map(str, upright)), 0.1, 1e-5)
    require_closed(made.patches)
    bent = [edge.number for edge in body.edges if edge.number not in upright and not rounding.is_of_planes(body, edge)]
    for number in bent:
        made = rounding.rounded([patches], str(number), 0.1, 1e-5)
        assert made.error < 1e-12
        require_smooth(require_closed(made.patches), lambda _: False)
    with pytest.raises(failures.Refusal, match="the corner of edges .*not all surfaces there are planes"):
        rounding.rounded([patches], "", 0.1, 1e-5)


def test_a_wall_and_a_lid_of_two_shapes_are_exact_whatever_the_patch_of_the_lid():
    outline = sc.build.contour([(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0)], closed=True).rounded(0.5)
    wall_patch, bottom, top = capped(outline, 0, 0, 1)
    for cap in (bottom, top):
        made = make('rounded_edge', wall_patch, cap, radius=0.3, end_radius=0.3)
        assert made.error < 1e-12 and made.said == "1 edge rounded"
        together = sc.PatchSet.from_patches(list(made.value))
        assert together.edge_counts()['free'] == 1
        require_smooth(together, lambda _: True)


def test_three_surfaces_in_one_edge_and_four_in_a_corner_are_refused():
    fan = [build.plane((0, 0, 0), (1, 0, 0), way) for way in ((0, 1, 0), (0, 0, 1), (0, -1, 0.3))]
    with pytest.raises(failures.Refusal, match="edge 1: more than two surfaces meet in it"):
        rounding.rounded([fan], "", 0.1, 1e-4)
    base, top = [(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)], (0, 0, 1)
    pyramid = [quad(base[i], base[(i + 1) % 4], top, top) for i in range(4)]
    with pytest.raises(failures.Refusal, match="the corner of edges 1, 2, 3 and 4: 4 rounded edges and 4 surfaces meet there"):
        rounding.rounded([pyramid], "", 0.1, 1e-4)
    made = rounding.rounded([[*pyramid, quad(*base[::-1])]], "1", 0.1, 1e-4)
    require_closed(made.patches)


def test_walls_side_by_side_in_one_plane_are_one_wall():
    walls = [build.plane((x, 0, 0), (2, 0, 0), (0, 0, 1)) for x in (0, 2)]
    made = rounding.rounded([[build.plane((0, 0, 0), (4, 0, 0), (0, 2, 0))], walls], "", 0.2, 1e-4)
    assert made.count == 1 and len(made.patches) == 3
    require_closed(made.patches, free=8)


def wall(x=2.0, low=0.0, tilt=0.0):
    return build.plane((0, tilt, low), (x, -2 * tilt, 0), (0, 0, 1 - low))


def test_surfaces_that_cross_are_cut_back_along_lines_of_both():
    floor = build.plane((0, -1, 0), (2, 0, 0), (0, 3, 0))
    made = make('rounded_edge', floor, wall(low=-0.4), radius=0.1, end_radius=0.1)
    assert made.said == "cut back to where they cross" and made.error < 1e-12
    require_closed(list(made.value), free=8)
    low, high = np.array([patch.bounding_box() for patch in made.value]).transpose(1, 0, 2)
    assert low.min(axis=0) == pytest.approx((0, 0, 0), abs=1e-9) and high.max(axis=0) == pytest.approx((2, 2, 1), abs=1e-9)
    other = make('rounded_edge', floor, wall(low=-0.4), radius=0.1, end_radius=0.1, first_side='v_end', second_side='v_end')
    points = np.concatenate([np.asarray(patch.points).reshape(-1, 3) for patch in other.value])
    assert points[:, 1].max() <= 1e-9 and points[:, 2].max() <= 1e-9
    ending = make('rounded_edge', floor, wall(), radius=0.1, end_radius=0.1)
    require_closed(list(ending.value), free=8)


def test_a_plate_through_a_tube():
    tube, plate = build.cylinder((0, 0, 0), (0, 0, 1), 1, 3), build.disc((0, 0, 1), (0, 0, 1), 2)
    made = make('rounded_edge', tube, plate, radius=0.1, end_radius=0.1)
    require_closed(list(made.value), free=2)


@pytest.mark.parametrize("other, message", [
    (wall(tilt=0.2, low=-0.4), "not along a line of u or v of the first one"),
    (wall(x=1.5, low=-0.4), "along a part of a line of the first one"),
    (build.plane((0, 9, 5), (1, 0, 0), (0, 0, 1)), "no edge in common, and do not cross"),
    (build.sphere((1, 0.5, 0), 0.3), "closed curve|closed across|not along")])
def test_what_would_have_to_be_trimmed_is_said(other, message):
    floor = build.plane((0, -1, 0), (2, 0, 0), (0, 3, 0))
    with pytest.raises(failures.Refusal, match=message):
        make('rounded_edge', floor, other, radius=0.1, end_radius=0.1)


def outline_at_random(rng):
    """A closed outline of segments and arcs that goes on smoothly, in any order of its corners' radii, and the least radius."""
    count = int(rng.integers(3, 7))
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False) + rng.uniform(-0.2, 0.2, count)
    points = np.c_[3 * np.cos(angles) * rng.uniform(0.8, 1.5), 3 * np.sin(angles), np.zeros(count)]
    least = rng.uniform(0.3, 0.5)
    return sc.build.contour(points, closed=True).rounded(least, shrink=True), least


def off_the_ball(points, outline, radius, height):
    """How far points beside the rims of an upright body are from a ball that touches its wall and its lid."""
    beside = radius - outline.nearest(points * (1, 1, 0)).distances
    deep = radius - np.minimum(points[:, 2], height - points[:, 2])
    is_rim = (beside > 0) & (deep > 0)
    return np.abs(np.hypot(beside, deep) - radius)[is_rim]


def test_rims_of_smooth_outlines(inputs):
    """Both rims of an extruded outline of segments and arcs: exact tubes and tori, closed, G1, in one patch and in several."""
    for seed in range(inputs(100)):
        rng = np.random.default_rng([seed, 414])
        outline, least = outline_at_random(rng)
        size = 10**rng.uniform(-3, 3)
        axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        axes *= np.sign(np.linalg.det(axes))
        back = np.c_[size * axes, size * rng.uniform(-3, 3, 3)]
        patches = [patch.transformed(back) for patch in capped(outline, 0, 0, 2)]
        if rng.random() < 0.5:
            knots = np.unique(patches[0].knots[0])[1:-1]
            patches[:1] = _parts(patches[0], rng.permutation(knots)[:int(rng.integers(1, 4))])
        radius = rng.uniform(0.1, 0.9) * least
        made = rounding.rounded([patches], "", radius * size, 1e-5 * size)
        assert made.count == 2 and made.error <= 1e-12 * size, (seed, made.error / size)
        together = require_closed(made.patches)
        require_smooth(together, lambda _: True)
        for patch in made.patches:
            points = patch.evaluate_grid(*(np.linspace(*domain, 7) for domain in patch.domain)).reshape(-1, 3)
            off = off_the_ball((points - back[:, 3]) @ axes / size, outline, radius, 2.0)
            assert off.max(initial=0.0) <= 1e-7, (seed, off.max())


def _parts(patch, knots):
    parts = [patch]
    for knot in np.sort(knots):
        parts += parts.pop().split('u', knot)
    return parts


def test_corners_are_rounded_first_and_then_the_rims():
    """Upright edges with one radius, and all round with a smaller one: planes are cut at chords where no point sees all."""
    for corners in ([(0, 0), (3, 0), (3, 2), (0, 2)], [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)],
                    [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]):
        patches = capped(build.contour([(*corner, 0) for corner in corners], closed=True), 0, 0, 1)
        body = rounding.body_between([patches])
        upright = [edge.number for edge in body.edges
                   if np.ptp(body.corners[[edge.pairs[0][0].start, edge.pairs[-1][0].end], 2]) > 0.5]
        first = rounding.rounded([patches], " ".join(map(str, upright)), 0.3, 1e-5)
        require_smooth(require_closed(first.patches), lambda _: False)
        second = rounding.rounded([first.patches], "", 0.1, 1e-5)
        assert second.count == 2 and second.error < 1e-12
        require_smooth(require_closed(second.patches), lambda _: True)
        with pytest.raises(failures.Refusal, match="^edge 1: the radius is too large"):
            rounding.rounded([first.patches], "", 0.35, 1e-5)


def test_corners_of_curved_walls_say_what_works_and_that_does():
    """Half a disc, extruded: its upright edges first, then both rims."""
    arc = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], [(2, 0, 0), (2, 2, 0), (0, 2, 0), (-2, 2, 0), (-2, 0, 0)],
                        [1, math.sqrt(0.5), 1, math.sqrt(0.5), 1])
    chord = sc.NurbsCurve(1, [0, 0, 1, 1], [(-2, 0, 0), (2, 0, 0)])
    patches = capped(build.join_curves([arc, chord], 1e-9)[0], 0, 0, 1.5)
    with pytest.raises(failures.Refusal, match="the corner of edges .* round one of them first, then the others with a smaller radius"):
        rounding.rounded([patches], "", 0.1, 1e-6)
    body = rounding.body_between([patches])
    upright = [edge.number for edge in body.edges if np.ptp(_ends_of(body, edge)[:, 2]) > 0.5]
    first = rounding.rounded([patches], " ".join(map(str, upright)), 0.1, 1e-6)
    second = rounding.rounded([first.patches], "", 0.05, 1e-6)
    assert first.count == second.count == 2 and max(first.error, second.error) < 1e-12
    require_smooth(require_closed(second.patches), lambda _: True)


def _ends_of(body, edge):
    return body.corners[[edge.pairs[0][0].start, edge.pairs[-1][0].end]]


@pytest.mark.parametrize("seed, share", [(31, 0.8760990821436997), (48, 0.8518831583658625)])
def test_arcs_that_go_on_beyond_their_ends_keep_their_digits(seed, share):
    """Beside the ends of an edge patches go on for the ball: an arc that does has huge points, which cancel."""
    outline, least = outline_at_random(np.random.default_rng([seed, 414]))
    upright, radius = capped(outline, 0, 0, 2)[0], share * least
    for width in (1.001, 1.01, 1.02, 1.05):
        strip = core('rounding.strips').strip_of(upright.boundary('v_start'), np.array([0, 0, 1.0]), width * radius)
        made = build.fillet_patches(upright, 'v_start', strip, 'v_start', radius, tolerance=1e-5)
        assert made.error < 1e-12
