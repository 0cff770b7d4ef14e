"""Curves and patches through points and near them (lecture rows S17, S20)."""

from ._splinecore import fit as _fit

approximate = _fit.approximate
interpolate = _fit.interpolate
interpolate_patch = _fit.interpolate_patch
project = _fit.project

__all__ = ["approximate", "interpolate", "interpolate_patch", "project"]
