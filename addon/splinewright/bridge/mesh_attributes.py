"""What users put on the vertices, faces and corners of a mesh, carried over to other faces of the same patches.

Numbers are interpolated over the parameters of each patch, which every corner keeps; whole numbers, texts and
switches are those of the nearest corner. What lies on edges goes with them.
"""

import contextlib
import itertools
from typing import NamedTuple

import numpy as np
from mathutils.bvhtree import BVHTree

#: Corner attribute: u, v in [0, 1] of the patch, and the number of the patch.
PARAMETERS = "parameters"
UV_NAME = "UVMap"
_OWN = {PARAMETERS, UV_NAME, 'patch', 'position', 'custom_normal', 'material_index', 'sharp_face'}
#: How a value of each type is read: the name of its field, how many numbers it has, their type.
_TYPES = {'FLOAT': ('value', 1, np.float32), 'INT': ('value', 1, np.int32), 'INT8': ('value', 1, np.int32),
          'BOOLEAN': ('value', 1, bool), 'FLOAT_VECTOR': ('vector', 3, np.float32),
          'FLOAT_COLOR': ('color', 4, np.float32), 'BYTE_COLOR': ('color', 4, np.float32),
          'FLOAT2': ('vector', 2, np.float32)}
_DOMAINS = ('POINT', 'FACE', 'CORNER')


class Layer(NamedTuple):
    """One attribute or UV map of a mesh."""

    name: str
    data_type: str                      # as Blender's attributes, or 'UV'
    domain: str
    values: np.ndarray                  # (n, numbers)


class Kept(NamedTuple):
    """What was on a mesh, and the triangles over whose parameters it lies."""

    layers: list
    groups: list                        # names of the vertex groups
    weights: np.ndarray                 # (v, groups)
    triangles: np.ndarray               # (t, 3) corners
    corners: np.ndarray                 # (c, 3) parameters
    vertices: np.ndarray                # (c,) the vertex of each corner
    faces: np.ndarray                   # (t,) the face of each triangle
    active: dict                        # names of the active colours and UV map


def write_parameters(mesh, tessellation):
    """Keep for each corner where it lies."""
    attribute = mesh.attributes.get(PARAMETERS) or mesh.attributes.new(PARAMETERS, 'FLOAT_VECTOR', 'CORNER')
    attribute.data.foreach_set('vector', _parameters(tessellation).ravel())


def lies_as(mesh, tessellation):
    """Whether each corner lies where write_parameters() would say, if the mesh says it at all."""
    known = mesh.attributes.get(PARAMETERS)
    if known is None or len(known.data) != len(mesh.loops):
        return True
    return np.array_equal(_read(known.data, 'vector', 3, np.float32), _parameters(tessellation))


def _parameters(tessellation):
    sizes = np.diff(np.append(tessellation.face_starts, len(tessellation.corner_vertices)))
    values = np.column_stack([tessellation.corner_uvs, np.repeat(tessellation.face_patches, sizes)])
    return np.ascontiguousarray(values, np.float32)


@contextlib.contextmanager
def moved(mesh, owner, parents, places):
    """While other patches are written, what lies on the faces lies on those: each came of one of `parents`, and lies
    there in a core.places.Place. Where that fails it lies where it lay."""
    kept = keep(mesh, owner)
    if kept is None:
        yield
        return
    layer = mesh.uv_layers.get(UV_NAME)
    uvs = _read(*_uv(layer), 2, np.float32) if layer is not None else None
    is_ours = uvs is not None and np.abs(uvs - kept.corners[:, :2]).max() <= 1e-6
    corners = _on_parts(mesh, kept.corners, parents, places)
    _put(mesh, corners, corners[:, :2] if is_ours else None)
    try:
        yield
    except Exception:
        _put(mesh, kept.corners, uvs if is_ours else None)
        raise


def _put(mesh, corners, uvs):
    mesh.attributes[PARAMETERS].data.foreach_set('vector', np.ascontiguousarray(corners, np.float32).ravel())
    if uvs is not None:
        data, field = _uv(mesh.uv_layers[UV_NAME])
        data.foreach_set(field, np.ascontiguousarray(uvs, np.float32).ravel())


def _on_parts(mesh, corners, parents, places):
    """(c, 3): the parameters of corners on the patches that came of theirs; a face lies where its middle lies."""
    starts = _read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(corners)))
    middles, found = np.add.reduceat(corners, starts) / counts[:, None], corners.copy()
    for number, (parent, place) in enumerate(zip(parents, places)):
        for u, v in itertools.product(place.u, place.v):
            is_there = (np.rint(middles[:, 2]) == parent) & (u.start <= middles[:, 0]) & (middles[:, 0] <= u.end)
            there = np.repeat(is_there & (v.start <= middles[:, 1]) & (middles[:, 1] <= v.end), counts)
            at = [u.of(corners[there, 0]), v.of(corners[there, 1])]
            found[there] = np.column_stack([*(at[::-1] if place.is_swapped else at), np.full(there.sum(), number)])
    return found


def keep(mesh, owner):
    """The Kept of a mesh, or None where a user put nothing on it. owner: an object of it, for vertex groups, or None."""
    parameters = mesh.attributes.get(PARAMETERS)
    if parameters is None or not len(mesh.polygons) or len(parameters.data) != len(mesh.loops):
        return None
    corners = _read(parameters.data, 'vector', 3, np.float32)
    layers = [*_attributes(mesh), *_uv_maps(mesh, corners)]
    weights = _weights(mesh, owner)
    groups = [group.name for group in owner.vertex_groups] if owner is not None else []
    if not layers and not groups:
        return None
    triangles, faces = _triangles(mesh)
    vertices = _read(mesh.loops, 'vertex_index', 1, np.int32)[:, 0]
    return Kept(layers, groups, weights, triangles, corners, vertices, faces, _active(mesh))


def restore(mesh, owner, kept):
    """Put what was kept on the faces that the mesh has now."""
    corners = _read(mesh.attributes[PARAMETERS].data, 'vector', 3, np.float32)
    vertices = _read(mesh.loops, 'vertex_index', 1, np.int32)[:, 0]
    starts = _read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(corners)))
    of_faces = np.add.reduceat(corners, starts) / counts[:, None]
    # A corner is asked for a little inside its face, so that it gets the value of the side it belongs to.
    inside = corners + np.float32(1e-3) * (np.repeat(of_faces, counts, axis=0) - corners)
    _, first = np.unique(vertices, return_index=True)
    places = {'CORNER': inside, 'FACE': of_faces, 'POINT': corners[first]}
    found = _Found(kept)
    for layer in kept.layers:
        _write(mesh, layer, found.values(layer, places))
    if kept.groups:
        _write_weights(owner, kept.groups, found.blended(kept.weights[kept.vertices], 'POINT', places))
    _set_active(mesh, kept.active)


class _Found:
    """Where places of new faces lie on the old ones, looked up once for each domain."""

    def __init__(self, kept):
        self.kept, self._known = kept, {}
        self.tree = BVHTree.FromPolygons(_apart(kept.corners).tolist(), kept.triangles.tolist(), all_triangles=True)

    def values(self, layer, places):
        if layer.domain == 'FACE':
            triangle, _ = self._at('FACE', places)
            return layer.values[self.kept.faces[triangle]]
        of_corners = layer.values if layer.domain == 'CORNER' else layer.values[self.kept.vertices]
        if layer.values.dtype == np.float32:
            return self.blended(of_corners, layer.domain, places)
        triangle, weights = self._at(layer.domain, places)
        nearest = self.kept.triangles[triangle, weights.argmax(1)]
        return of_corners[nearest]

    def blended(self, of_corners, domain, places):
        triangle, weights = self._at(domain, places)
        return np.einsum('nk,nkx->nx', weights, of_corners[self.kept.triangles[triangle]]).astype(np.float32)

    def _at(self, domain, places):
        """(triangle, weights (n, 3) of its corners) of each place."""
        if domain not in self._known:
            where = _apart(places[domain])
            triangle = np.array([self.tree.find_nearest(place)[2] for place in where.tolist()])
            corners = self.kept.corners[self.kept.triangles[triangle], :2]
            self._known[domain] = triangle, _barycentric(corners, where[:, :2])
        return self._known[domain]


def _apart(places):
    """Parameters as points of space, each patch on a level of its own."""
    return places * np.array([1, 1, 10], np.float32)


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
    starts = _read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    counts = np.diff(np.append(starts, len(mesh.loops)))
    faces = np.repeat(np.arange(len(starts)), counts - 2)
    step = np.arange(len(faces)) - np.repeat(np.cumsum(counts - 2) - (counts - 2), counts - 2)
    first = starts[faces]
    return np.stack([first, first + step + 1, first + step + 2], 1), faces


def _read(data, field, numbers, dtype):
    flat = np.empty(numbers * len(data), dtype)
    data.foreach_get(field, flat)
    return flat.reshape(-1, numbers)


def _attributes(mesh):
    for attribute in mesh.attributes:
        if attribute.name in _OWN or attribute.name.startswith('.') or getattr(attribute, 'is_internal', False):
            continue
        if attribute.name in mesh.uv_layers or attribute.data_type not in _TYPES or attribute.domain not in _DOMAINS:
            continue
        yield Layer(attribute.name, attribute.data_type, attribute.domain, _read(attribute.data, *_TYPES[attribute.data_type]))


def _uv_maps(mesh, corners):
    """All but ours, and ours where a user changed it."""
    for layer in mesh.uv_layers:
        values = _read(*_uv(layer), 2, np.float32)
        if layer.name != UV_NAME or np.abs(values - corners[:, :2]).max() > 1e-6:
            yield Layer(layer.name, 'UV', 'CORNER', values)


def _uv(layer):
    return (layer.uv, 'vector') if hasattr(layer, 'uv') else (layer.data, 'uv')


def _write(mesh, layer, values):
    if layer.data_type == 'UV':
        data, field = _uv(mesh.uv_layers.get(layer.name) or mesh.uv_layers.new(name=layer.name, do_init=False))
    else:
        attribute = mesh.attributes.new(layer.name, layer.data_type, layer.domain)
        data, field = attribute.data, _TYPES[layer.data_type][0]
    data.foreach_set(field, np.ascontiguousarray(values).ravel())


def _weights(mesh, owner):
    """(vertices, groups) float32."""
    groups = len(owner.vertex_groups) if owner is not None else 0
    weights = np.zeros((len(mesh.vertices), groups), np.float32)
    if groups:
        for i, vertex in enumerate(mesh.vertices):
            for entry in vertex.groups:
                if entry.group < groups:
                    weights[i, entry.group] = entry.weight
    return weights


def _write_weights(owner, names, weights):
    """The groups are gone with the geometry that they lay on."""
    for name, column in zip(names, weights.T):
        group = owner.vertex_groups.get(name) or owner.vertex_groups.new(name=name)
        for i in np.flatnonzero(column).tolist():
            group.add([i], float(column[i]), 'REPLACE')


def _active(mesh):
    colours = getattr(mesh, 'color_attributes', None)
    return {'colour': getattr(colours, 'active_color_name', "") if colours is not None else "",
            'uv': mesh.uv_layers.active.name if mesh.uv_layers.active else ""}


def _set_active(mesh, names):
    if names['colour'] and names['colour'] in mesh.attributes and hasattr(mesh.color_attributes, 'active_color_name'):
        mesh.color_attributes.active_color_name = names['colour']
    if names['uv'] in mesh.uv_layers:
        mesh.uv_layers.active = mesh.uv_layers[names['uv']]
