"""Other curves that a shape may meet, in its space."""

import numpy as np

from ..core import transform, verbs
from ..core.failures import FAILURES
from . import derived


def curves_of(ob, others, depsgraph):
    """The curves of other objects, shapes or Blender's own, in the space of a shape. What shows none is left out."""
    found = []
    for other in others:
        if other == ob or other.type != 'CURVE' or not derived.is_possible(other):
            continue
        try:
            definition = derived.definition_of(other, depsgraph)
            matrix = derived.matrix_in(other, ob, depsgraph)
        except FAILURES:
            continue
        moved = definition if (matrix == np.eye(4)).all() else transform.transformed(definition, matrix)
        found += verbs.curves_of(moved)
    return found
