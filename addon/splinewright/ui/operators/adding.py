"""What all Add operators have in common."""

import bpy
from bpy.props import FloatProperty, FloatVectorProperty, IntProperty, StringProperty
from bpy_extras.object_utils import AddObjectHelper, object_data_add

from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import say
from ...core.shape import starters
from .. import progress
from . import new_shapes, reports


def can_add(cls, context):
    """poll() of operators that add shapes."""
    if context.mode != 'OBJECT':
        cls.poll_message_set(say("Leave Edit Mode first: a shape is a separate object"))
        return False
    try:
        require_place(context)
    except Refusal as error:
        cls.poll_message_set(say(sentence(error)))
        return False
    return True


def require_place(context):
    """Raises Refusal where no object can be added."""
    collection = context.collection
    if context.scene.library or (collection and (collection.library or collection.override_library)):
        raise Refusal("the active collection is linked from another file")


def add_in_front(context, ob, sources):
    """Put a new object into the scene, selected and active in place of those it was made from."""
    context.collection.objects.link(ob)
    for source in sources:
        source.select_set(False)
    ob.select_set(True)
    context.view_layer.objects.active = ob


class Repeatable:
    """Operators whose poll() would fail on what they made. Blender asks it before the panel of the last operator takes that
    back, and shows no panel where it fails."""

    made: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def has_made(cls, context):
        """Whether the active object is what the last operator made, and that was this one."""
        last, ob = context.active_operator, context.object
        return last is not None and last.bl_idname == cls.__name__ and ob is not None and last.properties.made == ob.name

    def finished(self, context, said):
        """reports.finished() when what was made is active."""
        self.made = context.object.name
        return reports.finished(self, said)


class AddShape(AddObjectHelper):
    """Adds the object of value(), at the 3D cursor or where align, location and rotation say."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    #: Default name of the object.
    shape_name = "Shape"

    size: FloatProperty(
        name="Radius", description="Distance from the middle to the sides",
        default=1.0, min=0.0001, soft_max=100.0, unit='LENGTH')
    # In place of those of Blender's helper, which presets would hold.
    location: FloatVectorProperty(name="Location", description="Where the new object is in the world", subtype='TRANSLATION', options={'SKIP_SAVE'})
    rotation: FloatVectorProperty(name="Rotation", description="How the new object is rotated in the world", subtype='EULER', options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def value(self):
        raise NotImplementedError("value: each operator says what it adds")

    def new_data(self, step):
        """The Mesh or Curve of the added object."""
        return shape.new_data(self.shape_name, starters.scaled(self.value(), self.size), new_shapes.start(self), step)

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        try:
            with progress.shown(context, shape.STEPS) as step:
                data = self.new_data(step)
        except FAILURES as error:
            return reports.failed(self, error)
        self._align(context)
        object_data_add(context, data, operator=self)
        return {'FINISHED'}

    def _align(self, context):
        """Settle the rotation. Blender's helper forgets an align that was given without one, and
        fails on a view that is not there."""
        space = context.space_data
        in_view = space is not None and space.type == 'VIEW_3D'
        given = self.properties
        if not given.is_property_set("rotation"):
            self.align = self.align if given.is_property_set("align") else context.preferences.edit.object_align
            if self.align == 'VIEW' and in_view:
                self.rotation = space.region_3d.view_matrix.to_3x3().inverted().to_euler()
            elif self.align == 'CURSOR':
                self.rotation = context.scene.cursor.matrix.to_euler()
            else:
                self.rotation = (0.0, 0.0, 0.0)
        if self.align == 'VIEW' and not in_view:
            self.align = 'WORLD'

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        self.draw_shape(layout)
        self.draw_size(layout)
        layout.separator()
        layout.prop(self, "align")
        layout.prop(self, "location")
        layout.prop(self, "rotation")

    def draw_size(self, layout):
        layout.prop(self, "size")


def resolution_property(axis="", default=12):
    along = f" along {axis.lower()}" if axis else ""
    return IntProperty(name=f"Resolution {axis}".strip(), description=f"Steps in every span{along}",
                       default=default, min=1, max=4096, soft_max=64)


def degree_property(axis="", default=3):
    along = f" along {axis.lower()}" if axis else ""
    return IntProperty(name=f"Degree {axis}".strip(), description=f"Degree of the polynomials{along}",
                       default=default, min=1, max=255, soft_max=11)


def count_property(axis="", default=4, minimum=2):
    along = f" along {axis.lower()}" if axis else ""
    return IntProperty(name=f"Points {axis}".strip(), description=f"Control points{along}",
                       default=default, min=minimum, max=100_000, soft_max=32)


def knots_property(axis=""):
    along = f" along {axis.lower()}" if axis else ""
    return bpy.props.EnumProperty(
        name=f"Knots {axis}".strip(), description=f"How the knots{along} meet the ends",
        items=(('CLAMPED', "Clamped", "Begins and ends in the outer control points"),
               ('UNCLAMPED', "Unclamped", "Uniform knots that touch no end point"),
               ('PERIODIC', "Periodic", "Closed and smooth everywhere")))


def enough_points(count, degree, knots):
    """At least as many points as the degree needs; a closed shape needs three."""
    return max(count, 3 if knots == 'PERIODIC' else degree + 1)
