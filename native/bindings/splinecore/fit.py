"""Curves and patches through points and near them (lecture rows S17, S20)."""

from ._splinecore import fit as _fit

approximate = _fit.approximate
approximate_patch = _fit.approximate_patch
approximate_scattered = _fit.approximate_scattered
interpolate = _fit.interpolate
interpolate_patch = _fit.interpolate_patch
project = _fit.project

__all__ = ["approximate", "approximate_patch", "approximate_scattered", "interpolate", "interpolate_patch", "project"]
