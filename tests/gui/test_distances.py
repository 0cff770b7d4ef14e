"""Colors by the distance from another object: those of the legend, live, measured again only after changes."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, empty_file, into_net, mean_difference, out_of_net, part, redrawn, run, save_picture,
                    select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Of a picture, where shapes are and neither regions nor the legend; and where that is.
PLACE, LEGEND = (slice(100, 680), slice(260, 830)), (slice(480, 760), slice(850, 1060))
state = part('bridge.data.file_state').state
deviations = part('bridge.analysis.deviations')


def chosen():
    return bpy.context.scene.splinewright_sights


def picture(name):
    return save_picture(OUTPUT / f"distances-{name}.png")


def deviation(name):
    """What is known of a shape, measured in the end; None until it is."""
    data = bpy.data.objects[name].data
    known = state.sights.get(part('bridge.data.file_state').key(data), {}).get(('deviation', name))
    return known[1] if known else None


def measured(name, is_so, what):
    """Steps until distances were measured in the end, and are so."""
    def is_there():
        found = deviation(name)
        return found is not None and is_so(found)
    yield from redrawn()
    yield from until(is_there, what)
    yield from redrawn()


def made(view):
    """A patch, a mesh above it, and the patch selected."""
    empty_file()
    with view.override():
        bpy.ops.mesh.primitive_plane_add(size=20, location=(0, 0, 2))
        bpy.context.object.name = "plane"
        bpy.context.object.display_type = 'WIRE'
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        bpy.context.object.name = "patch"
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_orbit(angle=0.6, type='ORBITUP')
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()


def heights():
    """The largest distance to the plane, by the exact patch."""
    patch = bpy.data.objects["patch"].data.splinewright.value
    (u0, u1), (v0, v1) = patch.domain
    return 2 - patch.evaluate_grid(np.linspace(u0, u1, 90), np.linspace(v0, v1, 90))[..., 2]


def require_colors(view, shown):
    """Places on the patch have the colors that the legend has for their distances, darker where the surface turns away."""
    patch, largest = bpy.data.objects["patch"].data.splinewright.value, deviation("patch").largest
    (u0, u1), (v0, v1) = patch.domain
    palette = part('ui.surface_shader')
    for u in (0.1, 0.5):
        at = patch.evaluate(u0 + u * (u1 - u0), v0 + 0.6 * (v1 - v0))
        x, y = view.pixel_of(at)
        pixel = shown[shown.shape[0] - 1 - int(y), int(x)].astype(float)
        wanted = 255 * palette.colors_at([2 * (2 - at[2]) / largest - 1], palette.DISTANCES)[0]
        light = pixel @ wanted / (wanted @ wanted)
        assert 0.65 < light < 1.05 and np.abs(pixel - light * wanted).max() < 12, (u, pixel, wanted)


def surface(view):
    yield from made(view)
    off = picture("off")
    chosen().deviation = True
    yield from redrawn()
    assert mean_difference(off[PLACE], picture("none")[PLACE]) < 0.3, "painted though there is nothing to measure to"
    chosen().deviation_object = bpy.data.objects["plane"]
    wanted = heights()
    yield from measured("patch", lambda found: abs(found.largest - wanted.max()) < 1e-3, "the distance to the plane")
    on = picture("plane")
    assert mean_difference(off[PLACE], on[PLACE]) > 3.0 and mean_difference(off[LEGEND], on[LEGEND]) > 3.0
    require_colors(view, on)
    before = deviation("patch")
    assert np.nanmin(before.values) > wanted.min() - 1e-3 and wanted.min() < before.mean < wanted.max()
    yield from redrawn()
    yield from redrawn()
    assert deviation("patch") is before, "measured again though nothing changed"
    bpy.data.objects["plane"].location.z = 5
    yield from measured("patch", lambda found: abs(found.largest - 3 - wanted.max()) < 1e-3, "the plane moved")
    bpy.data.objects["plane"].data.vertices[0].co.z += 1.0
    bpy.data.objects["plane"].data.update()
    yield from measured("patch", lambda found: abs(found.largest - 3 - wanted.max()) > 1e-2, "the plane changed")
    print("surface", flush=True)


def while_a_net_is_edited(view):
    """Every step of a drag is shown at once, by few places."""
    yield from made(view)
    chosen().deviation_object = bpy.data.objects["plane"]
    yield from measured("patch", lambda found: True, "distances")
    before = picture("before-net")
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(5)
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 1.5))
    yield from redrawn()
    wanted = heights()
    yield from measured("patch", lambda found: abs(found.largest - wanted.max()) < 1e-3, "the patch as it is now")
    assert mean_difference(before[PLACE], picture("net")[PLACE]) > 0.5
    view.press('TAB')
    yield from out_of_net()
    chosen().deviation = False
    yield from redrawn()
    assert not state.targets, "something of the object is kept though the switch is off"
    print("net", flush=True)


def curve(view):
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, count=7)
        bpy.context.object.name = "other"
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, count=7)
        bpy.context.object.name = "curve"
        bpy.context.object.location.z = 0.75
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_orbit(angle=0.6, type='ORBITUP')
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    off = picture("curve-off")
    chosen().deviation, chosen().deviation_object = True, bpy.data.objects["other"]
    yield from measured("curve", lambda found: 0.1 < found.largest < 0.75 + 1e-6, "the distance from another curve")
    assert mean_difference(off[PLACE], picture("curve")[PLACE]) > 0.05
    bpy.data.objects["curve"].rotation_euler.z = 0.5
    yield from measured("curve", lambda found: found.largest > 0.75 + 1e-3, "the curve turned")
    picture("curve-turned")
    print("curve", flush=True)


def popover(view):
    chosen().deviation_object = bpy.data.objects["curve"]
    with view.override():
        bpy.ops.wm.call_panel(name="VIEW3D_PT_overlay", keep_open=True)
    yield from redrawn()
    picture("popover")
    view.press('ESC')
    yield from redrawn()
    print("popover", flush=True)


def steps():
    view = View()
    view.move()
    yield from surface(view)
    yield from while_a_net_is_edited(view)
    yield from curve(view)
    yield from popover(view)


run(steps())
