"""What Blender interpolates along its splines from their points: radius, tilt and soft body weight.

Columns of numbers, one row for each point. A spline of Blender's own runs evenly from part 0 of it to part 1.
"""

import dataclasses

import numpy as np

from . import native, native_values

#: More entries of a matrix than this are not solved for.
_MOST = 4_000_000
#: How much less it counts that values stay where they are than that what they give fits.
_PULL = 1e-6
_TENSION = 0.71


def values_at(spline, values, fractions, ways=None):
    """(m, k): what k columns of values, (n, k), give at parts of a NativeSpline.

    ways: for each column how a Bezier spline interpolates it, as Blender names it; linearly where it is None.
    """
    if spline.kind == 'BEZIER':
        return along_bezier(values, spline.directions[0].flags.cyclic, fractions, ways or ['LINEAR'] * values.shape[1])
    columns = [_along_nurbs(spline, values[:, i:i + 3], fractions) for i in range(0, values.shape[1], 3)]
    return np.concatenate(columns, axis=1)


def _along_nurbs(spline, values, fractions):
    """values_at() of up to three columns: those of a curve with the weights of the spline."""
    points = np.zeros((len(values), 4))
    points[:, :values.shape[1]], points[:, 3] = values, spline.points[:, 3]
    curve, _ = native_values.curve_value(dataclasses.replace(spline, points=points), "")
    start, end = curve.domain
    found = curve.evaluate(np.clip(start + fractions * (end - start), start, end), at_infinity='nan')
    return found[:, :values.shape[1]]


def along_bezier(values, is_cyclic, fractions, ways):
    """values_at() of a Bezier spline."""
    rows = np.concatenate([values, values[:1]]) if is_cyclic else values
    count = len(rows) - 1
    segment = np.clip((fractions * count).astype(int), 0, count - 1)
    within = fractions * count - segment
    beside = [segment + i if is_cyclic else np.clip(segment + i, 0, count) for i in (-1, 0, 1, 2)]
    four = np.stack([rows[i % count if is_cyclic else i] for i in beside])
    found = np.stack([np.einsum('in,in->n', _WAYS[way](within), four[..., k]) for k, way in enumerate(ways)], axis=-1)
    # The last point of an open spline has what it has, even where the way there ends elsewhere.
    return found if is_cyclic else np.where((fractions >= 1.0)[:, None], values[-1], found)


def _linear(t):
    return np.stack([0 * t, 1 - t, t, 0 * t])


def _ease(t):
    return _linear(t * t * (3 - 2 * t))


def _cardinal(t):
    a, t2, t3 = _TENSION, t * t, t * t * t
    return np.stack([-a * t3 + 2 * a * t2 - a * t, (2 - a) * t3 + (a - 3) * t2 + 1,
                     (a - 2) * t3 + (3 - 2 * a) * t2 + a * t, a * t3 - a * t2])


def _b_spline(t):
    t2, t3 = t * t, t * t * t
    return np.stack([-t3 + 3 * t2 - 3 * t + 1, 3 * t3 - 6 * t2 + 4, -3 * t3 + 3 * t2 + 3 * t + 1, t3]) / 6


_WAYS = {'LINEAR': _linear, 'EASE': _ease, 'CARDINAL': _cardinal, 'BSPLINE': _b_spline}


def parts(spline):
    """(n,): at which part of a NativeSpline each of its points counts most, or so."""
    direction, = spline.directions
    if spline.kind == 'BEZIER' or not native.is_valid_curve(direction):
        return np.arange(direction.count) / (direction.count - (0 if direction.flags.cyclic else 1))
    start, end = native.domain(direction)
    knots, degree = native.all_knots(direction), direction.degree
    sums = np.cumsum(np.append(0.0, knots))
    middles = (sums[degree + 1:direction.count + degree + 1] - sums[1:direction.count + 1]) / degree
    fractions = (middles - start) / (end - start)
    return fractions % 1.0 if direction.flags.cyclic else np.clip(fractions, 0.0, 1.0)


def fitted(spline, first, fractions, values, ways):
    """(n, k): values of points that give `values`, (m, k), at parts of the spline, as nearly as can be; what they do not
    say is as `first`, (n, k), has it. ways: as of values_at()."""
    count = len(first)
    if len(fractions) * count > _MOST:
        return first
    if spline.kind != 'BEZIER':
        return nearest(values_at(spline, np.eye(count), fractions), first, values)
    return np.column_stack([each if way == 'LINEAR' else
                            nearest(values_at(spline, np.eye(count), fractions, [way] * count), each, wanted)
                            for each, wanted, way in zip(first.T, values.T, ways)])


def nearest(matrix, first, values):
    """What of the size of `first` a matrix (m, n) makes `values` of, as nearly as can be, and nearest to `first`."""
    missing = np.concatenate([values - matrix @ first, np.zeros_like(first)])
    return first + np.linalg.lstsq(np.concatenate([matrix, _PULL * np.eye(len(first))]), missing, rcond=None)[0]
