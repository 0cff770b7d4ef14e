"""Points of a net go to infinity, and come back."""

import bpy

from ...bridge.cage import net_object
from ...bridge.data import store
from ...bridge.net import live
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import say
from ...core.shape import infinity
from .. import editing, net_props
from . import reports


class _OnSelectedPoints:
    """Changes the rows of the pool behind the selected points of the nets in Edit Mode: of all shapes, or of none."""

    bl_options = {'REGISTER', 'UNDO'}
    works_on_nets = True

    @staticmethod
    def changed(definition, rows):
        """The definition with these rows of its pool changed. Raises Refusal."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        if not editing.nets_in_edit_mode(context):
            cls.poll_message_set(say("Edit the net of a shape first"))
            return False
        return True

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        chosen = {ob: rows for ob in nets if (rows := _selected_rows(ob))}
        if not chosen:
            return reports.cancelled(self, "select points of the net")
        plans, failed = [], {}
        for ob, rows in chosen.items():
            try:
                plans.append(self._planned(ob, rows))
            except FAILURES as error:
                failed[_name(ob)] = sentence(error)
        if failed:
            return reports.cancelled(self, *(reports.by_name(failed) if len(nets) > 1 else failed.values()))
        for plan in plans:
            shape.carry_out(plan)
        return reports.finished(self, reports.Report(warnings=editing.anew(context, nets)))

    def _planned(self, ob, rows):
        """The shape.Plan for the shape of a net."""
        owner = net_object.shape_of(ob)
        if owner is None:
            raise Refusal("the shape of this net was deleted, or is in no scene")
        live.sync_from_cage(ob)
        if live.problem(ob):
            raise Refusal(live.problem(ob))
        recipes.require_free(owner.data)
        return shape.planned(owner.data, self.changed(store.read(owner.data), rows))


def _selected_rows(ob):
    _, vertices = net_props.chosen(ob.data)
    return sorted({int(row) for row in live.session(ob.data).net.rows[vertices] if row >= 0})


def _name(ob):
    owner = net_object.shape_of(ob)
    return owner.name if owner else ob.name


class SPLINEWRIGHT_OT_point_to_infinity(_OnSelectedPoints, bpy.types.Operator):
    bl_idname = "splinewright.point_to_infinity"
    bl_label = "Move to Infinity"
    bl_description = "Make the selected points directions: control points at infinity, of weight 0, shown as arrows"
    changed = staticmethod(infinity.sent)


class SPLINEWRIGHT_OT_point_from_infinity(_OnSelectedPoints, bpy.types.Operator):
    bl_idname = "splinewright.point_from_infinity"
    bl_label = "Bring Back from Infinity"
    bl_description = "Make the selected arrows points of weight 1 where their heads are"
    changed = staticmethod(infinity.brought_back)


CLASSES = (SPLINEWRIGHT_OT_point_to_infinity, SPLINEWRIGHT_OT_point_from_infinity)
