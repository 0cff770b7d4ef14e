"""What can be made of the selection, or from nothing, in the sidebar: there is something to do in every state."""

import bpy

from ..bridge.lessons import stage
from ..core.base.words import say
from . import editing, menu_table, menus, object_kinds, offered, texts
from .operators import add_sample
from .sub_panel import ClosedPanel

#: Labels and operators by what is selected.
_NATIVE = ("Exact", ('make_exact', 'follow_object'))
_FROM_ONE = ("Surface", ('add_revolve', 'add_extrude', 'add_pipe'))
_FROM_TWO = ("Surface", ('add_ruled', 'add_loft', 'add_sweep'))
_FROM_MANY = ("Surface", ('add_loft', 'add_sweep'))
_FROM_PATCH = ("Surface", ('add_offset_surface', 'add_thickened'))
_FROM_PATCHES = ("Surface", ('add_surface_blend', 'add_matched'))
_FOLLOW = ("Copy", ('follow_object', 'add_mirror'))
_JOIN = {'curve': ("Join", ('join_ends', 'join')), 'patch': ("Join", ('join_patches', 'join'))}
_JOIN_MANY = ("Join", ('join',))


def groups(obs, active):
    """Pairs of a label and names of operators, for the selected objects and the active one."""
    found = [object_kinds.of(ob) for ob in obs]
    count = {kind: found.count(kind) for kind in object_kinds.ALL | object_kinds.INEXACT}
    curves = sum(ob.type == 'CURVE' for ob in obs if object_kinds.of(ob) in ('curve', 'native'))
    made = [_NATIVE] if count['native'] and object_kinds.of(active) in object_kinds.FOLLOWED else []
    made += [("Exact", ('make_exact',))] if count['native'] + count['text'] and not made else []
    for kind in sorted(object_kinds.SHAPES):
        if count[kind] > 1 and active in obs and object_kinds.of(active) == kind:
            made.append(_JOIN[kind] if len(obs) == 2 else _JOIN_MANY)
    others = sum(count[kind] for kind in object_kinds.FOLLOWED) - curves
    if curves == 1 and not others:
        made.append(_FROM_ONE)
    if curves == 2 and not others:
        made.append(_FROM_TWO)
    if curves > 2 and not others:
        made.append(_FROM_MANY)
    if others == count['patch'] == len(obs) > 0 and len(obs) <= 2:
        made.append(_FROM_PATCH if len(obs) == 1 else _FROM_PATCHES)
    if len(obs) == 1 and count['curve'] + count['patch'] == 1 and active in obs:
        made.append(_FOLLOW)
    return made


def menus_for(obs):
    """Pairs of a text and a menu: all that can be made of the selected objects."""
    found = {object_kinds.of(ob) for ob in obs}
    curves = any(ob.type == 'CURVE' for ob in obs if object_kinds.of(ob) in ('curve', 'native'))
    surfaces = 'patch' in found or any(ob.type == 'SURFACE' for ob in obs)
    made = [("Curve from Objects", menu_table.FROM_OBJECTS)] if curves or surfaces else []
    made += [("Surface from Curves", menu_table.FROM_CURVES)] if curves else []
    return made + ([("Surface from Surfaces", menu_table.FROM_SURFACES)] if surfaces else [])


def _is_empty(context):
    """Whether nothing is selected that something can be made of."""
    return context.mode == 'OBJECT' and not groups(context.selected_objects, context.object) and not menus_for(context.selected_objects)


class SPLINEWRIGHT_PT_start(bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_start"
    bl_label = "Make"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "NURBS"
    bl_order = 0

    @classmethod
    def poll(cls, context):
        return not editing.nets_in_edit_mode(context) and not (stage.lesson_of(context.scene) and _is_empty(context))

    def draw(self, context):
        layout = self.layout
        if context.mode != 'OBJECT':
            texts.draw_note(layout, "Shapes are made in Object Mode: leave the present mode first")
            return
        layout.operator_context = 'INVOKE_REGION_WIN'
        made = groups(context.selected_objects, context.object)
        more = menus_for(context.selected_objects)
        _draw_groups(layout, made)
        if more:
            _draw_menus(layout.column(align=True), more)
        elif not made:
            column = layout.box().column(align=True)
            add_sample.draw(column)
            column.operator("splinewright.manual", text="First Steps", icon='HELP').page = "five-minutes.html"
            column.operator("splinewright.start_lesson", text="First Lesson", icon='PLAY')


class SPLINEWRIGHT_PT_start_add(ClosedPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_start_add"
    bl_label = "Add"
    bl_parent_id = "SPLINEWRIGHT_PT_start"

    @classmethod
    def poll(cls, context):
        return _is_empty(context)

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        _draw_menus(layout.column(align=True), (("Curve", menu_table.ADD_CURVE), ("Surface", menu_table.ADD_SURFACE)))
        layout.operator("splinewright.import_json", text="Import", icon='IMPORT')


def _draw_groups(layout, made):
    for label, names in made:
        column = layout.column(align=True)
        column.label(text=say(label))
        for name in names:
            column.operator(f"splinewright.{name}", text=say(offered.text_of(name)))


def _draw_menus(column, linked):
    for text, menu in linked:
        menus.draw_link(column, menu, text=text)


CLASSES = (SPLINEWRIGHT_PT_start, SPLINEWRIGHT_PT_start_add)
