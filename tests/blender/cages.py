"""Rows of the nets of patches, taken by hand."""

import bmesh
import bpy
import numpy as np

from shapes import numbers_of, op
from support import part

rows = part('core.net.cage_rows')


def held():
    return bpy.context.object


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def vertices(patch, axis, place):
    """The vertices of a row of a patch: of its points at a place along an axis."""
    return np.take(rows.grids(numbers_of(held()))[patch], place, axis).tolist()


def mesh():
    found = bmesh.from_edit_mesh(held().data)
    found.verts.ensure_lookup_table()
    found.verts.index_update()
    return found


def slots():
    """Of each vertex of the net its slot."""
    net = numbers_of(held())
    return part('bridge.net.selection')._slots(held(), net)


def choose(*chosen):
    """Select vertices of the net and the edges and faces between, as an undo step."""
    part('bridge.net.selection').select(held(), numbers_of(held()), chosen)
    bpy.ops.ed.undo_push(message="choose")


def choose_row(*row):
    """Select rows (patch, axis, place)."""
    choose(*np.unique([vertex for each in row for vertex in vertices(*each)]).tolist())


def choose_edges(pairs):
    """Select the edges between pairs of vertices alone, as an undo step."""
    bpy.ops.mesh.select_mode(type='EDGE')
    wanted = {frozenset(slots()[list(pair)].tolist()) for pair in pairs}
    edited = mesh()
    for piece in (*edited.faces, *edited.edges, *edited.verts):
        piece.select = False
    found = [edge for edge in edited.edges if frozenset(vertex.index for vertex in edge.verts) in wanted]
    assert len(found) == len(wanted)
    for edge in found:
        edge.select = True
    edited.select_flush_mode()
    bmesh.update_edit_mesh(held().data)
    bpy.ops.ed.undo_push(message="choose edges")


def rungs(*gaps):
    """The pairs of vertices on both sides of gaps (patch, axis, place), each once."""
    pairs = {frozenset(pair) for patch, axis, place in gaps
             for pair in zip(vertices(patch, axis, place), np.roll(rows.grids(numbers_of(held()))[patch], -1, axis).take(
                 place, axis).tolist())}
    return [tuple(pair) for pair in pairs if len(pair) == 2]


def cut(*gaps, cuts=1):
    """Cut across gaps, as a loop cut does."""
    choose_edges(rungs(*gaps))
    op(bpy.ops.mesh.subdivide, number_cuts=cuts)
    bpy.ops.mesh.select_mode(type='VERT')
    bpy.context.view_layer.update()


def extrude(*row, by=(0, 0, 1)):
    choose_row(*row)
    op(bpy.ops.mesh.extrude_context_move, TRANSFORM_OT_translate={'value': by})
    bpy.context.view_layer.update()


def dissolve(*row):
    """Dissolve the edges of rows."""
    pairs = {frozenset(pair) for patch, axis, place in row
             for line in [vertices(patch, axis, place)]
             for pair in zip(line, line[1:] + ([line[0]] if is_around(patch, 1 - axis) else []))}
    choose_edges([tuple(pair) for pair in pairs])
    op(bpy.ops.mesh.dissolve_edges)
    bpy.ops.mesh.select_mode(type='VERT')
    bpy.context.view_layer.update()


def is_around(patch, axis):
    return (numbers_of(held()).definition.pieces[patch].periodic or (False, False))[axis]


def delete(*row, kind='VERT'):
    choose_row(*row)
    op(bpy.ops.mesh.delete, type=kind)
    bpy.context.view_layer.update()
