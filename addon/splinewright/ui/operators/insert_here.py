"""By a click on the shape: a knot is inserted, the shape is split, an isocurve is extracted. Where is shown at the mouse."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ...bridge.analysis import surveys
from ...bridge.edit import replace_pieces
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.verbs import parameter_picking
from .. import active_shape, aim_overlay, editing, picking
from ..ui_state import ui_state
from . import meant, reports
from .on_shapes import at_exactly
from .gesture import Gesture, redraw
from .pointing import take_again

_DIRECTIONS = ('U', 'V', 'BOTH')
#: Pixels, of an interface that is not scaled, that belong to a point.
_ON_POINT = 8.0
_STEPS = {'WHEELUPMOUSE': 1, 'WHEELDOWNMOUSE': -1}


class ByClick(Gesture):
    """The item at the mouse is shown until it is clicked, or called off."""

    bl_options = {'REGISTER'}
    cursor = 'CROSSHAIR'
    works_on_nets = True
    #: What lies at the mouse, and what a click does with it, as the status bar says it.
    thing, does = "", ""
    #: How many parameters what is clicked may have.
    dimensions = (1, 2)

    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # click where the mouse is, or leave the key to others
    direction: EnumProperty(name="Along", description="Along which direction of a patch", options={'SKIP_SAVE'}, items=(
        ('U', "U", "At one u"), ('V', "V", "At one v"), ('BOTH', "Both", "At both")))

    def clicked(self, aimed):
        """Do it at an Aim, by the operator whose panel then has the numbers."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        shapes = active_shape.shapes(context)
        if not shapes:
            cls.poll_message_set(say("Select a Splinewright shape, or edit its net"))
        elif not any(map(active_shape.is_free, shapes)):
            cls.poll_message_set(say("The shape is made by a recipe: use Apply Construction first"))
        return is_possible(context)

    def invoke(self, context, event):
        aimed = self.at_once and aimed_by_tool(context, event.mouse_x, event.mouse_y, self.direction, event.ctrl, self.dimensions)
        if self.at_once and not aimed:
            return {'PASS_THROUGH', 'CANCELLED'}
        problem = editing.unread(editing.nets_in_edit_mode(context))
        if problem:
            return reports.cancelled(self, problem)
        if aimed:
            return self.clicked(aimed)
        self._snaps, self._why_none = False, ""
        self._aim(context, event)
        return self.begin_modal(context)

    def lets_pass(self, event):
        return super().lets_pass(event) and not self._turns(event)

    def step(self, context, event):
        if self._turns(event):
            self.direction = _DIRECTIONS[(_DIRECTIONS.index(self.direction) + _STEPS[event.type]) % len(_DIRECTIONS)]
        self._snaps |= not event.ctrl   # the Ctrl of the key that called it does not count
        self._aim(context, event)
        if event.type not in ('LEFTMOUSE', 'RET', 'NUMPAD_ENTER') or event.value != 'PRESS':
            return {'RUNNING_MODAL'}
        if not ui_state.aimed:
            self._why_none = meant.why_none(context, event, self.meant(context))
            self._tell(context)
            return {'RUNNING_MODAL'}
        aimed = ui_state.aimed
        self.end_modal(context)
        return self.clicked(aimed)

    def done_at(self, aimed, operator, **settings):
        """Do it by another operator."""
        settings.update(at_exactly(*aimed.parameters))
        if len(aimed.parameters) == 2:
            settings['direction'] = aimed.direction
        return reports.called(self, operator, only=aimed.name, piece=aimed.number, **settings)

    def hide(self):
        ui_state.aimed = None

    def _turns(self, event):
        """Whether the wheel changes the direction of the item at the mouse, a patch."""
        return event.type in _STEPS and ui_state.aimed is not None and len(ui_state.aimed.parameters) == 2

    def told(self, context, aimed):
        """The Aim, with what a click would do."""
        return aimed

    def _aim(self, context, event):
        """Find the item at the mouse, with Ctrl the middle of the span there, and show it."""
        aimed = aimed_at(context, event.mouse_x, event.mouse_y, self.direction, self._snaps and event.ctrl)
        ui_state.aimed = self.told(context, aimed) if aimed else None
        if aimed or event.type != 'LEFTMOUSE':
            self._why_none = "" if aimed else self._why_none
            self._tell(context)
        redraw()

    @classmethod
    def meant(cls, context):
        """The shapes that can be clicked."""
        return _meant(context)

    def _tell(self, context):
        """In the status bar: why a click did nothing or the current object, and the keys."""
        first = f"{self._why_none}   |   " if self._why_none else meant.works_on(self.meant(context))
        context.workspace.status_text_set(say(first + _status(ui_state.aimed, self.thing, self.does)))


class SPLINEWRIGHT_OT_insert_here(ByClick, bpy.types.Operator):
    bl_idname = "splinewright.insert_here"
    bl_label = "Insert Knot"
    bl_description = "Click a curve or patch to insert a knot there; the shape does not change, but gets more control points"
    thing, does = "Knot at {numbers}", "Click: insert"

    def clicked(self, aimed):
        return self.done_at(aimed, bpy.ops.splinewright.insert_knot, where='PARAMETER', times=1)


class SPLINEWRIGHT_OT_split_here(ByClick, bpy.types.Operator):
    bl_idname = "splinewright.split_here"
    bl_label = "Split"
    bl_description = "Click the curve or patch where it is to be split in two; the shape stays the same"
    thing, does = "Cut at {numbers}", "Click: split"

    def clicked(self, aimed):
        return self.done_at(aimed, bpy.ops.splinewright.split, where='PARAMETER')


class SPLINEWRIGHT_OT_extract_here(ByClick, bpy.types.Operator):
    bl_idname = "splinewright.extract_here"
    bl_label = "Extract Isocurve"
    bl_description = "Click a patch to extract an exact isocurve there, as a new shape"
    thing, does = "Isocurve at {numbers}", "Click: extract"
    dimensions = (2,)
    works_on_nets = False

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT' or not any(map(replace_pieces.is_patch_shape, context.selected_objects)):
            cls.poll_message_set(say("Select a patch shape in Object Mode"))
            return False
        return super().poll(context)

    def clicked(self, aimed):
        if len(aimed.parameters) == 1:
            return {'CANCELLED'}        # a curve is one already
        ended = self.done_at(aimed, bpy.ops.splinewright.extract_isocurve)
        if self.at_once:
            take_again(bpy.context, bpy.data.objects[aimed.name])
        return ended


def is_possible(context):
    """Whether an active shape takes knots."""
    return any(map(active_shape.is_free, active_shape.shapes(context)))


def aimed_at(context, x, y, direction, in_middle=False):
    """The Aim at a pixel of the window, or in the middle of the span there; None where nothing is to be pointed at."""
    try:
        found = _found(context, x, y, in_middle)
    except FAILURES:
        return None                     # such a shape shows nothing to point at
    return aim_overlay.Aim(found[0].name, found[1], found[2], direction) if found else None


def aimed_by_tool(context, x, y, direction, in_middle=False, dimensions=(1, 2)):
    """aimed_at() where it has one of these numbers of parameters; None at a point of a curve's net, which is selected by a click."""
    view = picking.view_at(x, y)
    curves = [ob for ob in editing.nets_in_edit_mode(context) if ob.type == 'CURVE']
    if view and picking.point_at(*view, (x - view[0].x, y - view[0].y), curves, within=_ON_POINT):
        return None
    found = aimed_at(context, x, y, direction, in_middle)
    return found if found and len(found.parameters) in dimensions else None


def _meant(context):
    """The active shapes that take knots, and are to be seen."""
    return [ob for ob in active_shape.shapes(context) if active_shape.is_free(ob) and ob.visible_get()]


def _found(context, x, y, in_middle):
    """(object, number of its piece, its parameters), or None."""
    found = picking.pointed_at(x, y, _meant(context), context.evaluated_depsgraph_get())
    if found is None or not in_middle:
        return found
    ob, number, parameters = found
    return ob, number, parameter_picking.in_middle(surveys.pieces_of(ob.data)[number - 1], parameters)


def _status(aimed, thing, does):
    if aimed is None:
        return "Point at the shape   |   Esc, Right Mouse: Cancel"
    names = {'U': "u", 'V': "v", 'BOTH': "uv"}[aimed.direction] if len(aimed.parameters) == 2 else "u"
    numbers = ", ".join(f"{name} = {value:.4g}" for name, value in zip("uv", aimed.parameters) if name in names)
    wheel = ("Wheel: along u, v, both",) if len(aimed.parameters) == 2 else ()
    return "   |   ".join((phrase(thing, numbers=numbers), does, "Ctrl: middle of the span", *wheel, "Esc, Right Mouse: Cancel"))


CLASSES = (SPLINEWRIGHT_OT_insert_here, SPLINEWRIGHT_OT_split_here, SPLINEWRIGHT_OT_extract_here)
