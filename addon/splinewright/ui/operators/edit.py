"""Edit a shape's net, and leave it."""

import bpy
from bpy.props import EnumProperty, IntProperty, StringProperty

from ...bridge import shape, store
from ...bridge.net import live, net, net_points
from ...core import knots
from .. import editing, progress


class SPLINEWRIGHT_OT_edit_net(bpy.types.Operator):
    bl_idname = "splinewright.edit_net"
    bl_label = "Edit Net"
    bl_description = "Edit the control net of the active shape, and of selected ones of its kind, in Edit Mode"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT':
            cls.poll_message_set("Leave the present mode first")
            return False
        reason = editing.why_not(context.object)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    def execute(self, context):
        try:
            with progress.shown(context, len(context.selected_objects)) as step:
                editing.enter(context, context.object, step)
        except (ValueError, TypeError, ArithmeticError, RuntimeError) as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        return {'FINISHED'}


class SPLINEWRIGHT_OT_leave_net(bpy.types.Operator):
    bl_idname = "splinewright.leave_net"
    bl_label = "Leave Net"
    bl_description = "Put the control net away; the shape keeps every digit"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set("No net is being edited")
            return False
        return True

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        with progress.shown(context, len(nets)) as step:
            problem = editing.leave(context, step)
        if problem:
            self.report({'WARNING'}, f"The last state of the net was not taken: {problem}")
        return {'FINISHED'}


class SPLINEWRIGHT_OT_set_knots(bpy.types.Operator):
    bl_idname = "splinewright.set_knots"
    bl_label = "Edit Knots"
    bl_description = "Give a piece of the shape other knots; of a Hermite piece, other parameters"
    bl_options = {'REGISTER', 'UNDO'}

    piece: IntProperty(name="Piece", description="Which curve or patch of the shape", default=0, min=0)
    axis: EnumProperty(name="Axis", description="Direction of a patch", items=(
        ('U', "U", "The knots along u, or of a curve"), ('V', "V", "The knots along v")))
    knots: StringProperty(name="Knots", description="Numbers that never decrease, with spaces between")

    @classmethod
    def poll(cls, context):
        if _shape_in_hand(context) is None:
            cls.poll_message_set("Select a shape, or edit its net")
            return False
        return True

    def invoke(self, context, event):
        try:
            definition = store.read(_shape_in_hand(context).data)
            self.knots = knots.text_of(definition, self.piece, self._axis())
        except ValueError as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        return context.window_manager.invoke_props_dialog(self, width=700)

    def draw(self, context):
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
            shape.require_untouched(owner.data)
            changed = knots.replaced(store.read(owner.data), self.piece, self._axis(), self.knots)
            shape.set_definition(owner.data, changed)
        except (ValueError, TypeError, ArithmeticError) as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        if editing_nets:
            _edit_anew(context, editing_nets)
        return {'FINISHED'}

    def _axis(self):
        return 'UV'.index(self.axis)


def _shape_in_hand(context):
    """The active shape, or the one whose net is active in Edit Mode."""
    ob = context.object
    if net.is_net(ob) and ob.mode == 'EDIT':
        return net.shape_of(ob)
    return ob if shape.has_shape(ob) and ob.mode == 'OBJECT' and not editing.why_not(ob) else None


def _edit_anew(context, nets):
    """Put the nets away and out again, from what the shapes are now; points stay selected."""
    selections = {}
    for ob in nets:
        owner = net.shape_of(ob)
        if owner is not None:
            selections[owner.name] = net_points.selected(ob, live.session(ob.data).net)
    active = net.shape_of(context.object)
    editing.leave(context)
    if active is None or context.view_layer.objects.get(active.name) != active:
        return
    context.view_layer.objects.active = active
    for ob in editing.enter(context, active):
        numbers = live.session(ob.data).net
        net_points.select(ob, numbers, selections.get(net.shape_of(ob).name, ()))


CLASSES = (SPLINEWRIGHT_OT_edit_net, SPLINEWRIGHT_OT_leave_net, SPLINEWRIGHT_OT_set_knots)
