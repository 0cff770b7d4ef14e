"""The continuity of patches across their seams: listed in the panel, colored along the surface."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, select
from support import part, splinecore as sc

colors, definitions, overlay, panel, seams, starters, surveys = (part(name) for name in (
    'ui.colors', 'core.shape.definition', 'ui.seams_overlay', 'ui.continuity_panel', 'core.joints.seams', 'core.shape.starters', 'bridge.analysis.surveys'))


def pair(height, slope=0.0):
    """Two flat patches with a common edge along y; the second one rises, or bends upwards."""
    flat = sc.BezierPatch([[(x, y, 0) for y in range(4)] for x in range(4)])
    risen = sc.BezierPatch([[(3 + x, y, slope * x + height * x * x) for y in range(4)] for x in range(4)])
    return sc.PatchSet.from_patches([flat, risen])


@pytest.mark.parametrize('value, word, number', (
    (pair(0.0), "C2 G2", 2), (pair(0.5), "C1 G1", 1), (pair(0.0, 0.5), "C0 G0", 0)))
def test_a_seam_has_its_class_in_words_and_colors(value, word, number):
    if number == 1:                     # a height of x² at the points x = 0, 1, 2, 3 leaves the plane with a slope
        net = np.array(value[1].points)
        net[1, :, 2] = 0
        value = sc.PatchSet.from_patches([value[0], sc.BezierPatch(net)])
    ob = add(value)
    survey = surveys.survey_of(ob.data)
    assert survey.count == 1 and survey.joints[0].name == "1 u end · 2 u start"
    assert panel.kind(survey.joints[0]) == word
    (line, found), = overlay.colored_lines(ob.data)
    assert np.allclose(line[:, 0], 3) and np.allclose(found, colors.of_seams()[number])


def test_a_seam_that_opens_along_its_way_changes_its_color():
    flat = sc.BezierPatch([[(x, y, 0) for y in range(4)] for x in range(4)])
    net = np.array([[(3 + x, y, 0.0) for y in range(4)] for x in range(4)])
    net[1, 3, 2] = 1.0                  # the tangent plane turns away towards the far end only
    ob = add(sc.PatchSet.from_patches([flat, sc.BezierPatch(net)]))
    (line, found), = overlay.colored_lines(ob.data)
    assert np.allclose(found[line[:, 1].argmax()], colors.of_seams()[0])
    assert np.allclose(found[line[:, 1].argmin()], colors.of_seams()[2])


def test_places_that_cannot_be_measured_are_gray():
    class Measured:
        parameters, gaps = np.zeros(2), np.array([np.nan, 0.0])
        angles = curvature_differences = np.array([np.nan, np.nan])

    assert seams.classes(Measured, 1.0).tolist() == [-2, 2]


def test_the_teapot_has_its_seams_and_the_sphere_closes_smoothly():
    teapot = add(starters.teapot())
    assert surveys.survey_of(teapot.data).count == 52
    assert len(overlay.colored_lines(teapot.data)) == 52
    bpy.ops.splinewright.add_sphere('EXEC_DEFAULT', True)
    sphere = bpy.context.object.data.splinewright.value
    assert sphere.periodic == (True, False) and surveys.survey_of(bpy.context.object.data).count == 0
    opened = add(sphere.clamped('u'))
    joint, = surveys.survey_of(opened.data).joints
    assert joint.name == "u start · u end" and joint.continuity.g == 2


def test_a_net_that_is_dragged_shows_what_becomes_of_the_seam():
    ob = add(pair(0.0))
    held = enter()
    before = panel.kind(surveys.survey_of(ob.data).joints[0])
    assert overlay.patch_shape_of(held) == ob
    select(held, 17)
    move(0, 0, 1)
    now = surveys.survey_of(ob.data)
    leave()
    assert before == "C2 G2"
    assert any(panel.kind(joint) != before for joint in now.joints) or now.count == 1


def test_shapes_without_seams_or_patches_have_none():
    assert surveys.survey_of(add(VALUES['bezier patch']()).data).count == 0
    assert overlay.patch_shape_of(add(VALUES['nurbs']())) is None and overlay.patch_shape_of(None) is None
