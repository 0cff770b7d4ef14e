"""Delete, Separate and Explode: pieces of shapes go, or become separate shapes, in Object Mode and while nets are edited."""

import bpy
from bpy.props import IntProperty

from ...bridge.cage import net_object
from ...bridge.edit import parting
from ...bridge.shape import shape
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from .. import active_shape, editing
from . import pieces, reports
from .selected import OnSelected


class _OnChosen(pieces.OnPieces):
    """Works on the piece that is given; in a net on all whose points are selected, or else on the one that has the selected ones."""

    bl_options = {'REGISTER', 'UNDO'}
    needs = "Select a shape"
    fits = staticmethod(shape.has_shape)

    piece: IntProperty(name="Piece", description="Which piece of the shape, counted from 1", default=1, min=1, options={'SKIP_SAVE'})

    def settings(self):
        return []

    def can_work(self, ob):
        return False

    def numbers(self, context, ob):
        """Of the pieces, counted from 0. Raises Refusal."""
        net = next((net for net in editing.nets_in_edit_mode(context) if net_object.shape_of(net) == ob), None)
        if net is not None:
            whole, touched = active_shape.whole_pieces(net), active_shape.pieces_of_points(net)
            if not whole and len(touched) != 1:
                raise Refusal("select a point that no other piece has, or all points of some pieces")
            return whole or touched
        count = active_shape.count_of(ob.data)
        if self.piece > count:
            raise Refusal("the shape has {count} pieces, there is none of number {number}",
                      "the shape has {count} piece, there is none of number {number}", count=count, number=self.piece)
        return [self.piece - 1]


class SPLINEWRIGHT_OT_delete_pieces(_OnChosen, bpy.types.Operator):
    bl_idname = "splinewright.delete_pieces"
    bl_label = "Delete Piece"
    bl_description = "Delete a curve or patch of the shape: the chosen one, or in a net that of the selected points"
    done = "Deleted pieces of {what}"

    def work(self, context, ob):
        outcome = parting.delete(ob.data, self.numbers(context, ob))
        self._note(ob, outcome[1])
        return outcome


def _separated(ob, groups):
    made = parting.separate(ob, groups)
    for new in made:
        new.select_set(not editing.nets())
    return made


def _counted(outcomes):
    count = sum(map(len, outcomes.values()))
    return phrase("{count} new objects", one="{count} new object", count=count)


class SPLINEWRIGHT_OT_separate_pieces(_OnChosen, bpy.types.Operator):
    bl_idname = "splinewright.separate_pieces"
    bl_label = "Separate Piece"
    bl_description = "Separate a curve or patch into a new shape: the chosen one, or in a net the selected one"
    done = "Separated {what}"

    def work(self, context, ob):
        return _separated(ob, [self.numbers(context, ob)])

    def said(self, outcomes):
        return reports.Report(f"{self.summary(outcomes)}: {_counted(outcomes)}")


class SPLINEWRIGHT_OT_explode(OnSelected, bpy.types.Operator):
    bl_idname = "splinewright.explode"
    bl_label = "Explode"
    bl_description = "Separate every curve or patch of a shape into a new shape; materials, attributes and modifiers are kept"
    needs = "Select a shape of several pieces"
    fits = staticmethod(lambda ob: shape.has_shape(ob) and active_shape.count_of(ob.data) > 1)
    done = "Exploded {what}"

    def work(self, context, ob):
        return _separated(ob, [[number] for number in range(active_shape.count_of(ob.data))])

    def said(self, outcomes):
        return reports.Report(f"{self.summary(outcomes)}: {_counted(outcomes)}")


CLASSES = (SPLINEWRIGHT_OT_delete_pieces, SPLINEWRIGHT_OT_separate_pieces, SPLINEWRIGHT_OT_explode)
