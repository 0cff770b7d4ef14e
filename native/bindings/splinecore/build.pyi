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
    "joint_equations",
    "joint_points",
    "kochanek_bartels",
    "lagrange_evaluate",
    "least_motion",
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
    "rail_frames",
    "revolve",
    "ruled",
    "sphere",
    "sweep",
    "sweep_two_rails",
    "thicken",
    "torus",
    "touching_circle",
    "two_rail_frames",
]

_Parameterization = Literal["uniform", "centripetal", "chordal"] | ArrayLike
_Ends = Literal["parabola", "chord", "natural"]
_Curve = NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Patch = NurbsPatch | BezierPatch | HermitePatch
_Border = Literal["u_start", "u_end", "v_start", "v_end"]
_EdgeContinuity = Literal["G0", "G1", "G2", "G3"]
_Neighbor = tuple[_Patch, _Border, _EdgeContinuity] | tuple[_Patch, _Border, _EdgeContinuity, float]
_PatchSmoothness = Literal["C0", "G1", "C1", "G2", "C2"]

def polynomial_through(points: ArrayLike, parameters: ArrayLike | None = None) -> NurbsCurve:
    """Interpolate points by one polynomial.

    Between equal steps it oscillates. One span, or more where rounding would hide the curve.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), n from 2 to 256.
    parameters : array_like, optional
        Increasing parameters (n,); by default equal steps from 0 to 1.

    Returns
    -------
    NurbsCurve
        The curve of degree n - 1.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lagrange; Runge 1901; lecture row S3.

    Examples
    --------
    >>> curve = sc.build.polynomial_through([(0, 0), (1, 1), (2, 0)])
    >>> curve.degree, curve.evaluate(0.5).round(9).tolist()
    (2, [1.0, 1.0, 0.0])
    """
def osculating_polynomial(data: Sequence[ArrayLike], parameters: ArrayLike) -> NurbsCurve:
    """Find the polynomial curve with given derivatives.

    Parameters
    ----------
    data : sequence of array_like
        For each parameter an array (k, 2 or 3) of the point and its first k - 1 derivatives.
    parameters : array_like
        Increasing parameters.

    Returns
    -------
    NurbsCurve
        The curve; its degree is the number of all rows less one, 255 at most.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S3.

    Examples
    --------
    >>> curve = sc.build.osculating_polynomial([[(0, 0), (1, 0)], [(1, 1), (1, 0)]], [0, 1])
    >>> curve.degree, curve.derivatives(1.0, 1).round(9)[:, :2].tolist()
    (3, [[1.0, 1.0], [1.0, 0.0]])
    """
def lagrange_evaluate(
    points: ArrayLike, u: ArrayLike, parameters: ArrayLike | None = None
) -> NDArray[np.float64]:
    """Evaluate the polynomial through points without making a curve.

    The barycentric form, stable for hundreds of points at Chebyshev's parameters.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3).
    u : array_like
        Parameters (...,) in the domain.
    parameters : array_like, optional
        Increasing parameters (n,); by default equal steps from 0 to 1.

    Returns
    -------
    numpy.ndarray
        Points (..., 3).

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Berrut and Trefethen 2004; lecture row S3.

    Examples
    --------
    >>> sc.build.lagrange_evaluate([(0, 0), (1, 1), (2, 0)], [0.25, 0.5]).round(9).tolist()
    [[0.5, 0.75, 0.0], [1.0, 1.0, 0.0]]
    """
def catmull_rom(
    points: ArrayLike,
    parameterization: _Parameterization = "uniform",
    tension: ArrayLike = 0.0,
    closed: bool = False,
    ends: _Ends = "parabola",
) -> HermiteCurve:
    """Make a chain of cubics through points, whose tangents come from the neighbors.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length; two coordinates lie in the xy plane.
    parameterization : {'uniform', 'centripetal', 'chordal'} or array_like, default 'uniform'
        Powers 0, 1/2 or 1 of the distances, or increasing parameters (n,), for a closed chain (n +
        1,).
    tension : array_like, default 0.0
        Tangents are multiplied by 1 - tension; 0 is Catmull's and Rom's spline.
    closed : bool, default False
        Whether the chain returns to its first point.
    ends : {'parabola', 'chord', 'natural'}, default 'parabola'
        The tangent at an open end: of the parabola through three points, of the chord, or 'natural',
        without second derivative.

    Returns
    -------
    HermiteCurve
        The chain.

    Raises
    ------
    InvalidShape
        If points coincide and their distance is the step of the parameter.

    References
    ----------
    Catmull and Rom 1974; lecture row S5.

    Examples
    --------
    >>> chain = sc.build.catmull_rom([(0, 0), (1, 1), (2, 0), (3, 1)])
    >>> chain.evaluate(1.0).tolist()
    [1.0, 1.0, 0.0]
    """
def kochanek_bartels(
    points: ArrayLike,
    tension: ArrayLike = 0.0,
    continuity: ArrayLike = 0.0,
    bias: ArrayLike = 0.0,
    parameterization: _Parameterization = "uniform",
    closed: bool = False,
    ends: _Ends = "parabola",
) -> HermiteCurve:
    """Make a chain of cubics through points with tension, continuity and bias.

    With a continuity other than 0 the chain has corners.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length; two coordinates lie in the xy plane.
    tension : array_like, default 0.0
        One number, or one for each point (n,).
    continuity : array_like, default 0.0
        One number, or one for each point (n,).
    bias : array_like, default 0.0
        One number, or one for each point (n,).
    parameterization : {'uniform', 'centripetal', 'chordal'} or array_like, default 'uniform'
        As of `catmull_rom`.
    closed : bool, default False
        Whether the chain returns to its first point.
    ends : {'parabola', 'chord', 'natural'}, default 'parabola'
        As of `catmull_rom`.

    Returns
    -------
    HermiteCurve
        The chain.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Kochanek and Bartels 1984; lecture row S5.

    Examples
    --------
    >>> points = [(0, 0), (1, 1), (2, 0), (3, 1)]
    >>> tight = sc.build.kochanek_bartels(points, tension=1.0)
    >>> tight.evaluate(1.0).tolist(), tight.derivatives(1.0, 1)[1].tolist()
    ([1.0, 1.0, 0.0], [0.0, 0.0, 0.0])
    """
def chain_from_polygon(points: ArrayLike, parameters: ArrayLike | None = None) -> list[BezierCurve]:
    """Convert the control polygon of a cubic B-spline with fourfold ends to Bezier curves.

    Parameters
    ----------
    points : array_like
        Polygon (m + 3, 2 or 3).
    parameters : array_like, optional
        Increasing parameters (m + 1,); 0, 1, 2, … where none are given.

    Returns
    -------
    list of BezierCurve
        The m cubic curves.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S8.

    Examples
    --------
    >>> chain = sc.build.chain_from_polygon([(0, 0), (1, 2), (3, 2), (4, 0), (6, 0)])
    >>> len(chain), chain[0].evaluate(1.0).tolist() == chain[1].evaluate(0.0).tolist()
    (2, True)
    """
def polygon_of_chain(
    chain: Sequence[BezierCurve], lengths: ArrayLike | None = None, tolerance: float | None = None
) -> NDArray[np.float64]:
    """Find the control polygon of a C2 chain of cubic Bezier curves.

    Parameters
    ----------
    chain : sequence of BezierCurve
        The m curves.
    lengths : array_like, optional
        Lengths (m,) of their intervals, 1 where none are given.
    tolerance : float, optional
        The largest difference at a joint that counts as C2; by default that of rounding.

    Returns
    -------
    numpy.ndarray
        Polygon (m + 3, 3).

    Raises
    ------
    InvalidShape
        If a joint is not C2; the message has its number.

    References
    ----------
    Lecture row S8.

    Examples
    --------
    >>> polygon = [(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0), (6, 0, 0)]
    >>> bool(np.allclose(sc.build.polygon_of_chain(sc.build.chain_from_polygon(polygon)), polygon))
    True
    """
def joint_equations(
    first: ArrayLike,
    first_degree: SupportsIndex,
    first_spans: ArrayLike,
    second: ArrayLike,
    second_degree: SupportsIndex,
    second_spans: ArrayLike,
    continuity: Literal["C0", "G1", "C1", "G2", "C2"] = "G1",
) -> NDArray[np.float64] | None:
    """Find what continuity across a joint or seam asks of where the control points beside it lie.

    While weights stay, and the numbers by which one side continues the other, points may move by whatever
    makes the sum of factors times motions 0 in every column. The numbers are read from points for which
    the continuity holds.

    Parameters
    ----------
    first : array_like
        The first three rows of points (3, n, 4) of the first side, counted from the edge, in columns
        across it: x, y, z and weight. A curve has one column; of degree 1 the third point may be any.
    first_degree : int
        Its degree across.
    first_spans : array_like
        How far its next two knots are from the edge, both above 0.
    second : array_like
        The first three rows of points (3, n, 4) of the second side, in the same columns.
    second_degree : int
        Its degree across.
    second_spans : array_like
        How far its next two knots are from the edge, both above 0.
    continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
        'C0', 'G1', 'C1', 'G2' or 'C2'.

    Returns
    -------
    numpy.ndarray or None
        Factors (orders, n, 6): for each derivative and column those of three points of the first side
        and three of the second. None where the continuity does not hold, for C1 and C2 also where
        weights of both sides differ at the edge, or where it lies at infinity.

    Raises
    ------
    InvalidShape
        If points, degrees or spans are not as said.

    References
    ----------
    Farin 2002; lecture rows S18, S21.

    Examples
    --------
    >>> first = [[(2, 0, 0, 1)], [(1, 0, 0, 1)], [(0, 0, 0, 1)]]
    >>> second = [[(2, 0, 0, 1)], [(3, 0, 0, 1)], [(4, 0, 0, 1)]]
    >>> sc.build.joint_equations(first, 2, (1, 1), second, 2, (1, 1), "C1") / 2
    array([[[-1.,  1.,  0., -1.,  1.,  0.]]])
    """
def least_motion(
    equations: Sequence[tuple[ArrayLike, ArrayLike]],
    moved: ArrayLike,
    free: ArrayLike,
    *,
    cancel: Callable[[], object] | None = None,
) -> NDArray[np.float64] | None:
    """Move points by the least sum of squares so that linear equations hold again after some were moved.

    Parameters
    ----------
    equations : sequence of tuple (array_like, array_like)
        Pairs of the numbers of points (n, k), in columns, and factors (orders, n, k): in each column,
        for each order, the sum of factors times motions is to be 0.
    moved : array_like
        How far points were moved already (m, 3).
    free : array_like
        Which points may move on (m,).
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    numpy.ndarray or None
        How far points move beside that (m, 3). None where no motion meets the equations.

    Raises
    ------
    InvalidShape
        If there is no point of some number, or counts differ.
    Cancelled
        If `cancel` returned true.

    Examples
    --------
    >>> middle = ([[0, 1, 2]], [[[1, -2, 1]]])
    >>> sc.build.least_motion([middle], [(0, 0, 0), (0, 3, 0), (0, 0, 0)], [True, False, True])
    array([[0., 3., 0.],
           [0., 0., 0.],
           [0., 3., 0.]])
    """
def joint_points(
    first: ArrayLike,
    first_degree: SupportsIndex,
    first_spans: ArrayLike,
    second: ArrayLike,
    second_degree: SupportsIndex,
    second_spans: ArrayLike,
    continuity: Literal["C0", "G1", "C1", "G2", "C2"] = "G1",
    moves: Literal["second", "first", "both"] = "second",
    *,
    first_moved: Sequence[bool] | None = None,
    second_moved: Sequence[bool] | None = None,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Move the control points beside a joint of two curves so that one continues the other smoothly.

    A curve leaves a joint by its first three control points, counted from there: at an end of a clamped
    curve, or on both sides of a knot that is as often in the list as the degree. Weights stay, and so do
    points that need not move, to the last digit. G1 and G2 keep the speed of each side, and how that
    changes.

    Parameters
    ----------
    first : array_like
        The first points (2 or 3, 4) of the curve before the joint, counted backwards from there: x,
        y, z and weight. Where the weight is 0, x, y and z are a direction.
    first_degree : int
        Its degree.
    first_spans : array_like
        How far its next two knots are from the joint, both above 0.
    second : array_like
        The first points (2 or 3, 4) of the curve behind the joint.
    second_degree : int
        Its degree.
    second_spans : array_like
        How far its next two knots are from the joint, both above 0.
    continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
        'C0' for a common point, 'G1' for a common tangent, 'C1' for equal first derivatives, 'G2' for
        a common curvature, 'C2' for equal first two derivatives.
    moves : {'second', 'first', 'both'}, default 'second'
        Which side moves.
    first_moved : sequence of bools, optional
        Which of the points were moved by hand. An end that was takes the joint along; other points
        stay where they were put, unless the continuity moves them.
    second_moved : sequence of bools, optional
        The same of the second side.

    Returns
    -------
    tuple (numpy.ndarray, numpy.ndarray)
        The points of both sides, in the same order.

    Raises
    ------
    InvalidShape
        If the joint lies at infinity, a side that moves has too low a degree, or points or spans are
        not as said.

    References
    ----------
    The NURBS Book, formulas 3.9 and 4.8; lecture rows S18, S21.

    Examples
    --------
    >>> first = [(2, 0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 1)]
    >>> second = [(2, 0, 0, 1), (2, 1, 0, 1), (4, 2, 0, 1)]
    >>> _, moved = sc.build.joint_points(first, 2, (1, 1), second, 2, (1, 1), "C1")
    >>> moved[1]
    array([3., 0., 0., 1.])
    """
def join_beziers(
    curves: Sequence[BezierCurve], parameters: ArrayLike | None = None, tolerance: float = 0.0
) -> NurbsCurve:
    """Join Bezier curves end to end as one NURBS curve that keeps each exactly.

    Parameters
    ----------
    curves : sequence of BezierCurve
        Curves of any degrees.
    parameters : array_like, optional
        Increasing parameters, one more than curves; 0, 1, 2, … where none are given.
    tolerance : float, default 0.0
        The largest distance of an end from the next start, a length.

    Returns
    -------
    NurbsCurve
        The curve; inner parameters are knots of full multiplicity.

    Raises
    ------
    InvalidShape
        If an end lies farther from the next start; the message has the number of the joint.

    References
    ----------
    Lecture row S7.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (1, 0)])
    >>> b = sc.BezierCurve([(1, 0), (1, 1), (0, 1)])
    >>> sc.build.join_beziers([a, b])
    NurbsCurve(degree=2, points=5)
    """
def blend(
    a: _Curve,
    b: _Curve,
    continuity: SupportsIndex = 2,
    *,
    end_a: Literal["start", "end"] = "end",
    end_b: Literal["start", "end"] = "start",
    strengths: ArrayLike = (1.0, 1.0),
) -> BezierCurve:
    """Join the ends of two curves by a smooth Bezier curve.

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind.
    continuity : int, default 2
        0 for points alone; 1 for tangents, 2 for curvatures, 3 for their derivative by the length (G0
        to G3).
    end_a : {'start', 'end'}, default 'end'
        The end of a.
    end_b : {'start', 'end'}, default 'start'
        The end of b.
    strengths : array_like, default (1.0, 1.0)
        Speeds (2,) at both ends relative to their distance: larger values follow a curve further.

    Returns
    -------
    BezierCurve
        The curve, of degree 2 continuity + 1.

    Raises
    ------
    InvalidShape
        If a strength is not above 0, the ends coincide, or a curve has a zero derivative at its end.
    PointAtInfinity
        If an end lies at infinity.

    References
    ----------
    Lecture rows S7, S16.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (1, 0)])
    >>> b = sc.BezierCurve([(2, 1), (3, 1)])
    >>> sc.build.blend(a, b, 1).points[:2].tolist()[0]
    [1.0, 0.0, 0.0]
    """
def filleted(
    a: _Curve,
    b: _Curve,
    radius: float,
    kept: ArrayLike,
    normal: ArrayLike = (0, 0, 1),
    *,
    cancel: Callable[[], object] | None = None,
) -> tuple[NurbsCurve | None, NurbsCurve, NurbsCurve | None]:
    """Fillet two plane curves: an arc that touches both, and both shortened to it.

    Open curves that have no such arc are extended straight to it; closed ones are not cut.

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind in the same plane.
    radius : float
        Radius of the arc, above 0.
    kept : array_like
        Parameters (2,), one on each curve, of the parts that stay.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of the plane.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    tuple (NurbsCurve or None, NurbsCurve, NurbsCurve or None)
        (a, arc, b); None for a curve that the arc replaces.

    Raises
    ------
    InvalidShape
        If there is no such arc, or the curves are not in a plane with that normal.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0), (4, 0)])
    >>> b = sc.BezierCurve([(4, 0), (4, 4)])
    >>> _, arc, _ = sc.build.filleted(a, b, 1.0, (0.0, 1.0))
    >>> round(arc.length(), 6)
    1.570796
    """
def chamfered(
    a: _Curve, b: _Curve, lengths: ArrayLike, kept: ArrayLike, *, cancel: Callable[[], object] | None = None
) -> tuple[NurbsCurve | None, NurbsCurve, NurbsCurve | None]:
    """Chamfer two curves: a line between them, and both shortened to it.

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind.
    lengths : array_like
        Lengths (2,) along each curve from where they meet.
    kept : array_like
        Parameters (2,), one on each curve, of the parts that stay.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    tuple (NurbsCurve or None, NurbsCurve, NurbsCurve or None)
        (a, line, b); None for a curve that the line replaces.

    Raises
    ------
    InvalidShape
        If the curves do not meet, both lengths are 0, or a curve is too short.
    Cancelled
        If `cancel` returned true.

    Examples
    --------
    >>> a, b = sc.BezierCurve([(0, 0), (4, 0)]), sc.BezierCurve([(4, 0), (4, 4)])
    >>> _, line, _ = sc.build.chamfered(a, b, (1, 2), (0.0, 1.0))
    >>> line.evaluate(0.0).round(9).tolist(), line.evaluate(1.0).round(9).tolist()
    ([3.0, 0.0, 0.0], [4.0, 2.0, 0.0])
    """
def contour(
    points: ArrayLike, bulges: ArrayLike | None = None, closed: bool = False, normal: ArrayLike = (0, 0, 1)
) -> NurbsCurve:
    """Make a contour of segments and arcs through points.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3).
    bulges : array_like, optional
        One number for each part: the tangent of a quarter of the angle of its arc, positive for
        counterclockwise ones, 0 for a segment, as in DXF files.
    closed : bool, default False
        Whether a last part returns to the first point.
    normal : array_like, default (0, 0, 1)
        Normal (3,) that arcs are seen against.

    Returns
    -------
    NurbsCurve
        The curve.

    Raises
    ------
    InvalidShape
        If counts disagree, points that follow each other coincide, or the normal is along the chord
        of an arc.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> stadium = sc.build.contour([(0, 0), (2, 0), (2, 2), (0, 2)], [0, 1, 0, 1], closed=True)
    >>> round(stadium.length() - 2 * np.pi, 9)
    4.0
    """
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
) -> NurbsCurve:
    """Make a helix about a curve, or a spiral.

    It turns evenly by the length of the curve, in rotation-minimizing frames.

    Parameters
    ----------
    axis : curve
        A curve of any kind.
    radius : float
        Radius at the start, 0 or more.
    turns : float
        Number of turns; left-handed where it is negative.
    end_radius : float, optional
        Radius at the end; by default the same.
    phase : float, default 0.0
        Angle at the start in radians, from the direction `start`.
    start : array_like, optional
        Direction (3,) of the angle 0; by default the normal of the curve.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    NurbsCurve
        The helix, by the same parameter as the axis.

    Raises
    ------
    InvalidShape
        If a radius is below 0, both are 0, the turns are 0 or more than 4096, or the axis is a point.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> axis = sc.BezierCurve([(0, 0, 0), (0, 0, 1)])
    >>> helix = sc.build.helix(axis, 1.0, 3, start=(1, 0, 0))
    >>> abs(helix.length() - ((6 * np.pi)**2 + 1)**0.5) < 1e-4
    True
    """
def curve_on_patch(
    patch: _Patch,
    image: _Curve,
    distance: float = 0.0,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> NurbsCurve:
    """Map a curve in the parameters of a patch to the patch, or to a distance from it.

    Parameters
    ----------
    patch : patch
        A patch of any kind.
    image : curve
        A curve of any kind in the plane: x is u, y is v. Beyond the domain it continues over the seam
        of a closed patch.
    distance : float, default 0.0
        How far from the patch along its normals.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the patch.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    NurbsCurve
        The curve by the same parameter as the image.

    Raises
    ------
    InvalidShape
        If the image leaves the domain, or the patch has no normal there and the distance is not 0.
    PointAtInfinity
        If the curve runs to infinity.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
    >>> meridian = sc.BezierCurve([(0.0, 0.0), (0.0, 2.0)])
    >>> round(sc.build.curve_on_patch(sphere, meridian).length() / np.pi, 6)
    1.0
    """
def join_curves(curves: Sequence[_Curve], tolerance: float) -> list[NurbsCurve]:
    """Join curves whose ends are near each other, the nearest first.

    Ends meet in their middle. The first curve of each chain keeps its direction; the others are turned as
    needed. Closed curves stay as they are.

    Parameters
    ----------
    curves : sequence of curves
        Curves of any kinds.
    tolerance : float
        The largest distance of two ends, a length.

    Returns
    -------
    list of NurbsCurve
        The joined curves.

    Raises
    ------
    InvalidShape
        If there is no curve, or the tolerance is below 0.

    Examples
    --------
    >>> curves = [sc.BezierCurve(ends) for ends in ([(0, 0), (1, 0)], [(1, 1), (1, 0)], [(5, 5), (6, 5)])]
    >>> [round(curve.length(), 9) for curve in sc.build.join_curves(curves, 1e-6)]
    [2.0, 1.0]
    """
def touching_circle(
    a: _Curve, b: _Curve, c: _Curve, parameters: ArrayLike, normal: ArrayLike = (0, 0, 1)
) -> tuple[NurbsCurve, NDArray[np.float64], float, tuple[float, float, float]]:
    """Find the circle that touches three plane curves near given places.

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind.
    c : curve
        A curve of any kind.
    parameters : array_like
        Parameters (3,), one of each curve, near where it touches.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of the plane.

    Returns
    -------
    tuple (NurbsCurve, numpy.ndarray, float, tuple (float, float, float))
        (arc from a through b to c, center (3,), radius, parameters).

    Raises
    ------
    InvalidShape
        If the places are on one line, or there is no such circle near them.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> lines = [sc.BezierCurve(ends) for ends in ([(0, 0), (3, 0)], [(3, 0), (0, 4)], [(0, 4), (0, 0)])]
    >>> arc, center, radius, _ = sc.build.touching_circle(*lines, (0.3, 0.5, 0.7))
    >>> center.round(9).tolist(), round(radius, 9)
    ([1.0, 1.0, 0.0], 1.0)
    """
def c2_pair(
    q0: ArrayLike,
    q1: ArrayLike,
    d: ArrayLike,
    r2: ArrayLike,
    r3: ArrayLike,
    a: float = 1.0,
    b: float = 1.0,
) -> tuple[BezierCurve, BezierCurve]:
    """Make two cubic Bezier curves that meet with C2 continuity.

    Parameters
    ----------
    q0 : array_like
        First point (2 or 3,) of the first curve.
    q1 : array_like
        Second point of the first curve.
    d : array_like
        Point where the inner legs of both meet.
    r2 : array_like
        Third point of the second curve.
    r3 : array_like
        Last point of the second curve.
    a : float, default 1.0
        Length of the interval of the first curve.
    b : float, default 1.0
        Length of the interval of the second curve.

    Returns
    -------
    tuple (BezierCurve, BezierCurve)
        Both curves.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S7.

    Examples
    --------
    >>> first, second = sc.build.c2_pair((0, 0), (0, 1), (1, 2), (2, 1), (2, 0))
    >>> first.continuity_to(second).c
    3
    """
def curve_from_formulas(
    formulas: Sequence[str | Formula],
    domain: ArrayLike,
    *,
    tolerance: float = 1e-6,
    variable: str = "t",
    constants: Mapping[str, float] | None = None,
) -> Approximation[NurbsCurve]:
    """Make a curve from formulas of its coordinates.

    Polynomials give one exact Bezier span; everything else C2 quintic pieces within the tolerance.

    Parameters
    ----------
    formulas : sequence of str or Formula
        x, y and perhaps z: texts, or formulas of one variable.
    domain : array_like
        First and last parameter (2,).
    tolerance : float, default 1e-06
        The largest error allowed, a length in units of the points.
    variable : str, default 't'
        Name of the variable in texts.
    constants : Mapping of str, optional
        Names and values of constants.

    Returns
    -------
    Approximation of NurbsCurve
        The curve by that parameter, and its error.

    Raises
    ------
    InvalidShape
        If a formula has no value at a parameter, or is not a formula.
    ToleranceNotReached
        At a jump or a pole.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> curve, error = sc.build.curve_from_formulas(["cos(t)", "sin(t)"], (0, 2 * np.pi))
    >>> abs(curve.length() - 2 * np.pi) < 1e-4
    True
    """
def patch_from_formulas(
    formulas: Sequence[str | Formula],
    domain_u: ArrayLike,
    domain_v: ArrayLike,
    *,
    tolerance: float = 1e-6,
    variables: Sequence[str] = ("u", "v"),
    constants: Mapping[str, float] | None = None,
) -> Approximation[NurbsPatch]:
    """Make a patch from formulas of its coordinates.

    Polynomials give one exact Bezier patch; everything else a C2 biquintic patch within the tolerance.

    Parameters
    ----------
    formulas : sequence of str or Formula
        x, y and z: texts, or formulas of two variables.
    domain_u : array_like
        First and last parameter (2,) in u.
    domain_v : array_like
        First and last parameter (2,) in v.
    tolerance : float, default 1e-06
        The largest error allowed, a length in units of the points.
    variables : sequence of strings, optional
        Names of both variables in texts.
    constants : Mapping of str, optional
        Names and values of constants.

    Returns
    -------
    Approximation of NurbsPatch
        The patch by those parameters, and its error.

    Raises
    ------
    InvalidShape
        If a formula has no value at a pair of parameters, or is not a formula.
    ToleranceNotReached
        At a jump, a pole, or a crease that does not follow u or v.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> saddle, error = sc.build.patch_from_formulas(["u", "v", "u * v"], (-1, 1), (-1, 1))
    >>> saddle.degree, error
    ((1, 1), 0.0)
    """
def plane(origin: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike) -> NurbsPatch:
    """Make a parallelogram origin + u axis_a + v axis_b.

    Parameters
    ----------
    origin : array_like
        Corner (3,).
    axis_a : array_like
        Side (3,) along u.
    axis_b : array_like
        Side (3,) along v.

    Returns
    -------
    NurbsPatch
        The patch over [0, 1] x [0, 1]; its normal is along axis_a x axis_b.

    Raises
    ------
    InvalidShape
        If the sides are zero or parallel.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> round(sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0)).area(), 9)
    6.0
    """
def cylinder(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    height: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Make the mantle of a cylinder.

    u is the longitude, counterclockwise about the axis, v in [0, 1] the height; normals point outwards.

    Parameters
    ----------
    center : array_like
        Center (3,) of the circle at the bottom.
    axis : array_like
        Direction (3,) of the axis.
    radius : float
        Radius, above 0.
    height : float
        Height, above 0.
    start : float, default 0.0
        Angle in radians at which the surface starts.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact patch of degree (2, 1).

    Raises
    ------
    InvalidShape
        If a length is not positive, the axis is zero, or the sweep is 0 or more than a turn.

    References
    ----------
    The NURBS Book, 8.3; lecture row S20.

    Examples
    --------
    >>> round(sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0).area() / np.pi, 9)
    4.0
    """
def cone(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    height: float,
    top_radius: float = 0.0,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Make the mantle of a cone, or of a truncated cone.

    Parameters and normals as of `cylinder`. A radius of 0 is a tip: the side is a pole.

    Parameters
    ----------
    center : array_like
        Center (3,) of the circle at the bottom.
    axis : array_like
        Direction (3,) of the axis.
    radius : float
        Radius at the bottom, 0 or more.
    height : float
        Height, above 0.
    top_radius : float, default 0.0
        Radius at the top, 0 or more.
    start : float, default 0.0
        Angle in radians at which the surface starts.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact patch of degree (2, 1).

    Raises
    ------
    InvalidShape
        If both radii are 0, and as of `cylinder`.

    References
    ----------
    The NURBS Book, 8.5; lecture row S20.

    Examples
    --------
    >>> cone = sc.build.cone((0, 0, 0), (0, 0, 1), 3.0, 4.0)
    >>> round(cone.area() / np.pi, 9)
    15.0
    """
def disc(
    center: ArrayLike,
    axis: ArrayLike,
    radius: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Make a flat disc.

    u is the angle, v runs from the rim to the center, which is a pole. Its rim is that of a cylinder or
    cone about the same axis.

    Parameters
    ----------
    center : array_like
        Center (3,).
    axis : array_like
        Normal (3,).
    radius : float
        Radius, above 0.
    start : float, default 0.0
        Angle in radians at which the surface starts.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact patch of degree (2, 1).

    Raises
    ------
    InvalidShape
        As of `cylinder`.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> round(sc.build.disc((0, 0, 0), (0, 0, 1), 2.0).area() / np.pi, 9)
    4.0
    """
def sphere(
    center: ArrayLike,
    radius: float,
    axis: ArrayLike = (0.0, 0.0, 1.0),
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Make a sphere.

    u is the longitude, v in [0, 2] the latitude from south to north; both sides in v are poles. Normals
    point outwards.

    Parameters
    ----------
    center : array_like
        Center (3,).
    radius : float
        Radius, above 0.
    axis : array_like, default (0.0, 0.0, 1.0)
        Direction (3,) of the axis.
    start : float, default 0.0
        Angle in radians at which the surface starts.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact patch of degree (2, 2).

    Raises
    ------
    InvalidShape
        If the radius is not positive, the axis is zero, or the sweep is 0 or more than a turn.

    References
    ----------
    The NURBS Book, 8.5; lecture row S20.

    Examples
    --------
    >>> sphere = sc.build.sphere((0, 0, 0), 1.0)
    >>> sphere.degree, sphere.periodic
    ((2, 2), (True, False))
    """
def torus(
    center: ArrayLike,
    axis: ArrayLike,
    ring_radius: float,
    tube_radius: float,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Make a torus.

    u is the longitude; v goes around the tube from the outer equator upwards. Normals point outwards.

    Parameters
    ----------
    center : array_like
        Center (3,).
    axis : array_like
        Direction (3,) of the axis.
    ring_radius : float
        Radius of the circle in the middle of the tube.
    tube_radius : float
        Radius of the tube.
    start : float, default 0.0
        Angle in radians at which the surface starts.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact patch of degree (2, 2), periodic in v and for a whole turn in u.

    Raises
    ------
    InvalidShape
        If a radius is not positive, the axis is zero, or the sweep is 0 or more than a turn.

    References
    ----------
    The NURBS Book, 8.5; lecture row S20.

    Examples
    --------
    >>> torus = sc.build.torus((0, 0, 0), (0, 0, 1), 2.0, 1.0)
    >>> round(torus.area() / np.pi**2, 9)
    8.0
    """
def revolve(
    curve: _Curve,
    axis_point: ArrayLike,
    axis_direction: ArrayLike,
    start: float = 0.0,
    sweep: float | None = None,
) -> NurbsPatch:
    """Revolve a curve about an axis.

    u runs about the axis, v along the curve on its knots. Normals point away from the axis where the
    curve runs in its direction. Control points on the axis make poles.

    Parameters
    ----------
    curve : curve
        A curve of any kind.
    axis_point : array_like
        Point (3,) of the axis.
    axis_direction : array_like
        Direction (3,) of the axis.
    start : float, default 0.0
        Angle in radians at which the surface starts; 0 is the curve itself.
    sweep : float, optional
        Angle in radians that the surface covers, at most a whole turn; a negative one runs clockwise
        and turns the normals over. None is a whole turn, periodic in u.

    Returns
    -------
    NurbsPatch
        The exact surface.

    Raises
    ------
    InvalidShape
        If the axis is zero, the sweep is 0 or more than a turn, or the curve lies on the axis.

    References
    ----------
    The NURBS Book, A8.1; lecture row S20.

    Examples
    --------
    >>> line = sc.BezierCurve([(1, 0, 0), (1, 0, 2)])
    >>> cylinder = sc.build.revolve(line, (0, 0, 0), (0, 0, 1))
    >>> round(cylinder.area() / np.pi, 9)
    4.0
    """
def extrude(curve: _Curve, vector: ArrayLike) -> NurbsPatch:
    """Extrude a curve along a vector.

    u is the parameter of the curve, v in [0, 1] the share of the vector; normals point along C' x vector.

    Parameters
    ----------
    curve : curve
        A curve of any kind.
    vector : array_like
        Vector (3,).

    Returns
    -------
    NurbsPatch
        The exact surface.

    Raises
    ------
    InvalidShape
        If the vector is zero.

    References
    ----------
    The NURBS Book, 8.3; lecture row S20.

    Examples
    --------
    >>> circle = sc.conics.circle((0, 0, 0), 1.0)
    >>> round(sc.build.extrude(circle, (0, 0, 1)).area() / np.pi, 9)
    2.0
    """
def fillets(
    a: _Curve, b: _Curve, radius: float, normal: ArrayLike = (0, 0, 1), *, cancel: Callable[[], object] | None = None
) -> list[tuple[NurbsCurve, float, float, bool, bool]]:
    """Find all arcs of a radius that touch two plane curves.

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind in the same plane.
    radius : float
        Radius of the arcs, above 0.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of the plane.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    list of tuple (NurbsCurve, float, float, bool, bool)
        (arc, parameter on a, parameter on b, whether a runs into the arc, whether the arc runs along
        b) in the order of a; an arc is no longer than half a turn.

    Raises
    ------
    InvalidShape
        If the curves are not in a plane with that normal, or it cannot be decided whether an arc
        touches both.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S18.

    Examples
    --------
    >>> a, b = sc.BezierCurve([(-4, 0), (4, 0)]), sc.BezierCurve([(0, -4), (0, 4)])
    >>> found = sc.build.fillets(a, b, 1.0)
    >>> len(found), round(found[0][0].length() / np.pi, 9)
    (4, 0.5)
    """
def ruled(a: _Curve, b: _Curve) -> NurbsPatch:
    """Connect two curves by segments.

    u lies in the domain of a, to which that of b is mapped; v goes from a to b in [0, 1].

    Parameters
    ----------
    a : curve
        A curve of any kind.
    b : curve
        A curve of any kind.

    Returns
    -------
    NurbsPatch
        The exact surface, periodic if both curves are.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    The NURBS Book, 8.4; lecture row S20.

    Examples
    --------
    >>> a = sc.BezierCurve([(0, 0, 0), (1, 0, 0)])
    >>> b = sc.BezierCurve([(0, 1, 0), (1, 1, 0)])
    >>> round(sc.build.ruled(a, b).area(), 12)
    1.0
    """
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
) -> LoftSurface:
    """Make a surface through sections.

    u runs along the sections, v from one to the next. At each end one of tangent, flat and neighbor may
    be given.

    Parameters
    ----------
    sections : sequence of curve or array_like
        Curves of any kinds; the first and the last one may be a point (3,), in which the surface
        closes.
    style : {'normal', 'tight', 'uniform', 'loose', 'straight'}, default 'normal'
        Parameters along v by distances ('normal'), their square roots ('tight') or even ones
        ('uniform'); sections as rows of control points ('loose'); segments between them ('straight').
    closed : bool, default False
        Whether the last section is followed by the first one.
    degree : int, default 3
        Degree along v.
    align : bool, default True
        Whether directions and seams of sections follow those of the section before.
    turned : sequence of bools, optional
        Whether each section runs the other way than that (n,).
    corners : {'free', 'matched'}, default 'free'
        'matched': where all sections have as many corners, these have the same parameters, and the
        surface an edge for each.
    weights : {'scaled', 'kept'}, default 'scaled'
        Whether the weights of each section are divided by their mean, or kept.
    tolerance : float, optional
        How far sections may be moved for fewer knots, a length; by default not at all.
    knot_distance : float, default 0.0
        Knots nearer to each other than this part of the domain become one.
    parameters : array_like, optional
        Increasing parameters (n,) along v.
    knots : array_like, optional
        All knots along v.
    start_tangent : array_like, optional
        Derivative (3,) along v at the start; length 1 is as fast as elsewhere.
    end_tangent : array_like, optional
        The same at the end.
    start_flat : array_like or tuple (array_like, float), optional
        Normal (3,) of the tangent plane in a point at the start, or (normal, speed).
    end_flat : array_like or tuple (array_like, float), optional
        The same at the end.
    start_neighbor : tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}) or tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}, float), optional
        (patch, side, 'G0' to 'G3') or with a strength; the side becomes one more section, which the
        surface continues.
    end_neighbor : tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}) or tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}, float), optional
        The same at the end.
    calm : bool, default True
        Whether neighbors are followed with less strength where the surface would swing out; otherwise
        that is refused.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    LoftSurface
        The surface, how far sections were moved, and the part of the strengths that was used.

    Raises
    ------
    InvalidShape
        If there are fewer than two sections (three where closed), an inner one is a point, or weights
        would not stay positive.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    The NURBS Book, 10.3; lecture row S20.

    Examples
    --------
    >>> circles = [sc.conics.circle((0, 0, z), r) for z, r in ((0, 1.0), (1, 0.6), (2, 1.0))]
    >>> vase, error = sc.build.loft(circles)
    >>> vase.periodic, error
    ((True, False), 0.0)
    """
def corner_counts(sections: Sequence[_Curve | ArrayLike], *, align: bool = True) -> list[int]:
    """Count the corners of sections as `loft` matches them.

    All breaks of the tangent if all sections have as many of these, else those of more than 0.02 radians.
    Where the numbers differ, none is matched.

    Parameters
    ----------
    sections : sequence of curve or array_like
        Curves of any kinds, or points (3,), which have no corner.
    align : bool, default True
        As of `loft`.

    Returns
    -------
    list of ints
        Numbers of corners.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    Examples
    --------
    >>> square = sc.build.contour([(0, 0), (2, 0), (2, 2), (0, 2)], closed=True)
    >>> sc.build.corner_counts([square, sc.conics.circle((1, 1, 3), 1.0)])
    [4, 0]
    """
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
) -> NurbsPatch:
    """Join a side of one patch to a side of another one by a smooth patch.

    u runs along the sides, v from a to b.

    Parameters
    ----------
    a : patch
        A patch of any kind.
    side_a : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of a.
    b : patch
        A patch of any kind.
    side_b : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of b.
    continuity : {'G0', 'G1', 'G2', 'G3'} or a pair of these, default 'G2'
        'G0' to 'G3', one for both ends or a pair.
    strengths : float or a pair of these, default 1.0
        How far the blend follows each patch, one for both or a pair.
    align : bool, default True
        Whether the side of b is reversed to run as that of a, and closed sides begin beside each
        other.
    calm : bool, default True
        Whether less strength is used where the blend would swing out; otherwise that is refused.

    Returns
    -------
    NurbsPatch
        The blend.

    Raises
    ------
    InvalidShape
        If a side is the seam of a periodic direction or lies at infinity, a patch has a zero
        derivative across its side, both sides coincide, or weights would not stay positive.
    ToleranceNotReached
        Where rounding leaves it off the tangent planes by more than 1e-4 radians, or off the
        curvatures by more than a thousandth of the largest.

    References
    ----------
    Lecture row S21.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> b = sc.build.plane((2, 0, 1), (1, 0, 0), (0, 1, 0))
    >>> blend = sc.build.blend_patches(a, "u_end", b, "u_start", "G1")
    >>> sc.seam_continuity(a, "u_end", blend, "v_start").g >= 1
    True
    """
def coons(
    sides: Sequence[_Curve],
    *,
    across: Sequence[_Curve | None] | None = None,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]:
    """Fill three or four boundary curves by a Coons patch.

    u runs along the first curve, v from there to the third one; of three curves the last side is a point.
    Weights of sides are multiplied so that they are 1 at both ends.

    Parameters
    ----------
    sides : sequence of curves
        Three or four curves of any kinds that form a loop, in any directions.
    across : sequence of curve or None, optional
        For each of four sides None, or a curve of vectors: the derivative across the side into the
        patch.
    tolerance : float, optional
        How far neighboring ends may lie apart, a length; by default 2^-30 of the size.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch, and how far an end, or a derivative, was moved.

    Raises
    ------
    InvalidShape
        If there are not three or four curves, one is closed or ends at infinity, or its end weights
        have different signs.
    ToleranceNotReached
        If ends lie farther apart, or a derivative at a corner is not that along the next side.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Coons 1967; Farin 2002, 22.3; lecture row S21.

    Examples
    --------
    >>> corners = [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)]
    >>> sides = [sc.BezierCurve([corners[i - 1], corners[i]]) for i in range(4)]
    >>> patch, error = sc.build.coons(sides)
    >>> patch.evaluate(0.5, 0.5).round(9)
    array([0.5 , 0.5 , 0.25])
    """
def network(
    along_u: Sequence[_Curve],
    along_v: Sequence[_Curve],
    *,
    neighbors: Sequence[_Neighbor] | None = None,
    tolerance: float | None = None,
    gap: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> NetworkSurface:
    """Make a surface through a network of curves.

    Each curve of one direction meets each of the other once, in any order and direction; parts beyond the
    outermost curves are cut off. Outermost curves keep their parameters, others are reparametrized within
    half the tolerance where they must be.

    Parameters
    ----------
    along_u : sequence of curves
        Curves of any kinds.
    along_v : sequence of curves
        Curves of any kinds.
    neighbors : sequence of tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}) or tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2', 'G3'}, float), optional
        (patch, side, 'G1') of patches that the surface continues over an outermost curve.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size.
    gap : float, optional
        How far curves may pass one another, a length; by default the tolerance.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    NetworkSurface
        The surface, the largest distance from a curve, and distances of its sides at equal shares of
        parameters.

    Raises
    ------
    InvalidShape
        If curves do not meet once and in order; the message names them and says how near they are.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Gordon 1969; lecture row S21.

    Examples
    --------
    >>> line = lambda a, b: sc.BezierCurve([a, b])
    >>> along_u = [line((0, y, 0), (2, y, 0)) for y in (0, 1)]
    >>> along_v = [line((x, 0, 0), (x, 1, 0)) for x in (0, 1, 2)]
    >>> surface, error = sc.build.network(along_u, along_v)
    >>> round(surface.area(), 9)
    2.0
    """
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
) -> Approximation[NurbsPatch]:
    """Move sections along a rail.

    Sections are given in the frame of the rail: x along its normal, y along its binormal, z along its
    tangent. u runs along the sections, v along the rail. Exact if the frame is parallel or the rail
    straight. Corners between straight stretches are mitered.

    Parameters
    ----------
    rail : curve
        A curve of any kind.
    sections : curve or sequence of curves
        A curve of any kind, or several.
    at : array_like, optional
        Parameters of the rail at which the sections are; by default even ones.
    frame : {'minimal', 'upright', 'parallel'}, default 'minimal'
        'minimal' frames turn no more than they must; in 'upright' ones y stays as near to `up` as it
        can; 'parallel' ones do not turn.
    up : array_like, default (0, 0, 1)
        Direction (3,) for upright frames.
    start : array_like, optional
        Direction (3,) of x at the start, for minimal frames.
    end_scale : float, default 1.0
        Factor by which sections have grown at the end.
    scales : array_like, optional
        Parameters of the rail and factors there (n, 2), without overshoot between them.
    twist : float, default 0.0
        Angle in radians by which sections have turned at the end.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the rail.
    scale : curve, optional
        A curve over the domain of the rail whose x is the factor there.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The surface, and the largest error that was found.

    Raises
    ------
    InvalidShape
        If there is no section, `at` does not increase or leaves the rail, the rail runs along `up`,
        turns back, or has a corner beside a curved stretch, or a scale is not positive.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    The NURBS Book, 10.4; lecture row S20.

    Examples
    --------
    >>> rail = sc.BezierCurve([(0, 0, 0), (0, 0, 3)])
    >>> tube, error = sc.build.sweep(rail, sc.conics.circle((0, 0, 0), 1.0))
    >>> round(tube.area() / np.pi, 6)
    6.0
    """
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
) -> Approximation[NurbsPatch]:
    """Move sections along two rails.

    Sections are given with x from the first rail to the second one, and stretched so that they stay
    between both. Rails are taken at equal parts of their domains. u runs along the sections, v by the
    parameter of the first rail.

    Parameters
    ----------
    rail : curve
        A curve of any kind.
    second : curve
        A curve of any kind that runs the same way.
    sections : curve or sequence of curves
        A curve of any kind, or several.
    at : array_like, optional
        Parameters of the first rail at which the sections are; by default even ones.
    height : {'scaled', 'kept'}, default 'scaled'
        Whether the height, along y and z, is scaled with the width, or kept.
    up : array_like, optional
        Direction (3,) that y stays near; by default it is at right angles to the rails.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the rails.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The surface, and the largest error, with the distance by which a section misses a rail.

    Raises
    ------
    InvalidShape
        If a section touches neither rail, the rails meet, have corners and there is no `up`, or run
        against each other; and as of `sweep`.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> rails = [sc.BezierCurve([(0, y, 0), (4, y, 0)]) for y in (0, 2)]
    >>> section = sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)])
    >>> surface, error = sc.build.sweep_two_rails(*rails, section)
    >>> surface.evaluate(0.0, 0.5).round(9).tolist(), surface.evaluate(1.0, 0.5).round(9).tolist()
    ([2.0, 0.0, 0.0], [2.0, 2.0, 0.0])
    """
def pipe(
    axis: _Curve,
    radius: float | ArrayLike,
    *,
    caps: Literal["none", "flat", "round"] = "none",
    tolerance: float | None = None,
    scale: _Curve | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]:
    """Make a pipe about a curve.

    Normals point outwards.

    Parameters
    ----------
    axis : curve
        A curve of any kind.
    radius : float or array_like
        A radius, or (n, 2): increasing parameters of the curve and radii there, without overshoot
        between them.
    caps : {'none', 'flat', 'round'}, default 'none'
        No caps, flat or round ones; a closed curve has none.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the curve.
    scale : curve, optional
        A curve over the domain of the axis whose x multiplies the radius.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of list of NurbsPatch
        The mantle and then the caps at start and end, and the largest error.

    Raises
    ------
    InvalidShape
        If a radius is not above 0, and as of `sweep`.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> axis = sc.BezierCurve([(0, 0, 0), (0, 0, 2)])
    >>> patches, error = sc.build.pipe(axis, 1.0, caps="flat")
    >>> round(sc.PatchSet.from_patches(patches).volume() / np.pi, 6)
    2.0
    """
def offset_patch(
    patch: _Patch,
    distance: float,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]:
    """Offset a patch along its normals.

    Planes, cylinders, cones, spheres and tori come out exactly, but for rounding.

    Parameters
    ----------
    patch : patch
        A patch of any kind.
    distance : float
        How far; to the other side where it is negative.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the patch.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch, and the largest error that was found.

    Raises
    ------
    InvalidShape
        If the patch has a crease, a gap or no normal somewhere, or bends with a radius that is not
        longer than the distance.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Farin 2002, 8; lecture row S20.

    Examples
    --------
    >>> outer, error = sc.build.offset_patch(sc.build.sphere((0, 0, 0), 1.0), 1.0)
    >>> round(outer.area() / np.pi, 6)
    16.0
    """
def thicken(
    patch: _Patch,
    start: float,
    end: float,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]:
    """Thicken a patch to a closed set.

    Patches next to each other have the same control points along their common side.

    Parameters
    ----------
    patch : patch
        A patch of any kind.
    start : float
        Distance of one offset; 0 is the patch itself.
    end : float
        Distance of the other offset.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size of the patch.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of list of NurbsPatch
        Both offsets and the surfaces between their sides, normals outwards, and the larger error.

    Raises
    ------
    InvalidShape
        If both distances are equal, and as of `offset_patch`.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0))
    >>> patches, error = sc.build.thicken(plane, 0.0, 0.5)
    >>> round(sc.PatchSet.from_patches(patches).volume(), 9)
    3.0
    """
def extend_patch(
    patch: _Patch, side: _Border, length: float, how: Literal["natural", "straight"] = "natural"
) -> NurbsPatch:
    """Extend a patch at a side.

    Parameters stay, the domain grows.

    Parameters
    ----------
    patch : patch
        A patch of any kind.
    side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side.
    length : float
        How far on average along the side, above 0.
    how : {'natural', 'straight'}, default 'natural'
        By the polynomials of the last span ('natural'), or along the tangents ('straight').

    Returns
    -------
    NurbsPatch
        The larger patch.

    Raises
    ------
    InvalidShape
        If the length is far longer or shorter than the patch, the direction is periodic, lines have a
        zero derivative at the side, or run to infinity before that length.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> plane = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0))
    >>> round(sc.build.extend_patch(plane, "u_end", 1.0).area(), 9)
    9.0
    """
def rail_frames(
    rail: _Curve,
    at: ArrayLike,
    *,
    frame: Literal["minimal", "upright", "parallel"] = "minimal",
    up: ArrayLike = (0, 0, 1),
    start: ArrayLike | None = None,
    cancel: Callable[[], object] | None = None,
) -> NDArray[np.float64]:
    """Find where `sweep` puts sections on a rail.

    Each matrix maps a section that is given in the frame of the rail to its place; its inverse maps a
    section that lies there to the frame. A closed rail is taken as `sweep` takes it: smoothly around, or
    from its first corner on.

    Parameters
    ----------
    rail : curve
        A curve of any kind.
    at : array_like
        Parameters (...,) of the rail.
    frame : {'minimal', 'upright', 'parallel'}, default 'minimal'
        As of `sweep`.
    up : array_like, default (0, 0, 1)
        Direction (3,) for upright frames.
    start : array_like, optional
        Direction (3,) of x at the start, for minimal frames.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    numpy.ndarray
        Matrices (..., 4, 4) whose columns are x, y, z of the frame and the point of the rail.

    Raises
    ------
    InvalidShape
        If a parameter lies outside, the rail is a point, or it runs along `up`.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> rail = sc.BezierCurve([(0, 0, 0), (0, 0, 3)])
    >>> sc.build.rail_frames(rail, 0.5)[:, 3]
    array([0. , 0. , 1.5, 1. ])
    """
def two_rail_frames(
    rail: _Curve,
    second: _Curve,
    at: ArrayLike,
    *,
    up: ArrayLike | None = None,
    cancel: Callable[[], object] | None = None,
) -> NDArray[np.float64]:
    """Find where `sweep_two_rails` puts sections between two rails.

    x of a frame has length 1 and points from the first rail to the second one, so that a section there
    reaches from 0 to their distance.

    Parameters
    ----------
    rail : curve
        A curve of any kind.
    second : curve
        A curve of any kind that runs the same way.
    at : array_like
        Parameters (...,) of the first rail; the second one is taken at the same part of its domain.
    up : array_like, optional
        Direction (3,) that y stays near; by default it is at right angles to the rails.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    numpy.ndarray
        Matrices (..., 4, 4) whose columns are x, y, z of the frame and the point of the first rail.

    Raises
    ------
    InvalidShape
        If a parameter lies outside, or the rails meet or run against each other there.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S20.

    Examples
    --------
    >>> rails = [sc.BezierCurve([(0, y, 0), (4, y, 0)]) for y in (0, 2)]
    >>> sc.build.two_rail_frames(*rails, 0.5)[:3, 0]
    array([0., 1., 0.])
    """
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
) -> Approximation[NurbsPatch]:
    """Change a patch so that it continues another one smoothly along a side.

    The first rows of control points follow from the derivatives of the other patch, at the speed with
    which they move least. Rows that may move follow evenly, the rest stays.

    Parameters
    ----------
    patch : patch
        The patch that changes, of any kind.
    side : {'u_start', 'u_end', 'v_start', 'v_end'}
        Its side.
    onto : patch
        The patch that stays.
    onto_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of that.
    continuity : {'G0', 'G1', 'G2', 'G3'}, default 'G1'
        The continuity wanted.
    rows : int, optional
        How many rows may move; by default all.
    strength : float, default 1.0
        Factor of the speed.
    reversed : bool, optional
        Whether the second side runs against the first one; by default as their ends lie nearer.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch over the same domain, and the largest distance by which a point moved.

    Raises
    ------
    InvalidShape
        If rows are too few, a patch has a zero derivative across its side, or that is the seam of a
        periodic direction.
    ToleranceNotReached
        Where rounding leaves it off the tangent planes by more than 1e-4 radians, or off the
        curvatures by more than a thousandth of the largest.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Farin 2002; lecture row S21.

    Examples
    --------
    >>> floor = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> wall = sc.build.plane((1, 0, 0), (0, 0, 1), (0, 1, 0)).elevate("u", 2)
    >>> matched, moved = sc.build.match_patch(wall, "u_start", floor, "u_end", "G1", rows=2)
    >>> matched.continuity_to("u_start", floor, "u_end").g
    1
    """
def fill(
    sides: Sequence[_Curve | tuple[_Patch, _Border, Literal["G0", "G1", "G2"]]],
    *,
    tolerance: float | None = None,
    angle: float = 1e-4,
    cancel: Callable[[], object] | None = None,
) -> Filling:
    """Fill a hole of three to eight sides, smoothly along neighbors.

    A hole with four corners is one patch; others are split from the middle of each side to a point. As
    few control points as reach tolerance and angle; the result says what was reached. Where neighbors do
    not share their tangent plane at a corner, the filling cannot continue both.

    Parameters
    ----------
    sides : sequence of curve or tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, {'G0', 'G1', 'G2'})
        Curves of any kinds, or neighbors (patch, side, 'G0' to 'G2'), one after the other in any
        directions.
    tolerance : float, optional
        The largest distance from a side, a length; by default 2^-20 of the size of the sides.
    angle : float, default 0.0001
        The largest angle between tangent planes, in radians.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Filling
        The patches, and how well they continue the sides.

    Raises
    ------
    InvalidShape
        If there are not 3 to 8 sides that form a loop, or the filling would fold.
    ToleranceNotReached
        If ends of sides lie apart, or the filling is too far from its sides; the message says how
        far.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Sarraga 1987; Greiner 1994; lecture row S21.

    Examples
    --------
    >>> corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    >>> sides = [sc.BezierCurve([corners[i - 1], corners[i]]) for i in range(4)]
    >>> filling = sc.build.fill(sides)
    >>> round(filling.patches[0].area(), 9)
    1.0
    """
def fill_rim(
    sides: Sequence[_Curve], *, cancel: Callable[[], object] | None = None
) -> Approximation[list[NurbsPatch]]:
    """Fill a plane rim of curves, with holes.

    A loop inside another one is a hole of it, and one inside that is filled again. u runs along a curve,
    on its control points, v from there straight to a point. Normals point to the side from which the
    first curve, or the widest loop, runs counterclockwise.

    Parameters
    ----------
    sides : sequence of curves
        Curves of any kinds that form one or several loops, in any directions.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of list of NurbsPatch
        The patches, and how far the curves are from a plane.

    Raises
    ------
    InvalidShape
        If the curves do not form a loop, a weight is not positive, or the rim crosses itself or a
        hole, or encloses nearly nothing.
    Cancelled
        If `cancel` returned true.

    Examples
    --------
    >>> patches, error = sc.build.fill_rim([sc.conics.circle((0, 0, 0), 1.0)])
    >>> round(sum(patch.area() for patch in patches) / np.pi, 6)
    1.0
    """
def open_ends(patches: Sequence[_Patch]) -> list[list[tuple[int, _Border]]]:
    """Find the open ends of patches.

    Parameters
    ----------
    patches : sequence of patches
        Patches of any kinds.

    Returns
    -------
    list of list of tuple (int, {'u_start', 'u_end', 'v_start', 'v_end'})
        For each end the sides (number of a patch, side) around it.

    Raises
    ------
    InvalidShape
        If a patch is in several pieces, more than two open sides end in one point, or one ends where
        no other does.

    Examples
    --------
    >>> tube = sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0)
    >>> sc.build.open_ends([tube])
    [[(0, 'v_start')], [(0, 'v_end')]]
    """
def cap(
    patches: Sequence[_Patch],
    ends: Sequence[Sequence[tuple[int, _Border]]] | None = None,
    *,
    cancel: Callable[[], object] | None = None,
) -> Approximation[list[NurbsPatch]]:
    """Close the open ends of patches.

    Caps have the control points of the sides that they close, so that the mesh of all has no open edges
    there. Normals of a closed result point outwards.

    Parameters
    ----------
    patches : sequence of patches
        Patches of any kinds.
    ends : sequence of sequence of tuple (int, {'u_start', 'u_end', 'v_start', 'v_end'}), optional
        Ends as of `open_ends`; by default all. An end may have sides of holes behind its first loop.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of list of NurbsPatch
        The patches and their caps, and how far rims are from planes.

    Raises
    ------
    InvalidShape
        As of `fill_rim`, or if a patch that has to be cut shares the side opposite to the end.
    Cancelled
        If `cancel` returned true.

    Examples
    --------
    >>> tube = sc.build.cylinder((0, 0, 0), (0, 0, 1), 1.0, 2.0)
    >>> patches, error = sc.build.cap([tube])
    >>> round(sc.PatchSet.from_patches(patches).volume() / np.pi, 6)
    2.0
    """
def fillet_patches(
    first: _Patch,
    first_side: _Border,
    second: _Patch,
    second_side: _Border,
    radius: float | ArrayLike,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> RoundedEdge:
    """Round the edge of two patches by a ball that rolls along it.

    All three share their sides: the same points on the same knots, for which patches gain some along the
    edge.

    Parameters
    ----------
    first : patch
        A patch of any kind.
    first_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the first patch.
    second : patch
        A patch of any kind.
    second_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the second patch.
    radius : float or array_like
        A radius, or (n, 2): parameters of the first patch along the edge and radii there, without
        overshoot between them.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    RoundedEdge
        The rest of both patches, the fillet and its error.

    Raises
    ------
    InvalidShape
        If the sides are not one edge, their tangent planes agree, or a radius is not above 0 or too
        large.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Rossignac and Requicha 1984; lecture row S21.

    Examples
    --------
    >>> floor = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0))
    >>> wall = sc.build.plane((0, 0, 0), (0, 3, 0), (0, 0, 2))
    >>> edge = sc.build.fillet_patches(floor, "u_start", wall, "v_start", 0.5)
    >>> round(edge.fillet.area(), 6), round(0.75 * np.pi, 6)
    (2.356194, 2.356194)
    """
def fillet_chain(
    edges: Sequence[tuple[_Patch, _Border, _Patch, _Border]],
    radius: float | ArrayLike,
    *,
    tolerance: float | None = None,
    cancel: Callable[[], object] | None = None,
) -> list[RoundedEdge]:
    """Round several edges that follow each other by one ball.

    Patches continue each other across the joints of the chain; a chain that ends where it begins is
    rounded all around. Patches and fillets share their sides along the chain and at its joints.

    Parameters
    ----------
    edges : sequence of tuple (patch, {'u_start', 'u_end', 'v_start', 'v_end'}, patch, {'u_start', 'u_end', 'v_start', 'v_end'})
        (first patch, side, second patch, side) of each edge.
    radius : float or array_like
        A radius, or (n, 2): k and a share of edge k, and radii there.
    tolerance : float, optional
        The largest error, a length; by default 2^-20 of the size.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    list of RoundedEdge
        For each edge the rest of both patches, the fillet and its error.

    Raises
    ------
    InvalidShape
        If edges do not follow each other, meet in a corner, or patches do not continue each other.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    Examples
    --------
    >>> floor = sc.build.plane((0, 0, 0), (2, 0, 0), (0, 3, 0))
    >>> wall = sc.build.plane((0, 0, 0), (0, 3, 0), (0, 0, 2))
    >>> edges = [(a, "u_start", b, "v_start") for a, b in zip(floor.split("v", 0.5), wall.split("u", 0.5))]
    >>> rounded = sc.build.fillet_chain(edges, 0.5)
    >>> round(sum(edge.fillet.area() for edge in rounded), 6), round(0.75 * np.pi, 6)
    (2.356194, 2.356194)
    """
def catmull_clark(
    points: ArrayLike, faces: Sequence[Sequence[SupportsIndex]], *, cancel: Callable[[], object] | None = None
) -> SubdivisionPatches:
    """Make the patches of a Catmull-Clark subdivision surface.

    The mesh is subdivided until all faces have four sides and at most one extraordinary point. Faces
    without one are exact bicubic patches; those with one are patches of degree 7 through its limit that
    meet in common tangent planes. Edges of one face converge to cubic splines, and corners of one face
    stay.

    Parameters
    ----------
    points : array_like
        Corners (n, 3).
    faces : sequence of sequence of ints
        Numbers of the corners of each face, counterclockwise seen from outside.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    SubdivisionPatches
        The patches, and how many of them are not exact.

    Raises
    ------
    InvalidShape
        If a face has fewer than three corners or one twice, an edge has more than two faces,
        neighboring faces have opposite orientations, or parts meet in a point alone.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Catmull and Clark 1978; lecture row S20.

    Examples
    --------
    >>> points = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> cube = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    >>> len(sc.build.catmull_clark(points, cube).patches)
    24
    """
def join_patches(
    first: _Patch,
    first_side: _Border,
    second: _Patch,
    second_side: _Border,
    continuity: _PatchSmoothness = "G1",
    moves: Literal["second", "first", "both"] = "second",
    reversed: bool | None = None,
) -> JoinedPatches:
    """Bring two patches together along a side of each.

    Domains and directions stay. Both get one degree and the same knots along the edge. The rows of points
    beside the edge move as little as the condition asks.

    Parameters
    ----------
    first : patch
        A patch of any kind.
    first_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the first patch.
    second : patch
        A patch of any kind.
    second_side : {'u_start', 'u_end', 'v_start', 'v_end'}
        The side of the second patch.
    continuity : {'C0', 'G1', 'C1', 'G2', 'C2'}, default 'G1'
        'C0' for a common edge, 'G1' for common tangent planes, 'C1' for equal first derivatives
        across, 'G2' for common curvatures, 'C2' for equal first two derivatives.
    moves : {'second', 'first', 'both'}, default 'second'
        Which patch moves.
    reversed : bool, optional
        Whether the second side runs against the first one; by default as their ends lie nearer.

    Returns
    -------
    JoinedPatches
        Both patches, and how far each moved.

    Raises
    ------
    InvalidShape
        If a side is one point, lies at infinity or is the seam of a periodic direction, or a patch
        leaves the edge in no direction.

    References
    ----------
    Farin 2002; Faux and Pratt 1979; lecture row S21.

    Examples
    --------
    >>> a = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> b = sc.build.plane((1.1, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> joined = sc.build.join_patches(a, "u_end", b, "u_start")
    >>> round(joined.second_error, 9), joined.first_error
    (0.1, 0.0)
    """
