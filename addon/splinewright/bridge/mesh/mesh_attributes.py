"""What users put on a mesh, carried over to other faces of the same patches.

Numbers are interpolated over the parameters of each patch, which every corner keeps; whole numbers, texts and
switches are those of the nearest corner. What lies on edges is mesh_marks'.
"""

import contextlib
import itertools
from typing import NamedTuple

import numpy as np
from mathutils.bvhtree import BVHTree

from ...core.base.words import phrase
from . import mesh_groups, mesh_layers, mesh_marks, mesh_sharp
from .mesh_layers import ATTRIBUTES, Layer, MOST_UV_MAPS, UV_NAME, read


class Kept(NamedTuple):
    """What was on a mesh, and the triangles over whose parameters it lies."""

    layers: list                        # of vertices, faces and corners
    marks: list                         # of mesh_marks
    groups: object                      # mesh_groups.Groups or None
    triangles: np.ndarray               # (t, 3) corners
    corners: np.ndarray                 # (c, 3) parameters
    vertices: np.ndarray                # (c,) the vertex of each corner
    faces: np.ndarray                   # (t,) the face of each triangle
    active: dict                        # of mesh_layers.active()


def write_parameters(mesh, tessellation):
    """Keep for each corner of new faces where it lies."""
    mesh_layers.write_parameters(mesh, _parameters(tessellation))


def lies_as(mesh, tessellation):
    """Whether each corner of a mesh with these faces lies where write_parameters() would put it, if the mesh has these at all."""
    known = mesh_layers.parameters(mesh, tessellation.corner_vertices)
    return known is None or np.array_equal(known, _parameters(tessellation))


def _parameters(tessellation):
    values = np.empty((len(tessellation.corner_vertices), 3), np.float32)
    values[:, :2] = tessellation.corner_uvs
    values[:, 2] = np.repeat(tessellation.face_patches, np.diff(np.append(tessellation.face_starts, len(values))))
    return values


@contextlib.contextmanager
def moved(mesh, owner, uneven, parents, places):
    """While other patches are written, what lies on the faces lies on those: each came of one of `parents`, and lies
    there in a core.shape.places.Place. Where that fails it lies where it lay. uneven: of mesh_looks.kept()."""
    kept = keep(mesh, owner, uneven)
    if kept is None:
        yield
        return
    layer = mesh.uv_layers.get(UV_NAME)
    uvs = read(*mesh_layers.uv_of(layer), 2, np.float32) if layer is not None else None
    is_ours = uvs is not None and np.abs(uvs - kept.corners[:, :2]).max() <= 1e-6
    corners = _on_parts(mesh, kept.corners, parents, places)
    _put(mesh, corners, corners[:, :2] if is_ours else None)
    mesh_marks.remember(mesh, mesh_marks.moved(kept.marks, parents, places), is_certain=True)
    try:
        yield
        mesh_marks.be_uncertain(mesh)
    except Exception:
        _put(mesh, kept.corners, uvs if is_ours else None)
        mesh_marks.remember(mesh, kept.marks)
        raise


def _put(mesh, corners, uvs):
    mesh_layers.write_parameters(mesh, corners.astype(np.float32))
    if uvs is not None:
        data, field = mesh_layers.uv_of(mesh.uv_layers[UV_NAME])
        data.foreach_set(field, np.ascontiguousarray(uvs, np.float32).ravel())


def _on_parts(mesh, corners, parents, places):
    """(c, 3): the parameters of corners on the patches that came of theirs; a face lies where its middle lies."""
    starts = read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(corners)))
    middles, found = np.add.reduceat(corners, starts) / counts[:, None], corners.copy()
    for number, (parent, place) in enumerate(zip(parents, places)):
        for u, v in itertools.product(place.u, place.v):
            is_there = (np.rint(middles[:, 2]) == parent) & (u.start <= middles[:, 0]) & (middles[:, 0] <= u.end)
            there = np.repeat(is_there & (v.start <= middles[:, 1]) & (middles[:, 1] <= v.end), counts)
            at = [u.of(corners[there, 0]), v.of(corners[there, 1])]
            found[there] = np.column_stack([*(at[::-1] if place.is_swapped else at), np.full(there.sum(), number)])
    return found


def has_room_for_ours(kept):
    """Whether a mesh that gets what was kept may have our UV map, too."""
    return kept is None or sum(layer.data_type == 'UV' for layer in kept.layers if layer.name != UV_NAME) < MOST_UV_MAPS


def keep(mesh, owner, uneven=()):
    """The Kept of a mesh, or None where a user put nothing on it. owner: of its vertex groups, an object or None.
    uneven: of mesh_looks.kept()."""
    corners = mesh_layers.parameters(mesh)
    if corners is None or not len(mesh.polygons):
        return None
    of_users = list(mesh_layers.of_users(mesh))
    marks = mesh_marks.keep(mesh, corners, _of_edges(mesh, of_users))
    layers = [*uneven, *(layer for layer in of_users if layer.domain != 'EDGE'),
              *mesh_layers.uv_maps(mesh, corners[:, :2]), *mesh_layers.pins(mesh)]
    groups = mesh_groups.of(mesh, owner)
    if not layers and not marks and groups is None:
        return None
    triangles, faces = _triangles(mesh)
    return Kept(layers, marks, groups, triangles, corners, mesh_layers.corner_vertices(mesh), faces,
                mesh_layers.active(mesh))


def _of_edges(mesh, of_users=None):
    """The Layers that a user put on edges."""
    found = [layer for layer in of_users or mesh_layers.of_users(mesh) if layer.domain == 'EDGE']
    sharp = mesh_sharp.of_users(mesh, mesh_sharp.marked(mesh))
    return found if sharp is None else [*found, Layer('use_edge_sharp', 'FIELD', 'EDGE', sharp[:, None])]


def in_words(kept):
    """What was kept, but for vertex groups, as nouns for the user."""
    if kept is None:
        return []
    found = [phrase("the UV map {name}", name=layer.name) for layer in kept.layers if layer.data_type == 'UV']
    found += [phrase("the attribute {name}", name=layer.name) for layer in kept.layers if layer.data_type in ATTRIBUTES]
    others = [layer for layer in kept.layers if layer.data_type not in ('UV', *ATTRIBUTES)]
    return found + ["marks of edges"] * bool(kept.marks) + ["marks of faces and vertices"] * bool(others)


def restore(mesh, owner, kept):
    """Put what was kept on the faces that the mesh has now."""
    corners = mesh_layers.parameters(mesh)
    if kept.layers or kept.groups is not None:
        _restore_on(mesh, owner, kept, corners, slice(None))
    mesh_marks.restore(mesh, corners, kept.marks)
    mesh_layers.set_active(mesh, kept.active)


def add(mesh, owner, kept, first, count):
    """Put what was kept of another mesh, whose patches are `count` of this one from number `first` on, on their faces.
    owner: an object with the mesh, which gets the vertex groups. Edges of the surface are not sharp until it is written."""
    corners = mesh_layers.parameters(mesh)
    kept = kept._replace(corners=kept.corners + np.array([0, 0, first], np.float32))
    if kept.layers or kept.groups is not None:
        is_in = (np.rint(corners[:, 2]) >= first) & (np.rint(corners[:, 2]) < first + count)
        _restore_on(mesh, owner, kept, corners, is_in)
    if kept.marks:
        here = mesh_marks.keep(mesh, corners, _of_edges(mesh))
        mesh_marks.restore(mesh, corners, mesh_marks.together(here, kept.marks, first))


def _restore_on(mesh, owner, kept, corners, chosen):
    """Put what was kept on vertices, faces and corners: those of the chosen corners, (c,) or all."""
    vertices = mesh_layers.corner_vertices(mesh)
    starts = read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(corners)))
    of_faces = np.add.reduceat(corners, starts) / counts[:, None]
    # A corner is asked for a little inside its face, so that it gets the value of the side it belongs to.
    inside = corners + np.float32(1e-3) * (np.repeat(of_faces, counts, axis=0) - corners)
    numbers = np.arange(len(corners))[chosen]
    which, first = np.unique(vertices[numbers], return_index=True)
    faces = np.flatnonzero(np.isin(starts, numbers))
    found = _Found(kept, {'CORNER': inside[numbers], 'FACE': of_faces[faces], 'POINT': corners[numbers][first]})
    of_domains = {'CORNER': numbers, 'FACE': faces, 'POINT': which}
    # Those that a copy of the mesh is needed for come first.
    for layer in sorted(kept.layers, key=lambda layer: layer.data_type != 'BMESH'):
        mesh_layers.write_some(mesh, layer, found.values(layer), of_domains[layer.domain])
    mesh_layers.hide_with_faces(mesh)
    if kept.groups is not None:
        weights = found.blended(kept.groups.weights[kept.vertices], 'POINT')
        mesh_groups.write(owner, kept.groups, weights, which)


class _Found:
    """Where points of new faces, of each domain, lie on the old ones, looked up once for each domain."""

    def __init__(self, kept, parameters):
        self.kept, self.parameters, self._known = kept, parameters, {}
        self.tree = BVHTree.FromPolygons(_apart(kept.corners).tolist(), kept.triangles.tolist(), all_triangles=True)

    def values(self, layer):
        if layer.domain == 'FACE':
            triangle, _ = self._at('FACE')
            return layer.values[self.kept.faces[triangle]]
        of_corners = layer.values if layer.domain == 'CORNER' else layer.values[self.kept.vertices]
        if layer.is_mixed:
            return self.blended(of_corners, layer.domain)
        triangle, weights = self._at(layer.domain)
        nearest = self.kept.triangles[triangle, weights.argmax(1)]
        return of_corners[nearest]

    def blended(self, of_corners, domain):
        triangle, weights = self._at(domain)
        return np.einsum('nk,nkx->nx', weights, of_corners[self.kept.triangles[triangle]]).astype(np.float32)

    def _at(self, domain):
        """(triangle, weights (n, 3) of its corners) of each point."""
        if domain not in self._known:
            where = _apart(self.parameters[domain])
            triangle = np.array([self.tree.find_nearest(point)[2] for point in where.tolist()])
            corners = self.kept.corners[self.kept.triangles[triangle], :2]
            self._known[domain] = triangle, _barycentric(corners, where[:, :2])
        return self._known[domain]


def _apart(parameters):
    """Parameters as points of space, each patch on a separate level."""
    return parameters * np.array([1, 1, 10], np.float32)


def _barycentric(corners, at):
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = _cross(b - a, c - a)
    area = np.where(area == 0, 1, area)
    second, third = _cross(at - a, c - a) / area, _cross(b - a, at - a) / area
    weights = np.clip(np.stack([1 - second - third, second, third], 1), 0, 1)
    return weights / weights.sum(1, keepdims=True)


def _cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _triangles(mesh):
    """(corners (t, 3), faces (t,)): each face cut from its first corner."""
    starts = read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(mesh.loops)))
    faces = np.repeat(np.arange(len(starts)), counts - 2)
    step = np.arange(len(faces)) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2)
    first = starts[faces]
    return np.stack([first, first + step + 1, first + step + 2], 1), faces
