"""The net of patches as a Mesh. Attributes of its vertices are their numbers and weights."""

from operator import itemgetter

import bmesh
import bpy
import numpy as np

from ...core.net import strays
from ...core.net.cage import Cage
from ...core.net.grown import STRAY, copy_of
from ...core.net.last_reading import Snapshot
from ...core.net.reading import ChangedNet, Present
from ..data.file_state import ended_operators
from ..mesh import mesh_edges

WEIGHT = "weight"
NUMBER = "splinewright_vertex"
#: What copies of a vertex have, and what Blender makes between two has not.
_SEAL = "splinewright_vertex_seal"
#: Moved points up to which it is faster to read those alone.
_FEW = 64
#: The number of a vertex that was passed over once for all.
_STRAY = -1


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


def present(ob, net):
    """The Present vertices of a net's object or Mesh, in Edit Mode or not. Raises ChangedNet."""
    vertices = _Vertices(ob)
    return Present(_numbers(vertices, net), vertices.positions, lambda: vertices.values('FLOAT', WEIGHT), vertices.links)


def snapshot(ob, before=None):
    """The core.net.last_reading.Snapshot of a net's object in Edit Mode, or None where it is not, or has lost what it takes.

    before: the last one. Where a few points have moved since, and none came or went, numbers and weights of those alone
    are read: to read all of them is most of a step of a drag. Where none has moved it is something else that changed.
    """
    if not ob.data.is_editmode:
        return None
    vertices = _Vertices(ob)
    layers, edited = (vertices.layer('INT', NUMBER), vertices.layer('FLOAT', WEIGHT)), vertices.edited
    if None in layers:
        return None
    occasion = len(edited.verts), len(edited.edges), len(edited.faces), ended_operators()
    positions = vertices.positions()
    if before is not None and occasion == before.occasion:
        moved = before.moved(positions)
        if 0 < len(moved) <= _FEW:
            edited.verts.ensure_lookup_table()
            kept = before.numbers, before.weights
            if all(edited.verts[i][layer] == known[i] for i in moved.tolist() for layer, known in zip(layers, kept)):
                return before._replace(positions=positions, slots=moved)
    return Snapshot(*(list(map(itemgetter(layer), edited.verts)) for layer in layers), positions, occasion)


def _numbers(vertices, net):
    """(m,): the vertices of the net that those that are there carry the numbers of, -1 for none."""
    numbers, count = vertices.values('INT', NUMBER), len(net.rows)
    if numbers is None:
        raise ChangedNet("the net has lost the numbers of its points, by which they are told apart: undo that")
    numbers = numbers.astype(np.int64) - net.first
    if np.array_equal(numbers, np.arange(count)) or np.array_equal(np.sort(numbers), np.arange(count)):
        return numbers
    seals = vertices.values('FLOAT', _SEAL)
    if seals is None:
        return np.where(numbers < count, numbers, -1)
    return strays.of_net(numbers, seals, strays.seals(count, net.first))


def runs(mesh, net, found):
    """The one core.net.cage.Cage of a Mesh. found: (n,) of each vertex of the net its slot, or -1."""
    vertices = _Vertices(mesh)
    numbers, carried = _numbers(vertices, net), vertices.values('INT', NUMBER)
    is_own = np.zeros(len(numbers), bool)
    is_own[found[found >= 0]] = True
    numbers = np.where(is_own | (numbers < 0), numbers, copy_of(numbers))
    numbers[carried == _STRAY] = STRAY
    weights = vertices.values('FLOAT', WEIGHT)
    weights = np.ones(len(numbers), np.float32) if weights is None else weights
    return [Cage(numbers, vertices.positions(), weights, vertices.links, vertices.corners)]


def carried(mesh):
    """(m,) the numbers that the vertices of a net carry, whatever they stand for."""
    numbers = _Vertices(mesh).values('INT', NUMBER)
    return np.empty(0, np.int64) if numbers is None else numbers


def everything(mesh):
    """Bytes of all that a net says."""
    vertices = _Vertices(mesh)
    for values in (vertices.values('INT', NUMBER), vertices.values('FLOAT', _SEAL), vertices.values('FLOAT', WEIGHT),
                   vertices.positions(), vertices.links()):
        yield b"" if values is None else values.tobytes()
    for corners in vertices.corners():
        yield repr(corners).encode()


def renumber(mesh, net, numbers, cages):
    """Let the vertices of a Mesh be those of a net, where they are: the number of each there, -1 for none, and smaller ones
    for copies, and strays."""
    (own,), seals = numbers, strays.seals(len(net.rows), net.first)
    known = np.where(own == STRAY, -1, np.where(own < -1, copy_of(own), own))
    vertices = _Vertices(mesh)
    vertices.set_values('INT', NUMBER, np.where(known < 0, _STRAY, known + net.first))
    vertices.set_values('FLOAT', _SEAL, np.where(known < 0, 1, seals[np.maximum(known, 0)]))
    vertices.tell()


def place(mesh, net, numbers, cages, new):
    """Put the vertices of a Mesh to where a net has them; as of renumber()."""
    (own,), vertices = numbers, _Vertices(mesh)
    positions, weights = vertices.positions(), vertices.values('FLOAT', WEIGHT)
    known = own >= 0
    positions[known] = net.single[own[known]]
    vertices.set_positions(positions)
    if weights is not None:
        weights[known] = net.single_weights[own[known]]
        vertices.set_values('FLOAT', WEIGHT, weights)
    vertices.tell()


def mend(mesh, faces, parted):
    """Make faces, by their slots, and let others go, in Edit Mode: out of it a net is on its way out of the file."""
    if mesh.is_editmode:
        edited = bmesh.from_edit_mesh(mesh)
        edited.verts.index_update()
        edited.verts.ensure_lookup_table()
        corners_of = {face: frozenset(vertex.index for vertex in face.verts) for face in edited.faces} if parted else {}
        for face in [face for face, corners in corners_of.items() if corners in parted]:
            edited.faces.remove(face)
        for corners in faces:
            edited.faces.new([edited.verts[slot] for slot in corners])
        bmesh.update_edit_mesh(mesh)


class _Vertices:
    """The vertices of a Mesh, from where they are now: Edit Mode has its own."""

    def __init__(self, block):
        """block: the Mesh, or the object that has it, which is faster in Edit Mode."""
        self._ob, self._mesh = (None, block) if isinstance(block, bpy.types.Mesh) else (block, block.data)
        self.edited = bmesh.from_edit_mesh(self._mesh) if self._mesh.is_editmode else None

    def values(self, kind, name):
        """(m,) of an attribute, or None where there is none of that kind."""
        dtype = np.float32 if kind == 'FLOAT' else np.int32
        if self.edited is not None:
            layer = self.layer(kind, name)
            vertices = self.edited.verts
            return None if layer is None else np.fromiter(map(itemgetter(layer), vertices), dtype, len(vertices))
        attribute = self._attribute(kind, name)
        if attribute is None:
            return None
        values = np.empty(len(attribute.data), dtype)
        attribute.data.foreach_get('value', values)
        return values

    def set_values(self, kind, name, values):
        """Write an attribute that is there."""
        if self.edited is not None:
            layer = self.layer(kind, name)
            for vertex, value in zip(self.edited.verts, values.tolist()) if layer is not None else ():
                vertex[layer] = value
        elif self._attribute(kind, name) is not None:
            dtype = np.float32 if kind == 'FLOAT' else np.int32
            self._attribute(kind, name).data.foreach_set('value', np.ascontiguousarray(values, dtype))

    def layer(self, kind, name):
        """The layer of an attribute in Edit Mode, or None."""
        layers = self.edited.verts.layers
        return (layers.float if kind == 'FLOAT' else layers.int).get(name)

    def _attribute(self, kind, name):
        attribute = self._mesh.attributes.get(name)
        return attribute if attribute and attribute.domain == 'POINT' and attribute.data_type == kind else None

    def positions(self):
        if self.edited is not None and self._ob is None:
            return np.array([vertex.co[:] for vertex in self.edited.verts], np.float32).reshape(-1, 3)
        if self.edited is not None:
            self._ob.update_from_editmode()
        flat = np.empty(3 * len(self._mesh.vertices), np.float32)
        self._mesh.vertices.foreach_get('co', flat)
        return flat.reshape(-1, 3)

    def set_positions(self, positions):
        if self.edited is None:
            self._mesh.vertices.foreach_set('co', positions.ravel())
            return
        for vertex, position in zip(self.edited.verts, positions.tolist()):
            vertex.co = position

    def links(self):
        if self.edited is not None:
            self.edited.verts.index_update()
            return np.array([[vertex.index for vertex in edge.verts] for edge in self.edited.edges], np.int64)
        flat = np.empty(2 * len(self._mesh.edges), np.int32)
        self._mesh.edges.foreach_get('vertices', flat)
        return flat.reshape(-1, 2)

    def corners(self):
        """Of each face the slots of its vertices."""
        if self.edited is None:
            return [tuple(face.vertices) for face in self._mesh.polygons]
        self.edited.verts.index_update()
        return [tuple(vertex.index for vertex in face.verts) for face in self.edited.faces]

    def tell(self):
        """Let Blender know of what was written."""
        if self.edited is None:
            self._mesh.update()
        else:
            bmesh.update_edit_mesh(self._mesh, loop_triangles=False, destructive=False)


def selects_vertices(ob):
    """Whether single vertices can be selected in Edit Mode now."""
    return 'VERT' in bmesh.from_edit_mesh(ob.data).select_mode


def flags(ob):
    """(m,) bool: the selected vertices in Edit Mode."""
    mesh = bmesh.from_edit_mesh(ob.data)
    return np.array([vertex.select for vertex in mesh.verts], bool)


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


def is_chosen(ob, index, kind):
    """Whether a vertex or an edge is selected. kind: 'verts' or 'edges'."""
    mesh = bmesh.from_edit_mesh(ob.data)            # its parts are gone with it
    return _part(mesh, index, kind).select


def choose(ob, index, kind, how):
    """Select a vertex or an edge, as a click does: 'only' and 'extend' select it, 'deselect' ends that, 'toggle' does the one
    not so."""
    mesh = bmesh.from_edit_mesh(ob.data)
    part = _part(mesh, index, kind)
    is_on = not part.select if how == 'toggle' else how != 'deselect'
    part.select_set(is_on)
    mesh.select_history.discard(part)
    if is_on:
        mesh.select_history.add(part)
    mesh.select_flush_mode()
    bmesh.update_edit_mesh(ob.data, loop_triangles=False, destructive=False)


def clear(ob):
    """Select nothing."""
    mesh = bmesh.from_edit_mesh(ob.data)
    for parts in (mesh.faces, mesh.edges, mesh.verts):
        for part in parts:
            part.select = False
    mesh.select_history.clear()
    mesh.select_flush_mode()
    bmesh.update_edit_mesh(ob.data, loop_triangles=False, destructive=False)


def _part(mesh, index, kind):
    parts = getattr(mesh, kind)
    parts.ensure_lookup_table()
    return parts[index]


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
