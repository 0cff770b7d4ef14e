"""Revolves and circles to be sculpted, and the creases that the panel lists where exact ones were pulled."""

import bpy
import numpy as np
import pytest

from layouts import drawn_by, sidebar
from shapes import activate, add, enter, leave, op, require_exact
from support import part, splinecore as sc
from test_files import reopen, save
from test_surfaces import add_recipe

overlay, recipes, surveys = part('ui.seams_overlay'), part('bridge.recipes.recipes'), part('bridge.analysis.surveys')


def vase(**settings):
    activate(add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(1, 0, 0), (1.5, 0, 1), (0.5, 0, 2), (0.8, 0, 2.5), (1, 0, 3)])))
    return add_recipe('revolve', **settings)


def pull(ob):
    activate(ob)
    if recipes.has(ob.data):
        op(bpy.ops.splinewright.make_editable)
    u = ob.data.splinewright.value.domain[0]
    assert op(bpy.ops.splinewright.pull_here, piece=1, parameter_u=u[0] + 0.22 * (u[1] - u[0]), parameter_v=1.0,
              vector=(0.4, 0.2, 0)) == {'FINISHED'}


def test_a_revolve_is_exact_unless_asked_and_says_how_near_it_is():
    ob = vase()
    assert recipes.read(ob.data).values['deformable'] is False
    assert 1e-4 < recipes.read(ob.data).values['tolerance'] < 1e-2      # by its size
    before = ob.data.splinewright.value
    ob.data.splinewright_parameters.revolve_deformable = True
    after = ob.data.splinewright.value
    require_exact(ob)
    assert after != before and (after.weights == 1).all() and after.periodic[0]
    assert any("ithin" in text for text in sidebar(bpy.context).texts)
    ob.data.splinewright_parameters.revolve_tolerance = 1e-5
    assert len(ob.data.splinewright.value.points) > len(after.points)


def test_a_pulled_exact_one_lists_its_creases_and_colors_them():
    ob = vase()
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "No seams" in drawn.texts and "4 knots inside" in " ".join(drawn.texts)
    pull(ob)
    survey = surveys.survey_of(ob.data)
    assert survey.count and all(joint.name.startswith("crease u") for joint in survey.joints)
    drawn = drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context)
    assert "crease u 1" in drawn.texts and "splinewright.hold_seam" not in drawn.operators
    assert len(overlay.colored_lines(ob.data)) == survey.count
    enter()
    assert "crease u 1" in drawn_by(bpy.types.SPLINEWRIGHT_PT_continuity, bpy.context).texts
    leave()


def test_a_pulled_deformable_one_stays_smooth(tmp_path):
    ob = vase(deformable=True)
    pull(ob)
    name = ob.name
    assert surveys.survey_of(ob.data)[1:] == (0, 0)
    save(tmp_path / "soft.blend")
    reopen(tmp_path / "soft.blend")
    assert surveys.survey_of(bpy.data.objects[name].data)[1:] == (0, 0)


@pytest.mark.parametrize('kind', ('circle', 'ellipse'))
def test_circles_and_ellipses_may_be_deformable(kind):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}")) == {'FINISHED'}
    ob = bpy.context.object
    setattr(ob.data.splinewright_parameters, f"{kind}_form", 'deformable')
    value = ob.data.splinewright.value
    assert value.periodic and value.degree == 3 and (value.weights == 1).all()
    require_exact(ob)
    assert np.isfinite(value.points).all()


def deformed(ob, **settings):
    activate(ob)
    assert op(bpy.ops.splinewright.make_deformable, **settings) == {'FINISHED'}
    return ob.data.splinewright.value


@pytest.mark.parametrize('kind', ('sphere', 'torus', 'cylinder', 'cone', 'circle', 'ellipse'))
def test_recipes_get_it_in_their_panel_and_go_on(kind):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}")) == {'FINISHED'}
    ob = bpy.context.object
    deformed(ob, tolerance=1e-4)
    require_exact(ob)
    stored = recipes.read(ob.data)
    assert stored.recipe.kind == kind and 0 < stored.error <= 1e-4
    with pytest.raises(RuntimeError, match="already"):
        op(bpy.ops.splinewright.make_deformable)
    setattr(ob.data.splinewright_parameters, *((f"{kind}_deformable", False) if kind not in ('circle', 'ellipse')
                                              else (f"{kind}_form", 'square')))
    assert recipes.error(ob.data) == 0
    require_exact(ob)


@pytest.mark.parametrize('kind', ('sphere', 'torus', 'cylinder', 'cone', 'circle', 'ellipse'))
def test_made_editable_they_become_deformable_and_stay_smooth_when_pulled(kind):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}")) == {'FINISHED'}
    ob = bpy.context.object
    op(bpy.ops.splinewright.make_editable)
    value = deformed(ob)
    pieces = [value[i] for i in range(len(value))] if hasattr(value, '__len__') else [value]
    assert all((piece.weights == 1).all() for piece in pieces)
    require_exact(ob)
    with pytest.raises(RuntimeError, match="nothing would change"):
        op(bpy.ops.splinewright.make_deformable)
    if kind in ('sphere', 'torus'):
        pull(ob)
        assert surveys.survey_of(ob.data).count == 0


def test_what_follows_without_such_a_parameter_is_refused_by_name():
    activate(add(sc.conics.circle((0, 0, 0), 1.0)))
    assert op(bpy.ops.splinewright.add_extrude) == {'FINISHED'}
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.make_deformable)
    op(bpy.ops.splinewright.make_editable)
    assert (deformed(bpy.context.object).weights == 1).all()
