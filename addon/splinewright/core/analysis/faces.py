"""The faces of a surface with what they are painted by: exact normals, and a number at each corner."""

from typing import NamedTuple

import numpy as np

from ..verbs.patch_verbs import Along
from .lines import ends_of

#: So far, as a part of its face, a corner where a span ends is moved into it before its curvature or its normal is
#: measured: at a knot that of its own side counts, and at a pole there is one.
_INTO, _INTO_FOR_NORMALS = 1e-3, 1e-6
#: Of parameters in float32.
_ROUNDING = 2e-7
#: The numbers by which a surface is painted.
CURVATURES = {
    'GAUSS': lambda patch, u, v: patch.curvatures(u, v).gauss,
    'MEAN': lambda patch, u, v: patch.curvatures(u, v).mean,
    'LARGEST': lambda patch, u, v: patch.curvatures(u, v).principal.max(-1),
    'SMALLEST': lambda patch, u, v: patch.curvatures(u, v).principal.min(-1),
}
#: Triangles are cut into no more parts than this along a side, and all into no more than so many together.
_MOST_CUTS, _MOST_PARTS = 6, 40_000
#: Of a normal that is no longer than this part of what it is made of there is too little left.
_DEGENERATE = 1e-9


class Places(NamedTuple):
    """Where on patches something lies."""

    patches: np.ndarray                 # (n,): their numbers
    parts: np.ndarray                   # (n, 2) float32: parts of the domains


class Faces(NamedTuple):
    """Corners that are alike are one."""

    positions: np.ndarray               # (n, 3) float32
    normals: np.ndarray                 # (n, 3) float32
    values: np.ndarray                  # (n,) float32; nan where there is none
    triangles: np.ndarray               # (t, 3) int32


def colored(tessellation, patch_set, value):
    """The Faces of patches with a number of CURVATURES. Raises as splinecore.Tessellation.evaluate()."""
    positions, normals = tessellation.evaluate(patch_set)
    corners, starts, uvs = tessellation.corner_vertices, tessellation.face_starts, tessellation.corner_uvs
    sizes = np.diff(np.append(starts, len(uvs)))
    middles = np.repeat(np.add.reduceat(uvs.astype(np.float64), starts) / sizes[:, None], sizes, 0)
    patches = np.repeat(tessellation.face_patches, sizes)
    values = _measured(patch_set, patches, uvs, middles, CURVATURES[value], (), _INTO).astype(np.float32)
    kept, number = _welded(corners, np.column_stack([normals, values]))
    return Faces(positions[corners[kept]], normals[kept], values[kept], number[_fans(starts, len(corners))])


def shaded(tessellation, patch_set):
    """The Faces of patches where normals are exact inside of large faces, too; values are 0. Raises as colored()."""
    return placed(tessellation, patch_set)[0]


def placed(tessellation, patch_set):
    """(shaded(), the Places of its corners). Raises as colored()."""
    positions, normals = tessellation.evaluate(patch_set)
    sizes = np.diff(np.append(tessellation.face_starts, len(tessellation.corner_vertices)))
    corners, fans = tessellation.corner_vertices, _fans(tessellation.face_starts, len(tessellation.corner_vertices))
    cuts = int(np.clip(np.sqrt(_MOST_PARTS / max(len(fans), 1)), 1, _MOST_CUTS))
    if cuts == 1:
        kept, number = _welded(corners, normals)
        here = Places(np.repeat(tessellation.face_patches, sizes)[kept], tessellation.corner_uvs[kept])
        return Faces(positions[corners[kept]], normals[kept], np.zeros(len(kept), np.float32), number[fans]), here
    shares, parts = _cut(cuts)
    at, uvs, about = (np.einsum('ms,tsk->tmk', shares, rows[fans]) for rows in (
        positions[corners], tessellation.corner_uvs, normals))
    patches = np.repeat(np.repeat(tessellation.face_patches, sizes - 2), len(shares))
    middles = np.repeat(uvs.mean(1), len(shares), 0)
    places = uvs.reshape(-1, 2).astype(np.float32)
    exact = _measured(patch_set, patches, places, middles, _normals, (3,), _INTO_FOR_NORMALS)
    about = about.reshape(-1, 3)
    is_known = np.isfinite(exact).all(1) & ~np.tile((shares == 1).any(1), len(fans))
    exact *= np.where((exact * about).sum(1) < 0, -1.0, 1.0)[:, None]
    found = np.where(is_known[:, None], exact, about).astype(np.float32)
    triangles = (len(shares) * np.arange(len(fans))[:, None, None] + parts).reshape(-1, 3).astype(np.int32)
    faces = Faces(at.reshape(-1, 3).astype(np.float32), found, np.zeros(len(found), np.float32), triangles)
    return faces, Places(patches, places)


def reach(faces, part=0.9):
    """What the numbers of so large a part of the surface are not beyond, above 0; 0 where there are none."""
    corners = faces.positions[faces.triangles].astype(np.float64)
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    sizes = np.abs(faces.values[faces.triangles]).max(1, initial=0.0)
    is_known = np.isfinite(sizes)
    order = np.argsort(sizes[is_known])
    sizes, total = sizes[is_known][order], np.cumsum(areas[is_known][order])
    if not len(sizes) or total[-1] == 0.0:
        return 0.0
    return float(sizes[np.searchsorted(total, part * total[-1])])


def _cut(cuts):
    """(the shares (m, 3) that corners of a triangle have in points inside of it, the triangles (cuts², 3) between)."""
    places = [(i, j) for i in range(cuts + 1) for j in range(cuts + 1 - i)]
    number = {place: k for k, place in enumerate(places)}
    parts = []
    for i, j in places:
        if i + j < cuts:
            parts.append((number[i, j], number[i + 1, j], number[i, j + 1]))
        if i + j < cuts - 1:
            parts.append((number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]))
    return np.array([(cuts - i - j, i, j) for i, j in places]) / cuts, np.array(parts)


def _normals(patch, u, v):
    """(n, 3): nan where there are none."""
    found = patch.derivatives(u, v, 1)
    along_u, along_v = found[:, 1, 0], found[:, 0, 1]
    across = np.cross(along_u, along_v)
    length = np.linalg.norm(across, axis=1)
    with np.errstate(all='ignore'):
        across /= np.where(length > _DEGENERATE * np.linalg.norm(along_u, axis=1) * np.linalg.norm(along_v, axis=1),
                           length, np.nan)[:, None]
    return across


def _measured(patch_set, patches, uvs, middles, measure, shape, into):
    """(n, *shape): what measure(patch, u, v) says at places of patches, as seen from the middles of their faces.

    uvs: float32, parts of the domains. into: how far towards the middles those are moved where a span ends, as a part.
    """
    found = np.empty((len(uvs), *shape))
    for number in np.unique(patches):
        here = patches == number
        found[here] = _of_patch(patch_set[int(number)], uvs[here], middles[here], measure, shape, into)
    return found


def _of_patch(patch, uvs, middles, measure, shape, into):
    """Inside a span all faces see the same: there places that are equal are measured once."""
    ends, is_end = _at_ends(patch, uvs)
    inner, number = np.unique(np.ascontiguousarray(uvs[~is_end]).view(np.uint64).ravel(), return_inverse=True)
    ends += into * (middles[is_end] - ends)
    places = np.concatenate([inner.view(np.float32).reshape(-1, 2).astype(np.float64), ends])
    (start_u, end_u), (start_v, end_v) = patch.domain
    measured = measure(patch, start_u + places[:, 0] * (end_u - start_u), start_v + places[:, 1] * (end_v - start_v))
    found = np.empty((len(uvs), *shape))
    found[~is_end], found[is_end] = measured[:len(inner)][number], measured[len(inner):]
    return found


def _at_ends(patch, uvs):
    """(the places in float64 that lie where a span ends, (n,) bool: which these are)."""
    exact, found = uvs.astype(np.float64), np.zeros(len(uvs), bool)
    for axis, (start, end) in enumerate(patch.domain):
        ends = (ends_of(Along(patch, 'uv'[axis])) - start) / (end - start)
        after = np.searchsorted(ends, uvs[:, axis]).clip(1, len(ends) - 1)
        for near in (ends[after - 1], ends[after]):
            there = np.abs(uvs[:, axis] - near) <= _ROUNDING
            exact[there, axis] = near[there]
            found |= there
    return exact[found], found


def _welded(vertices, rows):
    """(the corners that are kept, of every corner the number of its like among them): those of one vertex that have
    equal rows are one."""
    all_corners = np.arange(len(vertices))
    first = np.zeros(vertices.max(initial=-1) + 1, np.int64)
    first[vertices[::-1]] = all_corners[::-1]
    first = first[vertices]
    like = np.where((rows == rows[first]).all(1), first, all_corners)
    is_kept = like == all_corners
    return np.flatnonzero(is_kept), (np.cumsum(is_kept) - 1)[like].astype(np.int32)


def _fans(starts, count):
    """(t, 3): the corners of triangles into which faces are cut, from the first corner of each."""
    sizes = np.diff(np.append(starts, count))
    owners = np.repeat(np.arange(len(starts)), sizes - 2)
    step = np.arange(len(owners)) - np.repeat(np.cumsum(sizes - 2) - (sizes - 2), sizes - 2)
    first = starts[owners]
    return np.stack([first, first + step + 1, first + step + 2], -1)
