"""Curves and patches through points and near them (lecture rows S17, S20)."""

from collections.abc import Callable
from typing import Literal, SupportsIndex, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import Approximation, NurbsCurve, NurbsPatch

__all__ = ["approximate", "approximate_patch", "approximate_scattered", "interpolate", "interpolate_patch", "project"]

_Floats: TypeAlias = NDArray[np.float64]
_Parameterization: TypeAlias = Literal["calm", "uniform", "centripetal", "chordal"]
_Ends: TypeAlias = Literal["averaged", "not_a_knot", "natural"]

def interpolate(
    points: ArrayLike,
    degree: SupportsIndex = 3,
    parameters: _Parameterization | ArrayLike = "calm",
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
    parameters: _Parameterization | tuple[_Parameterization | ArrayLike, _Parameterization | ArrayLike] = "calm",
    knots: tuple[ArrayLike | None, ArrayLike | None] | None = None,
    ends: _Ends | tuple[_Ends, _Ends] = "averaged",
    closed: bool | tuple[bool, bool] = False,
    *,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def approximate(
    points: ArrayLike,
    count: SupportsIndex | None = None,
    degree: SupportsIndex = 3,
    parameters: _Parameterization | ArrayLike | None = None,
    *,
    tolerance: float | None = None,
    knots: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    fixed_ends: bool | None = None,
    start: ArrayLike | None = None,
    end: ArrayLike | None = None,
    closed: bool = False,
    smoothing: float = 0.0,
    corrections: SupportsIndex = 0,
    residual: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsCurve]: ...
def project(
    function: Callable[[_Floats], ArrayLike],
    knots: ArrayLike,
    degree: SupportsIndex = 3,
    *,
    fixed_ends: bool = False,
    closed: bool = False,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsCurve]: ...
def approximate_patch(
    points: ArrayLike,
    counts: SupportsIndex | tuple[SupportsIndex | None, SupportsIndex | None] | None = None,
    degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] = 3,
    parameters: _Parameterization | tuple[_Parameterization | ArrayLike, _Parameterization | ArrayLike] | None = None,
    *,
    tolerance: float | None = None,
    knots: tuple[ArrayLike | None, ArrayLike | None] | None = None,
    weights: tuple[ArrayLike | None, ArrayLike | None] | None = None,
    fixed_ends: bool = True,
    closed: bool | tuple[bool, bool] = False,
    smoothing: float | tuple[float, float] = 0.0,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def approximate_scattered(
    points: ArrayLike,
    counts: SupportsIndex | tuple[SupportsIndex, SupportsIndex] | None = None,
    degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] = 3,
    *,
    parameters: ArrayLike | None = None,
    tolerance: float | None = None,
    knots: tuple[ArrayLike, ArrayLike] | None = None,
    weights: ArrayLike | None = None,
    smoothing: float = 0.0,
    corrections: SupportsIndex = 8,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
