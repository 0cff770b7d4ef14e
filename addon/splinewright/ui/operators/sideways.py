"""What the mouse changes of the selected points of nets by moving sideways, or typed numbers do: what such operators have in
common."""

from contextlib import suppress

import bpy
from bpy.props import BoolProperty

from ...bridge.net import live, selection
from ...core.base import typed_number
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase, say
from .. import editing, picking, seeing, weight_overlay
from ..ui_state import ui_state
from . import reports
from .gesture import Gesture, Typing, redraw

#: With Shift a gesture is so many times slower.
FINE = 0.1
_KEYS = "Move: {moves}   |   Digits: {digits}   |   Ctrl: steps   |   Shift: finely   |   Esc, Right Mouse: as it was"


class Sideways(Typing, Gesture):
    """`_moved` has the pixels of the way of the mouse, `_typed` what was typed, `_problem` why that is refused."""

    bl_options = {'REGISTER', 'UNDO', 'BLOCKING', 'GRAB_CURSOR_X'}
    works_on_nets = True
    #: What the mouse and digits do, for the status bar.
    means = "", ""

    at_mouse: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})         # begin with the point there, or leave the key to others
    is_drag: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # a button is held until it is over

    def nets(self, context):
        """The nets in Edit Mode whose points may be changed."""
        raise NotImplementedError

    def is_meant(self, net):
        """(n,) bool of the points of a core.net.Net that may be changed."""
        return net.rows >= 0

    def hold(self, context):
        """Begin with the selected points. Returns why there are none, or ""."""
        raise NotImplementedError

    def choose(self, event):
        """Take what was typed, or the way of the mouse."""
        raise NotImplementedError

    def show(self):
        """Let the shapes have what was chosen. Raises FAILURES."""
        raise NotImplementedError

    def confirmed(self, context):
        """What step() returns when it is over and was not called off."""
        raise NotImplementedError

    def text(self, typed):
        """The preview at the mouse."""
        raise NotImplementedError

    def is_odd(self):
        """Whether that is shown as a warning."""
        return bool(self._problem)

    def invoke(self, context, event):
        if self.at_mouse and not self._select_at_mouse(context, event):
            return {'PASS_THROUGH', 'CANCELLED'}
        problem = editing.unread(editing.nets_in_edit_mode(context)) or self.hold(context)
        if problem:
            return reports.cancelled(self, problem)
        self._moved, self._typed, self._problem = 0.0, typed_number.Typed(), ""
        self._area, self._x = context.area, event.mouse_x
        self._follow(context, event)
        return self.begin_modal(context)

    def step(self, context, event):
        if event.type == 'MOUSEMOVE':
            self._moved += (event.mouse_x - self._x) * (FINE if event.shift else 1.0)
            self._x = event.mouse_x
        elif self._is_over(event) and (event.type == 'LEFTMOUSE' or not self._problem):
            self.end_modal(context)                 # Return takes no number of which the header says why not
            return self.confirmed(context)
        self._follow(context, event)
        return {'RUNNING_MODAL'}

    def hide(self):
        ui_state.weighing = None

    def _is_over(self, event):
        if self.is_drag and event.type == 'LEFTMOUSE':
            return event.value == 'RELEASE' and not str(self._typed)        # who types lets the button go
        return event.type in ('LEFTMOUSE', 'RET', 'NUMPAD_ENTER') and event.value == 'PRESS'

    def _follow(self, context, event):
        """Give the shapes the value set by mouse or keys, and report it."""
        self.choose(event)
        self._problem = ""
        try:
            self.show()
        except FAILURES as error:
            self._problem = sentence(error)
        text = self.text(str(self._typed))
        region, _ = picking.view_at(event.mouse_x, event.mouse_y) or (context.region, None)
        x = min(max(event.mouse_x, region.x), region.x + 0.8 * region.width)
        ui_state.weighing = weight_overlay.Weighing(region.as_pointer(), x, event.mouse_y, text, self.is_odd())
        self.write_header(self._area, ": ".join(filter(None, (text, self._problem))))
        context.workspace.status_text_set(say(phrase(_KEYS, moves=phrase(self.means[0]), digits=phrase(self.means[1]))))
        redraw()

    def _select_at_mouse(self, context, event):
        """Whether there is a point at the mouse; it is selected then, alone unless it was among the selected ones."""
        area = picking.area_at(event.mouse_x, event.mouse_y)
        if area is None:
            return False
        pixel = event.mouse_x - area[1].x, event.mouse_y - area[1].y
        found = seeing.point_at(context, *area, pixel, self.nets(context), are_meant=self.is_meant)
        if found is None:
            return False
        ob, vertex = found
        if vertex not in selection.selected(ob, live.session(ob.data).net):
            for other in editing.nets_in_edit_mode(context):
                if (known := live.known_session(other.data)):
                    with suppress(Refusal):
                        selection.select(other, known.net, [vertex] if other == ob else [])
            bpy.ops.ed.undo_push(message="Select")
        return True


def scaled(pixels):
    """Pixels of this interface in those of one that is not scaled."""
    return pixels / bpy.context.preferences.system.ui_scale
