"""Knot vectors, basis functions and samples (lecture rows S14, S15)."""

from ._splinecore import basis as _basis

KnotVector = _basis.KnotVector
Samples = _basis.Samples

__all__ = ["KnotVector", "Samples"]

for _name in __all__:
    globals()[_name].__module__ = __name__
del _name
