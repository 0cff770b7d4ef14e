"""Join Patches: which sides meet, what moves, what was achieved, and what is refused."""

import bpy
import numpy as np
import pytest

from patches import patches_of
from shapes import VALUES, activate, add, op, require_exact
from support import part, splinecore as sc

joints, recipes = part('core.joints.patch_joints'), part('bridge.recipes.recipes')
CLASS = {'C0': (0, 0), 'G1': (0, 1), 'C1': (1, 1), 'G2': (0, 2), 'C2': (2, 2)}


def net(start, seed=3, size=4):
    """A wavy sheet over [start, start + size - 1] x [0, size - 1]."""
    random = np.random.default_rng(seed + start)
    return np.array([[(start + i, j, random.uniform(-0.4, 0.4)) for j in range(size)] for i in range(size)])


def sheets():
    return sc.PatchSet.from_patches([sc.BezierPatch(net(0)), sc.BezierPatch(net(4))])


def seam(ob):
    value = ob.data.splinewright.value
    (first, second), = value.seams()
    return sc.seam_continuity(value[first[0]], first[1], value[second[0]], second[1])


@pytest.mark.parametrize('continuity', CLASS)
@pytest.mark.parametrize('moves', ('second', 'first', 'both'))
def test_two_patches_of_a_shape_are_joined_and_stay_so_in_its_mesh(continuity, moves):
    ob = add(sheets())
    before = patches_of(ob)
    assert op(bpy.ops.splinewright.join_patches, continuity=continuity, moves=moves) == {'FINISHED'}
    value, measured = ob.data.splinewright.value, seam(ob)
    assert value.seams() == [((0, 'u_end'), (1, 'u_start'))]
    assert measured.gap <= 1e-12 and measured.c >= CLASS[continuity][0] and measured.g >= CLASS[continuity][1]
    for number, name in enumerate(('first', 'second')):
        moved = before[number].to_nurbs().largest_distance(value[number].to_nurbs())
        assert (moved > 1e-3) == (moves in (name, 'both'))
    require_exact(ob)
    bpy.ops.ed.undo()
    assert patches_of(bpy.data.objects["shape"]) == before


def test_the_edge_is_one_row_of_points_in_the_net():
    ob = add(sheets())
    op(bpy.ops.splinewright.join_patches, continuity='C1')
    value = ob.data.splinewright.value
    shared = set(value.patches[0]['indices'].ravel()) & set(value.patches[1]['indices'].ravel())
    assert len(shared) == value[0].points.shape[1]


def test_the_sides_that_are_asked_for_meet():
    ob = add(sheets())
    op(bpy.ops.splinewright.join_patches, first=2, first_side='v_end', second=1, second_side='v_end', continuity='C0')
    assert ob.data.splinewright.value.seams() == [((0, 'v_end'), (1, 'v_end'))]


def test_a_patch_of_another_shape_comes_along_from_where_it_stands():
    ob, other = add(sc.BezierPatch(net(0)), "one"), add(sc.BezierPatch(net(0, seed=9)), "other")
    other.location, other.rotation_euler = (4, 0, 0.5), (0, 0, 0.1)
    red = bpy.data.materials.new("red")
    other.data.materials.append(red)
    bpy.context.view_layer.update()
    activate(ob, other)
    kept = ob.data.splinewright.value
    assert op(bpy.ops.splinewright.join_patches) == {'FINISHED'}
    assert [ob.name for ob in bpy.data.objects] == ["one"] and red in list(ob.data.materials)
    assert seam(ob).g >= 1 and seam(ob).gap <= 1e-12
    first = ob.data.splinewright.value[0]
    assert first.to_nurbs().largest_distance(kept.to_nurbs()) <= 1e-12, "the active one stays"


def test_patches_of_other_kinds_degrees_and_knots_are_joined():
    hermite = sc.HermitePatch(*[VALUES['hermite patch']().points[:3, :2] * 0 + part for part in (
        net(0, size=3)[:, :2], [1.0, 0, 0], [0, 1.0, 0])])
    round_ = sc.build.cylinder((4, 0.5, 0), (0, 1, 0), 0.5, 1.0, 0.0, 2.0)
    ob = add(sc.PatchSet.from_patches([hermite, round_]))
    assert op(bpy.ops.splinewright.join_patches, continuity='G1') == {'FINISHED'}
    assert seam(ob).g >= 1
    require_exact(ob)


def test_what_was_achieved_is_said(capfd):
    add(sheets())
    op(bpy.ops.splinewright.join_patches, continuity='C1')
    said = capfd.readouterr().out
    assert "u end of patch 1 and u start of patch 2 are C1 G1, angle 0°" in said
    assert "patch 2 moved by" in said and "patch 1 moved" not in said


def test_two_shapes_that_are_joined_are_called_by_their_names(capfd):
    wing, body = add(sc.BezierPatch(net(0)), "wing"), add(sc.PatchSet.from_patches([sc.BezierPatch(net(8)), sc.BezierPatch(net(4))]), "body")
    activate(body, wing)
    op(bpy.ops.splinewright.join_patches, continuity='G1')
    said = capfd.readouterr().out
    assert "u start of patch 2 of body and u end of wing are" in said and "wing moved by" in said
    activate(body, add(sc.BezierPatch(net(0)), "other"))
    with pytest.raises(RuntimeError, match="other: there is 1 patch, none of number 7"):
        op(bpy.ops.splinewright.join_patches, second=7)


def test_the_report_and_the_panel_say_the_same_continuity(capfd):
    """Where derivatives nearly agree, the limit decides."""
    first, second = np.array(net(0)), np.array(net(3))
    second[0] = first[-1]
    second[1] = first[-1] + (first[-1] - first[-2]) * (1 + 3e-6)
    ob = add(sc.PatchSet.from_patches([sc.BezierPatch(first), sc.BezierPatch(second)]))
    op(bpy.ops.splinewright.join_patches, continuity='C0')
    shown, = (part('ui.continuity_panel').kind(joint) for joint in part('bridge.analysis.surveys').survey_of(ob.data).joints)
    assert f"are {shown}, angle" in capfd.readouterr().out and shown == "C1 G1"


def three(rows):
    """Two patches side by side, the second one with so many rows, and one along that."""
    first, after = sc.BezierPatch(net(0)), np.array(net(3))
    after[0] = first.points[-1]
    second = sc.BezierPatch(after[np.linspace(0, 3, rows).astype(int)])
    beside = sc.BezierPatch(np.stack([second.points[:, -1], second.points[:, -1] + (0, 1, 0)], 1))
    return sc.PatchSet.from_patches([first, second, beside])


def test_other_patches_go_along_with_what_is_joined(capfd):
    ob = add(three(4))
    op(bpy.ops.splinewright.join_patches, first=1, second=2, continuity='G1')
    found = ob.data.splinewright.value
    assert "open now" not in capfd.readouterr().out and len(found.seams()) == 2
    (first, side), (second, other) = next(pair for pair in found.seams() if pair[1][0] == 2)
    assert sc.seam_continuity(found[first], side, found[second], other).gap == 0.0


def test_seams_with_others_that_come_apart_are_named(capfd):
    add(three(2))
    op(bpy.ops.splinewright.join_patches, first=1, second=2, continuity='G2')
    assert "open now between patch 2 and patch 3" in capfd.readouterr().out


@pytest.mark.parametrize('value, settings, reason', (
    (lambda: sc.BezierPatch(net(0)), {}, "has one patch"),
    (sheets, {'first': 3}, "none of number 3"),
    (sheets, {'first': 1, 'second': 1}, "not joined to itself"),
    (lambda: sc.PatchSet.from_patches([sc.build.sphere((0, 0, 0), 1.0), sc.BezierPatch(net(3))]), {'first': 1}, "point|no side"),
))
def test_what_cannot_be_joined_is_refused_and_nothing_changes(value, settings, reason):
    ob = add(value())
    before = ob.data.splinewright.value
    with pytest.raises(RuntimeError, match=reason):
        op(bpy.ops.splinewright.join_patches, **settings)
    assert ob.data.splinewright.value == before


def test_recipes_and_curves_are_refused():
    op(bpy.ops.splinewright.add_plane)
    plane = bpy.context.object
    other = add(sc.BezierPatch(net(2)), "other")
    activate(plane, other)
    with pytest.raises(RuntimeError, match="made by a recipe"):
        op(bpy.ops.splinewright.join_patches)
    assert recipes.has(plane.data) and "other" in bpy.data.objects
    add(VALUES['nurbs']())
    assert not bpy.ops.splinewright.join_patches.poll()


def test_three_shapes_are_too_many():
    activate(*(add(sc.BezierPatch(net(3 * i)), str(i)) for i in range(3)))
    assert not bpy.ops.splinewright.join_patches.poll()


def test_shape_keys_of_either_are_not_lost():
    first, second = add(sc.BezierPatch(net(0)), "first"), add(sc.BezierPatch(net(4)), "second")
    second.shape_key_add(name="Basis")
    activate(first, second)
    for operator in (bpy.ops.splinewright.join_patches, bpy.ops.splinewright.join):
        with pytest.raises(RuntimeError, match="second has shape keys"):
            op(operator)
    assert second.data.shape_keys and len(patches_of(first)) == 1
