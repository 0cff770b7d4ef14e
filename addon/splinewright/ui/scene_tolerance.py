"""The tolerance of a scene in its properties and in the sidebar, and how operators take it."""

import bpy
from bpy.props import EnumProperty, FloatProperty, PointerProperty

from ..bridge.data import tessellate
from ..bridge.follow import scene_tolerance
from ..bridge.follow.scene_tolerance import AUTOMATIC, OWN
from . import texts


class SplinewrightTolerance(bpy.types.PropertyGroup):
    by: EnumProperty(
        name="Tolerance", description="Default tolerance of new curves and surfaces",
        items=((AUTOMATIC, "Automatic", "A power of ten that suits the size of the largest curve or surface"),
               (OWN, "Custom", "A length that is typed")), default=AUTOMATIC, options=set())
    own: FloatProperty(
        name="Tolerance", description="Default tolerance of new curves and surfaces",
        default=1e-4, min=1e-9, soft_max=1.0, precision=6, step=0.01, unit='LENGTH', options=set())


def options(parameter):
    """What Blender's property of an operator takes for a parameter: what was typed once does not stay for the next time."""
    return {'options': {'SKIP_SAVE'}} if parameter.of_scene else {}


def fill_from_scene(operator, context, recipe):
    """Give an operator the scene's tolerance where it was not given one."""
    for parameter in recipe.parameters:
        if parameter.of_scene and not operator.properties.is_property_set(parameter.name):
            setattr(operator, parameter.name, scene_tolerance.of(context.scene))


def settle_in_object(operator, context, ob):
    """settle() for a tolerance in units of an object."""
    scale = tessellate.largest_scale(ob.matrix_world) if ob else 1.0
    if not operator.properties.is_property_set('tolerance') and scale > 0.0:
        operator.tolerance = scene_tolerance.of(context.scene) / scale


class _TolerancePanel:
    bl_label = "NURBS Tolerance"
    bl_options = {'DEFAULT_CLOSED'}

    @classmethod
    def poll(cls, context):
        return context.scene is not None

    def draw(self, context):
        layout, scene = self.layout, context.scene
        chosen = scene_tolerance.settings(scene)
        layout.column().prop(chosen, "by", expand=True)
        if chosen.by == OWN:
            layout.prop(chosen, "own")
        else:
            texts.draw_note(layout, _text_of(scene, scene_tolerance.automatic(scene)))


def _text_of(scene, length):
    units = scene.unit_settings
    if units.system == 'NONE':
        return f"{length:g}"
    return bpy.utils.units.to_string(units.system, 'LENGTH', length * units.scale_length, precision=6, compatible_unit=False)


class SPLINEWRIGHT_PT_tolerance(_TolerancePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_tolerance"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "NURBS"
    bl_order = 10


class SPLINEWRIGHT_PT_scene_tolerance(_TolerancePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_scene_tolerance"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "scene"
    bl_parent_id = "SCENE_PT_unit"


CLASSES = (SplinewrightTolerance, SPLINEWRIGHT_PT_tolerance, SPLINEWRIGHT_PT_scene_tolerance)


def register():
    bpy.types.Scene.splinewright_tolerance = PointerProperty(type=SplinewrightTolerance)


def unregister():
    del bpy.types.Scene.splinewright_tolerance
