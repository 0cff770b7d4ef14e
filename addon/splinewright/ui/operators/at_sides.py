"""By clicks on the sides of patches: two are joined, or one is extracted. What is at the mouse is shown."""

import bpy

from ...bridge import replacing
from ...bridge.file_state import state
from ...core.failures import FAILURES
from .. import hand, picking
from . import polls, reports
from .pointing import Pointing, redraw


class _PicksSides(Pointing):
    """So many sides are clicked, one after the other."""

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
        state.sides = ()

    def look(self, context, event):
        view = picking.view_at(event.mouse_x, event.mouse_y)
        found = None
        if view:
            region, view = view
            pixel = event.mouse_x - region.x, event.mouse_y - region.y
            try:
                found = picking.side_at(region, view, pixel, self.pieces(context, self._picked), context.evaluated_depsgraph_get())
            except FAILURES:
                pass                    # such a shape shows nothing to point at
        self._found = found
        state.sides = tuple((ob.name, number, side) for ob, number, side in [*self._picked, *([found] if found else [])])
        redraw()
        return found is not None

    def clicked(self, context):
        self._picked.append(self._found)
        if len(self._picked) < self.count:
            return {'RUNNING_MODAL'}
        picked = self._picked
        self.cancel(context)
        return self.done(context, picked)


def _patches(obs):
    return [(ob, number) for ob in obs if replacing.is_patch_shape(ob) and ob.visible_get() for number in hand.counted(ob.data)]


class SPLINEWRIGHT_OT_join_here(_PicksSides, bpy.types.Operator):
    bl_idname = "splinewright.join_here"
    bl_label = "Join Patches by Click"
    bl_description = "Click an edge of a patch, then the edge to join with it, of the same or the other shape"
    hint = "Click an edge of a patch, then the one to join with it   |   Esc, Right Mouse: Cancel"
    count = 2

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replacing.is_patch_shape, "patch")

    def pieces(self, context, picked):
        found = _patches({ob.name: ob for ob in (context.object, *context.selected_objects)}.values())
        if not picked:
            return found
        (first, number, _), is_alone = picked[0], len(context.selected_objects) < 2
        return [one for one in found if (one[0] == first) == is_alone and one != (first, number)]

    def done(self, context, picked):
        first, second = sorted(picked, key=lambda one: one[0] != context.object)
        return reports.called(
            self, bpy.ops.splinewright.join_patches, first=first[1], first_side=first[2], second=second[1], second_side=second[2])


class SPLINEWRIGHT_OT_extract_side_here(_PicksSides, bpy.types.Operator):
    bl_idname = "splinewright.extract_side_here"
    bl_label = "Extract Edge by Click"
    bl_description = "Click an edge of a patch to extract it as an exact curve, in a new shape"
    hint = "Click an edge of a patch   |   Esc, Right Mouse: Cancel"

    @classmethod
    def poll(cls, context):
        if context.mode != 'OBJECT' or not any(map(replacing.is_patch_shape, context.selected_objects)):
            cls.poll_message_set("Select a patch shape in Object Mode")
            return False
        return True

    def pieces(self, context, picked):
        return _patches(context.selected_objects)

    def done(self, context, picked):
        (ob, number, side), = picked
        return reports.called(self, bpy.ops.splinewright.extract_boundary, only=ob.name, piece=number, side=side.upper())


CLASSES = (SPLINEWRIGHT_OT_join_here, SPLINEWRIGHT_OT_extract_side_here)
