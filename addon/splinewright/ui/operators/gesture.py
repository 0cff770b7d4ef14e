"""What all gestures of the mouse have in common: how they begin, how the view is turned meanwhile, how they are called off, and
that nothing of them stays on the screen."""

from contextlib import suppress

from ...core.base import typed_number
from .. import picking

#: What goes on meanwhile: the view may be turned.
PASSED = {'MIDDLEMOUSE', 'WHEELUPMOUSE', 'WHEELDOWNMOUSE', 'WHEELINMOUSE', 'WHEELOUTMOUSE', 'TRACKPADPAN', 'TRACKPADZOOM',
           'MOUSEROTATE', 'MOUSESMARTZOOM', 'NDOF_MOTION', 'HOME', *(f"NUMPAD_{key}" for key in "0 1 2 3 4 5 6 7 8 9".split()),
           'NUMPAD_PERIOD', 'NUMPAD_PLUS', 'NUMPAD_MINUS'}


def redraw():
    for area, _, _ in picking.views():
        area.tag_redraw()


class Gesture:
    """A modal operator that follows the mouse until it is done, which step() tells, or called off by Esc or the right button."""

    #: Blender's name of the mouse cursor meanwhile; None for the usual one.
    cursor = None
    #: What calls it off.
    called_off_by = ('ESC', 'RIGHTMOUSE')
    _headed = None

    def step(self, context, event):
        """What modal() returns at an event that neither turns the view nor calls the gesture off."""
        raise NotImplementedError

    def hide(self):
        """Show nothing any more."""

    def put_back(self):
        """Let the shapes be as they were, where the gesture is called off."""

    def called_off(self):
        """What modal() returns then."""
        return {'CANCELLED'}

    def takes(self, event):
        """Whether an event is part of the typed text."""
        return False

    def lets_pass(self, event):
        """Whether an event is left to the view."""
        return event.type in PASSED

    def begin_modal(self, context):
        """What invoke() returns."""
        context.window_manager.modal_handler_add(self)
        if self.cursor:
            context.window.cursor_modal_set(self.cursor)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if not self.takes(event) and self.lets_pass(event):
            return {'PASS_THROUGH'}
        if event.type in self.called_off_by and event.value == 'PRESS':
            self.cancel(context)
            return self.called_off()
        return self.step(context, event)

    def write_header(self, area, text):
        """Show a text in the header of an area, or of none, until the gesture ends."""
        self._headed = area
        if area is not None:
            area.header_text_set(text)

    def cancel(self, context):
        """Call the gesture off. Also called by Blender, where another file is opened meanwhile."""
        with suppress(ReferenceError):
            self.put_back()
        self.end_modal(context)

    def end_modal(self, context):
        """Leave nothing on the screen."""
        self.hide()
        with suppress(ReferenceError):      # the area may be gone
            if self._headed is not None:
                self._headed.header_text_set(None)
        if self.cursor:
            context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)
        redraw()


class Typing:
    """A number may be typed while the mouse leads: `_typed`, a core.base.typed_number.Typed."""

    def takes(self, event):
        """Whether a key is part of a number."""
        if event.value != 'PRESS' or event.ctrl or event.alt:
            return False
        if event.type == 'BACK_SPACE':
            self._typed = typed_number.shortened(self._typed)
            return True
        longer = typed_number.after(self._typed, event.unicode) if event.unicode else None
        self._typed = longer or self._typed
        return longer is not None
