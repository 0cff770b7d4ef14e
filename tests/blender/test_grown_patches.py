"""Rows more and less in the net of patches, by Blender's own gestures: the shape follows, through undo, leaving and saving."""

import bpy
import numpy as np
import pytest

from cages import choose, cut, delete, dissolve, extrude, held, mesh, value, vertices
from patches import value_of
from shapes import activate, add, enter, leave, move, numbers_of, op, require_exact
from support import part, splinecore as sc
from test_files import reopen, save

editing, live, net_object, store = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store'))
#: Kinds, and along which axes they have borders.
OPEN = [('plain nurbs', 0), ('plain nurbs', 1), ('rational nurbs', 0), ('rational nurbs', 1), ('nurbs patch', 0),
        ('bezier patch', 0), ('bezier patch', 1), ('uniform', 0), ('uniform', 1), ('bilinear', 0), ('cylinder', 1)]
AROUND = [('nurbs patch', 1), ('both periodic', 0), ('both periodic', 1), ('cylinder', 0)]


def started(kind):
    """The value of a shape whose net is in Edit Mode."""
    before = value_of(kind)
    add(before)
    enter()
    return before


def followed():
    """The value, after Blender told of what was done; the net is as many points, where they are, and as many faces as the
    shape's own."""
    bpy.context.view_layer.update()
    assert live.problem(held()) == ""
    own = net_object.net_of(store.read(bpy.data.objects["shape"].data))
    there = net_object.present(held(), numbers_of(held()))
    assert np.array_equal(np.sort(there.numbers), np.arange(len(own.rows)))
    order = np.argsort(there.numbers)
    size = np.abs(own.positions).max()
    assert np.allclose(there.positions()[order], own.positions, atol=1e-6 * size)
    assert np.allclose(there.weights()[order], own.weights, rtol=1e-6)
    held().update_from_editmode()
    number_of = {int(slot): number for number, slot in enumerate(order)}
    faces = {frozenset(number_of[vertex] for vertex in face.vertices) for face in held().data.polygons}
    assert faces == set(map(frozenset, own.faces))
    require_exact(bpy.data.objects["shape"])
    return value()


def told():
    """How far the shape is said to lie from what it was."""
    note = live.note(held())
    return float(note.split("within ")[1].split()[0]) if note else 0.0


def nurbs(patch):
    return patch.to_nurbs()


def rows_of(points, axis, places):
    return np.take(points, places, axis)


@pytest.mark.parametrize('kind,axis', OPEN)
@pytest.mark.parametrize('end', (-1, 0), ids=('last', 'first'))
def test_e_on_a_border_appends_a_row_and_the_others_stay(kind, axis, end):
    before = nurbs(started(kind))
    count = before.points.shape[axis]
    for times in (1, 2, 3):
        extrude((0, axis, end), by=(0.5, 0, 0.25))
        after = followed()
        kept = range(count) if end else range(times, times + count)
        assert np.array_equal(rows_of(after.points, axis, kept), before.points)
        assert np.array_equal(rows_of(after.weights, axis, kept), before.weights)
        assert np.allclose(rows_of(after.points, axis, end), rows_of(before.points, axis, end) + times * np.array([0.5, 0, 0.25]),
                           atol=1e-5)
        assert after.degree == before.degree and after.points.shape[axis] == count + times
        assert live.note(held()) == "" and len(live.session(held().data).stages) == times + 1
    move(0, 0, 1)
    assert np.isclose(rows_of(followed().points, axis, end)[:, 2], rows_of(after.points, axis, end)[:, 2] + 1, atol=1e-5).all()
    after = value()
    leave()
    assert value() == after
    enter()
    assert followed() == after
    leave()


@pytest.mark.parametrize('kind,axis', OPEN + AROUND)
@pytest.mark.parametrize('cuts', (1, 3))
def test_a_loop_cut_inserts_knots_and_the_shape_stays(kind, axis, cuts):
    before = nurbs(started(kind))
    count = before.points.shape[axis]
    for place in range(count if before.periodic[axis] else count - 1):
        cut((0, axis, place), cuts=cuts)
        after = followed()
        assert after.points.shape[axis] == count + cuts and after.degree == before.degree
        assert after.largest_distance(before) < 1e-12 * np.abs(before.points).max()
        bpy.ops.ed.undo()
        assert nurbs(followed()) == before
        bpy.ops.ed.redo()
        assert followed() == after
        bpy.ops.ed.undo()
        bpy.ops.ed.undo()
    cut((0, axis, 0))
    cut((0, axis, 1))
    cut((0, 1 - axis, 0))
    after = followed()
    assert after.largest_distance(before) < 1e-12 * np.abs(before.points).max()
    assert after.points.shape[axis] == count + 2 and after.points.shape[1 - axis] == before.points.shape[1 - axis] + 1
    leave()
    assert value() == after


@pytest.mark.parametrize('kind', ('plain nurbs', 'bezier patch', 'both periodic', 'teapot', 'four around a corner'))
def test_subdividing_all_cuts_in_rows_along_both_directions(kind):
    before = started(kind)
    bpy.ops.mesh.select_all(action='SELECT')
    op(bpy.ops.mesh.subdivide)
    if kind == 'teapot':                # it has poles
        bpy.context.view_layer.update()
        assert value() == before and (live.problem(held()) or live.note(held()))
        return
    after = followed()
    for old, new in zip(list(before) if isinstance(before, sc.PatchSet) else [before],
                        list(after) if isinstance(before, sc.PatchSet) else [after]):
        assert new.largest_distance(nurbs(old)) < 1e-12 * np.abs(old.points).max()
        assert all(np.array(new.points.shape[:2]) >= 2 * np.array(old.points.shape[:2]) - 1)
    leave()


@pytest.mark.parametrize('kind,axis', OPEN + AROUND)
def test_a_row_that_was_cut_in_and_is_dissolved_leaves_the_shape_as_it_was(kind, axis):
    before = nurbs(started(kind))
    cut((0, axis, 1 if before.points.shape[axis] > 2 else 0))
    after = followed()
    count = after.points.shape[axis]
    for place in range(1, count - 1):
        dissolve((0, axis, place))
        fewer = followed()
        assert fewer.points.shape[axis] == count - 1
        assert np.isclose(told(), nurbs(fewer).largest_distance(after), rtol=0.01, atol=1e-7)
        bpy.ops.ed.undo()
        assert followed() == after and live.note(held()) == ""
    if before.degree[axis] != 1:        # of degree 1 the two rows beside are as good as the new one
        dissolve((0, axis, 2))
        assert followed().largest_distance(before) < 1e-7 * np.abs(before.points).max()
    leave()


@pytest.mark.parametrize('kind,axis', [one for one in OPEN if one[0] not in ('bilinear', 'cylinder')])
@pytest.mark.parametrize('end', (-1, 0), ids=('last', 'first'))
def test_a_border_that_is_deleted_lets_the_patch_end_earlier(kind, axis, end):
    before = started(kind)
    extrude((0, axis, end))
    longer = followed()
    delete((0, axis, end))
    again = followed()
    assert np.array_equal(again.points, before.points) and again.degree == before.degree
    assert nurbs(again).largest_distance(nurbs(before)) < 1e-12 and live.note(held()) == ""
    choose(*vertices(0, axis, end), *vertices(0, axis, 1 if end == 0 else -2))
    op(bpy.ops.mesh.delete, type='FACE')
    shorter = followed()
    kept = range(1, before.points.shape[axis]) if end == 0 else range(before.points.shape[axis] - 1)
    assert np.array_equal(shorter.points, rows_of(before.points, axis, kept))
    for expected in (again, longer):
        while value() != expected:
            bpy.ops.ed.undo()
        assert followed() == expected
    leave()
    require_exact(bpy.data.objects["shape"])


def taken_up():
    """followed(), when what had to wait is taken up, which a timer does in a window."""
    bpy.context.view_layer.update()
    assert live.is_waiting(held()) and live.problem(held()) == ""
    editing.adopt_rows()
    assert not live.is_waiting(held())
    return followed()


@pytest.mark.parametrize('kind,axis', [one for one in OPEN + AROUND if one[0] not in ('bilinear', 'cylinder')])
@pytest.mark.parametrize('count', (1, 2))
def test_an_inner_row_that_is_deleted_with_its_faces_leaves_no_gap(kind, axis, count):
    before = started(kind)
    cut((0, axis, 0), cuts=2)
    longer = followed()
    places = (1, 2)[:count]
    delete(*[(0, axis, place) for place in places])
    assert value() == longer
    fewer = taken_up()
    assert fewer.points.shape[axis] == longer.points.shape[axis] - count
    choose(*vertices(0, axis, 0))
    move(0, 0, 1)
    moved = followed()
    cut((0, axis, 0))
    assert followed().largest_distance(nurbs(moved)) < 1e-12
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert taken_up() == fewer          # as it was deleted, before the gap was closed
    bpy.ops.ed.undo()
    assert followed() == longer
    bpy.ops.ed.redo()
    assert taken_up() == fewer
    leave()
    assert value() == fewer
    bpy.data.objects.remove(bpy.data.objects["shape"])
    started(kind)
    cut((0, axis, 0), cuts=2)
    delete((0, axis, 1))
    leave()                             # at once
    assert value().points.shape[axis] == before.points.shape[axis] + 1


def test_undo_and_redo_go_through_every_gesture_and_over_the_border():
    seen = [started('rational nurbs')]
    for gesture in (lambda: extrude((0, 0, -1)), lambda: extrude((0, 1, 0), by=(0, 1, 0)), lambda: move(1, 0, 0),
                    lambda: cut((0, 0, 2), cuts=2), lambda: cut((0, 1, 1)), lambda: dissolve((0, 0, 3)),
                    lambda: delete((0, 1, -1))):
        gesture()
        seen.append(followed())
        choose(5)
        move(0, 0, 1)
        seen.append(followed())
    assert all(a != b for a, b in zip(seen, seen[1:]))
    leave()

    def there(back):
        """The distinct values that undo, or redo, leads through."""
        found = []
        for _ in range(60):
            (bpy.ops.ed.undo if back else bpy.ops.ed.redo)()
            editing.sweep()
            if not found or found[-1] != value():
                found.append(value())
            if found[-1] == (seen[0] if back else seen[-1]):
                return found
        raise AssertionError("it does not come")

    for expected in (seen[::-1], seen[-2::-1]):
        assert there(True) == expected
        require_exact(bpy.data.objects["shape"])
        assert there(False) == seen[1:]
        assert held().mode == 'EDIT' and live.problem(held()) == ""
    leave()


def test_what_was_moved_before_stays_moved_and_digits_are_kept():
    before = started('plain nurbs')
    corner = vertices(0, 0, 0)[0]
    choose(corner)
    move(0, 0, 3)
    extrude((0, 0, -1))
    after = followed()
    assert np.isclose(after.points[0, 0, 2], before.points[0, 0, 2] + 3)
    kept = np.ones((6, 6), bool)
    kept[0, 0] = False
    assert np.array_equal(after.points[:6][kept], before.points[kept])
    moved = after
    cut((0, 1, 2))
    assert followed().largest_distance(moved) < 1e-12
    leave()


def test_a_border_that_was_extruded_and_called_off_is_copies_again():
    before = started('plain nurbs')
    row = vertices(0, 0, -1)
    choose(*row)
    op(bpy.ops.mesh.extrude_context)
    bpy.context.view_layer.update()
    assert value() == before and "not of this net" in live.note(held()) and live.problem(held()) == ""
    move(0, 0, 1)
    longer = followed()
    assert longer.points.shape == (7, 6, 3) and live.note(held()) == ""
    bpy.ops.ed.undo()
    assert value() == before and "not of this net" in live.note(held()) and live.problem(held()) == ""
    move(0, 0, 1)
    assert followed() == longer
    move(0, 0, -1)
    held().update_from_editmode()
    if value() != before:               # the way back is not exact in float32
        bpy.ops.ed.undo()
        bpy.ops.ed.undo()
    editing.hand_over_now()
    bpy.context.view_layer.update()
    assert part('ui.net_props').chosen(held().data)[1] == row
    move(0, 0, 2)
    after = value()
    assert after.points.shape == (6, 6, 3) and np.allclose(after.points[-1, :, 2], before.points[-1, :, 2] + 2, atol=1e-5)
    assert np.array_equal(after.points[:-1], before.points[:-1])
    extrude((0, 0, -1))
    assert value().points.shape == (7, 6, 3) and live.problem(held()) == ""
    leave()


def test_a_called_off_drag_of_a_border_leads_back_at_once():
    """Esc puts copies back to where they were made, to the last bit."""
    before = started('plain nurbs')
    choose(*vertices(0, 0, -1))
    op(bpy.ops.mesh.extrude_context)
    bpy.context.view_layer.update()
    held().update_from_editmode()
    places = np.empty(3 * len(held().data.vertices), np.float32)
    held().data.vertices.foreach_get('co', places)
    move(0, 0, 1)
    assert value() != before
    edited = part('bridge.cage.cage')._Vertices(held())
    edited.set_positions(places.reshape(-1, 3))
    edited.tell()
    bpy.context.view_layer.update()
    assert value() == before and "not of this net" in live.note(held()) and live.problem(held()) == ""
    assert len(live.session(held().data).stages) == 2
    leave()
    assert value() == before


def half_extruded():
    choose(*vertices(0, 0, -1)[:3])
    op(bpy.ops.mesh.extrude_context_move, TRANSFORM_OT_translate={'value': (0, 0, 1)})


def corner_extruded():
    choose(*vertices(0, 0, -1), *vertices(0, 1, -1))
    op(bpy.ops.mesh.extrude_context_move, TRANSFORM_OT_translate={'value': (0, 0, 1)})


def inner_row_extruded():
    choose(*vertices(0, 0, 2))
    op(bpy.ops.mesh.extrude_context_move, TRANSFORM_OT_translate={'value': (0, 0, 1)})


def one_deleted():
    choose(vertices(0, 0, 2)[2])
    op(bpy.ops.mesh.delete, type='VERT')


def half_deleted():
    choose(*vertices(0, 0, 2)[2:])
    op(bpy.ops.mesh.delete, type='VERT')


def one_dissolved():
    choose(vertices(0, 0, 2)[2])
    op(bpy.ops.mesh.dissolve_verts)


def one_edge_cut():
    choose(*vertices(0, 0, 2)[1:3])
    op(bpy.ops.mesh.subdivide)


def one_face_cut():
    choose(*vertices(0, 0, 2)[1:3], *vertices(0, 0, 3)[1:3])
    op(bpy.ops.mesh.subdivide)


def faces_poked():
    bpy.ops.mesh.select_all(action='SELECT')
    op(bpy.ops.mesh.poke)


def row_and_a_point_deleted():
    choose(*vertices(0, 0, 2), vertices(0, 0, 4)[3])
    op(bpy.ops.mesh.delete, type='VERT')


def faces_deleted():
    choose(*vertices(0, 0, 2), *vertices(0, 0, 3))
    op(bpy.ops.mesh.delete, type='ONLY_FACE')
    extrude((0, 0, -1))


def all_deleted():
    bpy.ops.mesh.select_all(action='SELECT')
    op(bpy.ops.mesh.delete, type='VERT')


BAD = (half_extruded, corner_extruded, inner_row_extruded, one_deleted, half_deleted, one_dissolved, one_edge_cut,
       one_face_cut, faces_poked, row_and_a_point_deleted,
       faces_deleted, all_deleted)


@pytest.mark.parametrize('gesture', BAD, ids=lambda one: one.__name__)
def test_what_makes_no_row_is_said_and_the_points_that_are_there_count(gesture):
    before = started('plain nurbs')
    gesture()
    bpy.context.view_layer.update()
    assert value() == before and (live.problem(held()) or "not of this net" in live.note(held()))
    if gesture != all_deleted:
        choose(0)
        move(0, 0, 1)
        after = value()
        assert np.isclose(after.points[0, 0, 2], before.points[0, 0, 2] + 1)
        assert np.array_equal(after.points[1:], before.points[1:])
    while live.problem(held()) or live.note(held()) or len(mesh().faces) < 25:
        bpy.ops.ed.undo()
    assert followed() == before
    extrude((0, 0, -1))
    assert followed().points.shape == (7, 6, 3)
    leave()


@pytest.mark.parametrize('kind', ('hermite patch', 'ferguson'))
def test_hermite_patches_refuse_rows_in_words_and_lose_nothing(kind):
    before = started(kind)
    for gesture in (lambda: extrude((0, 0, -1)), lambda: cut((0, 0, 0)), lambda: delete((0, 0, 0))):
        gesture()
        assert "Hermite" in live.problem(held()) and value() == before
        choose(vertices(0, 0, 1)[1])
        move(0, 0, 1)
        assert value() != before and "Hermite" in live.problem(held())
        while live.problem(held()):
            bpy.ops.ed.undo()
        assert value() == before
    leave()
    require_exact(bpy.data.objects["shape"])


def test_a_net_with_points_at_infinity_refuses_rows_in_words():
    before = started('patch with a point at infinity')
    cut((0, 1, 0))
    assert value() == before and (live.problem(held()) or live.note(held()))
    bpy.ops.ed.undo()
    choose(*vertices(0, 0, 0))
    move(0, 0, 1)
    assert value() != before and live.problem(held()) == ""
    leave()


def test_a_grown_net_is_saved_while_it_is_out_and_goes_on_when_it_is_opened(tmp_path):
    started('rational nurbs')
    extrude((0, 0, -1))
    cut((0, 1, 1))
    after = followed()
    save(tmp_path / "grown.blend")
    assert followed() == after
    reopen(tmp_path / "grown.blend")
    editing.sweep()
    assert value() == after and not [ob for ob in bpy.data.objects if net_object.is_net(ob)]
    activate(bpy.data.objects["shape"])
    enter()
    assert followed() == after and live.note(held()) == ""
    extrude((0, 0, -1), by=(1, 0, 0))
    more = followed()
    assert more.points.shape[0] == after.points.shape[0] + 1
    dissolve((0, 1, 2))
    followed()
    leave()


def test_typed_numbers_reach_points_of_rows_that_were_added():
    started('plain nurbs')
    extrude((0, 0, -1))
    choose(vertices(0, 0, -1)[2])
    numbers = list(held().data.splinewright_points.numbers)
    numbers[0], numbers[3] = 0.1, 0.3
    held().data.splinewright_points.numbers = numbers
    after = followed()
    assert after.points[-1, 2, 0] == 0.1 and after.weights[-1, 2] == 0.3
    leave()
    assert value() == after


def test_a_net_that_cannot_be_read_waits_for_nothing_and_its_shape_stays():
    started('plain nurbs')
    cut((0, 0, 0), cuts=2)
    longer = followed()
    delete((0, 0, 1))
    bpy.context.view_layer.update()
    assert live.is_waiting(held())
    layers = mesh().verts.layers.int
    layers.remove(layers["splinewright_vertex"])
    live.sync_from_cage(held(), live.Phase.TOLD)
    assert "lost the numbers" in live.problem(held())
    assert not live.is_waiting(held()) and value() == longer
    require_exact(bpy.data.objects["shape"])


def test_where_a_net_that_has_grown_cannot_be_read_its_shape_stays_until_it_can(monkeypatch):
    before, reading = started('plain nurbs'), live.reading
    count = before.points[..., 0].size

    def read(net, *more, work=reading.read):
        if len(net.rows) > count:
            raise reading.ChangedNet("it is not to be read now")
        return work(net, *more)
    monkeypatch.setattr(reading, 'read', read)
    extrude((0, 0, -1), by=(1, 0, 0))
    bpy.context.view_layer.update()
    session = live.session(held().data)
    assert "not to be read" in live.problem(held()) and value() == before
    assert len(session.state.positions) == len(session.points) == len(session.net.rows) > count
    monkeypatch.undo()
    live.sync_from_cage(held())
    assert followed().points.shape[0] == before.points.shape[0] + 1
