"""The add-on's preferences. They work without the native library, to explain the problem with it."""

import bpy
import rna_keymap_ui
from bpy.props import BoolProperty, FloatVectorProperty, IntProperty

from ..bridge.data import settings
from ..core.base import library
from ..core.base.words import phrase, say
from . import addresses, keymaps, manual, texts
from .ui_state import ui_state

_NAME = __package__.rpartition('.')[0]


def get():
    """The preferences in use; their defaults where Blender has none yet."""
    addon = bpy.context.preferences.addons.get(_NAME)
    return addon.preferences if addon and addon.preferences else _Defaults()


class _Defaults:
    def __getattr__(self, name):
        known = SplinewrightPreferences.bl_rna.properties[name]
        return tuple(known.default_array) if getattr(known, 'is_array', False) else known.default


def _color(name, default, description):
    return FloatVectorProperty(name=name, description=description, subtype='COLOR_GAMMA', min=0.0, max=1.0, default=default)


def _steps(name, of_what):
    return IntProperty(name=name, description=f"Steps in every span of {of_what}; 0: as many as suit its kind",
                       default=0, min=0, max=4096, soft_max=64)


def _redraw_status_bar(_self, context):
    """Blender does it where the text is set."""
    for window in context.window_manager.windows:
        window.workspace.status_text_set(say(ui_state.status or None))


class SplinewrightPreferences(bpy.types.AddonPreferences):
    bl_idname = _NAME

    use_theme: BoolProperty(
        name="Nets in the Theme's Colors",
        description="Rows of nets are colored as the theme colors active lines of Blender's own surfaces", default=True)
    color_u: _color("Along U", (0.95, 0.78, 0.1), "Rows of nets along u")
    color_v: _color("Along V", (0.9, 0.25, 0.75), "Rows of nets along v")
    color_arrow: _color("At Infinity", (0.2, 0.9, 0.95), "Arrows to control points at infinity")
    color_gap: _color("Gap", (0.75, 0.0, 0.2), "Seams where patches do not meet")
    color_edge: _color("Edge", (0.45, 0.1, 0.95), "Seams where tangent planes differ")
    color_g1: _color("G1", (0.05, 0.6, 1.0), "Seams where tangent planes agree")
    color_g2: _color("G2", (0.0, 0.65, 0.25), "Seams where curvatures agree")

    show_hints: BoolProperty(
        name="Keys in the Status Bar", description="Show in the status bar which keys work while a net is edited",
        default=True, update=_redraw_status_bar)

    curve_resolution: _steps("Resolution of Curves", "a new curve")
    surface_mode: settings.mode_property(default=settings.AUTOMATIC)
    surface_resolution: _steps("Resolution of Surfaces", "a new surface along u and v")
    surface_tolerance: settings.tolerance_property()
    surface_angle: settings.angle_property()

    def draw(self, context):
        layout = self.layout
        if library.problem:
            texts.draw_problem(layout, library.problem, width=90)
            _draw_help(layout)
            return
        layout.label(text=say(phrase("Native library splinecore {version} is loaded", version=library.sc.__version__)), icon='CHECKMARK')
        _draw_start(layout)
        _draw_help(layout)
        self._draw_new_shapes(_section(layout, "New Shapes"))
        _section(layout, "Nets").prop(self, "show_hints")
        _draw_keys(layout, context)
        self._draw_colors(_section(layout, "Colors"), context)

    def _draw_new_shapes(self, column):
        column.prop(self, "curve_resolution")
        column.prop(self, "surface_mode", text="Faces of Surfaces")
        if self.surface_mode == settings.COUNT:
            column.prop(self, "surface_resolution")
        if self.surface_mode in (settings.TOLERANCE, settings.BOTH):
            column.prop(self, "surface_tolerance")
        if self.surface_mode in (settings.ANGLE, settings.BOTH):
            column.prop(self, "surface_angle")

    def _draw_colors(self, column, context):
        column.prop(self, "use_theme")
        if self.use_theme:
            theme = context.preferences.themes[0].view_3d
            column.prop(theme, "nurb_sel_uline", text="Along U")
            column.prop(theme, "nurb_sel_vline", text="Along V")
        else:
            column.prop(self, "color_u")
            column.prop(self, "color_v")
        column.prop(self, "color_arrow")
        column.separator()
        for name in ("color_gap", "color_edge", "color_g1", "color_g2"):
            column.prop(self, name)


def _draw_start(layout):
    """How to begin."""
    box = layout.box()
    box.label(text="Get started: the tab NURBS of the sidebar (N) in the 3D view, Shift+A > Curve or Surface > NURBS")
    row = box.row()
    row.operator(manual.SPLINEWRIGHT_OT_manual.bl_idname, text="First Steps", icon='PLAY').page = "five-minutes.html"
    row.operator_menu_enum("splinewright.add_sample", "sample", icon='SCENE_DATA')
    row.operator("splinewright.start_lesson", text="First Lesson", icon='PLAY')
    row.operator_menu_enum("splinewright.start_lesson", "lesson", icon='HELP')
    row.operator("splinewright.add_asset_library", icon='ASSET_MANAGER')


def _draw_help(layout):
    """The manual, and what there is on the web."""
    row = layout.row()
    row.alignment = 'LEFT'
    row.operator(manual.SPLINEWRIGHT_OT_manual.bl_idname, icon='HELP')
    if not library.problem:
        row.operator("splinewright.self_test", icon='PLAY')
    for text, address in addresses.known():
        row.operator("wm.url_open", text=say(text), icon='URL').url = address


def _section(layout, title):
    layout.separator()
    layout.label(text=say(title))
    column = layout.column()
    column.use_property_split = True
    column.use_property_decorate = False
    return column


def _draw_keys(layout, context):
    """The items as the preferences of Blender draw them: what a user changes is kept with all other keys."""
    layout.separator()
    layout.label(text="Keys")
    column = layout.column()
    for keymap, item, operator in keymaps.of_user():
        if item is None:
            column.label(text=say(phrase("{operator} has no key: Restore brings it back in Keymap > {keymap}", operator=phrase(operator),
                                       keymap=keymap.name if keymap else "")))
            continue
        column.context_pointer_set("keymap", keymap)
        rna_keymap_ui.draw_kmi([], context.window_manager.keyconfigs.user, keymap, item, column, 0)


CLASSES = (SplinewrightPreferences,)
