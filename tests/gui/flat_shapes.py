"""Flat shapes in a file of their own, seen from above."""

import bpy
import numpy as np

from window import empty_file, part, redrawn


def begun(view):
    """An empty scene, seen from above."""
    with view.override():
        empty_file()
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.context.space_data.region_3d.view_location = (0, 0, 0)
        bpy.context.space_data.region_3d.view_distance = 14
    yield from redrawn()


def lines(view, *rows):
    """A shape of each, all selected, the first active."""
    yield from begun(view)
    sc = part('core.base.library').sc
    for number, row in enumerate(rows):
        data = part('bridge.shape.shape').new_data(f"line {number}", sc.BezierCurve(np.array(row, float)), (12, 12))
        ob = bpy.data.objects.new(f"line {number}", data)
        bpy.context.scene.collection.objects.link(ob)
        ob.select_set(True)
        bpy.context.view_layer.objects.active = bpy.data.objects["line 0"]
    with view.override():
        bpy.ops.ed.undo_push(message="lines")
    yield from redrawn()


def curves(name=None):
    ob = bpy.data.objects[name] if name else bpy.context.object
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


def sheet(view, count=1):
    """Flat patches in a row along x, with room between them."""
    sc = part('core.base.library').sc
    u, v = np.meshgrid(np.linspace(-1, 1, 4), np.linspace(-1, 1, 4), indexing='ij')
    patches = [sc.BezierPatch(np.stack([u + 3 * i, v, np.zeros_like(u)], -1)).to_nurbs() for i in range(count)]
    with view.override():
        empty_file()
        data = part('bridge.shape.shape').new_data("sheet", sc.PatchSet.from_patches(patches) if count > 1 else patches[0], (6, 6))
        ob = bpy.data.objects.new("sheet", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.ops.view3d.view_selected()
        bpy.ops.ed.undo_push(message="sheet")
    yield from redrawn()
