"""Shapes given to Blender: what it draws of them against the exact shapes."""

import bpy
import numpy as np

import blender_objects
from curves import run
from geometry import mesh_points
from shapes import activate
from support import part, splinecore as sc

shape = part('bridge.shape.shape')

#: Of the size. Blender's numbers have 24 bits; unclamped shapes and Hermite chains lose more where it makes their points.
NEAR, NEAR_UNCLAMPED = 1e-6, 2e-5
#: Of the size: how far what Blender draws is at most from any place of a shape, with steps of its resolution.
STEPS = 0.06
ON_SURFACES, ON_CURVES = 12, 64
MOST_DRAWN, MOST_EXACT = 60, 100


def values_of(ob):
    """Its curves or patches."""
    value = ob.data.splinewright.value
    return list(value) if isinstance(value, (list, sc.PatchSet)) else [value]


def compare(ob, near=NEAR):
    """Give a shape to Blender: all points that it draws lie on the exact shape, which lies near them everywhere."""
    values = values_of(ob)
    exact = np.concatenate([_places_on(value) for value in values])
    size = np.ptp(exact, axis=0).max() + np.abs(exact).max()
    points = _drawn(_given(ob))
    assert len(points) > 1
    assert np.min([_distances(value.to_nurbs(), _few(points, MOST_DRAWN)) for value in values], axis=0).max() < near * size
    assert all(np.linalg.norm(points - place, axis=1).min() < STEPS * size for place in _few(exact, MOST_EXACT))


def compare_selected(near=NEAR):
    if bpy.context.mode != 'OBJECT':
        bpy.ops.object.mode_set(mode='OBJECT')
    shapes = [ob for ob in bpy.context.selected_objects if shape.has_shape(ob)]
    assert shapes
    for ob in shapes:
        compare(ob, near)


def _given(ob):
    """What Convert to Blender Curve/Surface makes of a shape, at a low resolution."""
    name = ob.name
    activate(ob)
    assert run('to_native') == {'FINISHED'}
    ob = bpy.data.objects[name]
    if ob.type == 'CURVE':
        ob.data.bevel_depth = 0.0
    for spline in ob.data.splines:
        spline.resolution_u, spline.resolution_v = (ON_SURFACES,) * 2 if ob.type == 'SURFACE' else (ON_CURVES, 1)
    ob.data.update_tag()
    return ob


def _drawn(ob):
    if ob.type == 'CURVE':
        return blender_objects.evaluated_vertices(ob)
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = mesh_points(evaluated.to_mesh())
    evaluated.to_mesh_clear()
    return points


def _few(points, most):
    return points[::max(1, len(points) // most)]


def _places_on(value):
    grid = [np.linspace(*domain, 15) for domain in np.reshape(value.domain, (-1, 2))]
    return (value.evaluate_grid(*grid) if len(grid) == 2 else value.evaluate(*grid)).reshape(-1, 3)


def _distances(value, points):
    """Of each point: to the nearest place on a grid where many are as near, as in the middle of a lid."""
    try:
        return np.linalg.norm(value.nearest(points).points - points, axis=1)
    except sc.InvalidShape as error:
        assert "cannot be told" in str(error)
        if len(points) > 1:
            return np.concatenate([_distances(value, point[None]) for point in points])
        return np.linalg.norm(_places_on(value) - points, axis=1).min(keepdims=True)
