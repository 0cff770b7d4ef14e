"""The net of curves as a Curve. Points are numbered by their tilt and marked by their radius, which show nothing here.

What can be selected has a slot: each point, and of a Bezier point its left handle, itself and its right handle, spline
by spline.
"""

import bpy
import numpy as np
from mathutils import Vector

from ...core.net import strays
from ...core.net.grown import STRAY, Run, copy_of
from ...core.net.reading import Present

#: The tilt of points that were passed over once for all: no number of a point reaches it.
_STRAY = np.float32(2 ** 24)
_HANDLES = ('handle_left', 'co', 'handle_right')
_FLAGS = ('select_left_handle', 'select_control_point', 'select_right_handle')


def make(name, net):
    """A new Curve that shows the net of curves, whose points carry the numbers from 0 on."""
    curve = bpy.data.curves.new(f"{name} Net", 'CURVE')
    curve.dimensions = '3D'
    first = number = 0
    seals = strays.seals(len(net.spline_points[0]))
    for part in net.splines:
        spline = curve.splines.new(part.kind)
        if part.kind == 'BEZIER':
            last = first + 3 * part.count
            _fill_bezier(spline, part, net.single[first:last].reshape(-1, 3, 3))
        else:
            last = first + part.count
            spline.points.add(part.count - 1)
            rows = np.column_stack([net.single[first:last], net.single_weights[first:last]])
            spline.points.foreach_set('co', rows.ravel())
        spline.use_cyclic_u = part.closed
        numbers = np.arange(number, number + part.count)
        _points_of(spline).foreach_set('tilt', numbers.astype(np.float32))
        _points_of(spline).foreach_set('radius', seals[numbers])
        first, number = last, number + part.count
    curve.update_tag()
    return curve


def _fill_bezier(spline, part, triples):
    spline.bezier_points.add(part.count - 1)
    for point, smooth in zip(spline.bezier_points, part.smooth):
        point.handle_left_type = point.handle_right_type = 'ALIGNED' if smooth else 'FREE'
    for i, name in enumerate(_HANDLES):
        spline.bezier_points.foreach_set(name, np.ascontiguousarray(triples[:, i]).ravel())


def _points_of(spline):
    return spline.bezier_points if spline.type == 'BEZIER' else spline.points


def present(curve, net):
    """The Present points and handles of a Curve that was made of a net."""
    seals = strays.seals(len(net.spline_points[0]), net.first)
    vertices = np.concatenate([np.empty(0, np.int64), *(_numbered(spline, net, seals) for spline in curve.splines)])
    rows = np.concatenate([np.empty((0, 4), np.float32), *map(_rows, curve.splines)])
    return Present(vertices, lambda: rows[:, :3], lambda: rows[:, 3], lambda: _links(curve), _void(curve, vertices))


def _void(curve, vertices):
    """(m,) bool: handles that lead to points that are new, by which Blender shortened them; None where there are none."""
    void, first = np.zeros(len(vertices), bool), 0
    for spline in curve.splines:
        last = first + (3 if spline.type == 'BEZIER' else 1) * len(_points_of(spline))
        if spline.type == 'BEZIER':
            tilts = _values(spline.bezier_points, 'tilt', 1)[:, 0]
            is_new = (vertices[first + 1:last:3] < 0) & (tilts != _STRAY)
            before, after = np.roll(is_new, 1), np.roll(is_new, -1)
            if not spline.use_cyclic_u:
                before[:1] = after[-1:] = False
            void[first:last:3], void[first + 2:last:3] = before, after
        first = last
    return void if void.any() else None


def _numbered(spline, net, seals):
    """The vertices of the net that the points and handles of a spline carry, -1 for none."""
    is_bezier = spline.type == 'BEZIER'
    first = net.spline_points[0]
    numbers, turned = _point_numbers(spline, net, seals)
    known = numbers >= 0
    vertices = np.full((len(numbers), 3 if is_bezier else 1), -1)
    vertices[known] = first[numbers[known], None]
    if is_bezier:                       # switching the direction turns tilts over, and exchanges the handles
        vertices[known] += np.where(turned[known, None], (2, 1, 0), (0, 1, 2))
    return vertices.ravel()


def _point_numbers(spline, net, seals):
    """(the points of the net that those of a spline carry the numbers of, -1 for none; whether each was turned over)."""
    tilts, radii = (_values(_points_of(spline), name, 1)[:, 0] for name in ('tilt', 'radius'))
    whole = np.isfinite(tilts) & (tilts == np.rint(tilts))
    numbers = strays.of_net(np.where(whole, np.abs(tilts) - net.first, -1).astype(np.int64), radii, seals)
    for i in np.flatnonzero((numbers < 0) & whole & (np.abs(tilts) < net.first)):
        same = np.flatnonzero(seals == radii[i])        # a drag brings back the tilt that its points had when it began
        numbers[i] = same[0] if len(same) == 1 else -1
    known = numbers >= 0
    are_bezier = net.spline_points[1]
    known[known] = are_bezier[numbers[known]] == (spline.type == 'BEZIER')      # otherwise it is of another type now
    return np.where(known, numbers, -1), np.signbit(tilts)


def carried(curve):
    """(n,) the numbers that the points of a net carry, whatever they stand for; those of strays among them."""
    tilts = np.concatenate([np.empty(0, np.float32), *(_values(_points_of(spline), 'tilt', 1)[:, 0]
                                                       for spline in curve.splines)])
    return np.abs(tilts[np.isfinite(tilts)]).astype(np.int64)


def everything(curve):
    """Bytes of all that a net says."""
    for spline in curve.splines:
        yield f"{spline.type} {spline.use_cyclic_u} {len(_points_of(spline))}".encode()
        yield _rows(spline).tobytes()
        for name in ('tilt', 'radius'):
            yield _values(_points_of(spline), name, 1).tobytes()


def runs(curve, net, found):
    """A core.net.grown.Run for each spline. found: (n,) of each vertex of the net the slot of its point, or -1."""
    seals, owned, result, slot = strays.seals(len(net.spline_points[0]), net.first), set(found.tolist()), [], 0
    for spline in curve.splines:
        is_bezier = spline.type == 'BEZIER'
        numbers, turned = _point_numbers(spline, net, seals)
        step = 3 if is_bezier else 1
        slots = slot + step * np.arange(len(numbers)) + is_bezier       # of a Bezier point itself
        slot += step * len(numbers)
        own = np.array([each in owned for each in slots.tolist()], bool)
        rows = _rows(spline)
        positions = rows[:, :3].reshape(-1, 3, 3) if is_bezier else rows[:, :3]
        numbers = np.where(own | (numbers < 0), numbers, copy_of(numbers))
        numbers[_values(_points_of(spline), 'tilt', 1)[:, 0] == _STRAY] = STRAY
        result.append(Run(numbers, positions, rows[::step, 3],
                          bool(spline.use_cyclic_u), turned))
    return result


def renumber(curve, net, numbers, runs):
    """Let the points of a Curve be those of a net, where they are: numbers of each spline's points there, -1 for none,
    and smaller ones for copies; runs: runs() of it."""
    seals = strays.seals(len(net.spline_points[0]), net.first)
    for spline, own, over in zip(curve.splines, numbers, (run.is_turned for run in runs)):
        points = _points_of(spline)
        carried = np.where(own == STRAY, -1, np.where(own < -1, copy_of(own), own))
        tilts = (np.maximum(carried, 0) + net.first).astype(np.float32)
        points.foreach_set('tilt', np.where(own == STRAY, _STRAY, -tilts if over else tilts))
        points.foreach_set('radius', np.where(carried < 0, 1, seals[np.maximum(carried, 0)]).astype(np.float32))
    curve.update_tag()


def place(curve, net, numbers, runs, new):
    """Put the points of a Curve to where a net has them; as of renumber(). new: points that had no handles before."""
    first, are_smooth = net.spline_points[0], np.concatenate([spline.smooth or (False,) * spline.count
                                                              for spline in net.splines])
    for spline, own, over in zip(curve.splines, numbers, (run.is_turned for run in runs)):
        points = _points_of(spline)
        for i in np.flatnonzero(own >= 0).tolist():
            vertex, point = int(first[own[i]]), points[i]
            if spline.type == 'BEZIER':
                types = _types(point) if own[i] not in new else ('ALIGNED' if are_smooth[own[i]] else 'FREE',) * 2
                _place_triple(point, net.single[vertex:vertex + 3][::-1 if over else 1], types)
            elif not np.array_equal(point.co, (*net.single[vertex], net.single_weights[vertex])):
                point.co = (*net.single[vertex], net.single_weights[vertex])
    curve.update_tag()


def _types(point):
    return point.handle_left_type, point.handle_right_type


def _place_triple(point, triple, types):
    if types == _types(point) and all(np.array_equal(getattr(point, name), row) for name, row in zip(_HANDLES, triple)):
        return
    point.handle_left_type = point.handle_right_type = 'FREE'
    for name, row in zip(_HANDLES, triple):
        setattr(point, name, row)
    point.handle_left_type, point.handle_right_type = types


def _rows(spline):
    """(k, 4) float32: the positions of a spline and their weights."""
    if spline.type != 'BEZIER':
        return _values(spline.points, 'co', 4)
    triples = np.stack([_values(spline.bezier_points, name, 3) for name in _HANDLES], 1)
    return np.column_stack([triples.reshape(-1, 3), np.ones(3 * len(triples), np.float32)])


def _values(points, name, width):
    flat = np.empty(width * len(points), np.float32)
    points.foreach_get(name, flat)
    return flat.reshape(-1, width)


def _links(curve):
    pairs, first = [np.empty((0, 2), np.int64)], 0
    for spline in curve.splines:
        step = 3 if spline.type == 'BEZIER' else 1
        last = first + step * len(_points_of(spline))
        before = np.arange(first, last)
        after = before + step
        if spline.use_cyclic_u and last > first:
            after = first + (after - first) % (last - first)
        pairs.append(np.stack([before, after], -1)[after < last])
        first = last
    return np.concatenate(pairs)


def flags(curve):
    """(m,) bool: what is selected, by its slot."""
    found = [np.empty(0, bool)]
    for spline in curve.splines:
        columns = []
        for name in _FLAGS if spline.type == 'BEZIER' else ('select',):
            columns.append(np.empty(len(_points_of(spline)), bool))
            _points_of(spline).foreach_get(name, columns[-1])
        found.append(np.stack(columns, -1).ravel())
    return np.concatenate(found)


def set_flags(curve, chosen):
    """Select what has a slot where chosen (m,) is True."""
    first = 0
    for spline in curve.splines:
        names = _FLAGS if spline.type == 'BEZIER' else ('select',)
        last = first + len(names) * len(_points_of(spline))
        for name, column in zip(names, chosen[first:last].reshape(-1, len(names)).T):
            _points_of(spline).foreach_set(name, np.ascontiguousarray(column))
        first = last
    curve.update_tag()


def move(curve, rows):
    """Give points and handles positions and weights. rows: x, y, z, w by the slot of each."""
    first = 0
    for spline in curve.splines:
        is_bezier = spline.type == 'BEZIER'
        step = 3 if is_bezier else 1
        count = len(_points_of(spline))
        own = [divmod(slot - first, step) + (row,) for slot, row in rows.items() if first <= slot < first + step * count]
        for i, handle, row in sorted(own, key=lambda one: one[1] != 1):         # points take their handles along
            _move(_points_of(spline)[i], handle if is_bezier else None, *row)
        first += step * count
    curve.update_tag()


def _move(point, handle, x, y, z, weight):
    """handle: 0 left, 1 the point itself, 2 right; None for a point without handles."""
    if handle is None:
        point.co = (x, y, z, weight)
    elif handle == 1:
        moved = Vector((x, y, z)) - point.co
        ends = point.handle_left + moved, point.handle_right + moved
        point.co = (x, y, z)
        point.handle_left, point.handle_right = ends
    else:
        setattr(point, _HANDLES[handle], (x, y, z))
