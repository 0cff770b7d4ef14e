"""The panel Measure says what shapes measure in the scene, against closed forms."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

import curves
import patches
from layouts import drawn_by
from shapes import add, enter
from support import part, splinecore as sc

measured, measure_panel = part('core.analysis.measured'), part('ui.measure_panel')
panel = measure_panel.SPLINEWRIGHT_PT_measure


@pytest.fixture(autouse=True)
def patience(monkeypatch):
    """A busy machine takes its time."""
    monkeypatch.setattr(measure_panel, '_SOON', 60)
    monkeypatch.setattr(measure_panel, '_SOON_WHILE_EDITED', 60)


def said():
    """{label: number} of the panel and of those below it."""
    assert panel.poll(bpy.context)
    texts = [text for one in measure_panel.CLASSES for text in drawn_by(one, bpy.context).texts if text]
    found = {}
    for name, value in zip(texts, texts[1:]):
        try:
            found.setdefault(name, float(value))
        except ValueError:
            pass
    return found


def test_a_circle_under_a_scale_is_an_ellipse_in_the_scene():
    ob = add(curves.value_of('circle'))
    circle = curves.value_of('circle')
    ob.matrix_world = Matrix.LocRotScale((5, 0, 0), None, (2, 2, 2))
    bpy.context.view_layer.update()
    now = said()
    assert now["Length"] == pytest.approx(2 * circle.length(), rel=1e-6)
    assert now["Curvature"] == pytest.approx(float(circle.curvature(circle.domain[0])) / 2, rel=1e-6)
    assert now["Radius"] == pytest.approx(1 / now["Curvature"], rel=1e-6) and now["Torsion"] == pytest.approx(0, abs=1e-9)
    assert now["Length to here"] == pytest.approx(now["Length"] / 2, rel=1e-6)
    assert now["Size X"] == pytest.approx(now["Size Y"], rel=1e-6) and now["From X"] < now["To X"]


@pytest.mark.parametrize('scale', ((1, 1, 1), (2, 3, 0.5), (-2, 3, 0.5), (-1, -1, -1), (1, -1, -2)))
def test_tangent_and_torsion_under_uneven_and_mirrored_scale(scale):
    """Of (t, t^2, t^3), scaled: closed forms at t = 1/2. A mirroring turns the torsion's sign."""
    ob = add(sc.BezierCurve([(0, 0, 0), (1 / 3, 0, 0), (2 / 3, 1 / 3, 0), (1, 1, 1)]))
    ob.scale = scale
    bpy.context.view_layer.update()
    first, second, third = np.array([(1, 1, 0.75), (0, 2, 3), (0, 0, 6)]) * scale
    across = np.cross(first, second)
    now = said()
    assert [now[f"Tangent {axis}"] for axis in "XYZ"] == pytest.approx(list(first / np.linalg.norm(first)), rel=1e-6)
    assert now["Torsion"] == pytest.approx(across @ third / (across @ across), rel=1e-6)
    assert np.sign(now["Torsion"]) == np.sign(np.prod(scale))
    assert now["Curvature"] == pytest.approx(np.linalg.norm(across) / np.linalg.norm(first)**3, rel=1e-6)


def test_a_sphere_has_its_volume_and_an_open_surface_none():
    bpy.ops.splinewright.add_sphere()
    sphere = bpy.context.object
    now = said()
    radius = now["Size X"] / 2
    assert now["Area"] == pytest.approx(4 * np.pi * radius**2, rel=1e-6)
    assert now["Volume"] == pytest.approx(4 / 3 * np.pi * radius**3, rel=1e-6)
    assert abs(now["Mean"]) == pytest.approx(1 / radius, rel=1e-6) and now["Gauss"] == pytest.approx(1 / radius**2, rel=1e-6)
    sphere.scale = (1, 2, 3)
    bpy.context.view_layer.update()
    assert said()["Volume"] == pytest.approx(6 * now["Volume"], rel=1e-6)
    add(patches.value_of('bicubic'))
    now = said()
    assert "Volume" not in now
    assert now["Area"] == pytest.approx(patches.value_of('bicubic').area(tolerance=1e-9), rel=1e-6)


def test_the_place_is_chosen_by_piece_and_parameter():
    ob = add(curves.value_of('many curves'))
    values = curves.value_of('many curves')
    ob.data.splinewright.piece, ob.data.splinewright.measure_u = 2, 0.25
    start, end = values[1].domain
    point = values[1].evaluate(start + 0.25 * (end - start))
    now = said()
    assert [now[f"Point {axis}"] for axis in "XYZ"] == pytest.approx(list(point), rel=1e-6, abs=1e-6)


def test_what_runs_to_infinity_is_told_and_what_is_flat():
    ob = add(curves.value_of('hyperbola'))
    assert drawn_by(panel, bpy.context).texts
    ob.scale = (1, 1, 0)
    bpy.context.view_layer.update()
    assert "flatten" in " ".join(drawn_by(panel, bpy.context).texts)


def folded():
    """A patch folded in its plane: its normal is nought along lines that lie anyhow."""
    u, v = np.meshgrid(np.arange(12.0), np.arange(12.0), indexing='ij')
    knots = np.r_[[0.0] * 4, np.arange(1, 9), [9.0] * 4]
    points = np.stack([u, v, 0 * u], -1)
    points[..., :2] += np.random.default_rng(3).uniform(-2, 2, (12, 12, 2))
    return sc.NurbsPatch((3, 3), (knots, knots), points)


def test_where_the_area_is_refused_the_box_is_there():
    add(folded())
    box = sc.PatchSet.from_patches([folded()]).bounding_box()
    now = said()
    assert [now[f"From {axis}"] for axis in "XYZ"] == pytest.approx(list(box[0]), abs=1e-5)
    assert [now[f"Size {axis}"] for axis in "XYZ"] == pytest.approx(list(box[1] - box[0]), abs=1e-5)
    assert "Area" not in now
    assert "the area cannot be found within" in " ".join(drawn_by(panel, bpy.context).texts)


def test_measures_that_are_refused_for_one_reason_say_it_once():
    ob = add(curves.value_of('hyperbola'))
    problem, = part('bridge.analysis.surveys').whole_soon(ob.data, np.eye(4), 60).problems
    assert "infinity" in problem


def test_measures_are_kept_until_the_shape_changes():
    ob = add(curves.value_of('nurbs'))
    surveys = part('bridge.analysis.surveys')
    matrix = np.eye(4)
    first = surveys.whole_soon(ob.data, matrix, 60)
    assert surveys.whole_soon(ob.data, matrix, 60) is first
    ob.data.splinewright.value = curves.value_of('cubic')
    assert surveys.whole_soon(ob.data, matrix, 60) is not first
    assert first.length == pytest.approx(curves.value_of('nurbs').length(), rel=1e-6)


def test_while_a_net_is_edited_too():
    ob = add(curves.value_of('nurbs'))
    enter()
    assert "Length" in said()


def heavy():
    """A curve of so many points all about that its length takes long."""
    return sc.fit.interpolate(np.random.default_rng(6).uniform(-1, 1, (60_000, 3))).value


def test_what_takes_long_is_measured_when_asked_for_and_kept(monkeypatch):
    ob = add(sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)]))
    calls = []

    def measure(shape, cancel=None, work=measured.whole):
        calls.append(cancel)
        if cancel is not None:
            raise sc.Cancelled("it takes too long")
        return work(shape)
    monkeypatch.setattr(measured, 'whole', measure)
    for _ in range(3):
        assert "Length" not in said() and len(calls) == 1
    assert "splinewright.measure_whole" in drawn_by(panel, bpy.context).operators
    assert bpy.ops.splinewright.measure_whole() == {'FINISHED'} and len(calls) == 2
    assert said()["Length"] == pytest.approx(ob.data.splinewright.value.length(), rel=1e-6)
    for u in np.linspace(0, 1, 50):
        ob.data.splinewright.measure_u = u
        assert "Length" in said()
    assert len(calls) == 2
    ob.location.x = 3
    bpy.context.view_layer.update()
    assert "Length" not in said() and len(calls) == 3


def test_the_panel_of_a_curve_of_very_many_points_is_drawn_soon():
    """Work that is called off is counted by what it asked, not by the clock."""
    curve, asked = heavy(), []

    def after(calls):
        asked.append(1)
        return len(asked) > calls
    shape = measured.moved(part('core.shape.definition').from_value(curve), np.eye(4))
    with pytest.raises(sc.Cancelled):
        measured.whole(shape, lambda: after(3))
    assert len(asked) == 4
    rows = dict(measured.at_parameter(curve, (0.9, 0.0), lambda: True))
    assert "Length to here" not in rows and "Curvature" in rows
    assert dict(measured.at_parameter(curve, (0.9, 0.0)))["Length to here"] > 1


@pytest.mark.parametrize('value, names', ((curves.value_of('circle'), {"Length"}), (sc.build.sphere((0, 0, 0), 1.0), {"Area", "Volume"})))
def test_five_numbers_stand_first_and_the_rest_is_folded(value, names):
    add(value)
    texts = [text for text in drawn_by(panel, bpy.context).texts if text]
    assert set(texts[::2]) == names | {f"Size {axis}" for axis in "XYZ"} and len(texts) <= 10
    others = [one for one in measure_panel.CLASSES if one != panel]
    assert all('DEFAULT_CLOSED' in one.bl_options and one.bl_parent_id == panel.bl_idname for one in others) and others


def test_rounding_is_shown_as_zero():
    bpy.ops.splinewright.add_nurbs_curve()
    now = said()
    assert now["Point Y"] == 0 and now["Curvature"] == 0 and "Radius" not in now
    bpy.ops.splinewright.add_cylinder()
    cylinder = bpy.context.object
    for scale in (1e-3, 1.0, 1e5):
        cylinder.scale = (scale, scale, scale)
        bpy.context.view_layer.update()
        now = said()
        assert 0 in (now["Curvature min"], now["Curvature max"]) and now["Gauss"] == 0 and abs(now["Mean"]) > 0


def test_what_is_small_beside_other_shapes_is_not_rounding():
    add(sc.BezierCurve([(0, 0, 0), (1e-9, 2e-9, 0), (3e-9, 0, 0)]))
    now = said()
    assert now["Point Y"] == pytest.approx(1e-9, rel=1e-6) and now["Curvature"] > 1e8
