"""What operators have in common that make curves of points: vertices of a mesh in Edit Mode, and their own points."""

import bmesh
import bpy
import numpy as np
from mathutils import Matrix

from ...bridge.edit import grease_pencil
from ...bridge.recipes import recipes
from ...bridge.shape import recipe_edit, shape
from ...core.base import vertex_order
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import say
from ...core.shape import polylines
from .. import editing, progress, recipe_props
from . import new_shapes, reports
from .adding import Repeatable, add_in_front, require_place
from .long_work import LongWork


class CurvesFromPoints(LongWork, Repeatable):
    """Adds what curves() makes. `recipe` makes a curve of points, `shape_name` names it."""

    recipe, shape_name = None, ""
    #: Whether distances are those of the scene: scales go into the points then.
    is_measured = False
    needs = "Select objects in Object Mode, or vertices in the Edit Mode of a mesh that is no net"

    @classmethod
    def poll(cls, context):
        if context.mode == 'OBJECT' and cls.has_made(context):
            return True
        if context.mode not in ('OBJECT', 'EDIT_MESH') or editing.nets_in_edit_mode(context):
            cls.poll_message_set(say(cls.needs))
            return False
        return context.mode == 'EDIT_MESH' or cls.can_take_objects(context)

    @classmethod
    def can_take_objects(cls, context):
        """poll() in Object Mode."""
        return True

    def called(self, context):
        return super().called(context) if self.recipe.takes_cancel else self.execute(context)

    def tasks(self, context):
        found = self.lines_of_objects(context) if context.mode == 'OBJECT' else _lines_of_vertices(context)
        return {i: self.recipe.work(self._placed(source, points)[1], self._values(closed))
                for i, (source, points, closed) in enumerate(found)}

    def _placed(self, source, points):
        """(the matrix of objects made of points in the space of an object or the scene, the points in its space)."""
        points = np.array(points, dtype=np.float64)
        if not source:
            return Matrix(), points
        if not self.is_measured:
            return source.matrix_world, points
        matrix, linear = new_shapes.without_scale(source.matrix_world)
        return matrix, points @ linear.T

    def _values(self, closed):
        return {**recipe_props.typed(self.recipe, self), 'closed': self.closed or closed}

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        try:
            require_place(context)
            new = self.of_objects(context) if context.mode == 'OBJECT' else self._of_vertices(context)
        except FAILURES as error:
            return reports.failed(self, error)
        for ob in new:
            add_in_front(context, ob, context.selected_objects if ob == new[0] else [])
        return self.finished(context, reports.Report(self.said(new), warnings=self.warnings(new)))

    def lines_of_objects(self, context):
        """[(object or None, points in its space, whether they close)] in Object Mode. Raises Refusal."""
        raise NotImplementedError("lines_of_objects: each operator says what it takes of objects")

    def of_objects(self, context):
        """New objects, in Object Mode. Raises Refusal."""
        return self.new_objects(self.lines_of_objects(context))

    def said(self, new):
        """The report on the new objects. Distances are the scene's where `is_measured`."""
        return new_shapes.said_of(new, max(recipes.error(ob.data) for ob in new)) if self.is_measured else ""

    def warnings(self, new):
        return ()

    def _of_vertices(self, context):
        """One curve for each chain of vertices. Leaves Edit Mode where nothing is refused."""
        new = self.new_objects(_lines_of_vertices(context))
        bpy.ops.object.mode_set(mode='OBJECT')
        return new

    def new_objects(self, found):
        """One for each (source, points in its space, whether they close), in its place; none where one is refused."""
        new = []
        try:
            with progress.shown(bpy.context, shape.STEPS * len(found)) as told:
                for i, (source, points, closed) in enumerate(found):
                    matrix, points = self._placed(source, points)
                    name = f"{source.name} Curve" if source else self.shape_name
                    new.append(self.new_object(name, self._values(closed), points, i,
                                               lambda step: told(shape.STEPS * len(new) + step)))
                    new[-1].matrix_world = matrix
        except FAILURES:
            bpy.data.batch_remove([ob.data for ob in new])
            raise
        return new

    def new_object(self, name, values, points, number=0, told=shape.no_progress):
        """number: of the task that makes it; told: as `progress` of shape.new_data()."""
        if len(points) < 2:
            raise Refusal("a curve needs two points: select more")
        points = np.array(points, dtype=np.float64)
        result = self.result_of(number, self.recipe.work(points, values))
        data = recipe_edit.new_data(name, self.recipe, values, points, new_shapes.start(self), result, told)
        return bpy.data.objects.new(data.name, data)


def are_strokes_there(context):
    """Whether lines_of_strokes() has something to look at."""
    return any(map(grease_pencil.is_drawn, context.selected_objects)) or grease_pencil.has_annotations(context)


def lines_of_strokes(context, needs):
    """[(object or None, points in its space, whether they close)] of the selected Grease Pencil objects, or of the annotations
    where none is selected. Raises Refusal; `needs` says what there must be."""
    drawn = [ob for ob in context.selected_objects if grease_pencil.is_drawn(ob)]
    frame = context.scene.frame_current
    found = ([(ob, *stroke) for ob in drawn for stroke in grease_pencil.of_object(ob, frame)] if drawn else
             [(None, *stroke) for stroke in grease_pencil.of_annotations(context)])
    lines = [(source, polylines.without_repeats(points), closed) for source, points, closed in found]
    lines = [line for line in lines if len(line[1]) > 1]
    if not lines:
        raise Refusal("there are no strokes" if drawn else needs)
    return lines


def _lines_of_vertices(context):
    """[(object, points in its space, whether they close)] of the selected vertices. Raises Refusal."""
    found = [(ob, *chain) for ob in context.objects_in_mode_unique_data for chain in _chains(ob.data)]
    if not found:
        raise Refusal("no vertices are selected")
    return found


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
