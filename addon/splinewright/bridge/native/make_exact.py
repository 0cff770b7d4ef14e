"""Blender's own curves, surfaces and texts become shapes, in their place."""

from typing import NamedTuple

import bpy
import numpy as np

from ...core.base.failures import Refusal, blenders_refusals
from ...core.native import native_density
from ...core.net.handles import fitting
from ..curve import handles
from ..data import blocks, settings, store, versions
from ..data.shading import Look
from ..mesh import mesh_looks
from ..shape import curve_pieces, shape
from . import measure_native, native_layers, native_links, native_splines, read_native, retype, staging, surface_rows

#: Of objects that can be made exact.
TYPES = ('CURVE', 'SURFACE', 'FONT')


class Outcome(NamedTuple):
    """What was done."""

    deviation: object               # the largest distance from what Blender drew, or None if not measured
    dropped: list                   # what could not be kept: nouns


def make_exact(context, ob):
    """Make the data-block of a CURVE, SURFACE or FONT object a shape, and so of all objects that share it.

    A curve keeps its data-block. A surface becomes a mesh, rows of points and a text curves, and the objects stay the same objects.
    Raises one of the FAILURES, and has changed nothing, if it cannot be.
    """
    users = native_links.users_of(ob.data)
    _require_native(ob, users)
    if ob.type == 'FONT':
        _become_curve(context, ob)
    dropped = surface_rows.become_curves(context, ob, users) if ob.type == 'SURFACE' and surface_rows.are_all(ob) else []
    reading = read_native.read(ob)
    if reading.value is None:
        raise Refusal("; ".join(["nothing to make exact", *reading.dropped]))
    deviation = measure_native.of_reading(ob, reading)
    dropped += reading.dropped + native_links.parented_points(users)
    if ob.data.shape_keys:
        dropped.append("the shape keys")
    lost = (_surface if ob.type == 'SURFACE' else _curve)(context, ob, reading, users)
    return Outcome(deviation, dropped + lost)


def _require_native(ob, users):
    if ob.type not in TYPES:
        raise Refusal("it is not a curve, surface or text")
    if store.has_definition(ob.data):
        raise Refusal("it is exact already")
    for block in [ob.data, *(users if ob.type == 'SURFACE' else [])]:
        if block.library or block.override_library:
            raise Refusal("{name} is linked from another file and cannot be changed here", name=block.name)
    if ob.data.is_editmode:
        raise Refusal("leave Edit Mode first")


def _become_curve(context, ob):
    """Of the outlines of its letters."""
    shown = ob.to_curve(context.evaluated_depsgraph_get())
    has_letters = len(shown.splines) > 0
    ob.to_curve_clear()
    if not has_letters:
        raise Refusal("its text has no letters that are seen")
    with staging.alone(context, ob), blenders_refusals():
        bpy.ops.object.convert(target='CURVE')
    if ob.type != 'CURVE':
        raise Refusal("Blender did not convert {name}", name=ob.name)


def _curve(context, ob, reading, users):
    data = ob.data
    steps = max(native_density.steps_of_curve(spline, data.splines[i].resolution_u, versions.sampling)
                for spline, i in zip(reading.splines, reading.indices))
    rehearsal = shape.new_data(data.name, reading.value, (steps, steps))    # raises before anything is changed
    blocks.remove(rehearsal)
    is_flat, lost = native_layers.fill_of(data, reading.indices)
    layers = [native_layers.along(data.splines[i], spline) for spline, i in zip(reading.splines, reading.indices)]
    types = [_handle_letters(data.splines[i], spline) for spline, i in zip(reading.splines, reading.indices)]
    lost += native_links.hooked_points(users)
    if data.shape_keys:
        ob.shape_key_clear()
    if native_links.drop_point_animation(data):
        lost.append("the animation of single points")
    settings.set_resolution(data, steps, steps)
    shape.set_value(data, reading.value)
    definition = store.read(data)
    handles.write(data, fitting(types, definition))
    fractions = [np.concatenate([line.at for line in lines]) for lines in curve_pieces.shown_of(data, definition)]
    curve_pieces.write(data, definition, [[of_spline(at)] for of_spline, at in zip(layers, fractions)])
    if is_flat:
        data.dimensions = '2D'
    return lost


def _handle_letters(spline, numbers):
    """The letters of a spline's handles, "" where it has none. numbers: its NativeSpline, whose points shape keys may move."""
    if numbers.kind != 'BEZIER':
        return ""
    ends = numbers.points[[0, -1], 1]
    is_merged = len(numbers.points) > 2 and not spline.use_cyclic_u and bool((ends[0] == ends[1]).all())
    return native_splines.handle_letters(spline, is_merged)


def _surface(context, ob, reading, users):
    data = ob.data
    steps = [max(native_density.steps_of_surface(spline.directions[axis], getattr(data.splines[i], f"resolution_{name}"))
                 for spline, i in zip(reading.splines, reading.indices)) for axis, name in ((1, 'v'), (0, 'u'))]
    mesh = shape.new_data(data.name, reading.value, steps)
    for material in data.materials:
        mesh.materials.append(material)
    smooth = [data.splines[i].use_smooth for i in reading.indices]
    mesh_looks.set_looks(mesh, dict(enumerate(map(Look, reading.materials, smooth))))
    shape.restore(mesh)                 # flat faces have normals of their own
    lost = ["the animation of the surface data"] if data.animation_data else []
    return lost + retype.all_become(context, users, mesh, retype.become_mesh, retype.become_surface)
