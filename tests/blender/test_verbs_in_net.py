"""Verbs while the net of a shape is edited: what they do in Object Mode, and the net comes out again."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from curves import value_of
from layouts import drawn
from shapes import OF_CURVES, OF_PATCHES, activate, add, enter, first_point, leave, move, names_of, numbers_of, op, require_exact, select, shown
from support import part
from test_menus import Drawn

editing, live, menus, net_object = (part(name) for name in ('ui.editing', 'bridge.net.live', 'ui.menus', 'bridge.cage.net_object'))
CURVE, PATCH = names_of(OF_CURVES), names_of(OF_PATCHES)
CASES = [*((name, 'curve') for name in CURVE), *((name, 'patch') for name in PATCH)]
VALUES = {'curve': lambda: value_of('nurbs'), 'patch': lambda: patches.value_of('plain nurbs')}
#: Settings with which a verb changes the shapes above.
SETTINGS = {'make_periodic': {'tolerance': 100.0}, 'remove_knots': {'tolerance': 100.0}, 'reparameterize': {'end': 7.0},
            'insert_knot': {'where': 'SPANS'}}


def call(name):
    """What Blender says: its operator's result, or the refusal."""
    try:
        return op(getattr(bpy.ops.splinewright, name), **SETTINGS.get(name, {}))
    except RuntimeError as error:
        return str(error).partition(": ")[2]


def value(ob):
    return ob.data.splinewright.value


@pytest.mark.parametrize('name, kind', CASES)
def test_a_verb_does_with_its_net_out_what_it_does_without(name, kind):
    ob = add(VALUES[kind]())
    held = enter()
    select(held, first_point(held))
    move(0.1, 0.2, 0.3)
    moved = value(ob)
    leave()
    said = call(name)
    wanted = value(ob)
    ob.data.splinewright.value = moved
    held = enter()
    assert call(name) == said and value(bpy.data.objects["shape"]) == wanted
    held, ob = bpy.context.object, bpy.data.objects["shape"]
    assert held.mode == 'EDIT' and net_object.shape_of(held) == ob and live.problem(held) == ""
    select(held, first_point(held))
    move(0.0, 0.0, 0.5)
    assert value(ob) != wanted
    require_exact(ob)
    leave()
    assert len(editing.nets()) == 0


@pytest.mark.parametrize('name, kind', (('insert_knot', 'curve'), ('to_bezier', 'curve'), ('insert_knot', 'patch'), ('swap_uv', 'patch')))
def test_undo_takes_a_verb_back_and_the_net_with_it(name, kind):
    ob = add(VALUES[kind]())
    before = value(ob)
    held = enter()
    count = len(numbers_of(held).rows)
    select(held, first_point(held))
    move(0.0, 0.0, 0.5)
    moved = value(ob)
    assert call(name) == {'FINISHED'}
    done = value(bpy.data.objects["shape"])
    assert done != moved
    op(bpy.ops.ed.undo)
    assert value(bpy.data.objects["shape"]) == moved and len(numbers_of(bpy.context.object).rows) == count
    op(bpy.ops.ed.redo)
    assert value(bpy.data.objects["shape"]) == done
    for _ in range(3):
        op(bpy.ops.ed.undo)
    assert value(bpy.data.objects["shape"]) == before


def test_points_that_stay_where_they_are_stay_selected():
    add(value_of('nurbs'))
    held = enter()
    first, last = 0, len(numbers_of(held).rows) - 1
    select(held, first, last)
    assert op(bpy.ops.splinewright.insert_knot, where='SPANS') == {'FINISHED'}
    held = bpy.context.object
    count = len(numbers_of(held).rows)
    assert count > last + 1
    assert part('bridge.net.selection').selected(held, numbers_of(held)) == [0, count - 1]


def test_the_piece_of_the_selected_points_is_the_one_in_hand():
    ob = add([value_of('cubic'), value_of('nurbs')])
    held = enter()
    rows = numbers_of(held).definition.pieces[1].indices.ravel()
    select(held, *np.flatnonzero(np.isin(numbers_of(held).rows, rows))[:2])
    assert part('ui.active_shape').pieces_of_points(held) == [1]
    operator = SimpleNamespace(piece=0, properties=SimpleNamespace(is_property_set=lambda name: False))
    part('ui.active_shape').begin(operator, [ob], [held])
    assert operator.piece == 2


def test_nets_of_several_shapes_are_changed_together_and_those_of_others_are_not():
    first, second, third = (add(value_of('nurbs'), name) for name in ("first", "second", "third"))
    activate(first, second)
    enter()
    assert op(bpy.ops.splinewright.raise_degree, times=1) == {'FINISHED'}
    assert len(bpy.context.objects_in_mode) == 2
    leave()
    assert [value(bpy.data.objects[name]).degree for name in ("first", "second", "third")] == [4, 4, 3]


def test_a_net_that_holds_what_its_shape_does_not_take_is_not_put_away():
    ob = add(patches.value_of('plain nurbs'))
    before = shown(ob).copy()
    held = enter()
    select(held, first_point(held))
    op(bpy.ops.mesh.delete, type='VERT')
    bpy.context.view_layer.update()
    assert live.problem(held)
    with pytest.raises(RuntimeError, match="lost points"):
        op(bpy.ops.splinewright.raise_degree)
    assert bpy.context.object == held and held.mode == 'EDIT' and np.array_equal(shown(ob), before)


#: Of its two places the last one is that of nets.
HEADER = "VIEW3D_MT_editor_menus"


def test_the_menu_of_nets_is_on_top_of_the_context_menus():
    assert [menu for menu, _ in menus._FIRST] == [
        "VIEW3D_MT_edit_mesh_context_menu", "VIEW3D_MT_edit_curve_context_menu", "VIEW3D_MT_edit_mesh_delete",
        "VIEW3D_MT_edit_curve_delete"]


@pytest.mark.parametrize('kind', ('nurbs', 'plain nurbs'))
def test_the_menu_of_a_net_holds_what_works_there(kind):
    layout = Drawn()
    for draw in (*(draw for _, draw in menus._FIRST), dict(menus._AT_ENDS)[HEADER]):
        draw(SimpleNamespace(layout=layout), bpy.context)
    assert layout == []
    add(value_of(kind) if kind == 'nurbs' else patches.value_of(kind))
    enter()
    dict(menus._AT_ENDS)[HEADER](SimpleNamespace(layout=layout), bpy.context)
    names = [name for name in layout if name.islower() and "." not in name]
    assert set(CURVE if kind == 'nurbs' else PATCH) <= set(names) and 'extract_boundary' not in names and 'join_ends' not in names
    gray = {name for name in names if not getattr(bpy.ops.splinewright, name).poll()}
    assert gray == {'clear_point_keys', 'use_tool'}, "there are no keys, and in background no toolbar"
