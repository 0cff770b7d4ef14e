"""Knot vectors, basis functions and samples (lecture rows S14, S15)."""

from ._splinecore import basis as _basis

KnotVector = _basis.KnotVector
Samples = _basis.Samples

bezier_matrix = _basis.bezier_matrix
hermite_matrix = _basis.hermite_matrix
uniform_matrix = _basis.uniform_matrix
uniform_to_bezier = _basis.uniform_to_bezier

__all__ = ["KnotVector", "Samples", "bezier_matrix", "hermite_matrix", "uniform_matrix", "uniform_to_bezier"]

for _name in ("KnotVector", "Samples"):
    globals()[_name].__module__ = __name__
del _name
