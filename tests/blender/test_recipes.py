"""Recipes: their numbers stay what one edits, in the panel, by the net, for ever."""

import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from layouts import sidebar
from shapes import VALUES, activate, add, enter, leave, move, numbers_of, op, require_exact, select, shown
from support import curve_points, part, splinecore as sc

definitions, made, selection, recipes, shape, store, table = (part(name) for name in (
    'core.shape.definition', 'bridge.shape.recipe_edit', 'bridge.net.selection', 'bridge.recipes.recipes', 'bridge.shape.shape',
    'bridge.data.store', 'core.recipes.table'))
RECIPES = {recipe.kind: recipe for recipe in table.STARTING}
WITH_POINTS = [kind for kind, recipe in RECIPES.items() if recipe.points]


def add_recipe(kind, **numbers):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **numbers) == {'FINISHED'}
    bpy.ops.ed.undo_push(message="add")
    return bpy.context.object


def numbers(ob):
    return ob.data.splinewright_parameters


@pytest.mark.parametrize('kind', RECIPES)
def test_what_a_recipe_adds_is_what_its_numbers_say_and_stays_so_in_a_file(kind, tmp_path):
    ob = add_recipe(kind)
    recipe = RECIPES[kind]
    made = recipe.make(recipe.start_for(recipe.defaults), **recipe.defaults).definition
    assert ob.data.splinewright.value == definitions.to_value(made)
    assert [piece.name for piece in store.read(ob.data).pieces] == [piece.name for piece in made.pieces]
    require_exact(ob)
    value, name = ob.data.splinewright.value, ob.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "recipe.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "recipe.blend"))
    ob = bpy.data.objects[name]
    assert recipes.kind(ob.data) == kind and ob.data.splinewright.value == value
    assert recipes.parameters(ob.data) == recipe.defaults


OTHER = {'conic': ('weight', 2.0), 'ellipse': ('form', 'halves'), 'foci': ('distance', 1.5), 'circle': ('radius', 3.0),
         'arc': ('sweep', 3.0), 'catmull_rom': ('closed', True), 'interpolating': ('degree', 2), 'approximating': ('degree', 2), 'kochanek_bartels': ('bias', 0.5),
         'polynomial': ('parametrisation', 'uniform'), 'helix': ('turns', -2.0), 'formula': ('y', 't^2'),
         'equation': ('c', -4.0), 'osculating': ('derivatives', 2)}


@pytest.mark.parametrize('kind', OTHER)
def test_a_number_is_changed_in_the_panel_and_the_change_undone(kind):
    ob = add_recipe(kind)
    before, (name, value) = ob.data.splinewright.value, OTHER[kind]
    setattr(numbers(ob), f"{kind}_{name}", value)
    assert getattr(numbers(ob), f"{kind}_{name}") == value and recipes.parameters(ob.data)[name] == value
    after, object_name = ob.data.splinewright.value, ob.name
    assert after != before
    require_exact(ob)
    bpy.ops.ed.undo_push(message="number")
    bpy.ops.ed.undo()
    assert bpy.data.objects[object_name].data.splinewright.value == before
    bpy.ops.ed.redo()
    assert bpy.data.objects[object_name].data.splinewright.value == after


def test_a_typed_number_has_its_digits_in_double_precision():
    ob = add_recipe('circle')
    numbers(ob).circle_radius = 0.1
    assert recipes.parameters(ob.data)['radius'] == 0.1
    ob = add_recipe('circle', radius=0.3)
    assert ob.data.splinewright.value == sc.conics.circle((0, 0, 0), 0.3)


@pytest.mark.parametrize('kind, name, value, word', (
    ('formula', 'x', "cos(3*t", "character"), ('formula', 'x', "foo(t)", "unknown name 'foo'"),
    ('formula', 'y', "1/(t - 1)", "t = "), ('formula', 'end', 0.0, "not above"),
    ('formula', 'x', "__import__('os')", "character"), ('formula', 'constants', "a 2", "no constant"),
    ('formula', 'constants', "a = b", "unknown name 'b'"), ('formula', 'constants', "2a = 1", "is no name"),
    ('formula', 'constants', "sin = 1", "name of a function"), ('formula', 'constants', "a = 1/0", "no finite value"),
    ('circle', 'radius', 0.0, "radius"), ('helix', 'turns', 0.0, "turns"),
    ('equation', 'f', 1.0, "no real point")))
def test_a_number_of_which_nothing_comes_is_refused_with_a_word_and_nothing_changes(kind, name, value, word):
    ob = add_recipe(kind)
    before, points = ob.data.splinewright.value, shown(ob).copy()
    setattr(numbers(ob), f"{kind}_{name}", value)
    assert word in ob.data.splinewright.problem
    assert ob.data.splinewright.value == before and np.array_equal(shown(ob), points)
    assert recipes.parameters(ob.data) == RECIPES[kind].defaults
    with pytest.raises(RuntimeError, match="(?s)" + word.replace("(", r"\(")):
        add_recipe(kind, **{name: value})


@pytest.mark.parametrize('kind', WITH_POINTS)
def test_the_net_of_a_recipe_is_its_points_and_the_shape_follows(kind):
    ob = add_recipe(kind)
    before, points, name = ob.data.splinewright.value, recipes.points(ob.data), ob.name
    held = enter()
    assert len(numbers_of(held).rows) == len(points)
    select(held, 1)
    move(0.25, 0.125, 0)
    moved = bpy.data.objects[name]
    expected = points.copy()
    expected[1] += (0.25, 0.125, 0)
    assert np.allclose(recipes.points(moved.data), expected, atol=1e-7)
    assert np.array_equal(recipes.points(moved.data)[[0, *range(2, len(points))]], points[[0, *range(2, len(points))]])
    assert moved.data.splinewright.value != before
    require_exact(moved)
    bpy.ops.ed.undo()
    assert bpy.data.objects[name].data.splinewright.value == before
    bpy.ops.ed.redo()
    leave()
    ob = bpy.data.objects[name]
    assert bpy.context.object == ob and recipes.kind(ob.data) == kind and ob.data.splinewright.value != before


def test_points_of_which_nothing_comes_leave_the_last_good_shape_and_say_why():
    ob = add_recipe('five_points')
    before = ob.data.splinewright.value
    held = enter()
    start = recipes.points(ob.data)
    select(held, 1)
    move(*(start[0] - start[1]))
    assert part('bridge.net.live').problem(held)
    assert bpy.data.objects[ob.name].data.splinewright.value == before
    select(held, 1)
    move(0.01, 0.6, 0)
    assert not part('bridge.net.live').problem(held)
    assert bpy.data.objects[ob.name].data.splinewright.value != before


def test_recipes_of_numbers_alone_have_no_net_and_say_so():
    for kind in set(RECIPES) - set(WITH_POINTS):
        add_recipe(kind)
        assert not bpy.ops.splinewright.edit_net.poll()
        assert "in the panel" in part('ui.editing').why_not(bpy.context.object)


def test_the_weight_of_a_conic_goes_through_all_its_classes_without_a_stray_line():
    ob = add_recipe('conic')
    ob.data.splinewright.reach = 5.0
    counts = {}
    for weight in np.linspace(-3, 3, 61):
        numbers(ob).conic_weight = weight
        points = shown(ob)
        assert np.abs(points).max() <= 6.001, weight
        for spline in ob.data.splines:
            line = np.array([point.co[:3] for point in spline.points])
            assert np.linalg.norm(np.diff(line, axis=0), axis=1).max() < 6.0, weight
        counts[round(float(weight), 2)] = len(ob.data.splines)
    assert (counts[-3.0], counts[-1.0], counts[-0.5], counts[0.5], counts[1.0], counts[3.0]) == (3, 2, 1, 1, 1, 1)


def test_reach_says_how_far_a_curve_that_runs_to_infinity_is_shown():
    ob = add(sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -2, 1]))
    farthest = []
    for reach in (1.0, 10.0, 1000.0):
        ob.data.splinewright.reach = reach
        require_exact(ob)
        farthest.append(np.abs(shown(ob)).max())
        assert len(ob.data.splines) == 3
    assert np.allclose(farthest, (2, 11, 1001), rtol=1e-3)


def test_make_editable_drops_the_recipe_and_keeps_every_digit():
    ob = add_recipe('catmull_rom')
    value = ob.data.splinewright.value
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    assert not recipes.has(ob.data) and ob.data.splinewright.value == value
    held = enter()
    assert len(numbers_of(held).rows) == 3 * len(value.points)


def test_what_would_be_lost_at_the_next_change_is_refused_with_a_word():
    ob, other = add_recipe('catmull_rom'), add(VALUES['nurbs']())
    activate(ob, other)
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.join)
    activate(ob)
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.apply_transform)
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.set_knots, knots="0 1")
    value = ob.data.splinewright.value
    with pytest.raises(ValueError, match="made by a recipe"):
        ob.data.splinewright.value = VALUES['nurbs']()
    assert ob.data.splinewright.value == value


def test_a_copy_has_a_recipe_of_its_own_and_a_follower_follows_it():
    ob = add_recipe('helix')
    op(bpy.ops.object.duplicate)
    copy = bpy.context.object
    numbers(copy).helix_turns = 1.0
    assert numbers(ob).helix_turns == 3.0 and ob.data.splinewright.value != copy.data.splinewright.value
    op(bpy.ops.splinewright.follow_object)
    follower = bpy.context.object
    numbers(copy).helix_height = 5.0
    bpy.context.view_layer.update()
    assert follower.data.splinewright.value == copy.data.splinewright.value


def test_more_points_lie_on_runges_curve_where_the_polynomial_oscillates_and_a_spline_does_not():
    polynomial, spline = (add_recipe(kind, count=15, parametrisation='uniform') for kind in ('polynomial', 'catmull_rom'))
    at = np.linspace(-1, 1, 15)
    assert np.allclose(recipes.points(polynomial.data)[:, 1], 1 / (1 + 25 * at ** 2))
    assert shown(polynomial)[:, 1].max() > 5 and np.abs(shown(spline)[:, 1] - 0.5).max() < 0.6


def test_a_recipe_of_a_newer_version_is_shown_and_read_only_with_a_word():
    ob = add_recipe('conic')
    value = ob.data.splinewright.value
    ob.data[recipes.KEY]['kind'] = "clothoid"
    with pytest.raises(store.UnreadableDefinition, match="newer Splinewright"):
        recipes.of(ob.data)
    numbers(ob).conic_weight = 3.0
    assert ob.data.splinewright.value == value
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}


def test_angles_are_angles_and_a_quarter_is_a_quarter():
    ob = add_recipe('arc', sweep=math.pi)
    assert np.allclose(shown(ob)[-1], (-1, 0, 0), atol=1e-6)
    assert recipes.parameters(add_recipe('arc', sweep=math.pi / 2).data)['sweep'] == math.pi / 2


def test_the_curve_of_an_equation_lies_on_it():
    numbers_of = {'a': 2.0, 'b': 1.0, 'c': -1.5, 'd': 0.5, 'e': -1.0, 'f': 3.0}
    ob = add_recipe('equation', **numbers_of)
    for curve in ob.data.splinewright.value:
        for points, _ in curve.polylines(32, 20.0):
            x, y, z = points.T
            terms = np.array([2 * x * x, x * y, -1.5 * y * y, 0.5 * x, -y, 3 + 0 * x])
            assert (abs(terms.sum(axis=0)) <= 1e-12 * abs(terms).sum(axis=0)).all() and not z.any()


def test_an_osculating_polynomial_has_the_derivatives_of_its_net():
    ob = add_recipe('osculating', derivatives=2)
    curve, rows = ob.data.splinewright.value, recipes.points(ob.data)
    assert curve.degree == 5
    for u, (point, first, second) in zip((0.0, 1.0), rows.reshape(2, 3, 3)):
        found = curve.derivatives(u, 2, side='left' if u else 'right')
        assert np.allclose(found, [point, first - point, second - point], atol=1e-12)


def test_constants_have_names_of_their_own():
    ob = add_recipe('formula', x="a*t", y="b*t^2", constants="a = 2, b = a*pi", start=0.0, end=1.0)
    assert np.allclose(ob.data.splinewright.value.evaluate([0.5]), [(1.0, np.pi / 2, 0.0)], atol=1e-15)


@pytest.mark.parametrize('derivatives', range(1, 6))
def test_osculating_polynomials_of_every_order_can_be_added(derivatives):
    ob = add_recipe('osculating', derivatives=derivatives)
    groups = len(recipes.points(ob.data)) // (derivatives + 1)
    assert ob.data.splinewright.value.degree == groups * (derivatives + 1) - 1
    before = ob.data.splinewright.value
    numbers(ob).osculating_derivatives = 4 if derivatives != 4 else 3
    assert "groups of" in ob.data.splinewright.problem and ob.data.splinewright.value == before


def test_a_polynomial_that_would_miss_its_points_is_refused_and_a_small_miss_is_said():
    with pytest.raises(RuntimeError, match="too many for one polynomial"):
        add_recipe('polynomial', count=100, parametrisation='uniform')
    ob = add_recipe('polynomial', count=50, parametrisation='uniform')
    error = recipes.error(ob.data)
    parameters = np.linspace(0, 1, 50)
    missed = np.linalg.norm(ob.data.splinewright.value.evaluate(parameters) - recipes.points(ob.data), axis=1).max()
    assert 0 < error < 1e-3 and error == missed


def test_a_spline_through_the_same_points_goes_along_with_the_polynomial():
    ob = add_recipe('polynomial', count=11, parametrisation='uniform', spline=True)
    polynomial, spline = ob.data.splinewright.value
    points, at = recipes.points(ob.data), np.linspace(0, 1, 11)
    assert np.allclose(spline.evaluate(at), points, atol=1e-14) and np.allclose(polynomial.evaluate(at), points, atol=1e-12)


@pytest.mark.parametrize('typed', (2 * math.pi, -2 * math.pi, math.radians(90), math.radians(37), 1.0))
def test_an_angle_is_the_one_that_was_typed_in_degrees_or_radians(typed):
    ob = add_recipe('arc')
    numbers(ob).arc_sweep = typed
    assert ob.data.splinewright.problem == "" and recipes.parameters(ob.data)['sweep'] == typed


def farthest_from(ob, points):
    low, high = points.min(axis=0), points.max(axis=0)
    drawn = shown(ob).astype(float)
    return np.maximum(low - drawn, drawn - high).max()


@pytest.mark.parametrize('weight', (-1.0, -0.9999999, -1.0000001, -0.99, -1.01, -10.0, 0.0, 10.0))
def test_no_weight_of_a_conic_draws_farther_than_the_reach(weight):
    ob = add_recipe('conic', weight=weight)
    points = recipes.points(ob.data)
    assert farthest_from(ob, points) <= 10 * (1 + 1e-6)
    for spline in ob.data.splines:
        drawn = curve_points(spline)
        assert np.linalg.norm(np.diff(drawn, axis=0), axis=1).max() < 25


@pytest.mark.parametrize('k', (0.0, 0.1, 1e-2, 1e-4))
def test_a_conic_through_five_points_is_drawn_through_them_however_far_it_runs(k):
    x = np.array([-2.0, -1.0, 0.0, 1.0, 3.0])
    ob = add_recipe('five_points')
    rows = np.column_stack([x, x * x + k * x ** 3, 0 * x])
    ob.data.splinewright.resolution_u = 1024
    part('bridge.shape.recipe_edit').set_points(ob.data, rows)
    drawn = shown(ob).astype(float)
    assert farthest_from(ob, rows) <= 10 * (1 + 1e-6)
    for row in rows:
        assert np.linalg.norm(drawn - row, axis=1).min() < 0.1
    require_exact(ob)


@pytest.mark.parametrize('kind, settings', (
    ('foci', {'size': 20.0, 'distance': 30.0}), ('equation', {'a': 1.0, 'c': -0.04, 'f': -9.0}),
    ('equation', {'a': 1.0, 'c': -1.0, 'f': -400.0}), ('hyperbola', {'size': 1000.0})))
def test_hyperbolas_of_any_size_are_shown_around_their_vertices(kind, settings):
    ob = add_recipe(kind, **settings)
    assert len(ob.data.splines) == 2
    for curve, spline in zip(ob.data.splinewright.value, ob.data.splines):
        assert np.linalg.norm(curve_points(spline) - curve.points[2], axis=1).min() < 1e-3 * max(1, abs(curve.points[2]).max())


def test_a_damaged_recipe_is_said_and_read_only():
    ob = add_recipe('circle')
    value = ob.data.splinewright.value
    ob.data[recipes.KEY]['parameters']['radius'] = "wide"
    assert numbers(ob).circle_radius == RECIPES['circle'].defaults['radius']
    numbers(ob).circle_radius = 2.0
    assert "damaged" in ob.data.splinewright.problem and ob.data.splinewright.value == value


def test_a_constant_may_hold_a_comma():
    ob = add_recipe('formula', x="a*t", y="0", z="0", constants="a = atan2(1, 2), b = 2", start=0.0, end=1.0)
    assert np.allclose(ob.data.splinewright.value.evaluate([1.0], side='left'), [(math.atan2(1, 2), 0, 0)])


@pytest.mark.parametrize('kind', ('ellipse', 'hyperbola'))
def test_half_axes_are_those_of_the_points_and_can_be_typed(kind):
    ob = add_recipe(kind)
    before = recipes.points(ob.data)
    lengths = [f"{kind}_length_{i}" for i in range(2)]
    assert [getattr(numbers(ob), name) for name in lengths] == pytest.approx(np.linalg.norm(before[1:] - before[0], axis=1))
    setattr(numbers(ob), lengths[1], 0.3)
    setattr(numbers(ob), lengths[0], 2.1)
    assert np.abs(recipes.points(ob.data) - [(0, 0, 0), (2.1, 0, 0), (0, 0.3, 0)]).max() <= 4e-16
    require_exact(ob)
    setattr(numbers(ob), lengths[0], 0.0)
    assert np.linalg.norm(recipes.points(ob.data)[1]) == pytest.approx(2.1), "nothing comes of it, and nothing changes"
    other = add_recipe('circle')
    assert getattr(numbers(other), lengths[0]) == 0.0


def test_an_ellipse_that_is_drawn_anywhere_keeps_its_directions():
    ob = add_recipe('ellipse')
    made.set_points(ob.data, np.array([(1, 2, 3), (1, 4, 3), (1, 2, 2.5)]))
    assert numbers(ob).ellipse_length_0 == 2.0 and numbers(ob).ellipse_length_1 == 0.5
    numbers(ob).ellipse_length_0 = 3.0
    assert np.array_equal(recipes.points(ob.data), [(1, 2, 3), (1, 5, 3), (1, 2, 2.5)])


@pytest.mark.parametrize('kind, name, value, hidden', (
    ('ellipse', 'form', 'deformable', 'tolerance'), ('circle', 'form', 'deformable', 'tolerance'), ('sphere', 'deformable', True, 'tolerance'),
    ('contour', 'corners', 'cut', 'corner_size'), ('approximating', 'by', 'count', 'control_points'), ('interpolating', 'closed', False, 'knots')))
def test_what_does_not_count_is_not_shown(kind, name, value, hidden):
    """In the panel and in that of the last operator."""
    recipe = part('core.recipes.table').RECIPES[kind]
    given = {parameter.name: parameter for parameter in recipe.parameters}
    others = {'form': 'square', 'deformable': False, 'corners': 'sharp', 'by': 'tolerance', 'closed': True}
    for now, is_shown in ((value, True), (others[name], False)):
        shown = recipe.counting(SimpleNamespace(**{**recipe.defaults, name: now}))
        assert (given[hidden] in shown) == is_shown
        data = add_recipe(kind, **{name: now}).data
        drawn = sidebar(bpy.context)
        assert (f"{kind}_{hidden}" in drawn.props) == is_shown, drawn.props
