"""The data of a shape are pinned in the properties editor while another shape is active."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def steps():
    view = View()
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, resolution_u=8)
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True, resolution_u=8, resolution_v=8)
        bpy.context.view_layer.objects.active = bpy.data.objects["NURBS Curve"]
    pinned, active = bpy.data.objects["NURBS Patch"], bpy.data.objects["NURBS Curve"]
    area = view.beside('PROPERTIES')
    space = area.spaces.active
    space.pin_id, space.use_pin_id = pinned.data, True
    space.search_filter = "Resolution"  # our panel is below others, and closed
    yield from redrawn()
    region = next(region for region in area.regions if region.type == 'WINDOW')
    yield from view.go_to_field("resolution_u", region)
    before = pinned.data.splinewright.resolution_u, active.data.splinewright.resolution_u
    save_picture(OUTPUT / "pinned.png")
    view.wheel_up(ctrl=True)
    yield from until(lambda: pinned.data.splinewright.resolution_u != before[0], "the wheel changes what is pinned")
    assert pinned.data.splinewright.resolution_u == before[0] + 1, "the pinned shape did not change"
    assert active.data.splinewright.resolution_u == before[1], "the active shape changed"
    assert len(pinned.data.polygons) == before[0] * (before[0] + 1) * 9
    view.press('Z', ctrl=True)
    yield from until(lambda: bpy.data.objects["NURBS Patch"].data.splinewright.resolution_u == before[0], "undo")
    print("the pinned panel did what it should:", bpy.app.version_string, flush=True)


run(steps())
