"""Pictures with matplotlib: pip install splinecore[plot].

    import splinecore as sc
    axes = sc.plot.curve(shape)          # makes a figure
    sc.plot.comb(shape, axes)            # draws into it
    axes.figure.savefig("shape.png")

Each function takes axes, or makes a figure with some, and returns them. What lies in the xy plane gets flat axes, all else those
of three dimensions; into flat axes it is drawn as seen along z. More arguments by name are those of matplotlib.
"""

import numpy as np

from . import _cubics, meshes
from ._splinecore import InvalidShape, PatchSet

__all__ = ["basis_functions", "comb", "control_net", "control_polygon", "curve", "isocurves", "surface"]

_STEPS, _NEARNESS = 12, 1e-4


def _new_axes(is_flat):
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("splinecore.plot needs matplotlib: pip install splinecore[plot]") from error
    figure = pyplot.figure(layout="constrained")
    return figure.add_subplot(projection=None if is_flat else "3d")


def _is_solid(axes):
    return axes.name == "3d"


def _draw(axes, points, style):
    """Polylines in rows with nan between them."""
    if axes is None:
        z = points[np.isfinite(points).all(axis=1), 2]
        axes = _new_axes(is_flat=not np.ptp(z) if len(z) else True)
    axes.plot(*points.T[:3 if _is_solid(axes) else 2], **style)
    _set_equal(axes)
    return axes


def _set_equal(axes):
    """One unit is as long along each axis, and the drawing fills the room."""
    if _is_solid(axes):
        sides = np.ptp([axes.get_xlim(), axes.get_ylim(), axes.get_zlim()], axis=1)
        axes.set_box_aspect(np.maximum(sides, 0.02 * sides.max()))
        _thin_out_ticks(axes, sides / sides.max())
    else:
        axes.set_aspect("equal")


def _thin_out_ticks(axes, parts):
    """A short axis has few numbers, which would lie on each other; ticks that a caller placed stay."""
    from matplotlib.ticker import AutoLocator
    for axis, part in zip((axes.xaxis, axes.yaxis, axes.zaxis), parts):
        if isinstance(axis.get_major_locator(), AutoLocator):
            axis.get_major_locator().set_params(nbins=max(2, round(8 * part)))


def _apart(rows):
    """Rows of points one after the other, nan between them."""
    gap = np.full((1, 3), np.nan)
    return np.concatenate([part for row in rows for part in (row, gap)] or [gap])[:-1]


def curve(curve, axes=None, **style):
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
    segments = _cubics.cubics(curve, nearness=_NEARNESS)
    rows = _cubics.sampled(segments, np.linspace(0, 1, _STEPS + 1))
    jumps = np.flatnonzero((segments[1:, 0] != segments[:-1, 3]).any(axis=1)) + 1
    chains = [np.concatenate([part[0, :1], *part[:, 1:]]) for part in np.split(rows, jumps) if len(part)]
    return _draw(axes, _apart(chains), {"color": "C0"} | style)


def control_polygon(curve, axes=None, **style):
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
    if not hasattr(curve, "points"):
        raise InvalidShape("a PowerCurve has no control points: to_bezier() has some")
    if hasattr(curve, "tangents"):
        segments = _cubics.cubics(curve)
        points = _apart([*segments[:, :2], *segments[:, 2:]])
    else:
        points = _cubics.control_polygon(curve)
    return _draw(axes, points, _NET | style)


_NET = {"color": "gray", "linewidth": 0.8, "marker": "o", "markersize": 3}


def comb(curve, axes=None, *, scale=None, count=32, **style):
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
    if count < 1:
        raise InvalidShape(f"count is {count}, at least 1 is expected")
    bounds = _cubics.bounds_of(curve)
    spans = [np.linspace(*span, count + 1) for span in zip(bounds, bounds[1:])]
    sides = [curve.derivatives(span[part], 2, side=side, at_infinity="nan")
             for span in spans for part, side in ((slice(-1), "right"), (slice(-1, None), "left"))]
    points, bend = _bends(np.concatenate(sides))
    longest = np.nanmax(np.linalg.norm(bend, axis=1), initial=0.0)
    if scale is None:
        scale = 0.25 * _cubics.size_of(points) / longest if longest else 1.0
    tips = points - scale * bend
    teeth = np.stack([points, tips, np.full_like(tips, np.nan)], axis=1).reshape(-1, 3)
    rows = np.split(tips, len(spans))
    return _draw(axes, np.concatenate([teeth, _apart(rows)]), {"color": "C1", "linewidth": 0.6} | style)


def _bends(derivatives):
    """Points and curvature vectors, without places where the curve stops or is at infinity: there they are nan."""
    points, first, second = derivatives.swapaxes(0, 1)
    with np.errstate(all="ignore"):
        speed = np.linalg.norm(first, axis=1, keepdims=True)
        along, second = first / speed, second / speed / speed
        bend = second - along * (along * second).sum(axis=1, keepdims=True)
    ok = np.isfinite(bend).all(axis=1, keepdims=True)
    return np.where(ok, points, np.nan), np.where(ok, bend, np.nan)


def basis_functions(knots, axes=None, **style):
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
    axes = _new_axes(is_flat=True) if axes is None else axes
    if _is_solid(axes):
        raise InvalidShape("functions are drawn into flat axes")
    inner = np.unique(knots.knots)
    start, end = knots.domain
    places = np.unique(np.concatenate([[start], inner[(inner > start) & (inner < end)], [end]]))
    spans = [np.linspace(*span, 4 * _STEPS) for span in zip(places, places[1:])]
    for i in range(knots.count):
        rows = [np.stack([u[:-1], knots.function(i, u[:-1])], axis=1) for u in spans]
        axes.plot(*np.concatenate([*rows, [[end, knots.function(i, end)]]]).T, **style)
    axes.plot(places, np.zeros_like(places), color=axes.spines["bottom"].get_edgecolor(), linestyle="", marker="|", markersize=8, clip_on=False)
    return axes


def _patches(surface):
    return list(surface) if isinstance(surface, PatchSet) else [surface]


def control_net(surface, axes=None, **style):
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
    rows = []
    for patch in _patches(surface):
        net = _cubics.finite_points(patch).reshape(np.shape(patch.points))
        rows += [*net, *net.swapaxes(0, 1)]
    return _draw(axes, _apart(rows), _NET | style)


def isocurves(surface, axes=None, *, count=8, **style):
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
    if count < 1:
        raise InvalidShape(f"count is {count}, at least 1 is expected")
    rows = []
    for patch in _patches(surface):
        for axis, domain in zip("uv", patch.domain):
            for at in np.linspace(*domain, count + 1):
                segments = _cubics.cubics(patch.isocurve(axis, at), nearness=_NEARNESS)
                rows.append(_cubics.sampled(segments, np.linspace(0, 1, _STEPS + 1)).reshape(-1, 3))
    return _draw(axes, _apart(rows), {"color": "C0", "linewidth": 0.8} | style)


def surface(surface, axes=None, *, resolution=16, color="C0", **style):
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
    axes = _new_axes(is_flat=False) if axes is None else axes
    if not _is_solid(axes):
        raise InvalidShape("a surface is drawn into axes of three dimensions, those with projection='3d'; isocurves are drawn into flat ones")
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    positions, normals, starts, vertices = meshes.mesh(surface, resolution=resolution)
    corners = np.split(positions[vertices].astype(float), starts[1:-1])
    toward = np.add.reduceat(normals.astype(float), starts[:-1])
    toward /= np.linalg.norm(toward, axis=1, keepdims=True).clip(1e-300)
    light = 0.45 + 0.55 * np.abs(toward @ _LIGHT)
    colors = np.outer(light, to_rgb(color))
    axes.add_collection3d(Poly3DCollection(corners, **{"facecolors": colors, "edgecolors": colors, "linewidths": 0.3} | style))
    axes.auto_scale_xyz(*positions.astype(float).T)
    _set_equal(axes)
    return axes


_LIGHT = np.array([0.36, -0.48, 0.8])
