"""One shape alone in a window: added, and where on it something is to be seen."""

import itertools

import bpy
import numpy as np
from mathutils import Vector

from window import empty_file, part, redrawn

_names = []


def added(view, operator):
    """Steps that leave nothing in the file but what an operator adds, in the middle of the view."""
    with view.override():
        empty_file()
        operator('EXEC_DEFAULT', True)
        _names.append(bpy.context.object.name)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()


def shape():
    """Undo gives it another address."""
    return bpy.data.objects[_names[-1]]


def value():
    return shape().data.splinewright.value


def place_seen(view):
    """(u, v) inside the patch before which nothing lies in the view."""
    return place_seen_on(view, shape())


def place_seen_on(view, ob):
    """The same of the one patch of an object."""
    return next(places_seen_on(view, ob))


def places_seen_on(view, ob):
    """All such places of a grid."""
    (u0, u1), (v0, v1) = ob.data.splinewright.value.domain
    grid = itertools.product(np.linspace(u0, u1, 12)[2:-2], np.linspace(v0, v1, 14)[3:-3])
    return (at for at in grid if _is_seen(view, ob, at))


def _is_seen(view, ob, at):
    x, y = view.pixel_of(ob.matrix_world @ Vector(ob.data.splinewright.value.evaluate(*at)))
    with view.override():
        found = part('ui.picking').parameters_at(view.region, view.region.data, (x - view.region.x, y - view.region.y),
                                                 [ob], bpy.context.evaluated_depsgraph_get())
    return found is not None and np.allclose(found[2], at, atol=0.02)
