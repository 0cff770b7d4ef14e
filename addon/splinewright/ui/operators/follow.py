"""Make shapes follow objects."""

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ...bridge.follow import follow, recipe_results
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.recipes.table import FOLLOW
from . import polls, reports
from .adding import add_in_front, require_place, resolution_property
from .selected import OnFollowers


class SPLINEWRIGHT_OT_follow_object(bpy.types.Operator):
    bl_idname = "splinewright.follow_object"
    bl_label = "Add Live Copy"
    button = "Live Copy"
    bl_description = ("Add a live copy of the active curve, surface or shape, or make the active shape follow the other "
                      "object")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    source: StringProperty(name="Object", description="Name of the object to follow; empty: the selected one",
                           options={'SKIP_SAVE'})
    #: Whether a shape was added, to which the redo panel then may give another object to follow.
    is_added: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})
    resolution_u: resolution_property("U")
    resolution_v: resolution_property("V")

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not recipe_results.is_possible(context.object):
            cls.poll_message_set(say("Select a curve, a surface or a Splinewright shape"))
            return False
        return True

    def execute(self, context):
        depsgraph = context.evaluated_depsgraph_get()
        try:
            target, source = self._chosen(context)
            self.is_added = target is None
            if self.is_added:
                require_place(context)
                resolution = self.resolution_u, self.resolution_v
                target = follow.new_object(FOLLOW, {}, [source], resolution, depsgraph)
                for material in source.data.materials:
                    target.data.materials.append(material)
                add_in_front(context, target, [source, context.object])
            else:
                follow.attach(target, source, depsgraph)
        except FAILURES as error:
            return reports.failed(self, error)
        self.source = source.name       # the redo panel shows it
        return reports.finished(self, reports.Report(phrase("{name} follows {source_name}",
                                                            name=target.name, source_name=source.name)))

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop_search(self, "source", context.scene, "objects")
        column = layout.column(align=True)
        column.prop(self, "resolution_u")
        column.prop(self, "resolution_v", text="V")

    def _chosen(self, context):
        """(the shape that will follow or None for a new one, the object it follows)."""
        if self.source:
            source = context.scene.objects.get(self.source)
            if source is None:
                raise Refusal("there is no object named {source} in this scene", source=self.source)
            is_target = not self.is_added and shape.has_shape(context.object) and source != context.object
            return (context.object if is_target else None), source
        others = [ob for ob in context.selected_objects if ob != context.object and recipe_results.is_possible(ob)]
        if shape.has_shape(context.object) and len(others) == 1:
            return context.object, others[0]
        return None, context.object


class SPLINEWRIGHT_OT_set_moving(OnFollowers, bpy.types.Operator):
    bl_idname = "splinewright.set_moving"
    bl_label = "Set Motion"
    bl_description = "What happens when a shape that is made from other objects is moved, rotated or scaled"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    done = "Set how {what} moves"

    how: EnumProperty(name="Moves", items=[
        ('FREELY', "Freely", "It moves like any other object, and its inputs stay. It still follows them: what they change shows "
         "where it is now"),
        ('WITH_INPUTS', "Stays on Inputs", "It stays where its inputs lie, whatever happens to its own place. Its axes are those "
         "of its object")])

    def work(self, context, ob):
        follow.let_move_freely(ob.data, self.how == 'FREELY', context.evaluated_depsgraph_get())


CLASSES = (SPLINEWRIGHT_OT_follow_object, SPLINEWRIGHT_OT_set_moving)
