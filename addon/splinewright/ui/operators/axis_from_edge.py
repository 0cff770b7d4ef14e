"""Turn a surface of revolution about an edge of a mesh that is clicked in the view."""

import bpy
from bpy.props import FloatVectorProperty, StringProperty
from mathutils import Matrix, Vector

from ...bridge.follow import follow
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from .. import edge_picking
from ..ui_state import ui_state
from . import polls, reports
from .gesture import redraw
from .pointing import Pointing


class SPLINEWRIGHT_OT_axis_from_edge(Pointing, bpy.types.Operator):
    bl_idname = "splinewright.axis_from_edge"
    bl_label = "Pick Axis from Edge"
    bl_description = "Click a mesh edge: the active surface of revolution turns about it, and follows an empty there"
    bl_options = {'REGISTER', 'UNDO'}
    hint = "Click an edge of a mesh as the axis   |   Esc, Right Mouse: Cancel"

    start: FloatVectorProperty(name="Start", description="Where the edge begins, in the world", subtype='TRANSLATION',
                               options={'SKIP_SAVE'})
    end: FloatVectorProperty(name="End", description="Where the edge ends, in the world", subtype='TRANSLATION',
                             default=(0.0, 0.0, 1.0), options={'SKIP_SAVE'})
    parent: StringProperty(name="Moves With", description="Object that takes the axis along; empty: none",
                           options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        ob = context.object
        if not shape.has_shape(ob) or ob.data.library or recipes.kind(ob.data) != 'revolve':
            cls.poll_message_set(say("Select a shape that Revolve made"))
            return False
        return True

    def invoke(self, context, event):
        return self.begin(context, event)

    def forget(self):
        ui_state.edge = None

    def look(self, context, event):
        ui_state.edge = edge_picking.edge_at(context, event.mouse_x, event.mouse_y, context.object)
        redraw()
        return ui_state.edge is not None

    def clicked(self, context):
        self.parent, self.start, self.end = ui_state.edge
        self.cancel(context)
        return self.execute(context)

    def execute(self, context):
        ob, axis = context.object, None
        try:
            axis = _put_axis(context, ob, Vector(self.start), Vector(self.end), self.parent)
            follow.set_frame(ob.data, axis, context.evaluated_depsgraph_get(),
                             {'axis': 'z', 'offset_x': 0.0, 'offset_y': 0.0, 'offset_z': 0.0})
        except FAILURES as error:
            if axis is not None:
                bpy.data.objects.remove(axis)
            return reports.failed(self, error, ob.name)
        beside = phrase(" beside {parent}", parent=self.parent) if self.parent else ""
        return reports.finished(self, reports.Report(phrase("{name} turns about {axis_name}{beside}",
                                                            name=ob.name, axis_name=axis.name, beside=beside)))


def _put_axis(context, ob, start, end, parent):
    """A new empty whose z leads from start to end. Raises Refusal."""
    along = end - start
    if not along.length > 0.0:
        raise Refusal("the edge has no length: it shows no direction")
    holder = context.scene.objects.get(parent) if parent else None
    if parent and holder is None:
        raise Refusal("there is no object named {parent} in this scene", parent=parent)
    axis = bpy.data.objects.new(f"{ob.name} Axis", None)
    axis.empty_display_type, axis.empty_display_size = 'SINGLE_ARROW', along.length
    for collection in ob.users_collection:
        collection.objects.link(axis)
    if holder is not None:
        axis.parent, axis.matrix_parent_inverse = holder, holder.matrix_world.inverted_safe()
    axis.matrix_basis = Matrix.Translation(start) @ along.to_track_quat('Z', 'Y').to_matrix().to_4x4()
    context.view_layer.update()
    return axis


CLASSES = (SPLINEWRIGHT_OT_axis_from_edge,)
