"""Revolve about an empty that is selected beside the profile, then about an edge that is clicked: shown under the mouse."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def picture(name):
    return save_picture(OUTPUT / f"axis-{name}.png")


def state():
    return part('ui.ui_state').ui_state


def revolved():
    return bpy.data.objects[NAMES[-1]]


NAMES = []


def select(*obs):
    bpy.ops.object.select_all(action='DESELECT')
    for ob in obs:
        ob.select_set(True)
    bpy.context.view_layer.objects.active = obs[0]


def scene(view):
    with view.override():
        empty_file()
        bpy.ops.mesh.primitive_cube_add(location=(-4, 0, 0))
        bpy.ops.object.empty_add(location=(2, 0, 0), rotation=(0, 0.5, 0))
        axis = bpy.context.object
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
        select(bpy.context.object, axis)
        bpy.ops.splinewright.add_revolve('INVOKE_DEFAULT', True)
        NAMES.append(bpy.context.object.name)
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    assert part('bridge.recipes.recipes').read(revolved().data).frames == (axis,)
    picture("of-an-empty")


def an_edge(view):
    before = revolved().data.splinewright.value
    cube = bpy.data.objects["Cube"]
    eye = view.region.data.view_matrix.inverted().translation
    edges = [[cube.matrix_world @ cube.data.vertices[i].co for i in edge.vertices] for edge in cube.data.edges]
    start, end = min(edges, key=lambda ends: ((ends[0] + ends[1]) / 2 - eye).length)
    inside = (start + end) / 2 * 0.97 + cube.location * 0.03
    plain = picture("before")
    with view.override():
        bpy.ops.splinewright.axis_from_edge('INVOKE_DEFAULT')
    view.move(*view.pixel_of(inside))
    wanted = {tuple(np.round(point, 4)) for point in (start, end)}
    yield from until(lambda: state().edge is not None and {tuple(np.round(point, 4)) for point in state().edge[1:]} == wanted,
                     "the edge at the mouse is shown")
    yield from redrawn()
    assert mean_difference(picture("edge"), plain) > 0.01
    view.press('ESC')
    yield from until(lambda: state().edge is None, "Esc ends it")
    assert revolved().data.splinewright.value == before
    with view.override():
        bpy.ops.splinewright.axis_from_edge('INVOKE_DEFAULT')
    view.move(*view.pixel_of(inside))
    yield from until(lambda: state().edge is not None, "the edge at the mouse, again")
    view.press('LEFTMOUSE')
    yield from until(lambda: revolved().data.splinewright.value != before, "a click turns it about the edge")
    [axis] = part('bridge.recipes.recipes').read(revolved().data).frames
    assert axis.parent == cube and part('bridge.follow.follow').problem(revolved().data) == ""
    yield from redrawn()
    picture("of-an-edge")
    view.press('Z', ctrl=True)
    yield from until(lambda: revolved().data.splinewright.value == before, "Ctrl+Z takes it back")
    assert not any(ob.name.endswith("Axis") for ob in bpy.context.scene.objects)


def steps():
    view = View()
    yield from scene(view)
    yield from an_edge(view)


run(steps())
