"""Change the radius and the tilt of the selected points of nets of curves: by the mouse, or by typed numbers."""

import math
from contextlib import suppress

import bpy
from bpy.props import FloatProperty

from ...bridge import recipes
from ...bridge.file_state import state
from ...bridge.net import live, net_object
from ...core import decimals, typed_number
from ...core.failures import FAILURES, sentence
from .. import editing, picking, weight_overlay
from . import reports
from .pointing import PASSED, Typing, redraw

#: With Shift a gesture is so many times slower.
_FINE = 0.1
_KEYS = "Move: {}   |   Digits: {}   |   Ctrl: steps   |   Shift: finely   |   Esc, Right Mouse: as it was"


class _Changes(Typing):
    """What both operators do. They say what the mouse and typed numbers mean, and what that does to points."""

    bl_options = {'REGISTER', 'UNDO', 'BLOCKING', 'GRAB_CURSOR_X'}
    works_on_nets = True

    @classmethod
    def poll(cls, context):
        nets = [ob for ob in editing.nets_in_edit_mode(context) if ob.type == 'CURVE']
        if not nets:
            cls.poll_message_set("Edit the net of a Splinewright curve first")
        elif not any(map(_can_change, nets)):
            cls.poll_message_set("The shape is made by a recipe: use Apply Construction first")
        return any(map(_can_change, nets))

    def invoke(self, context, event):
        self._gestures, problem = _begun(context)
        if problem:
            return reports.cancelled(self, problem)
        self._moved, self._typed, self._problem = 0.0, typed_number.Typed(), ""
        self._area, self._x = context.area, event.mouse_x
        context.window_manager.modal_handler_add(self)
        self._show(context, event)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type == 'MOUSEMOVE':
            self._moved += (event.mouse_x - self._x) * (_FINE if event.shift else 1.0)
            self._x = event.mouse_x
        elif event.type in ('ESC', 'RIGHTMOUSE') and event.value == 'PRESS':
            self.cancel(context)
            return {'CANCELLED'}
        elif event.type in ('LEFTMOUSE', 'RET', 'NUMPAD_ENTER') and event.value == 'PRESS':
            return self._confirmed(context)
        elif not self.takes(event) and event.type in PASSED:
            return {'PASS_THROUGH'}
        self._show(context, event)
        return {'RUNNING_MODAL'}

    def _show(self, context, event):
        """Let the shapes have what the mouse or the keys say, and tell of it."""
        scale = bpy.context.preferences.system.ui_scale
        self.choose(self._typed.number if str(self._typed) else None, self._moved / scale, event.ctrl, event.shift)
        self._problem = ""
        try:
            for gesture in self._gestures:
                self._put(gesture)
        except FAILURES as error:
            self._problem = sentence(error)
        text = self.text(str(self._typed))
        region, _ = picking.view_at(event.mouse_x, event.mouse_y) or (context.region, None)
        x = min(max(event.mouse_x, region.x), region.x + 0.8 * region.width)
        state.weighing = weight_overlay.Weighing(region.as_pointer(), x, event.mouse_y, text, bool(self._problem))
        if self._area is not None:
            self._area.header_text_set(": ".join(filter(None, (text, self._problem))))
        context.workspace.status_text_set(_KEYS.format(*self.means))
        redraw()

    def _put(self, gesture):
        if self.is_nothing():
            gesture.put_back()
        else:
            gesture.show(*self.change())

    def _confirmed(self, context):
        self._end(context)
        if self.is_nothing() or self._problem:
            self._put_back()
            return reports.cancelled(self, self._problem) if self._problem else {'CANCELLED'}
        return self._kept()

    def execute(self, context):
        self._gestures, problem = _begun(context)
        if problem:
            return reports.cancelled(self, problem)
        if self.is_nothing():
            return reports.finished(self, reports.Said("Nothing changed"))
        try:
            for gesture in self._gestures:
                gesture.show(*self.change())
        except FAILURES as error:
            self._put_back()
            return reports.cancelled(self, sentence(error))
        return self._kept()

    def _kept(self):
        for gesture in self._gestures:
            live.end_along(gesture)
        count = sum(gesture.count for gesture in self._gestures)
        return reports.finished(self, reports.Said(f"{self.text('')} of {count} points" if count > 1 else self.text("")))

    def cancel(self, context):
        """Also called by Blender, where another file is opened meanwhile."""
        self._end(context)
        self._put_back()

    def _put_back(self):
        for gesture in self._gestures:
            with suppress(*FAILURES, ReferenceError):
                gesture.put_back()

    def _end(self, context):
        state.weighing = None
        with suppress(ReferenceError):
            if self._area is not None:
                self._area.header_text_set(None)
        context.workspace.status_text_set(None)
        redraw()


class SPLINEWRIGHT_OT_radius_here(_Changes, bpy.types.Operator):
    bl_idname = "splinewright.radius_here"
    bl_label = "Change Radius"
    bl_description = "Multiply the radius of the selected control points by mouse or number, for example for a bevel"

    factor: FloatProperty(name="Factor", description="What radii are multiplied by", default=1.0, min=0.0, precision=4, step=10,
                          options={'SKIP_SAVE'})

    means = "thinner, thicker", "the factor"
    #: Pixels, of an interface that is not scaled, over which a radius doubles; what Ctrl rounds to.
    _doubles, _step = 150.0, 0.1

    def choose(self, typed, pixels, is_stepped, is_fine):
        """Take what was typed, or the way of the mouse."""
        if typed is not None:
            self.factor = abs(typed)
            return
        factor = 2.0 ** min(max(pixels / self._doubles, -30.0), 30.0)
        step = self._step * (_FINE if is_fine else 1.0)
        self.factor = float(f"{round(factor / step) * step if is_stepped else factor:.4g}")

    def change(self):
        return decimals.typed(self.factor), 0.0

    def is_nothing(self):
        return self.factor == 1.0

    def text(self, typed):
        return f"Radius × {typed or f'{self.factor:.4g}'}"


class SPLINEWRIGHT_OT_tilt_here(_Changes, bpy.types.Operator):
    bl_idname = "splinewright.tilt_here"
    bl_label = "Change Tilt"
    bl_description = "Twist the profile at the selected control points by mouse or degrees, for example of a bevel"

    angle: FloatProperty(name="Angle", description="Angle added to the tilts", default=0.0, subtype='ANGLE', step=100,
                         options={'SKIP_SAVE'})

    means = "turn back, turn on", "degrees"
    #: Pixels, of an interface that is not scaled, of one degree; what Ctrl rounds to, in degrees.
    _degree, _step = 2.0, 5.0

    def choose(self, typed, pixels, is_stepped, is_fine):
        """Take what was typed, or the way of the mouse."""
        degrees = pixels / self._degree if typed is None else typed
        if typed is None:
            step = (1.0 if is_fine else self._step) if is_stepped else 0.1 * (_FINE if is_fine else 1.0)
            degrees = round(degrees / step) * step
        self.angle = math.radians(degrees)

    def change(self):
        return 1.0, self.angle

    def is_nothing(self):
        return self.angle == 0.0

    def text(self, typed):
        return f"Tilt {typed or f'{math.degrees(self.angle):.4g}'}°"


def _can_change(ob):
    owner = net_object.shape_of(ob)
    return owner is not None and not recipes.has(owner.data)


def _begun(context):
    """(an along.Gesture for each net of curves in Edit Mode with selected points, why there is none or "")."""
    nets = [ob for ob in editing.nets_in_edit_mode(context) if ob.type == 'CURVE' and _can_change(ob)]
    try:
        gestures = [gesture for gesture in map(live.begin_along, nets) if gesture.count]
    except FAILURES as error:
        return [], sentence(error)
    return gestures, "" if gestures else "select points of the net"


CLASSES = (SPLINEWRIGHT_OT_radius_here, SPLINEWRIGHT_OT_tilt_here)
