"""Ctrl+J on a shape and a cube in a real window: it asks; where Blender's own Join runs, it is said afterwards."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until, user_item

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"joining-{name}.png")


def shapes():
    return {ob.name for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)}


def add_both(view):
    """A shape and, active, a cube."""
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        ob = bpy.context.object
        bpy.ops.mesh.primitive_cube_add('EXEC_DEFAULT', True, location=(3, 0, 0))
        ob.select_set(True)
        bpy.ops.ed.undo_push(message="select")
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()
    assert shapes() == {ob.name} and len(bpy.data.objects) == 2
    return ob.name, bpy.context.object.name


def asked(view):
    """Ctrl+J; the dialog is a change of the picture."""
    before = picture("selected")
    view.press('J', ctrl=True)
    yield from until(lambda: mean_difference(before, picture("asked")) > 0.5, "Ctrl+J asks")
    assert len(bpy.data.objects) == 2, "Ctrl+J joined before it was answered"


def refusing(view, name):
    yield from asked(view)
    view.press('ESC')
    yield from redrawn()
    assert shapes() == {name} and len(bpy.data.objects) == 2


def agreeing(view, name, cube):
    yield from asked(view)
    view.press('RET')
    yield from until(lambda: len(bpy.data.objects) == 1, "one object is left")
    assert not shapes() and bpy.data.objects.keys() == [cube]
    picture("joined")
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 2, "Ctrl+Z brings both back")
    assert shapes() == {name}


def blenders_own(view, name):
    """Where the key was given back to Blender, a popup tells of it; once."""
    user_item("splinewright.join").active = False
    yield from redrawn()
    said, say = [], part('ui.join_notice')._say

    def note(names):
        said.append(names)
        say(names)
    part('ui.join_notice')._say = note
    before = picture("before Blender's join")
    view.press('J', ctrl=True)
    yield from until(lambda: said, "Blender's Join took a shape, and that is said")
    assert said == [[name]]
    yield from until(lambda: mean_difference(before, picture("said")) > 0.5, "a popup")
    view.press('ESC')
    yield from redrawn()
    view.press('Z', ctrl=True)
    yield from until(lambda: len(bpy.data.objects) == 2, "Ctrl+Z brings both back")
    assert shapes() == {name}
    with view.override():
        bpy.ops.object.select_all(action='SELECT')
        bpy.data.objects[name].location.y = 1
    yield from redrawn()
    assert len(said) == 1


def steps():
    view = View()
    with view.override():
        empty_file()
    yield from redrawn()
    name, cube = yield from add_both(view)
    yield from refusing(view, name)
    yield from agreeing(view, name, cube)
    yield from blenders_own(view, name)
    print("Joining: asked, refused, agreed, undone, and Blender's own Join told of")


run(steps())
