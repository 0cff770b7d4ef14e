"""Blender's global undo turned off: its steps of Edit Mode go on, and would crash where a net of theirs was removed."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, enter, first_point, leave, move, numbers_of, op, require_exact, select
from support import part
from test_files import reopen, save

editing, live, net_object = part('ui.editing'), part('bridge.net.live'), part('bridge.cage.net_object')


@pytest.fixture(autouse=True)
def no_global_undo(empty_scene):        # after the scene, which reads preferences
    bpy.context.preferences.edit.use_global_undo = False
    yield
    bpy.context.preferences.edit.use_global_undo = True


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def moved_twice(name):
    """The values of a shape before, after one move and after another, in its net."""
    add(VALUES[name]())
    held = enter()
    select(held, first_point(held))
    seen = [value()]
    for _ in range(2):
        move(0, 0, 1)
        seen.append(value())
    return seen


def undo():
    bpy.ops.ed.undo()
    editing.sweep()


@pytest.mark.parametrize('name', ('nurbs patch', 'teapot', 'nurbs', 'hermite', 'many curves'))
def test_the_net_is_entered_left_undone_and_redone(name):
    first, second, third = moved_twice(name)
    undo()
    assert value() == second and bpy.context.mode.startswith('EDIT')
    bpy.ops.ed.redo()
    assert value() == third
    leave()
    assert bpy.context.mode == 'OBJECT' and not list(editing.nets()) and bpy.context.object.name == "shape"
    undo()
    held = bpy.context.object
    assert net_object.is_net(held) and held.mode == 'EDIT' and bpy.context.mode.startswith('EDIT'), "back in the net"
    seen = [value()]
    for _ in range(5):
        if bpy.ops.ed.undo.poll():
            undo()
            seen.append(value())
    assert seen[-1] == first and second in seen
    for _ in range(8):
        if bpy.ops.ed.redo.poll():
            bpy.ops.ed.redo()
            editing.sweep()
    assert value() == third
    leave()
    require_exact(bpy.data.objects["shape"])
    assert value() == third


def test_a_net_that_undo_brings_back_is_live():
    *_, last = moved_twice('nurbs patch')
    leave()
    undo()
    held = bpy.context.object
    select(held, 5)
    move(1, 0, 0)
    assert value() != last and live.problem(held) == ""
    leave()
    require_exact(bpy.data.objects["shape"])


def test_a_shape_that_has_changed_since_is_not_overwritten_by_a_net_that_undo_brings_back():
    moved_twice('nurbs patch')
    leave()
    bpy.data.objects["shape"].data.splinewright.value = VALUES['bezier patch']()
    given = value()
    undo()
    held = bpy.context.object
    assert value() == given and "earlier time" in live.problem(held)
    move(0, 0, 1)
    assert value() == given
    leave()
    assert value() == given and [ob.name for ob in bpy.context.scene.objects] == ["shape"]
    require_exact(bpy.data.objects["shape"])


def test_many_times_in_and_out_and_all_the_way_back():
    add(VALUES['nurbs patch']())
    for i in range(4):
        held = enter()
        select(held, i)
        move(0, 0, 1)
        leave()
    for _ in range(40):
        if bpy.ops.ed.undo.poll():
            undo()
            bpy.context.view_layer.update()
    for _ in range(40):
        if bpy.ops.ed.redo.poll():
            bpy.ops.ed.redo()
            editing.sweep()
    if bpy.context.mode != 'OBJECT':
        leave()
    require_exact(bpy.data.objects["shape"])


def test_knots_a_renewed_net_and_saving_in_the_net(tmp_path):
    add(VALUES['nurbs']())
    held = enter()
    select(held, 2)
    move(0, 0, 1)
    op(bpy.ops.splinewright.set_knots, knots="0 0 0 0 0.125 0.75 1 1 1 1")
    op(bpy.ops.splinewright.renew_net)
    saved = value()
    save(tmp_path / "x.blend")
    assert bpy.context.mode == 'EDIT_CURVE'
    for _ in range(6):
        if bpy.ops.ed.undo.poll():
            undo()
    if bpy.context.mode != 'OBJECT':
        leave()
    require_exact(bpy.data.objects["shape"])
    reopen(tmp_path / "x.blend")
    assert value() == saved and [ob.name for ob in bpy.data.objects] == ["shape"]
    activate(bpy.data.objects["shape"])
    enter()
    leave()


def test_a_net_left_by_another_way_and_an_add_on_that_goes():
    moved_twice('nurbs patch')
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    editing.sweep()
    last = value()
    undo()
    enter() if bpy.context.mode == 'OBJECT' else None
    part('ui').unregister()
    try:
        assert bpy.context.mode == 'OBJECT' and [ob.name for ob in bpy.context.scene.objects] == ["shape"]
        for _ in range(3):
            if bpy.ops.ed.undo.poll():
                bpy.ops.ed.undo()
    finally:
        part('ui').register()
    part('ui.handlers').loaded()
    editing.sweep()
    assert np.isfinite(value().points).all() and last is not None
