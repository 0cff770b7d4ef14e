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
) -> Approximation[NurbsCurve]:
    """Interpolate points by a polynomial curve.

    In time linear in the number of points.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length.
    degree : int, default 3
        Degree of the curve.
    parameters : {'uniform', 'centripetal', 'chordal'} or array_like or array_like, default 'calm'
        'calm' stays near the points however uneven their distances are; 'uniform', 'centripetal' and
        'chordal' take powers 0, 1/2 and 1 of the distances; or increasing numbers (n,), for a closed
        curve (n + 1,).
    knots : array_like, optional
        All knots, of a closed curve one period; by default as `ends` says.
    ends : {'parabola', 'chord', 'natural'}, default 'averaged'
        'averaged' knots are averages of parameters; 'not_a_knot' ones lie at the points but for those
        next to the ends; 'natural' ones lie at the points, with second derivatives that vanish at
        both ends (odd degrees).
    start : array_like, optional
        Derivatives 1, 2, … at the start (k, 2 or 3), or the first one (2 or 3,).
    end : array_like, optional
        The same at the end.
    tangents : array_like, optional
        First derivatives (n, 2 or 3) at the points, rows of NaN where there is none.
    closed : bool, default False
        Whether the curve is periodic.

    Returns
    -------
    Approximation of NurbsCurve
        The curve, and the distance from a point that rounding left.

    Raises
    ------
    InvalidShape
        If there are fewer points than the degree needs, points coincide that follow each other, or
        knots do not fit the points.

    References
    ----------
    The NURBS Book, 9.2; Lee 1989; Schoenberg and Whitney 1953; lecture row S17.

    Examples
    --------
    >>> curve, error = sc.fit.interpolate([(0, 0), (1, 1), (2, 0), (3, 1)])
    >>> curve.degree, len(curve.points), error < 1e-12
    (3, 4, True)
    """
def interpolate_patch(
    points: ArrayLike,
    degrees: SupportsIndex | tuple[SupportsIndex, SupportsIndex] = 3,
    parameters: _Parameterization | tuple[_Parameterization | ArrayLike, _Parameterization | ArrayLike] = "calm",
    knots: tuple[ArrayLike | None, ArrayLike | None] | None = None,
    ends: _Ends | tuple[_Ends, _Ends] = "averaged",
    closed: bool | tuple[bool, bool] = False,
    *,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsPatch]:
    """Interpolate a grid of points by a polynomial patch.

    In time linear in the number of points. Arguments are one value for both directions, or a pair for u
    and v.

    Parameters
    ----------
    points : array_like
        Grid (nu, nv, 2 or 3), in any unit of length.
    degrees : int or a pair of these, default 3
        Degrees in u and v.
    parameters : {'uniform', 'centripetal', 'chordal'} or array_like or tuple ({'uniform', 'centripetal', 'chordal'} or array_like or array_like, {'uniform', 'centripetal', 'chordal'} or array_like or array_like), default 'calm'
        As of `interpolate`; 'centripetal' and 'chordal' ones are averaged over the rows.
    knots : tuple (array_like or None, array_like or None), optional
        A pair of all knots, or of None; by default as `ends` says.
    ends : {'parabola', 'chord', 'natural'} or a pair of these, default 'averaged'
        As of `interpolate`.
    closed : bool or a pair of these, default False
        Whether the patch is periodic.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch, and the distance from a point that rounding left.

    Raises
    ------
    InvalidShape
        If there are fewer rows than the degree needs, two neighboring rows coincide, or knots do not
        fit.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    The NURBS Book, 9.2.5; lecture rows S17, S20.

    Examples
    --------
    >>> x, y = np.meshgrid(np.arange(4.0), np.arange(5.0), indexing="ij")
    >>> patch, error = sc.fit.interpolate_patch(np.stack([x, y, x * y], axis=-1))
    >>> patch.points.shape, error < 1e-12
    ((4, 5, 3), True)
    """
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
) -> Approximation[NurbsCurve]:
    """Approximate points by a polynomial curve with few control points.

    Least sum of squares, in time linear in the number of points. Give `count`, `knots`, `tolerance` or
    `residual`. With noisy points set `fixed_ends` to False: otherwise the curve begins and ends exactly
    at the first and last point, noise and all.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length.
    count : int, optional
        Number of control points; with a tolerance the most.
    degree : int, default 3
        Degree of the curve.
    parameters : {'uniform', 'centripetal', 'chordal'} or array_like or array_like, optional
        As of `interpolate`; by default 'chordal', with a tolerance 'calm' where a curve would swing.
    tolerance : float, optional
        The largest distance of a point from the curve, a length: knots are put where they are needed.
    knots : array_like, optional
        All knots, of a closed curve one period.
    weights : array_like, optional
        Positive weights (n,) of the squares.
    fixed_ends : bool, optional
        Whether an open curve begins at the first and ends at the last point; by default it does,
        except with a residual.
    start : array_like, optional
        Derivatives 1, 2, … at the start (k, 2 or 3), or the first one (2 or 3,).
    end : array_like, optional
        The same at the end.
    closed : bool, default False
        Whether the curve is periodic.
    smoothing : float, default 0.0
        Weight of the integral of the squared second derivative beside the sum of squares.
    corrections : int, default 0
        How often, while the error falls, parameters move towards the nearest points.
    residual : float, optional
        Largest weighted sum of squared distances: the calmest curve with no more, as `s` of SciPy.
        For noise of deviation d give n * d**2.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsCurve
        The curve, and the largest distance of a point from the curve's point at its parameter.

    Raises
    ------
    InvalidShape
        If the points do not determine the curve.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    The NURBS Book, 9.4; Reinsch 1967; Hoschek 1988; lecture row S17.

    Examples
    --------
    >>> t = np.linspace(0, np.pi, 100)
    >>> curve, error = sc.fit.approximate(np.stack([t, np.sin(t)], axis=1), tolerance=1e-3)
    >>> error <= 1e-3, len(curve.points) < 20
    (True, True)
    """
def project(
    function: Callable[[_Floats], ArrayLike],
    knots: ArrayLike,
    degree: SupportsIndex = 3,
    *,
    fixed_ends: bool = False,
    closed: bool = False,
    cancel: Callable[[], object] | None = None,
) -> Approximation[NurbsCurve]:
    """Project a function on splines with given knots.

    The integral of the difference times a basis function is zero. Integrals are taken on ever smaller
    parts of spans, so that kinks and jumps count; features narrower than 1/512 of a span may be missed.

    Parameters
    ----------
    function : callable
        A function that takes parameters (m,) and gives points (m, 2 or 3).
    knots : array_like
        All knots, of a closed curve one period.
    degree : int, default 3
        Degree of the curve.
    fixed_ends : bool, default False
        Whether the curve begins and ends where the function does; the knots are clamped then.
    closed : bool, default False
        Whether the curve is periodic.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsCurve
        The curve, and the largest distance that was found.

    Raises
    ------
    InvalidShape
        If a value is not finite, for noise, and for knots that belong to no curve.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Lecture row S17.

    Examples
    --------
    >>> line = lambda t: np.stack([t, 2 * t], axis=1)
    >>> curve, error = sc.fit.project(line, [0, 0, 1, 1], 1)
    >>> curve.evaluate(0.5).round(9), error < 1e-9
    (array([0.5, 1. , 0. ]), True)
    """
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
) -> Approximation[NurbsPatch]:
    """Approximate a grid of points by a polynomial patch with few control points.

    Least sum of squares first along u, then along v. Arguments are one value for both directions, or a
    pair for u and v. Weights of single points are those of `approximate_scattered`.

    Parameters
    ----------
    points : array_like
        Grid (nu, nv, 2 or 3), in any unit of length.
    counts : int or tuple (int or None, int or None), optional
        Numbers of control points; with a tolerance the most.
    degrees : int or a pair of these, default 3
        Degrees in u and v.
    parameters : {'uniform', 'centripetal', 'chordal'} or array_like or tuple ({'uniform', 'centripetal', 'chordal'} or array_like or array_like, {'uniform', 'centripetal', 'chordal'} or array_like or array_like), optional
        As of `approximate` and `interpolate_patch`.
    tolerance : float, optional
        The largest distance of a point from the patch, a length.
    knots : tuple (array_like or None, array_like or None), optional
        A pair of all knots, or of None.
    weights : tuple (array_like or None, array_like or None), optional
        A pair of positive weights (nu,) and (nv,), or None: the square of a point weighs their
        product.
    fixed_ends : bool, default True
        Whether the corners stay.
    closed : bool or a pair of these, default False
        Whether the patch is periodic.
    smoothing : float or a pair of these, default 0.0
        Weight of the squared second derivatives beside the sum of squares.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch, and the largest distance of a point from the patch's point at its parameters.

    Raises
    ------
    InvalidShape
        If the points do not determine the patch; the message names the direction.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    The NURBS Book, 9.4.3; lecture rows S17, S20.

    Examples
    --------
    >>> x, y = np.meshgrid(np.linspace(0, 1, 20), np.linspace(0, 1, 30), indexing="ij")
    >>> grid = np.stack([x, y, x**2 * y], axis=-1)
    >>> patch, error = sc.fit.approximate_patch(grid, (4, 4), parameters="uniform")
    >>> patch.points.shape, error < 1e-9
    ((4, 4, 3), True)
    """
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
) -> Approximation[NurbsPatch]:
    """Approximate scattered points by a polynomial patch.

    Least sum of squares at parameters that move to the nearest points of the patch.

    Parameters
    ----------
    points : array_like
        Points (n, 2 or 3), in any unit of length.
    counts : int or a pair of these, optional
        Numbers of control points, (u, v) or one for both; with a tolerance the most, 100 where none
        are given.
    degrees : int or a pair of these, default 3
        Degrees in u and v.
    parameters : array_like, optional
        Parameters (n, 2) to begin with; by default those of the nearest plane.
    tolerance : float, optional
        The largest distance of a point from the patch, a length.
    knots : tuple (array_like, array_like), optional
        A pair of all knots.
    weights : array_like, optional
        Positive weights (n,) of the squares.
    smoothing : float, default 0.0
        Weight of the energy of a thin plate beside the mean of the squares; it decides where there
        are no points.
    corrections : int, default 8
        How often at most parameters move, while that helps.
    cancel : callable, optional
        A function without arguments that is called now and then; a true result ends the call.

    Returns
    -------
    Approximation of NurbsPatch
        The patch, and the largest distance of a point from it.

    Raises
    ------
    InvalidShape
        If the points lie on a line, or do not determine a control point.
    ToleranceNotReached
        If the tolerance is not reached.
    Cancelled
        If `cancel` returned true.

    References
    ----------
    Hoschek 1988; Ma and Kruth 1995; lecture rows S17, S20.

    Examples
    --------
    >>> x, y = np.random.default_rng(1).random((2, 200))
    >>> patch, error = sc.fit.approximate_scattered(np.stack([x, y, x * y], axis=-1), 4)
    >>> patch.points.shape, error < 1e-3
    ((4, 4, 3), True)
    """
