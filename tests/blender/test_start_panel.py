"""The sidebar has something to do in every state, and what it offers is done."""

import bpy
import pytest

from curves import value_of
from layouts import Layout, drawn_by, panels
from natives import native_curve
from shapes import activate, add, enter, op
from support import part, splinecore as sc

start_panel = part('ui.start_panel')
menu_table = part('ui.menu_table')


def curve():
    return add(value_of('cubic'))


def patch():
    return add(sc.build.extrude(value_of('cubic'), (0.5, 0.2, 3.0)))


def surface():
    bpy.ops.surface.primitive_nurbs_surface_surface_add()
    return bpy.context.object


def cube():
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.object


def text():
    bpy.ops.object.text_add()
    bpy.context.object.data.body = "Oi"
    return bpy.context.object


STATES = {
    'nothing': ((), set()),
    'a cube': ((cube,), set()),
    'a curve of Blender': ((native_curve,), {'make_exact', 'follow_object', 'add_revolve', 'add_extrude', 'add_pipe'}),
    'a surface of Blender': ((surface,), {'make_exact', 'follow_object'}),
    'two curves of Blender': ((native_curve, native_curve), {'make_exact', 'follow_object', 'add_ruled', 'add_loft', 'add_sweep'}),
    'a curve': ((curve,), {'add_revolve', 'add_extrude', 'add_pipe', 'follow_object', 'add_mirror'}),
    'a patch': ((patch,), {'follow_object', 'add_mirror', 'add_offset_surface', 'add_thickened'}),
    'two curves': ((curve, curve), {'join_ends', 'join', 'add_ruled', 'add_loft', 'add_sweep'}),
    'two patches': ((patch, patch), {'join_patches', 'join', 'add_surface_blend', 'add_matched'}),
    'three curves': ((curve, curve, curve), {'join', 'add_loft', 'add_sweep'}),
    'a curve and a patch': ((patch, curve), set()),
    'a curve and one of Blender': ((native_curve, curve), {'make_exact', 'follow_object', 'add_ruled', 'add_loft', 'add_sweep'}),
    'a curve and a cube': ((cube, curve), {'add_revolve', 'add_extrude', 'add_pipe'}),
    'a text': ((text,), {'make_exact'}),
}
OFFERED = [(state, name) for state, (_, names) in STATES.items() for name in sorted(names)]


def made(state):
    obs = [make() for make in STATES[state][0]]
    for i, ob in enumerate(obs):
        ob.location.x = 3.0 * i
    bpy.ops.object.select_all(action='DESELECT')
    if obs:
        activate(*obs)
        bpy.context.view_layer.update()


def drawn():
    return drawn_by(start_panel.SPLINEWRIGHT_PT_start, bpy.context)


@pytest.mark.parametrize('state', STATES)
def test_what_is_offered(state):
    made(state)
    assert start_panel.SPLINEWRIGHT_PT_start.poll(bpy.context)
    layout = drawn()
    is_empty = not STATES[state][0] or state == 'a cube'
    assert {name.partition(".")[2] for name in layout.operators} == (STATES[state][1] or ({'add_sample', 'start_lesson', 'manual'} if is_empty else set()))
    assert start_panel.SPLINEWRIGHT_PT_start_add.poll(bpy.context) == is_empty


def test_with_nothing_there_are_three_buttons_and_the_rest_is_folded():
    layout = drawn()
    assert [name.partition(".")[2] for name in layout.operators] == ['add_sample', 'manual', 'start_lesson'] and not layout.menus
    rest = start_panel.SPLINEWRIGHT_PT_start_add
    assert 'DEFAULT_CLOSED' in rest.bl_options and rest.bl_parent_id == start_panel.SPLINEWRIGHT_PT_start.bl_idname
    layout = drawn_by(rest, bpy.context)
    assert layout.menus == [menu_table.ADD_CURVE.idname, menu_table.ADD_SURFACE.idname] and layout.operators == ["splinewright.import_json"]


@pytest.mark.parametrize('state, names', [
    ('a curve', {'add_filling', 'add_offset', 'add_section'}),
    ('two curves', {'add_two_rails', 'add_blend', 'add_touching_circle'}),
    ('three curves', {'add_network', 'add_filling', 'add_two_rails'}),
    ('two curves of Blender', {'add_network', 'add_filling'}),
    ('a patch', {'cap', 'add_section', 'add_extended_surface', 'extract_isocurve'}),
    ('two patches', {'add_rounded_edge', 'add_filling', 'add_section'}),
    ('a curve and a patch', {'add_on_patch', 'add_projected', 'add_rounded_edge'}),
    ('a surface of Blender', {'add_rounded_edge', 'add_offset_surface'})])
def test_menus_have_the_rest(state, names):
    made(state)
    shown = drawn().menus
    entries = [entry.operator for menu in menu_table.MENUS if menu.idname in shown for entry in menu_table.operators_in(menu)]
    assert names <= set(entries)


@pytest.mark.parametrize('state, name', OFFERED)
def test_what_is_offered_is_done(state, name):
    made(state)
    operator = getattr(bpy.ops.splinewright, name)
    assert operator.poll() and op(operator) == {'FINISHED'}


def test_other_modes_say_what_to_do():
    ob = native_curve()
    activate(ob)
    bpy.ops.object.mode_set(mode='EDIT')
    layout = drawn()
    bpy.ops.object.mode_set(mode='OBJECT')
    assert "Object Mode" in " ".join(layout.texts) and not layout.operators


def test_a_net_has_its_own_panel():
    curve()
    enter()
    assert not start_panel.SPLINEWRIGHT_PT_start.poll(bpy.context)
    assert any(panel.poll(bpy.context) for panel in panels() if hasattr(panel, 'poll'))


def test_long_names_of_numbers_stand_before_their_fields():
    activate(patch(), patch())
    bpy.context.selected_objects[0].location.y = 5.0
    bpy.context.view_layer.update()
    op(bpy.ops.splinewright.add_surface_blend)
    layout = Layout()
    part('ui.recipe_props').draw(layout, bpy.context.object.data)
    assert "Second Strength" in layout.texts and 'surface_blend_second_strength' in layout.props
