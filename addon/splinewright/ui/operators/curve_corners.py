"""Corners of curves become round or are cut off: of one, and between two."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from ...bridge.data import store
from ...bridge.edit import joining, replace_pieces
from ...core.base import decimals
from ...core.base.failures import FAILURES
from ...core.base.words import phrase
from ...core.meets import meeting
from ...core.verbs import verbs
from .. import active_shape
from . import pieces, polls, reports
from .on_shapes import OnCurves
from .pick_piece import draw_number

_SIDES = (('AUTO', "Longer", "The longer part from where they meet"), ('start', "Start", "The part at its start"),
          ('end', "End", "The part at its end"))
#: How large a corner is where nothing is known; of the size of a curve how large it is at first.
_DEFAULT, _SHARE = 0.1, 0.05


def length_property(name, what, least=1e-6, **settings):
    """settings: more of a property's."""
    return FloatProperty(name=name, description=f"{what}, in units of the object", default=_DEFAULT, min=least, precision=4,
                         step=1, unit='LENGTH', **settings)


def joined_property(**settings):
    return BoolProperty(name="Join", description="Make one curve of both and the corner between them", default=True, **settings)


class _Corners(pieces.FromActive, OnCurves):
    """Replaces all corners of curves."""

    asked = ('size',)
    already = "it has no corners"

    def first_values(self, curve):
        return (first_length(curve),)

    def typed_size(self):
        return decimals.typed(self.size)


def first_length(curve):
    """A share of the size, in one digit."""
    low, high = curve.bounding_box()
    return float(f"{_SHARE * max(high - low):.1g}") or _DEFAULT


class SPLINEWRIGHT_OT_fillet_corners(_Corners, bpy.types.Operator):
    bl_idname = "splinewright.fillet_corners"
    bl_label = "Fillet Corners"
    bl_description = "Replace each corner of a curve by a tangent arc of a circle"
    done = "Filleted corners of {what}"

    size: length_property("Radius", "Of the arcs")

    def verb(self):
        return meeting.fillet_corners(self.typed_size())


class SPLINEWRIGHT_OT_chamfer_corners(_Corners, bpy.types.Operator):
    bl_idname = "splinewright.chamfer_corners"
    bl_label = "Chamfer Corners"
    bl_description = "Put a segment in place of each corner of a curve"
    done = "Chamfered corners of {what}"

    size: length_property("Length", "From each corner along the curve")

    def verb(self):
        return meeting.chamfer_corners(self.typed_size())


class _Between:
    """Two curves are shortened, or made longer, up to the piece put between them."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    joined: joined_property()
    first_kept: EnumProperty(name="Keep First", description="Which part of the first curve stays", items=_SIDES,
                             options={'SKIP_SAVE'})
    second_kept: EnumProperty(name="Keep Second", description="Which part of the second curve stays", items=_SIDES,
                              options={'SKIP_SAVE'})
    picked: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})           # the parts were clicked: these parameters are on them
    first_at: FloatProperty(options={'HIDDEN', 'SKIP_SAVE'})
    second_at: FloatProperty(options={'HIDDEN', 'SKIP_SAVE'})
    first: IntProperty(name="Piece", description="Which curve of the active shape, counted from 1", default=1, min=1,
                       options={'SKIP_SAVE'})
    second: IntProperty(name="Other Piece", description="Which other curve of it, or of the other shape, counted from 1; "
                        "0 for the next one", default=0, min=0, options={'SKIP_SAVE'})

    def change(self, definition, first, second, kept):
        """The verbs.Changed of both curves."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        return polls.one_or_two_selected(cls, context, replace_pieces.is_curve_shape, "Select one or two curve shapes")

    def invoke(self, context, event):
        active_shape.begin_pair(self, context)
        self.first = max(self.first, 1)
        return self.execute(context)

    def execute(self, context):
        """With the sizes of the last call, or where there was none, or they do not fit, with some that are likely to."""
        ob, others = context.object, [ob for ob in context.selected_objects if ob != context.object]
        parted = active_shape.count_of(ob.data) if others else None
        is_given = self.properties.is_property_set(self.sizes[0])
        if not is_given and all(decimals.typed(getattr(self, name)) == _DEFAULT for name in self.sizes):
            self._suggest(ob)
        try:
            outcome = joining.join_changed(ob, others, self._changed)
        except FAILURES as error:
            if is_given or not self._suggest(ob):
                return reports.failed(self, error, ob.name)
            return self.execute(context)
        active_shape.keep(ob.data, outcome[1].parents)
        active_shape.note_pair(self, ob, outcome[1].parents, parted)
        return reports.finished(self, reports.Report(phrase("{done}{told}", done=phrase(self.done, what=ob.name), told=pieces.told([outcome]))))

    def _suggest(self, ob):
        """Begin with a share of the size; whether that is known."""
        try:
            size = first_length(verbs.curves_of(store.read(ob.data))[0])
        except FAILURES:
            return False                # execute() says it
        for name in self.sizes:
            setattr(self, name, size)
        return True

    def _changed(self, definition, parted):
        first, second = self.first, self.second
        if parted:
            second = parted + max(second, 1)
        elif not second:
            second = 2 if first == 1 else 1
        for number in (first, second):
            verbs.require_piece(definition.pieces, number)
        sides = self.first_kept, self.second_kept
        best = (self.first_at, self.second_at) if self.picked else meeting.best_kept(definition, first, second)
        kept = [found if side == 'AUTO' else side for side, found in zip(sides, best)]
        return self.change(definition, first, second, kept)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in (*self.sizes, 'joined', 'first_kept', 'second_kept'):
            layout.prop(self, name)
        draw_number(layout, self, "first")
        draw_number(layout, self, "second")


class SPLINEWRIGHT_OT_fillet_curves(_Between, bpy.types.Operator):
    bl_idname = "splinewright.fillet_curves"
    bl_label = "Fillet Two Curves"
    bl_description = "Fillet two curves of one plane with an arc, and trim or extend them to it"
    done = "Filleted curves of {what}"
    sizes = ('radius',)

    radius: length_property("Radius", "Of the arc")

    def change(self, definition, first, second, kept):
        return meeting.filleted(definition, first, second, kept, decimals.typed(self.radius), self.joined)


class SPLINEWRIGHT_OT_chamfer_curves(_Between, bpy.types.Operator):
    bl_idname = "splinewright.chamfer_curves"
    bl_label = "Chamfer Two Curves"
    bl_description = "Chamfer two curves with a segment, by two lengths from where they or their tangents meet"
    done = "Chamfered curves of {what}"
    sizes = ('first_length', 'second_length')

    first_length: length_property("First Length", "Along the first curve", 0.0)
    second_length: length_property("Second Length", "Along the second curve", 0.0)

    def change(self, definition, first, second, kept):
        lengths = decimals.typed(self.first_length), decimals.typed(self.second_length)
        return meeting.chamfered(definition, first, second, kept, lengths, self.joined)


CLASSES = (SPLINEWRIGHT_OT_fillet_corners, SPLINEWRIGHT_OT_chamfer_corners, SPLINEWRIGHT_OT_fillet_curves,
           SPLINEWRIGHT_OT_chamfer_curves)
