"""Faces for the render, and materials for patches."""

import bpy
from bpy.props import FloatProperty, IntProperty

from ...bridge.data import problems, settings, tessellate
from ...bridge.edit import replace_pieces
from ...bridge.mesh import mesh_looks
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from .. import active_shape
from . import reports
from .pick_piece import draw_number
from .selected import OnSelected


class _OnPatches(OnSelected):
    needs = "Select a shape of patches"
    fits = staticmethod(replace_pieces.is_patch_shape)


class SPLINEWRIGHT_OT_tolerance_from_render(_OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.tolerance_from_render"
    bl_label = "Set Tolerance from Render"
    bl_description = "Set the tolerance so that the mesh is exact to a fraction of a pixel in the scene's camera"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    pixels: FloatProperty(name="Pixels", description="How far the mesh may lie from the surface in the picture",
                          default=0.25, min=0.001, soft_max=4.0)

    def work(self, context, ob):
        depsgraph = context.evaluated_depsgraph_get()
        tolerance = self.pixels * tessellate.of_render(ob, shape.points_of(ob.data), context.scene, depsgraph)
        shape.require_writable(ob.data)
        before, chosen = len(ob.data.polygons), settings.of(ob.data)
        least = chosen.bl_rna.properties['tolerance'].hard_min
        if tolerance < least:
            raise Refusal("it would take a tolerance of {tolerance}, less than the least, {least}",
                          tolerance=decimals.text_of(tolerance, 2), least=decimals.text_of(least, 1))
        was = chosen.mode, chosen.tolerance
        settings.set_tolerance(ob.data, tolerance)
        problem = problems.of(ob.data, problems.SETTING)
        if problem:
            settings.put_back(ob.data, *was)
            problems.set_problem(ob.data, problems.SETTING, "")
            raise Refusal(problem)
        return tolerance, before, len(ob.data.polygons)

    def said(self, outcomes):
        if len(outcomes) > 1:
            return reports.Report(phrase("{count} objects are shown as the render needs", count=len(outcomes)))
        (name, (tolerance, before, now)), = outcomes.items()
        return reports.Report(phrase("{name}: tolerance {tolerance}, faces: {before:,} → {count:,}",
                                     name=name, tolerance=decimals.text_of(tolerance, 2), before=before, count=now))


class SPLINEWRIGHT_OT_set_patch_material(_OnPatches, bpy.types.Operator):
    bl_idname = "splinewright.set_patch_material"
    bl_label = "Set Patch Material"
    bl_description = "Assign the material of a slot to one patch or to all, also when the faces change"
    done = "Set the material of {what}"

    piece: IntProperty(name="Patch", description="Which patch of the shape, counted from 1; 0 for all of them",
                       default=0, min=0, options={'SKIP_SAVE'})
    slot: IntProperty(name="Slot", description="Which material slot, counted from 1; 0 for the active one",
                      default=0, min=0, options={'SKIP_SAVE'})

    def invoke(self, context, event):
        active_shape.begin(self, self.chosen(context))
        return self.execute(context)

    def execute(self, context):
        active_shape.forget_asked()
        for ob in self.chosen(context):
            active_shape.note(self, 'piece', ob)
        return super().execute(context)

    def draw(self, context):
        self.layout.use_property_split = True
        draw_number(self.layout, self, 'piece')
        self.layout.prop(self, 'slot')

    def work(self, context, ob):
        slot = self.slot or ob.active_material_index + 1
        if slot > len(ob.material_slots):
            raise Refusal("it has {count} material slots, there is none of number {slot}",
                          "it has {count} material slot, there is none of number {slot}", count=len(ob.material_slots), slot=slot)
        shape.require_writable(ob.data)
        mesh_looks.set_material(ob.data, self.piece, slot - 1)


CLASSES = (SPLINEWRIGHT_OT_tolerance_from_render, SPLINEWRIGHT_OT_set_patch_material)
