"""Curves and patches from points, curves and formulas (lecture rows S1, S3, S5, S7, S8, S20, S21)."""

from collections.abc import Callable, Mapping, Sequence
from typing import Literal, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import (
    Approximation,
    BezierCurve,
    BezierPatch,
    Filling,
    Formula,
    HermiteCurve,
    HermitePatch,
    JoinedPatches,
    LoftSurface,
    NetworkSurface,
    NurbsCurve,
    NurbsPatch,
    PowerCurve,
    RoundedEdge,
    SubdivisionPatches,
)

__all__ = [
    "blend",
    "blend_patches",
    "c2_pair",
    "cap",
    "catmull_clark",
    "catmull_rom",
    "chain_from_polygon",
    "chamfered",
    "cone",
    "contour",
    "coons",
    "corner_counts",
    "curve_from_formulas",
    "curve_on_patch",
    "cylinder",
    "disc",
    "extend_patch",
    "extrude",
    "fill",
    "fill_rim",
    "fillet_chain",
    "fillet_patches",
    "filleted",
    "fillets",
    "helix",
    "join_beziers",
    "join_curves",
    "join_patches",
    "kochanek_bartels",
    "lagrange_evaluate",
    "loft",
    "match_patch",
    "network",
    "offset_patch",
    "open_ends",
    "osculating_polynomial",
    "patch_from_formulas",
    "pipe",
    "plane",
    "polygon_of_chain",
    "polynomial_through",
    "revolve",
    "ruled",
    "sphere",
    "sweep",
    "sweep_two_rails",
    "thicken",
    "torus",
    "touching_circle",
]

_Parameterization = Literal["uniform", "centripetal", "chordal"] | ArrayLike
_Ends = Literal["parabola", "chord", "natural"]
_Curve = NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Patch = NurbsPatch | BezierPatch | HermitePatch
_Border = Literal["u_start", "u_end", "v_start", "v_end"]
_EdgeContinuity = Literal["G0", "G1", "G2", "G3"]
_Neighbor = tuple[_Patch, _Border, _EdgeContinuity] | tuple[_Patch, _Border, _EdgeContinuity, float]
_PatchSmoothness = Literal["C0", "G1", "C1", "G2", "C2"]

def polynomial_through(points: ArrayLike, parameters: ArrayLike | None = None) -> NurbsCurve: ...
def osculating_polynomial(data: Sequence[ArrayLike], parameters: ArrayLike) -> NurbsCurve: ...
def lagrange_evaluate(
    points: ArrayLike, u: ArrayLike, parameters: ArrayLike | None = None
) -> NDArray[np.float64]: ...
def catmull_rom(
    points: ArrayLike,
    parameterization: _Parameterization = "uniform",
    tension: ArrayLike = 0.0,
    closed: bool = False,
    ends: _Ends = "parabola",
) -> HermiteCurve: ...
def kochanek_bartels(
    points: ArrayLike,
    tension: ArrayLike = 0.0,
    continuity: ArrayLike = 0.0,
    bias: ArrayLike = 0.0,
    parameterization: _Parameterization = "uniform",
    closed: bool = False,
    ends: _Ends = "parabola",
) -> HermiteCurve: ...
def chain_from_polygon(points: ArrayLike, parameters: ArrayLike | None = None) -> list[BezierCurve]: ...
def polygon_of_chain(
    chain: Sequence[BezierCurve], lengths: ArrayLike | None = None, tolerance: float | None = None
) -> NDArray[np.float64]: ...
def join_beziers(
    curves: Sequence[BezierCurve], parameters: ArrayLike | None = None, tolerance: float = 0.0
) -> NurbsCurve: ...
def blend(
    a: _Curve,
    b: _Curve,
    continuity: SupportsIndex = 2,
    *,
    end_a: Literal["start", "end"] = "end",
    end_b: Literal["start", "end"] = "start",
    strengths: ArrayLike = (1.0, 1.0),
) -> BezierCurve: ...
def filleted(
    a: _Curve,
    b: _Curve,
    radius: float,
    kept: ArrayLike,
    normal: ArrayLike = (0, 0, 1),
    *,
    cancel: Callable[[], object] | None = None,
) -> tuple[NurbsCurve | None, NurbsCurve, NurbsCurve | None]: ...
def chamfered(
    a: _Curve, b: _Curve, lengths: ArrayLike, kept: ArrayLike, *, cancel: Callable[[], object] | None = None
) -> tuple[NurbsCurve | None, NurbsCurve, NurbsCurve | None]: ...
def contour(
    points: ArrayLike, bulges: ArrayLike | None = None, closed: bool = False, normal: ArrayLike = (0, 0, 1)
) -> NurbsCurve: ...
def helix(
    axis: _Curve,
    radius: float,
    turns: float,
    *,
    end_radius: float | None = None,
    phase: float = 0.0,
    start: ArrayLike | None = None,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> NurbsCurve: ...
def curve_on_patch(
    patch: _Patch,
    image: _Curve,
    distance: float = 0.0,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> NurbsCurve: ...
def join_curves(curves: Sequence[_Curve], tolerance: float) -> list[NurbsCurve]: ...
def touching_circle(
    a: _Curve, b: _Curve, c: _Curve, parameters: ArrayLike, normal: ArrayLike = (0, 0, 1)
) -> tuple[NurbsCurve, NDArray[np.float64], float, tuple[float, float, float]]: ...
def c2_pair(
    q0: ArrayLike,
    q1: ArrayLike,
    d: ArrayLike,
    r2: ArrayLike,
    r3: ArrayLike,
    a: float = 1.0,
    b: float = 1.0,
) -> tuple[BezierCurve, BezierCurve]: ...
def curve_from_formulas(
    formulas: Sequence[str | Formula],
    domain: ArrayLike,
    *,
    tolerance: float = 1e-6,
    variable: str = "t",
    constants: Mapping[str, float] | None = None,
) -> Approximation[NurbsCurve]: ...
def patch_from_formulas(
    formulas: Sequence[str | Formula],
    domain_u: ArrayLike,
    domain_v: ArrayLike,
    *,
    tolerance: float = 1e-6,
    variables: Sequence[str] = ("u", "v"),
    constants: Mapping[str, float] | None = None,
) -> Approximation[NurbsPatch]: ...
def plane(origin: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike) -> NurbsPatch: ...
def cylinder(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    height: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def cone(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    height: float,
    top_radius: float = 0.0,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def disc(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def sphere(
    center: ArrayLike,
    radius: float,
    axis: ArrayLike = (0.0, 0.0, 1.0),
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def torus(
    center: ArrayLike,
    axis: ArrayLike,
    ring_radius: float,
    tube_radius: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def revolve(
    curve: _Curve,
    axis_point: ArrayLike,
    axis_direction: ArrayLike,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch: ...
def extrude(curve: _Curve, vector: ArrayLike) -> NurbsPatch: ...
def fillets(
    a: _Curve, b: _Curve, radius: float, normal: ArrayLike = (0, 0, 1), *, cancel: Callable[[], object] | None = None
) -> list[tuple[NurbsCurve, float, float, bool, bool]]: ...
def ruled(a: _Curve, b: _Curve) -> NurbsPatch: ...
def loft(
    sections: Sequence[_Curve | ArrayLike],
    *,
    style: Literal["normal", "tight", "uniform", "loose", "straight"] = "normal",
    closed: bool = False,
    degree: int = 3,
    align: bool = True,
    turned: Sequence[bool] | None = None,
    corners: Literal["free", "matched"] = "free",
    weights: Literal["scaled", "kept"] = "scaled",
    tolerance: float | None = None,
    knot_distance: float = 0.0,
    parameters: ArrayLike | None = None,
    knots: ArrayLike | None = None,
    start_tangent: ArrayLike | None = None,
    end_tangent: ArrayLike | None = None,
    start_flat: ArrayLike | tuple[ArrayLike, float] | None = None,
    end_flat: ArrayLike | tuple[ArrayLike, float] | None = None,
    start_neighbor: _Neighbor | None = None,
    end_neighbor: _Neighbor | None = None,
    calm: bool = True,
    cancel: Callable[[], object] | None = None,
) -> LoftSurface: ...
def corner_counts(sections: Sequence[_Curve | ArrayLike], *, align: bool = True) -> list[int]: ...
def blend_patches(
    a: _Patch,
    side_a: _Border,
    b: _Patch,
    side_b: _Border,
    continuity: _EdgeContinuity | tuple[_EdgeContinuity, _EdgeContinuity] = "G2",
    strengths: float | tuple[float, float] = 1.0,
    *,
    align: bool = True,
    calm: bool = True,
) -> NurbsPatch: ...
def coons(
    sides: Sequence[_Curve],
    *,
    across: Sequence[_Curve | None] | None = None,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def network(
    along_u: Sequence[_Curve],
    along_v: Sequence[_Curve],
    *,
    neighbors: Sequence[_Neighbor] | None = None,
    tolerance: float | None = None,
    gap: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> NetworkSurface: ...
def sweep(
    rail: _Curve,
    sections: _Curve | Sequence[_Curve],
    *,
    at: ArrayLike | None = None,
    frame: Literal["minimal", "upright", "parallel"] = "minimal",
    up: ArrayLike = (0, 0, 1),
    start: ArrayLike | None = None,
    end_scale: float = 1.0,
    scales: ArrayLike | None = None,
    twist: float = 0.0,
    tolerance: float | None = None,
    scale: _Curve | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def sweep_two_rails(
    rail: _Curve,
    second: _Curve,
    sections: _Curve | Sequence[_Curve],
    *,
    at: ArrayLike | None = None,
    height: Literal["scaled", "kept"] = "scaled",
    up: ArrayLike | None = None,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def pipe(
    axis: _Curve,
    radius: float | ArrayLike,
    *,
    caps: Literal["none", "flat", "round"] = "none",
    tolerance: float | None = None,
    scale: _Curve | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]: ...
def offset_patch(
    patch: _Patch,
    distance: float,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def thicken(
    patch: _Patch,
    start: float,
    end: float,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]: ...
def extend_patch(
    patch: _Patch, side: _Border, length: float, how: Literal["natural", "straight"] = "natural"
) -> NurbsPatch: ...
def match_patch(
    patch: _Patch,
    side: _Border,
    onto: _Patch,
    onto_side: _Border,
    continuity: _EdgeContinuity = "G1",
    *,
    rows: int | None = None,
    strength: float = 1.0,
    reversed: bool | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]: ...
def fill(
    sides: Sequence[_Curve | tuple[_Patch, _Border, Literal["G0", "G1", "G2"]]],
    *,
    tolerance: float | None = None,
    angle: float = 1e-4,
    cancel: Callable[[], object] | None = None,
) -> Filling: ...
def fill_rim(
    sides: Sequence[_Curve], *, cancel: Callable[[], object] | None = None
) -> Approximation[list[NurbsPatch]]: ...
def open_ends(patches: Sequence[_Patch]) -> list[list[tuple[int, _Border]]]: ...
def cap(
    patches: Sequence[_Patch],
    ends: Sequence[Sequence[tuple[int, _Border]]] | None = None,
    *,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]: ...
def fillet_patches(
    first: _Patch,
    first_side: _Border,
    second: _Patch,
    second_side: _Border,
    radius: float | ArrayLike,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> RoundedEdge: ...
def fillet_chain(
    edges: Sequence[tuple[_Patch, _Border, _Patch, _Border]],
    radius: float | ArrayLike,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> list[RoundedEdge]: ...
def catmull_clark(
    points: ArrayLike, faces: Sequence[Sequence[SupportsIndex]], *, cancel: Callable[[], object] | None = None
) -> SubdivisionPatches: ...
def join_patches(
    first: _Patch,
    first_side: _Border,
    second: _Patch,
    second_side: _Border,
    continuity: _PatchSmoothness = "G1",
    moves: Literal["second", "first", "both"] = "second",
    reversed: bool | None = None,
) -> JoinedPatches:
    """Two patches brought together along a side of each: the rows of points beside it move by the least.

    InvalidShape if a side is one point, lies at infinity or is the seam of a periodic axis. Farin 2002, on composite
    surfaces.
    """
