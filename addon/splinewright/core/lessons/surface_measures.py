"""Measures of the first patch of a surface at parameters, for measures.py: its places and normals."""

import numpy as np

from ..base.failures import Refusal


def _place(axis):
    return lambda patches, at, at_v: patches[0].evaluate(at, at_v)[axis]


def _normal(axis):
    def measure(patches, at, at_v):
        found = patches[0].evaluate_grid_with_normals([at], [at_v])[1][0, 0]
        if not np.isfinite(found).all() or not found.any():
            raise Refusal("the surface has no normal there")
        return found[axis]
    return measure


#: {name: (what it takes, function of a list of patches)}. `at` is the parameter u, `at_v` is v; normals have the length 1.
MEASURES = {f"{name}_{axis}": (('at', 'at_v'), found(i)) for name, found in (('surface', _place), ('normal', _normal))
            for i, axis in enumerate("xyz")}
