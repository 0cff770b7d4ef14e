"""Points more and less in the net of a curve, by Blender's own gestures: the shape follows, through undo, leaving and saving."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, numbers_of, op, points, require_exact, select
from support import part, splinecore as sc
from test_files import reopen, save

editing, live, net_object, store = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store'))
POLYGONS = ('nurbs', 'quintic', 'rational cubic', 'unclamped', 'line')
CHAINS = ('hermite', 'hermite with corners', 'cubic')
MORE = {
    'unclamped': lambda: sc.NurbsCurve(2, range(9), points(6)),
    'line': lambda: sc.NurbsCurve(1, [0, 0, 0.2, 0.5, 1, 1], points(4)),
}


def value_of(name):
    return {**VALUES, **MORE}[name]()


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def held():
    return bpy.context.object


def spline(number=0):
    return held().data.splines[number]


def points_of(of):
    return of.bezier_points if of.type == 'BEZIER' else of.points


def choose(*places, number=0):
    """Select points by their places in a spline, as an undo step."""
    choose_among((number, place) for place in places)


def choose_among(places):
    """Select points by the number of their spline and their place in it, as an undo step."""
    bpy.ops.curve.select_all(action='DESELECT')
    for number, place in places:
        point = points_of(spline(number))[place]
        if spline(number).type == 'BEZIER':
            point.select_control_point = point.select_left_handle = point.select_right_handle = True
        else:
            point.select = True
    held().data.update_tag()
    bpy.ops.ed.undo_push(message="choose")


def followed():
    """The value, after Blender told of what was done; the net is as many points, where they are, as the shape's own."""
    held().data.update_tag()
    bpy.context.view_layer.update()
    assert live.problem(held()) == ""
    own = net_object.net_of(store.read(bpy.data.objects["shape"].data))
    there = net_object.present(held(), numbers_of(held()))
    assert np.array_equal(np.sort(there.numbers), np.arange(len(own.rows)))
    positions = there.positions()[np.argsort(there.numbers)]
    told = own.rows >= 0                # handles that set nothing may stand anywhere
    assert np.allclose(positions[told], own.positions[told], atol=1e-5 * np.abs(own.positions).max())
    require_exact(bpy.data.objects["shape"])
    return value()


def extruded(x, y, z):
    op(bpy.ops.curve.extrude_move, TRANSFORM_OT_translate={'value': (x, y, z)})
    return followed()


def as_nurbs(curve):
    return curve.to_nurbs()


@pytest.mark.parametrize('name', POLYGONS)
@pytest.mark.parametrize('end', (-1, 0), ids=('last', 'first'))
def test_e_appends_a_point_to_a_polygon_and_the_others_stay(name, end):
    before = value_of(name)
    add(before)
    enter()
    for times in (1, 2, 3):
        choose(end)
        after = extruded(0.5, 0, 0.25)
        kept = after.points[:-times] if end else after.points[times:]
        weights = after.weights[:-times] if end else after.weights[times:]
        assert np.array_equal(kept, before.points) and np.array_equal(weights, before.weights)
        assert np.allclose(after.points[end], before.points[end] + times * np.array([0.5, 0, 0.25]), atol=1e-6)
        assert after.degree == before.degree and len(spline().points) == len(before.points) + times
    leave()
    assert value() == after
    enter()
    assert len(spline().points) == len(before.points) + 3
    leave()
    assert value() == after


@pytest.mark.parametrize('name', ('nurbs', 'hermite', 'cubic'))
def test_undo_and_redo_go_through_every_gesture_and_over_the_border(name):
    add(value_of(name))
    enter()
    seen = [value()]
    choose(-1)
    seen.append(extruded(0, 0, 1))
    choose(-1)
    seen.append(extruded(0, 1, 0))
    move(1, 0, 0)
    seen.append(followed())
    choose(0, 1)
    op(bpy.ops.curve.subdivide)
    seen.append(followed())
    choose(1)
    move(0, 0, 2)
    seen.append(followed())
    choose(1)
    op(bpy.ops.curve.delete, type='VERT')
    seen.append(followed())
    choose(0)
    move(0, 0, 1)
    seen.append(followed())
    assert all(a != b for a, b in zip(seen, seen[1:]))
    leave()

    def there(back):
        """The distinct values that undo, or redo, leads through."""
        found = []
        for _ in range(40):
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


@pytest.mark.parametrize('name', (*POLYGONS, 'periodic'))
@pytest.mark.parametrize('cuts', (1, 3))
def test_subdividing_a_polygon_inserts_knots_and_the_shape_stays(name, cuts):
    before = value_of(name)
    add(before)
    enter()
    count = len(spline().points)
    choose(1, 2)
    op(bpy.ops.curve.subdivide, number_cuts=cuts)
    after = followed()
    assert len(after.points) == count + cuts == len(spline().points)
    assert after.largest_distance(as_nurbs(before)) < 1e-12
    bpy.ops.curve.select_all(action='SELECT')
    op(bpy.ops.curve.subdivide)
    twice = followed()
    assert twice.largest_distance(as_nurbs(before)) < 1e-12
    assert len(twice.points) == 2 * len(after.points) - (0 if spline().use_cyclic_u else 1)
    if before.degree == 2:
        assert len(np.unique(twice.knots)) == len(twice.knots), "a knot came twice"
    choose(2)
    move(0, 0, 1)
    moved = followed()
    assert np.isclose(np.abs(moved.points - twice.points).max(), 1, atol=1e-5)
    leave()
    assert value() == moved


def test_what_was_moved_before_a_point_is_deleted_or_cut_stays_moved_and_undo_leads_there():
    add(value_of('nurbs'))
    enter()
    choose(3)
    move(0, 0, 3)
    moved = followed()
    op(bpy.ops.curve.delete, type='VERT')
    without = followed()
    assert "lies within" in live.note(held())
    assert np.isclose(without.largest_distance(moved), float(live.note(held()).split("within ")[1].split()[0]), rtol=0.5)
    choose(0)
    move(1, 0, 0)
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    held().data.update_tag()
    assert followed() == without and "lies within" in live.note(held())
    bpy.ops.ed.undo()
    assert followed() == moved and live.note(held()) == ""
    leave()


@pytest.mark.parametrize('name', (*POLYGONS, *CHAINS))
def test_a_point_that_was_cut_in_and_is_deleted_leaves_the_shape_as_it_was(name):
    before = value_of(name)
    add(before)
    enter()
    choose(0, 1)
    op(bpy.ops.curve.subdivide)
    followed()
    choose(1)
    op(bpy.ops.curve.delete, type='VERT')
    after = followed()
    assert as_nurbs(after).largest_distance(as_nurbs(before)) < 1e-9
    leave()


@pytest.mark.parametrize('name', (*POLYGONS, *CHAINS))
@pytest.mark.parametrize('end', (-1, 0), ids=('last', 'first'))
def test_an_end_that_was_extruded_and_is_deleted_leaves_what_was_there(name, end):
    before = value_of(name)
    add(before)
    enter()
    choose(end)
    extruded(0.5, 0, 1)
    choose(end)
    op(bpy.ops.curve.delete, type='VERT')
    after = followed()
    assert len(after.points) == len(as_chain(before).points)
    assert np.allclose(as_chain(after).points, as_chain(before).points, atol=1e-12)
    if name in CHAINS:
        assert as_nurbs(after).largest_distance(as_nurbs(before)) < 1e-12
    leave()


def as_chain(curve):
    return curve.to_hermite() if isinstance(curve, sc.BezierCurve) and len(curve.points) == 4 and not curve.is_rational else curve


@pytest.mark.parametrize('name', CHAINS)
@pytest.mark.parametrize('end', (-1, 0), ids=('last', 'first'))
def test_e_appends_a_segment_to_a_chain_and_the_others_stay(name, end):
    original = value_of(name)
    before = original.to_hermite()
    add(original)
    enter()
    choose(end)
    after = extruded(1, 0.5, 0.25)
    assert len(after.points) == len(before.points) + 1
    kept = slice(None, -1) if end else slice(1, None)
    assert np.array_equal(after.points[kept], before.points)
    assert np.allclose(after.points[end] - before.points[end], (1, 0.5, 0.25), atol=1e-6)
    for before_one, after_one in zip(before.to_bezier(), after.to_bezier()[kept]):
        assert np.allclose(before_one.points, after_one.points, atol=1e-6)
    leave()
    assert value() == after


@pytest.mark.parametrize('name', (*CHAINS, 'closed hermite'))
@pytest.mark.parametrize('cuts', (1, 2))
def test_subdividing_a_chain_splits_it_exactly(name, cuts):
    before = value_of(name)
    add(before)
    enter()
    count = len(spline().bezier_points)
    for more in (cuts, cuts + count * cuts):
        bpy.ops.curve.select_all(action='SELECT')
        op(bpy.ops.curve.subdivide, number_cuts=cuts)
        after = followed()
        assert as_nurbs(after).largest_distance(as_nurbs(before)) < 1e-12
    segments = (len(as_chain(before).points) - 1) * (cuts + 1) ** 2
    assert len(after.points) == segments + 1
    leave()
    assert value() == after


@pytest.mark.parametrize('name', ('nurbs', 'periodic', 'hermite', 'closed hermite', 'unclamped'))
def test_any_point_may_be_deleted_and_dissolved(name):
    for verb in (lambda: op(bpy.ops.curve.delete, type='VERT'), lambda: op(bpy.ops.curve.dissolve_verts)):
        before = value_of(name)
        add(before)
        enter()
        count = len(points_of(spline()))
        for place in range(count):
            choose(place)
            verb()
            after = followed()
            assert len(points_of(spline())) == count - 1 and after != before
            bpy.ops.ed.undo()
            assert followed() == before
        leave()
        bpy.data.objects.remove(bpy.data.objects["shape"])


def test_the_last_points_are_refused_in_words_and_the_others_count():
    add(value_of('cubic'))
    enter()
    before = value()
    choose(0)
    op(bpy.ops.curve.delete, type='VERT')
    held().data.update_tag()
    bpy.context.view_layer.update()
    assert "a curve needs two points" in live.problem(held())
    assert value() == before
    bpy.ops.ed.undo()
    assert followed() == before
    leave()


@pytest.mark.parametrize('name', ('nurbs', 'quintic', 'unclamped', 'hermite', 'cubic', 'line'))
def test_toggle_cyclic_closes_and_opens(name):
    before = value_of(name)
    add(before)
    enter()
    choose(0)
    op(bpy.ops.curve.cyclic_toggle)
    closed = followed()
    ends = closed.domain
    assert np.allclose(closed.evaluate(ends[0]), closed.evaluate(ends[1]), atol=1e-12)
    leave()
    enter()
    assert spline().use_cyclic_u and value() == closed
    choose(0)
    op(bpy.ops.curve.cyclic_toggle)
    opened = followed()
    assert not spline().use_cyclic_u and len(points_of(spline())) == len(as_chain(before).points)
    assert np.array_equal(opened.points, as_chain(before).points)
    bpy.ops.ed.undo()
    assert followed() == closed
    leave()


def test_points_that_were_extruded_and_called_off_are_copies_again():
    add(value_of('nurbs'))
    enter()
    before = value()
    choose(-1)
    op(bpy.ops.curve.extrude, mode='INIT')
    held().data.update_tag()
    bpy.context.view_layer.update()
    assert value() == before and "not of this net" in live.note(held())
    end = held().data.splines[0].points[-1]
    was = tuple(end.co)
    end.co.z += 1
    assert followed() != before and live.note(held()) == ""
    held().data.splines[0].points[-1].co = was
    held().data.update_tag()
    bpy.context.view_layer.update()
    assert value() == before and "not of this net" in live.note(held()) and live.problem(held()) == ""
    part('ui.editing').hand_over_now()
    assert part('ui.net_props').chosen(held().data)[1] == [5]
    leave()
    assert value() == before


@pytest.mark.parametrize('name', ('nurbs', 'hermite'))
def test_a_drag_that_brings_the_old_tilt_back_takes_no_point_for_another(name):
    """Blender's drags remember the tilt of what they move, and put it back."""
    add(value_of(name))
    enter()
    tilt = points_of(spline())[-1].tilt
    choose(-1)
    extruded(0, 0, 1)
    end = points_of(spline())[-1]
    assert end.tilt != tilt
    end.tilt = tilt
    after, stages = followed(), len(live.session(held().data).stages)
    choose(-1)
    move(0, 0, 1)
    assert followed().points[-1, 2] - after.points[-1, 2] == pytest.approx(1, abs=1e-6)
    assert len(live.session(held().data).stages) == stages
    choose(-1)
    assert len(extruded(0, 1, 0).points) == len(after.points) + 1
    leave()


def test_a_typed_number_goes_to_a_point_that_was_added():
    add(value_of('nurbs'))
    enter()
    choose(-1)
    extruded(0, 0, 1)
    choose(-1)
    numbers = list(held().data.splinewright_points.numbers)
    numbers[0], numbers[3] = 0.1, 0.3
    held().data.splinewright_points.numbers = numbers
    after = followed()
    assert after.points[-1, 0] == 0.1 and after.weights[-1] == 0.3
    leave()
    assert value() == after


@pytest.mark.parametrize('name', ('nurbs', 'hermite'))
def test_a_turned_net_grows_and_shrinks_like_any_other(name):
    before = value_of(name)
    add(before)
    enter()
    bpy.ops.curve.select_all(action='SELECT')
    op(bpy.ops.curve.switch_direction)
    assert followed() == before
    choose(0)                           # the last of the shape
    after = extruded(0, 0, 1)
    assert np.array_equal(after.points[:-1], before.points)
    choose(1, 2)
    op(bpy.ops.curve.subdivide)
    cut = followed()
    assert as_nurbs(cut).largest_distance(as_nurbs(after)) < 1e-12
    choose(-1)
    op(bpy.ops.curve.delete, type='VERT')
    assert np.allclose(followed().points[0], cut.points[1], atol=1e-12)
    leave()


def test_one_of_several_curves_is_deleted_and_one_grows():
    before = value_of('many curves')
    add(before)
    enter()
    choose(-1, number=1)
    extruded(0, 0, 1)
    assert [len(curve.points) for curve in value()] == [4, 6, 3, 2]
    choose(0, 1, number=3)
    op(bpy.ops.curve.delete, type='VERT')
    after = followed()
    assert [len(curve.points) for curve in after] == [4, 6, 3] and after[0] == before[0] and after[2] == before[2]
    leave()
    assert value() == after


@pytest.mark.parametrize('name', ('nurbs', 'hermite', 'periodic', 'closed hermite'))
def test_a_segment_that_is_deleted_parts_a_curve_and_opens_a_closed_one(name):
    before = value_of(name)
    add(before)
    enter()
    is_closed, places = spline().use_cyclic_u, [tuple(point.co)[:3] for point in points_of(spline())]
    choose(1, 2)
    op(bpy.ops.curve.delete, type='SEGMENT')
    after = followed()
    if is_closed:
        assert np.allclose(after.points, places[2:] + places[:2], atol=1e-6) and not spline().use_cyclic_u
    else:
        assert np.allclose(np.concatenate([one.points for one in after]), places, atol=1e-6) and len(after) == 2
    leave()
    assert value() == after
    for _ in range(2):
        bpy.ops.ed.undo()
        editing.sweep()
    assert value() == before
    bpy.ops.ed.redo()
    assert followed() == after
    leave()


def test_what_is_separated_goes_to_an_object_of_its_own_and_the_shape_has_the_rest():
    before = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 3, 4, 5, 5, 5], points(7))
    add(before)
    enter()
    choose(0, 1, 2)
    op(bpy.ops.curve.separate)
    after = followed()
    assert np.allclose(after.points, before.points[2:], atol=1e-12)
    leave()
    assert value() == after and not [ob for ob in bpy.data.objects if net_object.is_net(ob)]


@pytest.mark.parametrize('name', ('nurbs', 'hermite'))
def test_a_file_saved_while_the_net_is_out_has_what_was_added(name, tmp_path):
    add(value_of(name))
    enter()
    choose(-1)
    extruded(0, 0, 1)
    choose(0, 1)
    op(bpy.ops.curve.subdivide)
    after = followed()
    save(tmp_path / "grown.blend")
    assert followed() == after
    choose(0)
    move(0, 0, 1)
    assert followed() != [after]
    reopen(tmp_path / "grown.blend")
    editing.sweep()
    assert value() == after and not [ob for ob in bpy.data.objects if net_object.is_net(ob)]
