"""What users put on the splines of a Curve: a Look, and along them radius, tilt and soft body weight."""

from typing import NamedTuple

import bpy
import numpy as np

from ..data import store
from ..data.shading import Look

#: Of each point, in the order of a Layer's columns, and what a new point has.
NAMES = ('radius', 'tilt', 'weight_softbody')
PLAIN = np.array([1.0, 0.0, 0.0], np.float32)
#: Of a spline: how radius and tilt are interpolated. Polylines have that, too, of no use to Blender.
_WAYS = ('radius_interpolation', 'tilt_interpolation')
#: On the Curve: the Layers that were given to other points than those that have them now.
KEY = "splinewright_layers"
#: On the Curve: the number of what lies along it; of bridge.net.along.
_NUMBER = "splinewright_along"


class Layers(NamedTuple):
    """What lies along a spline, between any two points of it a mixture of both."""

    look: Look
    at: np.ndarray                      # (n,) growing: 0 where the spline begins, 1 where it ends or closes
    values: np.ndarray                  # (n, 3) float32: NAMES
    ways: tuple = ('LINEAR', 'LINEAR')  # how radius and tilt go from joint to joint of a chain, as Blender names it

    def there(self, at):
        """(m, 3) float32: the values at other points."""
        return np.column_stack([np.interp(at, self.at, column) for column in self.values.T]).astype(np.float32)

    def distance(self, at):
        """How far a point of the spline lies outside of where these lie."""
        return max(self.at[0] - at, at - self.at[-1], 0.0)


def of(spline):
    """The Layers of a spline."""
    points = spline.bezier_points or spline.points
    values = np.empty((len(NAMES), len(points)), np.float32)
    for row, name in zip(values, NAMES):
        points.foreach_get(name, row)
    look, values = Look(spline.material_index, spline.use_smooth), values.T
    if spline.use_cyclic_u:
        values = np.concatenate([values, values[:1]])
    return Layers(look, np.linspace(0.0, 1.0, len(values)), values, tuple(getattr(spline, name) for name in _WAYS))


def fractions(count, closed):
    """Where a given number of points lie, for Layers.there(): evenly."""
    return np.linspace(0.0, 1.0, count + 1)[:-1] if closed else np.linspace(0.0, 1.0, count)


def write(spline, layers, values):
    """Give a spline what Layers have beside their values, and each of its points its values, (n, 3)."""
    spline.material_index, spline.use_smooth = layers.look
    for name, way in zip(_WAYS, layers.ways):
        setattr(spline, name, way)
    points = spline.bezier_points or spline.points
    for name, column in zip(NAMES, np.asarray(values, np.float32).T):
        points.foreach_set(name, np.ascontiguousarray(column))


def snapshot(data):
    """What put() takes."""
    group = data.get(KEY)
    return [of(spline) for spline in data.splines], group.to_dict() if store.is_group(group) else None


def put(data, taken):
    """Let a Curve of as many points have what it had at a snapshot()."""
    layers, note = taken
    for spline, each in zip(data.splines, layers):
        write(spline, each, each.values[:len(spline.points)])
    forget(data)
    if note is not None:
        store.assign(data, KEY, note)
    data.update_tag()


def kept(data):
    """The Layers of each spline: those that it was given, where it still has what they gave it."""
    present = [of(spline) for spline in data.splines]
    known = _remembered(data)
    if len(known) != len(present) or not all(_gives(was, now) for was, now in zip(known, present)):
        return present
    return [was._replace(look=now.look, ways=now.ways) for was, now in zip(known, present)]


def _gives(was, now):
    return np.array_equal(was.there(now.at), now.values)


def remember(data, layers):
    """Note what splines were given, so that many changes of how many points they have blur nothing."""
    if all((each.values == each.values[0]).all() for each in layers):
        forget(data)
        return
    store.assign(data, KEY, {'counts': np.array([len(each.at) for each in layers], np.int32),
                             'at': np.concatenate([each.at for each in layers]),
                             'values': np.concatenate([each.values for each in layers]).astype(np.float64).ravel()})


def number(data):
    """The number of what lies along a Curve, 0 where it was never given one."""
    found = data.get(_NUMBER)
    return found if type(found) is int and found > 0 else 0


def set_number(data, found):
    if found:
        data[_NUMBER] = found
    elif _NUMBER in data.keys():
        del data[_NUMBER]


def forget(data):
    if KEY in data.keys():
        del data[KEY]


def _remembered(data):
    """What remember() noted; [] where that is nothing, or damaged."""
    try:
        group = data[KEY]
        ends = np.cumsum(np.array(group['counts'], np.int64))
        at, values = np.array(group['at'], np.float64), np.array(group['values'], np.float64).astype(np.float32)
        parts = zip(np.split(at, ends), np.split(values.reshape(-1, len(NAMES)), ends))
        return [Layers(Look(), *part) for part in parts][:len(ends)] if len(at) == ends[-1] == len(values) // 3 else []
    except (KeyError, TypeError, ValueError, IndexError):
        return []


def thicken(data, radius):
    """Let a new Curve be a tube of a radius; 0: leave it a line. A Mesh stays as it is."""
    if radius and isinstance(data, bpy.types.Curve):
        data.bevel_depth, data.bevel_resolution = radius, 1
