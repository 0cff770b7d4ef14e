"""Something in the view is pointed at, and clicked: what operators of that kind have in common."""

from bpy.props import BoolProperty

from ...core.base.words import say
from ..ui_state import ui_state
from . import meant
from .gesture import Gesture

def given(operator, *names):
    """Those of an operator's settings that a tool has, or that were set; another operator keeps its own for the others."""
    return {name: getattr(operator, name) for name in names
            if operator.at_once or operator.properties.is_property_set(name)}


def take_again(context, ob):
    """Select an object beside what was made of it, and make it active: for the next click of a tool."""
    ob.select_set(True)
    context.view_layer.objects.active = ob


class Pointing(Gesture):
    """The item at the mouse is shown until it is clicked. `hint` stands in the status bar."""

    cursor = 'EYEDROPPER'
    hint = ""

    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # click where the mouse is, or leave the key to others

    def look(self, context, event):
        """Find the item at the mouse, and show it; whether there is anything."""
        raise NotImplementedError

    def forget(self):
        """Show nothing any more."""
        raise NotImplementedError

    def clicked(self, context):
        """What step() returns when what look() found is clicked; it is shown still."""
        raise NotImplementedError

    def meant(self, context):
        """The shapes that can be clicked now; none where anything can."""
        return []

    def begin(self, context, event):
        if self.at_once:
            if not self.look(context, event):
                self.forget()
                return {'PASS_THROUGH', 'CANCELLED'}
            ended = self.clicked(context)
            if ended != {'RUNNING_MODAL'}:
                return ended
        ui_state.is_pointing = True
        self.tell(context)
        self.look(context, event)
        return self.begin_modal(context)

    def step(self, context, event):
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
        """In the status bar: why a click did nothing, the current object, and the keys."""
        first = f"{why_none}   |   " if why_none else meant.works_on(self.meant(context))
        context.workspace.status_text_set(say(first + self.hint))

    def hide(self):
        ui_state.is_pointing = False
        self.forget()
