"""The panel that lists the joints of a curve shape."""

import math
import types

import bpy
import numpy as np
import pytest

from curves import value_of
from layouts import drawn_by
from shapes import activate, add, enter, leave, move, op, select
from support import part, splinecore as sc

continuity, panel, store, surveys = (part(name) for name in (
    'core.joints.continuity', 'ui.continuity_panel', 'bridge.data.store', 'bridge.analysis.surveys'))


class Layout:
    """Takes down the labels, line by line."""

    def __init__(self, lines=None):
        self.lines = [] if lines is None else lines
        self.alert = False

    def label(self, text, icon='NONE'):
        self.lines.append(text)

    def prop(self, data, name):
        getattr(data, name)

    def operator(self, name, text="", icon='NONE'):
        return types.SimpleNamespace()

    def split(self, factor):
        return self

    def column(self, align=False):
        return self

    box = row = column


def drawn():
    """The labels of the panel for the active object."""
    context = types.SimpleNamespace(object=bpy.context.object)
    assert panel.SPLINEWRIGHT_PT_continuity.poll(context)
    layout = Layout()
    panel.SPLINEWRIGHT_PT_continuity.draw(types.SimpleNamespace(layout=layout), context)
    return layout.lines


def joints_of(value):
    return {joint.name: joint for joint in surveys.survey_of(add(value).data).joints}


def test_knots_have_the_continuity_that_the_library_measures():
    curve = value_of('three knots')
    ob = add(curve)
    survey = surveys.survey_of(ob.data)
    expected = curve.joints()
    assert survey.count == len(survey.joints) == len(expected) == 2
    for joint, (u, measured), c in zip(survey.joints, expected, (2, 1)):
        assert joint.name == f"{u:.4g}" and repr(joint.continuity) == repr(measured) and measured.c == c
    numbers = drawn()
    assert numbers[:5] == ["Gap", "Angle", "Curvature", "0.1", "C2 G2"] and numbers[8:10] == ["0.3333", "C1 G1"]
    assert math.isclose(float(numbers[-1]), expected[1][1].curvature_difference, rel_tol=0.01)


def corner(angle):
    """Two lines that meet at an angle, of which the second is three times as fast."""
    return [sc.BezierCurve([(0, 0), (1, 0)]), sc.BezierCurve([(1, 0), (1 + 3 * math.cos(angle), 3 * math.sin(angle))])]


@pytest.mark.parametrize('reversals, place', (((False, False), "1 → → 2"), ((False, True), "1 → ← 2"),
                                              ((True, False), "1 ← → 2"), ((True, True), "2 → → 1")))
def test_the_ends_of_two_pieces_are_compared_whichever_way_they_run(reversals, place):
    curves = [curve.reversed() if turned else curve for curve, turned in zip(corner(math.radians(30)), reversals)]
    joint, = joints_of(curves).values()
    assert joint.name == place and (joint.continuity.c, joint.continuity.g) == (0, 0)
    assert math.isclose(math.degrees(joint.continuity.angle), 30, rel_tol=1e-12)
    assert drawn()[3:] == [place, "C0 G0", "0", "30°", "0"]
    joint, = joints_of(corner(0.0)).values()
    assert (joint.continuity.c, joint.continuity.g) == (0, 2), "the other speed is no change of direction"


def test_the_curvature_of_a_circle_beside_a_line_differs_by_one_over_the_radius():
    arc = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], [1, math.sqrt(0.5), 1])
    line = sc.BezierCurve([(2, -1), (2, 0)])
    joint = joints_of([line, arc])["1 → → 2"]
    assert joint.continuity.g == 1 and math.isclose(joint.continuity.curvature_difference, 0.5, rel_tol=1e-12)


def test_a_small_gap_is_measured_and_a_large_one_is_no_joint():
    first, second = corner(0.0)
    for gap, count in ((1e-5, 1), (0.01, 0)):
        joints = joints_of([first, second.with_points(second.points + (0, gap, 0))])
        assert len(joints) == count
        if joints:
            assert math.isclose(joints["1 → → 2"].continuity.gap, gap) and drawn()[4:6] == ["gap", "1e-05"]
    assert drawn() == ["No joints"]


def test_a_seam_without_a_lock_says_why_and_offers_what_helps():
    """Shapes that are made one by Join Shapes have edges that lie on each other."""
    first, second = sc.BezierPatch(np.mgrid[0:4, 0:4, 0:1].reshape(3, 4, 4).transpose(1, 2, 0)), None
    second = first.with_points(first.points + (3, 0, 0))
    left, right = add(first, "left"), add(second, "right")
    activate(right, left)
    op(bpy.ops.splinewright.join)
    layout = drawn_by(panel.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "Join Patches" in " ".join(layout.texts) and "splinewright.hold_seam" not in layout.operators
    assert "splinewright.join_patches" in layout.operators
    op(bpy.ops.splinewright.join_patches, continuity='C0', first=1, second=2)
    layout = drawn_by(panel.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "splinewright.hold_seam" in layout.operators and "Join Patches" not in " ".join(layout.texts)


def test_seams_of_closed_curves_are_joints_and_knots_of_nothing_are_smooth():
    assert joints_of(value_of('circle'))["seam"].continuity.g == 2
    periodic = joints_of(value_of('periodic'))
    assert len(periodic) == 7 and periodic["seam"].continuity.c == 2
    assert "seam" in joints_of(value_of('closed hermite')) and "seam" not in joints_of(value_of('hermite'))
    add(value_of('cubic').to_nurbs().insert_knot(0.25))
    assert drawn()[3:5] == ["0.25", "C∞"]


def test_a_joint_at_infinity_is_named_and_not_measured():
    add([value_of('cubic'), sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (1, 1), (0, 2)], [1, 0, 0, 1])])
    assert drawn()[3:] == ["2: 1", "", "at infinity: not measured"]
    add([sc.BezierCurve([(0, 0), (1, 1), (0, 1)], [1, 1, 0]), sc.BezierCurve([(0, 1), (1, 2), (3, 3)], [0, 1, 1])])
    assert drawn() == ["No joints"], "ends at infinity meet nowhere"


def test_of_many_joints_the_first_are_shown_and_the_others_counted():
    points = np.cumsum(np.random.default_rng(3).uniform(size=(1200, 3)), axis=0)
    knots = [0, 0, 0, *range(1198), 1197, 1197, 1197]
    add(sc.NurbsCurve(3, knots[:1204], points))
    lines = drawn()
    assert lines.count("C2 G2") == surveys.SHOWN and lines[-1] == "and 1,146 more"


def test_a_star_of_many_curves_is_no_trouble():
    ends = np.random.default_rng(3).uniform(size=(2000, 3))
    ob = add([sc.BezierCurve([(0, 0, 0), end]) for end in ends])
    survey = surveys.survey_of(ob.data)
    assert len(survey.joints) == surveys.SHOWN and 1999 <= survey.count < 40_000


def test_it_is_worked_out_when_the_definition_changes_and_not_at_every_redraw(monkeypatch):
    count = []

    def counted(*arguments, surveyed=continuity.surveyed):
        count.append(1)
        return surveyed(*arguments)
    monkeypatch.setattr(continuity, 'surveyed', counted)
    ob = add(sc.NurbsCurve(2, [0, 0, 0, 0.5, 1, 1, 1], np.random.default_rng(77).uniform(size=(4, 3))))
    first = drawn()
    ob.data.splinewright.resolution_u = 7
    assert drawn() == first and len(count) == 1
    op(bpy.ops.splinewright.reverse)
    drawn()
    assert len(count) == 2
    bpy.ops.ed.undo()
    assert drawn() == first and len(count) == 2, "what was known is not forgotten"
    for i in range(20):
        add(sc.BezierCurve([(i, 0), (i, 1)]))
        drawn()
    assert len(part('bridge.data.file_state').state.surveys) <= 8


def test_while_a_net_is_edited_the_joints_are_those_of_the_shape_as_it_is():
    ob = add([sc.BezierCurve([(0, 0), (1, 0), (2, 0)]), sc.BezierCurve([(2, 0), (3, 0), (4, 0)])])
    assert drawn()[3:] == ["1 → → 2", "C∞", "0", "0°", "0"]
    held = enter()
    assert drawn()[3:5] == ["1 → → 2", "C∞"]
    select(held, 4)
    move(0, 1, 0)
    bpy.context.view_layer.update()
    assert drawn()[3:7] == ["1 → → 2", "C0 G0", "0", "45°"]
    bpy.ops.ed.undo()
    assert drawn()[3:5] == ["1 → → 2", "C∞"]
    bpy.ops.ed.redo()
    leave()
    assert bpy.context.object == bpy.data.objects["shape"] and drawn()[6] == "45°"


def test_a_net_that_cannot_be_shown_is_said_to_show_an_earlier_state():
    op(bpy.ops.splinewright.add_five_points)
    ob = bpy.context.object
    start = part('bridge.recipes.recipes').points(ob.data)
    held = enter()
    select(held, 1)
    move(*(start[0] - start[1]))
    assert part('bridge.net.live').problem(held)
    assert "As it was before" in " ".join(drawn())


def test_it_is_there_for_shapes_alone():
    poll = panel.SPLINEWRIGHT_PT_continuity.poll
    patch = add(sc.BezierPatch(np.random.default_rng(1).uniform(size=(2, 2, 3))))
    assert poll(types.SimpleNamespace(object=patch))
    bpy.ops.curve.primitive_bezier_curve_add()
    for ob in [None, bpy.context.object]:
        assert not poll(types.SimpleNamespace(object=ob))
    activate(patch)
    enter()
    assert poll(types.SimpleNamespace(object=bpy.context.object)), "the net of a patch"
    assert 'DEFAULT_CLOSED' in panel.SPLINEWRIGHT_PT_continuity.bl_options


def test_a_damaged_or_newer_definition_breaks_no_panel():
    ob = add(value_of('nurbs'))
    ob.data[store.KEY]['version'] = 99
    assert drawn() == []
    ob.data[store.KEY]['version'] = 2
    ob.data[store.KEY]['structure'] = "["
    assert drawn() == []
    ob.data[store.KEY] = 5
    assert drawn() == []


@pytest.mark.parametrize('number, text', ((0, "0"), (0.5, "0.5"), (1234.5, "1e+03"), (999.4, "999"), (1e-17, "0"), (-1e-12, "0"), (2e-7, "2e-07"),
                                          (0.00123456, "0.00123"), (179.96, "180")))
def test_numbers_are_short(number, text):
    assert panel._short(number) == text and len(text) <= 7
