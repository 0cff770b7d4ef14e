"""A contour of segments and arcs, point after point by clicks in a 3D view."""

import math

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, StringProperty
from bpy_extras import view3d_utils
from mathutils import Vector

from ...bridge.shape import recipe_edit, shape
from ...core.base import decimals, typed_number
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.drawing import contours, guides
from ...core.recipes.table import RECIPES
from .. import drawing_marks, picking, snapping, weight_overlay
from ..ui_state import ui_state
from . import new_shapes, reports
from .adding import add_in_front, can_add, require_place, resolution_property
from .gesture import Gesture, Typing, redraw

_DONE = ('RET', 'NUMPAD_ENTER', 'SPACE')
#: Pixels, of an interface that is not scaled, within which a click on the first point closes.
_MEETING = 12.0


class SPLINEWRIGHT_OT_draw_contour(Typing, Gesture, bpy.types.Operator):
    bl_idname = "splinewright.draw_contour"
    bl_label = "Draw Contour"
    bl_description = "Click points of a contour: A switches to arcs, Ctrl snaps angles, numbers set lengths, Enter finishes"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    cursor = 'CROSSHAIR'

    contour: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # the first point is where the mouse is pressed
    radius: FloatProperty(name="Corner Radius", description="Of arcs in place of all corners; it stays in the panel of the contour. 0 leaves them sharp", default=0.0,
                          min=0.0, unit='LENGTH', options={'SKIP_SAVE'})
    resolution_u: resolution_property()

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def invoke(self, context, event):
        self._kind, self._view, self._mark = contours.SEGMENT, None, ""
        self._drawn = self._longer = contours.Contour()
        self._forget_typed()
        self._marks = drawing_marks.Marks(context)
        self.begin_modal(context)
        if self.at_once:
            self._aim(context, event)
            return self._click(context, event)
        self._show(context, event)
        return {'RUNNING_MODAL'}

    def _forget_typed(self):
        """Typed is the length; _other has the angle meanwhile, or the other way round."""
        self._typed, self._other, self._types_angle = typed_number.Typed(), typed_number.Typed(), False

    def lets_pass(self, event):
        return super().lets_pass(event) and not (event.type.startswith("NUMPAD_") and self._drawn.points)

    def step(self, context, event):
        if event.value == 'PRESS' and event.type == 'S':
            self._marks.are_on = not self._marks.are_on
        elif event.value == 'PRESS' and self._drawn.points:
            if event.type in _DONE:
                return self._end(context)
            if event.type == 'C' and len(self._drawn.points) > 2:
                return self._end(context, closed=True)
        self._aim(context, event)
        if event.type == 'LEFTMOUSE' and event.value == 'PRESS':
            return self._click(context, event)
        self._show(context, event)
        return {'RUNNING_MODAL'}

    def takes(self, event):
        if event.value != 'PRESS' or not self._drawn.points:
            return False
        if event.type == 'A':
            self._kind = contours.ARC if self._kind == contours.SEGMENT else contours.SEGMENT
        elif event.type == 'TAB':
            self._typed, self._other, self._types_angle = self._other, self._typed, not self._types_angle
        elif event.type == 'BACK_SPACE' and not self._typed.digits:
            self._drawn = self._drawn.shortened()
            self._marks.begin_at(self._drawn)
        else:
            return super().takes(event)
        return True

    def hide(self):
        ui_state.contour = ui_state.weighing = None

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        try:
            require_place(context)
            data = self._data(contours.from_text(self.contour).without_repeats())
        except FAILURES as error:
            return reports.failed(self, error)
        ob = bpy.data.objects.new(data.name, data)
        add_in_front(context, ob, context.selected_objects)
        return reports.finished(self, reports.Report())

    def _data(self, drawn):
        """With round corners what keeps their radius; sharp ones can be rounded, cut and trimmed as they are."""
        if self.radius == 0:
            return shape.new_data("Contour", contours.curve_of(drawn), new_shapes.start(self))
        values = {'corners': 'round', 'corner_size': decimals.typed(self.radius), 'closed': drawn.closed and len(drawn.points) > 2,
                  'arcs': ", ".join(map(str, drawn.sides()))}
        return recipe_edit.new_data("Contour", RECIPES['contour'], values, np.array(drawn.points), new_shapes.start(self))

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
        place, self._mark = None, ""
        if not event.ctrl and self._numbers() == (None, None):
            place, self._mark = self._met(context, region, space, pixel)
        if place is None:
            place = view3d_utils.region_2d_to_location_3d(region, space, pixel, self._depth(context))
            place = self._guided(np.array(place, dtype=np.float64), space, event.ctrl)
        self._longer = self._drawn.after(place, self._kind)

    def _met(self, context, region, view, pixel):
        """(the place (3,) of something at the mouse, what that is); (None, "") where nothing is."""
        found = self._marks.at(region, view, pixel)
        if found is not None:
            return found.place, found.name
        if context.scene.tool_settings.use_snap:
            return snapping.place_at(context, region, view, pixel, ()), ""
        return None, ""

    def _numbers(self):
        """(length, angle in radians) as typed, None for those not typed."""
        length, angle = (self._other, self._typed) if self._types_angle else (self._typed, self._other)
        return length.number, None if angle.number is None else math.radians(angle.number)

    def _guided(self, place, view, is_held):
        """A place in the plane of the view through the last point, as angles are held and numbers typed."""
        length, angle = self._numbers()
        if not self._drawn.points or not is_held and (length, angle) == (None, None):
            return place
        last, plane = np.array(self._drawn.points[-1]), _plane(view)
        away = guides.next_point(plane @ (place - last), self._way(plane), is_held, length, angle)
        return last + plane.T @ away

    def _way(self, plane):
        """(2,) in a plane: where the contour continues; None at its first point."""
        try:
            way = contours.way_of(self._drawn)
        except FAILURES:
            return None
        return None if way is None else plane @ way

    def _depth(self, context):
        """The plane goes through the first point."""
        return Vector(self._drawn.points[0]) if self._drawn.points else context.scene.cursor.location

    def _click(self, context, event):
        view = picking.view_at(event.mouse_x, event.mouse_y)
        if view is None or len(self._longer.points) == len(self._drawn.points):
            return {'RUNNING_MODAL'}
        if len(self._drawn.points) > 2 and self._is_on_first(event):
            return self._end(context, closed=True)
        if self._longer.kinds and not _is_possible(self._longer):
            return {'RUNNING_MODAL'}    # there is no such arc
        self._view, self._drawn = view, self._longer
        self._forget_typed()
        self._marks.begin_at(self._drawn)
        self._show(context, event)
        return {'RUNNING_MODAL'}

    def _is_on_first(self, event):
        region, space = self._view
        first = picking.on_screen(region, space, np.eye(4), np.array(self._drawn.points[:1]))[0]
        return np.hypot(*(first - (event.mouse_x - region.x, event.mouse_y - region.y))) <= picking.near(_MEETING)

    def _show(self, context, event):
        ui_state.contour = self._drawn, self._longer
        words = " ".join(filter(None, (self._measures(), self._mark)))
        view = self._view or picking.view_at(event.mouse_x, event.mouse_y)
        ui_state.weighing = (weight_overlay.Weighing(view[0].as_pointer(), event.mouse_x, event.mouse_y, words, False)
                          if view and words else None)
        keys = ["Click: tangent arc" if self._kind == contours.ARC else "Click: segment", "A: segment, arc",
                "S: marks of curves off" if self._marks.are_on else "S: marks of curves on"]
        if self._drawn.points:
            keys += ["Ctrl: steps of 15°", *(("Numbers: angle", "Tab: length") if self._types_angle else ("Numbers: length", "Tab: angle")),
                     "Backspace: one back", "Enter: done", "C, first point: close"]
        context.workspace.status_text_set(say("   |   ".join([*keys, "Esc, Right Mouse: cancel"])))
        redraw()

    def _measures(self):
        """The length of the part that a click adds, and its angle, as they are or as they are typed."""
        if not self._drawn.points or len(self._longer.points) == len(self._drawn.points) or self._view is None:
            return ""
        plane = _plane(self._view[1])
        away = np.array(self._longer.points[-1]) - np.array(self._drawn.points[-1])
        angle = math.degrees(guides.turn(plane @ away, self._way(plane)))
        numbers = [decimals.text_of(np.linalg.norm(away), 4), f"{decimals.text_of(angle, 4)}°"]
        if self._typed.digits:
            numbers[self._types_angle] = f"[{self._typed}{'°' if self._types_angle else ''}]"
        return phrase("Length {length}   Angle {angle}", length=numbers[0], angle=numbers[1])

    def _end(self, context, closed=False):
        drawn = self._drawn._replace(closed=closed, closing=self._kind if closed else contours.SEGMENT)
        if closed and not _is_possible(drawn):
            return {'RUNNING_MODAL'}    # there is no such arc
        self.end_modal(context)
        if len(drawn.points) < 2:
            return reports.stopped(self, "one point is no contour: click two or more")
        self.contour = contours.text_of(drawn)
        return self.execute(context)


def _is_possible(contour):
    try:
        contours.parts_of(contour)
    except FAILURES:
        return False
    return True


def _plane(view):
    """(2, 3): the directions of a view to the right and up."""
    return np.array(view.view_rotation.to_matrix(), dtype=np.float64).T[:2]


CLASSES = (SPLINEWRIGHT_OT_draw_contour,)
