"""Keys of control points: those that are selected in nets, or all of the selected shapes."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ...bridge.data import store
from ...bridge.keys import point_keys
from ...bridge.net import live, point_keying, selection
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase, say
from .. import active_shape, editing
from . import reports


class _OnPoints:
    """Works on points of shapes by their rows: of all shapes that can, and tells of the others."""

    bl_options = {'REGISTER', 'UNDO'}
    works_on_nets = True

    points: EnumProperty(name="Points", description="Which control points", options={'SKIP_SAVE'}, items=(
        ('SELECTED', "Selected", "Those that are selected in the net; in Object Mode all"), ('ALL', "All", "All of them")))

    @classmethod
    def poll(cls, context):
        shapes = active_shape.shapes(context)
        if not shapes:
            cls.poll_message_set(say("Select a Splinewright shape, or edit its net"))
        elif not any(map(cls.fits, shapes)):
            is_linked = all(ob.data.library for ob in shapes)
            cls.poll_message_set(say("The shape is linked from another file: make it local first" if is_linked else cls.needs))
        return any(map(cls.fits, shapes))

    def work(self, data, rows, frame):
        """How many points it was done to. rows: None for all."""
        raise NotImplementedError

    def execute(self, context):
        done, failed = {}, {}
        frame = context.scene.frame_current_final
        for owner, net in _edited(context):
            try:
                done[owner.name] = self.work(owner.data, self._rows(owner.data, net), frame)
            except FAILURES as error:
                failed[owner.name] = sentence(error)
        reasons = reports.by_name(failed) if len(done) + len(failed) > 1 else tuple(failed.values())
        if not any(done.values()):
            return reports.cancelled(self, *(reasons or (self.nothing,)))
        if editing.nets_in_edit_mode(context):
            editing.want_whole_step()
        count = sum(done.values())
        points = "1 point" if count == 1 else phrase("{count} points", count=count)
        return reports.finished(self, reports.Report(phrase(self.done, what=points, frame=f"{frame:g}"), warnings=reasons))

    def _rows(self, data, net):
        if net is None:
            return None
        live.sync_from_cage(net)
        if live.problem(net):
            raise Refusal(live.problem(net))
        session = live.session(net.data)
        if self.points == 'ALL':
            return None
        rows = set(point_keying.rows_of(session.net, data, selection.selected(net, session.net))) - {-1}
        if not rows:
            raise Refusal("select points of the net")
        return sorted(rows)


def _edited(context):
    """[(shape, its net in Edit Mode or None)], one for each data-block."""
    nets = editing.nets_in_edit_mode(context)
    found = [(active_shape.shape_of(net), net) for net in nets] if nets else [(owner, None) for owner in active_shape.shapes(context)]
    return list({owner.data: (owner, net) for owner, net in found if owner is not None}.values())


class SPLINEWRIGHT_OT_key_points(_OnPoints, bpy.types.Operator):
    bl_idname = "splinewright.key_points"
    bl_label = "Insert Point Keyframes"
    bl_description = "Insert keyframes of the control points at this frame: of selected ones, or in Object Mode of all"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    needs = "The shape is made by a recipe: key its numbers in the panel, or use Apply Construction first"
    nothing = "there is no point to key"
    done = "Keys of {what} at frame {frame}"

    place: BoolProperty(name="Location", description="Set keys of where points lie, and of the vectors of tangents and "
                        "directions", default=True)
    weight: BoolProperty(name="Weight", description="Set keys of the weights, of points that have one", default=True)

    fits = staticmethod(active_shape.is_free)

    def work(self, data, rows, frame):
        if not self.place and not self.weight:
            raise Refusal("choose Location, Weight or both")
        rows = range(len(store.pool(data))) if rows is None else rows
        return point_keying.insert(data, rows, frame, self.place, self.weight)


class SPLINEWRIGHT_OT_clear_point_keys(_OnPoints, bpy.types.Operator):
    bl_idname = "splinewright.clear_point_keys"
    bl_label = "Clear Point Keyframes"
    bl_description = "Delete keyframes of the control points: of selected ones, or in Object Mode of all"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    needs = "None of its points has keys"
    nothing = "none of these points has keys there"
    done = "Cleared keys of {what}"

    when: EnumProperty(name="Keys", description="Which keys", items=(
        ('ALL', "Of All Frames", "All of them"), ('FRAME', "Of This Frame", "Those at the current frame")))

    @staticmethod
    def fits(ob):
        return active_shape.is_free(ob) and point_keys.has(ob.data)

    def work(self, data, rows, frame):
        return point_keying.clear(data, rows, frame if self.when == 'FRAME' else None)


CLASSES = (SPLINEWRIGHT_OT_key_points, SPLINEWRIGHT_OT_clear_point_keys)
