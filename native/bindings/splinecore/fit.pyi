"""Curves through points (lecture row S17)."""

from typing import Literal, SupportsIndex

from numpy.typing import ArrayLike

from . import Approximation, NurbsCurve

__all__ = ["interpolate"]

def interpolate(
    points: ArrayLike,
    degree: SupportsIndex = 3,
    parameters: Literal["uniform", "centripetal", "chordal"] | ArrayLike = "chordal",
    knots: ArrayLike | None = None,
    ends: Literal["averaged", "not_a_knot", "natural"] = "averaged",
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    closed: bool = False,
) -> Approximation[NurbsCurve]: ...
