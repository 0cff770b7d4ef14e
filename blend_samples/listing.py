"""Pictures for the page of the add-on on a platform: an icon of 256 x 256, and windows of 1920 x 1080, the first of which is shown large.

`./run listing` calls it, in a window of that size.
"""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "tests/gui"), str(HERE.parent / "addon")]

import make_icons
import window

OUTPUT = Path(os.environ["SPLINEWRIGHT_OUTPUT"])
#: A sample scene, the shape that is selected in it, and the overlays that are shown.
SCENES = [("kettle", "Body", ("stripes",)), ("mouse", None, ("curvature",)), ("hull", None, ("polygon",)), ("flask", "Front", ("isocurves",))]
#: Where a window of this size has the tab of the sidebar.
TAB = 1572, 833
_BLUE, _GRAY, _ORANGE, _NIGHT = (0x4D, 0xA6, 0xFF), (0xA0, 0xA0, 0xA8), (0xFF, 0x99, 0x33), (0x22, 0x22, 0x2A)


def icon(size=256, finer=4):
    """A cubic with its control polygon, as rows of colors."""
    corners = (38, 60), (70, 205), (165, 225), (217, 82)
    picture = np.zeros((size * finer, size * finer, 3), np.uint8)
    picture[:] = _NIGHT
    for color, triangles in ((_GRAY, make_icons.line(corners, 8)), (_BLUE, make_icons.line(make_icons.cubic(*corners, count=48), 18)),
                             (_ORANGE, [one for corner in corners for one in make_icons.disc(*corner, 14)])):
        for triangle in triangles:
            fill(picture, np.array(triangle) * size * finer / 255, color)
    return picture.reshape(size, finer, size, finer, 3).mean(axis=(1, 3)).round().astype(np.uint8)[::-1]


def fill(picture, triangle, color):
    """Color the pixels whose middles are in a triangle."""
    low, high = np.floor(triangle.min(0)).astype(int).clip(0), np.ceil(triangle.max(0)).astype(int) + 1
    x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
    turns = [(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) for a, b in zip(triangle, np.roll(triangle, -1, 0))]
    inside = np.all(np.array(turns) >= 0, axis=0) | np.all(np.array(turns) <= 0, axis=0)
    part = picture[low[1]:high[1], low[0]:high[0]]
    part[inside[:part.shape[0], :part.shape[1]]] = color


def steps():
    window.write_png(OUTPUT / "icon.png", icon())
    for number, (name, shape, overlays) in enumerate(SCENES, 1):
        bpy.ops.wm.open_mainfile(filepath=str(HERE / f"{name}.blend"), load_ui=False)
        yield from window.redrawn()
        yield from show(window.View(), bpy.data.objects[shape] if shape else largest(), overlays)
        window.save_picture(OUTPUT / f"{number}-{name}.png")


def largest():
    """The shape that is largest, but for what things stand on."""
    shapes = [ob for ob in bpy.context.view_layer.objects
              if ob.visible_get() and ob.data and window.part("bridge.shape.shape").is_shape(ob.data) and max(ob.dimensions) < 20]
    return max(shapes, key=lambda ob: sum(ob.dimensions))


def show(view, ob, overlays):
    """Steps that select a shape and look at it by the camera of its scene, with its panels."""
    for other in bpy.context.selected_objects:
        other.select_set(False)
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    for overlay in overlays:
        setattr(bpy.context.scene.splinewright_sights, overlay, True)
    space = view.area.spaces.active
    space.shading.type = 'MATERIAL'
    space.region_3d.view_perspective = 'CAMERA'
    with view.override():
        bpy.ops.view3d.view_center_camera()
    space.region_3d.view_camera_zoom -= 5
    view.open_sidebar()
    yield from window.redrawn()
    yield from view.show_tab("NURBS", TAB)
    view.move(420, 420)
    yield from window.redrawn()


window.run(steps())
