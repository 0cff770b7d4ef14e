"""The net of patches as a Mesh. Attributes of its vertices are their numbers and weights."""

import bmesh
import bpy
import numpy as np

from ...core.net import strays
from ...core.net.reading import ChangedNet, Present
from .. import mesh_edges

WEIGHT = "weight"
NUMBER = "splinewright_vertex"
#: What copies of a vertex have, and what Blender makes between two has not.
_SEAL = "splinewright_vertex_seal"


def make(name, net):
    """A new Mesh that shows the net of patches."""
    mesh = bpy.data.meshes.new(f"{name} Net")
    edges = np.concatenate([*net.lines, np.array(net.arrows, dtype=np.int64).reshape(-1, 2)])
    mesh.from_pydata(net.positions.tolist(), _without_sides(edges, net.faces).tolist(), net.faces)
    mesh_edges.mend(mesh)
    mesh.attributes.new(WEIGHT, 'FLOAT', 'POINT').data.foreach_set('value', net.single_weights)
    count = np.arange(len(net.rows), dtype=np.int32)
    mesh.attributes.new(NUMBER, 'INT', 'POINT').data.foreach_set('value', count)
    mesh.attributes.new(_SEAL, 'FLOAT', 'POINT').data.foreach_set('value', strays.seals(len(count)))
    mesh.vertices.foreach_set('select', np.zeros(len(count), bool))
    mesh.edges.foreach_set('select', np.zeros(len(mesh.edges), bool))
    mesh.polygons.foreach_set('select', np.zeros(len(mesh.polygons), bool))
    mesh.update()
    return mesh


def _without_sides(edges, faces):
    """The edges that are no side of a face."""
    quads = np.array([face for face in faces if len(face) == 4], dtype=np.int64).reshape(-1, 4)
    triangles = np.array([face for face in faces if len(face) == 3], dtype=np.int64).reshape(-1, 3)
    sides = np.concatenate([np.stack([corners, np.roll(corners, -1, 1)], -1).reshape(-1, 2)
                            for corners in (quads, triangles)])
    count = 1 + edges.max(initial=0)
    known = [pairs.min(1) * count + pairs.max(1) for pairs in (edges, sides)]
    return edges[~np.isin(*known)]


def present(ob, count):
    """The Present vertices of a net that was made of so many, in Edit Mode or not. Raises ChangedNet."""
    vertices = _Vertices(ob)
    numbers = vertices.values('INT', NUMBER)
    if numbers is None:
        raise ChangedNet("the net has lost the numbers of its points, by which they are told apart: undo that")
    if not np.array_equal(np.sort(numbers), np.arange(count)):
        seals = vertices.values('FLOAT', _SEAL)
        numbers = numbers if seals is None else strays.of_net(numbers, seals, strays.seals(count))
    return Present(numbers, vertices.positions, lambda: vertices.values('FLOAT', WEIGHT), vertices.links)


class _Vertices:
    """The vertices of a Mesh, from where they are now: Edit Mode has its own."""

    def __init__(self, ob):
        self._ob = ob
        self._edited = bmesh.from_edit_mesh(ob.data) if ob.mode == 'EDIT' else None

    def values(self, kind, name):
        """(m,) of an attribute, or None where there is none of that kind."""
        dtype = np.float32 if kind == 'FLOAT' else np.int32
        if self._edited is not None:
            layers = self._edited.verts.layers
            layer = (layers.float if kind == 'FLOAT' else layers.int).get(name)
            return None if layer is None else np.array([vertex[layer] for vertex in self._edited.verts], dtype)
        attribute = self._ob.data.attributes.get(name)
        if attribute is None or attribute.domain != 'POINT' or attribute.data_type != kind:
            return None
        values = np.empty(len(attribute.data), dtype)
        attribute.data.foreach_get('value', values)
        return values

    def positions(self):
        if self._edited is not None:
            self._ob.update_from_editmode()
        flat = np.empty(3 * len(self._ob.data.vertices), np.float32)
        self._ob.data.vertices.foreach_get('co', flat)
        return flat.reshape(-1, 3)

    def links(self):
        if self._edited is not None:
            self._edited.verts.index_update()
            return np.array([[vertex.index for vertex in edge.verts] for edge in self._edited.edges], np.int64)
        flat = np.empty(2 * len(self._ob.data.edges), np.int32)
        self._ob.data.edges.foreach_get('vertices', flat)
        return flat.reshape(-1, 2)


def selects_vertices(ob):
    """Whether single vertices can be selected in Edit Mode now."""
    return 'VERT' in bmesh.from_edit_mesh(ob.data).select_mode


def flags(ob):
    """(m,) bool: the selected vertices in Edit Mode."""
    return np.array([vertex.select for vertex in bmesh.from_edit_mesh(ob.data).verts], bool)


def set_flags(ob, chosen):
    """Select the vertices of which chosen (m,) is True, in Edit Mode, and the edges and faces between them."""
    mesh = bmesh.from_edit_mesh(ob.data)
    for part in (*mesh.faces, *mesh.edges):
        part.select = False             # takes vertices along
    for vertex, is_chosen in zip(mesh.verts, chosen.tolist()):
        vertex.select = is_chosen
    for part in (*mesh.edges, *mesh.faces):
        if all(vertex.select for vertex in part.verts):
            part.select = True
    bmesh.update_edit_mesh(ob.data)


def move(ob, rows):
    """Give vertices in Edit Mode positions and weights. rows: x, y, z, w by the slot of a vertex."""
    mesh = bmesh.from_edit_mesh(ob.data)
    weights = mesh.verts.layers.float.get(WEIGHT)
    mesh.verts.ensure_lookup_table()
    for i, (*position, weight) in rows.items():
        mesh.verts[i].co = position
        if weights is not None:
            mesh.verts[i][weights] = weight
    bmesh.update_edit_mesh(ob.data, loop_triangles=False, destructive=False)
