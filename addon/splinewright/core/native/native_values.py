"""Blender's splines as values of the same geometry that Blender draws, at Blender's parameters.

What cannot be held is named in words that follow "without": pairs of a value, or None, and such words.
"""

import numpy as np

from ..base.library import sc
from ..base.words import phrase
from . import native
from .native_refine import Axis, bezier_rows, homogeneous

#: What Blender ignores, of several and of one.
_POINTS = ("{count} points at the end of {name}, which Blender ignores", "{count} point at the end of {name}, which Blender ignores")
_ROWS = ("{count} rows along {axis} at the end of {name}, which Blender ignores",
         "{count} row along {axis} at the end of {name}, which Blender ignores")


def curve_value(spline, name):
    """The curve of a spline, or None, and what of it is left out, as fragments that name it by `name`."""
    direction, = spline.directions
    if not np.isfinite(spline.points).all():
        return None, [phrase("{name}, which has a point that is not finite", name=name)]
    if direction.count < 2:
        return None, [phrase("{name}, which is a single point", name=name)]
    if spline.kind == 'BEZIER':
        return _chain(spline.points, direction.flags.cyclic), []
    if spline.kind != 'NURBS' or not native.is_valid_curve(direction):
        return _polygon(spline.points[:, :3], direction.flags.cyclic), []
    axis, net, words = _axis_and_net(spline.points, direction, 0, name)
    net, lost = _without_weightless_places(net, name)
    if _has_gap([axis], net):
        return None, [phrase("{name}, whose weights of 0 leave a part without points", name=name)]
    return sc.NurbsCurve(axis.degree, axis.knots, net[:, :3], net[:, 3], periodic=axis.periodic), words + lost


def surface_value(spline, name):
    """curve_value() of a spline of a surface. Its faces look where Blender's do, so u is Blender's v."""
    if not np.isfinite(spline.points).all():
        return None, [phrase("{name}, which has a point that is not finite", name=name)]
    if spline.kind != 'NURBS' or min(spline.points.shape[:2]) < 2:
        return None, [phrase("{name}, which is a row of points and no surface", name=name)]
    if not all(map(native.is_valid_surface, spline.directions)):
        return None, [phrase("{name}, of which Blender draws nothing: its points do not fit its orders", name=name)]
    axes, net, words = [], spline.points, []
    for i, direction in enumerate(spline.directions):
        axis, net, dropped = _axis_and_net(net, direction, i, name)
        axes.append(axis)
        words += dropped
    net, lost = _without_weightless_places(net, name)
    if _has_gap(axes, net):
        return None, [phrase("{name}, whose weights of 0 leave a part without points", name=name)]
    patch = sc.NurbsPatch([axis.degree for axis in axes], [axis.knots for axis in axes], net[..., :3], net[..., 3],
                          periodic=[axis.periodic for axis in axes])
    return patch.swapped(), words + lost


def _chain(points, is_cyclic):
    """The cubics of a Bezier spline: a span is 1 long, so tangents are three times the handles."""
    tangents = np.stack([3 * (points[:, 1] - points[:, 0]), 3 * (points[:, 2] - points[:, 1])], axis=1)
    positions = points[:, 1]
    if is_cyclic:
        positions, tangents = np.concatenate([positions, positions[:1]]), np.concatenate([tangents, tangents[:1]])
    return sc.HermiteCurve(positions, tangents)


def _polygon(points, is_cyclic):
    numbers = np.arange(float(len(points)))
    if is_cyclic:
        return sc.NurbsCurve(1, [*numbers, len(points)], points, periodic=True)
    return sc.NurbsCurve(1, [0, *numbers, numbers[-1]], points)


def _axis_and_net(net, direction, i, name):
    """The axis i of a net, the net without the points that Blender ignores, and a word about those."""
    used = native.used_count(direction)
    if direction.flags.cyclic:
        return Axis(direction.degree, native.periodic_knots(direction), True), net, []
    axis = Axis(direction.degree, native.plain_knots(direction))
    if used == direction.count:
        return axis, net, []
    words = phrase(*(_POINTS if net.ndim == 2 else _ROWS), count=direction.count - used, axis='uv'[i], name=name)
    return axis, np.take(net, range(used), axis=i), [words]


def _without_weightless_places(net, name):
    """A weight of 0 takes a point out of Blender's sums; to us it would be a point at infinity."""
    weightless = net[..., 3] == 0
    if not weightless.any():
        return net, []
    net = net.copy()
    net[weightless] = 0
    return net, [phrase("the places of points of weight 0 in {name}, which draw nothing", name=name)]


def _has_gap(axes, net):
    """Whether all weights that count are 0 somewhere: Blender draws the origin there."""
    if (net[..., 3] != 0).all():
        return False
    rows = homogeneous(net[..., :3], net[..., 3])
    for i, axis in enumerate(axes):
        rows = np.moveaxis(rows, i, 0)
        made = bezier_rows(axis, rows.reshape(len(rows), -1), axis.joints)
        rows = np.moveaxis(made.reshape(-1, *rows.shape[1:]), 0, i)
    corners = rows[tuple(np.ix_(*(range(0, rows.shape[i], axis.degree) for i, axis in enumerate(axes))))]
    return bool((corners == 0).all(-1).any())
