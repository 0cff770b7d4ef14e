"""Chains of edges rounded as one: closed forms of planes, cylinders and tori, an edge in parts as the whole, corners refused, and meshes
without a gap at seams and joints."""

import numpy as np
import pytest
import splinecore as sc
from splinecore import build, conics
from test_rounded_meshes import open_edges, s_curve, smooth_chain, spline, wall_and_floor

UP, HEIGHT, WIDTH = (0, 0, 1), 4.0, 5.0


def straight_pair(start, end, inward):
    """(wall, floor) along a segment in the ground plane; the floor lies to the inner side."""
    edge = sc.BezierCurve([start, end])
    return build.extrude(edge, (0, 0, HEIGHT)), build.extrude(edge, np.array(inward) * WIDTH)


def arc_pair(center, start, end, share):
    """Of a quarter of a circle; the floor goes to a smaller or larger one."""
    arc = conics.arc_about(center, start, end)
    scale = np.eye(4)
    scale[:3, :3] *= share
    scale[:3, 3] = (1 - share) * np.array(center)
    return build.extrude(arc, (0, 0, HEIGHT)), build.ruled(arc, arc.transformed(scale))


def bend():
    """Straight, a quarter of radius 8 about (10, 8), straight; walls upwards, floors outwards."""
    return [straight_pair((0, 0, 0), (10, 0, 0), (0, -1, 0)),
            arc_pair((10, 8, 0), (10, 0, 0), (18, 8, 0), 1 + WIDTH / 8),
            straight_pair((18, 8, 0), (18, 20, 0), (1, 0, 0))]


def edges_of(pairs):
    return [(wall, 'v_start', floor, 'v_start') for wall, floor in pairs]


def mixed(rng, wall, floor):
    """The same edge with patches turned in any way."""
    sides = []
    for patch in (wall, floor):
        side = 'v_start'
        if rng.random() < 0.4:
            patch, side = patch.reversed('v'), 'v_end'
        if rng.random() < 0.4:
            patch = patch.reversed('u')
        if rng.random() < 0.4:
            patch, side = patch.swapped(), side.replace('v', 'u')
        sides += [patch, side]
    return tuple(sides)


def require_closed_up(parts, free):
    """One set without a gap along seams and joints: only so many sides are open."""
    patches = [patch for part in parts for patch in (part.first, part.fillet, part.second)]
    together = sc.PatchSet.from_patches(patches)
    counts = together.edge_counts()
    assert counts['free'] == free, counts
    for faces in (sc.Tessellation(together, (3, 3)), sc.Tessellation.adaptive(together, tolerance=0.05)):
        found = open_edges(faces)
        uvs = np.array(faces.corner_uvs)[found[:, 1:]]
        # every open edge lies along a side of its patch
        assert ((np.abs(uvs - 0.0) <= 1e-6).all(axis=1) | (np.abs(uvs - 1.0) <= 1e-6).all(axis=1)).any(axis=1).all()


def grid(patch, count=17):
    return patch.evaluate_grid(*(np.linspace(*domain, count) for domain in patch.domain)).reshape(-1, 3)


def bend_miss(points, radius):
    """How far points are from the ball's surface along bend(): its center is beside the edge by the radius, and above it."""
    x, y, z = points.T
    beside = np.where(x < 10, -y, np.where(y > 8, x - 18, np.hypot(x - 10, y - 8) - 8))
    return np.abs(np.hypot(beside - radius, z - radius) - radius)


def test_a_bend_is_rounded_by_cylinders_and_a_torus(inputs):
    for seed in range(inputs(40)):
        rng = np.random.default_rng([seed, 361])
        radius = rng.uniform(0.2, 2.0)
        edges = [mixed(rng, *pair) for pair in bend()]
        made = build.fillet_chain(edges, radius, tolerance=1e-6)
        assert len(made) == 3 and max(part.error for part in made) <= 1e-6
        for part in made:
            assert bend_miss(grid(part.fillet), radius).max() <= 1e-6
        require_closed_up(made, 2 * 3 + 2 * 3)


def test_a_rounded_rectangle_is_rounded_all_round():
    corners = [((8, 0), (10, 2), (8, 2)), ((10, 6), (8, 8), (8, 6)), ((2, 8), (0, 6), (2, 6)), ((0, 2), (2, 0), (2, 2))]
    pairs = []
    for k, (start, end, center) in enumerate(corners):
        following = corners[(k + 1) % 4][0]
        way = np.array(following) - end
        outward = np.array((way[1], -way[0], 0)) / np.linalg.norm(way)
        pairs.append(arc_pair((*center, 0), (*start, 0), (*end, 0), 1 + WIDTH / 2))
        pairs.append(straight_pair((*end, 0), (*following, 0), outward))
    made = build.fillet_chain(edges_of(pairs), 0.5, tolerance=1e-6)
    assert len(made) == 8
    require_closed_up(made, 2 * 8)


def test_an_edge_in_parts_is_rounded_as_the_whole(inputs):
    made_count = 0
    for seed in range(inputs(100)):
        rng = np.random.default_rng([seed, 362])
        wall, _, floor, _ = wall_and_floor(rng, (spline, s_curve, smooth_chain)[int(rng.integers(3))](rng))
        radius = rng.uniform(0.1, 0.4)
        cuts = np.sort(rng.uniform(0.15, 0.85, int(rng.integers(1, 3)))) * wall.domain[0][1]
        pairs, rest = [], [wall, floor]
        for at in cuts:
            both = [patch.split('u', at) for patch in rest]
            pairs.append([one for one, _ in both])
            rest = [one for _, one in both]
        pairs.append(rest)
        try:
            whole = build.fillet_patches(wall, 'v_start', floor, 'v_start', radius, tolerance=1e-4)
        except (sc.InvalidShape, sc.ToleranceNotReached):
            continue
        try:
            made = build.fillet_chain([mixed(rng, *pair) for pair in pairs], radius, tolerance=1e-4)
        except sc.ToleranceNotReached as refused:
            assert "abruptly" in str(refused), (seed, refused)
            continue
        made_count += 1
        assert len(made) == len(cuts) + 1
        for part in made:
            assert whole.fillet.nearest(grid(part.fillet, 7)).distances.max() <= 2.5e-4, seed
        require_closed_up(made, 2 * len(made) + 6)
    assert made_count > 0.6 * inputs(100)


def test_radii_along_a_chain():
    made = build.fillet_chain(edges_of(bend()), [(0, 0.5), (3, 1.5)], tolerance=1e-5)
    require_closed_up(made, 12)
    first, last = made[0].fillet, made[-1].fillet
    for patch, at, radius in ((first, 0, 0.5), (last, 1, 1.5)):
        u = patch.domain[0][at]
        assert patch.evaluate([u], [0])[0][2] == pytest.approx(radius, abs=0.05)


def test_what_is_no_chain_is_refused():
    pairs = bend()
    with pytest.raises(sc.InvalidShape, match="edges 1 and 2 of the chain lie .* apart"):
        build.fillet_chain(edges_of([pairs[0], pairs[2]]), 0.5)
    square = [straight_pair((0, 0, 0), (10, 0, 0), (0, -1, 0)), straight_pair((10, 0, 0), (10, 10, 0), (1, 0, 0))]
    with pytest.raises(sc.InvalidShape, match="edges 1 and 2 of the chain meet in a corner of 90 degrees"):
        build.fillet_chain(edges_of(square), 0.5)
    low = build.extrude(sc.BezierCurve([(10, 0, 0), (20, 0, 0)]), (0, 0, 2)), build.extrude(sc.BezierCurve([(10, 0, 0), (20, 0, 0)]), (0, -5, 0))
    with pytest.raises(sc.InvalidShape, match="first patches of edges 1 and 2 do not continue"):
        build.fillet_chain(edges_of([pairs[0], low]), 0.5)
    with pytest.raises(sc.InvalidShape, match="no edge"):
        build.fillet_chain([], 0.5)
    with pytest.raises(sc.InvalidShape, match="off the chain"):
        build.fillet_chain(edges_of(pairs), [(0, 0.5), (4, 0.5)])
    with pytest.raises(sc.InvalidShape, match="a patch and its side"):
        build.fillet_chain([(pairs[0][0], 'v_start')], 0.5)
