"""Sharp edges: those of the surface, which are marked again each time, and a user's, which stay."""

import numpy as np

from ..data import versions
from . import mesh_layers

#: Edge attribute: those that are sharp because the surface is; other sharp edges are a user's.
SHARP = ".splinewright_sharp"


def marked(mesh):
    """(edges,) whether each is marked sharp; None where none is."""
    flags = mesh_layers.column(mesh, 'edges', 'use_edge_sharp', 'sharp_edge', bool)
    return flags if flags is not None and flags.any() else None


def of_users(mesh, flags):
    """(edges,) which of those that are marked() a user marked; None where none. A mesh of an early Splinewright cannot
    tell."""
    attribute = mesh_layers.ours(mesh, SHARP, 'BOOLEAN', 'EDGE')
    if flags is None or attribute is None:
        return None
    flags = flags & ~mesh_layers.read(attribute.data, 'value', 1, bool)[:, 0]
    return flags if flags.any() else None


def mark(mesh, sharp, users, flags):
    """Mark the edges of these pairs of vertices sharp, those of the user, (edges,) or None, and no others. flags: the
    present marked(). Returns the new one."""
    wanted = users
    if len(sharp):
        of_surface = _between(mesh, sharp)
        wanted = of_surface if users is None else of_surface | users
    if flags is not None or wanted is not None:
        _write(mesh, np.zeros(len(mesh.edges), bool) if wanted is None else wanted)
    return wanted


def _between(mesh, pairs):
    """(edges,) whether each is one of these pairs of vertices."""
    ends = np.empty(2 * len(mesh.edges), np.int32)
    if versions.marks_are_attributes:
        mesh.attributes['.edge_verts'].data.foreach_get('value', ends)
    else:
        mesh.edges.foreach_get('vertices', ends)
    count = len(mesh.vertices)
    return np.isin(_edge_numbers(ends.reshape(-1, 2), count), _edge_numbers(pairs, count))


def _edge_numbers(pairs, count):
    """One number for an edge, whichever way it runs."""
    pairs = np.sort(pairs.astype(np.int64), axis=1)
    return pairs[:, 0] * count + pairs[:, 1]


def note(mesh, users, flags):
    """Note that all edges that are marked() but those of the user, (edges,) or None for none, are the surface's."""
    attribute = mesh_layers.ours(mesh, SHARP, 'BOOLEAN', 'EDGE')
    if attribute is None:
        attribute = mesh.attributes.new(SHARP, 'BOOLEAN', 'EDGE')
    elif flags is None:
        flags = np.zeros(len(mesh.edges), bool)
    if flags is not None:
        attribute.data.foreach_set('value', flags if users is None else flags & ~users)


def _write(mesh, flags):
    """Mark these edges sharp, (edges,), and no others."""
    if not versions.marks_are_attributes:
        mesh.edges.foreach_set('use_edge_sharp', flags)
        return
    attribute = mesh.attributes.get('sharp_edge') or mesh.attributes.new('sharp_edge', 'BOOLEAN', 'EDGE')
    attribute.data.foreach_set('value', flags)
