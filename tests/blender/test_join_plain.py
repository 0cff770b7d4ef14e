"""Ctrl+J where shapes are selected beside objects that are none: nothing ends without a word."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, op, require_exact, shown, world_points
from support import part

joining, recipes, shape, store = (part(name) for name in ('bridge.edit.joining', 'bridge.recipes.recipes', 'bridge.shape.shape', 'bridge.data.store'))


def cube(name="Cube"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [], [(0, 1, 2, 3)])
    return linked(bpy.data.objects.new(name, mesh))


def plain_curve(name="Curve"):
    curve = bpy.data.curves.new(name, 'CURVE')
    curve.dimensions = '3D'
    curve.splines.new('POLY').points.add(4)
    return linked(bpy.data.objects.new(name, curve))


def linked(ob):
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    return ob


PLAIN = {'nurbs patch': cube, 'teapot': cube, 'nurbs': plain_curve, 'many curves': plain_curve}


def begin(kind, active_is_shape):
    """(the shape, the plain object), both selected."""
    ob, other = add(VALUES[kind](), "shape"), PLAIN[kind]()
    ob.location.x = 3
    activate(*((ob, other) if active_is_shape else (other, ob)))
    bpy.ops.ed.undo_push(message="select")
    return ob, other


@pytest.mark.parametrize('active_is_shape', (False, True))
@pytest.mark.parametrize('kind', PLAIN)
def test_shapes_and_plain_objects_are_not_joined_unasked(kind, active_is_shape):
    ob, other = begin(kind, active_is_shape)
    value, before = ob.data.splinewright.value, shown(ob).copy()
    assert bpy.ops.splinewright.join.poll(), "Ctrl+J would go to Blender's own Join"
    with pytest.raises(RuntimeError, match="is no Splinewright shape.*the definition of shape ends.*Nothing was joined"):
        op(bpy.ops.splinewright.join)
    assert {ob.name, other.name} <= set(bpy.data.objects.keys())
    assert ob.data.splinewright.value == value and np.array_equal(shown(ob), before)


@pytest.mark.parametrize('active_is_shape', (False, True))
@pytest.mark.parametrize('kind', PLAIN)
def test_joined_all_the_same_they_are_one_plain_object_and_undo_brings_the_definitions_back(kind, active_is_shape):
    ob, other = begin(kind, active_is_shape)
    value, points = ob.data.splinewright.value, world_points(ob)
    count = len(shown(other)) if kind in ('nurbs', 'many curves') else len(other.data.vertices)
    assert op(bpy.ops.splinewright.join, end_definitions=True) == {'FINISHED'}
    assert len(bpy.data.objects) == 1
    joined = bpy.context.object
    assert not shape.has_shape(joined) and not any(store.has_definition(data) for data in (*bpy.data.meshes, *bpy.data.curves))
    found = world_points(joined)
    assert len(found) == len(points) + count
    assert all(np.abs(found - point).max(1).min() < 1e-4 for point in points[::7])
    bpy.ops.ed.undo()
    ob = bpy.data.objects["shape"]
    assert len(bpy.data.objects) == 2 and ob.data.splinewright.value == value
    require_exact(ob)


def test_two_shapes_and_a_cube_are_counted_and_named():
    add(VALUES['nurbs patch'](), "a"), add(VALUES['bezier patch'](), "b")
    activate(cube(), bpy.data.objects["a"], bpy.data.objects["b"])
    assert joining.ending_in_words(bpy.context.selected_objects) == (
        "Cube is no Splinewright shape. Joined with it, the definitions of a and b end: what they show stays, without a net")
    assert op(bpy.ops.splinewright.join, end_definitions=True) == {'FINISHED'}


def test_a_definition_that_others_show_goes_on():
    ob = add(VALUES['nurbs patch'](), "a")
    twin = linked(bpy.data.objects.new("twin", ob.data))
    value = ob.data.splinewright.value
    activate(cube(), ob)
    op(bpy.ops.splinewright.join, end_definitions=True)
    assert set(bpy.data.objects) == {twin, bpy.context.object} and twin.data.splinewright.value == value
    require_exact(twin)


def test_a_recipe_ends_with_its_definition():
    bpy.ops.splinewright.add_helix()
    helix = bpy.context.object
    activate(helix, plain_curve())
    op(bpy.ops.splinewright.join, end_definitions=True)
    assert not shape.has_shape(bpy.context.object) and not recipes.has(bpy.context.object.data)


def test_objects_of_other_types_stay_out_of_it_as_in_blender():
    first, second, other = add(VALUES['nurbs patch'](), "a"), add(VALUES['teapot'](), "b"), add(VALUES['nurbs'](), "c")
    empty = linked(bpy.data.objects.new("empty", None))
    activate(first, second, other, empty)
    assert op(bpy.ops.splinewright.join) == {'FINISHED'}
    assert set(bpy.data.objects) == {first, other, empty}
    require_exact(first), require_exact(other)


def test_the_key_passes_to_blender_where_its_join_meets_no_shape():
    ob = add(VALUES['nurbs'](), "a")
    activate(cube(), ob)
    assert not bpy.ops.splinewright.join.poll()
    activate(cube("b"), cube("c"), ob)
    assert not bpy.ops.splinewright.join.poll()
    bpy.ops.object.join()
    require_exact(ob)


def test_nothing_ends_where_blender_refuses_to_join(tmp_path):
    ob, other = begin('nurbs patch', False)
    path, value = str(tmp_path / "mesh.blend"), ob.data.splinewright.value
    bpy.data.libraries.write(path, {other.data})
    with bpy.data.libraries.load(path, link=True) as (theirs, ours):
        ours.meshes = theirs.meshes
    other.data = ours.meshes[0]
    with pytest.raises(RuntimeError):
        op(bpy.ops.splinewright.join, end_definitions=True)
    assert ob.data.splinewright.value == value and len(bpy.data.objects) == 2
    require_exact(ob)
