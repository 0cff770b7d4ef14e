"""Shapes whose control points have keys, for tests."""

import bpy
import numpy as np

from animated import animate, curves_of, in_scene
from shapes import activate, add, enter, op
from support import part

point_keys, store = part('bridge.keys.point_keys'), part('bridge.data.store')
key, clear = bpy.ops.splinewright.key_points, bpy.ops.splinewright.clear_point_keys


def at(frame):
    bpy.context.scene.frame_set(frame)


def pool(ob):
    return store.read(ob.data).pool


def key_at(frame, *moves, **settings):
    """Go to a frame, move points as of put(), and set keys."""
    at(frame)
    for move in moves:
        put(bpy.context.object, *move)
    assert op(key, **settings) == {'FINISHED'}


def straight(data):
    """Go straight from key to key."""
    for curve in curves_of(data.animation_data.action):
        for point in curve.keyframe_points:
            point.interpolation = 'LINEAR'


def put(ob, rows, step):
    """Move rows of the pool by a step (3,) or (4,), by a script."""
    definition = store.read(ob.data)
    moved = definition.pool.copy()
    moved[rows, :len(step)] += step
    part('bridge.shape.shape').set_definition(ob.data, part('core.shape.definition').Definition(
        definition.form, moved, definition.pieces))
    bpy.context.view_layer.update()


def keyed_shape(value, step=(0.0, 0.0, 6.0), rows=slice(None)):
    """A shape whose points were at home at frame 1 and are a step away at frame 7."""
    ob = add(value)
    key_at(1)
    key_at(7, (rows, step))
    straight(ob.data)
    at(1)
    return ob


def animate_row(ob, row, name, values, index=-1):
    item = point_keys.added(ob.data, [row])[0]
    point_keys.show(ob.data, pool(ob))
    animate(ob.data, f"splinewright_keyed[{item}].{name}", values, index)


def drive(ob, row, name, index):
    lever = in_scene("lever", None)
    item = point_keys.added(ob.data, [row])[0]
    point_keys.show(ob.data, pool(ob))
    arguments = (f"splinewright_keyed[{item}].{name}",) + ((index,) if name == 'place' else ())
    driver = ob.data.driver_add(*arguments).driver
    variable = driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = lever, 'location.x'
    driver.expression = variable.name
    return lever


def keys(ob):
    """How many there are on all channels."""
    curves = list(part('bridge.data.animation').curves(ob.data))
    return sum(len(curve.keyframe_points) for curve in curves)


def moving(ob):
    """{row: how far its keys move it from frame 1 to 7}."""
    at(1)
    first = pool(ob)
    at(7)
    return dict(enumerate((pool(ob) - first)[:, 2].tolist()))


def ramp(value):
    """A shape of which row i has moved by i + 1 at frame 7."""
    ob = add(value)
    key_at(1)
    at(7)
    for row in range(len(pool(ob))):
        put(ob, row, (0, 0, row + 1))
    op(key)
    straight(ob.data)
    at(1)
    return ob


def edited(ob):
    """Its net in Edit Mode."""
    activate(ob)
    return enter()


def net_places(held):
    """Where the net has its points now, in Blender."""
    session = part('bridge.net.live').session(held.data)
    present = part('bridge.cage.net_object').present(held, session.net)
    slots = part('core.net.reading').slots(session.net, present)
    return present.positions()[slots]
