"""Objects to which distances are measured: Blender's own by the faces, edges or points that are shown of them, shapes
by themselves."""

from dataclasses import dataclass

import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

from ...core.analysis import deviations
from ...core.base.failures import Refusal
from ...core.shape import transform
from ...core.verbs import verbs
from ..data import store
from ..data.file_state import key, remember, state
from ..shape import shape

#: Objects that are kept.
_KEPT = 4
#: Of more pieces the boxes that lead to the nearest one take too long to make in a drag.
_MOST_PIECES = 1000
#: A matrix that differs by so small a part of it from one that keeps angles keeps them.
_ANGLES = 1e-5
#: Points are no farther from the middle than so many sizes: their squares are float32.
_FARTHEST = 1e15
#: What may be measured to.
TYPES = ('MESH', 'CURVE', 'SURFACE', 'FONT', 'META')


@dataclass(eq=False)
class Geometry:
    """Of an object as it is now. Lengths in its tree are in units of a size and from a middle, where float32 is best."""

    words: str                          # what is measured to, in the legend
    middle: np.ndarray
    size: float
    tree: BVHTree | None = None
    pieces: tuple = ()                  # exact ones, where there is no tree

    def distances(self, points):
        """(n,): how far points (n, 3) are; nan of those that are not finite."""
        found = np.full(len(points), np.nan)
        with np.errstate(over='ignore', invalid='ignore'):
            near = (points - self.middle) / self.size
        here = np.flatnonzero((np.abs(near) < _FARTHEST).all(1))
        if self.pieces:
            found[here] = deviations.distances_to(self.pieces, points[here])
            return found
        nearest = self.tree.find_nearest
        found[here] = [nearest(point)[3] for point in near[here].tolist()]
        return found * self.size


@dataclass(eq=False)
class Target:
    """A Geometry and where it lies: another one when either is."""

    data: tuple                         # the key of the object's data-block
    made_of: tuple                      # what its Geometry is made of
    matrix: tuple                       # of the object
    geometry: Geometry
    into: np.ndarray                    # (3, 3): leads from directions in the world to its own
    origin: np.ndarray                  # of its own in the world
    unit: float                         # how long in the world is what is 1 in it

    def frame(self, matrix):
        """(3, 4): leads from the space of a matrix to its own."""
        return self.into @ np.column_stack([matrix[:3, :3], matrix[:3, 3] - self.origin])


def of(ob):
    """The Target of an object, its Geometry made again when it changed. Raises FAILURES where there is nothing to measure
    to."""
    if ob.type not in TYPES:
        raise Refusal("{name} has no surface and no lines: choose a mesh or a curve", name=ob.name)
    known, matrix = state.targets.get(key(ob)), tuple(flat(ob.matrix_world))
    if known is not None and known.matrix == matrix and known.made_of[0] == ob.as_pointer():
        return known                    # at every redraw: this must be quick
    world = np.reshape(matrix, (4, 4))
    if not np.isfinite(world).all():
        raise Refusal("{name} lies at infinity", name=ob.name)
    bend, into, unit = _taken_apart(world[:3, :3])
    made_of = ob.as_pointer(), None if bend is None else bend.tobytes()
    is_same = known is not None and known.made_of == made_of
    geometry = known.geometry if is_same else _geometry(ob, bend)
    return remember(state.targets, key(ob), Target(key(ob.data), made_of, matrix, geometry, into, world[:3, 3], unit),
                    _KEPT)


def flat(matrix):
    """The 16 numbers of a matrix of Blender's."""
    return [number for row in matrix for number in row]


def look_again(updates):
    """Blender tells of changes."""
    for update in updates:
        block = update.id.original
        if update.is_updated_geometry and isinstance(block, bpy.types.Object):
            state.targets.pop(key(block), None)


def _taken_apart(linear):
    """(what its geometry is changed by, or None; what leads from the world to that; its unit): a matrix that keeps angles
    does not change it."""
    with np.errstate(all='ignore'):
        unit = float(np.cbrt(abs(np.linalg.det(linear))))
        like = linear / unit
        if unit > 0.0 and np.abs(like.T @ like - np.eye(3)).max() < _ANGLES:
            return None, np.linalg.inv(like) / unit, unit
    return linear, np.eye(3), 1.0


def _geometry(ob, bend):
    if shape.has_shape(ob) and not any(modifier.show_viewport for modifier in ob.modifiers):
        return _exact(ob, bend) or _shown(ob, bend)
    return _shown(ob, bend)


def _exact(ob, bend):
    """None where it runs to infinity, is flattened, or has too many pieces."""
    definition = store.read(ob.data)
    if definition.runs_to_infinity or (bend is not None and np.linalg.det(bend) == 0.0):
        return None
    if bend is not None:
        definition = transform.transformed(definition, np.block([[bend, np.zeros((3, 1))], [np.zeros(3), 1.0]]))
    pieces = verbs.pieces_of(definition)
    if not 0 < len(pieces) <= _MOST_PIECES:
        return None
    return Geometry("exact", *deviations.extent(np.concatenate([piece.bounding_box() for piece in pieces])), pieces=tuple(pieces))


def _shown(ob, bend):
    """Of its faces, or its edges where it has none, or its points."""
    shown = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    try:
        mesh = shown.to_mesh()
    except RuntimeError:
        mesh = None
    try:
        points, triangles, words = _of_mesh(mesh) if mesh is not None else (np.empty((0, 3)), (), "")
    finally:
        shown.to_mesh_clear()
    if not len(points):
        raise Refusal("{name} is empty: it has no points to measure to", name=ob.name)
    return _with_tree(words, points if bend is None else points @ bend.T, triangles)


def _of_mesh(mesh):
    """(points, triangles, what these are): an edge and a point are triangles with corners that are one."""
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', points)
    points = points.reshape(-1, 3).astype(np.float64)
    mesh.calc_loop_triangles()
    if len(mesh.loop_triangles):
        return points, _numbers(mesh.loop_triangles, 3), "faces"
    if len(mesh.edges):
        return points, _numbers(mesh.edges, 2)[:, [0, 1, 1]], "edges"
    return points, np.arange(len(points))[:, None].repeat(3, 1), "points"


def _numbers(items, count):
    found = np.empty(count * len(items), np.int32)
    items.foreach_get('vertices', found)
    return found.reshape(-1, count)


def _with_tree(words, points, triangles):
    used = np.isfinite(points).all(1)
    triangles = triangles[used[triangles].all(1)]
    middle, size = deviations.extent(points)
    at = np.where(used[:, None], (points - middle) / size, 0.0)
    tree = BVHTree.FromPolygons(at.tolist(), triangles.tolist(), all_triangles=True)
    return Geometry(words, middle, size, tree)
