"""What the mesh of an object is, before modifiers, for surfaces that are made of it."""

import numpy as np

from ...core.base.words import phrase
from ...core.shape.polygons import Polygons, require_faces
from ..data import versions
from . import shape


def is_mesh(ob):
    """Whether an object is a mesh that shows no shape."""
    return ob is not None and ob.type == 'MESH' and not shape.has_shape(ob)


def polygons_of(ob, matrix):
    """The Polygons of an object, with points under a matrix (4, 4). Raises Refusal."""
    mesh = ob.data
    require_faces(ob.name, len(mesh.polygons))
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', points)
    starts = np.empty(len(mesh.polygons) + 1, np.int32)
    mesh.polygons.foreach_get('loop_start', starts[:-1])
    starts[-1] = len(mesh.loops)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get('vertex_index', corners)
    points = points.reshape(-1, 3).astype(np.float64)
    return Polygons(points @ matrix[:3, :3].T + matrix[:3, 3], starts, corners, _has_creases(mesh))


def not_followed(ob):
    """What of the object polygons_of() does not read: nouns for the user."""
    keys = ["the shape keys"] if ob.data.shape_keys else []
    return keys + [phrase("the modifier {name}", name=modifier.name) for modifier in ob.modifiers if modifier.show_viewport]


def _has_creases(mesh):
    if versions.marks_are_attributes:
        layers = [mesh.attributes[name].data for name in ('crease_edge', 'crease_vert') if name in mesh.attributes]
        return any(_is_above_0(layer, 'value') for layer in layers)
    return _is_above_0(mesh.edges, 'crease') or any(_is_above_0(layer.data, 'value') for layer in mesh.vertex_creases)


def _is_above_0(items, name):
    values = np.zeros(len(items), np.float32)
    items.foreach_get(name, values)
    return bool((values > 0.0).any())
