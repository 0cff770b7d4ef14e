"""What every mesh of a patch set must be: closed where the set is, without cracks, slivers and flipped faces."""

from typing import NamedTuple

import numpy as np

import meshes

SIDES = {'u_start': (0, 0.0), 'u_end': (0, 1.0), 'v_start': (1, 0.0), 'v_end': (1, 1.0)}


class Mesh(NamedTuple):
    """Corners of all faces in a row, and what belongs to each."""

    vertex: np.ndarray          # its number
    following: np.ndarray       # the next corner of its face
    face: np.ndarray
    patch: np.ndarray
    uv: np.ndarray              # (n, 2), in [0, 1]
    normal: np.ndarray          # (n, 3), of the surface
    positions: np.ndarray       # (vertices, 3)
    starts: np.ndarray


def mesh_of(patch_set, tessellation):
    positions, normals = tessellation.evaluate(patch_set)
    starts, count = tessellation.face_starts, len(tessellation.corner_vertices)
    sizes = np.diff([*starts, count])
    following = np.arange(1, count + 1)
    following[np.cumsum(sizes) - 1] = starts
    face = np.repeat(np.arange(len(starts)), sizes)
    return Mesh(tessellation.corner_vertices, following, face, tessellation.face_patches[face],
                tessellation.corner_uvs.astype(float), normals.astype(float), positions.astype(float), starts)


def edge_uses(mesh):
    """Of every corner, that of the edge from it to the next: (faces along it, faces along it the same way)."""
    a, b = mesh.vertex.astype(np.int64), mesh.vertex[mesh.following].astype(np.int64)
    count = len(mesh.positions)
    _, both, uses = np.unique(np.minimum(a, b) * count + np.maximum(a, b), return_inverse=True, return_counts=True)
    _, way, alike = np.unique(a * count + b, return_inverse=True, return_counts=True)
    return uses[both], alike[way]


def sides_of(patch_set, size):
    """Of every patch {side: one of 'pole', 'shared', 'free'}, found by sampling the curves of the sides."""
    t = np.linspace(0, 1, 34)
    lines = []
    for number in range(len(patch_set)):
        patch = patch_set[number].to_nurbs()
        for side, (axis, _) in SIDES.items():
            if not patch.periodic[axis]:
                curve = patch.boundary(side)
                start, end = curve.domain
                lines.append((number, side, curve.evaluate(np.clip(start + t * (end - start), start, end))))
    found = [{} for _ in range(len(patch_set))]
    near = lambda p, q: np.abs(p - q).max() <= 1e-9 * size
    for i, (number, side, line) in enumerate(lines):
        met = any(near(line, other) or near(line, other[::-1]) for j, (_, _, other) in enumerate(lines) if j != i)
        found[number][side] = 'pole' if near(line, line[:1]) else 'shared' if met else 'free'
    return found


def on_side(mesh, corners, number, side, kinds):
    """Which corners lie on a side of a patch; those at a pole lie on every side that ends there."""
    axis, at = SIDES[side]
    on = mesh.uv[corners, axis] == at
    for pole, kind in kinds.items():
        other, end = SIDES[pole]
        if kind == 'pole' and other != axis:
            on |= mesh.uv[corners, other] == end
    return on & (mesh.patch[corners] == number)


def check_borders(mesh, sides):
    """Edges have two faces that run against each other; where they have one they lie on a free side and fill it."""
    uses, alike = edge_uses(mesh)
    assert uses.max() <= 2, f"{(uses > 2).sum()} edges have more than two faces"
    assert alike.max() <= 1, f"{(alike > 1).sum()} edges are run through twice the same way"
    starts = np.flatnonzero(uses == 1)
    ends = mesh.following[starts]
    explained = np.zeros(len(starts), bool)
    for number, kinds in enumerate(sides):
        for side in (side for side, kind in kinds.items() if kind == 'free'):
            on = on_side(mesh, starts, number, side, kinds) & on_side(mesh, ends, number, side, kinds)
            along = 1 - SIDES[side][0]
            filled = np.abs(mesh.uv[starts[on], along] - mesh.uv[ends[on], along]).sum()
            assert abs(filled - 1) <= 1e-5, f"{side} of patch {number} is covered {filled} times by border"
            explained |= on
    assert explained.all(), f"{(~explained).sum()} edges are open inside or where patches meet"


def quality(p, q, r):
    """4 sqrt(3) area / sum of squared sides: 1 of an equilateral triangle, 0 of one without area."""
    a, b, c = q - p, r - q, p - r
    area = np.linalg.norm(np.cross(a, b), axis=-1) / 2
    return 4 * np.sqrt(3) * area / ((a * a).sum(-1) + (b * b).sum(-1) + (c * c).sum(-1))


def qualities(mesh, patch_set):
    """Of every triangle of mesh: its own, and that of the triangle with the same parameters in the tangent plane at
    their middle, that is what the parameterization alone makes of it."""
    triangles = meshes.triangles(mesh.starts, len(mesh.vertex))
    own = quality(*np.moveaxis(mesh.positions[mesh.vertex[triangles]], 1, 0))
    given = np.empty(len(triangles))
    for number in range(len(patch_set)):
        rows = np.flatnonzero(mesh.patch[triangles[:, 0]] == number)
        patch = patch_set[number]
        (a, b), (c, d) = patch.domain
        uv = mesh.uv[triangles[rows]] * (b - a, d - c)
        middle = uv.mean(axis=1) + (a, c)
        jets = patch.derivatives(np.clip(middle[:, 0], a, b), np.clip(middle[:, 1], c, d), 1)
        flat = uv[..., :1] * jets[:, None, 1, 0] + uv[..., 1:] * jets[:, None, 0, 1]
        given[rows] = quality(*np.moveaxis(flat, 1, 0))
    return own, given


def face_normals(mesh):
    """Twice the area of each face along its mean normal."""
    p = mesh.positions[mesh.vertex]
    origin = p[mesh.starts][mesh.face]
    return np.add.reduceat(np.cross(p - origin, p[mesh.following] - origin), mesh.starts, axis=0)


def corner_normals(mesh):
    """Of every corner the unit normal of the triangle with its neighbors."""
    p = mesh.positions[mesh.vertex]
    before = np.empty_like(mesh.following)
    before[mesh.following] = np.arange(len(before))
    normals = np.cross(p[mesh.following] - p, p[before] - p)
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def mean_normals(mesh, patch_set, count=4):
    """Of every face the direction of S_u x S_v, added up at count x count places between its parameters."""
    low, high = np.minimum.reduceat(mesh.uv, mesh.starts), np.maximum.reduceat(mesh.uv, mesh.starts)
    parts = (np.arange(count) + 0.5) / count
    u, v = (low[:, None, i] + (high - low)[:, None, i] * parts for i in range(2))
    found = np.empty((len(mesh.starts), 3))
    for number in range(len(patch_set)):
        (a, b), (c, d) = patch_set[number].domain
        faces = np.flatnonzero(mesh.patch[mesh.starts] == number)
        at_u, at_v = np.broadcast_arrays((a + (b - a) * u[faces])[:, :, None], (c + (d - c) * v[faces])[:, None, :])
        jets = patch_set[number].derivatives(at_u, at_v, 1)
        found[faces] = np.cross(jets[..., 1, 0, :], jets[..., 0, 1, :]).sum(axis=(1, 2))
    return found / np.linalg.norm(found, axis=1)[:, None]


def surface_normals(mesh, patch_set):
    """Of every corner the direction of S_u x S_v a thousandth of the way into its face; NaN where that is none."""
    sizes = np.bincount(mesh.face)[:, None]
    middles = (np.add.reduceat(mesh.uv, mesh.starts) / sizes)[mesh.face]
    uv = mesh.uv + 1e-3 * (middles - mesh.uv)
    found = np.empty((len(uv), 3))
    for number in range(len(patch_set)):
        (a, b), (c, d) = patch_set[number].domain
        corners = np.flatnonzero(mesh.patch == number)
        jets = patch_set[number].derivatives(a + (b - a) * uv[corners, 0], c + (d - c) * uv[corners, 1], 1)
        found[corners] = np.cross(jets[:, 1, 0], jets[:, 0, 1])
    with np.errstate(invalid='ignore'):
        return found / np.linalg.norm(found, axis=1)[:, None]


def turning(mesh, normals):
    """The largest angle between neighboring or opposite normals on each face; NaN where one is none."""
    opposite = mesh.following[mesh.following]
    cosines = np.minimum((normals * normals[mesh.following]).sum(axis=1), (normals * normals[opposite]).sum(axis=1))
    return np.arccos(np.clip(np.minimum.reduceat(cosines, mesh.starts), -1, 1))


def check_faces(mesh, patch_set):
    """No face is empty; each runs round its parameters the right way. At every corner it looks the way the surface does
    on it in the mean, and where that turns by less than 60 degrees as it does there. Normals are those of the surface."""
    normals = face_normals(mesh)
    areas = np.linalg.norm(normals, axis=1) / 2
    edges = mesh.positions[mesh.vertex] - mesh.positions[mesh.vertex[mesh.following]]
    lengths = np.linalg.norm(edges, axis=1)
    longest = np.maximum.reduceat(lengths, mesh.starts)
    assert (lengths > 1e-5 * longest[mesh.face]).all(), "an edge has no length"
    assert (areas > 1e-5 * longest**2).all(), f"{(areas <= 1e-5 * longest**2).sum()} faces have no area"
    (u, v), (next_u, next_v) = mesh.uv.T, mesh.uv[mesh.following].T
    assert (np.add.reduceat(u * next_v - next_u * v, mesh.starts) > 0).all(), "a face is wound backwards"
    own, expected = corner_normals(mesh), surface_normals(mesh, patch_set)
    cosines = (own * mean_normals(mesh, patch_set)[mesh.face]).sum(axis=1)
    there = (own * expected).sum(axis=1)
    cosines = np.where(turning(mesh, expected)[mesh.face] < np.radians(60), np.minimum(cosines, there), cosines)
    wrong = ~(cosines > 0)
    assert not wrong.any(), f"{wrong.sum()} corners are turned from the surface: cosines from {cosines.min():.2f}"
    cosines = (mesh.normal * expected).sum(axis=1)
    wrong = ~(cosines > 0.9) & np.isfinite(expected).all(axis=1)
    assert not wrong.any(), f"{wrong.sum()} normals are not those of the surface: cosines {cosines[wrong]}"


def check_no_vertex_on_an_edge(mesh, size):
    """No vertex of a border lies inside another edge of a border."""
    uses, _ = edge_uses(mesh)
    border = np.flatnonzero(uses == 1)
    a, b = mesh.positions[mesh.vertex[border]], mesh.positions[mesh.vertex[mesh.following[border]]]
    steps = b - a
    for vertex in np.unique(mesh.vertex[border]):
        share = ((mesh.positions[vertex] - a) * steps).sum(axis=1) / (steps * steps).sum(axis=1)
        away = np.linalg.norm(a + share[:, None] * steps - mesh.positions[vertex], axis=1)
        inside = (share > 1e-3) & (share < 1 - 1e-3) & (away <= 1e-6 * size)
        assert not inside.any(), f"vertex {vertex} lies inside the edge of another face"


def check(patch_set, tessellation):
    """All of it. A triangle has a quality of 0.1 at least, but where the parameterization alone makes it worse
    (thin cells, and round a pole): there it keeps a quarter of what that gives, since cells of other sizes are
    joined by triangles of a part of their height."""
    mesh = mesh_of(patch_set, tessellation)
    size = np.abs(mesh.positions).max()
    check_borders(mesh, sides_of(patch_set, size))
    check_faces(mesh, patch_set)
    check_no_vertex_on_an_edge(mesh, size)
    own, given = qualities(mesh, patch_set)
    bound = np.minimum(given / 4, 0.1)
    worst = (own / bound).argmin()
    found = f"a sliver of quality {own[worst]:.4f}, where the parameterization gives {given[worst]:.4f}"
    assert own[worst] >= bound[worst], found
