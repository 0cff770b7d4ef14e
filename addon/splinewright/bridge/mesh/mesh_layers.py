"""What users put on a mesh, as arrays: attributes, UV maps, marks, and which of them are active.

Blender drops all of it with the faces.
"""

from typing import NamedTuple

import bmesh
import bpy
import numpy as np
from mathutils.interpolate import poly_3d_calc

from ..data import versions

#: Attribute of vertices where all corners of each agree, else of corners: u, v in [0, 1] of the patch, and its number.
PARAMETERS = "parameters"
#: Attribute of corners of Blender 4.5 and later: normals as they are.
NORMALS = 'custom_normal'
#: On a mesh whose NORMALS were chosen in Blender's list when they were taken away: what is chosen in their place.
_INSTEAD = "splinewright_chosen_instead"
UV_NAME = "UVMap"
_OWN = {PARAMETERS, UV_NAME, 'patch', 'position', NORMALS, 'material_index', 'sharp_face', 'sharp_edge'}
#: Blender's own, which a user made all the same.
_HIDDEN = {'.sculpt_mask', '.sculpt_face_set', '.uv_seam', '.hide_poly'}
_PINS = '.pn.'
#: How a value of each type of attribute is read: the name of its field, how many numbers it has, their type.
ATTRIBUTES = {'FLOAT': ('value', 1, np.float32), 'INT': ('value', 1, np.int32), 'INT8': ('value', 1, np.int32),
              'BOOLEAN': ('value', 1, bool), 'FLOAT_VECTOR': ('vector', 3, np.float32),
              'FLOAT_COLOR': ('color', 4, np.float32), 'BYTE_COLOR': ('color', 4, np.float32),
              'FLOAT2': ('vector', 2, np.float32), 'INT16_2D': ('value', 2, np.int32), 'INT32_2D': ('value', 2, np.int32),
              'FLOAT4': ('vector', 4, np.float32), 'QUATERNION': ('value', 4, np.float32),
              'FLOAT4X4': ('value', 16, np.float32), 'STRING': ('value', 1, object)}
#: A mixture of two turns is none.
_NEVER_MIXED = {'QUATERNION', 'FLOAT4X4'}
#: So many UV maps a mesh may have.
MOST_UV_MAPS = 8
_COLLECTIONS = {'POINT': 'vertices', 'EDGE': 'edges', 'FACE': 'polygons', 'CORNER': 'loops'}
#: What some versions keep as a field of vertices, edges or faces, where others have attributes: domain, name, type, and
#: the property of the mesh that tells whether any has it.
_FIELDS = (('EDGE', 'use_seam', bool, None), ('EDGE', 'crease', np.float32, 'has_crease_edge'),
           ('EDGE', 'bevel_weight', np.float32, 'has_bevel_weight_edge'),
           ('POINT', 'bevel_weight', np.float32, 'has_bevel_weight_vertex'),
           ('EDGE', 'use_freestyle_mark', bool, None), ('FACE', 'use_freestyle_mark', bool, None))
#: Of Blender 3: collections of one layer or none, which bmesh alone can make, and its names for them.
_OF_BMESH = {'vertex_paint_masks': 'paint_mask', 'vertex_creases': 'crease'}


class Layer(NamedTuple):
    """One attribute or UV map of a mesh."""

    name: str
    data_type: str                      # as Blender's attributes, or 'UV', 'PIN', 'FIELD', 'BMESH'
    domain: str
    values: np.ndarray                  # (n, width)

    @property
    def is_mixed(self):
        """Whether what lies between two values is a mixture of them, not the nearer one."""
        return self.values.dtype == np.float32 and self.data_type not in _NEVER_MIXED


def ours(mesh, name, data_type, domain):
    """The attribute of the add-on of that name, or None; one of another type is a user's."""
    attribute = mesh.attributes.get(name)
    is_ours = attribute is not None and (attribute.data_type, attribute.domain) == (data_type, domain)
    return attribute if is_ours else None


def _of_parameters(mesh):
    """(the attribute, whether it is of vertices); None where the mesh has none."""
    for domain, collection in (('POINT', mesh.vertices), ('CORNER', mesh.loops)):
        attribute = ours(mesh, PARAMETERS, 'FLOAT_VECTOR', domain)
        if attribute is not None and len(attribute.data) == len(collection):
            return attribute, domain == 'POINT'
    return None


def parameters(mesh, corners=None):
    """(c, 3) of PARAMETERS of the corners, or None where the mesh has none. corners: their corner_vertices(), where known."""
    found = _of_parameters(mesh)
    if found is None:
        return None
    values = read(found[0].data, 'vector', 3, np.float32)
    if not found[1]:
        return values
    return values[corner_vertices(mesh) if corners is None else corners]


def write_parameters(mesh, corners):
    """Give the mesh PARAMETERS, (c, 3) of its corners."""
    vertices = corner_vertices(mesh)
    of_vertices = np.zeros((len(mesh.vertices), 3), np.float32)
    of_vertices[vertices] = corners
    is_of_vertices = np.array_equal(of_vertices[vertices], corners)
    domain, values = ('POINT', of_vertices) if is_of_vertices else ('CORNER', np.ascontiguousarray(corners, np.float32))
    attribute = ours(mesh, PARAMETERS, 'FLOAT_VECTOR', domain)
    if attribute is None:
        other = _of_parameters(mesh)
        if other is not None:
            remove(mesh, PARAMETERS)
        attribute = mesh.attributes.new(PARAMETERS, 'FLOAT_VECTOR', domain)
    attribute.data.foreach_set('vector', values.ravel())


def parameters_at(mesh, face, point):
    """(u, v) in [0, 1] of the patch at a point of one of its faces, also of an evaluated mesh; None where that has none."""
    found = _of_parameters(mesh)
    if found is None or face >= len(mesh.polygons):
        return None
    (attribute, is_of_vertices), polygon = found, mesh.polygons[face]
    weights = poly_3d_calc([mesh.vertices[vertex].co for vertex in polygon.vertices], point)
    numbers = polygon.vertices if is_of_vertices else polygon.loop_indices
    corners = np.array([attribute.data[number].vector for number in numbers])
    return tuple(np.clip(np.array(weights) @ corners[:, :2], 0.0, 1.0).tolist())


def read(data, field, width, dtype):
    """(n, width) of the items of a layer."""
    if np.dtype(dtype) == object:
        return np.array([getattr(item, field) for item in data], object).reshape(-1, width)
    flat = np.empty(width * len(data), dtype)
    data.foreach_get(field, flat)
    return flat.reshape(-1, width)


def column(mesh, collection, field, attribute, dtype):
    """(n,) of a field, whose attribute is where this Blender has it; None where no element has that."""
    if not versions.marks_are_attributes:
        return read(getattr(mesh, collection), field, 1, dtype)[:, 0]
    layer = mesh.attributes.get(attribute)
    return None if layer is None else read(layer.data, 'value', 1, dtype)[:, 0]


def corner_vertices(mesh):
    """(c,) the vertex of each corner."""
    return _of_corners(mesh, 'vertex_index', '.corner_vert')


def corner_edges(mesh):
    """(c,) the edge from each corner to the next of its face."""
    return _of_corners(mesh, 'edge_index', '.corner_edge')


def _of_corners(mesh, field, attribute):
    """A column() that every mesh has; a mesh in Edit Mode has no attribute for it."""
    if mesh.is_editmode:
        return read(mesh.loops, field, 1, np.int32)[:, 0]
    return column(mesh, 'loops', field, attribute, np.int32)


def of_users(mesh):
    """A Layer for each attribute, mark and hidden layer that a user made; UV maps are uv_maps()."""
    yield from _attributes(mesh)
    yield from _fields(mesh)
    if not versions.marks_are_attributes:
        yield from _layers_of_blender_3(mesh)


def _layers_of_blender_3(mesh):
    for collection in _OF_BMESH:
        for layer in getattr(mesh, collection):
            yield Layer(collection, 'BMESH', 'POINT', read(layer.data, 'value', 1, np.float32))
    for layer in mesh.face_maps:
        yield Layer('face_maps', 'BMESH', 'FACE', read(layer.data, 'value', 1, np.int32))


def _attributes(mesh):
    for attribute in mesh.attributes:
        if not _is_users(attribute) or attribute.name in mesh.uv_layers or attribute.data_type not in ATTRIBUTES:
            continue
        values = read(attribute.data, *ATTRIBUTES[attribute.data_type])
        yield Layer(attribute.name, attribute.data_type, attribute.domain, values)


def _is_users(attribute):
    name = attribute.name
    if name.startswith('.'):
        return name in _HIDDEN or name.startswith(_PINS)
    return name not in _OWN and attribute.domain in _COLLECTIONS and not getattr(attribute, 'is_internal', False)


def _fields(mesh):
    for domain, name, dtype, is_there in _FIELDS:
        collection = getattr(mesh, _COLLECTIONS[domain])
        if not _has_field(domain, name) or is_there is not None and not getattr(mesh, is_there):
            continue
        values = read(collection, name, 1, dtype)
        if values.any():
            yield Layer(name, 'FIELD', domain, values)


def _has_field(domain, name):
    if name == 'use_seam' and versions.marks_are_attributes:
        return False
    owner = {'POINT': bpy.types.MeshVertex, 'EDGE': bpy.types.MeshEdge, 'FACE': bpy.types.MeshPolygon}[domain]
    return name in owner.bl_rna.properties


def is_possible(layer):
    """Whether a mesh of this Blender may have the Layer."""
    return _has_field(layer.domain, layer.name) if layer.data_type == 'FIELD' else layer.data_type in ATTRIBUTES


def is_dropped_where_empty(layer):
    """Whether Blender drops the Layer, for example on leaving Edit Mode, where no edge has it."""
    return layer.data_type == 'FIELD' or layer.name.endswith('uv_seam')


def uv_maps(mesh, ours):
    """A Layer for each, but for the one that holds `ours`, (c, 2)."""
    for layer in mesh.uv_layers:
        values = read(*uv_of(layer), 2, np.float32)
        if layer.name != UV_NAME or np.abs(values - ours).max() > 1e-6:
            yield Layer(layer.name, 'UV', 'CORNER', values)


def pins(mesh):
    """A Layer for each UV map of which corners are pinned, where that is no attribute."""
    for layer in mesh.uv_layers:
        if not hasattr(layer, 'uv'):
            values = read(layer.data, 'pin_uv', 1, bool)
            if values.any():
                yield Layer(layer.name, 'PIN', 'CORNER', values)


def uv_of(layer):
    """The items of a UV map and the name of their field."""
    return (layer.uv, 'vector') if versions.uvs_are_attributes else (layer.data, 'uv')


def write(mesh, layer, values):
    """Give a mesh that has lost the Layer these values of it, (n, width)."""
    if layer.data_type == 'BMESH':
        _write_by_bmesh(mesh, layer, values)
        return
    data, field = _items(mesh, layer)
    if values.dtype == object:
        for item, value in zip(data, values[:, 0]):
            setattr(item, field, value)
    elif data is not None:
        data.foreach_set(field, np.ascontiguousarray(values).ravel())


def write_some(mesh, layer, values, elements):
    """Give these elements of a mesh, whose numbers grow, values of a Layer, (n, width); others keep theirs."""
    count = len(getattr(mesh, _COLLECTIONS[layer.domain]))
    if len(elements) < count:
        every = _present(mesh, layer, count)
        every[elements] = values
        values = every
    write(mesh, layer, values)


def _present(mesh, layer, count):
    """(count, width): what a mesh has of a Layer; zeros where it has none."""
    if layer.data_type == 'BMESH':
        there = list(getattr(mesh, layer.name))
        data, field = (there[0].data if there else None), 'value'
    else:
        data, field = _items(mesh, layer)
    shape = layer.values.shape[1]
    dtype = layer.values.dtype
    return np.zeros((count, shape), dtype) if data is None else read(data, field, shape, dtype)


def _items(mesh, layer):
    """The items of a Layer, which is made where it is missing, and the name of their field."""
    if layer.data_type == 'FIELD':
        return getattr(mesh, _COLLECTIONS[layer.domain]), layer.name
    if layer.data_type == 'UV':
        uv_map = mesh.uv_layers.get(layer.name) or mesh.uv_layers.new(name=layer.name, do_init=False)
        return (None, "") if uv_map is None else uv_of(uv_map)      # there may be as many as Blender takes
    if layer.data_type == 'PIN':
        uv_map = mesh.uv_layers.get(layer.name)
        return (None if uv_map is None else uv_map.data), 'pin_uv'
    attribute = (ours(mesh, layer.name, layer.data_type, layer.domain)
                 or mesh.attributes.new(layer.name, layer.data_type, layer.domain))
    return attribute.data, ATTRIBUTES[layer.data_type][0]


def _write_by_bmesh(mesh, layer, values):
    if layer.name == 'face_maps':
        face_map = mesh.face_maps[0] if len(mesh.face_maps) else mesh.face_maps.new()
        face_map.data.foreach_set('value', np.ascontiguousarray(values).ravel())
        return
    copy = bmesh.new()
    copy.from_mesh(mesh)
    key = getattr(copy.verts.layers, _OF_BMESH[layer.name]).verify()
    for vertex, value in zip(copy.verts, values[:, 0].tolist()):
        vertex[key] = value
    copy.to_mesh(mesh)
    copy.free()


def hide_with_faces(mesh):
    """Hide what lies between hidden faces only."""
    hidden = ours(mesh, '.hide_poly', 'BOOLEAN', 'FACE')
    if hidden is None:
        return
    of_faces = read(hidden.data, 'value', 1, bool)[:, 0]
    if not of_faces.any():
        return
    starts = read(mesh.polygons, 'loop_start', 1, np.int32)[:, 0]
    is_shown = ~np.repeat(of_faces, np.diff(np.append(starts, len(mesh.loops))))
    for name, domain, elements in (('.hide_vert', 'POINT', corner_vertices(mesh)),
                                   ('.hide_edge', 'EDGE', corner_edges(mesh))):
        attribute = ours(mesh, name, 'BOOLEAN', domain) or mesh.attributes.new(name, 'BOOLEAN', domain)
        hide = np.ones(len(attribute.data), bool)
        hide[elements[is_shown]] = False
        attribute.data.foreach_set('value', hide)


def active(mesh):
    """Which layers are shown and which are rendered, by their names, for set_active()."""
    colors, uvs = mesh.color_attributes, mesh.uv_layers
    return {'color': colors.active_color_name, 'rendered color': colors.default_color_name,
            'uv': uvs.active.name if uvs.active else "",
            'rendered uv': next((layer.name for layer in uvs if layer.active_render), "")}


def set_active(mesh, names):
    colors, uvs = mesh.color_attributes, mesh.uv_layers
    # Blender 3.4 takes no names here.
    if names['color'] in colors:
        colors.active_color = colors[names['color']]
    if names['rendered color'] in colors:
        colors.render_color_index = colors.keys().index(names['rendered color'])
    if names['uv'] in uvs:
        uvs.active = uvs[names['uv']]
    if names['rendered uv'] in uvs:
        uvs[names['rendered uv']].active_render = True


def active_attribute(mesh):
    """The name of the attribute that is chosen in Blender's list of them, or "". Of NORMALS that put_away() took it is known
    until another is chosen."""
    found = _active_attribute(mesh)
    return NORMALS if mesh.get(_INSTEAD) == found else found


def _active_attribute(mesh):
    active = mesh.attributes.active
    return active.name if active else ""


def set_active_attribute(mesh, name):
    if name in mesh.attributes and _active_attribute(mesh) != name:
        mesh.attributes.active = mesh.attributes[name]


def remove(mesh, name):
    """Take an attribute away; another that is active stays so. Blender counts them: what came after the one would not."""
    active = _active_attribute(mesh)
    mesh.attributes.remove(mesh.attributes[name])
    set_active_attribute(mesh, active)


def put_away_normals(mesh):
    """remove() NORMALS, that are to come back."""
    is_active = _active_attribute(mesh) == NORMALS
    remove(mesh, NORMALS)
    if is_active:
        mesh[_INSTEAD] = _active_attribute(mesh)


def have_normals_back(mesh):
    """All attributes are there again."""
    if _INSTEAD in mesh.keys():
        del mesh[_INSTEAD]
