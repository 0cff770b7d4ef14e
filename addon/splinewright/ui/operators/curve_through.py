"""A curve through what is selected: vertices of a mesh in Edit Mode, or the origins of objects, which it follows."""

import re

import bmesh
import bpy
import numpy as np
from bpy.props import BoolProperty

from ...bridge import follow, remaking
from ...core import vertex_order
from ...core.failures import FAILURES, Refusal
from ...core.recipes.table import RECIPES, THROUGH_OBJECTS
from .. import editing, recipe_props
from . import new_shapes, reports
from .adding import Repeatable, add_in_front, require_place, resolution_property

_SPLINE = RECIPES['interpolating']
_NAME = "Curve Through Points"
_FEW = "Select two objects or more"
_MORE = {'closed': {'options': {'SKIP_SAVE'}, 'description': "Go back to the first point; loops of edges always do"}}


class SPLINEWRIGHT_OT_curve_through_points(Repeatable, bpy.types.Operator):
    bl_idname = "splinewright.curve_through_points"
    bl_label = f"Add {_NAME}"
    bl_description = ("Add a spline through the selected vertices of a mesh in Edit Mode, along its edges or in the order in "
                      "which they were selected, or through the selected objects in the order of their names, which it follows")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    __annotations__ = {
        **{parameter.name: recipe_props.property_of(parameter, **_MORE.get(parameter.name, {}))
           for parameter in _SPLINE.parameters},
        'live': BoolProperty(name="Follow Objects", default=True,
                             description="Let the curve go on through the objects when they move"),
        'resolution_u': resolution_property(default=_SPLINE.resolution)}

    @classmethod
    def poll(cls, context):
        if context.mode == 'OBJECT' and cls.has_made(context):
            return True
        if context.mode not in ('OBJECT', 'EDIT_MESH') or editing.nets_in_edit_mode(context):
            cls.poll_message_set("Select objects in Object Mode, or vertices in the Edit Mode of a mesh that is no net")
            return False
        if context.mode == 'OBJECT' and len(context.selected_objects) < 2:
            cls.poll_message_set(_FEW)
            return False
        return True

    def execute(self, context):
        new_shapes.settle(self)
        try:
            require_place(context)
            new = self._through_objects(context) if context.mode == 'OBJECT' else self._through_vertices(context)
        except FAILURES as error:
            return reports.failed(self, error)
        for ob in new:
            add_in_front(context, ob, context.selected_objects if ob == new[0] else [])
        return self.finished(context, reports.Said(warnings=self._lowered(new)))

    def _lowered(self, new):
        degree = min(ob.data.splinewright.value.degree for ob in new)
        return (f"the degree is {degree}: there are no points for more",) if degree < self.degree else ()

    def _through_objects(self, context):
        if len(context.selected_objects) < 2:
            raise Refusal(_FEW)
        places = sorted(context.selected_objects, key=lambda ob: _in_numbers(ob.name))
        values, depsgraph = recipe_props.typed(_SPLINE, self), context.evaluated_depsgraph_get()
        if self.live:
            return [follow.new_object(THROUGH_OBJECTS, values, [], new_shapes.start(self), depsgraph, places)]
        points = [ob.matrix_world.translation for ob in places]
        return [self._new_object(_NAME, values, points)]

    def _through_vertices(self, context):
        """One curve for each chain of vertices. Leaves Edit Mode where nothing is refused."""
        found = [(ob, *chain) for ob in context.objects_in_mode_unique_data for chain in _chains(ob.data)]
        if not found:
            raise Refusal("no vertices are selected")
        new = []
        try:
            for source, points, closed in found:
                values = {**recipe_props.typed(_SPLINE, self), 'closed': self.closed or closed}
                new.append(self._new_object(f"{source.name} Curve", values, points))
                new[-1].matrix_world = source.matrix_world
        except FAILURES:
            bpy.data.batch_remove([ob.data for ob in new])
            raise
        bpy.ops.object.mode_set(mode='OBJECT')
        return new

    def _new_object(self, name, values, points):
        if len(points) < 2:
            raise Refusal("one point is no curve: select more")
        data = remaking.new_data(name, _SPLINE, values, np.array(points, dtype=np.float64), new_shapes.start(self))
        return bpy.data.objects.new(data.name, data)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for parameter in _SPLINE.parameters:
            layout.prop(self, parameter.name)
        layout.prop(self, "live")
        new_shapes.draw(self, layout)


def _chains(mesh):
    """[(points, whether they close)] of the selected vertices of a mesh in Edit Mode. Raises Refusal."""
    bm = bmesh.from_edit_mesh(mesh)
    bm.verts.index_update()
    places = {vertex.index: vertex.co.copy() for vertex in bm.verts if vertex.select}
    edges = [[vertex.index for vertex in edge.verts] for edge in bm.edges if edge.select]
    chosen = map(bm.select_history.__getitem__, range(len(bm.select_history)))      # Python 3.13 does not iterate over it
    history = [one.index for one in chosen if isinstance(one, bmesh.types.BMVert)]
    chains = vertex_order.in_order(places, edges, history) if places else []
    return [([places[vertex] for vertex in chain], closed) for chain, closed in chains]


def _in_numbers(name):
    """What sorts names as one reads them: P.2 comes before P.10."""
    return [(int(part), "") if part.isdigit() else (-1, part.casefold()) for part in re.split(r"(\d+)", name)]


CLASSES = (SPLINEWRIGHT_OT_curve_through_points,)
