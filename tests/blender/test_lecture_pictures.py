"""Homogeneous curves, triangles, discs, orders, influence and ducks as shapes: named, labeled, colored, live, of every kind of source."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, add, made, op, pieces_named, require_exact
from support import part, splinecore as sc

labels, piece_materials, store = (part(name) for name in ('core.formulas.labels', 'bridge.shape.piece_materials', 'bridge.data.store'))
CURVES = [name for name, make in VALUES.items() if 'patch' not in name and name not in ('ferguson', 'teapot', 'mixed set')]
PLANE = np.array([(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0)], float)


def values_of(ob):
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


def labels_of(ob):
    return [f"{label.base}{label.below and '_' + label.below}{label.after}" for label in labels.of(store.read(ob.data))]


@pytest.mark.parametrize('kind, settings', (('discs', {'position': 0.3}), ('influence', {'index': 1, 'piece': 1}), ('basis_triangle', {'spans': "", 'chosen': ""})))
@pytest.mark.parametrize('name', CURVES)
def test_they_are_made_of_every_kind_of_curve(kind, settings, name):
    ob = made(kind, add(VALUES[name](), "curve"), **settings)
    assert all(pieces_named(ob)) and len(ob.data.materials) > 2
    require_exact(ob)


def test_the_homogeneous_curve_follows_weights_and_its_image_follows_it():
    source = add(sc.BezierCurve(PLANE, [1, 2, 0.5, 1]), "curve")
    ob = made('lift', source, height=1.0, base='one', cone=6, factor_start=1.0, factor_end=1.0)
    assert pieces_named(ob)[0] == "homogeneous curve" and pieces_named(ob).count("cone") == 7 and pieces_named(ob).count("ray") == 4
    assert np.allclose(values_of(ob)[0].points, [(0, 0, 0), (2, 4, 1), (1.5, 1, -0.5), (4, 0, 0)])
    assert {"P_1  W = 2", "p_1", "O", "W = 0", "W = 1"} <= set(labels_of(ob))
    require_exact(ob)
    image = made('perspective', ob)
    assert np.allclose(values_of(image)[0].homogeneous_points, source.data.splinewright.value.to_nurbs().homogeneous_points, atol=1e-6)
    source.data.splinewright.value = sc.BezierCurve(PLANE, [1, 0, 3, 1])
    bpy.context.view_layer.update()
    assert "P_1  W = 0" in labels_of(ob) and "p_1" not in labels_of(ob)
    assert np.allclose(values_of(image)[0].weights, [1, 0, 3, 1], atol=1e-6)
    ob.data.splinewright_parameters.lift_factor_end = 4.0
    bpy.context.view_layer.update()
    assert values_of(image)[0].degree == 4
    u = np.linspace(0, 1, 9)
    assert np.allclose(values_of(image)[0].evaluate(u), source.data.splinewright.value.evaluate(u), atol=1e-5)


@pytest.mark.parametrize('base', ('one', 'zero'))
def test_a_polynomial_factor_changes_the_curve_in_space_and_not_its_image(base):
    source = add(sc.BezierCurve(PLANE, [1, 2, 0.5, 1]), "curve")
    ob = made('lift', source, height=1.0, base=base, cone=6, factor="1 + t^2")
    assert values_of(ob)[0].degree == 5
    require_exact(ob)
    image, u = made('perspective', ob), np.linspace(0, 1, 9)
    for factor in ("1 + t^2", "t - 2", "t", "t - 0.5"):
        ob.data.splinewright_parameters.lift_factor = factor
        bpy.context.view_layer.update()
        assert ob.data.splinewright.problem == ""
        height = values_of(ob)[0].evaluate(u)[:, 2] + (1.0 if base == 'one' else 0.0)
        weights = (source.data.splinewright.value.to_nurbs().homogeneous_points[:, 3])
        expected = [eval(factor.replace("^", "**"), {'t': t}) * np.dot(weights, [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3]) for t in u]
        assert np.allclose(height, expected, atol=1e-12)
    ob.data.splinewright_parameters.lift_factor = "2 - t"
    bpy.context.view_layer.update()
    assert np.allclose(values_of(image)[0].evaluate(u)[:, :2], source.data.splinewright.value.evaluate(u)[:, :2], atol=1e-5)
    ob.data.splinewright_parameters.lift_factor = "sin(t)"
    assert "no polynomial of degree 4" in ob.data.splinewright.problem and ob.data.splinewright_parameters.lift_factor == "2 - t"


def applied_lift(**settings):
    source = add(sc.BezierCurve(PLANE, [1, 2, 0.5, 1]), "curve")
    ob = made('lift', source, **{'height': 1.0, 'base': 'one', 'cone': 6, 'marker': 0.03, 'polygons': True, 'rays': True, 'plane': True, **settings})
    assert op(bpy.ops.splinewright.make_editable) == {'FINISHED'}
    return ob


def test_an_applied_homogeneous_curve_keeps_what_stays_right_and_its_image_draws_rays_that_follow(capfd):
    ob = applied_lift()
    assert "would not follow the curve" in capfd.readouterr().out
    assert set(pieces_named(ob)) == {"homogeneous curve", "mark O", "grid", "axis", "tick W = 0", "tick W = 1"}
    require_exact(ob)
    image = made('perspective', ob, rays=True, cone=4)
    assert [pieces_named(image).count(name) for name in ("image", "ray", "cone")] == [1, 4, 5]
    values = values_of(ob)
    values[0] = values[0].with_points(values[0].points + [(0, 0, 0), (0, 0, 0), (0, 0, 0), (1, 0, 1)])
    ob.data.splinewright.value = values
    bpy.context.view_layer.update()
    assert np.allclose(values_of(image)[0].weights, [1, 2, 0.5, 2], atol=1e-6)
    last = values_of(image)[4].points
    assert np.allclose(np.cross(last[1] - (0, 0, -1), (5, 0, 2)), 0, atol=1e-6) and np.linalg.norm(last[1] - (0, 0, -1)) > 5.38
    require_exact(image)


def test_applying_what_a_lift_shows_without_rays_leaves_all_of_it_and_says_nothing(capfd):
    ob = applied_lift(rays=False, cone=0, polygons=False, marker=0.0)
    assert "would not follow" not in capfd.readouterr().out and pieces_named(ob)[0] == "homogeneous curve"


def test_a_new_value_of_an_applied_picture_keeps_names_and_materials():
    ob = applied_lift()
    names, slots = pieces_named(ob), [spline.material_index for spline in ob.data.splines]
    values = values_of(ob)
    ob.data.splinewright.value = [values[0].with_points(values[0].points + (0, 0, 1)), *values[1:]]
    assert pieces_named(ob) == names and [spline.material_index for spline in ob.data.splines] == slots and len(set(slots)) > 2
    assert piece_materials.colors_of(ob.data)["grid"] != piece_materials.colors_of(ob.data)["axis"]
    ob.data.splinewright.value = values[1:]
    assert pieces_named(ob) == names[1:]
    ob.data.splinewright.value = [*values[2:], sc.BezierCurve(PLANE), sc.BezierCurve(PLANE), sc.BezierCurve(PLANE)]
    assert pieces_named(ob) == names[2:] + [""] * 3 and len(names) == len(values)


def test_the_image_of_a_curve_in_space_has_weights_by_its_height():
    space = add(sc.BezierCurve(PLANE + [(0, 0, 0), (0, 0, 1), (0, 0, 2), (0, 0, 0)]), "space")
    ob = made('perspective', space, x=0.0, y=0.0, z=-1.0, plane=0.0)
    assert np.allclose(values_of(ob)[0].weights, [1, 2, 3, 1]) and np.allclose(values_of(ob)[0].points[1], (0.5, 1, 0))
    require_exact(ob)
    with pytest.raises(RuntimeError, match="eye lies in the plane"):
        made('perspective', space, x=0.0, y=0.0, z=2.0, plane=2.0)
    with pytest.raises(RuntimeError, match="leaves the plane z = 0 by 2"):
        made('lift', space)


def test_the_triangle_of_typed_knots_points_out_what_is_chosen():
    ob = made('triangle', degree=2, knot_values="0 1 2 3", chosen="0,2", feeding='parents', spans="1")
    assert {"N_0,2", "N_2,0", "u/2", "(3-u)/2", "[1, 2)"} <= set(labels_of(ob))
    assert pieces_named(ob).count("parents 0,2") == 2 and "wedge 1" in pieces_named(ob)
    require_exact(ob)
    ob.data.splinewright_parameters.triangle_knot_values = "0 1 1 2 3"
    bpy.context.view_layer.update()
    assert "N_1,0 = 0" in labels_of(ob)
    for settings, message in (({'chosen': "7,2"}, "no function N_7,2"), ({'chosen': "a"}, "not a whole number"), ({'chosen': "1"}, "is not a function"),
                              ({'spans': "9"}, "no span 9"), ({'spans': "²"}, "not a whole number"), ({'knot_values': "0 x"}, "is not a number")):
        with pytest.raises(RuntimeError, match=message):
            made('triangle', **{'degree': 2, 'knot_values': "0 1 2 3", 'chosen': "", 'spans': "", **settings})


def test_the_triangle_of_a_curve_follows_its_knots():
    source = add(sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], PLANE[:3]), "curve")
    ob = made('basis_triangle', source, chosen="", spans="", feeding='support')
    assert labels_of(ob).count("N_2,2") == 1 and "N_3,2" not in labels_of(ob)
    source.data.splinewright.value = source.data.splinewright.value.insert_knot(0.5)
    bpy.context.view_layer.update()
    assert "N_3,2" in labels_of(ob)


def test_discs_have_the_colors_of_the_functions_and_take_keys():
    source = add(sc.BezierCurve(PLANE), "curve")
    ob = made('discs', source, position=0.0, radius=0.5)
    assert pieces_named(ob) == [f"B_{{{i},3}}" for i in range(4)] + ["mark C  u = 0"]
    graphs = made('basis', source, show='functions', axes=False)
    colors, others = piece_materials.colors_of(ob.data), piece_materials.colors_of(graphs.data)
    assert all(colors[name] == others[name] for name in pieces_named(ob)[:4])
    ob.data.splinewright_parameters.discs_position = 0.5
    bpy.context.view_layer.update()
    radii = [np.ptp(value.evaluate(np.linspace(*value.domain, 5))[:, 0]) / 2 for value in values_of(ob)[:4]]
    assert np.allclose(np.square(radii) / 0.25, [1 / 8, 3 / 8, 3 / 8, 1 / 8], atol=1e-6)


def test_orders_have_their_names_as_labels():
    ob = made('orders', add(sc.BezierCurve(PLANE), "curve"), wanted_orders="", columns=4, polygons=True)
    assert sum(name.startswith("order") for name in pieces_named(ob)) == 12 and {"0123", "0213"} <= set(labels_of(ob))
    require_exact(ob)
    ob.data.splinewright_parameters.orders_wanted_orders = "0 2 1 3"
    bpy.context.view_layer.update()
    assert pieces_named(ob) == ["order 0213", "polygon"]
    with pytest.raises(RuntimeError, match="is not an order"):
        made('orders', add(sc.BezierCurve(PLANE), "other"), wanted_orders="0 2", columns=4)


def test_influence_is_red_and_says_its_share(capfd):
    source = add(sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(i, 0, 0) for i in range(5)]), "curve")
    capfd.readouterr()
    ob = made('influence', source, index=1)
    assert "it moves 50 % of the length" in capfd.readouterr().out
    assert pieces_named(ob) == ["influence", "mark P_{1}"] and piece_materials.colors_of(ob.data)["influence"][0] > 0.8
    ob.data.splinewright_parameters.influence_index = 0
    bpy.context.view_layer.update()
    assert np.allclose(values_of(ob)[0].points[:, 0], [0, 1])
    with pytest.raises(RuntimeError, match="no control point 9"):
        made('influence', source, index=9)


@pytest.mark.parametrize('name', ('bezier patch', 'hermite patch', 'nurbs patch', 'teapot', 'mixed set'))
def test_influence_on_every_kind_of_surface_is_a_red_surface(name):
    ob = made('influence', add(VALUES[name](), "surface"), index=1, index_v=1, above=0.01)
    assert ob.type == 'MESH' and set(pieces_named(ob)) == {"influence"} and ob.data.materials[0].name.startswith("Splinewright Influence")
    require_exact(ob)


def test_influence_on_a_surface_follows_its_knots_and_points():
    net = np.dstack(np.meshgrid(np.arange(5.0), np.arange(4.0), [0.0], indexing='ij')).reshape(5, 4, 3)
    source = add(sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 2, 3, 3]), net), "surface")
    ob = made('influence', source, index=1, index_v=1, above=0.0, piece=1)
    corners = [(vertex.co.x, vertex.co.y) for vertex in ob.data.vertices]
    assert (min(corners), max(corners)) == ((0, 0), (2, 2))
    source.data.splinewright.value = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 3, 4, 4], [0, 0, 1, 2, 3, 3]), net + (0, 0, 2))
    bpy.context.view_layer.update()
    assert {vertex.co.z for vertex in ob.data.vertices} == {2.0}
    source.data.splinewright.value = source.data.splinewright.value.insert_knot('u', 0.5)
    bpy.context.view_layer.update()
    assert max(vertex.co.x for vertex in ob.data.vertices) == 1.0


def test_ducks_hold_a_strip_with_its_energy_as_label():
    ob = made('ducks', ends=0.3)
    assert pieces_named(ob)[:3] == ["strip", "end", "end"] and any(label.startswith("E = ") for label in labels_of(ob))
    require_exact(ob)
    ob.data.splinewright_parameters.ducks_ends = 0.0
    bpy.context.view_layer.update()
    assert "end" not in pieces_named(ob)


def test_interpolating_splines_take_end_derivatives_and_knots():
    ob = made('interpolating', start_derivative="0 5 0", end_derivative="", knots='averaged', closed=False)
    assert np.allclose(ob.data.splinewright.value.derivatives([0.0], 1)[0, 1], (0, 5, 0), atol=1e-9)
    ob.data.splinewright_parameters.interpolating_start_derivative = ""
    ob.data.splinewright_parameters.interpolating_knot_values = "0 0 0 0 0.3 1 1 1 1"
    ob.data.splinewright_parameters.interpolating_knots = 'typed'
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value.knots[4] == 0.3


def test_axes_are_drawn():
    assert "axis" in pieces_named(made('axes', grid=True))
