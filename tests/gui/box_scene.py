"""A box of six patches, alone in a window."""

import bpy

from window import empty_file, part, redrawn


def box(view):
    """Steps until it is there, with nothing selected."""
    sc = part('core.base.library').sc
    square = sc.build.contour([(-1.5, -1, 0), (1.5, -1, 0), (1.5, 1, 0), (-1.5, 1, 0)], closed=True)
    value = sc.PatchSet.from_patches(sc.build.cap([sc.build.extrude(square, (0, 0, 1))], None).value)
    with view.override():
        empty_file()
        data = part('bridge.shape.shape').new_data("box", value, (4, 4))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("box", data))
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="box")
    yield from redrawn()
