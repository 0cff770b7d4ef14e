"""Entries in Blender's menus."""

import bpy

from ..bridge import read_polygons
from ..core.recipes.table import DERIVED, FOLLOW, FROM_BOTH, FROM_CURVES, FROM_SURFACES, MEETING, STARTING
from . import curve_tools, editing, kinds, patch_tools, tools

#: What stands above all others, as most is begun with it.
_FIRST_CURVES = (('line', 'IPO_LINEAR'), ('bezier_curve', 'CURVE_BEZCURVE'), ('bezier_chain', 'CURVE_PATH'),
                 ('nurbs_curve', 'CURVE_NCURVE'), ('circle', 'MESH_CIRCLE'), ('arc', 'SPHERECURVE'))
#: Conics come before it, splines and formulas from it on.
_FIRST_SPLINE = 'interpolating'
_ICONS = {'ellipse': 'MESH_CIRCLE', 'formula': 'FILE_TEXT',
          'helix': 'FORCE_VORTEX', 'parabola': 'SMOOTHCURVE', 'plane': 'MESH_PLANE', 'cylinder': 'MESH_CYLINDER',
          'cone': 'MESH_CONE', 'sphere': 'MESH_UVSPHERE', 'torus': 'MESH_TORUS', 'surface_formula': 'FILE_TEXT'}
#: They need selected curves, and are grey without them.
_ICONS_OF_MADE = {'revolve': 'MOD_SCREW', 'extrude': 'MOD_SOLIDIFY', 'ruled': 'MOD_LATTICE', 'loft': 'MOD_ARRAY',
                  'sweep': 'CURVE_PATH', 'two_rails': 'CURVE_PATH', 'pipe': 'META_CAPSULE', 'network': 'MOD_LATTICE',
                  'filling': 'MESH_GRID', 'surface_blend': 'MOD_SMOOTH', 'matched': 'SNAP_EDGE', 'rounded_edge': 'MOD_BEVEL',
                  'offset_surface': 'MOD_OFFSET', 'thickened': 'MOD_SOLIDIFY', 'extended_surface': 'MOD_EDGESPLIT',
                  'of_mesh': 'MOD_SUBSURF', 'mirror': 'MOD_MIRROR'}


class SPLINEWRIGHT_MT_curve_add(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_curve_add"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        for name, icon in _FIRST_CURVES:
            layout.operator(f"splinewright.add_{name}", text=tools.text_of(f"add_{name}"), icon=icon)
        layout.separator()
        layout.operator("splinewright.add_hermite_curve", text="Hermite Chain", icon='CURVE_DATA')
        first = [name for name, _ in _FIRST_CURVES]
        for recipe in (recipe for recipe in STARTING if not recipe.is_surface and recipe.kind not in first):
            if recipe.kind == _FIRST_SPLINE:
                layout.separator()
            icon = _ICONS.get(recipe.kind, 'CURVE_DATA')
            layout.operator(f"splinewright.add_{recipe.kind}", text=recipe.label, icon=icon)
        layout.separator()
        layout.operator("splinewright.curve_through_points", text=tools.text_of("curve_through_points"), icon='SNAP_VERTEX')
        layout.operator("splinewright.contour_through_points", text=tools.text_of("contour_through_points"), icon='SNAP_VERTEX')
        layout.operator("splinewright.fit_curve", text=tools.text_of("fit_curve"), icon='GREASEPENCIL')
        _draw_pens(layout)


def _draw_pens(layout):
    for name in ('draw_curve', 'draw_on_surface', 'draw_contour'):
        layout.operator(f"splinewright.{name}", icon='GREASEPENCIL')


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
        _draw_made(layout, (*FROM_CURVES, *FROM_BOTH))
        layout.separator()
        _draw_made(layout, FROM_SURFACES)
        layout.separator()
        layout.operator("splinewright.add_teapot", text="Newell's Teapot", icon='MESH_UVSPHERE')


def _draw_curve_add(self, context):
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_curve_add.bl_idname, icon='CURVE_DATA')


def _draw_surface_add(self, context):
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_surface_add.bl_idname, icon='SURFACE_DATA')


def _draw_vertices(self, context):
    if not editing.nets_in_edit_mode(context):
        self.layout.separator()
        self.layout.operator("splinewright.curve_through_points", text="Splinewright: Curve Through Points")
        self.layout.operator("splinewright.contour_through_points", text="Splinewright: Contour Through Points")
        self.layout.operator("splinewright.fit_curve", text="Splinewright: Fit Curve")
        self.layout.operator("splinewright.fit_patch", text="Splinewright: Fit Patch")


def _draw_faces(self, context):
    if not editing.nets_in_edit_mode(context):
        self.layout.separator()
        self.layout.operator("splinewright.patch_through_grid", text="Splinewright: Patch Through Grid")


def _draw_import(self, context):
    self.layout.operator("splinewright.import_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.import_json", text="Splinewright Exact Curves and Patches (.json)")


def _draw_export(self, context):
    self.layout.operator("splinewright.export_bpt", text="Bezier Patches (.bpt)")
    self.layout.operator("splinewright.export_json", text="Splinewright Exact Curves and Patches (.json)")


def _draw_apply(self, context):
    if kinds.selected(context) & kinds.SHAPES:
        self.layout.separator()
        self.layout.operator("splinewright.apply_transform", text="Splinewright: Transform into Definition")


def _draw_convert(self, context):
    found = kinds.selected(context)
    if found:
        self.layout.separator()
    if 'native' in found:
        self.layout.operator("splinewright.make_exact", text="Splinewright: Make Exact")
    if any(map(read_polygons.is_mesh, context.selected_objects)):
        self.layout.operator("splinewright.add_of_mesh", text="Splinewright: NURBS of Mesh")
    if found & kinds.SHAPES:
        self.layout.operator("splinewright.to_native", text="Splinewright: To Blender's Own")


#: What takes clicks, what follows, and what is done once.
_MEETING = (('trim_here', 'extend_here', 'fillet_here', 'chamfer_here'), tuple(f"add_{recipe.kind}" for recipe in MEETING),
            ('intersections', 'add_touching_circle'))
#: What F3 finds first by these words: the title of the menu has those of all.
_FOUND_BY = {'add_offset': "Offset Curve"}


class SPLINEWRIGHT_MT_meeting(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_meeting"
    bl_label = "Trim, Fillet, Offset, Section"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        for i, names in enumerate(_MEETING):
            if i:
                layout.separator()
            for name in names:
                layout.operator(f"splinewright.{name}", text=_FOUND_BY.get(name) or tools.text_of(name))


class SPLINEWRIGHT_MT_from_curves(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_from_curves"
    bl_label = "Surface from Curves"

    def draw(self, context):
        self.layout.operator_context = 'INVOKE_REGION_WIN'
        _draw_made(self.layout, FROM_CURVES, context.selected_objects)


def _draw_made(layout, recipes, obs=()):
    """Operators of recipes; what would be refused for all the objects is grey."""
    for recipe in recipes:
        name = f"add_{recipe.kind}"
        row = layout.row()
        row.enabled = not tools.is_refused(name, obs)
        row.operator(f"splinewright.{name}", text=recipe.label, icon=_ICONS_OF_MADE[recipe.kind])


class SPLINEWRIGHT_MT_from_surfaces(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_from_surfaces"
    bl_label = "Surface from Surfaces"

    def draw(self, context):
        self.layout.operator_context = 'INVOKE_REGION_WIN'
        _draw_made(self.layout, FROM_SURFACES, context.selected_objects)
        self.layout.operator("splinewright.round_here", icon='EYEDROPPER')


#: Names of operators and menus, with what they concern, in groups.
_ENTRIES = (
    (('edit_net', kinds.SHAPES), ('insert_here', kinds.SHAPES), ('pull_here', kinds.SHAPES), ('split_here', kinds.SHAPES),
     ('measure_here', kinds.SHAPES), ('join_here', {'patch'}), ('extract_here', {'patch'}), ('extract_side_here', {'patch'}),
     ('set_knots', kinds.SHAPES), ('pick_piece', kinds.SHAPES),
     ('key_points', kinds.SHAPES), ('clear_point_keys', kinds.SHAPES),
     (curve_tools.SPLINEWRIGHT_MT_curve, {'curve'}), (patch_tools.SPLINEWRIGHT_MT_patch, {'patch'})),
    (('make_exact', {'native'}), ('to_native', kinds.SHAPES), ('follow_object', kinds.SHAPES | {'native'}),
     ('make_editable', kinds.SHAPES), ('bake_animation', kinds.SHAPES), ('unbake', {'baked'})),
    ((SPLINEWRIGHT_MT_from_curves, {'curve', 'native'}), (SPLINEWRIGHT_MT_from_surfaces, {'patch', 'native'}),
     *((f"add_{recipe.kind}", kinds.FOLLOWED) for recipe in FROM_BOTH), (SPLINEWRIGHT_MT_meeting, kinds.FOLLOWED), ('curve_through_points', kinds.ALL), ('fit_curve', kinds.ALL), ('divide_equally', {'curve'}), ('project_points', kinds.SHAPES),
     *((f"add_{recipe.kind}", {'curve', 'native'}) for recipe in DERIVED if recipe is not FOLLOW and recipe not in (*MEETING, *FROM_CURVES, *FROM_BOTH, *FROM_SURFACES))),
    (('join', kinds.SHAPES), ('separate_pieces', kinds.SHAPES), ('delete_pieces', kinds.SHAPES), ('explode', kinds.SHAPES), ('cap', {'patch'}), ('make_deformable', kinds.SHAPES),
     ('apply_transform', kinds.SHAPES), ('adopt_transform', kinds.SHAPES)),
    (('restore', kinds.SHAPES), ('detach', kinds.SHAPES)))
_ENTRY_ICONS = {SPLINEWRIGHT_MT_from_curves: 'MOD_LATTICE', SPLINEWRIGHT_MT_from_surfaces: 'MOD_SOLIDIFY',
                SPLINEWRIGHT_MT_meeting: 'SNAP_MIDPOINT', 'edit_net': 'EDITMODE_HLT', 'follow_object': 'LINKED', 'pick_piece': 'EYEDROPPER',
                curve_tools.SPLINEWRIGHT_MT_curve: 'CURVE_DATA', patch_tools.SPLINEWRIGHT_MT_patch: 'SURFACE_DATA'}


def _draw_entries(layout, found, obs):
    """Those that concern one of these kinds; what would be refused for all the objects is grey."""
    layout.operator_context = 'INVOKE_REGION_WIN'
    groups = [[entry for entry, concerned in group if concerned & found] for group in _ENTRIES]
    for i, group in enumerate(filter(None, groups)):
        if i:
            layout.separator()
        for entry in group:
            icon = _ENTRY_ICONS.get(entry, 'NONE')
            if isinstance(entry, str):
                row = layout.row()
                row.enabled = not tools.is_refused(entry, obs)
                row.operator(f"splinewright.{entry}", text=tools.text_of(entry), icon=icon)
            else:
                layout.menu(entry.bl_idname, icon=icon)


class SPLINEWRIGHT_MT_object(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_object"
    bl_label = "Splinewright"

    def draw(self, context):
        _draw_entries(self.layout, kinds.ALL, context.selected_objects)
        self.layout.separator()
        _draw_pens(self.layout)


class SPLINEWRIGHT_MT_object_context(bpy.types.Menu):
    bl_idname = "SPLINEWRIGHT_MT_object_context"
    bl_label = "Splinewright"

    def draw(self, context):
        _draw_entries(self.layout, kinds.selected(context), context.selected_objects)


def _draw_object(self, context):
    """In the Object menu, where what cannot be done is grey and says why."""
    self.layout.separator()
    self.layout.menu(SPLINEWRIGHT_MT_object.bl_idname, icon='SURFACE_DATA')


def _draw_object_context(self, context):
    if kinds.selected(context):
        self.layout.separator()
        self.layout.menu(SPLINEWRIGHT_MT_object_context.bl_idname, icon='SURFACE_DATA')


class SPLINEWRIGHT_MT_net(bpy.types.Menu):
    """While a net is edited: in the header, and on top of Blender's context menu."""

    bl_idname = "SPLINEWRIGHT_MT_net"
    bl_label = "Splinewright"

    def draw(self, context):
        layout = self.layout
        layout.operator_context = 'INVOKE_REGION_WIN'
        is_curve = isinstance(context.object.data, bpy.types.Curve)
        layout.operator("splinewright.leave_net", icon='CHECKMARK')
        layout.operator("splinewright.renew_net", icon='FILE_REFRESH')
        layout.separator()
        layout.operator("splinewright.insert_here")
        layout.operator("splinewright.split_here")
        layout.operator("splinewright.pull_here")
        layout.operator("splinewright.measure_here")
        layout.operator("splinewright.separate_pieces")
        layout.operator("splinewright.delete_pieces")
        layout.operator("splinewright.set_knots")
        layout.operator("splinewright.weight_here")
        if is_curve:
            layout.operator("splinewright.radius_here")
            layout.operator("splinewright.tilt_here")
        layout.operator("splinewright.point_to_infinity")
        layout.operator("splinewright.point_from_infinity")
        layout.separator()
        layout.operator("splinewright.key_points", icon='KEY_HLT')
        if bpy.ops.splinewright.clear_point_keys.poll():
            layout.operator("splinewright.clear_point_keys")
        layout.separator()
        tools = curve_tools if is_curve else patch_tools
        tools.draw_verbs(layout, context)


def _draw_net(self, context):
    if editing.nets_in_edit_mode(context):
        self.layout.menu(SPLINEWRIGHT_MT_net.bl_idname, icon='SURFACE_DATA')
        self.layout.separator()


def _draw_delete(self, context):
    """Blender's X takes points away, which a net has to keep."""
    if editing.nets_in_edit_mode(context):
        self.layout.operator("splinewright.delete_pieces", icon='SURFACE_DATA')
        self.layout.separator()


def _draw_net_header(self, context):
    if editing.nets_in_edit_mode(context):
        self.layout.menu(SPLINEWRIGHT_MT_net.bl_idname)


CLASSES = (SPLINEWRIGHT_MT_curve_add, SPLINEWRIGHT_MT_surface_add, SPLINEWRIGHT_MT_from_curves, SPLINEWRIGHT_MT_from_surfaces,
           SPLINEWRIGHT_MT_meeting, SPLINEWRIGHT_MT_object,
           SPLINEWRIGHT_MT_object_context, SPLINEWRIGHT_MT_net)

#: Blender's menus that ours are added to, at the end or before all else.
_PLACES = (
    ("VIEW3D_MT_curve_add", _draw_curve_add),
    ("VIEW3D_MT_surface_add", _draw_surface_add),
    ("VIEW3D_MT_object", _draw_object),
    ("VIEW3D_MT_object_context_menu", _draw_object_context),
    ("VIEW3D_MT_object_apply", _draw_apply),
    ("VIEW3D_MT_object_convert", _draw_convert),
    ("VIEW3D_MT_edit_mesh_vertices", _draw_vertices),
    ("VIEW3D_MT_edit_mesh_faces", _draw_faces),
    ("VIEW3D_MT_editor_menus", _draw_net_header),
    ("TOPBAR_MT_file_import", _draw_import),
    ("TOPBAR_MT_file_export", _draw_export),
)


_TOPS = (
    ("VIEW3D_MT_edit_mesh_context_menu", _draw_net),
    ("VIEW3D_MT_edit_curve_context_menu", _draw_net),
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
