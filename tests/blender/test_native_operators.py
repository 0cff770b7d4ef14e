"""Convert to Splinewright and To Blender's Own as operators: undo, what is refused, what is left alone."""

import bpy
import numpy as np
import pytest

from natives import exact, native, native_curve, native_surface, select
from support import part, scene_state, splinecore as sc

make_exact = part('bridge.native.make_exact')
read_native = part('bridge.native.read_native')


@pytest.mark.parametrize('make', (native_curve, native_surface), ids=('curve', 'surface'))
def test_undo_and_redo_take_both_ways_exactly(make):
    ob = make()
    name, kind, value = ob.name, ob.type, read_native.read(ob).value
    ob.modifiers.new("Array", 'ARRAY')
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.splinewright.make_exact('EXEC_DEFAULT', True)
    shape_type = bpy.data.objects[name].type
    bpy.ops.splinewright.to_native('EXEC_DEFAULT', True)

    def state():
        ob = bpy.data.objects[name]
        assert ob.modifiers[0].name == "Array" and ob == bpy.context.object and len(bpy.data.objects) == 1
        return ob.type, getattr(ob.data, 'splinewright').value

    assert state() == (kind, None)
    bpy.ops.ed.undo()
    assert state() == (shape_type, value)
    bpy.ops.ed.undo()
    assert state() == (kind, None) and read_native.read(bpy.data.objects[name]).value == value
    bpy.ops.ed.redo()
    assert state() == (shape_type, value)
    bpy.ops.ed.redo()
    assert state() == (kind, None)


def test_nothing_is_done_without_something_that_fits():
    select()
    assert not bpy.ops.splinewright.make_exact.poll() and not bpy.ops.splinewright.to_native.poll()
    with pytest.raises(RuntimeError, match="Select a curve or surface"):
        bpy.ops.splinewright.make_exact()
    bpy.ops.splinewright.add_bezier_curve()
    assert not bpy.ops.splinewright.make_exact.poll(), "it is exact already"
    native_curve()
    assert not bpy.ops.splinewright.to_native.poll()
    bpy.ops.object.mode_set(mode='EDIT')
    with pytest.raises(RuntimeError, match="Leave the present mode"):
        bpy.ops.splinewright.make_exact()


def broken():
    """A curve of one point, and a surface of none."""
    data = bpy.data.curves.new("point", 'CURVE')
    data.splines.new('POLY')
    objects = [bpy.data.objects.new("point", data),
               bpy.data.objects.new("nothing", bpy.data.curves.new("nothing", 'SURFACE'))]
    for ob in objects:
        bpy.context.collection.objects.link(ob)
    return objects


def test_objects_that_show_nothing_are_named_and_left_alone():
    objects = broken()
    select(*objects)
    before = scene_state()
    with pytest.raises(RuntimeError, match="point: nothing to make exact; spline 1, which is a single point"):
        bpy.ops.splinewright.make_exact()
    assert scene_state() == before and len(objects[0].data.splines) == 1 and objects[1].type == 'SURFACE'


def test_a_curve_and_a_mesh_of_one_name_are_both_done():
    bpy.ops.splinewright.add_bezier_curve()
    curve = bpy.context.object
    bpy.ops.splinewright.add_bezier_patch()
    patch = bpy.context.object
    patch.data.name = curve.data.name
    assert patch.data.name == curve.data.name
    native(curve, patch)
    assert patch.type == 'SURFACE' and curve.data.splinewright.value is None


def test_the_others_are_done_where_one_cannot_be():
    bad, _ = broken()
    good = native_curve()
    exact(bad, good)
    assert good.data.splinewright.value is not None and bad.data.splinewright.value is None


def test_a_shape_that_blender_cannot_hold_is_left_alone():
    for value in (sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, -2, 1]),
                  sc.BezierPatch(np.random.default_rng(1).uniform(size=(2, 65, 3)))):
        data = part('bridge.shape.shape').new_data("shape", value, (4, 4))
        ob = bpy.data.objects.new("shape", data)
        bpy.context.collection.objects.link(ob)
        select(ob)
        before = scene_state()
        with pytest.raises(RuntimeError, match="infinity|degree is 64"):
            bpy.ops.splinewright.to_native()
        assert scene_state() == before and ob.data.splinewright.value == value


def test_a_shape_changed_by_hand_is_left_alone():
    bpy.ops.splinewright.add_bezier_patch()
    ob = bpy.context.object
    ob.data.vertices[0].co.z += 1
    with pytest.raises(RuntimeError, match="changed by hand"):
        bpy.ops.splinewright.to_native()
    assert ob.type == 'MESH'


@pytest.mark.parametrize('make', (native_curve, native_surface), ids=('curve', 'surface'))
def test_linked_data_is_refused(make, tmp_path):
    ob = make()
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {ob})
    name = ob.name
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = [name]
    linked = wanted.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    select(linked)
    with pytest.raises(RuntimeError, match="linked from another file"):
        bpy.ops.splinewright.make_exact()
    assert linked.type in ('CURVE', 'SURFACE')


def test_too_dense_a_surface_is_refused_and_the_scene_is_unchanged():
    ob = native_surface()
    bpy.context.collection.objects.unlink(ob)           # or Blender would evaluate 67 million vertices, too
    ob.data.splines[0].resolution_u = ob.data.splines[0].resolution_v = 1024
    before = scene_state()
    with pytest.raises(ValueError, match="lower the resolution"):
        make_exact.make_exact(bpy.context, ob)
    assert scene_state() == before and ob.type == 'SURFACE'


def test_where_one_of_several_users_cannot_be_changed_none_is(monkeypatch):
    ob = native_surface()
    twin = bpy.data.objects.new("twin", ob.data)
    ob.modifiers.new("Array", 'ARRAY')
    retype, data = part('bridge.native.retype'), ob.data
    become = retype.become_mesh

    def fail_on_the_second(context, user, mesh):
        if mesh.users:
            raise RuntimeError("Blender did not convert it")
        return become(context, user, mesh)

    monkeypatch.setattr(retype, 'become_mesh', fail_on_the_second)
    before = scene_state()
    with pytest.raises(RuntimeError, match="did not convert"):
        make_exact.make_exact(bpy.context, ob)
    assert scene_state() == before and ob.data == twin.data == data
    assert ob.type == 'SURFACE' and ob.modifiers[0].name == "Array"


def test_both_ways_work_in_local_view_also_for_what_is_outside_it():
    ob = native_surface()
    ob.modifiers.new("Array", 'ARRAY')
    twin = bpy.data.objects.new("twin", ob.data)
    twin.modifiers.new("Solidify", 'SOLIDIFY')
    window = bpy.context.window
    area = next(area for area in window.screen.areas if area.type == 'VIEW_3D')
    region = next(region for region in area.regions if region.type == 'WINDOW')
    select(ob)
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.localview()
        bpy.context.scene.collection.objects.link(twin)
        bpy.context.view_layer.update()
        space = area.spaces.active
        assert space.local_view
        twin.local_view_set(space, False)
        bpy.context.view_layer.update()
        if bpy.app.version < (5, 0, 0):         # later it is in every local view
            assert not twin.local_view_get(space)
        assert bpy.ops.splinewright.make_exact() == {'FINISHED'}
        assert (ob.type, twin.type) == ('MESH', 'MESH')
        assert bpy.ops.splinewright.to_native() == {'FINISHED'}
        assert (ob.type, twin.type) == ('SURFACE', 'SURFACE')
    assert [ob.modifiers[0].name, twin.modifiers[0].name] == ["Array", "Solidify"]


def test_selection_and_active_object_are_as_before():
    ob, other = native_surface(), native_curve()
    select(ob, other)
    exact(ob, other)
    assert set(bpy.context.selected_objects) == {ob, other} and bpy.context.object == other
    bpy.context.view_layer.objects.active = None
    ob.select_set(True)
    assert bpy.ops.splinewright.to_native() == {'FINISHED'}
    assert set(bpy.context.selected_objects) == {ob, other} and bpy.context.view_layer.objects.active is None
