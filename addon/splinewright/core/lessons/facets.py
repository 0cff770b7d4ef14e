"""How a surface is drawn: its facets, and how far they lie from it."""

from typing import NamedTuple

import numpy as np

from ..base.library import sc


class Facets(NamedTuple):
    """The mesh that shows a surface."""

    places: np.ndarray                  # (n, 3) of vertices
    edges: np.ndarray                   # (m, 2) numbers of vertices
    corners: np.ndarray                 # numbers of vertices, face by face
    starts: np.ndarray                  # of each face: where its corners begin


def count(facets, _value):
    """How many faces there are."""
    return len(facets.starts)


def distance(facets, value):
    """How far the middles of edges and faces lie from the surface, at most."""
    patches = [value[i] for i in range(len(value))] if isinstance(value, sc.PatchSet) else [value]
    return sc.nearest(patches, _middles(facets)).distances.max()


def _middles(facets):
    of_edges = facets.places[facets.edges].mean(axis=1)
    sizes = np.diff(np.append(facets.starts, len(facets.corners)))
    of_faces = np.add.reduceat(facets.places[facets.corners], facets.starts) / sizes[:, None]
    return np.concatenate([of_edges, of_faces])
