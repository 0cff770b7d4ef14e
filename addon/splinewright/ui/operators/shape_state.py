"""Discard Manual Changes, Convert to Plain Mesh/Curve, Apply Transform to NURBS: changes of a shape as a whole."""

import bpy
from bpy.props import BoolProperty

from ...bridge.edit import transforming
from ...bridge.keys import point_keys
from ...bridge.recipes import recipes
from ...bridge.shape import recipe_edit, shape
from ...core.base.failures import Refusal
from . import reports
from .selected import OnSelected


class _OnShapes(OnSelected):
    needs = "Select a Splinewright shape"
    fits = staticmethod(shape.has_shape)


class SPLINEWRIGHT_OT_restore(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.restore"
    bl_label = "Discard Manual Changes"
    bl_description = "Make the mesh or curve again from the definition; changes made by hand are lost"
    done = "Discarded manual changes of {what}"

    def work(self, context, ob):
        shape.restore(ob.data)


class SPLINEWRIGHT_OT_detach(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.detach"
    bl_label = "Convert to Plain Mesh/Curve"
    bl_description = "Keep a plain mesh or curve, and drop the definition"
    done = "Converted {what}: no longer NURBS"

    def work(self, context, ob):
        point_keys.tell_lost(ob.data, point_keys.count(ob.data))
        shape.detach(ob.data)


class SPLINEWRIGHT_OT_make_editable(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.make_editable"
    bl_label = "Apply Construction"
    bl_description = "Drop the recipe, or stop following another object; the definition stays and can be edited"
    done = "{what} can be edited"

    def work(self, context, ob):
        if not recipes.has(ob.data):
            raise Refusal("it follows nothing, has no recipe and is editable already")
        return recipe_edit.end(ob.data)

    def said(self, outcomes):
        return reports.Report(self.summary(outcomes), warnings=tuple(filter(None, outcomes.values())))


class SPLINEWRIGHT_OT_apply_transform(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.apply_transform"
    bl_label = "Apply Transform to NURBS"
    bl_description = "Move location, rotation and scale of the object into the definition; nothing moves on the screen"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    done = "Applied the transform of {what}"

    location: BoolProperty(name="Location", default=True, description="Apply the location")
    rotation: BoolProperty(name="Rotation", default=True, description="Apply the rotation")
    scale: BoolProperty(name="Scale", default=True, description="Apply the scale")

    def work(self, context, ob):
        transforming.apply(ob, self.location, self.rotation, self.scale)


class SPLINEWRIGHT_OT_adopt_transform(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.adopt_transform"
    bl_label = "Accept Applied Transform"
    bl_description = "Move the definition, too, after Blender's Apply moved the mesh or curve as a whole"
    done = "Adopted the transform of {what}"

    def work(self, context, ob):
        return transforming.adopt(ob.data, context.evaluated_depsgraph_get())

    def said(self, outcomes):
        return reports.Report(self.summary(outcomes), warnings=tuple(filter(None, outcomes.values())))


CLASSES = (SPLINEWRIGHT_OT_restore, SPLINEWRIGHT_OT_detach, SPLINEWRIGHT_OT_make_editable,
           SPLINEWRIGHT_OT_apply_transform, SPLINEWRIGHT_OT_adopt_transform)
