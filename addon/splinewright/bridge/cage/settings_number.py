"""A number in the net itself: what Edit Mode's undo brings back, and nothing beside the net does."""

import bmesh
import numpy as np

#: The vertices of a cage carry it under this name; curves in what is of no use to them, their resolution along v.
_NAME = "splinewright_settings"
#: The numbers there are; smaller ones are what Blender gives to splines of its own accord.
FIRST, COUNT = 101, 900


def make(data):
    """Let a net's data-block that was just made carry the first number."""
    if hasattr(data, 'splines'):
        _write_curve(data, FIRST)
    else:
        attribute = data.attributes.new(_NAME, 'INT', 'POINT')
        attribute.data.foreach_set('value', np.full(len(data.vertices), FIRST, np.int32))


def read(ob):
    """The number that a net carries; one that is not one of the add-on's where it carries none."""
    if ob.type == 'CURVE':
        return ob.data.splines[0].resolution_v if len(ob.data.splines) else 0
    if ob.mode == 'EDIT':
        mesh = bmesh.from_edit_mesh(ob.data)        # its parts are gone with it
        vertices = mesh.verts
        layer = vertices.layers.int.get(_NAME)
        return next((vertex[layer] for vertex in vertices if vertex[layer]), 0) if layer else 0
    attribute = ob.data.attributes.get(_NAME)
    return attribute.data[0].value if attribute and len(attribute.data) else 0


def write(ob, number):
    """Let a net in Edit Mode carry a number."""
    if ob.type == 'CURVE':
        _write_curve(ob.data, number)
        return
    mesh = bmesh.from_edit_mesh(ob.data)
    vertices = mesh.verts
    layer = vertices.layers.int.get(_NAME)
    if layer:
        for vertex in vertices:
            vertex[layer] = number


def _write_curve(data, number):
    for spline in data.splines:
        spline.resolution_v = number
