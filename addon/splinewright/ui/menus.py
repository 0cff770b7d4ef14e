"""The menus and places of ui.menu_table as Blender has them."""

import bpy

from ..bridge.shape import read_polygons
from ..core.base.words import say
from . import active_shape, editing, menu_table, object_kinds, offered


def _draw_menu(layout, menu, context):
    """What of a menu concerns the selection, or all of it where nothing of the add-on is; what would be refused is gray."""
    layout.operator_context = 'INVOKE_REGION_WIN'
    drawn, is_parted = 0, False
    for entry in menu.entries:
        if entry is None:
            is_parted = drawn > 0
        elif _is_shown(entry, context):
            if is_parted:
                layout.separator()
            _draw_entry(layout, entry, context)
            drawn, is_parted = drawn + 1, False


def _draw_entry(layout, entry, context):
    if isinstance(entry, menu_table.Menu):
        layout.menu(entry.idname, icon=entry.icon)
        return
    if isinstance(entry, menu_table.Native):
        layout.operator(entry.operator)
        return
    row = layout.row()
    row.enabled = not offered.is_gray(entry, active_shape.shapes(context))
    button = row.operator(f"splinewright.{entry.operator}", text=say(entry.text or offered.text_of(entry.operator)), icon=entry.icon)
    for name, value in entry.settings:
        setattr(button, name, value)


def _is_shown(entry, context):
    if isinstance(entry, menu_table.Menu):
        return any(_is_shown(below, context) for below in menu_table.entries_in(entry))
    if isinstance(entry, menu_table.Native):
        return context.mode in entry.modes and bool(editing.nets_in_edit_mode(context))
    nets = editing.nets_in_edit_mode(context)
    if entry.concerns is menu_table.ANY:
        return True
    if nets and not offered.works_on_nets(entry.operator):
        return False
    found = set(map(object_kinds.of, active_shape.shapes(context))) if nets else object_kinds.selected(context)
    return not found or bool(entry.concerns & found)


def _class_of(menu):
    def draw(self, context):
        _draw_menu(self.layout, menu, context)
    return type(menu.idname, (bpy.types.Menu,), {'bl_idname': menu.idname, 'bl_label': menu.label, 'draw': draw})


CLASSES = tuple(map(_class_of, menu_table.MENUS))


def draw_link(layout, menu, **more):
    """The entry that opens a menu of ui.menu_table."""
    layout.menu(menu.idname, icon=menu.icon, **more)


# Blender's own menus ------------------------------------------------------------------------------


def _draw_place(layout, place, context):
    """The entries that concern the selection; those that would be refused are gray."""
    entries = _entries_now(place, context)
    if entries and place.has_line and not place.is_first:
        layout.separator()
    for entry in entries:
        if place.is_header:
            layout.menu(entry.idname)
        else:
            _draw_entry(layout, entry, context)
    if entries and place.has_line and place.is_first:
        layout.separator()


def _entries_now(place, context):
    has_nets, selected = bool(editing.nets_in_edit_mode(context)), object_kinds.selected(context)
    if not {'NETS': has_nets, 'OTHERS': not has_nets, 'OBJECT': context.mode == 'OBJECT' and bool(selected)}.get(place.mode, True):
        return []
    selected |= {'mesh'} if any(map(read_polygons.is_mesh, context.selected_objects)) else set()
    return [entry for entry in place.entries
            if place.mode == 'NETS' or isinstance(entry, menu_table.Menu) or entry.concerns is menu_table.ANY or entry.concerns & selected]


def _drawing(place):
    def draw(self, context):
        _draw_place(self.layout, place, context)
    return draw


#: (Blender's menu, what draws our entries there), of each Place.
_AT_ENDS, _FIRST = (tuple((place.menu, _drawing(place)) for place in menu_table.PLACES if place.is_first == is_first)
                    for is_first in (False, True))


def register():
    for menu, draw in _AT_ENDS:
        getattr(bpy.types, menu).append(draw)
    for menu, draw in _FIRST:
        getattr(bpy.types, menu).prepend(draw)


def unregister():
    for menu, draw in (*_AT_ENDS, *_FIRST):
        getattr(bpy.types, menu).remove(draw)
