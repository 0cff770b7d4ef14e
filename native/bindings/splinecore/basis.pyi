"""Knot vectors, basis functions and samples (lecture rows S14, S15)."""

from typing import Literal, SupportsIndex, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["KnotVector", "Samples", "bezier_matrix", "hermite_matrix", "uniform_matrix", "uniform_to_bezier"]

_Floats = NDArray[np.float64]

@final
class KnotVector:
    """A degree and its knots.

    Parameters
    ----------
    degree : int
        Degree, 0 to 255.
    knots : array_like
        Knots that do not decrease: n + degree + 1 for n control points; where periodic n + 1, one
        period.
    periodic : bool, default False
        Whether the knots are one period.

    Raises
    ------
    InvalidShape
        If a knot decreases, is not finite or has a multiplicity above degree + 1.

    References
    ----------
    The NURBS Book, chapter 2; lecture rows S14, S15.

    Examples
    --------
    >>> knots = sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2])
    >>> knots.count, knots.domain
    (4, (0.0, 2.0))
    """

    def __init__(self, degree: SupportsIndex, knots: ArrayLike, periodic: bool = False) -> None: ...
    @property
    def degree(self) -> int:
        """The degree.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2]).degree
        2
        """
    @property
    def periodic(self) -> bool:
        """Whether the knots are one period.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 1, 2, 3, 4], periodic=True).periodic
        True
        """
    @property
    def count(self) -> int:
        """Number of control points that belong to the knots.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 1, 2, 3, 4], periodic=True).count
        4
        """
    @property
    def knots(self) -> NDArray[np.float64]:
        """The knots as given, a read-only float64 array.

        Examples
        --------
        >>> sc.basis.KnotVector(1, [0, 0, 1, 2, 2]).knots
        array([0., 0., 1., 2., 2.])
        """
    @property
    def domain(self) -> tuple[float, float]:
        """First and last parameter (start, end) between which the functions add up to 1.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 1, 2, 3, 4, 5]).domain
        (2.0, 3.0)
        """
    @property
    def greville(self) -> NDArray[np.float64]:
        """Greville abscissae (count,): for each control point the mean of the `degree` knots that decide it; of
        periodic knots they may begin before the domain.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2]).greville
        array([0. , 0.5, 1.5, 2. ])
        """
    def span(self, u: ArrayLike, *, side: Literal["left", "right"] = "right") -> NDArray[np.int64]:
        """Find the span of each parameter.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain.
        side : {'left', 'right'}, default 'right'
            At a knot, the span to the right or to the left.

        Returns
        -------
        numpy.ndarray
            Index k (...,) int64 with knots[k] <= u < knots[k + 1], in the unrolled knots.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2]).span([0.5, 1.0])
        array([2, 3])
        """
    def functions(self, u: ArrayLike, *, side: Literal["left", "right"] = "right") -> NDArray[np.float64]:
        """Evaluate all basis functions.

        Parameters
        ----------
        u : array_like
            Parameters (...,) in the domain.
        side : {'left', 'right'}, default 'right'
            At a knot, the value from the right or from the left.

        Returns
        -------
        numpy.ndarray
            Values (..., count), which add up to 1.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        The NURBS Book, A2.2; lecture row S14.

        Examples
        --------
        >>> sc.basis.KnotVector(1, [0, 0, 1, 2, 2]).functions(0.25)
        array([0.75, 0.25, 0.  ])
        """
    def function(self, i: SupportsIndex, u: ArrayLike) -> NDArray[np.float64]:
        """Evaluate one basis function on the whole line.

        Spans are half-open, closed at the end of the domain.

        Parameters
        ----------
        i : int
            Number of the function.
        u : array_like
            Any parameters (...,).

        Returns
        -------
        numpy.ndarray
            Values (...,).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Cox 1972, de Boor 1972; lecture row S14.

        Examples
        --------
        >>> sc.basis.KnotVector(1, [0, 0, 1, 2, 2]).function(1, [0.5, 1.0, 1.5, 9.0])
        array([0.5, 1. , 0.5, 0. ])
        """
    def function_derivatives(self, i: SupportsIndex, u: ArrayLike, order: SupportsIndex) -> _Floats:
        """Evaluate one basis function and its derivatives on the whole line.

        Right-hand at a knot, left-hand at the end of the domain.

        Parameters
        ----------
        i : int
            Number of the function.
        u : array_like
            Any parameters (...,).
        order : int
            Highest order of derivatives, 0 or more.

        Returns
        -------
        numpy.ndarray
            Array (..., order + 1).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        The NURBS Book, eq. 2.10; lecture row S14.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 1, 1]).function_derivatives(1, 0.25, 2)      # 2u(1 - u)
        array([ 0.375,  1.   , -4.   ])
        """
    def triangle(self, u: float) -> list[tuple[NDArray[np.int64], _Floats, _Floats, _Floats]]:
        """All rows of the triangular scheme for the basis functions at a parameter.

        Each row has the functions that are not zero on the span of u. `values[j]` is `rising[j]` times the
        value of the same function in the row before plus `falling[j]` times that of the next function.
        Indices of a periodic vector are modulo count.

        Parameters
        ----------
        u : float
            A parameter.

        Returns
        -------
        list of tuple (numpy.ndarray, numpy.ndarray, numpy.ndarray, numpy.ndarray)
            (indices, values, rising, falling) for degrees 0, 1, …, degree.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        References
        ----------
        Lecture row S14.

        Examples
        --------
        >>> for indices, values, rising, falling in sc.basis.KnotVector(2, [0, 0, 0, 1, 1, 1]).triangle(0.5):
        ...     print(indices.tolist(), values.tolist())
        [2] [1.0]
        [1, 2] [0.5, 0.5]
        [0, 1, 2] [0.25, 0.5, 0.25]
        """
    @property
    def spans(self) -> NDArray[np.int32]:
        """Index of each span of positive length (m,), as `span` gives it.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 1, 2, 2, 2]).spans
        array([2, 4], dtype=int32)
        """
    def support(self, i: SupportsIndex) -> tuple[float, float]:
        """Find the smallest interval outside which a basis function is zero.

        Parameters
        ----------
        i : int
            Number of the function.

        Returns
        -------
        tuple (float, float)
            (start, end).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.basis.KnotVector(1, [0, 0, 1, 2, 2]).support(1)
        (0.0, 2.0)
        """
    def multiplicity(self, u: float) -> int:
        """Count how often a parameter occurs among the knots.

        Parameters
        ----------
        u : float
            A parameter.

        Returns
        -------
        int
            The multiplicity; 0 where it is not a knot.

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2]).multiplicity(0.0)
        3
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> KnotVector: ...
    def __deepcopy__(self, memo: object, /) -> KnotVector: ...

@final
class Samples:
    """Spans and weights for a batch of parameters, computed once and applied to any rows of numbers.

    Parameters
    ----------
    knots : KnotVector
        The knots.
    u : array_like
        Parameters (m,) in the domain.
    order : int, default 0
        Highest order of derivatives.
    side : {'left', 'right'}, default 'right'
        At a knot, the value from the right or from the left.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    Examples
    --------
    >>> knots = sc.basis.KnotVector(1, [0, 0, 1, 2, 2])
    >>> sc.basis.Samples(knots, [0.5, 1.5]).apply([10.0, 20.0, 40.0])
    array([15., 30.])
    """

    def __init__(
        self,
        knots: KnotVector,
        u: ArrayLike,
        order: SupportsIndex = 0,
        *,
        side: Literal["left", "right"] = "right",
    ) -> None: ...
    @property
    def first(self) -> NDArray[np.int64]:
        """The first control point (m,) int64 that each sample depends on.

        Examples
        --------
        >>> knots = sc.basis.KnotVector(1, [0, 0, 1, 2, 2])
        >>> sc.basis.Samples(knots, [0.5, 1.5]).first
        array([0, 1])
        """
    def weights(self, order: SupportsIndex = 0) -> NDArray[np.float64]:
        """Give the weights of control points first, first + 1, … modulo their count.

        Parameters
        ----------
        order : int, default 0
            Order of the derivative.

        Returns
        -------
        numpy.ndarray
            Weights (m, degree + 1).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> knots = sc.basis.KnotVector(1, [0, 0, 1, 2, 2])
        >>> sc.basis.Samples(knots, [0.25, 1.5]).weights().tolist()
        [[0.75, 0.25], [0.5, 0.5]]
        """
    def apply(self, values: ArrayLike, order: SupportsIndex = 0) -> NDArray[np.float64]:
        """Sum rows with the weights of each sample.

        Parameters
        ----------
        values : array_like
            Rows (count, ...), one for each control point.
        order : int, default 0
            Order of the derivative.

        Returns
        -------
        numpy.ndarray
            Sums (m, ...).

        Raises
        ------
        InvalidShape
            If an argument is not valid: the message names it, the first offending index and its value.

        Examples
        --------
        >>> knots = sc.basis.KnotVector(1, [0, 0, 1, 2, 2])
        >>> sc.basis.Samples(knots, [0.5, 1.5], 1).apply([10.0, 20.0, 40.0], 1)
        array([10., 20.])
        """
    def __len__(self) -> int: ...
    def __copy__(self) -> Samples: ...
    def __deepcopy__(self, memo: object, /) -> Samples: ...

def uniform_matrix(degree: SupportsIndex) -> _Floats:
    """Matrix of uniform B-splines: [t^degree … t 1] @ matrix @ points is a segment, t from 0 to 1.

    Parameters
    ----------
    degree : int
        0 to 18.

    Returns
    -------
    numpy.ndarray
        Matrix (degree + 1, degree + 1), right in the last digit.

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S13.

    Examples
    --------
    >>> (6 * sc.basis.uniform_matrix(3)).round(9)[-1].tolist()
    [1.0, 4.0, 1.0, 0.0]
    """
def uniform_to_bezier(degree: SupportsIndex) -> _Floats:
    """Matrix that converts a uniform B-spline segment: matrix @ points are its Bezier points.

    Parameters
    ----------
    degree : int
        0 to 18.

    Returns
    -------
    numpy.ndarray
        Matrix (degree + 1, degree + 1).

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S13.

    Examples
    --------
    >>> sc.basis.uniform_to_bezier(2).tolist()
    [[0.5, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.5, 0.5]]
    """
def bezier_matrix(degree: SupportsIndex) -> _Floats:
    """Matrix of Bernstein polynomials: [t^degree … t 1] @ matrix @ points is the Bezier curve.

    Parameters
    ----------
    degree : int
        0 to 33.

    Returns
    -------
    numpy.ndarray
        Integers (degree + 1, degree + 1).

    Raises
    ------
    InvalidShape
        If an argument is not valid: the message names it, the first offending index and its value.

    References
    ----------
    Lecture row S6.

    Examples
    --------
    >>> sc.basis.bezier_matrix(2).tolist()
    [[1.0, -2.0, 1.0], [-2.0, 2.0, 0.0], [1.0, 0.0, 0.0]]
    """
def hermite_matrix() -> _Floats:
    """Matrix of cubic Hermite curves: [t³ t² t 1] @ matrix @ (P1, R1, P4, R4) is the curve.

    Returns
    -------
    numpy.ndarray
        Matrix (4, 4).

    References
    ----------
    Lecture row S4.

    Examples
    --------
    >>> sc.basis.hermite_matrix()[0].tolist()
    [2.0, 1.0, -2.0, 1.0]
    """
