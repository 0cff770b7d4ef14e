"""The panel in the properties of object data shows what is pinned there, and no button that would take another object."""

import types

import bpy
import numpy as np
import pytest

from layouts import drawn_by
from shapes import VALUES, activate, add, enter, leave, op, require_exact, shown
from support import part

panels, shape = part('ui.panels'), part('bridge.shape.shape')
PANEL = panels.SPLINEWRIGHT_PT_data


def context(data=None, ob=None):
    """Of the properties editor: measured in 3.4, 4.3 and 5.2, an object is there only where it is in the path."""
    data = ob.data if ob else data
    return types.SimpleNamespace(
        object=ob, active_object=bpy.context.view_layer.objects.active,
        mesh=data if isinstance(data, bpy.types.Mesh) else None,
        curve=data if isinstance(data, bpy.types.Curve) else None)


@pytest.mark.parametrize('name', ('nurbs patch', 'teapot', 'nurbs', 'hermite'))
def test_pinned_data_are_shown_with_their_settings_and_without_buttons(name):
    pinned = add(VALUES[name](), "pinned")
    add(VALUES['bezier patch'](), "active")
    here = context(pinned.data)
    assert PANEL.poll(here)
    layout = drawn_by(PANEL, here)
    assert "resolution_u" in layout.props and not layout.operators
    assert any("Pinned" in text for text in layout.texts)
    kind = "curve" if pinned.type == 'CURVE' else "patch"
    assert any(kind in text.lower() for text in layout.texts), layout.texts


@pytest.mark.parametrize('mode', ('COUNT', 'TOLERANCE'))
def test_an_object_that_is_pinned_and_not_active_has_no_buttons_either(mode):
    pinned = add(VALUES['teapot'](), "pinned")
    for name in ("red", "blue"):
        pinned.data.materials.append(bpy.data.materials.new(name))
    pinned.data.splinewright.mode = mode
    assert {"splinewright.edit_net", "splinewright.set_patch_material"} <= set(drawn_by(PANEL, context(ob=pinned)).operators)
    add(VALUES['bezier patch'](), "active")
    assert not drawn_by(PANEL, context(ob=pinned)).operators


def test_what_is_pinned_is_changed_and_the_active_object_is_not():
    pinned, other = add(VALUES['nurbs patch'](), "pinned"), add(VALUES['nurbs patch'](), "active")
    before = shown(other).copy()
    pinned.data.splinewright.resolution_u = 9
    require_exact(pinned)
    assert np.array_equal(shown(other), before)


def test_pinned_data_that_are_no_shape_have_no_panel_whatever_is_active():
    ob = add(VALUES['nurbs patch'](), "active")
    assert PANEL.poll(context(ob=ob))
    for data in (bpy.data.meshes.new("plain"), bpy.data.curves.new("plain", 'CURVE'),
                 bpy.data.curves.new("text", 'FONT'), bpy.data.curves.new("surface", 'SURFACE')):
        assert not PANEL.poll(context(data))
    assert not PANEL.poll(context())


def test_the_shape_of_a_net_that_is_out_stays_pinned_and_follows():
    ob = add(VALUES['nurbs patch'](), "pinned")
    held = enter()
    layout = drawn_by(PANEL, context(ob.data))
    assert "resolution_u" in layout.props and not layout.operators
    assert "splinewright.leave_net" in drawn_by(PANEL, context(ob=held)).operators
    ob.data.splinewright.resolution_u = 9
    leave()
    require_exact(ob)


def test_the_numbers_of_a_pinned_recipe_are_there_and_those_of_a_touched_shape_are_not():
    op(bpy.ops.splinewright.add_torus)
    ob = bpy.context.object
    add(VALUES['bezier patch'](), "active")
    assert any(name.startswith("torus_") for name in drawn_by(PANEL, context(ob.data)).props)
    ob.data.vertices[0].co.x += 1
    ob.data.update()
    bpy.context.view_layer.update()
    layout = drawn_by(PANEL, context(ob.data))
    assert any("by hand" in text for text in layout.texts) and not any(name.startswith("torus_") for name in layout.props)


def test_a_damaged_definition_is_said_where_it_is_pinned():
    ob = add(VALUES['nurbs patch'](), "pinned")
    del ob.data["splinewright_definition"]["pool"]
    other = add(VALUES['bezier patch'](), "active")
    activate(other)
    assert any("damaged" in text for text in drawn_by(PANEL, context(ob.data)).texts)
