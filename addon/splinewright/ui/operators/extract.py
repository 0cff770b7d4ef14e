"""Curves on patch shapes become separate shapes."""

import bpy
from bpy.props import EnumProperty

from ...bridge.edit import extracting
from ...core.base.words import phrase
from ...core.verbs import patch_curves
from . import reports
from .adding import Repeatable, can_add
from .on_shapes import AtParameters, OnPatches, direction_property


class _Extract(Repeatable, OnPatches):
    """Adds a curve shape for every selected patch shape, in its place."""

    works_on_nets = False

    @classmethod
    def poll(cls, context):
        return can_add(cls, context) and (cls.has_made(context) or super().poll(context))

    def chosen(self, context):
        """Also of objects that share data: their curves lie in different places."""
        return [ob for ob in self._in_order(context) if self.fits(ob) and self.only in ("", ob.name)]

    def execute(self, context):
        sources = context.selected_objects
        if not any(map(self.fits, sources)):
            return reports.cancelled(self, self.needs)
        self.added = []
        result = super().execute(context)
        if self.added:
            for ob in sources:
                ob.select_set(False)
            for ob in self.added:
                ob.select_set(True)
            context.view_layer.objects.active = self.added[-1]
            self.made = self.added[-1].name
        return result

    def add(self, context, source, name, curves, axes):
        ob = extracting.new_object(source, name, curves, axes)
        context.collection.objects.link(ob)
        self.added.append(ob)

    def said(self, outcomes):
        left_out = [text for texts in outcomes.values() for text in texts]
        return reports.Report(self.summary(outcomes), (phrase("left out: {left_out}",
                                                              left_out=', '.join(left_out)),) if left_out else ())


class SPLINEWRIGHT_OT_extract_isocurve(AtParameters, _Extract, bpy.types.Operator):
    bl_idname = "splinewright.extract_isocurve"
    bl_label = "Extract Isocurve"
    bl_description = "Add the exact curve on a patch along which u or v is constant, as a new shape"
    done = "Extracted an isocurve of {what}"

    direction: direction_property("The curve at one u", "The curve at one v", "Both curves through one point")

    def settings(self):
        return ['direction', *self.parameters()]

    def work(self, context, ob):
        axes = [name[-1] for name in self.parameters()]
        curves, left_out = extracting.isocurves(ob.data, self.piece, [(axis, self.parameter(axis)) for axis in axes])
        self.add(context, ob, "Isocurve", curves, axes)
        return left_out


class SPLINEWRIGHT_OT_extract_boundary(_Extract, bpy.types.Operator):
    bl_idname = "splinewright.extract_boundary"
    bl_label = "Extract Boundary"
    bl_description = "Add the sides of a patch as exact curves in a new shape, except sides that are points"
    done = "Extracted the boundary of {what}"

    side: EnumProperty(name="Side", items=(
        ('ALL', "All Four", "Every side, a piece each"), ('U_START', "U Start", "Where u starts"),
        ('U_END', "U End", "Where u ends"), ('V_START', "V Start", "Where v starts"),
        ('V_END', "V End", "Where v ends")))

    def settings(self):
        return ['side']

    def work(self, context, ob):
        sides = list(patch_curves.SIDES) if self.side == 'ALL' else [self.side.lower()]
        curves, left_out = extracting.boundaries(ob.data, self.piece, sides)
        self.add(context, ob, "Boundary", curves, [side[0] for side in sides])
        return left_out


CLASSES = (SPLINEWRIGHT_OT_extract_isocurve, SPLINEWRIGHT_OT_extract_boundary)
