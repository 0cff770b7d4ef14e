"""Curves and patches through points (lecture rows S17, S20)."""

from ._splinecore import fit as _fit

interpolate = _fit.interpolate
interpolate_patch = _fit.interpolate_patch

__all__ = ["interpolate", "interpolate_patch"]
