"""By clicks on the sides of patches: two are joined, or one is extracted. The item at the mouse is shown."""

import bpy

from ...bridge.edit import replace_pieces
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from .. import active_shape, picking
from ..ui_state import ui_state
from . import patch_join, polls, reports
from .gesture import redraw
from .pointing import Pointing, given, take_again


class _PicksSides(Pointing):
    """A given number of sides are clicked, one after the other."""

    bl_options = {'REGISTER'}
    count = 1

    def pieces(self, context, picked):
        """(object, number) of the patches of which one is asked for, after (object, number, side) were picked."""
        raise NotImplementedError

    def done(self, context, picked):
        """Do it with the (object, number, side) that were picked. Returns what modal() does."""
        raise NotImplementedError

    def invoke(self, context, event):
        self._picked = []
        return self.begin(context, event)

    def meant(self, context):
        return list({ob.name: ob for ob, _ in self.pieces(context, self._picked)}.values())

    def forget(self):
        ui_state.sides = ()

    def look(self, context, event):
        self._found = found = side_at(context, event.mouse_x, event.mouse_y, self.pieces(context, self._picked))
        ui_state.sides = tuple((ob.name, number, side) for ob, number, side in [*self._picked, *([found] if found else [])])
        redraw()
        return found is not None

    def clicked(self, context):
        self._picked.append(self._found)
        if len(self._picked) < self.count:
            return {'RUNNING_MODAL'}
        picked = self._picked
        self.cancel(context)
        return self.done(context, picked)


def side_at(context, x, y, pieces):
    """(object, number, side) of the side of one of these (object, number) at a pixel of the window, or None."""
    view = picking.view_at(x, y)
    if view is None:
        return None
    try:
        return picking.side_at(*view, (x - view[0].x, y - view[0].y), pieces, context.evaluated_depsgraph_get())
    except FAILURES:
        return None                     # such a shape shows nothing to point at


def patches_of(obs):
    return [(ob, number) for ob in obs if replace_pieces.is_patch_shape(ob) and ob.visible_get() for number in active_shape.counted(ob.data)]


class SPLINEWRIGHT_OT_join_here(_PicksSides, bpy.types.Operator):
    bl_idname = "splinewright.join_here"
    bl_label = "Join Patches"
    bl_description = "Click an edge of a patch, then the edge to join with it, of the same or the other shape"
    count = 2

    continuity: patch_join.continuity_property(options={'SKIP_SAVE'})
    moves: patch_join.moves_property(options={'SKIP_SAVE'})

    @property
    def hint(self):
        which = "the edge to join it to" if self._picked else "the first of two edges"
        return phrase("Click {which}   |   Esc, Right Mouse: Cancel", which=which)

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replace_pieces.is_patch_shape, "Select one or two patch shapes")

    def pieces(self, context, picked):
        found = patches_of({ob.name: ob for ob in (context.object, *context.selected_objects)}.values())
        if not picked:
            return found
        (first, number, _), is_alone = picked[0], len(context.selected_objects) < 2
        return [one for one in found if (one[0] == first) == is_alone and one != (first, number)]

    def done(self, context, picked):
        first, second = sorted(picked, key=lambda one: one[0] != context.object)
        return reports.called(
            self, bpy.ops.splinewright.join_patches, first=first[1], first_side=first[2], second=second[1], second_side=second[2],
            **given(self, 'continuity', 'moves'))


class SPLINEWRIGHT_OT_extract_side_here(_PicksSides, bpy.types.Operator):
    bl_idname = "splinewright.extract_side_here"
    bl_label = "Extract Edge"
    bl_description = "Click an edge of a patch to extract it as an exact curve, in a new shape"
    hint = "Click an edge of a patch   |   Esc, Right Mouse: Cancel"

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT' or not any(map(replace_pieces.is_patch_shape, context.selected_objects)):
            cls.poll_message_set(say("Select a patch shape in Object Mode"))
            return False
        return True

    def pieces(self, context, picked):
        return patches_of(context.selected_objects)

    def done(self, context, picked):
        (ob, number, side), = picked
        ended = reports.called(self, bpy.ops.splinewright.extract_boundary, only=ob.name, piece=number, side=side.upper())
        if self.at_once:
            take_again(context, ob)
        return ended


CLASSES = (SPLINEWRIGHT_OT_join_here, SPLINEWRIGHT_OT_extract_side_here)
