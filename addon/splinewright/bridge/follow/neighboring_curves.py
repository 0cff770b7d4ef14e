"""Other curves that a shape may meet, in its space."""

import numpy as np

from ...core.base.failures import FAILURES
from ...core.shape import transform
from ...core.verbs import verbs
from . import recipe_results


def curves_of(ob, others, depsgraph):
    """The curves of other objects, shapes or Blender's own, in the space of a shape. What shows none is left out."""
    found = []
    for other in others:
        if other == ob or other.type != 'CURVE' or not recipe_results.is_possible(other):
            continue
        try:
            definition = recipe_results.definition_of(other, depsgraph)
            matrix = recipe_results.matrix_in(other, ob, depsgraph)
        except FAILURES:
            continue
        moved = definition if (matrix == np.eye(4)).all() else transform.transformed(definition, matrix)
        found += verbs.curves_of(moved)
    return found
