"""Make Deformable: exact circles and surfaces of revolution become ones to be sculpted."""

import bpy

from ...bridge.edit import replace_pieces
from ...bridge.net import keyed
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.deform import deforming
from .. import active_shape
from . import reports
from .pieces import UpToTolerance, scene_tolerance_property


class SPLINEWRIGHT_OT_make_deformable(UpToTolerance, bpy.types.Operator):
    bl_idname = "splinewright.make_deformable"
    bl_label = "Make Deformable"
    bl_description = ("Make exact circles and surfaces of revolution cubic and smooth around, without weights, for "
                      "sculpting, within the tolerance")
    bl_options = {'REGISTER', 'UNDO'}
    needs, done = "Select a shape", "Made {what} deformable"
    fits = staticmethod(shape.has_shape)

    tolerance: scene_tolerance_property("How far it may lie from the exact one")

    def work(self, context, ob):
        """Returns (how far it lies from the exact one, how many pieces still have weights)."""
        changes = _of_recipe(ob.data)
        if changes:
            if all(recipes.parameters(ob.data)[name] == value for name, value in changes.items()):
                raise Refusal("it is deformable already")
            keyed.set_parameters(ob.data, {**changes, 'tolerance': self.tolerance})
            return recipes.error(ob.data), 0
        before = replace_pieces.read(ob.data)
        found = deforming.deformed(before, self.tolerance)
        replace_pieces.put(ob.data, before, found.changed)
        active_shape.keep(ob.data, found.changed.parents)
        return found.changed.error, found.rational

    def said(self, outcomes):
        error = max(error for error, _ in outcomes.values())
        rational = sum(count for _, count in outcomes.values())
        more = [phrase("within {error} of the exact one", error=decimals.text_of(error, 2))]
        if rational:
            more.append(phrase("{count} pieces keep weights along the profile",
                               one="{count} piece keeps weights along the profile", count=rational))
        return reports.Report(f"{self.summary(outcomes)}: {', '.join(more)}")

def _of_recipe(data):
    """The parameters, by name, that make what a recipe makes deformable; none where it has none."""
    recipe = recipes.of(data) if recipes.has(data) else None
    for parameter in recipe.parameters if recipe else ():
        if parameter.name == 'deformable':
            return {'deformable': True}
        if parameter.name == 'form' and 'deformable' in (choice[0] for choice in parameter.choices):
            return {'form': 'deformable'}
    return {}


CLASSES = (SPLINEWRIGHT_OT_make_deformable,)
