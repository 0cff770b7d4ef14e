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
    """The conic a x² + b xy + c y² + d x + e y + f = 0 in the coordinates of a plane.

    Parameters
    ----------
    coefficients : array_like
        Coefficients (6,), a to f; a common factor changes nothing.
    origin : array_like, default (0, 0, 0)
        Point (3,) of the plane.
    x_axis : array_like, default (1, 0, 0)
        Unit vector (3,).
    y_axis : array_like, default (0, 1, 0)
        Unit vector (3,) at right angles to x_axis.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> conic = sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4])      # x² + 4 y² = 4
    >>> conic.type, conic.half_lengths
    ('ellipse', (2.0, 1.0))
    """

    def __init__(
        self,
        coefficients: ArrayLike,
        origin: ArrayLike = (0, 0, 0),
        x_axis: ArrayLike = (1, 0, 0),
        y_axis: ArrayLike = (0, 1, 0),
    ) -> None: ...
    @property
    def coefficients(self) -> _Floats:
        """Coefficients (6,) float64, as given, read-only.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]).coefficients
        array([ 1.,  0.,  4.,  0.,  0., -4.])
        """
    @property
    def origin(self) -> _Floats:
        """Origin (3,) of the plane.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]).origin
        array([0., 0., 0.])
        """
    @property
    def x_axis(self) -> _Floats:
        """First axis (3,) of the plane.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]).x_axis
        array([1., 0., 0.])
        """
    @property
    def y_axis(self) -> _Floats:
        """Second axis (3,) of the plane.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]).y_axis
        array([0., 1., 0.])
        """
    @property
    def type(self) -> _Type:
        """'circle', 'ellipse', 'parabola', 'hyperbola', 'crossing_lines', 'parallel_lines', 'line', 'point' or
        'empty'.

        Examples
        --------
        >>> sc.conics.ImplicitConic([0, 1, 0, 0, 0, -1]).type      # x y = 1
        'hyperbola'
        """
    @property
    def center(self) -> _Floats | None:
        """The center (3,), the vertex of a parabola, or a point of a line; None where the conic is empty.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 1, -2, 0, 0]).center      # (x - 1)² + y² = 1
        array([1., 0., 0.])
        """
    @property
    def half_lengths(self) -> tuple[float, float]:
        """Half lengths (along, across) of the axes; (focal length, 0) of a parabola; (0, half the distance) of
        parallel lines.

        Examples
        --------
        >>> sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]).half_lengths
        (2.0, 1.0)
        """
    @property
    def axes(self) -> tuple[_Floats, _Floats]:
        """Unit vectors along the major or transverse axis, or to the focus of a parabola, or along a line; and
        across.

        Examples
        --------
        >>> sc.conics.ImplicitConic([4, 0, 1, 0, 0, -4]).axes[0]      # longer along y
        array([0., 1., 0.])
        """
    @property
    def foci(self) -> list[_Floats]:
        """The foci (3,): two, one of a circle or a parabola, none where the conic is degenerate.

        Examples
        --------
        >>> [focus.round(9).tolist() for focus in sc.conics.ImplicitConic([9, 0, 25, 0, 0, -225]).foci]
        [[-4.0, 0.0, 0.0], [4.0, 0.0, 0.0]]
        """
    @property
    def eccentricity(self) -> float | None:
        """The eccentricity, 0 of a circle, 1 of a parabola; None where the conic is degenerate.

        Examples
        --------
        >>> round(sc.conics.ImplicitConic([9, 0, 25, 0, 0, -225]).eccentricity, 9)
        0.8
        """
    def arc(self, start: float, end: float) -> NurbsCurve:
        """Cut out the part between two parameters.

        Parameters are angles in radians from the axis; for a parabola distances from its axis; for a
        hyperbola t of (along cosh t, across sinh t).

        Parameters
        ----------
        start : float
            Where to begin.
        end : float
            Where to end.

        Returns
        -------
        NurbsCurve
            The part.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> circle = sc.conics.ImplicitConic([1, 0, 1, 0, 0, -1])
        >>> round(circle.arc(0.0, np.pi / 2).length() / np.pi, 9)
        0.5
        """
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
) -> NurbsCurve:
    """Make an arc of an ellipse.

    Parameters
    ----------
    center : array_like
        Center (3,).
    axis_a : array_like
        Half axis (3,) to the angle 0.
    axis_b : array_like
        Half axis (3,) to the angle pi / 2.
    start : float
        Angle in radians.
    sweep : float
        Angle in radians; negative ones run backwards.
    span_count : int, default 0
        Number of spans; 0 for as few as keep each within a quarter turn.

    Returns
    -------
    NurbsCurve
        The exact arc.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.arc((0, 0, 0), (1, 0, 0), (0, 1, 0), 0.0, np.pi / 2)
    >>> round(arc.length(), 9)
    1.570796327
    """
def arc_about(
    center: ArrayLike, start: ArrayLike, end: ArrayLike, normal: ArrayLike = (0, 0, 1)
) -> NurbsCurve:
    """Make an arc of a circle about a center, counterclockwise seen against the normal.

    Parameters
    ----------
    center : array_like
        Center (3,).
    start : array_like
        Point (3,) where the arc begins.
    end : array_like
        Point (3,) in whose direction it ends; a whole circle where that is the direction of the
        start.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of its plane.

    Returns
    -------
    NurbsCurve
        The exact arc.

    Raises
    ------
    InvalidShape
        If a point is the center, or the normal is zero or along the radius.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.arc_about((0, 0, 0), (2, 0, 0), (0, 5, 0))
    >>> round(arc.length() / np.pi, 9)
    1.0
    """
def arc_from_tangent(start: ArrayLike, tangent: ArrayLike, end: ArrayLike) -> NurbsCurve:
    """Make the arc of a circle from a point in a direction to another point.

    Parameters
    ----------
    start : array_like
        Point (3,).
    tangent : array_like
        Direction (3,) at the start.
    end : array_like
        Point (3,).

    Returns
    -------
    NurbsCurve
        The exact arc.

    Raises
    ------
    InvalidShape
        If the points coincide, or the direction is zero or along the line of both.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.arc_from_tangent((1, 0, 0), (0, 1, 0), (-1, 0, 0))
    >>> round(arc.length() / np.pi, 9)
    1.0
    """
def arc_through(start: ArrayLike, through: ArrayLike, end: ArrayLike) -> NurbsCurve:
    """Make the arc of a circle through three points.

    Parameters
    ----------
    start : array_like
        Point (3,) where it begins.
    through : array_like
        Point (3,) that it passes.
    end : array_like
        Point (3,) where it ends.

    Returns
    -------
    NurbsCurve
        The exact arc.

    Raises
    ------
    InvalidShape
        If two points coincide or all lie on a line.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.arc_through((1, 0, 0), (0, 1, 0), (-1, 0, 0))
    >>> round(arc.length() / np.pi, 9)
    1.0
    """
def as_hermite(curve: BezierCurve | NurbsCurve, tolerance: float) -> Approximation[HermiteCurve]:
    """Approximate a finite curve of degree 2 by cubics with tangents.

    Parameters
    ----------
    curve : BezierCurve or NurbsCurve
        A curve of degree 2.
    tolerance : float
        The largest distance, a length.

    Returns
    -------
    Approximation of HermiteCurve
        The chain and its error.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.
    ToleranceNotReached
        Where only rounding is left.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.arc((0, 0, 0), (1, 0, 0), (0, 1, 0), 0.0, np.pi / 2)
    >>> chain, error = sc.conics.as_hermite(arc, 1e-4)
    >>> chain.degree, error <= 1e-4
    (3, True)
    """
def by_foci(
    focus_1: ArrayLike, focus_2: ArrayLike, distance: float, normal: ArrayLike = (0, 0, 1)
) -> ImplicitConic:
    """Make the conic with two foci.

    An ellipse where the distance is more than that of the foci, otherwise a hyperbola.

    Parameters
    ----------
    focus_1 : array_like
        Point (3,).
    focus_2 : array_like
        Point (3,).
    distance : float
        Sum, or difference, of the distances from both foci.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of the plane where the foci coincide.

    Returns
    -------
    ImplicitConic
        The conic.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> sc.conics.by_foci((-1, 0, 0), (1, 0, 0), 4.0).type
    'ellipse'
    """
def circle(center: ArrayLike, radius: float, normal: ArrayLike = (0, 0, 1), form: _Form = "square") -> NurbsCurve:
    """Make a circle.

    Parameters
    ----------
    center : array_like
        Center (3,).
    radius : float
        Radius, above 0.
    normal : array_like, default (0, 0, 1)
        Normal (3,) of its plane.
    form : {'square', 'triangle', 'halves', 'single'}, default 'square'
        Four quarters, three thirds, two halves with directions in the middle, or a single span of
        degree 5.

    Returns
    -------
    NurbsCurve
        The exact circle.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Chou 1995; lecture row S10.

    Examples
    --------
    >>> circle = sc.conics.circle((0, 0, 0), 2.0)
    >>> round(circle.length() / np.pi, 9)
    4.0
    """
def class_of(curve: BezierCurve | NurbsCurve) -> _Class:
    """Classify a rational quadratic curve of one span.

    Parameters
    ----------
    curve : BezierCurve or NurbsCurve
        A curve of degree 2 and one span.

    Returns
    -------
    {'shorter_ellipse_arc', 'half_ellipse', 'longer_ellipse_arc', 'parabola_arc', 'two_parabola_arcs', 'hyperbola_arc', 'two_hyperbola_arcs', 'three_hyperbola_arcs', 'segment', 'line_through_infinity', 'point'}
        The class.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> sc.conics.class_of(sc.BezierCurve([(0, 0), (1, 2), (2, 0)]))
    'parabola_arc'
    """
def conic_arc(p0: ArrayLike, p1: ArrayLike, p2: ArrayLike, w1: float) -> BezierCurve:
    """Make the Bezier curve of three points with weights 1, w1, 1.

    Parameters
    ----------
    p0 : array_like
        Point (3,) where it begins.
    p1 : array_like
        Point (3,) where the tangents meet.
    p2 : array_like
        Point (3,) where it ends.
    w1 : float
        Weight of p1; 0 makes a segment.

    Returns
    -------
    BezierCurve
        The curve.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> arc = sc.conics.conic_arc((1, 0, 0), (1, 1, 0), (0, 1, 0), 0.5**0.5)
    >>> sc.conics.class_of(arc), round(arc.length() / np.pi, 9)
    ('shorter_ellipse_arc', 0.5)
    """
def ellipse(center: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike, form: _Form = "square") -> NurbsCurve:
    """Make an ellipse from any two conjugate half axes.

    Parameters
    ----------
    center : array_like
        Center (3,).
    axis_a : array_like
        Half axis (3,).
    axis_b : array_like
        Half axis (3,).
    form : {'square', 'triangle', 'halves', 'single'}, default 'square'
        As of `circle`.

    Returns
    -------
    NurbsCurve
        The exact ellipse.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> ellipse = sc.conics.ellipse((0, 0, 0), (2, 0, 0), (0, 1, 0))
    >>> round(ellipse.signed_area() / np.pi, 9)
    2.0
    """
def from_implicit(conic: ImplicitConic) -> list[NurbsCurve]:
    """Cover the real points of a conic by curves, each point once.

    Curves that are not closed begin and end at infinity: `finite_arcs` clips them.

    Parameters
    ----------
    conic : ImplicitConic
        The conic.

    Returns
    -------
    list of NurbsCurve
        The curves; none for a point or an empty conic.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> ellipse, = sc.conics.from_implicit(sc.conics.ImplicitConic([1, 0, 4, 0, 0, -4]))
    >>> round(abs(ellipse.signed_area()) / np.pi, 9)
    2.0
    """
def hyperbola(center: ArrayLike, axis_a: ArrayLike, axis_b: ArrayLike) -> list[NurbsCurve]:
    """Make both branches of a hyperbola from any two conjugate half axes.

    Parameters
    ----------
    center : array_like
        Center (3,).
    axis_a : array_like
        Half axis (3,) to a vertex.
    axis_b : array_like
        Conjugate half axis (3,).

    Returns
    -------
    list of NurbsCurve
        Both branches, each from the direction of one asymptote to that of the other.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> right, left = sc.conics.hyperbola((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> right.evaluate(0.5).round(9).tolist()
    [1.0, 0.0, 0.0]
    """
def implicit(curve: BezierCurve | NurbsCurve) -> ImplicitConic:
    """Find the conic on which a curve lies.

    By products of control points where the curve has degree 2 and one span. Any other one lies on a conic
    if, up to rounding, 2 * degree + 1 points of each span do (Bezout).

    Parameters
    ----------
    curve : BezierCurve or NurbsCurve
        A curve of any kind.

    Returns
    -------
    ImplicitConic
        The conic, in the xy plane where every z is 0, otherwise in the plane of the curve.

    Raises
    ------
    InvalidShape
        If the curve lies on no conic, or on a line.

    References
    ----------
    Lecture row S1.

    Examples
    --------
    >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
    >>> sc.conics.implicit(arc).type, sc.conics.implicit(sc.conics.ellipse((0, 0, 0), (2, 0, 0), (0, 1, 0))).type
    ('circle', 'ellipse')
    """
def parabola(focus: ArrayLike, directrix_point: ArrayLike, directrix_direction: ArrayLike) -> ImplicitConic:
    """Make the conic of the points as far from a focus as from a line.

    Parameters
    ----------
    focus : array_like
        Point (3,).
    directrix_point : array_like
        Point (3,) of the line.
    directrix_direction : array_like
        Direction (3,) of the line.

    Returns
    -------
    ImplicitConic
        The conic.

    Raises
    ------
    InvalidShape
        If the focus lies on the line.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> sc.conics.parabola((0, 1, 0), (0, -1, 0), (1, 0, 0)).type
    'parabola'
    """
def through_points(points: ArrayLike, tolerance: float | None = None) -> ImplicitConic:
    """Make the conic through five points of a plane.

    Parameters
    ----------
    points : array_like
        Points (5, 2 or 3).
    tolerance : float, optional
        How far a point may lie off the plane, a length; by default 1e-9 of their extent.

    Returns
    -------
    ImplicitConic
        The conic.

    Raises
    ------
    InvalidShape
        If two points coincide, four lie on a line or one lies off the plane.

    References
    ----------
    Lecture row S10.

    Examples
    --------
    >>> sc.conics.through_points([(1, 0), (0, 1), (-1, 0), (0, -1), (0.6, 0.8)]).type
    'circle'
    """
