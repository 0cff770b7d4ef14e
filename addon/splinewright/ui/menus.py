"""Entries in Blender's menus."""

import bpy

from ..bridge.net import net_object
from ..core.recipes.table import DERIVED, FOLLOW, STARTING
from . import curve_tools, patch_tools

#: Conics come before it, splines and formulas from it on.
_FIRST_SPLINE = 'catmull_rom'
_ICONS = {'circle': 'MESH_CIRCLE', 'arc': 'SPHERECURVE', 'ellipse': 'MESH_CIRCLE', 'formula': 'FILE_TEXT',
          'helix': 'FORCE_VORTEX', 'parabola': 'SMOOTHCURVE', 'plane': 'MESH_PLANE', 'cylinder': 'MESH_CYLINDER',
          'cone': 'MESH_CONE', 'sphere': 'MESH_UVSPHERE', 'torus': 'MESH_TORUS', 'surface_formula': 'FILE_TEXT'}


class SPLINEWRIGHT_MT_curve_add(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_curve_add"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        layout.operator("splinewright.add_bezier_curve", text="Bezier Curve", icon='CURVE_BEZCURVE')
        layout.operator("splinewright.add_hermite_curve", text="Hermite Chain", icon='CURVE_PATH')
        layout.operator("splinewright.add_nurbs_curve", text="NURBS Curve", icon='CURVE_NCURVE')
        layout.separator()
        for recipe in (recipe for recipe in STARTING if not recipe.is_surface):
            if recipe.kind == _FIRST_SPLINE:
                layout.separator()
            icon = _ICONS.get(recipe.kind, 'CURVE_DATA')
            layout.operator(f"splinewright.add_{recipe.kind}", text=recipe.label, icon=icon)


class SPLINEWRIGHT_MT_surface_add(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_surface_add"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        layout.operator("splinewright.add_bezier_patch", text="Bezier Patch", icon='MESH_GRID')
        layout.operator("splinewright.add_hermite_patch", text="Hermite Patch", icon='SURFACE_NSURFACE')
        layout.operator("splinewright.add_nurbs_patch", text="NURBS Patch", icon='SURFACE_DATA')
        layout.separator()
        for recipe in (recipe for recipe in STARTING if recipe.is_surface):
            icon = _ICONS.get(recipe.kind, 'SURFACE_DATA')
            layout.operator(f"splinewright.add_{recipe.kind}", text=recipe.label, icon=icon)
        layout.separator()
        layout.operator("splinewright.add_teapot", text="Newell's Teapot", icon='MESH_UVSPHERE')


def _draw_curve_add(self, context):
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_curve_add.bl_idname, icon='CURVE_DATA')


def _draw_surface_add(self, context):
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_surface_add.bl_idname, icon='SURFACE_DATA')


def _draw_import(self, context):
    self.layout.operator("splinewright.import_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.import_json", text="Splinewright Exact Curves and Patches (.json)")


def _draw_export(self, context):
    self.layout.operator("splinewright.export_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.export_json", text="Splinewright Exact Curves and Patches (.json)")


def _draw_apply(self, context):
    self.layout.separator()
    self.layout.operator("splinewright.apply_transform", text="Splinewright: Transform into Definition")


def _draw_convert(self, context):
    self.layout.separator()
    self.layout.operator("splinewright.make_exact", text="Splinewright: Make Exact")
    self.layout.operator("splinewright.to_native", text="Splinewright: To Blender's Own")


class SPLINEWRIGHT_MT_object(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_object"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        layout.operator("splinewright.edit_net", icon='EDITMODE_HLT')
        layout.operator("splinewright.set_knots")
        layout.menu(curve_tools.SPLINEWRIGHT_MT_curve.bl_idname, icon='CURVE_DATA')
        layout.menu(patch_tools.SPLINEWRIGHT_MT_patch.bl_idname, icon='SURFACE_DATA')
        layout.separator()
        layout.operator("splinewright.make_exact")
        layout.operator("splinewright.to_native")
        layout.operator("splinewright.follow_object", icon='LINKED')
        layout.operator("splinewright.make_editable")
        layout.operator("splinewright.bake_animation")
        layout.operator("splinewright.unbake")
        layout.separator()
        for recipe in DERIVED:
            if recipe is not FOLLOW:
                layout.operator(f"splinewright.add_{recipe.kind}", text=recipe.label)
        layout.separator()
        layout.operator("splinewright.join")
        layout.operator("splinewright.apply_transform")
        layout.operator("splinewright.adopt_transform")
        layout.separator()
        layout.operator("splinewright.restore")
        layout.operator("splinewright.detach")


def _draw_object(self, context):
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_object.bl_idname, icon='SURFACE_DATA')


def _draw_net(self, context):
    if any(net_object.is_net(ob) for ob in context.objects_in_mode):
        self.layout.operator("splinewright.leave_net")
        self.layout.operator("splinewright.point_to_infinity")
        self.layout.operator("splinewright.point_from_infinity")
        self.layout.separator()


CLASSES = (SPLINEWRIGHT_MT_curve_add, SPLINEWRIGHT_MT_surface_add, SPLINEWRIGHT_MT_object)

_ENTRIES = (
    ("VIEW3D_MT_curve_add", _draw_curve_add),
    ("VIEW3D_MT_surface_add", _draw_surface_add),
    ("VIEW3D_MT_object", _draw_object),
    ("VIEW3D_MT_object_context_menu", _draw_object),
    ("VIEW3D_MT_object_apply", _draw_apply),
    ("VIEW3D_MT_object_convert", _draw_convert),
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_net),
    ("VIEW3D_MT_edit_curve_context_menu", _draw_net),
    ("TOPBAR_MT_file_import", _draw_import),
    ("TOPBAR_MT_file_export", _draw_export),
)


def register():
    for menu, draw in _ENTRIES:
        getattr(bpy.types, menu).append(draw)


def unregister():
    for menu, draw in _ENTRIES:
        getattr(bpy.types, menu).remove(draw)
