"""Patches through and near the selected vertices of meshes in Edit Mode."""

import bmesh
import bpy
import numpy as np
from bpy.props import EnumProperty, FloatProperty, IntProperty

from ...bridge.shape import shape
from ...core.base import decimals, vertex_grid
from ...core.base.failures import FAILURES, Refusal
from ...core.base.library import sc
from ...core.base.words import say
from .. import editing, progress
from . import new_shapes, reports
from .add_patch import draw_pairs
from .adding import Repeatable, add_in_front, count_property, degree_property, require_place, resolution_property
from .long_work import LongWork


class PatchOfVertices(LongWork, new_shapes.Faces, Repeatable):
    """Adds a patch for each mesh, near or through the points of its selection."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}

    degree_u: degree_property("U")
    degree_v: degree_property("V")
    resolution_u: resolution_property("U", default=8)
    resolution_v: resolution_property("V", default=8)

    @classmethod
    def poll(cls, context):
        if context.mode == 'OBJECT' and cls.has_made(context):
            return True
        if context.mode != 'EDIT_MESH' or editing.nets_in_edit_mode(context):
            cls.poll_message_set(say("Select vertices in the Edit Mode of a mesh that is no net"))
            return False
        return True

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        made = []
        try:
            require_place(context)
            for ob in context.objects_in_mode_unique_data:
                with progress.shown(context, shape.STEPS) as step:
                    found = self.result_of(ob.name, self.task(ob))
                    data = shape.new_data(f"{ob.name} Patch", found.value, new_shapes.start(self), step)
                made.append((bpy.data.objects.new(data.name, data), ob, found.error))
        except FAILURES as error:
            bpy.data.batch_remove([new.data for new, _, _ in made])
            return reports.failed(self, error)
        bpy.ops.object.mode_set(mode='OBJECT')
        for new, source, _ in made:
            new.matrix_world, _ = new_shapes.without_scale(source.matrix_world)
            add_in_front(context, new, context.selected_objects if new == made[0][0] else [])
        new, _, errors = zip(*made)
        return self.finished(context, reports.Report(new_shapes.said_of(new, max(errors))))

    def tasks(self, context):
        return {ob.name: self.task(ob) for ob in context.objects_in_mode_unique_data}

    def task(self, ob):
        """A function that gives the library's Approximation, where distances are those of the scene, for a `cancel` as the
        library takes it. Raises Refusal."""
        raise NotImplementedError("task: each operator says which patch it makes")


class SPLINEWRIGHT_OT_patch_through_grid(PatchOfVertices, bpy.types.Operator):
    bl_idname = "splinewright.patch_through_grid"
    bl_label = "Add Patch Through Grid"
    button = "Patch Through Grid"
    bl_description = "Add a smooth NURBS patch through the corners of the selected faces, which lie in rows and columns"

    parametrisation: EnumProperty(name="Parameters", default='centripetal', items=(
        ('uniform', "Uniform", "The same step between any two rows"),
        ('chordal', "Chordal", "Steps by the distances of the points"),
        ('centripetal', "Centripetal", "Steps by the roots of the distances: calm where the points are uneven")))

    def task(self, ob):
        bm = bmesh.from_edit_mesh(ob.data)
        bm.verts.index_update()
        bm.verts.ensure_lookup_table()
        rows, closed = vertex_grid.in_grid([[vertex.index for vertex in face.verts] for face in bm.faces if face.select])
        _, linear = new_shapes.without_scale(ob.matrix_world)
        if np.linalg.det(linear) < 0.0:
            rows, closed = rows.T, closed[::-1]         # normals stay on their side
        points = np.array([[bm.verts[vertex].co for vertex in row] for row in rows.tolist()], dtype=np.float64) @ linear.T
        degrees = tuple(min(degree, count - 1) for degree, count in zip((self.degree_u, self.degree_v), rows.shape))
        parametrisation = self.parametrisation
        return lambda cancel: sc.fit.interpolate_patch(points, degrees, parametrisation, closed=closed, cancel=cancel)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        draw_pairs(self, layout, "degree")
        layout.prop(self, "parametrisation")
        new_shapes.draw(self, layout)


class SPLINEWRIGHT_OT_fit_patch(PatchOfVertices, bpy.types.Operator):
    bl_idname = "splinewright.fit_patch"
    bl_label = "Fit Patch"
    bl_description = ("Add a clean NURBS patch near the selected vertices, with a number of control points or within a "
                      "tolerance")

    by: EnumProperty(name="By", items=(('COUNT', "Points", "A given number of control points"),
                                       ('TOLERANCE', "Tolerance", "Few control points within a distance")))
    count_u: count_property("U", default=8)
    count_v: count_property("V", default=8)
    tolerance: FloatProperty(name="Tolerance", description="No vertex is farther from the patch, in the scene", default=0.01,
                             min=1e-9, soft_max=1.0, precision=4, unit='LENGTH')
    smoothing: FloatProperty(name="Smoothing", description="How much the patch is kept from bending; it decides where there "
                             "are no vertices", default=1e-6, min=0.0, soft_max=0.01, precision=8, step=0.0001)
    corrections: IntProperty(name="Corrections", description="So often at most the vertices' places on the patch are improved",
                             default=8, min=0, soft_max=20, max=1000)

    def task(self, ob):
        bm = bmesh.from_edit_mesh(ob.data)
        points = np.array([vertex.co for vertex in bm.verts if vertex.select], dtype=np.float64).reshape(-1, 3)
        if len(points) < 3:
            raise Refusal("select three vertices or more")
        points = points @ new_shapes.without_scale(ob.matrix_world)[1].T
        wanted = {'counts': (self.count_u, self.count_v)} if self.by == 'COUNT' else {'tolerance': decimals.typed(self.tolerance)}
        wanted |= {'degrees': (self.degree_u, self.degree_v), 'smoothing': decimals.typed(self.smoothing),
                   'corrections': self.corrections}
        return lambda cancel: sc.fit.approximate_scattered(points, **wanted, cancel=cancel)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "by", expand=True)
        if self.by == 'COUNT':
            draw_pairs(self, layout, "count")
        else:
            layout.prop(self, "tolerance")
        draw_pairs(self, layout, "degree")
        layout.prop(self, "smoothing")
        layout.prop(self, "corrections")
        new_shapes.draw(self, layout)


CLASSES = (SPLINEWRIGHT_OT_patch_through_grid, SPLINEWRIGHT_OT_fit_patch)
