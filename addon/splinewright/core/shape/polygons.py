"""Meshes of polygons, as surfaces are made of them."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal

#: A surface of more faces than this would take minutes.
MOST_FACES = 20_000


class Polygons(NamedTuple):
    """Corners and faces."""

    points: np.ndarray                  # (n, 3) float64
    starts: np.ndarray                  # (faces + 1,) int: where the corners of each face begin in `corners`
    corners: np.ndarray                 # (m,) int: numbers of points
    has_creases: bool = False           # of edges or points

    @property
    def faces(self):
        return [self.corners[start:end].tolist() for start, end in zip(self.starts, self.starts[1:])]


def require_faces(name, count):
    """Raises Refusal about a mesh of this name."""
    if not count:
        raise Refusal("{name}: the mesh has no face: a surface needs some", name=name)
    if count > MOST_FACES:
        raise Refusal("{name}: the mesh has {count:,} faces, {most_faces:,} are the most: take the mesh before it was subdivided",
                      name=name, count=count, most_faces=MOST_FACES)
