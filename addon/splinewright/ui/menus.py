"""The menus of ui.menu_table as Blender's, and our entries in Blender's own menus."""

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


def _draw_curve_add(self, context):
    self.layout.separator()
    draw_link(self.layout, menu_table.ADD_CURVE)


def _draw_surface_add(self, context):
    self.layout.separator()
    draw_link(self.layout, menu_table.ADD_SURFACE)


def _draw_vertices(self, context):
    if not editing.nets_in_edit_mode(context):
        self.layout.separator()
        self.layout.operator("splinewright.curve_through_points", text="NURBS Curve Through Points")
        self.layout.operator("splinewright.contour_through_points", text="NURBS Contour Through Points")
        self.layout.operator("splinewright.fit_curve", text="Fit NURBS Curve")
        self.layout.operator("splinewright.fit_patch", text="Fit NURBS Patch")


def _draw_faces(self, context):
    if not editing.nets_in_edit_mode(context):
        self.layout.separator()
        self.layout.operator("splinewright.patch_through_grid", text="NURBS Patch Through Grid")


def _draw_import(self, context):
    self.layout.operator("splinewright.import_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.import_json", text="Splinewright Exact Curves and Patches (.spw.json)")


def _draw_export(self, context):
    self.layout.operator("splinewright.export_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.export_json", text="Splinewright Exact Curves and Patches (.spw.json)")
    self.layout.operator("splinewright.export_figure", text="Figure (.svg, .pdf)")


def _draw_apply(self, context):
    if object_kinds.selected(context) & object_kinds.SHAPES:
        self.layout.separator()
        self.layout.operator("splinewright.apply_transform", text="Transform of NURBS")


def _draw_convert(self, context):
    found = object_kinds.selected(context)
    if found:
        self.layout.separator()
    if object_kinds.INEXACT & found:
        self.layout.operator("splinewright.make_exact", text="NURBS Shape (Exact)")
    if any(map(read_polygons.is_mesh, context.selected_objects)):
        self.layout.operator("splinewright.add_of_mesh", text="NURBS from Mesh")
    if found & object_kinds.SHAPES:
        self.layout.operator("splinewright.to_native", text="Blender Curve/Surface from NURBS")


def _draw_object_header(self, context):
    if context.mode == 'OBJECT' and object_kinds.selected(context):
        self.layout.menu(menu_table.OBJECT.idname)


def _draw_object_context(self, context):
    if object_kinds.selected(context):
        self.layout.separator()
        draw_link(self.layout, menu_table.OBJECT)


def _draw_net_header(self, context):
    if editing.nets_in_edit_mode(context):
        self.layout.menu(menu_table.NET.idname)


def _draw_net_context(self, context):
    """On top of Blender's context menu."""
    if editing.nets_in_edit_mode(context):
        draw_link(self.layout, menu_table.NET)
        self.layout.separator()


def _draw_delete(self, context):
    """Blender's X takes points away, which a net has to keep."""
    if editing.nets_in_edit_mode(context):
        self.layout.operator("splinewright.delete_pieces", icon='SURFACE_DATA')
        self.layout.separator()


#: Blender's menus that ours are added to, at the end or before all else.
_PLACES = (
    ("VIEW3D_MT_curve_add", _draw_curve_add),
    ("VIEW3D_MT_surface_add", _draw_surface_add),
    ("VIEW3D_MT_object_context_menu", _draw_object_context),
    ("VIEW3D_MT_object_apply", _draw_apply),
    ("VIEW3D_MT_object_convert", _draw_convert),
    ("VIEW3D_MT_edit_mesh_vertices", _draw_vertices),
    ("VIEW3D_MT_edit_mesh_faces", _draw_faces),
    ("VIEW3D_MT_editor_menus", _draw_object_header),
    ("VIEW3D_MT_editor_menus", _draw_net_header),
    ("TOPBAR_MT_file_import", _draw_import),
    ("TOPBAR_MT_file_export", _draw_export),
)


_TOPS = (
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_net_context),
    ("VIEW3D_MT_edit_curve_context_menu", _draw_net_context),
    ("VIEW3D_MT_edit_mesh_delete", _draw_delete),
    ("VIEW3D_MT_edit_curve_delete", _draw_delete),
)


def register():
    for menu, draw in _PLACES:
        getattr(bpy.types, menu).append(draw)
    for menu, draw in _TOPS:
        getattr(bpy.types, menu).prepend(draw)


def unregister():
    for menu, draw in (*_PLACES, *_TOPS):
        getattr(bpy.types, menu).remove(draw)
