# matplotlib need not be there, and brings types from 3.8 on.
# pyright: reportMissingImports=false, reportUnknownParameterType=false, reportUnknownVariableType=false
# pyright: reportUnknownMemberType=false, reportMissingTypeStubs=false
from matplotlib.axes import Axes  # type: ignore[import-not-found,import-untyped,unused-ignore]

from . import BezierCurve, BezierPatch, HermiteCurve, HermitePatch, NurbsCurve, NurbsPatch, PatchSet, PowerCurve
from .basis import KnotVector

__all__ = ["basis_functions", "comb", "control_net", "control_polygon", "curve", "isocurves", "surface"]

_Curve = NurbsCurve | BezierCurve | HermiteCurve | PowerCurve
_Surface = NurbsPatch | BezierPatch | HermitePatch | PatchSet

def curve(curve: _Curve, axes: Axes | None = None, **style: object) -> Axes:
    """Draw a curve.

    Parameters
    ----------
    curve : curve
        The curve; where it runs to infinity it ends a little beyond its control points.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1])
    >>> axes = sc.plot.curve(arc, color="black")
    >>> axes = sc.plot.control_polygon(arc, axes)
    >>> len(axes.lines)
    2
    """
def control_polygon(curve: NurbsCurve | BezierCurve | HermiteCurve, axes: Axes | None = None, **style: object) -> Axes:
    """Draw the control polygon of a curve, and the handles of a Hermite chain.

    Parameters
    ----------
    curve : NurbsCurve, BezierCurve or HermiteCurve
        The curve; its polygon is broken at control points at infinity.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    InvalidShape
        If the curve is a PowerCurve, which has no control points.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.control_polygon(sc.BezierCurve([(0, 0), (1, 2), (2, 0)]), marker="s")
    >>> axes.lines[0].get_xydata().tolist()
    [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]
    """
def comb(curve: _Curve, axes: Axes | None = None, *, scale: float | None = None, count: int = 32, **style: object) -> Axes:
    """Draw the curvature of a curve as a comb: teeth away from the center of curvature, as long as it is large.

    Parameters
    ----------
    curve : curve
        The curve.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    scale : float, optional
        Length of a tooth where the curvature is 1; by default the longest tooth is a quarter of the curve's size.
    count : int, default 32
        Teeth in every span.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    InvalidShape
        If count is less than 1.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.comb(sc.conics.circle((0, 0), 2.0), scale=1.0)      # curvature 0.5
    >>> points = axes.lines[0].get_xydata()
    >>> round(float(np.nanmax(np.hypot(*points.T))), 6)
    2.5
    """
def basis_functions(knots: KnotVector, axes: Axes | None = None, **style: object) -> Axes:
    """Draw the basis functions of a knot vector, each in another color, and the knots as marks.

    Parameters
    ----------
    knots : KnotVector
        As of `NurbsCurve.knot_vector` or made by `basis.KnotVector`.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    InvalidShape
        If axes are of three dimensions.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.basis_functions(sc.basis.KnotVector(2, [0, 0, 0, 1, 2, 2, 2]))
    >>> len(axes.lines)                    # four functions, and the knots
    5
    """
def control_net(surface: _Surface, axes: Axes | None = None, **style: object) -> Axes:
    """Draw the control net of a patch, or of every patch of a set.

    Parameters
    ----------
    surface : patch or PatchSet
        The surface; a net is broken at control points at infinity.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.control_net(sc.build.plane((0, 0, 0), (2, 0, 0), (0, 1, 0)))
    >>> axes.name
    'rectilinear'
    """
def isocurves(surface: _Surface, axes: Axes | None = None, *, count: int = 8, **style: object) -> Axes:
    """Draw curves of constant u and of constant v, borders among them, on a patch or on every patch of a set.

    Parameters
    ----------
    surface : patch or PatchSet
        The surface.
    axes : matplotlib axes, optional
        Where to draw; new ones are made where none are given.
    count : int, default 8
        Strips between curves, along u and along v.
    **style : object
        As of matplotlib's `plot`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    InvalidShape
        If count is less than 1.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.isocurves(sc.build.sphere((0, 0, 0), 1.0), linewidth=0.5)
    >>> axes.name
    '3d'
    """
def surface(surface: _Surface, axes: Axes | None = None, *, resolution: int = 16, color: object = "C0",
            **style: object) -> Axes:
    """Draw a patch or a set of patches as a shaded surface.

    Parameters
    ----------
    surface : patch or PatchSet
        The surface.
    axes : matplotlib axes, optional
        Where to draw, of three dimensions; new ones are made where none are given.
    resolution : int, default 16
        Faces in every span along u and v.
    color : color, default 'C0'
        As matplotlib names it.
    **style : object
        As of matplotlib's `Poly3DCollection`.

    Returns
    -------
    matplotlib axes
        Those that were drawn into.

    Raises
    ------
    InvalidShape
        If axes are flat, or as of `meshes.mesh`.
    ImportError
        If matplotlib is not installed.

    Examples
    --------
    >>> axes = sc.plot.surface(sc.build.torus((0, 0, 0), (0, 0, 1), 2.0, 0.5), color="tab:green")
    >>> len(axes.collections)
    1
    """
