"""Surfaces that curves span, live: lofts, sweeps, pipes, networks, fillings; any number of curves, their order and direction."""

import math

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from curves import value_of
from shapes import activate, add, enter, leave, op, require_exact, select
from support import part, splinecore as sc

follow, recipes, sections_overlay = (part(name) for name in ('bridge.follow.follow', 'bridge.recipes.recipes', 'ui.sections_overlay'))
CIRCLE = sc.conics.circle((0, 0, 0), 1.0)


def line(*points):
    """Through points: of the degree that takes them all."""
    return sc.build.polynomial_through(points)


def make(kind, *curves, **settings):
    """The surface of selected objects, of which the first is active."""
    activate(*curves)
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **settings) == {'FINISHED'}
    bpy.ops.ed.undo_push(message="add")
    return bpy.context.object


def circles():
    """Of a cylinder, made in no order."""
    found = []
    for name, height in (("middle", 2.0), ("low", 0.0), ("high", 5.0), ("next", 1.0)):
        found.append(add(CIRCLE, name))
        found[-1].location.z = height
    bpy.context.view_layer.update()
    return found


def names(ob):
    return [source.name for source in recipes.read(ob.data).sources]


def radii(ob):
    points = np.array([vertex.co for vertex in ob.data.vertices])
    return np.hypot(points[:, 0], points[:, 1])


FRAME = {'left': line((0, 0, 0), (0, 1, 0.5), (0, 2, 0)), 'right': line((3, 0, 0), (3, 1, -0.5), (3, 2, 0)),
         'front': line((0, 0, 0), (1.5, -0.2, 0.4), (3, 0, 0)), 'back': line((0, 2, 0), (1.5, 2.3, 0.3), (3, 2, 0))}


def frame():
    return [add(curve, name) for name, curve in FRAME.items()]


MADE = {
    'loft': lambda: make('loft', *circles()),
    'sweep': lambda: make('sweep', add(FRAME['front'], "rail"), add(CIRCLE, "section")),
    'two_rails': lambda: make('two_rails', *(add(FRAME[name], name) for name in ('left', 'right', 'front', 'back'))),
    'pipe': lambda: make('pipe', add(FRAME['front'], "rail"), caps='round'),
    'network': lambda: make('network', *frame()),
    'filling': lambda: make('filling', *frame()),
}


@pytest.mark.parametrize('kind', MADE)
def test_it_is_exact_follows_its_curves_and_stays_so_in_a_file(kind, tmp_path):
    ob = MADE[kind]()
    name, value = ob.name, ob.data.splinewright.value
    assert ob.type == 'MESH' and recipes.read(ob.data).recipe.kind == kind
    require_exact(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "skin.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "skin.blend"))
    ob = bpy.data.objects[name]
    assert ob.data.splinewright.value == value
    for source in recipes.read(ob.data).sources:
        source.location.z += 0.25
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != value and not follow.problem(ob.data)


def test_circles_in_any_order_are_a_cylinder_and_undo_brings_it_back():
    ob = MADE['loft']()
    assert names(ob) in (["low", "next", "middle", "high"], ["high", "middle", "next", "low"])
    assert np.abs(radii(ob) - 1.0).max() < 1e-6
    name, value = ob.name, ob.data.splinewright.value
    ob.data.splinewright_parameters.loft_style = 'straight'
    bpy.ops.ed.undo_push(message="style")
    assert ob.data.splinewright.value != value
    bpy.ops.ed.undo()
    assert bpy.data.objects[name].data.splinewright.value == value


def test_the_order_is_changed_one_is_left_out_and_taken_in_again():
    ob = MADE['loft']()
    before, order = ob.data.splinewright.value, names(ob)
    assert op(bpy.ops.splinewright.move_input, index=1, way='UP') == {'FINISHED'}
    assert names(ob) == [order[1], order[0], *order[2:]] and ob.data.splinewright.value != before
    assert op(bpy.ops.splinewright.move_input, index=0, way='DOWN') == {'FINISHED'}
    assert ob.data.splinewright.value == before
    assert op(bpy.ops.splinewright.remove_input, index=3) == {'FINISHED'}
    assert names(ob) == order[:3]
    bpy.data.objects[order[3]].select_set(True)
    assert op(bpy.ops.splinewright.add_inputs) == {'FINISHED'}
    assert names(ob) == order and ob.data.splinewright.value == before


@pytest.mark.parametrize('heights, new', (((0, 1, 3), 2), ((3, 1, 0), 2), ((0, 1, 2), 9), ((0, 1, 2), -4), ((5, 4, 1), 8)))
def test_what_is_added_comes_where_it_belongs(heights, new):
    rings = {z: add(line((0, 0, z), (1, 0, z), (2, 1, z)), f"at {z}") for z in (*heights, new)}
    ob = make('loft', *(rings[z] for z in heights))
    if names(ob) != [f"at {z}" for z in heights]:
        assert op(bpy.ops.splinewright.reverse_inputs) == {'FINISHED'}
    rings[new].select_set(True)
    assert op(bpy.ops.splinewright.add_inputs) == {'FINISHED'}
    assert names(ob) == [f"at {z}" for z in sorted((*heights, new), reverse=heights[0] > heights[-1])]


def test_sorting_and_reversing_the_order():
    ob = MADE['loft']()
    order = names(ob)
    assert op(bpy.ops.splinewright.reverse_inputs) == {'FINISHED'} and names(ob) == order[::-1]
    assert op(bpy.ops.splinewright.move_input, index=1, way='UP') == {'FINISHED'}
    assert op(bpy.ops.splinewright.sort_inputs) == {'FINISHED'} and names(ob) in (order, order[::-1])


def test_an_order_of_ones_own_stays_where_one_is_added():
    sections = part('core.surfaces.sections')
    assert sections.with_new([0, 1, 2, 3], 4) == [0, 1, 2, 3]
    assert [n for n in sections.with_new([2, 0, 3, 1], 3) if n < 3] == [0, 1, 2]
    for seed in range(1000):
        random = np.random.default_rng(seed)
        count = int(random.integers(2, 12))
        order, old = random.permutation(count).tolist(), int(random.integers(1, count + 1))
        found = sections.with_new(order, old)
        assert sorted(found) == list(range(count)) and [n for n in found if n < old] in (
            list(range(old)), [n for n in order if n < old], [n for n in order[::-1] if n < old])


def test_open_and_closed_sections_together_are_refused_by_name():
    circle = sc.conics.circle((0, 0, 0), 1.0)
    both = [add(line((0, 0, 2), (1, 0, 2), (2, 1, 2)), "the open one"), add(circle, "the closed one")]
    with pytest.raises(RuntimeError, match="the closed one is closed and the open one is open"):
        make('loft', *both)


def test_a_section_that_is_turned_twists_the_surface():
    ob = make('loft', *(add(line((0, 0, z), (1, 0, z), (2, 1, z)), f"{z}") for z in (0.0, 1.0, 2.0)))
    before = ob.data.splinewright.value
    assert op(bpy.ops.splinewright.turn_input, index=1) == {'FINISHED'}
    assert recipes.read(ob.data).turned == (False, True, False) and ob.data.splinewright.value != before
    seen = sections_overlay.shown(ob)
    assert [one.number for one in seen] == [1, 2, 3]
    assert np.allclose(seen[1].foot, (2, 1, 1)) and np.allclose(seen[0].foot[:2], (0, 0))
    assert op(bpy.ops.splinewright.turn_input, index=1) == {'FINISHED'}
    assert ob.data.splinewright.value == before


@pytest.mark.parametrize('name, settings, message', (
    ('move_input', {'index': 0, 'way': 'UP'}, "first one"), ('move_input', {'index': 3, 'way': 'DOWN'}, "last one"),
    ('turn_input', {'index': 4}, "none of number 5"), ('remove_input', {'index': 9}, "none of number 10"),
    ('add_inputs', {}, "select others beside it")))
def test_what_the_list_cannot_do_is_said_and_changes_nothing(name, settings, message):
    ob = MADE['loft']()
    activate(ob)
    before = names(ob), ob.data.splinewright.value
    with pytest.raises(RuntimeError, match=message):
        op(getattr(bpy.ops.splinewright, name), **settings)
    assert (names(ob), ob.data.splinewright.value) == before


def test_a_surface_needs_the_curves_that_it_is_left_with():
    ob = make('loft', *(circles()[:2]))
    with pytest.raises(RuntimeError, match="one curve and more curves"):
        op(bpy.ops.splinewright.remove_input, index=0)
    assert len(names(ob)) == 2


def test_a_profile_far_away_in_any_plane_is_set_upright_on_the_rail():
    """Its own x and y become the rail's: a circle becomes a tube of its radius, wherever and in whichever plane it was drawn."""
    rail = add(line((0, 0, 0), (4, 0, 0)), "rail")
    for turn in (Matrix.Identity(4), Matrix.Rotation(1.1, 4, 'Y') @ Matrix.Rotation(-0.4, 4, 'X')):
        for axis in ((0, 0, 1), (0, 1, 0), (1, 0, 0)):
            profile = add(sc.conics.circle((0, 0, 0), 0.5, axis), "profile")
            profile.matrix_world = Matrix.Translation((7, -3, 2)) @ turn @ Matrix.Scale(2.0, 4)
            bpy.context.view_layer.update()
            ob = make('sweep', rail, profile)
            points = np.array([ob.matrix_world @ vertex.co for vertex in ob.data.vertices])
            assert np.abs(np.hypot(points[:, 1], points[:, 2]) - 1.0).max() < 1e-5
            assert abs(points[:, 0].min()) < 1e-6 and abs(points[:, 0].max() - 4.0) < 1e-6


@pytest.mark.parametrize('turn', ('minimal', 'upright'))
def test_sections_that_lie_at_the_rail_are_on_the_surface(turn):
    rail = add(line((0, 0, 0), (2, 0.5, 0), (4, 0, 0)), "rail")
    value = rail.data.splinewright.value.to_nurbs()
    sections = []
    for u in value.domain[0] + np.array([0.9, 0.1]) * np.diff(value.domain):
        tangent, normal, binormal = value.frames(u)
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = np.stack([normal, binormal, tangent], 1) * 0.3, value.evaluate(u)
        sections.append(add(CIRCLE, "section"))
        sections[-1].matrix_world = Matrix(matrix)
    bpy.context.view_layer.update()
    ob = make('sweep', rail, *sections, placed='there', frame=turn, tolerance=1e-6)
    patch = ob.data.splinewright.value
    for section in sections:
        matrix = np.array(ob.matrix_world.inverted() @ section.matrix_world)
        points = CIRCLE.evaluate(np.linspace(*CIRCLE.domain, 9)) @ matrix[:3, :3].T + matrix[:3, 3]
        assert patch.nearest(points).distances.max() < 1e-5


def test_a_section_that_crosses_the_rail_twice_is_refused_where_it_lies():
    rail, ring = add(line((0, 0, 0), (2, 0.5, 0), (4, 0, 0)), "rail"), add(CIRCLE, "ring")
    ring.location = 2.0, 0.25, 0.0
    bpy.context.view_layer.update()
    before = set(bpy.data.objects)
    with pytest.raises(RuntimeError, match="crosses the rail at 2 places"):
        make('sweep', rail, ring, placed='there')
    assert set(bpy.data.objects) == before
    assert make('sweep', rail, ring, placed='upright').type == 'MESH'


def test_a_section_that_comes_back_to_one_of_two_rails_is_refused():
    rails = [add(FRAME[name], name) for name in ('left', 'right')]
    back = add(line((0, 0.4, 0.32), (0, 0.8, 0.48), (3, 1.2, 0.48)), "back")
    with pytest.raises(RuntimeError, match="crosses the rail at 2 places"):
        make('two_rails', *rails, back)


def test_rails_are_found_among_the_curves_and_the_surface_ends_on_them():
    ob = MADE['two_rails']()
    assert names(ob)[:2] == ["left", "right"]
    patch = ob.data.splinewright.value
    for name in ("left", "right", "front", "back"):
        points = FRAME[name].evaluate(np.linspace(*FRAME[name].domain, 17))
        assert patch.nearest(points).distances.max() < 1e-3


@pytest.mark.parametrize('kind', ('network', 'filling'))
def test_the_surface_has_the_curves_for_borders(kind):
    patch = MADE[kind]().data.splinewright.value
    for curve in FRAME.values():
        points = curve.evaluate(np.linspace(*curve.domain, 17))
        assert patch.nearest(points).distances.max() < 1e-3


def beside_a_hole():
    """A plane surface beside a hole, and four curves round that: two leave the plane smoothly, the far one is bent."""
    around = (line((0, 0, 0), (0, 2, 0)), line((3, 0, 1), (3, 1, 0.7), (3, 2, -1)),
              sc.BezierCurve([(0, 0, 0), (1.5, 0, 0), (3, 0, 1)]), sc.BezierCurve([(0, 2, 0), (1.5, 2, 0), (3, 2, -1)]))
    return add(sc.build.plane((-1, 0, 0), (1, 0, 0), (0, 2, 0)), "beside"), [add(curve, "curve") for curve in around]


def test_a_network_goes_on_from_a_surface_and_says_how_well():
    beside, curves = beside_a_hole()
    ob = make('network', *curves, beside)
    assert "angle" in recipes.read(ob.data).said and "to surfaces beside it" in recipes.read(ob.data).said
    patch, other = ob.data.splinewright.value, beside.data.splinewright.value
    assert part('core.surfaces.neighbors').angle_to(patch, [(other, 'u_end', 'G1')], 1e-3) < 2e-4
    apart = make('network', *curves).data.splinewright.value
    assert part('core.surfaces.neighbors').angle_to(apart, [(other, 'u_end', 'G1')], 1e-3) > 0.1


def test_a_surface_that_is_not_beside_a_network_is_refused():
    curves = frame()
    activate(*curves, add(sc.build.plane((20, 0, 0), (1, 0, 0), (0, 1, 0)), "far"))
    with pytest.raises(RuntimeError, match="has no side on which a curve lies"):
        op(bpy.ops.splinewright.add_network)


def test_a_curve_of_a_network_that_misses_the_others_is_named():
    curves = [*frame(), add(line((0, 0, 9), (1, 0, 9)), "astray")]
    activate(*curves)
    with pytest.raises(RuntimeError, match="astray meets no other curve: it comes to about 8.* of (left|right|front|back), the gap that is allowed is 0.0001"):
        op(bpy.ops.splinewright.add_network)
    assert len(bpy.data.objects) == 5


def test_borders_that_do_not_close_are_refused_with_the_gap():
    curves = frame()
    curves[0].location.x = -0.5
    bpy.context.view_layer.update()
    activate(*curves)
    with pytest.raises(RuntimeError, match="do not close: ends of left and (front|back) lie 0.5 apart"):
        op(bpy.ops.splinewright.add_filling)


@pytest.mark.parametrize('kind', ('loft', 'sweep', 'network'))
def test_one_curve_is_too_few(kind):
    activate(add(FRAME['left'], "only"))
    assert not getattr(bpy.ops.splinewright, f"add_{kind}").poll()


def test_the_distance_of_a_pipe_from_its_axis_is_its_radius():
    ob = make('pipe', add(FRAME['front'], "rail"), radius=0.25, end_radius=0.25, tolerance=1e-6)
    points = np.array([vertex.co for vertex in ob.data.vertices])
    assert np.abs(FRAME['front'].nearest(points).distances - 0.25).max() < 1e-5


# The radius of the rail -----------------------------------------------------------------------------------------------

RAIL = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0), (2, 0, 1), (4, 3, 0), (7, 2, -1), (9, 0, 0)])


def spline_of(curve, numbers):
    points = np.column_stack([numbers, np.zeros((len(numbers), 2))])
    return sc.NurbsCurve(curve.degree, curve.knots, points, curve.weights if curve.is_rational else None, curve.periodic)


def off_radius(ob, rail, radius_at):
    mantle = ob.data.splinewright.value
    v = np.linspace(*mantle.domain[1], 101)
    points = mantle.evaluate_grid(np.linspace(*mantle.domain[0], 9), v)
    return np.abs(np.linalg.norm(points - rail.evaluate(v)[None], axis=-1) - radius_at(v)).max()


def thicker(number, factor):
    """Alt+S on one point of the active shape."""
    held = enter()
    select(held, number)
    assert op(bpy.ops.splinewright.radius_here, factor=factor) == {'FINISHED'}


def test_a_pipe_is_as_thick_as_the_points_of_its_curve_say_and_follows_alt_s():
    rail = add(RAIL, "rail")
    ob = make('pipe', rail, radius=0.2, end_radius=0.2, tolerance=1e-6, own_radius=True)
    assert off_radius(ob, RAIL, lambda v: 0.2) < 1e-5
    activate(rail)
    thicker(2, 3.0)
    wanted = spline_of(RAIL, [1, 1, 3, 1, 1])
    assert off_radius(ob, RAIL, lambda v: 0.2 * wanted.evaluate(v)[:, 0]) < 1e-5, "before the net is left"
    leave()
    numbers = ob.data.splinewright_parameters
    numbers.pipe_end_radius = 0.4
    ends = ob.data.splinewright.value
    assert np.linalg.norm(ends.evaluate(0.0, 2.0) - RAIL.evaluate(2.0)) == pytest.approx(0.4, abs=1e-5)
    numbers.pipe_end_radius, numbers.pipe_own_radius = 0.2, False
    assert off_radius(ob, RAIL, lambda v: 0.2) < 1e-5


def test_undo_takes_the_radius_back():
    rail = add(RAIL, "rail")
    make('pipe', rail, radius=0.2, end_radius=0.2, tolerance=1e-5, own_radius=True)
    activate(rail)
    bpy.ops.ed.undo_push(message="rail")
    thicker(1, 2.0)
    name = next(ob.name for ob in bpy.data.objects if ob.data.splinewright.value != RAIL and ob.type == 'MESH')
    thick = bpy.data.objects[name].data.splinewright.value
    bpy.ops.ed.undo()
    assert bpy.data.objects[name].data.splinewright.value != thick
    bpy.ops.ed.redo()
    assert bpy.data.objects[name].data.splinewright.value == thick


def test_the_radius_of_a_chain_goes_from_joint_to_joint():
    chain = sc.HermiteCurve([(0, 0, 0), (3, 1, 0), (6, 0, 1), (9, 2, 0)], [(3, 2, 0)] * 4)
    rail = add(chain, "rail")
    ob = make('pipe', rail, radius=0.1, end_radius=0.1, tolerance=1e-6, own_radius=True)
    activate(rail)
    thicker(4, 2.0)                      # the second joint
    mantle = ob.data.splinewright.value
    v = np.linspace(*chain.domain, 4)
    found = np.linalg.norm(mantle.evaluate(np.zeros(4), v) - chain.evaluate(v), axis=1)
    assert np.allclose(found, [0.1, 0.2, 0.1, 0.1], atol=1e-4)
    assert off_radius(ob, chain, lambda v: 0.15) < 0.0501, "it nowhere overshoots"
    leave()


@pytest.mark.parametrize('kind', ('nurbs', 'periodic', 'rational cubic', 'cubic', 'hermite', 'closed hermite', 'uniform', 'circle'))
def test_curves_of_every_kind_give_their_radius(kind):
    """All points alike change all of it, one point nothing beyond what points have."""
    rail = add(value_of(kind), "rail")
    ob = make('pipe', rail, radius=0.02, end_radius=0.02, tolerance=1e-5, own_radius=True)
    axis = rail.data.splinewright.value.to_nurbs()
    assert off_radius(ob, axis, lambda v: 0.02) < 1e-4
    activate(rail)
    held = enter()
    bpy.ops.curve.select_all(action='SELECT')
    assert op(bpy.ops.splinewright.radius_here, factor=2.0) == {'FINISHED'}
    assert off_radius(ob, axis, lambda v: 0.04) < 1e-4
    select(held, 1 if held.data.splines[0].type != 'BEZIER' else 4)
    assert op(bpy.ops.splinewright.radius_here, factor=1.5) == {'FINISHED'}
    leave()
    assert not follow.problem(ob.data)
    assert 0.003 < off_radius(ob, axis, lambda v: 0.04) < 0.0201


def test_curves_of_blender_have_a_radius_too():
    bpy.ops.curve.primitive_nurbs_path_add()
    rail = bpy.context.object
    for i, point in enumerate(rail.data.splines[0].points):
        point.radius = 1 + i
    ob = make('pipe', rail, radius=0.1, end_radius=0.1, own_radius=True)
    points = np.array([vertex.co for vertex in ob.data.vertices])
    assert np.hypot(points[:, 1], points[:, 2]).max() == pytest.approx(0.5, abs=1e-3)
    rail.data.splines[0].points[4].radius = 10.0
    rail.data.update_tag()
    bpy.context.view_layer.update()
    points = np.array([vertex.co for vertex in ob.data.vertices])
    assert np.hypot(points[:, 1], points[:, 2]).max() == pytest.approx(1.0, abs=1e-3)
    assert not part('bridge.follow.recipe_results').not_followed_by(ob.data, [rail])
    ob.data.splinewright_parameters.pipe_own_radius = False
    assert part('bridge.follow.recipe_results').not_followed_by(ob.data, [rail]) == ["the radius"]


def test_sections_of_a_sweep_are_as_large_as_the_rail_says():
    rail, section = add(RAIL, "rail"), add(sc.conics.circle((0, 0, 0), 0.2), "section")
    ob = make('sweep', rail, section, own_radius=True, tolerance=1e-6)
    activate(rail)
    thicker(4, 2.0)
    leave()
    wanted = spline_of(RAIL, [1, 1, 1, 1, 2])
    assert off_radius(ob, RAIL, lambda v: 0.2 * wanted.evaluate(v)[:, 0]) < 1e-5
    activate(ob)
    bpy.ops.splinewright.turn_input(index=0)
    assert off_radius(ob, RAIL.reversed(), lambda v: 0.2 * wanted.reversed().evaluate(v)[:, 0]) < 1e-5


def test_what_has_no_one_radius_is_refused_with_a_word():
    rail = add([RAIL, RAIL.transformed(np.c_[np.eye(3), [0, 0, 5]])], "rails")
    activate(rail)
    with pytest.raises(RuntimeError, match="2 curves"):
        op(bpy.ops.splinewright.add_pipe, own_radius=True)


def test_curves_of_blender_are_sections_too_and_a_deleted_one_leaves_the_surface_as_it_was():
    found = []
    for height in (0.0, 1.0):
        bpy.ops.curve.primitive_nurbs_circle_add(location=(0, 0, height))
        found.append(bpy.context.object)
    ob = make('loft', *found)
    before = ob.data.splinewright.value
    bpy.data.objects.remove(found[1])
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value == before and "deleted" in follow.problem(ob.data)


def test_what_crosses_itself_is_made_told_of_in_the_report_and_kept_for_the_panel(tmp_path):
    rail = add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]), "rail")
    ob = make('pipe', rail, radius=0.9)
    assert "the curve bends with a radius of 0.375 at u = 0.5: the surface folds there" in recipes.read(ob.data).warning
    group = ob.data.splinewright_parameters
    group.pipe_radius = group.pipe_end_radius = 0.1
    assert recipes.read(ob.data).warning == ""
    group.pipe_radius = group.pipe_end_radius = 0.5
    name = ob.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "folds.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "folds.blend"))
    ob = bpy.data.objects[name]
    assert "folds there" in recipes.read(ob.data).warning
    rail = recipes.read(ob.data).sources[0]
    rail.data.splinewright.value = line((0, 0, 0), (3, 0, 0.1), (6, 0, 0))
    bpy.context.view_layer.update()
    assert recipes.read(ob.data).warning == ""


def test_revolved_and_extruded_profiles_that_cross_are_told_of():
    across = add(line((-1, 0, 0), (1, 1, 0), (2, 3, 0)), "across")
    assert "crosses the axis at u = 0.2192" in recipes.read(make('revolve', across, axis='y').data).warning
    loop = add(line((0, 0, 0), (2, 2, 0), (2, 0, 0), (0, 2, 0)), "loop")
    assert "the curve crosses itself at u = 0.05904" in recipes.read(make('extrude', loop).data).warning
