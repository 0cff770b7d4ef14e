"""A contour of segments and arcs, point after point by clicks in a 3D view."""

import bpy
import numpy as np
from bpy.props import FloatProperty, StringProperty
from bpy_extras import view3d_utils
from mathutils import Vector

from ...bridge import shape
from ...bridge.file_state import state
from ...core import contours, decimals, typed_number
from ...core.failures import FAILURES
from .. import picking, snapping
from . import new_shapes, reports
from .adding import add_in_front, can_add, require_place, resolution_property
from .pointing import PASSED, Typing, redraw

_DONE = ('RET', 'NUMPAD_ENTER', 'SPACE')
#: Pixels, of an interface that is not scaled, within which a click on the first point closes.
_MEETING = 12.0


class SPLINEWRIGHT_OT_draw_contour(Typing, bpy.types.Operator):
    bl_idname = "splinewright.draw_contour"
    bl_label = "Draw Contour"
    bl_description = ("Click points of a contour, one after the other, on the plane through the 3D cursor that faces the view: A "
                      "changes between segments and arcs that go on smoothly, Enter ends it, a click on its first point closes it")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    contour: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    radius: FloatProperty(name="Corner Radius", description="Of arcs in place of all corners; 0 leaves them sharp", default=0.0,
                          min=0.0, unit='LENGTH', options={'SKIP_SAVE'})
    resolution_u: resolution_property()

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def invoke(self, context, event):
        self._kind, self._typed, self._view = contours.SEGMENT, typed_number.Typed(), None
        self._drawn = self._longer = contours.Contour()
        context.window_manager.modal_handler_add(self)
        context.window.cursor_modal_set('CROSSHAIR')
        self._show(context)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type in PASSED and not (event.type.startswith("NUMPAD_") and self._drawn.points):
            return {'PASS_THROUGH'}
        if event.type in ('ESC', 'RIGHTMOUSE') and event.value == 'PRESS':
            self.cancel(context)
            return {'CANCELLED'}
        if event.value == 'PRESS' and self._drawn.points:
            if event.type in _DONE:
                return self._end(context)
            if event.type == 'C' and len(self._drawn.points) > 2:
                return self._end(context, closed=True)
            if event.type == 'A':
                self._kind = contours.ARC if self._kind == contours.SEGMENT else contours.SEGMENT
            elif event.type == 'BACK_SPACE' and not self._typed.digits:
                self._drawn = self._drawn.shortened()
            elif len(self._drawn.points) > 0:
                self.takes(event)
        self._aim(context, event)
        if event.type == 'LEFTMOUSE' and event.value == 'PRESS':
            return self._click(context, event)
        self._show(context)
        return {'RUNNING_MODAL'}

    def cancel(self, context):
        """Also called by Blender, where another file is opened meanwhile."""
        state.contour = None
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)
        redraw()

    def execute(self, context):
        new_shapes.settle(self)
        try:
            require_place(context)
            value = contours.curve_of(contours.from_text(self.contour), decimals.typed(self.radius))
            data = shape.new_data("Contour", value, new_shapes.start(self))
        except FAILURES as error:
            return reports.failed(self, error)
        ob = bpy.data.objects.new(data.name, data)
        add_in_front(context, ob, context.selected_objects)
        return reports.finished(self, reports.Said())

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(self, "radius")
        new_shapes.draw(self, self.layout)

    def _aim(self, context, event):
        """Where the next point would be."""
        view = self._view or picking.view_at(event.mouse_x, event.mouse_y)
        if view is None:
            return
        region, space = view
        pixel = Vector((event.mouse_x - region.x, event.mouse_y - region.y))
        place = snapping.place_at(context, region, space, pixel, ()) if snapping.is_on(event) else None
        if place is None:
            place = view3d_utils.region_2d_to_location_3d(region, space, pixel, self._depth(context))
        self._longer = self._drawn.after(self._at_length(np.array(place, dtype=np.float64)), self._kind)

    def _depth(self, context):
        """The plane goes through the first point."""
        return Vector(self._drawn.points[0]) if self._drawn.points else context.scene.cursor.location

    def _at_length(self, place):
        """As far from the last point as was typed."""
        length = self._typed.number
        if length is None or not self._drawn.points:
            return place
        last = np.array(self._drawn.points[-1])
        away = np.linalg.norm(place - last)
        return last + (place - last) * (length / away) if away > 0 else place

    def _click(self, context, event):
        view = picking.view_at(event.mouse_x, event.mouse_y)
        if view is None or len(self._longer.points) == len(self._drawn.points):
            return {'RUNNING_MODAL'}
        if len(self._drawn.points) > 2 and self._is_on_first(event):
            return self._end(context, closed=True)
        try:
            if self._longer.kinds:
                contours.parts_of(self._longer)
        except FAILURES:
            return {'RUNNING_MODAL'}    # there is no such arc
        self._view, self._drawn, self._typed = view, self._longer, typed_number.Typed()
        self._show(context)
        return {'RUNNING_MODAL'}

    def _is_on_first(self, event):
        region, space = self._view
        first = picking.on_screen(region, space, np.eye(4), np.array(self._drawn.points[:1]))[0]
        return np.hypot(*(first - (event.mouse_x - region.x, event.mouse_y - region.y))) <= picking.near(_MEETING)

    def _show(self, context):
        state.contour = self._drawn, self._longer
        kind = "arc, on from what is before" if self._kind == contours.ARC else "segment"
        typed = f"length {self._typed}   |   " if self._typed.digits else ""
        more = "Enter: done   |   C, or click the first point: close   |   Backspace: one back   |   Numbers: length   |   "
        context.workspace.status_text_set(
            f"Click: {kind}   |   {typed}A: segment, arc   |   Ctrl: magnet   |   {more if self._drawn.points else ''}"
            "Esc, Right Mouse: cancel")
        redraw()

    def _end(self, context, closed=False):
        drawn = self._drawn._replace(closed=closed)
        self.cancel(context)
        if len(drawn.points) < 2:
            return reports.stopped(self, "one point is no contour: click two or more")
        self.contour = contours.text_of(drawn)
        return self.execute(context)


CLASSES = (SPLINEWRIGHT_OT_draw_contour,)
