"""Pick a piece of a shape by a click: the active piece, or a number in the panel of the last operator."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ...bridge.shape import shape
from ...core.base.words import phrase, say
from .. import active_shape, picking
from ..ui_state import ui_state
from . import polls, reports
from .gesture import redraw
from .pointing import Pointing


def draw_number(layout, operator, setting):
    """A setting of an operator that is the number of a piece, with a button to pick it in the view."""
    row = layout.row(align=True)
    row.prop(operator, setting)
    shapes = ui_state.asked.get((type(operator).__name__, setting), {})
    if any(len(numbers) > 1 for numbers in shapes.values()):
        row.operator("splinewright.pick_for_operator", text="", icon='EYEDROPPER').setting = setting


class _Picks(Pointing):
    """The piece at the mouse is shown, and picked() called with its object and number when it is clicked."""

    hint = "Click a piece to take its number   |   Esc, Right Mouse: Cancel"

    def candidates(self, context):
        """The numbers of pieces by names of objects."""
        raise NotImplementedError

    def picked(self, context, ob, number):
        """Returns what modal() does."""
        raise NotImplementedError

    def invoke(self, context, event):
        ui_state.picking = {name: numbers for name, numbers in self.candidates(context).items()
                         if (ob := context.view_layer.objects.get(name)) and ob.visible_get()}
        if not ui_state.picking:
            return reports.cancelled(self, "no shape whose pieces could be picked is to be seen")
        return self.begin(context, event)

    def forget(self):
        ui_state.picking, ui_state.hovered = {}, ()

    def clicked(self, context):
        name, number = ui_state.hovered
        number, ob = ui_state.picking[name][number - 1], context.view_layer.objects.get(name)
        self.cancel(context)
        return self.picked(context, ob, number)

    def look(self, context, event):
        view = picking.view_at(event.mouse_x, event.mouse_y)
        obs = [ob for ob in map(context.view_layer.objects.get, ui_state.picking) if shape.has_shape(ob)]
        found = None
        if view:
            region, view = view
            pixel = event.mouse_x - region.x, event.mouse_y - region.y
            found = picking.piece_at(region, view, pixel, obs, context.evaluated_depsgraph_get())
        hovered = (found[0].name, found[1]) if found and ui_state.picking[found[0].name][found[1] - 1] else ()
        if hovered != ui_state.hovered:
            ui_state.hovered = hovered
            redraw()
        return bool(hovered)


class SPLINEWRIGHT_OT_pick_piece(_Picks, bpy.types.Operator):
    bl_idname = "splinewright.pick_piece"
    bl_label = "Pick Piece"
    bl_description = "Click a piece in the 3D view: operators that ask for one begin with it"
    bl_options = {'UNDO'}

    other: BoolProperty(name="Other", description="Take the piece for the second one that operators ask for",
                        options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not shape.has_shape(context.object):
            cls.poll_message_set(say("Select a Splinewright shape"))
            return False
        if context.object.data.library:
            cls.poll_message_set(say("The shape is linked from another file: make it local first"))
            return False
        return True

    def candidates(self, context):
        obs = [context.object, *context.selected_objects]
        return {ob.name: active_shape.counted(ob.data) for ob in obs if shape.has_shape(ob) and not ob.data.library}

    def picked(self, context, ob, number):
        active_shape.take(ob.data, number, self.other)
        return reports.finished(self, reports.Report(phrase("Piece {number} of {name} is active", number=number, name=ob.name)))


class SPLINEWRIGHT_OT_pick_for_operator(_Picks, bpy.types.Operator):
    bl_idname = "splinewright.pick_for_operator"
    bl_label = "Pick Number"
    bl_description = "Click a piece in the 3D view to enter its number here"
    bl_options = {'INTERNAL'}

    setting: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        operator = context.active_operator
        return context.mode == 'OBJECT' and operator is not None and operator.bl_idname.startswith("SPLINEWRIGHT_OT_")

    def candidates(self, context):
        return active_shape.asked(context.active_operator).get(self.setting, {})

    def picked(self, context, ob, number):
        """As if the number was typed: the last operator is undone and done again with it."""
        operator = context.active_operator
        setattr(operator.properties, self.setting, number)
        area, region, _ = picking.views()[0]
        with context.temp_override(area=area, region=region):
            if bpy.ops.ed.undo_redo() == {'FINISHED'}:
                bpy.ops.ed.undo_push(message=getattr(bpy.types, operator.bl_idname).bl_label)
        return {'CANCELLED'}            # Blender 5.2 hides the panel when another operator finishes


CLASSES = (SPLINEWRIGHT_OT_pick_piece, SPLINEWRIGHT_OT_pick_for_operator)
