"""Conics: rational quadratic curves and their equations (lecture rows S1, S10, S11)."""

from typing import Literal, SupportsIndex, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import Approximation, BezierCurve, HermiteCurve, NurbsCurve

__all__ = [
    "ImplicitConic",
    "arc",
    "arc_about",
    "arc_from_tangent",
    "arc_through",
    "as_hermite",
    "by_foci",
    "circle",
    "class_of",
    "conic_arc",
    "ellipse",
    "from_implicit",
    "hyperbola",
    "implicit",
    "parabola",
    "through_points",
]

_Form = Literal["square", "triangle", "halves", "single"]
_Floats = NDArray[np.float64]
_Type = Literal[
    "circle",
    "ellipse",
    "parabola",
    "hyperbola",
    "crossing_lines",
    "parallel_lines",
    "line",
    "point",
    "empty",
]
_Class = Literal[
    "shorter_ellipse_arc",
    "half_ellipse",
    "longer_ellipse_arc",
    "parabola_arc",
    "two_parabola_arcs",
    "hyperbola_arc",
    "two_hyperbola_arcs",
    "three_hyperbola_arcs",
    "segment",
    "line_through_infinity",
    "point",
]

@final
class ImplicitConic:
    """a x² + b xy + c y² + d x + e y + f = 0 in the coordinates of a plane."""

    def __init__(
        self,
        coefficients: ArrayLike,
        origin: ArrayLike = (0, 0, 0),
        x_axis: ArrayLike = (1, 0, 0),
        y_axis: ArrayLike = (0, 1, 0),
    ) -> None: ...
    @property
    def coefficients(self) -> _Floats: ...
    @property
    def origin(self) -> _Floats: ...
    @property
    def x_axis(self) -> _Floats: ...
    @property
    def y_axis(self) -> _Floats: ...
    @property
    def type(self) -> _Type: ...
    @property
    def center(self) -> _Floats | None: ...
    @property
    def half_lengths(self) -> tuple[float, float]: ...
    @property
    def axes(self) -> tuple[_Floats, _Floats]: ...
    @property
    def foci(self) -> list[_Floats]: ...
    @property
    def eccentricity(self) -> float | None: ...
    def arc(self, start: float, end: float) -> NurbsCurve: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> ImplicitConic: ...
    def __deepcopy__(self, memo: object, /) -> ImplicitConic: ...

def arc(
    center: ArrayLike,
    axis_a: ArrayLike,
    axis_b: ArrayLike,
    start: float,
    sweep: float,
    span_count: SupportsIndex = 0,
) -> NurbsCurve: ...
def arc_about(
    center: ArrayLike, start: ArrayLike, end: ArrayLike, normal: ArrayLike = (0, 0, 1)
) -> NurbsCurve: ...
def arc_from_tangent(start: ArrayLike, tangent: ArrayLike, end: ArrayLike) -> NurbsCurve: ...
def arc_through(start: ArrayLike, through: ArrayLike, end: ArrayLike) -> NurbsCurve: ...
def as_hermite(curve: BezierCurve | NurbsCurve, tolerance: float) -> Approximation[HermiteCurve]: ...
def by_foci(
    focus_1: ArrayLike, focus_2: ArrayLike, distance: float, normal: ArrayLike = (0, 0, 1)
) -> ImplicitConic: ...
def circle(center: ArrayLike, radius: float, normal: ArrayLike = (0, 0, 1), form: _Form = "square") -> NurbsCurve: ...
def class_of(curve: BezierCurve | NurbsCurve) -> _Class: ...
def conic_arc(p0: ArrayLike, p1: ArrayLike, p2: ArrayLike, w1: float) -> BezierCurve: ...
def ellipse(center: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike, form: _Form = "square") -> NurbsCurve: ...
def from_implicit(conic: ImplicitConic) -> list[NurbsCurve]: ...
def hyperbola(center: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike) -> list[NurbsCurve]: ...
def implicit(curve: BezierCurve | NurbsCurve) -> ImplicitConic: ...
def parabola(focus: ArrayLike, directrix_point: ArrayLike, directrix_direction: ArrayLike) -> ImplicitConic: ...
def through_points(points: ArrayLike, tolerance: float | None = None) -> ImplicitConic: ...
