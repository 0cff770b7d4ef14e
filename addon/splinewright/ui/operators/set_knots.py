"""Edit the knots of a shape as text, also while its net is edited."""

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from ...bridge import recipes, shape, store
from ...bridge.net import live, net_object
from ...core import knots
from ...core.failures import FAILURES, sentence
from .. import editing


class SPLINEWRIGHT_OT_set_knots(bpy.types.Operator):
    bl_idname = "splinewright.set_knots"
    bl_label = "Edit Knots"
    bl_description = "Give a piece of the shape other knots; of a Hermite piece, other parameters"
    bl_options = {'REGISTER', 'UNDO'}

    piece: IntProperty(name="Piece", description="Which curve or patch of the shape, counted from 1", default=1, min=1)
    axis: EnumProperty(name="Axis", description="Direction of a patch", items=(
        ('U', "U", "The knots along u, or of a curve"), ('V', "V", "The knots along v")))
    knots: StringProperty(
        name="Knots", description="Numbers with spaces between, none smaller than the one before; "
        "the parameters of a Hermite piece grow from each to the next")

    @classmethod
    def poll(cls, context):
        if _shape_in_hand(context) is None:
            cls.poll_message_set("Select a shape, or edit its net")
            return False
        return True

    def invoke(self, context, event):
        try:
            self._show_knots(context)
        except FAILURES as error:
            self.report({'ERROR'}, sentence(error))
            return {'CANCELLED'}
        return context.window_manager.invoke_props_dialog(self, width=700)

    def check(self, context):
        """The dialog was changed: with another piece or axis it shows the knots of that."""
        if self._shown == (self.piece, self.axis):
            return False
        try:
            self._show_knots(context)
        except FAILURES as error:
            self.knots, self._shown = sentence(error), (self.piece, self.axis)
        return True

    def _show_knots(self, context):
        definition = store.read(_shape_in_hand(context).data)
        self.knots = knots.text_of(definition, self.piece - 1, self._axis())
        self._shown = self.piece, self.axis

    def draw(self, context):
        definition = store.read(_shape_in_hand(context).data)
        row = self.layout.row()
        if len(definition.pieces) > 1:
            row.prop(self, "piece")
        if not definition.has_curves:
            row.row().prop(self, "axis", expand=True)
        self.layout.prop(self, "knots", text="")

    def execute(self, context):
        owner = _shape_in_hand(context)
        editing_nets = editing.nets_in_edit_mode(context)
        for ob in editing_nets:
            live.pull(ob)
            if live.problem(ob):
                self.report({'ERROR'}, live.problem(ob))
                return {'CANCELLED'}
        try:
            recipes.require_free(owner.data)
            shape.require_untouched(owner.data)
            changed = knots.replaced(store.read(owner.data), self.piece - 1, self._axis(), self.knots)
            shape.set_definition(owner.data, changed)
        except FAILURES as error:
            self.report({'ERROR'}, sentence(error))
            return {'CANCELLED'}
        if editing_nets:
            editing.anew(context, editing_nets)
        return {'FINISHED'}

    def _axis(self):
        return 'UV'.index(self.axis)


def _shape_in_hand(context):
    """The active shape, or the one whose net is active in Edit Mode."""
    ob = context.object
    if net_object.is_net(ob) and ob.mode == 'EDIT':
        return net_object.shape_of(ob)
    return ob if shape.has_shape(ob) and ob.mode == 'OBJECT' and not editing.why_not(ob) else None


CLASSES = (SPLINEWRIGHT_OT_set_knots,)
