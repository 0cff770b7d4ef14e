"""Curves and patches from points and formulas (lecture rows S1, S3, S5, S7, S8)."""

from ._splinecore import build as _build

c2_pair = _build.c2_pair
catmull_rom = _build.catmull_rom
chain_from_polygon = _build.chain_from_polygon
curve_from_formulas = _build.curve_from_formulas
join_beziers = _build.join_beziers
kochanek_bartels = _build.kochanek_bartels
lagrange_evaluate = _build.lagrange_evaluate
osculating_polynomial = _build.osculating_polynomial
patch_from_formulas = _build.patch_from_formulas
polygon_of_chain = _build.polygon_of_chain
polynomial_through = _build.polynomial_through

__all__ = [
    "c2_pair",
    "catmull_rom",
    "chain_from_polygon",
    "curve_from_formulas",
    "join_beziers",
    "kochanek_bartels",
    "lagrange_evaluate",
    "osculating_polynomial",
    "patch_from_formulas",
    "polygon_of_chain",
    "polynomial_through",
]
