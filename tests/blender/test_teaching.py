"""Basis functions, constructions of points, and formulas, beside the curves they belong to."""

import bpy
import numpy as np
import pytest

from shapes import activate, require_exact
from support import curve_points, part, splinecore as sc

follow, placing, recipes, shape, teaching, formulas = (part(name) for name in (
    'bridge.follow.follow', 'bridge.recipes.placing', 'bridge.recipes.recipes', 'bridge.shape.shape', 'core.formulas.teaching', 'core.formulas.formulas'))

LINE = np.array([(0, 0, 0), (1, 2, 0), (2, -1, 0), (3, 2, 0), (4, 0, 0), (5, 1, 0)], dtype=float)
KNOTS = {
    'clamped': (3, [0, 0, 0, 0, 1, 3, 4, 4, 4, 4], False),
    'unclamped': (3, [0, 1, 2, 3, 5, 6, 7, 8.5, 9, 10], False),
    'multiple': (3, [0, 0, 0, 0, 1, 1, 2, 2, 2, 2], False),
    'periodic': (3, [0, 1, 2, 2.5, 4, 5, 6], True),
    'linear': (1, [0, 0, 1, 2, 3, 4, 5, 5], False),
}


def curve_of(name):
    degree, knots, periodic = KNOTS[name]
    return sc.NurbsCurve(degree, knots, LINE, periodic=periodic)


def add(value, name="curve"):
    ob = bpy.data.objects.new(name, shape.new_data(name, value, (12, 12)))
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    activate(ob)
    return ob


def derive(kind, ob, **settings):
    activate(ob)
    assert getattr(bpy.ops.splinewright, f"add_{kind}")('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


@pytest.mark.parametrize('name', KNOTS)
def test_a_graph_is_the_basis_function(name):
    curve = curve_of(name)
    vector, knots = curve.knot_vector, curve.knots
    ob = derive('basis', add(curve), width=2.0, height=0.5, axes=False)
    graphs = ob.data.splinewright.value
    unseen = list(range(len(LINE)))
    for graph in graphs:
        x = np.linspace(*graph.domain, 41)[1:-1]
        points = graph.evaluate(x)
        u = knots[0] + points[:, 0] / 2.0 * (knots[-1] - knots[0])
        assert np.allclose(u, x, rtol=0, atol=1e-12) and not points[:, 2].any()
        fits = [i for i in range(len(LINE)) if np.allclose(vector.function(i, x), 2 * points[:, 1], rtol=0, atol=1e-12)]
        assert len(fits) == 1
        unseen = [i for i in unseen if i not in fits]
    assert not unseen
    require_exact(ob)


def test_graphs_follow_when_the_knots_change_and_lie_below_the_curve():
    source = add(curve_of('clamped'))
    ob = derive('basis', source, axes=False)
    assert len(ob.data.splinewright.value) == 6
    assert np.allclose(ob.matrix_world.translation, (0, shape.points_of(source.data)[:, 1].min() - 1.3, 0), atol=1e-6)
    source.data.splinewright.value = source.data.splinewright.value.insert_knot(2.0)
    bpy.context.view_layer.update()
    assert len(ob.data.splinewright.value) == 7
    require_exact(ob)
    ob.data.splinewright_parameters.basis_height = 3.0
    assert max(graph.points[:, 1].max() for graph in ob.data.splinewright.value) == 3.0


@pytest.mark.parametrize('scheme', ('de_boor', 'casteljau', 'rational'))
@pytest.mark.parametrize('name', KNOTS)
@pytest.mark.parametrize('position', (0.0, 0.1, 0.5, 0.777, 1.0))
def test_a_construction_ends_in_the_point_of_the_curve(name, position, scheme):
    curve = curve_of(name).with_weights([1, 2, 0.5, 3, 1, 1])
    start, end = curve.domain
    u = start + position * (end - start)
    point = curve.evaluate([u], side='left' if position == 1.0 else 'right')[0]
    *levels, circle = [part.curve for part in teaching.construction(curve, position, scheme, 0.1)]
    assert np.allclose(np.linalg.norm(circle.evaluate(np.linspace(*circle.domain, 9)) - point, axis=1), 0.1, atol=1e-12)
    sizes = [len(level.points) for level in levels]
    assert sizes == sorted(sizes, reverse=True) and sizes[0] == curve.degree + 1
    last = levels[-1].points
    nearest = min(np.linalg.norm(np.cross(point - a, b - a)) / np.linalg.norm(b - a) for a, b in zip(last, last[1:]))
    assert nearest < 1e-12


def test_every_level_divides_the_legs_of_the_level_before():
    curve = sc.BezierCurve(LINE[:5]).to_nurbs()
    levels = [part.curve for part in teaching.construction(curve, 0.25, 'de_boor', 0.0)]
    for before, after in zip(levels, levels[1:]):
        assert np.allclose(after.points, 0.75 * before.points[:-1] + 0.25 * before.points[1:], atol=1e-14)


def test_the_rational_algorithm_says_where_it_breaks_and_the_homogeneous_goes_on():
    source = add(sc.BezierCurve([(1, 0, 0), (0, 1, 0), (-1, 0, 0)], weights=[1, 0, 1]))
    ob = derive('construction', source)
    before = ob.data.splinewright.value
    ob.data.splinewright_parameters.construction_scheme = 'rational'
    assert "breaks at level" in ob.data.splinewright.problem
    assert ob.data.splinewright.value == before
    assert recipes.parameters(ob.data)['scheme'] == 'de_boor'
    ob.data.splinewright_parameters.construction_scheme = 'casteljau'
    assert ob.data.splinewright.problem == ""
    circle = ob.data.splinewright.value[-1]
    assert np.allclose(circle.points[:, 2], 0) and np.allclose(circle.evaluate([0.0]), (0.03, 1, 0), atol=1e-12)


def test_a_construction_follows_the_curve_while_it_is_edited_and_moved():
    source = add(curve_of('clamped'))
    ob = derive('construction', source, position=0.5)
    moved = LINE + (0, 0, 1)
    source.data.splinewright.value = source.data.splinewright.value.with_points(moved)
    source.location.x = 5.0
    bpy.context.view_layer.update()
    circle = ob.data.splinewright.value[-1]
    middle = source.data.splinewright.value.evaluate([2.0])[0] + (5, 0, 0)
    assert np.allclose(circle.evaluate([circle.domain[0]])[0] - middle, (0.03, 0, 0), atol=1e-6)
    assert not bpy.ops.splinewright.edit_net.poll()
    require_exact(ob)


def test_what_cannot_be_made_is_refused_with_a_word():
    add(curve_of('clamped'))
    with pytest.raises(RuntimeError, match="there is no piece 2"):
        bpy.ops.splinewright.add_basis('EXEC_DEFAULT', True, piece=2)
    bpy.ops.splinewright.add_bezier_patch()
    with pytest.raises(RuntimeError, match="Select one curve"):
        bpy.ops.splinewright.add_basis('EXEC_DEFAULT', True)
    bpy.ops.object.select_all(action='DESELECT')
    assert not bpy.ops.splinewright.add_basis.poll()


def test_the_deleted_curve_leaves_the_last_picture_and_its_numbers_as_they_are():
    source = add(curve_of('clamped'))
    ob = derive('basis', source)
    value = ob.data.splinewright.value
    bpy.data.objects.remove(source)
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value == value and "deleted" in follow.problem(ob.data)
    ob.data.splinewright_parameters.basis_height = 3.0
    assert "deleted" in ob.data.splinewright.problem and ob.data.splinewright.value == value
    assert recipes.parameters(ob.data)['height'] == 1.0


def test_a_saved_picture_is_alive_again(tmp_path):
    derive('basis', add(curve_of('clamped')), axes=False)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "basis.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "basis.blend"))
    part('ui.handlers').loaded()
    source = bpy.data.objects["curve"]
    source.data.splinewright.value = source.data.splinewright.value.insert_knot(2.0)
    bpy.context.view_layer.update()
    assert len(bpy.data.objects["curve Basis Functions"].data.splinewright.value) == 7


def test_formulas_of_a_conic():
    add(sc.conics.conic_arc((1, 0, 0), (1, 1, 0), (0, 1, 0), np.sqrt(0.5)))
    assert bpy.ops.splinewright.write_formulas() == {'FINISHED'}
    text = bpy.data.texts["curve Formulas"].as_string()
    assert "Class: shorter ellipse arc" in text and "Conic: circle" in text
    lines = dict(formulas.conic_lines(bpy.context.object.data.splinewright.value.to_nurbs()))
    assert lines["Eccentricity"] == "0"


def test_the_power_basis_and_the_triangles_are_written_out():
    text = formulas.text(sc.BezierCurve([(0, 0, 0), (0.5, 0, 0), (1, 1, 0)]).to_nurbs(), 0.5)
    assert "x = u\n" in text and "y = u^2\n" in text and "z = 0\n" in text
    assert "N0,2 = 0.25   N1,2 = 0.5   N2,2 = 0.25" in text
    assert "(0.5, 0.25, 0) w = 1" in text


def test_formulas_say_where_the_rational_algorithm_breaks():
    half = sc.BezierCurve([(1, 0, 0), (0, 1, 0), (-1, 0, 0)], weights=[1, 0, 1]).to_nurbs()
    text = formulas.text(half, 0.5)
    assert "the rational algorithm breaks at level" in text and "(at infinity)" in text
    assert "[0 0.5 0 0.5]" in text


@pytest.mark.parametrize('make, kind', (
    (lambda: sc.conics.circle((1, 2, 3), 2.0), "circle"), (lambda: sc.conics.circle((0, 0, 0), 2.0, form='single'), "circle"),
    (lambda: sc.conics.ellipse((0, 1, 0), (3, 1, 0), (0, 0, 1)), "ellipse"),
    (lambda: sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 2, 0)), "hyperbola"),
    (lambda: sc.conics.from_implicit(sc.conics.ImplicitConic([1, 0, 0, 0, -4, 0]))[0], "parabola"),
    (lambda: sc.BezierCurve([(0, 0, 0), (1, 2, 0), (2, 0, 0)]).elevate(3), "parabola")))
def test_a_conic_in_any_form_is_named_with_an_equation_that_holds(make, kind):
    value = make()
    curve = (value[0] if isinstance(value, list) else value).to_nurbs()
    lines = dict(formulas.conic_lines(curve))
    assert lines["Conic"] == kind and lines["Equation"].endswith("= 0") and "e-1" not in lines["Equation"]


@pytest.mark.parametrize('make', (lambda: sc.BezierCurve([(0, 0), (1, 2), (2, -1), (3, 0)]), lambda: curve_of('clamped'),
                                  lambda: sc.BezierCurve([(0, 0), (1, 1)])))
def test_a_curve_that_is_no_conic_is_not_called_one(make):
    assert formulas.conic_lines(make().to_nurbs()) == []


def test_matrices_are_those_of_the_lectures():
    text = formulas.text(sc.NurbsCurve(3, range(10), LINE), 0.5)
    assert "uniform B-spline matrix" in text and "1/6 times" in text
    assert "Bezier matrix" in formulas.text(sc.BezierCurve(LINE[:4]).to_nurbs(), 0.5)
    assert formulas.text(curve_of('multiple'), 0.5).count("B-spline matrix on") == 2


def test_texts_of_others_are_left_alone_and_ours_is_written_anew():
    notes = bpy.data.texts.new("curve Formulas")
    notes.from_string("mine")
    add(curve_of('clamped'))
    for _ in range(2):
        assert bpy.ops.splinewright.write_formulas() == {'FINISHED'}
    assert notes.as_string() == "mine" and len(bpy.data.texts) == 2


def test_a_curve_flattened_by_its_scale_has_graphs_and_a_flat_owner_is_told():
    source = add(curve_of('clamped'))
    source.scale.z = 0.0
    bpy.context.view_layer.update()
    assert len(derive('basis', source, axes=False).data.splinewright.value) == 6
    source.scale.z = 1.0
    ob = derive('construction', source)
    value = ob.data.splinewright.value
    placing.stop(ob.data)
    ob.scale.z = 0.0
    bpy.context.view_layer.update()
    assert "scale of 0" in follow.problem(ob.data) and ob.data.splinewright.value == value
    ob.scale.z = 1.0
    bpy.context.view_layer.update()
    assert follow.problem(ob.data) == ""


def test_nothing_is_made_where_it_could_not_be_put(tmp_path):
    bpy.data.collections.new("theirs")
    bpy.data.libraries.write(str(tmp_path / "lib.blend"), {bpy.data.collections["theirs"]})
    bpy.data.collections.remove(bpy.data.collections["theirs"])
    with bpy.data.libraries.load(str(tmp_path / "lib.blend"), link=True) as (_, wanted):
        wanted.collections = ["theirs"]
    source = add(curve_of('clamped'))
    bpy.context.scene.collection.children.link(bpy.data.collections["theirs"])
    layers = bpy.context.view_layer.layer_collection.children
    bpy.context.view_layer.active_layer_collection = layers["theirs"]
    activate(source)
    count = len(bpy.data.objects)
    assert not bpy.ops.splinewright.add_basis.poll() and not bpy.ops.splinewright.add_construction.poll()
    with pytest.raises(RuntimeError, match="linked from another file"):
        bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True)
    assert len(bpy.data.objects) == count
