"""Something in the view is pointed at, and clicked: what operators of that kind have in common."""

from bpy.props import BoolProperty

from ...core.base import typed_number
from .. import picking
from ..ui_state import ui_state
from . import meant

#: What goes on meanwhile: the view may be turned.
PASSED = {'MIDDLEMOUSE', 'WHEELUPMOUSE', 'WHEELDOWNMOUSE', 'WHEELINMOUSE', 'WHEELOUTMOUSE', 'TRACKPADPAN', 'TRACKPADZOOM',
           'MOUSEROTATE', 'MOUSESMARTZOOM', 'NDOF_MOTION', 'HOME', *(f"NUMPAD_{key}" for key in "0 1 2 3 4 5 6 7 8 9".split()),
           'NUMPAD_PERIOD', 'NUMPAD_PLUS', 'NUMPAD_MINUS'}


def redraw():
    for area, _, _ in picking.views():
        area.tag_redraw()


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


def given(operator, *names):
    """Those of an operator's settings that a tool has, or that were set; another operator keeps its own for the others."""
    return {name: getattr(operator, name) for name in names
            if operator.at_once or operator.properties.is_property_set(name)}


def take_again(context, ob):
    """Select an object beside what was made of it, and make it active: for the next click of a tool."""
    ob.select_set(True)
    context.view_layer.objects.active = ob


class Pointing:
    """Modal: what is at the mouse is shown until it is clicked, or called off. `hint` stands in the status bar."""

    hint = ""

    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # click where the mouse is, or leave the key to others

    def look(self, context, event):
        """Find what is at the mouse, and show it; whether there is anything."""
        raise NotImplementedError

    def forget(self):
        """Show nothing any more."""
        raise NotImplementedError

    def clicked(self, context):
        """What modal() returns when what look() found is clicked; it is shown still."""
        raise NotImplementedError

    def meant(self, context):
        """The shapes that can be clicked now; none where anything can."""
        return []

    def begin(self, context, event):
        """What invoke() returns."""
        if self.at_once:
            if not self.look(context, event):
                self.forget()
                return {'PASS_THROUGH', 'CANCELLED'}
            ended = self.clicked(context)
            if ended != {'RUNNING_MODAL'}:
                return ended
        context.window_manager.modal_handler_add(self)
        ui_state.is_pointing = True
        context.window.cursor_modal_set('EYEDROPPER')
        self.tell(context)
        self.look(context, event)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type in PASSED:
            return {'PASS_THROUGH'}
        if event.type in ('ESC', 'RIGHTMOUSE') and event.value == 'PRESS':
            self.cancel(context)
            return {'CANCELLED'}
        is_found = event.type in ('MOUSEMOVE', 'LEFTMOUSE') and self.look(context, event)
        if event.type != 'LEFTMOUSE' or event.value != 'PRESS':
            return {'RUNNING_MODAL'}
        if is_found:
            ended = self.clicked(context)
            if ended == {'RUNNING_MODAL'}:
                self.tell(context)      # what can be clicked is another now
            return ended
        self.tell(context, meant.why_none(context, event, self.meant(context)) if self.meant(context) else "")
        return {'RUNNING_MODAL'}

    def tell(self, context, why_none=""):
        """In the status bar: why a click did nothing, what is worked on, and the keys."""
        first = f"{why_none}   |   " if why_none else meant.works_on(self.meant(context))
        context.workspace.status_text_set(first + self.hint)

    def cancel(self, context):
        """Also called by Blender, where another file is opened meanwhile."""
        ui_state.is_pointing = False
        self.forget()
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)
        redraw()
