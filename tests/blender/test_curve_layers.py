"""Radius, tilt and soft body weight of single points stay where they are when a curve shape gets other points."""

import bpy
import numpy as np
import pytest

from curves import curves_of, run, value_of
from geometry import mesh_points
from natives import drawn, exact, native, native_curve
from shapes import activate, add, curve_points, enter, leave, move, op, require_exact, select
from support import part

curve_layers, curve_pieces, store = (part(f'bridge.{name}') for name in ('curve.curve_layers', 'shape.curve_pieces', 'data.store'))
NAMES = ('radius', 'tilt', 'weight_softbody')
KINDS = ('cubic', 'rational cubic', 'hermite', 'closed hermite', 'nurbs', 'periodic', 'many curves', 'circle', 'uniform')


def values(spline, name):
    found = np.empty(len(spline.points), np.float32)
    spline.points.foreach_get(name, found)
    return found


def all_values(ob):
    return [np.stack([values(spline, name) for name in NAMES], 1) for spline in ob.data.splines]


def give(ob, of_points):
    """Each point the three numbers that of_points() gives for all points (n, 3) of a spline."""
    for spline in ob.data.splines:
        for name, column in zip(NAMES, np.asarray(of_points(curve_points(spline)), np.float32).T):
            spline.points.foreach_set(name, np.ascontiguousarray(column))
    bpy.ops.ed.undo_push(message="give")


def said_of(points):
    """Numbers that say where a point lies."""
    return 2 + np.tanh(points / 4)


def farthest_from_said(ob, tilt_sign=1):
    signs = np.array([1, tilt_sign, 1])
    return max(np.abs(all_values(ob)[i] * signs - said_of(curve_points(spline))).max()
               for i, spline in enumerate(ob.data.splines))


def peaked(ob):
    """Numbers on single points, at a third of each spline, say."""
    give(ob, lambda points: np.where(np.arange(len(points))[:, None] == len(points) // 3, (5, 1, 0.5), (1, 0, 0)))
    return all_values(ob)


# Other numbers of points ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize('kind', KINDS)
def test_where_points_lie_on_their_curves_is_known(kind):
    ob = add(value_of(kind))
    for reach, resolution in ((10.0, 1), (0.5, 5), (10.0, 12)):
        ob.data.splinewright.reach, ob.data.splinewright.resolution_u = reach, resolution
        require_lines_are_known(ob)


@pytest.mark.parametrize('reach', (0.1, 3.0))
def test_where_points_lie_on_arms_of_hyperbolas_is_known(reach):
    ob = add([value_of('hyperbola'), value_of('semicircle')])
    ob.data.splinewright.reach = reach
    require_lines_are_known(ob)


def require_lines_are_known(ob):
    lines = curve_pieces.shown_of(ob.data, store.read(ob.data))
    points = []
    for curve, piece in zip(curves_of(ob), lines):
        start, end = curve.domain
        points += [curve.evaluate(np.minimum(start + line.at * (end - start), end)) for line in piece]
    assert len(points) == len(ob.data.splines)
    for theirs, spline in zip(points, ob.data.splines):
        assert np.allclose(theirs, curve_points(spline), atol=1e-5)


@pytest.mark.parametrize('kind', KINDS)
def test_values_lie_where_they_lay_at_another_resolution(kind):
    ob = add(value_of(kind))
    ob.data.splinewright.resolution_u = 24
    give(ob, said_of)
    for resolution in (60, 7, 24):
        ob.data.splinewright.resolution_u = resolution
        require_exact(ob)
        assert farthest_from_said(ob) < (0.05 if resolution == 7 else 0.02)


@pytest.mark.parametrize('kind', KINDS)
def test_a_slider_that_goes_through_all_resolutions_wears_nothing_down(kind):
    ob = add(value_of(kind))
    before = peaked(ob)
    for resolution in (5, 6, 7, 8, 3, 1, 4):
        ob.data.splinewright.resolution_u = resolution
    assert all(map(np.array_equal, all_values(ob), before))
    ob.data.splinewright.resolution_u = 8
    assert all(now[:, 0].max() == 5.0 for now in all_values(ob))


def test_what_was_changed_at_the_new_resolution_counts():
    ob = add(value_of('nurbs'))
    peaked(ob)
    ob.data.splinewright.resolution_u = 5
    give(ob, said_of)
    ob.data.splinewright.resolution_u = 4
    assert farthest_from_said(ob) < 0.2
    assert all(now[:, 0].max() < 3.1 for now in all_values(ob))


def test_values_of_one_number_cost_nothing_and_are_not_noted():
    ob = add(value_of('nurbs'))
    give(ob, lambda points: np.tile((2, 1, 0.5), (len(points), 1)))
    ob.data.splinewright.resolution_u = 9
    assert (all_values(ob)[0] == (2, 1, 0.5)).all() and curve_layers.KEY not in ob.data.keys()


@pytest.mark.parametrize('damaged', (3, "x", {'counts': [2]}, {'counts': [7, -3], 'at': [0.0], 'values': [1.0]},
                                     {'counts': [], 'at': [], 'values': []}))
def test_a_damaged_note_is_passed_over(damaged):
    ob = add(value_of('nurbs'))
    peaked(ob)
    ob.data.splinewright.resolution_u = 5
    before = all_values(ob)[0]
    ob.data[curve_layers.KEY] = damaged
    ob.data.splinewright.resolution_u = 10
    assert np.array_equal(all_values(ob)[0][::2], before) and ob.data.splinewright.problem == ""


def test_values_survive_a_net_that_gains_points_and_saving(tmp_path):
    bpy.ops.splinewright.add_catmull_rom()
    ob = bpy.context.object
    peaked(ob)
    op(bpy.ops.splinewright.edit_net)
    bpy.ops.curve.select_all(action='SELECT')
    bpy.ops.curve.subdivide()
    leave()
    ob = bpy.context.object
    assert all_values(ob)[0][:, 0].max() > 4
    path = str(tmp_path / "saved.blend")
    ob.data.splinewright.resolution_u = 7
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    bpy.context.object.data.splinewright.resolution_u = 24
    assert all_values(bpy.context.object)[0][:, 0].max() > 4


def test_values_stay_while_a_net_is_dragged():
    ob = add(value_of('nurbs'))
    before = peaked(ob)
    held = enter()
    select(held, 0)
    move(0, 0, 1)
    leave()
    assert all(map(np.array_equal, all_values(ob), before))


# Verbs ----------------------------------------------------------------------------------------------------------------


VERBS = (('insert_knot', {'where': 'SPANS', 'times': 2}), ('raise_degree', {}), ('split', {'parameter_u': 0.3}),
         ('split', {'where': 'KNOTS'}), ('split', {'where': 'FLAT', 'tolerance': 0.05}), ('reverse', {}),
         ('to_bezier', {}), ('to_nurbs', {}), ('clamp', {}), ('unclamp', {}),
         ('reparameterize', {'how': 'MOEBIUS', 'rho': 3.0}), ('reparameterize', {'how': 'AFFINE', 'start': 2.0, 'end': 5.0}),
         ('standard_form', {}), ('project_curve', {'eye': (0, 0, 1e4)}), ('to_hermite', {'tolerance': 1e-3}))


@pytest.mark.parametrize('kind', KINDS)
@pytest.mark.parametrize('name, settings', VERBS)
def test_values_stay_in_their_place_after_a_verb(name, settings, kind):
    ob = add(value_of(kind))
    ob.data.splinewright.resolution_u = 48
    give(ob, said_of)
    try:
        run(name, **settings)
    except RuntimeError as refused:
        assert not str(refused).startswith("Python"), refused
        assert farthest_from_said(ob) < 1e-6
        return
    require_exact(ob)
    ob.data.splinewright.resolution_u = 40
    off = [np.abs(now * (1, -1 if name == 'reverse' else 1, 1) - said_of(curve_points(spline)))
           for now, spline in zip(all_values(ob), ob.data.splines)]
    if name == 'project_curve':
        off = [each[:, :2] for each in off]
    assert max(map(np.max, off)) < 0.03


def test_reversed_tilts_are_those_of_blenders_own_switch_of_direction():
    ob = add(value_of('nurbs'))
    give(ob, said_of)
    before = all_values(ob)[0]
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.curve.select_all(action='SELECT')
    bpy.ops.curve.switch_direction()
    bpy.ops.object.mode_set(mode='OBJECT')
    blenders = all_values(ob)[0]
    op(bpy.ops.splinewright.restore)
    give(ob, lambda points: before)
    run('reverse')
    assert np.allclose(all_values(ob)[0], blenders, atol=1e-5)


def test_joined_ends_and_pieces_keep_what_lay_on_both():
    whole = value_of('nurbs')
    ob = add(list(whole.split(1 / 3)))
    ob.data.splinewright.resolution_u = 40
    give(ob, said_of)
    run('reverse', piece=2)
    run('join_ends')
    assert len(ob.data.splines) == 1 and farthest_from_said(ob) < 0.02
    run('to_bezier')
    run('join_pieces', tolerance=1e-5)
    assert len(ob.data.splines) == 1 and farthest_from_said(ob) < 0.02


@pytest.mark.parametrize('names', (('nurbs', 'hermite', 'many curves'), ('periodic', 'cubic')))
def test_joined_shapes_of_other_resolutions_keep_what_lay_on_each(names):
    obs = [add(value_of(name), name) for name in names]
    for i, ob in enumerate(obs):
        ob.data.splinewright.resolution_u = 24 + 9 * i
        give(ob, said_of)
    activate(*obs)
    op(bpy.ops.splinewright.join)
    assert len(bpy.data.objects) == 1 and farthest_from_said(bpy.context.object) < 0.02


# Blender's own curves -------------------------------------------------------------------------------------------------


NATIVES = ('primitive_bezier_curve_add', 'primitive_bezier_circle_add', 'primitive_nurbs_curve_add',
           'primitive_nurbs_circle_add', 'primitive_nurbs_path_add')
THICK = 0.005


def varied(ob):
    """Numbers on each point, and thick enough to show them."""
    for spline in ob.data.splines:
        points = spline.bezier_points or spline.points
        for i, point in enumerate(points):
            point.radius, point.tilt, point.weight_softbody = 1 + (i % 3), 0.3 * (i % 2), 0.2 + 0.1 * i
    ob.data.bevel_depth = THICK
    return ob


def of_points(ob):
    return [[(p.radius, p.tilt, p.weight_softbody) for p in spline.bezier_points or spline.points]
            for spline in ob.data.splines]


def dense(rows, closed):
    """(points, radii) of many more places between the rows (n, 4) of points and radii."""
    rows = np.concatenate([rows, rows[:1]]) if closed else rows
    at = np.linspace(0, len(rows) - 1, 5000)
    found = np.column_stack([np.interp(at, np.arange(len(rows)), column) for column in rows.T])
    return found[:, :3], found[:, 3]


@pytest.mark.parametrize('way', ('LINEAR', 'EASE', 'CARDINAL', 'BSPLINE'))
@pytest.mark.parametrize('name', NATIVES)
def test_a_curve_made_exact_is_as_thick_as_it_was_everywhere(name, way):
    ob = varied(native_curve(name))
    spline, = ob.data.splines
    spline.radius_interpolation, spline.resolution_u = way, 64
    around = mesh_points(drawn(ob))[12:-12]     # Blender tilts the rings at the ends
    exact(ob)
    values, = all_values(ob)
    assert (np.ptp(values, axis=0) > (0.3, 0.02, 0.05)).all()
    middle, radii = dense(np.column_stack([curve_points(ob.data.splines[0]), values[:, 0]]), ob.data.splines[0].use_cyclic_u)
    distances = np.stack([np.linalg.norm(middle - place, axis=1) for place in around])
    assert np.abs(distances.min(1) - THICK * radii[distances.argmin(1)]).max() < 0.03 * THICK


@pytest.mark.parametrize('name', NATIVES)
def test_there_and_back_every_point_has_what_it_had(name):
    ob = varied(native_curve(name))
    before = of_points(ob)
    exact(ob)
    native(ob)
    assert np.allclose(of_points(ob), before, atol=1e-4)


def test_what_points_of_blenders_cannot_say_is_said():
    ob = add(value_of('cubic'))
    ob.data.splinewright.resolution_u = 40
    peaked(ob)
    outcome, _ = part('bridge.native.to_native').to_native(bpy.context, ob)
    assert outcome.dropped == ["the radius of single points", "the tilt of single points",
                               "the soft body weight of single points"]


def test_looks_and_values_of_each_piece_become_those_of_its_splines():
    ob = add([value_of('nurbs'), value_of('cubic'), value_of('three knots')])
    for i, spline in enumerate(ob.data.splines):
        ob.data.materials.append(bpy.data.materials.new(str(i)))
        spline.material_index, spline.use_smooth = i, bool(i % 2)
        for point in spline.points:
            point.radius = 2 + i
    native(ob)
    assert {(spline.material_index, spline.use_smooth, point.radius) for spline in ob.data.splines
            for point in spline.bezier_points or spline.points} == {(i, bool(i % 2), 2.0 + i) for i in range(3)}
