"""Curves and patches through points (lecture rows S17, S20)."""

from collections.abc import Callable
from typing import Literal, SupportsIndex, TypeAlias

from numpy.typing import ArrayLike

from . import Approximation, NurbsCurve, NurbsPatch

__all__ = ["interpolate", "interpolate_patch"]

_Parametrisation: TypeAlias = Literal["uniform", "centripetal", "chordal"]
_Ends: TypeAlias = Literal["averaged", "not_a_knot", "natural"]

def interpolate(
    points: ArrayLike,
    degree: SupportsIndex = 3,
    parameters: _Parametrisation | ArrayLike = "chordal",
    knots: ArrayLike | None = None,
    ends: _Ends = "averaged",
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    closed: bool = False,
) -> Approximation[NurbsCurve]: ...
def interpolate_patch(
    points: ArrayLike,
    degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] = 3,
    parameters: _Parametrisation | tuple[_Parametrisation | ArrayLike, _Parametrisation | ArrayLike] = "chordal",
    knots: tuple[ArrayLike | None, ArrayLike | None] | None = None,
    ends: _Ends | tuple[_Ends, _Ends] = "averaged",
    closed: bool | tuple[bool, bool] = False,
    *,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
