"""Catmull and Clark's scheme: regular faces in closed form, limits by many rounds, common tangent planes, meshes refused."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from test_frames_anywhere import rotation

CUBE = ([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)],
        [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
TETRAHEDRON = ([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])


def sheet(count, seed=1, bump=0.3):
    rng = np.random.default_rng(seed)
    points = [(i + rng.uniform(-.2, .2), j + rng.uniform(-.2, .2), rng.normal(0, bump)) for i in range(count) for j in range(count)]
    faces = [(i * count + j, (i + 1) * count + j, (i + 1) * count + j + 1, i * count + j + 1)
             for i in range(count - 1) for j in range(count - 1)]
    return np.array(points), faces


def fan(valence, is_open=False, seed=0):
    """Faces round a point, with a second ring of them where it is closed."""
    rng = np.random.default_rng(seed)
    whole = np.pi if is_open else 2 * np.pi
    spokes = valence + 1 if is_open else valence
    points = [np.array([0, 0, 0.4])]
    for i in range(spokes):
        a = whole * i / valence
        points.append(np.array([np.cos(a), np.sin(a), rng.normal(0, 0.1)]))
    for i in range(valence):
        a = whole * (i + 0.5) / valence
        points.append(1.5 * np.array([np.cos(a), np.sin(a), -0.2 + rng.normal(0, 0.1)]))
    faces = [(0, 1 + i, 1 + spokes + i, 1 + (i + 1) % spokes) for i in range(valence)]
    return np.array(points), faces


def subdivide(points, faces):
    """An independent one, by dictionaries."""
    points = [np.asarray(p, float) for p in points]
    middle = [np.mean([points[v] for v in face], axis=0) for face in faces]
    edges, around = {}, {i: [] for i in range(len(points))}
    for f, face in enumerate(faces):
        for k, v in enumerate(face):
            edges.setdefault(frozenset((v, face[(k + 1) % len(face)])), []).append(f)
            around[v].append(f)
    neighbors = {i: [e for e in edges if i in e] for i in range(len(points))}
    moved = []
    for i, p in enumerate(points):
        border = [e for e in neighbors[i] if len(edges[e]) == 1]
        if len(around[i]) == 1 and border:
            moved.append(p)
        elif border:
            moved.append(0.75 * p + sum(0.125 * points[next(iter(e - {i}))] for e in border))
        else:
            n = len(around[i])
            f = np.mean([middle[k] for k in around[i]], axis=0)
            r = np.mean([np.mean([points[v] for v in e], axis=0) for e in neighbors[i]], axis=0)
            moved.append((f + 2 * r + (n - 3) * p) / n)
    numbers = {}
    for e, of in edges.items():
        numbers[e] = len(moved)
        ends = np.mean([points[v] for v in e], axis=0)
        moved.append(ends if len(of) == 1 else (2 * ends + middle[of[0]] + middle[of[1]]) / 4)
    made = []
    for f, face in enumerate(faces):
        for k, v in enumerate(face):
            made.append((v, numbers[frozenset((v, face[(k + 1) % len(face)]))], len(moved) + f,
                         numbers[frozenset((face[k - 1], v))]))
    return np.array(moved + middle), made


def limit_points(points, faces, rounds):
    """Where the points of a mesh of four-sided faces, subdivided so often, converge to, but for those on the border."""
    for _ in range(rounds):
        points, faces = subdivide(points, faces)
    sums, counts, edges = {}, {}, {}
    for face in faces:
        for k, v in enumerate(face):
            sums.setdefault(v, np.zeros(3))
            sums[v] = sums[v] + points[face[(k + 2) % 4]] + 2 * points[face[(k + 1) % 4]] + 2 * points[face[k - 1]]
            counts[v] = counts.get(v, 0) + 1
            edges.setdefault(frozenset((v, face[(k + 1) % 4])), []).append(1)
    border = {v for e, of in edges.items() if len(of) == 1 for v in e}
    return np.array([(counts[v] ** 2 * points[v] + sums[v]) / (counts[v] * (counts[v] + 5)) for v in sums if v not in border])


def distances(points, patches):
    return np.min([patch.nearest(points).distances for patch in patches], axis=0)


def test_a_sheet_is_a_cubic_spline():
    """Inside that of its points as control points of one uniform patch."""
    points, faces = sheet(7)
    made = build.catmull_clark(points, faces)
    assert made.rounds == 0 and made.irregular == 0 and len(made.patches) == 36
    spline = sc.NurbsPatch((3, 3), (np.arange(-3.0, 8.0), np.arange(-3.0, 8.0)), points.reshape(7, 7, 3))
    t = np.linspace(0, 1, 9)
    for k in range(1, 5):
        for m in range(1, 5):
            want = spline.evaluate_grid(k - 1 + t, m - 1 + t)
            assert np.abs(made.patches[k * 6 + m].evaluate_grid(t, t) - want).max() <= 1e-13


def test_limits_of_regular_faces_to_the_last_digits():
    points, faces = sheet(6, seed=4)
    made = build.catmull_clark(points, faces)
    for rounds in (0, 2):
        assert distances(limit_points(points, faces, rounds)[:200], made.patches).max() <= 1e-12


def test_borders_are_cubic_splines_and_corners_stay():
    points, faces = sheet(4)
    made = build.catmull_clark(points, faces)
    assert np.abs(made.patches[0].evaluate(0, 0) - points[0]).max() <= 1e-15
    a, b, c = points[0], points[4], points[8]
    assert np.abs(made.patches[0].evaluate(1, 0) - (a + 4 * b + c) / 6).max() <= 1e-15


@pytest.mark.parametrize("mesh", [CUBE, TETRAHEDRON, fan(3), fan(5), fan(6), fan(9), fan(3, True), fan(5, True)],
                         ids=["cube", "tetrahedron", "3", "5", "6", "9", "open 3", "open 5"])
def test_tangent_planes_are_common_everywhere(mesh):
    made = build.catmull_clark(*mesh)
    assert made.irregular > 0
    assert made.angle <= 1e-9


@pytest.mark.parametrize("mesh, off", [(CUBE, 0.02), (fan(3), 0.03), (fan(5), 0.03), (fan(8), 0.05)], ids=["cube", "3", "5", "8"])
def test_about_extraordinary_points_it_is_near_the_limit(mesh, off):
    """A part of the size of the faces there; the point itself is that of the surface."""
    made = build.catmull_clark(*mesh)
    limits = limit_points(*mesh, 3)
    assert distances(limits[::7], made.patches).max() <= off
    if mesh is not CUBE:
        first = limit_points(*mesh, 0)
        assert distances(first, made.patches).max() <= 1e-12


def test_the_cube_becomes_a_closed_surface():
    made = build.catmull_clark(*CUBE)
    assert made.rounds == 1 and len(made.patches) == 24
    assert sc.PatchSet.from_patches(made.patches).volume() == pytest.approx(2.6, rel=0.1)


def with_fold(points, faces, at=0):
    """A face parted along its diagonal by two edges through a new point, which has two faces."""
    points = [tuple(p) for p in points]
    a, b, c, d = faces[at]
    middle = tuple(np.mean([points[i] for i in (a, b, c, d)], axis=0))
    split = [(a, b, c, len(points)), (a, len(points), c, d)]
    return [*points, middle], [*faces[:at], *split, *faces[at + 1:]]


@pytest.mark.parametrize("mesh", [with_fold(*CUBE), with_fold(*with_fold(*CUBE), at=4), with_fold(*sheet(5), at=5),
                                  ([(0, 0, 0), (1, 0, 0.1), (1, 1, 0), (0, 1, 0.1)], [(0, 1, 2, 3), (3, 2, 1, 0)])])
def test_points_inside_with_two_faces_leave_no_fold(mesh):
    """As Suzanne has some: the surface is closed round about, and has common tangent planes."""
    made = build.catmull_clark(*mesh)
    seams = sc.PatchSet.from_patches(list(made.patches))
    assert made.angle < 1e-10
    points = np.concatenate([patch.evaluate_grid(*(np.linspace(*domain, 5) for domain in patch.domain)).reshape(-1, 3)
                             for patch in made.patches])
    assert np.isfinite(points).all() and (np.abs(points) <= np.abs(np.array(mesh[0])).max(axis=0) + 1e-12).all()
    if len(mesh[0]) < 12:
        assert seams.edge_counts()['free'] == 0


@pytest.mark.parametrize("count", [3, 50, 200])
def test_faces_of_many_corners(count):
    """A prism: its lids are smooth about their middles, however many patches run together there."""
    angles = 2 * np.pi * np.arange(count) / count
    rim = np.c_[np.cos(angles), np.sin(angles)]
    points = np.r_[np.c_[rim, np.zeros(count)], np.c_[rim, np.ones(count)]]
    around = np.arange(count)
    faces = [list(around[::-1]), list(count + around), *np.c_[around, np.roll(around, -1), count + np.roll(around, -1), count + around]]
    found = build.catmull_clark(points, [list(map(int, face)) for face in faces])
    assert found.angle <= 1e-8
    lids = np.array([point for patch in found.patches for point in patch.points.reshape(-1, 3)])
    assert np.abs(lids[:, 2] - 0.5).max() <= 0.5 and np.hypot(lids[:, 0], lids[:, 1]).max() <= 1


@pytest.mark.parametrize("size", [1e-150, 1e-3, 1e150])
def test_any_size(size):
    one = build.catmull_clark(*CUBE)
    other = build.catmull_clark(np.array(CUBE[0]) * size, CUBE[1])
    for a, b in zip(one.patches, other.patches):
        assert np.abs(np.asarray(b.points) / size - a.points).max() <= 1e-6
    assert other.angle <= 1e-9


def test_random_meshes():
    """Faces of three and four sides taken out of a sheet and split at will."""
    rng = np.random.default_rng(3)
    for round in range(40):
        count = int(rng.integers(3, 6))
        points, faces = sheet(count, seed=round)
        kept = []
        for face in faces:
            kind = rng.integers(4)
            if kind == 1:
                kept += [face[:3], (face[0], face[2], face[3])]
            else:
                kept.append(face)
        made = build.catmull_clark(points, kept)
        assert made.angle <= 1e-6
        assert all(np.isfinite(patch.points).all() for patch in made.patches)


@pytest.mark.parametrize("points, faces, words", [
    ([(0, 0, 0)], [], "no face"),
    (CUBE[0], [(0, 1)], "fewer than three"),
    (CUBE[0], [(0, 1, 1)], "twice"),
    (CUBE[0], [(0, 1, 9)], "none of the 8 points"),
    (CUBE[0], [(0, 1, -1)], "none of the 8 points"),
    (TETRAHEDRON[0], [(0, 1, 2), (0, 1, 3)], "turned differently"),
    (CUBE[0], [(0, 1, 2), (0, 3, 4)], "alone"),
    ([(0, 0, np.nan), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)], "not finite"),
    ([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], "shape"),
])
def test_meshes_that_are_none_are_refused(points, faces, words):
    with pytest.raises(sc.InvalidShape, match=words):
        build.catmull_clark(points, faces)


@pytest.mark.parametrize("faces", [3, "abc", [(0, 1, "2")], [(0.5, 1, 2)]])
def test_faces_are_lists_of_numbers(faces):
    with pytest.raises(TypeError):
        build.catmull_clark(CUBE[0], faces)


def limit_normal(points, faces, vertex):
    """Of the scheme: the plane through where neighbors lie after many rounds, from the left eigenvectors of one round."""
    for _ in range(2):
        points, faces = subdivide(points, faces)
    beside = {face[face.index(vertex) + 1 - 4]: (face[(face.index(vertex) + 2) % 4], face[face.index(vertex) - 1])
              for face in faces if vertex in face}
    ring = [next(iter(beside))]
    while len(ring) < len(beside):
        ring.append(beside[ring[-1]][1])
    n = len(ring)
    a = 2 * np.pi / n * np.arange(n)
    c = np.cos(2 * np.pi / n)
    edges = 1 + c + np.cos(np.pi / n) * np.sqrt(2 * (9 + c))
    tangents = []
    for f in (np.cos, np.sin):
        tangents.append(edges * f(a) @ points[ring] + (f(a) + f(a + 2 * np.pi / n)) @ points[[beside[e][0] for e in ring]])
    normal = np.cross(*tangents)
    return normal / np.linalg.norm(normal)


def test_normals_at_extraordinary_points_are_those_of_the_scheme(inputs):
    """Of bent, steep, thin and crumpled meshes, anywhere: every patch that ends there has it, and no patch lies face down."""
    rng = np.random.default_rng(8)
    for seed in range(inputs(1000)):
        valence = int(rng.choice([3, 5, 6, 7, 9, 12, 20, 40]))
        points, faces = fan(valence, seed=seed)
        points = points * [1, 10**rng.uniform(-2, 0), 10**rng.uniform(-2, 2)] + rng.choice([0, 0.1, 0.3]) * rng.normal(size=points.shape)
        if rng.random() < 0.2:
            points[1] = points[2]
        size, scale, far, turn = np.ptp(points, axis=0).max(), 10**rng.uniform(-12, 9), rng.choice([0, 1, 1e3, 1e6]), rotation(rng)
        points = scale * (points @ turn.T + far * size * rng.uniform(-1, 1, 3))
        want = limit_normal(points - points[0], faces, 0)  # of points as far away rounds them
        made = build.catmull_clark(points, faces)
        middle = limit_points(points, faces, 0)[0]
        found = 0
        for patch in made.patches:
            if np.abs(patch.evaluate(1, 1) - middle).max() > (1e-9 + 1e-13 * far) * size * scale:
                continue
            found += 1
            _, normals = patch.evaluate_grid_with_normals([1.0], [1.0])
            assert np.linalg.norm(normals[0, 0] - want) <= 1e-9 + 1e-11 * far, seed  # patches are rounded there, too
        assert found == valence and made.angle <= 1e-8 + 1e-12 * far, seed


def test_normals_where_three_faces_meet_on_the_border():
    """The scheme comes near to its tangent plane by 0.82 a round."""
    points, faces = fan(3, is_open=True, seed=3)
    points = points * [1, 1, 2] + np.random.default_rng(5).normal(0, 0.1, points.shape)
    middle = (points[1] + 4 * points[0] + points[4]) / 6
    made = build.catmull_clark(points, faces)
    for _ in range(30):
        points, faces = subdivide(points, faces)
        near = {v for face in faces if 0 in face for v in face}
        for _ in range(2):
            near = {v for face in faces if near & set(face) for v in face}
        kept = sorted(near)
        numbers = {v: i for i, v in enumerate(kept)}
        points, faces = points[kept], [tuple(numbers[v] for v in face) for face in faces if set(face) <= near]
    ring = points[sorted({v for face in faces if 0 in face for v in face})]
    want = np.linalg.svd(ring - points[0])[2][2]
    found = [patch.evaluate_grid_with_normals([1.0], [1.0])[1][0, 0] for patch in made.patches
             if np.abs(patch.evaluate(1, 1) - middle).max() <= 1e-9]
    assert len(found) == 3
    for normal in found:
        assert np.linalg.norm(np.cross(normal, want)) <= 1e-3
