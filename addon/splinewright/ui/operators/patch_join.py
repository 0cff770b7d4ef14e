"""Patches continue as one another where two of their sides meet."""

import math

import bpy
from bpy.props import EnumProperty, IntProperty

from ...bridge.edit import joining, replace_pieces
from ...core.base import decimals
from ...core.base.failures import FAILURES
from ...core.base.words import phrase
from ...core.joints import patch_joints, seams
from ...core.verbs.patch_curves import SIDES, SIDE_CHOICES
from .. import active_shape
from . import polls, reports
from .pick_piece import draw_number

_WORDS = {'C0': "They share the edge", 'G1': "They share tangent planes, too",
          'C1': "They share first derivatives across the edge", 'G2': "They are as curved on both sides",
          'C2': "They share the first two derivatives across the edge"}
_MOVES = {'second': ("Other", "The second patch moves to the first"), 'first': ("First", "The first patch moves"),
          'both': ("Both", "Each as little as it must")}


def continuity_property(**settings):
    return EnumProperty(name="Continuity", description="What the patches share along the edge", default='G1',
                        items=[(name, name, _WORDS[name]) for name in patch_joints.SMOOTHNESS], **settings)


def moves_property(**settings):
    return EnumProperty(name="Moves", description="Which patch gives way",
                        items=[(name, *_MOVES[name]) for name in patch_joints.MOVES], **settings)


def _number_property(name, what):
    return IntProperty(name=name, description=f"{what}, counted from 1; 0 for the nearest", default=0, min=0,
                       options={'SKIP_SAVE'})


def _side_property(of):
    items = [('NEAREST', "Nearest", "The side that lies nearest to the other patch"),
             *SIDE_CHOICES]
    return EnumProperty(name="Side", description=f"Which side of {of}", items=items, default='NEAREST',
                        options={'SKIP_SAVE'})


class SPLINEWRIGHT_OT_join_patches(bpy.types.Operator):
    bl_idname = "splinewright.join_patches"
    bl_label = "Join Patches"
    bl_description = "Join two patches at their nearest sides with a chosen continuity, and report how far they moved"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    continuity: continuity_property()
    moves: moves_property()
    first: _number_property("Patch", "Which patch of the active shape")
    first_side: _side_property("it")
    second: _number_property("Other Patch", "Which other patch of it, or of the other shape")
    second_side: _side_property("the other patch")

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replace_pieces.is_patch_shape, "Select one or two patch shapes")

    def invoke(self, context, event):
        active_shape.begin_pair(self, context)
        return self.execute(context)

    def execute(self, context):
        ob = context.object
        other = next((other for other in context.selected_objects if other != ob), None)
        parted = active_shape.count_of(ob.data) if other else None
        named = _named_of_two(ob, other) if other else _named
        try:
            found = joining.join_patches(ob, other, self._choice('first'), self._choice('second'), self.continuity,
                                         self.moves)
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        active_shape.note_pair(self, ob, found.changed.parents, parted)
        return reports.finished(self, reports.Report(f"{ob.name}: {told(found, named)}", warnings=came_apart(found, named)))

    def _choice(self, which):
        side = getattr(self, f"{which}_side")
        return patch_joints.Choice(getattr(self, which), None if side == 'NEAREST' else side)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "continuity", expand=True)
        layout.row().prop(self, "moves", expand=True)
        for name in ("first", "second"):
            column = layout.column(align=True)
            draw_number(column, self, name)
            column.prop(self, f"{name}_side")


def _named(number):
    return phrase("patch {number}", number=number)


def _named_of_two(ob, other):
    """(number of a patch of both, counted from 1) -> what it is called: by its object, while there are two."""
    owners = [(owner.name, number, count) for owner, count in ((one, active_shape.count_of(one.data)) for one in (ob, other))
              for number in range(1, count + 1)]

    def named(number):
        name, of_its_own, count = owners[number - 1]
        return name if count == 1 else phrase("patch {number} of {name}", number=of_its_own, name=name)
    return named


def told(found, named=_named):
    """A core.joints.patch_joints.Joined in words. named: (number) -> what a patch is called."""
    sides = " and ".join(phrase("{side} of {patch}",
                                side=SIDES[side], patch=named(number)) for number, side, _ in (found.first, found.second))
    moved = [phrase("{patch} moved by {error}",
                    patch=named(number), error=decimals.text_of(error, 2)) for number, _, error in (found.first, found.second)
             if error > 1e-12]
    measured = found.measured
    angle, bend = math.degrees(measured.angle), measured.curvature_difference
    return (phrase("{sides} are {measured}, angle {angle}°, curvatures differ by {bend}; {moved}",
                   sides=sides, measured=seams.in_words(measured), angle=_short(angle), bend=_short(bend), moved=', '.join(moved) or "nothing moved"))


def came_apart(found, named=_named):
    """What a core.joints.patch_joints.Joined has taken apart, as warnings."""
    pairs = ", ".join(phrase("{first} and {second}", first=named(first), second=named(second)) for first, second in found.came_apart)
    return (phrase("open now between {pairs}: they have other knots or degrees there", pairs=pairs),) if pairs else ()


def _short(number):
    """Rounding is nothing to tell."""
    return decimals.text_of(number, 2) if number > 1e-9 else "0"


CLASSES = (SPLINEWRIGHT_OT_join_patches,)
