"""What is made from objects and stops following them: why, by name, in the panel, the status bar and the views; until it is mended."""

import bpy
import numpy as np
import pytest

from layouts import sidebar
from shapes import activate, add, op
from support import part, splinecore as sc
from test_files import reopen, save

follow, hints, stopped, store = part('bridge.follow.follow'), part('ui.hints'), part('ui.stopped'), part('bridge.data.store')
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def loft(count=3):
    rings = []
    for i in range(count):
        rings.append(add(CIRCLE, f"Ring {i + 1}"))
        rings[-1].location.z = i
    activate(*rings)
    assert op(bpy.ops.splinewright.add_loft) == {'FINISHED'}
    return bpy.context.object, rings


def said():
    bpy.context.view_layer.update()
    return {ob.name: why for ob, why in stopped.sentence(bpy.context.view_layer)}


def panel(ob):
    activate(ob)
    return " ".join(sidebar(bpy.context).texts)


def delete(*objects):
    activate(*objects)
    assert op(bpy.ops.object.delete) == {'FINISHED'}


@pytest.mark.parametrize('how', ('operator', 'script'))
def test_a_deleted_input_is_named(how):
    ob, (first, second, third) = loft()
    assert not said()
    if how == 'operator':
        delete(second)
    else:
        bpy.data.objects.remove(second)
    assert list(said()) == [ob.name] and "'Ring 2' was deleted" in said()[ob.name]
    assert stopped.in_status(bpy.context.view_layer).startswith(f"{ob.name} stopped following: the ")
    assert "'Ring 2' was deleted" in panel(ob)


def test_more_than_one_and_more_than_one_shape():
    ob, (first, second, third) = loft()
    activate(first, third)
    assert op(bpy.ops.splinewright.add_loft) == {'FINISHED'}
    delete(second, third)
    assert "'Ring 2' and the curve 'Ring 3' were deleted" in said()[ob.name] and len(said()) == 2
    assert stopped.in_status(bpy.context.view_layer).endswith("(1 more stopped)")


def test_undo_leaving_out_and_an_end_to_it_mend_it():
    ob, (_, second, _) = loft()
    op(bpy.ops.ed.undo_push)
    delete(second)
    assert said()
    op(bpy.ops.ed.undo)
    assert not said() and "Ring 2" in bpy.context.scene.objects
    delete(bpy.context.scene.objects["Ring 2"])
    ob = next(ob for ob in bpy.context.scene.objects if ob.type == 'MESH')
    activate(ob)
    assert op(bpy.ops.splinewright.remove_input, index=1) == {'FINISHED'}
    assert not said()
    delete(bpy.context.scene.objects["Ring 3"])
    assert said()
    activate(ob)
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    assert not said()


def test_an_input_that_cannot_be_used_is_named_and_mended_by_what_it_was():
    ob, (_, second, _) = loft()
    op(bpy.ops.ed.undo_push)
    before = second.data
    second.data = add(sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)]), "open").data
    bpy.context.view_layer.update()
    assert "Ring 2" in said()[ob.name] and "closed" in said()[ob.name]
    second.data = before
    bpy.context.view_layer.update()
    assert not said()


def test_it_is_told_again_after_undo_of_something_else():
    ob, (_, second, _) = loft()
    second.data = add(sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)]), "open").data
    bpy.context.view_layer.update()
    assert said()
    op(bpy.ops.ed.undo_push)
    add(CIRCLE, "beside")
    op(bpy.ops.ed.undo_push)
    op(bpy.ops.ed.undo)
    assert list(said()) == [ob.name]


def test_two_curves_in_one_object_are_refused_by_name():
    ob, (_, second, _) = loft()
    apart = [CIRCLE, sc.conics.circle((5, 0, 0), 1.0)]
    second.data = add(apart, "two").data
    bpy.context.view_layer.update()
    assert "Ring 2" in said()[ob.name]


def test_a_file_tells_it_again_with_the_name(tmp_path):
    ob, (_, second, _) = loft()
    second.name = "Neck"
    second.location.x = 0.1
    bpy.context.view_layer.update()
    delete(second)
    before = store.read(ob.data).pool.copy()
    name = ob.name
    save(tmp_path / "stopped.blend")
    reopen(tmp_path / "stopped.blend")
    assert "'Neck'" in said()[name]
    assert np.array_equal(store.read(bpy.data.objects[name].data).pool, before)


def test_what_is_hidden_or_drawn_without_problem_says_nothing():
    ob, (_, second, _) = loft()
    for ring in bpy.context.scene.objects:
        if ring.type == 'CURVE':
            ring.hide_set(True)
    assert not said()
    delete_hidden = bpy.data.objects["Ring 2"]
    bpy.data.objects.remove(delete_hidden)
    ob.hide_set(True)
    assert not said()
    ob.hide_set(False)
    assert list(said()) == [ob.name]


def test_the_one_input_of_a_shape_is_named_whatever_is_wrong():
    profile = add(CIRCLE, "profile")
    activate(profile)
    assert op(bpy.ops.splinewright.add_extrude, caps='both') == {'FINISHED'}
    ob = bpy.context.object
    profile.data = add(sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)]), "open").data
    bpy.context.view_layer.update()
    assert said()[ob.name].startswith("profile: ")
