"""Points of a net go to infinity, and come back."""

import bpy

from ...bridge import recipes, shape, store
from ...bridge.net import live, net_object
from ...core import infinity
from ...core.failures import FAILURES, Refusal, sentence
from .. import editing, net_props


class _OnSelectedPoints:
    """Changes the rows of the pool behind the selected points of the nets in Edit Mode."""

    bl_options = {'REGISTER', 'UNDO'}

    @staticmethod
    def changed(definition, rows):
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set("Edit the net of a shape first")
            return False
        return True

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        try:
            changes = [change for change in map(self._change, nets) if change]
            if not changes:
                raise Refusal("select points of the net")
            for data, definition in changes:
                shape.set_definition(data, definition)
        except FAILURES as error:
            self.report({'ERROR'}, sentence(error))
            return {'CANCELLED'}
        editing.anew(context, nets)
        return {'FINISHED'}

    def _change(self, ob):
        """(data-block, definition) of a net's shape, or None where nothing is selected."""
        _, vertices = net_props.chosen(ob.data)
        rows = sorted({int(row) for row in live.session(ob.data).net.rows[vertices] if row >= 0})
        if not rows:
            return None
        live.pull(ob)
        if live.problem(ob):
            raise Refusal(live.problem(ob))
        data = net_object.shape_of(ob).data
        recipes.require_free(data)
        return data, self.changed(store.read(data), rows)


class SPLINEWRIGHT_OT_point_to_infinity(_OnSelectedPoints, bpy.types.Operator):
    bl_idname = "splinewright.point_to_infinity"
    bl_label = "Send to Infinity"
    bl_description = "Make the selected points directions: control points at infinity, of weight 0, shown as arrows"
    changed = staticmethod(infinity.sent)


class SPLINEWRIGHT_OT_point_from_infinity(_OnSelectedPoints, bpy.types.Operator):
    bl_idname = "splinewright.point_from_infinity"
    bl_label = "Bring Back from Infinity"
    bl_description = "Make the selected arrows points of weight 1 where their heads are"
    changed = staticmethod(infinity.brought_back)


CLASSES = (SPLINEWRIGHT_OT_point_to_infinity, SPLINEWRIGHT_OT_point_from_infinity)
