"""A net in local view has its surface there; a file that is saved in a net opens with the shape selected; Mirror from the menu, and the
half is pulled in its net: keys and mouse, with the sidebar closed."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, in_net, into_net, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
POINTS = [[(x, y, 0.3 * (2 - x) * (y + 0.2 * x)) for y in range(3)] for x in range(4)]


def picture(name):
    return save_picture(OUTPUT / f"others-{name}.png")


def space():
    return next(area.spaces.active for area in bpy.context.window.screen.areas if area.type == 'VIEW_3D')


def scene(view):
    sc = part('core.base.library').sc
    patch = sc.NurbsPatch((2, 2), ([0, 0, 0, 0.5, 1, 1, 1], [0, 0, 0, 1, 1, 1]), POINTS)
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_cube_add(location=(-3, 0, 0))
        ob = bpy.data.objects.new("half", part('bridge.shape.shape').new_data("half", patch, (12, 12)))
        bpy.context.collection.objects.link(ob)
        bpy.ops.object.select_all(action='DESELECT')
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="half")
    yield from redrawn()


def alone(view):
    half = bpy.data.objects["half"]
    view.move(640, 420)
    view.press('TAB')
    yield from into_net()
    view.press('NUMPAD_SLASH')
    yield from until(lambda: space().local_view is not None, "local view")
    yield from until(lambda: half.visible_get(viewport=space()), "the surface is in it, too")
    assert not bpy.data.objects["Cube"].visible_get(viewport=space())
    yield from redrawn()
    picture("alone")
    view.press('NUMPAD_SLASH')
    yield from until(lambda: space().local_view is None, "all is seen again")


def saved(view):
    """In the net."""
    path = str(OUTPUT / "others.blend")
    assert in_net()
    with view.override():
        bpy.ops.wm.save_as_mainfile(filepath=path)
    yield from until(in_net, "the net is there again after saving")
    bpy.ops.wm.open_mainfile(filepath=path)
    yield from redrawn()
    assert bpy.context.object == bpy.data.objects["half"] and bpy.context.object.select_get()


def mirrored():
    return bpy.data.objects["half Mirror"]


def mirror(view):
    """What the menu calls; then Tab on it edits the half, and the image follows."""
    view.move(640, 420)
    with view.override():
        bpy.ops.splinewright.add_mirror('INVOKE_DEFAULT', True)
    yield from until(lambda: "half Mirror" in bpy.data.objects, "the mirror")
    yield from redrawn()
    picture("mirror")
    before = mirrored().data.splinewright.value
    assert bpy.data.objects["half"].hide_get() and bpy.context.object == mirrored()
    view.press('TAB')
    yield from into_net()
    select_points(7)
    yield from redrawn()
    view.press('G')
    view.press('Z')
    view.press('ONE', "1")
    view.press('RET')
    yield from until(lambda: mirrored().data.splinewright.value != before, "the image follows the net")
    view.press('Z', ctrl=True)
    yield from until(lambda: mirrored().data.splinewright.value == before, "Ctrl+Z puts both back")
    view.press('TAB')
    yield from out_of_net()
    yield from redrawn()


def steps():
    view = View()
    yield from scene(view)
    yield from alone(view)
    yield from saved(view)
    yield from mirror(View())


run(steps())
