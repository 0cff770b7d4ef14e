"""Sharp edges: those of the surface, which are marked anew each time, and a user's, which stay."""

import numpy as np

from . import mesh_layers

#: Edge attribute: those that are sharp because the surface is; other sharp edges are a user's.
SHARP = ".splinewright_sharp"


def marked(mesh):
    """(edges,) whether each is marked sharp; None where none is."""
    flags = mesh_layers.column(mesh, 'edges', 'use_edge_sharp', 'sharp_edge', bool)
    return flags if flags is not None and flags.any() else None


def of_users(mesh):
    """(edges,) whether a user marked each sharp; None where none is. A mesh of an early Splinewright cannot tell."""
    flags, attribute = marked(mesh), mesh_layers.ours(mesh, SHARP, 'BOOLEAN', 'EDGE')
    if flags is None or attribute is None:
        return None
    flags &= ~mesh_layers.read(attribute.data, 'value', 1, bool)[:, 0]
    return flags if flags.any() else None


def mark(mesh, sharp, users):
    """Mark the edges of these pairs of vertices sharp, those of the user, (edges,) or None, and no others."""
    if not len(sharp):
        if users is not None or marked(mesh) is not None:
            _write(mesh, np.zeros(len(mesh.edges), bool) if users is None else users)
        return
    ends = np.empty(2 * len(mesh.edges), np.int32)
    if mesh_layers.IN_ATTRIBUTES:
        mesh.attributes['.edge_verts'].data.foreach_get('value', ends)
    else:
        mesh.edges.foreach_get('vertices', ends)
    count = len(mesh.vertices)
    flags = np.isin(_edge_numbers(ends.reshape(-1, 2), count), _edge_numbers(sharp, count))
    _write(mesh, flags if users is None else flags | users)


def _edge_numbers(pairs, count):
    """One number for an edge, whichever way it runs."""
    pairs = np.sort(pairs.astype(np.int64), axis=1)
    return pairs[:, 0] * count + pairs[:, 1]


def note(mesh, users):
    """Note that all sharp edges but those of the user, (edges,) or None for none, are the surface's."""
    attribute, flags = mesh_layers.ours(mesh, SHARP, 'BOOLEAN', 'EDGE'), marked(mesh)
    if attribute is None:
        attribute = mesh.attributes.new(SHARP, 'BOOLEAN', 'EDGE')
    elif flags is None:
        flags = np.zeros(len(mesh.edges), bool)
    if flags is not None:
        attribute.data.foreach_set('value', flags if users is None else flags & ~users)


def _write(mesh, flags):
    """Mark these edges sharp, (edges,), and no others."""
    if not mesh_layers.IN_ATTRIBUTES:
        mesh.edges.foreach_set('use_edge_sharp', flags)
        return
    attribute = mesh.attributes.get('sharp_edge') or mesh.attributes.new('sharp_edge', 'BOOLEAN', 'EDGE')
    attribute.data.foreach_set('value', flags)
