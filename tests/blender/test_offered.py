"""What would be refused is gray, and nothing else is."""

from types import SimpleNamespace

import bpy
import pytest

import patches
from curves import value_of
from layouts import Layout, drawn_by, panels
from natives import native_curve
from shapes import activate, add, op
from support import part

menus, menu_table = part('ui.menus'), part('ui.menu_table')
texts = part('ui.texts')

#: Refused with the settings they begin with, which the redo panel changes.
MENDED = {'make_periodic', 'remove_knots', 'reparameterize', 'split', 'remove_knot', 'to_hermite', 'clamp', 'unclamp', 'add_offset', 'trim_curve',
          'fillet_corners', 'chamfer_corners', 'fillet_curves', 'chamfer_curves', 'extend_curve', 'split_where_met', 'intersections',
          'add_touching_circle', 'join_curves', 'add_offset_surface', 'add_thickened', 'add_extended_surface', 'cap', 'make_deformable'}
#: Only the work itself tells whether what was changed was moved as a whole, whether there is a hole to fill, or whether all of
#: several edges can be rounded; what was just made can be made with other settings.
TOLD_LATE = {('touched', 'adopt_transform'), ('revolved', 'add_revolve'), ('teapot', 'add_rounded_edge')}
#: They open a dialog, work on the view, or are told by the panel what is meant.
NOT_RUN = {'pick_piece', 'choose_function', 'insert_here', 'measure_here', 'pull_here', 'split_here', 'join_here', 'extract_here', 'extract_side_here',
           'trim_here', 'extend_here', 'fillet_here', 'chamfer_here', 'round_here', 'set_knots', 'manual', 'bake_animation', 'export_json', 'export_bpt',
           'hold_seam', 'release_seam', 'hold_joint', 'release_joint', 'use_tool', 'start_lesson', 'start_lesson_file', 'show_lesson_folder',
           'collect_answers', 'new_lesson'}
#: It leads to another object, and there is nothing to change then.
LEADS_AWAY = {'edit_source'}


def made(name):
    op(getattr(bpy.ops.splinewright, name))
    return bpy.context.object


def touched():
    ob = add(patches.value_of('bicubic'))
    ob.data.vertices[0].co.x += 1
    ob.data.update()
    return ob


def follower():
    native_curve()
    return made('follow_object')


def revolved():
    add(value_of('cubic'))
    return made('add_revolve')


def chain():
    ob = add(value_of('nurbs'))
    op(bpy.ops.splinewright.to_bezier)
    return ob


STATES = {
    'Bezier curve': lambda: add(value_of('cubic')), 'NURBS curve': lambda: add(value_of('nurbs')), 'chain': chain,
    'line': lambda: made('add_line'), 'Hermite': lambda: made('add_hermite_curve'), 'circle': lambda: made('add_circle'),
    'spline': lambda: made('add_catmull_rom'), 'follower': follower, 'Bezier patch': lambda: add(patches.value_of('bicubic')),
    'NURBS patch': lambda: made('add_nurbs_patch'), 'Hermite patch': lambda: made('add_hermite_patch'),
    'cylinder': lambda: made('add_cylinder'), 'teapot': lambda: made('add_teapot'), 'revolved': revolved, 'touched': touched}


TOLD_LATE |= {(state, name) for state in STATES for name in ('add_filling', 'add_lift')}


def begun(state):
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    activate(STATES[state]())
    bpy.context.view_layer.update()


def offered():
    """(operators that are offered, those of them that are gray) in the panels and the context menu."""
    layout = Layout()
    for panel in panels():
        if panel.poll(bpy.context):
            drawn = drawn_by(panel, bpy.context)
            layout.operators.extend(drawn.operators)
            layout.disabled.extend(drawn.disabled)
    for menu in menu_table.menus_in(menu_table.OBJECT):
        getattr(bpy.types, menu.idname).draw(SimpleNamespace(layout=layout), bpy.context)
    names = {name.partition(".")[2] for name in layout.operators}
    gray = {name.partition(".")[2] for name in layout.disabled}
    return names, gray | {name for name in names if not getattr(bpy.ops.splinewright, name).poll()}


def is_refused(name):
    try:
        return op(getattr(bpy.ops.splinewright, name)) != {'FINISHED'}
    except RuntimeError:
        return True
    finally:
        if bpy.context.mode != 'OBJECT':
            bpy.ops.object.mode_set(mode='OBJECT')


@pytest.mark.parametrize('state', STATES)
def test_what_would_be_refused_is_gray(state):
    begun(state)
    names, gray = offered()
    wrong = []
    for name in sorted(names - NOT_RUN):
        begun(state)
        if is_refused(name) != (name in gray) and not ((name in MENDED or (state, name) in TOLD_LATE) and name not in gray):
            wrong.append((name, "gray" if name in gray else "not gray"))
    assert len(names) > 5 and not wrong


def has_settings(name):
    settings = getattr(bpy.ops.splinewright, name).get_rna_type().properties
    return 'REGISTER' in getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}").bl_options and any(
        not (setting.is_hidden or setting.identifier == 'rna_type') for setting in settings)


@pytest.mark.parametrize('state', STATES)
def test_after_an_operator_its_settings_can_be_changed(state):
    """Blender asks poll() of what came of it before the panel at the lower left takes that back."""
    begun(state)
    names, gray = offered()
    without = []
    for name in sorted(names - gray - NOT_RUN - LEADS_AWAY):
        begun(state)
        if has_settings(name) and not is_refused(name) and not getattr(bpy.ops.splinewright, name).poll():
            without.append(name)
    assert not without, without


@pytest.mark.parametrize('state', STATES)
def test_sentences_in_panels_fit_the_sidebar_as_it_opens(state):
    begun(state)
    for panel in panels():
        if panel.poll(bpy.context):
            for text in drawn_by(panel, bpy.context).texts:
                assert len(text) <= texts.WIDTH + 5, text
