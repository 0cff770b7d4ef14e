"""Single vertices of a net in Edit Mode: which are selected, and how one is moved by a number."""

import bmesh
import numpy as np
from mathutils import Vector

from . import free_net, net_object


def selected(ob, net):
    """Numbers of the selected vertices, ascending. The feet of arrows and idle handles are left out."""
    chosen = _selected_of_curve(ob.data, net) if ob.type == 'CURVE' else _selected_of_cage(ob.data)
    return [vertex for vertex in chosen if vertex < len(net.rows) and net.rows[vertex] >= 0]


def select(ob, net, vertices):
    """Make these the selected vertices."""
    chosen = set(vertices)
    if ob.type == 'CURVE':
        for spline, handle, i, vertex in _curve_vertices(ob.data, net):
            setattr(_point(spline, i), f"select{handle}", vertex in chosen)
        return
    mesh = bmesh.from_edit_mesh(ob.data)
    number = mesh.verts.layers.int[net_object.NUMBER]
    for vertex in mesh.verts:
        vertex.select = vertex[number] in chosen
    mesh.select_flush_mode()
    bmesh.update_edit_mesh(ob.data)


def place(ob, net, vertices, rows):
    """Give vertices positions and weights, rows (k, 4); they are kept in float64 beside the net.

    Raises ChangedNet where the net has not its points.
    """
    if free_net.is_free(ob.data):
        numbers = free_net.numbers(ob.data)[vertices]
    else:
        net_object.read(ob, net)
        numbers = vertices
    net_object.add_typed(ob.data, np.column_stack([numbers, rows]))
    values = dict(zip(vertices, rows))
    if ob.type == 'CURVE':
        _place_on_curve(ob.data, net, values)
    else:
        _place_on_cage(ob.data, values)


def _selected_of_cage(mesh):
    vertices = bmesh.from_edit_mesh(mesh).verts
    number = vertices.layers.int.get(net_object.NUMBER)
    return sorted(v[number] for v in vertices if v.select) if number else []


def _place_on_cage(data, values):
    mesh = bmesh.from_edit_mesh(data)
    number, weights = mesh.verts.layers.int[net_object.NUMBER], mesh.verts.layers.float[net_object.WEIGHT]
    for vertex in mesh.verts:
        if vertex[number] in values:
            *vertex.co, vertex[weights] = values[vertex[number]]
    bmesh.update_edit_mesh(data, loop_triangles=False, destructive=False)


def _curve_vertices(curve, net):
    """(spline, end of the names of its handle's properties, index of the point, vertex)."""
    first = 0
    for spline, part in zip(curve.splines, net.splines):
        handles = ('_left_handle', '_control_point', '_right_handle') if part.kind == 'BEZIER' else ('',)
        if (spline.type == 'BEZIER') == (part.kind == 'BEZIER'):        # otherwise it is of another type now
            numbers, is_turned = _numbers(curve, spline, part.count)
            for i, number in enumerate(numbers):
                for k, handle in enumerate(handles[::-1] if is_turned else handles):
                    yield spline, handle, i, first + len(handles) * number + k
        first += len(handles) * part.count


def _numbers(curve, spline, count):
    """(the number of each point of a spline in its place, whether its direction was switched)."""
    if not free_net.is_free(curve):
        try:
            numbers = net_object.order_of(spline, count).tolist()
            return numbers, count > 1 and numbers.index(0) > numbers.index(count - 1)
        except net_object.ChangedNet:
            pass                        # read() says it
    return list(range(count)), False


def _point(spline, i):
    return spline.bezier_points[i] if spline.type == 'BEZIER' else spline.points[i]


def _selected_of_curve(curve, net):
    for spline, handle, i, vertex in _curve_vertices(curve, net):
        if i < len(spline.bezier_points or spline.points) and getattr(_point(spline, i), f"select{handle}"):
            yield vertex


_PLACES = {'_left_handle': 'handle_left', '_right_handle': 'handle_right'}


def _place_on_curve(curve, net, values):
    for spline, handle, i, vertex in list(_curve_vertices(curve, net)):
        if vertex in values:
            _place_point(_point(spline, i), handle, *values[vertex])
    curve.update_tag()


def _place_point(point, handle, x, y, z, weight):
    if handle == '_control_point':
        moved = Vector((x, y, z)) - point.co
        ends = point.handle_left + moved, point.handle_right + moved
        point.co = (x, y, z)
        point.handle_left, point.handle_right = ends
    elif handle:
        setattr(point, _PLACES[handle], (x, y, z))
    else:
        point.co = (x, y, z, weight)
