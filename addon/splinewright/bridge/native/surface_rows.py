"""Surface objects that hold rows of points only, as Blender's Surface > NURBS Curve and NURBS Circle: Blender draws curves."""

import bpy

from . import native_splines, read_native, retype


def are_all(ob):
    """Whether a SURFACE object holds rows of points, and nothing else."""
    return bool(ob.data.splines) and all(spline.type == 'NURBS' and spline.point_count_v == 1 for spline in ob.data.splines)


def become_curves(context, ob, users):
    """Make it, and all objects that share its data, CURVE objects that draw the same. Returns what was lost, as nouns."""
    data = ob.data
    curve = bpy.data.curves.new(data.name, 'CURVE')
    curve.dimensions = '3D'
    for material in data.materials:
        curve.materials.append(material)
    for row, spline in zip(read_native.rows(ob), data.splines):
        made = native_splines.append(curve, row, spline.resolution_u)
        made.material_index, made.use_smooth = spline.material_index, spline.use_smooth
    lost = ["the animation of the surface data"] if data.animation_data else []
    lost += ["the shape keys"] if data.shape_keys else []
    return lost + retype.all_become(context, users, curve, _take, _take)


def _take(_, ob, data):
    """Objects of curves and of surfaces take each other's data, and are of its type then."""
    ob.data = data
    return []
