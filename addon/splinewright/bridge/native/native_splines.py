"""Between Blender's splines and their numbers."""

from contextlib import contextmanager

import bpy
import numpy as np

from ...core.native.native import Direction, Flags, NativeSpline
from ...core.net import handles

_BEZIER_FIELDS = ('handle_left', 'co', 'handle_right')
#: The sine of an angle that is rounding.
_STRAIGHT = 1e-6
#: What Blender accepts.
MOST_RESOLUTION = 1024


def read(spline, is_surface):
    """The NativeSpline of a spline of a Curve data-block."""
    if spline.type == 'BEZIER':
        columns = [_column(spline.bezier_points, name, 3) for name in _BEZIER_FIELDS]
        points = np.stack(columns, axis=1)
    else:
        points = _column(spline.points, 'co', 4)
    if not is_surface:
        return NativeSpline(spline.type, points, (_direction(spline, 'u', len(points)),))
    counts = spline.point_count_u, spline.point_count_v
    if spline.type != 'BEZIER':
        points = points.reshape(*counts[::-1], 4).swapaxes(0, 1)
    return NativeSpline(spline.type, points, tuple(_direction(spline, *pair) for pair in zip('uv', counts)))


@contextmanager
def holder_of(data, like=None):
    """An object with this data and nothing else, in no scene: Blender evaluates it without modifiers,
    and with the choice of shape keys of the object `like`."""
    holder = bpy.data.objects.new(data.name, data)
    try:
        if like is not None:
            holder.show_only_shape_key = like.show_only_shape_key
            holder.active_shape_key_index = like.active_shape_key_index
        yield holder
    finally:
        bpy.data.objects.remove(holder)


def straight_segments(spline):
    """Of each segment of a Bezier spline: whether Blender draws it as one straight edge."""
    points = list(spline.bezier_points)
    ends = points[1:] + points[:1] if spline.use_cyclic_u else points[1:]
    return [start.handle_right_type == end.handle_left_type == 'VECTOR' for start, end in zip(points, ends)]


def _column(points, name, width):
    flat = np.empty(width * len(points), np.float32)
    points.foreach_get(name, flat)
    return flat.reshape(-1, width).astype(np.float64)


def _direction(spline, axis, count):
    flags = Flags(*(getattr(spline, f"use_{name}_{axis}") for name in Flags._fields))
    return Direction(count, getattr(spline, f"order_{axis}") - 1, flags)


def handle_letters(spline, is_merged=False):
    """The core.net.handles letters of a spline of 'BEZIER'. is_merged: the last point is the first one again."""
    pairs = [tuple(handles.LETTERS[name] for name in (point.handle_left_type, point.handle_right_type))
             for point in spline.bezier_points]
    if is_merged:
        pairs[0] = pairs[-1][0], pairs[0][1]
        pairs.pop()
    return "".join(letter for pair in pairs for letter in pair)


def append(data, native, resolution, letters=""):
    """Add a curve's spline to a Curve data-block. letters: of the types of its handles, where they are known."""
    spline = data.splines.new(native.kind)
    if native.kind == 'BEZIER':
        spline.bezier_points.add(len(native.points) - 1)
        for point, *pair in zip(spline.bezier_points, *_types(native, letters)):
            point.handle_left_type, point.handle_right_type = pair
        for name, column in zip(_BEZIER_FIELDS, np.swapaxes(native.points, 0, 1)):
            spline.bezier_points.foreach_set(name, single(column))
        spline.use_cyclic_u = native.directions[0].flags.cyclic
        spline.resolution_u = _possible(resolution)
    else:
        spline.points.add(len(native.points) - 1)
        fill(spline, native, (resolution,))
    spline.use_smooth = True
    return spline


def _types(native, letters):
    """What Blender calls the types of the handles before, and of those after the points."""
    if letters:
        letters = handles.true(native.points, letters, native.directions[0].flags.cyclic)
        return tuple([handles.NAMES[letter] for letter in letters[side::2]] for side in (0, 1))
    return (['ALIGNED' if is_smooth else 'FREE' for is_smooth in _smooth_joints(native.points)],) * 2


def _smooth_joints(points):
    """Of each point of a Bezier spline: whether its handles lie on one line, to Blender's precision."""
    into, out = points[:, 1] - points[:, 0], points[:, 2] - points[:, 1]
    lengths = np.linalg.norm(into, axis=1) * np.linalg.norm(out, axis=1)
    sines = np.linalg.norm(np.cross(into, out), axis=1)
    return (lengths > 0) & (sines <= _STRAIGHT * lengths) & ((into * out).sum(1) > 0)


def fill(spline, native, resolution):
    """Give a NURBS spline of as many points the numbers of another; resolution is one for each direction."""
    points = native.points if native.points.ndim == 2 else native.points.swapaxes(0, 1)
    spline.points.foreach_set('co', single(points))
    spline.points.foreach_set('radius', np.ones(len(spline.points), np.float32))
    for axis, direction, steps in zip('uv', native.directions, resolution):
        for name, is_on in direction.flags._asdict().items():
            setattr(spline, f"use_{name}_{axis}", is_on)
        setattr(spline, f"resolution_{axis}", _possible(steps))
        setattr(spline, f"order_{axis}", direction.degree + 1)      # last: Blender cuts it to what fits


def _possible(resolution):
    return min(max(int(resolution), 1), MOST_RESOLUTION)


def single(values):
    """Flat and float32, as Blender takes numbers fastest."""
    return np.ascontiguousarray(values, np.float32).ravel()
