"""Edit the knots of a shape as text, also while its net is edited."""

from contextlib import suppress

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from ...bridge.cage import net_object
from ...bridge.data import held, store
from ...bridge.net import live
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import say
from ...core.verbs import knots
from .. import active_shape, editing, texts
from ..ui_state import ui_state
from . import reports
from .pick_piece import draw_number


class SPLINEWRIGHT_OT_set_knots(bpy.types.Operator):
    bl_idname = "splinewright.set_knots"
    bl_label = "Edit Knots"
    bl_description = "Give a piece of the shape other knots; of a Hermite piece, other parameters"
    bl_options = {'REGISTER', 'UNDO'}
    works_on_nets = True

    piece: IntProperty(name="Piece", description="Which curve or patch of the shape, counted from 1", default=1, min=1,
                       options={'SKIP_SAVE'})
    axis: EnumProperty(name="Axis", description="Direction of a patch", options={'SKIP_SAVE'}, items=(
        ('U', "U", "The knots along u, or of a curve"), ('V', "V", "The knots along v")))
    knots: StringProperty(
        name="Knots", description="Numbers with spaces between, none smaller than the one before; "
        "the parameters of a Hermite piece grow from each to the next", options={'SKIP_SAVE'})
    #: The piece and axis whose knots the text was read from; "" where a script gave it.
    shown: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    #: (name of a data-block, piece and axis, its knots), and the text that was refused for them.
    _refused = (), ""

    @classmethod
    def poll(cls, context):
        if _active_shape(context) is None:
            cls.poll_message_set(say("Select a shape, or edit its net"))
            return False
        return True

    def invoke(self, context, event):
        owner = _active_shape(context)
        active_shape.forget_asked()
        active_shape.begin(self, [owner])
        try:
            self._show_knots(owner.data)
        except FAILURES as error:
            return reports.failed(self, error)
        self._show_refused(owner.data)
        ui_state.asking.add(self.bl_idname)
        return context.window_manager.invoke_props_dialog(self, width=700)

    def cancel(self, context):
        ui_state.asking.discard(self.bl_idname)

    def check(self, context):
        """A setting was changed: with another piece or axis the text becomes the knots of that."""
        owner = _active_shape(context)
        if owner is None or not self._is_of_another():
            return False
        with suppress(*FAILURES):       # draw() tells of it
            self._show_knots(owner.data)
        return True

    def _place(self):
        return f"{self.piece} {self.axis}"

    def _is_of_another(self):
        """Whether the text was read for another piece or axis than is set now."""
        return self.shown not in ("", self._place())

    def _show_knots(self, data):
        self.knots = knots.text_of(store.read(data), self.piece - 1, self._axis())
        self.shown = self._place()

    def _show_refused(self, data):
        """The text that was refused last, where it was for these very knots."""
        place, text = self._refused
        if place == (data.name, self._place(), self.knots):
            self.knots = text

    def _keep_refused(self, data, text):
        """For the next time that this is asked for; "" for what was taken."""
        with suppress(*FAILURES):
            now = knots.text_of(store.read(data), self.piece - 1, self._axis())
            type(self)._refused = ((data.name, self._place(), now), text) if text else ((), "")

    def draw(self, context):
        owner = _active_shape(context)
        if owner is None:
            return
        definition = store.read(owner.data)
        row = self.layout.row()
        if len(definition.pieces) > 1:
            draw_number(row, self, "piece")
        if not definition.has_curves:
            row.row().prop(self, "axis", expand=True)
        if not self._is_of_another():
            self.layout.prop(self, "knots", text="")
            return
        try:
            knots.text_of(definition, self.piece - 1, self._axis())
        except FAILURES as error:
            texts.draw_problem(self.layout, sentence(error), width=100)

    def execute(self, context):
        self.cancel(context)            # the dialog is closed
        owner = _active_shape(context)
        active_shape.forget_asked()
        active_shape.note(self, 'piece', owner)
        editing_nets = editing.nets_in_edit_mode(context)
        for ob in editing_nets:
            live.sync_from_cage(ob)
            if live.problem(ob):
                return reports.cancelled(self, live.problem(ob))
        try:
            recipes.require_free(owner.data)
            if self._is_of_another():   # the redo panel calls no check() before
                self._show_knots(owner.data)
            before, seams = store.read(owner.data), held.known(owner.data)
            shape.set_definition(owner.data, knots.replaced(before, self.piece - 1, self._axis(), self.knots))
            held.carry(owner.data, seams, before)
        except FAILURES as error:
            self._keep_refused(owner.data, self.knots)
            return reports.failed(self, error)
        self._keep_refused(owner.data, "")
        return reports.finished(self, reports.Report(warnings=editing.anew(context, editing_nets) if editing_nets else ()))

    def _axis(self):
        return 'UV'.index(self.axis)


def _active_shape(context):
    """The active shape, or the one whose net is active in Edit Mode."""
    ob = context.object
    if net_object.is_net(ob):
        return active_shape.shape_of(ob) if ob.mode == 'EDIT' else None
    return ob if shape.has_shape(ob) and ob.mode == 'OBJECT' and not editing.why_not(ob) else None


CLASSES = (SPLINEWRIGHT_OT_set_knots,)
