"""Restore, Detach, Apply Transform, Join: what becomes of a shape as a whole."""

import bpy
from bpy.props import BoolProperty

from ...bridge import joining, recipes, shape, transforming
from ...core.failures import FAILURES, Refusal, sentence
from . import polls
from .selected import OnSelected


class _OnShapes(OnSelected):
    needs = "Select a Splinewright shape"
    fits = staticmethod(shape.has_shape)


class SPLINEWRIGHT_OT_restore(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.restore"
    bl_label = "Restore"
    bl_description = "Make the mesh or curve anew from the definition; changes made by hand are lost"
    done = "Restored {}"

    def work(self, context, ob):
        shape.restore(ob.data)


class SPLINEWRIGHT_OT_detach(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.detach"
    bl_label = "Detach"
    bl_description = "Keep what is shown as a plain mesh or curve and drop the definition"
    done = "Detached {}"

    def work(self, context, ob):
        shape.detach(ob.data)


class SPLINEWRIGHT_OT_make_editable(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.make_editable"
    bl_label = "Make Editable"
    bl_description = "Drop the recipe, or stop following another object; the definition stays and can be edited"
    done = "{} can be edited"

    def work(self, context, ob):
        if not recipes.has(ob.data):
            raise Refusal("it follows nothing, has no recipe and is editable already")
        shape.require_writable(ob.data)
        recipes.remove(ob.data)


class SPLINEWRIGHT_OT_apply_transform(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.apply_transform"
    bl_label = "Apply Transform"
    bl_description = "Move location, rotation and scale of the object into the definition; nothing moves on the screen"
    done = "Applied the transform of {}"

    location: BoolProperty(name="Location", default=True, description="Apply the location")
    rotation: BoolProperty(name="Rotation", default=True, description="Apply the rotation")
    scale: BoolProperty(name="Scale", default=True, description="Apply the scale")

    def work(self, context, ob):
        transforming.apply(ob, self.location, self.rotation, self.scale)


class SPLINEWRIGHT_OT_adopt_transform(_OnShapes, bpy.types.Operator):
    bl_idname = "splinewright.adopt_transform"
    bl_label = "Adopt Transform"
    bl_description = "The mesh or curve was moved as a whole, by Blender's Apply say: move the definition, too"
    done = "Adopted the transform of {}"

    def work(self, context, ob):
        transforming.adopt(ob.data)


class SPLINEWRIGHT_OT_join(bpy.types.Operator):
    bl_idname = "splinewright.join"
    bl_label = "Join Shapes"
    bl_description = "Make the selected shapes one shape of all their pieces, in the place of the active one"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        chosen = context.selected_objects
        if not polls.in_object_mode(cls, context):
            return False
        if not shape.has_shape(context.object) or not context.object.select_get():
            cls.poll_message_set("Select shapes, the one to keep last")
            return False
        if len(chosen) < 2 or not all(shape.has_shape(ob) and ob.type == context.object.type for ob in chosen):
            cls.poll_message_set("Select two or more shapes, all of curves or all of patches")
            return False
        return True

    def execute(self, context):
        others = [ob for ob in context.selected_objects if ob != context.object]
        try:
            joining.join(context.object, others)
        except FAILURES as error:
            self.report({'ERROR'}, sentence(error))
            return {'CANCELLED'}
        return {'FINISHED'}


CLASSES = (SPLINEWRIGHT_OT_restore, SPLINEWRIGHT_OT_detach, SPLINEWRIGHT_OT_make_editable,
           SPLINEWRIGHT_OT_apply_transform, SPLINEWRIGHT_OT_adopt_transform, SPLINEWRIGHT_OT_join)
