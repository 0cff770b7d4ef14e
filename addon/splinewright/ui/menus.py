"""Entries in Blender's menus."""

import bpy

from ..bridge import baking, shape
from ..core.recipes.table import DERIVED, FOLLOW, STARTING
from . import curve_tools, editing, patch_tools, tools

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


_SHAPES = {'curve', 'patch'}
_ALL = {'curve', 'patch', 'native', 'baked'}


def _kinds(context):
    """What is selected of what entries concern: shapes of curves or patches, baked ones, Blender's own objects."""
    found = set()
    for ob in context.selected_objects:
        if shape.has_shape(ob):
            found.add('curve' if ob.type == 'CURVE' else 'patch')
        elif baking.is_baked(ob.data):
            found.add('baked')
        elif ob.type in ('CURVE', 'SURFACE'):
            found.add('native')
    return found


def _draw_apply(self, context):
    if _kinds(context) & _SHAPES:
        self.layout.separator()
        self.layout.operator("splinewright.apply_transform", text="Splinewright: Transform into Definition")


def _draw_convert(self, context):
    kinds = _kinds(context)
    if kinds:
        self.layout.separator()
    if 'native' in kinds:
        self.layout.operator("splinewright.make_exact", text="Splinewright: Make Exact")
    if kinds & _SHAPES:
        self.layout.operator("splinewright.to_native", text="Splinewright: To Blender's Own")


#: Names of operators and menus, with what they concern, in groups.
_ENTRIES = (
    (('edit_net', _SHAPES), ('insert_here', _SHAPES), ('set_knots', _SHAPES), ('pick_piece', _SHAPES),
     (curve_tools.SPLINEWRIGHT_MT_curve, {'curve'}), (patch_tools.SPLINEWRIGHT_MT_patch, {'patch'})),
    (('make_exact', {'native'}), ('to_native', _SHAPES), ('follow_object', _SHAPES | {'native'}), ('make_editable', _SHAPES),
     ('bake_animation', _SHAPES), ('unbake', {'baked'})),
    tuple((f"add_{recipe.kind}", {'curve', 'native'}) for recipe in DERIVED if recipe is not FOLLOW),
    (('join', _SHAPES), ('apply_transform', _SHAPES), ('adopt_transform', _SHAPES)),
    (('restore', _SHAPES), ('detach', _SHAPES)))
_ENTRY_ICONS = {'edit_net': 'EDITMODE_HLT', 'follow_object': 'LINKED', 'pick_piece': 'EYEDROPPER',
                curve_tools.SPLINEWRIGHT_MT_curve: 'CURVE_DATA', patch_tools.SPLINEWRIGHT_MT_patch: 'SURFACE_DATA'}


def _draw_entries(layout, kinds):
    """Those that concern one of these kinds."""
    layout.operator_context = 'INVOKE_REGION_WIN'
    groups = [[entry for entry, concerned in group if concerned & kinds] for group in _ENTRIES]
    for i, group in enumerate(filter(None, groups)):
        if i:
            layout.separator()
        for entry in group:
            icon = _ENTRY_ICONS.get(entry, 'NONE')
            if isinstance(entry, str):
                layout.operator(f"splinewright.{entry}", text=tools.text_of(entry), icon=icon)
            else:
                layout.menu(entry.bl_idname, icon=icon)


class SPLINEWRIGHT_MT_object(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_object"
    bl_label = "Splinewright"

    def draw(self, context):
        _draw_entries(self.layout, _ALL)


class SPLINEWRIGHT_MT_object_context(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_object_context"
    bl_label = "Splinewright"

    def draw(self, context):
        _draw_entries(self.layout, _kinds(context))


def _draw_object(self, context):
    """In the Object menu, where what cannot be done is grey and says why."""
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_object.bl_idname, icon='SURFACE_DATA')


def _draw_object_context(self, context):
    if _kinds(context):
        self.layout.separator()
        self.layout.menu(SPLINEWRIGHT_MT_object_context.bl_idname, icon='SURFACE_DATA')


class SPLINEWRIGHT_MT_net(bpy.types.Menu):
    """While a net is edited: in the header, and on top of Blender's context menu."""

    bl_idname = "SPLINEWRIGHT_MT_net"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        layout.operator("splinewright.leave_net", icon='CHECKMARK')
        layout.operator("splinewright.renew_net", icon='FILE_REFRESH')
        layout.separator()
        layout.operator("splinewright.insert_here")
        layout.operator("splinewright.set_knots")
        layout.operator("splinewright.point_to_infinity")
        layout.operator("splinewright.point_from_infinity")
        layout.separator()
        tools = curve_tools if isinstance(context.object.data, bpy.types.Curve) else patch_tools
        tools.draw_verbs(layout)


def _draw_net(self, context):
    if editing.nets_in_edit_mode(context):
        self.layout.menu(SPLINEWRIGHT_MT_net.bl_idname, icon='SURFACE_DATA')
        self.layout.separator()


def _draw_net_header(self, context):
    if editing.nets_in_edit_mode(context):
        self.layout.menu(SPLINEWRIGHT_MT_net.bl_idname)


CLASSES = (SPLINEWRIGHT_MT_curve_add, SPLINEWRIGHT_MT_surface_add, SPLINEWRIGHT_MT_object,
           SPLINEWRIGHT_MT_object_context, SPLINEWRIGHT_MT_net)

#: Blender's menus that ours are added to, at the end or before all else.
_PLACES = (
    ("VIEW3D_MT_curve_add", _draw_curve_add),
    ("VIEW3D_MT_surface_add", _draw_surface_add),
    ("VIEW3D_MT_object", _draw_object),
    ("VIEW3D_MT_object_context_menu", _draw_object_context),
    ("VIEW3D_MT_object_apply", _draw_apply),
    ("VIEW3D_MT_object_convert", _draw_convert),
    ("VIEW3D_MT_editor_menus", _draw_net_header),
    ("TOPBAR_MT_file_import", _draw_import),
    ("TOPBAR_MT_file_export", _draw_export),
)


_TOPS = (
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_net),
    ("VIEW3D_MT_edit_curve_context_menu", _draw_net),
)


def register():
    for menu, draw in _PLACES:
        getattr(bpy.types, menu).append(draw)
    for menu, draw in _TOPS:
        getattr(bpy.types, menu).prepend(draw)


def unregister():
    for menu, draw in (*_PLACES, *_TOPS):
        getattr(bpy.types, menu).remove(draw)
