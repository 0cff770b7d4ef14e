"""The net as a Blender object: a Mesh cage or a Curve, made when editing starts and gone when it ends.

The net's data-block keeps the definition it was made from, the object points to its shape. Both
survive undo and saving, so that a net means the same whenever it is read.
"""

import uuid

import bmesh
import bpy
import numpy as np

from ...core.failures import Refusal
from ...core.net import curve_net, patch_net
from .. import blocks, mesh_edges, store
from . import marks

#: On the net's data-block: the definition it was made from, and numbers typed since.
KEY = "splinewright_net"
#: On the shape's data-block: the token of the one net that edits it.
EDITED_BY = "splinewright_edited_by"
#: On the net's object: the shape it edits.
SHAPE = "splinewright_shape"
WEIGHT = "weight"
NUMBER = "splinewright_vertex"


class ChangedNet(Refusal):
    """The net does not have the points it was made with."""


def is_net(ob):
    return ob is not None and SHAPE in ob.keys() and ob.data is not None and KEY in ob.data.keys()


def shape_of(ob):
    """The shape that a net edits, or None where it was deleted."""
    shape = ob[SHAPE]
    return shape if shape is not None and shape.users_scene and store.has_definition(shape.data) else None


def net_of(definition):
    """The core.net.Net of a definition."""
    return (curve_net if definition.has_curves else patch_net).make(definition)


def make(shape, definition, net, scene):
    """A net object for a shape, always where that is, linked to the scene. net: net_of(definition)."""
    if not (np.isfinite(net.single).all() and np.isfinite(net.single_weights).all()):
        raise Refusal(f"a control point of {shape.name} lies farther away than Blender's Edit Mode reaches (3.4e38)")
    data = _curve(shape.name, net) if definition.has_curves else _cage(shape.name, net)
    data[KEY] = {'token': uuid.uuid4().hex, 'definition': store.encoded(definition)}
    marks.make(data)
    shape.data[EDITED_BY] = token(data)
    ob = bpy.data.objects.new(data.name, data)
    ob[SHAPE] = shape
    ob.matrix_world = shape.matrix_world
    ob.constraints.new('COPY_TRANSFORMS').target = shape        # children of a path would run along it
    ob.show_in_front = True
    ob.hide_render = True
    if not definition.has_curves:
        ob.display_type = 'WIRE'
    scene.collection.objects.link(ob)
    return ob


def is_current(ob):
    """Whether the net is the one that edits its shape: no copy, and none of an earlier time."""
    shape = shape_of(ob)
    return shape is not None and shape.data.get(EDITED_BY) == token(ob.data)


def end(ob):
    """Nothing edits the shape of a net any more."""
    if is_current(ob):
        del shape_of(ob).data[EDITED_BY]


def remove(ob):
    """Take a net out of the file."""
    data = ob.data
    bpy.data.objects.remove(ob)
    blocks.remove(data)


def token(data):
    """Names the net among all that ever were: equal tokens, equal baselines."""
    return data[KEY]['token']


def editor(shape_data):
    """The token of the net that edits a shape, or None."""
    return shape_data.get(EDITED_BY)


def source(data):
    """The definition that a net was made from."""
    return store.decoded(data[KEY]['definition'])


def remember(ob, names):
    """Keep the names of objects that were selected when the net came."""
    ob.data[KEY]['selected'] = dict(zip(map(str, range(len(names))), names))


def remembered(ob):
    group = ob.data[KEY]
    return list(group['selected'].values()) if 'selected' in group.keys() else []


def typed(data):
    """(k, 5): vertex, x, y, z, w that were typed in float64. Later rows win."""
    group = data[KEY]
    return np.array(group['typed']).reshape(-1, 5) if 'typed' in group.keys() else np.empty((0, 5))


def add_typed(data, rows):
    """Remember typed numbers. They are never removed: undo takes the vertex back, and so the match."""
    every = np.concatenate([typed(data), rows])
    last = len(every) - 1 - np.unique(every[::-1], axis=0, return_index=True)[1]
    store.assign(data[KEY], 'typed', every[np.sort(last)].ravel())


def read(ob, net):
    """Positions (n, 3) and weights (n,), float32, as they are in this moment. Raises ChangedNet."""
    return (_read_curve if ob.type == 'CURVE' else _read_cage)(ob, net)


def _cage(name, net):
    mesh = bpy.data.meshes.new(f"{name} Net")
    edges = np.concatenate([*net.lines, np.array(net.arrows, dtype=np.int64).reshape(-1, 2)])
    mesh.from_pydata(net.positions.tolist(), _without_sides(edges, net.faces).tolist(), net.faces)
    mesh_edges.mend(mesh)
    mesh.attributes.new(WEIGHT, 'FLOAT', 'POINT').data.foreach_set('value', net.single_weights)
    count = np.arange(len(net.rows), dtype=np.int32)
    mesh.attributes.new(NUMBER, 'INT', 'POINT').data.foreach_set('value', count)
    mesh.vertices.foreach_set('select', np.zeros(len(count), bool))
    mesh.edges.foreach_set('select', np.zeros(len(mesh.edges), bool))
    mesh.polygons.foreach_set('select', np.zeros(len(mesh.polygons), bool))
    mesh.update()
    return mesh


def _without_sides(edges, faces):
    """The edges that are no side of a face."""
    quads = np.array([face for face in faces if len(face) == 4], dtype=np.int64).reshape(-1, 4)
    triangles = np.array([face for face in faces if len(face) == 3], dtype=np.int64).reshape(-1, 3)
    sides = np.concatenate([np.stack([corners, np.roll(corners, -1, 1)], -1).reshape(-1, 2)
                            for corners in (quads, triangles)])
    count = 1 + edges.max(initial=0)
    known = [pairs.min(1) * count + pairs.max(1) for pairs in (edges, sides)]
    return edges[~np.isin(*known)]


def _read_cage(ob, net):
    count = len(net.rows)
    if ob.mode != 'EDIT':
        return _read_mesh(ob.data, count)
    vertices = bmesh.from_edit_mesh(ob.data).verts
    weight, number = vertices.layers.float.get(WEIGHT), vertices.layers.int.get(NUMBER)
    if weight is None or number is None:
        raise ChangedNet("the net has lost the weights of its points: undo that")
    order = np.array([vertex[number] for vertex in vertices], np.int32)
    weights = np.array([vertex[weight] for vertex in vertices], np.float32)
    _require_count(len(order), count)
    ob.update_from_editmode()
    return _ordered(_positions(ob.data), weights, order)


def _read_mesh(mesh, count):
    _require_count(len(mesh.vertices), count)
    weights, order = np.empty(count, np.float32), np.empty(count, np.int32)
    for name, values in ((WEIGHT, weights), (NUMBER, order)):
        attribute = mesh.attributes.get(name)
        if attribute is None:
            raise ChangedNet("the net has lost the weights of its points: undo that")
        attribute.data.foreach_get('value', values)
    return _ordered(_positions(mesh), weights, order)


def _positions(mesh):
    flat = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', flat)
    return flat.reshape(-1, 3)


def _require_count(found, expected):
    if found != expected:
        verb = "lost" if found < expected else "gained"
        raise ChangedNet(f"the net has {verb} points ({found} of {expected}): undo that, the shape waits")


def _ordered(positions, weights, order):
    if np.array_equal(order, np.arange(len(order))):
        return positions, weights
    if not np.array_equal(np.sort(order), np.arange(len(order))):
        raise ChangedNet("points of the net were replaced by copies: undo that, the shape waits")
    places = np.argsort(order)
    return positions[places], weights[places]


def _curve(name, net):
    curve = bpy.data.curves.new(f"{name} Net", 'CURVE')
    curve.dimensions = '3D'
    first = 0
    for part in net.splines:
        spline = curve.splines.new(part.kind)
        if part.kind == 'BEZIER':
            last = first + 3 * part.count
            _fill_bezier(spline, part, net.single[first:last].reshape(-1, 3, 3))
        else:
            last = first + part.count
            spline.points.add(part.count - 1)
            rows = np.column_stack([net.single[first:last], net.single_weights[first:last]])
            spline.points.foreach_set('co', rows.ravel())
        spline.use_cyclic_u = part.closed
        # A tilt shows nothing here, and tells the points apart.
        _points_of(spline).foreach_set('tilt', np.arange(part.count, dtype=np.float32))
        first = last
    curve.update_tag()
    return curve


_HANDLES = ('handle_left', 'co', 'handle_right')


def _fill_bezier(spline, part, triples):
    spline.bezier_points.add(part.count - 1)
    for point, smooth in zip(spline.bezier_points, part.smooth):
        point.handle_left_type = point.handle_right_type = 'ALIGNED' if smooth else 'FREE'
    for i, name in enumerate(_HANDLES):
        spline.bezier_points.foreach_set(name, np.ascontiguousarray(triples[:, i]).ravel())


def _points_of(spline):
    return spline.bezier_points if spline.type == 'BEZIER' else spline.points


def order_of(spline, count):
    """The number of each point, in the present order. Raises ChangedNet unless all are there once."""
    _require_count(len(_points_of(spline)), count)
    tilts = np.empty(count, np.float32)
    _points_of(spline).foreach_get('tilt', tilts)
    tilts = np.abs(tilts)               # switching the direction turns them over
    order = np.rint(tilts).astype(np.int64)
    if not np.array_equal(np.sort(tilts), np.arange(count)):
        raise ChangedNet("points of the net were replaced or tilted: undo that, the shape waits")
    return order


def _read_curve(ob, net):
    splines = ob.data.splines
    if len(splines) != len(net.splines):
        raise ChangedNet("the net has lost or gained splines: undo that, the shape waits")
    positions, weights = [], []
    for spline, part in zip(splines, net.splines):
        if spline.type != part.kind:
            raise ChangedNet("a spline of the net has another type: undo that, the shape waits")
        places = np.argsort(order_of(spline, part.count))
        if part.kind == 'BEZIER':
            triples = np.empty((part.count, 3, 3), np.float32)
            for i, name in enumerate(_HANDLES):
                flat = np.empty(3 * part.count, np.float32)
                spline.bezier_points.foreach_get(name, flat)
                triples[:, i] = flat.reshape(-1, 3)
            if part.count > 1 and places[0] > places[-1]:
                triples = triples[:, ::-1]          # switched direction exchanges the handles
            positions.append(triples[places].reshape(-1, 3))
            weights.append(np.ones(3 * part.count, np.float32))
        else:
            flat = np.empty(4 * part.count, np.float32)
            spline.points.foreach_get('co', flat)
            positions.append(flat.reshape(-1, 4)[places, :3])
            weights.append(flat.reshape(-1, 4)[places, 3])
    return np.concatenate(positions), np.concatenate(weights)
