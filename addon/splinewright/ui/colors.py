"""The colors of drawings over the 3D view, as the preferences have them."""

import bpy

from ..core.base.words import say
from . import preferences

#: Of a seam whose continuity is not known.
_UNKNOWN = (0.5, 0.5, 0.5, 1.0)
#: What is in the way, or is not as one would think.
WARNING = (1.0, 0.45, 0.2, 1.0)
#: Of ui.analysis_overlay.
CURVE = (0.3, 0.65, 1.0, 1.0)
KNOTS, RIM = (1.0, 1.0, 1.0, 1.0), (0.0, 0.0, 0.0, 1.0)
NORMALS, HODOGRAPH, CIRCLE = (0.35, 0.9, 1.0, 0.9), (1.0, 0.75, 0.3, 1.0), (1.0, 1.0, 1.0, 0.8)
FRAME = (1.0, 0.25, 0.3, 1.0), (0.5, 0.85, 0.2, 1.0), (0.25, 0.55, 1.0, 1.0)
TEETH, BACK = (0.75, 0.5, 1.0, 0.55), (0.8, 0.55, 1.0, 1.0)
AXES, GRID = (0.85, 0.85, 0.85, 1.0), (0.5, 0.5, 0.5, 0.35)
KNOTS_OF_PATCHES, ISOCURVES = (0.02, 0.02, 0.05, 1.0), (0.05, 0.05, 0.1, 0.55)
#: Of seams on either side.
SEAM_RIM = (1.0, 1.0, 1.0, 1.0)
#: Of ui.knot_strip_overlay: what lies behind it, and behind texts at the mouse; texts, those outside the domain.
STRIP, STRIP_LABEL = (0.0, 0.0, 0.0, 0.55), (0.0, 0.0, 0.0, 0.85)
STRIP_TEXT, STRIP_FADED = (0.92, 0.92, 0.92, 1.0), (0.62, 0.62, 0.62, 1.0)
#: By the classes of core.joints.seams, from a gap to curvatures that agree: the preference and what it is called.
SEAMS = {-1: ("color_gap", "Gap"), 0: ("color_edge", "Edge"), 1: ("color_g1", "G1"), 2: ("color_g2", "G2")}


def of_net():
    """RGBA of the rows along u and of those along v."""
    if preferences.get().use_theme:
        theme = bpy.context.preferences.themes[0].view_3d
        return _opaque(theme.nurb_sel_uline), _opaque(theme.nurb_sel_vline)
    return _opaque(preferences.get().color_u), _opaque(preferences.get().color_v)


def of_points():
    """RGBA of control points that are not selected."""
    return _opaque(bpy.context.preferences.themes[0].view_3d.vertex)


def of_selected():
    """RGBA of control points that are selected."""
    return _opaque(bpy.context.preferences.themes[0].view_3d.vertex_select)


def of_arrows():
    """RGBA of the directions at infinity."""
    return _opaque(preferences.get().color_arrow)


def of_seams():
    """RGBA by the classes of core.joints.seams."""
    wanted = preferences.get()
    return {-2: _UNKNOWN, **{number: _opaque(getattr(wanted, name)) for number, (name, _) in SEAMS.items()}}


def draw_legend(layout):
    """The colors of seams and what they mean, where Blender has the add-on's preferences."""
    wanted = preferences.get()
    if isinstance(wanted, bpy.types.AddonPreferences):
        grid = layout.grid_flow(columns=2, even_columns=True, align=True)
        for name, text in SEAMS.values():
            grid.prop(wanted, name, text=say(text))


def _opaque(color):
    return (*color[:3], 1.0)
