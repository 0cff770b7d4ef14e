"""Seams of patches hold while either side is edited, until they are released."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ...bridge.data import held, store
from ...bridge.edit import joining, replace_pieces
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.joints import patch_joints
from ...core.joints.held import Held, are_one
from ...core.verbs.patch_curves import SIDE_CHOICES
from .. import active_shape, editing
from . import reports
from .patch_join import came_apart, continuity_property, moves_property, told

_SIDES = list(SIDE_CHOICES)
_RELEASED = {'joint': "the joint is released", 'seam': "the seam is released"}
_ALL_RELEASED = {'joint': "all joints are released: what held was damaged", 'seam': "all seams are released: what held was damaged"}


def number_property(what, of):
    return IntProperty(name=what, description=f"{of}, counted from 1", default=1, min=1, options={'SKIP_SAVE'})


def _side():
    return EnumProperty(name="Side", description="Which side of it", items=_SIDES, options={'SKIP_SAVE'})


class OnWhatHolds:
    """With what joins pieces of the active shape, or of the one whose net is edited, which then comes out again."""

    wanted, fits = "Select a patch shape, or edit its net", staticmethod(replace_pieces.is_patch_shape)

    @classmethod
    def poll(cls, context):
        ob = active_shape.shape_of(context.object)
        if ob is None or not cls.fits(ob):
            cls.poll_message_set(say(cls.wanted))
            return False
        if context.mode != 'OBJECT' and not editing.nets_in_edit_mode(context):
            cls.poll_message_set(say("Leave the present mode first"))
            return False
        return True

    def execute(self, context):
        nets = editing.nets_in_edit_mode(context)
        problem = editing.unread(nets)
        if problem:
            return reports.cancelled(self, problem)
        ob = active_shape.shape_of(context.object)
        try:
            said, warnings = self.work(ob)
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        warnings = (*warnings, *(editing.anew(context, nets) if nets else ()))
        return reports.finished(self, reports.Report(phrase("{name}: {said}", name=ob.name, said=said), warnings=warnings))

    def sides(self):
        return (self.first - 1, self.first_side), (self.second - 1, self.second_side)


def released(data, sides, of):
    """Release one, or all where what holds is damaged; in words what was done."""
    try:
        held.release(data, *sides)
    except store.UnreadableDefinition:
        held.write(data, ())
        return _ALL_RELEASED[of]
    return _RELEASED[of]


class SPLINEWRIGHT_OT_hold_seam(OnWhatHolds, bpy.types.Operator):
    bl_idname = "splinewright.hold_seam"
    bl_label = "Lock Seam Continuity"
    bl_description = "Make two patches continue each other smoothly across their common edge, and keep that during editing"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    continuity: continuity_property()
    moves: moves_property()
    first: number_property("Patch", "One patch")
    first_side: _side()
    second: number_property("Patch", "The other patch")
    second_side: _side()

    def work(self, ob):
        replace_pieces.require_changeable(ob.data)
        seam = Held(*self.sides(), self.continuity, self.moves)
        definition = store.read(ob.data)
        if max(self.first, self.second) > len(definition.pieces) or not are_one(definition, seam):
            raise Refusal("these sides are not one edge: use Join Patches first")
        choices = (patch_joints.Choice(number + 1, side) for number, side in self.sides())
        found = joining.join_patches(ob, None, *choices, self.continuity, self.moves)
        held.hold(ob.data, seam)
        return phrase("{found}; {continuity} holds from now on", found=told(found), continuity=self.continuity), came_apart(found)


class SPLINEWRIGHT_OT_release_seam(OnWhatHolds, bpy.types.Operator):
    bl_idname = "splinewright.release_seam"
    bl_label = "Unlock Seam Continuity"
    bl_description = "Let both sides of a seam be edited independently again"
    bl_options = {'REGISTER', 'UNDO'}

    first: number_property("Patch", "One patch")
    first_side: _side()
    second: number_property("Patch", "The other patch")
    second_side: _side()

    def work(self, ob):
        return released(ob.data, self.sides(), 'seam'), ()


CLASSES = (SPLINEWRIGHT_OT_hold_seam, SPLINEWRIGHT_OT_release_seam)
