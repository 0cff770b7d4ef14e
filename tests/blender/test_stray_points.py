"""Gestures that leave points in a net that are not the shape's, or take some away: the points that were there count."""

import bmesh
import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, numbers_of, op, require_exact, select
from support import part

live, net_object, store, reading = (part(name) for name in (
    'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store', 'core.net.reading'))


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def pool():
    return store.read(bpy.data.objects["shape"].data).pool.copy()


def duplicated():
    op(bpy.ops.mesh.duplicate)


def extruded():
    op(bpy.ops.mesh.extrude_region)


def extruded_faces():
    bpy.ops.mesh.select_mode(type='FACE')
    op(bpy.ops.mesh.extrude_region)
    bpy.ops.mesh.select_mode(type='VERT')


def extruded_edges():
    bpy.ops.mesh.select_mode(type='EDGE')
    op(bpy.ops.mesh.extrude_edges_indiv)
    bpy.ops.mesh.select_mode(type='VERT')


def extruded_twice():
    extruded()
    extruded()


def extruded_and_moved():
    op(bpy.ops.mesh.extrude_region_move, TRANSFORM_OT_translate={'value': (0, 0, 3)})


def subdivided():
    op(bpy.ops.mesh.subdivide)


def cut():
    op(bpy.ops.mesh.subdivide, number_cuts=3)


def cube_added():
    op(bpy.ops.mesh.primitive_cube_add)


def spun():
    op(bpy.ops.mesh.spin, steps=3, dupli=True, angle=1.0, center=(3, 0, 0), axis=(0, 0, 1))


CAGE_GESTURES = (duplicated, extruded, extruded_faces, extruded_edges, extruded_twice, extruded_and_moved, subdivided, cut,
                 cube_added, spun)
CAGES = ('nurbs patch', 'bezier patch', 'hermite patch', 'patch with a point at infinity', 'teapot')


def name_of(gesture):
    return gesture.__name__


def require_followed(held, before):
    """Every point moves the shape, and nothing keeps the shape from it. before: the pool."""
    numbers = numbers_of(held)
    present = net_object.present(held, numbers)
    told = np.ones(len(numbers.rows), bool) if present.void is None else ~present.void[reading.slots(numbers, present)]
    chosen = np.flatnonzero(numbers.are_points & told)
    for vertex in chosen[:: max(1, len(chosen) // 6)].tolist():
        deselect()
        select(held, vertex)
        move(0, 0, 0.5)
        after = pool()
        row = numbers.rows[vertex]
        assert np.isclose(after[row, 2], before[row, 2] + 0.5, atol=1e-6), f"vertex {vertex}"
        if numbers.are_points.all():
            assert np.array_equal(np.delete(after, row, 0), np.delete(before, row, 0)), f"vertex {vertex}"
        before = after
    assert live.problem(held) == ""
    require_exact(bpy.data.objects["shape"])


def deselect():
    (bpy.ops.mesh if bpy.context.mode == 'EDIT_MESH' else bpy.ops.curve).select_all(action='DESELECT')


@pytest.mark.parametrize('gesture,name', [(gesture, name) for gesture in CAGE_GESTURES for name in CAGES
                                          if gesture != extruded_faces or 'infinity' not in name],      # no faces there
                         ids=lambda one: one if isinstance(one, str) else one.__name__)
def test_what_a_gesture_adds_to_a_cage_is_passed_over_and_every_point_goes_on(gesture, name):
    add(VALUES[name]())
    before = value()
    held = enter()
    select(held, 0, 1, *np.ravel(numbers_of(held).faces[:1]).astype(int).tolist())
    gesture()
    bpy.context.view_layer.update()
    assert live.problem(held) == "" and value() == before
    assert "not of this net" in live.note(held) and len(held.data.vertices) > len(numbers_of(held).rows)
    require_followed(held, pool())
    after = value()
    leave()
    assert value() == after and [ob.name for ob in bpy.data.objects] == ["shape"]


@pytest.mark.parametrize('gesture', CAGE_GESTURES, ids=name_of)
def test_a_point_that_moved_before_stays_where_it_was_moved(gesture):
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, *numbers_of(held).faces[5])
    move(0, 0, 1)
    before = value()
    gesture()
    bpy.context.view_layer.update()
    assert live.problem(held) == "" and value() == before
    require_followed(held, pool())


def extruded_at_the_end():
    op(bpy.ops.curve.extrude, mode='INIT')


def duplicated_points():
    op(bpy.ops.curve.duplicate)


def duplicated_curves():
    bpy.ops.curve.select_all(action='SELECT')
    op(bpy.ops.curve.duplicate)


def curve_added():
    op(bpy.ops.curve.primitive_bezier_circle_add)
    op(bpy.ops.curve.primitive_nurbs_path_add)


def turned_and_extruded():
    bpy.ops.curve.select_all(action='SELECT')
    op(bpy.ops.curve.switch_direction)
    deselect()
    select(bpy.context.object, *ends(bpy.context.object)[:1])
    extruded_at_the_end()


CURVE_GESTURES = (extruded_at_the_end, duplicated_points, duplicated_curves, curve_added, turned_and_extruded)
CURVES = ('nurbs', 'quintic', 'hermite', 'closed hermite', 'cubic', 'periodic', 'semicircle', 'many curves')


def ends(held):
    """The last and the first point of the first spline of a net, with handles."""
    numbers = numbers_of(held)
    part_of, step = numbers.splines[0], 3 if numbers.splines[0].kind == 'BEZIER' else 1
    last = step * (part_of.count - 1)
    return [*range(last, last + step)], [*range(step)]


@pytest.mark.parametrize('name', CURVES)
@pytest.mark.parametrize('gesture', CURVE_GESTURES, ids=name_of)
@pytest.mark.parametrize('end', (0, 1), ids=('last', 'first'))
def test_what_a_gesture_adds_to_curves_is_passed_over_and_every_point_goes_on(gesture, name, end):
    add(VALUES[name]())
    before = value()
    held = enter()
    count = point_count(held)
    select(held, *ends(held)[end])
    gesture()
    held.data.update_tag()              # Blender tells of some when something moves next
    bpy.context.view_layer.update()
    part('ui.editing').hand_over_now()  # a timer does in a window
    assert live.problem(held) == "" and value() == before
    assert (point_count(held) > count) == ("not of this net" in live.note(held))
    require_followed(held, pool())
    leave()


def point_count(held):
    return sum(len(spline.bezier_points) + len(spline.points) for spline in held.data.splines)


def places():
    """(n, 3): where the points of the shape's net are, as the shape is now."""
    return net_object.net_of(store.read(bpy.data.objects["shape"].data)).positions


@pytest.mark.parametrize('name', ('nurbs patch', 'hermite patch', 'teapot'))
def test_points_that_were_deleted_stay_where_they_were_and_the_others_go_on(name):
    add(VALUES[name]())
    held = enter()
    numbers = numbers_of(held)
    gone = [0, 3]
    select(held, *gone)
    move(0, 0, 1)
    before = value()
    op(bpy.ops.mesh.delete, type='VERT')
    bpy.context.view_layer.update()
    assert f"lost points ({len(gone)} of {len(numbers.rows)})" in live.problem(held) and value() == before
    left = next(vertex for vertex in np.flatnonzero(numbers.are_points) if vertex not in gone)
    select(held, left)
    was = places()
    move(0, 0, 0.5)
    assert np.isclose(places()[left, 2], was[left, 2] + 0.5, atol=1e-6)
    assert np.allclose(places()[gone], was[gone], atol=1e-14) and "lost points" in live.problem(held)
    for _ in range(3):
        bpy.ops.ed.undo()
    assert live.problem(bpy.context.object) == "" and value() == before
    leave()
    require_exact(bpy.data.objects["shape"])


def test_deleted_points_come_back_where_they_were_when_the_net_is_renewed():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 3)
    move(0, 0, 1)
    op(bpy.ops.mesh.duplicate)
    op(bpy.ops.mesh.delete, type='VERT')
    select(held, 3, 4)
    op(bpy.ops.mesh.delete, type='VERT')
    bpy.context.view_layer.update()
    before = value()
    assert "lost points" in live.problem(held)
    select(held, 7)
    assert bpy.ops.splinewright.renew_net('EXEC_DEFAULT', True) == {'FINISHED'}
    held = bpy.context.object
    assert live.problem(held) == live.note(held) == "" and held.mode == 'EDIT' and value() == before
    assert len(held.data.vertices) == len(numbers_of(held).rows)
    assert part('ui.net_props').chosen(held.data)[1] == [7]
    require_followed(held, pool())
    bpy.ops.ed.undo()


def weight_of(held, vertex, weight):
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[vertex][mesh.verts.layers.float['weight']] = weight
    bmesh.update_edit_mesh(held.data)
    bpy.context.view_layer.update()


@pytest.mark.parametrize('weight', (0.0, float('nan'), float('inf')))
def test_a_weight_that_cannot_be_taken_keeps_no_other_point_back(weight):
    add(VALUES['nurbs patch']())
    held = enter()
    before = pool()
    weight_of(held, 3, weight)
    assert live.problem(held) != "" and np.array_equal(pool(), before)
    select(held, 5)
    move(0, 0, 1)
    assert np.flatnonzero((pool() != before).any(1)).tolist() == [5]
    weight_of(held, 3, 2.0)
    assert live.problem(held) == "" and pool()[3, 3] == 2.0


@pytest.mark.parametrize('gesture', (extruded, lambda: op(bpy.ops.mesh.duplicate_move)), ids=('extruded', 'duplicated'))
def test_copies_that_stay_in_place_give_the_selection_back_and_the_point_is_moved(gesture):
    add(VALUES['nurbs patch']())
    held = enter()
    before = pool()
    select(held, 8)
    gesture()
    bpy.context.view_layer.update()
    assert part('ui.net_props').chosen(held.data)[1] == []
    part('ui.editing').select_originals()
    bpy.context.view_layer.update()
    assert part('ui.net_props').chosen(held.data)[1] == [8]
    move(0, 0, 1)
    assert np.flatnonzero((pool() != before).any(1)).tolist() == [8] and live.problem(held) == ""
    bpy.ops.ed.undo()
    part('ui.editing').hand_over_now()
    assert np.array_equal(pool(), before) and part('ui.net_props').chosen(bpy.context.object.data)[1] == [8]


def test_copies_of_a_curves_points_give_the_selection_back_too():
    for name in ('nurbs', 'hermite'):
        add(VALUES[name](), name)
        held = enter()
        select(held, *ends(held)[0])
        extruded_at_the_end()
        bpy.context.view_layer.update()
        part('ui.editing').select_originals()
        assert part('ui.net_props').chosen(held.data)[1] == [v for v in ends(held)[0] if numbers_of(held).rows[v] >= 0]
        before = store.read(bpy.data.objects[name].data).pool.copy()
        move(0, 0, 1)
        assert (store.read(bpy.data.objects[name].data).pool != before).any()
        leave()


def test_copies_that_were_moved_keep_the_selection():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, 8)
    extruded_and_moved()
    part('ui.editing').select_originals()
    assert part('ui.net_props').chosen(held.data)[1] == []


def test_points_are_found_again_after_a_hundred_gestures_by_lot():
    """Whatever was extruded, cut or copied: a point that was never deleted moves the shape, and only its own row."""
    random = np.random.default_rng(5)
    add(VALUES['nurbs patch']())
    held = enter()
    gestures = [gesture for gesture in CAGE_GESTURES if gesture not in (extruded_faces, cut)]
    for _ in range(100):
        if len(held.data.vertices) > 3000:
            bpy.ops.splinewright.renew_net('EXEC_DEFAULT', True)
            held = bpy.context.object
        count = len(numbers_of(held).rows)
        select(held, *random.choice(count, 2, replace=False).tolist())
        before = value()
        gestures[random.integers(len(gestures))]()
        bpy.context.view_layer.update()
        held.update_from_editmode()
        assert live.problem(held) == "" and value() == before
        vertex = int(random.integers(count))
        deselect()
        select(held, vertex)
        was = pool()
        move(*random.uniform(-1, 1, 3))
        assert np.flatnonzero((pool() != was).any(1)).tolist() == [numbers_of(held).rows[vertex]]
    leave()
    require_exact(bpy.data.objects["shape"])
