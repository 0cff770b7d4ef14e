"""Points of meshes are brought onto the active shape, each to the nearest place."""

import bpy
import numpy as np
from bpy.props import BoolProperty

from ...bridge.data import store
from ...bridge.shape import shape
from ...core.analysis import measured
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from ...core.meets import projecting
from .. import progress
from . import reports
from .adding import Repeatable, can_add
from .long_work import LongWork


class SPLINEWRIGHT_OT_project_points(LongWork, Repeatable, bpy.types.Operator):
    bl_idname = "splinewright.project_points"
    bl_label = "Project Points"
    bl_description = ("Project the vertices of the other selected meshes onto the active shape, as new meshes, and report "
                      "the distances")
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    in_place: BoolProperty(name="In Place", description="Move the vertices themselves, without new meshes")
    selected_only: BoolProperty(name="Selected Only", description="Only vertices that are selected in Edit Mode; others stay")

    @classmethod
    def poll(cls, context):
        if not can_add(cls, context):
            return False
        if cls.has_made(context) or (shape.has_shape(context.object) and _meshes(context)):
            return True
        cls.poll_message_set(say("Select meshes, and then the shape onto which their points go"))
        return False

    def tasks(self, context):
        return {'feet': _task(context.object, self._chosen(context))}

    def execute(self, context):
        onto = context.object
        try:
            new, distances = self._projected(context, onto, self._chosen(context))
        except FAILURES as error:
            return reports.failed(self, error, onto.name if onto else "")
        if new:
            for ob in context.selected_objects:
                ob.select_set(False)
            for ob in new:
                context.collection.objects.link(ob)
                ob.select_set(True)
            context.view_layer.objects.active = new[0]
        words = [decimals.text_of(number, 4) for number in (distances.max(), distances.mean())]
        return self.finished(context, reports.Report(
            phrase("{count} points, largest distance {largest}, mean {mean}", one="{count} point, distance {largest}",
                   count=len(distances), largest=words[0], mean=words[1])))

    def _chosen(self, context):
        """The _Points that are meant. Raises Refusal."""
        sources = _meshes(context)
        if not shape.has_shape(context.object) or not sources:
            raise Refusal("select meshes, and then the shape onto which their points go")
        chosen = [_Points(ob, self.selected_only) for ob in sources]
        if not any(len(points.world) for points in chosen):
            raise Refusal("no vertices are selected" if self.selected_only else "the meshes have no vertices")
        if self.in_place:
            for points in chosen:
                points.require_free()
        return chosen

    def _projected(self, context, onto, chosen):
        """(new objects, none where vertices move themselves; all distances in the scene). Nothing moves where one is refused."""
        with progress.shown(context, sum(len(points.world) for points in chosen)) as told:
            feet, distances = self.result_of('feet', _task(onto, chosen, told))
        for points, of_one in zip(chosen, feet):
            points.move(of_one)
        new = [points.put(self.in_place) for points in chosen]
        return [ob for ob in new if ob is not None], np.concatenate(distances)

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(self, "in_place")
        self.layout.prop(self, "selected_only")


def _meshes(context):
    return [ob for ob in context.selected_objects
            if ob.type == 'MESH' and ob != context.object and not shape.has_shape(ob)]


def _task(onto, chosen, told=lambda done: None):
    """A function that gives the nearest points, and their distances, on a shape of each of the _Points, for a `cancel` as the
    library takes it."""
    pieces = measured.moved(store.read(onto.data), np.array(onto.matrix_world, dtype=np.float64)).pieces
    worlds = [points.world for points in chosen]
    firsts = np.cumsum([0, *map(len, worlds)]).tolist()

    def feet(cancel):
        found = [projecting.feet(pieces, world, lambda count: told(first + count), cancel)
                 for first, world in zip(firsts, worlds)]
        return tuple(zip(*found))
    return feet


class _Points:
    """Vertices of a mesh object, in the world."""

    def __init__(self, ob, selected_only):
        self.ob, mesh = ob, ob.data
        self._local = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get('co', self._local)
        self._local = self._local.reshape(-1, 3).astype(np.float64)
        self._moves = np.ones(len(self._local), bool)
        if selected_only:
            mesh.vertices.foreach_get('select', self._moves)
        self._matrix = np.array(ob.matrix_world, dtype=np.float64)
        if np.linalg.det(self._matrix[:3, :3]) == 0.0:
            raise Refusal("{name} has a scale of 0", name=ob.name)
        self.world = self._local[self._moves] @ self._matrix[:3, :3].T + self._matrix[:3, 3]

    def require_free(self):
        """Raises Refusal where the vertices cannot move themselves."""
        mesh = self.ob.data
        if mesh.library or mesh.override_library:
            raise Refusal("{name} is linked from another file", name=self.ob.name)
        if mesh.shape_keys:
            raise Refusal("{name} has shape keys", name=self.ob.name)

    def move(self, world):
        self._local[self._moves] = np.linalg.solve(self._matrix[:3, :3], (world - self._matrix[:3, 3]).T).T

    def put(self, in_place):
        """Writes the vertices. Returns a new object, or None."""
        mesh = self.ob.data if in_place else self.ob.data.copy()
        ob = None if in_place else bpy.data.objects.new(f"{self.ob.name} Projected", mesh)
        if ob:
            mesh.name, ob.matrix_world = ob.name, self.ob.matrix_world
            if mesh.shape_keys:
                ob.shape_key_clear()
        mesh.vertices.foreach_set('co', self._local.astype(np.float32).ravel())
        mesh.update()
        return ob


CLASSES = (SPLINEWRIGHT_OT_project_points,)
