"""Seams that are drawn are told from the net that lies on them, and its points from them."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
sc, colors, state = part('core.base.library').sc, part('ui.colors'), part('bridge.data.file_state').state


def strip():
    """Three patches side by side, the third one folded up: their nets lie on their seams, of G2 and with an edge."""
    def patch(x, slope):
        return sc.BezierPatch([[(x + i, j, slope * i) for j in range(4)] for i in range(4)])
    return sc.PatchSet.from_patches([patch(0, 0), patch(3, 0), patch(6, 1)])


def colors_of(picture, view, point, reach=3):
    """The colors around a point of the world: the n x n pixels."""
    x, y = view.pixel_of(point)
    row = picture.shape[0] - 1 - y
    return picture[row - reach:row + reach + 1, x - reach:x + reach + 1].reshape(-1, 3).astype(float)


def is_there(picture, view, point, wanted, reach=3):
    return np.abs(colors_of(picture, view, point, reach) - 255 * np.array(wanted[:3])).max(1).min() < 16


def steps():
    view = View()
    view.move()
    with view.override():
        empty_file()
        data = part('bridge.shape.shape').new_data("shape", strip(), (6, 6))
        ob = bpy.data.objects.new("shape", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        ob.data.splinewright.show_seams = True
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_orbit(angle=0.4, type='ORBITUP')
        bpy.ops.view3d.view_selected()
    view.move(420, 300)
    yield from redrawn()
    save_picture(OUTPUT / "seams.png")
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.mesh.select_all(action='DESELECT')
    yield from redrawn()
    yield from redrawn()
    found, of_class = save_picture(OUTPUT / "seams-net.png"), colors.of_seams()
    for x, number in ((3, 2), (6, 0)):
        for y in (0.5, 1.5, 2.5):       # between points of the net, the rows of which lie there, too
            assert is_there(found, view, (x, y, 0), of_class[number]), (x, y)
            assert is_there(found, view, (x, y, 0), colors.SEAM_RIM, 6), (x, y)
            assert not is_there(found, view, (x, y, 0), colors.of_net()[0]), "the net lies above the seam"
        for y in (1, 2):
            assert is_there(found, view, (x, y, 0), colors.of_points(), 2), "a point of the net does not show"
    key = part('bridge.data.file_state').key(bpy.data.objects["shape"].data)
    known = state.sights[key]['seams'][1]
    yield from redrawn()
    yield from redrawn()
    assert state.sights[key]['seams'][1] is known, "worked out anew though nothing changed"
    view.press('TAB')
    yield from out_of_net()


run(steps())
