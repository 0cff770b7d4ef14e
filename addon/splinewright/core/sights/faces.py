"""The faces of a surface with what they are painted by: exact normals, and a number at each corner."""

from typing import NamedTuple

import numpy as np

from ..patch_verbs import Along
from .lines import ends_of

#: So far, as a part of its face, a corner is moved into it before its curvature is measured: at a knot that of its own
#: side counts, and at a pole there is one.
_INTO = 1e-3
#: Of parameters in float32.
_ROUNDING = 2e-7
#: The numbers by which a surface is painted.
CURVATURES = {
    'GAUSS': lambda found: found.gauss,
    'MEAN': lambda found: found.mean,
    'LARGEST': lambda found: found.principal.max(-1),
    'SMALLEST': lambda found: found.principal.min(-1),
}


class Faces(NamedTuple):
    """Corners that are alike are one."""

    positions: np.ndarray               # (n, 3) float32
    normals: np.ndarray                 # (n, 3) float32
    values: np.ndarray                  # (n,) float32; nan where there is none
    triangles: np.ndarray               # (t, 3) int32


def of(tessellation, patch_set, value=None):
    """The Faces of patches. value: of CURVATURES, or None for zeros.

    Raises as splinecore.Tessellation.evaluate().
    """
    positions, normals = tessellation.evaluate(patch_set)
    corners = tessellation.corner_vertices
    values = curvatures(tessellation, patch_set, value) if value else np.zeros(len(corners), np.float32)
    kept, number = _welded(corners, np.column_stack([normals, values]))
    starts = tessellation.face_starts
    return Faces(positions[corners[kept]], normals[kept], values[kept], number[_fans(starts, len(corners))])


def curvatures(tessellation, patch_set, value):
    """(c,) float32: a curvature at each corner, seen from its face; nan where there is none."""
    starts, uvs = tessellation.face_starts, tessellation.corner_uvs
    sizes = np.diff(np.append(starts, len(uvs)))
    middles = np.repeat(np.add.reduceat(uvs.astype(np.float64), starts) / sizes[:, None], sizes, 0)
    patch_of = np.repeat(tessellation.face_patches, sizes)
    found = np.empty(len(uvs), np.float32)
    for number in np.unique(patch_of):
        here = patch_of == number
        found[here] = _of_patch(patch_set[int(number)], uvs[here], middles[here], CURVATURES[value])
    return found


def _of_patch(patch, uvs, middles, choose):
    """Inside a span all faces see the same: there places that are equal are measured once."""
    is_end = _at_ends(patch, uvs)
    inner, number = np.unique(np.ascontiguousarray(uvs[~is_end]).view(np.uint64).ravel(), return_inverse=True)
    ends = uvs[is_end] + _INTO * (middles[is_end] - uvs[is_end])
    places = np.concatenate([inner.view(np.float32).reshape(-1, 2).astype(np.float64), ends])
    (start_u, end_u), (start_v, end_v) = patch.domain
    measured = choose(patch.curvatures(start_u + places[:, 0] * (end_u - start_u),
                                       start_v + places[:, 1] * (end_v - start_v)))
    found = np.empty(len(uvs), np.float32)
    found[~is_end], found[is_end] = measured[:len(inner)][number], measured[len(inner):]
    return found


def _at_ends(patch, uvs):
    """(c,) bool: which corners lie where a span ends."""
    found = np.zeros(len(uvs), bool)
    for axis, (start, end) in enumerate(patch.domain):
        ends = (ends_of(Along(patch, 'uv'[axis])) - start) / (end - start)
        after = np.searchsorted(ends, uvs[:, axis]).clip(1, len(ends) - 1)
        for near in (ends[after - 1], ends[after]):
            found |= np.abs(uvs[:, axis] - near) <= _ROUNDING
    return found


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
