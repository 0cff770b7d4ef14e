"""Control points that keys and drivers move, as Blender's properties."""

import bpy
from bpy.props import CollectionProperty, FloatProperty, FloatVectorProperty, IntProperty

from ..bridge.data import problems, store
from ..bridge.keys import point_keys
from ..bridge.net import point_keying
from ..core.base.failures import FAILURES, sentence

#: Types of data-blocks that can hold a shape.
_OWNERS = (bpy.types.Mesh, bpy.types.Curve)


def _changed(self, context):
    """Called by Blender when a user, or a script, has changed a number; never for keys and drivers. Where nothing results from
    it the number is shown again as it was."""
    data = self.id_data
    if not store.has_definition(data):
        return
    try:
        point_keying.put(data, self.row, self.place, self.weight)
        problems.set_problem(data, problems.SETTING, "")
    except FAILURES as error:
        problems.set_problem(data, problems.SETTING, sentence(error))
        try:
            point_keys.show(data, store.pool(data))
        except store.UnreadableDefinition:
            return                      # the panel says it


class SplinewrightKeyedPoint(bpy.types.PropertyGroup):
    """A control point that has keys or drivers, or had some. Where it is in float64 the definition says."""

    row: IntProperty(name="Point", description="Its number among the points of the shape; -1 for one that is gone",
                     default=point_keys.GONE, options={'HIDDEN'})
    stage: IntProperty(options={'HIDDEN'})
    place: FloatVectorProperty(name="Location", description="Location of the control point, or vector of a tangent or direction "
                                                         "at infinity, for keys and drivers", subtype='XYZ', unit='LENGTH',
                               precision=5, update=_changed)
    weight: FloatProperty(name="Weight", description="Weight of the control point, not 0, for keys and drivers", default=1.0, precision=5, step=10, update=_changed)


CLASSES = (SplinewrightKeyedPoint,)


def register():
    for owner in _OWNERS:
        owner.splinewright_keyed = CollectionProperty(type=SplinewrightKeyedPoint)


def unregister():
    for owner in _OWNERS:
        del owner.splinewright_keyed
