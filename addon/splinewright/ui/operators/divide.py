"""Equal parts of a curve: points at their ends, or objects that stand there."""

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty
from mathutils import Matrix

from ...bridge.data import store
from ...bridge.edit import replace_pieces
from ...core.analysis import measured
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.verbs import dividing
from .. import progress
from . import reports
from .adding import Repeatable, can_add
from .long_work import LongWork

_MOST_OBJECTS = 10_000


class SPLINEWRIGHT_OT_divide_equally(LongWork, Repeatable, bpy.types.Operator):
    bl_idname = "splinewright.divide_equally"
    bl_label = "Divide Equally"
    bl_description = "Divide the active curve into parts of equal length, with points or copies of an object at their ends"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    by: EnumProperty(name="By", items=(
        ('COUNT', "Parts", "Into a given number of parts"), ('LENGTH', "Length", "Into parts of one length, from the start on")))
    count: IntProperty(name="Parts", description="How many equal parts each curve gets", default=10, min=1, soft_max=200,
                       max=1_000_000)
    length: FloatProperty(name="Length", description="Of a part, in the scene", default=1.0, min=1e-9, unit='LENGTH')
    with_ends: BoolProperty(name="With Ends", description="Also at the ends of an open curve", default=True)
    make: EnumProperty(name="Make", items=(
        ('POINTS', "Points", "A mesh of points"), ('EMPTIES', "Empties", "Arrows that show where things would stand"),
        ('COPIES', "Copies", "Copies of an object that share its data")))
    source: StringProperty(name="Object", description="Object to copy", options={'SKIP_SAVE'})
    turned: EnumProperty(name="Turned", items=(
        ('standing', "Standing", "Upright in the world, as posts stand, turned to where the curve goes"),
        ('upright', "Upright", "Along the curve, also where it climbs, upper side up"),
        ('minimal', "With the Curve", "With the curve, and about it no more than it must"),
        ('frenet', "To the Bend", "Upper side to where the curve bends: Frenet's frames"),
        ('not', "Not", "As the object is turned, or the world")))
    along: EnumProperty(name="Ahead", items=(
        ('X', "X", "The object's x axis follows the curve"), ('Y', "Y", "Its y axis"), ('Z', "Z", "Its z axis")))

    @classmethod
    def poll(cls, context):
        if not can_add(cls, context):
            return False
        if cls.has_made(context) or _is_curve(context.object):
            return True
        cls.poll_message_set(say("Make a curve shape active"))
        return False

    def invoke(self, context, event):
        """Another object that is selected beside the curve is copied."""
        others = [ob for ob in context.selected_objects if ob != context.object]
        if len(others) == 1 and not any(map(self.properties.is_property_set, ('source', 'make'))):
            self.source, self.make = others[0].name, 'COPIES'
        return self.called(context)

    def tasks(self, context):
        self._source()
        return {'places': self._task(context.object)}

    def execute(self, context):
        ob = context.object
        try:
            source = self._source()
            places, parts = self.result_of('places', self._task(ob))
            new = self._new_objects(context, ob, places, source)
        except FAILURES as error:
            return reports.failed(self, error, ob.name if ob else "")
        for other in context.selected_objects:
            other.select_set(False)
        if self.make == 'POINTS':
            context.collection.objects.link(new[0])
        for each in new:
            each.select_set(True)
        context.view_layer.objects.active = new[0]
        return self.finished(context, reports.Report(parts))

    def _task(self, ob):
        """A function that gives, for a `cancel` as the library takes it, ((n, 4, 4) of all curves of the shape, in the world;
        a sentence about the parts). Raises Refusal."""
        if not _is_curve(ob):
            raise Refusal("make a curve shape active")
        curves = measured.moved(store.read(ob.data), np.array(ob.matrix_world, dtype=np.float64)).pieces
        wanted = {'count': self.count} if self.by == 'COUNT' else {'length': decimals.typed(self.length)}
        wanted['with_ends'] = self.with_ends
        turned, along = 'not' if self.make == 'POINTS' else self.turned, self.along

        def places(cancel):
            found = np.concatenate([
                dividing.places(curve, dividing.parameters(curve, **wanted, cancel=cancel), turned, along, cancel)
                for curve in curves])
            if not len(found):
                raise Refusal("there is no place between the ends")
            return found, phrase("{count} places", one="{count} place", count=len(found)) + _said_of_parts(curves, wanted)
        return places

    def _require_few(self, count):
        """Raises Refusal where these are too many objects."""
        if self.make != 'POINTS' and count > _MOST_OBJECTS:
            raise Refusal("that makes too many objects: at most {most_objects} are allowed", most_objects=_MOST_OBJECTS)

    def _source(self):
        """The object that is copied, or None. Raises Refusal, also where more objects than are allowed are certain."""
        if self.by == 'COUNT':
            self._require_few(self.count - 1)
        if self.make != 'COPIES':
            return None
        source = bpy.data.objects.get(self.source)
        if source is None:
            raise Refusal("choose the object that is copied")
        return source

    def _new_objects(self, context, ob, places, source):
        name = f"{ob.name} Divided"
        if self.make == 'POINTS':
            return [_points(name, ob.matrix_world.translation, places[:, :3, 3])]
        self._require_few(len(places))
        collection, new = bpy.data.collections.new(name), []
        context.collection.children.link(collection)
        with progress.shown(context, len(places)) as told:
            for place in places:
                new.append(_standing(source, name, collection, place, self.turned))
                told(len(new))
        return new

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "by", expand=True)
        layout.prop(self, "count" if self.by == 'COUNT' else "length")
        layout.prop(self, "with_ends")
        layout.row().prop(self, "make", expand=True)
        if self.make == 'COPIES':
            layout.prop_search(self, "source", context.scene, "objects")
        if self.make != 'POINTS':
            layout.prop(self, "turned")
            if self.turned != 'not':
                layout.row().prop(self, "along", expand=True)


def _is_curve(ob):
    return ob is not None and replace_pieces.is_curve_shape(ob)


def _said_of_parts(curves, wanted):
    if 'count' not in wanted or len(curves) > 1:
        return ""
    return phrase(", parts of {length}", length=decimals.text_of(curves[0].length(tolerance=1e-06) / wanted['count'], 4))


def _points(name, origin, points):
    """A mesh of points in the world, with its origin there."""
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set('co', (points - np.array(origin)).astype(np.float32).ravel())
    mesh.update()
    ob = bpy.data.objects.new(name, mesh)
    ob.location = origin
    return ob


def _standing(source, name, collection, place, turned):
    """A copy of an object, or an empty, in its place."""
    if source is None:
        ob = bpy.data.objects.new(name, None)
        ob.empty_display_type = 'ARROWS'
        ob.empty_display_size = 0.25
        own = Matrix()
    else:
        ob = source.copy()
        ob.parent = None
        ob.animation_data_clear()
        _, rotation, scale = source.matrix_world.decompose()
        own = Matrix.LocRotScale(None, rotation if turned == 'not' else None, scale)
    collection.objects.link(ob)
    ob.matrix_world = Matrix(place.tolist()) @ own
    return ob


CLASSES = (SPLINEWRIGHT_OT_divide_equally,)
