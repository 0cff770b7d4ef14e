"""A point of a net that is dragged with the magnet on goes to other objects, and does not hop about on what it moves."""

import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from one_shape import added
from window import View, into_net, nets, out_of_net, part, redrawn, run, select_points


def place(number):
    ob = nets()[0]
    ob.update_from_editmode()
    return np.array(ob.data.vertices[number].co)


def dragged(view):
    yield from added(view, bpy.ops.splinewright.add_nurbs_patch)
    with view.override():
        bpy.ops.mesh.primitive_plane_add('EXEC_DEFAULT', True, size=1.0, location=(3.0, 0.0, 0.5))
        bpy.context.view_layer.objects.active = bpy.data.objects["NURBS Patch"]
        bpy.ops.view3d.view_axis(type='TOP')
    region = view.area.spaces.active.region_3d
    region.view_distance, region.view_location = 10.0, (1.0, 0.0, 0.0)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    points = part('bridge.net.live').session(nets()[0].data).points
    number = int(np.linalg.norm(points[:, :2] - points[:, :2].mean(0), axis=1).argmin())
    select_points(number)
    tools = bpy.context.scene.tool_settings
    tools.snap_elements, tools.use_snap = {'FACE'}, True
    yield from redrawn()
    before, start = place(number), view.pixel_of(Vector(points[number]))
    view.move(*start)
    view.press('G')
    yield from redrawn()
    for step in range(1, 6):
        view.move(start[0] + 5 * step, start[1] + 3 * step)
        yield from redrawn()
        assert abs(place(number)[2] - before[2]) < 1e-5, "the point hops onto what it moves"
    assert np.abs(place(number) - before).max() > 0.01, "it goes with the mouse"
    view.move(*view.pixel_of(Vector((3.0, 0.1, 0.5))))
    yield from redrawn()
    yield from redrawn()
    assert abs(place(number)[2] - 0.5) < 1e-5, "it goes onto another object"
    view.press('ESC')
    yield from redrawn()
    tools.use_snap = False
    view.press('TAB')
    yield from out_of_net()
    print("dragged", flush=True)


run(dragged(View()))
