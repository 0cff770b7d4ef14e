"""Curves on patches become shapes of their own: exact, in the patch's place."""

import bpy
import numpy as np
import pytest

from curves import curves_of, run
from patches import patches_of, value_of
from shapes import activate, add, op, require_exact
from support import part, scene_state, splinecore as sc

KINDS = ('bezier patch', 'hermite patch', 'nurbs patch', 'rational nurbs', 'uniform', 'both periodic', 'torus')


def on_patch(patch, axis, at, t):
    points = patch.evaluate_grid([at], t)[0] if axis == 'u' else patch.evaluate_grid(t, [at])[:, 0]
    return points


@pytest.mark.parametrize('direction', ('U', 'V', 'BOTH'))
@pytest.mark.parametrize('kind', KINDS)
def test_an_isocurve_lies_on_the_patch_and_is_taken_back_by_undo(kind, direction):
    patch = value_of(kind)
    source = add(patch)
    assert run('extract_isocurve', direction=direction, parameter_u=0.3, parameter_v=0.2) == {'FINISHED'}
    ob = bpy.context.object
    assert ob.type == 'CURVE' and ob.name == "shape Isocurve" and bpy.context.selected_objects == [ob]
    assert source.data.splinewright.value == patch
    axes = {'U': 'u', 'V': 'v', 'BOTH': 'uv'}[direction]
    assert len(curves_of(ob)) == len(axes)
    for axis, curve in zip(axes, curves_of(ob)):
        t = np.linspace(*curve.domain, 41)[1:-1]
        expected = on_patch(patch, axis, {'u': 0.3, 'v': 0.2}[axis], t)
        assert np.abs(curve.evaluate(t) - expected).max() < 1e-13 * max(np.abs(patch.points).max(), 1)
        assert curve == patch.isocurve(axis, {'u': 0.3, 'v': 0.2}[axis])
    require_exact(ob)
    bpy.ops.ed.undo()
    assert [one.name for one in bpy.data.objects] == ["shape"] and not bpy.data.curves
    bpy.ops.ed.redo()
    require_exact(bpy.data.objects["shape Isocurve"])


SIDES = ('U_START', 'U_END', 'V_START', 'V_END')


@pytest.mark.parametrize('side', (*SIDES, 'ALL'))
@pytest.mark.parametrize('kind', ('bezier patch', 'hermite patch', 'rational nurbs', 'uniform'))
def test_a_boundary_is_the_side_of_the_patch(kind, side):
    patch = value_of(kind)
    add(patch)
    assert run('extract_boundary', side=side) == {'FINISHED'}
    ob = bpy.context.object
    sides = SIDES if side == 'ALL' else (side,)
    assert ob.name == "shape Boundary" and curves_of(ob) == [patch.boundary(name.lower()) for name in sides]
    for name, curve in zip(sides, curves_of(ob)):
        start, end = patch.domain['uv'.index(name[0].lower())]
        t = np.linspace(*curve.domain, 21)[1:-1]
        expected = on_patch(patch, name[0].lower(), start if name.endswith('START') else end, t)
        assert np.abs(curve.evaluate(t) - expected).max() < 1e-13 * np.abs(patch.points).max()
    require_exact(ob)
    bpy.ops.ed.undo()
    assert [one.name for one in bpy.data.objects] == ["shape"]


def test_a_side_that_is_a_point_or_none_is_left_out_with_a_word(capfd):
    add(value_of('sphere').clamped('u'))
    run('extract_boundary')
    assert len(curves_of(bpy.context.object)) == 2
    assert "left out: v start is a point, v end is a point" in "".join(capfd.readouterr())
    add(value_of('cylinder'), "cylinder")
    run('extract_boundary')
    assert len(curves_of(bpy.context.object)) == 2 and all(curve.periodic for curve in curves_of(bpy.context.object))
    assert "u start is no side, the patch is periodic" in "".join(capfd.readouterr())


def test_a_side_at_infinity_is_left_out_with_a_word():
    points = [[(0, 0, 0), (1, 0, 0)], [(0, 0, 1), (0, 1, 1)]]
    cone = sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2, points, [[1, 1], [0, 0]])
    curves, left_out = part('core.verbs.patch_curves').boundaries([cone], 0, ['u_start', 'u_end'])
    assert curves == [cone.boundary('u_start')] and left_out == ["u end lies at infinity"]


REFUSED = (
    ('extract_isocurve', {'parameter_u': 2.0}, 'bicubic', "u = 2 is outside the domain"),
    ('extract_isocurve', {'direction': 'V', 'parameter_v': -1.0}, 'bicubic', "v = -1 is outside the domain"),
    ('extract_isocurve', {'direction': 'V', 'parameter_v': 0.0}, 'sphere', "at v = 0 it is a point"),
    ('extract_isocurve', {'piece': 2}, 'bicubic', "1 piece, there is none of number 2"),
    ('extract_isocurve', {'parameter_u': 1.5}, 'mixed set', "piece 1: u = 1.5 is .*, piece 2: u = 1.5 is outside"),
    ('extract_isocurve', {'parameter_u': 0.5, 'piece': 1}, 'mixed set', "piece 1: u = 0.5 is outside"),
    ('extract_boundary', {'piece': 40}, 'teapot', "32 pieces, there is none of number 40"),
    ('extract_boundary', {'side': 'V_START'}, 'sphere', "v start is a point"),
    ('extract_boundary', {'side': 'U_END'}, 'sphere', "u end is no side, the patch is periodic"))


@pytest.mark.parametrize('name, settings, kind, word', REFUSED)
def test_what_is_no_curve_is_refused_with_a_word_and_nothing_is_added(name, settings, kind, word):
    ob = add(value_of(kind))
    before = scene_state()
    with pytest.raises(RuntimeError, match=f"shape: .*{word}"):
        run(name, **settings)
    assert scene_state() == before and bpy.context.selected_objects == [ob]


def test_one_piece_or_all_of_them():
    teapot = add(value_of('teapot'))
    patches = patches_of(teapot)
    run('extract_isocurve', parameter_u=0.5)
    assert curves_of(bpy.context.object) == [patch.isocurve('u', 0.5) for patch in patches]
    activate(teapot)
    run('extract_isocurve', piece=7, direction='V', parameter_v=0.25)
    assert bpy.context.object.data.splinewright.value == patches[6].isocurve('v', 0.25)
    activate(teapot)
    run('extract_boundary')
    assert len(curves_of(bpy.context.object)) == 32 * 4 - 8, "poles are left out"


def test_patches_on_which_the_parameter_does_not_lie_are_left_out_with_a_word(capfd):
    ob = add(value_of('mixed set'))
    run('extract_isocurve', parameter_u=0.5)
    assert bpy.context.object.data.splinewright.value == patches_of(ob)[1].isocurve('u', 0.5)
    assert "left out: piece 1: u = 0.5 is outside" in "".join(capfd.readouterr())


def test_a_number_in_single_precision_meets_the_knot_that_is_meant():
    patch = value_of('rational nurbs')
    add(patch)
    run('extract_isocurve', parameter_u=1 / 3)
    assert bpy.context.object.data.splinewright.value == patch.isocurve('u', 1 / 3)


def test_the_curve_lies_where_the_patch_lies_and_linked_duplicates_each_have_one():
    first = add(value_of('bicubic'))
    first.location, first.rotation_euler, first.scale = (1, 2, 3), (0.4, 0.5, 0.6), (1, 2, 0.5)
    twin = bpy.data.objects.new("twin", first.data)
    bpy.context.scene.collection.objects.link(twin)
    twin.location.x = 9
    bpy.context.view_layer.update()
    activate(first, twin)
    run('extract_boundary', side='V_END')
    bpy.context.view_layer.update()
    added = bpy.context.selected_objects
    assert {ob.name for ob in added} == {"shape Boundary", "twin Boundary"}
    assert bpy.context.object.name == "shape Boundary", "of the active one"
    for source, ob in ((first, bpy.data.objects["shape Boundary"]), (twin, bpy.data.objects["twin Boundary"])):
        assert np.allclose(ob.matrix_world, source.matrix_world, atol=1e-6)


def test_recipes_followers_and_shapes_changed_by_hand_give_curves_and_stay_as_they_are():
    op(bpy.ops.splinewright.add_torus)
    torus = bpy.context.object
    value = torus.data.splinewright.value
    run('extract_isocurve', direction='V', parameter_v=0.0)
    circle = bpy.context.object.data.splinewright.value
    assert circle == value.isocurve('v', 0.0) and circle.periodic
    assert part('bridge.recipes.recipes').has(torus.data) and torus.data.splinewright.value == value


def test_the_resolution_is_that_of_the_patch_along_the_curve():
    ob = add(value_of('bicubic'))
    ob.data.splinewright.set_resolution(3, 7)
    for direction, resolution in (('U', 7), ('V', 3), ('BOTH', 7)):
        activate(ob)
        run('extract_isocurve', direction=direction)
        assert bpy.context.object.data.splinewright.resolution_u == resolution


def test_a_curve_of_a_sheared_shape_lies_on_it():
    source = add(value_of('bicubic'))
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale, parent.rotation_euler = (1, 3, 1), (0.3, 0.4, 0.5)
    source.parent, source.rotation_euler, source.location = parent, (1, 0.2, 0.7), (1, 2, 3)
    bpy.context.view_layer.update()
    assert run('extract_boundary', side='U_START') == {'FINISHED'}
    ob = bpy.context.object
    bpy.context.view_layer.update()
    here, there = (np.array(one.matrix_world) for one in (ob, source))
    expected = patches_of(source)[0].points[0] @ there[:3, :3].T + there[:3, 3]
    assert np.allclose(curves_of(ob)[0].points @ here[:3, :3].T + here[:3, 3], expected, atol=1e-5)
