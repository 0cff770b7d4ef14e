"""Gizmos of the 3D view: the place that a tool would click, a dial around the selected points for their weights,
and the knot strip."""

import bpy
import numpy as np
from mathutils import Matrix, Vector

from ..bridge.data.settings import overlays_of
from ..bridge.net import live, weighing
from . import active_shape, aim_overlay, editing, hints, keymaps, knot_strip, measure_overlay, numbers_overlay, toolbar
from .operators import at_sides, curve_here, insert_here, measure_here, move_knot, weight_here
from .ui_state import ui_state

_DIAL = 0.28


def _knot(context, x, y, settings, known, dimensions=(1, 2)):
    direction = getattr(settings, 'direction', 'U')
    return insert_here.aimed_by_tool(context, x, y, direction, dimensions=dimensions)


def _isocurve(*arguments):
    return _knot(*arguments, dimensions=(2,))


def _place_on_curve(*arguments):
    return _knot(*arguments, dimensions=(1,))


def _with_line(operator):
    """What the click of an operator on a curve would take or add."""
    def find(context, x, y, settings, known):
        aimed = _place_on_curve(context, x, y, settings, known)
        return aimed and operator.with_line(context, aimed, settings.meet, known)
    return find


def _side(context, x, y, *_):
    found = at_sides.side_at(context, x, y, at_sides.patches_of(context.selected_objects))
    return found and ((found[0].name, *found[1:]),)


def _measured(context, x, y, *_):
    return measure_here.measured_at(context, x, y)[1]


#: For tools with such a preview: what is found at a pixel of the window, and how that is drawn. The last argument keeps what was
#: found, until something changes.
_PREVIEWS = {'knot': (_knot, aim_overlay.show), 'isocurve': (_isocurve, aim_overlay.show), 'curve': (_place_on_curve, aim_overlay.show),
             'trim': (_with_line(curve_here.SPLINEWRIGHT_OT_trim_here), aim_overlay.show),
             'extend': (_with_line(curve_here.SPLINEWRIGHT_OT_extend_here), aim_overlay.show),
             'side': (_side, numbers_overlay.show_sides), 'measure': (_measured, measure_overlay.show_all)}


class SPLINEWRIGHT_GT_aim(bpy.types.Gizmo):
    """What a click of a tool would take, at the mouse. It is never hit: clicks are the tool's."""

    bl_idname = "SPLINEWRIGHT_GT_aim"
    __slots__ = ('aim', 'known')

    def setup(self):
        self.aim, self.known = None, {}

    def test_select(self, context, location):
        tool = toolbar.active(context)
        if tool is None or not tool.preview:
            return -1
        x, y = context.region.x + location[0], context.region.y + location[1]
        found = _PREVIEWS[tool.preview][0](context, x, y, toolbar.settings(context, tool), self.known)
        aim = (tool.preview, found) if found else None
        if aim or self.aim:
            self.aim = aim
            context.area.tag_redraw()
        return -1

    def draw(self, context):
        tool = toolbar.active(context)
        is_drawn_by_others = ui_state.is_pointing or ui_state.aimed or ui_state.sides
        if self.aim and tool and tool.preview == self.aim[0] and not is_drawn_by_others:
            _PREVIEWS[tool.preview][1](self.aim[1])


class SPLINEWRIGHT_GGT_aim(bpy.types.GizmoGroup):
    bl_idname = "SPLINEWRIGHT_GGT_aim"
    bl_label = "Preview at the Mouse"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'WINDOW'
    bl_options = {'3D', 'PERSISTENT'}

    @classmethod
    def poll(cls, context):
        tool = toolbar.active(context)
        return bool(tool and tool.preview and active_shape.shapes(context))

    def setup(self, context):
        self.gizmos.new(SPLINEWRIGHT_GT_aim.bl_idname)

    def refresh(self, context):
        self.gizmos[0].known.clear()


class SPLINEWRIGHT_GGT_weight(bpy.types.GizmoGroup):
    bl_idname = "SPLINEWRIGHT_GGT_weight"
    bl_label = "Weights of Points"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'WINDOW'
    bl_options = {'3D', 'PERSISTENT', 'SHOW_MODAL_ALL'}

    @classmethod
    def poll(cls, context):
        nets = editing.nets_in_edit_mode(context)
        if not nets or not (overlays_of(context.scene).weights or toolbar.is_active(context, "weight")):
            return False
        return context.space_data.show_gizmo and middle(context) is not None

    def setup(self, context):
        dial = self.gizmos.new('GIZMO_GT_dial_3d')
        dial.target_set_operator(weight_here.SPLINEWRIGHT_OT_weight_here.bl_idname).is_drag = True
        dial.color, dial.alpha = (0.95, 0.95, 0.95), 0.6
        dial.color_highlight, dial.alpha_highlight = (1.0, 0.8, 0.2), 1.0
        dial.line_width, dial.scale_basis, dial.use_draw_value = 3.0, _DIAL, False

    def draw_prepare(self, context):
        at = middle(context)
        if at is not None:
            facing = context.region_data.view_rotation.to_matrix().to_4x4()
            self.gizmos[0].matrix_basis = Matrix.Translation(at) @ facing


class SPLINEWRIGHT_GT_strip(bpy.types.Gizmo):
    """The knot strip, whose overlay draws it. A press on it does not reach what lies below."""

    bl_idname = "SPLINEWRIGHT_GT_strip"

    def test_select(self, context, location):
        hit = knot_strip.hit(context, *location)
        pointed = hit and knot_strip.pointed(context.region, hit)
        if pointed != ui_state.pointed_knot:
            ui_state.pointed_knot = pointed
            context.area.tag_redraw()
            hints.redraw(context)
        return -1 if hit is None else 0

    def draw(self, context):
        pointed = ui_state.pointed_knot
        if pointed and pointed.region == context.region.as_pointer() and not self.is_highlight:
            ui_state.pointed_knot = None   # the mouse has left the view
            context.area.tag_redraw()
            hints.redraw(context)


class SPLINEWRIGHT_GGT_strip(bpy.types.GizmoGroup):
    bl_idname = "SPLINEWRIGHT_GGT_strip"
    bl_label = "Knot Strip"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'WINDOW'
    bl_options = {'PERSISTENT', 'SHOW_MODAL_ALL'}

    @classmethod
    def poll(cls, context):
        return knot_strip.is_on(context) and knot_strip.shown(context) is not None

    @classmethod
    def setup_keymap(cls, keyconfig):
        return keymaps.of_strip(bpy.context.window_manager.keyconfigs.addon or keyconfig)

    def setup(self, context):
        strip = self.gizmos.new(SPLINEWRIGHT_GT_strip.bl_idname)
        strip.target_set_operator(move_knot.SPLINEWRIGHT_OT_move_knot.bl_idname)


def middle(context):
    """The mean in the world of the selected points that have weights, or None where there are none."""
    found = [_in_world(ob, vertices) for ob in editing.nets_in_edit_mode(context) if weight_here.has_weights(ob)
             for vertices, _ in [weighing.of_selected(ob)] if vertices]
    at = np.concatenate(found).mean(0) if found else None
    return Vector(at) if at is not None and np.isfinite(at).all() else None


def _in_world(ob, vertices):
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    return live.session(ob.data).points[vertices] @ matrix[:3, :3].T + matrix[:3, 3]


CLASSES = (SPLINEWRIGHT_GT_aim, SPLINEWRIGHT_GGT_aim, SPLINEWRIGHT_GGT_weight, SPLINEWRIGHT_GT_strip,
           SPLINEWRIGHT_GGT_strip)
