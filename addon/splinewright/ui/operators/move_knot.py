"""Move a knot between its neighbors: on the knot strip by the mouse or typed numbers, or in the panel."""


import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty

from ...bridge.edit import moving_knots
from ...core.base import decimals, typed_number
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase, say
from ...core.verbs import knot_strip
from .. import knot_strip as strip
from .. import active_shape, editing
from ..ui_state import ui_state
from . import reports
from .gesture import Gesture, Typing, redraw
from .pick_piece import draw_number

#: The mouse has not been moved where it is nearer to where it was pressed, in pixels.
_STILL = 3.0
#: With Shift the knot goes by this part of what the mouse goes.
_FINE = 0.1
#: In pixels: to what the knot is rounded that follows the mouse, and with Ctrl.
_SHORT, _STEP = 0.25, 10.0
_KEYS = ("Move: the knot   |   Digits: its parameter   |   Ctrl: round numbers   |   Shift: finely   |   "
         "Esc, Right Mouse: as it was")


class SPLINEWRIGHT_OT_move_knot(Typing, Gesture, bpy.types.Operator):
    bl_idname = "splinewright.move_knot"
    bl_label = "Move Knot"
    bl_description = "Move a knot of the shape between its neighbors: the control points stay, and the shape follows"
    bl_options = {'REGISTER', 'UNDO', 'BLOCKING'}

    piece: IntProperty(name="Piece", description="Which curve or patch of the shape, counted from 1", default=1, min=1,
                       options={'SKIP_SAVE'})
    axis: EnumProperty(name="Axis", description="Direction of a patch", options={'SKIP_SAVE'}, items=(
        ('U', "U", "A knot along u, or of a curve"), ('V', "V", "A knot along v")))
    knot: IntProperty(name="Knot", description="Which of the knots, counted from 1; its copies go along", default=1,
                      min=1, options={'SKIP_SAVE'})
    parameter: FloatProperty(name="Parameter", description="Where it goes, between the knots beside it", default=0.0,
                             precision=5, step=1, options={'SKIP_SAVE'})
    #: The parameter with all its digits.
    exact: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if not active_shape.shapes(context):    # of those that are not to be changed the refusal tells
            cls.poll_message_set(say("Select a Splinewright shape, or edit its net"))
            return False
        return True

    # From here on: with numbers.

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        problem = editing.unread(nets)
        if problem:
            return reports.cancelled(self, problem)
        owner = active_shape.shape_of(context.object)
        if owner is None:
            return reports.cancelled(self, "the active object is not a shape")
        active_shape.forget_asked()
        active_shape.note(self, 'piece', owner)
        to = decimals.meant(self.parameter, self.exact)
        try:
            held = self._held(owner.data)
            held.show(to)
        except FAILURES as error:
            return reports.failed(self, error, owner.name)
        return reports.finished(self, reports.Report(phrase("Knot {knot} of {name} at {to:.6g}",
                                                            knot=self.knot, name=owner.name, to=to),
                                                   warnings=(*filter(None, [held.lost]),
                                                             *(editing.anew(context, nets) if nets else ()))))

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split, column.use_property_decorate = True, False
        column.prop(self, 'parameter')
        column.prop(self, 'knot')
        owner = active_shape.shape_of(context.object)
        if owner is not None and owner.type == 'MESH':
            column.row().prop(self, 'axis', expand=True)
        if owner is not None and active_shape.count_of(owner.data) > 1:
            draw_number(column, self, 'piece')

    def _held(self, data):
        return moving_knots.HeldKnot(data, self.piece - 1, 'UV'.index(self.axis), self.knot - 1)

    # From here on: by the mouse.

    def invoke(self, context, event):
        hit = strip.hit(context, event.mouse_region_x, event.mouse_region_y) if strip.is_on(context) else None
        if hit is None:
            return reports.cancelled(self, "point at a knot of the knot strip, which the Overlays popover switches on")
        if hit.mark is None:
            return {'CANCELLED'}        # nothing is there to be moved: what lies below is not meant
        self._shown, self._bar, self._mark = hit.shown, hit.bar, hit.mark
        self.piece, self.axis, self.knot = hit.shown.number, 'UV'[hit.axis], int(hit.bar.firsts[hit.mark]) + 1
        self._data, self._area = hit.shown.ob.data, context.area
        self._pressed = self._x = event.mouse_x
        self._moved, self._to, self._typed, self._problem = 0.0, hit.value, typed_number.Typed(), ""
        self._note = ""
        self._drag, self._refused = None, ""
        context.workspace.status_text_set(say(_KEYS))
        return self.begin_modal(context)

    def step(self, context, event):
        if not (self._drag or self._refused) and (str(self._typed) or abs(event.mouse_x - self._pressed) >= _STILL):
            self._begin(context)
        if event.type == 'MOUSEMOVE':
            self._moved += (event.mouse_x - self._x) * (_FINE if event.shift else 1.0)
            self._x = event.mouse_x
        elif self._is_over(event):
            return self._let_go(context)
        if self._drag is not None:
            self._show(event)
        return {'RUNNING_MODAL'}

    def _begin(self, context):
        """Take hold of the knot, or tell why it is to stay."""
        problem = editing.unread(editing.nets_in_edit_mode(context)) or knot_strip.why_fixed(self._bar, self._mark)
        try:
            if problem:
                raise Refusal(problem)
            self._drag = self._held(self._data)
        except FAILURES as error:
            self._refused = reports.named(self._shown.ob.name, sentence(error))
            self.write_header(self._area, self._refused)
            return
        ui_state.moved_knot = strip.Moved(self._data.name, 'UV'.index(self.axis), self._mark, self._shown.spans)

    def _is_over(self, event):
        if event.type == 'LEFTMOUSE':   # who types lets the button go
            return event.value == ('PRESS' if str(self._typed) else 'RELEASE')
        return event.type in ('RET', 'NUMPAD_ENTER') and event.value == 'PRESS' and not self._problem

    def _show(self, event):
        """Put the knot where the mouse or the keys set it, and report it."""
        if not str(self._typed):
            self._to = self._followed(event)
        elif self._typed.number is not None:
            self._to = self._typed.number
        self._problem = self._note = ""
        try:
            self._drag.show(self._to)
            self._note = self._drag.lost
        except FAILURES as error:
            self._problem = sentence(error)
        self.write_header(self._area, self._text())
        redraw()

    def _followed(self, event):
        """The parameter at the mouse, as short as pixels tell it."""
        start, axis = float(self._bar.values[self._mark]), 'UV'.index(self.axis)
        if not self._moved:
            return start
        width = self._shown.width(axis)
        step = knot_strip.step(width, (_STEP if event.ctrl else _SHORT) * (_FINE if event.shift else 1.0))
        low, high = knot_strip.reach(self._bar, self._mark)
        return knot_strip.within(start + self._moved * width, step, low, high)

    def _text(self):
        number = str(self._typed) + "|" if str(self._typed) else f"{self._to:.10g}"
        return phrase("Knot {knot} at {number}: {problem}",
                      knot=self.knot, number=number, problem=self._problem or self._note or knot_strip.where(self._bar, self._mark))

    def _let_go(self, context):
        is_moved = self._drag is not None and self._to != self._bar.values[self._mark]
        self.cancel(context)
        if self._refused:               # an error of Blender's would lie over the strip
            return reports.stopped(self, self._refused)
        if not is_moved:
            return {'CANCELLED'}
        self.parameter, self.exact = decimals.single(self._to), repr(self._to)
        return self.execute(context)

    def hide(self):
        ui_state.moved_knot = None

    def put_back(self):
        if self._drag is not None:
            self._drag.put_back()


CLASSES = (SPLINEWRIGHT_OT_move_knot,)
