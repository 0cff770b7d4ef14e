"""Halved polygons, hulls, chain points and marks as shapes: named, colored and labeled, live, of every kind of curve and surface."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, require_exact
from support import part, splinecore as sc

labels, piece_materials, signs, store = (part(name) for name in (
    'core.formulas.labels', 'bridge.shape.piece_materials', 'core.formulas.signs', 'bridge.data.store'))
CORNERS = np.array([(0, 0, 0), (0, 4, 0), (4, 4, 0), (4, 0, 0)], float)
SPLINE = (3, [0, 0, 0, 0, 1, 3, 4, 4, 4, 4], np.array([(0, 0, 0), (1, 2, 0), (2, -1, 0), (3, 2, 0), (4, 0, 0), (5, 1, 0)], float))
CURVES = [name for name, make in VALUES.items() if 'patch' not in name and name not in ('ferguson', 'teapot', 'mixed set')]


def made(kind, source, **settings):
    activate(source)
    assert getattr(bpy.ops.splinewright, f"add_{kind}")('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


def names_of(ob):
    return [piece.name for piece in store.read(ob.data).pieces]


def labels_of(ob):
    return [f"{label.base}{label.below and '_' + label.below}{label.after}" for label in labels.of(store.read(ob.data))]


@pytest.mark.parametrize('kind, settings', (('halving', {}), ('halving', {'ratio': 0.2, 'distance': 3.0}), ('hulls', {'show': 'both'}),
                                            ('hulls', {'hulls_of': 'whole'}), ('chain_points', {}), ('marks', {'derivatives': True})))
@pytest.mark.parametrize('name', CURVES)
def test_they_are_made_of_every_kind_of_curve(kind, settings, name):
    ob = made(kind, add(VALUES[name](), "curve"), **settings)
    assert all(names_of(ob)) and len(ob.data.materials) > 2 and ob.data.bevel_depth > 0
    require_exact(ob)


@pytest.mark.parametrize('name', ('bezier patch', 'hermite patch', 'nurbs patch', 'patch with a point at infinity', 'teapot', 'mixed set'))
@pytest.mark.parametrize('of', ('spans', 'whole'))
def test_hulls_are_made_of_every_kind_of_surface(name, of):
    ob = made('hulls', add(VALUES[name](), "surface"), hulls_of=of)
    assert {each.partition(" ")[0] for each in names_of(ob)} == {"hull"}
    require_exact(ob)


def test_halving_follows_the_curve_step_by_step():
    source = add(sc.BezierCurve(CORNERS), "curve")
    ob = made('halving', source, steps=2, distance=6.0)
    assert names_of(ob) == ["step 0", "step 1", "step 2"] and [spline.material_index for spline in ob.data.splines] == [3, 4, 5]
    source.data.splinewright.value = sc.BezierCurve(CORNERS + (0, 0, 1))
    bpy.context.view_layer.update()
    assert np.array_equal(ob.data.splinewright.value[1].points[3], (8, 3, 1))
    ob.data.splinewright_parameters.halving_steps = 0
    bpy.context.view_layer.update()
    assert names_of(ob) == ["step 0"]


def test_hulls_follow_and_intersections_have_one_color():
    source = add(sc.NurbsCurve(*SPLINE), "curve")
    ob = made('hulls', source, show='both')
    assert names_of(ob) == ["hull 0", "hull 1", "hull 2", "intersection", "intersection"]
    assert [spline.material_index for spline in ob.data.splines] == [3, 4, 5, 6, 6]
    source.data.splinewright.value = source.data.splinewright.value.insert_knot(2.0)
    bpy.context.view_layer.update()
    assert names_of(ob).count("hull 3") == 1
    with pytest.raises(RuntimeError, match="no two neighboring hulls"):
        made('hulls', add(sc.BezierCurve(CORNERS), "one"), show='intersections')


def test_chain_points_have_labels_with_ratios_and_a_color_each():
    ob = made('chain_points', add(sc.NurbsCurve(*SPLINE), "curve"), polygons='both', marker=0.03)
    found = labels_of(ob)
    assert found == ["d_0 = e0", "d_1 = f1", "d_2", "d_3", "d_4 = g3", "d_5 = e3", "g_1  1 : 2", "e_1  1 : 2", "f_2  1 : 3", "g_2  3 : 1",
                     "e_2  2 : 1", "f_3  2 : 1"]
    colors = piece_materials.colors_of(ob.data)
    assert len({colors[name] for name in names_of(ob)}) == 6 and colors["mark d_{2}"] == colors["mark d_{3}"]
    ob.data.splinewright_parameters.chain_points_polygons = 'none'
    bpy.context.view_layer.update()
    assert all(name.startswith(signs.MARK) for name in names_of(ob))


def test_chains_of_bezier_cubics_have_the_polygon_of_the_spline_or_a_warning(capfd):
    spline = sc.NurbsCurve(*SPLINE)
    ob = made('chain_points', add(spline.to_bezier(), "chain"), polygons='spline', marker=0.0)
    assert np.allclose(ob.data.splinewright.value[0].points if isinstance(ob.data.splinewright.value, list) else ob.data.splinewright.value.points,
                       SPLINE[2], rtol=0, atol=1e-6)
    capfd.readouterr()
    made('chain_points', add([sc.BezierCurve(CORNERS), sc.BezierCurve(CORNERS[::-1])], "no chain"), polygons='both', marker=0.03)
    assert "no spline polygon: joint 1 is not C" in capfd.readouterr().out


def test_marks_and_arrows_are_labeled():
    ob = made('marks', add(sc.HermiteCurve([(0, 0, 0), (3, 0, 0)], [(3, 3, 0), (3, -3, 0)]), "curve"), steps=2, derivatives=True)
    assert labels_of(ob) == ["u = 0", "u = 0.5", "u = 1", "R_0", "R_1"]
    corner = made('marks', add(sc.NurbsCurve(1, [0, 0, 1, 2, 2], CORNERS[:3]), "corner"), steps=0, arrow=0.5, derivatives=False)
    assert names_of(corner) == ["arrow T_{-}", "arrow T_{+}"]
    with pytest.raises(RuntimeError, match="nothing is drawn"):
        made('marks', add(sc.BezierCurve(CORNERS), "smooth"), steps=0, derivatives=False)
