"""What moves with a net is no target of Blender's magnet while the net is out, and all is as it was afterwards."""

import bpy
import pytest

from curves import value_of
from shapes import VALUES, activate, add, enter, leave, op
from support import part

editing, magnet = part('ui.editing'), part('bridge.net.magnet')


def excluded():
    """Names of the objects that the magnet passes over, or none where it passes over nothing."""
    is_on = bpy.context.scene.tool_settings.use_snap_selectable
    return {ob.name for ob in bpy.data.objects if ob.hide_select} if is_on else set()


def nothing_is_left():
    blocks = (*bpy.data.objects, *bpy.data.scenes)
    return not bpy.context.scene.tool_settings.use_snap_selectable and not any(magnet._WAS in block.keys() for block in blocks)


def test_a_shape_and_what_follows_it_are_excluded_while_its_net_is_out():
    profile, other = add(value_of('cubic'), "profile"), add(VALUES['nurbs patch'](), "other")
    activate(profile)
    op(bpy.ops.splinewright.add_revolve)
    surface = bpy.context.object
    copy = bpy.data.objects.new("copy", profile.data)
    bpy.context.collection.objects.link(copy)
    activate(profile)
    enter()
    assert excluded() == {"profile", "copy", surface.name} and not other.hide_select
    leave()
    assert excluded() == set() and nothing_is_left() and bpy.context.object == profile and profile.select_get()


@pytest.mark.parametrize('was_hidden', (False, True))
def test_what_was_set_before_is_so_again(was_hidden):
    ob, tools = add(VALUES['nurbs patch'](), "shape"), bpy.context.scene.tool_settings
    other = add(VALUES['nurbs'](), "other")
    other.hide_select = tools.use_snap_selectable = was_hidden
    activate(ob)
    enter()
    assert excluded() == {"shape", "other"} if was_hidden else excluded() == {"shape"}
    leave()
    assert tools.use_snap_selectable == was_hidden == other.hide_select and not ob.hide_select
    tools.use_snap_selectable = False


def test_undo_and_redo_go_over_that_border_too():
    add(VALUES['nurbs patch'](), "shape")
    bpy.ops.ed.undo_push(message="add")
    enter()
    bpy.ops.ed.undo_push(message="in the net")
    while bpy.context.mode != 'OBJECT':
        bpy.ops.ed.undo()
    editing.sweep()
    assert nothing_is_left() and not bpy.data.objects["shape"].hide_select
    bpy.ops.ed.redo()
    assert excluded() == {"shape"}
    leave()
    assert nothing_is_left()


def test_a_file_is_saved_without_it(tmp_path):
    add(VALUES['nurbs patch'](), "shape")
    enter()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "shape.blend"), copy=True)
    assert excluded() == {"shape"}
    leave()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "shape.blend"))
    assert nothing_is_left() and not bpy.data.objects["shape"].hide_select


def test_other_ways_out_bring_it_back_too():
    add(VALUES['nurbs patch'](), "shape")
    enter()
    bpy.ops.object.mode_set(mode='OBJECT')
    editing.sweep()
    assert nothing_is_left() and bpy.data.objects["shape"].select_get()
    activate(bpy.data.objects["shape"])
    held = enter()
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.data.objects.remove(held)
    editing.sweep()
    assert nothing_is_left() and not bpy.data.objects["shape"].hide_select
