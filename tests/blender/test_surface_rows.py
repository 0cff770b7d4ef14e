"""Blender's own Surface > NURBS Curve and NURBS Circle: surface objects of rows of points, of which Blender draws curves."""

import bpy
import numpy as np
import pytest

from blender_objects import evaluated_vertices
from natives import drawn, exact, material, native
from geometry import mesh_points
from shapes import activate, require_exact
from support import part, splinecore as sc

ROWS = ('primitive_nurbs_surface_curve_add', 'primitive_nurbs_surface_circle_add')
#: Blender's rounding, of the size.
NEAR = 1e-5


def row(name=ROWS[0]):
    getattr(bpy.ops.surface, name)(location=(1, 2, 3))
    ob = bpy.context.object
    assert ob.type == 'SURFACE'
    return ob


@pytest.mark.parametrize('order', (2, 3, 4))
@pytest.mark.parametrize('flags', ((), ('use_endpoint_u',), ('use_cyclic_u',)))
@pytest.mark.parametrize('name', ROWS)
def test_a_row_of_points_becomes_the_curve_that_blender_draws(name, flags, order):
    ob = row(name)
    spline = ob.data.splines[0]
    for flag in ('use_endpoint_u', 'use_cyclic_u', 'use_bezier_u'):
        setattr(spline, flag, flag in flags)
    spline.order_u, spline.resolution_u = order, 9
    for i, point in enumerate(spline.points):
        point.co = (*point.co[:3], 1 + 0.3 * i)
    ob.data.update_tag()
    before, pointer = mesh_points(drawn(ob)), ob.as_pointer()
    exact(ob)
    value = ob.data.splinewright.value
    assert ob.type == 'CURVE' and ob.as_pointer() == pointer and isinstance(value, sc.NurbsCurve) and value.degree == order - 1
    assert np.abs(value.nearest(before).distances).max() < NEAR * np.abs(before).max()
    assert tuple(ob.location) == (1, 2, 3) and bpy.context.object == ob and len(bpy.data.curves) == 1
    require_exact(ob)
    native(ob)
    assert ob.type == 'CURVE' and np.abs(value.nearest(evaluated_vertices(ob)).distances).max() < NEAR * np.abs(before).max()


def test_all_that_share_it_and_materials_and_several_rows_stay():
    ob = row(ROWS[1])
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.surface.primitive_nurbs_surface_curve_add()
    bpy.ops.object.mode_set(mode='OBJECT')
    ob.data.materials.append(material("a"))
    ob.data.materials.append(material("b"))
    ob.data["note"] = 7
    for i, spline in enumerate(ob.data.splines):
        spline.material_index = 1 - i
    other = bpy.data.objects.new("other", ob.data)
    bpy.context.scene.collection.objects.link(other)
    ob.modifiers.new("Array", 'ARRAY')
    exact(ob)
    assert ob.type == other.type == 'CURVE' and ob.data == other.data and len(ob.data.splinewright.value) == 2
    assert [slot.material.name for slot in ob.material_slots] == ["a", "b"] and ob.data["note"] == 7
    assert [modifier.name for modifier in ob.modifiers] == ["Array"]
    assert [spline.material_index for spline in ob.data.splines] == [1, 0]


def test_rows_beside_patches_are_left_out_and_it_is_said(capfd):
    bpy.ops.surface.primitive_nurbs_surface_torus_add()
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.surface.primitive_nurbs_surface_curve_add()
    bpy.ops.object.mode_set(mode='OBJECT')
    ob = bpy.context.object
    exact(ob)
    assert ob.type == 'MESH' and "row of points" in capfd.readouterr().out


def test_keys_and_animation_are_lost_and_it_is_said(capfd):
    ob = row()
    ob.shape_key_add(name="Basis")
    ob.shape_key_add(name="Key").data[1].co.z = 3
    ob.data.shape_keys.key_blocks["Key"].value = 1
    bpy.context.view_layer.update()
    ob.data.keyframe_insert('extrude')
    exact(ob)
    said = capfd.readouterr().out
    assert "the shape keys" in said and "the animation of the surface data" in said
    assert ob.data.splinewright.value.points[1, 2] == 3, "as it is shown"


def test_one_of_too_few_points_is_refused_or_drawn_as_its_polygon():
    ob = row()
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.curve.select_all(action='DESELECT')
    for point in ob.data.splines[0].points[1:]:
        point.select = True
    bpy.ops.curve.delete(type='VERT')
    bpy.ops.object.mode_set(mode='OBJECT')
    activate(ob)
    with pytest.raises(RuntimeError, match="single point"):
        bpy.ops.splinewright.make_exact()
    assert not part('bridge.shape.shape').has_shape(ob)
