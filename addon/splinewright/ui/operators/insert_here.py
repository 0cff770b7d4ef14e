"""Insert a knot by a click on the shape: where it would lie is shown at the mouse."""

import bpy

from ...bridge import surveys
from ...bridge.file_state import state
from ...core import aiming
from ...core.failures import FAILURES
from .. import aim_overlay, editing, hand, picking
from . import reports
from .pick_piece import PASSED, redraw

_DIRECTIONS = ('U', 'V', 'BOTH')
_STEPS = {'WHEELUPMOUSE': 1, 'WHEELDOWNMOUSE': -1}


class SPLINEWRIGHT_OT_insert_here(bpy.types.Operator):
    bl_idname = "splinewright.insert_here"
    bl_label = "Insert Knot by Click"
    bl_description = ("Click the curve or patch where a knot is to be; the shape stays the same, and has more control points "
                      "there")
    bl_options = {'REGISTER'}

    @classmethod
    def poll(cls, context):
        shapes = hand.shapes(context)
        if not shapes:
            cls.poll_message_set("Select a Splinewright shape, or edit its net")
        elif not any(map(hand.is_free, shapes)):
            cls.poll_message_set("The shape comes of a recipe: use Make Editable first")
        return any(map(hand.is_free, shapes))

    def invoke(self, context, event):
        problem = editing.unread(editing.nets_in_edit_mode(context))
        if problem:
            return reports.cancelled(self, problem)
        self._direction, self._snaps = 0, False
        context.window_manager.modal_handler_add(self)
        context.window.cursor_modal_set('CROSSHAIR')
        self._aim(context, event)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type in _STEPS and self._is_on_patch():
            self._direction = (self._direction + _STEPS[event.type]) % len(_DIRECTIONS)
        elif event.type in PASSED:
            return {'PASS_THROUGH'}
        if event.type in ('ESC', 'RIGHTMOUSE') and event.value == 'PRESS':
            self.cancel(context)
            return {'CANCELLED'}
        self._snaps |= not event.ctrl   # the Ctrl of the key that called it does not count
        self._aim(context, event)
        if event.type not in ('LEFTMOUSE', 'RET', 'NUMPAD_ENTER') or event.value != 'PRESS' or not state.aimed:
            return {'RUNNING_MODAL'}
        aimed, direction = state.aimed, _DIRECTIONS[self._direction]
        self.cancel(context)
        return _insert(aimed, direction)

    def cancel(self, context):
        """Also called by Blender, where another file is opened meanwhile."""
        state.aimed = None
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)
        redraw()

    def _is_on_patch(self):
        return state.aimed is not None and len(state.aimed.parameters) == 2

    def _aim(self, context, event):
        """Find what is at the mouse, with Ctrl the middle of the span there, and show it."""
        try:
            found = _found(context, event, self._snaps and event.ctrl)
        except FAILURES:
            found = None                # such a shape shows nothing to point at
        direction = _DIRECTIONS[self._direction]
        state.aimed = aim_overlay.Aim(found[0].name, found[1], found[2], direction) if found else None
        context.workspace.status_text_set(_status(state.aimed))
        redraw()


def _found(context, event, in_middle):
    """(object, number of its piece, its parameters) at the mouse, or in the middle of the span there; or None."""
    obs = [ob for ob in hand.shapes(context) if hand.is_free(ob) and ob.visible_get()]
    found = picking.pointed_at(event, obs, context.evaluated_depsgraph_get())
    if found is None or not in_middle:
        return found
    ob, number, parameters = found
    return ob, number, aiming.in_middle(surveys.pieces_of(ob.data)[number - 1], parameters)


def _status(aimed):
    if aimed is None:
        return "Point at the shape   |   Esc, Right Mouse: Cancel"
    names = {'U': "u", 'V': "v", 'BOTH': "uv"}[aimed.direction] if len(aimed.parameters) == 2 else "u"
    numbers = ", ".join(f"{name} = {value:.4g}" for name, value in zip("uv", aimed.parameters) if name in names)
    wheel = "   |   Wheel: along u, v, both" if len(aimed.parameters) == 2 else ""
    return f"Knot at {numbers}   |   Click: insert   |   Ctrl: middle of the span{wheel}   |   Esc, Right Mouse: Cancel"


def _insert(aimed, direction):
    """By the operator whose panel then has the numbers."""
    if len(aimed.parameters) == 1:
        return bpy.ops.splinewright.insert_knot('EXEC_DEFAULT', True, piece=aimed.number, parameter=aimed.parameters[0])
    u, v = aimed.parameters
    return bpy.ops.splinewright.patch_insert_knot(
        'EXEC_DEFAULT', True, piece=aimed.number, direction=direction, parameter_u=u, parameter_v=v)


CLASSES = (SPLINEWRIGHT_OT_insert_here,)
