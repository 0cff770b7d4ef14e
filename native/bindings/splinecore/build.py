"""Curves from points: polynomials, cardinal splines, chains of Bezier curves (lecture rows S3, S5, S7, S8)."""

from ._splinecore import build as _build

c2_pair = _build.c2_pair
catmull_rom = _build.catmull_rom
chain_from_polygon = _build.chain_from_polygon
join_beziers = _build.join_beziers
kochanek_bartels = _build.kochanek_bartels
lagrange_evaluate = _build.lagrange_evaluate
osculating_polynomial = _build.osculating_polynomial
polygon_of_chain = _build.polygon_of_chain
polynomial_through = _build.polynomial_through

__all__ = [
    "c2_pair",
    "catmull_rom",
    "chain_from_polygon",
    "join_beziers",
    "kochanek_bartels",
    "lagrange_evaluate",
    "osculating_polynomial",
    "polygon_of_chain",
    "polynomial_through",
]
