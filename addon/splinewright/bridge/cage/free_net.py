"""Nets of recipes that take any number of points: Blender's own Edit Mode may add and remove them.

Where a point is in its spline says which it is. Its tilt is the number of the point it was made from.
"""

from dataclasses import replace

import bpy
import numpy as np

from ...core.net.exact_net import Spline
from ...core.net.free_net import digits, present
from ...core.net.reading import ChangedNet
from . import net_object

_FREE = 'any_count'


def set_free(data, is_closed):
    """Let a net's data-block that was just made gain and lose points; whether its shape is closed."""
    data[net_object.KEY][_FREE] = True
    set_closed(data, is_closed)


def set_closed(data, is_closed):
    """Show whether the shape of a net is closed."""
    for spline in data.splines:
        spline.use_cyclic_u = is_closed


def is_free(data):
    """Whether a net may have other points than it was made with."""
    return isinstance(data, bpy.types.Curve) and _FREE in net_object.stored(data).keys()


def numbers(data):
    """(n,) the numbers that the points carry, in the order of the splines."""
    return np.abs(_values(data, 'tilt', 1).ravel())     # switching the direction turns tilts over


def is_turned(data):
    """Whether the direction of the whole net was switched since it was made."""
    return bool(np.signbit(_values(data, 'tilt', 1)).all())


def read(data, made_with):
    """The Net of the points that are there in this moment. made_with: the Net that the data-block was made from.

    Splines of Blender's Bezier type count as empty.
    """
    rows = _values(data, 'co', 4)
    exact = digits(made_with, net_object.typed(data), numbers(data), rows[:, :3])
    splines = [Spline(spline.type, len(spline.points), spline.use_cyclic_u) for spline in data.splines]
    return present(made_with, exact, rows[:, 3], splines)


def without_copies(data, net):
    """The Net that read() gave without points that are copies in the same place, as a duplication that was called off
    leaves them; None where there are none."""
    seen, keep = set(), np.ones(len(net.rows), bool)
    for i, point in enumerate(zip(numbers(data).tolist(), map(tuple, net.positions.tolist()))):
        keep[i] = point not in seen
        seen.add(point)
    if keep.all():
        return None
    splines, first = [], 0
    for spline in net.splines:
        count = int(keep[first:first + spline.count].sum())
        first += spline.count
        if count:
            splines.append(replace(spline, count=count))
    return present(net, net.positions[keep], net.weights[keep], splines)


def require_one_polygon(net):
    """The only spline of a Net that was read. Raises ChangedNet where there is not one, of the type it had."""
    if not net.splines:
        raise ChangedNet("the net has no points left: undo that, the shape waits")
    if len(net.splines) > 1:
        raise ChangedNet("the net has {count} splines: join them (Make Segment) or delete all but one, the shape waits",
                         count=len(net.splines))
    if net.splines[0].kind != 'POLY':
        raise ChangedNet("the spline of the net has another type: undo that, the shape waits")
    return net.splines[0]


def editing(shape_data):
    """The data-block of the net of this kind that edits a shape, or None."""
    token = net_object.editor(shape_data)
    return next((data for data in bpy.data.curves
                 if net_object.KEY in data.keys() and net_object.token(data) == token and is_free(data)), None)


def _values(data, name, width):
    """(n, width) float32: an attribute of all points."""
    found = [np.empty(0, np.float32)]
    for spline in data.splines:
        found.append(np.empty(width * len(spline.points), np.float32))
        spline.points.foreach_get(name, found[-1])
    return np.concatenate(found).reshape(-1, width)
