"""Graphs of basis functions as shapes: their names, materials and thickness, live on knots, saved, and refused in words."""

import bpy
import numpy as np
import pytest

from shapes import activate, add, require_exact
from support import part, splinecore as sc

functions, piece_materials, store = (part(name) for name in (
    'core.formulas.functions', 'bridge.shape.piece_materials', 'bridge.data.store'))


def names_of(ob):
    return [piece.name for piece in store.read(ob.data).pieces]


def slots_of(ob):
    return [spline.material_index for spline in ob.data.splines]


def added(**settings):
    assert bpy.ops.splinewright.add_functions('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


def test_each_function_has_its_name_material_and_color():
    ob = added(degree=0, knot_values="0 1 2 3 4 5")
    names = [f"N_{{{i},0}}" for i in range(5)] + [functions.AXIS] * 2 + [f"{functions.TICK} {number}" for number in (0, 1, 2, 3, 4, 5, 1)]
    assert names_of(ob) == names and slots_of(ob) == [3, 4, 5, 6, 7] + [0] * 9
    colors = [material.diffuse_color[:3] for material in ob.data.materials]
    assert len(colors) == 8 and len({tuple(color) for color in colors}) == 8
    assert ob.data.bevel_depth > 0
    require_exact(ob)


@pytest.mark.parametrize('family', ('bspline', 'bernstein', 'hermite', 'lagrange', 'natural'))
@pytest.mark.parametrize('show', ('functions', 'sum', 'stacked'))
def test_every_family_is_made_as_it_is_said(family, show):
    ob = added(family=family, degree=3, knot_values="0 1 2 4 5 6", show=show, width=3.0, height=0.5)
    points = np.array([point.co[:3] for spline in ob.data.splines for point in spline.points])
    assert points[:, 0].max() == pytest.approx(3.0, abs=1e-6) and not points[:, 2].any()
    assert (functions.SUM in names_of(ob)) == (show == 'sum')
    require_exact(ob)


def test_they_follow_other_numbers_and_materials_of_the_user_stay():
    ob = added(degree=1, knot_values="0 1 2 3", axes=False)
    mine = bpy.data.materials.new("mine")
    ob.data.materials[3] = mine
    ob.data.splinewright_parameters.functions_knot_values = "0 1 2 3 4 5"
    bpy.context.view_layer.update()
    assert len(names_of(ob)) == 4 and slots_of(ob) == [3, 4, 5, 6] and ob.data.materials[3] == mine
    ob.data.splinewright_parameters.functions_degree = 2
    bpy.context.view_layer.update()
    assert names_of(ob) == [f"N_{{{i},2}}" for i in range(3)] and slots_of(ob) == [3, 4, 5]


def test_what_a_user_gave_a_spline_stays_while_its_name_does():
    ob = added(degree=1, knot_values="0 1 2 3", axes=False)
    ob.data.splines[0].material_index = 4
    ob.data.splinewright_parameters.functions_height = 2.0
    bpy.context.view_layer.update()
    assert slots_of(ob) == [4, 4]


def test_those_of_a_curve_follow_its_knots():
    source = add(sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], np.array([(0, 0, 0), (1, 2, 0), (2, 0, 0), (3, 1, 0)], float)), "curve")
    activate(source)
    assert bpy.ops.splinewright.add_basis('EXEC_DEFAULT', True, show='stacked') == {'FINISHED'}
    ob = bpy.context.object
    assert names_of(ob)[:4] == [f"N_{{{i},2}}" for i in range(4)]
    source.data.splinewright.value = source.data.splinewright.value.insert_knot(0.5)
    bpy.context.view_layer.update()
    assert names_of(ob)[:5] == [f"N_{{{i},2}}" for i in range(5)] and slots_of(ob)[:5] == [3, 4, 5, 6, 7]
    require_exact(ob)


@pytest.mark.parametrize('value, names', (
    (lambda: sc.BezierCurve(np.eye(3)), [f"B_{{{i},2}}" for i in range(3)]),
    (lambda: sc.HermiteCurve(np.eye(3)[:2], np.eye(3)[:2]), ["H_{0}", "H_{2}", "H_{1}", "H_{3}"])))
def test_they_are_of_the_kind_of_the_curve(value, names):
    activate(add(value(), "curve"))
    bpy.ops.splinewright.add_basis('EXEC_DEFAULT', True, axes=False)
    assert names_of(bpy.context.object) == names


def test_the_domain_is_marked_and_its_absence_told(capfd):
    ob = added(family='bspline', degree=2, knot_values="0 1 2 3 4 5", axes=False, domain=True)
    assert names_of(ob) == [f"N_{{{i},2}}" for i in range(3)] + [functions.DOMAIN] * 4 and slots_of(ob) == [3, 4, 5, 2, 2, 2, 2]
    require_exact(ob)
    capfd.readouterr()
    assert functions.DOMAIN not in names_of(added(family='bspline', degree=2, knot_values="0 1 2 3", domain=True))
    assert "there is no domain" in capfd.readouterr().out


def test_names_are_saved(tmp_path):
    ob = added(degree=2, knot_values="0 1 2 3 4")
    names, slots = names_of(ob), slots_of(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "functions.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "functions.blend"))
    ob = next(each for each in bpy.data.objects if each.type == 'CURVE')
    assert names_of(ob) == names and slots_of(ob) == slots


def test_functions_that_are_zero_are_named_and_bad_knots_refused(capfd):
    added(degree=0, knot_values="0 1 1 2")
    assert "zero everywhere: N_{1,0}" in capfd.readouterr().out
    for knots, said in (("0 x 2", "\"x\" is not a number"), ("0 1", "at least 3"), ("3 2 1 0", "must not decrease"), ("", "at least 3")):
        with pytest.raises(RuntimeError, match=said):
            bpy.ops.splinewright.add_functions('EXEC_DEFAULT', True, degree=1, knot_values=knots)


def test_a_picture_of_before_has_no_axes():
    """A file of before says nothing of axes."""
    recipe = part('core.recipes.table').RECIPES['basis']
    assert {parameter.name: parameter.before for parameter in recipe.parameters}['axes'] is False


@pytest.mark.parametrize('first, last, wanted', ((0, 255, ["level 0", "level 1", "level 2", "point"]), (1, 1, ["level 1"]),
                                                 (2, 9, ["level 2", "point"]), (3, 3, ["point"]), (0, 0, ["level 0"])))
def test_a_construction_is_drawn_level_by_level(first, last, wanted):
    corners = np.array([(0, 0, 0), (1, 2, 0), (2, 2, 0), (3, 0, 0)], float)
    activate(add(sc.BezierCurve(corners), "curve"))
    bpy.ops.splinewright.add_construction('EXEC_DEFAULT', True, scheme='casteljau', position=0.25, first_level=first, last_level=last)
    ob = bpy.context.object
    assert names_of(ob) == wanted
    levels = [corners]
    while len(levels[-1]) > 1:
        levels.append(0.75 * levels[-1][:-1] + 0.25 * levels[-1][1:])
    value = ob.data.splinewright.value
    for name, curve in zip(wanted, value if isinstance(value, list) else [value]):
        if name != "point":
            assert np.allclose(curve.points, levels[int(name[-1])], rtol=0, atol=1e-14)
    require_exact(ob)


def test_levels_that_are_not_there_are_refused():
    activate(add(sc.BezierCurve(np.eye(3)), "curve"))
    for settings, said in (({'first_level': 3}, "levels are 0 to 2"), ({'first_level': 2, 'last_level': 1}, "none from 2 to 1"), ({'first_level': 2, 'marker': 0}, "is a point")):
        with pytest.raises(RuntimeError, match=said):
            bpy.ops.splinewright.add_construction('EXEC_DEFAULT', True, **settings)


def labels_of(ob):
    return [(f"{label.base}{label.below and '_' + label.below}{label.after}", label.point) for label in
            part('core.formulas.labels').of(store.read(ob.data))]


def test_functions_ticks_and_levels_have_their_labels():
    found = dict(labels_of(added(degree=1, knot_values="0 1 2.5", width=5.0, height=2.0)))
    assert list(found) == ["N_0,1", "0", "1", "2.5"]
    assert found["N_0,1"] == pytest.approx((2.0, 2.0, 0.0), abs=0.1) and found["2.5"][0] == 5.0
    corners = np.array([(0, 0, 0), (1, 2, 0), (2, 2, 0), (3, 0, 0)], float)
    activate(add(sc.BezierCurve(corners), "curve"))
    bpy.ops.splinewright.add_construction('EXEC_DEFAULT', True, scheme='casteljau', position=0.5)
    found = dict(labels_of(bpy.context.object))
    assert list(found) == ["P_0", "P_1", "P_2", "P_3", "M_01", "M_12", "M_23", "M_012", "M_123", "M_0123"]
    assert found["M_12"] == (1.5, 2.0, 0.0) and found["M_012"] == (1.0, 1.5, 0.0)


def test_control_points_weights_and_knots_have_their_labels():
    points = np.array([(0, 0, 0), (1, 2, 0), (2, 0, 0), (3, 1, 0), (4, 0, 0)], float)
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 2, 2, 2], points, [1, 2, 1, 1, 1])
    assert [text for text, _ in labels_of(add(curve, "curve"))] == ["P_0", "P_1  w = 2", "P_2", "P_3", "P_4", "u_3…4 = 1"]
    patch = sc.BezierPatch(np.random.default_rng(1).uniform(-1, 1, (2, 3, 3)))
    assert [text for text, _ in labels_of(add(patch, "patch"))] == [f"P_{i},{j}" for i in range(2) for j in range(3)]
    many = add(sc.NurbsCurve(1, np.arange(503.0), np.random.default_rng(1).uniform(-1, 1, (501, 3))), "many")
    assert labels_of(many) == [("1,000 names: too many to write", tuple(many.data.splinewright.value.points[0]))]


def test_labels_have_the_colors_of_materials():
    ob = added(degree=1, knot_values="0 1 2 3")
    found = piece_materials.colors_of(ob.data)
    assert found["N_{0,1}"] == pytest.approx((0.0, 0.45, 0.70, 1.0), abs=1e-6) and found["axis"] == pytest.approx((0.55, 0.55, 0.55, 1.0), abs=1e-6)
    ob.data.materials[3].diffuse_color = (1.0, 0.0, 0.0, 1.0)
    assert piece_materials.colors_of(ob.data)["N_{0,1}"] == pytest.approx((1.0, 0.0, 0.0, 1.0))


def axes_of(**settings):
    assert bpy.ops.splinewright.add_axes('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


def test_axes_have_ticks_at_multiples_of_the_step():
    ob = axes_of(x_from=-0.5, x_to=2.0, y_from=0.0, y_to=1.0, step=0.5, tick=0.1, spatial=False, grid=False)
    assert names_of(ob) == ["axis", "tick -0.5", "tick 0", "tick 0.5", "tick 1", "tick 1.5", "tick 2", "axis", "tick 0.5", "tick 1"]
    value = ob.data.splinewright.value
    assert value[0].points.tolist() == [[-0.5, 0, 0], [2, 0, 0]] and value[7].points.tolist() == [[0, 0, 0], [0, 1, 0]]
    assert value[4].points.tolist() == [[1, -0.1, 0], [1, 0, 0]] and value[8].points.tolist() == [[-0.1, 0.5, 0], [0, 0.5, 0]]
    assert set(slots_of(ob)) == {0}
    require_exact(ob)


def test_axes_in_space_and_a_grid():
    ob = axes_of(x_from=1.0, x_to=3.0, y_from=-2.0, y_to=-1.0, z_from=0.0, z_to=1.0, step=1.0, spatial=True, grid=True)
    names = names_of(ob)
    assert names.count("grid") == 5 and names.count("axis") == 3 and slots_of(ob)[:5] == [2] * 5
    starts = {tuple(curve.points[0]) for name, curve in zip(names, ob.data.splinewright.value) if name == "axis"}
    assert starts == {(1.0, -1.0, 0.0), (1.0, -2.0, 0.0), (1.0, -1.0, 0.0)}, "through the place that is nearest to the origin"


@pytest.mark.parametrize('settings, said', (({'x_from': 2.0, 'x_to': 1.0}, "x ends at 1"), ({'step': 1e-3}, "200 are the most")))
def test_axes_that_cannot_be_are_refused(settings, said):
    with pytest.raises(RuntimeError, match=said):
        axes_of(**settings)


def test_where_axes_cross_there_is_one_tick_and_never_none():
    limits = {'y_from': -1.0, 'y_to': 1.0, 'step': 1.0, 'spatial': False, 'grid': False}
    assert names_of(axes_of(x_from=0.0, x_to=1.0, **limits)).count("tick 0") == 1
    assert names_of(axes_of(x_from=0.5, x_to=1.0, **limits)).count("tick 0") == 1, "the first axis has none at 0.5"


def test_a_function_below_the_axis_has_its_label_there():
    found = dict(labels_of(added(family='hermite', knot_values="0 1", show='functions', width=1.0, height=1.0)))
    assert found["H_3"] == pytest.approx((2 / 3, -4 / 27, 0.0), abs=0.01)
