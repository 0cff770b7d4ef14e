"""What users put on a mesh, as arrays: attributes, UV maps, vertex groups, and which of them are active.

Blender drops all of it with the faces.
"""

from typing import NamedTuple

import numpy as np

from . import versions

#: Corner attribute: u, v in [0, 1] of the patch, and the number of the patch.
PARAMETERS = "parameters"
UV_NAME = "UVMap"
_OWN = {PARAMETERS, UV_NAME, 'patch', 'position', 'custom_normal', 'material_index', 'sharp_face'}
#: How a value of each type is read: the name of its field, how many numbers it has, their type.
_TYPES = {'FLOAT': ('value', 1, np.float32), 'INT': ('value', 1, np.int32), 'INT8': ('value', 1, np.int32),
          'BOOLEAN': ('value', 1, bool), 'FLOAT_VECTOR': ('vector', 3, np.float32),
          'FLOAT_COLOR': ('color', 4, np.float32), 'BYTE_COLOR': ('color', 4, np.float32),
          'FLOAT2': ('vector', 2, np.float32), 'INT16_2D': ('value', 2, np.int32), 'INT32_2D': ('value', 2, np.int32),
          'FLOAT4': ('vector', 4, np.float32), 'QUATERNION': ('value', 4, np.float32),
          'FLOAT4X4': ('value', 16, np.float32), 'STRING': ('value', 1, object)}
#: A mixture of two turns is none.
_NEVER_MIXED = {'QUATERNION', 'FLOAT4X4'}
#: So many UV maps a mesh may have.
MOST_UV_MAPS = 8
_DOMAINS = ('POINT', 'FACE', 'CORNER')


class Layer(NamedTuple):
    """One attribute or UV map of a mesh."""

    name: str
    data_type: str                      # as Blender's attributes, or 'UV'
    domain: str
    values: np.ndarray                  # (n, numbers)

    @property
    def is_mixed(self):
        """Whether what lies between two values is a mixture of them, not the nearer one."""
        return self.values.dtype == np.float32 and self.data_type not in _NEVER_MIXED


class Groups(NamedTuple):
    """The vertex groups of an object and their weights."""

    names: list
    locked: list
    active: int
    weights: np.ndarray                 # (vertices, groups)


def ours(mesh, name, data_type, domain):
    """The attribute of ours of that name, or None; one of another type is a user's."""
    attribute = mesh.attributes.get(name)
    is_ours = attribute is not None and (attribute.data_type, attribute.domain) == (data_type, domain)
    return attribute if is_ours else None


def parameters(mesh):
    """(c, 3) of PARAMETERS, or None where the mesh has none for its corners."""
    attribute = ours(mesh, PARAMETERS, 'FLOAT_VECTOR', 'CORNER')
    if attribute is None or len(attribute.data) != len(mesh.loops):
        return None
    return read(attribute.data, 'vector', 3, np.float32)


def read(data, field, numbers, dtype):
    """(n, numbers) of the items of a layer."""
    if dtype is object:
        return np.array([getattr(item, field) for item in data], object).reshape(-1, numbers)
    flat = np.empty(numbers * len(data), dtype)
    data.foreach_get(field, flat)
    return flat.reshape(-1, numbers)


def attributes(mesh):
    """A Layer for each that a user made and that does not lie on edges."""
    for attribute in mesh.attributes:
        if attribute.name in _OWN or attribute.name.startswith('.') or getattr(attribute, 'is_internal', False):
            continue
        if attribute.name in mesh.uv_layers or attribute.data_type not in _TYPES or attribute.domain not in _DOMAINS:
            continue
        values = read(attribute.data, *_TYPES[attribute.data_type])
        yield Layer(attribute.name, attribute.data_type, attribute.domain, values)


def uv_maps(mesh, ours):
    """A Layer for each, but for the one that holds `ours`, (c, 2)."""
    for layer in mesh.uv_layers:
        values = read(*uv_of(layer), 2, np.float32)
        if layer.name != UV_NAME or np.abs(values - ours).max() > 1e-6:
            yield Layer(layer.name, 'UV', 'CORNER', values)


def uv_of(layer):
    """The items of a UV map and the name of their field."""
    return (layer.uv, 'vector') if versions.uvs_are_attributes else (layer.data, 'uv')


def write(mesh, layer, values):
    """Give a mesh that has lost the Layer these values of it, (n, numbers)."""
    if layer.data_type == 'UV':
        data, field = uv_of(mesh.uv_layers.get(layer.name) or mesh.uv_layers.new(name=layer.name, do_init=False))
    else:
        attribute = mesh.attributes.new(layer.name, layer.data_type, layer.domain)
        data, field = attribute.data, _TYPES[layer.data_type][0]
    if values.dtype == object:
        for item, value in zip(data, values[:, 0]):
            setattr(item, field, value)
    else:
        data.foreach_set(field, np.ascontiguousarray(values).ravel())


def groups_of(mesh, owner):
    """The Groups of an object that has the mesh, or None where there are none."""
    if owner is None or not owner.vertex_groups:
        return None
    groups = owner.vertex_groups
    weights = np.zeros((len(mesh.vertices), len(groups)), np.float32)
    for i, vertex in enumerate(mesh.vertices):
        for entry in vertex.groups:
            if entry.group < len(groups):
                weights[i, entry.group] = entry.weight
    names, locked = [group.name for group in groups], [group.lock_weight for group in groups]
    return Groups(names, locked, groups.active_index, weights)


def write_groups(owner, groups, weights):
    """Give an object Groups with other weights, (vertices, groups)."""
    for name, is_locked, column in zip(groups.names, groups.locked, weights.T):
        group = owner.vertex_groups.get(name) or owner.vertex_groups.new(name=name)
        for i in np.flatnonzero(column).tolist():
            group.add([i], float(column[i]), 'REPLACE')
        group.lock_weight = is_locked
    owner.vertex_groups.active_index = groups.active


def active(mesh):
    """Which layers are shown and which are rendered, by their names, for set_active()."""
    colours, uvs = mesh.color_attributes, mesh.uv_layers
    return {'colour': colours.active_color_name, 'rendered colour': colours.default_color_name,
            'uv': uvs.active.name if uvs.active else "",
            'rendered uv': next((layer.name for layer in uvs if layer.active_render), "")}


def set_active(mesh, names):
    colours, uvs = mesh.color_attributes, mesh.uv_layers
    # Blender 3.4 takes no names here.
    if names['colour'] in colours:
        colours.active_color = colours[names['colour']]
    if names['rendered colour'] in colours:
        colours.render_color_index = colours.keys().index(names['rendered colour'])
    if names['uv'] in uvs:
        uvs.active = uvs[names['uv']]
    if names['rendered uv'] in uvs:
        uvs[names['rendered uv']].active_render = True
