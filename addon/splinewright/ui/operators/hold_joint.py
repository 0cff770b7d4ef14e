"""Joints of curves hold while either side is edited, until they are released."""

import bpy
import numpy as np
from bpy.props import EnumProperty, IntProperty

from ...bridge.data import held, store
from ...bridge.edit import replace_pieces
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.joints import held_joints, patch_joints
from ...core.joints.held import Held, applied
from ...core.shape import parameters
from ...core.verbs import verbs
from .hold_seam import OnWhatHolds, number_property, released

_WORDS = {'C0': "They meet", 'G1': "They share the tangent, too", 'C1': "They share the first derivative",
          'G2': "They share the osculating circle, too", 'C2': "They share the first two derivatives"}
_MOVES = {'second': ("Other", "What begins there moves to what ends there"), 'first': ("First", "What ends there moves"),
          'both': ("Both", "Each goes half of the way")}


def _end(default):
    items = [('start', "Start", "Where it begins"), ('end', "End", "Where it ends")]
    return EnumProperty(name="End", description="Which end of it", items=items, default=default, options={'SKIP_SAVE'})


def _knot():
    return IntProperty(name="Knot", description="Which knot inside the first piece, counted from 1; 0 for the ends", default=0,
                       min=0, options={'SKIP_SAVE'})


class _OnJoint(OnWhatHolds):
    wanted, fits = "Select a curve shape, or edit its net", staticmethod(replace_pieces.is_curve_shape)

    def sides(self, data):
        """As of a core.joints.held.Held. Raises Refusal where there are none."""
        curves = verbs.curves_of(store.read(data))
        for number in (self.first, self.second):
            verbs.require_piece(curves, number)
        if not self.knot:
            return (self.first - 1, self.first_end), (self.second - 1, self.second_end)
        knots = parameters.inner_knots(curves[self.first - 1]).tolist()
        if self.knot > len(knots):
            raise Refusal("piece {first} has {count} knots inside, none of number {knot}",
                          "piece {first} has {count} knot inside, none of number {knot}",
                          first=self.first, count=len(knots), knot=self.knot)
        return ((self.first - 1, knots[self.knot - 1]),) * 2


class SPLINEWRIGHT_OT_hold_joint(_OnJoint, bpy.types.Operator):
    bl_idname = "splinewright.hold_joint"
    bl_label = "Lock Joint Continuity"
    bl_description = "Make curves continue each other smoothly at a joint, and keep that while either side is edited"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    continuity: EnumProperty(name="Continuity", description="What both sides share there", default='G1',
                             items=[(name, name, _WORDS[name]) for name in held_joints.SMOOTHNESS])
    moves: EnumProperty(name="Moves", description="Which side gives way",
                        items=[(name, *_MOVES[name]) for name in patch_joints.MOVES])
    first: number_property("Piece", "The one that ends there")
    first_end: _end('end')
    second: number_property("Piece", "The one that begins there")
    second_end: _end('start')
    knot: _knot()

    def work(self, ob):
        replace_pieces.require_changeable(ob.data)
        definition, joint = store.read(ob.data), Held(*self.sides(ob.data), self.continuity, self.moves)
        held_joints.require_possible(definition, joint)
        after = applied(definition, held.with_one(ob.data, joint))
        if after is not definition:
            shape.set_definition(ob.data, after)
        held.hold(ob.data, joint)
        moved = np.linalg.norm((after.pool - definition.pool)[:, :3], axis=1).max()
        return phrase("{continuity} holds from now on; ", continuity=self.continuity) + (phrase("points moved by up to {moved}",
                                                                  moved=decimals.text_of(moved, 2)) if moved else "nothing moved"), ()

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "continuity", expand=True)
        layout.row().prop(self, "moves", expand=True)


class SPLINEWRIGHT_OT_release_joint(_OnJoint, bpy.types.Operator):
    bl_idname = "splinewright.release_joint"
    bl_label = "Unlock Joint Continuity"
    bl_description = "Let both sides of a joint be edited independently again"
    bl_options = {'REGISTER', 'UNDO'}

    first: number_property("Piece", "The one that ends there")
    first_end: _end('end')
    second: number_property("Piece", "The one that begins there")
    second_end: _end('start')
    knot: _knot()

    def work(self, ob):
        return released(ob.data, self.sides(ob.data), 'joint'), ()


CLASSES = (SPLINEWRIGHT_OT_hold_joint, SPLINEWRIGHT_OT_release_joint)
